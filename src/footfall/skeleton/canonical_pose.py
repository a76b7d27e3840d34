"""One pose that every body can be put in: upright, arms out to the sides, feet flat and ahead.

Files orient joint frames anyhow, and their rest poses stand, hang, lie or fold. In a pose that
means the same on every body the frames can be compared: what turns one body's joint from there
turns the other's. The body faces +z, its left is +x, arms are level (a T).

* Bones are brought to their directions the short way from where they are at rest; limbs that are
  folded back at rest are first swung out sideways, so that the front stays the front.
* The twist of a limb follows its hinge, where a motion has shown it: knees fold backward, elbows
  forward. A rest pose of straight limbs does not tell.
* A clavicle that is astray at rest has its top where a motion has the trunk's up in its frame.
* Feet stand on their soles, as seen in a motion, or else as they stand at rest.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from footfall.arrays import Floats, Positions, Rotations
from footfall.geometry import conjugate, from_matrix, multiply, rotate
from footfall.skeleton.landmarks import Landmarks, rest_positions
from footfall.skeleton.skeleton import Skeleton
from footfall.skeleton.turns import across, frame_turn, unfolding

__all__ = ["LimbAttitudes", "canonical_rotations", "rest_axes"]

LEFT, UP, AHEAD = np.eye(3)

SNAP = np.cos(np.radians(30.0))
"""Rest poses are drawn along axes: a body's own axes are these, if it is within 30° of them."""

ASTRAY = np.cos(np.radians(60.0))
"""A clavicle, or toes, farther than this from their direction are not in a natural pose; nor is
a clavicle whose top, as seen in a motion, is farther than this from up."""

STANDING = np.cos(np.radians(50.0))
"""A rest pose whose shanks point down up to this angle stands on its feet."""

_SHORTEST = 1e-6


@dataclass(frozen=True, eq=False)
class LimbAttitudes:
    """What a motion has shown about a body's limbs; zeros where it has shown nothing."""

    hinge_axes: Floats = field(default_factory=lambda: np.zeros((2, 2, 2, 3)))
    """Unit normal of the plane in which a limb bends, upper bone × lower bone, in the frames of
    its upper and of its middle joint; arms then legs, left then right. Shape (2, 2, 2, 3)."""

    sole_directions: Floats = field(default_factory=lambda: np.zeros((2, 3)))
    """Unit vector straight down in the frame of each ankle while the foot is flat, (2, 3)."""

    toe_turns: Rotations = field(default_factory=lambda: np.zeros((2, 4)))
    """The toe joint relative to the ankle while the foot is flat, shape (2, 4)."""

    clavicle_ups: Floats = field(default_factory=lambda: np.zeros((2, 3)))
    """Unit vector up the trunk in the frame of each clavicle, in the mean, shape (2, 3)."""


def canonical_rotations(
    skeleton: Skeleton, landmarks: Landmarks, attitudes: LimbAttitudes | None = None
) -> Rotations:
    """Return the rotation of each joint in the canonical pose.

    Args:
        skeleton: The body.
        landmarks: What its joints are.
        attitudes: What a motion has shown of its hinges and soles; None: only rest is known.

    Returns:
        World rotations, shape (joints, 4).
    """
    pose = _Pose(skeleton, landmarks, attitudes or LimbAttitudes())
    anatomy = landmarks.anatomy
    for side in range(2):
        sideways = LEFT if side == 0 else -LEFT
        arm = anatomy.arms[side]
        if arm is not None:
            clavicle = landmarks.clavicles[side]
            if clavicle is not None:
                up = pose.attitudes.clavicle_ups[side]
                pose.straighten(clavicle, arm.shoulder, sideways, up)
            bend = -UP if side == 0 else UP
            hinge = pose.attitudes.hinge_axes[0, side]
            pose.point(arm.shoulder, arm.elbow, sideways, hinge[0], bend)
            pose.point(arm.elbow, arm.wrist, sideways, hinge[1], bend)
        leg = anatomy.legs[side]
        hinge = pose.attitudes.hinge_axes[1, side]
        pose.point(leg.hip, leg.knee, -UP, hinge[0], LEFT)
        pose.point(leg.knee, leg.ankle, -UP, hinge[1], LEFT)
        pose.stand(side)
    return pose.settled()


def rest_axes(skeleton: Skeleton, landmarks: Landmarks) -> Rotations:
    """Return the rotation that takes a body at rest to +x on its left, +y up, facing +z, (4,)."""
    places = rest_positions(skeleton)
    anatomy = landmarks.anatomy
    hips = [places[leg.hip] for leg in anatomy.legs]
    sideways = hips[0] - hips[1]
    middle = 0.5 * (hips[0] + hips[1])
    shoulders = [places[arm.shoulder] for arm in anatomy.arms if arm is not None]
    if len(shoulders) == 2:
        between = shoulders[0] - shoulders[1]
        # Clavicles that are astray at rest say nothing of where left is.
        sideways = sideways + between if _agree(sideways, between) else sideways
        top = 0.5 * (shoulders[0] + shoulders[1])
    else:
        top = places[landmarks.head if landmarks.head is not None else landmarks.chest]
    left = _snapped(sideways, LEFT)
    up = _snapped(top - middle, UP)
    up = up - float(up @ left) * left
    if np.linalg.norm(up) < 0.1:
        up = UP - float(left @ UP) * left if abs(float(left @ UP)) < 0.9 else AHEAD
    up = up / np.linalg.norm(up)
    return from_matrix(np.stack([left, up, np.cross(left, up)]))


def _agree(hips: Positions, shoulders: Positions) -> bool:
    """Return whether hips and shoulders of a rest pose lie alike: some fold one clavicle."""
    size = float(np.linalg.norm(hips)) * float(np.linalg.norm(shoulders))
    return size < _SHORTEST**2 or float(hips @ shoulders) > SNAP * size


def _snapped(vector: Positions, otherwise: Positions) -> Positions:
    """Return the unit vector along the axis that a vector nearly has, or else along itself."""
    length = float(np.linalg.norm(vector))
    if length < _SHORTEST:
        return otherwise
    vector = vector / length
    axis = int(np.abs(vector).argmax())
    if abs(vector[axis]) < SNAP:
        return vector
    snapped = np.zeros(3)
    snapped[axis] = np.sign(vector[axis])
    return snapped


class _Pose:
    """The canonical pose as it is being built: landmarks are turned, all else follows."""

    def __init__(self, skeleton: Skeleton, landmarks: Landmarks, attitudes: LimbAttitudes) -> None:
        self.skeleton = skeleton
        self.landmarks = landmarks
        self.attitudes = attitudes
        self.upright = rest_axes(skeleton, landmarks)
        self.places = rest_positions(skeleton)
        self.turned: dict[int, Rotations] = {}

    def settled(self) -> Rotations:
        """Return the rotation of every joint: its own, or its parent's."""
        return np.stack([self.of(joint) for joint in range(self.skeleton.count)])

    def of(self, joint: int) -> Rotations:
        """Return how a joint is turned so far."""
        while joint >= 0:
            if joint in self.turned:
                return self.turned[joint]
            joint = int(self.skeleton.parents[joint])
        return self.upright

    def point(
        self, joint: int, end: int, goal: Positions, hinge: Positions, axis: Positions
    ) -> None:
        """Turn a bone to its direction, its hinge to its axis."""
        bone = self.places[end] - self.places[joint]
        axle = across(hinge, bone)
        if np.linalg.norm(bone) < _SHORTEST:
            return
        if np.linalg.norm(axle) > 0.5:
            self.turned[joint] = frame_turn(bone, axle, goal, axis)
            return
        now = self.of(joint)
        self.turned[joint] = multiply(unfolding(rotate(now, bone), goal), now)

    def straighten(self, joint: int, end: int, goal: Positions, up: Positions) -> None:
        """Turn a bone to its direction, its top up, where it is far from that; else as at rest."""
        bone = self.places[end] - self.places[joint]
        length = float(np.linalg.norm(bone))
        if length < _SHORTEST:
            return
        now = self.of(joint)
        if float(rotate(now, bone) @ goal) < ASTRAY * length:
            self.point(joint, end, goal, up, UP)
        elif up.any() and float(rotate(now, up) @ UP) < ASTRAY:
            kept = rotate(now, bone) / length
            above = across(UP, kept)
            if above.any():
                self.point(joint, end, kept, up, above)

    def stand(self, side: int) -> None:
        """Turn a foot so that its sole is on the ground and points ahead, its toes level."""
        leg, toe = self.landmarks.anatomy.legs[side], self.landmarks.toes[side]
        down = self.attitudes.sole_directions[side]
        shank = self.places[leg.ankle] - self.places[leg.knee]
        length = float(np.linalg.norm(shank))
        if not down.any():
            down = rotate(conjugate(self.upright), -UP)
            if length > _SHORTEST and float(down @ shank) < STANDING * length:
                down = shank / length
        tip = self.places[leg.toe.joint] - self.places[leg.ankle] + np.array(leg.toe.offset)
        fore = across(tip, down)
        if np.linalg.norm(fore) < 0.2:
            fore = across(rotate(conjugate(self.of(leg.ankle)), AHEAD), down)
        if np.linalg.norm(fore) < _SHORTEST:
            return
        self.turned[leg.ankle] = frame_turn(down, fore, -UP, AHEAD)
        if toe is not None:
            self._level_toe(side, toe, leg.ankle)

    def _level_toe(self, side: int, toe: int, ankle: int) -> None:
        turn = self.attitudes.toe_turns[side]
        if turn.any():
            self.turned[toe] = multiply(self.turned[ankle], turn)
            return
        children = self.skeleton.children(toe)
        tip = self.skeleton.rest_offsets[children[0]] if children else None
        tip = self.skeleton.tip_offsets[toe] if tip is None or not tip.any() else tip
        length = float(np.linalg.norm(tip))
        now = self.turned[ankle]
        if length > _SHORTEST and float(rotate(now, tip) @ AHEAD) < ASTRAY * length:
            self.turned[toe] = multiply(unfolding(rotate(now, tip), AHEAD), now)
