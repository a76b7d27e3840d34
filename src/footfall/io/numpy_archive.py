"""Arrays out of a ``.npz`` file, without believing what the file says of their size."""

from __future__ import annotations

import io
import math
import zipfile
import zlib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.errors import FileFormatError
from footfall.io.raw_file import BOMB_RATIO, BOMB_START, read_bytes

__all__ = ["archive_names", "read_archive"]

_DAMAGE = (
    OSError,
    EOFError,
    KeyError,
    ValueError,
    TypeError,
    SyntaxError,
    RuntimeError,
    NotImplementedError,
    zipfile.BadZipFile,
    zlib.error,
)


def read_archive(path: Path, names: Iterable[str]) -> Mapping[str, npt.NDArray[Any]]:
    """Return those of the named arrays that a ``.npz`` file holds; nothing else is unpacked.

    Arrays of Python objects count as absent: they would run code.

    Args:
        path: The file.
        names: The arrays that are wanted.

    Raises:
        FileFormatError: If it is no such file, is damaged, or unpacks to more than is believable.
    """
    data = read_bytes(path)
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = {info.filename: info for info in archive.infolist()}
            wanted = [f"{name}.npy" for name in names if f"{name}.npy" in members]
            _check_sizes([members[name].file_size for name in wanted], len(data), path)
            found = {name.removesuffix(".npy"): _array(archive, members[name]) for name in wanted}
    except _DAMAGE as error:
        if isinstance(error, FileFormatError):
            raise
        detail = " ".join(str(error).split())[:120]
        raise FileFormatError(f"is damaged or no .npz file: {detail}", path=path) from error
    return {name: array for name, array in found.items() if array is not None}


def archive_names(path: Path) -> frozenset[str]:
    """Return what the arrays of a ``.npz`` file are called; empty where it is no such file.

    Raises:
        FileFormatError: If it cannot be read.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(read_bytes(path))) as archive:
            return frozenset(name.removesuffix(".npy") for name in archive.namelist())
    except FileFormatError:
        raise
    except _DAMAGE:
        return frozenset()


def _check_sizes(sizes: list[int], packed: int, path: Path) -> None:
    total = sum(sizes)
    if total > BOMB_RATIO * packed + BOMB_START:
        raise FileFormatError(
            f"unpacks from {packed} to {total} bytes, which no motion does; it is not read",
            path=path,
        )


def _array(archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> npt.NDArray[Any] | None:
    """Return one array; None for one of Python objects."""
    data = archive.read(info)
    stream = io.BytesIO(data)
    version = np.lib.format.read_magic(stream)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"{info.filename} is of NumPy format {version}")
    read_header = (
        np.lib.format.read_array_header_1_0
        if version == (1, 0)
        else np.lib.format.read_array_header_2_0
    )
    shape, fortran, dtype = read_header(stream)
    if dtype.hasobject:
        return None
    start = stream.tell()
    size = math.prod(shape) * dtype.itemsize
    if min(shape, default=1) < 0 or start + size != len(data):
        raise ValueError(f"{info.filename} has {len(data) - start} bytes for a shape of {shape}")
    array = np.frombuffer(data, dtype, math.prod(shape), start)
    return array.reshape(shape, order="F" if fortran else "C")
