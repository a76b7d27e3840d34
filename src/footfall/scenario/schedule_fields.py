"""The fields of a schedule problem, read strictly: a message names the field and its range."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from dataclasses import fields as dataclass_fields
from functools import lru_cache
from typing import Any, TypeVar, cast

from footfall.errors import ScenarioError, SupportSequenceError
from footfall.support import SupportSequence
from footfall.sync.tables import (
    Ended,
    Planner,
    Rules,
    StartPolicy,
    check_limbs,
    check_registration,
    rules_of,
)

__all__ = ["ScheduleProblem", "parse_timed"]

MOST_LOOKAHEAD = 1_000
MOST_SLOTS = 1_000_000

Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class ScheduleProblem:
    """Some sequences, the slots in which they are commanded to start, and the rules.

    Raises:
        FootfallError: If a field breaks what its sentence below says.
    """

    sequences: tuple[str, ...]
    """Each in the text form of `SupportSequence.parse`; at least one."""

    priorities: tuple[float, ...]
    """Finite numbers >= 0, one a sequence; also the weights of eq. 6."""

    start: tuple[int, ...]
    """The slot of each start command, from 0 on, one a sequence."""

    lookahead: int = 5
    """How many slots after the current one are decided, 1 to 1000."""

    slots: int = 12
    """How many slots are played, 1 to 1 000 000."""

    planner: Planner = "footfall"
    """The default planner, or the paper's rule."""

    start_policy: StartPolicy = "extend"
    """Paper mode: whether phases may be held to make room for a start."""

    ended: Ended | None = None
    """Paper mode: what a clamped action does after its last phase; "repeat" unless given."""

    def __post_init__(self) -> None:
        for name, values in (("priorities", self.priorities), ("start", self.start)):
            if len(values) != len(self.sequences):
                raise ScenarioError(
                    f"{len(values)} values in {name} for {len(self.sequences)} sequences; "
                    "give one for each"
                )
        for i, text in enumerate(self.sequences):
            try:
                parse_timed(text)
            except SupportSequenceError as error:
                raise ScenarioError(f"sequences[{i}], {text!r}: {error}") from error
        rules_of(self.planner, start_policy=self.start_policy, ended=self.ended)
        check_limbs([parse_timed(text)[0] for text in self.sequences], self.planner)

    @classmethod
    def of(cls, fields: Mapping[str, Any]) -> ScheduleProblem:
        """Read a problem from the fields of its JSON object; all but `sequences` may be missing.

        Raises:
            FootfallError: If a field is unknown or not what it must be.
        """
        _check_names(fields, _FIELDS)
        texts = _list_of(fields, "sequences", _sequence_text)
        count = len(texts)
        ended = fields.get("ended")
        return cls(
            sequences=texts,
            priorities=_list_of(fields, "priorities", _non_negative, tuple(range(count, 0, -1))),
            start=_list_of(fields, "start", _slot_number, (0,) * count),
            lookahead=_whole_number(fields, "lookahead", 5, MOST_LOOKAHEAD),
            slots=_whole_number(fields, "slots", 12, MOST_SLOTS),
            planner=cast(Planner, _choice(fields, "planner", ("footfall", "paper"))),
            start_policy=cast(StartPolicy, _choice(fields, "start_policy", ("extend", "native"))),
            ended=None
            if ended is None
            else cast(Ended, _choice(fields, "ended", ("repeat", "stop"))),
        )

    @property
    def order(self) -> list[int]:
        """The actions, oldest command first; of one slot, in the order of their names."""
        return sorted(range(len(self.start)), key=self.start.__getitem__)

    @property
    def rules(self) -> Rules:
        """The planner's rules, as the kernels take them."""
        return rules_of(self.planner, start_policy=self.start_policy, ended=self.ended)


_FIELDS = tuple(field.name for field in dataclass_fields(ScheduleProblem))


@lru_cache(maxsize=4096)
def parse_timed(text: str) -> tuple[SupportSequence, bool]:
    """Return a sequence, and whether each of its phases carries its seconds."""
    sequence = SupportSequence.parse(text)
    check_registration(sequence)
    tokens = text.strip().removesuffix("*").split()
    return sequence, all(token[-1] in "0123456789." for token in tokens)


def _check_names(fields: Mapping[str, Any], known: Collection[str]) -> None:
    """Refuse a field that does not exist.

    Raises:
        ScenarioError: If there is one.
    """
    for name in fields:
        if name not in known:
            raise ScenarioError(f"no field named {name!r}; there are: {', '.join(known)}")


def _list_of(
    fields: Mapping[str, Any],
    name: str,
    read: Callable[[str, Any], Value],
    default: tuple[Value, ...] | None = None,
) -> tuple[Value, ...]:
    """Return a field that is a list with at least one entry, each read by `read`.

    Raises:
        ScenarioError: If it is not, or is missing and there is no default.
    """
    values: Any = fields.get(name)
    if values is None and default is not None:
        return default
    if not isinstance(values, list) or not values:
        raise ScenarioError(f"{name} is {values!r}; it must be a list with at least one entry")
    entries = cast(list[Any], values)
    return tuple(read(f"{name}[{i}]", value) for i, value in enumerate(entries))


def _sequence_text(name: str, value: Any) -> str:
    """Return a text."""
    if not isinstance(value, str):
        raise ScenarioError(f'{name} is {value!r}; it must be a text such as "R D L D*"')
    return value


def _non_negative(name: str, value: Any) -> float:
    """Return a finite number, not below zero."""
    number = isinstance(value, int | float) and not isinstance(value, bool)
    if not number or not math.isfinite(value) or value < 0.0:
        raise ScenarioError(f"{name} is {value!r}; it must be a number, at least 0")
    return float(value)


def _slot_number(name: str, value: Any) -> int:
    """Return the number of a slot."""
    if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value < 2**31:
        raise ScenarioError(f"{name} is {value!r}; it must be a whole number of slots, at least 0")
    return value


def _whole_number(fields: Mapping[str, Any], name: str, default: int, most: int) -> int:
    """Return a field that is a whole number from 1 to `most`."""
    value: Any = fields.get(name, default)
    if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= most:
        raise ScenarioError(f"{name} is {value!r}; it must be a whole number from 1 to {most}")
    return value


def _choice(fields: Mapping[str, Any], name: str, choices: tuple[str, ...]) -> str:
    """Return a field that is one of some words, or the first of them if it is missing."""
    value: Any = fields.get(name, choices[0])
    if value not in choices:
        words = " or ".join(f'"{word}"' for word in choices)
        raise ScenarioError(f"{name} is {value!r}; it must be {words}")
    return cast(str, value)
