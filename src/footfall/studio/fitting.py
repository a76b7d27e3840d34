"""Motions as a body performs them: retargeted once, before they are performed, where they must."""

from __future__ import annotations

from footfall.engine import MotionLibrary
from footfall.errors import FootfallError
from footfall.motion import Clip
from footfall.scenario.motions import Motion
from footfall.skeleton import Skeleton

__all__ = ["Fitting"]


class Fitting:
    """Remembers what each motion has become on each body."""

    def __init__(self) -> None:
        """Begin with nothing."""
        # What was made stands beside what it was made of, so that no address is used again.
        self._known: dict[tuple[int, ...], tuple[object, ...]] = {}
        self._made: dict[tuple[int, ...], Clip | str] = {}

    def clip(self, motion: Motion, body: Skeleton, shown: Clip | None) -> Clip | str:
        """Return a motion as a body performs it, or why it cannot.

        The library of the engine itself makes it, so that a scenario that is saved comes to the
        same.

        Args:
            motion: The motion.
            body: Who performs it.
            shown: The first motion of that body, which shows how it stands; None: this one.
        """
        parts = (motion.clip, motion.supports, body, shown)
        key = tuple(map(id, parts))
        if key not in self._made:
            library = MotionLibrary(skeleton=body, neutral=shown)
            try:
                library.add("motion", motion.clip, motion.supports)
                made: Clip | str = library.actions[0].clip
            except FootfallError as error:
                made = str(error)
            self._known[key], self._made[key] = parts, made
        return self._made[key]
