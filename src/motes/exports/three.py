"""A three.js material: an ES module with the GLSL, its uniforms and a ShaderMaterial that answers to the lights of a scene."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from motes.exports import glsl
from motes.exports.shaders import heading, plain, prepare
from motes.exports.subject import Subject, as_rgb
from motes.files import write_text
from motes.printing.language import comment

SUFFIX = ".js"
_MODULE = Path(__file__).with_name("three_material.js")


def limits(subject: Subject) -> list[str]:
    """What the module cannot say."""
    return [
        "Directional, point and spot lights see the BRDF itself; ambient light and hemispheres see its spherical albedo."
    ]


def module(subject: Subject) -> str:
    """The text of the module.

    Exports ``parameters`` (name, uniform, value, range, unit, meaning), ``formula`` (the GLSL), ``createMaterial(values)`` and
    ``setParameter(material, name, value)``.
    """
    subject.colored("a three.js material")
    prepared = prepare(subject.brdf)
    shader = glsl.shader(subject.brdf, title=subject.name)
    parameters = [
        {
            "name": uniform.slot,
            "uniform": uniform.name,
            "value": uniform.value,
            "min": _finite(uniform.parameter.bounds[0]),
            "max": _finite(uniform.parameter.bounds[1]),
            "typical": list(uniform.parameter.typical),
            "unit": uniform.parameter.unit,
            "symbol": uniform.parameter.symbol,
            "meaning": uniform.parameter.doc,
        }
        for uniform in shader.uniforms
    ]
    albedo = [round(float(x), 6) for x in as_rgb(subject.brdf.spherical_albedo())]
    lines = heading(prepared, subject.name, "A three.js material", (*subject.notes, *limits(subject)))
    lines += ["", f"export const name = {_script(plain(subject.name))};", ""]
    lines += comment("What a slider needs to know of each parameter; a list of three is a colour, linear.")
    lines += [f"export const parameters = {_script(parameters, indent=2)};", ""]
    lines += comment("The share of uniform light from all sides that is reflected, with the parameters above.")
    lines += [f"export const albedo = {_script(albedo)};", ""]
    lines += ["export const formula = /* glsl */ `" + _template(shader.source) + "`;", ""]
    return "\n".join(lines) + "\n" + _MODULE.read_text(encoding="utf-8")


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the module."""
    return [write_text(path, module(subject))]


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _script(value: object, indent: int | None = None) -> str:
    """JSON that is also safe inside a page's script element."""
    return json.dumps(value, indent=indent, allow_nan=False).replace("<", "\\u003c")


def _template(text: str) -> str:
    """A text inside a template literal."""
    return text.replace("\\", "\\\\").replace("`", "\\`").replace("${", "\\${").replace("</", "<\\/")
