"""Ours and fixed rules asked which foot is on the ground, where the truth is known."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from benchmarks.comparison.sheets import CLIPS, ROOT
from tests.detection.foot_events import noisy

from footfall.arrays import Flags
from footfall.baselines import FIXED_RULES
from footfall.detection import detect_supports
from footfall.io import load, load_supports
from footfall.motion import Clip
from footfall.samples import sample, sample_names
from footfall.support import SupportSequence

LABELS = ROOT / "tests" / "detection" / "labels"

NEAR = 2.0 / 30.0
"""A boundary found this near to where it is counts as found [s]."""

NOISE = 0.002
"""Standard deviation of the noise on every joint of a sample [m]."""

OURS = "footfall"

AT_HAND = frozenset(
    {"cmu16_15_walk", "cmu69_57_sidestep_right", "mass_run", "pab_walk", "woody_kick"}
)
"""Clips that were labeled while detection was made; the others were labeled afterwards."""


@dataclass(frozen=True, slots=True)
class Verdict:
    """How far a rule is from the truth."""

    wrong: float
    """Share of feet and frames in which it is wrong, 0 to 1."""

    missed: int
    """Landings and releases that it does not find within two frames of 30 a second."""

    invented: int
    """Those that it finds and that are not there."""

    there: int
    """How many there are."""


@dataclass(frozen=True, slots=True)
class LabeledVerdicts:
    """What the rules say of a clip that was labeled by eye."""

    name: str
    """Which clip."""

    fps: float
    """Its frames per second."""

    at_hand: bool
    """Whether detection was made with it at hand."""

    verdicts: dict[str, Verdict]
    """By rule."""


def _ours(clip: Clip) -> Flags:
    return flags_of(detect_supports(clip), clip)


RULES: Mapping[str, Callable[[Clip], Flags]] = {**FIXED_RULES, OURS: _ours}


def flags_of(supports: SupportSequence, clip: Clip) -> Flags:
    """Return whether each foot carries in each frame, shape (frames, 2)."""
    values = supports.supports_at(np.arange(clip.frames) / clip.fps)
    return np.stack([(values & bit) == bit for bit in (0b011, 0b101)], axis=1)


def judge(found: Flags, truth: Flags, clip: Clip) -> Verdict:
    """Compare what a rule says with the truth."""
    missed = invented = there = 0
    turn = clip.duration if clip.cyclic else None
    for foot in range(2):
        for landing in (True, False):
            true = _moments(truth[:, foot], clip, landing=landing)
            own = _moments(found[:, foot], clip, landing=landing)
            matched = _matches(true, own, turn)
            there += len(true)
            missed += len(true) - matched
            invented += len(own) - matched
    return Verdict(float((found != truth).mean()), missed, invented, there)


def _moments(flags: Flags, clip: Clip, *, landing: bool) -> list[float]:
    """Return when a foot lands, or else lifts [s]; a cycle's last frame is its first again."""
    before, after = flags[:-1], flags[1:]
    if clip.cyclic:
        before, after = np.roll(flags[:-1], 1), flags[:-1]
    changes = (after & ~before) if landing else (before & ~after)
    frames = np.flatnonzero(changes) + (0 if clip.cyclic else 1)
    return (frames / clip.fps).tolist()


def _matches(true: list[float], own: list[float], turn: float | None) -> int:
    """Return how many of the true moments have one of their own near them."""

    def apart(one: float, other: float) -> float:
        far = abs(one - other)
        return far if turn is None else min(far, turn - far)

    free = list(own)
    matched = 0
    for moment in true:
        nearest = min(free, key=lambda one: apart(one, moment), default=None)
        if nearest is not None and apart(nearest, moment) <= NEAR + 1e-9:
            free.remove(nearest)
            matched += 1
    return matched


def pooled(verdicts: list[Verdict]) -> Verdict:
    """Return the verdict over several motions, each of the same weight."""
    return Verdict(
        float(np.mean([one.wrong for one in verdicts])),
        sum(one.missed for one in verdicts),
        sum(one.invented for one in verdicts),
        sum(one.there for one in verdicts),
    )


def on_samples() -> Iterator[tuple[float, dict[str, Verdict]]]:
    """Return the verdict of each rule over all noisy samples, at each frame rate."""
    for fps in (30.0, 60.0, 120.0):
        verdicts: dict[str, list[Verdict]] = {name: [] for name in RULES}
        for name in sample_names():
            clip, supports = sample(name, fps=fps)
            clip = noisy(clip, NOISE, seed=1)
            for rule, ask in RULES.items():
                verdicts[rule].append(judge(ask(clip), flags_of(supports, clip), clip))
        yield fps, {rule: pooled(each) for rule, each in verdicts.items()}


def on_labeled_clips() -> Iterator[LabeledVerdicts]:
    """Return the verdict of each rule on each clip that was labeled by eye."""
    for path in _labels():
        file = path.read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")
        clip = load(CLIPS / file).evolve(cyclic=False)
        truth = flags_of(load_supports(path), clip)
        verdicts = {rule: judge(ask(clip), truth, clip) for rule, ask in RULES.items()}
        yield LabeledVerdicts(path.stem, clip.fps, path.stem in AT_HAND, verdicts)


def _labels() -> list[Path]:
    return sorted(LABELS.glob("*.supports")) if CLIPS.is_dir() else []
