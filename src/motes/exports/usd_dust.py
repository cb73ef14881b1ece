"""A dusty mesh as USD: tau at its vertices, and a material that looks it up; of several days one frame each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.exports.subject import identifier
from motes.exports.surface_over_tau import Progress, fit_over_tau
from motes.exports.usd_library import library
from motes.exports.usd_stage import Stage
from motes.exports.usd_surfaces import CLEARLY, PREVIEW, TAU, over_dust, preview, preview_values, previewed
from motes.meshes.mesh import Mesh, unit
from motes.models import BRDF, GltfSurface, OpenPBR
from motes.version import __version__

Floats = NDArray[np.float64]
#: What of OpenPBR is fitted over dust.  The tint of the highlight is left out: with it several sets of parameters look alike, and no line leads from one to
#: another.
OVER_DUST = (
    "openpbr(base_metalness=0, specular_ior=1.5, specular_color=1, fuzz_weight=0, fuzz_color=1, fuzz_roughness=0.5)",
    "openpbr(base_metalness=0, specular_ior=1.5, specular_color=1)",
    "openpbr(specular_ior=1.5, specular_color=1)",
)
#: The primvars that the preview reads, by its inputs.
READERS = {
    "diffuseColor": "displayColor",
    "metallic": "motes_metallic",
    "roughness": "motes_roughness",
    "ior": "motes_ior",
}


def write_usd(
    path: Path,
    mesh: Mesh,
    model: BRDF,
    moments: Sequence[tuple[float, Floats]],
    told: str,
    *,
    up: ArrayLike = (0.0, 1.0, 0.0),
    progress: Progress | None = None,
) -> tuple[str, ...]:
    """Write a mesh under dust as USD.

    Parameters
    ----------
    path
        ``.usda`` (text), ``.usdc``, ``.usd`` (binary) or ``.usdz``.
    mesh
        With normals.
    model
        What it is made of, with a layer of dust on top, whose depth each vertex has its own of.
    moments
        Days, increasing, with tau (V,) then; a frame is a day.
    told
        A sentence for the file.
    up
        Against gravity.  USD knows y and z; a mesh with another way up is turned.
    progress
        Told the number of fits done, how many there are, and a word.

    Returns
    -------
    tuple of str
        What the file cannot say, and how far its surfaces are from the material, a sentence each.

    Raises
    ------
    MissingExtraError
        Without the package usd-core.
    ParameterError
        For a model without dust on top.
    DataError
        For other than one or three channels.
    """
    library()
    largest = max(float(tau.max()) for _, tau in moments)
    over = fit_over_tau(model, OpenPBR, largest, texts=OVER_DUST, progress=progress)
    plain = fit_over_tau(model, GltfSurface, largest, texts=PREVIEW, made=previewed, clearly=CLEARLY)
    axis, placed, notes = _placed(mesh, up)
    notes += [
        f"MaterialX: {over.said()}",
        f"UsdPreviewSurface, for programs without MaterialX: {plain.said()}",
        over.surface.left_out,
    ]
    lines = [f"Motes {__version__}: {told}", "Lengths are taken as metres. Colour is linear sRGB.", *notes]
    if len(moments) > 1:
        lines.append(f"A frame is a day; what lies under the dust is as on day {moments[-1][0]:g}.")
    stage = Stage(identifier(mesh.name), lines, axis)
    made, used = stage.mesh("mesh", placed)
    frames: list[float | None] = [None] if len(moments) == 1 else [day for day, _ in moments]
    if len(moments) > 1:
        stage.frames([day for day, _ in moments])
    taus = [tau[used] for _, tau in moments]
    looks = [preview_values(plain.at(tau)) for tau in taus]
    columns = {TAU: taus} | {primvar: [look[name] for look in looks] for name, primvar in READERS.items()}
    for name, values in columns.items():
        stage.over_vertices(made, name, list(zip(frames, values, strict=True)))
    stage.bind(made, stage.material("dusty", {"mtlx": over_dust("OpenPBR", over), "": preview(READERS)}))
    stage.save(path)
    return tuple(notes)


def _placed(mesh: Mesh, up: ArrayLike) -> tuple[str, Mesh, list[str]]:
    """The axis that is up, the mesh in it, and what was done to it."""
    way = unit(np.asarray(up, np.float64), "up")
    for name, axis in (("Y", (0.0, 1.0, 0.0)), ("Z", (0.0, 0.0, 1.0))):
        if np.allclose(way, axis):
            return name, mesh, []
    turned = replace(mesh.moved(up=way), attributes=mesh.attributes)
    return "Y", turned, ["The mesh is turned so that y is up: USD knows y and z alone."]
