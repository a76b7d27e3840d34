"""Figure 14: a motion that leads from walking to hopping finds room where a hop finds none."""

from __future__ import annotations

from footfall.engine import Character, Impossible, Started, Waiting
from footfall.figures.cast import Cast
from footfall.figures.cells import define_hatching
from footfall.figures.figure import LEFT, TOP, WIDTH, Figure, begin_sheet
from footfall.figures.performing import Cues, perform_cues
from footfall.figures.played_lanes import draw_lane, draw_mark, draw_result
from footfall.figures.strip import TimeAxis, draw_band, draw_poses, timed_phases
from footfall.report import clip_trace
from footfall.skeleton import find_anatomy
from footfall.view import performance_timeline
from footfall.view.svg import Picture

__all__ = ["answers", "walk_to_hop_figure"]

CLAIM = (
    "Walk-to-hop sequence. It is possible to fail synchronizing critical motions like a right "
    "hopping with a left hopping motion; coupling normal motions with critical ones gives more "
    "solutions."
)
LONGEST = 4.2
"""What is shown at most of a motion [s]."""

POSES = 15
BAND = 28.0
ASKED, LEFT_BEHIND = 0.6, 1.35
"""When the walk-to-hop is commanded beside the left hop, and when that is stopped [s]."""


def walk_to_hop_figure(cast: Cast) -> Figure:
    """Draw the motion with its sequence, and what becomes of it beside a left hop."""
    motion = cast.motion("walk to hop")
    shown = min(motion.clip.duration, LONGEST)
    title = "A walk-to-hop sequence"
    note = (
        "Above: the motion and its phases. "
        "Below: commanded (▾) while the character hops on the left foot, which is then stopped (▪)"
    )
    picture = begin_sheet(14, title, note, 566.0)
    define_hatching(picture)
    axis = TimeAxis(LEFT + 116.0, WIDTH - LEFT - 30.0, shown)
    draw_band(picture, axis, timed_phases(motion.supports, shown), TOP + 6.0)
    trace = clip_trace(motion.clip, find_anatomy(motion.clip.skeleton), motion.supports)
    times = [shown * (index + 0.5) / POSES for index in range(POSES)]
    parents = motion.clip.skeleton.parents
    draw_poses(picture, trace, parents, axis, TOP + 228.0, times, tallest=170.0)
    _draw_beside_hop(picture, cast, TimeAxis(axis.left, axis.right, shown + 0.4), TOP + 294.0)
    hop, coupled = answers(cast)
    facts = (
        f"Sequence: {' '.join(phase.support.symbol for phase in motion.supports.phases)}.",
        f"A right hop beside the left hop: {_told(hop)}.",
        f"The walk-to-hop beside the left hop: {_told(coupled)}.",
    )
    for row, fact in enumerate(facts[1:]):
        picture.words(LEFT, TOP + 430.0 + 24.0 * row, fact, size=15)
    return Figure(14, "walk_to_hop", title, CLAIM, facts, picture.to_svg())


def answers(cast: Cast) -> tuple[Started | Waiting, Started | Waiting]:
    """Return what a character that hops on the left foot says to a right hop and a walk-to-hop."""
    given: list[Started | Waiting] = []
    for role in ("right hop", "walk to hop"):
        hop, other = cast.motion("left hop"), cast.motion(role)
        hero = Character(hop.clip.skeleton)
        hero.add("left hop", hop.clip, hop.supports)
        hero.add(role, other.clip, other.supports)
        hero.start("left hop")
        hero.advance(ASKED)
        given.append(hero.start(role))
    return given[0], given[1]


def _told(answer: Started | Waiting) -> str:
    if isinstance(answer, Started):
        return "starts at once"
    if isinstance(answer, Impossible):
        return "can never start; every joint state has been tried"
    if answer.until is None:
        return "waits for longer than can be foreseen"
    return f"starts after {answer.until - ASKED:.2f} s"


def _draw_beside_hop(picture: Picture, cast: Cast, axis: TimeAxis, top: float) -> None:
    cues: Cues = (
        (0.0, "start", "left hop"),
        (ASKED, "start", "walk to hop"),
        (LEFT_BEHIND, "stop", "left hop"),
    )
    performance = perform_cues(cast, cues, axis.duration)
    timeline = performance_timeline(performance)
    for row, lane in enumerate(timeline.lanes):
        y = top + row * (BAND + 4)
        picture.words(LEFT, y + 19, lane.name, size=15, font_weight="600")
        draw_lane(picture, axis, lane, y, BAND)
    y = top + 2 * (BAND + 4) + 4
    picture.words(LEFT, y + 19, "result", size=15, class_="soft")
    draw_result(picture, axis, timeline, y, BAND)
    draw_mark(picture, axis.x(ASKED), top - 2)
    draw_mark(picture, axis.x(LEFT_BEHIND), top - 2, stop=True)
