"""Footprints on the ground of the 3D scene: where each foot came down, the latest ones kept."""

from __future__ import annotations

import numpy as np
from viser import BatchedMeshHandle, SceneApi

from footfall.arrays import Floats, Positions
from footfall.geometry import from_yaw

__all__ = ["Footprints"]

MOST = 40
"""Prints of each foot that are kept."""

SOLE = np.array(
    [[-0.27, 0.10], [-0.22, 0.21], [-0.1, 0.28], [0.1, 0.29], [0.45, 0.26], [0.7, 0.32],
     [0.95, 0.39], [1.15, 0.39], [1.3, 0.31], [1.41, 0.16]]
)  # fmt: skip
"""Outline of a shoe: along from heel (0) to toe (1), half-width; in lengths from heel to toe."""

COLORS = ((34, 116, 184), (214, 118, 14))

ABOVE = 0.012
"""Height over the ground, so that prints are seen [m]."""


class Footprints:
    """The prints of both feet."""

    def __init__(self, scene: SceneApi, name: str) -> None:
        """Begin on clean ground."""
        self._nodes = [_soles(scene, f"{name}/{foot}", foot) for foot in range(2)]
        self._count = [0, 0]
        self._down = [False, False]
        self._places = np.zeros((2, MOST, 3))
        self._turns = np.tile([1.0, 0.0, 0.0, 0.0], (2, MOST, 1))
        self._sizes = np.zeros((2, MOST, 3))

    def update(self, points: Positions, planted: tuple[bool, bool], ground: float) -> None:
        """Take one frame: heel and toe of each foot [m], (2, 2, 3), and which feet carry."""
        for foot in range(2):
            if not planted[foot]:
                self._down[foot] = False
                continue
            heel, toe = points[foot]
            # A print shows the foot when it is flattest: until both ends are down it moves along.
            flat = abs(float(heel[1] - toe[1])) < 0.035
            if self._down[foot] and not flat:
                continue
            if not self._down[foot]:
                self._down[foot] = True
                self._count[foot] += 1
            self._write(foot, heel, toe, ground)

    def clear(self) -> None:
        """Forget all prints."""
        self._count, self._down = [0, 0], [False, False]
        self._sizes[:] = 0.0
        for foot in range(2):
            self._send(foot)

    def show(self, visible: bool) -> None:
        """Show or hide them."""
        for node in self._nodes:
            node.visible = visible

    def _write(self, foot: int, heel: Floats, toe: Floats, ground: float) -> None:
        slot = (self._count[foot] - 1) % MOST
        way = toe - heel
        length = max(float(np.hypot(way[0], way[2])), 0.06)
        place = np.array([heel[0], ground + ABOVE, heel[2]])
        if np.abs(place - self._places[foot, slot]).max() < 1e-4 and self._sizes[foot, slot].any():
            return
        self._places[foot, slot] = place
        self._turns[foot, slot] = from_yaw(np.arctan2(way[0], way[2]))
        self._sizes[foot, slot] = length
        self._send(foot)

    def _send(self, foot: int) -> None:
        node = self._nodes[foot]
        node.batched_positions = self._places[foot].astype(np.float32)
        node.batched_wxyzs = self._turns[foot].astype(np.float32)
        node.batched_scales = self._sizes[foot].astype(np.float32)


def _soles(scene: SceneApi, name: str, foot: int) -> BatchedMeshHandle:
    right = np.stack([SOLE[:, 1], np.zeros(len(SOLE)), SOLE[:, 0]], axis=-1)
    vertices = np.concatenate([right, right * [-1.0, 1.0, 1.0]])
    count = len(SOLE)
    faces = [
        triangle
        for i in range(count - 1)
        for triangle in ([i, i + count, i + 1], [i + 1, i + count, i + count + 1])
    ]
    return scene.add_batched_meshes_simple(
        name,
        vertices.astype(np.float32),
        np.array(faces),
        batched_wxyzs=np.tile([1.0, 0.0, 0.0, 0.0], (MOST, 1)),
        batched_positions=np.zeros((MOST, 3)),
        batched_scales=np.zeros((MOST, 3)),
        batched_colors=COLORS[foot],
        side="double",
        lod="off",
        cast_shadow=False,
        receive_shadow=False,
    )
