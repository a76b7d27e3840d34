"""Strict sequences as text: all short ones, and any of the longer ones."""

from __future__ import annotations

from functools import cache
from itertools import pairwise, product

from hypothesis import strategies as st


def is_strict(symbols: tuple[str, ...], *, cyclic: bool) -> bool:
    """Whether neighbors differ, those across the wrap of a cycle included."""
    differ = all(one != other for one, other in pairwise(symbols))
    return differ and not (cyclic and symbols[0] == symbols[-1])


@cache
def every_strict_text(longest: int) -> tuple[str, ...]:
    """Return every strict sequence of up to `longest` phases, clamped and cyclic."""
    return tuple(
        " ".join(symbols) + "*" * cyclic
        for length in range(1, longest + 1)
        for cyclic in (False, True)
        for symbols in product("RLD-", repeat=length)
        if is_strict(symbols, cyclic=cyclic)
    )


@st.composite
def strict_texts(draw: st.DrawFn, *, longest: int, cyclic: bool | None = None) -> str:
    """Draw a strict sequence of up to `longest` phases."""
    starred = draw(st.booleans()) if cyclic is None else cyclic
    symbols = [draw(st.sampled_from("RLD-"))]
    for _ in range(draw(st.integers(1 if starred else 0, longest - 1))):
        symbols.append(draw(st.sampled_from([s for s in "RLD-" if s != symbols[-1]])))
    if starred and symbols[0] == symbols[-1]:
        if len(symbols) == 2:
            symbols[1] = "D" if symbols[0] != "D" else "R"
        else:
            symbols.pop()
    if starred and len(symbols) == 1:
        symbols.append("-" if symbols[0] != "-" else "R")
    return " ".join(symbols) + "*" * starred
