"""Every error of the project.

FootfallError
├── SkeletonError            a body that cannot be used (also ValueError)
├── ClipError                a motion that cannot be used (also ValueError)
├── SupportSequenceError     a sequence of support phases that breaks its rules (also ValueError)
├── FileFormatError          a file that cannot be read; knows its path and line (also ValueError)
├── ScenarioError            a cue sheet that cannot be played (also ValueError)
├── SourceError              a motion source of the user's raised something (also RuntimeError)
├── ArgumentError            an argument out of its range (also ValueError)
├── GroundError              a ground of a program's own that fails (also RuntimeError)
├── MissingExtraError        an optional library that is not installed (also ImportError)
├── MissingViewerError       a viewer, or what it needs, is not installed (also ImportError)
└── UnknownNameError         a name that is not there; lists those that are (also LookupError)

Each message says what is wrong and where, with the numbers, then what would be right.
"""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

__all__ = [
    "ArgumentError",
    "ClipError",
    "FileFormatError",
    "FootfallError",
    "GroundError",
    "MissingExtraError",
    "MissingViewerError",
    "ScenarioError",
    "SkeletonError",
    "SourceError",
    "SupportSequenceError",
    "UnknownNameError",
]


class FootfallError(Exception):
    """Anything this project has to say about what it was given."""


class SkeletonError(FootfallError, ValueError):
    """A body cannot be used."""


class ClipError(FootfallError, ValueError):
    """A motion cannot be used."""


class SupportSequenceError(FootfallError, ValueError):
    """A sequence of support phases breaks its rules."""


class ScenarioError(FootfallError, ValueError):
    """A cue sheet cannot be played."""


class ArgumentError(FootfallError, ValueError):
    """An argument is out of its range."""


class GroundError(FootfallError, RuntimeError):
    """A ground of a program's own fails; the error that it raised is the cause."""


class MissingViewerError(FootfallError, ImportError):
    """A viewer, or what it needs, is not installed."""


class FileFormatError(FootfallError, ValueError):
    """A file cannot be read.

    Attributes:
        problem: What is wrong and what would be right.
        path: The file.
        line: Its line, counted from 1, or None where the whole file is meant.
    """

    def __init__(self, problem: str, *, path: Path | str, line: int | None = None) -> None:
        self.problem = problem
        self.path = Path(path)
        self.line = line
        where = f"{path}" if line is None else f"{path}:{line}"
        super().__init__(f"{where}: {problem}")


class MissingExtraError(FootfallError, ImportError):
    """An optional library is not installed.

    Attributes:
        extra: The extra of this project that brings it.
    """

    def __init__(self, purpose: str, library: str, extra: str) -> None:
        self.extra = extra
        super().__init__(f"{purpose} needs {library}; pip install 'footfall[{extra}]'")


class SourceError(FootfallError, RuntimeError):
    """A motion source of the user's raised something; that is its `__cause__`.

    Attributes:
        action: The action that it was asked for.
    """

    def __init__(self, action: str, problem: Exception) -> None:
        self.action = action
        told = f"{type(problem).__name__}: {problem}" if str(problem) else type(problem).__name__
        super().__init__(f"the source of {action!r} raised {told}; the library is as it was before")


class UnknownNameError(FootfallError, LookupError):
    """A name is not there.

    Attributes:
        name: The name that was asked for.
        known: The names that exist.
    """

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.name = name
        self.known = tuple(known)
        there = ", ".join(self.known) if self.known else "none yet"
        super().__init__(f"no {kind} named {name!r}; there are: {there}")
