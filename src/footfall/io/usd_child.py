"""Reads a USD file in a process of its own, and hands plain arrays back.

Run by `footfall.io.guarded_server`, as `fbx_child` is and for the same reasons.

Facts of the answer: fps, metres_per_unit, up, names. Arrays: ``parents`` (nodes,),
``joints`` (flags), and ``matrices`` (frames, nodes, 4, 4) from each node to its parent, in the
file's unit and axes, for column vectors.
"""

from __future__ import annotations

import importlib
import os
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["Answer", "UnreadableError", "load_library", "read_file"]

MOST_FRAMES_PER_SECOND = 10_000


Answer = tuple[dict[str, Any], dict[str, npt.NDArray[Any]]]
"""Facts by name, and arrays by name."""

MODULES = ("Tf", "Usd", "UsdGeom", "UsdSkel")


class UnreadableError(Exception):
    """What is wrong with the file."""


def load_library() -> None:
    """Import USD, which then works in one thread: more would count as memory."""
    os.environ["PXR_WORK_THREAD_LIMIT"] = "1"
    for name in MODULES:
        importlib.import_module(f"pxr.{name}")


def read_file(words: list[str], data: bytes, allowed: int) -> Answer:
    """Return the facts and the arrays of a file.

    Args:
        words: The path of the file.
        data: Nothing: the library opens the file itself, and what it references.
        allowed: How much memory reading it may take [bytes].

    Raises:
        UnreadableError: If it is damaged.
    """
    assert not data
    try:
        return _read(words[0], allowed)
    except UnicodeDecodeError as error:
        raise UnreadableError("is damaged: it holds a name that is no UTF-8") from error


def _read(path: str, allowed: int) -> Answer:
    pxr: dict[str, Any] = {name: importlib.import_module(f"pxr.{name}") for name in MODULES}
    try:
        stage = pxr["Usd"].Stage.Open(path)
    except pxr["Tf"].ErrorException as error:
        told = " ".join(str(error).split())
        # What comes before is where in the library that was.
        told = told.rsplit(" : '", 1)[-1]
        raise UnreadableError(f"is damaged or no USD file: {told[:160]}") from error
    skeletons = _skeletons(stage, pxr)
    if not skeletons:
        raise UnreadableError("holds no skeleton: no Skeleton prim with joints is in it")
    times = _times(skeletons, float(stage.GetTimeCodesPerSecond()), allowed)
    nodes = [_nodes(query, times[0], pxr) for query in skeletons]
    facts = {
        "fps": times[1],
        "metres_per_unit": float(pxr["UsdGeom"].GetStageMetersPerUnit(stage)),
        "up": str(pxr["UsdGeom"].GetStageUpAxis(stage)).lower(),
        "names": [name for one in nodes for name in one[0]],
    }
    starts = np.cumsum([0, *(len(one[0]) for one in nodes)])[:-1]
    parents = [np.where(one[1] < 0, -1, one[1] + s) for one, s in zip(nodes, starts, strict=True)]
    flags = [np.arange(len(one[0])) > 0 for one in nodes]
    return facts, {
        "parents": np.concatenate(parents),
        "joints": np.concatenate(flags),
        "matrices": np.concatenate([one[2] for one in nodes], axis=1),
    }


def _skeletons(stage: Any, pxr: dict[str, Any]) -> list[Any]:
    """Return a query of each skeleton with joints; animated where something is bound to it."""
    cache = pxr["UsdSkel"].Cache()
    prims = list(stage.Traverse(pxr["Usd"].TraverseInstanceProxies()))
    for prim in prims:
        if prim.IsA(pxr["UsdSkel"].Root):
            cache.Populate(pxr["UsdSkel"].Root(prim), pxr["Usd"].TraverseInstanceProxies())
    queries = [
        cache.GetSkelQuery(pxr["UsdSkel"].Skeleton(prim))
        for prim in prims
        if prim.IsA(pxr["UsdSkel"].Skeleton)
    ]
    return [query for query in queries if query and len(query.GetJointOrder()) > 0]


def _times(skeletons: list[Any], codes: float, allowed: int) -> tuple[list[float], float]:
    """Return the time codes of the frames, and frames per second.

    A frame is a time code, unless the samples lie evenly at another distance.
    """
    if not 0.0 < codes <= MOST_FRAMES_PER_SECOND:
        raise UnreadableError(
            f"has {codes:g} time codes per second; more than 0 and at most "
            f"{MOST_FRAMES_PER_SECOND} are possible"
        )
    samples: set[float] = set()
    for query in skeletons:
        animation = query.GetAnimQuery()
        if animation:
            samples |= set(animation.GetJointTransformTimeSamples())
    if len(samples) < 2:
        return [min(samples, default=0.0)], codes
    ordered = np.array(sorted(samples))
    steps = np.diff(ordered)
    step = float(np.median(steps))
    if np.abs(steps - step).max() > 1e-3 * step:
        step = 1.0
    span = float(ordered[-1] - ordered[0])
    joints = sum(len(query.GetJointOrder()) + 1 for query in skeletons)
    if not np.isfinite(span) or span / step * joints * 256 > allowed or codes / step > 1e4:
        raise UnreadableError(
            f"its animation runs from {ordered[0]:g} to {ordered[-1]:g} in steps of {step:g}, far "
            "more than such a file holds"
        )
    frames = round(span / step) + 1
    return [float(ordered[0] + step * frame) for frame in range(frames)], codes / step


def _nodes(
    query: Any, times: list[float], pxr: dict[str, Any]
) -> tuple[list[str], npt.NDArray[np.int64], npt.NDArray[np.float64]]:
    """Return a skeleton as nodes: first the prim itself in the world, then its joints."""
    skeleton = query.GetSkeleton()
    parents = np.array(query.GetTopology().GetParentIndices(), dtype=np.int64).reshape(-1)
    count = len(parents)
    matrices = np.empty((len(times), count + 1, 4, 4))
    for frame, time in enumerate(times):
        placed = pxr["UsdGeom"].XformCache(time).GetLocalToWorldTransform(skeleton.GetPrim())
        local = query.ComputeJointLocalTransforms(time)
        if local is None or len(local) != count:
            raise UnreadableError(
                f"skeleton {skeleton.GetPath()} has {count} joints, but no transform for each; its "
                "animation or its restTransforms must give them"
            )
        matrices[frame, 0] = np.array(placed)
        matrices[frame, 1:] = np.array(local)
    # USD multiplies row vectors.
    return (
        [str(skeleton.GetPrim().GetName()), *_names(query, skeleton)],
        np.concatenate([[-1], np.where(parents < 0, 0, parents + 1)]),
        np.swapaxes(matrices, -1, -2),
    )


def _names(query: Any, skeleton: Any) -> list[str]:
    """Return what the joints are called: their own names, or else the ends of their paths."""
    paths = [str(path) for path in query.GetJointOrder()]
    names = skeleton.GetJointNamesAttr().Get()
    if names is not None and len(names) == len(paths):
        return [str(name) for name in names]
    return [path.rsplit("/", 1)[-1] for path in paths]
