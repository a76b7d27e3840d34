from __future__ import annotations

from functools import cache
from itertools import pairwise, product

import numpy as np
import pytest

from footfall.arrays import Flags, Floats, Positions, Rotations
from footfall.errors import ArgumentError, UnknownNameError
from footfall.geometry import conjugate, from_yaw, multiply, rotate
from footfall.motion import Clip
from footfall.samples import sample, sample_names
from footfall.samples.body import BALL_HEIGHT, HEEL_FROM_ANKLE, SHANK, THIGH
from footfall.support import Support, SupportSequence

NAMES = (
    "walk",
    "walk-slow",
    "walk-fast",
    "walk-backward",
    "run",
    "hop-right",
    "hop-left",
    "side-step",
    "idle",
    "walk-left",
    "walk-right",
    "run-left",
    "run-right",
    "kick",
    "punch",
    "jump",
    "shot",
    "walk-to-hop",
)
CYCLIC = NAMES[:13]
CURVES = NAMES[9:13]
FLYING = ("run", "run-left", "run-right", "hop-right", "hop-left", "jump", "shot", "walk-to-hop")
RATES = (30.0, 120.0)
SIDES = ("Left", "Right")

LETTERS = {
    "walk": "R D L D*",
    "walk-slow": "R D L D*",
    "walk-fast": "R D L D*",
    "walk-backward": "R D L D*",
    "run": "R - L -*",
    "hop-right": "R -*",
    "hop-left": "L -*",
    "side-step": "R D L D*",
    "idle": "D*",
    "walk-left": "R D L D*",
    "walk-right": "R D L D*",
    "run-left": "R - L -*",
    "run-right": "R - L -*",
    "kick": "D L D",
    "punch": "D",
    "jump": "D - D",
    "shot": "L D R - L D R D",
    "walk-to-hop": "R D L D R - R - R D",
}

every = pytest.mark.parametrize(("name", "fps"), list(product(NAMES, RATES)))


def turn_rate(name: str) -> float:
    """How fast a sample turns to the left [rad/s]."""
    return (0.65 if name.endswith("left") else -0.65) if name in CURVES else 0.0


def letters(sequence: SupportSequence) -> str:
    text = " ".join(phase.support.symbol for phase in sequence.phases)
    return text + ("*" if sequence.cyclic else "")


@cache
def world(clip: Clip) -> tuple[Rotations, Positions]:
    return clip.world_poses()


def joint(clip: Clip, name: str) -> Positions:
    return world(clip)[1][:, clip.skeleton.index(name)]


def heel(clip: Clip, side: str) -> Positions:
    rotations, positions = world(clip)
    ankle = clip.skeleton.index(f"{side}Foot")
    return positions[:, ankle] + rotate(rotations[:, ankle], np.array(HEEL_FROM_ANKLE))


def carried(clip: Clip, supports: SupportSequence, side: str) -> Flags:
    """Whether the foot is on the ground in each frame, both boundaries included."""
    bounds = supports.boundaries
    times = np.arange(clip.frames) / clip.fps
    flags = np.zeros(clip.frames, dtype=np.bool_)
    for phase, begin, end in zip(supports.phases, bounds, bounds[1:], strict=False):
        stands = phase.support.left if side == "Left" else phase.support.right
        if stands:
            flags |= (times >= begin - 1e-9) & (times <= end + 1e-9)
    return flags


def resting(point: Positions, height: float) -> tuple[Floats, Flags]:
    """How far a point of the foot moves from frame to frame, and whether it lies on the ground."""
    down = np.abs(point[:, 1] - height) < 1e-4
    return np.linalg.norm(np.diff(point, axis=0), axis=-1), down[:-1] & down[1:]


def turning(clip: Clip) -> Floats:
    """Angular velocities of the joints [rad/s], shape (frames - 1, joints, 3)."""
    turns = multiply(conjugate(clip.local_rotations[:-1]), clip.local_rotations[1:])
    return 2.0 * clip.fps * turns[..., 1:] * np.sign(turns[..., :1])


def test_all_promised_samples_are_there_and_no_other() -> None:
    assert sorted(sample_names()) == sorted(NAMES)


def test_an_unknown_name_lists_the_known_ones() -> None:
    with pytest.raises(UnknownNameError) as caught:
        sample("skip")
    assert str(caught.value) == f"no sample named 'skip'; there are: {', '.join(sample_names())}"


@pytest.mark.parametrize("fps", [9.0, 0.0, -30.0, float("inf"), float("nan")])
def test_a_rate_that_shows_no_step_is_refused(fps: float) -> None:
    with pytest.raises(ArgumentError) as caught:
        sample("walk", fps=fps)
    assert str(caught.value) == f"fps is {fps}; a sample needs at least 10 per second"


@every
def test_the_supports_are_those_that_were_asked_for(name: str, fps: float) -> None:
    clip, supports = sample(name, fps=fps)
    assert letters(supports) == LETTERS[name]
    assert clip.cyclic is supports.cyclic is (name in CYCLIC)
    assert clip.name == name
    assert supports.start == 0.0


@every
def test_the_supports_last_as_long_as_the_clip(name: str, fps: float) -> None:
    clip, supports = sample(name, fps=fps)
    assert supports.duration == pytest.approx(clip.duration, abs=1e-12)


@pytest.mark.parametrize("fps", [24.0, 25.0, 50.0, 59.94])
@pytest.mark.parametrize("name", NAMES)
def test_any_rate_will_do(name: str, fps: float) -> None:
    clip, supports = sample(name, fps=fps)
    own, _ = sample(name, fps=120.0)
    assert supports.duration == pytest.approx(clip.duration, abs=1e-12)
    assert abs(clip.duration - own.duration) <= (0.5 if clip.cyclic else 1.0) / fps + 0.5 / 120.0


@every
def test_a_carrying_foot_is_fixed_at_its_heel_or_its_ball(name: str, fps: float) -> None:
    clip, supports = sample(name, fps=fps)
    for side in SIDES:
        flags = carried(clip, supports, side)
        points = ((joint(clip, f"{side}ToeBase"), BALL_HEIGHT), (heel(clip, side), 0.0))
        moves, downs = zip(*(resting(point, height) for point, height in points), strict=True)
        both = flags[:-1] & flags[1:]
        # Between two frames astride the moment at which the foot comes down, neither rests.
        rests = both & (downs[0] | downs[1])
        still = np.minimum(np.where(downs[0], moves[0], 1.0), np.where(downs[1], moves[1], 1.0))
        assert np.count_nonzero(both & ~rests) <= 2 * len(supports.phases)
        assert still[rests].max(initial=0.0) < 1e-4


@every
def test_a_foot_touches_the_ground_throughout_its_support(name: str, fps: float) -> None:
    clip, supports = sample(name, fps=fps)
    for side in SIDES:
        flags = carried(clip, supports, side)
        over = np.minimum(joint(clip, f"{side}ToeBase")[:, 1] - BALL_HEIGHT, heel(clip, side)[:, 1])
        assert np.abs(over[flags]).max(initial=0.0) < 1e-6


@pytest.mark.parametrize("name", [name for name in NAMES if name not in ("idle", "punch")])
def test_a_foot_that_does_not_carry_is_off_the_ground_or_on_its_way(name: str) -> None:
    fps = 240.0
    clip, supports = sample(name, fps=fps)
    for side in SIDES:
        free = ~carried(clip, supports, side)
        ball, hind = joint(clip, f"{side}ToeBase"), heel(clip, side)
        lowest = np.minimum(ball[:, 1] - BALL_HEIGHT, hind[:, 1])
        assert lowest[free].min(initial=1.0) > -1e-6
        edges = np.flatnonzero(free[1:] != free[:-1])
        for edge, rising in ((edge, bool(free[edge + 1])) for edge in edges):
            later = edge + round(0.04 * fps) if rising else edge - round(0.04 * fps)
            if not 0 <= later < clip.frames or not free[later]:
                continue
            speeds = [abs(point[later + 1] - point[later]) * fps for point in (ball, hind)]
            assert min(np.linalg.norm(speed) for speed in speeds) > 0.35
            assert lowest[later] > 0.001


@pytest.mark.parametrize("name", ["walk", "walk-slow", "walk-fast", "walk-backward"])
def test_swinging_toes_clear_the_ground_by_a_centimeter_or_more(name: str) -> None:
    clip, supports = sample(name, fps=120.0)
    bounds = supports.boundaries
    for phase, begin, end in zip(supports.phases, bounds, bounds[1:], strict=False):
        if phase.support in (Support.LEFT, Support.RIGHT):
            side = "Right" if phase.support is Support.LEFT else "Left"
            middle = slice(
                round((begin + 0.2 * (end - begin)) * 120), round((end - 0.2 * (end - begin)) * 120)
            )
            clearance = joint(clip, f"{side}ToeBase")[middle, 1] - BALL_HEIGHT
            assert 0.010 < clearance.min() < 0.035


@pytest.mark.parametrize("name", FLYING)
def test_the_pelvis_falls_freely_where_no_foot_carries(name: str) -> None:
    fps = 120.0
    clip, supports = sample(name, fps=fps)
    acceleration = np.diff(clip.pelvis_positions, n=2, axis=0) * fps**2
    bounds = supports.boundaries
    flights = 0
    for phase, begin, end in zip(supports.phases, bounds, bounds[1:], strict=False):
        if phase.support is Support.FLIGHT:
            frames = slice(int(np.ceil(begin * fps - 1e-9)), int(np.floor(end * fps + 1e-9)) - 1)
            assert acceleration[frames, 1] == pytest.approx(-9.81, abs=1e-5)
            flights += 1
    assert flights > 0


@pytest.mark.parametrize("name", CURVES)
def test_a_curve_goes_as_far_as_its_straight_gait_and_round_a_circle(name: str) -> None:
    clip, _ = sample(name)
    straight, _ = sample(name.split("-")[0])
    assert clip.duration == straight.duration
    rate = turn_rate(name)
    way = straight.pelvis_positions[-1, 2] - straight.pelvis_positions[0, 2]
    radius = way / (rate * clip.duration)
    chord = np.linalg.norm((clip.pelvis_positions[-1] - clip.pelvis_positions[0])[[0, 2]])
    # The pelvis leans into the curve, so it goes round a smaller circle than the way does.
    inside = chord / (2.0 * abs(np.sin(0.5 * rate * clip.duration)))
    assert abs(radius) - 0.15 < inside < abs(radius)


@pytest.mark.parametrize("name", CYCLIC)
def test_a_cycle_ends_on_its_first_pose_further_on(name: str) -> None:
    clip, _ = sample(name)
    first, last = clip.local_rotations[0].copy(), clip.local_rotations[-1]
    if name in CURVES:
        first[0] = multiply(from_yaw(turn_rate(name) * clip.duration), first[0])
    assert np.abs(np.sum(first * last, axis=-1)) == pytest.approx(1.0, abs=1e-9)
    travel = clip.pelvis_positions[-1] - clip.pelvis_positions[0]
    assert abs(travel[1]) < 1e-9
    turns = turning(clip)
    assert np.abs(turns[0] - turns[-1]).max() < 16.0


@every
def test_quaternions_of_neighboring_frames_are_close(name: str, fps: float) -> None:
    clip, _ = sample(name, fps=fps)
    cosines = np.sum(clip.local_rotations[1:] * clip.local_rotations[:-1], axis=-1)
    assert cosines.min() > np.cos(0.5 * 26.0 / fps)


@pytest.mark.parametrize("name", NAMES)
def test_no_joint_turns_or_jerks_faster_than_a_person(name: str) -> None:
    clip, _ = sample(name, fps=60.0)
    turns = turning(clip)
    assert np.linalg.norm(turns, axis=-1).max() < 20.0
    assert np.linalg.norm(np.diff(turns, axis=0) * 60.0, axis=-1).max() < 800.0


@pytest.mark.parametrize("name", NAMES)
def test_the_pelvis_and_the_head_never_jerk(name: str) -> None:
    clip, _ = sample(name, fps=60.0)
    for part, limit in (("Hips", 30.0), ("Head", 45.0)):
        acceleration = np.diff(joint(clip, part), n=2, axis=0) * 60.0**2
        assert np.linalg.norm(acceleration, axis=-1).max() < limit


@every
def test_knees_bend_forward_and_never_straighten_fully(name: str, fps: float) -> None:
    clip, _ = sample(name, fps=fps)
    rotations, _ = world(clip)
    for side in SIDES:
        hip, knee, ankle = (joint(clip, side + part) for part in ("UpLeg", "Leg", "Foot"))
        extension = np.linalg.norm(ankle - hip, axis=-1) / (THIGH + SHANK)
        assert extension.max() <= 0.985 + 1e-4
        thigh = rotations[:, clip.skeleton.index(f"{side}UpLeg")]
        forward = rotate(thigh, np.array([0.0, 0.0, 1.0]))
        along = (knee - hip) / THIGH
        bend = (ankle - knee) - along * np.sum((ankle - knee) * along, axis=-1, keepdims=True)
        assert np.sum(bend * forward, axis=-1).max() < 0.0


@pytest.mark.parametrize("name", NAMES)
def test_the_head_looks_ahead(name: str) -> None:
    clip, _ = sample(name)
    rotations, _ = world(clip)
    gaze = rotate(rotations[:, clip.skeleton.index("Head")], np.array([0.0, 0.0, 1.0]))
    # A walk begins with the left toe-off, 0.62 of a cycle after the strike, a run with the right
    # strike, half a cycle after it: so far has it turned by then.
    since = (0.62 if name.startswith("walk") else 0.5) * clip.duration
    ahead = turn_rate(name) * (since + np.arange(clip.frames) / clip.fps)
    gaze = rotate(from_yaw(-ahead), gaze)
    assert gaze[:, 2].min() > np.cos(np.radians(18.0))


@pytest.mark.parametrize("name", NAMES)
def test_hands_stay_outside_the_trunk(name: str) -> None:
    clip, _ = sample(name)
    rotations, positions = world(clip)
    index = clip.skeleton.index
    for side, part in product(SIDES, ("ForeArm", "Hand")):
        for one, other in pairwise(("Hips", "Spine1", "Spine2")):
            low, high = positions[:, index(one)], positions[:, index(other)]
            point = positions[:, index(side + part)]
            line = high - low
            share = np.sum((point - low) * line, axis=-1) / np.sum(line * line, axis=-1)
            nearest = low + np.clip(share, 0.0, 1.0)[:, np.newaxis] * line
            assert np.linalg.norm(point - nearest, axis=-1).min() > 0.12
    assert np.isfinite(rotations).all()


@pytest.mark.parametrize(
    ("name", "speed"),
    [("walk-slow", 0.75), ("walk", 1.3125), ("walk-fast", 1.8444), ("run", 3.3)],
)
def test_gaits_travel_at_their_speed(name: str, speed: float) -> None:
    clip, _ = sample(name)
    travel = clip.pelvis_positions[-1] - clip.pelvis_positions[0]
    assert travel[2] / clip.duration == pytest.approx(speed, abs=1e-3)
    assert abs(travel[0]) < 1e-9


@pytest.mark.parametrize("name", ["kick", "punch", "jump", "shot", "walk-to-hop"])
def test_what_happens_once_ends_at_rest_over_the_feet(name: str) -> None:
    clip, _ = sample(name, fps=60.0)
    assert clip.duration >= 1.0
    assert np.linalg.norm(clip.pelvis_positions[-1] - clip.pelvis_positions[-4]) < 1e-3
    feet = [joint(clip, f"{side}Foot")[-1] for side in SIDES]
    middle = 0.5 * (feet[0] + feet[1])
    assert np.abs((clip.pelvis_positions[-1] - middle)[[0, 2]]).max() < 0.06


def test_the_kick_swings_back_and_then_up_ahead() -> None:
    clip, _ = sample("kick")
    foot = joint(clip, "RightToeBase") - clip.pelvis_positions
    assert foot[:, 2].argmin() < foot[:, 2].argmax()
    assert foot[:, 2].min() < -0.4
    assert foot[:, 2].max() > 0.7
    assert joint(clip, "RightToeBase")[:, 1].max() > 0.4


def test_the_punch_reaches_straight_ahead_at_the_height_of_the_shoulder() -> None:
    clip, _ = sample("punch")
    hand, shoulder = joint(clip, "RightHand"), joint(clip, "RightArm")
    reach = hand - shoulder
    strike = int(reach[:, 2].argmax())
    assert reach[strike, 2] > 0.53
    assert abs(reach[strike, 1]) < 0.12
    assert abs(hand[strike, 0]) < 0.12


def test_the_same_sample_twice_is_the_same() -> None:
    one, other = sample("walk")[0], sample("walk")[0]
    assert np.array_equal(one.local_rotations, other.local_rotations)
    assert np.array_equal(one.pelvis_positions, other.pelvis_positions)


@pytest.mark.parametrize(
    ("name", "stance", "double"),
    [("walk", 0.62, 0.12), ("walk-slow", 0.66, 0.16), ("walk-fast", 0.58, 0.08)],
)
def test_walks_stand_on_both_feet_for_the_published_share(
    name: str, stance: float, double: float
) -> None:
    _, supports = sample(name, fps=120.0)
    single, both = (phase.duration / supports.duration for phase in supports.phases[:2])
    assert both == pytest.approx(double, abs=1e-9)
    assert single + 2.0 * both == pytest.approx(stance, abs=1e-9)
