"""A picture of what a frame costs: against the size of a crowd, and against its actions."""

from __future__ import annotations

import math

from footfall.benchmark.crowds import DT, mixing_crowd
from footfall.benchmark.rows import seconds_each
from footfall.view.svg import Picture

__all__ = ["cost_picture", "measure_costs"]

SIZES = (1, 8, 100, 1000, 10_000, 100_000)
ACTIONS = tuple(range(1, 9))

WIDTH, HEIGHT, EDGE = 420.0, 280.0, 50.0

Costs = dict[int, float]
"""Microseconds a character, by size or by number of actions."""


def measure_costs() -> tuple[Costs, Costs]:
    """Return the cost of a frame by size, with three actions, and by actions, for 1 000."""
    by_size = {rows: _cost(rows, 3) for rows in SIZES}
    return by_size, {count: _cost(1000, count) for count in ACTIONS}


def _cost(rows: int, actions: int) -> float:
    crowd = mixing_crowd(rows, actions)
    rounds = 5 if rows > 20_000 else 20
    return 1e6 * seconds_each(lambda: crowd.advance(DT), rounds, max(1, 200 // rows)) / rows


def cost_picture(by_size: Costs, by_actions: Costs) -> str:
    """Return both curves as an SVG document."""
    picture = Picture("costs", "What a frame costs a character", 2 * WIDTH, HEIGHT)
    spread = {math.log10(size): cost for size, cost in by_size.items()}
    _draw(picture, 0.0, spread, "characters (powers of ten), 3 actions")
    _draw(picture, WIDTH, {float(k): cost for k, cost in by_actions.items()}, "actions, N = 1 000")
    return picture.to_svg()


def _draw(picture: Picture, left: float, costs: dict[float, float], words: str) -> None:
    highest = max(costs.values()) * 1.1
    first, last = min(costs), max(costs)
    base, inner = HEIGHT - EDGE, WIDTH - 2 * EDGE

    def place(x: float, cost: float) -> tuple[float, float]:
        across = left + EDGE + inner * (x - first) / (last - first)
        return across, base - (HEIGHT - 2 * EDGE) * cost / highest

    picture.line(left + EDGE, base, left + EDGE + inner, base, class_="pen")
    picture.line(left + EDGE, EDGE, left + EDGE, base, class_="pen")
    picture.words(left + EDGE, EDGE - 15, "µs a character")
    picture.words(left + EDGE, HEIGHT - 10, words)
    picture.path([place(*pair) for pair in costs.items()], stroke="#2a7ab8", stroke_width=2)
    for x, cost in costs.items():
        at = place(x, cost)
        picture.add("circle", cx=at[0], cy=at[1], r=3, fill="#2a7ab8")
        picture.words(at[0] - 8, at[1] - 8, f"{cost:.2f}", size=10)
        picture.words(at[0] - 3, base + 15, f"{x:g}", size=10)
