"""The bodies of a crowd, and the motions of its library as each of them performs them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from footfall.adaptation.goal_body import GoalBody, goal_body_of
from footfall.arrays import Indices
from footfall.engine.hands import Palms, palms_of
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import Parameters, Parts
from footfall.engine.shelf import Shelf
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
        self.shelf: Shelf = library.shelf(planner)
        self.parameters = Parameters()
        self._planner: Planner = planner
        self._known = len(library.actions)

    @property
    def behind(self) -> bool:
        """Whether the library has learned actions since."""
        return len(self.library.actions) != self._known

    def refresh(self, parts: Parts) -> None:
        """Take over actions that the library has learned since.

        Args:
            parts: Records of all characters that perform these motions.
        """
        self.shelf = self.library.shelf(self._planner)
        self._known = len(self.library.actions)
        self.parameters.write(self.shelf, parts, self.library.actions)

    def ask(
        self,
        parts: Parts,
        action: int,
        speed: float | None,
        turn: float | None,
    ) -> None:
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


@dataclass(frozen=True, eq=False)
class Body:
    """One body of a crowd."""

    skeleton: Skeleton
    """Its joints, in the order of its motions."""

    rig: Rig
    """The same as the kernels take it."""

    repertoire: Repertoire
    """The motions that it performs."""

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

    def repertoires_of(self, bodies: Indices) -> Indices:
        """Return the number of each body's repertoire, shape (...)."""
        own = [self.repertoires.index(body.repertoire) for body in self.all]
        return np.array(own)[bodies]

    def learn(self) -> None:
        """Adapt motions that the library has learned since to the bodies of other families.

        Raises:
            SkeletonError: If one cannot be adapted.
        """
        for other in self.repertoires[1:]:
            self._library.adapted(other.library.skeleton)


def _same(one: Skeleton, other: Skeleton) -> bool:
    return (
        one.names == other.names
        and np.array_equal(one.parents, other.parents)
        and np.array_equal(one.rest_offsets, other.rest_offsets)
    )
