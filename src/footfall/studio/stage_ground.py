"""What the live character stands on, as it is asked to become: the stage's part for the ground."""

from __future__ import annotations

import math
from dataclasses import replace

from footfall.scenario.cue_sheet import Cue
from footfall.scenario.ground_change import GroundChange, GroundKind
from footfall.scenario.moving_ground import MovingGround
from footfall.studio.performer import Performer
from footfall.studio.take import Take

__all__ = ["StageGround"]


class StageGround:
    """The part of a stage that moves its ground."""

    asked: GroundChange
    """How the ground is to be."""

    ground: MovingGround
    """How it is by now."""

    performer: Performer | None
    begun: bool
    take: Take

    def lift_to(self, height: float) -> None:
        """Let the ground rise or sink to so far above where the first motion had it [m]."""
        self.ask(replace(self.asked, height=height))

    def tilt_to(self, ahead: float, aside: float) -> None:
        """Let the ground rise ahead of the character, and to its left [1], about its place."""
        heading = 0.0 if self.performer is None else self.performer.root[2]
        sine, cosine = math.sin(heading), math.cos(heading)
        slope = (sine * ahead + cosine * aside, cosine * ahead - sine * aside)
        self.ask(replace(self.asked, slope=slope))

    def put(self, kind: GroundKind) -> None:
        """Put something else on the ground, ahead of the character."""
        self.ask(replace(self.asked, kind=kind))

    def ask(self, change: GroundChange) -> None:
        """Let the ground become something else."""
        self.asked = change
        if self.performer is None:
            return
        self.ground.ask(change, self.performer.root)
        if self.begun:
            self.take = self.take.with_cue(Cue(self.performer.clock, "ground", ground=change))

    @property
    def tilt(self) -> tuple[float, float]:
        """How the ground rises ahead of the character, and to its left [1]."""
        x, z = self.ground.slope
        heading = 0.0 if self.performer is None else self.performer.root[2]
        sine, cosine = math.sin(heading), math.cos(heading)
        return x * sine + z * cosine, x * cosine - z * sine
