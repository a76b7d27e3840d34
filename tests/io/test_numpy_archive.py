from __future__ import annotations

import gzip
import io
import zipfile
from pathlib import Path

import numpy as np
import pytest

from footfall.errors import FileFormatError
from footfall.io import load
from footfall.io.numpy_archive import archive_names, read_archive


def test_arrays_come_back_in_either_order(tmp_path: Path) -> None:
    path = tmp_path / "a.npz"
    wanted = np.arange(6.0).reshape(2, 3)
    np.savez(path, c=wanted, fortran=np.asfortranarray(wanted), scalar=np.array(3))
    read = read_archive(path, ("c", "fortran", "scalar", "missing"))
    assert sorted(read) == ["c", "fortran", "scalar"]
    np.testing.assert_array_equal(read["c"], wanted)
    np.testing.assert_array_equal(read["fortran"], wanted)
    assert read["scalar"].shape == ()
    assert archive_names(path) == {"c", "fortran", "scalar"}


def test_a_bomb_is_not_unpacked(tmp_path: Path) -> None:
    path = tmp_path / "a.npz"
    np.savez_compressed(path, header=np.zeros(10_000_000, dtype=np.uint8))
    size = path.stat().st_size
    with pytest.raises(FileFormatError) as caught:
        load(path)
    assert str(caught.value) == (
        f"{path}: unpacks from {size} to 10000128 bytes, which no motion does; it is not read"
    )


def test_a_packed_text_that_never_ends_is_not_unpacked(tmp_path: Path) -> None:
    path = tmp_path / "a.bvh.gz"
    path.write_bytes(gzip.compress(bytes(30_000_000)))
    with pytest.raises(FileFormatError, match=r"unpacks from \d+ to more than \d+ bytes, which no"):
        load(path)


def test_a_shape_that_promises_too_much_is_refused(tmp_path: Path) -> None:
    stream = io.BytesIO()
    np.save(stream, np.zeros(3))
    data = stream.getvalue().replace(b"(3,)", b"(9,)")
    with zipfile.ZipFile(tmp_path / "a.npz", "w") as archive:
        archive.writestr("header.npy", data)
    with pytest.raises(FileFormatError, match=r"header\.npy has 24 bytes for a shape of \(9,\)"):
        read_archive(tmp_path / "a.npz", ("header",))
