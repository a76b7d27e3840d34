"""The ground in the 3D scene: the plane with its grid, and what stands on it, as it is."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from viser import FrameHandle, LineSegmentsHandle, MeshHandle, SceneApi

from footfall.adaptation import AnyGround, BuiltGround, HeightField, Plane, Platform, Terrain
from footfall.arrays import Positions, Rotations
from footfall.geometry import from_yaw, multiply, rotate
from footfall.studio.crowd_figures import from_vertical
from footfall.studio.ground_shapes import Part, frame_at, shape_of

__all__ = ["GroundFigures"]

PLANE, GRID, FINE = (226, 230, 236), (176, 186, 198), (205, 212, 221)

STONE, PLATE, RIM = (206, 212, 220), (186, 205, 222), (126, 138, 152)


@dataclass(eq=False)
class _Drawn:
    part: Part
    root: FrameHandle
    mesh: MeshHandle
    lines: LineSegmentsHandle


class GroundFigures:
    """What is stood on."""

    def __init__(self, scene: SceneApi, name: str) -> None:
        """Put level ground into the scene."""
        self._scene, self._name = scene, name
        self._grid = scene.add_grid(
            f"{name}/plane",
            plane="xz",
            infinite_grid=True,
            cell_size=0.25,
            section_size=1.0,
            cell_color=FINE,
            section_color=GRID,
            cell_thickness=0.6,
            section_thickness=1.0,
            fade_distance=26.0,
            fade_strength=1.6,
            shadow_opacity=0.22,
            plane_color=PLANE,
            plane_opacity=1.0,
        )
        self._ground: AnyGround | None = None
        self._plane = Plane()
        self._turn: Rotations = np.array([1.0, 0.0, 0.0, 0.0])
        self._drawn: list[_Drawn] = []

    def show(self, ground: AnyGround, time: float, middle: Positions) -> None:
        """Draw the ground as it is at a clock time [s].

        Args:
            ground: What is stood on.
            time: Clock time [s].
            middle: What is looked at [m], shape (3,): the plane is finite, and moves along.
        """
        if ground is not self._ground:
            self._ground = ground
            # A program's own ground has no shape to draw but the plane below it.
            own = not isinstance(ground, BuiltGround)
            parts = () if own else ground.parts if isinstance(ground, Terrain) else (ground,)
            planes = [one for one in parts if isinstance(one, Plane)]
            self._plane = planes[0] if planes else Plane()
            slope = self._plane.slope
            normal = np.array([[-slope[0], 1.0, -slope[1]]])
            self._turn = from_vertical(normal / np.linalg.norm(normal))[0]
            self._draw([one for one in parts if not isinstance(one, Plane)])
        for drawn in self._drawn:
            if isinstance(drawn.part, Platform):
                _place(drawn, time)
        self._lay(middle)

    def _lay(self, middle: Positions) -> None:
        """Move the plane along, by whole squares so that its lines stay."""
        origin = np.array([0.0, self._plane.height, 0.0])
        back = self._turn * [1.0, -1.0, -1.0, -1.0]
        slope = self._plane.slope
        below = middle[0] * slope[0] + middle[2] * slope[1]
        own = rotate(back, np.array([middle[0], below, middle[2]]))
        place = origin + rotate(self._turn, np.round(own) * [1.0, 0.0, 1.0])
        if float(np.abs(self._grid.position - place).max()) > 1e-6:
            self._grid.position = place
        if float(np.abs(self._grid.wxyz - self._turn).max()) > 1e-9:
            self._grid.wxyz = self._turn

    def _draw(self, parts: list[Part]) -> None:
        if [type(one.part) for one in self._drawn] != [type(one) for one in parts]:
            for old in self._drawn:
                old.root.remove()
            self._drawn = [self._new(one, number) for number, one in enumerate(parts)]
        for drawn, part in zip(self._drawn, parts, strict=True):
            if isinstance(part, HeightField) and part is not drawn.part:
                shape = shape_of(part)
                drawn.mesh.vertices = shape.vertices.astype(np.float32)
                drawn.lines.points = shape.lines.astype(np.float32)
            drawn.part = part
            _place(drawn, 0.0)

    def _new(self, part: Part, number: int) -> _Drawn:
        name = f"{self._name}/part_{number}"
        root = self._scene.add_frame(name, show_axes=False)
        shape = shape_of(part)
        mesh = self._scene.add_mesh_simple(
            f"{name}/surface",
            shape.vertices.astype(np.float32),
            shape.faces,
            color=PLATE if isinstance(part, Platform) else STONE,
            flat_shading=not isinstance(part, HeightField),
            side="double",
            cast_shadow=False,
            receive_shadow=0.22,
        )
        lines = self._scene.add_line_segments(
            f"{name}/lines", shape.lines.astype(np.float32), colors=RIM
        )
        return _Drawn(part, root, mesh, lines)


def _place(drawn: _Drawn, time: float) -> None:
    x, y, z, heading = frame_at(drawn.part, time)
    drawn.root.position = (x, y, z)
    turn = from_yaw(heading)
    if isinstance(drawn.part, Platform) and any(drawn.part.tilt):
        share = math.sin(math.tau * time / drawn.part.period)
        normal = np.array([[-share * drawn.part.tilt[0], 1.0, -share * drawn.part.tilt[1]]])
        turn = multiply(turn, from_vertical(normal / np.linalg.norm(normal))[0])
    drawn.root.wxyz = turn
