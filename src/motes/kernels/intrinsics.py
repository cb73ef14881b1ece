"""What generated Numba kernels need and Numba does not offer: memory without aliasing, a select, bits of floats, sums in any order.

Kernels take plain addresses: one signature then serves every layout, read-only arrays included, and is compiled once.  Imported by
generated modules only (it imports Numba).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba.core import types
from numba.extending import intrinsic

NEAR = 2  # how near `prefetch` brings memory: 3 is the first cache, 2 the second
ANY_ORDER = ("reassoc", "nsz", "contract")


def _scopes(module: Any, phase: str, lanes: int) -> list[Any]:
    """LLVM's names for the memory that the lanes of a phase write; see `store`."""
    domain = module.add_metadata(["motes"])
    return [module.add_metadata([f"{phase}{lane}", domain]) for lane in range(lanes)]


def _pointer(context: Any, builder: Any, scalar: Any, address: Any, index: Any) -> Any:
    base = builder.inttoptr(address, context.get_value_type(scalar).as_pointer())
    return builder.gep(base, [index])


@intrinsic(prefer_literal=True)
def load(typing: Any, scalar: Any, address: Any, index: Any, phase: Any, lanes: Any) -> Any:
    """``address[index]`` of a scalar type, from memory that the lanes of the phase do not write."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        value = builder.load(_pointer(context, builder, scalar.dtype, args[1], args[2]))
        scopes = _scopes(builder.module, phase.literal_value, lanes.literal_value)
        value.set_metadata("noalias", builder.module.add_metadata(scopes))
        return value

    return scalar.dtype(scalar, types.int64, types.int64, phase, lanes), generate


@intrinsic(prefer_literal=True)
def store(typing: Any, scalar: Any, address: Any, index: Any, value: Any, phase: Any, lane: Any, lanes: Any) -> Any:
    """``address[index] = value``.

    The memory of a lane is written by that lane only and not read in the phase (a loop with a name).  Without this promise a loop
    over nine arrays needs more run-time checks for overlap than LLVM is willing to make, and is not vectorised.
    """

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        instruction = builder.store(args[3], _pointer(context, builder, scalar.dtype, args[1], args[2]))
        scopes = _scopes(builder.module, phase.literal_value, lanes.literal_value)
        own = scopes.pop(lane.literal_value)
        instruction.set_metadata("alias.scope", builder.module.add_metadata([own]))
        if scopes:
            instruction.set_metadata("noalias", builder.module.add_metadata(scopes))
        return context.get_dummy_value()

    return types.none(scalar, types.int64, types.int64, scalar.dtype, phase, lane, lanes), generate


@intrinsic
def prefetch(typing: Any, address: Any) -> Any:
    """Ask for the memory at an address to be brought near, without waiting for it; an address that there is not does no harm."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        pointer = builder.inttoptr(args[0], ir.IntType(8).as_pointer())
        word = ir.IntType(32)
        function = builder.module.globals.get("llvm.prefetch.p0") or ir.Function(
            builder.module, ir.FunctionType(ir.VoidType(), [pointer.type, word, word, word]), "llvm.prefetch.p0"
        )
        builder.call(function, [pointer, ir.Constant(word, 0), ir.Constant(word, NEAR), ir.Constant(word, 1)])
        return context.get_dummy_value()

    return types.none(types.int64), generate


@intrinsic
def select(typing: Any, condition: Any, a: Any, b: Any) -> Any:
    """`a` where the condition holds, else `b`; both are computed."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.select(*args)

    return a(types.boolean, a, a), generate


@intrinsic
def sqrt(typing: Any, x: Any) -> Any:
    """The processor's square root; math.sqrt calls libm for negative numbers."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        function = builder.module.declare_intrinsic("llvm.sqrt", [args[0].type])
        return builder.call(function, args)

    return x(x), generate


@intrinsic
def add_in_any_order(typing: Any, total: Any, term: Any) -> Any:
    """A term of a sum that may be regrouped into vector lanes; the order is fixed once compiled."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.fadd(args[0], args[1], flags=ANY_ORDER)

    return total(total, total), generate


@intrinsic
def bits_of(typing: Any, x: Any) -> Any:
    """The bits of a float as an integer of its size."""
    integer: Any = types.int32 if x == types.float32 else types.int64

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], ir.IntType(integer.bitwidth))

    return integer(x), generate


@intrinsic
def float_of(typing: Any, x: Any) -> Any:
    """The float that has these bits."""
    real: Any = types.float32 if x == types.int32 else types.float64

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        return builder.bitcast(args[0], context.get_value_type(real))

    return real(x), generate
