from __future__ import annotations

import io
from typing import Any

import footfall as ff
from footfall.engine.feet import locate_feet, stand_where_planted
from footfall.engine.flight import fly
from footfall.engine.landing import foresee_landings
from footfall.engine.placing import aim_body, place_bodies
from footfall.engine.pose import blend_poses, move_root
from footfall.engine.pose_compiling import compile_poses
from footfall.engine.treading import keep_footprints, ride

STAGES: tuple[Any, ...] = (
    place_bodies,
    keep_footprints,
    foresee_landings,
    blend_poses,
    aim_body,
    fly,
    move_root,
    ride,
    locate_feet,
    stand_where_planted,
)


def compiled_anew() -> int:
    return sum(sum(stage.stats.cache_misses.values()) for stage in STAGES)


def test_pose_stages_are_compiled_as_the_tick_calls_them() -> None:
    library = ff.MotionLibrary()
    library.add("walk", *ff.sample("walk"))
    crowd = ff.Crowd(library, 2)
    crowd.advance(1.0 / 60.0)
    before = compiled_anew()
    compile_poses(crowd)
    assert [len(stage.signatures) for stage in STAGES] == [1] * len(STAGES)
    assert compiled_anew() == before


def test_warming_up_tells_each_step_and_the_time_it_took() -> None:
    out = io.StringIO()
    seconds = ff.warmup(out)
    lines = out.getvalue().splitlines()
    assert lines[0] == "footfall: preparing kernels, 1 of 3: motions"
    assert lines[-1] == f"footfall: kernels ready after {seconds:.1f} s"
    assert len(lines) == 4
