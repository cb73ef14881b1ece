"""LLVM's instructions as text: what generated modules become, written a line at a time.

llvmlite's own objects for instructions take ten times as long to make and to print.  Kinds of values are LLVM's words for them: ``i64``, ``double``,
``<8 x double>``; memory is addressed by ``i64``.
"""

from __future__ import annotations

import struct
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import NamedTuple

#: A value is NaN where it should be, and sums keep their order: without nnan, ninf and reassoc.
FLAGS = "nsz arcp contract"
WORD, INT, BYTE, TRUTH, FLOAT, DOUBLE = "i64", "i32", "i8", "i1", "float", "double"
SIZES = {TRUTH: 1, BYTE: 1, INT: 4, WORD: 8, FLOAT: 4, DOUBLE: 8}
LINE = 64  # bytes of a cache line
# Letters from which on a module is compiled in parts, a third of a second's work, and that a part has at least.
SHORT, PART = 200_000, 70_000
# Objects of other systems than Linux have not been seen to find each other.
IN_PARTS = sys.platform.startswith("linux")
_FLOATS = {"F": FLOAT, "D": DOUBLE}


class Value(NamedTuple):
    """What an instruction yields, or a constant."""

    kind: str
    text: str


def vector(lanes: int, kind: str) -> str:
    """The kind of so many lanes."""
    return f"<{lanes} x {kind}>"


def number(kind: str, value: float) -> Value:
    """A constant: an integer, a floating-point number, or the same one in all lanes of a vector."""
    if kind.startswith("<"):
        one = number(kind[1:-1].split(" x ")[1], value)
        return Value(kind, f"splat ({one.kind} {one.text})")
    if kind in (FLOAT, DOUBLE):
        if kind == FLOAT and abs(value) < float("inf"):
            value = struct.unpack("<f", struct.pack("<f", value))[0]
        return Value(kind, f"0x{struct.pack('>d', value).hex()}" if value == value else "0x7ff8000000000000")
    return Value(kind, str(int(value)))


class Function(NamedTuple):
    """A function: its text, what it calls, how others declare it, and whether it goes into no other."""

    name: str
    text: str
    calls: frozenset[str]
    declaration: str
    apart: bool


class Assembly:
    """A module: its functions, the functions of LLVM's that it calls, and what is promised about memory."""

    def __init__(self) -> None:
        self.functions: list[Function] = []
        self._declared: dict[str, str] = {}
        self._metadata: dict[str, int] = {}

    def declare(self, name: str, kind: str, arguments: Sequence[str]) -> str:
        """A function of LLVM's, by its whole name."""
        self._declared[name] = f"declare {kind} @{name}({', '.join(arguments)})"
        return name

    def metadata(self, text: str) -> str:
        """A node of metadata, the same for the same text."""
        return f"!{self._metadata.setdefault(text, len(self._metadata))}"

    def scopes(self, phase: str, lanes: int) -> list[str]:
        """Names for the memory that the lanes of a phase write: see `Builder.store`."""
        domain = self.metadata('!{!"motes"}')
        return [self.metadata(f'!{{!"{phase}{lane}", {domain}}}') for lane in range(lanes)]

    def text(self) -> str:
        """All of it."""
        return self._of([function.text for function in self.functions])

    def parts(self) -> list[str]:
        """The same in parts that can be compiled at once, whose objects belong together.

        What is not `apart` goes with all that call it.  A short module is one part, and so is one that is mostly one function.
        """
        apart = sorted((function for function in self.functions if function.apart), key=lambda f: -len(f.text))
        longest, whole = len(apart[0].text) if apart else 0, sum(len(function.text) for function in apart)
        if not IN_PARTS or whole < SHORT or 2 * longest > whole:
            return [self.text()]
        parts: list[list[Function]] = [[]]
        for function in apart:
            if sum(len(f.text) for f in parts[-1]) >= PART:
                parts.append([])
            parts[-1].append(function)
        return [self._part(part) for part in parts]

    def _part(self, part: Sequence[Function]) -> str:
        """The text of some functions with all that goes into them."""
        known = {function.name: function for function in self.functions}
        wanted, declared = {function.name: function for function in part}, dict[str, str]()
        waiting = list(part)
        while waiting:
            for name in waiting.pop().calls & known.keys() - wanted.keys():
                if known[name].apart:
                    declared[name] = known[name].declaration
                else:
                    wanted[name] = known[name]
                    waiting.append(known[name])
        texts = [f.text.replace("define internal ", "define ", 1) if f.apart else f.text for f in wanted.values()]
        return self._of([*texts, *declared.values()])

    def _of(self, functions: Sequence[str]) -> str:
        """The text of a module."""
        nodes = [f"!{k} = {text}" for text, k in self._metadata.items()]
        return "\n".join([*functions, *self._declared.values(), *nodes, ""])


class Builder:
    """Writes a function's instructions, block after block."""

    def __init__(self, module: Assembly) -> None:
        self.module = module
        self.lines: list[str] = []
        self.places: list[str] = []  # memory of the function's own, made at its beginning
        self.aligned = False
        self.tuning = ""  # the processor for which LLVM orders instructions, where it is not the one at hand
        self.block = "begin"
        self.calls: set[str] = set()
        self._count = 0

    def function(
        self, name: str, kind: str, arguments: Sequence[Value], attributes: str, linkage: str = ""
    ) -> Function:
        """What was written, as a function."""
        given = ", ".join(f"{kind} {text}" for kind, text in arguments)
        aligned = f" alignstack({LINE})" if self.aligned else ""
        tuned = f' "tune-cpu"="{self.tuning}"' if self.tuning else ""
        head = f"define {linkage}{kind} @{name}({given}) {attributes}{aligned}{tuned} {{"
        text = "\n".join([head, "begin:", *self.places, *self.lines, "}"])
        declaration = f"declare {kind} @{name}({', '.join(argument.kind for argument in arguments)})"
        return Function(name, text, frozenset(self.calls), declaration, not linkage or "noinline" in attributes)

    def fresh(self) -> str:
        self._count += 1
        return f"%v{self._count}"

    def value(self, kind: str, instruction: str) -> Value:
        """What an instruction yields."""
        name = self.fresh()
        self.lines.append(f"{name} = {instruction}")
        return Value(kind, name)

    # ------------------------------------------------------------ arithmetic

    def binary(self, op: str, a: Value, b: Value) -> Value:
        """``fadd`` and the like with `FLAGS`, or an operation on integers."""
        name = f"{op} {FLAGS}" if op[0] == "f" else op
        return self.value(a.kind, f"{name} {a.kind} {a.text}, {b.text}")

    def negated(self, a: Value) -> Value:
        return self.value(a.kind, f"fneg {FLAGS} {a.kind} {a.text}")

    def compared(self, how: str, a: Value, b: Value) -> Value:
        """``olt``, ``slt`` and the like: truth, or lanes of it."""
        of_floats = how[0] == "o" or how in ("une", "uno")
        name = f"fcmp {FLAGS} {how}" if of_floats else f"icmp {how}"
        kind = f"{a.kind[: a.kind.index('x')]}x {TRUTH}>" if a.kind.startswith("<") else TRUTH
        return self.value(kind, f"{name} {a.kind} {a.text}, {b.text}")

    def select(self, condition: Value, a: Value, b: Value) -> Value:
        return self.value(a.kind, f"select {condition.kind} {condition.text}, {a.kind} {a.text}, {b.kind} {b.text}")

    def turned(self, op: str, a: Value, kind: str) -> Value:
        """Another kind: ``bitcast``, ``sitofp`` and the like."""
        return self.value(kind, f"{op} {a.kind} {a.text} to {kind}")

    def call(self, name: str, kind: str, arguments: Sequence[Value], flags: str = "") -> Value:
        """What a function returns; nothing for ``void``."""
        self.calls.add(name)
        given = ", ".join(f"{argument.kind} {argument.text}" for argument in arguments)
        call = f"call {flags and flags + ' '}{kind} @{name}({given})"
        if kind == "void":
            self.lines.append(call)
            return Value(kind, "")
        return self.value(kind, call)

    def intrinsic(self, name: str, kind: str, arguments: Sequence[Value], flags: str = "") -> Value:
        """The same of one of LLVM's own."""
        return self.call(self.module.declare(name, kind, [a.kind for a in arguments]), kind, arguments, flags)

    def shuffled(self, a: Value, b: Value, order: Sequence[int]) -> Value:
        """Lanes of two vectors."""
        mask = ", ".join(f"i32 {n}" for n in order)
        kind = vector(len(order), a.kind[1:-1].split(" x ")[1])
        return self.value(
            kind, f"shufflevector {a.kind} {a.text}, {b.kind} {b.text}, {vector(len(order), 'i32')} <{mask}>"
        )

    # ------------------------------------------------------------ memory

    def pointer(self, address: Value) -> Value:
        return self.turned("inttoptr", address, "ptr")

    def load(self, kind: str, pointer: Value, align: int = 0, more: str = "") -> Value:
        return self.value(kind, f"load {kind}, ptr {pointer.text}{f', align {align}' if align else ''}{more}")

    def store(self, value: Value, pointer: Value, align: int = 0, more: str = "") -> None:
        aligned = f", align {align}" if align else ""
        self.lines.append(f"store {value.kind} {value.text}, ptr {pointer.text}{aligned}{more}")

    def place(self, kind: str) -> Value:
        """Memory of the function's own for a value."""
        name = self.fresh()
        self.places.append(f"{name} = alloca {kind}")
        return Value("ptr", name)

    # ------------------------------------------------------------ where it goes on

    def label(self) -> str:
        self._count += 1
        return f"b{self._count}"

    def begin(self, label: str) -> None:
        """The instructions that follow are at a label."""
        self.lines.append(f"{label}:")
        self.block = label

    def go(self, label: str) -> None:
        self.lines.append(f"br label %{label}")

    def choose(self, condition: Value, then: str, otherwise: str) -> None:
        self.lines.append(f"br i1 {condition.text}, label %{then}, label %{otherwise}")

    @contextmanager
    def loop(self, start: Value, stop: Value, step: int) -> Iterator[Value]:
        """What is written inside is done for each number of a range."""
        before, check, inside, after = self.block, self.label(), self.label(), self.label()
        self.go(check)
        self.begin(check)
        at = len(self.lines)
        self.lines.append("")  # what comes back is known at the end
        index, following = self.fresh(), self.fresh()
        self.choose(self.compared("slt", Value(WORD, index), stop), inside, after)
        self.begin(inside)
        yield Value(WORD, index)
        self.lines.append(f"{following} = add nsw i64 {index}, {step}")
        self.lines[at] = f"{index} = phi i64 [ {start.text}, %{before} ], [ {following}, %{self.block} ]"
        self.go(check)
        self.begin(after)


def scalar(letter: str) -> str:
    """The kind of number that programs call ``F`` or ``D``."""
    return _FLOATS[letter]
