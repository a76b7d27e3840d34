"""What feet do while motions come and go, on motions with exactly known supports."""

from __future__ import annotations

import numpy as np
import pytest
from tests.engine.test_pipeline import FPS, play

import footfall as ff
from footfall.arrays import Floats
from footfall.engine.recording import Recording
from footfall.skeleton import find_anatomy
from footfall.support import Support


def ankles(recording: Recording) -> Floats:
    """Return the ankles on the ground, x and z, shape (frames, feet, 2)."""
    joints = [leg.ankle for leg in find_anatomy(recording.skeleton).legs]
    return recording.world_positions[:, joints][..., [0, 2]]


def kicker() -> ff.Character:
    kick, supports = ff.sample("kick")
    hero = ff.Character(kick.skeleton)
    hero.add("kick", kick, supports)
    return hero


def test_a_body_whose_motion_is_over_stands_where_its_feet_are() -> None:
    clip, _ = ff.sample("kick")
    over = int(clip.duration * FPS)
    recording = play(kicker(), {0: ("start", "kick")}, over + 120)
    stands = ankles(recording)[over - 1 :]
    assert recording.supports[-1] == Support.DOUBLE
    assert recording.shares[-1, 0] == 0.0
    # Its feet may still turn a little, about their heels.
    assert np.abs(stands - stands[0]).max() < 0.01
    assert recording.foot_offsets[-1].max() < 0.002


def test_a_body_that_does_nothing_does_not_move() -> None:
    recording = play(kicker(), {}, 60)
    assert np.abs(np.diff(recording.world_positions, axis=0)).max() < 1e-9


def test_who_stops_in_the_middle_of_a_long_stride_stands_on_both_feet() -> None:
    library = ff.MotionLibrary()
    library.add("walk-fast", *ff.sample("walk-fast"), fade_out=0.02)
    library.add("kick", *ff.sample("kick"))
    crowd = ff.Crowd(library, 41)
    crowd.start(0, range(1, 41), ahead=[0.03 * row for row in range(40)])
    for _ in range(30):
        crowd.advance(1 / FPS)
    crowd.stop(0)
    for _ in range(4 * int(FPS)):
        crowd.advance(1 / FPS)
    assert not crowd.characters["occupied"].any()
    ankles = crowd.world_positions[:, crowd.rig.limbs[:, 2]]
    strides = np.linalg.norm(ankles[:, 0] - ankles[:, 1], axis=1)
    assert strides.max() > 0.7
    assert np.abs(ankles[1:, :, 1] - ankles[0, :, 1]).max() < 0.003


def weights(recording: Recording) -> Floats:
    return recording.shares[:, 1]


@pytest.fixture(scope="module")
def faded() -> Recording:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton)
    hero.add("walk", walk, supports)
    hero.add("walk-fast", *ff.sample("walk-fast"), fade_in=0.6)
    return play(hero, {0: ("start", "walk"), 95: ("start", "walk-fast")}, 240)


def test_leg_weights_move_only_while_one_foot_carries(faded: Recording) -> None:
    moved = np.abs(np.diff(weights(faded))) > 1e-9
    single = (faded.supports == Support.LEFT) | (faded.supports == Support.RIGHT)
    assert moved.sum() > 20
    # A step of the clock may begin in one support and end in the next.
    assert (single[1:] | single[:-1])[moved].all()


def test_leg_weights_come_to_rest_before_both_feet_carry(faded: Recording) -> None:
    # 0.6 s of fade at full speed: a jerk would be a step of the speed, which is at most 2.5 /s.
    accelerations = np.abs(np.diff(weights(faded), n=2)) * FPS**2
    assert accelerations.max() < 50.0


def test_a_fade_lasts_at_most_twice_the_time_asked(faded: Recording) -> None:
    share = weights(faded)
    begins, ends = int(np.argmax(share > 0.0)), int(np.argmax(share >= share.max()))
    assert (ends - begins) / FPS + 2.0 / FPS >= 0.6
    assert (ends - begins) / FPS <= 1.2 + 2.0 / FPS


def test_joints_may_come_in_any_order() -> None:
    walk, supports = ff.sample("walk")
    run, run_supports = ff.sample("run")
    names = run.skeleton.names
    legs = [name for name in names if "Leg" in name or "Foot" in name or "Toe" in name]
    others = [name for name in names[1:] if name not in legs]
    other = run.ordered_like(_in_order(run.skeleton, (names[0], *legs, *others)))
    assert other.skeleton.names != names

    def mixed(clip: ff.Clip) -> Floats:
        hero = ff.Character(walk.skeleton)
        hero.add("walk", walk, supports)
        hero.add("run", clip, run_supports)
        return play(hero, {0: ("start", "walk"), 40: ("start", "run")}, 100).world_positions

    assert np.array_equal(mixed(run), mixed(other))


def _in_order(skeleton: ff.Skeleton, names: tuple[str, ...]) -> ff.Skeleton:
    order = [skeleton.index(name) for name in names]
    above: list[int] = [int(skeleton.parents[old]) for old in order]
    parents = [order.index(parent) if parent >= 0 else -1 for parent in above]
    return ff.Skeleton(names, np.array(parents), skeleton.rest_offsets[order])
