"""What a joint's name says: which side it is on, and what it is.

Names come as ``Character1_LeftUpLeg``, ``mixamorig:LeftFoot``, ``Bip01 L Thigh``, ``lThigh``,
``lfemur``, ``thigh.L``, ``upperleg_r``, ``left_hip``. They are cut into words, the words that name
a side or a number are set aside, and the end of what remains is looked up: the end, since
prefixes name the rig, while suffixes (``Twist``, ``Dummy``, ``Nub``, ``RIGMESH``) make another,
helping joint of it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache

from footfall.skeleton.skeleton import Skeleton

__all__ = ["JointName", "Role", "read_joint_name", "read_joint_names"]


class Role(Enum):
    """What a joint is, as far as its name says; a joint is named by the bone below it."""

    THIGH = "hip"
    SHANK = "knee"
    FOOT = "ankle"
    TOE = "toe"
    UPPER_ARM = "shoulder"
    FOREARM = "elbow"
    HAND = "wrist"
    NECK = "neck"
    HEAD = "head"


@dataclass(frozen=True, slots=True)
class JointName:
    """What one name says."""

    side: int | None
    """0 for left, 1 for right, None where the name names no side."""

    role: Role | None
    """What the joint is, None where the name does not say."""

    words: tuple[str, ...]
    """The lower-case words without side and numbers: equal for the two joints of a pair."""


_WORDS: dict[Role, str] = {
    Role.THIGH: "upleg upperleg legupper thigh femur hip",
    Role.SHANK: "leg lowerleg lowleg leglower shin shank calf knee tibia",
    Role.FOOT: "foot ankle",
    Role.TOE: "toe toes toebase ball footthumb football bigtoe",
    Role.UPPER_ARM: "arm upperarm uparm armupper humerus shoulder shldr",
    Role.FOREARM: "forearm lowerarm lowarm armlower elbow radius",
    Role.HAND: "hand wrist palm",
    Role.NECK: "neck lowerneck upperneck",
    Role.HEAD: "head skull",
}
_ROLES = {word: role for role, words in _WORDS.items() for word in words.split()}
_SIDED_ONLY = {"thumb", "thumbs", "finger", "fingers", "clavicle", "collar", "shoulderjoint"}
_SIDES = {"left": 0, "l": 0, "right": 1, "r": 1}

_CONTROLS = {"ik", "fk", "ctrl", "control", "pole", "target", "mch", "vb"}
"""Words of joints that steer a rig and are no part of the body."""

_SPLIT = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")


def _cut_side(word: str) -> tuple[int | None, str]:
    """Return the side that a word begins with, and the rest of it: ``lfemur``, ``lefthand``."""
    for mark, side in _SIDES.items():
        rest = word[len(mark) :]
        if word.startswith(mark) and (len(mark) > 1 or rest in _ROLES or rest in _SIDED_ONLY):
            return side, rest
    return None, word


@lru_cache(maxsize=4096)
def read_joint_name(name: str) -> JointName:
    """Return what a joint's name says."""
    side: int | None = None
    words: list[str] = []
    for word in _SPLIT.findall(name.rsplit(":", 1)[-1]):
        word_side, rest = _SIDES.get(word.lower()), ""
        if word_side is None:
            word_side, rest = _cut_side(word.lower())
        if side is None:
            side = word_side
        if rest and not rest.isdigit():
            words.append(rest)
    role = None
    if not _CONTROLS.intersection(words):
        endings = ("".join(words[start:]) for start in range(len(words)))
        role = next((_ROLES[ending] for ending in endings if ending in _ROLES), None)
    return JointName(side, role, tuple(words))


def read_joint_names(skeleton: Skeleton) -> tuple[JointName, ...]:
    """Return what the name of each joint says."""
    return tuple(read_joint_name(name) for name in skeleton.names)
