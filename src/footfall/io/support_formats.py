"""What reads and writes support labels, by the suffix of their files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from footfall.errors import FileFormatError
from footfall.io.annotation import read_annotation, write_annotation
from footfall.io.label_table import phase_columns, supports_of
from footfall.io.native import load_native_supports
from footfall.io.table_files import read_csv, read_parquet, write_csv, write_parquet
from footfall.support import SupportSequence

__all__ = ["SUPPORT_READERS", "SUPPORT_WRITERS"]


def _read_npz_supports(path: Path) -> SupportSequence:
    supports = load_native_supports(path)
    if supports is None:
        raise FileFormatError("holds a motion without supports; detect them", path=path)
    return supports


SUPPORT_READERS: dict[str, Callable[[Path], SupportSequence]] = {
    ".csv": lambda path: supports_of(read_csv(path), path),
    ".npz": _read_npz_supports,
    ".parquet": lambda path: supports_of(read_parquet(path), path),
    ".supports": read_annotation,
}
"""What reads supports, by the file's suffix in lower case."""

SUPPORT_WRITERS: dict[str, Callable[[SupportSequence, Path], None]] = {
    ".csv": lambda sequence, path: write_csv(phase_columns(sequence), path),
    ".parquet": lambda sequence, path: write_parquet(phase_columns(sequence), path),
    ".supports": write_annotation,
}
"""What writes supports, by the file's suffix in lower case."""
