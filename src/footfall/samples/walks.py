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

from dataclasses import dataclass

from footfall.samples.gait import Gait, Harmonic, LegCycle, Pelvis, UpperBody

__all__ = ["WALKS"]


@dataclass(frozen=True, slots=True)
class _Walk:
    """What tells one walk from another; angles in degrees, lengths in metres."""

    duration: float
    stride: float
    duty: float
    strike_pitch: float
    leave_pitch: float
    bounce: float
    turn: float
    arm: float
    elbow: float
    reach: float
    lean: float
    rise: float = 0.42
    lift: float = 0.06

    def gait(self, *, backward: bool = False) -> Gait:
        """Return the gait; phase 0 is the left heel strike, the first frame a toe-off."""
        return Gait(
            self.duration,
            (0.0, self.stride),
            self._leg(0.0, 1.0),
            self._leg(0.5, -1.0),
            self._pelvis(),
            self._upper_body(),
            0.0 if backward else self.duty,
            backward,
        )

    def _leg(self, strike: float, side: float) -> LegCycle:
        # The toes pass 1 to 2 cm over the ground in the middle of the swing [W].
        return LegCycle(
            strike,
            self.duty,
            (side * 0.055, self.reach),
            clearance=((0.2, self.lift), (0.5, 0.02), (0.8, 0.025)),
            pitch=(
                (0.17, 1.17 * self.leave_pitch),
                (0.5, 0.3 * self.leave_pitch),
                (0.78, 0.75 * self.strike_pitch),
            ),
            progress=((0.86, 0.925),),
            strike_pitch=self.strike_pitch,
            leave_pitch=self.leave_pitch,
            flat=0.16,
            rise=self.rise,
        )

    def _pelvis(self) -> Pelvis:
        both = self.duty - 0.5
        return Pelvis(
            # Lowest in double support, highest at midstance [P].
            height=Harmonic(self.bounce, 0.215 + 0.5 * both, harmonic=2),
            sway=Harmonic(0.022, 0.5 * self.duty),
            surge=Harmonic(0.013, 0.44, harmonic=2),
            # Turned and tilted by 4 to 5 degrees to either side [M, P].
            heading=Harmonic(-self.turn, 0.0),
            lean=Harmonic(0.8, 0.06, 3.0, harmonic=2),
            tilt=Harmonic(4.0, 0.14),
        )

    def _upper_body(self) -> UpperBody:
        return UpperBody(
            # The chest turns against the pelvis, the arms swing against the legs [M].
            chest=(
                Harmonic(self.turn + 1.0, 0.02),
                Harmonic(0.8, 0.1, self.lean, 2),
                Harmonic(-1.5, 0.16),
            ),
            head=(Harmonic(), Harmonic(0.6, 0.1, 2.0, 2), Harmonic()),
            left_arm=(
                Harmonic(mean=4.0),
                Harmonic(-self.arm, 0.0, 3.0),
                Harmonic(mean=9.0),
                Harmonic(mean=-15.0),
                Harmonic(-self.elbow, 0.03, 18.0 + self.elbow),
            ),
        )


WALKS: dict[str, Gait] = {
    # 112 steps a minute, 1.31 m/s; toe-off at 62 % of the cycle [P, M].
    "walk": _Walk(
        duration=16 / 15,
        stride=1.40,
        duty=0.62,
        strike_pitch=20.0,
        leave_pitch=-62.0,
        bounce=0.024,
        turn=4.5,
        arm=21.0,
        elbow=11.0,
        reach=0.468,
        lean=2.5,
    ).gait(),
    # Slower walks have shorter steps and longer double supports [K].
    "walk-slow": _Walk(
        duration=1.4,
        stride=1.05,
        duty=0.66,
        strike_pitch=15.0,
        leave_pitch=-48.0,
        bounce=0.013,
        turn=3.0,
        arm=13.0,
        elbow=6.0,
        reach=0.392,
        lean=2.0,
        lift=0.045,
    ).gait(),
    "walk-fast": _Walk(
        duration=0.9,
        stride=1.66,
        duty=0.58,
        strike_pitch=25.0,
        leave_pitch=-64.0,
        bounce=0.0285,
        turn=7.0,
        arm=29.0,
        elbow=18.0,
        reach=0.518,
        lean=4.0,
    ).gait(),
    # A slow walk in reverse: the ball lands first, the heel leaves last [T].
    "walk-backward": _Walk(
        duration=1.2,
        stride=0.96,
        duty=0.64,
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
    ).gait(backward=True),
}
