"""What describes a cyclic gait: a handful of published numbers.

Phases count shares of the cycle.
"""

from __future__ import annotations

from dataclasses import dataclass

from footfall.arrays import Floats
from footfall.samples.curves import wave

__all__ = ["FreeLeg", "Gait", "Harmonic", "LegCycle", "Pelvis", "UpperBody"]


@dataclass(frozen=True, slots=True)
class Harmonic:
    """mean + amplitude cos(2π harmonic (phase - peak)); angles in degrees, lengths in metres."""

    amplitude: float = 0.0
    peak: float = 0.0
    mean: float = 0.0
    harmonic: int = 1

    def at(self, phases: Floats) -> Floats:
        """Return the values at these phases."""
        return self.mean + wave(phases, self.amplitude, self.peak, harmonic=self.harmonic)


@dataclass(frozen=True, slots=True)
class LegCycle:
    """One leg that steps once a cycle. Angles in degrees."""

    strike: float
    """Phase at which the foot touches."""

    duty: float
    """Share of the cycle for which it stays."""

    ball: tuple[float, float]
    """Where the ball stands, from the pelvis at the strike: x and z [m]."""

    clearance: tuple[tuple[float, float], ...]
    """As `Swing.clearance`."""

    pitch: tuple[tuple[float, float], ...] = ()
    """As `Swing.pitch`."""

    progress: tuple[tuple[float, float], ...] = ()
    """(share of the swing, share of the way)."""

    strike_pitch: float = 0.0
    leave_pitch: float = 0.0

    flat: float = 0.15
    """Share of the stance until the foot is flat."""

    rise: float = 0.5
    """Share of the stance in which it rolls off."""

    toe_out: float = 7.0
    """How far the toes point outward."""


@dataclass(frozen=True, slots=True)
class FreeLeg:
    """A leg that never touches: its ball from the pelvis [m], and its pitch [degrees]."""

    height: Harmonic
    forward: Harmonic
    pitch: Harmonic


@dataclass(frozen=True, slots=True)
class Pelvis:
    """How the pelvis moves about its steady travel."""

    height: Harmonic
    """[m]; its mean is lowered until both legs reach. Not read in gaits with flights."""

    drop: float = 0.0
    """How much lower it lands than it takes off [m]; read in gaits with flights."""

    sway: Harmonic = Harmonic()
    """To the left [m]."""

    surge: Harmonic = Harmonic()
    """Forward [m]."""

    heading: Harmonic = Harmonic()
    """To the left [degrees]."""

    lean: Harmonic = Harmonic()
    """Forward [degrees]."""

    tilt: Harmonic = Harmonic()
    """Left side up [degrees]."""


@dataclass(frozen=True, slots=True)
class UpperBody:
    """Trunk, head and arms [degrees]; arms as in `arm_rotations`.

    The right arm does half a cycle later what the left does, unless it is given apart.
    """

    chest: tuple[Harmonic, Harmonic, Harmonic]
    head: tuple[Harmonic, Harmonic, Harmonic]
    left_arm: tuple[Harmonic, Harmonic, Harmonic, Harmonic, Harmonic]
    right_arm: tuple[Harmonic, Harmonic, Harmonic, Harmonic, Harmonic] | None = None


@dataclass(frozen=True, slots=True)
class Gait:
    """A cyclic gait."""

    duration: float
    """Of one cycle [s]."""

    travel: tuple[float, float]
    """What one cycle covers: x and z [m]."""

    left: LegCycle | FreeLeg
    right: LegCycle | FreeLeg
    pelvis: Pelvis
    upper: UpperBody

    start: float = 0.0
    """Phase of the first frame; a boundary between two supports."""

    backward: bool = False
    """Whether it is played from its end to its beginning."""

    turn: float = 0.0
    """How far it turns to the left in a cycle, on an arc that is as long as its travel [rad]."""
