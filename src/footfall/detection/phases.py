"""Contacts of the feet to support phases, and to the tighter times at which they are planted."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.detection.contacts import MINIMUM_DURATION, Contacts, detect_contacts
from footfall.detection.intervals import Interval, covers
from footfall.errors import ArgumentError
from footfall.motion import Clip
from footfall.skeleton import Anatomy
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["contact_supports", "detect_supports", "frame_symbols", "interval_supports"]

_HANDOVER = 0.07
"""How long a double support is made that would be too short [s]: 5 % of a slow stride."""


def detect_supports(
    clip: Clip,
    anatomy: Anatomy | None = None,
    *,
    height: float | None = None,
    speed: float | None = None,
    min_duration: float = MINIMUM_DURATION,
) -> SupportSequence:
    """Find the support phases of a clip (section 4.2).

    Their durations sum to the clip's; boundaries may fall between frames. Of a cyclic clip
    whose loop was cut in the middle of a phase, that phase is the first one and begins before
    time zero.

    Args:
        clip: The motion, at least two frames.
        anatomy: Its skeleton's; found where not given.
        height: The paper's maximum height of the lowest extremity of the foot [m], > 0.
        speed: The paper's maximum speed below that height [m/s], > 0.
        min_duration: No phase is shorter [s], >= 0; see `contact_supports`.

    Raises:
        ArgumentError: If a limit is out of its range, or the clip has a single frame.
    """
    contacts = detect_contacts(clip, anatomy, height=height, speed=speed, min_duration=min_duration)
    return contact_supports(contacts, min_duration=min_duration)


def contact_supports(
    contacts: Contacts, *, min_duration: float = MINIMUM_DURATION
) -> SupportSequence:
    """Combine the contacts of both feet to one sequence without short phases.

    The shortest phase comes first, until none is too short. Between two phases of the same
    support it becomes theirs. Between two different ones it is made long enough, from both
    sides, if it is no flight, lasts at least half the minimum and they can spare it (a walk whose
    feet hand over quickly stays a walk); else it is shared half and half. At the end of a clip it
    goes to its only neighbor.

    Raises:
        ArgumentError: If the clip lasts no time.
    """
    return interval_supports(
        contacts.intervals, contacts.duration, cyclic=contacts.cyclic, min_duration=min_duration
    )


def interval_supports(
    limbs: Sequence[tuple[Interval, ...]], duration: float, *, cyclic: bool, min_duration: float
) -> SupportSequence:
    """Combine the contacts of any limbs, in the order of `footfall.support.LIMBS`.

    Args:
        limbs: When each is in contact, in order.
        duration: Of the clip [s].
        cyclic: Whether the clip is.
        min_duration: As in `contact_supports`.

    Raises:
        ArgumentError: If the clip lasts no time.
    """
    if duration <= 0.0:
        raise ArgumentError("a clip of a single frame has no phases; at least two are needed")
    bounds = _boundaries(limbs, duration, cyclic=cyclic)
    middles = 0.5 * (bounds[:-1] + bounds[1:])
    carrying = np.stack([covers(one, middles, duration, cyclic=cyclic) for one in limbs], axis=-1)
    phases = [
        (Support.from_limbs(np.flatnonzero(row).tolist()), float(start), float(end))
        for row, start, end in zip(carrying, bounds[:-1], bounds[1:], strict=True)
    ]
    phases = _resolved(_merged(phases, cyclic=cyclic), min_duration, cyclic=cyclic)
    if len(phases) == 1:
        return SupportSequence((SupportPhase(phases[0][0], duration),), cyclic)
    return SupportSequence(
        tuple(SupportPhase(support, end - start) for support, start, end in phases),
        cyclic,
        phases[0][1],
    )


def _boundaries(
    limbs: Sequence[tuple[Interval, ...]], duration: float, *, cyclic: bool
) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """Return all times at which a contact begins or ends, with both ends of the clip."""
    times = [
        time % duration if cyclic else time
        for limb in limbs
        for interval in limb
        for time in (interval.start, interval.end)
    ]
    times += [0.0, duration]
    ordered = np.unique(np.clip(times, 0.0, duration))
    apart = np.concatenate([[True], np.diff(ordered) > 1e-9])
    kept = ordered[apart]
    kept[-1] = duration
    return kept


_Phases = list[tuple[Support, float, float]]


def _merged(phases: _Phases, *, cyclic: bool) -> _Phases:
    """Join neighbors of the same support; on a cycle the first may then begin before zero."""
    merged: _Phases = []
    for support, start, end in phases:
        if merged and merged[-1][0] is support:
            merged[-1] = (support, merged[-1][1], end)
        else:
            merged.append((support, start, end))
    if cyclic and len(merged) > 1 and merged[0][0] is merged[-1][0]:
        _, last_start, last_end = merged.pop()
        merged[0] = (merged[0][0], last_start - last_end, merged[0][2])
    return merged


def _resolved(phases: _Phases, minimum: float, *, cyclic: bool) -> _Phases:
    while len(phases) > 1:
        lengths = np.array([end - start for _, start, end in phases])
        if not (lengths < minimum - 1e-9).any():
            break
        index = int(lengths.argmin())
        widened = _widened(phases, index, minimum, cyclic=cyclic)
        phases = _without(phases, index, cyclic=cyclic) if widened is None else widened
    return phases


def _widened(phases: _Phases, index: int, minimum: float, *, cyclic: bool) -> _Phases | None:
    """Return the phases with one made just long enough, or None where it is not to be kept.

    Kept is what lasts half the minimum between two different phases that can spare the rest.
    """
    count = len(phases)
    inside = cyclic or 0 < index < count - 1
    before, after = (index - 1) % count, (index + 1) % count
    support, start, end = phases[index]
    if support is Support.FLIGHT or not inside or count < 3:
        return None
    if phases[before][0] is phases[after][0]:
        return None
    missing = 0.5 * (max(minimum, _HANDOVER) - (end - start))
    spare = min(phases[i][2] - phases[i][1] for i in (before, after)) - missing
    if end - start < 0.5 * minimum or spare < minimum:
        return None
    result = list(phases)
    result[before] = (*phases[before][:2], phases[before][2] - missing)
    result[after] = (phases[after][0], phases[after][1] + missing, phases[after][2])
    result[index] = (support, start - missing, end + missing)
    return _from_zero(result, phases[-1][2] - phases[0][1], cyclic=cyclic)


def _without(phases: _Phases, index: int, *, cyclic: bool) -> _Phases:
    """Return the phases with one given to its neighbors."""
    count = len(phases)
    _, start, end = phases[index]
    before = index - 1 if index > 0 or cyclic else None
    after = index + 1 if index < count - 1 or cyclic else None
    middle = 0.5 * (start + end)
    if before is None:
        middle = start
    elif after is None:
        middle = end
    result = list(phases)
    period = phases[-1][2] - phases[0][1]
    if before is not None:
        support, first, _ = result[before % count]
        turns = period if before < 0 else 0.0
        result[before % count] = (support, first, middle + turns)
    if after is not None:
        support, _, last = result[after % count]
        turns = period if after == count else 0.0
        result[after % count] = (support, middle - turns, last)
    del result[index]
    if count == 2:
        return result
    return _from_zero(_merged(result, cyclic=False), period, cyclic=cyclic)


def _from_zero(phases: _Phases, period: float, *, cyclic: bool) -> _Phases:
    """Join the ends of a cycle, and begin it with the phase that is on at time zero."""
    if not cyclic:
        return phases
    phases = list(phases)
    if len(phases) > 1 and phases[0][0] is phases[-1][0]:
        support, start, _ = phases.pop()
        phases[0] = (support, start - period, phases[0][2])
    while phases[0][1] > 1e-12:
        support, start, end = phases.pop()
        phases.insert(0, (support, start - period, end - period))
    while phases[0][2] <= 1e-12:
        support, start, end = phases.pop(0)
        phases.append((support, start + period, end + period))
    return phases


def frame_symbols(sequence: SupportSequence, fps: float, frames: int) -> str:
    """Return the support at each of so many frames, one of ``R L D -`` a frame."""
    supports = sequence.supports_at(np.arange(frames) / fps)
    return "".join(Support(support).symbol for support in supports.tolist())
