"""Skeletons written as indented text, for tests."""

from __future__ import annotations

import numpy as np

from footfall.skeleton import Skeleton


def body(text: str) -> Skeleton:
    """Return a skeleton: a joint a line, indented below its parent, then its offset [m].

    A line may end in ``tip`` and the end of the joint's own bone.
    """
    names: list[str] = []
    parents: list[int] = []
    offsets: list[list[float]] = []
    tips: list[list[float]] = []
    path: list[tuple[int, int]] = []
    for line in filter(str.strip, text.splitlines()):
        indent = len(line) - len(line.lstrip())
        path = [entry for entry in path if entry[0] < indent]
        parents.append(path[-1][1] if path else -1)
        path.append((indent, len(names)))
        words, _, tip = line.partition(" tip ")
        name, *numbers = words.split()
        names.append(name)
        offsets.append([float(number) for number in numbers] or [0.0, 0.0, 0.0])
        tips.append([float(number) for number in tip.split()] or [0.0, 0.0, 0.0])
    return Skeleton(tuple(names), np.array(parents), np.array(offsets), np.array(tips))
