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
from motes.models import Lambert
from motes.models.dust import FORMS, Dust
from motes.models.expressions import FRESNEL, MODELS
from motes.models.fresnel import Fresnel
from motes.models.torrance_sparrow import NORMALIZATIONS
from motes.parameters import Parameter, Parametrised
from motes.viewer import contract

_GREEK = {"\\sigma": "σ", "\\tau": "τ"}
#: The words that an option accepts; a test checks that the models have no other options.
OPTIONS: dict[tuple[str, str], tuple[str, ...]] = {
    ("torrance_sparrow", "normalization"): NORMALIZATIONS,
    ("dust", "form"): FORMS,
}
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
  accepts: 'brdf' | 'dust' | 'fresnel';
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
    models = {name: _model(name, cls) for name, cls in (MODELS | FRESNEL).items()}
    lines = [_HEAD]
    lines += [f"export const MATERIAL_FORMAT = {json.dumps(material.Material(Lambert()).to_dict()['format'])};"]
    lines += [f"export const MATERIAL_VERSION = {material.VERSION};"]
    lines += [f"export const LARGEST_MATERIAL = {material.LARGEST_FILE};"]
    lines += [f"export const PAYLOAD_VERSION = {contract.VERSION};", ""]
    lines += ["export const MODELS: Readonly<Record<string, ModelDeclaration>> = "]
    lines[-1] += json.dumps(models, indent=2, ensure_ascii=False, allow_nan=False) + ";"
    for cls in vars(contract).values():
        if isinstance(cls, type) and hasattr(cls, "__total__"):
            lines += ["", *_interface(cls)]
    return "\n".join(lines) + "\n"


def plain_symbol(tex: str) -> str:
    r"""``\sigma_s`` as ``σ_s``: what a page shows, with what follows the underscore set lower."""
    for name, letter in _GREEK.items():
        tex = tex.replace(name, letter)
    return tex


def _model(name: str, cls: type[Parametrised]) -> dict[str, Any]:
    declared = {p.name: p for p in cls.declared()}
    listed: list[dict[str, Any]] = []
    for f in fields(cls):
        if f.name in declared:
            listed.append(_parameter(declared[f.name]))
        elif (name, f.name) in OPTIONS:
            listed.append({"kind": "option", "name": f.name, "value": f.default, "words": list(OPTIONS[name, f.name])})
        else:
            accepts = {"base": "brdf", "dust": "dust", "fresnel": "fresnel"}[f.name]
            default = "dust" if isinstance(f.default, Dust) else None
            listed.append({"kind": "child", "name": f.name, "accepts": accepts, "value": default})
    summary = (cls.__doc__ or "").strip().split("\n")[0]
    return {"brdf": not issubclass(cls, Fresnel), "summary": summary, "fields": listed}


def _parameter(p: Parameter) -> dict[str, Any]:
    low, high = p.bounds
    return {
        "kind": "parameter",
        "name": p.name,
        "symbol": plain_symbol(p.symbol),
        "unit": p.unit,
        "meaning": p.doc,
        "value": p.default,
        "low": low,
        "high": high if np.isfinite(high) else None,
        "open": p.open,
        "typical": list(p.typical),
        "perChannel": p.per_channel,
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
    if hint in (str, int, float, NoneType):
        return {str: "string", int: "number", float: "number", NoneType: "null"}[hint]
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
