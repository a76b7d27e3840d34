"""Eight numbers at once: a value for kernels that work on eight characters, or eight joints.

Inside a kernel an octet is eight single precision numbers in one register (of whatever width
the processor has: LLVM splits it where it must). It takes part in arithmetic and comparisons
beside plain numbers, so that formulas made of arithmetic alone serve both from one source;
`select`, `square_root` and their like are for what else a formula needs. A type checker, which
knows nothing of kernels, is told that an octet is a float.

Every operation is the same for all eight: what a character does never depends on its neighbors.
"""

# pyright: reportUnknownMemberType=false, reportUnknownArgumentType=false
# pyright: reportUnknownVariableType=false, reportUnknownParameterType=false
# pyright: reportMissingParameterType=false, reportMissingTypeStubs=false
# pyright: reportOptionalCall=false, reportUnusedFunction=false, reportUnknownLambdaType=false, reportUntypedFunctionDecorator=false
from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any, cast

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.datamodel import models
from numba.core.typing.templates import ConcreteTemplate, infer_global, signature
from numba.extending import intrinsic, lower_builtin, register_model

__all__ = [
    "LANES",
    "NUMBERS",
    "exponential",
    "greater",
    "octet",
    "select",
    "smaller",
    "square_root",
    "widen",
]

LANES = 8
"""How many numbers an octet holds."""

FLAGS = ("contract", "nsz")
"""A product and a sum may be one rounding; nothing else that would change a result is allowed."""

NUMBERS = ir.VectorType(ir.FloatType(), LANES)
CLAIMS = ir.VectorType(ir.IntType(1), LANES)


class _Octet(types.Type):
    def __init__(self) -> None:
        super().__init__("octet")


class _Claims(types.Type):
    def __init__(self) -> None:
        super().__init__("octet of claims")


octet, claims = _Octet(), _Claims()


@register_model(_Octet)
class _OctetModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, NUMBERS)


@register_model(_Claims)
class _ClaimsModel(models.PrimitiveModel):
    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, CLAIMS)


def widen(builder: Any, value: Any, kind: Any) -> Any:
    """Return a number of some Numba type as eight equal ones; eight as they are."""
    if kind == octet:
        return value
    if kind == types.float64:
        value = builder.fptrunc(value, ir.FloatType())
    place = ir.Constant(ir.IntType(32), 0)
    one = builder.insert_element(ir.Constant(NUMBERS, ir.Undefined), value, place)
    everywhere = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
    return builder.shuffle_vector(one, ir.Constant(NUMBERS, ir.Undefined), everywhere)


def _operation(symbol: Any, result: Any, lower: Any) -> None:
    """Let an operator take two octets, or an octet and a number."""
    pairs = [(octet, octet)]
    for number in (types.float32, types.float64):
        pairs += [(octet, number), (number, octet)]
    cases = [signature(result, *pair) for pair in pairs]
    infer_global(symbol)(type(f"_{symbol.__name__}", (ConcreteTemplate,), {"cases": cases}))

    def lowered(_: Any, builder: Any, sig: Any, values: Any) -> Any:
        one, other = (widen(builder, *each) for each in zip(values, sig.args, strict=True))
        return lower(builder, one, other)

    for pair in pairs:
        lower_builtin(symbol, *pair)(lowered)


for _symbol, _name in (
    (operator.add, "fadd"),
    (operator.iadd, "fadd"),
    (operator.sub, "fsub"),
    (operator.isub, "fsub"),
    (operator.mul, "fmul"),
    (operator.imul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _operation(
        _symbol,
        octet,
        lambda builder, one, other, name=_name: getattr(builder, name)(one, other, flags=FLAGS),
    )
for _symbol, _sign in (
    (operator.lt, "<"),
    (operator.le, "<="),
    (operator.gt, ">"),
    (operator.ge, ">="),
):
    _operation(
        _symbol,
        claims,
        lambda builder, one, other, sign=_sign: builder.fcmp_ordered(sign, one, other),
    )
infer_global(operator.neg)(type("_neg", (ConcreteTemplate,), {"cases": [signature(octet, octet)]}))


@lower_builtin(operator.neg, octet)
def _negate(_: Any, builder: Any, __: Any, values: Any) -> Any:
    return builder.fneg(values[0])


def _common(kinds: Any) -> Any:
    return octet if octet in kinds else types.float64


def _cast(context: Any, builder: Any, value: Any, kind: Any, goal: Any) -> Any:
    """Return a number as an octet or as a double, whichever is the goal."""
    if goal == octet:
        return widen(builder, value, kind)
    return context.cast(builder, value, kind, goal)


def _function(name: str) -> Any:
    """Return one of LLVM's own functions, on numbers or on octets."""

    def define(*kinds: Any) -> Any:
        common = _common(kinds)

        def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
            pairs = zip(values, sig.args, strict=True)
            values = [_cast(context, builder, *pair, common) for pair in pairs]
            kind = context.get_value_type(common)
            full = f"llvm.{name}.{'v8f32' if common == octet else 'f64'}"
            kind = ir.FunctionType(kind, [kind] * len(values))
            return builder.call(cgutils.get_or_insert_function(builder.module, kind, full), values)

        return signature(common, *kinds), generate

    return define


def _unary(name: str) -> Callable[[float], float]:
    define = _function(name)

    @intrinsic
    def one_argument(_: Any, x: Any) -> Any:
        return define(x)

    return cast(Callable[[float], float], one_argument)


def _binary(name: str) -> Callable[[float, float], float]:
    define = _function(name)

    @intrinsic
    def two_arguments(_: Any, x: Any, y: Any) -> Any:
        return define(x, y)

    return cast(Callable[[float, float], float], two_arguments)


@intrinsic
def _select(_: Any, condition: Any, one: Any, other: Any) -> Any:
    common = octet if condition == claims else _common((one, other))

    def generate(context: Any, builder: Any, sig: Any, values: Any) -> Any:
        pairs = zip(values[1:], sig.args[1:], strict=True)
        return builder.select(
            values[0], *(_cast(context, builder, *pair, common) for pair in pairs)
        )

    return signature(common, condition, one, other), generate


select = cast(Callable[[bool, float, float], float], _select)
"""Return `one` where a condition holds, else `other`; both have been worked out."""

square_root = _unary("sqrt")
"""Return the square root of what is not negative."""

exponential = _unary("exp")
"""Return e to the power of x."""

smaller = _binary("minnum")
"""Return the smaller of two numbers."""

greater = _binary("maxnum")
"""Return the greater of two numbers."""
