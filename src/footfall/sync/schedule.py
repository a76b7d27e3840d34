"""Schedule: a printable copy of which phases are played together (figures 7 to 9).

One row an action, one column a slot:

    slot        k    k+1  k+2  k+3  k+4  k+5
    walk   2    R    D    L    D    R    D
    shot   1    .    .    L    D    D~   L    ~ held: its next phase, L, conflicts with R
    blend       R    D    L    D    R    L
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from footfall.arrays import Counts, Indices, Supports
from footfall.support import Support
from footfall.sync.columns import has_ended, own_phase, support_of
from footfall.sync.schedule_html import schedule_html
from footfall.sync.schedule_text import schedule_text
from footfall.sync.shares import slot_seconds, stretch_of
from footfall.sync.tables import Rules, SequenceTable
from footfall.sync.window import Window

__all__ = ["Schedule", "ScheduleRow"]

CELL = 5
"""Characters a slot takes in print."""


@dataclass(frozen=True, slots=True)
class ScheduleRow:
    """One action in a schedule; every tuple has one entry a slot."""

    name: str
    """What the action is called."""

    priority: float
    """Its priority on the legs."""

    phases: tuple[int | None, ...]
    """Index into its own list of phases; None while it does not play."""

    supports: tuple[Support | None, ...]
    """What it stands on; None while it does not play."""

    held: tuple[bool, ...]
    """Whether it repeats the phase of the slot before: its next one would conflict, or is early."""

    following: tuple[Support | None, ...]
    """Where held: the support that it may not go on to yet; else None."""

    muted: tuple[bool, ...]
    """Whether it plays beside the schedule, for want of room (S-19)."""

    stretches: tuple[float | None, ...]
    """How many times as long as at its own speed its phase lasts, as far as the schedule goes:
    by so much it is held. None while it does not play, is muted or has ended."""

    waits: tuple[str, ...]
    """Why its start waits; empty unless it does."""

    @property
    def cells(self) -> tuple[str, ...]:
        """The row as symbols: a dot while it does not play, ``~`` behind a held phase."""
        return tuple(
            "." if support is None else support.symbol + ("~" if held else "")
            for support, held in zip(self.supports, self.held, strict=True)
        )

    @property
    def remark(self) -> str:
        """Why its first held phase is held; empty if none is."""
        for support in self.following:
            if support is not None and support not in (Support.LEFT, Support.RIGHT):
                return f"~ held: its next phase, {support.symbol}, comes with the others"
            if support is not None:
                other = Support.RIGHT if support is Support.LEFT else Support.LEFT
                conflict = f"its next phase, {support.symbol}, conflicts with {other.symbol}"
                return f"~ held: {conflict}"
        return ""


@dataclass(frozen=True, slots=True)
class Schedule:
    """Some consecutive slots of one character's schedule."""

    rows: tuple[ScheduleRow, ...]
    """One row an action."""

    results: tuple[Support, ...]
    """What the blend stands on in each slot; CONFLICT where the rule failed."""

    durations: tuple[float | None, ...]
    """How long each slot lasts [s]; of one that is being played, what is left of it. None where
    nobody is left who could say."""

    first_slot: int | None = None
    """The number of the first slot, or None to count from the current one, k."""

    @classmethod
    def of(
        cls,
        table: SequenceTable,
        rules: Rules,
        sequences: Sequence[int],
        names: Sequence[str],
        priorities: Sequence[float],
        phases: Indices | Counts,
        results: Supports,
        *,
        seconds: Sequence[float | None],
        muted: Sequence[Sequence[bool]],
        waits: Sequence[Sequence[str]] = (),
        first_slot: int | None = None,
    ) -> Schedule:
        """Copy a schedule out of arrays.

        Args:
            table: All sequences.
            rules: The rules of the planner.
            sequences: Row of the table of each action.
            names: What each action is called.
            priorities: Priority of each action on the legs.
            phases: Absolute phase indices, shape (actions, slots); `ABSENT` while one does not
                play.
            results: Combined support of each slot, shape (slots,).
            seconds: How long each slot lasts, or None.
            muted: Whether each action is muted, one row an action.
            waits: Why the start of each action waits, one row an action; nobody does if empty.
            first_slot: The number of the first slot, or None to count from the current one.

        Returns:
            The copy.
        """
        nobody = [("",) * len(results)] * len(names)
        rows = tuple(
            replace(
                _row(table, rules, sequence, [int(phase) for phase in row], seconds, quiet),
                name=name,
                priority=priority,
                waits=tuple(why),
            )
            for sequence, name, priority, row, quiet, why in zip(
                sequences, names, priorities, phases, muted, waits or nobody, strict=True
            )
        )
        together = tuple(Support(int(result)) for result in results)
        return cls(rows, together, tuple(seconds), first_slot)

    @classmethod
    def of_window(
        cls, table: SequenceTable, window: Window, rules: Rules, names: Sequence[str]
    ) -> Schedule:
        """Copy the decided columns of a window; `names` has one name a seat.

        Empty seats are left out.
        """
        seats = [int(seat) for seat in window.playing.nonzero()[0]]
        decided = window.lookahead + 1
        return cls.of(
            table,
            rules,
            [int(window.sequence[seat]) for seat in seats],
            [names[seat] for seat in seats],
            [float(window.priority[seat]) for seat in seats],
            window.phases[seats, :decided],
            window.results[:decided],
            seconds=[slot_seconds(table, window, rules, column) for column in range(decided)],
            muted=[[bool(window.muted[seat])] * decided for seat in seats],
        )

    def __str__(self) -> str:
        """Return the table, one line an action between the slots and the blend."""
        wide = max(len(name) for name in ("slot", "blend", *(row.name for row in self.rows)))
        ranks = [f"{row.priority:g}" for row in self.rows]
        rank_wide = max([1, *(len(rank) for rank in ranks)])
        lines = [
            (row.name, rank, row.cells, row.remark)
            for row, rank in zip(self.rows, ranks, strict=True)
        ]
        lines.insert(0, ("slot", "", self._slot_labels(), ""))
        lines.append(("blend", "", tuple(result.symbol for result in self.results), ""))
        return "\n".join(
            f"{name:{wide}}  {rank:{rank_wide}}    "
            f"{''.join(f'{cell:{CELL}}' for cell in cells)}{remark}".rstrip()
            for name, rank, cells, remark in lines
        )

    def describe(self) -> str:
        """Return everything that was decided, as text: see `footfall.sync.schedule_text`."""
        return schedule_text(self, self._slot_labels())

    def _repr_html_(self) -> str:
        """Return the table in colors, for notebooks."""
        return schedule_html(self, self._slot_labels())

    def _slot_labels(self) -> tuple[str, ...]:
        if self.first_slot is None:
            return tuple(f"k+{slot}" if slot else "k" for slot in range(len(self.results)))
        return tuple(str(self.first_slot + slot) for slot in range(len(self.results)))


def _row(
    table: SequenceTable,
    rules: Rules,
    sequence: int,
    phases: list[int],
    seconds: Sequence[float | None],
    muted: Sequence[bool],
) -> ScheduleRow:
    """Return the row of an action that has no name yet."""
    own = [own_phase(table, sequence, phase, rules.ended) for phase in phases]
    held = tuple(
        slot > 0 and phase == phases[slot - 1] and not has_ended(table, sequence, phase)
        for slot, phase in enumerate(phases)
    )

    def support(phase: int) -> Support:
        return Support(support_of(table, sequence, phase, rules.ended))

    return ScheduleRow(
        name="",
        priority=0.0,
        phases=tuple(None if index < 0 else index for index in own),
        supports=tuple(
            None if index < 0 else support(phase) for index, phase in zip(own, phases, strict=True)
        ),
        held=held,
        following=tuple(
            support(phase + 1) if held_here else None
            for phase, held_here in zip(phases, held, strict=True)
        ),
        muted=tuple(muted),
        stretches=tuple(
            None if quiet else stretch_of(table, sequence, phases, seconds, slot)
            for slot, quiet in enumerate(muted)
        ),
        waits=(),
    )
