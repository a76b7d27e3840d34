"""A BVH file small enough to read, with everything in it that a body needs."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from footfall.geometry import from_euler
from footfall.motion import Clip
from footfall.skeleton import Skeleton

__all__ = ["BIPED", "biped_clip", "biped_text", "golden_changes"]

GOLDEN = Path(__file__).parent.parent / "golden" / "bvh"

BIPED = """HIERARCHY
ROOT Hips
{
	OFFSET 0 0 0
	CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
	JOINT Head
	{
		OFFSET 0 60 0
		CHANNELS 3 Zrotation Xrotation Yrotation
		End Site
		{
			OFFSET 0 20 0
		}
	}
	JOINT LeftUpLeg
	{
		OFFSET 10 -5 0
		CHANNELS 3 Zrotation Xrotation Yrotation
		JOINT LeftLeg
		{
			OFFSET 0 -40 0
			CHANNELS 3 Zrotation Xrotation Yrotation
			JOINT LeftFoot
			{
				OFFSET 0 -40 0
				End Site
				{
					OFFSET 0 -5 15
				}
			}
		}
	}
	JOINT RightUpLeg
	{
		OFFSET -10 -5 0
		CHANNELS 3 Zrotation Xrotation Yrotation
		JOINT RightLeg
		{
			OFFSET 0 -40 0
			CHANNELS 3 Zrotation Xrotation Yrotation
			JOINT RightFoot
			{
				OFFSET 0 -40 0
				End Site
				{
					OFFSET 0 -5 15
				}
			}
		}
	}
}
MOTION
Frames: 2
Frame Time: 0.0333333
0 90 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0
1 91 2 0 0 0 0 0 0 0 30 0 0 40 0 0 0 0 0 0 0
"""
"""Line 53 is ``Frames: 2``, 55 the first frame; 21 channels; legs of 80 cm."""


def biped_text(*changes: tuple[str, str], count: int = 1) -> str:
    """Return `BIPED` with the first `count` places of each text replaced by another."""
    text = BIPED
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new, count)
    return text


def golden_changes(name: str) -> list[tuple[str, ...]]:
    """Return what is replaced, by what, and the message, of each line of a golden file."""
    lines = (GOLDEN / name).read_text(encoding="utf-8").splitlines()
    cases = [line.split(" => ") for line in lines if not line.startswith("#")]
    assert all(len(case) == 3 for case in cases)
    return [tuple(text.replace("\\n", "\n").replace("\\t", "\t") for text in c) for c in cases]


def biped_clip(frames: int = 8, seed: int = 0) -> Clip:
    """Return a clip of random poses of a body with legs of 0.8 m, more or less upright."""
    random = np.random.default_rng(seed)
    names = ("Hips", "Head", "LeftUpLeg", "LeftLeg", "LeftFoot", "LeftToe")
    names += tuple(name.replace("Left", "Right") for name in names[2:])
    parents = np.array([-1, 0, 0, 2, 3, 4, 0, 6, 7, 8])
    leg = [[0.1, -0.05, 0.01], [0.0, -0.4, 0.0], [0.003, -0.4, 0.0], [0.0, -0.07, 0.14]]
    other = [[-x, y, z] for x, y, z in leg]
    tips = np.zeros((10, 3))
    tips[[1, 5]] = [[0.0, 0.2, 0.0], [0.0, 0.0, 0.05]]
    skeleton = Skeleton(
        names, parents, np.array([[0.0, 0.0, 0.0], [0.0, 0.6, 0.0], *leg, *other]), tips
    )
    angles = random.uniform(-0.5, 0.5, (frames, 10, 3))
    angles[:, 0, 2] = random.uniform(-math.pi, math.pi, frames)
    places = np.array([0.0, 0.9, 0.0]) + random.uniform(-0.2, 0.2, (frames, 3))
    return Clip(skeleton, places, from_euler("ZXY", angles), 30.0, name="biped")
