"""A humanoid robot of our own: an MJCF model as text, 25 hinges with the ranges of people.

MuJoCo's axes: x forward, y left, z up. It stands on the floor with its arms down where every hinge
is at zero. Segment lengths and masses are shares of stature and of body mass as in Winter,
"Biomechanics and Motor Control of Human Movement", table 4.1, rounded.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from footfall.errors import ArgumentError

__all__ = ["humanoid_mjcf"]

SHORTEST, TALLEST = 0.5, 2.5
"""Statures that are made [m]."""


class _Hinge(NamedTuple):
    """A joint about one axis, its range [degrees], and the force of its motor [N m]."""

    name: str
    axis: str
    least: float
    most: float
    force: float


_X, _Y, _Z = "1 0 0", "0 1 0", "0 0 1"

_TRUNK = (
    _Hinge("lumbar_yaw", _Z, -45, 45, 150),
    _Hinge("lumbar_pitch", _Y, -35, 75, 200),
    _Hinge("lumbar_roll", _X, -35, 35, 200),
)
_NECK = (_Hinge("neck_yaw", _Z, -80, 80, 20), _Hinge("neck_pitch", _Y, -60, 60, 20))


def _leg(side: str, sign: int) -> tuple[tuple[_Hinge, ...], ...]:
    """Return the hinges of hip, knee and ankle; `sign` is 1 for the left."""
    return (
        (
            _Hinge(f"{side}_hip_yaw", _Z, *_span(-45, 45, sign), 150),
            _Hinge(f"{side}_hip_roll", _X, *_span(-35, 60, sign), 200),
            _Hinge(f"{side}_hip_pitch", _Y, -125, 45, 250),
        ),
        (_Hinge(f"{side}_knee", _Y, 0, 155, 250),),
        (
            _Hinge(f"{side}_ankle_pitch", _Y, -40, 60, 150),
            _Hinge(f"{side}_ankle_roll", _X, *_span(-35, 35, sign), 100),
        ),
    )


def _arm(side: str, sign: int) -> tuple[tuple[_Hinge, ...], ...]:
    """Return the hinges of shoulder and elbow; `sign` is 1 for the left."""
    return (
        (
            _Hinge(f"{side}_shoulder_pitch", _Y, -180, 70, 80),
            _Hinge(f"{side}_shoulder_roll", _X, *_span(-30, 175, sign), 80),
            _Hinge(f"{side}_shoulder_yaw", _Z, *_span(-90, 90, sign), 60),
        ),
        (_Hinge(f"{side}_elbow", _Y, -150, 0, 60),),
    )


def _span(least: float, most: float, sign: int) -> tuple[float, float]:
    """Return a range, mirrored for the right side."""
    return (least, most) if sign > 0 else (-most, -least)


def humanoid_mjcf(stature: float = 1.75) -> str:
    """Return the model as MJCF.

    Args:
        stature: How tall it is [m], 0.5 to 2.5.

    Raises:
        ArgumentError: If `stature` is out of its range.
    """
    if not SHORTEST <= stature <= TALLEST:
        raise ArgumentError(f"stature is {stature} m; it must be within {SHORTEST} to {TALLEST} m")
    h = stature
    legs = "".join(_leg_body(side, sign, h) for side, sign in (("left", 1), ("right", -1)))
    arms = "".join(_arm_body(side, sign, h) for side, sign in (("left", 1), ("right", -1)))
    hinges = [*_TRUNK, *_NECK]
    for side, sign in (("left", 1), ("right", -1)):
        hinges += [hinge for joint in (*_leg(side, sign), *_arm(side, sign)) for hinge in joint]
    pelvis = _capsule(f"0 {-0.06 * h:.4f} 0 0 {0.06 * h:.4f} 0", 0.052 * h)
    spine = _capsule(f"0 0 {0.05 * h:.4f} 0 0 {0.14 * h:.4f}", 0.07 * h)
    skull = f'<geom type="sphere" pos="0 0 {0.07 * h:.4f}" size="{0.06 * h:.4f}"/>'
    head = _body("head", (0.0, 0.0, 0.24 * h), _NECK, skull)
    chest = _body("chest", (0.0, 0.0, 0.08 * h), _TRUNK, spine + head + arms)
    # The density gives a person of 1.75 m 68 kg.
    return f"""<mujoco model="footfall humanoid">
  <compiler angle="degree" autolimits="true"/>
  <default>
    <geom density="1200" friction="1 0.02 0.002" condim="4"/>
    <joint type="hinge" damping="2" armature="0.02"/>
    <position kp="100" kv="5"/>
  </default>
  <worldbody>
    <light pos="0 0 4" dir="0 0 -1" directional="true"/>
    <geom name="floor" type="plane" size="20 20 0.1" rgba="0.8 0.8 0.78 1"/>
    <body name="pelvis" pos="0 0 {0.53 * h:.4f}">
      <freejoint name="root"/>
      {pelvis}{chest}{legs}
    </body>
  </worldbody>
  <actuator>
    {_motors(hinges)}
  </actuator>
</mujoco>
"""


def _leg_body(side: str, sign: int, h: float) -> str:
    hip, knee, ankle = _leg(side, sign)
    sole = (
        f'<geom type="box" pos="{0.035 * h:.4f} 0 {-0.027 * h:.4f}" '
        f'size="{0.075 * h:.4f} {0.025 * h:.4f} {0.012 * h:.4f}"/>'
    )
    foot = _body(f"{side}_foot", (0.0, 0.0, -0.246 * h), ankle, sole)
    shin = _capsule(f"0 0 0 0 0 {-0.225 * h:.4f}", 0.028 * h) + foot
    thigh = _capsule(f"0 0 {-0.02 * h:.4f} 0 0 {-0.225 * h:.4f}", 0.038 * h)
    thigh += _body(f"{side}_shin", (0.0, 0.0, -0.245 * h), knee, shin)
    return _body(f"{side}_thigh", (0.0, sign * 0.055 * h, 0.0), hip, thigh)


def _arm_body(side: str, sign: int, h: float) -> str:
    shoulder, elbow = _arm(side, sign)
    palm = f'<geom type="sphere" size="{0.024 * h:.4f}" pos="0 0 {-0.03 * h:.4f}"/>'
    hand = _body(f"{side}_hand", (0.0, 0.0, -0.146 * h), (), palm)
    forearm = _capsule(f"0 0 0 0 0 {-0.146 * h:.4f}", 0.02 * h) + hand
    arm = _capsule(f"0 0 0 0 0 {-0.17 * h:.4f}", 0.024 * h)
    arm += _body(f"{side}_forearm", (0.0, 0.0, -0.17 * h), elbow, forearm)
    return _body(f"{side}_upper_arm", (0.0, sign * 0.115 * h, 0.2 * h), shoulder, arm)


def _capsule(ends: str, radius: float) -> str:
    return f'<geom type="capsule" fromto="{ends}" size="{radius:.4f}"/>'


def _body(
    name: str, place: tuple[float, float, float], hinges: Iterable[_Hinge], content: str
) -> str:
    joints = "".join(
        f'<joint name="{hinge.name}" axis="{hinge.axis}" range="{hinge.least:g} {hinge.most:g}"/>'
        for hinge in hinges
    )
    x, y, z = place
    return f'\n<body name="{name}" pos="{x:.4f} {y:.4f} {z:.4f}">{joints}{content}</body>'


def _motors(hinges: Iterable[_Hinge]) -> str:
    return "\n    ".join(
        f'<position name="{hinge.name}" joint="{hinge.name}" '
        f'forcerange="{-hinge.force:g} {hinge.force:g}" '
        f'ctrlrange="{hinge.least:g} {hinge.most:g}"/>'
        for hinge in hinges
    )
