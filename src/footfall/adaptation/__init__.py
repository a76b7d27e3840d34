"""One pose, this body, this ground."""

from footfall.adaptation.ground import Plane

__all__ = ["Plane"]
