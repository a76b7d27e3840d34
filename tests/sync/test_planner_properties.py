"""What the default planner promises, on random sequences, commands and limbs."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.support import Support, SupportPhase, SupportSequence
from footfall.sync.columns import has_ended, own_phase
from footfall.sync.events import enter_next_slot, reconsider, release_action, start_action
from footfall.sync.planner import REFUSED
from footfall.sync.prices import GREATEST_RATE, LEAST_RATE
from footfall.sync.refusal import foresee
from footfall.sync.shares import natural_duration, spend_slot
from footfall.sync.tables import MOST_HELD, SequenceTable, rules_of
from footfall.sync.window import Window

RULES = rules_of("footfall")
COMMANDS = ("start", "stop", "raise", "wait")


@st.composite
def sequences(draw: st.DrawFn, limbs: int) -> SupportSequence:
    """Draw a strict sequence of a body with so many limbs, phases of 0.05 to 1.5 s."""
    sets = st.sets(st.integers(0, limbs - 1)).map(Support.from_limbs)
    phases: list[SupportPhase] = []
    for _ in range(draw(st.integers(1, 7))):
        support = draw(sets.filter(lambda s: not phases or s is not phases[-1].support))
        phases.append(SupportPhase(support, draw(st.floats(0.05, 1.5))))
    ends_differ = len(phases) > 1 and phases[0].support is not phases[-1].support
    return SupportSequence(tuple(phases), ends_differ and draw(st.booleans()))


@st.composite
def plays(draw: st.DrawFn) -> tuple[list[SupportSequence], list[tuple[str, int]]]:
    """Draw the sequences of 2 to 8 actions, and a command a slot."""
    limbs = draw(st.integers(2, 6))
    chosen = draw(st.lists(sequences(limbs), min_size=2, max_size=8))
    actions = st.integers(0, len(chosen) - 1)
    commands: list[tuple[str, int]] = draw(
        st.lists(st.tuples(st.sampled_from(COMMANDS), actions), min_size=10, max_size=40)
    )
    return chosen, commands


def check_window(table: SequenceTable, window: Window) -> None:
    """Check that every decided column can be played, goes on, and holds nobody too long."""
    seats = [int(seat) for seat in window.playing.nonzero()[0]]
    for column in range(len(window.results)):
        grounded = table.whole
        for seat in seats:
            index = own_phase(table, seat, int(window.phases[seat, column]), RULES.ended)
            support = int(table.supports[table.first[seat] + index]) if index >= 0 else 0
            if support and not window.muted[seat]:
                grounded &= support
        assert window.results[column] != Support.CONFLICT
        if column == 0:
            assert grounded != Support.CONFLICT, "a conflict is hidden below a flight"
    going = [s for s in seats if not has_ended(table, s, int(window.phases[s, 0]))]
    free = [s for s in going if not window.muted[s]]
    assert free or not going, "nobody goes on"
    assert (window.held[free] <= MOST_HELD).all()
    for seat in free:
        assert LEAST_RATE - 1e-9 <= window.pace[seat, 0] <= GREATEST_RATE + 1e-9
    if going:
        assert any(window.phases[s, 1] != window.phases[s, 0] for s in free)
        assert window.durations[0] > 0.0


def play(chosen: list[SupportSequence], commands: list[tuple[str, int]]) -> None:
    """Give one command a slot and check the schedule after each."""
    table = SequenceTable.of(chosen)
    window = Window.empty(len(chosen), 5)
    window.sequence[:] = window.age[:] = range(len(chosen))
    window.priority[:] = window.weight[:] = range(len(chosen), 0, -1)
    names = [str(i) for i in range(len(chosen))]
    for number, (command, action) in enumerate(commands):
        if command == "start" and not window.playing[action]:
            window.age[action] = number
            if start_action(table, window, RULES, action, 0.0) == REFUSED:
                refusal = foresee(table, window, RULES, action, names)
                assert refusal is not None
                assert refusal.reason.startswith(("waits for", "impossible beside"))
        elif command == "stop" and window.playing[action]:
            release_action(table, window, RULES, action)
        elif command == "raise" and window.playing[action]:
            window.priority[action] = window.weight[action] = number
            reconsider(table, window, RULES)
        check_window(table, window)
        before = window.phases[:, 0].copy()
        free = ~window.muted
        spend_slot(table, window)
        enter_next_slot(table, window, RULES)
        for seat in range(len(chosen)):
            if window.playing[seat]:
                phase = int(window.phases[seat, 0])
                assert phase >= before[seat]
                assert phase <= before[seat] + 1 or not free[seat]
                if has_ended(table, seat, phase):
                    release_action(table, window, RULES, seat)
                else:
                    own = natural_duration(table, seat, phase)
                    assert 0.0 < window.remaining[seat] <= own + 1e-9
        check_window(table, window)


@settings(deadline=None, max_examples=200)
@given(plays())
def test_nothing_fails_starves_or_rushes(
    drawn: tuple[list[SupportSequence], list[tuple[str, int]]],
) -> None:
    play(*drawn)


@pytest.mark.full
@settings(deadline=None, max_examples=4000)
@given(plays())
def test_nor_in_thousands_of_plays(
    drawn: tuple[list[SupportSequence], list[tuple[str, int]]],
) -> None:
    play(*drawn)
