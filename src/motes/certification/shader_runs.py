"""Printed shaders, run where the user is: C by a compiler, GLSL by OpenGL, WGSL and HLSL by WebGPU; values (N, C) of pairs of directions."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.certification.c_specimen import compiled
from motes.certification.glsl_specimen import pixels
from motes.certification.specimen import Floats, Numbers
from motes.errors import FormatError, MotesError
from motes.exports.shaders import Shader

#: Invocations of a work group.
GROUP = 64


def run_c(shader: Shader, scalar: str, wi: Numbers, wo: Numbers) -> tuple[Floats, str]:
    """The values of a header in C, and the compiler's version."""
    loop = f"""
void motes_run(long n, const {scalar} *wi, const {scalar} *wo, {scalar} *f) {{
    for (long k = 0; k < n; ++k) {shader.name}(wi + 3 * k, wo + 3 * k, &motes_defaults, f + {shader.channels} * k);
}}
"""
    library, version = compiled(shader.source + loop, Path("the header"))
    number = np.float32 if scalar == "float" else np.float64
    values = np.empty((len(wi), shader.channels), number)
    arrays = [np.ascontiguousarray(w, number) for w in (wi, wo)]
    library.motes_run(ctypes.c_long(len(wi)), *(ctypes.c_void_p(a.ctypes.data) for a in (*arrays, values)))
    return values.astype(np.float64), version


def run_glsl(context: Any, shader: Shader, version: str, wi: Numbers, wo: Numbers) -> NDArray[np.float32]:
    """The values of a shader in GLSL, a pixel a pair; three channels where there is one."""
    uniforms = {uniform.name: uniform.value for uniform in shader.uniforms}
    call = "motes_a, motes_b"
    if shader.channels in (1, 3):
        result = f"pixel = vec4({shader.name}({call}), 1.0);"
        return pixels(context, shader.source, version, result, uniforms, wi, wo)[:, :3]
    each = []
    for channel in range(shader.channels):
        result = f"float f[{shader.channels}]; {shader.name}({call}, f); pixel = vec4(f[channel]);"
        source = f"{shader.source}\nuniform int channel;\n"  # a constant would let the compiler shorten the arrays
        each.append(pixels(context, source, version, result, uniforms | {"channel": channel}, wi, wo)[:, :1])
    return np.concatenate(each, axis=1)


@cache
def open_gpu() -> Any:
    """A WebGPU device, one for the process.

    Raises
    ------
    MotesError
        Without the package wgpu, or an adapter.
    """
    try:
        import wgpu
    except ImportError:
        raise MotesError("the package wgpu is not installed", "pip install wgpu") from None
    try:
        return wgpu.gpu.request_adapter_sync(power_preference="low-power").request_device_sync()
    except Exception as error:  # wgpu has no class of its own for it
        raise MotesError(f"there is no WebGPU adapter here: {error}", "apt-get install mesa-vulkan-drivers") from error


def run_wgsl(device: Any, shader: Shader, parameters: bytes, wi: Numbers, wo: Numbers) -> NDArray[np.float32]:
    """The values of a shader in WGSL, an invocation a pair; three channels where there is one."""
    stride = 3 if shader.channels == 1 else shader.channels
    main = f"""
@group(1) @binding(0) var<storage, read> lights: array<vec4<f32>>;
@group(1) @binding(1) var<storage, read> viewers: array<vec4<f32>>;
@group(1) @binding(2) var<storage, read_write> values: array<f32>;
@compute @workgroup_size({GROUP})
fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
    var f = {shader.name}(lights[id.x].xyz, viewers[id.x].xyz);
    for (var c = 0u; c < {stride}u; c++) {{ values[id.x * {stride}u + c] = f[c]; }}
}}"""
    return _computed(device, shader.source + main, parameters, wi, wo, stride)


def run_hlsl(device: Any, shader: Shader, parameters: bytes, wi: Numbers, wo: Numbers) -> NDArray[np.float32]:
    """The same for HLSL, which glslang makes SPIR-V of.

    Raises
    ------
    MotesError
        Without glslang.
    FormatError
        Where it refuses the shader.
    """
    glslang = shutil.which("glslangValidator")
    if glslang is None:
        raise MotesError("glslangValidator, which compiles HLSL, is not installed", "apt-get install glslang-tools")
    stride = 3 if shader.channels == 1 else shader.channels
    result = f"float f[{stride}]" if shader.channels not in (1, 3) else "float3 f ="
    call = f"{shader.name}(lights[id.x].xyz, viewers[id.x].xyz"
    call = f"{result}; {call}, f);" if shader.channels not in (1, 3) else f"{result} {call});"
    main = f"""
[[vk::binding(0, 1)]] StructuredBuffer<float4> lights;
[[vk::binding(1, 1)]] StructuredBuffer<float4> viewers;
[[vk::binding(2, 1)]] RWStructuredBuffer<float> values;
[numthreads({GROUP}, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {{
    {call}
    for (int c = 0; c < {stride}; ++c) values[id.x * {stride} + c] = f[c];
}}
"""
    with tempfile.TemporaryDirectory(prefix="motes-hlsl-") as folder:
        source, binary = Path(folder) / "run.hlsl", Path(folder) / "run.spv"
        source.write_text(shader.source + main, encoding="utf-8")
        command = [glslang, "-D", "-S", "comp", "-e", "main", "-V", str(source), "-o", str(binary)]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=120, check=False)
        if done.returncode != 0:
            lines = [line for line in done.stdout.splitlines() if "ERROR" in line] or ["no reason"]
            raise FormatError(f"the shader does not compile: {lines[0][:300]}", "Report it: this is a defect")
        return _computed(device, binary.read_bytes(), parameters, wi, wo, stride)


def _computed(
    device: Any, code: str | bytes, parameters: bytes, wi: Numbers, wo: Numbers, stride: int
) -> NDArray[np.float32]:
    """What the entry point ``main`` of a module in WGSL or SPIR-V puts into its output."""
    import wgpu

    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
    storage, uniform = wgpu.BufferUsage.STORAGE, wgpu.BufferUsage.UNIFORM
    groups = -(-len(wi) // GROUP)
    more = groups * GROUP - len(wi)
    inputs = [
        device.create_buffer_with_data(data=np.pad(np.asarray(w, "f4"), ((0, more), (0, 1))), usage=storage)
        for w in (wi, wo)
    ]
    output = device.create_buffer(size=4 * stride * groups * GROUP, usage=storage | wgpu.BufferUsage.COPY_SRC)
    constants = device.create_buffer_with_data(data=parameters, usage=storage | uniform)
    bound = [
        device.create_bind_group(
            layout=pipeline.get_bind_group_layout(k),
            entries=[{"binding": b, "resource": {"buffer": x, "offset": 0, "size": x.size}} for b, x in enumerate(g)],
        )
        for k, g in enumerate(([constants], [*inputs, output]))
    ]
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    for k, group in enumerate(bound):
        work.set_bind_group(k, group)
    work.dispatch_workgroups(groups)
    work.end()
    device.queue.submit([encoder.finish()])
    return np.frombuffer(device.queue.read_buffer(output), "f4").reshape(-1, stride)[: len(wi)]
