"""The shaders that a MaterialX document refers to: the exact BRDF as a BSDF and as a value in GLSL, and as a value in OSL."""

from __future__ import annotations

from dataclasses import replace

from motes.exports.approximation import Words, losses, written
from motes.exports.shaders import Prepared, heading
from motes.exports.subject import Subject
from motes.models import Reflection
from motes.printing import glsl as glsl_language
from motes.printing import osl as osl_language
from motes.printing.language import POWER_WITHOUT_BITS, comment, indented

_FRAME = """vec3 tangent = normalize(cross(abs(N.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), N));
vec3 bitangent = cross(N, tangent);
vec3 wi = vec3(dot(L, tangent), dot(L, bitangent), dot(L, N));
vec3 wo = vec3(dot(V, tangent), dot(V, bitangent), dot(V, N));"""


def formula(prepared: Prepared, subject: Subject, name: str) -> str:
    """The BRDF, which the other two files include; its names begin with the material's, so that several fit into one shader."""
    lines = heading(prepared, subject.name, "GLSL for MaterialX's genglsl", subject.notes)
    # Metal, which MaterialX makes of this, has another name for intBitsToFloat.
    language = replace(glsl_language.language("450"), power=POWER_WITHOUT_BITS)
    definition = prepared.definition(language, f"motes_{name}_at", f"motes_{name}")
    return "\n".join([*lines, "", *definition]) + "\n"


def _arguments(prepared: Prepared, color: str) -> tuple[str, str]:
    """The parameters as a function declares them, with a comma at the end, and as it passes them on, with one before."""
    declared = "".join(f"{color if s.name in prepared.split else 'float'} {s.name}, " for s in prepared.slots)
    return declared, "".join(f", {slot.name}" for slot in prepared.slots)


def bsdf(prepared: Prepared, subject: Subject, name: str, stem: str) -> str:
    declared, passed = _arguments(prepared, "vec3")
    statements, found = written(prepared.model, prepared.split, "vec3")
    exact = f"bsdf.response = motes_{name}_at(wi, wo{passed}) * max(wi.z, 0.0) * closureData.occlusion;"
    around = [*statements, *(f"bsdf.response += {_environment(lobe)};" for lobe in found)]
    body = ["bsdf.response = vec3(0.0);", "bsdf.throughput = vec3(0.0);", "vec3 V = closureData.V;"]
    body += ["vec3 L = closureData.L;", "vec3 N = mx_forward_facing_normal(normal, V);", *_FRAME.split("\n")]
    body += ["if (closureData.closureType == CLOSURE_TYPE_REFLECTION) {", *indented([exact])]
    body += ["} else if (closureData.closureType == CLOSURE_TYPE_INDIRECT) {"]
    body += [*indented(["// The environment, by the standard lobes.", *around]), "}"]
    lines = comment("The environment sees standard lobes that come near the model:")
    lines += [line for text in losses(subject.brdf) for line in comment(text)]
    # Where the library's data folder is, there is a folder "libraries": its search path leads there.
    lines += ['#include "libraries/pbrlib/genglsl/lib/mx_closure_type.glsl"', f'#include "{stem}_formula.glsl"', ""]
    lines += [f"void motes_{name}_bsdf(ClosureData closureData, {declared}vec3 normal, inout BSDF bsdf) {{"]
    return "\n".join([*lines, *indented(body), "}"]) + "\n"


def value(prepared: Prepared, subject: Subject, name: str, stem: str) -> str:
    declared, passed = _arguments(prepared, "vec3")
    body = ["vec3 L = light;", "vec3 V = view;", "vec3 N = normal;", *_FRAME.split("\n")]
    body += [f"result = motes_{name}_at(wi, wo{passed});"]
    head = f"void motes_{name}_value({declared}vec3 light, vec3 view, vec3 normal, out vec3 result) {{"
    return "\n".join([f'#include "{stem}_formula.glsl"', "", head, *indented(body), "}"]) + "\n"


def _environment(lobe: Words) -> str:
    """A lobe's answer to the environment."""
    if lobe.reflection is Reflection.DIFFUSE:
        return f"mx_environment_irradiance(N) * {lobe.grazing}"
    fresnel = f"mx_init_fresnel_schlick({lobe.normal}, vec3(1.0), vec3(1.0), 5.0, 0.0, 1.5)"
    return f"{lobe.grazing} * mx_environment_radiance(N, V, tangent, vec2({lobe.roughness}), 0, {fresnel})"


def value_in_osl(prepared: Prepared, subject: Subject, name: str) -> str:
    declared, passed = _arguments(prepared, "color")
    lines = heading(prepared, subject.name, "OSL for MaterialX's genosl", subject.notes)
    lines += ["", *prepared.definition(osl_language.LANGUAGE, f"motes_{name}_at", f"motes_{name}"), ""]
    frame = _FRAME.replace("vec3(", "vector(").replace("vec3 ", "vector ").replace("N.z", "N[2]")
    body = ["vector L = toward_light;", "vector V = toward_viewer;", "vector N = toward_outside;", *frame.split("\n")]
    body += [f"result = motes_{name}_at(wi, wo{passed});"]
    # The words light and normal are reserved.
    head = f"void motes_{name}_value({declared}vector toward_light, vector toward_viewer, vector toward_outside, output color result) {{"
    return "\n".join([*lines, head, *indented(body), "}"]) + "\n"
