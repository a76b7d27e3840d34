"""Cohorts: rows of a crowd, side by side, whose characters have one body and one ground.

Eight characters are placed at once, by one body: so a cohort begins where a block of eight does,
and rows before it that would be of two cohorts stay empty.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Indices, Positions, Rotations, SmallFloats
from footfall.errors import ArgumentError
from footfall.octets import LANES
from footfall.skeleton import Skeleton
from footfall.skeleton.octet_poses import PLACEMENT

__all__ = ["Cohort", "Common", "Layout", "Span", "blocks_of", "lay_out", "with_more"]


class Span(NamedTuple):
    """Which rows have which body, on which ground."""

    body: int
    """Number of the body."""

    ground: int
    """Number of the ground."""

    first: int
    """The first row; the first of a block."""

    rows: int
    """How many rows."""

    @property
    def end(self) -> int:
        """The row after the last."""
        return self.first + self.rows


@dataclass(frozen=True, eq=False, slots=True)
class Cohort:
    """Characters of one body on one ground; all arrays are views of the crowd's own memory."""

    span: Span
    """Which rows of the crowd these are, and the number of their body."""

    skeleton: Skeleton
    """Their body."""

    characters: npt.NDArray[Any]
    """What they remember: records of `Character`, shape (rows,)."""

    poses: SmallFloats
    """Joints relative to the roots, as `Crowd.poses`, shape (blocks, joints, 7, 8)."""

    world_positions: Positions
    """Joints in the world [m], shape (rows, joints, 3)."""

    world_rotations: Rotations
    """Joints in the world, shape (rows, joints, 4)."""

    @property
    def rows(self) -> Indices:
        """Their row numbers in the crowd, shape (rows,)."""
        return np.arange(self.span.first, self.span.end)


class Common(NamedTuple):
    """What crowds have whose bodies all have the same number of joints: arrays of all rows."""

    poses: SmallFloats
    """As `Crowd.poses`, shape (blocks, joints, 7, 8)."""

    world_positions: Positions
    """Shape (rows, joints, 3)."""

    world_rotations: Rotations
    """Shape (rows, joints, 4)."""


class Layout(NamedTuple):
    """Where the poses of a crowd are: those of one cohort after those of another."""

    cohorts: tuple[Cohort, ...]
    """All of them, in the order of their rows."""

    poses: SmallFloats
    """The numbers of all `Cohort.poses`, shape (numbers,)."""

    arrays: Common | None
    """The same memory as arrays of all rows; None where bodies differ in their joints."""

    def common(self) -> Common:
        """Return the arrays of all rows.

        Raises:
            ArgumentError: If bodies differ in their number of joints.
        """
        if self.arrays is None:
            counts = sorted({cohort.skeleton.count for cohort in self.cohorts})
            raise ArgumentError(
                f"bodies of {counts[0]} and of {counts[-1]} joints have no array in common; read "
                "the crowd's cohorts one by one"
            )
        return self.arrays


def blocks_of(rows: int) -> int:
    """Return how many blocks of eight so many rows fill."""
    return -(-rows // LANES)


def with_more(spans: Sequence[Span], body: int, ground: int, count: int) -> list[Span]:
    """Return spans, at least one, with so many more rows of a body on a ground at their end."""
    *others, last = spans
    if (last.body, last.ground) == (body, ground):
        return [*others, last._replace(rows=last.rows + count)]
    full = last._replace(rows=LANES * blocks_of(last.end) - last.first)
    return [*others, full, Span(body, ground, full.end, count)]


def lay_out(
    spans: Sequence[Span],
    skeletons: Sequence[Skeleton],
    characters: npt.NDArray[Any],
    poses: SmallFloats,
) -> Layout:
    """Return the cohorts of some spans, and room for their poses.

    Args:
        spans: They follow one another.
        skeletons: All bodies.
        characters: Records of all rows, shape (rows,).
        poses: Those of so many of the first rows as there were before, one after the other,
            shape (numbers,).
    """
    counts = [skeletons[span.body].count for span in spans]
    sizes = [blocks_of(s.rows) * n * PLACEMENT * LANES for s, n in zip(spans, counts, strict=True)]
    memory = np.zeros(sum(sizes), dtype=np.float32)
    memory[: len(poses)] = poses
    joints = sum(span.rows * count for span, count in zip(spans, counts, strict=True))
    positions, rotations = np.zeros(3 * joints), np.zeros(4 * joints)
    cohorts: list[Cohort] = []
    pose = joint = 0
    for span, count, size in zip(spans, counts, sizes, strict=True):
        after = joint + span.rows * count
        cohorts.append(
            Cohort(
                span,
                skeletons[span.body],
                characters[span.first : span.end],
                memory[pose : pose + size].reshape(-1, count, PLACEMENT, LANES),
                _rows_of(positions[3 * joint : 3 * after], span, count),
                _rows_of(rotations[4 * joint : 4 * after], span, count),
            )
        )
        pose, joint = pose + size, after
    arrays = None
    if len(set(counts)) == 1:
        arrays = Common(
            memory.reshape(-1, counts[0], PLACEMENT, LANES),
            positions.reshape(-1, counts[0], 3),
            rotations.reshape(-1, counts[0], 4),
        )
    return Layout(tuple(cohorts), memory, arrays)


def _rows_of(numbers: Floats, span: Span, joints: int) -> Floats:
    return numbers.reshape(span.rows, joints, -1)
