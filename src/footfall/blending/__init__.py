"""The weighted mean of normalized poses, and of the ways they go."""

from footfall.blending.poses import Layers, blend_layers

__all__ = ["Layers", "blend_layers"]
