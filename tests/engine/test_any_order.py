"""Whatever is asked of a character, in whatever order: it stays whole, or says what is wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule
from tests.actions.test_motion_source import Replay, as_it_is, crash, nowhere, replay

from footfall.adaptation import Plane, Stairs, Terrain
from footfall.engine import Character, Started, Waiting
from footfall.engine.record import SEATS
from footfall.engine.state import EMPTY
from footfall.errors import ArgumentError, ClipError, FileFormatError, SourceError, UnknownNameError
from footfall.io import load as load_file
from footfall.io import load_supports
from footfall.io.native import save_native
from footfall.samples import sample, sample_names
from footfall.skeleton import BodyPart, find_anatomy, leg_length

NAMES = st.sampled_from(sample_names())
STEPS = st.one_of(st.just(0.0), st.just(1 / 60), st.floats(0.0, 1.0))
PRIORITIES = st.one_of(
    st.floats(0.1, 10.0),
    st.fixed_dictionaries({"legs": st.floats(0.0, 5.0), "arms": st.floats(0.1, 5.0)}),
)
GROUNDS = st.sampled_from(
    [
        Plane(),
        Plane(0.3),
        Plane(0.0, (0.0, 0.2)),
        Terrain((Plane(), Stairs((0.0, 0.0, 1.0), 6))),
    ]
)


class AnyOrder(RuleBasedStateMachine):
    """The commands of a character in any order."""

    def __init__(self) -> None:
        super().__init__()
        self.known: list[str] = []
        self.sources: dict[str, Replay] = {}
        self.folder = TemporaryDirectory()
        self.clock = 0.0
        self.kept: tuple[dict[str, Any], float, int] | None = None

    def teardown(self) -> None:
        self.folder.cleanup()

    @initialize(synchronized=st.sampled_from([True, True, True, False]), paper=st.booleans())
    def prepare(self, synchronized: bool, paper: bool) -> None:
        body = sample("walk")[0].skeleton
        self.hero = Character(
            body, synchronized=synchronized, planner="paper" if paper else "footfall"
        )
        self.legs = find_anatomy(body).legs
        self.reach = [leg_length(body, leg) for leg in self.legs]

    @rule(name=NAMES, priority=PRIORITIES, fade=st.floats(0.0, 1.0))
    def add(self, name: str, priority: Any, fade: float) -> None:
        options: dict[str, Any] = {"priority": priority, "fade_in": fade, "fade_out": fade}
        if name in self.known:
            with pytest.raises(ArgumentError, match="names must differ"):
                self.hero.add(name, *sample(name), **options)
            return
        self.hero.add(name, *sample(name), **options)
        self.known.append(name)

    @rule(name=NAMES, cut=st.sampled_from([None, None, 10, 1000]))
    def load(self, name: str, cut: int | None) -> None:
        """Add what a file says, as `name`; of a file that is cut off, nothing."""
        path = Path(self.folder.name) / "motion.npz"
        clip, supports = sample(name)
        save_native(clip, path, supports=supports)
        if cut is not None:
            path.write_bytes(path.read_bytes()[:cut])
            with pytest.raises(FileFormatError):
                load_file(path)
        elif name not in self.known:
            self.hero.add(name, load_file(path), load_supports(path))
            self.known.append(name)

    @rule(name=NAMES, broken=st.sampled_from([as_it_is, crash, nowhere]))
    def add_source(self, name: str, broken: Callable[[Any], Any]) -> None:
        if name in self.known:
            return
        source = replay(name, broken=broken)
        if broken is as_it_is:
            self.hero.add_source(name, source)
            self.known.append(name)
            self.sources[name] = source
            return
        with pytest.raises((SourceError, ClipError), match=repr(name)):
            self.hero.add_source(name, source)

    @precondition(lambda self: self.sources)
    @rule(data=st.data(), broken=st.sampled_from([as_it_is, crash, nowhere]))
    def ask_a_source_again(self, data: st.DataObject, broken: Callable[[Any], Any]) -> None:
        name = data.draw(st.sampled_from(sorted(self.sources)))
        self.sources[name].broken = broken
        if broken is as_it_is:
            self.hero.library.resample(name)
            return
        with pytest.raises((SourceError, ClipError), match=repr(name)):
            self.hero.library.resample(name)

    @rule(name=NAMES)
    def start(self, name: str) -> None:
        if name not in self.known:
            with pytest.raises(UnknownNameError):
                self.hero.start(name)
            return
        taken = int((self.hero.crowd.characters[0]["status"] != EMPTY).sum())
        if taken == SEATS and not self.hero.is_active(name):
            with pytest.raises(ArgumentError, match="stop one first"):
                self.hero.start(name)
            return
        answer = self.hero.start(name)
        clock = float(self.hero.crowd.characters[0]["clock"])
        assert isinstance(answer, Started | Waiting)
        if isinstance(answer, Started):
            assert answer.at == clock
        else:
            assert answer.reason
            assert self.hero.is_waiting(name)
            assert answer.until is None or answer.until >= clock - 1e-6
        assert self.hero.is_active(name)

    @precondition(lambda self: self.known)
    @rule(data=st.data())
    def stop(self, data: st.DataObject) -> None:
        name = data.draw(st.sampled_from(self.known))
        waiting = self.hero.is_waiting(name)
        self.hero.stop(name)
        assert not (waiting and self.hero.is_active(name))

    @precondition(lambda self: self.known)
    @rule(data=st.data(), priority=PRIORITIES)
    def set_priority(self, data: st.DataObject, priority: Any) -> None:
        self.hero.set_priority(data.draw(st.sampled_from(self.known)), priority)

    @precondition(lambda self: self.known)
    @rule(ground=GROUNDS)
    def change_ground(self, ground: Any) -> None:
        self.hero.crowd.ground = ground

    @precondition(lambda self: self.known)
    @rule(x=st.floats(-9.0, 9.0), z=st.floats(-9.0, 9.0), heading=st.floats(-4.0, 4.0))
    def place(self, x: float, z: float, heading: float) -> None:
        self.hero.place(x, z, heading)

    @precondition(lambda self: self.known)
    @rule(dt=STEPS)
    def advance(self, dt: float) -> None:
        frame = self.hero.advance(dt)
        self.clock += dt
        assert abs(frame.clock - self.clock) < 1e-6 * (1.0 + self.clock)
        assert np.isfinite(frame.world_positions).all()
        norms = np.linalg.norm(frame.world_rotations, axis=-1)
        np.testing.assert_allclose(norms, 1.0, atol=1e-6)
        for leg, reach in zip(self.legs, self.reach, strict=True):
            apart = frame.world_positions[leg.hip] - frame.world_positions[leg.ankle]
            assert np.linalg.norm(apart) <= reach * (1.0 + 1e-6)
        weights = self.hero.crowd.characters[0]["weights"]
        assert (weights >= 0.0).all()
        np.testing.assert_allclose(weights.sum(axis=0), np.ones(len(BodyPart)), atol=1e-9)

    @precondition(lambda self: self.known)
    @rule(dt=STEPS)
    def advance_go_back_and_advance_again(self, dt: float) -> None:
        before = self.hero.crowd.snapshot()
        first = self.hero.advance(dt).world_positions.tobytes()
        self.hero.crowd.restore(before)
        assert self.hero.advance(dt).world_positions.tobytes() == first
        self.clock += dt

    @precondition(lambda self: self.known)
    @rule()
    def keep_what_is_remembered(self) -> None:
        self.kept = (self.hero.crowd.snapshot(), self.clock, len(self.known))

    @precondition(lambda self: self.kept is not None)
    @rule()
    def go_back_to_what_was_kept(self) -> None:
        assert self.kept is not None
        remembered, clock, actions = self.kept
        if actions == len(self.known):
            self.hero.crowd.restore(remembered)
            self.clock = clock

    @precondition(lambda self: self.known)
    @rule(dt=st.sampled_from([-1e-9, -1.0, float("nan"), float("inf")]))
    def advance_by_what_is_no_time(self, dt: float) -> None:
        before = self.hero.crowd.characters.tobytes()
        with pytest.raises(ArgumentError) as caught:
            self.hero.advance(dt)
        assert str(caught.value) == f"dt is {dt} s; it must be finite and >= 0"
        assert self.hero.crowd.characters.tobytes() == before

    @invariant()
    def nobody_has_more_than_the_seats(self) -> None:
        if self.known:
            active = [name for name in self.known if self.hero.is_active(name)]
            assert len(active) <= SEATS
            assert str(self.hero.schedule)
            for name in self.known:
                assert self.hero.state(name) is not None


AnyOrder.TestCase.settings = settings(
    max_examples=40,
    stateful_step_count=25,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.filter_too_much],
)
TestAnyOrder = AnyOrder.TestCase
