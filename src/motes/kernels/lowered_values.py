"""Expressions of the language of generated modules: their kinds, and the instructions that compute them; see `motes.kernels.lowering`."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple, Protocol

from motes.kernels.assembly import (
    BYTE,
    DOUBLE,
    FLAGS,
    FLOAT,
    INT,
    TRUTH,
    WORD,
    Assembly,
    Builder,
    Value,
    number,
)

_ORDER = [TRUTH, BYTE, INT, WORD, FLOAT, DOUBLE]  # from the narrowest to the widest
_BINARY: dict[type, str] = {
    ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div", ast.FloorDiv: "sdiv", ast.Mod: "srem",
    ast.LShift: "shl", ast.RShift: "ashr", ast.BitAnd: "and", ast.BitOr: "or",
}  # fmt: skip
_COMPARED: dict[type, tuple[str, str]] = {
    ast.Lt: ("slt", "olt"), ast.LtE: ("sle", "ole"), ast.Gt: ("sgt", "ogt"), ast.GtE: ("sge", "oge"), ast.Eq: ("eq", "oeq"), ast.NotEq: ("ne", "une"),
}  # fmt: skip
_NEAR = 2  # how near `prefetch` brings memory: 3 is the first cache, 2 the second


class Returned(NamedTuple):
    """How a function is called, and the kinds that it returns: none, one, or several."""

    name: str
    kinds: tuple[str, ...]

    @property
    def kind(self) -> str:
        return "void" if not self.kinds else self.kinds[0] if len(self.kinds) == 1 else f"{{{', '.join(self.kinds)}}}"


class Around(Protocol):
    """What a function knows of its module."""

    assembly: Assembly
    kinds: dict[str, str]
    constants: dict[str, Value]
    functions: dict[str, ast.FunctionDef]

    def called(self, name: str, kinds: tuple[str, ...]) -> Returned:
        """The function for arguments of these kinds."""


def plain(node: ast.expr) -> float:
    """A number that stands in the text."""
    if isinstance(node, ast.Constant):
        return float(node.value) if isinstance(node.value, float) else int(node.value)  # type: ignore[arg-type]
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -plain(node.operand)
    if isinstance(node, ast.Name) and node.id in ("inf", "nan"):
        return float(node.id)
    raise TypeError(f"{ast.unparse(node)} is no number")


def widest(*kinds: str) -> str:
    return max(kinds, key=_ORDER.index)


def _is_float(kind: str) -> bool:
    return kind in (FLOAT, DOUBLE)


class Expressions:
    """Those of one function for arguments of some kinds."""

    def __init__(self, module: Around, arguments: Mapping[str, Value]) -> None:
        self.module, self.arguments = module, arguments
        self.builder = Builder(module.assembly)
        self.variables: dict[str, Value] = {}
        self.kinds: dict[str, str] = {}  # of variables

    # ------------------------------------------------------------ kinds

    def _kind(self, node: ast.expr) -> str:
        if isinstance(node, ast.Name):
            if node.id in self.kinds:
                return self.kinds[node.id]
            known = self.arguments.get(node.id) or self.module.constants.get(node.id)
            return known.kind if known is not None else TRUTH
        if isinstance(node, ast.Constant):
            return TRUTH if isinstance(node.value, bool) else DOUBLE if isinstance(node.value, float) else WORD
        if isinstance(node, ast.BoolOp | ast.Compare):
            return TRUTH
        if isinstance(node, ast.UnaryOp):
            return TRUTH if isinstance(node.op, ast.Not) else self._kind(node.operand)
        if isinstance(node, ast.BinOp):
            return widest(self._kind(node.left), self._kind(node.right))
        if isinstance(node, ast.IfExp):
            return widest(self._kind(node.body), self._kind(node.orelse))
        assert isinstance(node, ast.Call)
        assert isinstance(node.func, ast.Name)
        name = node.func.id
        if name in self.module.functions:
            return (*self._callee(node).kinds, TRUTH)[0]
        if name in self.module.kinds:
            return self.module.kinds[name]
        first = self._kind(node.args[0])
        if name == "load":
            return self._named(node.args[0])
        if name == "select":
            return widest(*(self._kind(a) for a in node.args[1:]))
        if name in ("bits_of", "float_of"):
            return {FLOAT: INT, DOUBLE: WORD, INT: FLOAT, WORD: DOUBLE}[first]
        return widest(*(self._kind(a) for a in node.args)) if name == "min" else first

    def _callee(self, node: ast.Call) -> Returned:
        assert isinstance(node.func, ast.Name)
        return self.module.called(node.func.id, tuple(self._kind(argument) for argument in node.args))

    def _named(self, node: ast.expr) -> str:
        assert isinstance(node, ast.Name)
        return self.module.kinds[node.id]

    # ------------------------------------------------------------ values

    def _name(self, node: ast.Name) -> Value:
        if node.id in self.variables:
            return self.builder.load(self.kinds[node.id], self.variables[node.id])
        return self.arguments[node.id] if node.id in self.arguments else self.module.constants[node.id]

    def _value(self, node: ast.expr) -> Value:
        builder = self.builder
        if isinstance(node, ast.Name):
            return self._name(node)
        if isinstance(node, ast.Constant):
            if isinstance(node.value, bool):
                return Value(TRUTH, str(node.value).lower())
            return number(self._kind(node), plain(node))
        if isinstance(node, ast.BinOp):
            return self._binary(type(node.op), self._value(node.left), self._value(node.right))
        if isinstance(node, ast.BoolOp):
            op = "and" if isinstance(node.op, ast.And) else "or"
            result, *others = (self._truth(value) for value in node.values)
            for other in others:
                result = builder.binary(op, result, other)
            return result
        if isinstance(node, ast.UnaryOp):
            if isinstance(node.op, ast.Not):
                return builder.binary("xor", self._truth(node.operand), Value(TRUTH, "true"))
            value = self._value(node.operand)
            return (
                builder.negated(value) if _is_float(value.kind) else builder.binary("sub", number(value.kind, 0), value)
            )
        if isinstance(node, ast.Compare):
            a, b = self._value(node.left), self._value(node.comparators[0])
            kind = widest(a.kind, b.kind)
            return builder.compared(_COMPARED[type(node.ops[0])][_is_float(kind)], self._as(a, kind), self._as(b, kind))
        if isinstance(node, ast.IfExp):
            kind = self._kind(node)
            test, a, b = self._truth(node.test), self._value(node.body), self._value(node.orelse)
            return builder.select(test, self._as(a, kind), self._as(b, kind))
        assert isinstance(node, ast.Call)
        return self._called(node)

    def _binary(self, op: type, a: Value, b: Value) -> Value:
        kind = widest(a.kind, b.kind)
        if kind == TRUTH and op is ast.Add:
            kind = WORD
        name = _BINARY[op]
        return self.builder.binary(f"f{name}" if _is_float(kind) else name, self._as(a, kind), self._as(b, kind))

    def _truth(self, node: ast.expr) -> Value:
        value = self._value(node)
        if value.kind == TRUTH:
            return value
        return self.builder.compared("une" if _is_float(value.kind) else "ne", value, number(value.kind, 0))

    def _as(self, value: Value, kind: str) -> Value:
        """The same number in another kind."""
        if value.kind == kind:
            return value
        before, after = _is_float(value.kind), _is_float(kind)
        wider = _ORDER.index(kind) > _ORDER.index(value.kind)
        if before and after:
            op = "fpext" if wider else "fptrunc"
        elif before:
            op = "fptoui" if kind == BYTE else "fptosi"
        elif after:
            op = "uitofp" if value.kind in (TRUTH, BYTE) else "sitofp"
        else:
            op = ("zext" if value.kind in (TRUTH, BYTE) else "sext") if wider else "trunc"
        return self.builder.turned(op, value, kind)

    def _several(self, node: ast.Call) -> list[Value]:
        """All that a call returns."""
        whole, callee = self._called(node), self._callee(node)
        return [
            self.builder.value(kind, f"extractvalue {whole.kind} {whole.text}, {k}")
            for k, kind in enumerate(callee.kinds)
        ]

    def _called(self, node: ast.Call) -> Value:
        builder = self.builder
        assert isinstance(node.func, ast.Name)
        name = node.func.id
        if name in self.module.functions:
            callee = self._callee(node)
            return builder.call(callee.name, callee.kind, [self._value(argument) for argument in node.args])
        if name in self.module.kinds:
            kind = self.module.kinds[name]
            try:
                return number(kind, plain(node.args[0]))
            except TypeError:
                return self._as(self._value(node.args[0]), kind)
        return _BUILT_IN[name](self, node.args)

    def _load(self, args: Sequence[ast.expr]) -> Value:
        """``load(kind, address, index, phase, lanes)``: an item of memory that the lanes of the phase do not write."""
        kind, scopes = self._named(args[0]), self._scopes(args[3], args[4])
        promise = f", !noalias {self.module.assembly.metadata(_set(scopes))}" if scopes else ""
        return self.builder.load(kind, self._item(kind, args[1], args[2]), more=promise)

    def _store(self, args: Sequence[ast.expr]) -> Value:
        """``store(kind, address, index, value, phase, lane, lanes)``.

        The memory of a lane is written by that lane only and not read in the phase (a loop with a name).  Without this promise a loop
        over nine arrays needs more run-time checks for overlap than LLVM is willing to make, and is not vectorised.
        """
        kind, scopes = self._named(args[0]), self._scopes(args[4], args[6])
        value = self._as(self._value(args[3]), kind)
        own = scopes.pop(int(self._plain(args[5])))
        metadata = self.module.assembly.metadata
        promise = f", !alias.scope {metadata(_set([own]))}"
        promise += f", !noalias {metadata(_set(scopes))}" if scopes else ""
        self.builder.store(value, self._item(kind, args[1], args[2]), more=promise)
        return value

    def _scopes(self, phase: ast.expr, lanes: ast.expr) -> list[str]:
        assert isinstance(phase, ast.Constant)
        return self.module.assembly.scopes(str(phase.value), int(self._plain(lanes)))

    def _plain(self, node: ast.expr) -> float:
        """A number that is known here."""
        if isinstance(node, ast.BinOp):
            a, b = self._plain(node.left), self._plain(node.right)
            return a - b if isinstance(node.op, ast.Sub) else a + b
        if isinstance(node, ast.Name):
            return int(self.module.constants[node.id].text)
        return plain(node)

    def _item(self, kind: str, address: ast.expr, index: ast.expr) -> Value:
        at, place = self.builder.pointer(self._value(address)), self._as(self._value(index), WORD)
        return self.builder.value("ptr", f"getelementptr {kind}, ptr {at.text}, i64 {place.text}")

    def _select(self, args: Sequence[ast.expr]) -> Value:
        """``select(condition, a, b)``: `a` where the condition holds, else `b`."""
        kind = widest(*(self._kind(a) for a in args[1:]))
        condition, a, b = self._truth(args[0]), *(self._as(self._value(a), kind) for a in args[1:])
        return self.builder.select(condition, a, b)

    def _min(self, args: Sequence[ast.expr]) -> Value:
        a, b = (self._as(self._value(a), WORD) for a in args)
        return self.builder.select(self.builder.compared("slt", b, a), b, a)

    def _sqrt(self, args: Sequence[ast.expr]) -> Value:
        """``sqrt(x)``: the processor's; NaN for negative numbers."""
        x = self._value(args[0])
        return self.builder.intrinsic(f"llvm.sqrt.f{32 if x.kind == FLOAT else 64}", x.kind, [x], FLAGS)

    def _bits(self, args: Sequence[ast.expr]) -> Value:
        """``bits_of(x)``: the bits of a float as an integer of its size, and ``float_of(n)``: the float that has these bits."""
        x = self._value(args[0])
        return self.builder.turned("bitcast", x, {FLOAT: INT, DOUBLE: WORD, INT: FLOAT, WORD: DOUBLE}[x.kind])

    def _prefetch(self, args: Sequence[ast.expr]) -> Value:
        """``prefetch(address)``: ask for memory to be brought near, without waiting; an address that there is not does no harm."""
        pointer = self.builder.pointer(self._value(args[0]))
        how = [number(INT, k) for k in (0, _NEAR, 1)]
        return self.builder.intrinsic("llvm.prefetch.p0", "void", [pointer, *how])


def _set(nodes: Sequence[str]) -> str:
    return f"!{{{', '.join(nodes)}}}"


_BUILT_IN: dict[str, Callable[[Expressions, Sequence[ast.expr]], Value]] = {
    "load": Expressions._load,
    "store": Expressions._store,
    "select": Expressions._select,
    "min": Expressions._min,
    "sqrt": Expressions._sqrt,
    "bits_of": Expressions._bits,
    "float_of": Expressions._bits,
    "prefetch": Expressions._prefetch,
}
