"""What was captured in place travels as far as the motion it was, and its feet rest."""

from __future__ import annotations

import numpy as np
import pytest
from tests.detection.test_contacts import in_place

from footfall.detection import detect_supports, travel
from footfall.engine import Character
from footfall.errors import ClipError
from footfall.motion import Clip
from footfall.report import clip_trace, measure
from footfall.samples import sample
from footfall.skeleton import find_anatomy

GAITS = ("walk", "walk-slow", "walk-fast", "walk-backward", "side-step", "run")


def locked(clip: Clip) -> Clip:
    """Return the clip with its pelvis held over one place, as the engines of games have it."""
    return clip.evolve(pelvis_positions=clip.pelvis_positions * np.array([0.0, 1.0, 0.0]))


def slip(clip: Clip) -> float:
    """Return the 95th percentile of how far carrying feet slide [mm]."""
    trace = clip_trace(clip, find_anatomy(clip.skeleton), detect_supports(clip))
    spread = measure(trace).slip.overall
    assert spread.p95 is not None
    return spread.p95


@pytest.mark.parametrize(
    ("name", "still"),
    [(name, in_place(sample(name)[0])) for name in GAITS]
    + [(name, locked(sample(name)[0])) for name in GAITS if name != "side-step"],
)
def test_its_feet_rest_and_it_goes_as_far_as_the_motion_it_was(name: str, still: Clip) -> None:
    clip, _ = sample(name)
    gone = travel(still)
    way, wanted = (one.pelvis_positions[-1] - one.pelvis_positions[0] for one in (gone, clip))
    # How fast a body flies shows only in how its feet come and go.
    share = 0.04 if name == "run" else 0.002
    assert way == pytest.approx(wanted, abs=share * float(np.linalg.norm(wanted)))
    assert slip(still) > 100.0
    assert slip(gone) < 5.0
    assert gone.cyclic == clip.cyclic
    np.testing.assert_array_equal(gone.local_rotations, still.local_rotations)


def test_a_body_that_goes_by_fits_and_starts_is_taken_along_by_supports_that_are_given() -> None:
    clip, supports = sample("side-step")
    gone = travel(locked(clip), supports)
    way, wanted = (one.pelvis_positions[-1] - one.pelvis_positions[0] for one in (gone, clip))
    assert way == pytest.approx(wanted, abs=0.002)
    assert slip(gone) < 5.0


def test_a_character_that_performs_it_goes_as_fast_as_the_motion_it_was() -> None:
    clip, _ = sample("walk", fps=30)
    gone = travel(in_place(clip))
    hero = Character(gone.skeleton)
    hero.add("walk", gone, detect_supports(gone))
    hero.start("walk")
    places = [hero.advance(1 / 30).world_positions[0, 2] for _ in range(60)]
    assert (places[-1] - places[20]) * 30 / 39 == pytest.approx(1.31, abs=0.05)


@pytest.mark.parametrize("name", ["walk", "idle", "kick"])
def test_what_goes_by_itself_or_stands_is_left_alone(name: str) -> None:
    clip, _ = sample(name)
    with pytest.raises(ClipError) as refusal:
        travel(clip)
    assert str(refusal.value) == (
        f"clip {name!r} is not in place: the ground does not run under its feet faster than the "
        "body goes; only what was captured in place can be taken along"
    )
