"""Feet on slopes, stairs and things that move: what was planted stays where it was planted."""

from __future__ import annotations

import math

import numpy as np
import pytest

import footfall as ff
from footfall.adaptation import (
    AnyGround,
    HeightField,
    Plane,
    Platform,
    Stairs,
    Terrain,
    ground_heights,
)
from footfall.arrays import Floats, Positions, Seconds
from footfall.engine.recording import Recorder, Recording
from footfall.motion import with_soles
from footfall.report import MethodReport, Trace, Track, measure
from footfall.report.pops import joint_pops
from footfall.skeleton import Anatomy, find_anatomy

FPS = 60


def walked(
    ground: AnyGround, frames: int = 240, later: dict[int, AnyGround] | None = None
) -> Recording:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, ground=ground)
    hero.add("walk", walk, supports)
    hero.start("walk")
    recorder = Recorder(hero, FPS)
    for frame in range(frames):
        if later and frame in later:
            hero.crowd.ground = later[frame]
        hero.advance(1 / FPS if frame else 0.0)
        recorder.keep()
    return recorder.finish()


def anatomy() -> Anatomy:
    walk, _ = ff.sample("walk")
    return with_soles(find_anatomy(walk.skeleton), *walk.world_poses())


def trace(recording: Recording, ground: AnyGround, resting: Floats | None) -> Trace:
    def heights(points: Positions, times: Seconds) -> Floats:
        return ground_heights(ground, points, times)

    return Trace(
        recording.world_positions,
        recording.world_rotations,
        anatomy(),
        FPS,
        recording.supports,
        ground=heights,
        surface_displacement=np.repeat(recording.carried[:, :, np.newaxis], 2, axis=2),
        resting_levels=resting,
    )


@pytest.fixture(scope="module")
def resting() -> Floats:
    return Track.from_trace(trace(walked(Plane()), Plane(), None)).resting_levels


def measured(ground: AnyGround, resting: Floats) -> MethodReport:
    return measure(trace(walked(ground), ground, resting))


def hilly() -> HeightField:
    x, z = np.meshgrid(np.arange(-8.0, 8.0, 0.1), np.arange(-8.0, 8.0, 0.1))
    return HeightField(0.12 * np.sin(1.7 * x + 0.4) * np.cos(2.1 * z), 0.1)


TWENTY, FIFTEEN = math.tan(math.radians(20.0)), math.tan(math.radians(15.0))
GROUNDS: dict[str, AnyGround] = {
    "up 20 degrees": Plane(0.0, (0.0, TWENTY)),
    "down 20 degrees": Plane(0.0, (0.0, -TWENTY)),
    "across 15 degrees": Plane(0.0, (FIFTEEN, 0.0)),
    "hills": hilly(),
    "up stairs": Terrain((Plane(), Stairs((0.0, 0.0, 1.0), 10))),
    "down stairs": Terrain(
        (
            Platform((0.0, 0.0, -4.0), (9.0, 10.0)),
            Stairs((0.0, 0.0, 1.0), 10, rise=-0.18),
            Plane(-1.8),
        )
    ),
    "a platform at half a meter a second": Platform((0, 0, 0), (90, 90), way=(0.5, 0.0, 0.0)),
    "a platform that rises and sinks": Platform((0, 0, 0), (90, 90), (0.0, 0.1, 0.1), 2.0),
    "a turntable": Platform((0, 0, 1), (90, 90), turning=math.radians(30.0)),
}


@pytest.mark.parametrize("name", GROUNDS)
def test_planted_feet_stay_on_whatever_they_stand(name: str, resting: Floats) -> None:
    recording = walked(GROUNDS[name])
    report = measure(trace(recording, GROUNDS[name], resting))
    drift, penetration, floating = (
        spread.overall.p95 for spread in (report.drift, report.penetration, report.floating)
    )
    pops, level = joint_pops(recording.world_positions), joint_pops(walked(Plane()).world_positions)
    assert pops is not None
    assert level is not None
    ratios = pops.over(level)
    assert ratios is not None
    print(
        f"{name}: drift {drift:.1f}, penetration {penetration:.1f}, float {floating:.1f} mm p95; "
        f"pops {ratios.speed_p999:.2f} {ratios.acceleration_p999:.2f} of those on level ground"
    )
    assert ratios.speed_p999 <= 2.0
    assert ratios.acceleration_p999 <= 2.0
    assert drift is not None
    assert drift <= 5.0
    assert penetration is not None
    assert penetration <= 5.0
    assert floating is not None
    assert floating <= 10.0


@pytest.mark.parametrize("height", [0.0, 0.05, 0.15])
@pytest.mark.parametrize("way", [(0.5, 0.0), (0.0, 0.5), (0.0, -0.5)])
def test_a_foot_that_comes_down_at_the_edge_of_what_moves_does_not_slide(
    way: tuple[float, float], height: float, resting: Floats
) -> None:
    worst = 0.0
    for shift in (0.0, 0.11, 0.22, 0.33):
        place = (-2.0 * way[0], height, 2.4 + shift - 2.0 * way[1])
        platform = Platform(place, (2.0 + shift, 1.6), way=(way[0], 0.0, way[1]))
        drift = measured(Terrain((Plane(), platform)), resting).drift.overall.maximum
        worst = max(worst, drift or 0.0)
    print(f"an edge {height} m high, going {way} m/s: drift at most {worst:.1f} mm")
    assert worst <= 10.0


def test_what_is_put_on_a_slope_stands_on_it_from_the_first_frame() -> None:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton, ground=Plane(0.0, (0.0, TWENTY)))
    hero.add("walk", walk, supports)
    hero.start("walk")
    shown = np.array([hero.advance(1 / FPS if i else 0.0).world_positions.copy() for i in range(6)])
    pops, level = joint_pops(shown), joint_pops(walked(Plane()).world_positions)
    assert pops is not None
    assert level is not None
    assert pops.acceleration_max < 2.0 * level.acceleration_max


def test_the_body_goes_where_the_ground_leads() -> None:
    flat, uphill = walked(Plane()), walked(Plane(0.0, (0.0, TWENTY)))
    way = flat.world_positions[-1, 0] - flat.world_positions[0, 0]
    rise = uphill.world_positions[-1, 0, 1] - uphill.world_positions[0, 0, 1]
    assert rise == pytest.approx(TWENTY * way[2], abs=0.15)


def test_the_ground_may_change_while_a_character_walks(resting: Floats) -> None:
    recording = walked(Plane(), later={90: Plane(0.1), 150: Plane(0.0, (0.05, 0.0))})
    assert np.isfinite(recording.world_positions).all()
    steps = np.abs(np.diff(recording.world_positions, n=2, axis=0)) * FPS**2
    usual = np.abs(np.diff(walked(Plane()).world_positions, n=2, axis=0)) * FPS**2
    assert steps.max() < 4.0 * usual.max()
    assert resting.shape == (2, 2)


def test_a_character_that_is_put_elsewhere_leaves_its_footprints() -> None:
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton)
    hero.add("walk", walk, supports)
    hero.start("walk")
    for _ in range(40):
        hero.advance(1 / FPS)
    hero.place(5.0, -3.0)
    shown = hero.advance(1 / FPS).world_positions
    ankles = shown[[leg.ankle for leg in anatomy().legs]]
    assert np.abs(ankles[:, [0, 2]] - [5.0, -3.0]).max() < 0.8
    assert np.linalg.norm(hero.crowd.characters[0]["foot_offset"], axis=-1).max() < 0.05
