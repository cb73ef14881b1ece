"""The language of generated modules, brought down to LLVM's instructions.

A generated module is Python that is never run: functions over addresses (integers), numbers, and the calls that `_BUILT_IN` lists, one of which may be a
program of `motes.kernels.vectors`.  It says so in few words::

    F, D = float32, float64
    LANES = 16

    @inline                     # goes into the functions that call it; without it, that is as it may be
    def clear(rows, count):
        for n in range(count * LANES):
            store(D, rows, n, D(0.0), "clear", 0, 1)

    @apart                      # goes into no other, and is made short: for what is done once for many
    def load_block(...): ...

    @kernel                     # what the engine calls: all arguments are integers, and so is what is returned, if anything
    def fit(...): ...

    @kernel
    @flushing                   # while it runs, numbers smaller than the smallest normal one are 0
    @wide                       # its loops become vectors as wide as the processor's, half of which LLVM leaves unused on Intel's with AVX-512
    def evaluate(...): ...

Variables have the widest kind of what they are given, operands of ``and``, ``or`` and ``a if b else c`` are all computed, and integers are not negative
where they are divided.  A program of vectors is a function of its own, which LLVM puts into no other.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from motes.kernels import vectors
from motes.kernels.assembly import BYTE, DOUBLE, FLOAT, INT, WORD, Assembly, Value, number
from motes.kernels.lowered_values import Expressions, Returned, plain, widest
from motes.kernels.machine_code import is_x86, without_estimates

# Bits of x86's control register: results below the smallest normal number become 0, and operands so small count as 0.
_FLUSHING = 0x8000 | 0x0040
_KINDS = {"float32": FLOAT, "float64": DOUBLE, "int32": INT, "int64": WORD, "uint8": BYTE}


class Lowered(NamedTuple):
    """LLVM's text of a module, whole and in parts; of each of its kernels the number of arguments, and whether it returns an integer."""

    text: str
    parts: list[str]
    kernels: dict[str, tuple[int, bool]]


def lowered(source: str) -> Lowered:
    """A module in LLVM's instructions."""
    module = _Module(ast.parse(source))
    kernels = {}
    for name, node in module.functions.items():
        if _decorated(node, "kernel"):
            count = len(node.args.args)
            kernels[name] = count, bool(module.called(name, (WORD,) * count).kinds)
    return Lowered(module.assembly.text(), module.assembly.parts(), kernels)


def _decorated(node: ast.FunctionDef, how: str) -> bool:
    return any(isinstance(d, ast.Name) and d.id == how for d in node.decorator_list)


class _Module:
    """Constants, kinds and functions by name; functions are written for the kinds that they are called with."""

    def __init__(self, tree: ast.Module) -> None:
        self.assembly = Assembly()
        self.kinds: dict[str, str] = dict(_KINDS)
        self.constants: dict[str, Value] = {}
        self.functions: dict[str, ast.FunctionDef] = {}
        self._written: dict[tuple[str, tuple[str, ...]], Returned] = {}
        for node in tree.body:
            if isinstance(node, ast.FunctionDef):
                self.functions[node.name] = node
            elif isinstance(node, ast.Assign):
                self._define(node)

    def _define(self, node: ast.Assign) -> None:
        for target, given in _pairs(node):
            if isinstance(given, ast.Name) and given.id in self.kinds:
                self.kinds[target] = self.kinds[given.id]
            else:
                self.constants[target] = self._number(given)

    def _number(self, node: ast.expr) -> Value:
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            return number(self.kinds[node.func.id], plain(node.args[0]))
        return number(WORD, plain(node))

    def called(self, name: str, kinds: tuple[str, ...]) -> Returned:
        """The function for arguments of these kinds."""
        key = name, kinds
        if key not in self._written:
            node = self.functions[name]
            others = sum(other == name for other, _ in self._written)
            label = f"{name}.{others}" if others else name
            self._written[key] = _Function(self, node, label, kinds).written()
        return self._written[key]


def _pairs(node: ast.Assign) -> list[tuple[str, ast.expr]]:
    """What is given to whom, where each name has a value of its own."""
    (target,) = node.targets
    if isinstance(target, ast.Name):
        return [(target.id, node.value)]
    assert isinstance(target, ast.Tuple)
    assert isinstance(node.value, ast.Tuple)
    return list(zip(_names(target), node.value.elts, strict=True))


def _names(target: ast.Tuple) -> list[str]:
    return [name.id for name in target.elts if isinstance(name, ast.Name)]


class _Function(Expressions):
    """One function for arguments of some kinds."""

    def __init__(self, module: _Module, node: ast.FunctionDef, label: str, kinds: Sequence[str]) -> None:
        self.given = [Value(kind, f"%a{k}") for k, kind in enumerate(kinds)]
        super().__init__(module, {a.arg: value for a, value in zip(node.args.args, self.given, strict=True)})
        self.node, self.label = node, label
        self.returned: tuple[str, ...] = ()
        self.loops: list[tuple[str, str]] = []  # where `continue` and `break` go
        self.control: Value | None = None  # where the processor's settings are, as they were before

    def written(self) -> Returned:
        """Write it into the module."""
        program = _program(self.node)
        if program is not None:
            self._run(*program)
            self.builder.lines.append("ret void")
            how = "noinline nounwind"
        else:
            self._learn()
            for name, kind in self.kinds.items():
                self.variables[name] = self.builder.place(kind)
                if name in self.arguments:
                    self.builder.store(self._as(self.arguments[name], kind), self.variables[name])
            if _decorated(self.node, "flushing") and is_x86():
                self._flush()
            if not self._block(self.node.body):
                self._leave("ret void")
            how = "alwaysinline nounwind" if _decorated(self.node, "inline") else "nounwind"
            if _decorated(self.node, "apart"):
                how = "noinline optsize nounwind"
        if _decorated(self.node, "wide"):
            how += ' "prefer-vector-width"="512"'
        if without_estimates():
            how += ' "reciprocal-estimates"="none"'
        found = Returned(self.label, self.returned)
        linkage = "" if _decorated(self.node, "kernel") else "internal "
        self.module.assembly.functions.append(self.builder.function(self.label, found.kind, self.given, how, linkage))
        return found

    def _flush(self) -> None:
        """From here on, results and operands that are no normal numbers are 0: Intel's processors take a hundred cycles and more for each vector with one."""
        builder = self.builder
        self.control, own = builder.place(INT), builder.place(INT)
        builder.intrinsic("llvm.x86.sse.stmxcsr", "void", [self.control])
        setting = builder.binary("or", builder.load(INT, self.control), number(INT, _FLUSHING))
        builder.store(setting, own)
        builder.intrinsic("llvm.x86.sse.ldmxcsr", "void", [own])

    def _leave(self, how: str) -> None:
        """Return, with the processor's settings as they were."""
        if self.control is not None:
            self.builder.intrinsic("llvm.x86.sse.ldmxcsr", "void", [self.control])
        self.builder.lines.append(how)

    def _run(self, text: str, call: ast.Call) -> None:
        assert isinstance(call.func, ast.Attribute)
        written: Callable[..., None] = getattr(vectors, call.func.attr)
        arguments: list[Any] = []
        for argument in call.args:
            if isinstance(argument, ast.Constant):
                arguments.append(argument.value)
            elif isinstance(argument, ast.Name) and argument.id in self.arguments:
                arguments.append(self.arguments[argument.id])
            elif isinstance(argument, ast.Name) and argument.id == "program":
                arguments.append(text)
            else:
                assert isinstance(argument, ast.Name)
                arguments.append(int(self.module.constants[argument.id].text))
        written(self.builder, *arguments)

    # ------------------------------------------------------------ kinds of variables

    def _learn(self) -> None:
        """What kind each variable is; what is given another one's value is known the second time."""
        assigned = [node for node in ast.walk(self.node) if isinstance(node, ast.Assign | ast.AugAssign | ast.For)]
        assigned.sort(key=lambda node: node.lineno)
        for _ in range(2):
            for node in assigned:
                if isinstance(node, ast.For):
                    assert isinstance(node.target, ast.Name)
                    self._widen(node.target.id, WORD)
                elif isinstance(node, ast.AugAssign):
                    assert isinstance(node.target, ast.Name)
                    self._widen(node.target.id, self._kind(node.value))
                elif isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Call):
                    for name, kind in zip(_names(node.targets[0]), self._callee(node.value).kinds, strict=True):
                        self._widen(name, kind)
                else:
                    for name, value in _pairs(node):
                        self._widen(name, self._kind(value))
        for returned in (n.value for n in ast.walk(self.node) if isinstance(n, ast.Return) and n.value is not None):
            parts = returned.elts if isinstance(returned, ast.Tuple) else [returned]
            self.returned = tuple(self._kind(part) for part in parts)

    def _widen(self, name: str, kind: str) -> None:
        before = self.kinds.get(name) or (self.arguments[name].kind if name in self.arguments else kind)
        self.kinds[name] = widest(kind, before)

    # ------------------------------------------------------------ statements

    def _block(self, statements: Sequence[ast.stmt]) -> bool:
        """Write statements; whether the last of them leads elsewhere."""
        return any(self._statement(statement) for statement in statements)

    def _statement(self, node: ast.stmt) -> bool:
        builder = self.builder
        if isinstance(node, ast.Expr):
            if isinstance(node.value, ast.Call):
                self._called(node.value)
        elif isinstance(node, ast.Assign):
            self._assign(node)
        elif isinstance(node, ast.AugAssign):
            assert isinstance(node.target, ast.Name)
            self._put(node.target.id, self._binary(type(node.op), self._name(node.target), self._value(node.value)))
        elif isinstance(node, ast.If):
            return self._if(node)
        elif isinstance(node, ast.For):
            self._for(node)
        elif isinstance(node, ast.While):
            check, inside, after = (builder.label() for _ in range(3))
            builder.go(check)
            builder.begin(check)
            builder.choose(self._truth(node.test), inside, after)
            self._inside(inside, node.body, check, after)
            builder.begin(after)
        elif isinstance(node, ast.Return):
            self._return(node)
            return True
        elif isinstance(node, ast.Break | ast.Continue):
            builder.go(self.loops[-1][isinstance(node, ast.Break)])
            return True
        else:
            raise TypeError(f"{ast.unparse(node)} is not in the language of generated modules")
        return False

    def _inside(self, label: str, body: Sequence[ast.stmt], again: str, after: str) -> None:
        self.loops.append((again, after))
        self.builder.begin(label)
        if not self._block(body):
            self.builder.go(again)
        self.loops.pop()

    def _if(self, node: ast.If) -> bool:
        builder = self.builder
        then, otherwise, after = (builder.label() for _ in range(3))
        builder.choose(self._truth(node.test), then, otherwise if node.orelse else after)
        builder.begin(then)
        ends = [self._block(node.body)]
        if not ends[0]:
            builder.go(after)
        if node.orelse:
            builder.begin(otherwise)
            ends.append(self._block(node.orelse))
            if not ends[1]:
                builder.go(after)
        if len(ends) == 2 and all(ends):
            return True
        builder.begin(after)
        return False

    def _for(self, node: ast.For) -> None:
        builder = self.builder
        assert isinstance(node.target, ast.Name)
        assert isinstance(node.iter, ast.Call)
        values = [self._value(argument) for argument in node.iter.args]
        from_zero = [number(WORD, 0)] if len(values) == 1 else []
        start, stop, step = [*from_zero, *values, number(WORD, 1)][:3]
        index = builder.place(WORD)
        check, inside, further, after = (builder.label() for _ in range(4))
        builder.store(start, index)
        builder.go(check)
        builder.begin(check)
        at = builder.load(WORD, index)
        builder.choose(builder.compared("slt", at, stop), inside, after)
        self.loops.append((further, after))
        builder.begin(inside)
        self._put(node.target.id, at)
        if not self._block(node.body):
            builder.go(further)
        self.loops.pop()
        builder.begin(further)
        builder.store(builder.value(WORD, f"add nsw i64 {at.text}, {step.text}"), index)
        builder.go(check)
        builder.begin(after)

    def _assign(self, node: ast.Assign) -> None:
        if isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Call):
            for name, value in zip(_names(node.targets[0]), self._several(node.value), strict=True):
                self._put(name, value)
            return
        for name, value in [(name, self._value(value)) for name, value in _pairs(node)]:
            self._put(name, value)

    def _return(self, node: ast.Return) -> None:
        if node.value is None:
            self._leave("ret void")
            return
        parts = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        values = [self._as(self._value(part), kind) for part, kind in zip(parts, self.returned, strict=True)]
        result = values[0]
        if len(values) > 1:
            kind = f"{{{', '.join(self.returned)}}}"
            result = Value(kind, "poison")
            for k, value in enumerate(values):
                result = self.builder.value(kind, f"insertvalue {kind} {result.text}, {value.kind} {value.text}, {k}")
        self._leave(f"ret {result.kind} {result.text}")

    def _put(self, name: str, value: Value) -> None:
        self.builder.store(self._as(value, self.kinds[name]), self.variables[name])


def _program(node: ast.FunctionDef) -> tuple[str, ast.Call] | None:
    """The text of a program of vectors and the call that runs it, where the function is one."""
    last = node.body[-1]
    if not isinstance(last, ast.Return) or not isinstance(last.value, ast.Call):
        return None
    if not isinstance(last.value.func, ast.Attribute):
        return None
    first = node.body[0]
    text = first.value.value if isinstance(first, ast.Assign) and isinstance(first.value, ast.Constant) else ""
    return str(text), last.value
