"""One pose, this body, this ground."""

from footfall.adaptation.ground import AnyGround, Plane, Platform, Ramp, Stairs, Terrain
from footfall.adaptation.height_field import HeightField
from footfall.adaptation.packed_ground import ground_heights, pack_ground

__all__ = [
    "AnyGround",
    "HeightField",
    "Plane",
    "Platform",
    "Ramp",
    "Stairs",
    "Terrain",
    "ground_heights",
    "pack_ground",
]
