"""The stages of a tick that come after its clock, compiled on their own.

One process compiles one kernel at a time. Another process can do these meanwhile: none of them
knows the planner, which takes as long. Their machine code is found in the cache by the first one.
"""

from __future__ import annotations

from typing import Any, cast

import numba  # pyright: ignore[reportMissingTypeStubs]

from footfall.engine.crowd import Crowd
from footfall.engine.feet import locate_feet, stand_where_planted
from footfall.engine.flight import fly
from footfall.engine.landing import foresee_landings
from footfall.engine.layers import lay_over
from footfall.engine.placing import aim_body, place_bodies
from footfall.engine.pose import blend_poses, move_root
from footfall.engine.state import new_workspace
from footfall.engine.treading import keep_footprints, ride

__all__ = ["compile_poses"]


def compile_poses(crowd: Crowd) -> None:
    """Compile stages 4 to 8 as `pipeline.advance_blocks` calls them, for crowds such as this."""
    work = new_workspace(crowd.skeleton.count)
    type_of = cast(Any, numba).typeof
    library, ground, rig, memory, me = (
        type_of(one)
        for one in (crowd.shelf, crowd.packed_ground, crowd.rig, work, crowd.characters[0])
    )
    characters, poses = type_of(crowd.characters), type_of(crowd.poses)
    pose, points = type_of(work.blended[0]), type_of(work.points)
    moment = type_of(work.moments[0])
    layers = type_of(crowd.shelf.layers)
    lane: Any = numba.intp
    time: Any = numba.float64
    stages: tuple[tuple[Any, tuple[Any, ...]], ...] = (
        (place_bodies, (rig, characters, memory, poses, lane)),
        (keep_footprints, (ground, rig, me, moment, time)),
        (foresee_landings, (library, ground, rig, me, moment, points)),
        (blend_poses, (library, rig, me, memory, lane)),
        (lay_over, (layers, me, pose, time)),
        (aim_body, (rig, me, memory, lane)),
        (fly, (library, rig, me, moment, time)),
        (move_root, (rig, me, moment, time)),
        (ride, (ground, me, time)),
        (locate_feet, (library, moment, pose)),
        (stand_where_planted, (library, me, moment)),
    )
    for stage, arguments in stages:
        cast(Any, stage).compile(arguments)
