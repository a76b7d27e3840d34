"""Priorities as a user writes them: one number, or numbers by body part."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from footfall.arrays import Floats
from footfall.errors import ArgumentError, UnknownNameError
from footfall.skeleton import BodyPart

__all__ = ["PART_NAMES", "parse_priority"]

PART_NAMES = {
    "legs": (BodyPart.LEGS,),
    "trunk": (BodyPart.TRUNK,),
    "head": (BodyPart.HEAD,),
    "arms": (BodyPart.LEFT_ARM, BodyPart.RIGHT_ARM),
    "left_arm": (BodyPart.LEFT_ARM,),
    "right_arm": (BodyPart.RIGHT_ARM,),
}
"""The body parts that each name stands for."""


def parse_priority(priority: float | Mapping[str, float]) -> Floats:
    """Return one priority a body part, shape (parts,).

    Args:
        priority: One number for the whole body, or numbers >= 0 for some of its parts by name:
            legs, trunk, head, arms, left_arm, right_arm. Parts that are not named get 0.

    Raises:
        ArgumentError: If a number is negative or not finite, or all are zero.
        UnknownNameError: If a part is unknown.
    """
    values = np.zeros(len(BodyPart))
    if isinstance(priority, Mapping):
        for name, number in priority.items():
            if name not in PART_NAMES:
                raise UnknownNameError("body part", name, PART_NAMES)
            values[list(PART_NAMES[name])] = number
    else:
        values[:] = priority
    if not (np.isfinite(values).all() and (values >= 0.0).all() and values.any()):
        raise ArgumentError(f"priority {priority}; it must be finite, >= 0 and not all zero")
    return values
