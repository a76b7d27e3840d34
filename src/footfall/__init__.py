"""Starts, stops and mixes motion clips of humanoid characters so that the feet never slide."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from footfall.adaptation import Ground, Plane
    from footfall.detection import clean, detect_supports
    from footfall.engine import (
        Character,
        Crowd,
        Frame,
        Impossible,
        MotionLibrary,
        PathFollower,
        Started,
        Waiting,
    )
    from footfall.errors import FootfallError
    from footfall.io import load, load_supports, save, save_supports
    from footfall.motion import Clip
    from footfall.samples import sample
    from footfall.skeleton import Skeleton
    from footfall.support import Support, SupportPhase, SupportSequence
    from footfall.warming import warmup

__all__ = [
    "Character",
    "Clip",
    "Crowd",
    "FootfallError",
    "Frame",
    "Ground",
    "Impossible",
    "MotionLibrary",
    "PathFollower",
    "Plane",
    "Skeleton",
    "Started",
    "Support",
    "SupportPhase",
    "SupportSequence",
    "Waiting",
    "clean",
    "detect_supports",
    "load",
    "load_supports",
    "sample",
    "save",
    "save_supports",
    "warmup",
]

_PACKAGES = {
    "adaptation": ("Ground", "Plane"),
    "detection": ("clean", "detect_supports"),
    "engine": (
        "Character",
        "Crowd",
        "Frame",
        "Impossible",
        "MotionLibrary",
        "PathFollower",
        "Started",
        "Waiting",
    ),
    "errors": ("FootfallError",),
    "io": ("load", "load_supports", "save", "save_supports"),
    "motion": ("Clip",),
    "samples": ("sample",),
    "skeleton": ("Skeleton",),
    "support": ("Support", "SupportPhase", "SupportSequence"),
    "warming": ("warmup",),
}
"""Where each public name lives. It is loaded when it is first used: a program that only reads
files waits for no compiler."""


def __getattr__(name: str) -> object:
    for package, names in _PACKAGES.items():
        if name in names:
            found = getattr(importlib.import_module(f"footfall.{package}"), name)
            globals()[name] = found
            return found
    raise AttributeError(f"module 'footfall' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
