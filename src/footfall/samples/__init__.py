"""Motions made here, with exactly known supports (published gait data)."""

from footfall.samples.body import sample_skeleton
from footfall.samples.catalog import sample, sample_names
from footfall.samples.quadruped import quadruped_supports

__all__ = ["quadruped_supports", "sample", "sample_names", "sample_skeleton"]
