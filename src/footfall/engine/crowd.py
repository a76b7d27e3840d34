"""A crowd: many characters, and the arrays of commands that drive them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround, BuiltGround, Plane
from footfall.arrays import Indices, Positions, Rotations, SmallFloats, Supports
from footfall.engine.advancing import Advancing
from footfall.engine.bodies import Bodies
from footfall.engine.cohorts import Cohort, Span, lay_out
from footfall.engine.flight import Flight, flight_of
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import FINEST
from footfall.engine.placing import world_poses_of
from footfall.engine.populating import Populating
from footfall.engine.remembering import Remembering
from footfall.engine.standing import Standing
from footfall.engine.state import new_characters
from footfall.engine.workers import Workers
from footfall.errors import ArgumentError
from footfall.skeleton import Skeleton
from footfall.skeleton.rig import Rig
from footfall.sync.tables import Planner, rules_of

__all__ = ["Crowd"]


class Crowd(Standing, Remembering, Populating):
    """Characters that share a motion library. One character is a crowd of one.

    Those that are spawned may have other bodies: see `Populating.spawn` and `cohorts`.

    Same commands, same bits, on however many threads: nothing here reads a clock or rolls dice.
    """

    def __init__(
        self,
        library: MotionLibrary,
        size: int = 1,
        *,
        skeleton: Skeleton | None = None,
        ground: AnyGround | None = None,
        planner: Planner = "footfall",
        lookahead: int = 5,
        synchronized: bool = True,
        footprints: bool = True,
        flight: Flight = "played",
        threads: int | None = None,
    ) -> None:
        """Place characters at the origin, facing +z, doing nothing.

        Args:
            library: Its actions can be started, also those that are added later.
            size: How many characters, >= 1; more can be spawned.
            skeleton: Their body; by default the library's. Of its family, the joints in any
                order, or any other one that its motions can be retargeted to.
            ground: What they stand on; by default a plane at height 0.
            planner: "footfall", or "paper" for the rule as printed.
            lookahead: How many slots ahead phases are synchronized, >= 1.
            synchronized: Whether supports are synchronized at all; if not, motions are
                cross-faded as they are, joint by joint.
            footprints: Whether planted feet are held where they came down.
            flight: What happens while nothing carries: motions are "played" as they are; weights
                are "frozen" as they were at take-off; or the body is "ballistic" too, it falls
                freely however long the flight is made (S-27).
            threads: How many threads advance a large crowd, >= 1; by default one a processor.

        Raises:
            ArgumentError: If a number is out of range, or the flight is unknown.
            SkeletonError: If the skeleton has other joints than the library's, and a motion
                cannot be retargeted.
        """
        if size < 1:
            raise ArgumentError(f"a crowd of {size}; it needs at least 1 character")
        if lookahead < 1:
            raise ArgumentError(f"a look-ahead of {lookahead} slots; it must be at least 1")
        self.library = library
        self._rules = rules_of(planner, ended="stop" if planner == "paper" else None)
        self._bodies = Bodies(library, planner)
        self._bodies.index_of(skeleton)
        self._workers = Workers(threads, lookahead)
        self._newborn = new_characters(1, lookahead)
        self._newborn["synchronized"] = synchronized
        self._newborn["printed"] = footprints and synchronized
        self._newborn["flight"] = flight_of(flight)
        self._characters = self._newborn[:0]
        self._grounds, self._packed_grounds = [], []
        self._stand_on(Plane() if ground is None else ground)
        self._make_room([Span(0, 0, 0, size)])
        self._characters["present"] = 1

    def _make_room(self, spans: Sequence[Span]) -> None:
        characters = np.repeat(self._newborn, spans[-1].end)
        characters["present"] = 0
        characters[: self.size] = self._characters
        poses = self._layout.poses if self.size else np.zeros(0, dtype=np.float32)
        self._characters = characters
        skeletons = [body.skeleton for body in self._bodies.all]
        for skeleton in skeletons:
            self._workers.workspaces(skeleton.count)
        self._layout = lay_out(spans, skeletons, characters, poses)
        self._cohorts = self._layout.cohorts
        self._advancing = Advancing(self._cohorts, self._workers)
        self._body_of_row = np.repeat([s.body for s in spans], [s.rows for s in spans])
        self._ground_of_row = np.repeat([s.ground for s in spans], [s.rows for s in spans])
        self._make_hands_room(len(characters))
        self._make_goals_room()
        self._stale = True

    def advance(self, dt: float) -> None:
        """Let time pass for everybody.

        Args:
            dt: How much [s], >= 0 and finite; 0 only works out the poses.

        Raises:
            ArgumentError: If `dt` is negative or not finite.
            GroundError: If they stand on a program's own ground, and it fails; nothing has moved
                then.
        """
        if not (0.0 <= dt < float("inf")):
            raise ArgumentError(f"dt is {dt} s; it must be finite and >= 0")
        self._refresh()
        if all(isinstance(ground, BuiltGround) for ground in self._grounds):
            self._pass(float(dt))
            return
        steps = self._sampled_grounds(float(dt))
        for grounds in steps:
            self._packed_grounds = grounds
            self._pass(dt / len(steps))

    def _pass(self, left: float) -> None:
        """Let a time pass on the grounds as they are packed."""
        while left > FINEST and self._steered():
            self._step(FINEST)
            left -= FINEST
        self._step(left)

    def _step(self, dt: float) -> None:
        """Let a time pass in which parameters are worked out once."""
        if dt > 0.0 and self._steered():
            self._steer(dt)
        self._advancing.advance(self._bodies.all, self._packed_grounds, self._rules, dt)
        self._stale = True
        if self._hands is not None or self._goals is not None:
            self._in_world()
            self._move_hands(dt)
            self._meet_goals(dt)

    def _in_world(self) -> None:
        if self._stale:
            for cohort in self._cohorts:
                world_poses_of(
                    cohort.characters, cohort.poses, cohort.world_rotations, cohort.world_positions
                )
            self._stale = False

    @property
    def characters(self) -> npt.NDArray[Any]:
        """Everything the crowd remembers: records of `Character`, shape (rows,); a view."""
        return self._characters

    @property
    def skeleton(self) -> Skeleton:
        """The body of the first cohort."""
        return self._bodies.all[0].skeleton

    @property
    def bodies(self) -> tuple[Skeleton, ...]:
        """All bodies, in the order in which they came."""
        return tuple(body.skeleton for body in self._bodies.all)

    @property
    def body_of_row(self) -> Indices:
        """Which of `bodies` each row has, shape (rows,)."""
        return self._body_of_row

    @property
    def rig(self) -> Rig:
        """The body of the first cohort as the kernels take it."""
        return self._bodies.all[0].rig

    @property
    def poses(self) -> SmallFloats:
        """Joints relative to the roots, eight characters side by side, as they are worked out.

        Rotation w, x, y, z and position x, y, z [m] of each joint, shape (blocks, joints, 7, 8):
        character `row` is in block `row // 8`, place `row % 8`. A view that advance overwrites.

        Raises:
            ArgumentError: If there are bodies of different numbers of joints; read `cohorts`.
        """
        return self._layout.common().poses

    @property
    def world_positions(self) -> Positions:
        """Joints in the world [m], shape (rows, joints, 3), worked out when they are asked for.

        A view that is overwritten when they are asked for after the next advance.

        Raises:
            ArgumentError: As `poses`.
        """
        self._in_world()
        return self._layout.common().world_positions

    @property
    def world_rotations(self) -> Rotations:
        """Joints in the world, shape (rows, joints, 4); likewise."""
        self._in_world()
        return self._layout.common().world_rotations

    @property
    def cohorts(self) -> tuple[Cohort, ...]:
        """Rows side by side that have one body, with their poses: views, likewise."""
        self._in_world()
        return self._cohorts

    @property
    def supports(self) -> Supports:
        """What carries each character, values of `Support`, shape (rows,)."""
        return self._characters["support"]
