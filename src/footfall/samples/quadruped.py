"""A dog's gaits as what they stand on: support sequences of four legs.

A gait diagram says for each leg when in the stride its foot comes down, and for which share of
the stride it stays (the duty factor). The numbers are typical values, ours: no table is copied.
What they keep to is published. In a walk the feet come down in the lateral sequence, left hind,
left front, right hind, right front, and the diagonal legs are 0.31 ± 0.02 of a stride apart (here
0.3); in a trot 0.02 ± 0.03 (here 0): "Gait transitions during unrestrained locomotion in dogs", 22
dogs. A racing greyhound gallops in the rotary order with two flights, gathered and extended: R. L.
Gillette, "Understanding the Greyhound Racing Gallop". From walk to rotary gallop cycles change
without a break: L. D. Maes et al., "Steady locomotion in dogs", J. Exp. Biology 211, 2008. How long
a stride lasts, the duty factors and the lags of the gallop are not taken from there.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

from footfall.errors import UnknownNameError
from footfall.support import Support, SupportPhase, SupportSequence, merge_equal_neighbors

__all__ = ["QUADRUPED_GAITS", "LegGait", "quadruped_supports"]


@dataclass(frozen=True, slots=True)
class LegGait:
    """A gait diagram: one stride of any number of legs, in the order of `LIMBS`."""

    duration: float
    """Of one stride [s], > 0."""

    strikes: tuple[float, ...]
    """When each foot comes down, as a share of the stride, in [0, 1)."""

    duties: tuple[float, ...]
    """For which share of the stride each then carries, in (0, 1)."""

    def supports(self) -> SupportSequence:
        """Return what carries the body, from the strike of the first leg on, cyclic."""
        legs = list(zip(self.strikes, self.duties, strict=True))
        edges = {round(edge % 1.0, 9) for strike, duty in legs for edge in (strike, strike + duty)}
        bounds = [*sorted(edges | {0.0}), 1.0]
        phases: list[SupportPhase] = []
        for begin, end in pairwise(bounds):
            middle = 0.5 * (begin + end)
            standing = (
                limb for limb, (strike, duty) in enumerate(legs) if (middle - strike) % 1.0 < duty
            )
            phases.append(SupportPhase(Support.from_limbs(standing), (end - begin) * self.duration))
        return SupportSequence(merge_equal_neighbors(phases), cyclic=True)


QUADRUPED_GAITS: dict[str, LegGait] = {
    # Left and right hind leg, left and right front leg.
    "walk": LegGait(0.9, (0.0, 0.5, 0.2, 0.7), (0.65, 0.65, 0.65, 0.65)),
    "trot": LegGait(0.5, (0.0, 0.5, 0.5, 0.0), (0.45, 0.45, 0.45, 0.45)),
    "gallop": LegGait(0.4, (0.0, 0.11, 0.6, 0.48), (0.27, 0.27, 0.24, 0.24)),
}
"""The gaits of a dog, by name: typical values."""


def quadruped_supports(name: str) -> SupportSequence:
    """Return what a dog stands on in one of its gaits: L and R its hind legs, l and r its front.

    Args:
        name: A key of `QUADRUPED_GAITS`: walk, trot or gallop.

    Raises:
        UnknownNameError: If there is no such gait.
    """
    if name not in QUADRUPED_GAITS:
        raise UnknownNameError("gait of four legs", name, QUADRUPED_GAITS)
    return QUADRUPED_GAITS[name].supports()
