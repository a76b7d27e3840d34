"""All figures into a folder, with a page that shows them beside the paper's claims."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from footfall.figures.activation import activation_figure
from footfall.figures.animations import ANIMATIONS, write_animations
from footfall.figures.cast import Cast
from footfall.figures.changing_ground import changing_ground_figure
from footfall.figures.comparison import comparison_figure
from footfall.figures.delays import delays_figure
from footfall.figures.detector import detector_figure
from footfall.figures.extension import extension_figure
from footfall.figures.figure import Figure
from footfall.figures.held_element import held_element_figure
from footfall.figures.indices import indices_figure
from footfall.figures.linear_path import linear_path_figure
from footfall.figures.locomotion_cycle import locomotion_figure
from footfall.figures.priorities import priorities_figure
from footfall.figures.relation import relation_figure
from footfall.figures.shots import shots_figure
from footfall.figures.spline import spline_figure
from footfall.figures.time_warps import plain_warp_figure, smooth_warp_figure
from footfall.figures.walk_to_hop import walk_to_hop_figure
from footfall.io import write_atomically

__all__ = ["COMMAND", "DRAWINGS", "gallery_text", "write_gallery"]

DRAWINGS: dict[int, Callable[[Cast], Figure]] = {
    2: activation_figure,
    3: locomotion_figure,
    4: lambda _: relation_figure(),
    5: detector_figure,
    6: lambda _: extension_figure(),
    7: indices_figure,
    8: lambda _: held_element_figure(),
    9: lambda _: priorities_figure(),
    10: plain_warp_figure,
    11: spline_figure,
    12: smooth_warp_figure,
    13: shots_figure,
    14: walk_to_hop_figure,
    15: linear_path_figure,
    16: changing_ground_figure,
    17: comparison_figure,
    18: delays_figure,
}
"""What draws each figure, by its number; figure 1 is a diagram of the paper's engine."""

COMMAND = "footfall figures -o docs/gallery --no-animations"
"""What writes the gallery of this project."""

INTRODUCTION = """\
# The figures of the paper, drawn anew

Figures 2 to 18 of Ménardais, Kulpa, Multon & Arnaldi, *Synchronization for dynamic blending of
motions* (SCA 2004), each computed by this library when it is drawn. Under each stand the claim of
the paper and what was measured. Pictures of the paper that are lost are drawn from their captions.
"""


def write_gallery(folder: Path, cast: Cast, *, animations: bool = True) -> tuple[Figure, ...]:
    """Draw all figures into a folder, and a README.md that shows them.

    Args:
        folder: Where to; it is there.
        cast: Who plays.
        animations: Whether the files that play are written too.

    Raises:
        FileFormatError: If a file cannot be written.
    """
    figures: list[Figure] = []
    for draw in DRAWINGS.values():
        figure = draw(cast)
        write_atomically(folder / f"{figure.stem}.svg", figure.svg.encode())
        figures.append(figure)
    if animations:
        write_animations(folder, cast)
    text = gallery_text(tuple(figures), cast, animations=animations)
    write_atomically(folder / "README.md", text.encode())
    return tuple(figures)


def gallery_text(figures: tuple[Figure, ...], cast: Cast, *, animations: bool) -> str:
    """Return the page that shows figures, as Markdown."""
    parts = [INTRODUCTION, _origin(cast)]
    for figure in figures:
        facts = "\n".join(f"- {fact}" for fact in figure.facts)
        parts.append(
            f"## Figure {figure.number}. {figure.title}\n\n"
            f"![Figure {figure.number}: {figure.title}]({figure.stem}.svg)\n\n"
            f"> {figure.claim}\n\n{facts}\n"
        )
    shown = "\n".join(
        f"- {f'[{name}]({name})' if animations else f'`{name}`'}: {told}"
        for name, told in ANIMATIONS.items()
    )
    also = "" if animations else ", which the same command without `--no-animations` writes"
    parts.append(f"## Files that play{also}\n\n{shown}\n")
    return "\n".join(parts)


def _origin(cast: Cast) -> str:
    """Say which motions play, and which command drew them."""
    if not cast.origins:
        return f"The motions are the project’s own samples. Drawn by `{COMMAND}`.\n"
    played = "\n".join(f"- {role}: `{file}`" for role, file in cast.origins.items())
    return f"These files play parts; samples play the others.\n\n{played}\n"
