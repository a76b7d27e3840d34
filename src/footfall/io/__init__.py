"""Files in and out."""

from footfall.io.amass import load_amass, save_amass
from footfall.io.annotation import parse_supports, supports_text
from footfall.io.atomic import write_atomically
from footfall.io.bvh import load_bvh, save_bvh
from footfall.io.clip_choice import split_choice
from footfall.io.conclusions import Conclusion, Conclusions, LegNames
from footfall.io.deepmimic import load_deepmimic, save_deepmimic
from footfall.io.files import (
    load,
    load_supports,
    load_with_conclusions,
    readable_suffixes,
    save,
    save_supports,
    writable_suffixes,
)
from footfall.io.gltf import save_gltf
from footfall.io.gltf_clip import gltf_animations, load_gltf
from footfall.io.gltf_skin import load_skinned
from footfall.io.gltf_skin_writer import save_skinned
from footfall.io.native import load_native, load_native_supports, save_native
from footfall.io.skinned_body import SkinnedBody
from footfall.io.units import UNITS, Unit

__all__ = [
    "UNITS",
    "Conclusion",
    "Conclusions",
    "LegNames",
    "SkinnedBody",
    "Unit",
    "gltf_animations",
    "load",
    "load_amass",
    "load_bvh",
    "load_deepmimic",
    "load_gltf",
    "load_native",
    "load_native_supports",
    "load_skinned",
    "load_supports",
    "load_with_conclusions",
    "parse_supports",
    "readable_suffixes",
    "save",
    "save_amass",
    "save_bvh",
    "save_deepmimic",
    "save_gltf",
    "save_native",
    "save_skinned",
    "save_supports",
    "split_choice",
    "supports_text",
    "writable_suffixes",
    "write_atomically",
]
