"""From clock time to clip time: never backward, never a jump in speed (section 5.3).

While a slot is played, each of its actions follows one Hermite segment, from where its clip is
now, with the speed it has now, to the end of its phase at the end of the slot. Whenever the end
of the slot moves, the segment is built anew from the present moment, and nothing jumps. What
is left to choose is the speed at the end of the slot.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Indices, Seconds, frozen
from footfall.compilation import kernel, small_kernel
from footfall.errors import ArgumentError
from footfall.geometry.curves import cubic_hermite, rational_hermite

__all__ = ["TimeWarp", "end_slope", "end_slope_paper", "warp"]


@small_kernel
def end_slope_paper(mean: float, rate: float) -> float:
    """Return the rate at the end of a slot, as printed (figures 11D and 11E).

    The mirror image of the present `rate` about the `mean` rate of the rest of the slot,
    bounded to 0..3 mean. It rings: what is too fast now is as much too slow at the end.
    """
    return min(max(2.0 * mean - rate, 0.0), 3.0 * mean)


@small_kernel
def end_slope(mean: float, next_mean: float) -> float:
    """Return the rate at the end of a slot that suits both slots that meet there.

    The harmonic mean of the mean rates of the rest of this slot and of the next one, known
    from the look-ahead: at most twice the smaller, and 0 where either is 0.
    """
    if mean <= 0.0 or next_mean <= 0.0:
        return 0.0
    return 2.0 * mean * next_mean / (mean + next_mean)


@small_kernel
def warp(
    t: float,
    t0: float,
    h0: float,
    v0: float,
    t1: float,
    h1: float,
    v1: float,
    use_paper_cubic: bool,
) -> tuple[float, float]:
    """Return clip time [s] and rate at clock time `t` [s].

    Args:
        t: Clock time [s], within t0..t1.
        t0: Clock time at which the segment was built [s].
        h0: Clip time there [s].
        v0: Rate there, >= 0.
        t1: Clock time at which the slot ends [s].
        h1: Clip time there [s], >= h0.
        v1: Rate there, >= 0.
        use_paper_cubic: Follow the paper's cubic wherever it is certain to be monotone, that
            is, unless a rate is above three times the mean (S-25); else the rational
            quadratic, which always is.
    """
    if use_paper_cubic and max(v0, v1) * (t1 - t0) <= 3.0 * (h1 - h0):
        return cubic_hermite(t, t0, h0, v0, t1, h1, v1)
    return rational_hermite(t, t0, h0, v0, t1, h1, v1)


@kernel
def _follow(
    times: Seconds,
    slots: Indices,
    clock_times: Seconds,
    clip_times: Seconds,
    rates: Floats,
    use_paper_cubic: bool,
    out_clip_times: Seconds,
    out_rates: Floats,
) -> None:
    for index in range(times.shape[0]):
        k = int(slots[index])
        out_clip_times[index], out_rates[index] = warp(
            times[index],
            clock_times[k],
            clip_times[k],
            rates[k],
            clock_times[k + 1],
            clip_times[k + 1],
            rates[k + 1],
            use_paper_cubic,
        )


@dataclass(frozen=True, eq=False)
class TimeWarp:
    """A whole time warp t' = H(t), slot after slot, for figures and reports.

    Raises:
        ArgumentError: If there are fewer than two knots, the arrays differ in shape, clock
            times do not increase, clip times decrease, or a rate is negative or not finite.
    """

    clock_times: Seconds
    """Where the slots begin, and the last one ends [s], increasing, shape (knots,)."""

    clip_times: Seconds
    """Where the clip is there [s], never decreasing, shape (knots,)."""

    rates: Floats
    """Clip time per clock time there, >= 0, shape (knots,)."""

    use_paper_cubic: bool = False
    """Whether the paper's cubic is followed where it is monotone."""

    def __post_init__(self) -> None:
        clock, clip, rates = (
            frozen(array) for array in (self.clock_times, self.clip_times, self.rates)
        )
        if clock.ndim != 1 or len(clock) < 2 or not clock.shape == clip.shape == rates.shape:
            raise ArgumentError(
                f"knots of shapes {clock.shape}, {clip.shape} and {rates.shape}; "
                "a time warp needs three equal ones of at least (2,)"
            )
        for label, times, wrong, rule in (
            ("clock times", clock, ~(np.diff(clock) > 0.0), "increase"),
            ("clip times", clip, ~(np.diff(clip) >= 0.0), "never decrease"),
        ):
            if wrong.any():
                k = int(wrong.argmax()) + 1
                raise ArgumentError(
                    f"{label} must {rule}, but knot {k} is at {times[k]} after {times[k - 1]}"
                )
        wrong = ~((rates >= 0.0) & np.isfinite(rates))
        if wrong.any():
            k = int(wrong.argmax())
            raise ArgumentError(
                f"rates must be finite and >= 0, but the one at knot {k} is {rates[k]}"
            )
        object.__setattr__(self, "clock_times", clock)
        object.__setattr__(self, "clip_times", clip)
        object.__setattr__(self, "rates", rates)

    @classmethod
    def through(
        cls,
        clock_times: Seconds,
        clip_times: Seconds,
        *,
        next_mean: float | None = None,
        paper: bool = False,
    ) -> TimeWarp:
        """Choose the rates at the knots, as the engine does when no duration changes.

        Args:
            clock_times: Where the slots begin, and the last one ends [s], shape (knots,).
            clip_times: Where the clip is there [s], shape (knots,).
            next_mean: Mean rate after the last knot: 0 where the action ends there, None
                where it goes on as before.
            paper: Use the paper's end slopes and cubic (figures 11 and 12), not the default.
        """
        means = np.diff(clip_times) / np.diff(clock_times)
        rates = np.empty(len(clock_times))
        rates[0] = means[0]
        following = np.append(means[1:], means[-1] if next_mean is None else next_mean)
        for k, mean in enumerate(means):
            rates[k + 1] = (
                end_slope_paper(mean, rates[k]) if paper else end_slope(mean, following[k])
            )
        return cls(clock_times, clip_times, rates, paper)

    def at(self, times: Seconds) -> tuple[Seconds, Floats]:
        """Return clip times [s] and rates at clock `times` [s], shape (times,) each."""
        times = np.ascontiguousarray(times, dtype=np.float64)
        slots = np.searchsorted(self.clock_times, times, side="right") - 1
        clip_times = np.empty(times.shape)
        rates = np.empty(times.shape)
        _follow(
            times,
            np.clip(slots, 0, len(self.clock_times) - 2),
            self.clock_times,
            self.clip_times,
            self.rates,
            self.use_paper_cubic,
            clip_times,
            rates,
        )
        return clip_times, rates
