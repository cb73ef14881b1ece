"""Exports, run or read back where the user is: each target of `motes.exports` by name, and what it answers for pairs of directions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from motes.certification.glsl_specimen import open_gl
from motes.certification.materialx_run import run_materialx, shaders_of
from motes.certification.mitsuba_specimen import VARIANT, bsdf_of, evaluated
from motes.certification.shader_runs import open_gpu, run_c, run_glsl, run_hlsl, run_wgsl
from motes.certification.specimen import Floats, Numbers
from motes.errors import DataError, FormatError, MotesError
from motes.exports import TARGETS, export, tristimulus
from motes.exports import c as c_header
from motes.exports import glsl as glsl_shader
from motes.exports import hlsl as hlsl_shader
from motes.exports import wgsl as wgsl_shader
from motes.exports.subject import Subject
from motes.measurements import Measurement, read
from motes.rendering import load_mitsuba, load_scene

Values = Callable[[Floats, Floats], Floats]
#: Relative differences that are no fault: of float64, of float32, of float32 with parameters that a document has in six decimals, of tables with
#: the digits of text; and of tables over patches or between nodes the median.
DOUBLE, SINGLE, SIX_DECIMALS, TEXT, DIGITS, PATCHES = 1e-9, 5e-4, 5e-3, 1e-6, 1e-3, 0.1
#: Tables of lighting, which hold one visible response or X, Y and Z.
XYZ = ("klems", "tensortree", "zemax")
#: Samples of a table that are looked at.
MOST_SAMPLES = 20_000


@dataclass(frozen=True)
class Run:
    """A target that was run here.

    Attributes
    ----------
    how
        By what, in words.
    values
        Of any directions (N, 3), (N, 3), in the channels (N, C); or of `pairs` alone.
    tolerance
        The largest relative difference that is no fault; where `typical`, that of the median.
    pairs
        The directions that a table has, or None.
    typical
        Whether a table averages, so that its single values differ.
    matrix
        What makes the target's channels of the material's (C, K): X, Y and Z; None where they are the same.
    """

    how: str
    values: Values
    tolerance: float
    pairs: tuple[Floats, Floats] | None = None
    typical: bool = False
    matrix: Floats | None = None


Runner = Callable[[Subject, Path], Run]


def _c(scalar: str, what: Subject, folder: Path) -> Run:
    shader = c_header.shader(what.brdf, scalar=scalar)
    version = run_c(shader, scalar, *_one())[1]
    tolerance = DOUBLE if scalar == "double" else SINGLE
    return Run(f"{scalar}, compiled by {version}", lambda wi, wo: run_c(shader, scalar, wi, wo)[0], tolerance)


def _glsl(version: str, what: Subject, folder: Path) -> Run:
    context, shader = open_gl(), glsl_shader.shader(what.brdf, version)
    how = f"GLSL {version}, drawn by {context.info['GL_RENDERER']}"
    return Run(how, lambda wi, wo: _wide(run_glsl(context, shader, version, wi, wo)), SINGLE)


def _wgsl(what: Subject, folder: Path) -> Run:
    device, shader, buffer = open_gpu(), wgsl_shader.shader(what.brdf), wgsl_shader.pack(what.brdf)
    return Run(f"computed by {_adapter(device)}", lambda wi, wo: _wide(run_wgsl(device, shader, buffer, wi, wo)), SINGLE)  # fmt: skip


def _hlsl(what: Subject, folder: Path) -> Run:
    device, shader, buffer = open_gpu(), hlsl_shader.shader(what.brdf), hlsl_shader.pack(what.brdf)
    how = f"SPIR-V by glslang, computed by {_adapter(device)}"
    return Run(how, lambda wi, wo: _wide(run_hlsl(device, shader, buffer, wi, wo)), SINGLE)


def _wide(values: Numbers) -> Floats:
    return values.astype(np.float64)


def _adapter(device: Any) -> str:
    return str(device.adapter.info.get("device") or "WebGPU")


def _materialx(what: Subject, folder: Path) -> Run:
    context = open_gl()
    path = _written(what, "materialx", folder)
    vertex, pixel, version = shaders_of(path, f"motes_{what.identifier}_value")
    how = f"GLSL by MaterialX {version}, drawn by {context.info['GL_RENDERER']}"
    return Run(how, lambda wi, wo: _wide(run_materialx(context, vertex, pixel, wi, wo)), SIX_DECIMALS)


def _mitsuba(what: Subject, folder: Path) -> Run:
    what.colored(VARIANT)
    mi = load_mitsuba(VARIANT)
    path = _written(what, "mitsuba", folder)
    scene = folder / "scene.xml"
    shape = f'<shape type="rectangle"><ref id="{what.identifier}"/></shape>'
    scene.write_text(
        f'<scene version="3.0.0"><include filename="{path.name}"/>{shape}</scene>\n',
        encoding="utf-8",
    )
    bsdf = bsdf_of(mi, load_scene(scene))
    return Run(f"Mitsuba {mi.__version__}, {VARIANT}", lambda wi, wo: evaluated(mi, bsdf, wi, wo), SIX_DECIMALS)


def _table(to: str, what: Subject, folder: Path, *, tolerance: float = TEXT, typical: bool = False) -> Run:
    """A table, read back by Motes' reader; at the samples that it has."""
    if to == "merl":
        what.colored("a MERL table")
    data = read(_written(what, to, folder))
    if not isinstance(data, Measurement):
        raise FormatError("what was written is read as a map", "Report it: this is a defect")
    matrix = tristimulus.matrix_of(what) if to in XYZ else None
    if matrix is None and data.n_channels != what.brdf.channels and what.brdf.channels != 1:
        raise DataError(
            f"it holds {data.n_channels} of the {what.brdf.channels} channels", "Compare its colours by eye"
        )
    usable = np.flatnonzero(data.mask[0].all(axis=1))
    if not len(usable):
        raise FormatError("of what was written no sample is usable", "Report it: this is a defect")
    if len(usable) > MOST_SAMPLES:
        usable = np.sort(np.random.default_rng(21).choice(usable, MOST_SAMPLES, replace=False))
    wi, wo, found = data.wi[usable], data.wo[usable], np.asarray(data.values[0][usable], np.float64)
    rows = {a.tobytes() + b.tobytes(): k for k, (a, b) in enumerate(zip(wi, wo, strict=True))}

    def values(a: Floats, b: Floats) -> Floats:
        return found[[rows[x.tobytes() + y.tobytes()] for x, y in zip(a, b, strict=True)]]

    return Run(f"read back, {len(usable):,} samples", values, tolerance, (wi, wo), typical, matrix)


def _osl(what: Subject, folder: Path) -> Run:
    raise MotesError("a shader in OSL runs in a renderer alone", "The tests run it in Blender's Cycles")


def _three(what: Subject, folder: Path) -> Run:
    raise MotesError("a module for three.js runs in a browser alone; its formula is that of glsl", "The tests run it in Chromium")  # fmt: skip


def _fitted(what: Subject, folder: Path) -> Run:
    raise MotesError("its own parameters are fitted, and need not agree", "motes export says by how much they miss")


def _written(what: Subject, to: str, folder: Path) -> Path:
    path = folder / f"{what.identifier}{TARGETS[to].suffix}"
    return export(what.material, to, path, hours=what.hours).files[0]


def _one() -> tuple[Floats, Floats]:
    up = np.array([[0.0, 0.0, 1.0]])
    return up, up


#: How each target is run; C and GLSL in both of their forms.
RUNNERS: Mapping[str, tuple[Runner, ...]] = {
    "c": (partial(_c, "double"), partial(_c, "float")),
    "glsl": (partial(_glsl, "300 es"), partial(_glsl, "450")),
    "wgsl": (_wgsl,),
    "hlsl": (_hlsl,),
    "osl": (_osl,),
    "materialx": (_materialx,),
    "mitsuba": (_mitsuba,),
    "three": (_three,),
    "merl": (partial(_table, "merl"),),
    "csv": (partial(_table, "csv"),),
    "bird": (partial(_table, "bird"),),
    "openmaterial": (partial(_table, "openmaterial"),),
    "rgl": (partial(_table, "rgl", tolerance=PATCHES, typical=True),),
    "klems": (partial(_table, "klems", tolerance=PATCHES, typical=True),),
    "tensortree": (partial(_table, "tensortree", tolerance=PATCHES, typical=True),),
    "zemax": (partial(_table, "zemax", tolerance=DIGITS),),
    "openpbr": (_fitted,),
    "standard_surface": (_fitted,),
    "gltf": (_fitted,),
    "blender": (_fitted,),
}
