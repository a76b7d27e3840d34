"""What a motion shows of a body that its rest pose does not: hinges, clavicles and flat soles.

Knees and elbows bend in one plane, whichever way the frames of their joints are turned. Feet are
flat where their ankles are lowest.
"""

from __future__ import annotations

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import blend_rotations, conjugate, multiply, rotate
from footfall.motion.clip import Clip
from footfall.motion.soles import flat_frames
from footfall.skeleton import Anatomy, Arm, Leg
from footfall.skeleton.canonical_pose import LimbAttitudes
from footfall.skeleton.landmarks import Landmarks, find_landmarks

__all__ = ["observe_attitudes"]

LEAST_BEND = 0.15
"""Root mean square bend (sine of the angle between the bones) that shows a hinge."""

LEAST_AGREEMENT = 0.85
"""Length of the mean of unit vectors above which they agree: within about 32°."""


def observe_attitudes(clip: Clip, anatomy: Anatomy) -> LimbAttitudes:
    """Return what a motion shows of hinges, clavicles and soles.

    Args:
        clip: The motion.
        anatomy: What its joints are.
    """
    rotations, positions = clip.world_poses()
    hinges, soles, toes = np.zeros((2, 2, 2, 3)), np.zeros((2, 3)), np.zeros((2, 4))
    landmarks = find_landmarks(clip.skeleton, anatomy)
    ups = np.zeros((2, 3))
    for side in range(2):
        clavicle = landmarks.clavicles[side]
        if clavicle is not None:
            ups[side] = _up_in(clavicle, landmarks, positions, rotations)
        arm, leg = anatomy.arms[side], anatomy.legs[side]
        if arm is not None:
            hinges[0, side] = _hinge(_arm_joints(arm), rotations, positions)
        hinges[1, side] = _hinge((leg.hip, leg.knee, leg.ankle), rotations, positions)
        soles[side], toes[side] = _flat_foot(leg, rotations, positions)
    return LimbAttitudes(hinges, soles, toes, ups)


def _up_in(
    joint: int, landmarks: Landmarks, positions: Positions, rotations: Rotations
) -> Positions:
    """Return the mean direction up the trunk in a joint's frame; zeros where it has none."""
    arms = [arm.shoulder for arm in landmarks.anatomy.arms if arm is not None]
    ups = _unit(positions[:, arms].mean(axis=1) - positions[:, landmarks.pelvis])
    mean = rotate(conjugate(rotations[:, joint]), ups).mean(axis=0)
    size = float(np.linalg.norm(mean))
    return mean / size if size >= LEAST_AGREEMENT else np.zeros(3)


def _arm_joints(arm: Arm) -> tuple[int, int, int]:
    return (arm.shoulder, arm.elbow, arm.wrist)


def _hinge(limb: tuple[int, int, int], rotations: Rotations, positions: Positions) -> Floats:
    """Return the bending axis in the frames of the upper and the middle joint, (2, 3)."""
    start, middle, end = limb
    upper = _unit(positions[:, middle] - positions[:, start])
    lower = _unit(positions[:, end] - positions[:, middle])
    normals = np.cross(upper, lower)
    bends = np.linalg.norm(normals, axis=-1)
    if np.sqrt((bends**2).mean()) < LEAST_BEND:
        return np.zeros((2, 3))
    weights = bends[:, np.newaxis]
    found = np.zeros((2, 3))
    for row, joint in enumerate((start, middle)):
        own = rotate(conjugate(rotations[:, joint]), normals)
        mean = (weights * own).sum(axis=0) / (bends**2).sum()
        size = float(np.linalg.norm(mean))
        if size < LEAST_AGREEMENT:
            return np.zeros((2, 3))
        found[row] = mean / size
    return found


def _unit(vectors: Positions) -> Positions:
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9)


def _flat_foot(leg: Leg, rotations: Rotations, positions: Positions) -> tuple[Floats, Rotations]:
    """Return straight down in the ankle's frame, and the toes' turn, while a foot is flat."""
    unknown = np.zeros(3), np.zeros(4)
    flat = flat_frames(leg, positions)
    if not flat.any():
        return unknown
    down = rotate(conjugate(rotations[flat, leg.ankle]), np.array([0.0, -1.0, 0.0]))
    mean = np.median(down, axis=0)
    agreement = float(np.linalg.norm(down.mean(axis=0)))
    if agreement < LEAST_AGREEMENT:
        return unknown
    turns = multiply(conjugate(rotations[flat, leg.ankle]), rotations[flat, leg.toe.joint])
    turn = blend_rotations(turns, np.full(len(turns), 1.0 / len(turns)))
    return mean / np.linalg.norm(mean), turn
