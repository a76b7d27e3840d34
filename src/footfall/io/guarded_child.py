"""A process that reads one file after another, and may crash or hang over any of them."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

__all__ = ["ChildEndedError", "GuardedChild", "Question"]

SERVER = Path(__file__).with_name("guarded_server.py")

MOST_FILES, MOST_MEMORY = 200, 16_000_000_000
"""How many files, and allowing how much memory [bytes], a child reads before it is worn: libraries
do not give all memory back."""

START_SECONDS = 20.0
"""When a child that is not ready is ended: Python and a library start in 0.2 s, on a busy machine
in several [s]."""


class ChildEndedError(Exception):
    """The child ended, or was ended, with a file in hand."""

    def __init__(self, told: str, crashed: bool) -> None:
        super().__init__(told)
        self.told = told
        self.crashed = crashed


@dataclass(frozen=True, slots=True)
class Question:
    """What a child is asked: see `footfall.io.guarded_server`."""

    words: tuple[str, ...]
    """What the child is told."""

    data: bytes
    """What it is given."""

    memory: int
    """How much it may allocate [bytes]."""

    seconds: float
    """When it is ended, from when it was ready [s]."""

    def to_bytes(self) -> bytes:
        """Return what is sent."""
        facts = {"words": self.words, "size": len(self.data), "allowed": self.memory}
        return json.dumps(facts).encode() + b"\n" + self.data


class GuardedChild:
    """A process that reads one file after another by one script.

    A new interpreter is started, rather than a `multiprocessing` child, so that programs need no
    ``if __name__ == "__main__"`` to read a file.
    """

    def __init__(self, script: Path) -> None:
        self.files = self.memory = 0
        self._ready = False
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115
        # -P: the script's own folder must not hide a library by a module of the same name.
        self._process = subprocess.Popen(
            [sys.executable, "-P", str(SERVER), str(script)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
        )

    @property
    def worn(self) -> bool:
        """Whether it has read enough."""
        return self.files >= MOST_FILES or self.memory >= MOST_MEMORY

    def ask(self, question: Question) -> bytes:
        """Return its answer about a file.

        Raises:
            ChildEndedError: If it crashes, fails, or does not answer in time.
        """
        self.files += 1
        self.memory += question.memory
        if not self._ready:
            late = (
                f"cannot be read: its parser did not start within {START_SECONDS:.0f} s; try "
                "again when the machine is less busy"
            )
            self._within(START_SECONDS, self._started, late)
            self._ready = True
        return self._within(
            question.seconds,
            lambda: self._answer(question),
            f"was still being read after {question.seconds:.0f} s, and was given up; it is "
            "damaged, or far too large",
        )

    def _within(self, seconds: float, step: Callable[[], bytes | None], late: str) -> bytes:
        """Return what a step returns; end the child where it takes longer.

        Raises:
            ChildEndedError: If the child ended; `late` is told where it was ended.
        """
        overdue = threading.Event()
        clock = threading.Timer(seconds, self._end, (overdue,))
        clock.start()
        try:
            answer = step()
        finally:
            clock.cancel()
        if answer is not None:
            return answer
        code = self._process.wait()
        if overdue.is_set():
            raise ChildEndedError(late, crashed=False)
        self._errors.seek(0)
        last = self._errors.read().decode(errors="replace").strip().splitlines()[-1:]
        told = f": {last[0][:160]}" if last else ""
        raise ChildEndedError(
            f"made its parser fail (exit code {code}){told}; the file is damaged, or holds what "
            "the parser does not know",
            crashed=True,
        )

    def _end(self, overdue: threading.Event) -> None:
        overdue.set()
        self._process.kill()

    def _started(self) -> bytes | None:
        """Wait until it can be asked; return None where it ended before."""
        assert self._process.stdout is not None
        return self._process.stdout.read(1) or None

    def _answer(self, question: Question) -> bytes | None:
        """Send a question; return the answer, None where the child ended before it was whole."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        try:
            self._process.stdin.write(question.to_bytes())
            self._process.stdin.flush()
        except OSError:
            return None
        head = self._process.stdout.read(8)
        size = int.from_bytes(head, "little")
        answer = self._process.stdout.read(size) if len(head) == 8 else b""
        return answer if len(head) == 8 and len(answer) == size else None

    def close(self) -> None:
        """End it."""
        self._process.kill()
        self._process.wait()
        for stream in (self._process.stdin, self._process.stdout, self._errors):
            assert stream is not None
            try:
                stream.close()
            except OSError:
                # What was not sent to a child that crashed.
                continue
