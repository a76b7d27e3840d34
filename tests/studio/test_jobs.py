"""Long work shows how far it is, can be canceled, and never takes the session with it."""

from __future__ import annotations

import threading

from footfall.errors import ClipError
from footfall.studio.jobs import Job, Jobs


class Told:
    def __init__(self) -> None:
        self.changes = 0
        self.failures: list[str] = []

    def changed(self) -> None:
        self.changes += 1


def test_work_is_done_in_order_and_tells_how_far_it_is() -> None:
    told, seen = Told(), list[str]()
    jobs = Jobs(told.changed, told.failures.append)

    def work(job: Job) -> None:
        job.report(0.5, "half")
        seen.append(f"{job.title} {job.share} {job.detail}")

    jobs.begin("one", work)
    jobs.begin("two", work)
    jobs.wait()
    assert seen == ["one 0.5 half", "two 0.5 half"]
    assert jobs.present == ()
    assert told.changes >= 6
    assert told.failures == []


def test_canceled_work_ends_at_its_next_report_and_waiting_work_never_begins() -> None:
    told = Told()
    jobs = Jobs(told.changed, told.failures.append)
    begun, go_on = threading.Event(), threading.Event()

    def work(job: Job) -> None:
        begun.set()
        go_on.wait(10.0)
        job.report(0.5)
        raise AssertionError

    first = jobs.begin("one", work)
    second = jobs.begin("two", work)
    begun.wait(10.0)
    jobs.cancel(first.number)
    jobs.cancel(second.number)
    go_on.set()
    jobs.wait()
    assert told.failures == ["canceled: one", "canceled: two"]


def test_whatever_goes_wrong_is_told_in_one_line() -> None:
    told = Told()
    jobs = Jobs(told.changed, told.failures.append)
    errors = [ClipError("no frames"), MemoryError(), OSError("disk full"), ZeroDivisionError("x")]

    for error in errors:

        def work(_: Job, error: Exception = error) -> None:
            raise error

        jobs.begin("reading", work)
    jobs.wait()
    assert told.failures == [
        "no frames",
        "reading: MemoryError",
        "reading: disk full",
        "reading: unexpected ZeroDivisionError: x",
    ]
