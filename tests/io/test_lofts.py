from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests import walking_figure

from footfall.io.lofts import Surface, capsule, ellipsoid, loft_surface
from footfall.io.mannequin import mannequin
from footfall.skeleton import Skeleton, find_anatomy

LENGTHS = st.floats(-1.0, 1.0)


def volume(surface: Surface) -> float:
    a, b, c = np.moveaxis(surface.positions[surface.triangles], 1, 0)
    return float(np.einsum("ti,ti->", a, np.cross(b, c))) / 6.0


def closed(triangles: np.ndarray[tuple[int, int], np.dtype[np.int64]]) -> bool:
    edges = Counter[tuple[int, int]]()
    for one, two, three in triangles.tolist():
        edges.update([(one, two), (two, three), (three, one)])
    return all(count == 1 and edges[(other, one)] == 1 for (one, other), count in edges.items())


@settings(deadline=None)
@given(st.tuples(LENGTHS, LENGTHS, LENGTHS), st.floats(0.01, 0.1), st.floats(0.01, 0.1))
def test_a_capsule_is_closed_and_seen_from_outside(
    end: tuple[float, float, float], one: float, other: float
) -> None:
    if np.linalg.norm(end) < 0.05:
        return
    surface = loft_surface(capsule(np.zeros(3), np.array(end), one, other), 9)
    assert closed(surface.triangles)
    assert volume(surface) > 0.0
    np.testing.assert_allclose(np.linalg.norm(surface.normals, axis=-1), 1.0)


def test_an_ellipsoid_has_its_volume() -> None:
    x, y, _ = np.eye(3)
    surface = loft_surface(ellipsoid(np.ones(3), x, y, (0.1, 0.2, 0.3)), 60)
    assert volume(surface) == pytest.approx(4.0 / 3.0 * np.pi * 0.006, rel=0.05)


def test_every_limb_of_a_mannequin_is_closed() -> None:
    skeleton = walking_figure.skeleton()
    body = mannequin(skeleton, find_anatomy(skeleton))
    assert closed(body.triangles)
    outward = np.einsum("vi,vi->v", body.normals, body.normals)
    np.testing.assert_allclose(outward, 1.0)


def test_soles_are_level_and_a_little_under_the_toes() -> None:
    skeleton = walking_figure.skeleton()
    body = mannequin(skeleton, find_anatomy(skeleton))
    for ankle in (3, 7):
        foot = body.positions[body.joints == ankle]
        assert -0.09 < foot[:, 1].min() < -0.06
        assert foot[:, 2].min() < -0.03
        assert foot[:, 2].max() > 0.13


def test_a_rig_handle_gets_no_limb() -> None:
    plain = walking_figure.skeleton()
    rigged = Skeleton(
        (*plain.names, "foot_ik_handle"),
        np.append(plain.parents, 0),
        np.vstack([plain.rest_offsets, [0.0, -0.9, 0.6]]),
        np.vstack([plain.tip_offsets, np.zeros(3)]),
    )
    with_handle = mannequin(rigged, find_anatomy(rigged))
    without = mannequin(plain, find_anatomy(plain))
    np.testing.assert_array_equal(with_handle.positions, without.positions)
