"""Ground that a program makes itself: any object that says how high it is."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, Protocol, TypeVar

import numpy as np

from footfall.arrays import Floats
from footfall.errors import ArgumentError, GroundError

__all__ = ["Frame", "Ground", "check_ground", "frame_of_own", "heights_of_own", "own_heights_at"]

Frame = tuple[float, float, float, float]
"""Where something is: x, y, z [m] and heading [rad]."""

Answer = TypeVar("Answer")


class Ground(Protocol):
    """Ground of a program's own; derive from it, or be alike.

    It is asked once a step, at a grid of places around everybody who stands on it, before anything
    moves; between them it is taken to be even. Where it raises an error, `advance` raises a
    `GroundError` that tells of it, and everybody is as before.
    """

    def heights(self, places: Floats, time: float) -> Floats:
        """Return how high it is over its frame [m], shape (places,).

        Args:
            places: x and z in its frame [m], shape (places, 2).
            time: Clock time [s].
        """
        ...

    def frame(self, time: float) -> Frame:
        """Return where its frame is at a clock time; who stands on it goes along.

        By default it stays at the origin. Heights may change too: they take feet up and down.
        """
        del time
        return 0.0, 0.0, 0.0, 0.0


def check_ground(ground: Any) -> None:
    """Refuse what is no ground.

    Raises:
        ArgumentError: If it does not say how high it is.
    """
    if not callable(getattr(ground, "heights", None)):
        raise ArgumentError(
            f"a ground of type {type(ground).__name__}; give a Plane or another one of "
            "footfall.adaptation, or an object with heights(places, time)"
        )


def frame_of_own(ground: Ground, time: float) -> Frame:
    """Return where the frame of a ground is; errors as of `heights_of_own`."""
    asked = getattr(ground, "frame", None)
    if asked is None:
        return 0.0, 0.0, 0.0, 0.0
    answer = _answered(ground, time, lambda: np.asarray(asked(time), dtype=np.float64))
    if answer.shape != (4,) or not np.isfinite(answer).all():
        told = "not finite" if answer.shape == (4,) else f"of shape {answer.shape}"
        raise GroundError(
            f"the frame of ground {_name(ground)} at {time:.3f} s is {told}; it must be x, y, z "
            "and heading"
        )
    x, y, z, heading = answer.tolist()
    return x, y, z, heading


def heights_of_own(ground: Ground, places: Floats, time: float) -> Floats:
    """Return how high a ground is over its frame at some places of it [m], shape (places,).

    Args:
        ground: The ground.
        places: x and z [m], shape (places, 2).
        time: Clock time [s].

    Raises:
        GroundError: If it raises an error, or does not answer with one finite number a place.
    """
    heights = _answered(
        ground, time, lambda: np.asarray(ground.heights(places.copy(), time), dtype=np.float64)
    )
    if heights.shape != (len(places),):
        raise GroundError(
            f"ground {_name(ground)} has heights of shape {heights.shape} at {time:.3f} s; "
            f"({len(places)},) is needed, one a place"
        )
    if not np.isfinite(heights).all():
        x, z = places[int(np.argwhere(~np.isfinite(heights))[0][0])].tolist()
        raise GroundError(
            f"the height of ground {_name(ground)} at x {x:.2f}, z {z:.2f} m is not finite at "
            f"{time:.3f} s; every place needs one [m]"
        )
    return heights


def own_heights_at(ground: Ground, points: Floats, times: Floats) -> Floats:
    """Return how high a ground is under points of the world [m]; errors as of `heights_of_own`.

    Args:
        ground: The ground.
        points: Where [m], of which x and z count, shape (points, 3).
        times: Clock times [s], shape (points,).
    """
    out = np.empty(len(points))
    for time in np.unique(times).tolist():
        rows = np.flatnonzero(times == time)
        x, y, z, heading = frame_of_own(ground, time)
        away = points[rows][:, [0, 2]] - [x, z]
        cosine, sine = math.cos(heading), math.sin(heading)
        places = away @ np.array([[cosine, sine], [-sine, cosine]])
        out[rows] = y + heights_of_own(ground, places, time)
    return out


def _name(ground: Ground) -> str:
    return type(ground).__name__


def _answered(ground: Ground, time: float, ask: Callable[[], Answer]) -> Answer:
    try:
        return ask()
    except Exception as error:
        told = " ".join(str(error).split())
        raise GroundError(
            f"ground {_name(ground)} failed at {time:.3f} s: {type(error).__name__}: {told}"
        ) from error
