from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import pytest

from footfall.errors import FileFormatError
from footfall.io import guarded_child
from footfall.io.guarded_child import MOST_FILES
from footfall.io.guarded_process import kept_children, memory_allowed, read_guarded, time_allowed

FILE = Path("walk.fbx")

SCRIPT = """
import os, sys
import numpy as np

class UnreadableError(Exception):
    pass

def load_library():
    {load}

def read_file(words, data, allowed):
    print("a library that talks")
    {code}
    return {{"words": words, "process": os.getpid()}}, {{"data": np.frombuffer(data, np.uint8)}}
"""


SLEEPS_OVER_BAD = "import time; time.sleep(60.0 * (data == b'bad'))"


def read(
    tmp_path: Path,
    code: str,
    data: bytes = b"data",
    *,
    seconds: float | None = 60.0,
    load: str = "pass",
) -> tuple[dict[str, Any], dict[str, Any]]:
    script = tmp_path / "child.py"
    script.write_text(SCRIPT.format(code=code, load=load))
    return read_guarded(script, ["one"], data, FILE, size=len(data), seconds=seconds)


def process(tmp_path: Path, data: bytes, code: str = "pass") -> int:
    return int(read(tmp_path, code, data)[0]["process"])


def test_what_the_script_reads_comes_back(tmp_path: Path) -> None:
    facts, arrays = read(tmp_path, "pass")
    assert facts["words"] == ["one"]
    assert {name: array.tobytes() for name, array in arrays.items()} == {"data": b"data"}


FAILURES = pytest.mark.parametrize(
    ("code", "told"),
    [
        ("os.abort()", "made its parser fail (exit code -6)"),
        ("import ctypes; ctypes.string_at(0)", "made its parser fail (exit code -11)"),
        (
            "raise ValueError('no such thing')",
            "made its parser fail (exit code 1): ValueError: no such thing",
        ),
    ],
)


@FAILURES
def test_a_script_that_crashes_takes_nothing_down(tmp_path: Path, code: str, told: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        read(tmp_path, code)
    assert str(caught.value) == (
        f"walk.fbx: {told}; the file is damaged, or holds what the parser does not know"
    )


def test_what_the_script_finds_wrong_is_told(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        read(tmp_path, "raise UnreadableError('holds nothing')")
    assert str(caught.value) == "walk.fbx: holds nothing"


def test_a_script_that_never_ends_is_ended(tmp_path: Path) -> None:
    began = time.monotonic()
    with pytest.raises(FileFormatError, match=r"still being read after 1 s, and was given up"):
        read(tmp_path, "import time; time.sleep(60)", seconds=1.0)
    assert time.monotonic() - began < 20.0


def test_a_file_of_a_few_bytes_is_given_up_after_two_seconds_of_reading(tmp_path: Path) -> None:
    with kept_children():
        process(tmp_path, b"1", SLEEPS_OVER_BAD)
        began = time.monotonic()
        with pytest.raises(FileFormatError) as caught:
            read(tmp_path, SLEEPS_OVER_BAD, b"bad", seconds=None)
        assert 2.0 <= time.monotonic() - began < 4.0
    assert str(caught.value) == (
        "walk.fbx: was still being read after 2 s, and was given up; it is damaged, or far too "
        "large"
    )


def test_a_library_that_takes_long_to_load_takes_no_time_from_the_reading(tmp_path: Path) -> None:
    facts, _ = read(tmp_path, "pass", seconds=0.5, load="import time; time.sleep(1.5)")
    assert facts["words"] == ["one"]


def test_a_library_that_never_loads_is_given_up_and_no_file_blamed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(guarded_child, "START_SECONDS", 1.0)
    with pytest.raises(FileFormatError) as caught:
        read(tmp_path, "pass", load="import time; time.sleep(60)")
    assert str(caught.value) == (
        "walk.fbx: cannot be read: its parser did not start within 1 s; try again when the "
        "machine is less busy"
    )


def test_a_script_beside_libraries_of_its_name_does_not_hide_them(tmp_path: Path) -> None:
    (tmp_path / "fractions.py").write_text("raise RuntimeError('hidden')\n")
    read(tmp_path, "import fractions")


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is limited on Linux only")
def test_a_script_that_takes_too_much_memory_fails(tmp_path: Path) -> None:
    allowed = memory_allowed(4)
    read(tmp_path, f"np.ones({allowed // 16})")
    with pytest.raises(FileFormatError, match="MemoryError: Unable to allocate"):
        read(tmp_path, f"np.ones({allowed // 4})")


def test_a_larger_file_may_take_longer_and_more_memory() -> None:
    assert time_allowed(0) == 2.0
    assert time_allowed(3_000_000) == 8.0
    assert memory_allowed(3_000_000) == 96_000_000


def test_every_file_has_a_process_of_its_own(tmp_path: Path) -> None:
    assert process(tmp_path, b"1") != process(tmp_path, b"2")


def test_a_kept_process_reads_many_files_each_by_itself(tmp_path: Path) -> None:
    script = tmp_path / "child.py"
    script.write_text(SCRIPT.format(code="pass", load="pass"))
    seen: set[int] = set()
    with kept_children():
        for number in range(MOST_FILES + 5):
            data = str(number).encode() * number
            facts, arrays = read_guarded(script, [str(number)], data, FILE, size=len(data))
            assert facts["words"] == [str(number)]
            assert arrays["data"].tobytes() == data
            seen.add(facts["process"])
    # The first one was worn.
    assert len(seen) == 2


CRASH = "if data == b'bad': os.abort()"
FRAGILE = """
    global before
    if data == b'2' and globals().get('before'): os.abort()
    before = True"""


def test_a_kept_process_that_crashes_is_replaced_and_only_its_file_blamed(tmp_path: Path) -> None:
    with kept_children():
        first = process(tmp_path, b"1", CRASH)
        assert process(tmp_path, b"2", CRASH) == first
        with pytest.raises(FileFormatError, match="made its parser fail"):
            process(tmp_path, b"bad", CRASH)
        assert process(tmp_path, b"3", CRASH) != first


def test_what_a_file_left_behind_is_no_fault_of_the_next(tmp_path: Path) -> None:
    with kept_children():
        first = process(tmp_path, b"1", FRAGILE)
        assert process(tmp_path, b"2", FRAGILE) != first


def test_a_kept_process_that_hangs_is_ended_at_once_for_all(tmp_path: Path) -> None:
    with kept_children():
        read(tmp_path, SLEEPS_OVER_BAD, b"1")
        began = time.monotonic()
        with pytest.raises(FileFormatError, match="still being read"):
            read(tmp_path, SLEEPS_OVER_BAD, b"bad", seconds=1.0)
        assert time.monotonic() - began < 2.0
        read(tmp_path, SLEEPS_OVER_BAD, b"2")
