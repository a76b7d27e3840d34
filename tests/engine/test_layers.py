"""Layers: motions laid over what plays, that no foot and no schedule notices."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import footfall as ff
from footfall.arrays import Floats, Rotations
from footfall.engine import Recorder, Recording
from footfall.engine.layer import pack_turns, parse_parts
from footfall.errors import ArgumentError, UnknownNameError
from footfall.geometry import conjugate, multiply
from footfall.skeleton import BodyPart, find_anatomy

FPS = 60
IDLE, WALK = ff.sample("idle")[0], ff.sample("walk")[0]
SKELETON = IDLE.skeleton
ANATOMY = find_anatomy(SKELETON)
PARTS = np.asarray(ANATOMY.parts, dtype=np.int64)
LEGS = np.flatnonzero(PARTS == BodyPart.LEGS)
UPPER = np.flatnonzero(PARTS != BodyPart.LEGS)


def turned(joint: str, angles: Floats, axis: int, clip: ff.Clip) -> ff.Clip:
    """Return a clip whose joint is turned on, in its parent's frame, by angles [rad] a frame."""
    rotations = np.array(clip.local_rotations[[0] * len(angles)])
    turns = np.zeros((len(angles), 4))
    turns[:, 0], turns[:, 1 + axis] = np.cos(angles / 2), np.sin(angles / 2)
    number = clip.skeleton.names.index(joint)
    rotations[:, number] = multiply(turns, rotations[:, number])
    pelvis = np.array(clip.pelvis_positions[[0] * len(angles)])
    return ff.Clip(clip.skeleton, pelvis, rotations, FPS)


def nod(clip: ff.Clip = IDLE, *, cyclic: bool = True, joint: str = "Neck") -> ff.Clip:
    """Return a nod of a second, or another joint's: from the clip's first pose and back to it."""
    angles = 0.5 * np.sin(np.linspace(0.0, 2.0 * np.pi, FPS + 1))
    angles[-1] = 0.0
    return turned(joint, angles, 0, clip).evolve(cyclic=cyclic)


def walker(**options: Any) -> ff.Character:
    hero = ff.Character(SKELETON, **options)
    for name in ("walk", "run", "punch"):
        hero.add(name, *ff.sample(name))
    hero.add_layer("nod", nod(), parts=["head"])
    hero.add_layer("wave", nod(joint="RightForeArm", cyclic=False), parts=["right_arm"])
    hero.add_layer("blow", ff.sample("punch")[0])
    return hero


def play(hero: ff.Character, cues: dict[int, tuple[str, str]], frames: int = 150) -> Recording:
    recorder = Recorder(hero, FPS)
    for frame in range(frames):
        if frame in cues:
            command, name = cues[frame]
            getattr(hero, command)(name)
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish()


MOVES = {0: ("start", "walk"), 40: ("start", "run"), 90: ("stop", "walk")}
OVER = {10: ("start_layer", "nod"), 30: ("start_layer", "blow"), 110: ("stop_layer", "nod")}


def local_rotations(hero: ff.Character) -> Rotations:
    world = hero.advance(0.0).world_rotations
    local = np.array(world)
    for joint in range(1, SKELETON.count):
        local[joint] = multiply(conjugate(world[SKELETON.parents[joint]]), world[joint])
    local /= np.linalg.norm(local, axis=-1, keepdims=True)
    return local


def same(one: Rotations, other: Rotations, atol: float = 5e-6) -> None:
    apart = np.minimum(np.abs(one - other).max(axis=-1), np.abs(one + other).max(axis=-1))
    assert apart.max() < atol


def bits(hero: ff.Character) -> bytes:
    return hero.crowd.poses.tobytes()


def test_legs_root_and_schedule_do_not_notice_what_lies_over_them() -> None:
    bare, laid = play(walker(), MOVES), play(walker(), MOVES | OVER)
    assert np.array_equal(bare.world_positions[:, LEGS], laid.world_positions[:, LEGS])
    assert np.array_equal(bare.world_rotations[:, LEGS], laid.world_rotations[:, LEGS])
    for field in ("supports", "shares", "clip_times", "rates", "foot_offsets"):
        np.testing.assert_array_equal(getattr(bare, field), getattr(laid, field))
    apart = np.abs(bare.world_positions[:, UPPER] - laid.world_positions[:, UPPER])
    assert apart[:10].max() == 0.0
    assert apart[20:100].max() > 0.1


def test_at_weight_zero_and_after_it_has_gone_no_bit_differs() -> None:
    bare, laid = walker(), walker()
    for frame in range(120):
        for hero in (bare, laid):
            if frame == 0:
                hero.start("walk")
        if frame == 20:
            laid.crowd.start_layer(2, weight=0.0)
        if frame == 50:
            laid.start_layer("nod")
        if frame == 70:
            laid.stop_layer("nod")
        bare.advance(1 / FPS)
        laid.advance(1 / FPS)
        if 52 <= frame < 75:
            assert bits(bare) != bits(laid)
        elif frame < 50 or frame >= 87:
            assert bits(bare) == bits(laid), frame
    assert laid.layer_weight("nod") == 0.0


def test_what_keeps_its_reference_pose_changes_no_bit() -> None:
    heroes = walker(), walker()
    still = turned("Neck", np.zeros(10), 0, WALK)
    heroes[1].add_layer("still", still, fade_in=0.0)
    for hero in heroes:
        hero.start("walk")
    heroes[1].start_layer("still")
    for _ in range(7):
        for hero in heroes:
            hero.advance(1 / FPS)
        assert heroes[1].layer_weight("still") > 0.0
        assert bits(heroes[0]) == bits(heroes[1])


def test_over_its_own_reference_the_clip_comes_out_as_it_is() -> None:
    clip = ff.sample("punch")[0]
    hero = ff.Character(SKELETON, neutral=clip)
    hero.add("walk", *ff.sample("walk"))
    hero.add_layer("blow", clip, fade_in=0.0, fade_out=0.0)
    hero.advance(0.0)
    hero.start_layer("blow")
    for frame in range(1, clip.frames - 1):
        hero.advance(1 / clip.fps)
        same(local_rotations(hero)[UPPER], clip.local_rotations[frame, UPPER])


def test_a_given_pose_is_the_reference() -> None:
    pose = turned("RightArm", np.array([2.0]), 2, IDLE)
    hero = ff.Character(SKELETON, neutral=IDLE)
    hero.add("walk", *ff.sample("walk"))
    hero.add_layer("raised", pose, reference=IDLE, fade_in=0.0)
    hero.add_layer("none", pose, fade_in=0.0)
    hero.advance(0.0)
    before = local_rotations(hero)
    hero.start_layer("none")
    hero.advance(1.0)
    same(local_rotations(hero), before)
    hero.start_layer("raised")
    # A single pose lies until it is stopped.
    hero.advance(100.0)
    same(local_rotations(hero)[UPPER], pose.local_rotations[0, UPPER])
    same(local_rotations(hero)[LEGS], before[LEGS])


@given(
    st.floats(0.0, 1.0), st.floats(0.0, 0.9), st.sampled_from(["arms", "trunk", "head", "left_arm"])
)
@settings(max_examples=25, deadline=None)
def test_a_joint_is_turned_by_a_part_of_the_turn_between_two_frames(
    weight: float, time: float, part: str
) -> None:
    clip = ff.sample("punch")[0]
    bare, laid = (ff.Character(SKELETON) for _ in range(2))
    for hero in (bare, laid):
        hero.add("walk", *ff.sample("walk"))
        hero.add_layer("blow", clip, parts=[part], fade_in=0.0, fade_out=0.0)
        hero.start("walk")
    laid.start_layer("blow", weight=weight)
    for hero in (bare, laid):
        hero.advance(time)
    frame, fraction = divmod(float(np.float32(time) * clip.fps), 1.0)
    turns: Rotations = multiply(clip.local_rotations, conjugate(clip.local_rotations[0]))
    turns *= np.sign(turns[..., :1])
    one, other = turns[int(frame)], turns[int(frame) + 1]
    part_turn = weight * (one + fraction * (other - one))
    part_turn[:, 0] += 1.0 - weight
    part_turn /= np.linalg.norm(part_turn, axis=-1, keepdims=True)
    base = local_rotations(bare)
    expected = np.where(
        parse_parts("", [part])[PARTS][:, np.newaxis] > 0.0, multiply(part_turn, base), base
    )
    same(local_rotations(laid), expected)


def test_several_lie_on_each_other_and_those_of_other_parts_beside() -> None:
    heroes = [walker() for _ in range(4)]
    for number, hero in enumerate(heroes):
        hero.add_layer("shake", turned("Neck", np.array([0.7]), 1, IDLE), reference=IDLE)
        hero.start("walk")
        if number & 1:
            hero.start_layer("nod")
        if number & 2:
            hero.start_layer("shake")
        for _ in range(30):
            hero.advance(1 / FPS)
    bare, nods, shakes, both = (local_rotations(hero) for hero in heroes)
    neck = SKELETON.names.index("Neck")
    turn = multiply(shakes[neck], conjugate(bare[neck]))
    same(both[neck], multiply(turn, nods[neck]))
    others = np.delete(np.arange(SKELETON.count), neck)
    same(both[others], bare[others])


def test_weight_fades_along_a_smoothstep_however_time_is_cut() -> None:
    for step in (1 / 240, 1 / 60, 0.1):
        hero = walker()
        hero.start_layer("nod", weight=0.8)
        for count in range(1, round(0.2 / step) + 1):
            hero.advance(step)
            share = count * step / 0.3
            assert hero.layer_weight("nod") == pytest.approx(
                0.8 * share**2 * (3 - 2 * share), abs=1e-6
            )
        # Turned back in the middle it does not leap, and takes its own time.
        before = hero.layer_weight("nod")
        hero.stop_layer("nod")
        assert hero.layer_weight("nod") == pytest.approx(before, abs=1e-7)
        hero.advance(0.15)
        assert hero.layer_weight("nod") == pytest.approx(0.5 * before, abs=1e-6)
        hero.start_layer("nod", weight=1.0)
        hero.advance(0.15)
        assert hero.layer_weight("nod") == pytest.approx(0.25 * before + 0.5, abs=1e-6)
        hero.advance(0.15)
        assert hero.layer_weight("nod") == 1.0


def test_a_pose_that_fades_in_is_turned_by_the_weight_it_says() -> None:
    pose = turned("RightArm", np.array([1.2]), 2, IDLE)
    heroes = walker(), walker()
    for hero, fade in zip(heroes, (0.4, 0.0), strict=True):
        hero.add_layer("raised", pose, reference=IDLE, fade_in=fade)
        hero.start("walk")
    heroes[0].start_layer("raised")
    for _ in range(9):
        heroes[0].advance(1 / FPS)
        heroes[1].start_layer("raised", weight=heroes[0].layer_weight("raised"))
        heroes[1].advance(1 / FPS)
        same(local_rotations(heroes[0]), local_rotations(heroes[1]))


def test_where_half_a_whole_turn_says_nothing_a_joint_keeps_its_pose() -> None:
    clip = turned("LeftArm", np.linspace(0.0, 2.0 * np.pi, 61), 0, IDLE)
    bare, laid = walker(), walker()
    laid.add_layer("round", clip, fade_in=0.0, fade_out=0.0)
    laid.start_layer("round", weight=0.5)
    for hero in (bare, laid):
        hero.advance(1.0 - 1e-7)
    assert laid.layer_weight("round") == 0.5
    same(local_rotations(laid), local_rotations(bare), 1e-2)


def test_nothing_pops_where_a_layer_comes_and_goes() -> None:
    cues = {0: ("start", "walk"), 30: ("start_layer", "blow"), 60: ("stop_layer", "blow")}
    bare, laid = (play(walker(), one, 120) for one in ({0: ("start", "walk")}, cues))
    punch = ff.sample("punch")[0].world_poses()[1]
    greatest = [
        float(np.linalg.norm(np.diff(places, 2, axis=0), axis=-1).max()) * FPS**2
        for places in (bare.world_positions, laid.world_positions, punch)
    ]
    assert greatest[1] < greatest[0] + 1.2 * greatest[2]


def test_what_is_played_once_is_gone_by_its_end_and_may_begin_anew_before() -> None:
    hero = walker()
    length = 1.0
    hero.start_layer("wave")
    hero.advance(length - 0.3)
    assert hero.layer_weight("wave") == pytest.approx(1.0)
    hero.advance(0.15)
    assert hero.layer_weight("wave") == pytest.approx(0.5, abs=1e-6)
    hero.start_layer("wave")
    hero.advance(0.15)
    seats = hero.crowd.characters["layers"][0]
    assert seats["status"].tolist() == [0, 1, 0, 0]
    assert seats["time"][1] == pytest.approx(0.15)
    hero.advance(2.0)
    assert not hero.crowd.characters["layered"][0]


def test_a_cycle_goes_on_until_it_is_stopped() -> None:
    hero = walker()
    hero.start_layer("nod")
    hero.advance(7.25)
    first = local_rotations(hero)
    seat = hero.crowd.characters["layers"][0, 0]
    assert seat["time"] == pytest.approx(0.25, abs=1e-5)
    hero.advance(4.0)
    same(local_rotations(hero), first)
    hero.stop_layer("nod")
    hero.advance(0.3)
    assert not hero.crowd.characters["layered"][0]


def test_an_arm_that_goes_round_does_not_leap_at_half_a_turn() -> None:
    angles = np.linspace(0.0, 1.6 * np.pi, 61)
    keys = pack_turns(turned("LeftArm", angles, 0, IDLE), IDLE, ANATOMY, parse_parts("", ["arms"]))
    joint = 4 * SKELETON.names.index("LeftArm")
    np.testing.assert_allclose(keys[:, joint], np.cos(angles / 2), atol=1e-6)


def test_a_row_of_a_crowd_is_a_character_alone_and_a_snapshot_takes_it_back() -> None:
    hero = walker()
    crowd = ff.Crowd(hero.library, 11)
    chosen = np.arange(11) % 3 == 1
    crowd.start(0)
    hero.start("walk")
    kept: Any = None
    for frame in range(90):
        if frame == 5:
            crowd.start_layer(0, chosen, weight=0.6)
            hero.start_layer("nod", weight=0.6)
        if frame == 30:
            crowd.start_layer(2, [4, 5])
            hero.start_layer("blow")
        if frame == 44:
            kept = crowd.snapshot()
        crowd.advance(1 / FPS)
        hero.advance(1 / FPS)
        alone, other = hero.crowd.world_rotations[0], crowd.world_rotations
        assert np.array_equal(other[4], alone)
        if 5 < frame < 30:
            assert np.array_equal(other[10], alone)
            assert not np.array_equal(other[0], alone)
    assert crowd.layer_weights(0).tolist() == [0.6000000238418579 * one for one in chosen]
    end = crowd.poses.tobytes()
    crowd.restore(kept)
    for _ in range(44, 90):
        crowd.advance(1 / FPS)
    assert crowd.poses.tobytes() == end
    crowd.spawn(1)
    assert crowd.characters["layered"].tolist()[-1] == 0


def test_hands_reach_from_where_a_layer_has_taken_them() -> None:
    hero = walker()
    hero.start_layer("blow")
    hero.advance(0.5)
    hero.reach("right", (-0.3, 1.2, 0.35), fade=0.1)
    for _ in range(40):
        hero.advance(1 / FPS)
    assert hero.hand("right").missing < 0.01
    assert hero.hand("right").palm == pytest.approx((-0.3, 1.2, 0.35), abs=0.01)


def test_without_synchronization_and_at_half_rate_layers_lie_too() -> None:
    hero = walker(synchronized=False)
    hero.crowd.set_detail("half rate")
    hero.start("walk")
    hero.start_layer("nod")
    for _ in range(40):
        hero.advance(1 / FPS)
    assert hero.layer_weight("nod") == 1.0


def test_one_that_is_added_later_can_be_laid() -> None:
    hero = walker()
    hero.start("walk")
    hero.advance(0.1)
    hero.add_layer("late", nod(joint="Head"))
    hero.start_layer("late")
    hero.advance(0.2)
    assert hero.layer_weight("late") > 0.5
    assert [layer.name for layer in hero.library.layers] == ["nod", "wave", "blow", "late"]


def test_a_layer_of_another_body_is_brought_onto_the_librarys() -> None:
    punch = ff.sample("punch")[0]
    names = tuple("Bauch" if name == "Spine" else name for name in SKELETON.names)
    other = ff.Skeleton(names, SKELETON.parents, SKELETON.rest_offsets, SKELETON.tip_offsets)
    heroes = walker(), walker()
    for hero, body in zip(heroes, (SKELETON, other), strict=True):
        clip = punch.evolve(skeleton=body)
        hero.add_layer("theirs", clip, parts=["arms"], reference=clip)
        hero.start("walk")
        hero.start_layer("theirs")
        hero.advance(0.7)
    same(local_rotations(heroes[1]), local_rotations(heroes[0]), 2e-2)
    bare = walker()
    bare.start("walk")
    bare.advance(0.7)
    assert np.abs(local_rotations(heroes[1]) - local_rotations(bare)).max() > 0.1


def test_what_cannot_be_laid_is_told() -> None:
    hero = walker()

    def told(kind: type[Exception], command: Any, *args: Any, **options: Any) -> str:
        with pytest.raises(kind) as caught:
            command(*args, **options)
        return str(caught.value)

    assert told(UnknownNameError, hero.start_layer, "walk") == (
        "no layer named 'walk'; there are: nod, wave, blow"
    )
    assert told(ArgumentError, hero.start_layer, "nod", weight=1.5) == (
        "a layer with a weight of 1.5; it must be within 0..1"
    )
    assert told(ArgumentError, hero.add_layer, "walk", nod()) == (
        "there already is an action named 'walk'; names must differ"
    )
    assert told(ArgumentError, hero.add, "nod", *ff.sample("walk")) == (
        "there already is a layer named 'nod'; names must differ"
    )
    assert told(ArgumentError, hero.add_layer, "a", nod(), fade_in=-1.0) == (
        "fade_in of 'a' is -1.0 s; it must be >= 0"
    )
    parts = (
        "; a layer moves no foot: its parts are some of trunk, head, arms, left_arm and right_arm"
    )
    assert told(ArgumentError, hero.add_layer, "a", nod(), parts=["legs", "head"]) == (
        "'a' is to turn the legs" + parts
    )
    assert told(ArgumentError, hero.add_layer, "a", nod(), parts=()) == (
        "'a' turns no body part" + parts
    )
    assert told(UnknownNameError, hero.add_layer, "a", nod(), parts="tail") == (
        "no body part named 'tail'; there are: legs, trunk, head, arms, left_arm, right_arm"
    )
    assert told(ArgumentError, hero.crowd.start_layer, 7) == "layer 7; the library has 0..2"
    for number in range(3):
        hero.add_layer(f"more {number}", nod())
    for name in ("nod", "wave", "blow", "more 0"):
        hero.start_layer(name)
    assert told(ArgumentError, hero.start_layer, "more 1") == (
        "character 0 already has 4 layers on; stop one first"
    )
    # Who is on already only changes its weight.
    hero.start_layer("nod", weight=0.5)
    bare = ff.Character(SKELETON)
    assert told(ArgumentError, bare.stop_layer, "nod") == (
        "the character has no action yet; add one first"
    )
    bare.add("walk", *ff.sample("walk"))
    assert told(ArgumentError, bare.crowd.start_layer, 0) == (
        "layer 0; the library has none; add_layer makes one"
    )
