"""Printed shaders, run: their values against NumPy in float64 at 4,096 pairs of directions."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.exports import c, glsl, hlsl, wgsl
from motes.models import BRDF, DustLayer, OrenNayar, TorranceSparrow
from shader_runners import checked, open_gl, open_gpu, run_c, run_glsl, run_hlsl, run_wgsl, tool
from shader_support import MODELS, SPECTRAL, check, directions, error, expected

ALL = MODELS | {"spectral": SPECTRAL}
WI, WO = directions()


@pytest.fixture(scope="module")
def gl() -> Any:
    return open_gl()  # one for the process


@pytest.fixture(scope="module")
def gpu() -> Any:
    return open_gpu()


@pytest.mark.parametrize("version", glsl.VERSIONS)
@pytest.mark.parametrize("name", ALL)
def test_glsl_against_numpy(gl: Any, name: str, version: str) -> None:
    check(name, run_glsl(gl, glsl.shader(ALL[name], version), version, WI, WO), expected(ALL[name], WI, WO))


def test_glsl_uniforms_are_live(gl: Any) -> None:
    """The values are in the uniforms, not in the text: a shader with those of another model is that model."""
    here = MODELS["dusty"]
    other = here.with_parameters({"K_d": (0.1, 0.5, 0.9), "sigma_d": 0.9, "tau": 1.5, "g": -0.5, "sigma_s": 0.3})
    shader, wanted = glsl.shader(here), glsl.shader(other)
    assert shader.source != wanted.source  # the comments
    mixed = type(shader)(shader.source, wanted.uniforms, shader.name, shader.language, shader.channels)
    check("dusty", run_glsl(gl, mixed, "300 es", WI, WO), expected(other, WI, WO))


def test_two_materials_in_one_shader(gl: Any) -> None:
    left, right = (
        glsl.shader(MODELS[name], name=f"{side}_eval") for name, side in (("dusty", "left"), ("conductor", "right"))
    )
    both = type(left)(left.source + right.source, left.uniforms + right.uniforms, "right_eval", "", 3)
    check("conductor", run_glsl(gl, both, "300 es", WI, WO), expected(MODELS["conductor"], WI, WO))


@pytest.mark.parametrize("name", ALL)
def test_wgsl_against_numpy(gpu: Any, name: str) -> None:
    model = ALL[name]
    check(name, run_wgsl(gpu, wgsl.shader(model), wgsl.pack(model), WI, WO), expected(model, WI, WO))


@pytest.mark.parametrize("name", ALL)
def test_wgsl_is_valid_elsewhere(gpu: Any, name: str) -> None:
    """In another group, at another binding: by naga, which is wgpu's compiler."""
    source = wgsl.shader(ALL[name], group=2, binding=3).source
    assert "@group(2) @binding(3)" in source
    gpu.create_shader_module(code=source)


@pytest.mark.parametrize("name", ALL)
@pytest.mark.parametrize("version", glsl.VERSIONS)
def test_glsl_is_valid(name: str, version: str, tmp_path: Path) -> None:
    """By the reference compiler, which is stricter than drivers."""
    validator = tool("glslangValidator")
    shader = glsl.shader(ALL[name], version)
    file = tmp_path / "material.frag"
    call = "float f[7]; motes_eval(w, w, f);" if shader.channels == 7 else "vec3 f = motes_eval(w, w);"
    main = f"out vec4 pixel; uniform vec3 w; void main() {{ {call} pixel = vec4(f[0], f[1], f[2], 1.0); }}"
    file.write_text(f"#version {version}\n{shader.source}{main}\n", encoding="utf-8")
    assert "WARNING" not in checked(validator, file)


@pytest.mark.parametrize("name", ALL)
def test_hlsl_against_numpy(gpu: Any, name: str) -> None:
    model = ALL[name]
    check(name, run_hlsl(gpu, hlsl.shader(model), hlsl.pack(model), WI, WO), expected(model, WI, WO))


@pytest.mark.parametrize("name", ALL)
def test_hlsl_compiles(name: str, tmp_path: Path) -> None:
    validator = tool("glslangValidator")
    shader = hlsl.shader(ALL[name])
    call = "float f[7]; motes_eval(a, b, f);" if shader.channels == 7 else "float3 f = motes_eval(a, b);"
    main = f"float4 main(float3 a: A, float3 b: B) : SV_Target {{ {call} return float4(f[0], f[1], f[2], 1.0); }}"
    file = tmp_path / "material.hlsl"
    file.write_text(shader.source + main + "\n", encoding="utf-8")
    checked(validator, "-D", "-S", "frag", "-e", "main", "-V", file, "-o", tmp_path / "material.spv")


@pytest.mark.parametrize("name", ALL)
def test_c_in_double_against_numpy(name: str, tmp_path: Path) -> None:
    values = run_c(c.shader(ALL[name]), "double", WI, WO, tmp_path, "-O2", "-ffp-contract=off")
    reference = expected(ALL[name], WI, WO)
    assert error(np.broadcast_to(values, reference.shape), reference, 1e-3) < 1e-12


@pytest.mark.parametrize("name", ALL)
def test_c_in_float_against_numpy(name: str, tmp_path: Path) -> None:
    values = run_c(c.shader(ALL[name], scalar="float"), "float", WI, WO, tmp_path, "-O1")
    reference = expected(ALL[name], WI, WO)
    check(name, np.broadcast_to(values, reference.shape), reference)


@pytest.mark.parametrize("model", [MODELS["dusty"], MODELS["conductor"]])
def test_nan_stays_nan_in_c(model: BRDF, tmp_path: Path) -> None:
    wi, wo = WI[:512].astype(float), WO[:512].astype(float)
    wi[np.arange(0, 512, 4), np.arange(0, 512, 4) // 4 % 3] = np.nan
    wo[np.arange(2, 512, 8), np.arange(2, 512, 8) // 8 % 3] = np.nan
    values = run_c(c.shader(model), "double", wi, wo, tmp_path, "-O2")
    np.testing.assert_array_equal(np.isnan(values), np.isnan(model.eval(wi, wo)))
    assert 0.2 < np.isnan(values).mean() < 0.5


def test_c_header_serves_cpp(tmp_path: Path) -> None:
    compiler = tool("g++")
    (tmp_path / "material.h").write_text(c.shader(MODELS["conductor"]).source, encoding="utf-8")
    (tmp_path / "main.cpp").write_text(
        '#include "material.h"\n#include "material.h"\nint main() { double w[3] = {0, 0, 1}, f[3]; '
        "motes_eval(w, w, &motes_defaults, f); return f[0] > 0 ? 0 : 1; }\n",
        encoding="utf-8",
    )
    checked(compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror", tmp_path / "main.cpp", "-o", tmp_path / "main")
    checked(tmp_path / "main")


@pytest.mark.parametrize("scalar", c.SCALARS)
@pytest.mark.parametrize("name", ["dusty", "conductor", "spectral"])
def test_c_header_serves_cuda(name: str, scalar: str) -> None:
    """Compiled for a GPU by NVIDIA's runtime compiler, which needs none."""
    nvrtc = pytest.importorskip("cuda.bindings.nvrtc", reason="the package cuda-bindings is not installed")
    source = c.shader(ALL[name], scalar=scalar).source
    kernel = f"""
extern "C" __global__ void run(const {scalar} *wi, const {scalar} *wo, motes_parameters p, {scalar} *f) {{
    int k = blockIdx.x * blockDim.x + threadIdx.x;
    motes_eval(wi + 3 * k, wo + 3 * k, &p, f + {ALL[name].channels} * k);
}}
"""
    try:
        error, program = nvrtc.nvrtcCreateProgram((source + kernel).encode(), b"run.cu", 0, None, None)
    except RuntimeError as missing:
        pytest.skip(f"the library nvrtc is not installed: {missing}")
    (error,) = nvrtc.nvrtcCompileProgram(program, 1, [b"--gpu-architecture=compute_80"])
    _, size = nvrtc.nvrtcGetProgramLogSize(program)
    log = b" " * size
    nvrtc.nvrtcGetProgramLog(program, log)
    assert error == nvrtc.nvrtcResult.NVRTC_SUCCESS, log.decode()
    _, size = nvrtc.nvrtcGetPTXSize(program)
    ptx = b" " * size
    nvrtc.nvrtcGetPTX(program, ptx)
    assert (b".f64" in ptx) == (scalar == "double")  # no number slips into double precision in float


@pytest.mark.parametrize("module", [wgsl, hlsl])
def test_parameters_lie_where_the_comments_say(module: Any) -> None:
    model = DustLayer(OrenNayar(K_d=(0.1, 0.2, 0.3), sigma_d=0.4) + TorranceSparrow(K_s=(0.5, 0.6, 0.7)), tau=0.9)
    source, data = module.shader(model).source, np.frombuffer(module.pack(model), "f4")
    offsets = {name: int(at) for name, at in re.findall(r"(\w+) ?: .*// at byte (\d+):", source)}
    offsets = {name.removeprefix("motes_"): at for name, at in offsets.items()}
    assert data[offsets["K_d"] // 4 :][:3].tolist() == np.float32([0.1, 0.2, 0.3]).tolist()
    assert data[offsets["sigma_d"] // 4] == np.float32(0.4)
    assert data[offsets["K_s"] // 4 :][:3].tolist() == np.float32([0.5, 0.6, 0.7]).tolist()
    assert data[offsets["tau"] // 4] == np.float32(0.9)
    assert f"has {data.nbytes} bytes" in source
