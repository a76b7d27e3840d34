"""A character that follows a path on the ground, whatever it faces (figure 15)."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy.typing as npt

from footfall.engine.handed import Handed
from footfall.engine.path_follower import PathFollower
from footfall.engine.pipeline import LONGEST_STEP

__all__ = ["Following"]


class Following(Handed):
    """The part of a character that goes where it is sent."""

    _follower: PathFollower | None = None

    def follow(
        self,
        path: npt.ArrayLike,
        actions: Sequence[str] | None = None,
        *,
        facing: npt.ArrayLike | None = None,
        heading: npt.ArrayLike | None = None,
    ) -> PathFollower:
        """Go along a path, mixed of the actions that go that way, and come to rest at its end.

        Of all actions, the two are mixed between whose own directions the path leads, as seen from
        the body: a walk and a side step, say. What is left is turned, evenly, the planted feet
        staying as they are; the path is rejoined where it was left. A path that is followed ends
        the one before.

        Args:
            path: Points on the ground, x and z [m], shape (points, 2); straight between them. It
                begins where it is nearest.
            actions: Names of what may be mixed: cyclic actions that travel, each its own way.
                None: all that are.
            facing: Where the body faces as seen from where the path leads [rad], 0 along it,
                to the left; one number, or one for each point. None: 0.
            heading: Where it faces in the world instead [rad], 0 to +z.

        Returns:
            The follower: how far it is, how far off the path, whether it is done.

        Raises:
            ArgumentError: If the path is no path, both a facing and a heading are given or have a
                wrong shape, or the actions do not travel or go the same way.
            UnknownNameError: If there is no action of a name.
        """
        follower = PathFollower(self.crowd, 0, path, actions, facing=facing, heading=heading)
        self._follower = follower
        return follower

    def _go_on(self, dt: float) -> None:
        """Let time pass, on the path if there is one."""
        follower = self._follower
        if follower is None or follower.done or not 0.0 < dt < math.inf:
            self.crowd.advance(dt)
            return
        steps = math.ceil(dt / LONGEST_STEP - 1e-9)
        for _ in range(steps):
            follower.steer(dt / steps)
            self.crowd.advance(dt / steps)
