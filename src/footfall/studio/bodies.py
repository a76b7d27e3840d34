"""The bodies and the grounds that are offered. One more choice is one more entry here."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from footfall.io import SkinnedBody, load_skinned
from footfall.motion import Clip
from footfall.scenario.ground_change import GROUND_KINDS
from footfall.skeleton import Skeleton, find_anatomy, leg_length

__all__ = [
    "GROUNDS",
    "HIGHEST",
    "LOWEST",
    "STEEPEST",
    "Body",
    "Wardrobe",
    "bodies_of",
    "standing_clip",
]

GROUNDS = GROUND_KINDS
"""What can be put on the plane."""

LOWEST, HIGHEST = -0.5, 0.5
"""How far the ground can be sunk and raised [m]."""

STEEPEST = 0.25
"""How far it can be tilted, rise per meter."""


@dataclass(frozen=True, eq=False)
class Body:
    """A body that can perform."""

    name: str
    """What the chooser calls it."""

    skeleton: Skeleton | None
    """The body; None: that of the first motion."""

    skin: SkinnedBody | None = None
    """Its skin; None: it is drawn as a mannequin."""


SIZES = (("child", 0.72, 1.0), ("tall", 1.14, 1.0), ("long legs", 1.0, 1.18))
"""Name, factor of every bone, and factor of the legs beside it."""


def bodies_of(skeletons: Sequence[Skeleton]) -> tuple[Body, ...]:
    """Return the bodies offered for motions of these skeletons: their own, and other sizes."""
    if not skeletons:
        return ()
    own = [Body("own", None)]
    own += [Body(f"own {number}", other) for number, other in enumerate(skeletons[1:], start=2)]
    return (*own, *(Body(name, _sized(skeletons[0], all_, legs)) for name, all_, legs in SIZES))


class Wardrobe:
    """The bodies that were read from files, each once as long as its file stays as it is."""

    def __init__(self) -> None:
        """Begin empty."""
        self._known: dict[tuple[Path, int, int], Body] = {}

    def body(self, path: Path, name: str) -> Body:
        """Return the character of a .glb or .gltf file, in its skin.

        Raises:
            FileFormatError: If the file cannot be read, or has no skin.
        """
        stamp = path.stat() if path.is_file() else None
        key = (path, stamp.st_mtime_ns, stamp.st_size) if stamp is not None else (path, 0, 0)
        if key not in self._known:
            skin = load_skinned(path)
            self._known[key] = Body(name, skin.skeleton, skin)
        return self._known[key]


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
