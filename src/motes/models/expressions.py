"""Models as text: ``oren_nayar + torrance_sparrow(fresnel=dielectric(n=1.5))``.

A name stands for a model with all parameters free; a value given in brackets fixes that parameter; options are given as
words.  The text is parsed, never executed."""

from __future__ import annotations

import ast
import difflib
from collections.abc import Iterable
from dataclasses import Field, fields
from typing import Any, NamedTuple

from motes.errors import ParameterError
from motes.models.base import BRDF, Sum
from motes.models.naming import name_of, registered
from motes.parameters import Parametrised, PartField
from motes.quiet import without_warnings

_MOST_PARTS = 64


def _example(word: str = "", known: Iterable[str] = ()) -> str:
    """What to write, with the models there are; before it, what of the known words was probably meant."""
    close = difflib.get_close_matches(word.lower(), [*known], n=1, cutoff=0.6)
    return (f"Did you mean {close[0]}? " if close else "") + (
        "Write for example 'oren_nayar + torrance_sparrow', or 'dust_layer(oren_nayar)'; the models are "
        + ", ".join(registered(BRDF))
    )


class Parsed(NamedTuple):
    """A model and the names (see `Parametrised.slots`) of the parameters whose values the text fixes."""

    model: BRDF
    fixed: frozenset[str]


def parse(text: str) -> Parsed:
    """The model that `text` names.

    Raises
    ------
    ParameterError
        When the text is not a sum of models, or names something that is not there.

    Examples
    --------
    >>> parse("oren_nayar(sigma_d=0.3) + torrance_sparrow").fixed
    frozenset({'sigma_d'})
    """
    shown = repr(text if len(text) <= 200 else f"{text[:197]}...")
    fixed: set[tuple[str, ...]] = set()
    try:
        with without_warnings():  # about odd escapes and numbers, which are refused below
            tree = ast.parse(text.strip(), mode="eval").body
        if sum(isinstance(node, ast.Name) for node in ast.walk(tree)) > _MOST_PARTS:
            raise ParameterError(f"model {shown} has more than {_MOST_PARTS} parts", _example())
        model = _build(tree, (), fixed)
    except ParameterError:
        raise
    except (
        SyntaxError,
        ValueError,
        MemoryError,
        RecursionError,
    ):  # ValueError: a NUL, or a number of thousands of digits
        raise ParameterError(f"model {shown} is not a sum of models", _example()) from None
    if not isinstance(model, BRDF):
        raise ParameterError(f"model {shown} is a Fresnel term, not a BRDF", _as_part_of(type(model)))
    return Parsed(model, frozenset(slot.name for slot in model.slots() if slot.path in fixed))


def _as_part_of(cls: type[Parametrised]) -> str:
    """A model that takes such a part, in a sentence."""
    for name, model in registered(BRDF).items():
        for place in model.declared_parts():
            if issubclass(cls, place.accepts):
                return f"Use it as {name}({place.name}=...)"
    return _example()


def _positional(cls: type[Parametrised]) -> list[PartField]:
    """The parts that need no name in a text: the BRDFs that a model is made of."""
    return [p for p in cls.declared_parts() if issubclass(p.accepts, BRDF)]


def _quoted(node: ast.AST) -> str:
    """The part of the text that `node` stands for, of bounded length."""
    text = ast.unparse(node)
    return repr(text if len(text) <= 80 else f"{text[:77]}...")


def _build(node: ast.AST, path: tuple[str, ...], fixed: set[tuple[str, ...]]) -> Any:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return Sum(_build(node.left, (*path, "a"), fixed), _build(node.right, (*path, "b"), fixed))
    call = node.func if isinstance(node, ast.Call) else node
    classes = registered(Parametrised, unlisted=True)
    if not isinstance(call, ast.Name) or call.id not in classes:
        word = call.id if isinstance(call, ast.Name) else ""
        raise ParameterError(f"{_quoted(node)} is not a model", _example(word, classes))
    cls = classes[call.id]
    known = {f.name: f for f in fields(cls)}
    positional = [p.name for p in _positional(cls)]
    given: dict[str, Any] = {}
    if isinstance(node, ast.Call):
        if len(node.args) > len(positional):
            raise ParameterError(
                f"{_quoted(node)} has a value without a name", f"Write {call.id}({next(iter(known))}=...)"
            )
        arguments = list(zip(positional, node.args, strict=False)) + [(k.arg or "**", k.value) for k in node.keywords]
        for name, value in arguments:
            if name not in known or name in given:
                raise ParameterError(
                    f"{call.id} has no parameter {name[:80]!r} (or it is given twice)", f"It has {', '.join(known)}"
                )
            given[name] = _value(value, known[name], (*path, name), fixed)
    missing = next((p.name for p in cls.declared_parts() if p.required and p.name not in given), None)
    if missing:
        raise ParameterError(f"{call.id} has no {missing}", f"Write {call.id}(oren_nayar), say")
    return cls(**given)


def _value(node: ast.AST, declared: Field[Any], path: tuple[str, ...], fixed: set[tuple[str, ...]]) -> Any:
    if "parameter" in declared.metadata:
        try:
            value = ast.literal_eval(node)
        except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
            raise ParameterError(
                f"{declared.name} = {_quoted(node)} is not a number or a list of numbers",
                f"Write {declared.name}=0.3, or {declared.name}=[0.7, 0.6, 0.5]",
            ) from None
        fixed.add(path)
        return value
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.Name) and ("option" in declared.metadata or node.id not in registered(Parametrised)):
        return node.id  # an option as a bare word: normalization=facets
    return _build(node, path, fixed)


def describe(model: Parametrised, *, values: bool = False) -> str:
    """The text that `parse` turns back into `model`: without values for its form alone, with values for all of it."""
    if isinstance(model, Sum):
        a, b = describe(model.a, values=values), describe(model.b, values=values)
        return f"{a} + ({b})" if isinstance(model.b, Sum) else f"{a} + {b}"
    parts: list[str] = []
    unnamed, positional = 0, [p.name for p in _positional(type(model))]
    for f in fields(model):
        value = getattr(model, f.name)
        if isinstance(value, Parametrised):
            text = describe(value, values=values)
            if not values and isinstance(f.default, Parametrised) and text == describe(f.default):
                continue  # `parse` puts it there
            # Without its name as long as all before it are.
            bare = len(parts) == unnamed and positional[unnamed : unnamed + 1] == [f.name]
            unnamed += bare
            parts.append(text if bare else f"{f.name}={text}")
        elif "parameter" in f.metadata:
            if values:
                parts.append(f"{f.name}={value.tolist() if hasattr(value, 'tolist') else value}")
        elif value != f.default:
            parts.append(f"{f.name}={value}")
    return name_of(type(model)) + (f"({', '.join(parts)})" if parts else "")
