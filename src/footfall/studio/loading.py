"""Motions loaded, or read in another way, beside the live session."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from footfall.errors import ArgumentError, FootfallError, ScenarioError
from footfall.scenario.motions import SAMPLE
from footfall.studio.jobs import Job
from footfall.studio.motion_list import LoadedMotion, MotionList
from footfall.studio.session import Session

__all__ = ["OPTIONS", "fit_beside", "load", "load_from_page", "set_option"]

OPTIONS = ("cyclic", "clean", "mirror")
"""How a motion may be read."""


def load(session: Session, files: Sequence[str | Path]) -> None:
    """Load motions beside the live session; each that cannot be read is told, none stops it."""
    title = f"loading {files[0]}" if len(files) == 1 else f"loading {len(files)} motions"

    def work(job: Job) -> None:
        for number, file in enumerate(files):
            job.report(number / len(files), str(file))
            try:
                loaded = session.motions.resolve(file)
                fit_beside(session, loaded)
                job.report((number + 1) / len(files), str(file))
            except FootfallError as error:
                session.notice(str(error), "error")
                continue
            with session.lock:
                session.take_in(loaded)

    session.jobs.begin(title, work)


def load_from_page(session: Session, file: str) -> None:
    """Load a sample, or a file of the folder.

    Raises:
        FileFormatError: If it lies elsewhere, or is too large.
    """
    if not file.startswith(SAMPLE):
        session.folder.readable(file)
    load(session, [file])


def set_option(session: Session, name: str, option: str, on: bool) -> None:
    """Change how a motion is read, beside the live session.

    Raises:
        ArgumentError: If there is no such motion or option.
    """
    if session.motions.find(name) is None or option not in OPTIONS:
        raise ArgumentError(f"no option {option!r} of {name!r}; {', '.join(OPTIONS)} are")

    def work(job: Job) -> None:
        job.report(0.1)
        # Supports that were corrected by hand belong to the motion as it was.
        loaded = session.motions.reload(name, **{option: on, "supports": None})
        fit_beside(session, loaded)
        job.report(1.0)
        with session.lock:
            session.motions.keep(loaded)
            session.motions_changed()

    session.jobs.begin(f"reading {name} again", work)


def fit_beside(session: Session, loaded: LoadedMotion) -> None:
    """Make what the body performs of a motion now, so that the live session need not wait."""
    with session.lock:
        others = MotionList(session.folder, session.motions)
        others.body = session.motions.body
    try:
        others.prepare(loaded)
    except ScenarioError as error:
        # It can still be looked at, and its supports edited.
        session.notice(str(error), "error")
