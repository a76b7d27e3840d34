"""Whatever is asked of a crowd, in whatever order: it stays whole, or refuses and is unchanged."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from footfall.adaptation import Plane, Stairs, Terrain
from footfall.engine import Crowd, MotionLibrary
from footfall.errors import ArgumentError
from footfall.samples import sample
from footfall.skeleton import BodyPart

ONCE_OR_CYCLIC = ("walk", "run", "kick", "jump", "hop-right", "side-step")
GAIT = len(ONCE_OR_CYCLIC)

ACTIONS = st.integers(0, GAIT)
ROWS = st.one_of(st.none(), st.lists(st.integers(0, 9), max_size=4, unique=True))
STEPS = st.one_of(st.just(0.0), st.just(1 / 60), st.floats(0.0, 1.0))
PLACES = st.tuples(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0))
GROUNDS = st.sampled_from(
    [Plane(), Plane(0.0, (0.0, 0.2)), Terrain((Plane(), Stairs((0.0, 0.0, 1.0), 6)))]
)


@cache
def library() -> MotionLibrary:
    shared = MotionLibrary()
    for name in ONCE_OR_CYCLIC:
        shared.add(name, *sample(name))
    shared.add_locomotion("gait", [sample("walk"), sample("run")])
    return shared


@contextmanager
def busy_allowed() -> Generator[None, None, None]:
    """Let a command be refused because somebody does too much, or something already."""
    try:
        yield
    except ArgumentError as error:
        if not str(error).endswith(("stop one first", "can be chosen only before")):
            raise


class AnyOrderOfACrowd(RuleBasedStateMachine):
    """The commands of a crowd in any order."""

    @initialize(
        size=st.integers(1, 9), paper=st.booleans(), flight=st.sampled_from(["played", "ballistic"])
    )
    def prepare(self, size: int, paper: bool, flight: Any) -> None:
        planner = "paper" if paper else "footfall"
        self.crowd = Crowd(library(), size, planner=planner, flight=flight)

    def memory(self) -> bytes:
        return b"".join(array.tobytes() for array in self.crowd.snapshot().values())

    def ask(self, command: str, *arguments: Any, rows: Any, **options: Any) -> None:
        """Give a command; where it names a row without anybody it is refused, and that is all."""
        there = np.flatnonzero(self.crowd.present)
        if rows is None or set(rows) <= set(there.tolist()):
            with busy_allowed():
                getattr(self.crowd, command)(*arguments, rows=rows, **options)
            return
        before = self.memory()
        with pytest.raises(ArgumentError):
            getattr(self.crowd, command)(*arguments, rows=rows, **options)
        assert self.memory() == before

    @rule(
        action=ACTIONS,
        rows=ROWS,
        patience=st.floats(0.0, 2.0),
        late=st.sampled_from(["give up", "mute"]),
    )
    def start(self, action: int, rows: Any, patience: float, late: str) -> None:
        self.ask("start", action, rows=rows, patience=patience, late=late)

    @rule(action=ACTIONS, rows=ROWS)
    def stop(self, action: int, rows: Any) -> None:
        self.ask("stop", action, rows=rows)

    @rule(action=ACTIONS, rows=ROWS, priority=st.floats(0.1, 5.0), fade=st.floats(0.0, 1.0))
    def set_priority(self, action: int, rows: Any, priority: float, fade: float) -> None:
        self.ask("set_priority", action, priority, rows=rows, fade=fade)

    @rule(speed=st.floats(1.3, 2.5))
    def change_the_speed_of_the_gait(self, speed: float) -> None:
        self.crowd.set_parameters(GAIT, speed=speed)

    @rule(place=PLACES, heading=st.floats(-4.0, 4.0), rows=ROWS)
    def place(self, place: tuple[float, float], heading: float, rows: Any) -> None:
        self.ask("place", place, heading, rows=rows)

    @rule(rows=ROWS, detail=st.sampled_from(["full", "no reaching", "half rate"]))
    def set_detail(self, rows: Any, detail: str) -> None:
        self.ask("set_detail", detail, rows=rows)

    @rule(rows=ROWS, synchronized=st.booleans())
    def set_synchronized(self, rows: Any, synchronized: bool) -> None:
        self.ask("set_synchronized", synchronized, rows=rows)

    @rule(
        rows=ROWS,
        hand=st.sampled_from(["left", "right"]),
        at=PLACES,
        height=st.floats(0.0, 2.0),
        grasp=st.booleans(),
    )
    def reach(
        self, rows: Any, hand: Any, at: tuple[float, float], height: float, grasp: bool
    ) -> None:
        self.ask("reach", hand, (at[0], height, at[1]), rows=rows, grasp=grasp)

    @rule(rows=ROWS, hand=st.sampled_from(["left", "right"]))
    def release(self, rows: Any, hand: Any) -> None:
        self.ask("release", hand, rows=rows)

    @rule(ground=GROUNDS)
    def change_ground(self, ground: Any) -> None:
        self.crowd.ground = ground

    @rule(height=st.floats(-1.0, 1.0))
    def raise_ground(self, height: float) -> None:
        self.crowd.raise_ground(height)

    @rule(count=st.integers(0, 3), place=PLACES)
    def spawn(self, count: int, place: tuple[float, float]) -> None:
        before = self.crowd.present.sum()
        rows = self.crowd.spawn(count, place)
        assert self.crowd.present[rows].all()
        assert self.crowd.present.sum() == before + count

    @rule(rows=st.lists(st.integers(0, 9), max_size=2, unique=True))
    def remove(self, rows: list[int]) -> None:
        self.ask("remove", rows=rows)

    @rule(dt=STEPS)
    def advance(self, dt: float) -> None:
        self.crowd.advance(dt)

    @rule(dt=STEPS)
    def advance_go_back_and_advance_again(self, dt: float) -> None:
        before = self.crowd.snapshot()
        self.crowd.advance(dt)
        first = self.crowd.world_positions.tobytes()
        self.crowd.restore(before)
        self.crowd.advance(dt)
        assert self.crowd.world_positions.tobytes() == first

    @invariant()
    def everybody_is_whole(self) -> None:
        if not hasattr(self, "crowd"):
            return
        there = self.crowd.present
        assert np.isfinite(self.crowd.world_positions[there]).all()
        weights = self.crowd.characters["weights"][there]
        assert (weights >= 0.0).all()
        shown = ~self.crowd.characters["fresh"][there].astype(bool)
        sums = weights.sum(axis=1)[shown]
        np.testing.assert_allclose(sums, np.ones((shown.sum(), len(BodyPart))), atol=1e-9)


AnyOrderOfACrowd.TestCase.settings = settings(
    max_examples=25,
    stateful_step_count=20,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
TestAnyOrderOfACrowd = AnyOrderOfACrowd.TestCase
