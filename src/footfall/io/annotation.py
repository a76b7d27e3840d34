"""Supports as text: one phase a line from the first frame on, made to be edited by hand.

::

    # support phases from the first frame on: symbol and seconds
    cyclic
    R 0.383
    D 0.117
    L 0.383
    D 0.117

``cyclic`` or ``once`` stands alone on a line; where neither does, it is ``once``. In a cyclic file
the first and the last line may carry the same symbol: the loop was cut inside that phase.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

from footfall.errors import FileFormatError, SupportSequenceError
from footfall.io.atomic import write_atomically
from footfall.io.bvh_hierarchy import finite_number
from footfall.io.raw_file import decoded, read_bytes
from footfall.support import Support, SupportPhase, SupportSequence

__all__ = ["parse_supports", "read_annotation", "supports_text", "write_annotation"]

HEADER = "# support phases from the first frame on: symbol and seconds"

DECIMALS = 6
"""Boundaries are written to the microsecond."""


def parse_supports(text: str, path: Path | str) -> SupportSequence:
    """Read the text form of a support sequence.

    Args:
        text: The content of a ``.supports`` file.
        path: Its name, for messages.

    Returns:
        The sequence. Where the loop was cut inside a phase, that phase is the first one and
        begins before the first frame.

    Raises:
        FileFormatError: If a line is none of the forms, two neighbors carry the same symbol, or
            there is no phase.
    """
    path = Path(path)
    cyclic: bool | None = None
    phases: list[SupportPhase] = []
    lines: list[int] = []
    for number, line in enumerate(text.splitlines(), start=1):
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        if words in (["cyclic"], ["once"]):
            if cyclic is not None:
                raise FileFormatError(
                    "cyclic or once is said a second time; say it once", path=path, line=number
                )
            cyclic = words == ["cyclic"]
            continue
        phases.append(_phase(words, path, number))
        lines.append(number)
    if not phases:
        raise FileFormatError("holds no phase; write one a line, such as R 0.383", path=path)
    for (one, other), number in zip(pairwise(phases), lines[1:], strict=True):
        if one.support is other.support and not (cyclic and len(phases) == 2):
            raise FileFormatError(
                f"{other.support.symbol} follows {other.support.symbol}; merge the two lines "
                "into one",
                path=path,
                line=number,
            )
    return _sequence(phases, bool(cyclic), path)


def _phase(words: list[str], path: Path, line: int) -> SupportPhase:
    seconds = finite_number(words[1]) if len(words) == 2 else None
    if len(words) != 2 or words[0] not in ("R", "L", "D", "-") or seconds is None:
        raise FileFormatError(
            f"{' '.join(words)[:40]!r} is no support phase; write R, L, D or - and its seconds, "
            "such as R 0.383, or cyclic, or once",
            path=path,
            line=line,
        )
    if not seconds > 0.0:
        raise FileFormatError(
            f"phase {words[0]} lasts {words[1]} s; it must last longer than zero",
            path=path,
            line=line,
        )
    return SupportPhase(Support.from_symbol(words[0]), seconds)


def _sequence(phases: list[SupportPhase], cyclic: bool, path: Path) -> SupportSequence:
    start = 0.0
    if cyclic and len(phases) > 1 and phases[0].support is phases[-1].support:
        last = phases.pop()
        phases[0] = SupportPhase(last.support, last.duration + phases[0].duration)
        start = -last.duration
    try:
        return SupportSequence(tuple(phases), cyclic, start)
    except SupportSequenceError as error:
        raise FileFormatError(str(error), path=path) from error


def supports_text(sequence: SupportSequence) -> str:
    """Return the text form, which `parse_supports` reads back.

    Boundaries, not durations, are rounded, so that a long sequence does not drift.
    """
    bounds = [round(bound, DECIMALS) for bound in sequence.boundaries]
    symbols = [phase.support.symbol for phase in sequence.phases]
    if bounds[0] < 0.0:
        bounds = [0.0, *bounds[1:], bounds[-1] - bounds[0]]
        symbols.append(symbols[0])
    lines = [HEADER, "cyclic" if sequence.cyclic else "once"]
    for symbol, (begin, end) in zip(symbols, pairwise(bounds), strict=True):
        lines.append(f"{symbol} {_seconds(end - begin)}")
    return "\n".join(lines) + "\n"


def _seconds(duration: float) -> str:
    # A phase that vanishes in rounding must still last: it keeps one microsecond.
    return f"{max(duration, 10.0**-DECIMALS):.{DECIMALS}f}".rstrip("0").rstrip(".")


def read_annotation(path: Path | str) -> SupportSequence:
    """Read a ``.supports`` file.

    Raises:
        FileFormatError: As `parse_supports`, or if the file cannot be read.
    """
    path = Path(path)
    return parse_supports(decoded(read_bytes(path)), path)


def write_annotation(sequence: SupportSequence, path: Path | str) -> None:
    """Write a ``.supports`` file.

    Raises:
        FileFormatError: If it cannot be written.
    """
    write_atomically(Path(path), supports_text(sequence).encode())
