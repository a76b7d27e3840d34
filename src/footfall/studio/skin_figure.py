"""A body in its own skin in the 3D scene; the browser bends the skin, the studio sends joints."""

from __future__ import annotations

import numpy as np
from viser import MeshSkinnedHandle, SceneApi

from footfall.arrays import Floats, Indices, Positions, Rotations
from footfall.io import SkinnedBody
from footfall.skeleton.landmarks import rest_positions

__all__ = ["SkinFigure"]

MOST_COLORS = 8
"""Pieces of a skin that are drawn in colors of their own."""

GHOST = (232, 237, 243)


class SkinFigure:
    """The skin of one character."""

    def __init__(
        self, scene: SceneApi, name: str, body: SkinnedBody, ghostly: bool = False
    ) -> None:
        """Put a skin into the scene.

        Args:
            scene: Where it stands.
            name: Of the scene node that it hangs under.
            body: The character.
            ghostly: Whether it is pale, and casts no shadow.
        """
        self.root = scene.add_frame(name, show_axes=False)
        places = rest_positions(body.skeleton)
        still = np.tile([1.0, 0.0, 0.0, 0.0], (1, body.skeleton.count, 1))
        vertices = body.vertices(still, places[np.newaxis])[0]
        self._pieces: list[tuple[MeshSkinnedHandle, Indices]] = []
        for number, (color, triangles) in enumerate(_by_color(body)):
            used, faces = np.unique(triangles, return_inverse=True)
            weights = _dense_weights(body, used)
            # Joints that move nothing are not sent.
            moving = np.flatnonzero(weights.any(axis=0))
            node = scene.add_mesh_skinned(
                f"{name}/piece_{number}",
                vertices[used].astype(np.float32),
                faces.reshape(-1, 3),
                bone_wxyzs=still[0, moving],
                bone_positions=places[moving],
                skin_weights=weights[:, moving],
                color=GHOST if ghostly else color,
                side="double",
                cast_shadow=not ghostly,
                receive_shadow=False,
            )
            self._pieces.append((node, moving))

    def pose(self, positions: Positions, rotations: Rotations) -> None:
        """Move it: joints in the world [m], (joints, 3), and their rotations, (joints, 4)."""
        for node, moving in self._pieces:
            for bone, joint in zip(node.bones, moving.tolist(), strict=True):
                bone.position = positions[joint]
                bone.wxyz = rotations[joint]

    def plant(self, left: bool, right: bool) -> None:
        """Leave the skin as it is, whatever carries."""
        del left, right

    def remove(self) -> None:
        """Take it out of sight: where a skin leaves the scene, the library's page breaks."""
        self.root.visible = False


def _by_color(body: SkinnedBody) -> list[tuple[tuple[int, int, int], Indices]]:
    """Return the triangles of each color, the rarest ones taken into the last."""
    colors = body.colors[body.triangles[:, 0]]
    known, index, counts = np.unique(
        np.round(colors, 3), axis=0, return_inverse=True, return_counts=True
    )
    index = index.reshape(-1)
    ranked = np.argsort(-counts)
    place = np.empty(len(ranked), dtype=np.int64)
    place[ranked] = np.minimum(np.arange(len(ranked)), MOST_COLORS - 1)
    pieces = place[index]
    return [
        (_screen(known[ranked[piece]]), body.triangles[pieces == piece])
        for piece in range(min(len(ranked), MOST_COLORS))
    ]


def _screen(linear: Floats) -> tuple[int, int, int]:
    """Return a linear color as screens have it, 0 to 255."""
    bent = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)
    red, green, blue = np.round(255.0 * np.clip(bent, 0.0, 1.0)).astype(int).tolist()
    return red, green, blue


def _dense_weights(body: SkinnedBody, used: Indices) -> Floats:
    """Return the share of each joint in each of some vertices, shape (vertices, joints)."""
    weights = np.zeros((len(used), body.skeleton.count))
    rows = np.repeat(np.arange(len(used)), body.joints.shape[1])
    np.add.at(weights, (rows, body.joints[used].reshape(-1)), body.weights[used].reshape(-1))
    return weights
