"""The mannequin's head."""

from __future__ import annotations

from footfall.io.body_plan import BodyPlan, Limb, Tone, across_axis
from footfall.io.lofts import ellipsoid

__all__ = ["head_limbs"]


def head_limbs(plan: BodyPlan) -> tuple[Limb, ...]:
    """Return a head with a face that tells where it looks."""
    head = plan.skull
    if head is None:
        return ()
    size = plan.stature
    up = across_axis(plan.up, plan.left)
    center = 0.062 * size * up + 0.014 * size * plan.forward
    skull = ellipsoid(center, plan.left, up, (0.044 * size, 0.066 * size, 0.054 * size))
    face_center = center + 0.036 * size * plan.forward - 0.002 * size * up
    face = ellipsoid(face_center, plan.left, up, (0.031 * size, 0.022 * size, 0.024 * size))
    return Limb(head, Tone.BODY, skull, 24), Limb(head, Tone.FACE, face)
