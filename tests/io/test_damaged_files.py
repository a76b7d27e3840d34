"""Whatever a file holds, its reader returns or says in one line what is wrong, soon, and small."""

from __future__ import annotations

import random
import time
import tracemalloc
import warnings
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.io.mutations import mutated
from tests.io.small_files import FORMS, small_bytes

from footfall.errors import FootfallError

every_form = pytest.mark.parametrize("form", sorted(FORMS))

QUICK, FULL = 150, 20_000

MEGABYTE = 2**20


class Reading:
    """Reads damaged files of one form, and fails where a reader does not keep its word."""

    def __init__(self, form: str, folder: Path) -> None:
        name, self.reader = FORMS[form]
        self.path = folder / name
        self.whole = small_bytes(form, folder)
        self.longest = 0.0
        self.largest = 0
        # What is imported and compiled on first use is not the file's doing.
        self.path.write_bytes(self.whole)
        self.reader(self.path)
        tracemalloc.start()

    def refused(self, data: bytes) -> bool:
        """Read, and return whether it was refused."""
        self.path.write_bytes(data)
        tracemalloc.reset_peak()
        before, _ = tracemalloc.get_traced_memory()
        start = time.perf_counter()
        refused = _refused(self.reader, self.path)
        seconds = time.perf_counter() - start
        size = tracemalloc.get_traced_memory()[1] - before
        self.longest, self.largest = max(self.longest, seconds), max(self.largest, size)
        assert seconds < 2.0 + 2.0 * len(data) / MEGABYTE, f"took {seconds:.1f} s"
        assert size < 20 * len(data) + 64 * MEGABYTE, f"took {size / MEGABYTE:.0f} MB"
        return refused


def _refused(reader: Callable[[Path], object], path: Path) -> bool:
    # A fault that NumPy only warns of would be a NaN later.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            reader(path)
        except FootfallError as error:
            return "\n" not in str(error) or pytest.fail(f"more than a line: {error}")
    return False


@pytest.fixture
def reading(form: str, tmp_path: Path):  # type: ignore[no-untyped-def]
    yield Reading(form, tmp_path)
    tracemalloc.stop()


@every_form
def test_the_whole_file_is_read(form: str, reading: Reading) -> None:
    assert not reading.refused(reading.whole), form


def cuts(size: int, most: int) -> list[int]:
    step = max(1, size // most)
    return list(range(0, size, step))


@every_form
def test_a_file_cut_short_is_refused_or_read(form: str, reading: Reading) -> None:
    refused = [reading.refused(reading.whole[:end]) for end in cuts(len(reading.whole), QUICK)]
    assert refused[0], form
    if form in ("glb", "gltf", "native", "amass", "model", "deepmimic", "character"):
        assert all(refused)


@every_form
def test_a_damaged_file_is_refused_or_read(form: str, reading: Reading) -> None:
    chance = random.Random(form)
    refused = [reading.refused(mutated(reading.whole, chance)) for _ in range(QUICK)]
    assert sum(refused) > QUICK // 20


@pytest.mark.full
@every_form
def test_a_file_cut_short_at_every_byte(form: str, reading: Reading) -> None:
    assert not reading.refused(reading.whole), form
    for end in cuts(len(reading.whole), 20_000):
        reading.refused(reading.whole[:end])


@pytest.mark.full
@every_form
def test_twenty_thousand_damaged_files(form: str, reading: Reading) -> None:
    chance = random.Random(f"full {form}")
    refused = sum(reading.refused(mutated(reading.whole, chance)) for _ in range(FULL))
    print(
        f"{form}: {refused} refused, {reading.longest:.2f} s, {reading.largest / MEGABYTE:.1f} MB"
    )
