"""The layers of a motion library: what can be laid over its actions."""

from __future__ import annotations

import math
from collections.abc import Sequence

from footfall.engine.layer import UPPER_BODY, Layer, pack_turns, parse_parts
from footfall.engine.library_body import LibraryBody
from footfall.errors import ArgumentError, UnknownNameError
from footfall.motion import Clip
from footfall.support import SupportSequence

__all__ = ["LibraryLayers"]

STANDING = SupportSequence.parse("D")
"""What a layer's body is taken to stand on where it has to be brought onto another one."""


class LibraryLayers(LibraryBody):
    """The part of a motion library that knows its layers."""

    @property
    def layers(self) -> tuple[Layer, ...]:
        """All layers; a layer's id is its index."""
        return tuple(self._layers)

    @property
    def size(self) -> int:
        """How many actions and layers there are."""
        return len(self._actions) + len(self._layers)

    def layer_index(self, name: str) -> int:
        """Return the id of a layer.

        Raises:
            UnknownNameError: If there is none of this name.
        """
        for index, layer in enumerate(self._layers):
            if layer.name == name:
                return index
        raise UnknownNameError("layer", name, [layer.name for layer in self._layers])

    def add_layer(
        self,
        name: str,
        clip: Clip,
        *,
        parts: Sequence[str] = UPPER_BODY,
        reference: Clip | None = None,
        fade_in: float = 0.3,
        fade_out: float = 0.3,
    ) -> int:
        """Add a motion that is laid over what plays, as the difference to a pose; return its id.

        It stands on nothing and is no part of the schedule: it starts whenever it is told to, goes
        at its own speed, and moves no foot. A cycle, or a single pose, lies until it is stopped;
        any other clip fades out so as to be gone by its end.

        Args:
            name: What commands will call it; new to this library.
            clip: The motion.
            parts: The body parts that it turns: some of trunk, head, arms, left_arm, right_arm.
            reference: Its first frame is the pose over which the clip comes out as it is; by
                default the clip's own first frame.
            fade_in: How long a start takes to become complete [s], >= 0.
            fade_out: How long a stop takes to become complete [s], >= 0.

        Raises:
            ArgumentError: If the name is taken, a number is out of range, or it has no body part,
                or the legs.
            UnknownNameError: If a body part is unknown.
            SkeletonError: If a clip's skeleton has other joints than the library's, and its motion
                cannot be retargeted.
        """
        self._check_new(name, fade_in, fade_out)
        turned = parse_parts(repr(name), parts)
        clip = self._in_family(repr(name), clip, STANDING)
        pose = clip
        if reference is not None:
            pose = self._in_family(f"the reference of {name!r}", reference, STANDING)
        keys = pack_turns(clip, pose, self.anatomy, turned)
        self._layers.append(Layer(name, clip, turned, fade_in, fade_out, keys))
        return len(self._layers) - 1

    def _check_new(self, name: str, fade_in: float, fade_out: float) -> None:
        for kind, known in (("an action", self._actions), ("a layer", self._layers)):
            if any(one.name == name for one in known):
                raise ArgumentError(f"there already is {kind} named {name!r}; names must differ")
        for label, seconds in (("fade_in", fade_in), ("fade_out", fade_out)):
            if not (math.isfinite(seconds) and seconds >= 0.0):
                raise ArgumentError(f"{label} of {name!r} is {seconds} s; it must be >= 0")
