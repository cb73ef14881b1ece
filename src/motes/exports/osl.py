"""OSL: a shader that computes the BRDF for a light, and its nearest closures.

OSL renderers take closures, not formulas: a shader never sees the light.  So the shader has two outputs: ``Reflectance``, the BRDF [1/sr] itself
for the direction ``Light``, for baking, for tables and for light loops of one's own; and ``BSDF``, the sum of the closures that come
nearest (see `motes.exports.approximation`), for rendering.
"""

from __future__ import annotations

from motes.exports.approximation import Words, losses, written
from motes.exports.shaders import (
    Prepared,
    Shader,
    checked_name,
    heading,
    plain,
    prefix_of,
    prepare,
    uniforms_of,
)
from motes.models import BRDF, Reflection
from motes.parameters import Slot
from motes.printing.language import indented
from motes.printing.osl import LANGUAGE


def shader(
    model: BRDF, name: str = "motes_eval", *, title: str = "", shader_name: str = "motes", notes: tuple[str, ...] = ()
) -> Shader:
    """A model as an OSL shader.

    Parameters
    ----------
    model, title, notes
        As for `motes.exports.glsl.shader`.
    name
        Of the function that computes the value from local directions.
    shader_name
        Of the shader.

    Returns
    -------
    Shader
        Its inputs are the parameters, ``Light``, ``View`` (from the renderer) and ``Normal``; with other than one or three channels
        ``Reflectance`` is an array and there is no ``BSDF``.
    """
    name, shader_name, prepared = checked_name(name), checked_name(shader_name), prepare(model)
    prefix = prefix_of(name)
    uniforms = uniforms_of(prepared, "")
    said = [
        "Reflectance is the BRDF itself for the light at Light; OSL cannot render with it, since a shader never sees the light."
    ]
    if prepared.arrays:
        said.append("There is no closure: closures are coloured by three channels.")
    else:
        said += ["BSDF is the nearest sum of standard closures, for rendering:", *losses(model)]
    lines = [*heading(prepared, title, LANGUAGE.title, (*notes, *said)), ""]
    lines += [*prepared.definition(LANGUAGE, name, prefix), ""]
    lines += [f"shader {shader_name}(", *indented(_parameters(prepared)), ") {"]
    body = [
        "vector tangent = normalize(cross(abs(Normal[2]) < 0.9 ? vector(0, 0, 1) : vector(1, 0, 0), vector(Normal)));",
        "vector bitangent = cross(vector(Normal), tangent);",
        "vector wi = vector(dot(Light, tangent), dot(Light, bitangent), dot(Light, Normal));",
        "vector wo = vector(dot(View, tangent), dot(View, bitangent), dot(View, Normal));",
    ]
    passed = "".join(f", {slot.name}" for slot in prepared.slots)
    if prepared.arrays:
        body += [f"{name}(wi, wo{passed}, Reflectance);"]
    else:
        body += [f"Reflectance = {name}(wi, wo{passed});", "", *_closures(prepared)]
    return Shader(
        "\n".join([*lines, *indented(body), "}"]) + "\n", uniforms, shader_name, LANGUAGE.title, prepared.channels
    )


def _parameters(prepared: Prepared) -> list[str]:
    """The inputs and outputs, with what user interfaces show."""
    lines = [f"{_declaration(prepared, slot)} [[ {_metadata(slot)} ]]," for slot in prepared.slots]
    lines += [
        'vector Light = vector(0, 0, 1) [[ string help = "unit vector to the light" ]],',
        # The specification's I points to the surface, that of Cycles to the viewer.
        'vector View = dot(I, N) > 0 ? I : -I [[ string help = "unit vector to the viewer" ]],',
        'normal Normal = N [[ string help = "the surface\'s normal" ]],',
    ]
    if prepared.arrays:
        zeros = ", ".join(["0.0"] * prepared.channels)
        return [*lines, f"output float Reflectance[{prepared.channels}] = {{{zeros}}}"]
    return [*lines, "output color Reflectance = color(0.0),", "output closure color BSDF = 0"]


def _declaration(prepared: Prepared, slot: Slot) -> str:
    value = prepared.value(slot)
    if not isinstance(value, tuple):
        return f"float {slot.name} = {value!r}"
    written = ", ".join(map(repr, value))
    if prepared.arrays:
        return f"float {slot.name}[{prepared.channels}] = {{{written}}}"
    return f"color {slot.name} = color({written})"


def _metadata(slot: Slot) -> str:
    parameter = slot.parameter
    parts = [f'string help = "{plain(parameter.doc)}"']
    for key, value in zip(("min", "max", "UImin", "UImax"), (*parameter.bounds, *parameter.typical), strict=True):
        parts += [f"float {key} = {value!r}"] if abs(value) < 1e6 else []
    parts += [f'string units = "{parameter.unit}"'] if parameter.unit else []
    return ", ".join(parts)


def _closures(prepared: Prepared) -> list[str]:
    """Statements that add up the closures."""
    statements, found = written(prepared.model, prepared.split, "color")
    calls = [_closure(lobe) for lobe in found]
    return [
        *statements,
        *(f"closure color lobe_{k} = {call};" for k, call in enumerate(calls, 1)),
        f"BSDF = {' + '.join(f'lobe_{k}' for k in range(1, len(calls) + 1))};",
    ]


def _closure(lobe: Words) -> str:
    if lobe.reflection is Reflection.DIFFUSE:
        return f"oren_nayar_diffuse_bsdf(Normal, {lobe.grazing}, {lobe.roughness})"
    return (
        f"{lobe.grazing} * generalized_schlick_bsdf(Normal, tangent, color(1.0), color(0.0), {lobe.roughness}, {lobe.roughness}, "
        f'{lobe.normal}, color(1.0), 5.0, "ggx")'
    )
