from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import pytest
from tests.datasets.archives import make_archive

from footfall.datasets import ClipAnnotation, annotate_archive, dask_executor, local_pool
from footfall.datasets.executors import usable_cores
from footfall.errors import ArgumentError, MissingExtraError
from footfall.io import save
from footfall.samples import sample


def test_a_pool_works_in_other_processes() -> None:
    with local_pool(1) as pool:
        assert pool.submit(os.getpid).result() != os.getpid()
    assert usable_cores() >= 1


def test_a_pool_needs_a_worker() -> None:
    with pytest.raises(ArgumentError) as caught:
        local_pool(0)
    assert str(caught.value) == "workers is 0; at least one is needed"


def test_without_dask_the_way_to_get_it_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(MissingExtraError) as caught:
        dask_executor("tcp://127.0.0.1:1")
    assert str(caught.value) == (
        "working on a cluster needs distributed; pip install 'footfall[dask]'"
    )


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "no address at all"])
def test_a_scheduler_that_does_not_answer_is_told(
    monkeypatch: pytest.MonkeyPatch, address: str
) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("footfall.datasets.executors.CONNECT_SECONDS", 1)
    with pytest.raises(ArgumentError) as caught:
        dask_executor(address)
    assert str(caught.value).startswith(f"no Dask scheduler answers at {address!r}: ")


class Cluster:
    """A scheduler and two workers, each a process of its own."""

    def __init__(self, folder: Path) -> None:
        self.file = folder / "scheduler.json"
        quiet = ["--no-dashboard"]
        self.scheduler = self._start(
            "scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", self.file, *quiet
        )
        until = time.monotonic() + 60.0
        while not self.file.exists():
            assert time.monotonic() < until, "the scheduler does not start"
            time.sleep(0.1)
        self.workers = [
            self._start(
                "worker",
                "--scheduler-file",
                self.file,
                "--nthreads",
                "1",
                "--no-nanny",
                *quiet,
                "--local-directory",
                folder / f"worker{index}",
            )
            for index in range(2)
        ]

    @property
    def address(self) -> str:
        import json

        return str(json.loads(self.file.read_text())["address"])

    def end(self) -> None:
        for process in [*self.workers, self.scheduler]:
            process.kill()
            process.wait()

    @staticmethod
    def _start(what: str, *words: object) -> subprocess.Popen[bytes]:
        command = [sys.executable, "-m", f"distributed.cli.dask_{what}", *map(str, words)]
        return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[Cluster]:
    pytest.importorskip("distributed")
    running = Cluster(tmp_path)
    yield running
    running.end()


def test_a_worker_killed_half_way_loses_nothing_and_does_nothing_twice(
    cluster: Cluster, tmp_path: Path
) -> None:
    pytest.importorskip("pyarrow")
    from distributed import Client

    archive = make_archive(tmp_path / "archive")
    for index in range(120):
        save(sample(("walk", "run", "kick")[index % 3])[0], archive / f"more{index:03d}.npz")
    with Client(cluster.address, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=60)
    files: list[str] = []

    def told(done: int, total: int, row: ClipAnnotation | None) -> None:
        if row is not None:
            assert row.error is None
            files.append(row.file)
        if done == total // 2:
            cluster.workers[0].send_signal(signal.SIGKILL)

    executors = partial(dask_executor, cluster.address)
    summary = annotate_archive(archive, tmp_path / "out", executors=executors, told=told)
    assert cluster.workers[0].wait(10) == -signal.SIGKILL
    assert (summary.files, summary.failed) == (126, 0)
    assert Counter(files) == Counter(
        path.relative_to(archive).as_posix() for path in archive.rglob("*.[bn]*") if path.is_file()
    )
    annotate_archive(archive, tmp_path / "here", executors=partial(local_pool, 1))
    table = "annotations.parquet"
    assert (tmp_path / "out" / table).read_bytes() == (tmp_path / "here" / table).read_bytes()
