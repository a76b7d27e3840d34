"""How an action fades in and out (figure 2: t1 start, t2 active, t3 stop, t4 gone).

A fade is a progress from 0 to 1. Fading in, the action's level is `level(progress)`; fading out
it is ``1 - level(progress)``. Weights that move while both feet carry, or none, make feet slide
or bend a flight; so the progress waits there (S-27), for as long as the fade asked for at most.
"""

from __future__ import annotations

from footfall.compilation import kernel, small_kernel

__all__ = ["advance_progress", "level", "reverse_fade", "smoothstep"]

# Sums of frame times miss 1 by rounding; a fade that close to its end is over.
_COMPLETE = 1.0 - 1e-13
_SHORTEST = 1e-9  # Of a fade [s]: the reciprocal of a much shorter one is infinite.


@small_kernel
def smoothstep(x: float) -> float:
    """Return 0 below 0, 1 above 1, and between them the cubic that is level at both ends."""
    if x <= 0.0:
        return 0.0
    if x >= 1.0:
        return 1.0
    return x * x * (3.0 - 2.0 * x)


@small_kernel
def level(progress: float) -> float:
    """Return the level, 0..1, of an action that fades in, at this progress of its fade.

    A fade out has the level ``1 - level(progress)``, which equals ``level(1 - progress)``.
    """
    return smoothstep(progress)


@small_kernel
def advance_progress(
    progress: float, elapsed: float, asked: float, dt: float, pace: float
) -> float:
    """Return the progress of a fade after `dt`.

    At full pace, progress gains 1 in `asked` seconds. Where weights may move only slowly or not
    at all it waits, until waiting any longer would make the fade last more than twice as long as
    asked: from that moment on it runs, so that it is complete at exactly twice the time asked.
    Hence every fade lasts at least `asked` and at most twice that, and at a steady pace cutting
    `dt` into pieces changes nothing.

    Args:
        progress: How far the fade is, 0..1.
        elapsed: Time since the fade began [s], `dt` not included.
        asked: How long the fade should last [s], >= 0; one shorter than a nanosecond is over at
            once.
        dt: Time to advance by [s], >= 0.
        pace: How fast weights may move all this time, 0 to 1, which is full pace.
    """
    if asked < _SHORTEST:
        return 1.0
    # Time that can still be spent below full pace, and how long it lasts at this pace.
    spare = 2.0 * asked - elapsed - (1.0 - progress) * asked
    easy = dt if spare >= 0.0 else 0.0
    if pace < 1.0:
        easy = min(max(spare, 0.0) / (1.0 - pace), dt)
    running = dt - easy
    moved = progress + pace / asked * easy
    if running > 0.0:
        left = 2.0 * asked - elapsed - easy
        if running >= left:
            return 1.0
        # The second is the greater one only for a fade that is already late.
        moved += max(1.0 / asked, (1.0 - moved) / left) * running
    return 1.0 if moved >= _COMPLETE else moved


@kernel
def reverse_fade(progress: float, asked: float) -> tuple[float, float]:
    """Return progress and elapsed time [s] of the opposite fade, begun in the middle of one.

    The level does not jump. What is left of the new fade lasts between the same share of
    `asked`, the time asked for the new fade [s], and twice that.
    """
    begun = 1.0 - progress
    return (begun, 2.0 * begun * asked)
