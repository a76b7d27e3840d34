"""Section 5: elements are put in order, then given one duration, then time is bent smoothly."""

from __future__ import annotations

import numpy as np
from tests.paper.requirements import requirement

import footfall as ff
from footfall.engine.state import RUNNING
from footfall.skeleton import BodyPart
from footfall.sync.tables import ABSENT


def mixed() -> ff.Character:
    hero = ff.Character(ff.sample("walk")[0].skeleton, planner="paper")
    hero.add("walk-slow", *ff.sample("walk-slow"), priority=2.0)
    hero.add("walk-fast", *ff.sample("walk-fast"))
    hero.start("walk-slow")
    hero.start("walk-fast")
    hero.advance(3.0)
    return hero


@requirement(61, "The synchronization algorithm uses three main steps to achieve its work.")
def test_order_duration_and_time_are_decided_one_after_the_other() -> None:
    hero = mixed()
    me = hero.crowd.characters[0]
    seats = np.flatnonzero(me["status"] >= RUNNING)
    assert len(seats) == 2
    slots: set[int] = set()
    for _ in range(600):
        before = me["rate"][seats].copy()
        hero.advance(1 / 480)
        # 1. One column a slot, playable.
        assert (me["phases"][seats, :6] != ABSENT).all()
        assert ff.Support.CONFLICT not in hero.schedule.results
        # 2. One duration for all: the mean of the phases' own, by the weights of the legs.
        weights = me["weights"][seats, BodyPart.LEGS]
        own = [
            hero.library.actions[int(me["action"][seat])]
            .supports.at(int(me["phases"][seat, 0]))
            .duration
            for seat in seats
        ]
        assert abs(float(me["slot_duration"]) - float(weights @ np.array(own))) < 0.02
        # 3. No step in speed: as fast as a smooth curve changes in a 480th of a second.
        assert np.abs(me["rate"][seats] - before).max() < 0.15
        slots.add(int(me["slot_index"]))
    assert len(slots) > 4
