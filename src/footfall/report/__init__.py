"""Measures of a motion."""
