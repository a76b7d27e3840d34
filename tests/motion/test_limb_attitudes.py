"""What a motion shows of a body that its rest pose does not."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.arrays import Rotations
from footfall.geometry import conjugate, multiply, rotate
from footfall.motion import Clip
from footfall.motion.limb_attitudes import observe_attitudes
from footfall.motion.retargeting import map_clip, retarget
from footfall.samples import sample
from footfall.skeleton import Skeleton, find_anatomy


def with_turned_clavicles(clip: Clip, turn: Rotations) -> Clip:
    """Return the same motion of a body whose clavicles have other frames.

    At rest they then point another way.
    """
    own = clip.skeleton
    offsets, local = own.rest_offsets.copy(), clip.local_rotations.copy()
    for name in ("LeftShoulder", "RightShoulder"):
        joint = own.index(name)
        local[:, joint] = multiply(local[:, joint], turn)
        for child in own.children(joint):
            offsets[child] = rotate(conjugate(turn), offsets[child])
            local[:, child] = multiply(conjugate(turn), local[:, child])
    names = tuple("Bauch" if name == "Spine" else name for name in own.names)
    body = Skeleton(names, own.parents, offsets, own.tip_offsets)
    return clip.evolve(skeleton=body, local_rotations=local)


@pytest.mark.parametrize("axis", [1, 2, 3])
@given(wobble=st.lists(st.floats(-0.15, 0.15), min_size=4, max_size=4))
@settings(max_examples=10, deadline=None)
def test_clavicles_half_a_turn_astray_at_rest_are_no_turn_of_the_arms(
    axis: int, wobble: list[float]
) -> None:
    turn = np.eye(4)[axis] + np.array(wobble)
    clip, _ = sample("walk")
    other = with_turned_clavicles(clip, turn / np.linalg.norm(turn))
    again = retarget(other, clip.skeleton, map_clip(other, clip.skeleton, clip))
    for name in ("LeftShoulder", "RightShoulder", "LeftArm", "RightArm"):
        joint = clip.skeleton.index(name)
        between = multiply(
            conjugate(again.local_rotations[:, joint]), clip.local_rotations[:, joint]
        )
        degrees = np.degrees(2.0 * np.arccos(np.minimum(np.abs(between[:, 0]), 1.0)))
        assert degrees.max() < 45.0


def test_the_trunk_is_up_in_the_frames_of_clavicles_however_they_are_turned() -> None:
    clip, _ = sample("walk")
    turn = np.array([0.0, 1.0, 0.0, 0.0])
    other = with_turned_clavicles(clip, turn)
    for one in (clip, other):
        ups = observe_attitudes(one, find_anatomy(one.skeleton)).clavicle_ups
        assert np.linalg.norm(ups, axis=-1) == pytest.approx([1.0, 1.0])
        assert np.sign(ups[:, 1]).tolist() == ([1.0, 1.0] if one is clip else [-1.0, -1.0])
