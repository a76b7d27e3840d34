"""What there is to say about a file that says everything itself."""

from __future__ import annotations

from footfall.io.conclusions import Conclusion, Conclusions
from footfall.io.observations import (
    conclude_feet,
    conclude_first_frame,
    conclude_floor,
    legs_or_reason,
)
from footfall.io.units import parse_unit
from footfall.motion import Clip

__all__ = ["conclude_stored"]


def conclude_stored(clip: Clip) -> Conclusions:
    """Return the conclusions about a clip of the project's own format: mostly what it says."""
    rotations, positions = clip.world_poses()
    anatomy = legs_or_reason(clip.skeleton)
    cyclic = "cyclic" if clip.cyclic else "not cyclic"
    return Conclusions(
        unit=Conclusion(parse_unit("m"), "m, as always in this format"),
        up=Conclusion("y", "y, as always in this format"),
        root=Conclusion(clip.skeleton.names[0], f"{clip.skeleton.names[0]!r}, joint 0 of the file"),
        bones=Conclusion(0.0, "fixed, as always in this format"),
        frames=Conclusion(clip.frames, f"{clip.frames}, as the file holds"),
        fps=Conclusion(clip.fps, f"{clip.fps:.9g} frames per second, as the file says"),
        feet=conclude_feet(clip.skeleton, anatomy),
        first_frame=conclude_first_frame(positions),
        floor=conclude_floor(anatomy, rotations, positions),
        cyclic=Conclusion(clip.cyclic, f"{cyclic}, as the file says"),
    )
