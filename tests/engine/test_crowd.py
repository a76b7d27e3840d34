"""Crowds: each row is a character alone, whoever works on it, whoever comes and goes beside it."""

from __future__ import annotations

import tracemalloc
from typing import Any

import numpy as np
import pytest

import footfall as ff
from footfall.arrays import Floats
from footfall.errors import ArgumentError

DT = 1.0 / 60.0
NAMES = ("walk", "run", "kick", "punch", "walk-fast")


@pytest.fixture(scope="module")
def library() -> ff.MotionLibrary:
    library = ff.MotionLibrary()
    for name in NAMES:
        library.add(name, *ff.sample(name))
    return library


def relative(crowd: ff.Crowd, row: int) -> Floats:
    """Return the joints of a row as seen from its pelvis [m]."""
    positions = crowd.world_positions[row]
    return positions - positions[0]


def command(crowd: ff.Crowd, frame: int, rows: Any) -> None:
    """Give the commands of one frame of a busy scene to some rows."""
    if frame == 0:
        crowd.start(0, rows)
    if frame == 40:
        crowd.start(1, rows)
    if frame == 90:
        crowd.start(3, rows, patience=1.0, late="mute")
        crowd.set_priority(1, {"legs": 2.0, "arms": 0.5}, rows)
    if frame == 130:
        crowd.stop(0, rows)


@pytest.mark.parametrize("row", [0, 3, 7, 8, 12])
def test_each_row_is_the_same_character_alone(library: ff.MotionLibrary, row: int) -> None:
    crowd, alone = ff.Crowd(library, 13), ff.Crowd(library, 1)
    for frame in range(200):
        # The others begin at other moments: nothing of theirs may be seen in this row.
        for other in range(13):
            if other != row:
                command(crowd, frame - 3 * other, [other])
        command(crowd, frame, [row])
        command(alone, frame, [0])
        crowd.advance(DT)
        alone.advance(DT)
        assert np.array_equal(relative(crowd, row), relative(alone, 0))


def test_the_number_of_threads_changes_no_bit(library: ff.MotionLibrary) -> None:
    crowds = [ff.Crowd(library, 5003, threads=threads) for threads in (1, 2, 3)]
    random = np.random.default_rng(0)
    places = random.uniform(-50.0, 50.0, (5003, 2))
    for crowd in crowds:
        crowd.place(places)
        crowd.start(0, ahead=np.linspace(0.0, 2.0, 5003))
        for frame in range(25):
            if frame == 5:
                crowd.start(1, np.arange(0, 5003, 3))
            crowd.advance(DT)
    one, *others = crowds
    for other in others:
        assert np.array_equal(one.poses, other.poses)
        assert one.characters.tobytes() == other.characters.tobytes()


def test_no_thread_is_refused(library: ff.MotionLibrary) -> None:
    with pytest.raises(ArgumentError, match="0 threads; a crowd needs at least 1"):
        ff.Crowd(library, 1, threads=0)


def test_a_frame_leaves_no_memory_behind(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 3000, threads=2)
    crowd.start(0)
    for _ in range(20):
        crowd.advance(DT)
    tracemalloc.start()
    try:
        for _ in range(40):
            crowd.advance(DT)
        before, _ = tracemalloc.get_traced_memory()
        for _ in range(160):
            crowd.advance(DT)
        after, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    # A hundred bytes a frame: threads keep some for themselves, whatever the number of frames.
    assert after - before < 16000
    assert peak - before < 65536


def test_who_began_earlier_is_where_it_would_be(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 2)
    crowd.start(0, [0])
    crowd.start(0, [1], ahead=30 * DT)
    for _ in range(30):
        crowd.advance(DT)
    early = relative(crowd, 1).copy(), float(crowd.characters["clip_time"][1, 0])
    assert float(crowd.characters["clock"][1]) == pytest.approx(30 * DT)
    for _ in range(30):
        crowd.advance(DT)
    assert float(crowd.characters["clip_time"][0, 0]) == pytest.approx(early[1], abs=1e-9)
    # Legs stand on footprints, which are where the feet have come down.
    trunk = library.rig().leg_sides < 0
    assert np.abs(relative(crowd, 0) - early[0])[trunk].max() < 1e-5


def test_only_who_has_shown_nothing_can_be_ahead(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 2)
    with pytest.raises(ArgumentError, match=r"ahead is -1\.0 s; it must be finite and >= 0"):
        crowd.start(0, ahead=-1.0)
    crowd.advance(DT)
    with pytest.raises(ArgumentError, match="character 1 has been shown already"):
        crowd.start(0, ahead=[0.0, 0.5])


def test_who_is_spawned_takes_the_rows_of_those_who_left(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 4)
    crowd.start(0)
    crowd.advance(DT)
    crowd.remove([1, 2])
    assert crowd.present.tolist() == [True, False, False, True]
    with pytest.raises(ArgumentError, match="nobody is in row 2; whoever was has been removed"):
        crowd.stop(0, [2])
    rows = crowd.spawn(3, position=(5.0, 6.0), heading=0.5)
    assert rows.tolist() == [1, 2, 4]
    assert crowd.size == 5
    assert crowd.present.all()
    assert crowd.characters["root"][rows].tolist() == [[5.0, 6.0, 0.5]] * 3
    assert (crowd.characters["occupied"] > 0).tolist() == [True, False, False, True, False]
    crowd.advance(DT)
    assert crowd.world_positions.shape == (5, library.skeleton.count, 3)
    with pytest.raises(ArgumentError, match="-1 characters to spawn"):
        crowd.spawn(-1)


def test_who_is_left_does_not_notice_who_comes_and_goes(library: ff.MotionLibrary) -> None:
    quiet, busy = ff.Crowd(library, 9), ff.Crowd(library, 9)
    for frame in range(60):
        for crowd in (quiet, busy):
            command(crowd, frame, [4])
        if frame == 20:
            busy.remove([0, 8])
        if frame == 30:
            busy.start(1, busy.spawn(20))
        quiet.advance(DT)
        busy.advance(DT)
        assert np.array_equal(relative(quiet, 4), relative(busy, 4))


def test_a_removed_character_stays_as_it_was(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 3)
    crowd.start(0)
    crowd.advance(DT)
    crowd.remove([1])
    before, clock = crowd.world_positions[1].copy(), float(crowd.characters["clock"][1])
    crowd.advance(DT)
    assert np.array_equal(crowd.world_positions[1], before)
    assert float(crowd.characters["clock"][1]) == clock


def test_a_snapshot_takes_the_crowd_back(library: ff.MotionLibrary, tmp_path: Any) -> None:
    crowd = ff.Crowd(library, 6)
    for frame in range(50):
        command(crowd, frame, None)
        crowd.advance(DT)
    arrays: Any = crowd.snapshot()
    np.savez(tmp_path / "crowd.npz", **arrays)
    for frame in range(50, 140):
        command(crowd, frame, None)
        crowd.advance(DT)
    first = crowd.world_positions.copy()
    with np.load(tmp_path / "crowd.npz") as kept:
        crowd.restore(dict(kept))
    for frame in range(50, 140):
        command(crowd, frame, None)
        crowd.advance(DT)
    assert np.array_equal(crowd.world_positions, first)


def test_a_snapshot_of_another_crowd_is_refused(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 6)
    before = crowd.snapshot()
    first, array = next(iter(before.items()))
    needed = f"this crowd needs {array.shape}"
    smaller = ff.Crowd(library, 5).snapshot()
    for snapshot, found in (
        (smaller, f"a snapshot with {smaller[first].shape} for {first!r}; {needed}"),
        ({}, f"a snapshot with nothing for {first!r}; {needed}"),
        (
            {**before, "clock": np.zeros(5)},
            "a snapshot with (5,) for 'clock'; this crowd needs (6,)",
        ),
    ):
        with pytest.raises(ArgumentError) as caught:
            crowd.restore(snapshot)
        assert str(caught.value) == found


def test_at_half_rate_every_second_frame_is_the_one_before(library: ff.MotionLibrary) -> None:
    crowd = ff.Crowd(library, 10)
    crowd.start(0)
    crowd.advance(0.0)
    crowd.set_detail("half rate")
    shown: list[Floats] = []
    for _ in range(41):
        crowd.advance(DT)
        shown.append(crowd.world_positions.copy())
    moved = np.abs(np.diff(shown, axis=0)).max(axis=(2, 3)) > 0.0
    for row in range(10):
        assert (moved[::2, row] != moved[1::2, row]).all()
    assert (moved[:, 0] != moved[:, 1]).all()
    full = ff.Crowd(library, 1)
    full.start(0)
    full.advance(0.0)
    for _ in range(40):
        full.advance(DT)
    late = float(crowd.characters["clock"][0] - full.characters["clock"][0])
    assert abs(late) < 1.01 * DT


def test_who_does_not_reach_has_the_legs_of_the_motion(library: ff.MotionLibrary) -> None:
    ground = ff.Plane(slope=(0.0, 0.1))
    crowd = ff.Crowd(library, 2, ground=ground)
    crowd.set_detail("no reaching", [1])
    crowd.start(0)
    for _ in range(40):
        crowd.advance(DT)
    apart = np.abs(relative(crowd, 0) - relative(crowd, 1)).max(axis=-1)
    assert apart.max() > 0.01
    with pytest.raises(ArgumentError, match="detail 'none'; there are: full, no reaching, half"):
        crowd.set_detail("none")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]


def test_synchronization_is_chosen_row_by_row(library: ff.MotionLibrary) -> None:
    crowd, plain = ff.Crowd(library, 3), ff.Crowd(library, 1, synchronized=False)
    crowd.set_synchronized(False, [1])
    for frame in range(100):
        for one in (crowd, plain):
            command(one, frame, None)
            one.advance(DT)
    assert np.array_equal(relative(crowd, 1), relative(plain, 0))
    assert not np.array_equal(relative(crowd, 1), relative(crowd, 0))
    with pytest.raises(ArgumentError, match="character 0 runs actions; synchronization can be"):
        crowd.set_synchronized(True)


def test_a_command_that_one_cannot_take_is_given_to_nobody(library: ff.MotionLibrary) -> None:
    full = ff.MotionLibrary()
    for index in range(9):
        full.add(f"walk {index}", *ff.sample("walk"))
    crowd = ff.Crowd(full, 2)
    for action in range(8):
        crowd.start(action, [1])
    with pytest.raises(ArgumentError, match="character 1 already has 8 actions running"):
        crowd.start(8)
    assert crowd.characters["occupied"].tolist() == [0, 8]
    del library
