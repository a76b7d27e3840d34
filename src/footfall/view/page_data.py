"""What the page's player needs, packed small: arrays as base64 inside one JSON object."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Indices
from footfall.io.flat_toes import flat_toe_turns
from footfall.io.mannequin import mannequin
from footfall.report import RATE, Trace, Track
from footfall.skeleton import Skeleton
from footfall.support import Support
from footfall.view.lanes import Timeline
from footfall.view.plants import Plant, plants

__all__ = ["player_json"]

_PLACE_UNIT = 1e-4
"""Joint places, relative to the pelvis, are kept to a tenth of a millimeter [m]."""


def player_json(takes: Sequence[tuple[str, Trace]], skeleton: Skeleton, timeline: Timeline) -> str:
    """Return the takes, the mannequin that performs them and the schedule as JSON.

    The text holds no ``<``, so that it may stand inside a script element.
    """
    last = takes[-1][1]
    turns = flat_toe_turns(last.anatomy, last.rotations, last.positions)
    body = mannequin(skeleton, last.anatomy, turns)
    used = np.concatenate([body.joints, body.others])
    joints, index = np.unique(used, return_inverse=True)
    vertex_joints, vertex_others = index.reshape(2, -1)
    document = {
        "rate": RATE,
        "mesh": {
            "positions": _packed(body.positions / _PLACE_UNIT, "<i2"),
            "normals": _packed(body.normals * 127.0, "<i1"),
            "joints": _packed(vertex_joints, "<u1"),
            "others": _packed(vertex_others, "<u1"),
            "shares": _packed(body.shares * 255.0, "<u1"),
            "rest": _packed(body.rest[joints] / _PLACE_UNIT, "<i2"),
            "tones": _packed(_vertex_tones(body.triangles, body.tones), "<u1"),
            "triangles": _packed(body.triangles, "<u2"),
            "unit": _PLACE_UNIT,
        },
        "takes": [_take(title, trace, joints) for title, trace in takes],
        "supports": timeline.supports,
        "scheduleRate": timeline.fps,
        "actions": [
            {"name": lane.name, "weights": _packed(lane.weights * 255.0, "<u1")}
            for lane in timeline.lanes
        ],
    }
    return json.dumps(document, separators=(",", ":")).replace("<", "\\u003c")


def _take(title: str, trace: Trace, joints: Indices) -> dict[str, Any]:
    track = Track.from_trace(trace)
    found = plants(track)
    places = trace.positions[:, joints] - trace.positions[:, :1]
    return {
        "title": title,
        "fps": trace.fps,
        "frames": trace.frames,
        "joints": len(joints),
        "roots": _packed(trace.positions[:, 0], "<f4"),
        "places": _packed(places / _PLACE_UNIT, "<i2"),
        "rotations": _packed(trace.rotations[:, joints] * 32767.0, "<i2"),
        "supports": "".join(Support(int(of)).symbol for of in track.supports).replace("Err", "-"),
        "moving": _packed(track.moving, "<u1"),
        "slid": _packed(_slid(track.frames, found) * 10_000.0, "<u2"),
        "plants": [_plant(plant) for plant in found],
    }


def _slid(frames: int, found: Sequence[Plant]) -> npt.NDArray[np.float64]:
    """Return how far each foot has slid since it was planted [m], (frames, 2); zero in swing."""
    slid = np.zeros((frames, 2))
    for plant in found:
        slid[plant.start : plant.stop, plant.foot] = plant.slid
    return slid


def _plant(plant: Plant) -> dict[str, Any]:
    return {
        "foot": plant.foot,
        "start": plant.start,
        "stop": plant.stop,
        "slip": round(plant.slip, 4),
        "print": np.round(plant.print[:, [0, 2]], 4).tolist(),
        "end": np.round(plant.streak[-1, [0, 2]], 4).tolist(),
    }


def _vertex_tones(triangles: Indices, tones: Indices) -> Indices:
    """Return the tone of each vertex: limbs share none."""
    result = np.zeros(int(triangles.max()) + 1, dtype=np.int64)
    result[triangles] = tones[:, np.newaxis]
    return result


def _packed(values: npt.NDArray[Any], kind: str) -> str:
    """Return numbers, rounded and clipped to what the kind can hold, as base64."""
    kept = np.asarray(values)
    if np.dtype(kind).kind in "iu":
        limits = np.iinfo(kind)
        kept = np.clip(np.rint(kept), limits.min, limits.max)
    return base64.b64encode(np.ascontiguousarray(kept, dtype=kind).tobytes()).decode()
