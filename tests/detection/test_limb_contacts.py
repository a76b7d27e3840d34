"""Four limbs: crawl, cartwheel and get-up, detected and played together."""

from __future__ import annotations

from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from tests.paper.requirements import requirement

from footfall.detection import detect_limb_supports, detect_supports, hands_on_the_ground
from footfall.errors import ArgumentError
from footfall.io import load
from footfall.motion import Clip
from footfall.samples import sample
from footfall.skeleton import Skeleton, find_anatomy
from footfall.support import SupportSequence
from footfall.sync import Synchronizer

MOTIONS = Path(__file__).parents[3] / "shared" / "motions" / "deepmimic"
ON_HANDS = ("crawl", "cartwheel", "getup_faceup", "getup_facedown")

needs_motions = pytest.mark.skipif(
    not MOTIONS.exists(), reason="needs the clips of ../shared/motions/deepmimic"
)


def motion(name: str) -> Clip:
    return load(MOTIONS / f"humanoid3d_{name}.txt.gz")


def symbols(supports: SupportSequence) -> list[str]:
    return [phase.support.symbol for phase in supports.phases]


def contains(whole: list[str], part: list[str]) -> bool:
    return any(whole[i : i + len(part)] == part for i in range(len(whole)))


@pytest.mark.parametrize("name", ["walk", "run", "kick", "jump", "idle"])
def test_a_motion_that_needs_no_hands_stands_on_what_it_stood_on(name: str) -> None:
    clip, _ = sample(name)
    assert hands_on_the_ground(clip, find_anatomy(clip.skeleton)) == (0.0, 0.0)
    assert str(detect_limb_supports(clip)) == str(detect_supports(clip))


@needs_motions
@pytest.mark.parametrize("name", ["walk", "run", "backflip", "kick", "dance_a"])
def test_real_motions_that_need_no_hands_neither(name: str) -> None:
    clip = motion(name)
    assert hands_on_the_ground(clip, find_anatomy(clip.skeleton)) == (0.0, 0.0)
    assert str(detect_limb_supports(clip)) == str(detect_supports(clip))


@needs_motions
def test_a_cartwheel_goes_over_one_hand_both_and_the_other_without_a_flight() -> None:
    found = symbols(detect_limb_supports(motion("cartwheel")))
    assert contains(found, ["L", "+l", "+lr", "+r", "R", "D"])
    assert "-" not in found
    assert "-" in symbols(detect_supports(motion("cartwheel")))


@needs_motions
def test_a_crawl_moves_diagonals_and_rests_on_all_fours() -> None:
    found = symbols(detect_limb_supports(motion("crawl")))
    assert "D+lr" in found
    assert contains(found, ["R+l", "D+l", "D+lr", "D+r", "L+r"])


@needs_motions
@pytest.mark.parametrize("name", ["getup_faceup", "getup_facedown"])
def test_getting_up_begins_on_hands_and_ends_on_feet_and_never_flies(name: str) -> None:
    found = symbols(detect_limb_supports(motion(name)))
    assert any("+lr" in symbol for symbol in found)
    assert found[-1] == "D"
    assert "-" not in found


@needs_motions
@pytest.mark.parametrize("name", ON_HANDS)
def test_the_phases_last_as_long_as_the_clip_and_none_is_flicker(name: str) -> None:
    clip = motion(name)
    supports = detect_limb_supports(clip)
    assert supports.duration == pytest.approx(clip.duration)
    assert min(phase.duration for phase in supports.phases) >= 0.06 - 1e-9
    assert SupportSequence.parse(str(supports)).phases[0].support is supports.phases[0].support


@pytest.fixture(scope="module")
def sequences() -> dict[str, SupportSequence]:
    if not MOTIONS.exists():
        pytest.skip("needs the clips of ../shared/motions/deepmimic")
    found = {name: detect_limb_supports(motion(name)) for name in ON_HANDS}
    return {**found, "walk": SupportSequence.parse("R.4 D.1 L.4 D.1*")}


def played(one: SupportSequence, other: SupportSequence) -> Synchronizer:
    """Return what has become of two actions forty slots after both were started."""
    synchronizer = Synchronizer([one, other], [0.7, 0.3], names=["one", "other"])
    assert synchronizer.start(0)
    synchronizer.start(1)
    for _ in range(40):
        assert synchronizer.next_slot().symbol != "Err"
    return synchronizer


@requirement(
    119,
    "limited to bipedic humans. It could be possible (mathematicaly) to extend the algorithm "
    "(considering hands for example)",
)
def test_the_planner_plays_all_of_them_together(sequences: dict[str, SupportSequence]) -> None:
    for one, other in permutations(ON_HANDS, 2):
        assert played(sequences[one], sequences[other]).waiting == {}
    for name in ON_HANDS:
        assert played(sequences[name], sequences["walk"]).waiting == {}


@pytest.mark.parametrize(
    ("name", "starts"), [("crawl", True), ("getup_facedown", True), ("cartwheel", False)]
)
def test_beside_a_walk_that_comes_first_only_what_leaves_it_its_feet(
    sequences: dict[str, SupportSequence], name: str, starts: bool
) -> None:
    waiting = played(sequences["walk"], sequences[name]).waiting
    assert (waiting == {}) is starts
    assert starts or waiting[1].startswith("waits: beside 'other' somebody would be held too long")


def test_a_skeleton_without_arms_is_told_so() -> None:
    names = ["Hips"]
    names += [f"{s}{p}" for s in ("Left", "Right") for p in ("UpLeg", "Leg", "Foot", "Toe")]
    parents = [-1, 0, 1, 2, 3, 0, 5, 6, 7]
    leg = [[0.1, 0.0, 0.0], [0.0, -0.4, 0.0], [0.0, -0.4, 0.0], [0.0, -0.05, 0.15]]
    other = [[-x, y, z] for x, y, z in leg]
    skeleton = Skeleton(tuple(names), np.array(parents), np.array([[0.0, 0.0, 0.0], *leg, *other]))
    turns = np.zeros((3, 9, 4))
    turns[..., 0] = 1.0
    clip = Clip(skeleton, np.full((3, 3), 0.85), turns, fps=30.0)
    assert hands_on_the_ground(clip, find_anatomy(skeleton)) == (0.0, 0.0)
    with pytest.raises(ArgumentError) as caught:
        detect_limb_supports(clip)
    assert str(caught.value) == (
        "the skeleton has no two arms that are known by their names, so that no hand can be "
        "found on the ground; detect its feet alone"
    )
