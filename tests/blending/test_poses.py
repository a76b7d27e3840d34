from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from tests.oracles.slow_blending import mean_pose

from footfall.arrays import Floats, SmallFloats
from footfall.blending import Layers, blend_layers
from footfall.skeleton import BodyPart
from footfall.skeleton.normalized import EFFECTORS, by_component, channel_count, padded_count

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


def blend(
    keys: SmallFloats, frames: list[int], fraction: float, weights: list[list[float]]
) -> tuple[Floats, Floats]:
    """Return rotations, joints then feet, and lengths of a mix of some frames."""
    count, padded = len(frames), padded_count(JOINTS)
    layers = Layers(
        np.array(frames, dtype=np.int64),
        np.array([frame + (fraction > 0.0) for frame in frames], dtype=np.int64),
        np.full(count, fraction, dtype=np.float32),
        np.array(weights, dtype=np.float32).reshape(count, len(BodyPart)),
        np.array([len(set(shares)) == 1 for shares in weights]),
    )
    masks = np.zeros((len(BodyPart), padded), dtype=np.float32)
    masks[[*PARTS, BodyPart.LEGS, BodyPart.LEGS], np.arange(JOINTS + 2)] = 1.0
    out = np.full(4 * padded + 8, np.nan, dtype=np.float32)
    blend_layers(by_component(keys, JOINTS), layers, count, masks, out)
    turned = out[: 4 * padded].reshape(4, padded).T[: JOINTS + 2]
    return turned.astype(np.float64), out[4 * padded :][:EFFECTORS].astype(np.float64)


def mean(poses: list[SmallFloats], weights: list[list[float]]) -> tuple[Floats, Floats]:
    return blend(np.concatenate(poses), list(range(len(poses))), 0.0, weights)


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
    turned, effectors = blend(keys, [0], 0.25, [WHOLE])
    assert turned[0] == pytest.approx(np.array([0.75, 0.25, 0.0, 0.0]) / np.hypot(0.75, 0.25))
    assert effectors == pytest.approx(np.full(EFFECTORS, 1.25))


def test_the_frame_after_the_last_is_never_read() -> None:
    turned, _ = blend(pose(*rows([1.0, 0, 0, 0])), [0], 0.0, [WHOLE])
    assert np.isfinite(turned).all()


def test_where_nothing_was_added_nothing_is_turned() -> None:
    turned, effectors = blend(pose(*rows([1.0, 0, 0, 0])), [], 0.0, [])
    assert turned == pytest.approx(np.array([[1.0, 0.0, 0.0, 0.0]] * (JOINTS + 2)))
    assert not effectors.any()


@settings(deadline=None, max_examples=50)
@given(st.integers(0, 2**32 - 1), st.integers(1, 5))
def test_eight_joints_at_once_are_the_mean_joint_by_joint(seed: int, count: int) -> None:
    random = np.random.default_rng(seed)
    poses = [
        pose(*random.normal(size=(JOINTS + 2, 4)), lengths=float(random.uniform()))
        for _ in range(count)
    ]
    weights = random.dirichlet(np.ones(count), size=len(BodyPart)).T
    turned, effectors = mean(poses, weights.tolist())
    rotations, lengths = mean_pose(np.concatenate(poses), weights, PARTS)
    # A sum that is all but nothing, or lies across a pose, has no direction to compare.
    clear = np.linalg.norm(rotations, axis=-1) > 1e-2
    units = rotations / np.linalg.norm(rotations, axis=-1, keepdims=True)
    assert np.abs((turned * units).sum(axis=-1))[clear] == pytest.approx(1.0, abs=1e-4)
    assert effectors == pytest.approx(lengths, abs=1e-6)
