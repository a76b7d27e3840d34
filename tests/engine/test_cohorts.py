"""Crowds of several bodies: each row is that character alone, on that body."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.engine.test_crowd import DT, NAMES, command
from tests.motion.test_retargeting import ROBOT as ROBOT_TEXT
from tests.skeleton.bodies import body as body_of

import footfall as ff
from footfall.arrays import Floats
from footfall.engine.cohorts import Span, with_more
from footfall.errors import ArgumentError, SkeletonError
from footfall.skeleton import Skeleton

ROBOT = body_of(ROBOT_TEXT)
BODY = ff.sample("walk")[0].skeleton


def scaled(factor: float, legs: float = 1.0) -> Skeleton:
    """Return a body of the samples' family, its legs longer still by another factor."""
    lengths = np.full((BODY.count, 1), factor)
    lengths[[i for i, name in enumerate(BODY.names) if "Leg" in name or "Foot" in name]] *= legs
    return Skeleton(
        BODY.names, BODY.parents, lengths * BODY.rest_offsets, lengths * BODY.tip_offsets
    )


BODIES = (BODY, scaled(0.6), scaled(1.6), scaled(1.0, 0.8), scaled(1.0, 1.2), ROBOT)


@pytest.fixture(scope="module")
def library() -> ff.MotionLibrary:
    library = ff.MotionLibrary()
    for name in NAMES:
        library.add(name, *ff.sample(name))
    return library


def motley(library: ff.MotionLibrary, each: int, **options: Any) -> ff.Crowd:
    """Return a crowd with some characters of each body."""
    crowd = ff.Crowd(library, each, **options)
    for body in BODIES[1:]:
        crowd.spawn(each, body=body)
    return crowd


def relative(crowd: ff.Crowd, row: int) -> Floats:
    """Return the joints of a row as seen from its pelvis [m]."""
    for cohort in crowd.cohorts:
        if row in cohort.rows:
            positions = cohort.world_positions[row - cohort.span.first]
            return positions - positions[0]
    raise AssertionError(row)


def test_each_row_is_the_same_character_alone_on_its_body(library: ff.MotionLibrary) -> None:
    crowd = motley(library, 3)
    rows = [int(np.flatnonzero(crowd.body_of_row == body)[1]) for body in range(len(BODIES))]
    alone = [ff.Crowd(library, 1, skeleton=body) for body in BODIES]
    heroes = [ff.Character(body) for body in BODIES]
    for hero in heroes:
        for name in NAMES:
            hero.add(name, *ff.sample(name))
    for frame in range(150):
        # The others begin at other moments: nothing of theirs may be seen in these rows.
        others = np.setdiff1d(np.flatnonzero(crowd.present), rows)
        command(crowd, frame - 7, others)
        command(crowd, frame, rows)
        crowd.advance(DT)
        for row, one, hero in zip(rows, alone, heroes, strict=True):
            for single in (one, hero.crowd):
                command(single, frame, [0])
                single.advance(DT)
            assert np.array_equal(relative(crowd, row), relative(one, 0))
            assert np.abs(relative(crowd, row) - relative(hero.crowd, 0)).max() < 1e-5
    assert len({relative(crowd, row).tobytes() for row in rows}) == len(BODIES)


def test_the_number_of_threads_changes_no_bit_of_several_bodies(library: ff.MotionLibrary) -> None:
    crowds = [motley(library, 501, threads=threads) for threads in (1, 2, 3)]
    for crowd in crowds:
        crowd.start(0, ahead=np.linspace(0.0, 2.0, int(crowd.present.sum())))
        for frame in range(12):
            if frame == 5:
                crowd.start(1, np.flatnonzero(crowd.present)[::3])
            crowd.advance(DT)
    one, *others = crowds
    for other in others:
        assert one.characters.tobytes() == other.characters.tobytes()
        for cohort, same in zip(one.cohorts, other.cohorts, strict=True):
            assert np.array_equal(cohort.poses, same.poses)


def test_rows_of_another_body_begin_with_a_block(library: ff.MotionLibrary) -> None:
    crowd, child = ff.Crowd(library, 5), scaled(0.6)
    crowd.start(0)
    crowd.advance(DT)
    before = relative(crowd, 4).copy()
    assert crowd.spawn(2, body=child).tolist() == [8, 9]
    assert np.array_equal(relative(crowd, 4), before)
    assert crowd.present.tolist() == [True] * 5 + [False] * 3 + [True] * 2
    assert crowd.body_of_row.tolist() == [0] * 8 + [1] * 2
    # What is empty is for whoever has that body.
    assert crowd.spawn(4).tolist() == [5, 6, 7, 16]
    crowd.remove([1, 8])
    assert crowd.spawn(1, body=scaled(0.6)).tolist() == [8]
    assert crowd.spawn(2).tolist() == [1, 17]
    assert [cohort.span for cohort in crowd.cohorts] == [
        Span(0, 0, 0, 8),
        Span(1, 0, 8, 8),
        Span(0, 0, 16, 2),
    ]
    assert len(crowd.bodies) == 2
    crowd.advance(DT)
    assert crowd.world_positions.shape == (18, BODY.count, 3)
    assert crowd.poses.shape == (3, BODY.count, 7, 8)


@pytest.mark.parametrize("body", [0, 1])
@pytest.mark.parametrize("rows", range(1, 18))
def test_more_rows_leave_those_that_are_there(rows: int, body: int) -> None:
    spans = with_more([Span(0, 0, 0, rows)], body, 0, 3)
    assert with_more([Span(0, 0, 0, rows)], 0, body, 3)[-1].ground == body
    if body == 0:
        assert spans == [Span(0, 0, 0, rows + 3)]
        return
    first, second = spans
    assert first.rows >= rows
    assert (first.first, first.rows % 8, first.rows - rows < 8) == (0, 0, True)
    assert second == Span(1, 0, first.rows, 3)


def test_bodies_of_other_joints_have_no_array_in_common(library: ff.MotionLibrary) -> None:
    crowd = motley(library, 2)
    crowd.start(0)
    crowd.advance(DT)
    fewer, more = sorted((BODY.count, ROBOT.count))
    for name in ("poses", "world_positions", "world_rotations"):
        with pytest.raises(ArgumentError) as caught:
            getattr(crowd, name)
        assert str(caught.value) == (
            f"bodies of {fewer} and of {more} joints have no array in common; read the crowd's "
            "cohorts one by one"
        )
    for cohort in crowd.cohorts:
        joints = cohort.skeleton.count
        assert cohort.poses.shape == (1, joints, 7, 8)
        assert cohort.world_positions.shape == (len(cohort.rows), joints, 3)
        assert np.isfinite(cohort.world_rotations).all()


def test_a_body_that_cannot_perform_the_motions_is_refused(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 2)
    box = Skeleton(("box",), np.array([-1]), np.zeros((1, 3)))
    with pytest.raises(SkeletonError):
        crowd.spawn(1, body=box)
    assert (crowd.size, len(crowd.bodies)) == (2, 1)
    crowd.start(0)
    crowd.advance(DT)


def test_a_command_that_one_of_another_family_cannot_take_is_given_to_nobody() -> None:
    library = ff.MotionLibrary()
    for index in range(9):
        library.add(f"walk {index}", *ff.sample("walk"))
    crowd = ff.Crowd(library, 1)
    (robot,) = crowd.spawn(1, body=ROBOT).tolist()
    for action in range(8):
        crowd.start(action, [robot])
    with pytest.raises(ArgumentError, match=f"character {robot} already has 8 actions running"):
        crowd.start(8)
    assert crowd.characters["occupied"][[0, robot]].tolist() == [0, 8]


def test_an_action_that_is_added_later_is_known_to_all_bodies() -> None:
    library = ff.MotionLibrary()
    library.add("walk", *ff.sample("walk"))
    crowd = ff.Crowd(library, 1)
    (robot,) = crowd.spawn(1, body=ROBOT).tolist()
    crowd.advance(DT)
    wave = library.add_layer("wave", ff.sample("punch")[0])
    run = library.add("run", *ff.sample("run"))
    assert crowd.start(run).all()
    crowd.advance(DT)
    assert (crowd.characters["action"][[0, robot], 0] == run).all()
    assert library.adapted(ROBOT).actions[run].name == "run"
    crowd.start_layer(wave)
    alone = ff.Crowd(library, 1, skeleton=ROBOT)
    alone.characters[:] = crowd.characters[[robot]]
    for _ in range(20):
        crowd.advance(DT)
        alone.advance(DT)
    assert crowd.layer_weights(wave)[[0, robot]] == pytest.approx(1.0)
    assert np.array_equal(relative(crowd, robot), relative(alone, 0))


def gaits() -> ff.MotionLibrary:
    library = ff.MotionLibrary()
    library.add_locomotion("go", [ff.sample(name) for name in ("walk", "walk-fast", "run")])
    return library


def test_all_bodies_are_steered_in_proportion_to_their_legs() -> None:
    crowd = ff.Crowd(gaits(), 1)
    rows = [0, *(int(crowd.spawn(1, body=body)[0]) for body in (scaled(0.6), ROBOT))]
    crowd.start(0)
    crowd.set_parameters(0, speed=2.0)
    for _ in range(180):
        crowd.advance(DT)
    before = crowd.characters["root"][rows, :2].copy()
    for _ in range(60):
        crowd.advance(DT)
    speeds = np.linalg.norm(crowd.characters["root"][rows, :2] - before, axis=1)
    legs = [library_leg(crowd, body) for body in range(3)]
    assert speeds[0] == pytest.approx(2.0, abs=0.1)
    assert speeds / legs == pytest.approx(np.full(3, speeds[0] / legs[0]), rel=0.06)


def library_leg(crowd: ff.Crowd, body: int) -> float:
    """Return the length of a leg [m]."""
    return float(crowd.library.adapted(crowd.bodies[body]).rig().leg_length)


def test_a_snapshot_takes_all_bodies_hands_goals_and_gaits_back(tmp_path: Any) -> None:
    def go_on(crowd: ff.Crowd) -> list[Floats]:
        shown: list[Floats] = []
        for frame in range(60):
            crowd.goals.look_at((3.0, 1.0, 0.01 * frame), np.flatnonzero(crowd.present)[::2])
            crowd.advance(DT)
            shown += [cohort.world_positions.copy() for cohort in crowd.cohorts]
        return shown

    def begin() -> ff.Crowd:
        crowd = ff.Crowd(gaits(), 3)
        for body in (scaled(0.6), ROBOT):
            crowd.spawn(3, body=body)
        return crowd

    crowd = begin()
    crowd.start(0)
    crowd.goals.sit(0.5, [1], fade=0.5)
    crowd.reach("left", (0.5, 1.0, 1.0), [0, 8])
    crowd.set_parameters(0, speed=2.6)
    for _ in range(20):
        crowd.advance(DT)
    arrays: Any = crowd.snapshot()
    np.savez(tmp_path / "crowd.npz", **arrays)
    first = go_on(crowd)
    with np.load(tmp_path / "crowd.npz") as kept:
        for again in (crowd, begin()):
            again.restore(dict(kept))
            for one, other in zip(first, go_on(again), strict=True):
                assert np.array_equal(one, other)


def test_a_snapshot_of_other_bodies_is_refused(library: ff.MotionLibrary) -> None:
    one, other = ff.Crowd(library, 8), ff.Crowd(library, 8)
    for crowd, bodies in ((one, (0.6, 1.6)), (other, (1.6, 0.6))):
        for factor in bodies:
            crowd.spawn(8, body=scaled(factor))
    with pytest.raises(ArgumentError) as caught:
        one.restore(other.snapshot())
    assert str(caught.value) == (
        "a snapshot of rows of other bodies or grounds; first spawn the same ones in the same order"
    )


def test_rows_stand_on_grounds_of_their_own(library: ff.MotionLibrary) -> None:
    ramp, high = ff.Plane(slope=(0.0, 0.15)), ff.Plane(1.5)
    crowd = ff.Crowd(library, 3)
    steep = crowd.spawn(2, ground=ramp)
    raised = crowd.spawn(2, ground=high, body=scaled(0.6))
    assert crowd.spawn(1, ground=ramp).tolist() == [int(steep[-1]) + 1]
    alone = {
        0: ff.Crowd(library, 1),
        int(steep[1]): ff.Crowd(library, 1, ground=ramp),
        int(raised[0]): ff.Crowd(library, 1, ground=high, skeleton=scaled(0.6)),
    }
    assert [crowd.ground_of_row[row] for row in alone] == [crowd.ground, ramp, high]
    lower = ff.Plane(1.2)
    for frame in range(120):
        if frame == 60:
            crowd.exchange_ground(lower, rise=-0.3, instead_of=high)
            alone[int(raised[0])].exchange_ground(lower, rise=-0.3)
        for one in (crowd, *alone.values()):
            command(one, frame, None)
            one.advance(DT)
        for row, one in alone.items():
            assert np.array_equal(crowd.world_positions[row], one.world_positions[0])
    assert crowd.world_positions[raised[0], :, 1].min() == pytest.approx(1.2, abs=0.05)
    with pytest.raises(ArgumentError) as caught:
        crowd.exchange_ground(ramp, instead_of=high)
    assert str(caught.value) == f"nobody stands on {high}; exchange what somebody stands on"
