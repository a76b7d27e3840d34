"""Figure 16: several motions on a ground that changes while it is walked on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from footfall.adaptation import AnyGround, HeightField, Plane, ground_heights
from footfall.arrays import Floats
from footfall.detection.tracks import points_of_pose
from footfall.engine import Character, Recorder
from footfall.engine.recording import Recording
from footfall.figures.cast import Cast
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.silhouettes import Silhouettes
from footfall.figures.way import Way, apart
from footfall.motion import with_soles
from footfall.report import MethodReport, Trace, Track, measure, recording_trace
from footfall.skeleton import find_anatomy
from footfall.view.svg import Picture

__all__ = ["Hills", "WalkedGround", "changing_ground_figure", "walk_on_hills"]

CLAIM = (
    "The synchronization module is part of our complete kinematical animation engine MKM. In this "
    "example, the character is animated on an interactively changing ground. For the picture, the "
    "floor was stationary."
)
FPS = 60.0
DURATION = 9.0
CUES = (
    (0.0, "start", "walk"),
    (2.1, "start", "fast walk"),
    (2.5, "stop", "walk"),
    (4.3, "start", "walk"),
    (4.7, "stop", "fast walk"),
    (6.2, "start", "kick"),
    (6.6, "stop", "walk"),
)
"""When [s], what, and which part."""

MARGIN, SPACING = 1.5, 0.1
"""How much ground lies before the start, and between two heights [m]."""

LENGTH, HALF_WIDTH = 15.0, 2.0
"""How far it reaches ahead and to each side [m]."""

RISE, CHANGE = 0.13, 0.7
"""How high the hills are [m], and how fast they come and go [rad/s]."""


@dataclass(frozen=True)
class Hills:
    """Ground of two patterns of hills, whose heights may swing in time."""

    moving: bool
    """Whether they swing."""

    @property
    def shape(self) -> tuple[int, int]:
        """How many heights there are along z and along x."""
        return round((LENGTH + MARGIN) / SPACING) + 1, round(2 * HALF_WIDTH / SPACING) + 1

    @property
    def patterns(self) -> Floats:
        """Heights of both patterns [m], shape (2, along z, along x)."""
        rows, columns = self.shape
        z = (np.arange(rows, dtype=np.float64) * SPACING - MARGIN)[:, np.newaxis]
        x = (np.arange(columns, dtype=np.float64) * SPACING - HALF_WIDTH)[np.newaxis]
        # Level where the character begins.
        fade = np.clip(z / 1.2, 0.0, 1.0) ** 2
        first = np.sin(2.0 * np.pi * z / 3.1) * np.cos(0.5 * x)
        second = np.sin(2.0 * np.pi * z / 1.9 + 0.9 * x)
        patterns: Floats = RISE * np.stack([fade * first, 0.45 * fade * second])
        return patterns

    @property
    def grid(self) -> tuple[float, float, float]:
        """The x and z of the first height, and the distance between two [m]."""
        return (-HALF_WIDTH, -MARGIN, SPACING)

    def weights(self, time: float) -> tuple[float, float]:
        """Return how much there is of each pattern at a time [s]."""
        if not self.moving:
            return (1.0, 1.0)
        return (float(np.cos(CHANGE * time)), float(np.cos(0.7 * CHANGE * time + 0.8)))

    def at(self, time: float) -> HeightField:
        """Return the ground at a time [s]."""
        first, second = self.weights(time)
        patterns = self.patterns
        middle = (0.0, 0.5 * (LENGTH - MARGIN))
        return HeightField(first * patterns[0] + second * patterns[1], SPACING, middle)


@dataclass(frozen=True, eq=False)
class WalkedGround:
    """What a character did on hills, as it is measured."""

    hills: Hills
    recording: Recording
    trace: Trace
    report: MethodReport


@lru_cache(maxsize=4)
def walk_on_hills(cast: Cast, *, moving: bool) -> WalkedGround:
    """Let a character walk over hills that stand still, or change all the time."""
    hills = Hills(moving)
    recording = _performed(cast, hills.at)
    trace = _trace(recording, hills.at, cast, _resting_levels(cast))
    return WalkedGround(hills, recording, trace, measure(trace))


def _performed(cast: Cast, ground: Callable[[float], AnyGround]) -> Recording:
    """Play the cues on a ground that is exchanged wherever it is another one."""
    walk = cast.motion("walk")
    hero = Character(walk.clip.skeleton, ground=ground(0.0))
    for role in dict.fromkeys(role for _, _, role in CUES):
        motion = cast.motion(role)
        hero.add(role, motion.clip, motion.supports, priority=3.0 if role == "kick" else 1.0)
    recorder = Recorder(hero, FPS)
    for frame in range(int(DURATION * FPS) + 1):
        if frame > 0:
            hero.crowd.ground = ground(frame / FPS)
            hero.advance(1.0 / FPS)
        for at, kind, role in CUES:
            if round(at * FPS) == frame:
                (hero.start if kind == "start" else hero.stop)(role)
        if frame == 0:
            hero.advance(0.0)
        recorder.keep()
    return recorder.finish()


@lru_cache(maxsize=2)
def _resting_levels(cast: Cast) -> Floats:
    """Return how high heel and toe are while they rest [m]: on level ground, where that is seen."""
    plane = Plane()

    def level(time: float) -> AnyGround:
        del time
        return plane

    return Track.from_trace(_trace(_performed(cast, level), level, cast, None)).resting_levels


def _trace(
    recording: Recording,
    ground: Callable[[float], AnyGround],
    cast: Cast,
    resting: Floats | None,
) -> Trace:
    """Return the recording over the ground as it was at each moment."""
    walk = cast.motion("walk").clip
    anatomy = with_soles(find_anatomy(walk.skeleton), *walk.world_poses())
    points = points_of_pose(recording.world_rotations, recording.world_positions, anatomy)
    heights = np.stack(
        [
            ground_heights(ground(frame / FPS), points[frame], np.zeros((2, 2)))
            for frame in range(len(points))
        ]
    )
    trace = recording_trace(recording, anatomy, ground=heights)
    return replace(trace, resting_levels=resting)


def changing_ground_figure(cast: Cast) -> Figure:
    """Draw the character on hills that stand still, and measure it on hills that change too."""
    still, moving = (walk_on_hills(cast, moving=moves) for moves in (False, True))
    title = "Several motions on hills"
    note = (
        "For the picture the ground stands still; "
        "the animation of the same cues has it change all the time"
    )
    way = Way.of([still.trace], tallest=250.0)
    picture = begin_sheet(16, title, note, TOP + way.height + 120.0)
    base = TOP + way.height + 40.0
    _draw_ground(picture, way, still, base)
    silhouettes = Silhouettes(still.trace, still.recording.skeleton, way, base)
    for frame in apart(way, still.trace, 0.46, 0.55):
        silhouettes.draw(picture, frame)
    facts = (
        _told("Ground that stands still", still.report),
        _told("Ground that changes", moving.report),
    )
    return Figure(16, "changing_ground", title, CLAIM, facts, picture.to_svg())


def _draw_ground(picture: Picture, way: Way, walked: WalkedGround, base: float) -> None:
    """Draw the ground under the middle of the way."""
    path = walked.trace.positions[:, 0]
    along = np.linspace(way.start, way.start + (WIDTH - 2 * LEFT) / way.scale, 301)
    across = float(way.stage.leftward(path).mean())
    ahead, aside = way.stage.ahead, np.array([way.stage.ahead[1], -way.stage.ahead[0]])
    places = np.zeros((len(along), 3))
    places[:, [0, 2]] = along[:, np.newaxis] * ahead + across * aside
    heights = ground_heights(walked.hills.at(0.0), places, np.zeros(len(along)))
    top = [
        (way.x(float(x)), base - float(height) * way.scale)
        for x, height in zip(along, heights, strict=True)
    ]
    bottom = base + 46.0
    picture.area([(top[0][0], bottom), *top, (top[-1][0], bottom)], fill="#7d8794", opacity=0.22)
    picture.path(top, class_="softpen", stroke_width=2)


def _told(name: str, report: MethodReport) -> str:
    spreads = (report.drift.overall, report.penetration.overall, report.floating.overall)
    figures = [f"{spread.p95:.1f}" if spread.p95 is not None else "no" for spread in spreads]
    return (
        f"{name}: over all spans p95 drift {figures[0]} mm, penetration {figures[1]} mm, "
        f"float {figures[2]} mm."
    )
