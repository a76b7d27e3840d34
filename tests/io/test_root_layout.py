from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.io.small_biped import BIPED, biped_text

from footfall.io.bvh_clip import clip_from_rig
from footfall.io.bvh_rig import BvhRig, parse_bvh
from footfall.io.root_layout import fold_root, rest_skeleton
from footfall.skeleton import find_anatomy

FILE = Path("walk.bvh")
HIPS = "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation"


def rig_of(text: str) -> BvhRig:
    return parse_bvh(text.encode(), FILE)


def below(node: str, frames: tuple[str, str], *more: tuple[str, str]) -> str:
    """Return `BIPED` inside another root, whose channels come first."""
    return biped_text(
        ("ROOT Hips", f"ROOT Node\n{{\n{node}\nJOINT Hips"),
        ("\n}\nMOTION", "\n}\n}\nMOTION"),
        ("\n0 90 0", f"\n{frames[0]} 0 90 0"),
        ("\n1 91 2", f"\n{frames[1]} 1 91 2"),
        *more,
    )


def test_a_pelvis_at_the_root_stays_as_it_is() -> None:
    rig = rig_of(BIPED)
    folded, root = fold_root(rig, find_anatomy(rest_skeleton(rig)))
    assert folded is rig
    assert (root.value, root.reason) == ("Hips", "'Hips', the file's root")


@pytest.mark.parametrize(
    ("node", "frames"),
    [
        ("OFFSET 0 0 0", ("", "")),
        ("OFFSET 3 4 5\nCHANNELS 3 Xposition Yposition Zposition", ("0 0 0", "0 0 0")),
    ],
    ids=["static", "with channels"],
)
def test_a_node_above_the_pelvis_is_folded_away(node: str, frames: tuple[str, str]) -> None:
    clip, conclusions = clip_from_rig(rig_of(below(node, frames)), FILE)
    expected, _ = clip_from_rig(rig_of(BIPED), FILE)
    assert clip.skeleton.names == expected.skeleton.names
    assert clip.skeleton.parents.tolist() == expected.skeleton.parents.tolist()
    np.testing.assert_allclose(clip.pelvis_positions, expected.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(clip.local_rotations, expected.local_rotations, atol=1e-12)
    assert conclusions.root.reason == (
        "'Hips': 'Node' above it carries nothing else, and became part of its motion through the "
        "world"
    )


def test_a_root_that_runs_along_on_the_ground_moves_the_pelvis() -> None:
    node = "OFFSET 0 0 0\nCHANNELS 4 Xposition Yposition Zposition Yrotation"
    clip, _ = clip_from_rig(rig_of(below(node, ("100 0 0 0", "100 0 0 90"))), FILE)
    # The second frame puts the pelvis at (1, 91, 2) in a root turned from z to x.
    expected = [[1.0, 0.9, 0.0], [1.02, 0.91, -0.01]]
    np.testing.assert_allclose(clip.pelvis_positions, expected, atol=1e-12)
    half = np.sqrt(0.5)
    np.testing.assert_allclose(clip.local_rotations[1, 0], [half, 0.0, half, 0.0], atol=1e-12)


def test_a_node_that_carries_something_else_stays() -> None:
    node = "OFFSET 0 0 0\nJOINT Camera\n{\nOFFSET 0 1 0\n}"
    rig = rig_of(below(node, ("", "")))
    folded, root = fold_root(rig, find_anatomy(rest_skeleton(rig)))
    assert folded is rig
    assert root.value == "Node"


def test_without_legs_nothing_is_folded() -> None:
    rig = rig_of(below("OFFSET 0 0 0", ("", "")))
    folded, root = fold_root(rig, None)
    assert folded is rig
    assert root.reason == "'Node', the file's root; without legs it is left as it is"
