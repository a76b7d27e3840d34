"""What the engine's clocks promise, on random supports and any commands at any time.

The body stands still whatever the supports say: only the clocks are looked at.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import footfall as ff
from footfall.engine.state import EMPTY, RUNNING
from footfall.support import Support, SupportPhase, SupportSequence
from footfall.sync.columns import has_ended
from footfall.sync.prices import GREATEST_RATE, LEAST_RATE
from footfall.timing import warp

FRAME = 0.05
"""Between two frames of the clips [s]."""

COMMANDS = ("start", "start", "stop", "raise", "wait")
CLOSE = 1e-9

LAST_MOMENT = 5e-3
"""A command that comes when so little is left of a slot may find no length that suits all [s]."""

Command = tuple[str, int, float]


@st.composite
def sequences(draw: st.DrawFn) -> SupportSequence:
    """Draw a strict sequence of two feet whose phases last whole frames, 0.05 to 1.2 s."""
    elements = [Support.FLIGHT, Support.LEFT, Support.RIGHT, Support.DOUBLE]
    phases: list[SupportPhase] = []
    for _ in range(draw(st.integers(1, 6))):
        left = [one for one in elements if not phases or one is not phases[-1].support]
        lasting = FRAME * draw(st.integers(1, 24))
        phases.append(SupportPhase(draw(st.sampled_from(left)), lasting))
    ends_differ = len(phases) > 1 and phases[0].support is not phases[-1].support
    return SupportSequence(tuple(phases), ends_differ and draw(st.booleans()))


@st.composite
def performances(draw: st.DrawFn) -> tuple[list[SupportSequence], list[Command]]:
    """Draw the supports of 2 to 8 actions, and commands with the time that passes after each."""
    chosen = draw(st.lists(sequences(), min_size=2, max_size=8))
    command = st.tuples(
        st.sampled_from(COMMANDS), st.integers(0, len(chosen) - 1), st.floats(0.0, 0.4)
    )
    return chosen, draw(st.lists(command, min_size=8, max_size=30))


def standing(supports: SupportSequence) -> ff.Clip:
    """Return a clip of a body that stands still for as long as some supports last."""
    idle, _ = ff.sample("idle")
    frames = round(supports.duration / FRAME) + 1
    return ff.Clip(
        idle.skeleton,
        np.repeat(idle.pelvis_positions[:1], frames, axis=0),
        np.repeat(idle.local_rotations[:1], frames, axis=0),
        1.0 / FRAME,
        cyclic=supports.cyclic,
    )


def performer(chosen: list[SupportSequence]) -> ff.Character:
    hero = ff.Character(ff.sample("idle")[0].skeleton, footprints=False)
    for number, supports in enumerate(chosen):
        hero.add(str(number), standing(supports), supports, priority=float(len(chosen) - number))
    return hero


def clocks(me: Any) -> dict[tuple[int, int], tuple[float, float, bool]]:
    """Return clip time and rate of each running action, and whether the warp drives it."""
    return {
        (int(me["age"][seat]), seat): (
            float(me["clip_time"][seat]),
            float(me["rate"][seat]),
            bool(me["playing"][seat] and not me["muted"][seat]),
        )
        for seat in np.flatnonzero(me["status"] >= RUNNING).tolist()
    }


def weights_rest(me: Any) -> bool:
    """Whether no weight of the legs is moving: while one is, warps are built anew all the time."""
    running = me["status"] >= RUNNING
    fades = me["fade_progress"][running] >= 1.0
    muting = me["presence"][running] != 1 - me["muted"][running]
    return bool(fades.all() and not muting.any() and not me["changing"])


def check_state(hero: ff.Character) -> None:
    """Check that the slot can be played, and that each clip is on a warp within its bounds."""
    crowd = hero.crowd
    me = crowd.characters[0]
    assert int(me["support"]) != Support.CONFLICT
    assert Support.CONFLICT not in hero.schedule.results
    for (_, seat), (clip_time, rate, warped) in clocks(me).items():
        assert np.isfinite(clip_time)
        assert 0.0 <= rate < np.inf
        ended = has_ended(crowd.shelf.table, int(me["action"][seat]), int(me["phases"][seat, 0]))
        if not warped or ended:
            continue
        (t0, t1), (h0, v0, v1) = me["span"].tolist(), me["segment"][seat].tolist()
        h1 = float(me["target"][seat])
        assert h1 >= h0
        if t1 > t0:
            here = warp(float(me["clock"]), t0, h0, v0, t1, h1, v1, False)
            assert here == pytest.approx((clip_time, rate), abs=CLOSE)
        lasting = float(me["slot_duration"])
        if (1.0 - float(me["slot_progress"])) * lasting > LAST_MOMENT:
            asked = float(me["natural"][seat]) / lasting
            assert LEAST_RATE - 1e-6 <= asked <= GREATEST_RATE + 1e-6


def pass_time(hero: ff.Character, dt: float) -> None:
    """Let time pass, and check that no clip goes back or changes its speed with a jump."""
    me = hero.crowd.characters[0]
    while dt > 0.0:
        left = (1.0 - float(me["slot_progress"])) * float(me["slot_duration"])
        step = min(dt, 1 / 60, left if left > 1e-6 else dt)
        before, clock, slot = clocks(me), float(me["clock"]), int(me["slot_index"])
        end, rest = float(me["span"][1]), weights_rest(me)
        ends = np.stack([me["target"], me["segment"][:, 2]], axis=1)
        hero.advance(step)
        check_state(hero)
        for key, (clip_time, rate, warped) in clocks(me).items():
            if key not in before:
                continue
            was_time, was_rate, was_warped = before[key]
            assert clip_time >= was_time - CLOSE
            if not (warped and was_warped):
                continue
            seat = key[1]
            t0, h0, v0 = float(me["span"][0]), *me["segment"][seat, :2].tolist()
            if abs(t0 - clock) < CLOSE and int(me["slot_index"]) == slot:
                # Built anew: from where the clip was, with the speed that it had.
                assert (h0, v0) == pytest.approx((was_time, was_rate), abs=CLOSE)
            t1, h1, v1 = end, *ends[seat].tolist()
            table, phase = hero.crowd.shelf.table, int(me["phases"][seat, 0])
            over = has_ended(table, int(me["action"][seat]), phase)
            entered = int(me["slot_index"]) == slot + 1
            if abs(t1 - float(me["clock"])) < CLOSE and entered and rest and not over:
                # The slot has ended as it was to end, and the next one goes on from there; a clip
                # that is over stays on its last frame.
                # The clock is then up to a nanosecond later, in which a speed changes by as much.
                assert (clip_time, rate) == pytest.approx((h1, v1), abs=1e-7)
        dt -= step


def perform(chosen: list[SupportSequence], commands: list[Command]) -> None:
    hero = performer(chosen)
    me = hero.crowd.characters[0]
    for number, (command, action, dt) in enumerate(commands):
        before = clocks(me)
        name = str(action)
        if command == "start" and (me["status"] == EMPTY).any():
            answer = hero.start(name)
            if isinstance(answer, ff.Waiting):
                assert answer.reason.startswith(("waits for", "impossible beside"))
                assert answer.until is None or answer.until > float(me["clock"])
            else:
                assert hero.state(name).activity in ("running", "fading in")
        elif command == "stop":
            hero.stop(name)
        elif command == "raise":
            hero.set_priority(name, 1.0 + number)
        hero.advance(0.0)
        check_state(hero)
        after = clocks(me)
        for key, (clip_time, rate, _) in after.items():
            if key in before:
                assert (clip_time, rate) == pytest.approx(before[key][:2], abs=CLOSE)
        pass_time(hero, dt)


@settings(deadline=None, max_examples=60)
@given(performances())
def test_time_never_goes_back_nor_jumps_in_speed_and_starts_are_explained(
    drawn: tuple[list[SupportSequence], list[Command]],
) -> None:
    perform(*drawn)


@pytest.mark.full
@settings(deadline=None, max_examples=2000)
@given(performances())
def test_nor_in_thousands_of_performances(
    drawn: tuple[list[SupportSequence], list[Command]],
) -> None:
    perform(*drawn)
