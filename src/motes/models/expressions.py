"""Models as text: ``oren_nayar + torrance_sparrow(fresnel=dielectric(n=1.5))``.

A name stands for a model with all parameters free; a value given in brackets fixes that parameter; options are given as
words.  The text is parsed, never executed."""

from __future__ import annotations

import ast
import warnings
from dataclasses import fields
from typing import Any, NamedTuple

from motes.errors import ParameterError
from motes.models.base import BRDF
from motes.models.dust import Dust, DustLayer
from motes.models.fresnel import Conductor, Dielectric, Schlick
from motes.models.lambert import Lambert
from motes.models.oren_nayar import OrenNayar
from motes.models.sums import Sum
from motes.models.torrance_sparrow import TorranceSparrow
from motes.parameters import Parametrised

MODELS: dict[str, type[Parametrised]] = {
    "lambert": Lambert,
    "oren_nayar": OrenNayar,
    "torrance_sparrow": TorranceSparrow,
    "dust": Dust,
    "dust_layer": DustLayer,
}
FRESNEL: dict[str, type[Parametrised]] = {"dielectric": Dielectric, "conductor": Conductor, "schlick": Schlick}
_NAMES = {cls: name for name, cls in (MODELS | FRESNEL).items()}
_EXAMPLE = (
    "Write for example 'oren_nayar + torrance_sparrow', or 'dust_layer(oren_nayar)'; the models are "
    + ", ".join(MODELS)
)
_MOST_PARTS = 64


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
        with warnings.catch_warnings():  # about odd escapes and numbers, which are refused below
            warnings.simplefilter("ignore")
            tree = ast.parse(text.strip(), mode="eval").body
        if sum(isinstance(node, ast.Name) for node in ast.walk(tree)) > _MOST_PARTS:
            raise ParameterError(f"model {shown} has more than {_MOST_PARTS} parts", _EXAMPLE)
        model = _build(tree, (), fixed)
    except ParameterError:
        raise
    except (
        SyntaxError,
        ValueError,
        MemoryError,
        RecursionError,
    ):  # ValueError: a NUL, or a number of thousands of digits
        raise ParameterError(f"model {shown} is not a sum of models", _EXAMPLE) from None
    if not isinstance(model, BRDF):
        raise ParameterError(f"model {shown} is a Fresnel term, not a BRDF", "Use it as torrance_sparrow(fresnel=...)")
    return Parsed(model, frozenset(slot.name for slot in model.slots() if slot.path in fixed))


def _quoted(node: ast.AST) -> str:
    """The part of the text that `node` stands for, of bounded length."""
    text = ast.unparse(node)
    return repr(text if len(text) <= 80 else f"{text[:77]}...")


def _build(node: ast.AST, path: tuple[str, ...], fixed: set[tuple[str, ...]]) -> Any:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return Sum(_build(node.left, (*path, "a"), fixed), _build(node.right, (*path, "b"), fixed))
    call = node.func if isinstance(node, ast.Call) else node
    if not isinstance(call, ast.Name) or call.id not in MODELS | FRESNEL:
        raise ParameterError(f"{_quoted(node)} is not a model", _EXAMPLE)
    cls = (MODELS | FRESNEL)[call.id]
    known = {f.name: f for f in fields(cls)}
    positional = [name for name in known if name in ("base", "dust")]
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
    if cls is DustLayer and "base" not in given:
        raise ParameterError("dust_layer has no base", "Write dust_layer(oren_nayar), say")
    return cls(**given)


def _value(node: ast.AST, declared: Any, path: tuple[str, ...], fixed: set[tuple[str, ...]]) -> Any:
    if "parameter" in declared.metadata:
        try:
            value = ast.literal_eval(node)
        except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
            raise ParameterError(f"{declared.name} = {_quoted(node)} is not a number or a list of numbers") from None
        fixed.add(path)
        return value
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.Name) and node.id not in MODELS | FRESNEL:
        return node.id  # an option as a bare word: normalization=facets
    return _build(node, path, fixed)


def describe(model: Parametrised, *, values: bool = False) -> str:
    """The text that `parse` turns back into `model`: without values for its form alone, with values for all of it."""
    if isinstance(model, Sum):
        a, b = describe(model.a, values=values), describe(model.b, values=values)
        return f"{a} + ({b})" if isinstance(model.b, Sum) else f"{a} + {b}"
    parts = []
    for f in fields(model):
        value = getattr(model, f.name)
        if isinstance(value, Parametrised):
            text = describe(value, values=values)
            if not values and isinstance(f.default, Parametrised) and text == describe(f.default):
                continue  # `parse` puts it there
            parts.append(text if f.name in ("base", "dust") else f"{f.name}={text}")
        elif "parameter" in f.metadata:
            if values:
                parts.append(f"{f.name}={value.tolist() if hasattr(value, 'tolist') else value}")
        elif value != f.default:
            parts.append(f"{f.name}={value}")
    return _NAMES[type(model)] + (f"({', '.join(parts)})" if parts else "")
