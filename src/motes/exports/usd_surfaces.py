"""Fitted surfaces as networks of USD: nodes of MaterialX, over dust where it varies, and UsdPreviewSurface for programs that know no other."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from motes.exports.surface_files import NODES, comment, names, rounded
from motes.exports.surface_fit import SurfaceFit, fit_surface
from motes.exports.surface_over_tau import OverTau
from motes.exports.usd_library import library
from motes.exports.usd_stage import Link, Node, Stage
from motes.meshes.shapes import sphere
from motes.models import GltfSurface
from motes.models.surfaces.gltf_surface import NORMAL

Floats = NDArray[np.float64]

#: What of glTF's surface a UsdPreviewSurface is: no sheen, a dielectric of the usual or of some other index, or a share of metal.
PREVIEW = (
    "gltf(metallic=0, specular=1, specular_color=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
    "gltf(metallic=0, specular=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
    "gltf(specular=1, specular_color=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
)
#: Programs differ in how a strong highlight darkens what lies below, so that another index must be so much nearer.
CLEARLY = 0.5
#: The largest reflectance at normal incidence that an index is made of: 10.
LARGEST = 0.66
TAU = "tau"
#: Frames from one moment to the next of a material that changes.
STEP = 24
RINGS, APART = 48, 2.4


def uniform(kind: str, values: Mapping[str, Any]) -> list[Node]:
    """A surface with numbers and colours as they are; a mapping of frames to values changes with them."""
    return [Node("surface", f"ND_{NODES[kind]}_surfaceshader", "token", {k: _given(v) for k, v in values.items()})]


def over_dust(kind: str, over: OverTau) -> list[Node]:
    """A surface that looks up its parameters by the primvar ``tau``: for each stretch between two thicknesses how much of it is behind, 0 to 1, and from
    one fitted value to the next by that much."""
    nodes = [Node("dust", "ND_geompropvalue_float", "float", {"geomprop": ("string", TAU), "default": ("float", 0.0)})]
    stretches = list(pairwise(rounded(over.tau.tolist())))
    for k, (low, high) in enumerate(stretches, 1):
        told = {"inlow": low, "inhigh": high, "outlow": 0.0, "outhigh": 1.0, "gamma": 1.0}
        inputs: dict[str, tuple[str, Any]] = {"in": ("float", Link("dust")), "doclamp": ("bool", True)}
        inputs |= {name: ("float", value) for name, value in told.items()}
        nodes.append(Node(f"stretch_{k}", "ND_range_float", "float", inputs))
    found: dict[str, tuple[str, Any]] = {}
    for name, values in over.values.items():
        if np.ptp(values, axis=0).max() < 1e-6:
            found[name] = _given(values[0])
            continue
        last = _given(values[0])
        kind_of = last[0]
        for k, value in enumerate(values[1:], 1):
            inputs = {"bg": last, "fg": _given(value), "mix": ("float", Link(f"stretch_{k}"))}
            definition = f"ND_mix_{'color3' if kind_of == 'color3f' else 'float'}"
            nodes.append(Node(f"{name}_{k}", definition, kind_of, inputs))
            last = (kind_of, Link(f"{name}_{k}"))
        found[name] = last
    return [*nodes, Node("surface", f"ND_{NODES[kind]}_surfaceshader", "token", found)]


def preview(values: Mapping[str, Any]) -> list[Node]:
    """A UsdPreviewSurface; a text in the place of a value is the primvar that has it."""
    nodes, inputs = [], {}
    for name, value in values.items():
        if isinstance(value, str):
            kind, reader = ("color3f", "float3") if name == "diffuseColor" else ("float", "float")
            told = {"varname": ("string", value)}
            nodes.append(Node(f"{name}_by_vertex", f"UsdPrimvarReader_{reader}", kind, told, "result"))
            inputs[name] = (kind, Link(f"{name}_by_vertex"))
        else:
            inputs[name] = _given(value)
    return [*nodes, Node("preview", "UsdPreviewSurface", "token", inputs, "surface")]


def previewed(surface: GltfSurface) -> GltfSurface:
    """The surface with what a UsdPreviewSurface has: the highlight of a dielectric without a colour."""
    return surface.with_parameters({"specular_color": min(float(np.mean(surface.specular_color)), LARGEST / NORMAL)})


def preview_values(parameters: Mapping[str, Any]) -> dict[str, Floats]:
    """The inputs of a UsdPreviewSurface from the parameters of what is `previewed`, for one place or many."""
    normal = np.asarray(parameters["specular_color"], np.float64)
    root = np.sqrt(NORMAL * (normal[..., 0] if normal.ndim else normal))
    return {
        "diffuseColor": np.asarray(parameters["base_color"], np.float64),
        "metallic": np.asarray(parameters["metallic"], np.float64),
        "roughness": np.asarray(parameters["roughness"], np.float64),
        "ior": np.asarray((1 + root) / (1 - root)),
    }


def _given(value: Any) -> tuple[str, Any]:
    if isinstance(value, Mapping):
        kinds = {frame: _given(each) for frame, each in value.items()}
        return next(iter(kinds.values()))[0], {frame: each for frame, (_, each) in kinds.items()}
    flat = rounded(np.ravel(value).tolist())
    return ("color3f", flat) if len(flat) == 3 else ("float", flat[0])


def write_fits(fits: Sequence[SurfaceFit], path: Path) -> Path:
    """Materials of fitted parameters, each on a sphere, in a row; of several moments one more that changes over frames.

    Raises
    ------
    MissingExtraError
        Without the package usd-core.
    """
    library()
    kind = type(fits[0].surface).__name__
    previews = [fit_surface(fit.what, GltfSurface, PREVIEW, previewed, CLEARLY) for fit in fits]
    lines = [
        *comment(fits),
        *(f"UsdPreviewSurface, for programs without MaterialX: {each.said()}" for each in previews),
    ]
    called = names(fits)
    if len(fits) > 1:
        lines.append(f"The material {fits[0].what.identifier} changes: a moment every {STEP} frames.")
    stage = Stage(f"{fits[0].what.identifier}_materials", lines)
    ball = sphere(RINGS)
    written = [fit.surface.written() for fit in fits]
    plain = [preview_values(each.surface.written()) for each in previews]
    for k, name in enumerate(called):
        made = stage.material(name, {"mtlx": uniform(kind, written[k]), "": preview(plain[k])})
        place, _ = stage.mesh(f"{name}_sphere", ball, (APART * k, 0.0, 0.0))
        stage.bind(place, made)
    if len(fits) > 1:
        frames = [1.0 + STEP * k for k in range(len(fits))]
        stage.frames(frames)
        everything = {key: value for each in reversed(written) for key, value in each.items()}
        told = {key: [each.get(key, everything[key]) for each in written] for key in everything}
        shown = {key: [each[key] for each in plain] for key in plain[0]}
        changing = [
            {key: dict(zip(frames, values, strict=True)) for key, values in columns.items()}
            for columns in cast(tuple[Mapping[str, Any], ...], (told, shown))
        ]
        made = stage.material(fits[0].what.identifier, {"mtlx": uniform(kind, changing[0]), "": preview(changing[1])})
        place, _ = stage.mesh(f"{fits[0].what.identifier}_sphere", ball, (0.0, 0.0, APART))
        stage.bind(place, made)
    return stage.save(path)
