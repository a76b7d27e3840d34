"""From the ground that a user describes to the surfaces that the kernels take."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from footfall.adaptation.ground import (
    AnyGround,
    BuiltGround,
    Plane,
    Platform,
    Ramp,
    Stairs,
    Terrain,
)
from footfall.adaptation.height_field import HeightField
from footfall.adaptation.own_ground import own_heights_at
from footfall.adaptation.surface_record import FIELD, SLOPE, STAIRS, Ground, surface_type
from footfall.adaptation.surfaces import probe
from footfall.arrays import Floats, Positions, Seconds
from footfall.compilation import kernel, records

__all__ = ["ground_heights", "pack_ground"]


def pack_ground(ground: BuiltGround) -> Ground:
    """Return a ground of a kind that they know as the kernels take it."""
    parts = ground.parts if isinstance(ground, Terrain) else (ground,)
    surfaces = records(np.zeros(len(parts), dtype=surface_type))
    samples: list[Floats] = [np.zeros(1)]
    first = 1
    for surface, part in zip(surfaces, parts, strict=True):
        fields = _fields(part)
        if isinstance(part, HeightField):
            fields["first"] = first
            samples.append(part.heights.reshape(-1))
            first += part.heights.size
        surface["half_x"] = surface["half_z"] = math.inf
        for name, value in fields.items():
            surface[name] = value
    packed: Any = surfaces
    even = len(parts) == 1 and isinstance(parts[0], Plane)
    return Ground(packed, even, np.concatenate(samples))


def ground_heights(ground: AnyGround, points: Positions, times: Seconds) -> Floats:
    """Return how high the ground is under some points [m], shape (...).

    Args:
        ground: The ground.
        points: Where [m], of which x and z count, shape (..., 3).
        times: Clock times [s], shape (...).

    Raises:
        GroundError: If it is a program's own, and fails.
    """
    out = np.empty(points.shape[:-1])
    flat = np.ascontiguousarray(points, dtype=np.float64).reshape(-1, 3)
    when = np.ascontiguousarray(np.broadcast_to(times, out.shape), dtype=np.float64).reshape(-1)
    if not isinstance(ground, BuiltGround):
        return own_heights_at(ground, flat, when).reshape(out.shape)
    _write_heights(pack_ground(ground), flat, when, out.reshape(-1))
    return out


@kernel
def _write_heights(ground: Ground, points: Positions, times: Seconds, out: Floats) -> None:
    for row in range(out.shape[0]):
        out[row] = probe(ground, points[row, 0], points[row, 2], times[row]).height


def _fields(part: Plane | Ramp | Stairs | Platform | HeightField) -> dict[str, float]:
    """Return the fields of a surface's record that are not 0."""
    if isinstance(part, Plane):
        return {
            "kind": SLOPE,
            "y": part.height,
            "slope_x": part.slope[0],
            "slope_z": part.slope[1],
        }
    if isinstance(part, HeightField):
        rows, columns = part.heights.shape
        return {
            "kind": FIELD,
            "x": part.middle[0],
            "z": part.middle[1],
            "count_x": columns,
            "count_z": rows,
            "spacing": part.spacing,
        }
    if isinstance(part, Platform):
        return _platform_fields(part)
    x, y, z = part.place
    length = part.length if isinstance(part, Ramp) else part.steps * part.tread + part.landing
    fields = {
        "x": x + 0.5 * length * math.sin(part.heading),
        "z": z + 0.5 * length * math.cos(part.heading),
        "heading": part.heading,
        "half_x": 0.5 * part.width,
        "half_z": 0.5 * length,
    }
    if isinstance(part, Ramp):
        return fields | {"y": y + 0.5 * part.rise, "slope_z": part.rise / part.length}
    return fields | {
        "kind": STAIRS,
        "y": y,
        "rise": part.rise,
        "tread": part.tread,
        "steps": part.steps,
    }


def _platform_fields(part: Platform) -> dict[str, float]:
    """Return the same of a platform."""
    fields = {"period": part.period, "turning": part.turning}
    fields |= dict(zip(("x", "y", "z"), part.place, strict=True))
    fields |= dict(zip(("way_x", "way_y", "way_z"), part.way, strict=True))
    fields |= dict(zip(("tilt_x", "tilt_z"), part.tilt, strict=True))
    return fields | {"half_x": 0.5 * part.size[0], "half_z": 0.5 * part.size[1]}
