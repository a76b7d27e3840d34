"""The mannequin's legs with their feet, and its arms with their hands."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.geometry import conjugate, rotate
from footfall.io.body_plan import BodyPlan, Limb, Tone, across_axis, unit
from footfall.io.lofts import Loft, capsule
from footfall.skeleton import BodyPart, Leg

__all__ = ["arm_limbs", "leg_limbs"]

# Radii as shares of stature.
_HIP, _KNEE, _ANKLE = 0.047, 0.031, 0.021
_CLAVICLE, _SHOULDER, _ELBOW, _WRIST, _FINGER = 0.026, 0.030, 0.021, 0.015, 0.0052


def leg_limbs(plan: BodyPlan, toe_turns: Rotations) -> tuple[Limb, ...]:
    """Return thighs, shanks, feet and toes; `toe_turns` as in `mannequin`."""
    limbs: list[Limb] = []
    for leg, tone, foot_tone, toe_turn in zip(
        plan.anatomy.legs,
        (Tone.LEFT, Tone.RIGHT),
        (Tone.LEFT_FOOT, Tone.RIGHT_FOOT),
        toe_turns,
        strict=True,
    ):
        limbs += _tapered(plan, plan.path(leg.hip, leg.knee), tone, (_HIP, _KNEE))
        limbs += _tapered(plan, plan.path(leg.knee, leg.ankle), tone, (_KNEE, _ANKLE))
        limbs += _foot(plan, leg, foot_tone, toe_turn)
    return tuple(limbs)


def _tapered(
    plan: BodyPlan, joints: tuple[int, ...], tone: Tone, ends: tuple[float, float]
) -> list[Limb]:
    """Return capsules along a chain, from one share of stature to another."""
    lengths = [float(np.linalg.norm(plan.skeleton.rest_offsets[joint])) for joint in joints[1:]]
    walked = np.concatenate([[0.0], np.cumsum(lengths)])
    total = max(float(walked[-1]), 1e-9)
    radii = plan.stature * np.interp(walked / total, (0.0, 1.0), ends)
    radii = np.minimum(radii, 0.4 * total)
    return [
        Limb(one, tone, capsule(np.zeros(3), plan.skeleton.rest_offsets[other], *pair))
        for (one, other), pair in zip(pairwise(joints), pairwise(radii.tolist()), strict=True)
        if plan.visible(plan.skeleton.rest_offsets[other])
    ]


def _foot(plan: BodyPlan, leg: Leg, tone: Tone, toe_turn: Rotations) -> list[Limb]:
    """Return the foot from heel to ball, and the toes where they bend."""
    size = plan.stature
    bends = leg.toe.joint != leg.ankle
    ball = plan.rest[leg.toe.joint] - plan.rest[leg.ankle] + np.array(leg.toe.offset) * (not bends)
    shank = unit(plan.rest[leg.knee] - plan.rest[leg.ankle])
    if np.linalg.norm(ball) < 0.03 * size:
        ball = ball + 0.09 * size * plan.forward
    if float(unit(ball) @ shank) < -0.9:
        return [Limb(leg.ankle, tone, capsule(np.zeros(3), ball, 0.022 * size, 0.018 * size))]
    forward = across_axis(ball, shank)
    sole = float(np.clip(-ball @ shank + 0.012 * size, 0.035 * size, 0.075 * size))
    to_ball = float(ball @ forward)
    tip = float(np.clip(0.055 * size if bends else 0.0, 0.0, 0.6 * to_ball))
    frame = (forward, shank)
    limbs = [Limb(leg.ankle, tone, _sole(frame, (-0.032 * size, to_ball), sole, size))]
    if bends:
        end = 0.02 * size + tip
        drop = float(np.clip(sole + ball @ shank, 0.004 * size, 0.03 * size))
        toe_frame = (rotate(conjugate(toe_turn), forward), rotate(conjugate(toe_turn), shank))
        limbs.append(Limb(leg.toe.joint, tone, _toes(toe_frame, end, drop, size)))
    return limbs


def _sole(
    frame: tuple[Positions, Positions], ends: tuple[float, float], drop: float, size: float
) -> Loft:
    """Return a foot: round heel, arched instep, wide ball; `drop` [m] from ankle to sole."""
    forward, up = frame
    shares = np.array([0.0, 0.04, 0.15, 0.35, 0.6, 0.85, 0.97, 1.0])
    along = ends[0] + shares * (ends[1] + 0.016 * size - ends[0])
    middle = -drop + 0.013 * size
    tops = np.array([0.0, 0.5, 0.93, 1.0, 0.62, 0.34, 0.2, 0.0])
    wide = size * np.array([0.0, 0.013, 0.019, 0.019, 0.022, 0.026, 0.018, 0.0])
    above = tops * (drop - 0.002 * size)
    under = size * np.array([0.0, 0.009, 0.013, 0.013, 0.013, 0.013, 0.009, 0.0])
    centers = along[:, np.newaxis] * forward + middle * up
    return Loft(centers, np.cross(up, forward), up, np.stack([wide, above, under], axis=-1))


def _toes(frame: tuple[Positions, Positions], length: float, drop: float, size: float) -> Loft:
    """Return the toes from behind the ball joint, `drop` [m] above the sole, to their tips."""
    forward, up = frame
    shares = np.array([0.0, 0.15, 0.45, 0.8, 0.95, 1.0])
    along = -0.02 * size + shares * (length + 0.02 * size)
    middle = -drop + 0.009 * size
    wide = size * np.array([0.0, 0.019, 0.026, 0.023, 0.013, 0.0])
    above = size * np.array([0.0, 0.012, 0.012, 0.008, 0.006, 0.0])
    under = size * np.array([0.0, 0.009, 0.009, 0.009, 0.006, 0.0])
    centers = along[:, np.newaxis] * forward + middle * up
    return Loft(centers, np.cross(up, forward), up, np.stack([wide, above, under], axis=-1))


def arm_limbs(plan: BodyPlan) -> tuple[Limb, ...]:
    """Return shoulders, arms, hands and fingers; plain bones where no arm was recognized."""
    limbs: list[Limb] = []
    sides = zip(
        plan.anatomy.arms,
        (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM),
        (Tone.LEFT, Tone.RIGHT),
        strict=True,
    )
    for arm, part, tone in sides:
        if arm is None:
            limbs += _plain_arm(plan, part, tone)
            continue
        first = int(np.flatnonzero(plan.anatomy.parts == part)[0])
        above = plan.path(max(int(plan.skeleton.parents[first]), 0), arm.shoulder)
        limbs += _tapered(plan, above, Tone.BODY, (_CLAVICLE, _CLAVICLE))
        limbs += _tapered(plan, plan.path(arm.shoulder, arm.elbow), tone, (_SHOULDER, _ELBOW))
        limbs += _tapered(plan, plan.path(arm.elbow, arm.wrist), tone, (_ELBOW, _WRIST))
        limbs += _hand(plan, arm.wrist, tone)
    return tuple(limbs)


def _plain_arm(plan: BodyPlan, part: BodyPart, tone: Tone) -> list[Limb]:
    joints: list[int] = np.flatnonzero(plan.anatomy.parts == part).tolist()
    limbs: list[Limb] = []
    for joint in joints:
        limbs += _tapered(plan, (int(plan.skeleton.parents[joint]), joint), tone, (_WRIST, _WRIST))
    return limbs


def _hand(plan: BodyPlan, joint: int, tone: Tone) -> list[Limb]:
    """Return the palm, and thin fingers where the skeleton has them."""
    size, skeleton = plan.stature, plan.skeleton
    children = [child for child in skeleton.children(joint) if plan.visible(_offset(plan, child))]
    arm = _offset(plan, joint)
    reach = (
        np.mean([_offset(plan, child) for child in children], axis=0)
        if children
        else skeleton.tip_offsets[joint]
    )
    if not plan.visible(reach) or float(reach @ arm) <= 0.0:
        reach = unit(arm) if plan.visible(arm) else plan.left
    reach = unit(reach) * float(np.clip(np.linalg.norm(reach), 0.045 * size, 0.07 * size))
    spread = _offset(plan, children[-1]) - _offset(plan, children[0]) if children else plan.forward
    limbs = [Limb(joint, tone, _palm(reach, spread, size))]
    for parent in _below(plan, joint):
        ends = [_offset(plan, child) for child in skeleton.children(parent)]
        ends += [skeleton.tip_offsets[parent]]
        limbs += [
            Limb(parent, tone, capsule(np.zeros(3), end, _FINGER * size, 0.85 * _FINGER * size), 8)
            for end in ends
            if plan.visible(end)
        ]
    return limbs


def _palm(reach: Positions, spread: Positions, size: float) -> Loft:
    axis = unit(reach)
    across = across_axis(spread, axis)
    length = float(np.linalg.norm(reach)) + 0.008 * size
    shares = np.array([-0.12, -0.05, 0.2, 0.6, 0.92, 1.0])
    wide = size * np.array([0.0, 0.011, 0.018, 0.023, 0.018, 0.0])
    deep = size * np.array([0.0, 0.009, 0.010, 0.009, 0.006, 0.0])
    centers = (shares * length)[:, np.newaxis] * axis
    return Loft(centers, across, np.cross(axis, across), np.stack([wide, deep, deep], axis=-1))


def _below(plan: BodyPlan, joint: int) -> list[int]:
    found: list[int] = []
    for child in plan.skeleton.children(joint):
        found += [child, *_below(plan, child)]
    return found


def _offset(plan: BodyPlan, joint: int) -> Positions:
    return plan.skeleton.rest_offsets[joint]
