"""Two crowds in two threads give the bits that each gives alone."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

from footfall.engine import Crowd, MotionLibrary
from footfall.samples import sample

FRAMES = 240


def library() -> MotionLibrary:
    shared = MotionLibrary()
    for name, priority in (("walk", 1.0), ("run", 2.0), ("kick", 3.0)):
        shared.add(name, *sample(name), priority=priority)
    return shared


def performance(crowd: Crowd, offset: int, barrier: Barrier | None = None) -> bytes:
    """Let a crowd of three perform; return every joint of every frame."""
    shown: list[bytes] = []
    if barrier is not None:
        barrier.wait(timeout=30.0)
    for frame in range(FRAMES):
        if frame == offset:
            crowd.start(0)
        if frame == 50 + offset:
            crowd.start(1, [0, 2])
        if frame == 120 + offset:
            crowd.stop(0)
            crowd.start(2, [1])
        crowd.advance(1 / 60)
        shown.append(crowd.world_positions.tobytes() + crowd.world_rotations.tobytes())
    return b"".join(shown)


def test_two_crowds_of_one_library_in_two_threads() -> None:
    shared = library()
    alone = [performance(Crowd(shared, 3), offset) for offset in (0, 7)]
    assert alone[0] != alone[1]
    for _ in range(3):
        barrier = Barrier(2)
        with ThreadPoolExecutor(2) as pool:
            jobs = [
                pool.submit(performance, Crowd(shared, 3), offset, barrier) for offset in (0, 7)
            ]
            assert [job.result() for job in jobs] == alone
