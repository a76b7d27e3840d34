"""Formats of a fixed body: which joint of a skeleton is which of theirs."""

from __future__ import annotations

from footfall.arrays import Indices
from footfall.skeleton import Skeleton

__all__ = ["named_like"]


def named_like(skeleton: Skeleton, names: tuple[str, ...], parents: Indices) -> list[int] | None:
    """Return the joint of a skeleton for each joint of a body, in the body's order.

    Args:
        skeleton: Joints in any order.
        names: The joints of the body.
        parents: Their parents by index, -1 for the root, shape (joints,).

    Returns:
        None where names or parents differ.
    """
    if set(names) != set(skeleton.names) or len(names) != skeleton.count:
        return None
    order = [skeleton.index(name) for name in names]
    wanted: list[int] = [-1 if parent < 0 else order[parent] for parent in parents.tolist()]
    return order if skeleton.parents[order].tolist() == wanted else None
