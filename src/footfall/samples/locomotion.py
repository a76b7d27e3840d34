"""The parameters of the cyclic samples that are no walks.

The run: T. F. Novacheck, "The biomechanics of running", Gait and Posture 7, 1998 (phases of the
cycle, joint angles).
"""

from __future__ import annotations

from footfall.samples.gait import FreeLeg, Gait, Harmonic, LegCycle, Pelvis, UpperBody

__all__ = ["OTHER_GAITS"]

_STILL = Harmonic()


def _run() -> Gait:
    """Return a run at 3.3 m/s: stance 36 % of the cycle, two flights (Novacheck, section 2)."""
    duration, stride, duty = 0.7, 2.31, 0.36

    def leg(strike: float, side: float) -> LegCycle:
        return LegCycle(
            strike,
            duty,
            (side * 0.03, 0.38),
            clearance=((0.2, 0.30), (0.42, 0.38), (0.62, 0.22), (0.85, 0.10)),
            pitch=((0.2, -105.0), (0.42, -85.0), (0.68, -20.0), (0.88, 8.0)),
            strike_pitch=10.0,
            leave_pitch=-62.0,
            flat=0.2,
            rise=0.6,
            toe_out=4.0,
        )

    pelvis = Pelvis(
        height=_STILL,
        drop=0.015,
        sway=Harmonic(0.010, 0.18),
        heading=Harmonic(-6.0, 0.02),
        lean=Harmonic(1.5, 0.0, 9.0, 2),
        tilt=Harmonic(4.0, 0.12),
    )
    upper = UpperBody(
        chest=(Harmonic(10.0, 0.03), Harmonic(1.5, 0.1, 7.0, 2), Harmonic(-2.0, 0.14)),
        head=(_STILL, Harmonic(1.0, 0.1, 3.0, 2), _STILL),
        left_arm=(
            Harmonic(mean=2.0),
            Harmonic(-38.0, 0.03, 2.0),
            Harmonic(mean=14.0),
            Harmonic(mean=-25.0),
            Harmonic(-12.0, 0.05, 88.0),
        ),
    )
    return Gait(duration, (0.0, stride), leg(0.0, 1.0), leg(0.5, -1.0), pelvis, upper, 0.5)


def _hop(side: float) -> Gait:
    """Return hops on the left (side 1) or the right leg (-1), at 1 m/s."""
    duration, travel, duty = 0.5, 0.5, 0.56
    stepping = LegCycle(
        0.0,
        duty,
        (side * 0.035, 0.235),
        clearance=((0.3, 0.06), (0.6, 0.07)),
        pitch=((0.22, -66.0), (0.65, -15.0)),
        strike_pitch=-16.0,
        leave_pitch=-52.0,
        flat=0.3,
        rise=0.45,
        toe_out=5.0,
    )
    free = FreeLeg(
        height=Harmonic(0.04, 0.6, -0.58),
        forward=Harmonic(0.09, 0.55, -0.22),
        pitch=Harmonic(6.0, 0.55, -62.0),
    )
    pelvis = Pelvis(
        height=_STILL,
        drop=0.05,
        heading=Harmonic(side * 3.0, 0.1, side * -2.0),
        lean=Harmonic(2.0, 0.2, 6.0),
        tilt=Harmonic(side * 3.0, 0.15, side * -1.0),
    )
    left, right = (stepping, free) if side > 0.0 else (free, stepping)
    return Gait(duration, (0.0, travel), left, right, pelvis, _hopping_upper_body(side))


def _hopping_upper_body(side: float) -> UpperBody:
    """Return both arms thrown up together as the body rises."""
    arm = (
        Harmonic(mean=8.0),
        Harmonic(16.0, 0.6, 4.0),
        Harmonic(5.0, 0.6, 24.0),
        Harmonic(mean=-10.0),
        Harmonic(10.0, 0.65, 68.0),
    )
    return UpperBody(
        chest=(
            Harmonic(side * 4.0, 0.6),
            Harmonic(3.0, 0.25, 7.0),
            Harmonic(mean=side * -4.0),
        ),
        head=(_STILL, Harmonic(1.0, 0.25, 3.0), _STILL),
        left_arm=arm,
        right_arm=arm,
    )


def _side_step() -> Gait:
    """Return steps to the left: the left foot opens, the right one closes."""

    def leg(strike: float, across: float) -> LegCycle:
        return LegCycle(
            strike,
            0.7,
            (across, 0.11),
            clearance=((0.25, 0.05), (0.6, 0.06), (0.85, 0.035)),
            pitch=((0.3, -16.0), (0.7, 2.0)),
            progress=((0.85, 0.885),),
            strike_pitch=-6.0,
            leave_pitch=-20.0,
            flat=0.12,
            rise=0.25,
            toe_out=6.0,
        )

    pelvis = Pelvis(
        height=Harmonic(0.008, 0.35, harmonic=2),
        sway=Harmonic(0.11, 0.36),
        surge=Harmonic(0.008, 0.1, harmonic=2),
        heading=Harmonic(2.0, 0.1),
        lean=Harmonic(1.0, 0.1, 5.0, 2),
        tilt=Harmonic(2.5, 0.4),
    )
    arm = (
        Harmonic(mean=6.0),
        Harmonic(-4.0, 0.1, 8.0),
        Harmonic(6.0, 0.1, 17.0),
        Harmonic(mean=-12.0),
        Harmonic(6.0, 0.1, 35.0),
    )
    upper = UpperBody(
        chest=(Harmonic(-2.0, 0.1), Harmonic(1.0, 0.15, 6.0, 2), Harmonic(-2.0, 0.38)),
        head=(_STILL, Harmonic(0.6, 0.2, 3.0, 2), _STILL),
        left_arm=arm,
        right_arm=arm,
    )
    return Gait(1.2, (0.45, 0.0), leg(0.0, 0.3275), leg(0.5, -0.0975), pelvis, upper, 0.7)


def _idle() -> Gait:
    """Return quiet standing: slow sway over still feet, one breath in two seconds' rhythm."""

    def leg(side: float, ahead: float) -> LegCycle:
        return LegCycle(0.0, 1.0, (side * 0.11, ahead), clearance=((0.5, 0.0),), toe_out=9.0)

    pelvis = Pelvis(
        height=Harmonic(0.002, 0.3, harmonic=2),
        sway=Harmonic(0.016, 0.25),
        surge=Harmonic(0.006, 0.4),
        heading=Harmonic(1.2, 0.35),
        lean=Harmonic(0.5, 0.4, 1.0),
        tilt=Harmonic(-1.2, 0.25),
    )
    arm = (
        Harmonic(mean=5.0),
        Harmonic(1.5, 0.45, 4.0),
        Harmonic(0.8, 0.2, 9.0, 2),
        Harmonic(mean=-15.0),
        Harmonic(2.0, 0.5, 17.0),
    )
    upper = UpperBody(
        chest=(Harmonic(1.5, 0.6), Harmonic(-1.1, 0.2, 2.0, 2), Harmonic(1.2, 0.25)),
        head=(Harmonic(5.0, 0.8), Harmonic(1.2, 0.55, 2.0), Harmonic(0.8, 0.3)),
        left_arm=arm,
    )
    return Gait(4.0, (0.0, 0.0), leg(1.0, 0.13), leg(-1.0, 0.09), pelvis, upper)


OTHER_GAITS: dict[str, Gait] = {
    "run": _run(),
    "hop-right": _hop(-1.0),
    "hop-left": _hop(1.0),
    "side-step": _side_step(),
    "idle": _idle(),
}
