"""One motion of an archive: its supports, its slip, and what was concluded about its file."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from footfall.detection import detect_supports
from footfall.errors import ArgumentError, FileFormatError, FootfallError
from footfall.io import Conclusions, load_with_conclusions, supports_text
from footfall.motion import Clip
from footfall.report import SpanMeasure, Spread, Track, clip_trace, measure_spans
from footfall.skeleton import find_anatomy
from footfall.support import SupportSequence

__all__ = ["ClipAnnotation", "Limits", "annotate_clip"]

MILLIMETERS = 1000.0
"""In a meter."""


@dataclass(frozen=True, slots=True)
class Limits:
    """The paper's limits of height and speed; see `footfall.detection.detect_contacts`.

    Raises:
        ArgumentError: If a limit is not finite and > 0.
    """

    height: float | None = None
    """Of the lowest point of a foot that carries [m]; None: from the body."""

    speed: float | None = None
    """Of that point [m/s]; None: from the motion."""

    def __post_init__(self) -> None:
        for name, limit in (("height", self.height), ("speed", self.speed)):
            if limit is not None and not 0.0 < limit < math.inf:
                raise ArgumentError(f"{name} is {limit}; a limit must be finite and > 0")


@dataclass(frozen=True, slots=True)
class ClipAnnotation:
    """A row of the table of an archive; of a file that could not be used, only why."""

    file: str
    """The file, relative to the archive, with forward slashes."""

    size: int
    """Of the file [bytes]."""

    changed: int
    """When it was last changed [ns since 1970]."""

    error: str | None = None
    """Why it could not be used; None where it could."""

    frames: int | None = None
    """How many there are."""

    fps: float | None = None
    """Frames per second."""

    seconds: float | None = None
    """From the first frame to the last [s]."""

    joints: int | None = None
    """How many there are."""

    unit: str | None = None
    """The unit of length of the file."""

    up: str | None = None
    """The axis of the file that points up."""

    cyclic: bool | None = None
    """Whether the last frame is the first one again."""

    supports: str | None = None
    """The support phases, such as ``R.38 D.12 L.38 D.12*`` (seconds)."""

    phases: int | None = None
    """How many there are."""

    left_share: float | None = None
    """Share of the time in which only the left foot carries, 0 to 1."""

    right_share: float | None = None
    """The same of the right foot."""

    double_share: float | None = None
    """The same of both feet."""

    flight_share: float | None = None
    """The same of none."""

    spans: int | None = None
    """How many stretches there are in which one foot carries long enough to be measured."""

    slip_median_mm: float | None = None
    """Median inner slip of these [mm]; see `footfall.report.SpanMeasure`."""

    slip_p95_mm: float | None = None
    """Its 95th percentile [mm]."""

    slip_max_mm: float | None = None
    """The greatest [mm]."""

    drift_max_mm: float | None = None
    """Greatest inner drift [mm]."""

    floor_mm: float | None = None
    """How high the lowest foot point rests [mm]."""

    labels: str | None = None
    """The content of the ``.supports`` file that is written; no column of the table."""

    def to_row(self) -> dict[str, Any]:
        """Return the cells of the table by the names of its columns."""
        row = asdict(self)
        del row["labels"]
        return row

    @classmethod
    def from_row(cls, row: dict[str, Any]) -> ClipAnnotation:
        """Return what `to_row` gave.

        Raises:
            TypeError: If a cell has no column, or a cell that is always there is missing.
        """
        return cls(**row)

    @classmethod
    def columns(cls) -> tuple[str, ...]:
        """Return the names of the table's columns, in their order."""
        return tuple(field.name for field in fields(cls) if field.name != "labels")


def annotate_clip(archive: str, file: str, limits: Limits) -> ClipAnnotation:
    """Detect the supports of one motion of an archive and measure its slip in them.

    It never raises: whatever is wrong with a file is told in its row. Runs in any process that
    can read the archive.

    Args:
        archive: The folder of the archive.
        file: The file, relative to it.
        limits: The detector's.
    """
    path = Path(archive) / file
    size = changed = 0
    try:
        facts = path.stat()
        size, changed = facts.st_size, facts.st_mtime_ns
        return _annotated(path, file, size, changed, limits)
    except FileFormatError as error:
        told = error.problem if error.line is None else f"line {error.line}: {error.problem}"
    except FootfallError as error:
        told = str(error)
    except OSError as error:
        told = f"cannot be read: {(error.strerror or str(error)).lower()}"
    except MemoryError:
        told = "needs more memory than there is"
    except Exception as error:
        # One file must not stop ten thousand; the row names what it ran into.
        told = f"ran into {type(error).__name__}: {error}"
    return ClipAnnotation(file, size, changed, error=" ".join(told.split()))


def _annotated(path: Path, file: str, size: int, changed: int, limits: Limits) -> ClipAnnotation:
    clip, conclusions = load_with_conclusions(path)
    anatomy = find_anatomy(clip.skeleton)
    supports = detect_supports(clip, anatomy, height=limits.height, speed=limits.speed)
    spans = measure_spans(Track.from_trace(clip_trace(clip, anatomy, supports)))
    return ClipAnnotation(
        file,
        size,
        changed,
        labels=supports_text(supports),
        **_facts(clip, conclusions),
        **_standing(supports),
        **_slips(spans),
    )


def _facts(clip: Clip, conclusions: Conclusions) -> dict[str, Any]:
    return {
        "frames": clip.frames,
        "fps": clip.fps,
        "seconds": clip.duration,
        "joints": clip.skeleton.count,
        "unit": conclusions.unit.value.name,
        "up": conclusions.up.value,
        "cyclic": clip.cyclic,
        "floor_mm": MILLIMETERS * conclusions.floor.value,
    }


def _standing(supports: SupportSequence) -> dict[str, Any]:
    shares = dict.fromkeys("LRD-", 0.0)
    for phase in supports.phases:
        shares[phase.support.symbol] += phase.duration / supports.duration
    return {
        "supports": str(supports),
        "phases": len(supports.phases),
        "left_share": shares["L"],
        "right_share": shares["R"],
        "double_share": shares["D"],
        "flight_share": shares["-"],
    }


def _slips(spans: tuple[SpanMeasure, ...]) -> dict[str, Any]:
    slips = Spread.of(MILLIMETERS * s.inner_slip for s in spans if s.inner_slip is not None)
    drifts = Spread.of(MILLIMETERS * s.inner_drift for s in spans if s.inner_drift is not None)
    return {
        "spans": slips.count,
        "slip_median_mm": slips.median,
        "slip_p95_mm": slips.p95,
        "slip_max_mm": slips.maximum,
        "drift_max_mm": drifts.maximum,
    }
