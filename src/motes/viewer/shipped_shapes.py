"""The meshes of the viewer, with the dust that settles on them, as the file that ships with Motes.

``tools/viewer_build.py`` writes it (needs the extra ``render``, for the rays): the shapes of `motes.meshes.shapes` at a size that suits a page,
and on their vertices the share of `motes.rendering.deposition` without its noise.
"""

from __future__ import annotations

import json
from functools import cache
from importlib import resources
from typing import Any, cast

import numpy as np

from motes.viewer.contract import ShapesView, ShapeView
from motes.viewer.packing import packed

FILE = "shapes.json"
STEPS = 61  # of the angle from 0 to 180 degrees


@cache
def shapes() -> ShapesView:
    """The file that ships with Motes."""
    text = resources.files("motes.viewer").joinpath("static", FILE).read_text(encoding="utf-8")
    return cast(ShapesView, json.loads(text))


def make() -> ShapesView:
    """The meshes and their dust, computed."""
    from motes.meshes.shapes import bunny, sphere, teapot
    from motes.rendering.deposition import settled_options
    from motes.rendering.gathering import falling, hold

    theta = np.linspace(0, np.pi, STEPS)
    normals = np.stack([np.sin(theta), np.cos(theta), 0 * theta], -1)
    options = settled_options({})
    directions = falling(np.array([0.0, 1.0, 0.0]), options["spread_deg"], 1024)
    fall = np.maximum(normals @ directions.T, 0).mean(1) / directions[:, 1].mean()
    share = fall * hold(normals[:, 1], options["adhesion"], options["slipperiness"])
    meshes = [_view(mesh) for mesh in (sphere(48), teapot(10), bunny(1))]
    return {"shapes": meshes, "dust_by_inclination": [round(float(s), 4) for s in share]}


def _view(mesh: Any) -> ShapeView:
    from motes.rendering.deposition import deposit

    low, high = mesh.bounds
    # Smooth noise is finer than the vertices of so small a mesh.
    share = np.clip(deposit(mesh, noise=0.0).share, 0, 1)
    return {
        "name": mesh.name,
        "low": tuple(low.tolist()),
        "high": tuple(high.tolist()),
        "positions": packed(_steps(mesh.positions, low, high), "<u2"),
        "normals": packed(np.round(mesh.normals * 32767), "<i2"),
        "triangles": packed(mesh.triangles, "<u2"),
        "dust": packed(np.round(share * 255), "u1"),
    }


def _steps(positions: Any, low: Any, high: Any) -> Any:
    """Positions in 65,535 steps of the box; vertices of a seam, which rounding of the last bits keeps apart, come to the same step."""
    return np.round(np.round((positions - low) / (high - low) * 65535, 3))
