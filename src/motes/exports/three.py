"""A three.js material: an ES module with the formula in GLSL and WGSL, and a material that answers to the lights of a scene, for either renderer."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from motes.exports import glsl
from motes.exports.shaders import Prepared, heading, plain, prepare
from motes.exports.subject import Subject, as_rgb
from motes.files import write_text
from motes.printing.glsl import language as glsl_language
from motes.printing.language import Language, comment
from motes.printing.wgsl import LANGUAGE as WGSL

SUFFIX = ".js"
GLSL = glsl_language("300 es")
_MODULE = [Path(__file__).with_name(f"three_{part}.js") for part in ("material", "nodes")]


def limits(subject: Subject) -> list[str]:
    """What the module cannot say."""
    return [
        "Directional, point and spot lights see the BRDF itself; ambient light, hemispheres and, with WebGPURenderer, the environment see its spherical albedo."
    ]


def module(subject: Subject) -> str:
    """The text of the module.

    Exports ``parameters`` (name, uniform, value, range, unit, meaning), ``formula`` (the GLSL), ``createMaterial(THREE, values, options)`` and
    ``setParameter(material, name, value)``.  The material is for ``WebGLRenderer``, or for ``WebGPURenderer`` where ``THREE`` is ``three/webgpu``.
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
    pieces = {"glsl": _pieces(prepared, GLSL, "vec3"), "wgsl": _pieces(prepared, WGSL, "fn")}
    before, _, after = shader.source.partition("".join(pieces["glsl"]))
    for language, (helpers, evaluate) in pieces.items():
        lines += [f"const {language}Formula = {{", f"    helpers: {_template(helpers, language)},"]
        lines += [f"    evaluate: {_template(evaluate, language)},", "};"]
    whole = f"{_template(before, 'glsl')} + glslFormula.helpers + glslFormula.evaluate + {_template(after, 'glsl')}"
    lines += [f"export const formula = {whole};", ""]
    return "\n".join(lines) + "\n" + "".join(path.read_text(encoding="utf-8") for path in _MODULE)


def _pieces(prepared: Prepared, language: Language, returned: str) -> tuple[str, str]:
    """The helpers of the function ``motes_eval_with``, and itself, which begins with the word `returned`."""
    lines = prepared.definition(language, "motes_eval_with", "motes")
    start = next(k for k, line in enumerate(lines) if line.startswith(f"{returned} motes_eval_with("))
    helpers, evaluate = ("".join(f"{line}\n" for line in part) for part in (lines[:start], lines[start:]))
    return helpers, evaluate


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the module."""
    return [write_text(path, module(subject))]


def _finite(value: float) -> float | None:
    return value if np.isfinite(value) else None


def _script(value: object, indent: int | None = None) -> str:
    """JSON that is also safe inside a page's script element."""
    return json.dumps(value, indent=indent, allow_nan=False).replace("<", "\\u003c")


def _template(text: str, language: str) -> str:
    """A template literal with that text."""
    inside = text.replace("\\", "\\\\").replace("`", "\\`").replace("${", "\\${").replace("</", "<\\/")
    return f"/* {language} */ `{inside}`"
