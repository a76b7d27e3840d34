"""Footprints on the ground of the 3D scene: where each foot came down, the latest ones kept."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from viser import BatchedMeshHandle, SceneApi

from footfall.adaptation import AnyGround, Platform, Terrain
from footfall.arrays import Floats, Positions
from footfall.geometry import from_yaw, multiply, rotate
from footfall.studio.crowd_figures import from_vertical
from footfall.studio.ground_shapes import frame_at

__all__ = ["Footprints"]

Heights = Callable[[Positions], Floats]

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
        self._time = 0.0
        # The plate that each is on, -1 where it is on none, and where in its frame.
        self._on = np.full((2, MOST), -1)
        self._own_places = np.zeros((2, MOST, 3))
        self._own_turns = self._turns.copy()

    def update(
        self, points: Positions, planted: tuple[bool, bool], heights: Heights, ground: AnyGround
    ) -> None:
        """Take one frame.

        Args:
            points: Heel and toe of each foot [m], shape (2, 2, 3).
            planted: Which feet carry.
            heights: Returns how high the ground is under points [m].
            ground: What they are on.
        """
        below = heights(points)
        for foot in range(2):
            if not planted[foot]:
                self._down[foot] = False
                continue
            heel, toe = points[foot]
            # A print shows the foot when it is flattest: until both ends are down it moves along.
            clearances = heel[1] - below[foot, 0], toe[1] - below[foot, 1]
            flat = abs(float(clearances[0] - clearances[1])) < 0.035
            if self._down[foot] and not flat:
                continue
            if not self._down[foot]:
                self._down[foot] = True
                self._count[foot] += 1
            self._write(foot, heel, toe, heights, ground)

    def ride(self, ground: AnyGround, time: float) -> None:
        """Let prints go with the plates that they are on, at a clock time [s]."""
        self._time = time
        plates = _plates(ground)
        for foot in range(2):
            on = self._on[foot] >= 0
            if not on.any():
                continue
            for slot in np.flatnonzero(on & (self._on[foot] < len(plates))).tolist():
                x, y, z, heading = frame_at(plates[int(self._on[foot, slot])], time)
                turn = from_yaw(heading)
                place = rotate(turn, self._own_places[foot, slot])
                self._places[foot, slot] = place + np.array([x, y, z])
                self._turns[foot, slot] = multiply(turn, self._own_turns[foot, slot])
            self._send(foot)

    def clear(self) -> None:
        """Forget all prints."""
        self._count, self._down = [0, 0], [False, False]
        self._sizes[:] = 0.0
        self._on[:] = -1
        for foot in range(2):
            self._send(foot)

    def show(self, visible: bool) -> None:
        """Show or hide them."""
        for node in self._nodes:
            node.visible = visible

    def _write(
        self, foot: int, heel: Floats, toe: Floats, heights: Heights, ground: AnyGround
    ) -> None:
        slot = (self._count[foot] - 1) % MOST
        way = toe - heel
        length = max(float(np.hypot(way[0], way[2])), 0.06)
        turn = from_yaw(np.arctan2(way[0], way[2]))
        # The print lies as the ground does: at its heel, ahead of it, and beside it.
        across = 0.04 * rotate(turn, np.array([1.0, 0.0, 0.0]))
        low, high, beside = heights(np.stack([heel, toe, heel + across]))
        normal = rotate(turn, np.array([(low - beside) / 0.04, 1.0, (low - high) / length]))
        if abs(normal[0]) + abs(normal[2]) > 1.5:
            normal = np.array([0.0, 1.0, 0.0])
        place = np.array([heel[0], low + ABOVE, heel[2]])
        if np.abs(place - self._places[foot, slot]).max() < 1e-4 and self._sizes[foot, slot].any():
            return
        tilt = from_vertical((normal / np.linalg.norm(normal))[np.newaxis])[0]
        self._places[foot, slot] = place
        self._turns[foot, slot] = multiply(tilt, turn)
        self._sizes[foot, slot] = length
        self._stick(foot, slot, ground, float(low))
        self._send(foot)

    def _stick(self, foot: int, slot: int, ground: AnyGround, height: float) -> None:
        """Find the plate that a print is on, if it is on one."""
        self._on[foot, slot] = -1
        for number, plate in enumerate(_plates(ground)):
            x, y, z, heading = frame_at(plate, self._time)
            own = rotate(from_yaw(-heading), self._places[foot, slot] - np.array([x, y, z]))
            inside = abs(own[0]) <= 0.5 * plate.size[0] and abs(own[2]) <= 0.5 * plate.size[1]
            if inside and abs(height - y) < 0.01:
                self._on[foot, slot] = number
                self._own_places[foot, slot] = own
                self._own_turns[foot, slot] = multiply(from_yaw(-heading), self._turns[foot, slot])

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


def _plates(ground: AnyGround) -> list[Platform]:
    parts = ground.parts if isinstance(ground, Terrain) else (ground,)
    return [part for part in parts if isinstance(part, Platform)]
