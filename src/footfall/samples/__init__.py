"""Motions made here, with exactly known supports (published gait data)."""

from footfall.samples.body import sample_skeleton
from footfall.samples.catalog import sample, sample_names

__all__ = ["sample", "sample_names", "sample_skeleton"]
