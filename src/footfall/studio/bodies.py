"""The bodies and the grounds that are offered. One more choice is one more entry here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from footfall.motion import Clip
from footfall.skeleton import Skeleton, find_anatomy, leg_length

__all__ = ["GROUNDS", "Body", "Ground", "bodies_of", "standing_clip"]


@dataclass(frozen=True, eq=False)
class Body:
    """A body that can perform."""

    name: str
    """What the chooser calls it."""

    skeleton: Skeleton | None
    """The body; None: that of the first motion."""


@dataclass(frozen=True, slots=True)
class Ground:
    """A ground that can be stood on."""

    name: str
    """What the chooser calls it."""

    least: float
    """The lowest it can be put [m]."""

    greatest: float
    """The highest [m]."""


GROUNDS = (Ground("level", -0.5, 0.5),)
"""What the engine can stand on."""

SIZES = (("child", 0.72, 1.0), ("tall", 1.14, 1.0), ("long legs", 1.0, 1.18))
"""Name, factor of every bone, and factor of the legs beside it."""


def bodies_of(skeletons: Sequence[Skeleton]) -> tuple[Body, ...]:
    """Return the bodies offered for motions of these skeletons: their own, and other sizes."""
    if not skeletons:
        return ()
    own = [Body("own", None)]
    own += [Body(f"own {number}", other) for number, other in enumerate(skeletons[1:], start=2)]
    return (*own, *(Body(name, _sized(skeletons[0], all_, legs)) for name, all_, legs in SIZES))


def _sized(skeleton: Skeleton, factor: float, legs: float) -> Skeleton:
    factors = np.full((skeleton.count, 1), factor)
    for leg in find_anatomy(skeleton).legs:
        joint = leg.ankle
        while joint != leg.hip:
            factors[joint] *= legs
            joint = int(skeleton.parents[joint])
    return replace(
        skeleton,
        rest_offsets=skeleton.rest_offsets * factors,
        tip_offsets=skeleton.tip_offsets * factor,
    )


def standing_clip(skeleton: Skeleton) -> Clip:
    """Return a clip of one frame that carries a body into a file."""
    rotations = np.tile([1.0, 0.0, 0.0, 0.0], (1, skeleton.count, 1))
    height = leg_length(skeleton, find_anatomy(skeleton).left)
    return Clip(skeleton, np.array([[0.0, height, 0.0]]), rotations, 60.0, name="body")
