"""WGSL (WebGPU): a module part with a uniform buffer of parameters."""

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
from motes.printing.language import comment
from motes.printing.wgsl import LANGUAGE


def shader(
    model: BRDF,
    name: str = "motes_eval",
    *,
    title: str = "",
    group: int = 0,
    binding: int = 0,
    notes: tuple[str, ...] = (),
) -> Shader:
    """A model as WGSL.

    Parameters
    ----------
    model, name, title, notes
        As for `motes.exports.glsl.shader`.
    group, binding
        Where the buffer of parameters is bound; `pack` makes its content.

    Returns
    -------
    Shader
        Defines ``fn name(wi: vec3<f32>, wo: vec3<f32>) -> vec3<f32>`` and ``name_with``, whose further arguments are the parameters.  With other
        than one or three channels both return an ``array<f32, N>``, and the buffer is a storage buffer.
    """
    name, prepared = checked_name(name), prepare(model)
    prefix = prefix_of(name)
    uniforms = uniforms_of(prepared, "")
    structure = f"{prefix[0].upper()}{prefix[1:]}Parameters"
    lines = heading(prepared, title, LANGUAGE.title, notes)
    lines += ["", f"struct {structure} {{"]
    for uniform, slot, offset in zip(uniforms, prepared.slots, _offsets(prepared)[0], strict=True):
        type_ = f"array<f32, {prepared.channels}>" if prepared.arrays else "vec3<f32>"
        type_ = type_ if slot.name in prepared.split else "f32"
        lines.append(f"    {slot.name}: {type_},  // at byte {offset}: {about(slot, uniform.value)}")
    space = "storage, read" if prepared.arrays else "uniform"
    lines += ["}", "", *comment(f"The buffer has {_offsets(prepared)[1]} bytes.")]
    lines += [f"@group({group}) @binding({binding}) var<{space}> {prefix}_parameters: {structure};", ""]
    lines += [*prepared.definition(LANGUAGE, f"{name}_with", prefix), ""]
    result = f"array<f32, {prepared.channels}>" if prepared.arrays else "vec3<f32>"
    passed = "".join(f", {prefix}_parameters.{slot.name}" for slot in prepared.slots)
    lines += [
        f"fn {name}(wi: vec3<f32>, wo: vec3<f32>) -> {result} {{",
        f"    return {name}_with(wi, wo{passed});",
        "}",
    ]
    return Shader("\n".join(lines) + "\n", uniforms, name, LANGUAGE.title, prepared.channels)


def pack(model: BRDF) -> bytes:
    """The content of the buffer of parameters of `shader`."""
    prepared = prepare(model)
    return packed(prepared, *_offsets(prepared))


def _offsets(prepared: Prepared) -> tuple[list[int], int]:
    """Where each parameter lies, and the size of the whole [bytes]."""
    offsets, end, widest = [], 0, 4
    for slot in prepared.slots:
        many = slot.name in prepared.split
        align = 16 if many and not prepared.arrays else 4
        end = -(-end // align) * align
        offsets.append(end)
        end += 4 * (prepared.channels if many else 1)
        widest = max(widest, align)
    return offsets, -(-end // widest) * widest
