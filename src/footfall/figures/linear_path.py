"""Figure 15: side step, walk and back walk are mixed, so that a path is kept whatever is faced."""

from __future__ import annotations

import math

import numpy as np

from footfall.arrays import Floats
from footfall.figures.axes import Axes
from footfall.figures.cast import Cast
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.path_walk import ROLES, PathWalk, follow_curve, walk_and_turn
from footfall.figures.seen_from_above import draw_seen_from_above
from footfall.figures.silhouettes import Silhouettes
from footfall.figures.way import Way, apart
from footfall.view.palette import SUPPORT_COLORS
from footfall.view.svg import Picture
from footfall.view.text_width import text_width

__all__ = ["linear_path_figure"]

CLAIM = (
    "Dynamic blending and synchronization: a side step motion and a front/back walk, in order to "
    "force the avatar’s displacement on a linear path whatever its local orientation."
)
CURVE_HEIGHT = 300.0
"""Of the panel with the curved path."""

FILLS = (SUPPORT_COLORS["R"], SUPPORT_COLORS["D"], SUPPORT_COLORS["L"])
"""Of the parts, in their order."""


def linear_path_figure(cast: Cast) -> Figure:
    """Draw the character from the side and from above, and what it is mixed of."""
    walked = walk_and_turn(cast)
    title = "On a linear path, whatever the body faces"
    note = (
        "The character turns round while walk, side step and back walk are mixed so that it "
        "keeps to the line; from the side and from above, the shares; below, round a circle"
    )
    way = Way.of([walked.trace], tallest=290.0)
    base = TOP + way.height + 14.0
    above = base + 128.0
    curved = follow_curve(cast)
    picture = begin_sheet(15, title, note, above + 254.0 + CURVE_HEIGHT)
    picture.line(LEFT, base, WIDTH - LEFT, base, class_="softpen", stroke_width=1.2)
    silhouettes = Silhouettes(walked.trace, walked.recording.skeleton, way, base)
    for frame in apart(way, walked.trace, 0.42, 1.2):
        silhouettes.draw(picture, frame)
    _draw_from_above(picture, way, walked, above)
    _draw_shares(picture, way, walked, above + 112.0)
    _draw_curve(picture, curved, above + 234.0)
    away, away_round = (
        100.0 * float(np.percentile(np.abs(one.away), 95)) for one in (walked, curved)
    )
    turn = math.degrees(float(np.ptp(walked.headings)))
    slip = walked.report.slip.overall
    turned = math.degrees(float(np.abs(curved.headings).max()))
    facts = (
        f"The body turns by {turn:.0f}° over {float(np.ptp(walked.roots[:, 1])):.1f} m; "
        f"for 95 % of the time its root is within {away:.1f} cm of the line.",
        f"Planted feet slip {slip.median or 0.0:.1f} mm in the median, "
        f"95 % of them at most {slip.p95 or 0.0:.1f} mm.",
        f"Round most of a circle, facing one way within {turned:.0f}°, it is within "
        f"{away_round:.1f} cm of the path, and 95 % of the feet slip at most "
        f"{curved.report.slip.overall.p95 or 0.0:.1f} mm.",
    )
    return Figure(15, "linear_path", title, CLAIM, facts, picture.to_svg())


def _draw_from_above(picture: Picture, way: Way, walked: PathWalk, middle: float) -> None:
    """Draw the line, the prints of the feet, the way of the body and where it faces."""

    def at(points: Floats) -> list[tuple[float, float]]:
        x = way.x(0.0) + way.stage.along(points) * way.scale
        y = middle - way.stage.leftward(points) * way.scale
        return list(zip(x.tolist(), y.tolist(), strict=True))

    picture.rectangle(LEFT, middle - 96, WIDTH - 2 * LEFT, 192, rx=6, class_="panel")
    picture.line(LEFT, middle, WIDTH - LEFT, middle, class_="softpen", stroke_dasharray="2 5")
    draw_seen_from_above(picture, at, walked, apart(way, walked.trace, 0.42, 1.2))


def _draw_curve(picture: Picture, walked: PathWalk, top: float) -> None:
    """Draw a curved path from above, in the middle of its panel."""
    picture.rectangle(LEFT, top, WIDTH - 2 * LEFT, CURVE_HEIGHT, rx=6, class_="panel")
    low, high = walked.path.min(axis=0) - 0.5, walked.path.max(axis=0) + 0.5
    scale = CURVE_HEIGHT / float(high[0] - low[0])
    left = 0.5 * (WIDTH - scale * float(high[1] - low[1]))

    def at(points: Floats) -> list[tuple[float, float]]:
        # Ahead is to the right, the left side up, as in the picture above.
        x, y = left + scale * (points[:, 2] - low[1]), top + scale * (high[0] - points[:, 0])
        return list(zip(x.tolist(), y.tolist(), strict=True))

    path = np.column_stack([walked.path[:, 0], np.zeros(len(walked.path)), walked.path[:, 1]])
    picture.path(at(path), class_="softpen", stroke_dasharray="2 5")
    steps = np.linalg.norm(np.diff(walked.roots, axis=0), axis=1).cumsum()
    frames = [int(np.searchsorted(steps, gone)) for gone in np.arange(0.1, steps[-1], 0.7)]
    draw_seen_from_above(picture, at, walked, frames)


def _draw_shares(picture: Picture, way: Way, walked: PathWalk, top: float) -> None:
    """Draw the shares of the parts, one on the other, under where the body was."""
    recording = walked.recording
    names = list(recording.actions)
    shares = np.stack([recording.shares[:, names.index(role)] for role in ROLES])
    along = np.maximum.accumulate(way.stage.along(walked.trace.positions[:, 0]))
    axes = Axes(
        way.x(float(along[0])),
        top,
        way.x(float(along[-1])) - way.x(float(along[0])),
        92.0,
        (float(along[0]), float(along[-1])),
        (0.0, 1.0),
    )
    lower = np.zeros(len(along))
    for role, share, fill in zip(ROLES, shares, FILLS, strict=True):
        upper = lower + share
        _draw_share(picture, axes, along, (lower, upper), fill)
        center = _middle_of_greatest(share)
        y = axes.y(float((lower[center] + upper[center]) / 2)) + 5
        if float(share.max()) > 0.25:
            half = 0.5 * text_width(role, 15, bold=True) + 8.0
            x = min(max(axes.x(float(along[center])), axes.left + half), axes.right - half)
            picture.words(
                x, y, role, size=15, text_anchor="middle",
                font_weight="600", fill="#10151a",
            )  # fmt: skip
        lower = upper


def _draw_share(
    picture: Picture, axes: Axes, along: Floats, bounds: tuple[Floats, Floats], fill: str
) -> None:
    """Draw the area between two curves over the way, a corner every third frame."""
    x, lower, upper = along[::3], bounds[0][::3], bounds[1][::3]
    outline = [axes.at(float(a), float(b)) for a, b in zip(x, upper, strict=True)]
    outline += [axes.at(float(a), float(b)) for a, b in zip(x[::-1], lower[::-1], strict=True)]
    picture.area(outline, fill=fill, fill_opacity=0.8)


def _middle_of_greatest(share: Floats) -> int:
    """Return the middle frame of where a share is near its greatest value."""
    near = np.flatnonzero(share >= 0.9 * share.max())
    return int(near[len(near) // 2])
