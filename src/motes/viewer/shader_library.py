"""Printed shaders of the single models, from which the page puts together the shader of a material that is dropped onto it.

Nothing is typed a second time: each piece is a model of three channels as `motes.exports.glsl` prints it.  A layer of dust over any base f is the printed
layer over a Lambertian base, whose value is K_d/pi: with K_d = pi f.
"""

from __future__ import annotations

import dataclasses
import itertools
import re
from functools import cache
from typing import Any

import numpy as np

from motes.arrays import NUMPY
from motes.errors import ParameterError
from motes.exports import glsl
from motes.exports.shaders import Shader, prepare
from motes.graph import tracing
from motes.graph.tracing import Symbol
from motes.models import BRDF, Fresnel, Lambert, registered
from motes.models.composition import layer_of
from motes.models.particles import MULTIPLE
from motes.parameters import Parametrised, Place
from motes.printing.shading import Stages
from motes.viewer.contract import SHARES, KeptTable, KeptView, ShaderView, UniformView
from motes.viewer.packing import packed

#: Operations of parameters alone from which a table of them pays.
LONG = 200


def in_stages(model: BRDF, title: str) -> ShaderView:
    """A printed shader for the page that computes once what many lights, and many viewers, share."""
    stages = glsl.in_stages(model)
    printed = shader_view(glsl.shader(model, title=title, stages=stages))
    if stages is None:
        return printed
    kept = [KeptView(name=name, type=type_) for name, type_ in stages.kept.items()] if stages.work >= LONG else []
    return {**printed, "stages": True, "kept": kept, "table": _table(model, stages) if kept else None}


def _table(model: BRDF, stages: Stages) -> KeptTable:
    """What the first stage computes at a model's own values, where its layer's thickness is that times each share: compiling it takes a browser longer."""
    prepared = prepare(model)
    layer = layer_of(model)
    outer = layer.depth.name if layer else ""
    shares = (np.arange(SHARES) / (SHARES - 1)) ** 3
    leaves: dict[Symbol, Any] = {}
    values: dict[str, list[float]] = {}
    for p in stages.parameters:
        slot = next(slot for slot in prepared.slots if slot.name == p.slot)
        value = np.atleast_1d(np.asarray(prepared.value(slot), float))
        values[p.slot] = value.tolist()
        leaves[p.symbol] = value[None] * (shares[:, None] if p.slot == outer else 1.0)
    with np.errstate(all="ignore"):
        found = tracing.evaluate(NUMPY, stages.symbols, leaves)
    widths = [3 if type_ == "vec3" else 1 for type_ in stages.kept.values()]
    columns = [np.broadcast_to(np.asarray(x, float), (SHARES, n)) for x, n in zip(found, widths, strict=True)]
    return {"values": values, "data": packed(np.concatenate(columns, axis=1), "<f4")}


def shader_view(shader: Shader) -> ShaderView:
    """A printed shader for the page."""
    uniforms = [
        UniformView(name=u.name, slot=u.slot, size=len(u.value) if isinstance(u.value, tuple) else 1)
        for u in shader.uniforms
    ]
    return {
        "source": shader.source,
        "name": shader.name,
        "uniforms": uniforms,
        "channels": shader.channels,
        "stages": False,
        "kept": [],
        "table": None,
    }


def pieces() -> dict[str, BRDF]:
    """The models by the names under which the page looks for them: the model's name, and its options and Fresnel term where it has some.

    What facets pass on to each other is coloured by Schlick's curve at most: with the exact terms the pieces would take as much room as ten others.
    """
    models: dict[str, BRDF] = {}
    for name, cls in registered(BRDF).items():
        bases = {p.name: Lambert() for p in cls.declared_parts() if p.place is Place.BASE}
        choices: dict[str, list[tuple[str, Any]]]
        choices = {o.name: [(word, word) for word in o.words] for o in cls.declared_options()}
        choices |= {p.name: _terms(p.accepts) for p in cls.declared_parts() if p.place is Place.FRESNEL}
        options = [
            (f.name, choices[f.name]) for f in dataclasses.fields(cls) if f.name in choices
        ]  # as the page joins them
        # A layer is made of one thing here, in its first form: the page refuses others, as Motes does.
        for chosen in itertools.product(*(each for _, each in options)):
            words = [word for word, _ in chosen if word]
            given = {field: value for (field, _), (_, value) in zip(options, chosen, strict=True)}
            if MULTIPLE in words and any(isinstance(term, Fresnel) and term.index() for term in given.values()):
                continue
            try:
                model = cls(**bases, **given)
            except ParameterError:  # words that do not go together
                continue
            if all(_takes_any(model, base) for base in bases):
                models["_".join([name, *words])] = model
    return models


def _takes_any(model: BRDF, base: str) -> bool:
    """Whether a layer depends on what its base reflects from here to there alone, by a factor and a sum, so that pi f may stand for K_d.

    A layer that is lit by all that its base reflects does not: the page asks for a page of the material's own.
    """
    wi, wo = np.array([0.6, 0.0, 0.8]), np.array([-0.28, 0.0, 0.96])
    none, half, whole = (
        np.asarray(dataclasses.replace(model, **{base: Lambert(K_d)}).eval(wi, wo)) for K_d in (0.0, 0.5, 1.0)
    )
    return bool(np.allclose(none + whole, 2 * half, rtol=1e-9, atol=0))


def _terms(accepts: type[Parametrised]) -> list[tuple[str, Any]]:
    """None, and each registered Fresnel term, by name."""
    return [("", None), *((name, cls()) for name, cls in registered(accepts).items())]


def library() -> dict[str, ShaderView]:
    """Every piece, printed with three channels."""
    return {name: _printed(name, model) for name, model in pieces().items()}


@cache
def _printed(name: str, model: BRDF) -> ShaderView:
    printed = shader_view(glsl.shader(_colored(model), name=f"{name}_eval"))
    # Dozens of pieces travel in every page: without comments, indents and what calls them with uniforms of their own they take half the room.
    left_out = rf"^\s*//.*\n|[ \t]*//.*$|^[ \t]+|^uniform .*\n|^vec3 {name}_eval\(vec3 wi, vec3 wo\) \{{[^}}]*\}}\n"
    return {**printed, "source": re.sub(left_out, "", printed["source"], flags=re.MULTILINE)}


def _colored(model: BRDF) -> BRDF:
    """The model with a value for each of three channels wherever a parameter may have one."""
    return model.with_parameters(
        {slot.name: (float(slot.value),) * 3 for slot in model.slots() if slot.parameter.per_channel}
    )
