"""GLSL ES 3.00 (WebGL 2) and 4.5: how they write a recorded model."""

from __future__ import annotations

from motes.printing.language import Language

_WORDS = (
    "active asm atomic_uint attribute buffer cast centroid class coherent common discard dvec2 dvec3 dvec4 external filter fixed flat fvec2 "
    "fvec3 fvec4 goto highp hvec2 hvec3 hvec4 image1D image2D image3D in inline inout input interface invariant iimage2D lowp mat2 mat3 mat4 "
    "mediump namespace noinline out output partition patch precise precision public readonly resource restrict sample sampler1D sampler2D "
    "sampler3D samplerCube shared smooth subroutine superp template this uint uniform using uvec2 uvec3 uvec4 varying vec2 vec3 vec4 writeonly "
    "abs acos asin atan ceil clamp cos cross degrees distance dot exp exp2 floor fract inversesqrt length log log2 max min mix mod normalize "
    "pow radians reflect refract sign sin smoothstep sqrt step tan"
)


def language(version: str) -> Language:
    """The language of ``#version`` `version`."""
    return Language(
        title="GLSL ES 3.00" if version == "300 es" else f"GLSL {version[0]}.{version[1:]}",
        number="float",
        color="vec3",
        direction="vec3",
        truth="bool",
        constant="const float {name} = {value};",
        splat="vec3({0})",
        power="intBitsToFloat((int({k}) + 126) << 23)",
        reserved=frozenset(_WORDS.split()),
    )
