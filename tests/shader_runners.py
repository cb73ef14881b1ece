"""Running printed shaders as `motes certify` does, but C through a compiler that warns of nothing.  Each is skipped, by name, where its tool is missing."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.certification import glsl_specimen, shader_runs
from motes.certification.shader_runs import run_glsl, run_wgsl
from motes.errors import MotesError
from motes.exports.shaders import Shader

__all__ = ["checked", "open_gl", "open_gpu", "run_c", "run_glsl", "run_hlsl", "run_wgsl", "tool"]
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


# ---------------------------------------------------------------- OpenGL, WebGPU


def open_gl() -> Any:
    """An OpenGL context without a window."""
    pytest.importorskip("moderngl", reason="moderngl is not installed")
    try:
        return glsl_specimen.open_gl()
    except MotesError as error:
        pytest.skip(f"no OpenGL 4.3 without a window here (EGL, llvmpipe): {error}")


def open_gpu() -> Any:
    """A WebGPU device."""
    pytest.importorskip("wgpu", reason="wgpu is not installed")
    try:
        return shader_runs.open_gpu()
    except MotesError as error:
        pytest.skip(f"no WebGPU adapter here (Vulkan, lavapipe): {error}")


def run_hlsl(device: Any, shader: Shader, parameters: bytes, wi: Directions, wo: Directions) -> NDArray[np.float32]:
    """The values of a shader in HLSL, which becomes SPIR-V by glslang."""
    tool("glslangValidator")
    return shader_runs.run_hlsl(device, shader, parameters, wi, wo)


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
