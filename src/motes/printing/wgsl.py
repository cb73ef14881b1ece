"""WGSL (WebGPU): how it writes a recorded model."""

from __future__ import annotations

from motes.printing.language import TEMPLATES, Language

_WORDS = """alias array atomic bitcast const_assert diagnostic discard enable f16 f32 fn i32 let loop mat2x2 mat3x3 mat4x4 override ptr requires u32 var
vec2 vec3 vec4 abs acos all any asin atan ceil clamp cos cross degrees determinant distance dot exp exp2 floor fma fract inverseSqrt ldexp
length log log2 max min mix modf normalize pow radians reflect refract round select sign sin smoothstep sqrt step tan trunc active class
common demote filter final fixed from highp inline interface lowp macro mediump meta mod module move namespace new nil null of operator
package partition pass patch precise precision premerge private protected public readonly ref resource sampler self set shared smooth
subroutine super target template this throw trait try type typeid typename uniform use using varying where with yield"""

LANGUAGE = Language(
    title="WGSL",
    number="f32",
    color="vec3<f32>",
    direction="vec3<f32>",
    truth="bool",
    templates=TEMPLATES | {"where": "select({2}, {1}, {0})"},
    constant="const {name}: f32 = {value};",
    splat="vec3<f32>({0})",
    power="bitcast<f32>((i32({k}) + 126) << 23u)",
    declaration="let {name} = {value};",
    header="fn {name}({arguments}) -> {number}",
    argument="{name}: {type}",
    color_header="fn {name}({arguments}) -> {color}",
    array_argument="{name}: array<f32, {count}>",
    array_header="fn {name}({arguments}) -> array<f32, {count}>",
    array_first="var f: array<f32, {count}>;",
    array_copy="var {name}_all = {name};",
    array_last="return f;",
    loop="for (var c = 0; c < {count}; c++)",
    reserved=frozenset(_WORDS.split()),
)
