"""Files in and out."""

from footfall.io.annotation import parse_supports, supports_text
from footfall.io.atomic import write_atomically
from footfall.io.bvh import load_bvh, save_bvh
from footfall.io.conclusions import Conclusion, Conclusions, LegNames
from footfall.io.files import load, load_supports, load_with_conclusions, save, save_supports
from footfall.io.gltf import save_gltf
from footfall.io.native import load_native, load_native_supports, save_native
from footfall.io.units import UNITS, Unit

__all__ = [
    "UNITS",
    "Conclusion",
    "Conclusions",
    "LegNames",
    "Unit",
    "load",
    "load_bvh",
    "load_native",
    "load_native_supports",
    "load_supports",
    "load_with_conclusions",
    "parse_supports",
    "save",
    "save_bvh",
    "save_gltf",
    "save_native",
    "save_supports",
    "supports_text",
    "write_atomically",
]
