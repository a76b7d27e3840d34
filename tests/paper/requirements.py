"""What the paper asks for, and the mark of a test that shows it.

`requirements.toml` has the numbers and the paper's own words. A test says which of them it shows,

    @requirement(43, "As our relation is commutative, two motions")
    def test_order_never_matters() -> None: ...

and `test_every_requirement.py` sees to it that none is missing here or in `docs/paper.md`.
"""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

__all__ = ["REQUIREMENTS", "Requirement", "requirement"]

Function = TypeVar("Function", bound=Callable[..., Any])


@dataclass(frozen=True, slots=True)
class Requirement:
    """One thing that the paper asks for."""

    number: int
    """Its number, from 1 on."""

    place: str
    """The section, figure or equation; "implied" where the paper does not say it."""

    sentence: str
    """The paper's own words; ours where it is implied."""


def _read() -> dict[int, Requirement]:
    table = tomllib.loads((Path(__file__).parent / "requirements.toml").read_text("utf-8"))
    return {entry["number"]: Requirement(**entry) for entry in table["requirement"]}


REQUIREMENTS = _read()


def requirement(number: int, sentence: str) -> Callable[[Function], Function]:
    """Mark a test that shows a requirement.

    Args:
        number: Of the requirement.
        sentence: The paper's words, so that whoever reads the test sees what it shows.

    Raises:
        ValueError: If there is no such requirement, or it reads differently.
    """
    if number not in REQUIREMENTS:
        raise ValueError(f"no requirement {number}; there are 1 to {len(REQUIREMENTS)}")
    if sentence != REQUIREMENTS[number].sentence:
        raise ValueError(f"requirement {number} reads {REQUIREMENTS[number].sentence!r}")
    return lambda function: function
