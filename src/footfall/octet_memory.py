"""Where octets come from and go to: single precision arrays, eight numbers side by side.

A place is the index of the first of the eight in the array as it lies in memory, whatever its
shape; arrays are contiguous.
"""

# pyright: reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportUnknownVariableType=false, reportUnknownParameterType=false
# pyright: reportMissingParameterType=false, reportMissingTypeStubs=false
# pyright: reportUnusedFunction=false, reportUntypedFunctionDecorator=false
# ruff: noqa: ARG001
from __future__ import annotations

from collections.abc import Callable
from typing import Any, cast

import numpy.typing as npt
from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typing.templates import signature
from numba.extending import intrinsic

from footfall.arrays import SmallFloats
from footfall.octets import LANES, NUMBERS, octet, widen

__all__ = ["fetch_ahead", "load", "spread", "store", "transpose"]

NUMBER = 4
"""Bytes of one number."""

LINE = 64
"""Bytes that a processor fetches at a time."""


def _place(context: Any, builder: Any, kind: Any, array: Any, index: Any) -> Any:
    data = cgutils.create_struct_proxy(kind)(context, builder, value=array).data
    return builder.bitcast(builder.gep(data, [index]), NUMBERS.as_pointer())


@intrinsic
def _load(_: Any, array: Any, place: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        return builder.load(_place(context, builder, sig.args[0], *values), align=NUMBER)

    return signature(octet, array, types.intp), generate


@intrinsic
def _store(_: Any, array: Any, place: Any, value: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        pointer = _place(context, builder, sig.args[0], values[0], values[1])
        builder.store(widen(builder, values[2], sig.args[2]), pointer, align=NUMBER)
        return context.get_dummy_value()

    return signature(types.void, array, types.intp, value), generate


@intrinsic
def _spread(_: Any, value: Any) -> Any:
    def generate(_: Any, builder: Any, sig: Any, values: Any) -> Any:
        return widen(builder, values[0], sig.args[0])

    return signature(octet, value), generate


def _mix(builder: Any, one: Any, other: Any, places: list[int]) -> Any:
    kind = ir.VectorType(ir.IntType(32), LANES)
    return builder.shuffle_vector(one, other, ir.Constant(kind, places))


def _exchange(builder: Any, rows: list[Any]) -> list[Any]:
    """Return the columns of eight octets."""
    low, high = [0, 8, 1, 9, 4, 12, 5, 13], [2, 10, 3, 11, 6, 14, 7, 15]
    pairs: list[Any] = []
    for k in range(0, LANES, 2):
        pairs += [_mix(builder, rows[k], rows[k + 1], way) for way in (low, high)]
    low, high = [0, 1, 8, 9, 4, 5, 12, 13], [2, 3, 10, 11, 6, 7, 14, 15]
    fours: list[Any] = []
    for k in (0, 1, 4, 5):
        fours += [_mix(builder, pairs[k], pairs[k + 2], way) for way in (low, high)]
    low, high = [0, 1, 2, 3, 8, 9, 10, 11], [4, 5, 6, 7, 12, 13, 14, 15]
    return [
        _mix(builder, fours[k], fours[k + 4], way) for way in (low, high) for k in range(LANES // 2)
    ]


@intrinsic
def _transpose(_: Any, array: Any, place: Any, stride: Any, out: Any, out_place: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        source, place, stride, target, out_place = values
        rows: list[Any] = []
        for k in range(LANES):
            index = builder.add(place, builder.mul(stride, ir.Constant(stride.type, k)))
            pointer = _place(context, builder, sig.args[0], source, index)
            rows.append(builder.load(pointer, align=NUMBER))
        for k, column in enumerate(_exchange(builder, rows)):
            index = builder.add(out_place, ir.Constant(out_place.type, LANES * k))
            pointer = _place(context, builder, sig.args[3], target, index)
            builder.store(column, pointer, align=NUMBER)
        return context.get_dummy_value()

    args = (array, types.intp, types.intp, out, types.intp)
    return signature(types.void, *args), generate


@intrinsic
def _fetch_ahead(_: Any, records: Any, index: Any, size: Any) -> Any:
    def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        records, index, size = values
        data = cgutils.create_struct_proxy(sig.args[0])(context, builder, value=records).data
        one = builder.bitcast(builder.gep(data, [index]), ir.IntType(8).as_pointer())
        number = ir.IntType(32)
        kind = ir.FunctionType(ir.VoidType(), [one.type, number, number, number])
        fetch = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        lines = builder.udiv(size, ir.Constant(size.type, LINE))
        with cgutils.for_range(builder, lines) as loop:
            place = builder.gep(one, [builder.mul(loop.index, ir.Constant(size.type, LINE))])
            builder.call(fetch, [place, *(ir.Constant(number, each) for each in (1, 3, 1))])
        return context.get_dummy_value()

    return signature(types.void, records, types.intp, types.intp), generate


fetch_ahead = cast(Callable[[npt.NDArray[Any], int, int], None], _fetch_ahead)
"""Bid the processor have the first bytes, so many, of a record of an array at hand soon."""

load = cast(Callable[[SmallFloats, int], float], _load)
"""Return the octet at a place of an array."""

store = cast(Callable[[SmallFloats, int, float], None], _store)
"""Write an octet, or one number eight times, at a place of an array."""

spread = cast(Callable[[float], float], _spread)
"""Return one number as an octet of equal ones."""

transpose = cast(Callable[[SmallFloats, int, int, SmallFloats, int], None], _transpose)
"""Write the columns of eight octets, which lie `stride` apart in an array, one after the other
at a place of another."""
