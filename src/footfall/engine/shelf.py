"""The motion library as the kernels take it, and the questions they ask of it."""

from __future__ import annotations

import math
from typing import NamedTuple

from footfall.arrays import Floats, Positions, Seconds, SmallFloats
from footfall.compilation import small_kernel
from footfall.engine.entry import Entries, Entry
from footfall.engine.layer_record import LayerShelf
from footfall.geometry import quaternions, transforms
from footfall.octets import LANES
from footfall.skeleton.normalized import ANKLES
from footfall.sync.tables import SequenceTable

__all__ = [
    "Shelf",
    "key_at",
    "phase_end",
    "phase_start",
    "read_points",
    "support_at",
    "travel",
    "travel_between",
]


class Shelf(NamedTuple):
    """All actions, packed for the kernels."""

    keys: SmallFloats
    """Normalized poses of all clips by component, one after the other, then the neutral one, shape
    (frames, 4 rows + 8)."""

    roots: Floats
    """The root of each of them: x, z in leg lengths, heading [rad], shape (frames, 3)."""

    sole_keys: SmallFloats
    """Heel and toe of each foot in each of those poses, relative to the root, in leg lengths: x of
    all four and z of all four; then z and -x, for a turn. Shape (frames, 16)."""

    entries: Entries
    """One record of `entry_type` for each action, shape (actions,)."""

    resting_heights: SmallFloats
    """Height of heel and toe of each foot over the ground while they carry, in leg lengths, and
    four zeros; the neutral motion is last. Shape (actions + 1, 8)."""

    table: SequenceTable
    """The support sequences; action i has sequence i."""

    phase_starts: Seconds
    """Clip time at which each phase begins [s], beside `table.supports`, shape (phases,)."""

    points: Positions
    """Heel and toe of each foot in the ankle's frame, in leg lengths, (2 feet, 2 points, 3).
    One foot for all motions: a point that meant another place in each would slide in a mix."""

    use_paper_cubic: bool
    """Whether time is warped, and durations are voted, literally as printed."""

    joints: int
    """How many joints a pose has."""

    layers: LayerShelf
    """What can be laid over all that."""


@small_kernel
def phase_start(entry: Entry, phase_starts: Seconds, phase: int) -> float:
    """Return the clip time [s] at which a phase of an action begins, cycles counted on."""
    if not entry.cyclic:
        if phase >= entry.phase_count:
            return entry.duration
        return phase_starts[entry.phase_first + phase]
    cycles = phase // entry.phase_count
    within = phase - cycles * entry.phase_count
    return cycles * entry.duration + phase_starts[entry.phase_first + within]


@small_kernel
def phase_end(entry: Entry, phase_starts: Seconds, phase: int) -> float:
    """Return the clip time [s] at which a phase of an action ends, cycles counted on."""
    return phase_start(entry, phase_starts, phase + 1)


@small_kernel
def key_at(entry: Entry, clip_time: float) -> tuple[int, float, int]:
    """Return the frame before a clip time, how far the next one is [0, 1), and the cycle."""
    cycle = 0
    if entry.duration <= 0.0:
        return entry.first_frame, 0.0, cycle
    if entry.cyclic:
        cycle = math.floor(clip_time / entry.duration)
        clip_time -= cycle * entry.duration
    place = min(max(clip_time, 0.0) * entry.fps, entry.frame_count - 1.0)
    frame = int(place)
    fraction = place - frame
    if frame >= entry.frame_count - 1:
        frame, fraction = entry.frame_count - 1, 0.0
    return entry.first_frame + frame, fraction, cycle


@small_kernel
def _root_at(roots: Floats, frame: int, fraction: float) -> tuple[float, float, float]:
    after = frame + 1 if fraction > 0.0 else frame
    one, other = roots[frame], roots[after]
    return (
        one[0] + fraction * (other[0] - one[0]),
        one[1] + fraction * (other[1] - one[1]),
        one[2] + fraction * (other[2] - one[2]),
    )


@small_kernel
def travel(roots: Floats, entry: Entry, before: float, after: float) -> tuple[float, float, float]:
    """Return where the root of a clip is at one time as seen from where it was at another.

    Args:
        roots: The root in every frame of the library, `Shelf.roots`.
        entry: Which clip.
        before: Clip time [s], past the end too.
        after: Clip time [s], not before `before`.

    Returns:
        x and z in leg lengths, and heading [rad].
    """
    return travel_between(roots, entry, key_at(entry, before), key_at(entry, after))


@small_kernel
def travel_between(
    roots: Floats, entry: Entry, one: tuple[int, float, int], other: tuple[int, float, int]
) -> tuple[float, float, float]:
    """Return what `travel` does, between places found by `key_at`."""
    frame, fraction, cycle = one
    x, z, heading = _root_at(roots, frame, fraction)
    next_frame, next_fraction, next_cycle = other
    next_x, next_z, next_heading = _root_at(roots, next_frame, next_fraction)
    first = roots[entry.first_frame]
    last = roots[entry.first_frame + entry.frame_count - 1]
    for _ in range(next_cycle - cycle):
        next_x, next_z, next_heading = transforms.relative(
            first[0], first[1], first[2], next_x, next_z, next_heading
        )
        next_x, next_z, next_heading = transforms.compose(
            last[0], last[1], last[2], next_x, next_z, next_heading
        )
    cosine, sine = transforms.cosine_and_sine(heading)
    step_x, step_z = transforms.turn(cosine, -sine, next_x - x, next_z - z)
    return step_x, step_z, next_heading - heading


@small_kernel
def read_points(shelf: Shelf, frame: int, fraction: float, out: SmallFloats) -> None:
    """Write heel and toe of each foot, relative to the root, in leg lengths, (2, 2, 3)."""
    keys = shelf.keys
    after = frame + 1 if fraction > 0.0 else frame
    rows = (keys.shape[1] - LANES) // 4
    for side in range(2):
        foot = shelf.joints + side
        place = 4 * rows + ANKLES + 3 * side
        w, x, y, z = quaternions.normalize(
            _key_between(keys, frame, after, fraction, foot),
            _key_between(keys, frame, after, fraction, foot + rows),
            _key_between(keys, frame, after, fraction, foot + 2 * rows),
            _key_between(keys, frame, after, fraction, foot + 3 * rows),
        )
        ankle_x = _key_between(keys, frame, after, fraction, place)
        ankle_y = _key_between(keys, frame, after, fraction, place + 1)
        ankle_z = _key_between(keys, frame, after, fraction, place + 2)
        for point in range(2):
            offset = shelf.points[side, point]
            px, py, pz = quaternions.rotate(w, x, y, z, offset[0], offset[1], offset[2])
            out[side, point, 0] = ankle_x + px
            out[side, point, 1] = ankle_y + py
            out[side, point, 2] = ankle_z + pz


@small_kernel
def _key_between(keys: SmallFloats, frame: int, after: int, fraction: float, column: int) -> float:
    one = float(keys[frame, column])
    return one + fraction * (float(keys[after, column]) - one)


@small_kernel
def support_at(shelf: Shelf, action: int, clip_time: float) -> int:
    """Return the support of a clip by itself at a clip time [s], past the end too."""
    entry = shelf.entries[action]
    first, index = entry.phase_first, entry.phase_count - 1
    if entry.cyclic:
        past = math.floor((clip_time - shelf.phase_starts[first]) / entry.duration)
        clip_time -= entry.duration * past
    while index > 0 and clip_time < shelf.phase_starts[first + index]:
        index -= 1
    return shelf.table.supports[first + index]
