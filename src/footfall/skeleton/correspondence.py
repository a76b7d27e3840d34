"""Which joint of one body drives which joint of another, found from names and geometry."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.errors import SkeletonError
from footfall.geometry import rotate
from footfall.skeleton.anatomy import Anatomy, arm_length, leg_length
from footfall.skeleton.anatomy_search import find_anatomy
from footfall.skeleton.body_map import BodyMap, Drive, solve_turns
from footfall.skeleton.canonical_pose import LimbAttitudes, canonical_rotations
from footfall.skeleton.joint_drives import all_drives, landmark_drives, same_drives
from footfall.skeleton.landmarks import find_landmarks, rest_positions
from footfall.skeleton.skeleton import Skeleton

__all__ = ["Correction", "map_body"]

Correction = tuple[str, str, float]
"""A correction of one joint: two reference joints, and how far from one to the other it is."""


def map_body(
    reference: Skeleton,
    body: Skeleton,
    *,
    reference_attitudes: LimbAttitudes | None = None,
    body_attitudes: LimbAttitudes | None = None,
    corrections: Mapping[str, Correction | None] | None = None,
) -> BodyMap:
    """Find what drives each joint of a body.

    Args:
        reference: The body that leads.
        body: The body that follows.
        reference_attitudes: What a motion has shown of the reference's hinges and soles.
        body_attitudes: The same of the body.
        corrections: Joints of the body that are driven otherwise than is found; None leaves a
            joint at rest, relative to its parent.

    Raises:
        SkeletonError: If either body has no two legs, or a correction names a joint that is not
            there; the message says which body and what was looked for.
    """
    anatomies = _anatomy(reference, "reference"), _anatomy(body, "followed")
    marks = find_landmarks(reference, anatomies[0]), find_landmarks(body, anatomies[1])
    alike = reference.same_family(body)
    found = same_drives(reference, body) if alike else landmark_drives(reference, body, *marks)
    _correct(found, reference, body, corrections or {})
    canonical = (
        canonical_rotations(reference, marks[0], reference_attitudes),
        canonical_rotations(body, marks[1], body_attitudes),
    )
    drives = all_drives(body, found, marks[0].pelvis)
    sources = np.array([[drive.one, drive.other] for drive in drives], dtype=np.int64)
    own = canonical[0][reference.order_of(body)] if alike else canonical[1]
    ratio = _leg_ratio(reference, body, *anatomies)
    return BodyMap(
        reference=reference,
        body=body,
        sources=sources,
        fractions=np.array([drive.fraction for drive in drives]),
        turns=solve_turns(sources, canonical[0], own),
        reference_hips=_hip_middle(reference, anatomies[0]),
        body_hips=_hip_middle(body, anatomies[1]),
        leg_ratio=ratio,
        arm_ratios=_arm_ratios(reference, body, *anatomies, ratio),
        ankle_lift=_ankle_height(body, anatomies[1], canonical[1])
        - ratio * _ankle_height(reference, anatomies[0], canonical[0]),
        reasons=tuple(
            _sentence(reference, name, drive)
            for name, drive in zip(body.names, drives, strict=True)
        ),
    )


def _anatomy(skeleton: Skeleton, which: str) -> Anatomy:
    try:
        return find_anatomy(skeleton)
    except SkeletonError as error:
        raise SkeletonError(
            f"no map between the two bodies: the {which} one has {error}"
        ) from error


def _correct(
    found: dict[int, Drive],
    reference: Skeleton,
    body: Skeleton,
    corrections: Mapping[str, Correction | None],
) -> None:
    """Write the corrections into the drives that were found."""
    for name, correction in corrections.items():
        if name not in body.names:
            raise SkeletonError(
                f"the map names {name!r}, which is no joint of the body that follows"
            )
        joint = body.index(name)
        if correction is None:
            found.pop(joint, None)
            continue
        one, other, fraction = correction
        for source in (one, other):
            if source not in reference.names:
                raise SkeletonError(
                    f"the map drives {name!r} by {source!r}, no joint of the reference body"
                )
        if not 0.0 <= fraction <= 1.0:
            raise SkeletonError(
                f"the map drives {name!r} at a fraction of {fraction:g}; it must be within 0..1"
            )
        found[joint] = Drive(
            reference.index(one), reference.index(other), fraction, "as the map file says"
        )


def _hip_middle(skeleton: Skeleton, anatomy: Anatomy) -> Positions:
    places = rest_positions(skeleton)
    return 0.5 * (places[anatomy.left.hip] + places[anatomy.right.hip])


def _leg_ratio(reference: Skeleton, body: Skeleton, theirs: Anatomy, own: Anatomy) -> float:
    lengths = [
        sum(leg_length(skeleton, leg) for leg in anatomy.legs)
        for skeleton, anatomy in ((reference, theirs), (body, own))
    ]
    for length, which in zip(lengths, ("reference", "followed"), strict=True):
        if length < 1e-6:
            raise SkeletonError(
                f"no map between the two bodies: the legs of the {which} one have no length"
            )
    return lengths[1] / lengths[0]


def _arm_ratios(
    reference: Skeleton, body: Skeleton, theirs: Anatomy, own: Anatomy, otherwise: float
) -> tuple[float, float]:
    ratios: list[float] = []
    for source, arm in zip(theirs.arms, own.arms, strict=True):
        length = 0.0 if source is None else arm_length(reference, source)
        known = arm is not None and length > 1e-6
        ratios.append(arm_length(body, arm) / length if known and arm is not None else otherwise)
    return ratios[0], ratios[1]


def _ankle_height(skeleton: Skeleton, anatomy: Anatomy, canonical: Rotations) -> float:
    """Return how high the ankles are over the toe joints of flat feet, on average [m]."""
    heights: list[float] = []
    for leg in anatomy.legs:
        toe = np.array(leg.toe.offset)
        joint = leg.toe.joint
        while joint != leg.ankle:
            toe = toe + skeleton.rest_offsets[joint]
            joint = int(skeleton.parents[joint])
        heights.append(-float(rotate(canonical[leg.ankle], toe)[1]))
    return float(np.mean(heights))


def _sentence(reference: Skeleton, name: str, drive: Drive) -> str:
    one, other = reference.names[drive.one], reference.names[drive.other]
    by = f"{one!r}" if drive.one == drive.other else f"{one!r} to {other!r} at {drive.fraction:.2f}"
    return f"{name}: driven by {by} ({drive.reason})"
