"""Gaits that follow a speed and a turn, made of walks and runs that are loaded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from footfall.engine import MotionLibrary
from footfall.errors import ArgumentError, FootfallError
from footfall.scenario.cue_sheet import ActionEntry
from footfall.studio.jobs import Job
from footfall.studio.loading import fit_beside
from footfall.studio.motion_list import LoadedMotion, MotionList
from footfall.studio.session import Session

__all__ = ["GAIT_SAMPLES", "load_gait", "load_own_gait"]

GAIT_SAMPLES = (
    "sample:walk",
    "sample:walk-slow",
    "sample:walk-fast",
    "sample:run",
    "sample:walk-left",
    "sample:walk-right",
    "sample:run-left",
    "sample:run-right",
)
"""What is steered where no file is named."""

SLOWEST = 0.3
"""A walk gets on at least so fast [m/s]: steps on the spot and backward are none."""


def load_gait(session: Session, name: str, files: Sequence[str]) -> None:
    """Load one action of several motions, beside the live session."""

    def work(job: Job) -> None:
        job.report(0.1, ", ".join(files))
        _take_in(session, ActionEntry(name, files[0], others=tuple(files[1:])))

    session.jobs.begin(f"loading {name}", work)


def load_own_gait(session: Session) -> None:
    """Make one action of the walks and runs that are loaded, beside the live session.

    Raises:
        ArgumentError: If fewer than two could be ones: those as their files have them, not cut,
            mirrored or cleaned, and not with supports of their own.
    """
    entries = [one.entry for one in session.motions.family if one.entry == _plain(one.entry)]
    if len(entries) < 2:
        raise ArgumentError("a gait is made of two or more walks and runs; load them first")

    def work(job: Job) -> None:
        chosen = _walks(session.motions, entries, job)
        if len(chosen) < 2:
            raise ArgumentError(
                f"{len(chosen)} of the {len(entries)} motions is a walk or a run that can be "
                "steered; two that go at different speeds or turns are needed"
            )
        first, *others = (entry.motion for entry in chosen)
        _take_in(session, ActionEntry(_free(session), first, cyclic=True, others=tuple(others)))

    session.jobs.begin("looking for walks and runs", work)


def _plain(entry: ActionEntry) -> ActionEntry:
    """Return an entry that says nothing of its motion but its name, and whether it is a loop."""
    return ActionEntry(
        entry.name, entry.motion, entry.priority, entry.fade_in, entry.fade_out, entry.cyclic
    )


def _walks(motions: MotionList, entries: list[ActionEntry], job: Job) -> list[ActionEntry]:
    """Return the entries that together are a gait, each as far as it goes with those before."""
    chosen: list[ActionEntry] = []
    members: list[LoadedMotion] = []
    for number, entry in enumerate(entries):
        job.report(number / len(entries), entry.name)
        try:
            loop = motions.resolve_entry(replace(entry, cyclic=True))
            if _speed(loop) < SLOWEST:
                continue
            trial = [*members, loop]
            others = tuple(one.motion for one in trial[1:])
            whole = LoadedMotion(trial[0].entry, replace(trial[0].motion, others=others))
            motions.prepare(whole)
        except FootfallError:
            # A kick is no walk: that is found out, and no mistake of its user.
            continue
        chosen.append(entry)
        members = trial
    return chosen


def _speed(loaded: LoadedMotion) -> float:
    """Return how fast a loop gets on, the way it faces [m/s]; errors as of a locomotion."""
    library = MotionLibrary()
    library.add_locomotion("gait", [(loaded.motion.clip, loaded.motion.supports)])
    gaits = library.actions[0].locomotion
    assert gaits is not None
    return float(gaits.speeds[0])


def _take_in(session: Session, entry: ActionEntry) -> None:
    loaded = session.motions.resolve_entry(entry)
    fit_beside(session, loaded)
    with session.lock:
        session.take_in(loaded)


def _free(session: Session) -> str:
    """Return a name for one more gait."""
    name, count = "go", 1
    while session.motions.find(name) is not None:
        count += 1
        name = f"go {count}"
    return name
