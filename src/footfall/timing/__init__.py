"""When motions are played: seconds only, no body."""

from footfall.timing.activation import advance_progress, level, reverse_fade, smoothstep
from footfall.timing.time_warp import TimeWarp, end_slope, end_slope_paper, warp
from footfall.timing.weights import mean_vote, normalize_weights, slot_duration

__all__ = [
    "TimeWarp",
    "advance_progress",
    "end_slope",
    "end_slope_paper",
    "level",
    "mean_vote",
    "normalize_weights",
    "reverse_fade",
    "slot_duration",
    "smoothstep",
    "warp",
]
