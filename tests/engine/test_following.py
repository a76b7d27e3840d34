"""A character goes along a path whatever it faces, and its feet do not slide (figure 15)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import pytest

import footfall as ff
from footfall.arrays import Floats
from footfall.engine.recording import Recorder
from footfall.errors import ArgumentError, UnknownNameError
from footfall.motion import mirror, with_soles
from footfall.report import MethodReport, measure, recording_trace
from footfall.skeleton import find_anatomy

FPS = 60.0
LINE = [(0.0, 0.0), (0.0, 8.0)]
ALL = ("walk", "side-step", "walk-backward", "side-step-right")


def on_the_other_side(supports: ff.SupportSequence) -> ff.SupportSequence:
    return ff.SupportSequence.parse(str(supports).translate(str.maketrans("LR", "RL")))


def walker(*names: str) -> ff.Character:
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    for name in names:
        clip, supports = ff.sample(name.removesuffix("-right"))
        if name.endswith("-right"):
            supports = on_the_other_side(supports)
            clip = mirror(clip, find_anatomy(clip.skeleton))
        hero.add(name, clip, supports, fade_in=0.4, fade_out=0.4)
    return hero


@dataclass
class Walked:
    follower: ff.PathFollower
    away: Floats
    """How far off the path, every frame [m]."""

    facings: Floats
    """Where it faces as seen from the path, every frame [degrees]."""

    end: tuple[float, float]
    report: MethodReport


def walked(
    hero: ff.Character,
    path: npt.ArrayLike,
    facing: npt.ArrayLike | None = None,
    heading: float | None = None,
) -> Walked:
    follower = hero.follow(path, facing=facing, heading=heading)
    recorder = Recorder(hero, FPS)
    rows: list[tuple[float, float]] = []
    hero.advance(0.0)
    while not follower.done:
        assert len(rows) < 60 * FPS, "the end is never reached"
        hero.advance(1.0 / FPS)
        recorder.keep()
        way = follower.path.direction(follower.distance, 0.3)
        rows.append((follower.away, hero.root[2] - way))
    away, facings = np.array(rows).T
    walk = ff.sample("walk")[0]
    anatomy = with_soles(find_anatomy(walk.skeleton), *walk.world_poses())
    report = measure(recording_trace(recorder.finish(), anatomy))
    x, z, _ = hero.root
    return Walked(follower, np.abs(away), np.degrees(np.unwrap(facings)), (x, z), report)


def check(label: str, did: Walked, path: npt.ArrayLike, most: float) -> None:
    """Hold a walk to bounds: it stays on its path, its feet stay, it stops at the end."""
    slip, drift = did.report.slip.overall, did.report.drift.overall
    end = math.dist(did.end, tuple(np.asarray(path, dtype=float)[-1]))
    off = float(np.percentile(did.away, 95))
    print(
        f"{label}: off the path p95 {100 * off:.1f}, max {100 * did.away.max():.1f} cm; "
        f"slip p95 {slip.p95:.2f}, drift p95 {drift.p95:.2f} mm; end {100 * end:.0f} cm"
    )
    assert off < most
    assert did.away.max() < 0.3
    assert slip.p95 is not None
    assert slip.p95 < 1.0
    assert drift.p95 is not None
    assert drift.p95 < 5.0
    assert end < 0.3


@pytest.mark.parametrize("degrees", [0, 45, -45, 90, -90, 135, 180])
def test_a_line_is_kept_whatever_the_body_faces(degrees: int) -> None:
    hero = walker(*ALL)
    hero.place(0.0, 0.0, math.radians(degrees))
    did = walked(hero, LINE, math.radians(degrees))
    check(f"line, facing {degrees}°", did, LINE, 0.15)
    under_way = did.facings[60:-90]
    asked = (under_way - degrees + 180.0) % 360.0 - 180.0
    assert np.abs(asked).max() < 12.0


def circle(radius: float = 2.0) -> Floats:
    angles = np.linspace(0.0, 2.0 * np.pi, 60)
    return np.column_stack([radius * np.cos(angles) - radius, radius * np.sin(angles)])


def winding() -> Floats:
    z = np.linspace(0.0, 10.0, 80)
    return np.column_stack([0.5 * np.sin(z * 2.0 * np.pi / 6.0), z])


def test_a_walk_alone_goes_round_a_circle() -> None:
    did = walked(walker("walk"), circle())
    check("circle", did, circle(), 0.1)
    assert np.abs(did.facings[60:-60]).max() < 12.0


def test_a_circle_is_gone_round_facing_one_way() -> None:
    hero = walker(*ALL)
    did = walked(hero, circle(), heading=0.0)
    check("circle, facing +z", did, circle(), 0.15)
    assert abs(math.remainder(hero.root[2], math.tau)) < math.radians(12.0)


def test_a_winding_path_is_walked_along_and_sideways() -> None:
    check("winding", walked(walker("walk"), winding()), winding(), 0.15)
    check("winding, facing +z", walked(walker(*ALL), winding(), heading=0.0), winding(), 0.15)


def test_the_facing_may_change_along_the_path() -> None:
    hero = walker(*ALL)
    did = walked(hero, LINE, [0.0, -math.pi])
    check("line, turning round", did, LINE, 0.15)
    assert math.remainder(hero.root[2], math.tau) == pytest.approx(-math.pi, abs=0.35) or (
        math.remainder(hero.root[2], math.tau) == pytest.approx(math.pi, abs=0.35)
    )


def test_a_gait_with_parameters_follows_too() -> None:
    hero = ff.Character(ff.sample("walk")[0].skeleton)
    hero.add_locomotion("go", [ff.sample(name) for name in ("walk", "run")], speed=1.8)
    did = walked(hero, circle(4.0))
    check("a gait of 1.8 m/s round a circle of 4 m", did, circle(4.0), 0.15)


def test_what_lies_beyond_all_directions_is_gone_to_as_near_as_they_come() -> None:
    did = walked(walker("walk", "side-step"), LINE, math.radians(90.0))
    check("facing left without a step to the right", did, LINE, 0.15)


def test_any_step_of_time_leads_along_the_same_path() -> None:
    hero = walker("walk")
    follower = hero.follow(LINE)
    hero.advance(0.0)
    for _ in range(20):
        hero.advance(0.5)
    assert follower.done
    assert math.dist(hero.root[:2], LINE[-1]) < 0.3


def test_a_follower_can_be_told_to_stop() -> None:
    hero = walker("walk")
    follower = hero.follow(LINE)
    for _ in range(120):
        hero.advance(1.0 / FPS)
    follower.stop()
    for _ in range(120):
        hero.advance(1.0 / FPS)
    assert follower.done
    assert 1.0 < hero.root[1] < 5.0
    assert not hero.is_active("walk")


def test_another_path_takes_the_place_of_the_first_one() -> None:
    hero = walker("walk")
    hero.follow(LINE)
    for _ in range(60):
        hero.advance(1.0 / FPS)
    did = walked(hero, [(0.0, 1.0), (0.0, 4.0)])
    assert math.dist(did.end, (0.0, 4.0)) < 0.3


def refusal(error: type[Exception], hero: ff.Character, *args: object, **asked: object) -> str:
    with pytest.raises(error) as caught:
        hero.follow(*args, **asked)  # pyright: ignore[reportArgumentType]
    return str(caught.value)


def test_what_cannot_be_followed_is_refused_with_the_reason() -> None:
    hero = walker(*ALL)
    hero.add("kick", *ff.sample("kick"))
    hero.add("idle", *ff.sample("idle"))
    hero.add("fast", *ff.sample("walk-fast"))
    assert refusal(ArgumentError, hero, [(0, 0)], ALL) == (
        "a path of shape (1, 2); two points or more are needed, x and z of each"
    )
    assert refusal(ArgumentError, hero, LINE, ALL, facing=0.0, heading=0.0) == (
        "both a facing and a heading; the body has one of them"
    )
    assert refusal(ArgumentError, hero, LINE, ALL, facing=[0, 1, 2]) == (
        "facings of shape (3,); give one number, or 2, one a point"
    )
    assert refusal(ArgumentError, hero, LINE, ALL, facing=math.nan) == (
        "a facing is not finite; give angles [rad]"
    )
    assert refusal(ArgumentError, hero, LINE, ALL, facing="north") == (
        "a facing must be a number, or one for each point of the path"
    )
    assert refusal(ArgumentError, hero, LINE, ["kick"]) == (
        "'kick' is not cyclic; a path needs walks and side steps"
    )
    assert refusal(ArgumentError, hero, LINE, ["idle"]) == (
        "'idle' stays where it is; a path needs walks and side steps"
    )
    alike = refusal(ArgumentError, hero, LINE)
    pairs = [("walk", "fast"), ("fast", "walk")]
    told = "{!r} and {!r} go the same way, 0° to the left; name one of them"
    assert alike in [told.format(*pair) for pair in pairs]
    assert refusal(UnknownNameError, hero, LINE, ["swim"]).startswith("no action named 'swim'")
    still = ff.Character(ff.sample("idle")[0].skeleton)
    still.add("idle", *ff.sample("idle"))
    assert refusal(ArgumentError, still, LINE) == (
        "no action that travels; a path needs a cyclic walk at least"
    )


def test_a_turn_that_is_no_number_is_refused() -> None:
    hero = walker("walk")
    with pytest.raises(ArgumentError) as caught:
        hero.crowd.steer(math.inf)
    assert str(caught.value) == "turning is inf rad/s; it must be finite"


def test_a_steered_character_turns_as_it_is_told_on_planted_feet() -> None:
    hero = walker("walk")
    hero.start("walk")
    hero.crowd.steer(0.8)
    recorder = Recorder(hero, FPS)
    for frame in range(240):
        hero.advance(1.0 / FPS if frame else 0.0)
        recorder.keep()
    assert hero.root[2] == pytest.approx(0.8 * 239 / FPS)
    walk = ff.sample("walk")[0]
    anatomy = with_soles(find_anatomy(walk.skeleton), *walk.world_poses())
    report = measure(recording_trace(recorder.finish(), anatomy))
    assert report.slip.overall.p95 is not None
    assert report.slip.overall.p95 < 1.0
    # Not only the point that carries: the whole sole stays as it was planted.
    recording = recorder.finish()
    toe, ankle = anatomy.legs[0].toe.joint, anatomy.legs[0].ankle
    along = recording.world_positions[:, toe] - recording.world_positions[:, ankle]
    yaws = np.unwrap(np.arctan2(along[:, 0], along[:, 2]))
    flat = np.array([symbol == "L" for symbol in recording.support_text])
    inside = flat[1:] & flat[:-1]
    assert np.abs(np.diff(yaws)[inside]).max() * FPS < 0.5
    hero.crowd.steer(None)
    heading = hero.root[2]
    for _ in range(240):
        hero.advance(1.0 / FPS)
    assert hero.root[2] == pytest.approx(heading, abs=1e-6)
    assert not hero.crowd.characters[0]["twisted"]


def test_a_row_of_a_crowd_with_another_body_follows_too() -> None:
    library = ff.MotionLibrary()
    library.add("walk", *ff.sample("walk"))
    walk = ff.sample("walk")[0].skeleton
    child = ff.Skeleton(walk.names, walk.parents, 0.6 * walk.rest_offsets, 0.6 * walk.tip_offsets)
    crowd = ff.Crowd(library, 1)
    row = int(crowd.spawn(1, body=child)[0])
    follower = ff.PathFollower(crowd, row, [(0.0, 0.0), (0.0, 4.0)])
    for _ in range(1200):
        if follower.done:
            break
        follower.steer(1.0 / FPS)
        crowd.advance(1.0 / FPS)
    assert follower.done
    x, z, _ = crowd.place_of(row)
    assert math.dist((x, z), (0.0, 4.0)) < 0.3
