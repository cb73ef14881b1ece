"""C99, C++ and CUDA: one header with a struct of parameters and a function."""

from __future__ import annotations

from motes.errors import ParameterError
from motes.exports.shaders import Prepared, Shader, about, checked_name, heading, prefix_of, prepare, uniforms_of
from motes.models import BRDF
from motes.printing import c

SCALARS = ("float", "double")


def shader(
    model: BRDF, name: str = "motes_eval", *, scalar: str = "double", title: str = "", notes: tuple[str, ...] = ()
) -> Shader:
    """A model as a header for C99, C++ and CUDA.

    Parameters
    ----------
    model, name, title, notes
        As for `motes.exports.glsl.shader`.
    scalar
        ``"double"``, or ``"float"`` for graphics processors: right to 1e-12, and to some 1e-6.

    Returns
    -------
    Shader
        Defines ``void name(const double wi[3], const double wo[3], const motes_parameters *p, double f[channels])``, the struct
        ``motes_parameters``, and its values for `model`, ``motes_defaults``.  A NaN in a direction gives NaN.
    """
    if scalar not in SCALARS:
        raise ParameterError(f"scalar {scalar!r} is not one of {', '.join(SCALARS)}", "Name one of them")
    name, prepared = checked_name(name), prepare(model)
    prefix = prefix_of(name)
    uniforms = uniforms_of(prepared, "")
    guard = f"{prefix.upper()}_H"
    lines = heading(prepared, title, c.language(scalar).title, notes)
    lines += ["", f"#ifndef {guard}", f"#define {guard}", ""]
    lines += ["#ifndef __CUDACC_RTC__", "#include <math.h>", "#endif", "", "#ifndef MOTES_FUNCTION"]
    lines += ["#ifdef __CUDACC__", "#define MOTES_FUNCTION __host__ __device__ static inline", "#else"]
    lines += ["#define MOTES_FUNCTION static inline", "#endif", "#endif", "", "typedef struct {"]
    for uniform, slot in zip(uniforms, prepared.slots, strict=True):
        size = f"[{prepared.channels}]" if slot.name in prepared.split else ""
        lines.append(f"    {scalar} {slot.name}{size};  // {about(slot, uniform.value)}")
    lines += [f"}} {prefix}_parameters;", "", f"static const {prefix}_parameters {prefix}_defaults = {{"]
    lines += [f"    {_initial(prepared, k, scalar)},  // {slot.name}" for k, slot in enumerate(prepared.slots)]
    lines += ["};", ""]
    lines += c.define(
        prepared.recording, scalar, name=name, prefix=prefix, split=prepared.split, channels=prepared.channels
    )
    return Shader("\n".join([*lines, "", "#endif"]) + "\n", uniforms, name, f"C, {scalar}", prepared.channels)


def _initial(prepared: Prepared, k: int, scalar: str) -> str:
    """The value of a parameter as C writes it."""
    write = c.language(scalar).literal
    value = prepared.value(prepared.slots[k])
    return f"{{{', '.join(map(write, value))}}}" if isinstance(value, tuple) else write(value)
