from __future__ import annotations

from pathlib import Path

import pytest
from tests.io.small_biped import BIPED, biped_text, golden_changes

from footfall.errors import FileFormatError
from footfall.io.bvh_hierarchy import HierarchyReader

FILE = Path("walk.bvh")


def read(text: str) -> tuple[HierarchyReader, int]:
    reader = HierarchyReader(FILE)
    return reader, reader.read(text.split("\n"))


def test_joints_offsets_channels_and_tips_are_read() -> None:
    reader, after = read(BIPED)
    assert [joint.name for joint in reader.joints] == [
        "Hips", "Head", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot",
    ]  # fmt: skip
    assert [joint.parent for joint in reader.joints] == [-1, 0, 0, 2, 3, 0, 5, 6]
    assert reader.joints[1].offset == (0.0, 60.0, 0.0)
    assert reader.joints[1].tip == (0.0, 20.0, 0.0)
    assert reader.joints[1].channels == ("Zrotation", "Xrotation", "Yrotation")
    assert reader.joints[4].channels == ()
    assert BIPED.split("\n")[after] == "MOTION"


@pytest.mark.parametrize(
    "change",
    [
        ("ROOT Hips\n{", "ROOT Hips {"),
        ("ROOT Hips", "root Hips"),
        ("Zposition Zrotation", "zposition ZROTATION"),
        ("JOINT Head\n\t{", "JOINT Head{"),
        ("End Site\n\t\t{\n\t\t\tOFFSET 0 20 0\n\t\t}", "End Site { OFFSET 0 20 0 }"),
        ("OFFSET 0 60 0", "OFFSET -0 6.0e+001 .0"),
        ("\t", "\n  \n"),
    ],
)
def test_these_ways_of_writing_mean_the_same(change: tuple[str, str]) -> None:
    joints = read(biped_text(change))[0].joints
    for joint, expected in zip(joints, read(BIPED)[0].joints, strict=True):
        joint.line = expected.line
        assert joint == expected


def test_a_name_may_hold_blanks() -> None:
    assert read(biped_text(("JOINT Head", "JOINT Head of  it")))[0].joints[1].name == "Head of it"


@pytest.mark.parametrize(("old", "new", "message"), golden_changes("broken_hierarchies.txt"))
def test_what_breaks_the_rules_is_refused_with_its_line(old: str, new: str, message: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        read(biped_text((old, new)))
    assert str(caught.value) == f"walk.bvh:{message}"


def test_an_empty_file_is_refused() -> None:
    with pytest.raises(FileFormatError) as caught:
        read("\n \n")
    assert str(caught.value) == "walk.bvh: is empty; a BVH file begins with HIERARCHY"


@pytest.mark.parametrize("lines", range(1, 51))
def test_a_hierarchy_cut_short_anywhere_is_refused(lines: int) -> None:
    with pytest.raises(FileFormatError, match="the file ends inside the hierarchy") as caught:
        read("\n".join(BIPED.split("\n")[:lines]))
    assert caught.value.line == lines
