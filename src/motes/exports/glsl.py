"""GLSL ES 3.00 (WebGL 2) and GLSL 4.5: a function with uniforms.

The text goes behind ``#version`` and, in a fragment shader, before ``main``.  It defines

- ``vec3 motes_eval(vec3 wi, vec3 wo)``: the BRDF [1/sr] with the parameters in uniforms ``motes_K_d`` and so on;
- ``vec3 motes_eval_with(vec3 wi, vec3 wo, vec3 K_d, ...)``: the same with the parameters as arguments, where some come from textures.
"""

from __future__ import annotations

from motes.errors import ParameterError
from motes.exports.shaders import Shader, about, checked_name, heading, prefix_of, prepare, uniforms_of
from motes.models import BRDF
from motes.printing import glsl
from motes.printing.shading import Stages, define_in_stages

VERSIONS = ("300 es", "450")


def shader(
    model: BRDF,
    version: str = "300 es",
    name: str = "motes_eval",
    *,
    title: str = "",
    notes: tuple[str, ...] = (),
    stages: Stages | None = None,
) -> Shader:
    """A model as GLSL.

    Parameters
    ----------
    model
        A BRDF; its values become those of the uniforms.
    version
        ``"300 es"`` or ``"450"``.
    name
        Of the function ``vec3 name(vec3 wi, vec3 wo)``.  Uniforms and helpers begin with what stands before its last underscore, so that
        ``left_eval`` and ``right_eval`` fit into one shader.
    title
        Of the material, for the comment.
    notes
        Further sentences for it.
    stages
        Of `in_stages` with the same `name`, in place of one function.

    Returns
    -------
    Shader
        Within 2e-6 of the models in float64 where the driver computes + - * / sqrt as IEEE does; see ``docs/exports.md``.  With other than one or three
        channels the function is ``void name(vec3 wi, vec3 wo, out float f[N])``.

    Raises
    ------
    ParameterError
        When the model has parameters for every direction, or `name` or `version` cannot be used.
    """
    if version not in VERSIONS:
        raise ParameterError(f"GLSL version {version!r} is not one of {', '.join(VERSIONS)}", "Name one of them")
    name, prepared = checked_name(name), prepare(model)
    prefix = prefix_of(name)
    uniforms = uniforms_of(prepared, f"{prefix}_")
    language = glsl.language(version)
    lines = heading(prepared, title, language.title, notes)
    lines += ["", *(["precision highp float;", ""] if version.endswith("es") else [])]
    lines += [
        f"uniform {_declared(u.glsl_type, u.name)};  // {about(slot, u.value)}"
        for u, slot in zip(uniforms, prepared.slots, strict=True)
    ]
    body = prepared.definition(language, f"{name}_with", prefix) if stages is None else stages.lines
    lines += ["", *body, ""]
    passed = "".join(f", {u.name}" for u in uniforms)
    if prepared.arrays:
        lines += [f"void {name}(vec3 wi, vec3 wo, out float f[{prepared.channels}]) {{"]
        lines += [f"    {name}_with(wi, wo{passed}, f);", "}"]
    else:
        lines += [f"vec3 {name}(vec3 wi, vec3 wo) {{", f"    return {name}_with(wi, wo{passed});", "}"]
    return Shader("\n".join(lines) + "\n", uniforms, name, language.title, prepared.channels)


def in_stages(model: BRDF, version: str = "300 es", name: str = "motes_eval") -> Stages | None:
    """The function of `shader` in three stages, for programs that ask for many lights with one viewer; None but for one channel or three.

    ``name_parameters(...)`` computes what parameters alone need, ``name_view(wo, ...)`` what does not depend on the light, ``name_light(wi, wo, ...)`` the
    value; between them it is kept in global variables.
    """
    prepared = prepare(model)
    if prepared.arrays:
        return None
    language, prefix = glsl.language(version), prefix_of(name)
    return define_in_stages(prepared.recording, language, name=name, prefix=prefix, split=prepared.split)


def _declared(type_: str, name: str) -> str:
    """``vec3 K_d``, ``float K_d[31]``."""
    base, bracket, size = type_.partition("[")
    return f"{base} {name}{bracket}{size}"
