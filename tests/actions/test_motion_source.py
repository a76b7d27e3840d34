"""What a program of the user's gives is a motion, or is refused with the name of its action."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from footfall.actions import ask_source
from footfall.arrays import Positions, Rotations, Seconds
from footfall.errors import ArgumentError, ClipError, SourceError
from footfall.motion import Clip, sampling
from footfall.samples import sample
from footfall.skeleton import Skeleton
from footfall.support import SupportSequence


def as_it_is(given: Any) -> Any:
    return given


def crash(_given: Any) -> Any:
    raise ZeroDivisionError("division by zero")


def nowhere(given: Any) -> Any:
    return given[0] * np.nan, given[1]


@dataclass
class Replay:
    """Gives the poses of a clip."""

    clip: Clip
    supports: SupportSequence
    fps: float
    broken: Callable[[Any], Any] = as_it_is

    @property
    def skeleton(self) -> Skeleton:
        return self.clip.skeleton

    def poses(self, times: Seconds) -> tuple[Positions, Rotations]:
        return self.broken(sampling.sample(self.clip, times))


def replay(name: str = "walk", **changes: Any) -> Replay:
    clip, supports = sample(name)
    given: dict[str, Any] = {"fps": clip.fps, **changes}
    return Replay(clip, supports, **given)


@pytest.mark.parametrize("name", ["walk", "jump"])
def test_a_source_that_replays_a_clip_is_that_clip(name: str) -> None:
    source = replay(name)
    clip, supports = ask_source("copy", source)
    assert supports is source.supports
    assert (clip.name, clip.cyclic) == ("copy", source.clip.cyclic)
    assert clip.fps == pytest.approx(source.clip.fps)
    np.testing.assert_allclose(clip.pelvis_positions, source.clip.pelvis_positions, atol=1e-12)
    np.testing.assert_allclose(clip.local_rotations, source.clip.local_rotations, atol=1e-12)
    assert clip.provenance == ("made by a motion source",)


@pytest.mark.parametrize("fps", [1e-9, 7.0, 24, 59.94, 120.0])
def test_its_poses_span_the_whole_duration_at_about_its_rate(fps: float) -> None:
    source = replay(fps=fps)
    clip, supports = ask_source("copy", source)
    assert clip.duration == pytest.approx(supports.duration, abs=1e-12)
    assert abs((clip.frames - 1) - fps * supports.duration) <= 1.0


def test_it_may_keep_and_change_the_times_that_it_is_given() -> None:
    class Spoiling(Replay):
        def poses(self, times: Seconds) -> tuple[Positions, Rotations]:
            given = super().poses(times)
            times[:] = np.nan
            return given

    source = Spoiling(*sample("walk"), fps=30.0)
    assert ask_source("copy", source)[0].duration == pytest.approx(source.supports.duration)


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        (ZeroDivisionError("division by zero"), "ZeroDivisionError: division by zero"),
        (KeyError("arm"), "KeyError: 'arm'"),
        (NotImplementedError(), "NotImplementedError"),
        (ClipError("no such take"), "ClipError: no such take"),
    ],
)
def test_what_it_raises_is_told_with_the_name_of_the_action(problem: Exception, told: str) -> None:
    def fail(_given: Any) -> Any:
        raise problem

    with pytest.raises(SourceError) as caught:
        ask_source("wave", replay(broken=fail))
    assert (
        str(caught.value) == f"the source of 'wave' raised {told}; the library is as it was before"
    )
    assert caught.value.action == "wave"
    assert caught.value.__cause__ is problem


def test_a_failing_property_is_told_too() -> None:
    with pytest.raises(SourceError) as caught:
        ask_source("wave", object())  # pyright: ignore[reportArgumentType]
    assert caught.value.action == "wave"
    assert isinstance(caught.value.__cause__, AttributeError)


def test_an_interrupt_is_not_taken_for_a_failure() -> None:
    def interrupt(_given: Any) -> Any:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ask_source("wave", replay(broken=interrupt))


def nothing(_given: Any) -> Any:
    return None


def positions_only(given: Any) -> Any:
    return given[:1]


def words(given: Any) -> Any:
    return "far", given[1]


def too_few(given: Any) -> Any:
    return given[0][:-1], given[1][:-1]


def a_joint_less(given: Any) -> Any:
    return given[0], given[1][:, :-1]


def twice_as_long(given: Any) -> Any:
    return given[0], given[1] * 2.0


@pytest.mark.parametrize(
    ("broken", "error", "told"),
    [
        (nothing, SourceError, "raised TypeError: 'NoneType' object is not iterable"),
        (positions_only, SourceError, "raised ValueError: not enough values to unpack"),
        (words, SourceError, "raised ValueError: could not convert"),
        (
            too_few,
            ClipError,
            "the source of 'wave' gave positions of shape (32, 3) for 33 times; (33, 3) is needed",
        ),
        (a_joint_less, ClipError, "'wave': rotations of shape"),
        (nowhere, ClipError, "clip 'wave': a pelvis position in frame 0 is not finite"),
        (twice_as_long, ClipError, "has length 2.000000; unit quaternions are needed"),
    ],
)
def test_poses_that_are_none_are_refused(
    broken: Callable[[Any], Any], error: type[Exception], told: str
) -> None:
    with pytest.raises(error) as caught:
        ask_source("wave", replay(fps=32 / sample("walk")[1].duration, broken=broken))
    assert told in str(caught.value)
    assert "'wave'" in str(caught.value)


@pytest.mark.parametrize(
    ("fps", "told"),
    [
        (0.0, "the source of 'wave' has 0.0 frames per second; > 0 is needed"),
        (-30.0, "the source of 'wave' has -30.0 frames per second; > 0 is needed"),
        (float("nan"), "the source of 'wave' has nan frames per second; > 0 is needed"),
        ("30", "the source of 'wave' has '30' frames per second; > 0 is needed"),
        (
            1e12,
            "the source of 'wave' has 1e+12 frames per second for 1.06667 s; at most 1000000 "
            "frames are kept",
        ),
    ],
)
def test_a_rate_that_is_none_is_refused_before_anything_is_asked(fps: Any, told: str) -> None:
    def never(_given: Any) -> Any:
        pytest.fail("it was asked for poses")

    with pytest.raises(ArgumentError) as caught:
        ask_source("wave", replay(fps=fps, broken=never))
    assert str(caught.value) == told


def test_a_body_and_supports_that_are_none_are_refused() -> None:
    source: Any = replay()
    source.supports = "R D L D"
    with pytest.raises(ArgumentError) as caught:
        ask_source("wave", source)
    assert str(caught.value) == (
        "the supports of the source of 'wave' is a str; a SupportSequence is needed"
    )
