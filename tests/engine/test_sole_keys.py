from __future__ import annotations

from typing import Any, cast

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

import footfall as ff
from footfall.arrays import SmallFloats
from footfall.compilation import kernel
from footfall.engine.sole_keys import resting_octets, sole_keys_of, sole_slides
from footfall.geometry import conjugate, from_yaw, rotate
from footfall.motion import extract_root_path, with_soles
from footfall.octet_memory import store
from footfall.skeleton import find_anatomy
from footfall.skeleton.normalized import by_component, normalize
from footfall.skeleton.rig import rig_of

some_keys: Any = arrays(np.float32, (4, 8), elements=st.floats(-1.0, 1.0, width=32))
places: Any = st.tuples(st.integers(0, 2), st.floats(0.0, 0.99), st.just(0))
turns = st.one_of(st.floats(-0.1, 0.1), st.floats(-3.0, 3.0))

Place = tuple[int, float, int]


@kernel
def slides_of(keys: SmallFloats, before: Place, now: Place, turn: float, out: SmallFloats) -> None:
    store(out, 0, sole_slides(keys, before, now, turn))


def between(rows: Any, place: Place) -> Any:
    return rows[place[0]] + place[1] * (rows[place[0] + 1] - rows[place[0]])


@settings(deadline=None)
@given(some_keys, places, places, turns)
def test_slides_are_the_way_of_each_point_seen_from_the_root_before(
    rows: SmallFloats, before: Place, now: Place, turn: float
) -> None:
    keys = np.concatenate([rows, rows[:, 4:], -rows[:, :4]], axis=1)
    out = np.empty(8, dtype=np.float32)
    slides_of(keys, before, now, turn, out)
    was, after = between(rows.astype(float), before), between(rows.astype(float), now)
    x = np.cos(turn) * after[:4] + np.sin(turn) * after[4:] - was[:4]
    z = np.cos(turn) * after[4:] - np.sin(turn) * after[:4] - was[4:]
    np.testing.assert_allclose(out, [*x, *z], atol=2e-6)


def test_points_are_where_the_body_has_its_heels_and_toes() -> None:
    clip, _ = ff.sample("walk")
    rotations, positions = clip.world_poses()
    anatomy = with_soles(find_anatomy(clip.skeleton), rotations, positions)
    rig, path = rig_of(clip.skeleton, anatomy), extract_root_path(clip, anatomy)
    keys = normalize(
        clip.skeleton, rig, clip.pelvis_positions, clip.local_rotations, path.headings, 0.0
    )
    found = sole_keys_of(
        by_component(keys, clip.skeleton.count),
        clip.skeleton.count,
        rig.foot_points / rig.leg_length,
    )
    # The root is on the ground under the pelvis.
    root = positions[:, 0] * [1.0, 0.0, 1.0]
    root_from_world = conjugate(from_yaw(path.headings))
    for side in range(2):
        ankle = cast(int, rig.limbs[side, 2])
        for point in range(2):
            offset = rotate(rotations[:, ankle], rig.foot_points[side, point])
            seen = rotate(root_from_world, positions[:, ankle] + offset - root) / rig.leg_length
            column = 2 * side + point
            np.testing.assert_allclose(found[:, column], seen[:, 0], atol=1e-5)
            np.testing.assert_allclose(found[:, column + 4], seen[:, 2], atol=1e-5)
    np.testing.assert_array_equal(found[:, 8:12], found[:, 4:8])
    np.testing.assert_array_equal(found[:, 12:], -found[:, :4])


def test_resting_heights_fill_the_first_half_of_an_octet() -> None:
    heights = np.arange(8.0).reshape(2, 2, 2)
    assert resting_octets(list(heights)).tolist() == [
        [0, 1, 2, 3, 0, 0, 0, 0],
        [4, 5, 6, 7, 0, 0, 0, 0],
    ]
