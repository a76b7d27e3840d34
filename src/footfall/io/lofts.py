"""Closed surfaces of elliptical rings: capsules, ellipsoids, soles; what a mannequin is made of."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions

__all__ = ["Loft", "Surface", "capsule", "ellipsoid", "loft_surface", "vertex_rings"]

_DOME = np.radians([-90.0, -60.0, -30.0, 0.0])


@dataclass(frozen=True, eq=False)
class Loft:
    """Elliptical rings along an axis; the first and the last are points."""

    centers: Positions
    """Center of each ring [m], shape (rings, 3)."""

    across: Positions
    """Unit direction of the ring's half-width, shape (3,)."""

    over: Positions
    """Unit direction of the ring's half-height, shape (3,); their cross product is the axis."""

    radii: Floats
    """Half-width, half-height above and half-height below of each ring [m], (rings, 3)."""


@dataclass(frozen=True, eq=False)
class Surface:
    """Triangles with smooth normals, seen from outside counterclockwise."""

    positions: Positions
    """Vertices [m], shape (vertices, 3)."""

    normals: Positions
    """Unit normals, shape (vertices, 3)."""

    triangles: Indices
    """Vertex indices, shape (triangles, 3)."""


def capsule(start: Positions, end: Positions, radius_start: float, radius_end: float) -> Loft:
    """Return a round bone from `start` to `end` [m] with domes of these radii [m] at its ends."""
    axis = _unit(end - start)
    spare: Positions = np.eye(3)[int(np.abs(axis).argmin())]
    across = _unit(np.cross(axis, spare))
    sine, cosine = np.sin(_DOME), np.cos(_DOME)
    along = np.concatenate([sine * radius_start, -sine[::-1] * radius_end])
    roots = np.concatenate([np.tile(start, (4, 1)), np.tile(end, (4, 1))])
    radii = np.concatenate([cosine * radius_start, cosine[::-1] * radius_end])
    return Loft(
        roots + along[:, np.newaxis] * axis,
        across,
        np.cross(axis, across),
        np.repeat(radii[:, np.newaxis], 3, axis=1),
    )


def ellipsoid(
    center: Positions, across: Positions, over: Positions, half: tuple[float, float, float]
) -> Loft:
    """Return an ellipsoid with half-axes [m] along `across`, `over` and their cross product."""
    angles = np.radians(np.linspace(-90.0, 90.0, 9))
    axis = np.cross(across, over)
    along = np.sin(angles) * half[2]
    round_ = np.cos(angles)
    radii = np.stack([round_ * half[0], round_ * half[1], round_ * half[1]], axis=-1)
    return Loft(center + along[:, np.newaxis] * axis, across, over, radii)


def loft_surface(loft: Loft, segments: int) -> Surface:
    """Return the surface of a loft, `segments` vertices around.

    The end rings collapse to one vertex each, so that no triangle is degenerate.
    """
    turn = np.linspace(0.0, 2.0 * np.pi, segments, endpoint=False)
    cosine, sine = np.cos(turn), np.sin(turn)
    inner = loft.radii[1:-1, :, np.newaxis]
    height = np.where(sine >= 0.0, inner[:, 1], inner[:, 2]) * sine
    width = inner[:, 0] * cosine
    rings = (
        loft.centers[1:-1, np.newaxis]
        + width[..., np.newaxis] * loft.across
        + height[..., np.newaxis] * loft.over
    )
    positions = np.concatenate([rings.reshape(-1, 3), loft.centers[[0]], loft.centers[[-1]]])
    triangles = _triangles(len(rings), segments)
    return Surface(positions, _normals(positions, triangles), triangles)


def vertex_rings(rings: int, segments: int) -> Indices:
    """Return the ring of a loft that each vertex of its surface lies on, shape (vertices,)."""
    return np.concatenate([np.repeat(np.arange(1, rings - 1), segments), [0, rings - 1]])


def _triangles(rings: int, segments: int) -> Indices:
    one = np.arange(segments)
    other = (one + 1) % segments
    first, last = rings * segments, rings * segments + 1
    top = (rings - 1) * segments
    parts = [np.stack([np.full(segments, first), other, one], axis=-1)]
    for ring in range(rings - 1):
        low, high = ring * segments, (ring + 1) * segments
        parts.append(np.stack([low + one, low + other, high + other], axis=-1))
        parts.append(np.stack([low + one, high + other, high + one], axis=-1))
    parts.append(np.stack([top + one, top + other, np.full(segments, last)], axis=-1))
    return np.concatenate(parts)


def _normals(positions: Positions, triangles: Indices) -> Positions:
    corners = positions[triangles]
    faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sums = np.zeros_like(positions)
    for corner in range(3):
        np.add.at(sums, triangles[:, corner], faces)
    return sums / np.linalg.norm(sums, axis=-1, keepdims=True)


def _unit(vector: Positions) -> Positions:
    return vector / np.linalg.norm(vector)
