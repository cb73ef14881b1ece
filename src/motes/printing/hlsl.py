"""HLSL (shader model 5 and later): how it writes a recorded model."""

from __future__ import annotations

from motes.printing.language import Language

_WORDS = """AppendStructuredBuffer asm BlendState Buffer cbuffer centroid class column_major compile ComputeShader discard double2 double3
double4 dword export extern float2 float3 float4 groupshared half2 half3 half4 in inline inout int2 int3 int4 interface line lineadj linear
matrix min16float min16int namespace nointerpolation noperspective NULL out packoffset pass pixelfragment point precise register row_major
sample sampler shared snorm stateblock string tbuffer technique texture Texture2D triangle typename uint uint2 uint3 uint4 uniform unorm using
vector abs acos all any asfloat asin asint atan ceil clamp clip cos cross degrees determinant distance dot exp exp2 floor fmod frac isnan
ldexp length lerp lit log log2 mad max min modf mul noise normalize pow radians rcp reflect refract round rsqrt saturate sign sin smoothstep
sqrt step tan transpose trunc select"""

LANGUAGE = Language(
    title="HLSL",
    number="float",
    color="float3",
    direction="float3",
    truth="bool",
    constant="const float {name} = {value};",
    splat="(float3)({0})",
    power="asfloat((int({k}) + 126) << 23)",
    reserved=frozenset(_WORDS.split()),
)
