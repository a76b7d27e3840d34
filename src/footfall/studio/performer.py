"""The one place where the studio touches the engine: a character that performs, and its ghost.

Everything else of the studio sees only what this module returns. Time passes here in whole frames
of the scenario, exactly as `footfall.scenario.perform` lets it pass, so that what was steered by
hand comes out of the scenario file bit for bit.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.engine import Waiting
from footfall.engine.inspection import ActionState, PlannedSlot, action_states, planned_slots
from footfall.geometry import rotate
from footfall.motion import with_soles
from footfall.report import carried_steps
from footfall.scenario.cue_sheet import ActionEntry, Scenario
from footfall.scenario.motions import Motion
from footfall.scenario.preparation import add_action, prepare_character
from footfall.skeleton import Anatomy, Skeleton, find_anatomy, leg_length
from footfall.support import Support

__all__ = ["Performer", "SlipMeter"]

Priority = float | Mapping[str, float]

CONTACT_SHARE = 0.05
"""A foot point is in contact below this share of the leg's length over its lowest place."""


@dataclass(eq=False)
class SlipMeter:
    """How far each planted foot has slid since it came down, as the reports measure it."""

    anatomy: Anatomy
    contact_height: float

    def __post_init__(self) -> None:
        self.slid: Floats = np.zeros(2)
        """Of each foot, since it was planted [m]; of its last span while it swings, shape (2,)."""
        self.total = 0.0
        """Of both feet, since the meter began [m]."""
        self._places: Positions | None = None
        self._planted = (False, False)
        self._lowest: Floats = np.full((2, 2), np.inf)

    def measure(self, points: Positions, support: Support, ground: float) -> None:
        """Take one frame: heel and toe of each foot in the world [m], shape (2, 2, 3)."""
        heights = points[..., 1] - ground
        self._lowest = np.minimum(self._lowest, heights)
        clearances = heights - self._lowest
        planted = (support.left, support.right)
        if self._places is not None:
            places = np.stack([self._places, points[..., [0, 2]]])
            both = np.stack([clearances, clearances])
            for foot in range(2):
                if not planted[foot]:
                    continue
                if not self._planted[foot]:
                    self.slid[foot] = 0.0
                    continue
                touching = both[:, foot] < self.contact_height
                step = carried_steps(places[:, foot], both[:, foot], touching)
                length = float(np.linalg.norm(step))
                self.slid[foot] += length
                self.total += length
        self._places = points[..., [0, 2]].copy()
        self._planted = planted


class Performer:
    """A character of a scenario that is steered by hand."""

    def __init__(
        self,
        scenario: Scenario,
        motions: tuple[Motion, ...],
        leading: int = 0,
        *,
        body: Skeleton | None = None,
        synchronized: bool = True,
    ) -> None:
        """Let a character stand where the motion of its leading action begins.

        Args:
            scenario: Its actions; cues are not read.
            motions: Of each action.
            leading: The action that will be started first.
            body: Instead of the scenario's.
            synchronized: Whether supports are synchronized, or clips are only cross-faded.
        """
        self._character, self.floor = prepare_character(
            scenario,
            motions,
            leading,
            body=body,
            synchronized=synchronized,
            footprints=synchronized,
        )
        self._fps = scenario.fps
        self._clock = 0.0
        self.frame = 0
        self.lift = 0.0
        self.skeleton = self._character.skeleton
        self.anatomy = with_soles(find_anatomy(self.skeleton), *motions[0].clip.world_poses())
        length = leg_length(self.skeleton, self.anatomy.left)
        self.slip = SlipMeter(self.anatomy, CONTACT_SHARE * length)
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
    def ground(self) -> float:
        """Height of the ground it stands on [m]."""
        return self.floor + self.lift

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

    def is_active(self, name: str) -> bool:
        """Whether an action runs, fades or waits."""
        return self._character.is_active(name)

    def raise_ground(self, lift: float) -> None:
        """Put the ground so far above where the first motion had it [m]."""
        self.lift = lift
        self._character.raise_ground(self.floor + lift)

    def advance(self, lift: float) -> None:
        """Let one frame pass, at the end of which the ground is so high [m]."""
        self.frame += 1
        time = self.frame / self._fps
        if lift != self.lift:
            self.raise_ground(lift)
        self._character.advance(time - self._clock)
        self._clock = time
        self.slip.measure(self.foot_points, self.support, self.ground)

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
