"""How a character is kept on a path: mixed of what goes that way, and turned."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Weights
from footfall.engine.crowd import Crowd
from footfall.engine.directions import Directions
from footfall.engine.foreseeing import stopping_place
from footfall.engine.mixed_actions import MixedActions
from footfall.errors import ArgumentError
from footfall.geometry.ground_path import GroundPath, wrapped

__all__ = ["PathFollower"]

FASTEST_TURN = math.radians(75.0)
"""[rad/s]"""

HARDEST_TURN = 4.0
"""The most by which that changes [rad/s²]."""

TURN_TIME = 0.35
"""In what time it turns to where it should face [s]."""

SWAY = 0.3
"""Length over which what it is off the path is averaged, since every step sways [m]."""

SLOWEST = 0.4
"""It counts as being at least so fast there [m/s]."""

QUICKEST = 1.5
"""The most by which a share changes [1/s]."""

CHORD = 0.3
"""Length over which the direction of a path is taken [m]."""

PULL = 1.5
"""How fast it comes back to the path, as a share of what it is off [1/s]."""

LEARNING = 0.5
"""How fast it learns by how much a mix goes elsewhere than foreseen, likewise [1/s]."""

WIDEST = 0.6
"""The most that it heads back to the path [rad]."""

BACKWARD, FORWARD = 0.3, 1.0
"""How far along the path from where it was it is looked for [m]."""

BRAKING = 2.0
"""How far before the end it is asked where a stop would lead [m]."""

ASKED_EVERY = 0.1
"""How often [s]."""

NEAR_ENOUGH = 0.1
"""How far before the end it may come to rest [m], for the next moment leads beyond it."""


class PathFollower:
    """Keeps one character of a crowd on a path until it stops at its end.

    `Character.follow` makes one and calls it; whoever drives a crowd calls `steer` before each
    advance of at most 1/30 s.
    """

    def __init__(
        self,
        crowd: Crowd,
        row: int,
        path: npt.ArrayLike,
        actions: Sequence[str] | None = None,
        *,
        facing: npt.ArrayLike | None = None,
        heading: npt.ArrayLike | None = None,
    ) -> None:
        """Let a character follow a path; arguments and errors as of `Character.follow`.

        Args:
            crowd: The crowd.
            row: Which of its characters.
            path: Points on the ground.
            actions: What it may be mixed of.
            facing: Where it faces as seen from where the path leads.
            heading: Where it faces in the world.
        """
        self.path = GroundPath.through(path)
        if facing is not None and heading is not None:
            raise ArgumentError("both a facing and a heading; the body has one of them")
        self._absolute = heading is not None
        asked = heading if heading is not None else 0.0 if facing is None else facing
        self._facings = _checked_facings(asked, len(self.path.points))
        crowd.place_of(row)
        self._crowd, self._row, self._actions = crowd, row, actions
        self._directions = self._measured()
        x, z, _ = crowd.place_of(row)
        self._distance, self._away = self.path.nearest(x, z, 0.0, self.path.length)
        self._speed = self._turn = self._off = self._bias = self._asked = 0.0
        self._mixed = MixedActions(crowd, row, self._directions.actions.tolist())
        self._stopping = self._done = False

    @property
    def distance(self) -> float:
        """How far along the path the character is [m]."""
        return self._distance

    @property
    def away(self) -> float:
        """How far it is off the path, to its left [m]."""
        return self._away

    @property
    def done(self) -> bool:
        """Whether it has come to rest at the end of the path, or was told to stop."""
        return self._done

    def stop(self) -> None:
        """Let the character leave the path where it is, and come to rest."""
        self._stopping = True
        self._mixed.stop()

    def steer(self, dt: float) -> None:
        """Mix and turn the character for the next step [s]."""
        if self._done:
            return
        x, z, heading = self._crowd.place_of(self._row)
        before = self._distance
        self._distance, self._away = self.path.nearest(
            x, z, max(before - BACKWARD, -BACKWARD), min(before + FORWARD, self.path.length)
        )
        if dt > 0.0:
            share = min(dt / 0.3, 1.0)
            self._speed += share * ((self._distance - before) / dt - self._speed)
        if not self._stopping and self._is_near_the_end():
            self.stop()
        if self._stopping:
            self._come_to_rest(dt)
            return
        back = self._way_back(dt)
        self._mixed.weigh(self._mix(heading - back), QUICKEST * dt)
        ahead = min(self._distance + self._speed * TURN_TIME, self.path.length)
        self._turn_towards(self._asked_heading(ahead) + back - heading, dt)

    def _measured(self) -> Directions:
        crowd = self._crowd
        return Directions.of(crowd.library, crowd.shelf, crowd.rig.leg_length, self._actions)

    def _way_back(self, dt: float) -> float:
        """Return by how much it has to head to the left to come back to the path [rad]."""
        speed = max(self._speed, SLOWEST)
        self._off += min(dt * speed / SWAY, 1.0) * (self._away - self._off)
        pull = PULL * self._off / speed
        self._bias = min(max(self._bias + LEARNING * pull * dt, -WIDEST), WIDEST)
        back = math.atan(pull) + self._bias
        return -min(max(back, -WIDEST), WIDEST)

    def _aim(self, distance: float) -> tuple[float, float]:
        """Return where the path leads, and where that is as seen from a body as asked for [rad]."""
        way = self.path.direction(distance, CHORD)
        facing = float(np.interp(distance, self.path.distances, self._facings))
        return way, wrapped(way - facing) if self._absolute else -facing

    def _asked_heading(self, distance: float) -> float:
        """Return where the body faces there for its mix to go where the path leads [rad]."""
        way, aim = self._aim(distance)
        return way - self._directions.direction(self._directions.shares(aim))

    def _mix(self, heading: float) -> Weights:
        """Return the shares that lead where the path does, for a body that faces there [rad]."""
        way, aim = self._aim(self._distance)
        shares = self._directions.shares(aim)
        if not self._directions.reach(aim):
            return shares
        foreseen = self._directions.direction(shares)
        return self._directions.shares(wrapped(aim + wrapped(way - heading - foreseen)))

    def _turn_towards(self, left: float, dt: float) -> None:
        """Let the root turn by an angle [rad] as fast as it may."""
        wanted = min(max(wrapped(left) / TURN_TIME, -FASTEST_TURN), FASTEST_TURN)
        most = HARDEST_TURN * dt
        self._turn += min(max(wanted - self._turn, -most), most)
        self._crowd.steer(self._turn, [self._row])

    def _is_near_the_end(self) -> bool:
        """Return whether a stop now leads as near to the end as it will."""
        left = self.path.length - self._distance
        if left > BRAKING or self._crowd.clock_of(self._row) < self._asked:
            return False
        self._asked = self._crowd.clock_of(self._row) + ASKED_EVERY
        x, z = stopping_place(self._crowd, self._row, self._directions.actions.tolist())
        end, _ = self.path.nearest(x, z, self._distance, self.path.length + BRAKING)
        return end >= self.path.length - NEAR_ENOUGH

    def _come_to_rest(self, dt: float) -> None:
        """Let the turn end; be done where nothing plays any more."""
        self._turn_towards(0.0, dt)
        if not self._mixed.present:
            self._crowd.steer(None, [self._row])
            self._done = True


def _checked_facings(facing: npt.ArrayLike, points: int) -> Floats:
    """Return where the body faces at each point of the path [rad], shape (points,)."""
    try:
        facings = np.asarray(facing, dtype=np.float64)
    except (TypeError, ValueError):
        raise ArgumentError(
            "a facing must be a number, or one for each point of the path"
        ) from None
    if facings.shape not in ((), (points,)):
        raise ArgumentError(
            f"facings of shape {facings.shape}; give one number, or {points}, one a point"
        )
    if not np.isfinite(facings).all():
        raise ArgumentError("a facing is not finite; give angles [rad]")
    return np.broadcast_to(facings, (points,))
