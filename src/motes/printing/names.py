"""Names and comments for what a trace computes, taken from the source that computed it.

While a model is traced, every function of `motes.equations`, every property of `motes.directions.Geometry` and every ``formula`` of a
model that returns is seen: the symbol it returns gets its name and its docstring, the symbols in its local variables get theirs.  So
a shader calls things what the equations call them, and nobody keeps a list.
"""

from __future__ import annotations

import ast
import inspect
import re
import sys
import textwrap
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from types import CodeType, FrameType
from typing import Any

from motes import directions, equations
from motes.graph import tracing
from motes.graph.tracing import Symbol, Trace
from motes.parameters import Parametrised

# What wins where one symbol has several names, and what is worth a comment.
_LOCAL, _HELPER, _MODEL, _EQUATION, _PROPERTY = range(5)
_SOURCES = (equations.__name__, directions.__name__)


@dataclass(frozen=True)
class Name:
    """What the source calls a symbol.

    Attributes
    ----------
    text
        The name: ``rho_d1``, ``tan_beta``, ``s2``.
    comment
        What the docstring says, a text a paragraph: ``Equation (4).``; empty for local variables.
    formula
        For equations, what the function returns, as it is written: ``1 - 0.5 * (s2 / (s2 + 0.33))``.
    equation
        True for what a function of `motes.equations` returns.
    """

    text: str
    comment: tuple[str, ...] = ()
    formula: str = ""
    equation: bool = False


@dataclass(frozen=True)
class Recording:
    """A trace, and the names of its symbols."""

    trace: Trace
    names: dict[Symbol, Name]


def record(model: Parametrised) -> Recording:
    """Trace a model with one symbol for all channels of a parameter, and note what its source calls things.

    A printer gives the parameters their types: a colour, a number, the entry of an array.
    """
    with _listening() as found:
        trace = tracing.trace(model, 1)
    given = {*trace.directions, *(p.symbol for p in trace.parameters)}
    return Recording(
        trace, {symbol: name for symbol, (_, name) in found.items() if symbol not in given and symbol.op != "constant"}
    )


@contextmanager
def _listening() -> Iterator[dict[Symbol, tuple[int, Name]]]:
    """Notes names, with their ranks, of what is computed in the block (in this thread)."""
    found: dict[Symbol, tuple[int, Name]] = {}

    def note(symbol: Any, rank: int, name: Name) -> None:
        if isinstance(symbol, Symbol) and (symbol not in found or found[symbol][0] < rank):
            found[symbol] = (rank, name)

    def listen(frame: FrameType, event: str, value: object) -> None:
        if event != "return":
            return
        code, module = frame.f_code, str(frame.f_globals.get("__name__"))
        owner = frame.f_locals.get("self")
        if module not in _SOURCES and not (isinstance(owner, Parametrised) and code.co_name == "formula"):
            return
        if code.co_name == "above_horizon":  # the result itself
            return
        if not code.co_name.isidentifier():  # <lambda>, <genexpr>: what they give is named by whoever keeps it
            return
        arguments = code.co_varnames[: code.co_argcount]
        for variable, symbol in frame.f_locals.items():
            if variable not in arguments:
                note(symbol, _LOCAL, Name(variable))
        if isinstance(owner, Parametrised):
            note(value, _MODEL, Name(_snake_case(type(owner).__name__), _said(type(owner))[:1]))
        elif isinstance(owner, directions.Geometry):
            attribute = inspect.getattr_static(directions.Geometry, code.co_name)
            note(value, _PROPERTY, Name(code.co_name.strip("_"), _said(getattr(attribute, "func", attribute))))
        elif module == equations.__name__:
            function = getattr(equations, code.co_name, None)
            note(value, _EQUATION, Name(code.co_name, _said(function), _returned(code), True))
        else:
            note(value, _HELPER, Name(code.co_name))

    before = sys.getprofile()
    sys.setprofile(listen)
    try:
        yield found
    finally:
        sys.setprofile(before)


def _snake_case(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def _said(documented: object) -> tuple[str, ...]:
    """The paragraphs of a docstring, each on one line, without the marks of markup."""
    paragraphs = inspect.cleandoc(getattr(documented, "__doc__", None) or "").split("\n\n")
    return tuple(" ".join(paragraph.split()).replace("`", "") for paragraph in paragraphs if paragraph.strip())


@cache
def _returned(code: CodeType) -> str:
    """What a function returns, as it is written there; empty where the source is not at hand."""
    try:
        tree = ast.parse(textwrap.dedent(inspect.getsource(code)))
    except (OSError, TypeError, SyntaxError):
        return ""
    returns = [node.value for node in ast.walk(tree) if isinstance(node, ast.Return) and node.value is not None]
    return ast.unparse(returns[-1]).replace("xp.", "") if returns else ""
