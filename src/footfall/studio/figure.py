"""A body in the 3D scene: its mannequin, a node a limb; its torso bends in the browser."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from viser import MeshHandle, MeshSkinnedHandle, SceneApi

from footfall.arrays import Flags, Floats, Indices, Positions, Rotations
from footfall.io.mannequin import Mannequin, Tone, mannequin
from footfall.skeleton import Anatomy, Skeleton

__all__ = ["Figure", "between"]

COLORS = {
    Tone.BODY: (222, 217, 208),
    Tone.FACE: (58, 62, 70),
    Tone.LEFT: (132, 168, 196),
    Tone.RIGHT: (214, 167, 118),
    Tone.LEFT_FOOT: (74, 104, 128),
    Tone.RIGHT_FOOT: (136, 106, 76),
}
"""The right side warm, the left side cool, as in all pictures."""

PLANTED = {Tone.LEFT_FOOT: (59, 143, 208), Tone.RIGHT_FOOT: (230, 145, 42)}
"""Feet that are commanded to carry, in the colors of their supports."""

GHOST = (232, 237, 243)


@dataclass(eq=False)
class _Part:
    joint: int
    tone: Tone
    node: MeshHandle


class Figure:
    """A mannequin of one skeleton."""

    def __init__(
        self,
        scene: SceneApi,
        name: str,
        skeleton: Skeleton,
        anatomy: Anatomy,
        *,
        ghostly: bool = False,
    ) -> None:
        """Put a mannequin into the scene.

        Args:
            scene: Where it stands.
            name: Of the scene node that its limbs hang under.
            skeleton: Its body.
            anatomy: What the joints are.
            ghostly: Whether it is pale, and casts no shadow.
        """
        self.root = scene.add_frame(name, show_axes=False)
        self._planted: tuple[bool, bool] | None = None
        self._ghostly = ghostly
        surface = mannequin(skeleton, anatomy)
        self._torsos = _bent(scene, name, surface, ghostly)
        # Limbs share no vertex: a triangle's joint is that of its first one.
        joints: Indices = surface.joints[surface.triangles[:, 0]]
        joints = np.where(_bends(surface), -1, joints)
        self._parts: list[_Part] = []
        for joint in np.unique(joints[joints >= 0]).tolist():
            for tone in np.unique(surface.tones[joints == joint]).tolist():
                chosen = surface.triangles[(joints == joint) & (surface.tones == tone)]
                used, faces = np.unique(chosen, return_inverse=True)
                node = scene.add_mesh_simple(
                    f"{name}/limb_{joint}_{tone}",
                    surface.positions[used].astype(np.float32),
                    faces.reshape(-1, 3),
                    color=GHOST if ghostly else COLORS[Tone(tone)],
                    cast_shadow=not ghostly,
                    receive_shadow=False,
                )
                self._parts.append(_Part(joint, Tone(tone), node))

    def pose(self, positions: Positions, rotations: Rotations) -> None:
        """Move it: joints in the world [m], (joints, 3), and their rotations, (joints, 4)."""
        for part in self._parts:
            part.node.position = positions[part.joint]
            part.node.wxyz = rotations[part.joint]
        for node, moving in self._torsos:
            for bone, joint in zip(node.bones, moving.tolist(), strict=True):
                bone.position = positions[joint]
                bone.wxyz = rotations[joint]

    def plant(self, left: bool, right: bool) -> None:
        """Paint the feet that carry."""
        if self._ghostly or self._planted == (left, right):
            return
        self._planted = (left, right)
        for part in self._parts:
            if part.tone in PLANTED:
                carries = left if part.tone is Tone.LEFT_FOOT else right
                part.node.color = PLANTED[part.tone] if carries else COLORS[part.tone]

    def remove(self) -> None:
        """Take it out of the scene; where what bends leaves it, the library's page breaks."""
        self.root.visible = False
        for part in self._parts:
            part.node.remove()


def _bends(surface: Mannequin) -> Flags:
    """Return which triangles are of a limb that bends, shape (triangles,)."""
    shared = (surface.shares[surface.triangles] > 0.0).any(axis=1)
    bending = np.zeros(int(surface.limbs.max()) + 1, dtype=np.bool_)
    bending[surface.limbs[shared]] = True
    return bending[surface.limbs]


def _bent(
    scene: SceneApi, name: str, surface: Mannequin, ghostly: bool
) -> list[tuple[MeshSkinnedHandle, Indices]]:
    """Put what bends into the scene: each node, and the joints that bend it."""
    chosen = _bends(surface)
    if not chosen.any():
        return []
    used, faces = np.unique(surface.triangles[chosen], return_inverse=True)
    weights = np.zeros((len(used), len(surface.rest)))
    every = np.arange(len(used))
    np.add.at(weights, (every, surface.joints[used]), 1.0 - surface.shares[used])
    np.add.at(weights, (every, surface.others[used]), surface.shares[used])
    moving = np.flatnonzero(weights.any(axis=0))
    node = scene.add_mesh_skinned(
        f"{name}/torso",
        (surface.positions + surface.rest[surface.joints])[used].astype(np.float32),
        faces.reshape(-1, 3),
        bone_wxyzs=np.tile([1.0, 0.0, 0.0, 0.0], (len(moving), 1)),
        bone_positions=surface.rest[moving],
        skin_weights=weights[:, moving],
        color=GHOST if ghostly else COLORS[Tone.BODY],
        cast_shadow=not ghostly,
        receive_shadow=False,
    )
    return [(node, moving)]


def between(first: Floats, second: Floats, share: float) -> Floats:
    """Return values between those of two frames; of rotations the short way, not normalized."""
    if first.shape[-1] == 4:
        opposed = np.einsum("ji,ji->j", first, second) < 0.0
        second = np.where(opposed[:, np.newaxis], -second, second)
        mixed = (1.0 - share) * first + share * second
        return np.asarray(mixed / np.linalg.norm(mixed, axis=-1, keepdims=True))
    return (1.0 - share) * first + share * second
