"""A cue sheet: what starts and stops when."""
