"""Ground as heights on a grid, from an array, a file or a grey image."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Floats, frozen
from footfall.errors import ArgumentError, FileFormatError

__all__ = ["HeightField", "check_finite", "check_positive"]


def check_finite(what: str, *numbers: float) -> None:
    """Raise an `ArgumentError` about the first number that is not finite."""
    for number in numbers:
        if not math.isfinite(number):
            raise ArgumentError(f"{what} {number}; it must be a finite number [m]")


def check_positive(what: str, **sizes: float) -> None:
    """Raise an `ArgumentError` about the first size [m] that is not finite and > 0."""
    for name, size in sizes.items():
        if not (size > 0.0 and math.isfinite(size)):
            raise ArgumentError(f"{what} with a {name} of {size} m; it must be > 0")


@dataclass(frozen=True, eq=False)
class HeightField:
    """Heights on a grid, linear between them.

    Raises:
        ArgumentError: If there are not 2 x 2 heights, one is not finite, or the spacing is not
            positive.
    """

    heights: Floats
    """y at each place [m], shape (along z, along x)."""

    spacing: float = 0.1
    """Between neighbors [m]."""

    middle: tuple[float, float] = field(default=(0.0, 0.0))
    """Where the middle of the grid is: x, z [m]; beyond its edge the ground goes on level."""

    def __post_init__(self) -> None:
        heights = frozen(self.heights)
        if heights.ndim != 2 or min(heights.shape) < 2:
            raise ArgumentError(f"heights of shape {heights.shape}; a grid of 2 × 2 is the least")
        if not np.isfinite(heights).all():
            row, column = (int(i) for i in np.argwhere(~np.isfinite(heights))[0])
            raise ArgumentError(f"the height at row {row}, column {column} is not finite")
        check_positive("a height field", spacing=self.spacing)
        check_finite("a height field with its middle at", *self.middle)
        object.__setattr__(self, "heights", heights)

    @classmethod
    def load(cls, path: Path | str) -> HeightField:
        """Read a ``.npz`` with `heights`, and optionally `spacing` and `middle`.

        Raises:
            FileFormatError: If there is no such file, or it holds no grid.
        """
        try:
            with np.load(path, allow_pickle=False) as stored:
                spacing = float(stored["spacing"]) if "spacing" in stored else 0.1
                middle = stored["middle"].tolist() if "middle" in stored else (0.0, 0.0)
                return cls(stored["heights"], spacing, (float(middle[0]), float(middle[1])))
        except FileNotFoundError:
            raise FileFormatError("there is no such file; check the name", path=path) from None
        except (OSError, ValueError, KeyError, TypeError, IndexError, EOFError) as error:
            told = " ".join(str(error).split())
            raise FileFormatError(f"holds no height field: {told}", path=path) from None

    @classmethod
    def from_image(
        cls, path: Path | str, low: float, high: float, *, spacing: float = 0.1
    ) -> HeightField:
        """Read an image: black lies at `low` [m], white at `high` [m], a pixel a height.

        The image is seen from above, its top towards +z, its left towards +x.

        Raises:
            ArgumentError: If Pillow is not installed, or a number is out of range.
            FileFormatError: If the image cannot be read.
        """
        check_finite("an image between", low, high)
        try:
            from PIL import Image
        except ImportError:
            raise ArgumentError(
                "an image needs Pillow; install it with: pip install 'footfall[image]'"
            ) from None
        try:
            with Image.open(path) as image:
                grey: Any = np.asarray(image.convert("F"), dtype=np.float64)
        except FileNotFoundError:
            raise FileFormatError("there is no such file; check the name", path=path) from None
        except (OSError, ValueError) as error:
            told = " ".join(str(error).split())
            raise FileFormatError(f"cannot be read as an image: {told}", path=path) from None
        brightest = 65535.0 if grey.max() > 255.0 else 255.0
        heights = low + (high - low) * grey[::-1, ::-1] / brightest
        return cls(np.ascontiguousarray(heights), spacing)
