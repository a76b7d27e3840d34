"""The HIERARCHY half of a BVH file: joints, offsets and channels, read strictly."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import NoReturn

from footfall.errors import FileFormatError

__all__ = ["BvhJoint", "HierarchyReader", "finite_number"]

GREATEST = 1e12
"""Numbers beyond it are refused: no motion has them, and their squares lose everything."""


CHANNELS = tuple(f"{axis}{kind}" for kind in ("position", "rotation") for axis in "XYZ")
_BY_LOWER_CASE = {name.lower(): name for name in CHANNELS}
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?")
_KEYWORDS = "ROOT, JOINT, OFFSET, CHANNELS, End Site, { or }"


@dataclass(slots=True)
class BvhJoint:
    """A joint as the file declares it, in the file's own unit and axes."""

    name: str
    """As written; blanks inside are kept."""

    parent: int
    """Index of the joint it stands in; -1 for the root."""

    line: int
    """Where it was declared."""

    offset: tuple[float, float, float] | None = None
    """Its OFFSET."""

    channels: tuple[str, ...] | None = None
    """Its channels in the order of the file, such as ``"Zrotation"``; None before they are read."""

    tip: tuple[float, float, float] | None = None
    """The OFFSET of its End Site, if it has one."""


def finite_number(word: str) -> float | None:
    """Return the number that a word is, or None where it is none, not finite or absurd."""
    if _NUMBER.fullmatch(word) is None:
        return None
    value = float(word)
    return value if abs(value) < GREATEST else None


@dataclass(slots=True)
class HierarchyReader:
    """Reads line by line; knows which joint is open and what it still lacks."""

    path: Path
    joints: list[BvhJoint] = field(default_factory=list[BvhJoint])
    _open: list[int] = field(default_factory=list[int])
    _awaits_brace: bool = False
    _in_end_site: bool = False
    _line: int = 0

    def read(self, lines: list[str]) -> int:
        """Read from the first line to the end of the last joint.

        Args:
            lines: The lines of the file.

        Returns:
            The index of the first line after the line that closes the root.

        Raises:
            FileFormatError: If anything is not as BVH wants it.
        """
        started = False
        for index, line in enumerate(lines):
            self._line = index + 1
            words = line.replace("{", " { ").replace("}", " } ").split()
            if not words:
                continue
            if not started:
                if words != ["HIERARCHY"]:
                    self._fail(f"a BVH file begins with HIERARCHY, not with {_quoted(words)}")
                started = True
                continue
            self._read_words(words)
            if self.joints and not self._open and not self._awaits_brace:
                return index + 1
        if not started:
            raise FileFormatError("is empty; a BVH file begins with HIERARCHY", path=self.path)
        raise FileFormatError(
            f"the file ends inside the hierarchy, with {len(self._open)} braces still open; "
            "it was cut short",
            path=self.path,
            line=self._line,
        )

    def _fail(self, problem: str) -> NoReturn:
        raise FileFormatError(problem, path=self.path, line=max(self._line, 1))

    def _read_words(self, words: list[str]) -> None:
        """Read one line; a brace may stand on it, before or after anything else."""
        while words:
            if words[0] == "{":
                self._open_brace()
                words = words[1:]
            elif words[0] == "}":
                self._close_brace()
                words = words[1:]
            else:
                braces = [i for i, word in enumerate(words) if word in "{}"]
                end = braces[0] if braces else len(words)
                self._read_statement(words[0], words[1:end])
                words = words[end:]

    def _read_statement(self, keyword: str, rest: list[str]) -> None:
        if self._awaits_brace:
            self._fail(f"a {{ is missing before {keyword}")
        match keyword.upper():
            case "ROOT" | "JOINT":
                self._begin_joint(keyword.upper(), " ".join(rest))
            case "END":
                self._begin_end_site()
            case "OFFSET":
                self._read_offset(rest)
            case "CHANNELS":
                self._read_channels(rest)
            case "MOTION" if self._open:
                self._fail(
                    f"MOTION comes while {len(self._open)} braces are still open; "
                    "each { needs its }"
                )
            case _:
                self._fail(f"{keyword!r} is no keyword of a hierarchy; {_KEYWORDS} is expected")

    def _begin_joint(self, keyword: str, name: str) -> None:
        if keyword == "ROOT" and self.joints:
            self._fail("a second ROOT; a file holds one body, and its other joints are JOINT")
        if keyword == "JOINT" and not self.joints:
            self._fail("a JOINT before the ROOT; the first joint is declared with ROOT")
        if self._in_end_site:
            self._fail(f"{keyword} inside an End Site; only OFFSET may stand there")
        if not name:
            self._fail(f"{keyword} has no name; write {keyword} and a name")
        for joint in self.joints:
            if joint.name == name:
                self._fail(
                    f"a second joint is named {name!r}, as on line {joint.line}; names must differ"
                )
        parent = self._open[-1] if self._open else -1
        self.joints.append(BvhJoint(name, parent, self._line))
        self._awaits_brace = True

    def _begin_end_site(self) -> None:
        if not self._open:
            self._fail("an End Site outside any joint; it belongs inside the last joint of a limb")
        if self._in_end_site:
            self._fail("an End Site inside an End Site; only OFFSET may stand there")
        if self.joints[self._open[-1]].tip is not None:
            self._fail(
                f"joint {self.joints[self._open[-1]].name!r} has a second End Site; "
                "a joint has one at most"
            )
        self._in_end_site = True
        self._awaits_brace = True

    def _open_brace(self) -> None:
        if not self._awaits_brace:
            self._fail("a { that follows no ROOT, JOINT or End Site")
        self._awaits_brace = False
        if not self._in_end_site:
            self._open.append(len(self.joints) - 1)

    def _close_brace(self) -> None:
        if self._awaits_brace:
            self._fail("a } where a { is missing")
        if not self._open:
            self._fail("a } that closes nothing; one ROOT opens the hierarchy")
        joint = self.joints[self._open[-1]]
        if self._in_end_site:
            if joint.tip is None:
                self._fail(f"the End Site of {joint.name!r} has no OFFSET; it needs three numbers")
            self._in_end_site = False
            return
        if joint.offset is None:
            self._fail(f"joint {joint.name!r} has no OFFSET; it needs three numbers")
        joint.channels = joint.channels or ()
        self._open.pop()

    def _read_offset(self, rest: list[str]) -> None:
        if not self._open:
            self._fail("OFFSET outside any joint")
        values = [finite_number(word) for word in rest]
        if len(values) != 3:
            self._fail(f"OFFSET has {len(values)} values; it needs three numbers")
        for word, value in zip(rest, values, strict=True):
            if value is None:
                self._fail(f"{word!r} in OFFSET is no finite number below 1e12")
        x, y, z = (0.0 if value is None else value for value in values)
        joint = self.joints[self._open[-1]]
        if (joint.tip if self._in_end_site else joint.offset) is not None:
            self._fail(f"a second OFFSET for joint {joint.name!r}; one is needed")
        if self._in_end_site:
            joint.tip = (x, y, z)
        else:
            joint.offset = (x, y, z)

    def _read_channels(self, rest: list[str]) -> None:
        if not self._open or self._in_end_site:
            self._fail("CHANNELS outside any joint")
        joint = self.joints[self._open[-1]]
        if joint.channels is not None:
            self._fail(f"a second CHANNELS for joint {joint.name!r}; one is needed")
        if not rest or not rest[0].isascii() or not rest[0].isdigit():
            self._fail("CHANNELS needs a count and then that many names")
        names = rest[1:]
        if int(rest[0][:9]) != len(names):
            self._fail(f"CHANNELS declares {rest[0]} channels but names {len(names)}")
        for name in names:
            if name.lower() not in _BY_LOWER_CASE:
                self._fail(f"{name!r} is no channel; there are {', '.join(CHANNELS)}")
        channels = tuple(_BY_LOWER_CASE[name.lower()] for name in names)
        if len(set(channels)) != len(channels):
            self._fail(f"joint {joint.name!r} names a channel twice; each may come once")
        joint.channels = channels


def _quoted(words: list[str]) -> str:
    text = " ".join(words)
    return repr(text if len(text) <= 40 else text[:37] + "...")
