"""One pose, this body, this ground."""

from footfall.adaptation.ground import (
    AnyGround,
    BuiltGround,
    Plane,
    Platform,
    Ramp,
    Stairs,
    Terrain,
)
from footfall.adaptation.height_field import HeightField
from footfall.adaptation.own_ground import Ground, check_ground
from footfall.adaptation.packed_ground import ground_heights, pack_ground
from footfall.adaptation.sampled_ground import sample_ground

__all__ = [
    "AnyGround",
    "BuiltGround",
    "Ground",
    "HeightField",
    "Plane",
    "Platform",
    "Ramp",
    "Stairs",
    "Terrain",
    "check_ground",
    "ground_heights",
    "pack_ground",
    "sample_ground",
]
