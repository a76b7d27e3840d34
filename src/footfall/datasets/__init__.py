"""Whole archives of motions at once: what each stands on, and how much its feet slip."""

from footfall.datasets.archive import ArchiveSummary, annotate_archive
from footfall.datasets.clip_annotation import ClipAnnotation, annotate_clip
from footfall.datasets.executors import dask_executor, local_pool
from footfall.datasets.manifest import Manifest
from footfall.datasets.public_clips import PublicClip, fetch_clip, find_clip, public_clips

__all__ = [
    "ArchiveSummary",
    "ClipAnnotation",
    "Manifest",
    "PublicClip",
    "annotate_archive",
    "annotate_clip",
    "dask_executor",
    "fetch_clip",
    "find_clip",
    "local_pool",
    "public_clips",
]
