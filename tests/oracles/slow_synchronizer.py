"""The slow and obvious synchronizer: letters in dictionaries, written from the paper alone.

`mended=True` adds what the default planner adds to the rule, the choice of an entry excepted:
ended actions are neutral, a conflict hidden by a flight counts, and so does a window of flights.
"""

from __future__ import annotations

from copy import deepcopy
from dataclasses import dataclass, field

FIGURE_4 = {
    ("D", "D"): "D",
    ("D", "R"): "R",
    ("D", "L"): "L",
    ("R", "R"): "R",
    ("L", "L"): "L",
    ("L", "R"): "Err",
}


def blend(one: str, other: str) -> str:
    """Return one cell of figure 4."""
    if "-" in (one, other):
        return "-"
    if "Err" in (one, other):
        return "Err"
    first, second = sorted((one, other))
    return FIGURE_4[first, second]


def blend_all(symbols: list[str], *, mended: bool = False) -> str:
    """Return the blend of a column (eq. 2)."""
    total = grounded = "D"
    for symbol in symbols:
        total = blend(total, symbol)
        grounded = blend(grounded, symbol) if symbol != "-" else grounded
    return "Err" if mended and grounded == "Err" else total


@dataclass
class SlowSynchronizer:
    """The actions by index; `window` maps a running one to its phases from the slot on."""

    sequences: list[str]
    priorities: list[float]
    lookahead: int
    native: bool = False
    mended: bool = False
    window: dict[int, list[int]] = field(default_factory=dict[int, list[int]])
    activated: list[int] = field(default_factory=list[int])

    def symbol(self, action: int, index: int) -> str:
        """Return S_i(index), extended as in figure 6."""
        letters = self.sequences[action].rstrip("*").split()
        if self.sequences[action].endswith("*"):
            return letters[index % len(letters)]
        if index < len(letters):
            return letters[index]
        return "D" if self.mended else letters[-1]

    def column(self, k: int) -> list[str]:
        """Return what the running actions stand on in a column of the window."""
        return [self.symbol(action, phases[k]) for action, phases in self.window.items()]

    def result(self, k: int = 0) -> str:
        """Return the blend of a column of the window."""
        return blend_all(self.column(k), mended=self.mended)

    def synchronize_next_column(self) -> None:
        """Append one column to the window by the priority rule."""
        for phases in self.window.values():
            phases.append(phases[-1] + 1)
        if self.result(-1) != "Err":
            return
        ranked = sorted(
            self.window, key=lambda action: (-self.priorities[action], self.activated.index(action))
        )
        symbols = {action: self.symbol(action, self.window[action][-1]) for action in ranked}
        constraint = next(symbols[action] for action in ranked if symbols[action] in "RL")
        for action in ranked:
            if symbols[action] in "RL" and symbols[action] != constraint:
                self.window[action][-1] -= 1

    def enter_next_slot(self) -> None:
        """Move on by one slot."""
        for phases in self.window.values():
            phases.pop(0)
        self.synchronize_next_column()

    def start(self, action: int, entry: int = 0) -> bool:
        """Start an action if columns k to k + nk + 1 can be synchronized."""
        before = deepcopy(self.window)
        if self.native:
            self.synchronize_next_column()
            self.window[action] = [entry + k for k in range(self.lookahead + 2)]
            self.activated.append(action)
        else:
            for phases in self.window.values():
                del phases[1:]
            self.window[action] = [entry]
            self.activated.append(action)
            if self.result() != "Err":
                for _ in range(self.lookahead + 1):
                    self.synchronize_next_column()
        results = {self.result(k) for k in range(len(self.window[action]))}
        if "Err" in results or (self.mended and results == {"-"}):
            self.window = before
            self.activated.remove(action)
            return False
        for phases in self.window.values():
            phases.pop()
        return True


def play(
    slow: SlowSynchronizer, starts: list[int], slots: int
) -> tuple[list[str], list[list[int | None]], list[int | None]]:
    """Play a problem as the batch command does: results, absolute phases, slots of starts."""
    results: list[str] = []
    rows: list[list[int | None]] = [[] for _ in starts]
    started: list[int | None] = [None for _ in starts]
    order = sorted(range(len(starts)), key=lambda action: starts[action])
    for slot in range(slots):
        if slot > 0:
            slow.enter_next_slot()
        if slow.result() != "Err":
            for action in order:
                waits = started[action] is None and starts[action] <= slot
                if waits and slow.start(action):
                    started[action] = slot
        results.append(slow.result())
        for action, row in enumerate(rows):
            row.append(slow.window[action][0] if action in slow.window else None)
        if results[-1] == "Err":
            break
    return results, rows, started
