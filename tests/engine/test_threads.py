"""Two crowds in two threads give the bits that each gives alone."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import pytest

from footfall.engine import Crowd, MotionLibrary, workers
from footfall.octets import LANES
from footfall.samples import sample

FRAMES = 240


def library() -> MotionLibrary:
    shared = MotionLibrary()
    for name, priority in (("walk", 1.0), ("run", 2.0), ("kick", 3.0)):
        shared.add(name, *sample(name), priority=priority)
    return shared


def performance(crowd: Crowd, offset: int, barrier: Barrier | None = None) -> bytes:
    """Let a crowd perform; return every joint of every frame."""
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


@pytest.mark.parametrize(("size", "threads"), [(3, None), (40, 1), (40, 3)])
def test_two_crowds_of_one_library_in_two_threads(
    size: int, threads: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A small crowd is shared by threads as a great one is, a block at a time.
    monkeypatch.setattr(workers, "SERIAL_BELOW", 2 * LANES)
    monkeypatch.setattr(workers, "SHARE", 1)
    shared = library()

    def crowd() -> Crowd:
        return Crowd(shared, size, threads=threads)

    alone = [performance(crowd(), offset) for offset in (0, 7)]
    assert alone[0] != alone[1]
    for _ in range(3):
        barrier = Barrier(2)
        with ThreadPoolExecutor(2) as pool:
            jobs = [pool.submit(performance, crowd(), offset, barrier) for offset in (0, 7)]
            assert [job.result() for job in jobs] == alone
