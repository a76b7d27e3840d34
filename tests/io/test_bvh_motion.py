from __future__ import annotations

from decimal import Decimal
from pathlib import Path

import pytest
from tests.io.small_biped import biped_text, golden_changes

from footfall.errors import FileFormatError
from footfall.io.bvh_motion import BvhMotion, parse_motion

FILE = Path("walk.bvh")


def read(text: str) -> BvhMotion:
    return parse_motion(text.split("\n"), 51, 21, FILE)


def test_frames_and_their_time_are_read_digit_by_digit() -> None:
    motion = read(biped_text())
    assert motion.values.shape == (2, 21)
    assert motion.values[1, [0, 1, 2, 10, 13]].tolist() == [1.0, 91.0, 2.0, 30.0, 40.0]
    assert motion.declared_frames == 2
    assert motion.frame_time == Decimal("0.0333333")


@pytest.mark.parametrize(
    "change",
    [
        ("MOTION", "\n  MOTION  "),
        ("Frames: 2", "FRAMES:\t2"),
        ("Frames: 2", "Frames : 2\n\n"),
        ("Frame Time: 0.0333333", "frame time:   3.33333e-02"),
        ("Frame Time: 0.0333333", "FrameTime:+.0333333"),
        ("1 91 2 0", "\n \t\n1.0  +9.1e+001\t2e0 -0"),
    ],
)
def test_these_ways_of_writing_mean_the_same(change: tuple[str, str]) -> None:
    motion, expected = read(biped_text(change)), read(biped_text())
    assert motion.values.tolist() == expected.values.tolist()
    assert (motion.declared_frames, motion.frame_time) == (2, expected.frame_time)


@pytest.mark.parametrize(("old", "new", "message"), golden_changes("broken_motions.txt"))
def test_what_breaks_the_rules_is_refused_with_its_line(old: str, new: str, message: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        read(biped_text((old, new)))
    assert str(caught.value) == f"walk.bvh:{message}"


def test_one_whole_frame_too_many_is_read() -> None:
    motion = read(biped_text(("Frames: 2", "Frames: 1")))
    assert (len(motion.values), motion.declared_frames) == (2, 1)


def test_two_frames_too_many_are_refused() -> None:
    text = biped_text(("Frames: 2", "Frames: 1")) + "0 " * 21 + "\n"
    with pytest.raises(FileFormatError) as caught:
        read(text)
    assert str(caught.value) == (
        "walk.bvh:53: 1 frames are declared, but 3 follow; the file holds something else, "
        "or else it should say Frames: 3"
    )


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        (51, "walk.bvh:51: the file ends where MOTION is expected; it was cut short"),
        (52, "walk.bvh:52: the file ends where Frames: is expected; it was cut short"),
        (53, "walk.bvh:53: the file ends where Frame Time: is expected; it was cut short"),
        (
            54,
            "walk.bvh:54: no frame follows Frame Time, though 2 are declared; "
            "the file was cut short",
        ),
        (
            55,
            "walk.bvh:53: 2 frames are declared, but 1 follow; the file was cut short, "
            "or else it should say Frames: 1",
        ),
    ],
)
def test_a_motion_cut_short_is_refused(lines: int, message: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        read("\n".join(biped_text().split("\n")[:lines]))
    assert str(caught.value) == message
