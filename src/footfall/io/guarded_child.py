"""A process that reads one file after another, and may crash or hang over any of them."""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import threading
from dataclasses import dataclass
from pathlib import Path

__all__ = ["ChildEndedError", "GuardedChild", "Question"]

SERVER = Path(__file__).with_name("guarded_server.py")

MOST_FILES, MOST_MEMORY = 200, 16_000_000_000
"""How many files, and allowing how much memory [bytes], a child reads before it is worn: libraries
do not give all memory back."""


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
    """When it is ended [s]."""

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
        overdue = threading.Event()
        clock = threading.Timer(question.seconds, self._end, (overdue,))
        clock.start()
        try:
            answer = self._answer(question)
        finally:
            clock.cancel()
        if answer is not None:
            return answer
        code = self._process.wait()
        if overdue.is_set():
            raise ChildEndedError(
                f"was still being read after {question.seconds:.0f} s, and was given up; it is "
                "damaged, or far too large",
                crashed=False,
            )
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
