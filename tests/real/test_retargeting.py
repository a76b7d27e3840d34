"""Real motions on other bodies, in a table.

`pytest -s -m full tests/real/test_retargeting.py` prints it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from tests.motion.test_retargeting import ROBOT
from tests.skeleton.bodies import body

import footfall as ff
from footfall.detection import clean_and_tell, detect_supports
from footfall.io import load, load_skinned, save_gltf
from footfall.motion.retargeting import map_clip, performer_anatomy, retarget
from footfall.report import clip_trace, measure
from footfall.report.track import carrying
from footfall.skeleton import Skeleton, find_anatomy
from footfall.skeleton.capsule_overlap import arm_overlaps

FOLDER = Path(__file__).parents[3] / "shared" / "motions"
needs_clips = pytest.mark.skipif(not FOLDER.exists(), reason="no ../shared/motions")

MOTIONS = (
    "snu_ys2010/woody_walk_normal",
    "snu_cmu69/cmu69_02_walk",
    "ozz/pab_walk",
    "snu_vsports/cmu16_35_run",
    "mass/mass_run",
    "ozz/pab_run",
    "snu_ys2010/woody_broad_jump",
    "snu_ys2010/woody_vertical_jumps",
    "assimp/cmu01_01_forward_jumps",
    "snu_ys2010/woody_cancan_run",
    "mass/mass_dance",
    "snu_tcr/spar_kicks",
)
WOODY = "snu_ys2010/woody_walk_slow.bvh.gz"
LEG_WORDS = ("UpLeg", "Leg", "Foot", "Toes")


def resized(factor: float, legs: float = 1.0, trunk: float = 1.0) -> Skeleton:
    """Return a body of the woody family under other names, with other proportions."""
    own = load(FOLDER / WOODY).skeleton
    sizes = [legs if name.endswith(LEG_WORDS) else trunk for name in own.names]
    names = tuple("Belly" if name == "Spine" else name for name in own.names)
    factors = factor * np.array(sizes)[:, np.newaxis]
    return Skeleton(names, own.parents, factors * own.rest_offsets, factors * own.tip_offsets)


def performers(skinned: Skeleton) -> dict[str, tuple[Skeleton, str | None]]:
    """Return bodies, and the file that shows how each moves."""
    others = {
        "cmu16": "snu_vsports/cmu16_15_walk.bvh.gz",
        "pab": "ozz/pab_walk.bvh.gz",
        "cmu69": "snu_cmu69/cmu69_02_walk.bvh.gz",
    }
    bodies: dict[str, tuple[Skeleton, str | None]] = {
        "0.6": (resized(0.6), None),
        "1.6": (resized(1.6), None),
        "short legs": (resized(1.0, legs=0.75), None),
        "long legs": (resized(1.0, legs=1.3), None),
        "child": (resized(0.6, legs=0.8, trunk=1.1), None),
        "robot": (body(ROBOT), None),
        "deepmimic": (load(FOLDER / "deepmimic/humanoid3d_walk.txt.gz").skeleton, None),
        "skinned": (skinned, None),
    }
    bodies |= {name: (load(FOLDER / file).skeleton, file) for name, file in others.items()}
    return bodies


@needs_clips
@pytest.mark.full
def test_motions_on_bodies_in_a_table(tmp_path: Path) -> None:
    save_gltf(ff.sample("walk")[0], tmp_path / "mannequin.glb")
    skinned = load_skinned(tmp_path / "mannequin.glb").skeleton
    heading = f"{'motion':24}{'body':11}{'drift':>7}{'sinks':>7}{'floats':>7}"
    heading += f"{'pops':>6}{'arms':>6}"
    print(f"\n{heading}   [mm, p95; pops over the source's by size; arms deeper than the source's]")
    rows: list[list[float]] = []
    for motion in MOTIONS:
        clip = load(FOLDER / f"{motion}.bvh.gz")
        anatomy = find_anatomy(clip.skeleton)
        supports = detect_supports(clip, anatomy)
        clip = clean_and_tell(clip, supports, anatomy).clip
        times = np.arange(clip.frames) / clip.fps
        carries = carrying(supports.supports_at(times))
        source = measure(clip_trace(clip, anatomy, supports))
        deep = arm_overlaps(clip.skeleton, anatomy, clip.world_poses()[1]).max()
        print(f"{motion.split('/')[1]:24}{'(source)':11}", end="")
        print(
            *(
                f"{one.overall.p95:7.1f}"
                for one in (source.drift, source.penetration, source.floating)
            )
        )
        for name, (performer, file) in performers(skinned).items():
            shown = None if file is None else load(FOLDER / file)
            found = map_clip(clip, performer, shown)
            result = retarget(clip, performer, found, carries)
            own = performer_anatomy(clip, found)
            told = measure(clip_trace(result, own, supports))
            assert told.pops is not None
            assert source.pops is not None
            pops = told.pops.acceleration_p999 / source.pops.acceleration_p999 / found.leg_ratio
            arms = 1e3 * (arm_overlaps(performer, own, result.world_poses()[1]).max() - deep)
            figures = [
                one.overall.p95 or 0.0 for one in (told.drift, told.penetration, told.floating)
            ]
            print(
                f"{'':24}{name:11}{figures[0]:7.1f}{figures[1]:7.1f}{figures[2]:7.1f}{pops:6.2f}{arms:6.0f}"
            )
            rows.append([*figures, pops, arms])
    table = np.array(rows)
    print(f"{'p95 of all rows':35}", np.percentile(table, 95.0, axis=0).round(2).tolist())
    print(f"{'median of all rows':35}", np.median(table, axis=0).round(2).tolist())
    met = table <= np.array([5.0, 5.0, 10.0, 2.0, 20.0])
    print(f"rows within the bounds, of {len(table)}: {met.sum(axis=0).tolist()}")
    assert np.isfinite(table).all()
    assert met.all()
