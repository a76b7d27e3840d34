"""Figures 10 and 12: the time warp with its corners, and the smooth one."""

from __future__ import annotations

import numpy as np

from footfall.figures.arrows import draw_legend
from footfall.figures.axes import Axes
from footfall.figures.cast import Cast
from footfall.figures.cells import ON_COLOR, color_of, notation
from footfall.figures.figure import TOP, Figure, begin_sheet
from footfall.figures.warp_example import LEADER, OTHER, WarpExample
from footfall.timing import TimeWarp
from footfall.view.palette import BODY, SLIP, SUPPORT_COLORS
from footfall.view.svg import Picture

__all__ = ["plain_warp_figure", "smooth_warp_figure"]

PLAIN, PRINTED, OURS = BODY, SUPPORT_COLORS["R"], SUPPORT_COLORS["L"]
BAND = 26.0


def plain_warp_figure(cast: Cast) -> Figure:
    """Draw the plain time warp: a straight piece a slot."""
    example = WarpExample.of(cast)
    title = "Non-derivable initial time warping"
    note = (
        f"A {LEADER} whose phases (left) last as long as the slots that it shares with a "
        f"{OTHER} (below, eq. 6): a corner at each knot"
    )
    picture = begin_sheet(10, title, note, 676.0)
    axes = _warp_axes(example, 130.0, TOP + 18.0, 1030.0, 486.0)
    _draw_frame(picture, axes, example)
    axes.curve(picture, *_diagonal(example), stroke=BODY, stroke_width=1.5, stroke_dasharray="3 5")
    axes.curve(picture, example.clock_times, example.clip_times, stroke=OURS, stroke_width=3.4)
    for time, clip in zip(example.clock_times.tolist(), example.clip_times.tolist(), strict=True):
        axes.mark(picture, time, clip, OURS)
    draw_legend(picture, axes.left + 18, axes.top + 28, OURS, "t′ = H(t)")
    draw_legend(picture, axes.left + 150, axes.top + 28, BODY, "own speed", dashed=True)
    rates = example.rates
    facts = (
        f"Rates of the {len(rates)} slots: {', '.join(f'{rate:.2f}' for rate in rates)}.",
        f"Greatest jump of the rate at a knot: {np.abs(np.diff(rates)).max():.2f}.",
    )
    claim = "Non derivable initial time warping."
    return Figure(10, "plain_time_warp", title, claim, facts, picture.to_svg())


def smooth_warp_figure(cast: Cast) -> Figure:
    """Draw the smooth time warps through the same knots, and their rates."""
    example = WarpExample.of(cast)
    warps = (
        (TimeWarp.through(example.clock_times, example.clip_times, paper=True), PRINTED),
        (TimeWarp.through(example.clock_times, example.clip_times), OURS),
    )
    title = "Final monotonic time warping"
    note = (
        "The same knots as in figure 10. Below, the rate dt′/dt: the printed end slopes ring, "
        "harmonic ones do not; both are never negative and never jump"
    )
    picture = begin_sheet(12, title, note, 856.0)
    axes = _warp_axes(example, 130.0, TOP + 18.0, 1030.0, 386.0)
    _draw_frame(picture, axes, example)
    times = np.linspace(0.0, float(example.clock_times[-1]), 1201)
    rates = [warp.at(times)[1] for warp, _ in warps]
    below = _draw_rate_frame(picture, axes, max(float(rate.max()) for rate in rates))
    for curve_axes, plain in (
        (axes, (example.clock_times, example.clip_times)),
        (below, (np.repeat(example.clock_times, 2)[1:-1], np.repeat(example.rates, 2))),
    ):
        curve_axes.curve(picture, *plain, stroke=PLAIN, stroke_width=1.6, stroke_dasharray="5 4")
    for (warp, color), rate in zip(warps, rates, strict=True):
        axes.curve(picture, times, warp.at(times)[0], stroke=color, stroke_width=3.2)
        below.curve(picture, times, rate, stroke=color, stroke_width=2.6)
    for time, clip in zip(example.clock_times.tolist(), example.clip_times.tolist(), strict=True):
        axes.mark(picture, time, clip, SLIP, 3.6)
    _draw_legends(picture, axes)
    facts = tuple(
        f"{name}: rate {rate.min():.2f} to {rate.max():.2f}, "
        f"greatest step back {max(0.0, float(-np.diff(warp.at(times)[0]).min())):g} s."
        for name, (warp, _), rate in zip(("As printed", "footfall"), warps, rates, strict=True)
    )
    claim = "Final monotonic time warping."
    return Figure(12, "smooth_time_warp", title, claim, facts, picture.to_svg())


def _draw_rate_frame(picture: Picture, above: Axes, highest: float) -> Axes:
    """Draw the panel of the rates under the one of the warps."""
    place = (above.left, above.bottom + 118.0, above.width, 190.0)
    axes = Axes(*place, above.x_range, (0.0, 1.1 * highest))
    seconds = np.arange(0.0, axes.x_range[1], 0.2).round(6).tolist()
    axes.draw(picture, x_ticks=seconds, y_ticks=(0.0, 1.0, 2.0), y_label="rate dt′/dt")
    picture.words(axes.right, axes.bottom + 38, "t [s]", size=14, text_anchor="end", class_="soft")
    return axes


def _draw_legends(picture: Picture, axes: Axes) -> None:
    for place, (color, told, dashed) in enumerate(
        ((PRINTED, "as printed", False), (OURS, "footfall", False), (PLAIN, "figure 10", True))
    ):
        x = axes.left + 18 + 140 * place
        draw_legend(picture, x, axes.top + 28, color, told, dashed=dashed)


def _warp_axes(example: WarpExample, left: float, top: float, width: float, height: float) -> Axes:
    end, clip_end = float(example.clock_times[-1]), float(example.clip_times[-1])
    return Axes(left, top, width, height, (0.0, end), (0.0, clip_end))


def _diagonal(example: WarpExample) -> tuple[np.ndarray, np.ndarray]:
    end = min(float(example.clock_times[-1]), float(example.clip_times[-1]))
    return np.array([0.0, end]), np.array([0.0, end])


def _draw_frame(picture: Picture, axes: Axes, example: WarpExample) -> None:
    """Draw the panel, its knots as lines, and the phases along both sides."""
    axes.draw(picture)
    for time, clip in zip(example.clock_times.tolist(), example.clip_times.tolist(), strict=True):
        x, y = axes.at(time, clip)
        picture.line(x, y, x, axes.bottom + 6, class_="rule", stroke_width=1.2)
        picture.line(axes.left - 6, y, x, y, class_="rule", stroke_width=1.2)
    for slot, support in enumerate(example.supports):
        left, right = (axes.x(float(example.clock_times[slot + i])) for i in (0, 1))
        low, high = (axes.y(float(example.clip_times[slot + i])) for i in (0, 1))
        fill = color_of(support)
        picture.rectangle(left + 1, axes.bottom + 6, right - left - 2, BAND, rx=3, fill=fill)
        picture.rectangle(
            axes.left - 6 - BAND - 8, high + 1, BAND + 8, low - high - 2, rx=3, fill=fill
        )
        for x, y, room in (
            ((left + right) / 2, axes.bottom + 6 + BAND / 2, right - left),
            (axes.left - 6 - (BAND + 8) / 2, (low + high) / 2, 1.6 * (low - high)),
        ):
            if room > 24:
                picture.words(
                    x, y + 5, notation(support), size=14, text_anchor="middle",
                    font_weight="600", fill=ON_COLOR,
                )  # fmt: skip
    y = axes.bottom + BAND + 28
    middle = (axes.left + axes.right) / 2
    picture.words(middle, y, "clock time t [s]", size=14, text_anchor="middle", class_="soft")
    for time in axes.x_range:
        told = f"{time:.2f}"
        picture.words(axes.x(time), y, told, size=13, text_anchor="middle", class_="soft")
    picture.words(24, axes.top - 4, "clip time t′ [s]", size=14, class_="soft")
    for clip in axes.y_range:
        x, y = axes.left - BAND - 22, axes.y(clip) + (14 if clip else 0)
        picture.words(x, y, f"{clip:.2f}", size=13, text_anchor="end", class_="soft")
