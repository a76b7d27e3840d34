from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from footfall.timing import advance_progress, level, reverse_fade, smoothstep

Steps = list[tuple[float, bool]]

asked_times = st.floats(0.01, 5.0)
steps_of_time = st.lists(st.tuples(st.floats(0.0, 1.0), st.booleans()), max_size=60)
shares = st.floats(0.0, 1.0)


def fade(asked: float, steps: Steps) -> list[tuple[float, float]]:
    """Return elapsed time and progress after each step, the start included."""
    elapsed, progress = 0.0, 0.0
    path = [(elapsed, progress)]
    for dt, may_move in steps:
        progress = advance_progress(progress, elapsed, asked, dt, may_move)
        elapsed += dt
        path.append((elapsed, progress))
    return path


@pytest.mark.parametrize(
    ("x", "y"), [(-1.0, 0.0), (0.0, 0.0), (0.25, 0.15625), (0.5, 0.5), (1.0, 1.0), (9.0, 1.0)]
)
def test_a_smooth_step_by_hand(x: float, y: float) -> None:
    assert smoothstep(x) == y


@settings(deadline=None)
@given(st.floats(-0.5, 1.5))
def test_a_fade_out_mirrors_a_fade_in(progress: float) -> None:
    assert level(1.0 - progress) == pytest.approx(1.0 - level(progress), abs=1e-15)


@settings(deadline=None)
@given(st.floats(-0.5, 1.5), st.floats(0.0, 0.5))
def test_the_level_never_falls_while_the_progress_rises(progress: float, more: float) -> None:
    assert 0.0 <= level(progress) <= level(progress + more) + 1e-15 <= 1.0 + 1e-15


@pytest.mark.parametrize("frames", [1, 7, 60, 1000])
def test_a_fade_that_never_waits_lasts_as_long_as_asked(frames: int) -> None:
    path = fade(1.0, [(1.0 / frames, True)] * frames)
    assert path[-1][1] == 1.0
    assert path[-2][1] < 1.0
    assert path[frames // 2][1] == pytest.approx(path[frames // 2][0])


@pytest.mark.parametrize("frames", [1, 7, 60, 1000])
def test_a_fade_that_may_never_move_is_complete_at_twice_the_time_asked(frames: int) -> None:
    path = fade(0.5, [(1.0 / frames, False)] * frames)
    assert path[-1][1] == 1.0
    assert path[-2][1] < 1.0
    assert path[frames // 2][1] == pytest.approx(0.0, abs=1e-12)


def test_waiting_for_less_than_the_time_asked_delays_by_just_that() -> None:
    path = fade(1.0, [(0.25, True), (0.75, False), (0.5, True), (0.25, True)])
    assert [progress for _, progress in path] == [0.0, 0.25, 0.25, 0.75, 1.0]


def test_a_step_that_runs_out_of_patience_waits_first_and_then_runs() -> None:
    assert advance_progress(0.25, 0.25, 1.0, 1.5, False) == 0.75


@pytest.mark.parametrize("may_move", [True, False])
@pytest.mark.parametrize("dt", [0.0, 0.1])
def test_a_fade_of_no_length_is_over_at_once(dt: float, may_move: bool) -> None:
    assert advance_progress(0.0, 0.0, 0.0, dt, may_move) == 1.0


def test_a_fade_that_is_already_late_catches_up() -> None:
    assert advance_progress(0.5, 1.75, 1.0, 0.125, False) == 0.75
    assert advance_progress(0.5, 1.75, 1.0, 0.125, True) == 0.75
    assert advance_progress(0.5, 2.5, 1.0, 0.125, False) == 1.0


@settings(deadline=None, max_examples=300)
@given(asked_times, steps_of_time)
@example(1.0, [(0.5, False)] * 4)
@example(0.3, [(1.0 / 60.0, False)] * 36)
def test_every_fade_lasts_between_the_time_asked_and_twice_that(asked: float, steps: Steps) -> None:
    path = fade(asked, steps)
    for (_, before), (elapsed, progress) in pairwise(path):
        assert before <= progress <= 1.0
        if progress == 1.0:
            assert elapsed >= asked * (1.0 - 1e-12)
        if elapsed >= 2.0 * asked * (1.0 + 1e-12):
            assert progress == 1.0


@settings(deadline=None, max_examples=300)
@given(asked_times, shares, shares, st.floats(0.0, 3.0), shares, st.booleans())
def test_cutting_a_step_in_two_changes_nothing(
    asked: float, progress: float, waited: float, dt: float, cut: float, may_move: bool
) -> None:
    elapsed = asked * (progress + waited)
    whole = advance_progress(progress, elapsed, asked, dt, may_move)
    half = advance_progress(progress, elapsed, asked, cut * dt, may_move)
    both = advance_progress(half, elapsed + cut * dt, asked, (1.0 - cut) * dt, may_move)
    assert both == pytest.approx(whole, abs=1e-12)


def test_the_rounding_of_sixty_frames_does_not_cost_a_frame() -> None:
    for frames in range(1, 200):
        assert fade(1.0, [(1.0 / frames, True)] * frames)[-1][1] == 1.0


@settings(deadline=None)
@given(shares, asked_times)
def test_turning_back_does_not_make_the_level_jump(progress: float, asked: float) -> None:
    begun, _ = reverse_fade(progress, asked)
    assert 1.0 - level(begun) == pytest.approx(level(progress), abs=1e-15)


@pytest.mark.parametrize(("may_move", "share"), [(True, 1.0), (False, 2.0)])
def test_turning_back_takes_its_share_of_the_time_or_twice_that(
    may_move: bool, share: float
) -> None:
    progress, elapsed = reverse_fade(0.25, 2.0)
    assert (progress, elapsed) == (0.75, 3.0)
    rest = share * 0.25 * 2.0
    almost = advance_progress(progress, elapsed, 2.0, rest - 1e-6, may_move)
    assert almost < 1.0
    assert advance_progress(progress, elapsed, 2.0, rest, may_move) == 1.0


@pytest.mark.parametrize("asked", [0.0, 5e-324, 1e-300, 9e-10])
@pytest.mark.parametrize("dt", [0.0, 1.0 / 60.0])
def test_a_fade_of_next_to_no_length_is_over_at_once(asked: float, dt: float) -> None:
    assert advance_progress(0.0, 0.0, asked, dt, 1.0) == 1.0
    assert advance_progress(0.0, 0.0, asked, dt, 0.0) == 1.0


def test_a_fade_of_a_nanosecond_still_takes_its_time() -> None:
    assert advance_progress(0.0, 0.0, 1e-9, 0.0, 1.0) == 0.0
    assert advance_progress(0.0, 0.0, 1e-9, 0.5e-9, 1.0) == pytest.approx(0.5)
