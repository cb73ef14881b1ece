"""HLSL: functions and a constant buffer."""

from __future__ import annotations

from motes.exports.shaders import (
    Prepared,
    Shader,
    about,
    checked_name,
    heading,
    packed,
    prefix_of,
    prepare,
    uniforms_of,
)
from motes.models import BRDF
from motes.printing.hlsl import LANGUAGE
from motes.printing.language import comment


def shader(
    model: BRDF, name: str = "motes_eval", *, title: str = "", register: int = 0, notes: tuple[str, ...] = ()
) -> Shader:
    """A model as HLSL.

    Parameters
    ----------
    model, name, title, notes
        As for `motes.exports.glsl.shader`.
    register
        Of the constant buffer.

    Returns
    -------
    Shader
        Defines ``float3 name(float3 wi, float3 wo)`` and ``name_with``, whose further arguments are the parameters.  With other than one or
        three channels they are ``void`` and fill an array ``out float f[N]``.
    """
    name, prepared = checked_name(name), prepare(model)
    prefix = prefix_of(name)
    uniforms = uniforms_of(prepared, f"{prefix}_")
    lines = [*heading(prepared, title, LANGUAGE.title, notes), ""]
    lines += [f"cbuffer {prefix}_parameters : register(b{register}) {{"]
    offsets, size = _offsets(prepared)
    for uniform, slot, offset in zip(uniforms, prepared.slots, offsets, strict=True):
        many = slot.name in prepared.split
        type_, many_of = ("float", f"[{prepared.channels}]") if prepared.arrays else ("float3", "")
        declared = f"{type_} {uniform.name}{many_of}" if many else f"float {uniform.name}"
        place = f"c{offset // 16}.{'xyzw'[offset % 16 // 4]}"
        lines.append(f"    {declared} : packoffset({place});  // at byte {offset}: {about(slot, uniform.value)}")
    lines += ["};", *comment(f"The buffer has {size} bytes; entries of an array are 16 bytes apart."), ""]
    lines += [*prepared.definition(LANGUAGE, f"{name}_with", prefix), ""]
    passed = "".join(f", {uniform.name}" for uniform in uniforms)
    if prepared.arrays:
        lines += [f"void {name}(float3 wi, float3 wo, out float f[{prepared.channels}]) {{"]
        lines += [f"    {name}_with(wi, wo{passed}, f);", "}"]
    else:
        lines += [f"float3 {name}(float3 wi, float3 wo) {{", f"    return {name}_with(wi, wo{passed});", "}"]
    return Shader("\n".join(lines) + "\n", uniforms, name, LANGUAGE.title, prepared.channels)


def pack(model: BRDF) -> bytes:
    """The content of the constant buffer of `shader`."""
    prepared = prepare(model)
    return packed(prepared, *_offsets(prepared), stride=16)


def _offsets(prepared: Prepared) -> tuple[list[int], int]:
    """Where each parameter lies, and the size of the whole [bytes]: nothing crosses a multiple of 16, and arrays fill whole ones.

    Left to themselves, compilers disagree on what follows an array: Direct3D's put the next number behind the last entry, in what is
    left of its 16 bytes; those that make SPIR-V begin at the next multiple.  So the places are written (``packoffset``).
    """
    offsets, end = [], 0
    for slot in prepared.slots:
        many = slot.name in prepared.split
        size = 4 if not many else 16 * prepared.channels if prepared.arrays else 12
        if end // 16 != (end + size - 1) // 16:
            end = -(-end // 16) * 16
        offsets.append(end)
        end += size
    return offsets, -(-end // 16) * 16
