"""How values are spread, as a picture that needs no library."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from footfall.view.palette import SLIP

__all__ = ["histogram_svg"]

WIDTH, HEIGHT, MARGIN = 720, 150, 34
BINS = 40


def histogram_svg(values: Sequence[float], label: str) -> str:
    """Return a histogram as SVG; the last bar holds all that would squeeze the others.

    Args:
        values: What is counted, >= 0; there may be none.
        label: What they are, under the axis.
    """
    if not values:
        return "<p>There is nothing to measure.</p>"
    array = np.array(values)
    top = min(float(array.max()), 4.0 * float(np.percentile(array, 75.0))) or 1.0
    counts, edges = np.histogram(np.minimum(array, top), bins=BINS, range=(0.0, top))
    scale = (HEIGHT - MARGIN - 14) / counts.max()
    step = WIDTH / BINS
    bars = "".join(
        f'<rect x="{index * step + 0.5:.1f}" y="{HEIGHT - MARGIN - count * scale:.1f}" '
        f'width="{step - 1:.1f}" height="{count * scale:.1f}" fill="{SLIP}" fill-opacity="0.75">'
        f"<title>{_range(edges, index)}: {count} files</title></rect>"
        for index, count in enumerate(counts.tolist())
        if count
    )
    ticks = "".join(
        f'<text x="{share * WIDTH:.0f}" y="{HEIGHT - MARGIN + 15}" text-anchor="{anchor}">'
        f"{share * top:.1f}</text>"
        for share, anchor in ((0.0, "start"), (0.25, "middle"), (0.5, "middle"), (0.75, "middle"))
    )
    more = " and more" if array.max() > top else ""
    last = f'<text x="{WIDTH}" y="{HEIGHT - MARGIN + 15}" text-anchor="end">{top:.1f}{more}</text>'
    return (
        f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" role="img" aria-label="{label}">'
        f'<text x="0" y="10">at most {counts.max()} files</text>{bars}'
        f'<line x1="0" x2="{WIDTH}" y1="{HEIGHT - MARGIN}" y2="{HEIGHT - MARGIN}" '
        f'stroke="currentColor" stroke-opacity="0.3"/>{ticks}{last}'
        f'<text x="{WIDTH / 2}" y="{HEIGHT - 2}" text-anchor="middle">{label}</text></svg>'
    )


def _range(edges: np.ndarray[tuple[int], np.dtype[np.float64]], index: int) -> str:
    return f"{edges[index]:.1f} to {edges[index + 1]:.1f} mm"
