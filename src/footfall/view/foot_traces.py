"""The ground from above: where the feet were planted, and where they slid."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.report import Trace, Track
from footfall.view.palette import BODY, FOOT_COLORS, SLIP
from footfall.view.plants import Plant, plants
from footfall.view.stage import Stage
from footfall.view.svg import Picture, points_text

__all__ = ["foot_traces_svg", "shoe_outline"]

WIDTH = 1200.0
MARGIN = 20.0
HEADING = 46.0
ROW_LENGTH = 6.5
TALLEST = 460.0

VISIBLE_SLIP = 0.015
"""A planted foot that moves farther than this is drawn as sliding [m]."""

# Outline of a shoe: along the foot from heel (0) to toe joint (1), and half its width [m].
_SHOE = (
    (-0.27, 0.012),
    (-0.22, 0.025),
    (-0.1, 0.033),
    (0.1, 0.034),
    (0.45, 0.031),
    (0.7, 0.038),
    (0.95, 0.046),
    (1.15, 0.046),
    (1.3, 0.037),
    (1.41, 0.019),
)
_SHOE_TIP = (1.45, 0.0)


@dataclass(frozen=True, eq=False)
class _Panel:
    title: str
    track: Track
    plants: tuple[Plant, ...]


@dataclass(frozen=True, slots=True)
class _Frame:
    """A map from the ground to one row of a panel."""

    stage: Stage
    start: float
    """Farthest back that the row shows [m]."""
    leftmost: float
    """Farthest left that it shows [m]."""
    scale: float
    """Pixels per meter."""

    def at(self, points: Positions) -> list[tuple[float, float]]:
        x = (self.stage.along(points) - self.start) * self.scale
        y = (self.leftmost - self.stage.leftward(points)) * self.scale
        return list(zip(x.tolist(), y.tolist(), strict=True))


def foot_traces_svg(motions: Sequence[tuple[str, Trace]]) -> str:
    """Draw the ground under several motions, one above the other, at the same scale.

    Planted feet are prints. Where one slides while it should carry, a red streak shows how far,
    with its length in millimeters (the inner slip of the span). Long ways are broken into rows.

    Args:
        motions: A title and a motion each.
    """
    tracks = [(title, Track.from_trace(trace)) for title, trace in motions]
    panels = [_Panel(title, track, plants(track)) for title, track in tracks]
    stage = Stage.of(panel.track.joints[:, 0] for panel in panels)
    along, leftward = _extent(stage, panels)
    rows = int(np.clip(round((along[1] - along[0]) / ROW_LENGTH), 1, 3))
    row_length = (along[1] - along[0]) / rows
    scale = min((WIDTH - 2 * MARGIN) / row_length, TALLEST / (leftward[1] - leftward[0]))
    row_height = (leftward[1] - leftward[0]) * scale
    panel_height = HEADING + rows * (row_height + 10.0)
    height = 44.0 + len(panels) * panel_height + 8.0
    picture = Picture("foot-traces", "Paths and prints of the feet from above", WIDTH, height)
    _legend(picture, scale)
    frame = _Frame(stage, along[0], leftward[1], scale)
    for index, panel in enumerate(panels):
        top = 44.0 + index * panel_height
        _draw_heading(picture, panel, top)
        _draw_panel(picture, panel, frame, f"foot-traces-{index}")
        for row in range(rows):
            _draw_row(
                picture,
                f"foot-traces-{index}",
                top + HEADING + row * (row_height + 10.0),
                (row * row_length * scale, row_length * scale, row_height),
            )
    return picture.to_svg()


def _extent(stage: Stage, panels: list[_Panel]) -> tuple[Floats, Floats]:
    """Return the least and the greatest place of any foot along and across the way [m]."""
    points = np.concatenate([panel.track.points.reshape(-1, 3) for panel in panels])
    along, leftward = stage.along(points), stage.leftward(points)
    return (
        np.array([along.min() - 0.25, along.max() + 0.25]),
        np.array([leftward.min() - 0.22, leftward.max() + 0.22]),
    )


def _legend(picture: Picture, scale: float) -> None:
    picture.words(20, 28, "Feet on the ground, from above", size=17, font_weight="600")
    x = 372.0
    for color, name in zip(FOOT_COLORS[::-1], ("right foot", "left foot"), strict=True):
        picture.rectangle(x, 17, 22, 11, rx=5.5, fill=color)
        picture.words(x + 29, 27, name, class_="soft")
        x += 108.0
    picture.line(x, 23, x + 24, 23, stroke=SLIP, stroke_width=5, stroke_linecap="round")
    picture.words(x + 34, 27, "slides while it should carry, mm", class_="soft")
    x += 240.0
    picture.line(x, 23, x + 24, 23, stroke=BODY, stroke_width=1.5, stroke_dasharray="5 4")
    picture.words(x + 32, 27, "body", class_="soft")
    meter = 0.5 * scale
    picture.line(WIDTH - MARGIN - meter, 26, WIDTH - MARGIN, 26, class_="softpen", stroke_width=1.5)
    picture.words(
        WIDTH - MARGIN - meter / 2, 20, "0.5 m", size=11, text_anchor="middle", class_="soft"
    )


def _draw_heading(picture: Picture, panel: _Panel, top: float) -> None:
    picture.words(20, top + 32, panel.title, size=15, font_weight="600")
    slips = [1000.0 * plant.slip for plant in panel.plants]
    if slips:
        facts = (
            f"slip of a planted foot: median {np.median(slips):.0f} mm, worst {max(slips):.0f} mm"
        )
        picture.words(WIDTH - MARGIN, top + 32, facts, text_anchor="end", class_="soft")


def _draw_row(picture: Picture, drawing: str, top: float, part: tuple[float, float, float]) -> None:
    """Show a part of a drawing: from where, how wide and how high [pixels]."""
    start, width, height = part
    picture.rectangle(MARGIN, top, WIDTH - 2 * MARGIN, height, rx=6, class_="panel")
    picture.open(
        "svg",
        x=(WIDTH - width) / 2,
        y=top,
        width=width,
        height=height,
        viewBox=f"{start:.2f} 0 {width:.2f} {height:.2f}",
    )
    picture.add("use", href=f"#{drawing}")
    picture.close("svg")


def _draw_panel(picture: Picture, panel: _Panel, frame: _Frame, name: str) -> None:
    """Define the drawing of a whole way once; rows show parts of it."""
    picture.open("defs")
    picture.open("g", id=name)
    pelvis = frame.at(panel.track.joints[::2, 0])
    picture.path(pelvis, stroke=BODY, stroke_width=1.5, stroke_dasharray="5 4", opacity=0.7)
    middles = panel.track.points.mean(axis=2)
    for foot, color in enumerate(FOOT_COLORS):
        picture.path(frame.at(middles[:, foot]), stroke=color, stroke_width=1.4, opacity=0.55)
    for plant in panel.plants:
        _draw_plant(picture, plant, frame)
    for plant in panel.plants:
        if plant.slip > VISIBLE_SLIP:
            _draw_streak(picture, plant, frame)
    picture.close("g")
    picture.close("defs")


def _draw_plant(picture: Picture, plant: Plant, frame: _Frame) -> None:
    slides = plant.slip > VISIBLE_SLIP
    outline = points_text(frame.at(shoe_outline(plant.print)))
    color = FOOT_COLORS[plant.foot]
    picture.add(
        "polygon", points=outline, fill=color, fill_opacity=0.4 if slides else 0.9, stroke=color
    )


def _draw_streak(picture: Picture, plant: Plant, frame: _Frame) -> None:
    """Draw the way of the ball of the foot, the print where it ended, and the length."""
    end = points_text(frame.at(shoe_outline(plant.print + plant.streak[-1])))
    picture.add("polygon", points=end, fill="none", stroke=SLIP, stroke_width=1.2)
    way = frame.at(plant.print[1] + plant.streak)
    picture.path(way, stroke=SLIP, stroke_width=5, stroke_linecap="round", stroke_linejoin="round")
    lowest, highest = min(y for _, y in way), max(y for _, y in way)
    y = lowest - 0.085 * frame.scale if plant.foot == 0 else highest + 0.085 * frame.scale + 9.0
    picture.words(
        0.5 * (way[0][0] + way[-1][0]),
        y,
        f"{1000.0 * plant.slip:.0f}",
        text_anchor="middle",
        fill=SLIP,
        font_weight="700",
    )


def shoe_outline(foot: Positions) -> Positions:
    """Return the outline of a shoe around heel and toe (2, 3), level, shape (points, 3)."""
    way = (foot[1] - foot[0]) * np.array([1.0, 0.0, 1.0])
    length = max(float(np.linalg.norm(way)), 0.06)
    ahead = way / length
    aside = np.array([ahead[2], 0.0, -ahead[0]])
    half = [(along, width) for along, width in _SHOE]
    around = [*half, _SHOE_TIP, *((along, -width) for along, width in reversed(half))]
    return np.array([foot[0] + along * length * ahead + width * aside for along, width in around])
