"""Whatever a file holds, its reader returns or says in one line what is wrong, soon, and small."""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from tests.io.mutations import mutated
from tests.io.readings import MEGABYTE, Readings
from tests.io.small_files import FORMS, small_bytes

from footfall.io.guarded_process import kept_children

every_form = pytest.mark.parametrize("form", sorted(FORMS))

QUICK, FULL = 100, 20_000

WHOLE = ("glb", "gltf", "native", "amass", "model", "deepmimic", "character", "parquet", "robot")
"""Forms of which no beginning is a whole file, but for a line's end."""


@pytest.fixture
def whole(form: str, tmp_path: Path) -> bytes:
    return small_bytes(form, tmp_path)


@pytest.fixture
def readings(form: str, whole: bytes, tmp_path: Path) -> Iterator[Readings]:
    """Read the sound file first and last: the last one must not suffer from those between."""
    name, reader = FORMS[form]
    path = tmp_path / name
    # What is imported and compiled on first use is not the file's doing.
    path.write_bytes(whole)
    reader(path)
    readings = Readings(reader, path)
    with kept_children():
        yield readings
        assert not readings.read(whole)
    print(f"{form} ({len(whole)} bytes): {readings}")


def cut(readings: Readings, whole: bytes, most: int) -> list[bool]:
    ends = np.unique(np.linspace(0, len(whole) - 1, min(most, len(whole))).astype(int))
    return [readings.read(whole[:end]) for end in ends.tolist()]


@every_form
def test_a_file_cut_short_is_refused_or_read(form: str, readings: Readings, whole: bytes) -> None:
    refused = cut(readings, whole, QUICK)
    assert refused[0], form
    assert all(refused[:-1]) or form not in WHOLE


@every_form
def test_a_damaged_file_is_refused_or_read(form: str, readings: Readings, whole: bytes) -> None:
    chance = random.Random(form)
    refused = [readings.read(mutated(whole, chance)) for _ in range(QUICK)]
    assert sum(refused) > QUICK // 20


@pytest.mark.full
@every_form
def test_a_file_cut_short_at_every_byte(form: str, readings: Readings, whole: bytes) -> None:
    refused = cut(readings, whole, FULL)
    assert refused[0], form
    assert all(refused[:-1]) or form not in WHOLE


@pytest.mark.full
@every_form
def test_twenty_thousand_damaged_files(form: str, readings: Readings, whole: bytes) -> None:
    chance = random.Random(f"full {form}")
    refused = [readings.read(mutated(whole, chance)) for _ in range(FULL)]
    assert sum(refused) > FULL // 20


def test_a_reader_that_takes_too_long_or_too_much_is_found_out(tmp_path: Path) -> None:
    slow = Readings(lambda _: time.sleep(2.1), tmp_path / "slow")
    with pytest.raises(AssertionError, match=r"took 2\.1 s"):
        slow.read(b"")
    large = Readings(lambda _: np.ones(int(9 * MEGABYTE)), tmp_path / "large")
    with pytest.raises(AssertionError, match=r"took 7[0-9] MB"):
        large.read(b"")
