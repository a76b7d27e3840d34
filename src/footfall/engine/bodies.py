"""The bodies of a crowd, and the motions of its library as each of them performs them."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from footfall.adaptation.goal_body import GoalBody, goal_body_of
from footfall.engine.hands import Palms, palms_of
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import Parameters, Parts
from footfall.engine.shelf import Shelf
from footfall.engine.sole_keys import sole_keys_of
from footfall.skeleton import Skeleton
from footfall.skeleton.arm_ik import arm_rig_of
from footfall.skeleton.rig import Rig
from footfall.sync.tables import Planner

__all__ = ["Bodies", "Body", "Repertoire"]


class Repertoire:
    """The motions of a library, adapted once and packed for the kernels of one crowd."""

    def __init__(self, library: MotionLibrary, planner: Planner) -> None:
        """Pack the motions of a library; they move its own skeleton."""
        self.library = library
        self.parameters = Parameters()
        self._planner: Planner = planner
        self.pack()

    @property
    def behind(self) -> bool:
        """Whether the library has learned actions since, or a motion has changed."""
        return self.library.revision != self._known

    def pack(self) -> None:
        """Pack the motions that the library has by now."""
        self.shelf: Shelf = self.library.shelf(self._planner)
        self._known = self.library.revision

    def write(self, parts: Parts) -> None:
        """Write the mix of every gait that has been steered, after `pack`.

        Args:
            parts: All characters that perform these motions.
        """
        self.parameters.write(self.shelf, parts, self.library.actions)

    def ask(self, parts: Parts, action: int, speed: float | None, turn: float | None) -> None:
        """Ask a locomotion for a speed [m/s] and a turn [rad/s]; errors as of `Parameters.ask`."""
        known = self.library.actions[action]
        self.parameters.ask(self.shelf, parts, known, action, (speed, turn))

    def speed_of(self, other: Repertoire, action: int, speed: float) -> float:
        """Return as how fast another body performs a gait [m/s] that this one does at a speed."""
        gait = other.library.actions[action].locomotion
        assert gait is not None
        asked = speed * other.library.rig().leg_length / self.library.rig().leg_length
        # Retargeted clips may go a little slower than the length of the legs says.
        return float(np.clip(asked, gait.speeds.min(), gait.speeds.max()))


class Body:
    """One body of a crowd."""

    def __init__(self, skeleton: Skeleton, rig: Rig, repertoire: Repertoire) -> None:
        """Fit motions to a body.

        Args:
            skeleton: Its joints, in the order of its motions.
            rig: The same as the kernels take it.
            repertoire: The motions that it performs.
        """
        self.skeleton, self.rig, self.repertoire = skeleton, rig, repertoire
        self.fit()

    def fit(self) -> None:
        """Take over the motions of its repertoire as they are by now.

        Feet belong to a body: the arrays are all the same but for where its heels and toes are.
        """
        packed, points = self.repertoire.shelf, self.rig.foot_points / self.rig.leg_length
        soles = sole_keys_of(packed.keys, packed.joints, points)
        self.shelf: Shelf = packed._replace(points=points, sole_keys=soles)

    @cached_property
    def palms(self) -> Palms:
        """Its arms and palms."""
        anatomy = self.repertoire.library.anatomy
        return palms_of(self.skeleton, anatomy, arm_rig_of(self.skeleton, anatomy))

    @cached_property
    def goals(self) -> GoalBody:
        """What of it meets goals."""
        return goal_body_of(self.skeleton, self.repertoire.library.anatomy)


class Bodies:
    """All bodies of a crowd.

    Those of the library's family share its motions as they are packed: normalized poses belong to
    no body. Any other one has the motions adapted to itself, once.
    """

    def __init__(self, library: MotionLibrary, planner: Planner) -> None:
        """Begin without a body."""
        self._library = library
        self._planner: Planner = planner
        self.all: list[Body] = []
        self.repertoires = [Repertoire(library, planner)]

    def index_of(self, skeleton: Skeleton | None) -> int:
        """Return the number of a body, which becomes one of the crowd if it is not yet.

        Args:
            skeleton: The body; None: the crowd's first one, or else the library's own.

        Raises:
            SkeletonError: If the motions of the library cannot be adapted to it.
        """
        if skeleton is None:
            if self.all:
                return 0
            skeleton = self._library.skeleton
        if skeleton.same_family(self._library.skeleton):
            skeleton = skeleton.ordered_like(self._library.skeleton)
        for index, known in enumerate(self.all):
            if _same(known.skeleton, skeleton):
                return index
        self.all.append(self._body(skeleton))
        return len(self.all) - 1

    def _body(self, skeleton: Skeleton) -> Body:
        if skeleton.same_family(self._library.skeleton):
            own = self.repertoires[0]
            return Body(skeleton, self._library.rig(skeleton), own)
        adapted = self._library.adapted(skeleton)
        self.repertoires.append(Repertoire(adapted, self._planner))
        return Body(skeleton, adapted.rig(), self.repertoires[-1])

    def learn(self) -> None:
        """Take over actions that the library has learned since, adapted to every body.

        Raises:
            SkeletonError: If one cannot be adapted.
        """
        for other in self.repertoires[1:]:
            self._library.adapted(other.library.skeleton)
        for repertoire in self.repertoires:
            repertoire.pack()
        for body in self.all:
            body.fit()


def _same(one: Skeleton, other: Skeleton) -> bool:
    return (
        one.names == other.names
        and np.array_equal(one.parents, other.parents)
        and np.array_equal(one.rest_offsets, other.rest_offsets)
    )
