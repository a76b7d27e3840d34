"""Pictures as SVG text, written element by element: no plotting library, the same bytes each time.

Colors of paper, ink and rules follow the reader's light or dark scheme; all other colors mean
something and stay.
"""

from __future__ import annotations

from collections.abc import Iterable
from html import escape

__all__ = ["Picture", "number", "points_text"]

_STYLE = (
    "text{font-family:system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif}"
    ".paper{fill:#ffffff}.ink{fill:#1d2228}.soft{fill:#66707c}.panel{fill:#f5f6f8}"
    ".rule{stroke:#dde1e6}.pen{stroke:#1d2228}.softpen{stroke:#66707c}"
    "@media(prefers-color-scheme:dark){"
    ".paper{fill:#14181d}.ink{fill:#e6e9ed}.soft{fill:#9aa4b0}.panel{fill:#1b2027}"
    ".rule{stroke:#2d343d}.pen{stroke:#e6e9ed}.softpen{stroke:#9aa4b0}}"
)


def number(value: float) -> str:
    """Return a coordinate with at most two decimals, and never ``-0``."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def points_text(points: Iterable[tuple[float, float]]) -> str:
    """Return points as SVG writes them."""
    return " ".join(f"{number(x)},{number(y)}" for x, y in points)


class Picture:
    """An SVG picture that grows by appending; x to the right and y down, in pixels."""

    def __init__(self, name: str, title: str, width: float, height: float) -> None:
        """Begin a picture.

        Args:
            name: A word that no other picture of a page has; ids begin with it.
            title: What it shows, for those who cannot see it.
            width: Width [pixels].
            height: Height [pixels].
        """
        self.name = name
        self.title = title
        self.width = width
        self.height = height
        self._parts: list[str] = []

    def add(self, tag: str, /, **attributes: float | str | None) -> None:
        """Append an element; an underscore in an attribute's name stands for a hyphen."""
        self._parts.append(f"<{tag}{_attributes(attributes)}/>")

    def open(self, tag: str, /, **attributes: float | str | None) -> None:
        """Begin an element that holds what is appended until `close`."""
        self._parts.append(f"<{tag}{_attributes(attributes)}>")

    def close(self, tag: str) -> None:
        """End the element begun last."""
        self._parts.append(f"</{tag}>")

    def rectangle(
        self,
        left: float,
        top: float,
        width: float,
        height: float,
        **attributes: float | str | None,
    ) -> None:
        """Append a rectangle."""
        self.add("rect", x=left, y=top, width=width, height=height, **attributes)

    def line(
        self, x1: float, y1: float, x2: float, y2: float, **attributes: float | str | None
    ) -> None:
        """Append a straight line."""
        self.add("line", x1=x1, y1=y1, x2=x2, y2=y2, **attributes)

    def path(self, points: Iterable[tuple[float, float]], **attributes: float | str | None) -> None:
        """Append an open line through points."""
        self.add("polyline", points=points_text(points), fill="none", **attributes)

    def area(self, points: Iterable[tuple[float, float]], **attributes: float | str | None) -> None:
        """Append a closed, filled outline."""
        self.add("polygon", points=points_text(points), **attributes)

    def words(
        self,
        x: float,
        y: float,
        text: str,
        *,
        size: float = 12.0,
        **attributes: float | str | None,
    ) -> None:
        """Append a line of text that starts at x and stands on y."""
        kind = None if "fill" in attributes else "ink"
        styled = {"class": kind, "x": x, "y": y, "font_size": size, **attributes}
        inner = f"{_attributes(styled)}>{escape(text)}"
        self._parts.append(f"<text{inner}</text>")

    def to_svg(self, **data: float | str) -> str:
        """Return the whole picture as an SVG document.

        Args:
            **data: Facts for scripts, written as ``data-`` attributes.
        """
        facts = {f"data_{name}": value for name, value in data.items()}
        size = f"{number(self.width)} {number(self.height)}"
        head = _attributes(
            {
                "xmlns": "http://www.w3.org/2000/svg",
                "class": f"picture {self.name}",
                "viewBox": f"0 0 {size}",
                "width": self.width,
                "height": self.height,
                "role": "img",
                **facts,
            }
        )
        return "\n".join(
            [
                f"<svg{head}>",
                f"<title>{escape(self.title)}</title>",
                f"<style>{_STYLE}</style>",
                '<rect width="100%" height="100%" class="paper"/>',
                *self._parts,
                "</svg>\n",
            ]
        )


def _attributes(attributes: dict[str, float | str | None]) -> str:
    """Return attributes as text; those that are None are left out."""
    written: dict[str, str] = {}
    for name, value in attributes.items():
        if value is not None:
            text = value if isinstance(value, str) else number(value)
            written[name.rstrip("_").replace("_", "-")] = escape(text)
    return "".join(f' {name}="{text}"' for name, text in written.items())
