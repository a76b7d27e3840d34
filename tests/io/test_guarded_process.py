from __future__ import annotations

import time
from pathlib import Path

import pytest

from footfall.errors import FileFormatError
from footfall.io.guarded_process import run_guarded, time_allowed

FILE = Path("walk.fbx")


def run(tmp_path: Path, code: str, *, seconds: float = 60.0) -> bytes:
    script = tmp_path / "child.py"
    script.write_text(f"import os, sys\n{code}\n")
    return run_guarded(script, ["one"], b"data", FILE, seconds=seconds)


def test_what_the_script_writes_comes_back(tmp_path: Path) -> None:
    code = "sys.stdout.buffer.write(sys.stdin.buffer.read() + sys.argv[1].encode())"
    assert run(tmp_path, code) == b"dataone"


@pytest.mark.parametrize(
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
def test_a_script_that_crashes_takes_nothing_down(tmp_path: Path, code: str, told: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        run(tmp_path, code)
    assert str(caught.value) == (
        f"walk.fbx: {told}; the file is damaged, or holds what the parser does not know"
    )


def test_a_script_that_never_ends_is_ended(tmp_path: Path) -> None:
    began = time.monotonic()
    with pytest.raises(FileFormatError, match=r"still being read after 1 s, and was given up"):
        run(tmp_path, "import time; time.sleep(60)", seconds=1.0)
    assert time.monotonic() - began < 20.0


def test_a_script_beside_libraries_of_its_name_does_not_hide_them(tmp_path: Path) -> None:
    (tmp_path / "json.py").write_text("raise RuntimeError('hidden')\n")
    assert run(tmp_path, "import json; print(json.dumps(1), end='')") == b"1"


def test_a_larger_file_may_take_longer() -> None:
    assert time_allowed(0) == 20.0
    assert time_allowed(3_000_000) == 26.0
