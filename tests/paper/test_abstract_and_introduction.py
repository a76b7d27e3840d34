"""What the abstract and section 1 promise, shown on the whole engine."""

from __future__ import annotations

import time

import numpy as np
import pytest
from tests.engine.test_pipeline import CUES, FPS, accelerations, drift, play, walker
from tests.paper.requirements import requirement

import footfall as ff
from footfall.arrays import Floats
from footfall.engine.recording import Recording
from footfall.errors import FootfallError

SECONDS_PER_FRAME = 1.0 / FPS


def scaled(body: ff.Skeleton, factor: float) -> ff.Skeleton:
    """Return the same body, larger or smaller."""
    return ff.Skeleton(body.names, body.parents, body.rest_offsets * factor)


def performer(factor: float) -> ff.Character:
    """Return a body of another size that performs the same two motions."""
    walk, supports = ff.sample("walk")
    hero = ff.Character(scaled(walk.skeleton, factor))
    hero.add("walk", walk, supports)
    hero.add("run", *ff.sample("run"))
    return hero


@requirement(1, "we present a new real-time synchronization algorithm")
def test_a_frame_with_everything_takes_less_than_a_tenth_of_its_time() -> None:
    hero = walker()
    play(hero, CUES, 60)
    begun = time.process_time()
    for _ in range(300):
        hero.advance(SECONDS_PER_FRAME)
    assert (time.process_time() - begun) / 300 < 0.1 * SECONDS_PER_FRAME


@requirement(
    2,
    "This algorithm uses the sequence of support phases of the motions. It also takes into "
    "account the priority associated to each motion.",
)
@requirement(17, "They imply the use of identical morphologies.")
def test_the_schedule_is_the_same_whatever_body_performs() -> None:
    recordings = [play(performer(factor), CUES, 200) for factor in (0.7, 1.0, 1.4)]
    for other in recordings[1:]:
        assert np.array_equal(other.phases, recordings[0].phases, equal_nan=True)
        assert np.array_equal(other.clip_times, recordings[0].clip_times, equal_nan=True)
        assert not np.allclose(other.world_positions, recordings[0].world_positions)


def half_a_cycle_apart(synchronized: bool) -> Recording:
    """Start a walk while another one stands on the other foot."""
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, synchronized=synchronized, footprints=False)
    hero.add("one", walk, supports)
    hero.add("two", *ff.sample("walk-fast"))
    half = round(0.5 * walk.duration * FPS)
    return play(hero, {0: ("start", "one"), half: ("start", "two")}, 240)


@requirement(
    6,
    "if a movement with the left foot on the ground is blended with another with the right foot "
    "on the floor, the resulting motion will not respect any of the support constraints",
)
def test_left_foot_blended_with_right_foot_slides_and_synchronized_it_does_not() -> None:
    slides, holds = drift(half_a_cycle_apart(False)), drift(half_a_cycle_apart(True))
    assert slides > 100.0
    assert holds < 30.0
    assert holds < 0.2 * slides


@requirement(7, "the motions used during the animations are interactively adapted")
@requirement(11, "It also uses priorities defined interactively for each motion.")
def test_priorities_change_while_motions_play_and_nothing_jumps() -> None:
    hero = walker()
    calm = accelerations(play(hero, CUES, 160).world_positions).max()
    shares: list[float] = []
    positions: list[Floats] = []
    for frame in range(160):
        if 20 <= frame < 60:
            hero.set_priority("run", 1.0 + 0.1 * (frame - 20))
        if 90 <= frame < 130:
            hero.set_priority("walk", 1.0 + 0.3 * (frame - 90))
        positions.append(hero.advance(SECONDS_PER_FRAME).world_positions.copy())
        shares.append(hero.state("run").weights[0])
        assert ff.Support.CONFLICT not in hero.schedule.results
    assert shares[0] == pytest.approx(0.5, abs=0.05)
    assert max(shares) > 0.8
    assert accelerations(np.array(positions)).max() < 4.0 * calm


@requirement(9, "we want to animate several characters with different morphologies in real-time")
@requirement(
    24,
    "allows it to be independent from the original morphology and then to be shared between a lot"
    " of characters with different skeletons",
)
@requirement(
    103, "The morphological adaptation is still made automatically with the normalized skeleton."
)
@requirement(
    105, "a motion can be automatically shared by several characters with different morphologies"
)
def test_bodies_of_other_sizes_share_the_motions_and_their_feet_hold() -> None:
    for factor in (0.6, 1.0, 1.5):
        recording = play(performer(factor), CUES, 240)
        assert drift(recording) < 5.0
        pelvis = recording.world_positions[:, 0, 1]
        own = play(performer(1.0), CUES, 240).world_positions[:, 0, 1]
        np.testing.assert_allclose(pelvis, factor * own, rtol=0, atol=0.02 * factor)


@requirement(
    12,
    "the user can activate or deactivate the motions by using the start/stop commands at any time",
)
@requirement(
    104,
    "Its use is very easy since motions are basically controlled by simple start/stop commands.",
)
def test_any_commands_at_any_time_are_obeyed_or_answered() -> None:
    names = ("walk", "run", "side-step", "kick", "hop-right", "hop-left", "jump")
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    for name in names:
        hero.add(name, *ff.sample(name))
    random = np.random.default_rng(4)
    for _ in range(400):
        name = str(random.choice(names))
        if random.random() < 0.5:
            active = sum(hero.is_active(one) for one in names)
            answer = hero.start(name) if active < 5 else None
            assert answer is None or isinstance(answer, ff.Started | ff.Waiting)
            assert not isinstance(answer, ff.Waiting) or answer.reason
        else:
            hero.stop(name)
        shown = hero.advance(float(random.uniform(0.0, 0.3)))
        assert np.isfinite(shown.world_positions).all()
        assert shown.support is not ff.Support.CONFLICT


@requirement(13, "delays the start of a new one if it cannot be immediately synchronized")
def test_a_start_that_does_not_fit_is_delayed_and_then_happens_by_itself() -> None:
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    hero.add("walk", *ff.sample("walk"))
    hero.add("shot", *ff.sample("shot"))
    hero.start("walk")
    hero.advance(0.1)
    assert isinstance(hero.start("shot"), ff.Waiting)
    assert not isinstance(hero.start("shot"), ff.Impossible)
    for _ in range(120):
        hero.advance(SECONDS_PER_FRAME)
    assert not hero.is_waiting("shot")
    assert hero.is_active("shot")


@requirement(14, "our work is already used by industrial partners")
def test_what_cannot_be_meant_is_answered_by_a_sentence_and_changes_nothing() -> None:
    hero, other = walker(), walker()
    for one in (hero, other):
        one.start("walk")
        one.advance(0.3)
    walk, supports = ff.sample("walk")
    wrong = [
        lambda: hero.start("wlak"),
        lambda: hero.stop(""),
        lambda: hero.advance(-1.0),
        lambda: hero.advance(float("nan")),
        lambda: hero.set_priority("walk", -1.0),
        lambda: hero.set_priority("walk", {"tail": 1.0}),
        lambda: hero.start("run", patience=-1.0),
        lambda: hero.add("walk", walk, supports),
        lambda: hero.add("other", walk, ff.SupportSequence.parse("R*")),
        lambda: hero.add("other", walk, ff.SupportSequence.parse("R D L D")),
    ]
    for act in wrong:
        with pytest.raises(FootfallError) as caught:
            act()
        assert str(caught.value)
    assert np.array_equal(hero.advance(0.1).world_positions, other.advance(0.1).world_positions)


@requirement(
    8,
    "They can also be adapted to external constraints specified by the user in realtime (e.g., "
    "height of a chair while sitting).",
)
def test_a_seat_that_the_user_moves_is_sat_on_and_the_feet_stay() -> None:
    idle, supports = ff.sample("idle")
    hero = ff.Character(idle.skeleton)
    hero.add("idle", idle, supports)
    hero.start("idle")
    ankles = [leg.ankle for leg in hero.library.anatomy.legs]
    hips = [leg.hip for leg in hero.library.anatomy.legs]
    before = hero.advance(0.0).world_positions[ankles].copy()
    for height in (0.6, 0.5, 0.7):
        hero.goals.sit(height)
        for _ in range(90):
            hero.advance(SECONDS_PER_FRAME)
        shown = hero.crowd.world_positions[0]
        assert sum(float(shown[hip, 1]) for hip in hips) / 2 == pytest.approx(height, abs=1e-3)
        assert shown[ankles] == pytest.approx(before, abs=2e-3)


@requirement(29, "contact of the hands during applause")
def test_hands_meet_while_a_walk_plays() -> None:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton)
    hero.add("walk", walk, supports)
    hero.start("walk")
    hands = [hero.library.skeleton.index(name) for name in ("LeftHand", "RightHand")]

    def apart() -> float:
        left, right = hero.advance(SECONDS_PER_FRAME).world_positions[hands]
        return float(np.linalg.norm(left - right))

    assert min(apart() for _ in range(60)) > 0.3
    hero.goals.join_hands(0.06)
    joined = [apart() for _ in range(90)][30:]
    assert joined == pytest.approx([0.06] * 60, abs=3e-3)
