from __future__ import annotations

from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.io.small_biped import BIPED, biped_text

from footfall.errors import FileFormatError
from footfall.geometry import from_euler
from footfall.io.bvh_rig import BvhRig, parse_bvh

FILE = Path("walk.bvh")
ROTATIONS = "Zrotation Xrotation Yrotation"
HIPS = f"CHANNELS 6 Xposition Yposition Zposition {ROTATIONS}"


def read(text: str) -> BvhRig:
    return parse_bvh(text.encode(), FILE)


def same(one: BvhRig, other: BvhRig) -> bool:
    return (
        one.names == other.names
        and np.array_equal(one.rotations, other.rotations)
        and one.translations.keys() == other.translations.keys()
        and all(
            np.array_equal(one.translations[j], other.translations[j]) for j in one.translations
        )
    )


@settings(deadline=None)
@given(
    st.sampled_from(["".join(order) for n in (1, 2, 3) for order in permutations("XYZ", n)]),
    st.lists(st.floats(-720.0, 720.0), min_size=3, max_size=3),
)
def test_every_order_turns_as_the_slow_way_does(order: str, angles: list[float]) -> None:
    channels = " ".join(f"{axis}rotation" for axis in order)
    text = f"""HIERARCHY
    ROOT a
    {{
        OFFSET 0 0 0
        CHANNELS {len(order)} {channels}
    }}
    MOTION
    Frames: 1
    Frame Time: 0.04
    {" ".join(map(repr, angles[: len(order)]))}
    """
    expected = from_euler(order, np.radians(angles[: len(order)]))
    np.testing.assert_allclose(read(text).rotations[0, 0], expected, atol=1e-12)


def test_rotations_may_stand_before_positions() -> None:
    text = biped_text(
        (HIPS, f"CHANNELS 6 {ROTATIONS} Xposition Yposition Zposition"),
        ("\n0 90 0 0 0 0 ", "\n0 0 0 0 90 0 "),
        ("\n1 91 2 0 0 0 ", "\n0 0 0 1 91 2 "),
    )
    assert same(read(text), read(BIPED))


def test_a_joint_without_channels_keeps_its_turn() -> None:
    rig = read(BIPED)
    assert rig.names[4] == "LeftFoot"
    assert rig.rotations[:, 4].tolist() == [[1.0, 0.0, 0.0, 0.0]] * 2


def test_position_channels_stand_in_place_of_the_offset() -> None:
    rig = read(biped_text(("OFFSET 0 0 0", "OFFSET 7 8 9")))
    assert rig.translations[0].tolist() == [[0.0, 90.0, 0.0], [1.0, 91.0, 2.0]]


def test_an_axis_without_a_position_channel_keeps_the_offset() -> None:
    rig = read(
        biped_text(
            ("OFFSET 0 60 0\n\t\tCHANNELS 3", "OFFSET 1 60 3\n\t\tCHANNELS 4 Yposition"),
            ("0 90 0 0 0 0 ", "0 90 0 0 0 0 61 "),
            ("1 91 2 0 0 0 ", "1 91 2 0 0 0 62 "),
        )
    )
    assert rig.translations[1].tolist() == [[1.0, 61.0, 3.0], [1.0, 62.0, 3.0]]


@pytest.mark.parametrize(
    "data",
    [
        BIPED.replace("\n", "\r\n").encode(),
        BIPED.replace("\n", "\r").encode(),
        b"\xef\xbb\xbf" + BIPED.encode(),
        BIPED.rstrip().encode(),
        (BIPED + "\n \n\t\n").encode(),
    ],
    ids=["CRLF", "CR", "byte order mark", "no last line end", "blank lines at the end"],
)
def test_line_ends_and_marks_do_not_matter(data: bytes) -> None:
    assert same(parse_bvh(data, FILE), read(BIPED))


@pytest.mark.parametrize("encoding", ["utf-8", "latin-1"])
def test_names_may_hold_letters_of_other_languages(encoding: str) -> None:
    data = biped_text(("JOINT Head", "JOINT Tête")).encode(encoding)
    assert parse_bvh(data, FILE).names[1] == "Tête"


def test_a_file_in_which_nothing_moves_is_refused() -> None:
    text = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\n}\nMOTION\nFrames: 1\nFrame Time: 1\n\n"
    with pytest.raises(FileFormatError) as caught:
        read(text)
    assert str(caught.value) == (
        "walk.bvh:5: no joint has CHANNELS, so that nothing can move; the root needs six"
    )
