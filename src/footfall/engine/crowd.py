"""A crowd: many characters of one body, and the arrays of commands that drive them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.adaptation import AnyGround, BuiltGround, Plane
from footfall.adaptation.surface_record import Ground
from footfall.arrays import Positions, Rotations, SmallFloats, Supports
from footfall.engine.flight import Flight, flight_of
from footfall.engine.library import MotionLibrary
from footfall.engine.parameters import FINEST, Parameters
from footfall.engine.pipeline import advance_blocks
from footfall.engine.placing import world_poses_of
from footfall.engine.populating import Populating, blocks_of
from footfall.engine.reaching import Reaching
from footfall.engine.standing import Standing
from footfall.engine.state import Workspace, new_characters
from footfall.engine.workers import Workers
from footfall.errors import ArgumentError, SkeletonError
from footfall.octets import LANES
from footfall.skeleton import Skeleton
from footfall.skeleton.octet_poses import PLACEMENT
from footfall.skeleton.rig import Rig
from footfall.sync.tables import Planner, rules_of

__all__ = ["Crowd"]


class Crowd(Standing, Reaching, Populating):
    """Characters that share a motion library and a body. One character is a crowd of one.

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
            skeleton: Their body, its joints in any order; by default the library's.
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
            SkeletonError: If the skeleton has other joints than the library's.
        """
        if size < 1:
            raise ArgumentError(f"a crowd of {size}; it needs at least 1 character")
        if lookahead < 1:
            raise ArgumentError(f"a look-ahead of {lookahead} slots; it must be at least 1")
        if skeleton is not None and not skeleton.same_family(library.skeleton):
            raise SkeletonError(
                f"a body of {skeleton.count} joints cannot perform motions of "
                f"{library.skeleton.count}; joint names and parents must be the same"
            )
        self.library = library
        self.skeleton = (skeleton or library.skeleton).ordered_like(library.skeleton)
        self._planner: Planner = planner
        self._rules = rules_of(planner, ended="stop" if planner == "paper" else None)
        self._rig = library.rig(self.skeleton)
        self._shelf = library.shelf(planner)
        self._known = library.size
        self._workers = Workers(self.skeleton.count, threads)
        self._newborn = new_characters(1, lookahead)
        self._newborn["synchronized"] = synchronized
        self._newborn["printed"] = footprints and synchronized
        self._newborn["flight"] = flight_of(flight)
        self._parameters = Parameters()
        self._characters, self._poses = self._newborn[:0], self._blank_poses(0)
        self._make_room(size)
        self._characters["present"] = 1
        self.ground = Plane() if ground is None else ground

    def _blank_poses(self, rows: int) -> SmallFloats:
        shape = (blocks_of(rows), self.skeleton.count, PLACEMENT, LANES)
        return np.zeros(shape, dtype=np.float32)

    def _make_room(self, rows: int) -> None:
        characters = np.repeat(self._newborn, rows)
        characters["present"] = 0
        characters[: self.size] = self._characters
        joints = self.skeleton.count
        poses = self._blank_poses(rows)
        poses[: len(self._poses)] = self._poses
        self._characters, self._poses = characters, poses
        self._make_hands_room(rows)
        self._world_positions: Positions = np.zeros((rows, joints, 3))
        self._world_rotations: Rotations = np.zeros((rows, joints, 4))
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
        if isinstance(self._ground, BuiltGround):
            self._pass(float(dt))
            return
        grounds = self._packed(self._ground, float(dt))
        for ground in grounds:
            self._packed_ground = ground
            self._pass(dt / len(grounds))

    def _pass(self, left: float) -> None:
        """Let a time pass on the ground as it is packed."""
        while self._parameters.moving and left > FINEST:
            self._step(FINEST)
            left -= FINEST
        self._step(left)

    def _step(self, dt: float) -> None:
        """Let a time pass in which parameters are worked out once."""
        if self._parameters.moving and dt > 0.0:
            self._parameters.advance(self._shelf, self._characters, self.library.actions, dt)

        def advance(work: Workspace, first: int, end: int) -> None:
            advance_blocks(
                self._shelf,
                self._packed_ground,
                self._rig,
                self._characters,
                work,
                self._rules,
                self._poses,
                dt,
                first,
                end,
            )

        self._workers.run(advance, len(self._poses))
        self._stale = True
        if self._hands is not None:
            self._in_world()
            self._move_hands(self._world_rotations, self._world_positions, dt)

    def _in_world(self) -> None:
        if self._stale:
            world_poses_of(
                self._characters, self._poses, self._world_rotations, self._world_positions
            )
            self._stale = False

    @property
    def characters(self) -> npt.NDArray[Any]:
        """Everything the crowd remembers: records of `Character`, shape (rows,); a view."""
        return self._characters

    @property
    def rig(self) -> Rig:
        """Their body as the kernels take it."""
        return self._rig

    @property
    def packed_ground(self) -> Ground:
        """What they stand on, as the kernels take it."""
        return self._packed_ground

    @property
    def poses(self) -> SmallFloats:
        """Joints relative to the roots, eight characters side by side, as they are worked out.

        Rotation w, x, y, z and position x, y, z [m] of each joint, shape (blocks, joints, 7, 8):
        character `row` is in block `row // 8`, place `row % 8`. A view that advance overwrites.
        """
        return self._poses

    @property
    def world_positions(self) -> Positions:
        """Joints in the world [m], shape (rows, joints, 3), worked out when they are asked for.

        A view that is overwritten when they are asked for after the next advance.
        """
        self._in_world()
        return self._world_positions

    @property
    def world_rotations(self) -> Rotations:
        """Joints in the world, shape (rows, joints, 4); likewise."""
        self._in_world()
        return self._world_rotations

    @property
    def supports(self) -> Supports:
        """What carries each character, values of `Support`, shape (rows,)."""
        return self._characters["support"]
