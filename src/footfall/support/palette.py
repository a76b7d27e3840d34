"""One color for one support, wherever one is drawn, and readable to the color-blind.

Hues of Okabe and Ito's set, evened in lightness so that they hold on light and dark paper.
"""

from __future__ import annotations

__all__ = ["SUPPORT_COLORS", "SUPPORT_NAMES"]

SUPPORT_COLORS = {"R": "#e6912a", "L": "#3b8fd0", "D": "#35a47a", "-": "#a4adb8"}
"""Fill of each symbol of a support."""

SUPPORT_NAMES = {"R": "right foot", "L": "left foot", "D": "both feet", "-": "flight"}
"""What each symbol means, for legends."""
