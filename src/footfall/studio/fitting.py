"""Motions as a body performs them: retargeted once, before they are performed, where they must."""

from __future__ import annotations

from footfall.engine import MotionLibrary
from footfall.errors import FootfallError
from footfall.motion import Clip
from footfall.scenario.motions import Motion
from footfall.skeleton import Skeleton

__all__ = ["Fitting"]

Begin = tuple[float | None, float | None]
Key = tuple[float | None, ...]


class Fitting:
    """Remembers what each motion has become on each body."""

    def __init__(self) -> None:
        """Begin with nothing."""
        # What was made stands beside what it was made of, so that no address is used again.
        self._known: dict[Key, tuple[object, ...]] = {}
        self._made: dict[Key, Clip | str] = {}

    def clip(
        self, motion: Motion, body: Skeleton, shown: Clip | None, begin: Begin = (None, None)
    ) -> Clip | str:
        """Return a motion as a body performs it, of a gait the first one, or why it cannot.

        The library of the engine itself makes it, so that a scenario that is saved comes to the
        same.

        Args:
            motion: The motion.
            body: Who performs it.
            shown: The first motion of that body, which shows how it stands; None: this one.
            begin: The speed and the turn with which a gait begins.
        """
        clips = [(one.clip, one.supports) for one in (motion, *motion.others)]
        parts = (body, shown, *(part for pair in clips for part in pair))
        key = (*map(id, parts), *begin)
        if key not in self._made:
            library = MotionLibrary(skeleton=body, neutral=shown)
            try:
                if motion.others:
                    library.add_locomotion("motion", clips, speed=begin[0], turn=begin[1])
                else:
                    library.add("motion", *clips[0])
                made: Clip | str = library.actions[0].clip
            except FootfallError as error:
                made = str(error)
            self._known[key], self._made[key] = parts, made
        return self._made[key]
