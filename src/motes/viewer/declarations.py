"""The TypeScript of what Python declares: models with their parameters and options, and the types of `motes.viewer.contract`.

``tools/viewer_build.py`` writes it to ``viewer/src/generated.ts``; a test compares the file with what this says now.
"""

from __future__ import annotations

import json
import typing
from dataclasses import fields
from types import NoneType, UnionType
from typing import Any

import numpy as np

from motes import material
from motes.models import BRDF, Fresnel, Lambert, registered
from motes.models.naming import name_of
from motes.parameters import Parameter, Parametrised, PartField
from motes.viewer import contract

_GREEK = {"\\sigma": "σ", "\\tau": "τ"}
_HEAD = """// Written by tools/viewer_build.py from what Python declares: do not edit.

export interface ParameterDeclaration {
  kind: 'parameter';
  name: string;
  symbol: string;
  unit: string;
  meaning: string;
  value: number;
  low: number;
  high: number | null;
  open: boolean;
  typical: readonly [number, number];
  perChannel: boolean;
  role: string | null;
  advice: string;
}

export interface OptionDeclaration {
  kind: 'option';
  name: string;
  value: string;
  words: readonly string[];
}

export interface ChildDeclaration {
  kind: 'child';
  name: string;
  /** Any model ('brdf'), any Fresnel term ('fresnel'), or the model of that name. */
  accepts: string;
  place: 'term' | 'base' | 'cover' | 'fresnel';
  required: boolean;
  value: string | null;
}

export type FieldDeclaration = ParameterDeclaration | OptionDeclaration | ChildDeclaration;

export interface ModelDeclaration {
  brdf: boolean;
  summary: string;
  fields: readonly FieldDeclaration[];
}
"""


def typescript() -> str:
    """The text of ``viewer/src/generated.ts``."""
    lines = [_HEAD]
    lines += [f"export const MATERIAL_FORMAT = {json.dumps(material.Material(Lambert()).to_dict()['format'])};"]
    lines += [f"export const MATERIAL_VERSION = {material.VERSION};"]
    lines += [f"export const LARGEST_MATERIAL = {material.LARGEST_FILE};"]
    lines += [f"export const SHARES = {contract.SHARES};"]
    lines += [f"export const PAYLOAD_VERSION = {contract.VERSION};", ""]
    lines += ["/** Those of Motes itself; a page brings the others that it needs. */"]
    lines += ["export const MODELS: Record<string, ModelDeclaration> = "]
    lines[-1] += json.dumps(declared(own=True), indent=2, ensure_ascii=False, allow_nan=False) + ";"
    for cls in vars(contract).values():
        if isinstance(cls, type) and hasattr(cls, "__total__"):
            lines += ["", *_interface(cls)]
    return "\n".join(lines) + "\n"


def declared(*, own: bool) -> dict[str, Any]:
    """The declarations of all registered models and Fresnel terms by name: Motes' own, or all others."""
    classes: dict[str, type[Parametrised]] = {**registered(BRDF), **registered(Fresnel)}
    return {name: _model(cls) for name, cls in classes.items() if cls.__module__.startswith("motes.") is own}


def plain_symbol(tex: str) -> str:
    r"""``\sigma_s`` as ``σ_s``: what a page shows, with what follows the underscore set lower."""
    for name, letter in _GREEK.items():
        tex = tex.replace(name, letter)
    return tex


def _model(cls: type[Parametrised]) -> dict[str, Any]:
    parameters = {p.name: p for p in cls.declared()}
    options = {o.name: o for o in cls.declared_options()}
    parts = {p.name: p for p in cls.declared_parts()}
    listed: list[dict[str, Any]] = []
    for f in fields(cls):
        if f.name in parameters:
            listed.append(_parameter(parameters[f.name]))
        elif f.name in options:
            option = options[f.name]
            listed.append({"kind": "option", "name": f.name, "value": option.default, "words": list(option.words)})
        else:
            listed.append(_child(parts[f.name]))
    summary = (cls.__doc__ or "").strip().split("\n")[0]
    return {"brdf": issubclass(cls, BRDF), "summary": summary, "fields": listed}


def _child(part: PartField) -> dict[str, Any]:
    """A part: what it accepts is a model by name, or any of a kind."""
    kinds: dict[type, str] = {BRDF: "brdf", Fresnel: "fresnel"}
    accepts = kinds.get(part.accepts) or name_of(part.accepts)
    default = None if part.default is None else name_of(type(part.default))
    said = {"accepts": accepts, "place": part.place.name.lower(), "required": part.required, "value": default}
    return {"kind": "child", "name": part.name, **said}


def range_view(p: Parameter) -> contract.RangeView:
    """Where a parameter's values lie, as JSON says it."""
    low, high = p.bounds
    return {"low": low, "high": high if np.isfinite(high) else None, "open": p.open}


def _parameter(p: Parameter) -> dict[str, Any]:
    return {
        "kind": "parameter",
        "name": p.name,
        "symbol": plain_symbol(p.symbol),
        "unit": p.unit,
        "meaning": p.doc,
        "value": p.default,
        **range_view(p),
        "typical": list(p.typical),
        "perChannel": p.per_channel,
        "role": p.role.name.lower() if p.role else None,
        "advice": p.advice,
    }


def _interface(cls: type) -> list[str]:
    text = " ".join((cls.__doc__ or "").split())
    hints = typing.get_type_hints(cls)
    return [
        f"/** {text} */",
        f"export interface {cls.__name__} {{",
        *(f"  {name}: {_type(hint)};" for name, hint in hints.items()),
        "}",
    ]


def _type(hint: Any) -> str:
    """A Python annotation as TypeScript; what it does not know is an error rather than `any`."""
    if hint is Any:
        return "unknown"
    if hint in (str, bool, int, float, NoneType):
        return {str: "string", bool: "boolean", int: "number", float: "number", NoneType: "null"}[hint]
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is list:
        inner = _type(arguments[0])
        return f"({inner})[]" if "|" in inner else f"{inner}[]"
    if origin is tuple:
        return f"[{', '.join(map(_type, arguments))}]"
    if origin is dict:
        return f"Record<{_type(arguments[0])}, {_type(arguments[1])}>"
    if origin is typing.Literal:
        return " | ".join(f"'{word}'" for word in arguments)
    if origin in (UnionType, typing.Union):
        return " | ".join(map(_type, arguments))
    if isinstance(hint, type) and hasattr(hint, "__total__"):
        return hint.__name__
    raise TypeError(f"{hint} has no TypeScript here")
