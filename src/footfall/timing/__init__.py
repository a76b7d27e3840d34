"""When phases are played: seconds only."""
