"""One character: a crowd of one, with names instead of numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from footfall.adaptation import AnyGround
from footfall.engine.answers import Impossible, Started, Waiting
from footfall.engine.crowd import Crowd
from footfall.engine.flight import Flight
from footfall.engine.following import Following
from footfall.engine.inspection import ActionState, action_states, present_schedule
from footfall.engine.layered import Layered
from footfall.engine.learning import Learning
from footfall.engine.library import MotionLibrary
from footfall.engine.refusals import Late
from footfall.engine.showing import show_character
from footfall.engine.state import EMPTY, WAITING, Frame
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.support import Support
from footfall.sync.schedule import Schedule
from footfall.sync.tables import Planner

__all__ = ["Character"]


class Character(Layered, Following, Learning):
    """A body that performs actions which start and stop at any moment."""

    def __init__(
        self,
        skeleton: Skeleton,
        *,
        ground: AnyGround | None = None,
        planner: Planner = "footfall",
        lookahead: int = 5,
        synchronized: bool = True,
        footprints: bool = True,
        flight: Flight = "played",
        neutral: Clip | None = None,
    ) -> None:
        """Prepare a character at the origin, facing +z; it can perform once it has an action.

        Args:
            skeleton: Its body.
            ground: What it stands on; by default a plane at height 0.
            planner: "footfall", or "paper" for the rule as printed.
            lookahead: How many slots ahead phases are synchronized, >= 1.
            synchronized: Whether supports are synchronized at all.
            footprints: Whether planted feet are held where they came down.
            flight: "played", "frozen" or "ballistic", as of `Crowd`.
            neutral: Its first frame is how the character stands that does nothing.
        """
        self.skeleton = skeleton
        self.library = MotionLibrary(skeleton=skeleton, neutral=neutral)
        self._options: dict[str, Any] = {
            "ground": ground,
            "planner": planner,
            "lookahead": lookahead,
            "synchronized": synchronized,
            "footprints": footprints,
            "flight": flight,
        }
        self._crowd: Crowd | None = None

    @property
    def crowd(self) -> Crowd:
        """The crowd of one that this character is.

        Raises:
            ArgumentError: If it has no action yet.
        """
        if self._crowd is None:
            if not self.library.actions:
                raise ArgumentError("the character has no action yet; add one first")
            self._crowd = Crowd(self.library, 1, skeleton=self.skeleton, **self._options)
        return self._crowd

    def set_parameters(
        self, name: str, *, speed: float | None = None, turn: float | None = None
    ) -> None:
        """Ask a locomotion for another speed [m/s] or turn [rad/s]; errors as of `Crowd`."""
        self.crowd.set_parameters(self.library.index(name), speed=speed, turn=turn)

    def parameters_of(self, name: str) -> tuple[float, float]:
        """Return the speed [m/s] and the turn [rad/s] that a locomotion has by now.

        Raises:
            UnknownNameError: If there is no action of this name.
        """
        return self.crowd.parameters_of(self.library.index(name))

    def start(
        self, name: str, *, patience: float = math.inf, late: Late = "give up"
    ) -> Started | Waiting:
        """Start an action, or let it wait for its moment.

        Args:
            name: Which action.
            patience: How long it waits at most [s], >= 0; for ever by default.
            late: What becomes of a start that has waited so long: "give up", or "mute" to play
                it at once without its legs, which rejoin as soon as there is room.

        Returns:
            `Started`; `Waiting` with the reason and the expected moment; or `Impossible`, which
            is a `Waiting` too, with the proof. `stop` cancels a wait.

        Raises:
            UnknownNameError: If there is no action of this name.
            ArgumentError: If too many actions run at the same time, or the patience or what
                comes after it is none.
        """
        action = self.library.index(name)
        crowd = self.crowd
        started = bool(crowd.start(action, patience=patience, late=late)[0])
        clock = float(crowd.characters[0]["clock"])
        if started:
            return Started(clock)
        refusal = crowd.refusal(action, 0)
        until = None if refusal.seconds is None else clock + refusal.seconds
        return (Impossible if refusal.impossible else Waiting)(refusal.reason, until)

    def stop(self, name: str) -> None:
        """Let an action fade out, or cancel its wait.

        Raises:
            UnknownNameError: If there is no action of this name.
        """
        self.crowd.stop(self.library.index(name))

    def set_priority(
        self, name: str, priority: float | Mapping[str, float], *, fade: float | None = None
    ) -> None:
        """Change the priority of a running or waiting action; as `Crowd.set_priority`."""
        self.crowd.set_priority(self.library.index(name), priority, fade=fade)

    def place(self, x: float, z: float, heading: float = 0.0) -> None:
        """Put the character somewhere: x, z [m] and heading [rad], 0 facing +z."""
        self.crowd.place((x, z), heading)

    @property
    def root(self) -> tuple[float, float, float]:
        """Where the character is: x, z [m] and heading [rad], 0 facing +z."""
        x, z, heading = self.crowd.characters[0]["root"].tolist()
        return x, z, heading

    def raise_ground(self, height: float) -> None:
        """Put the level ground at another height [m]; the character is carried along."""
        self.crowd.raise_ground(height)

    def is_waiting(self, name: str) -> bool:
        """Whether a start of this action still waits."""
        action = self.library.index(name)
        me = self.crowd.characters[0]
        return bool(((me["status"] == WAITING) & (me["action"] == action)).any())

    def is_active(self, name: str) -> bool:
        """Whether this action runs, fades or waits."""
        action = self.library.index(name)
        me = self.crowd.characters[0]
        return bool(((me["status"] != EMPTY) & (me["action"] == action)).any())

    def state(self, name: str) -> ActionState:
        """Return what an action does: its weights, its phase, why it waits.

        Raises:
            UnknownNameError: If there is no action of this name.
        """
        return action_states(self.crowd)[self.library.index(name)]

    @property
    def schedule(self) -> Schedule:
        """The slots that are decided: a copy that prints, also in a notebook."""
        return present_schedule(self.crowd)

    def show(self) -> object:
        """Show the character live, in a browser or in a notebook.

        Returns:
            What the viewer gives back; the studio's shows itself in a notebook.

        Raises:
            MissingViewerError: If no viewer is installed.
        """
        return show_character(self)

    def advance(self, dt: float) -> Frame:
        """Let time pass.

        Args:
            dt: How much [s], >= 0; 0 only works out the pose.

        Returns:
            The pose: a view that the next advance overwrites.

        Raises:
            ArgumentError: If `dt` is negative or not finite, or there is no action yet.
        """
        crowd = self.crowd
        self._go_on(dt)
        me = crowd.characters[0]
        return Frame(
            float(me["clock"]),
            Support(int(me["support"])),
            crowd.world_positions[0],
            crowd.world_rotations[0],
        )
