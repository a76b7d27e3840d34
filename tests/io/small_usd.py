"""USD files as text, written without the library, and where their joints are."""

from __future__ import annotations

import numpy as np
from tests.oracles.slow_kinematics import joint_frames

from footfall.arrays import Floats, Positions
from footfall.motion import Clip

__all__ = ["usd_text", "usd_world"]

PLACED = (3.0, 20.0, -1.0)
"""Where the skeleton stands, in the file's unit."""


def usd_text(
    clip: Clip, *, up: str = "Y", metres: float = 0.01, step: float = 1.0, names: bool = False
) -> bytes:
    """Return a clip as a .usda file: a scaled and moved body, its animation in another order.

    Args:
        clip: The motion; lengths are written in the unit, times two.
        up: The upward axis that is said.
        metres: The unit that is said [m].
        step: Time codes from one frame to the next; the rate that is said is as much higher.
        names: Whether the joints are named apart from their paths.
    """
    paths = _paths(clip)
    order = list(range(clip.skeleton.count))[::-1]
    scale = 2.0 / metres
    rest = [_moved(scale * offset) for offset in clip.skeleton.rest_offsets]
    named = f"uniform token[] jointNames = [{_texts(clip.skeleton.names)}]" if names else ""
    if names:
        paths = ["/".join(f"j{int(j)}" for j in path.split("#")) for path in _numbers(clip)]
    return f"""#usda 1.0
(
    metersPerUnit = {metres!r}
    timeCodesPerSecond = {clip.fps * step!r}
    upAxis = "{up}"
)
def SkelRoot "Root" (prepend apiSchemas = ["SkelBindingAPI"])
{{
    double3 xformOp:translate = {PLACED}
    double3 xformOp:scale = (0.5, 0.5, 0.5)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    rel skel:animationSource = </Root/Walk>
    def Skeleton "Bones"
    {{
        uniform token[] joints = [{_texts(paths)}]
        {named}
        uniform matrix4d[] bindTransforms = [{", ".join(rest)}]
        uniform matrix4d[] restTransforms = [{", ".join(rest)}]
    }}
    def SkelAnimation "Walk"
    {{
        uniform token[] joints = [{_texts([paths[joint] for joint in order])}]
        half3[] scales = [{", ".join(["(1, 1, 1)"] * len(order))}]
        float3[] translations.timeSamples = {{
{_samples(clip, step, [[_places(clip, t, scale)[j] for j in order] for t in range(clip.frames)])}
        }}
        quatf[] rotations.timeSamples = {{
{_samples(clip, step, [[clip.local_rotations[t, j] for j in order] for t in range(clip.frames)])}
        }}
    }}
}}
""".encode()


def usd_world(clip: Clip, metres: float, up: str) -> Positions:
    """Return where the joints of that file are, in metres and y up, by recursion over the tree."""
    positions = np.array(
        [
            joint_frames(clip.skeleton, clip.pelvis_positions[t], clip.local_rotations[t])[1]
            for t in range(clip.frames)
        ]
    )
    placed = positions + metres * np.array(PLACED)
    if up == "Z":
        placed = np.stack([placed[..., 0], placed[..., 2], -placed[..., 1]], axis=-1)
    return placed


def _paths(clip: Clip) -> list[str]:
    paths: list[str] = []
    for name, parent in zip(clip.skeleton.names, clip.skeleton.parents.tolist(), strict=True):
        paths.append(name if parent < 0 else f"{paths[parent]}/{name}")
    return paths


def _numbers(clip: Clip) -> list[str]:
    numbers: list[str] = []
    for joint, parent in enumerate(clip.skeleton.parents.tolist()):
        numbers.append(str(joint) if parent < 0 else f"{numbers[parent]}#{joint}")
    return numbers


def _texts(texts: list[str] | tuple[str, ...]) -> str:
    return ", ".join(f'"{text}"' for text in texts)


def _moved(place: Positions) -> str:
    x, y, z = place.tolist()
    return f"((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), ({x!r}, {y!r}, {z!r}, 1))"


def _places(clip: Clip, frame: int, scale: float) -> Positions:
    places = scale * np.array(clip.skeleton.rest_offsets)
    places[0] = scale * clip.pelvis_positions[frame]
    return places


def _samples(clip: Clip, step: float, values: list[list[Floats]]) -> str:
    lines = [
        f"{frame * step!r}: [{', '.join(str(tuple(value.tolist())) for value in row)}],"
        for frame, row in enumerate(values)
    ]
    assert len(lines) == clip.frames
    return "\n".join(lines)
