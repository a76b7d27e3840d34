"""Figures drawn from the samples, once for all tests, and what stands in their pictures."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from functools import cache

from footfall.figures import DRAWINGS, Cast, Figure

SVG = "{http://www.w3.org/2000/svg}"


@cache
def cast() -> Cast:
    return Cast.of_samples()


@cache
def drawn(number: int) -> Figure:
    return DRAWINGS[number](cast())


def picture(number: int) -> ElementTree.Element:
    return ElementTree.fromstring(drawn(number).svg)


def words(number: int) -> list[str]:
    """Return all texts of a figure, in the order in which they are drawn."""
    return [text.text or "" for text in picture(number).iter(f"{SVG}text")]


def numbers(text: str) -> list[float]:
    return [float(found) for found in re.findall(r"-?\d+\.?\d*", text.replace("−", "-"))]


def points(element: ElementTree.Element) -> list[tuple[float, float]]:
    """Return the corners of a line or an outline."""
    pairs = [pair.split(",") for pair in element.attrib["points"].split()]
    return [(float(x), float(y)) for x, y in pairs]


def attributes(number: int, tag: str, **wanted: str) -> list[dict[str, str]]:
    """Return the attributes of all elements of a kind that have these."""
    names = {name.replace("_", "-"): value for name, value in wanted.items()}
    return [
        element.attrib
        for element in picture(number).iter(f"{SVG}{tag}")
        if all(element.attrib.get(name) == value for name, value in names.items())
    ]
