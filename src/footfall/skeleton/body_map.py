"""How the joints of one body are turned by those of another: plain arrays, ready for a kernel.

Both bodies are put into the same canonical pose. What turns a joint of the one away from there
turns the joint of the other likewise: with R the rotation of a reference joint, C its rotation in
the canonical pose and D that of the driven joint, the driven joint's rotation is R C⁻¹ D. A joint
between two others is driven by both.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Positions, Rotations, frozen
from footfall.geometry import conjugate, multiply
from footfall.skeleton.skeleton import Skeleton

__all__ = ["BodyMap", "Drive", "body_rotations", "local_rotations", "solve_turns"]


@dataclass(frozen=True, slots=True)
class Drive:
    """What turns one joint of a body."""

    one: int
    """A joint of the reference body."""

    other: int
    """A second one; the same where one is enough."""

    fraction: float
    """How far from `one` to `other` the joint is, 0 to 1."""

    reason: str
    """What part of the body it is and why, for `footfall info`."""


@dataclass(frozen=True, eq=False)
class BodyMap:
    """What turns each joint of a body, given how the joints of a reference body are turned.

    World rotation of joint j = nlerp(R[sources[j, 0]] · turns[j, 0],
    R[sources[j, 1]] · turns[j, 1], fractions[j]), R being the reference body's world rotations.
    Both may also be relative to the root instead of the world.
    """

    reference: Skeleton
    """The body that leads."""

    body: Skeleton
    """The body that follows."""

    sources: Indices
    """Reference joints that drive each joint, shape (joints, 2)."""

    fractions: Floats
    """Share of the second of them, 0 to 1, shape (joints,)."""

    turns: Rotations
    """From the frame of each source to that of the joint, shape (joints, 2, 4)."""

    reference_hips: Positions
    """Middle of the hip joints in the frame of the reference body's joint 0 [m], shape (3,)."""

    body_hips: Positions
    """The same of the body that follows [m], shape (3,)."""

    leg_ratio: float
    """Leg length of the body over that of the reference."""

    arm_ratios: tuple[float, float]
    """Left and right arm's length over the reference's; the leg's where either has no arm."""

    ankle_lift: float
    """How much higher the ankles of the body are over their soles than those of the reference
    scaled by `leg_ratio`, mean of both feet [m]: as much higher stands its pelvis."""

    reasons: tuple[str, ...]
    """One sentence for each joint of the body: what drives it, and why."""

    def __post_init__(self) -> None:
        for name in ("fractions", "turns", "reference_hips", "body_hips"):
            object.__setattr__(self, name, frozen(getattr(self, name)))
        object.__setattr__(self, "sources", frozen(self.sources, np.int64))


def body_rotations(body_map: BodyMap, reference_rotations: Rotations) -> Rotations:
    """Return how the body's joints are turned.

    Args:
        body_map: The map.
        reference_rotations: The reference joints in the world, or relative to the root, shape
            (frames, reference joints, 4).

    Returns:
        The body's joints in the same frame, shape (frames, joints, 4).
    """
    one, other = (
        multiply(reference_rotations[:, body_map.sources[:, row]], body_map.turns[:, row])
        for row in range(2)
    )
    opposed = np.einsum("fji,fji->fj", one, other) < 0.0
    share = body_map.fractions[:, np.newaxis]
    mixed = (1.0 - share) * one + share * np.where(opposed[..., np.newaxis], -other, other)
    return mixed / np.linalg.norm(mixed, axis=-1, keepdims=True)


def local_rotations(skeleton: Skeleton, world_rotations: Rotations) -> Rotations:
    """Return the joints relative to their parents, joint 0 as it is, (frames, joints, 4)."""
    local = np.array(world_rotations)
    above = world_rotations[:, skeleton.parents[1:]]
    local[:, 1:] = multiply(conjugate(above), world_rotations[:, 1:])
    return local


def solve_turns(
    sources: Indices, reference_canonical: Rotations, body_canonical: Rotations
) -> Rotations:
    """Return the turns of a map from the canonical poses of both bodies, (joints, 2, 4)."""
    back = conjugate(reference_canonical[sources])
    return multiply(back, body_canonical[:, np.newaxis])
