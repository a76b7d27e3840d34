"""Which phases are played together: indices, no clock."""
