"""Serves questions about files in a process of its own: one of the children reads, this answers.

Run as a script by `footfall.io.guarded_process`, with the script of a child as its only word. It
imports nothing of the project, which would take longer than most files. A child is a module with

- ``load_library()``: imports what it needs, before the memory is limited;
- ``UnreadableError``: what it raises where a file cannot be read;
- ``read_file(words, data, allowed)``: returns facts by name, and arrays by name.

Once the library is loaded it says so by one byte: from then on the time of reading runs. A
question is a line of JSON (``words``, ``size`` of the data and the memory ``allowed``, in bytes)
and the data; an answer is its size as eight bytes, the lowest first, and an ``.npz`` of the arrays
and of ``header``, the facts as JSON. Where the file cannot be read, its only fact is ``error``.
"""

from __future__ import annotations

import importlib
import importlib.util
import io
import json
import os
import sys
from pathlib import Path
from typing import Any

import numpy as np

__all__ = ["main"]

READY = b"\x06"
"""What is said once questions can be answered: ASCII's acknowledgement."""


def main() -> None:
    """Answer until the questions end."""
    spec = importlib.util.spec_from_file_location("guarded_child", sys.argv[1])
    assert spec is not None
    assert spec.loader is not None
    child: Any = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(child)
    child.load_library()
    # What a library prints must not come between the answers.
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    answers.write(READY)
    answers.flush()
    while line := sys.stdin.buffer.readline():
        question = json.loads(line)
        packed = _answer(child, question, sys.stdin.buffer.read(question["size"]))
        answers.write(len(packed).to_bytes(8, "little") + packed)
        answers.flush()
    # Without the interpreter's farewell, in which a library may yet crash.
    os._exit(0)


def _answer(child: Any, question: dict[str, Any], data: bytes) -> bytes:
    allowed = int(question["allowed"])
    _limit_memory(allowed)
    arrays: dict[str, Any] = {}
    try:
        facts, arrays = child.read_file(question["words"], data, allowed)
    except child.UnreadableError as error:
        facts = {"error": str(error)}
    packed = io.BytesIO()
    np.savez(packed, header=np.frombuffer(json.dumps(facts).encode(), dtype=np.uint8), **arrays)
    return packed.getvalue()


def _limit_memory(allowed: int) -> None:
    """Let this process grow by so many bytes and no further, where the system can see to it."""
    pages = Path("/proc/self/statm")
    if pages.exists():
        resource: Any = importlib.import_module("resource")
        limit = int(pages.read_text().split()[5]) * resource.getpagesize() + allowed
        hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
        resource.setrlimit(resource.RLIMIT_DATA, (limit, hard))


if __name__ == "__main__":
    main()
