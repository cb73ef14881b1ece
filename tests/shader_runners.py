"""Running printed shaders: GLSL through moderngl, WGSL through wgpu, C through a compiler.  Each is skipped, by name, where its tool is missing."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.certification import glsl_specimen
from motes.errors import MotesError
from motes.exports.shaders import Shader

Directions = NDArray[np.float32]


def tool(name: str) -> str:
    """The path of a program; the test is skipped where it is not installed."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed")
    return path


def checked(*command: str | Path) -> str:
    """Run a program, which must succeed without a warning; returns what it printed."""
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=300, check=False)
    assert done.returncode == 0, f"{' '.join(map(str, command))}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
    return done.stdout + done.stderr


# ---------------------------------------------------------------- GLSL


def open_gl() -> Any:
    """An OpenGL context without a window."""
    pytest.importorskip("moderngl", reason="moderngl is not installed")
    try:
        return glsl_specimen.open_gl()
    except MotesError as error:
        pytest.skip(f"no OpenGL 4.3 without a window here (EGL, llvmpipe): {error}")


def run_glsl(context: Any, shader: Shader, version: str, wi: Directions, wo: Directions) -> NDArray[np.float32]:
    """The values of a shader, a pixel a pair of directions; (N, channels shown)."""
    uniforms = {uniform.name: uniform.value for uniform in shader.uniforms}
    call = "motes_a, motes_b"
    if shader.channels in (1, 3):
        picture = glsl_specimen.pixels(
            context, shader.source, version, f"pixel = vec4({shader.name}({call}), 1.0);", uniforms, wi, wo
        )
        return picture[:, :3]
    each = []
    for channel in range(shader.channels):
        result = f"float f[{shader.channels}]; {shader.name}({call}, f); pixel = vec4(f[channel]);"
        source = f"{shader.source}\nuniform int channel;\n"  # a constant would let the compiler shorten the arrays
        with_channel = uniforms | {"channel": channel}
        each.append(glsl_specimen.pixels(context, source, version, result, with_channel, wi, wo)[:, :1])
    return np.concatenate(each, axis=1)


# ---------------------------------------------------------------- WGSL


def open_gpu() -> Any:
    """A WebGPU device."""
    wgpu = pytest.importorskip("wgpu", reason="wgpu is not installed")
    try:
        return wgpu.gpu.request_adapter_sync(power_preference="low-power").request_device_sync()
    except Exception as error:
        pytest.skip(f"no WebGPU adapter here (Vulkan, lavapipe): {error}")


def run_wgsl(device: Any, shader: Shader, parameters: bytes, wi: Directions, wo: Directions) -> NDArray[np.float32]:
    """The values of a shader, an invocation a pair of directions; (N, channels)."""
    stride = max(3, shader.channels)
    main = f"""
@group(1) @binding(0) var<storage, read> lights: array<vec4<f32>>;
@group(1) @binding(1) var<storage, read> viewers: array<vec4<f32>>;
@group(1) @binding(2) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
    var f = {shader.name}(lights[id.x].xyz, viewers[id.x].xyz);
    for (var c = 0u; c < {stride}u; c++) {{ values[id.x * {stride}u + c] = f[c]; }}
}}"""
    return _computed(device, shader.source + main, parameters, wi, wo, stride)


def run_hlsl(
    device: Any, shader: Shader, parameters: bytes, wi: Directions, wo: Directions, folder: Path
) -> NDArray[np.float32]:
    """The same for HLSL, which becomes SPIR-V by glslang."""
    glslang = tool("glslangValidator")
    stride = max(3, shader.channels)
    result = f"float f[{stride}]" if shader.channels not in (1, 3) else "float3 f ="
    call = f"{shader.name}(lights[id.x].xyz, viewers[id.x].xyz"
    call = f"{result}; {call}, f);" if shader.channels not in (1, 3) else f"{result} {call});"
    main = f"""
[[vk::binding(0, 1)]] StructuredBuffer<float4> lights;
[[vk::binding(1, 1)]] StructuredBuffer<float4> viewers;
[[vk::binding(2, 1)]] RWStructuredBuffer<float> values;
[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {{
    {call}
    for (int c = 0; c < {stride}; ++c) values[id.x * {stride} + c] = f[c];
}}
"""
    source, binary = folder / "run.hlsl", folder / "run.spv"
    source.write_text(shader.source + main, encoding="utf-8")
    checked(glslang, "-D", "-S", "comp", "-e", "main", "-V", source, "-o", binary)
    return _computed(device, binary.read_bytes(), parameters, wi, wo, stride)


def _computed(
    device: Any, code: str | bytes, parameters: bytes, wi: Directions, wo: Directions, stride: int
) -> NDArray[np.float32]:
    """What the entry point ``main`` of a module in WGSL or SPIR-V puts into its output."""
    import wgpu

    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
    storage, uniform = wgpu.BufferUsage.STORAGE, wgpu.BufferUsage.UNIFORM
    inputs = [
        device.create_buffer_with_data(data=np.pad(w, ((0, 0), (0, 1))).astype("f4"), usage=storage) for w in (wi, wo)
    ]
    output = device.create_buffer(size=4 * stride * len(wi), usage=storage | wgpu.BufferUsage.COPY_SRC)
    constants = device.create_buffer_with_data(data=parameters, usage=storage | uniform)
    groups = [
        device.create_bind_group(
            layout=pipeline.get_bind_group_layout(k),
            entries=[{"binding": b, "resource": {"buffer": x, "offset": 0, "size": x.size}} for b, x in enumerate(g)],
        )
        for k, g in enumerate(([constants], [*inputs, output]))
    ]
    encoder = device.create_command_encoder()
    work = encoder.begin_compute_pass()
    work.set_pipeline(pipeline)
    for k, group in enumerate(groups):
        work.set_bind_group(k, group)
    work.dispatch_workgroups(len(wi) // 64)
    work.end()
    device.queue.submit([encoder.finish()])
    return np.frombuffer(device.queue.read_buffer(output), "f4").reshape(len(wi), stride)


# ---------------------------------------------------------------- C


def run_c(shader: Shader, scalar: str, wi: NDArray[Any], wo: NDArray[Any], folder: Path, *options: str) -> NDArray[Any]:
    """The values of a header in C, compiled without a warning; (N, channels)."""
    compiler = tool("gcc")
    (folder / "material.h").write_text(shader.source, encoding="utf-8")
    (folder / "run.c").write_text(
        f"""#include "material.h"
void run(long n, const {scalar} *wi, const {scalar} *wo, {scalar} *f) {{
    for (long k = 0; k < n; ++k) {shader.name}(wi + 3 * k, wo + 3 * k, &motes_defaults, f + {shader.channels} * k);
}}
""",
        encoding="utf-8",
    )
    strict = ("-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wdouble-promotion", "-Werror")
    library = folder / "run.so"
    checked(compiler, *strict, *options, "-shared", "-fPIC", folder / "run.c", "-o", library, "-lm")
    number = np.float32 if scalar == "float" else np.float64
    values = np.empty((len(wi), shader.channels), number)
    arrays = [np.ascontiguousarray(w, number) for w in (wi, wo)]
    ctypes.CDLL(str(library)).run(ctypes.c_long(len(wi)), *(ctypes.c_void_p(a.ctypes.data) for a in (*arrays, values)))
    return values
