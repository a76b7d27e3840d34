"""The mannequin's torso: one surface from the crotch to the skull, which bends with the spine."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.io.body_plan import BodyPlan, Limb, RingJoints, Tone
from footfall.io.lofts import Loft, ellipsoid

__all__ = ["torso_limb"]

# Half-width and half-depth as shares of stature, from the middle of the pelvis to the neck.
_HEIGHTS = np.array([0.0, 0.12, 0.25, 0.4, 0.55, 0.7, 0.8, 0.88, 0.94, 1.0])
_WIDTHS = np.array([np.nan, 0.076, 0.072, 0.077, 0.084, 0.09, 0.09, 0.082, 0.067, 0.045])
_DEPTHS = np.array([0.059, 0.056, 0.053, 0.056, 0.061, 0.062, 0.06, 0.054, 0.046, 0.037])
_NECK = 0.03
_MIDDLE, _SEAT = 0.018, 0.062
"""Where the pelvis is widest, above the hips, and how far it reaches down from there."""
_RING = 0.012
"""Greatest distance of two rings."""
_REACH = 0.07
"""Greatest distance from a joint at which the surface still bends with it."""


@dataclass(frozen=True, eq=False)
class _Column:
    """Heights above the hips, along the trunk at rest [m]."""

    plan: BodyPlan
    hips: Positions
    """The middle between the hips, shape (3,)."""

    top: float
    """Where the neck leaves the trunk."""

    end: float
    """Where the surface ends: inside the skull, or at the top."""

    joints: tuple[tuple[float, int], ...]
    """From where on which joint moves it, upward."""

    def height(self, place: Positions) -> float:
        return float((place - self.hips) @ self.plan.up)


def torso_limb(plan: BodyPlan) -> Limb:
    """Return the pelvis, the trunk and the neck; the pelvis alone where no spine rises from it."""
    size = plan.stature
    column = _column(plan)
    if column.top < 0.12 * size:
        center = column.hips + _MIDDLE * size * plan.up
        half = (_widest(plan), _SEAT * size, float(_DEPTHS[0]) * size)
        return Limb(0, Tone.BODY, ellipsoid(center, plan.left, plan.up, half), 18)
    heights, scales = _rings(column)
    wide, deep = _profile(column, heights)
    over = np.cross(plan.up, plan.left)
    radii = np.stack([wide, deep, deep], axis=-1) * scales[:, np.newaxis]
    loft = Loft(_centers(column, heights), plan.left, over, radii)
    return Limb(0, Tone.BODY, loft, 24, _ring_joints(column, heights))


def _column(plan: BodyPlan) -> _Column:
    hips = 0.5 * (plan.rest[plan.anatomy.left.hip] + plan.rest[plan.anatomy.right.hip])
    bare = _Column(plan, hips, 0.0, 0.0, ())
    path, neck = plan.trunk_path, plan.neck_path
    top = bare.height(plan.rest[path[-1]] + plan.trunk_top)
    starts = [(bare.height(plan.rest[joint]), joint) for joint in path[1:]]
    end = top
    if neck and bare.height(plan.rest[neck[-1]]) > top:
        end = bare.height(plan.rest[neck[-1]]) + 0.02 * plan.stature
        starts += [(max(bare.height(plan.rest[joint]), top), joint) for joint in neck]
    return _Column(plan, hips, top, end, _in_order(starts, 0.012 * plan.stature, end))


def _in_order(
    starts: list[tuple[float, int]], least: float, end: float
) -> tuple[tuple[float, int], ...]:
    """Return the joints that move enough of the surface to be seen: at least `least` [m] of it."""
    kept: list[tuple[float, int]] = [(0.0, 0)]
    for start, joint in starts:
        if start >= end - 0.5 * least:
            continue
        if start - kept[-1][0] < least and len(kept) > 1:
            kept.pop()
        kept.append((max(start, kept[-1][0] + least), joint))
    return tuple(kept)


def _rings(column: _Column) -> tuple[Floats, Floats]:
    """Return the rings' heights and how far each is drawn in; the first and the last are points."""
    size = column.plan.stature
    middle, seat = _MIDDLE * size, _SEAT * size
    turns = np.radians(np.linspace(-90.0, 0.0, 8))
    rise = np.linspace(middle, column.end, max(int((column.end - middle) / (_RING * size)), 8) + 1)
    wide, deep = _profile(column, rise[-1:])
    dome = 0.35 * float(np.sqrt(wide[0] * deep[0]))
    close = np.radians([30.0, 60.0, 90.0])
    heights = [middle + np.sin(turns) * seat, rise[1:], column.end + np.sin(close) * dome]
    scales = [np.cos(turns), np.ones(len(rise) - 1), np.cos(close)]
    return np.concatenate(heights), np.concatenate(scales).clip(min=0.0)


def _widest(plan: BodyPlan) -> float:
    """Return half the width of the pelvis [m]."""
    hips = [plan.rest[leg.hip] for leg in plan.anatomy.legs]
    return 0.5 * float(np.linalg.norm(hips[0] - hips[1])) + 0.038 * plan.stature


def _profile(column: _Column, heights: Floats) -> tuple[Floats, Floats]:
    """Return half-width and half-depth at some heights [m]."""
    size = column.plan.stature
    middle = _MIDDLE * size
    places = middle + _HEIGHTS * (column.top - middle)
    wide, deep = size * _WIDTHS, size * _DEPTHS
    wide[0] = _widest(column.plan)
    if column.end > column.top:
        thin = column.top + np.array([0.25, 1.0]) * min(0.04 * size, column.end - column.top)
        places = np.append(places, thin)
        wide = np.append(wide, size * np.array([0.036, _NECK]))
        deep = np.append(deep, size * np.array([0.033, _NECK]))
    return np.interp(heights, places, wide), np.interp(heights, places, deep)


def _centers(column: _Column, heights: Floats) -> Positions:
    """Return the rings' centers, along the joints of the spine [m], shape (rings, 3)."""
    plan = column.plan
    marks = [column.hips + _MIDDLE * plan.stature * plan.up]
    marks += [plan.rest[joint] for _, joint in column.joints[1:] if joint in plan.trunk_path]
    marks += [plan.rest[plan.trunk_path[-1]] + plan.trunk_top]
    if column.end > column.top:
        marks += [plan.rest[joint] for joint in plan.neck_path]
    levels = [column.height(mark) for mark in marks]
    kept = [0]
    for index in range(1, len(marks)):
        if levels[index] > levels[kept[-1]] + 0.02 * plan.stature:
            kept.append(index)
    asides = np.array([marks[index] - levels[index] * plan.up for index in kept])
    at = [levels[index] for index in kept]
    aside = np.stack([np.interp(heights, at, asides[:, axis]) for axis in range(3)], axis=-1)
    return aside + heights[:, np.newaxis] * plan.up


def _ring_joints(column: _Column, heights: Floats) -> RingJoints:
    """Return what moves each ring: near a joint, evenly less the one below it."""
    starts = [start for start, _ in column.joints]
    limits = [-_SEAT * column.plan.stature, *starts[1:], column.end]
    lower = np.full(len(heights), column.joints[0][1], dtype=np.int64)
    upper, shares = lower.copy(), np.zeros(len(heights))
    for index, ((_, below), (start, joint)) in enumerate(pairwise(column.joints), start=1):
        room = min(start - limits[index - 1], limits[index + 1] - start)
        reach = min(0.5 * room, _REACH * column.plan.stature)
        share = np.clip((heights - start + reach) / (2.0 * reach), 0.0, 1.0)
        share = share * share * (3.0 - 2.0 * share)
        here = share > 0.0
        lower[here], upper[here], shares[here] = below, joint, share[here]
    # The joint that moves it most comes first.
    turned = shares > 0.5
    first = np.where(turned, upper, lower)
    shares = np.where(turned, 1.0 - shares, shares)
    other = np.where(turned, lower, upper)
    return RingJoints(first, np.where(shares > 0.0, other, first), shares)
