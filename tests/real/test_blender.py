"""Blender opens what we write, and has the joints where we have them."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from footfall.io import load, save

CLIP = Path(__file__).parents[3] / "shared" / "motions" / "snu_ys2010" / "woody_kick.bvh.gz"
BLENDER = os.environ.get("FOOTFALL_BLENDER", "")


@pytest.mark.full
@pytest.mark.skipif(not CLIP.exists(), reason="no ../shared/motions")
@pytest.mark.skipif(not BLENDER, reason="FOOTFALL_BLENDER names no Python that has bpy")
@pytest.mark.parametrize("name", ["kick.bvh", "kick.glb"])
def test_blender_has_the_joints_within_a_millimeter(tmp_path: Path, name: str) -> None:
    clip = load(CLIP)
    save(clip, tmp_path / name)
    script = Path(__file__).parents[2] / "benchmarks" / "blender_joints.py"
    out = tmp_path / "out.json"
    subprocess.run(
        [BLENDER, str(script), str(tmp_path / name), str(out)], check=True, capture_output=True
    )
    positions = clip.world_poses()[1]
    compared = 0
    for frame, joints in json.loads(out.read_text()).items():
        for joint in clip.skeleton.names:
            # A BVH's end sites and a GLB's leaf joints may be bones' tails there.
            if joint in joints:
                there = positions[int(frame), clip.skeleton.index(joint)]
                assert np.linalg.norm(there - joints[joint]) < 1e-3
                compared += 1
    assert compared >= 3 * (clip.skeleton.count - 6)
