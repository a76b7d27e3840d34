"""Regenerates docs/comparison.md: ours beside what others offer, on many cue sheets.

Run as ``python -m benchmarks.comparison``.
"""
