"""The figures of the paper, drawn anew from what the engine does."""

from footfall.figures.cast import ROLES, Cast, Role
from footfall.figures.figure import Figure
from footfall.figures.gallery import DRAWINGS, write_gallery

__all__ = ["DRAWINGS", "ROLES", "Cast", "Figure", "Role", "write_gallery"]
