"""Whole archives of motions at once: what each stands on, and how much its feet slip."""

from footfall.datasets.archive import ArchiveSummary, annotate_archive
from footfall.datasets.clip_annotation import ClipAnnotation, annotate_clip
from footfall.datasets.executors import dask_executor, local_pool
from footfall.datasets.manifest import Manifest

__all__ = [
    "ArchiveSummary",
    "ClipAnnotation",
    "Manifest",
    "annotate_archive",
    "annotate_clip",
    "dask_executor",
    "local_pool",
]
