from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.datasets.archives import FILES, make_archive

from footfall.cli import main

pytest.importorskip("pyarrow")

Captured = pytest.CaptureFixture[str]


def test_an_archive_is_annotated_and_then_kept(tmp_path: Path, capsys: Captured) -> None:
    archive, out = make_archive(tmp_path / "archive", broken=True), tmp_path / "out"
    words = ["annotate", str(archive), "-o", str(out), "--workers", "1"]
    assert main(words) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "7 files, 0 of them done before, 1 not usable",
        str(out / "annotations.parquet"),
        str(out / "annotations.html"),
    ]
    assert main(words) == 0
    assert capsys.readouterr().out.startswith("7 files, 6 of them done before, 1 not usable")


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("annotate none -o out", "none is no folder; name the folder of an archive"),
        (
            "annotate none -o out --height -1",
            "height is -1.0; a limit must be finite and > 0",
        ),
        (
            "annotate archive -o out --workers 0",
            "workers is 0; at least one is needed",
        ),
    ],
)
def test_wrong_input_is_told_in_one_line(
    words: str, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    make_archive(tmp_path / "archive")
    monkeypatch.chdir(tmp_path)
    assert main(words.split()) == 2
    assert capsys.readouterr().err.splitlines()[-1] == f"footfall: {told}"


def test_an_interrupt_is_one_line_and_what_is_done_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Captured
) -> None:
    from footfall.cli import annotating

    def interrupted(*_words: Any, told: Callable[..., None], **_known: Any) -> None:
        told(2, 6, None)
        raise KeyboardInterrupt

    monkeypatch.setattr(annotating, "annotate_archive", interrupted)
    assert main(["annotate", str(tmp_path), "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err.splitlines()[-1] == (
        "footfall: interrupted after 2 of 6 files; run the same again to go on"
    )


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_a_killed_run_goes_on_where_it_was(tmp_path: Path, capsys: Captured) -> None:
    archive, out = make_archive(tmp_path / "archive"), tmp_path / "out"
    for index in range(300):
        os.link(archive / FILES[0], archive / f"more{index:03d}.bvh")
    words = ["annotate", str(archive), "-o", str(out), "--workers", "1"]
    command = [sys.executable, "-c", "from footfall.cli import main; main()", *words]
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    until = time.monotonic() + 120.0
    while len(list(out.rglob("*.supports"))) < 20:
        assert time.monotonic() < until
        assert running.poll() is None
        time.sleep(0.02)
    running.send_signal(signal.SIGKILL)
    running.wait()
    done = len(list(out.rglob("*.supports")))
    assert done < 306
    assert main(words) == 0
    kept = int(capsys.readouterr().out.split()[2])
    # At most the file in hand is lost: its supports are there, its line is not.
    assert done - 1 <= kept <= done
    assert len(list(out.rglob("*.supports"))) == 306
