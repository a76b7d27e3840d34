from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from footfall.detection import frame_symbols
from footfall.errors import FileFormatError
from footfall.io import load_supports, save_supports
from footfall.io.label_table import frame_columns, phase_columns, supports_of
from footfall.io.table_files import write_csv
from footfall.support import Support, SupportPhase, SupportSequence

PATH = Path("labels.csv")
WALK = SupportSequence.parse("R.383 D.117 L.383 D.117*")
CUT = SupportSequence(WALK.phases, True, -0.1)
JUMP = SupportSequence.parse("D.5 -.301 D.7")


@st.composite
def sequences(draw: st.DrawFn) -> SupportSequence:
    kinds = [Support.LEFT, Support.RIGHT, Support.DOUBLE, Support.FLIGHT]
    phases: list[SupportPhase] = []
    for _ in range(draw(st.integers(1, 8))):
        others = [kind for kind in kinds if not phases or phases[-1].support is not kind]
        seconds = draw(st.floats(0.01, 10.0))
        phases.append(SupportPhase(draw(st.sampled_from(others)), seconds))
    closes = len(phases) == 1 or phases[0].support is not phases[-1].support
    cyclic = closes and draw(st.booleans())
    start = -phases[0].duration * draw(st.floats(0.0, 0.9)) if cyclic else 0.0
    return SupportSequence(tuple(phases), cyclic, start)


@given(sequences())
def test_nothing_is_lost_with_one_row_a_phase(sequence: SupportSequence) -> None:
    assert supports_of(phase_columns(sequence), PATH) == sequence


@pytest.mark.parametrize("suffix", [".csv", ".parquet", ".supports"])
@pytest.mark.parametrize("sequence", [WALK, CUT, JUMP], ids=str)
def test_what_is_written_is_read_again(
    tmp_path: Path, sequence: SupportSequence, suffix: str
) -> None:
    if suffix == ".parquet":
        pytest.importorskip("pyarrow")
    save_supports(sequence, tmp_path / f"labels{suffix}")
    read = load_supports(tmp_path / f"labels{suffix}")
    if suffix != ".supports":
        assert read == sequence
    assert str(read) == str(sequence)


@pytest.mark.parametrize("fps", [24.0, 30.0, 59.94])
@pytest.mark.parametrize("sequence", [WALK, CUT, JUMP], ids=str)
def test_labels_of_frames_give_the_same_labels(
    tmp_path: Path, sequence: SupportSequence, fps: float
) -> None:
    frames = int(2.5 * fps)
    columns = frame_columns(sequence, fps, frames)
    write_csv(columns, tmp_path / "frames.csv")
    read = load_supports(tmp_path / "frames.csv")
    assert not read.cyclic
    assert read.duration == pytest.approx((frames - 1) / fps)
    assert frame_symbols(read, fps, frames) == frame_symbols(sequence, fps, frames)


def test_two_feet_are_as_good_as_a_symbol() -> None:
    columns = frame_columns(JUMP, 30.0, 45)
    feet = {name: columns[name] for name in ("time", "left", "right")}
    assert supports_of(feet, PATH) == supports_of(columns, PATH)


def test_a_csv_file_can_be_read_by_anybody(tmp_path: Path) -> None:
    save_supports(CUT, tmp_path / "walk.csv")
    assert (tmp_path / "walk.csv").read_text() == (
        "support,start,seconds,cyclic\nR,-0.1,0.383,true\nD,0.28300000000000003,0.117,true\n"
        "L,0.4,0.383,true\nD,0.783,0.117,true\n"
    )


WRONG: dict[str, tuple[dict[str, list[Any]], str]] = {
    "no row": ({"support": [], "seconds": []}, ": holds no row; each phase or each frame is one"),
    "no form": (
        {"foot": ["L"], "when": [1]},
        ": has the columns foot, when; it needs support and seconds (one row a phase), or time and "
        "support, or time, left and right (one row a frame)",
    ),
    "symbol": (
        {"support": ["R", "X"], "seconds": [1, 1]},
        ":3: support is 'X'; it must be R, L, D or -",
    ),
    "number": (
        {"support": ["R"], "seconds": ["nan"]},
        ":2: seconds is 'nan'; it must be a finite number of seconds",
    ),
    "nothing": (
        {"support": ["R"], "seconds": [None]},
        ":2: seconds is 'None'; it must be a finite number of seconds",
    ),
    "flag": (
        {"time": [0, 1], "left": [1, 1], "right": [0, "maybe"]},
        ":3: right is 'maybe'; it must be true or false, or 1 or 0",
    ),
    "claims": (
        {"support": ["R", "L"], "seconds": [1, 1], "cyclic": [True, False]},
        ": is cyclic in some rows and not in others",
    ),
    "neighbors": (
        {"support": ["R", "R"], "seconds": [1, 1]},
        ": phases 0 and 1 are both RIGHT; merge them into one",
    ),
    "single": (
        {"time": [0.0], "support": ["R"]},
        ": holds a single frame, which lasts no time",
    ),
    "uneven": (
        {"time": [0.0, 0.1, 0.2, 0.5], "support": ["R"] * 4},
        ":3: this frame comes 0.1 s after the one before, but most come after 0.166667 s; frames "
        "must be evenly spaced",
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_told_with_its_line(name: str) -> None:
    columns, told = WRONG[name]
    with pytest.raises(FileFormatError) as caught:
        supports_of(columns, PATH)
    assert str(caught.value) == f"labels.csv{told}"
