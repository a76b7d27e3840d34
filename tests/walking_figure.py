"""A hand-made body that walks with exactly known supports, for tests of files and pictures."""

from __future__ import annotations

import numpy as np

from footfall.arrays import Positions, Rotations
from footfall.geometry import from_axis_angle, multiply
from footfall.motion import Clip
from footfall.skeleton import Anatomy, BodyPart, FootPoint, Leg, Skeleton

JOINTS: tuple[tuple[str, str, tuple[float, float, float]], ...] = (
    ("Hips", "", (0.0, 0.0, 0.0)),
    ("LeftUpLeg", "Hips", (0.09, -0.03, 0.0)),
    ("LeftLeg", "LeftUpLeg", (0.0, -0.42, 0.0)),
    ("LeftFoot", "LeftLeg", (0.0, -0.42, 0.0)),
    ("LeftToe", "LeftFoot", (0.0, -0.06, 0.13)),
    ("RightUpLeg", "Hips", (-0.09, -0.03, 0.0)),
    ("RightLeg", "RightUpLeg", (0.0, -0.42, 0.0)),
    ("RightFoot", "RightLeg", (0.0, -0.42, 0.0)),
    ("RightToe", "RightFoot", (0.0, -0.06, 0.13)),
    ("Spine", "Hips", (0.0, 0.12, 0.0)),
    ("Chest", "Spine", (0.0, 0.18, 0.0)),
    ("Neck", "Chest", (0.0, 0.2, 0.0)),
    ("Head", "Neck", (0.0, 0.09, 0.01)),
    ("LeftShoulder", "Chest", (0.03, 0.15, 0.0)),
    ("LeftArm", "LeftShoulder", (0.14, 0.0, 0.0)),
    ("LeftForeArm", "LeftArm", (0.28, 0.0, 0.0)),
    ("LeftHand", "LeftForeArm", (0.25, 0.0, 0.0)),
    ("RightShoulder", "Chest", (-0.03, 0.15, 0.0)),
    ("RightArm", "RightShoulder", (-0.14, 0.0, 0.0)),
    ("RightForeArm", "RightArm", (-0.28, 0.0, 0.0)),
    ("RightHand", "RightForeArm", (-0.25, 0.0, 0.0)),
)
PERIOD = 1.1
STRIDE = 0.9
ANKLE_HEIGHT = 0.08


def skeleton() -> Skeleton:
    names = tuple(name for name, _, _ in JOINTS)
    parents = np.array([-1 if not parent else names.index(parent) for _, parent, _ in JOINTS])
    tips = np.zeros((len(names), 3))
    tips[names.index("Head")] = (0.0, 0.2, 0.0)
    return Skeleton(names, parents, np.array([offset for _, _, offset in JOINTS]), tips)


def anatomy() -> Anatomy:
    names = [name for name, _, _ in JOINTS]
    parts = np.full(len(names), BodyPart.TRUNK, dtype=np.int64)
    for joint, name in enumerate(names):
        if name.endswith(("Leg", "Foot", "Toe", "Hips")):
            parts[joint] = BodyPart.LEGS
        elif name in ("Neck", "Head"):
            parts[joint] = BodyPart.HEAD
        elif name.endswith(("Shoulder", "Arm", "Hand")):
            left = name.startswith("Left")
            parts[joint] = BodyPart.LEFT_ARM if left else BodyPart.RIGHT_ARM
    return Anatomy(_leg(1), _leg(5), parts, ("made by hand",))


def _leg(hip: int) -> Leg:
    heel = FootPoint(hip + 2, (0.0, -0.06, -0.04))
    return Leg(hip, hip + 1, hip + 2, heel, FootPoint(hip + 3, (0.0, 0.0, 0.0)))


def walk(frames: int = 67, fps: float = 60.0, sliding: float = 0.0) -> Clip:
    """Return a walk along +z; planted feet drift forward at `sliding` times the speed."""
    time = np.arange(frames) / fps
    body = skeleton()
    phase = time / PERIOD
    pelvis = np.stack(
        [
            np.zeros(frames),
            0.88 + 0.015 * np.cos(4 * np.pi * phase),
            STRIDE * phase,
        ],
        axis=-1,
    )
    local: Rotations = np.tile([1.0, 0.0, 0.0, 0.0], (frames, body.count, 1))
    for hip, offset in ((1, 0.0), (5, 0.5)):
        _bend_leg(local, pelvis, hip, _ankle(phase + offset, offset, sliding))
    swing = 0.45 * np.sin(2 * np.pi * (phase + 0.1))
    for arm, side in ((14, 1.0), (18, -1.0)):
        down = from_axis_angle(np.array([0.0, 0.0, -side]), np.full(frames, 1.35))
        local[:, arm] = multiply(from_axis_angle(np.array([1.0, 0.0, 0.0]), side * swing), down)
        local[:, arm + 1] = from_axis_angle(np.array([0.0, -side, 0.0]), np.full(frames, 0.5))
    return Clip(body, pelvis, local, fps, name="walk")


def _ankle(phase: Positions, offset: float, sliding: float) -> Positions:
    """Return height and place ahead of one ankle: 60 % of a cycle in stance."""
    cycle, share = np.divmod(phase, 1.0)
    swing = np.clip((share - 0.6) / 0.4, 0.0, 1.0)
    ease = swing - np.sin(2 * np.pi * swing) / (2 * np.pi)
    ahead = STRIDE * (cycle + ease - offset + 0.3) + sliding * STRIDE * np.minimum(share, 0.6)
    return np.stack([ANKLE_HEIGHT + 0.09 * np.sin(np.pi * swing) ** 2, ahead], axis=-1)


def _bend_leg(local: Rotations, pelvis: Positions, hip: int, ankle: Positions) -> None:
    """Turn hip, knee and foot in the plane of walking, so that the sole stays level."""
    down = pelvis[:, 1] - 0.03 - ankle[:, 0]
    ahead = ankle[:, 1] - pelvis[:, 2]
    reach = np.minimum(np.hypot(down, ahead), 0.8399)
    bend = np.arccos(reach / 0.84)
    lean = np.arctan2(ahead, down)
    x = np.array([1.0, 0.0, 0.0])
    local[:, hip] = from_axis_angle(x, -lean - bend)
    local[:, hip + 1] = from_axis_angle(x, 2.0 * bend)
    local[:, hip + 2] = from_axis_angle(x, lean - bend)


def supports(frames: int = 67, fps: float = 60.0) -> str:
    """Return what carries the body in each frame of `walk`."""
    phase = np.arange(frames) / fps / PERIOD
    left = phase % 1.0 < 0.6
    right = (phase + 0.5) % 1.0 < 0.6
    symbols = {(True, True): "D", (True, False): "L", (False, True): "R"}
    return "".join(symbols[pair] for pair in zip(left.tolist(), right.tolist(), strict=True))
