"""Starts, stops and mixes motion clips of humanoid characters so that the feet never slide."""
