"""The nearest standard lobes of a model, for programs that take lobes and not formulas: closures, MaterialX nodes, stock BSDFs.

Each model declares its own (`motes.models.BRDF.standard_lobes`), as arithmetic on its parameters, and a sentence on what is lost.
Here that arithmetic is computed with the numbers of a model, or recorded and printed in the words of a shading language;
`motes.exports.materialx_graph` makes nodes of it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY
from motes.errors import ParameterError
from motes.graph.dependence import live
from motes.graph.symbols import Graph, Symbol
from motes.models import BRDF, Reflection, StandardLobe
from motes.models.lifting import unchecked
from motes.models.standard import DIFFUSIVITY, MEAN_COSINE

#: What the cosine towards the viewer is called where a program tells it.
COS_VIEW = "cos_view"

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Numbers:
    """A standard lobe as numbers: reflectance (C,) at normal and at grazing incidence, and roughness; see `StandardLobe`."""

    reflection: Reflection
    normal: Floats
    grazing: Floats
    roughness: float
    distribution: str = ""
    index: tuple[Floats, Floats] | None = None
    regained: bool = False


def lobes(model: BRDF) -> list[Numbers]:
    """The standard lobes whose sum is nearest to `model`, with its values."""

    def numbers(lobe: StandardLobe) -> Numbers:
        tint = np.asarray(lobe.tint or 1.0)
        grazing = np.broadcast_to(np.asarray(lobe.reflectance, np.float64) * tint, (model.channels,))
        normal = grazing * np.asarray(lobe.normal, np.float64)
        index = None
        if lobe.index is not None:
            n, k = (np.broadcast_to(np.asarray(x, np.float64), (model.channels,)) for x in lobe.index)
            index = n, k
        roughness = float(np.ravel(lobe.roughness)[0])
        return Numbers(lobe.reflection, normal, grazing.copy(), roughness, lobe.distribution, index, lobe.regained)

    return [numbers(lobe) for lobe in model.standard_lobes(NUMPY, model, MEAN_COSINE)]


def recorded(model: BRDF, *, view: bool = False) -> list[StandardLobe]:
    """The standard lobes as symbols, whose leaves are named as the slots of `model`.

    Parameters
    ----------
    model
        Options, and numbers that no parameter of the lobes can say, are its own.
    view
        Whether the program tells the direction to the viewer: a leaf `COS_VIEW` then stands for its cosine.
    """
    graph = Graph()
    symbols = unchecked(model, {slot.path: graph.leaf(slot.name) for slot in model.slots()})
    cosine = graph.leaf(COS_VIEW) if view else graph.constant(MEAN_COSINE)
    found = model.standard_lobes(graph, symbols, cosine)
    return [
        replace(
            lobe,
            reflectance=graph.lift(lobe.reflectance),
            normal=graph.lift(lobe.normal),
            roughness=graph.lift(lobe.roughness),
        )
        for lobe in found
    ]


def losses(model: BRDF) -> list[str]:
    """What the lobes do not say, a sentence a kind of model."""
    sentences = (part.approximation for part in model.walk() if isinstance(part, BRDF))
    return list(dict.fromkeys(sentence for sentence in sentences if sentence))


@dataclass(frozen=True)
class Words:
    """A standard lobe in the words of a shading language; `grazing` and `normal`, a share of it, are colours."""

    reflection: Reflection
    grazing: str
    normal: str
    roughness: str


def written(model: BRDF, split: Collection[str], color: str) -> tuple[list[str], list[Words]]:
    """The standard lobes in the words of C-like shading languages, where ``wo`` is the direction to the viewer.

    Parameters
    ----------
    split
        Names of the slots that are colours there.
    color
        The type of a colour, which also converts a number to one: ``vec3``.

    Returns
    -------
    statements, lobes
        Those declare what the lobes use more than once.
    """
    found = recorded(model, view=True)
    outputs = [x for lobe in found for x in (lobe.reflectance, lobe.normal, lobe.roughness)]
    order = live(outputs)
    uses = Counter([a for symbol in order for a in symbol.args] + outputs)
    texts: dict[Symbol, str] = {}
    colored: set[Symbol] = set()
    statements: list[str] = []
    for symbol in order:
        if (symbol.value in split and symbol.op == "leaf") or any(a in colored for a in symbol.args):
            colored.add(symbol)
        text = _text(symbol, [texts[a] for a in symbol.args])
        if symbol.args and uses[symbol] > 1:
            name = f"shared_{len(statements) + 1}"
            statements.append(f"{color if symbol in colored else 'float'} {name} = {text};")
            text = name
        texts[symbol] = text
    if any(symbol.op == "leaf" and symbol.value == COS_VIEW for symbol in order):
        told = f"// Along the view exactly; along the light the mean of 1/cos is {DIFFUSIVITY}."
        statements = [told, f"float {COS_VIEW} = max(wo[2], 0.01);", *statements]

    def tinted(lobe: StandardLobe) -> str:
        text = texts[lobe.reflectance]
        tint = lobe.tint * 3 if len(lobe.tint) == 1 else lobe.tint
        return f"{color}({text})" + (f" * {color}({', '.join(map(repr, tint))})" if tint else "")

    return statements, [
        Words(lobe.reflection, tinted(lobe), f"{color}({texts[lobe.normal]})", texts[lobe.roughness]) for lobe in found
    ]


_TEXTS: dict[str, Callable[..., str]] = {
    "add": "({} + {})".format,
    "sub": "({} - {})".format,
    "mul": "({} * {})".format,
    "div": "({} / {})".format,
    "neg": "(-{})".format,
    "exp": "exp({})".format,
    "expm1": "(exp({}) - 1.0)".format,
    "sqrt": "sqrt({})".format,
    "maximum": "max({}, {})".format,
    "minimum": "min({}, {})".format,
    "lt": "({} < {})".format,
    "where": "select({2}, {1}, {0})".format,  # OSL's: the first where the last is 0
}


def _text(symbol: Symbol, args: list[str]) -> str:
    if symbol.op == "leaf":
        return str(symbol.value)
    if symbol.op == "constant":
        return repr(float(symbol.value)) if symbol.value >= 0 else f"({float(symbol.value)!r})"
    return _TEXTS[supported(symbol)](*args)


def supported(symbol: Symbol) -> str:
    """The operation of a symbol; raises `ParameterError` for one that standard lobes cannot be made of."""
    if symbol.op not in _TEXTS:
        raise ParameterError(
            f"a standard lobe is computed by {symbol.op}, which has no words here",
            f"BRDF.standard_lobes may use {', '.join(_TEXTS)}",
        )
    return symbol.op


__all__ = ["COS_VIEW", "Numbers", "Words", "lobes", "losses", "recorded", "supported", "written"]
