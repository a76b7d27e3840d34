"""The parameters of the walks, with their sources.

[W] D. A. Winter, *Biomechanics and Motor Control of Human Movement* (joint angles, toe
clearance, foot trajectories); [P] J. Perry and J. Burnfield, *Gait Analysis* (phases of the
cycle, rockers); [M] M. P. Murray, A. B. Drought, R. C. Kory, "Walking patterns of normal men",
J. Bone Joint Surg. 46-A, 1964 (step length and width, toe-out, pelvic and thoracic rotation, arm
swing); [K] C. Kirtley, *Clinical Gait Analysis* (slow and fast walking); [T] A. Thorstensson,
"How is the normal locomotor program modified to produce backward walking?", Exp. Brain Res. 61,
1986 (nearly forward walking in reverse).

Reach, bounce, roll-off and toe lift were fitted so that the knee follows the curve of [W]
(18 degrees in loading, 60 in swing) as closely as a knee that never fully straightens can.
"""

from __future__ import annotations

from footfall.samples.gait import Gait, Harmonic, LegCycle, Pelvis, UpperBody

__all__ = ["WALKS"]

_STILL = Harmonic()


def _walk(
    duration: float,
    stride: float,
    duty: float,
    *,
    strike_pitch: float,
    leave_pitch: float,
    bounce: float,
    turn: float,
    arm: float,
    elbow: float,
    reach: float,
    lean: float,
    rise: float = 0.42,
    lift: float = 0.06,
    backward: bool = False,
) -> Gait:
    """Return a walk; phase 0 is the left heel strike, the first frame the left toe-off."""

    def leg(strike: float, side: float) -> LegCycle:
        # Toe clearance: two peaks with about 15 mm between them [W, figure 3.10 and text].
        return LegCycle(
            strike,
            duty,
            (side * 0.055, reach),
            clearance=((0.2, lift), (0.5, 0.02), (0.8, 0.045)),
            pitch=(
                (0.17, 1.17 * leave_pitch),
                (0.5, -0.3 * -leave_pitch),
                (0.78, 0.75 * strike_pitch),
            ),
            progress=((0.86, 0.925),),
            strike_pitch=strike_pitch,
            leave_pitch=leave_pitch,
            flat=0.16,
            rise=rise,
        )

    both = duty - 0.5
    pelvis = Pelvis(
        # Lowest in the middle of double support, highest at midstance [P, chapter 2].
        height=Harmonic(bounce, 0.215 + 0.5 * both, harmonic=2),
        sway=Harmonic(0.022, 0.5 * duty),
        surge=Harmonic(0.013, 0.44, harmonic=2),
        heading=Harmonic(-turn, 0.0),
        lean=Harmonic(0.8, 0.06, 3.0, harmonic=2),
        tilt=Harmonic(4.0, 0.14),
    )
    upper = UpperBody(
        chest=(Harmonic(turn + 1.0, 0.02), Harmonic(0.8, 0.1, lean, 2), Harmonic(-1.5, 0.16)),
        head=(_STILL, Harmonic(0.6, 0.1, 2.0, 2), _STILL),
        left_arm=(
            Harmonic(mean=4.0),
            Harmonic(-arm, 0.0, 3.0),
            Harmonic(mean=9.0),
            Harmonic(mean=-15.0),
            Harmonic(-elbow, 0.03, 18.0 + elbow),
        ),
    )
    return Gait(
        duration,
        (0.0, stride),
        leg(0.0, 1.0),
        leg(0.5, -1.0),
        pelvis,
        upper,
        0.0 if backward else duty,
        backward,
    )


WALKS: dict[str, Gait] = {
    # 112 steps a minute, 1.31 m/s; toe-off at 62 % of the cycle [P, M].
    "walk": _walk(
        16 / 15,
        1.40,
        0.62,
        strike_pitch=20.0,
        leave_pitch=-62.0,
        bounce=0.024,
        turn=4.5,
        arm=21.0,
        elbow=11.0,
        reach=0.468,
        lean=2.5,
    ),
    # Slower walks have shorter steps and longer double supports [K].
    "walk-slow": _walk(
        1.4,
        1.05,
        0.66,
        strike_pitch=15.0,
        leave_pitch=-48.0,
        bounce=0.013,
        turn=3.0,
        arm=13.0,
        elbow=6.0,
        reach=0.392,
        lean=2.0,
        lift=0.045,
    ),
    "walk-fast": _walk(
        0.9,
        1.66,
        0.58,
        strike_pitch=25.0,
        leave_pitch=-64.0,
        bounce=0.0285,
        turn=7.0,
        arm=29.0,
        elbow=18.0,
        reach=0.518,
        lean=4.0,
    ),
    # A slow walk in reverse: the ball lands first, the heel leaves last [T].
    "walk-backward": _walk(
        1.2,
        0.96,
        0.64,
        strike_pitch=12.0,
        leave_pitch=-33.0,
        bounce=0.012,
        turn=3.0,
        arm=12.0,
        elbow=5.0,
        reach=0.378,
        lean=3.0,
        rise=0.34,
        lift=0.045,
        backward=True,
    ),
}
