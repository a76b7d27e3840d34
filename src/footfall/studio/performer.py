"""The one place where the studio touches the engine: a character that performs, and its ghost.

Everything else of the studio sees only what this module returns. Time passes here in whole frames
of the scenario, exactly as `footfall.scenario.perform` lets it pass, so that what was steered by
hand comes out of the scenario file bit for bit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

import numpy as np

from footfall.adaptation import AnyGround, ground_heights
from footfall.arrays import Floats, Positions, Rotations
from footfall.engine import Waiting
from footfall.engine.inspection import ActionState, PlannedSlot, action_states, planned_slots
from footfall.errors import ArgumentError
from footfall.geometry import rotate
from footfall.motion import Clip, with_soles
from footfall.scenario.cue_sheet import ActionEntry, Scenario
from footfall.scenario.goal_change import GoalChange
from footfall.scenario.motions import Motion
from footfall.scenario.preparation import add_action, prepare_character
from footfall.skeleton import Skeleton, find_anatomy, leg_length
from footfall.studio.slip_meter import SlipMeter
from footfall.support import Support

__all__ = ["Performer"]

Priority = float | Mapping[str, float]

CONTACT_SHARE = 0.05
"""A foot point is in contact below this share of the leg's length over its lowest place."""


class Performer:
    """A character of a scenario that is steered by hand."""

    def __init__(
        self,
        scenario: Scenario,
        motions: tuple[Motion, ...],
        leading: int = 0,
        *,
        body: Skeleton | None = None,
        clips: Sequence[Clip] | None = None,
        synchronized: bool = True,
    ) -> None:
        """Let a character stand where the motion of its leading action begins.

        Args:
            scenario: Its actions; cues are not read.
            motions: Of each action.
            leading: The action that will be started first.
            body: Instead of the scenario's.
            clips: The motions as the body performs them; None: as they are.
            synchronized: Whether supports are synchronized, or clips are only cross-faded.
        """
        self._character, self.floor = prepare_character(
            scenario,
            motions,
            leading,
            body=body,
            clips=clips,
            synchronized=synchronized,
            footprints=synchronized,
        )
        self._fps = scenario.fps
        self._clock = 0.0
        self.frame = 0
        self.skeleton = self._character.skeleton
        shown = self._character.library.actions[0].clip
        self.anatomy = with_soles(find_anatomy(self.skeleton), *shown.world_poses())
        length = leg_length(self.skeleton, self.anatomy.left)
        self.slip = SlipMeter(CONTACT_SHARE * length)
        legs = self.anatomy.legs
        self._joints = np.array([[leg.heel.joint, leg.toe.joint] for leg in legs])
        self._offsets = np.array([[leg.heel.offset, leg.toe.offset] for leg in legs])

    @property
    def clock(self) -> float:
        """Clock time [s]."""
        return self.frame / self._fps

    @property
    def support(self) -> Support:
        """What carries the body."""
        return Support(int(self._character.crowd.supports[0]))

    @property
    def positions(self) -> Positions:
        """Joints in the world [m], shape (joints, 3); a view that advancing overwrites."""
        return self._character.crowd.world_positions[0]

    @property
    def rotations(self) -> Rotations:
        """Joints in the world, shape (joints, 4); a view that advancing overwrites."""
        return self._character.crowd.world_rotations[0]

    @property
    def ground(self) -> AnyGround:
        """What it stands on."""
        return self._character.crowd.ground

    @property
    def root(self) -> tuple[float, float, float]:
        """Where it is: x, z [m] and heading [rad]."""
        return self._character.root

    def heights(self, points: Positions) -> Floats:
        """Return how high the ground is now under some points [m], shape (...)."""
        times = np.full(points.shape[:-1], self.clock)
        return ground_heights(self.ground, points, times)

    @property
    def foot_points(self) -> Positions:
        """Heel and toe of the left and the right foot in the world [m], shape (2, 2, 3)."""
        return self.positions[self._joints] + rotate(self.rotations[self._joints], self._offsets)

    def add(self, entry: ActionEntry, motion: Motion) -> None:
        """Add an action to those that can be started."""
        add_action(self._character, entry, motion)

    def stand(self) -> None:
        """Pose a character that is only looked at: one that has stood begins its actions faded."""
        self._character.advance(0.0)

    def start(self, name: str) -> str:
        """Start an action; return what it waits for, or nothing where it runs."""
        answer = self._character.start(name)
        self._settle()
        return answer.reason if isinstance(answer, Waiting) else ""

    def stop(self, name: str) -> None:
        """Let an action fade out, or cancel its wait."""
        self._character.stop(name)
        self._settle()

    def set_priority(self, name: str, priority: Priority) -> None:
        """Change the priority of an action that runs or waits."""
        self._character.set_priority(name, priority)

    def gait(self, name: str) -> tuple[float, float]:
        """Return the speed [m/s] and the turn [rad/s] of an action by now; 0 if it has none."""
        return self._character.parameters_of(name)

    def reach(self, name: str) -> tuple[tuple[float, float], tuple[float, float]] | None:
        """Return from where to where speed [m/s] and turn [rad/s] go; None: it is one motion."""
        library = self._character.library
        gaits = library.actions[library.index(name)].locomotion
        if gaits is None:
            return None
        spans = [(float(one.min()), float(one.max())) for one in (gaits.speeds, gaits.turns)]
        return spans[0], spans[1]

    def check_gait(self, name: str, speed: float, turn: float) -> None:
        """Refuse a speed [m/s] and a turn [rad/s] that an action does not reach.

        Raises:
            ArgumentError: If it does not, or is one motion.
        """
        library = self._character.library
        gaits = library.actions[library.index(name)].locomotion
        if gaits is None:
            raise ArgumentError(f"{name!r} is one motion; only a gait of several is steered")
        gaits.checked(speed, turn)

    def steer(self, name: str, kind: Literal["speed", "turn"], value: float) -> None:
        """Ask a gait for another speed [m/s] or turn [rad/s]."""
        self._character.set_parameters(name, **{kind: value})

    def meet(self, change: GoalChange) -> None:
        """Set or drop a goal; errors as of `GoalChange.give`."""
        change.give(self._character.goals)

    def is_active(self, name: str) -> bool:
        """Whether an action runs, fades or waits."""
        return self._character.is_active(name)

    def exchange_ground(self, ground: AnyGround, rise: float) -> None:
        """Put it on other ground, which takes it along by a rise [m]."""
        self._character.crowd.exchange_ground(ground, rise=rise)

    def advance(self) -> None:
        """Let one frame pass."""
        self.frame += 1
        time = self.frame / self._fps
        self._character.advance(time - self._clock)
        self._clock = time
        points = self.foot_points
        carried = self._character.crowd.characters["carried"][0]
        self.slip.measure(points, points[..., 1] - self.heights(points), carried, self.support)

    def states(self) -> tuple[ActionState, ...]:
        """Return what each action does."""
        return action_states(self._character.crowd)

    def planned(self) -> tuple[PlannedSlot, ...]:
        """Return the slots that are decided."""
        return planned_slots(self._character.crowd)

    def schedule_text(self) -> str:
        """Return the decided slots as figures 7 to 9 print them."""
        return str(self._character.schedule)

    def _settle(self) -> None:
        # The first frame is posed after the commands given at it, as a scenario does it.
        if self.frame == 0:
            self._character.advance(0.0)
