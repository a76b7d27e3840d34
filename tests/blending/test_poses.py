from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from footfall.arrays import Floats, SmallFloats
from footfall.blending import add_pose, clear_pose, finish_pose
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import EFFECTORS, channel_count

PARTS = np.array([BodyPart.LEGS, BodyPart.TRUNK, BodyPart.LEFT_ARM], dtype=np.int64)
JOINTS = len(PARTS)

quaternions: Any = arrays(np.float64, (4,), elements=st.floats(-1.0, 1.0)).filter(
    lambda q: float(np.linalg.norm(q)) > 0.1
)


def pose(*rotations: Floats, lengths: float = 1.0) -> SmallFloats:
    """Return one normalized pose: the rotations of the joints and of both feet, all lengths."""
    row = np.zeros((1, channel_count(JOINTS)), dtype=np.float32)
    units = [np.asarray(q) / np.linalg.norm(q) for q in rotations]
    row[0, : 4 * len(units)] = np.concatenate(units)
    row[0, 4 * JOINTS + 8 :] = lengths
    return row


def mean(poses: list[SmallFloats], weights: list[list[float]]) -> tuple[Floats, Floats]:
    turned, effectors = np.full((JOINTS + 2, 4), np.nan), np.full(EFFECTORS, np.nan)
    clear_pose(turned, effectors)
    keys = np.concatenate(poses)
    for frame, weight in enumerate(weights):
        add_pose(keys, frame, 0.0, PARTS, np.array(weight), turned, effectors)
    finish_pose(turned)
    return turned, effectors


def rows(q: Any) -> list[Any]:
    return [q] * (JOINTS + 2)


WHOLE = [1.0] * len(BodyPart)


@settings(deadline=None)
@given(quaternions)
def test_one_pose_alone_is_itself(q: Floats) -> None:
    turned, effectors = mean([pose(*rows(q), lengths=0.7)], [WHOLE])
    unit = q / np.linalg.norm(q)
    assert turned == pytest.approx(np.array(rows(unit)), abs=1e-6)
    assert effectors == pytest.approx(np.full(EFFECTORS, 0.7), abs=1e-7)


@settings(deadline=None)
@given(quaternions, quaternions, st.floats(0.05, 0.95))
def test_a_quaternion_and_its_opposite_are_the_same_rotation(
    one: Floats, other: Floats, share: float
) -> None:
    weights = [[share] * len(BodyPart), [1.0 - share] * len(BodyPart)]
    usual, _ = mean([pose(*rows(one)), pose(*rows(other))], weights)
    opposed, _ = mean([pose(*rows(one)), pose(*rows(-other))], weights)
    dots = np.abs((usual * opposed).sum(axis=-1))
    across = abs(float(one @ other) / np.linalg.norm(one) / np.linalg.norm(other))
    if across > 1e-3:
        assert dots == pytest.approx(np.ones(JOINTS + 2), abs=1e-5)
    assert np.linalg.norm(usual, axis=-1) == pytest.approx(np.ones(JOINTS + 2))


def test_each_body_part_has_weights_of_its_own_and_lengths_go_with_the_legs() -> None:
    level, turned_over = [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]
    arms = [0.0] * len(BodyPart)
    arms[BodyPart.LEFT_ARM] = 1.0
    rest = [1.0 - weight for weight in arms]
    turned, effectors = mean(
        [pose(*rows(level), lengths=1.0), pose(*rows(turned_over), lengths=3.0)], [rest, arms]
    )
    assert turned[0] == pytest.approx(level)
    assert turned[1] == pytest.approx(level)
    assert turned[2] == pytest.approx(turned_over)
    assert turned[3:] == pytest.approx(np.array([level, level]))
    assert effectors == pytest.approx(np.ones(EFFECTORS))


def test_between_two_frames_both_count() -> None:
    keys = np.concatenate([pose(*rows([1.0, 0, 0, 0])), pose(*rows([0, 1.0, 0, 0]), lengths=2.0)])
    turned, effectors = np.zeros((JOINTS + 2, 4)), np.zeros(EFFECTORS)
    add_pose(keys, 0, 0.25, PARTS, np.ones(len(BodyPart)), turned, effectors)
    assert turned[0] == pytest.approx([0.75, 0.25, 0.0, 0.0])
    assert effectors == pytest.approx(np.full(EFFECTORS, 1.25))


def test_the_frame_after_the_last_is_never_read() -> None:
    keys = pose(*rows([1.0, 0, 0, 0]))
    turned, effectors = np.zeros((JOINTS + 2, 4)), np.zeros(EFFECTORS)
    add_pose(keys, 0, 0.0, PARTS, np.ones(len(BodyPart)), turned, effectors)
    assert np.isfinite(turned).all()


def test_where_nothing_was_added_nothing_is_turned() -> None:
    turned, effectors = np.zeros((JOINTS + 2, 4)), np.zeros(EFFECTORS)
    finish_pose(turned)
    assert turned == pytest.approx(np.array([[1.0, 0.0, 0.0, 0.0]] * (JOINTS + 2)))
    assert not effectors.any()
