"""Preview scenes: one object on a studio floor, lit so that colour, highlight and grazing behaviour can be told apart.

The floor runs up into the back wall without an edge.  A large softbox at the upper left is the key light, a tall one at the right fills, a strip behind
the object draws its outline, and a dim white dome lights what is left.  With an environment map the softboxes and the wall give way to it, and the floor
becomes a round table.  All is white or grey: what has a colour is the material.
"""

from __future__ import annotations

import difflib
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import FormatError, MotesError
from motes.meshes.mesh import Mesh, with_normals
from motes.meshes.meshfile import SUFFIXES, read_mesh
from motes.meshes.shapes import SHAPES
from motes.rendering.flat import LAMP_DEG, flat
from motes.rendering.loading import native
from motes.rendering.rays import mitsuba_mesh

NAMES = ("sphere", "bunny", "teapot", "grid")
FLAT = "flat"
FLOOR = 0.55  # reflectance: a white highlight and a dark material both stand out from it
TARGET, EYE = (0.0, 0.93, 0.0), (0.0, 2.35, 7.2)
DEPTH = 4  # of a path: light that the floor gives back to the object, and once more
LARGEST_SIDE = 8192


class Subject(NamedTuple):
    """What is shown: a mesh on the stage, or None for the exact sphere of the preview, and for the flat sample, `aspect` times as wide as high."""

    mesh: Mesh | None
    name: str
    aspect: float = 1.0


def subject(scene: str, up: ArrayLike = (0.0, 1.0, 0.0)) -> Subject:
    """The object of a preview by name, or from a file (PLY, OBJ, STL, glTF) whose up direction is `up`, scaled to the stage.

    Raises
    ------
    MotesError
        For an unknown name; it suggests close ones.
    FormatError
        For a file that is not there or not a mesh.
    """
    if scene in ("sphere", "grid", FLAT):
        return Subject(None, scene)
    if scene in SHAPES:
        return Subject(SHAPES[scene](), scene)
    path = Path(scene)
    if path.suffix.lower() in SUFFIXES:
        if not path.is_file():
            raise FormatError(f"{path} does not exist", _suggestion(scene) or "Give the path of a mesh")
        return Subject(on_stage(read_mesh(path), up), path.stem)
    raise MotesError(
        f"{scene[:80]!r} is not a scene",
        _suggestion(scene)
        or f"Choose {', '.join((*NAMES, FLAT))}, a mesh ({', '.join(SUFFIXES)}) or a Mitsuba scene (.xml)",
    )


def _suggestion(scene: str) -> str:
    """Did you mean ...?  Names of previews, and files beside the one that is not there."""
    path = Path(scene)
    files = [str(p) for p in path.parent.iterdir()] if path.parent.is_dir() else []
    files = [f for f in files if Path(f).suffix.lower() in (*SUFFIXES, ".xml")]
    close = difflib.get_close_matches(scene.lower(), (*NAMES, FLAT), n=1, cutoff=0.5) or difflib.get_close_matches(
        scene, files, n=2, cutoff=0.6
    )
    return f"Did you mean {' or '.join(close)}?" if close else ""


def on_stage(mesh: Mesh, up: ArrayLike = (0.0, 1.0, 0.0)) -> Mesh:
    """The mesh turned, standing on y = 0 over the origin, 2 units across or 1.9 high, whichever comes first."""
    turned = mesh.moved(up=up)
    low, high = turned.bounds
    size = np.maximum(high - low, 1e-12)
    scale = min(2.2 / max(size[0], size[2]), 1.9 / size[1])
    middle = 0.5 * (low + high)
    placed = turned.moved(scale, -scale * np.array([middle[0], low[1], middle[2]]))
    return placed if placed.normals is not None else with_normals(placed)


def preview(
    item: Subject,
    bsdf: Mapping[str, Any],
    *,
    size: tuple[int, int] = (512, 512),
    env: str | os.PathLike[str] | None = None,
    lamp_deg: tuple[float, ...] = LAMP_DEG,
) -> dict[str, Any]:
    """A preview as a dictionary for Mitsuba, the object under the key ``object``.

    Parameters
    ----------
    item
        From `subject`; attributes of its mesh are there as ``vertex_NAME``.
    bsdf
        A dictionary for Mitsuba.
    size
        Width and height in pixels.
    env
        An environment map (EXR, HDR), y up, in place of the softboxes.
    lamp_deg
        Where the lamp over a flat sample stands; see `motes.rendering.flat`.

    Raises
    ------
    MotesError
        For a size out of range.
    FormatError
        When the environment map is not there.
    """
    from motes.rendering import load_mitsuba, load_scene

    mi = load_mitsuba()
    if item.name == FLAT and item.mesh is None:
        light = None if env is None else _environment(mi, env)
        return flat(bsdf, item.aspect, _film(size), lamp_deg=lamp_deg, environment=light)
    transform = mi.ScalarTransform4f
    if item.mesh is None:
        shape: Any = {"type": "sphere", "center": [0.0, 0.95, 0.0], "radius": 0.95, "bsdf": load_scene(bsdf)}
    else:
        properties = mi.Properties()
        properties["bsdf"] = load_scene(_two_sided(bsdf))
        shape = mitsuba_mesh(mi, item.mesh, properties)
    floor = {"type": "twosided", "inner": {"type": "diffuse", "reflectance": _grey(FLOOR)}}
    ground = {
        "type": "disk",
        "to_world": transform().rotate([1, 0, 0], -90).scale(2.1),
        "bsdf": floor,
    }
    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": DEPTH, "hide_emitters": env is None},
        "sensor": {
            "type": "perspective",
            "fov": _fov_deg(item, size),
            "fov_axis": "x",
            "to_world": transform().look_at(origin=list(EYE), target=list(TARGET), up=[0, 1, 0]),
            "film": _film(size),
            "sampler": {"type": "multijitter"},  # half the noise of independent samples here
        },
        "object": shape,
        **(_studio(mi, floor) if env is None else {"floor": ground, "environment": _environment(mi, env)}),
    }


def _fov_deg(item: Subject, size: tuple[int, int]) -> float:
    """A horizontal field of view in which the object fills three quarters of the picture, across or upwards."""
    low, high = (np.array([-0.95, 0, -0.95]), np.array([0.95, 1.9, 0.95])) if item.mesh is None else item.mesh.bounds
    across = max(abs(low[0]), abs(high[0]), 0.6)
    upwards = max(0.5 * (high[1] - low[1]), 0.6)
    distance = float(np.linalg.norm(np.subtract(EYE, TARGET)))
    half = max(across, upwards * size[0] / max(size[1], 1))
    return float(np.rad2deg(2 * np.arctan(half / (0.75 * distance))))


def _two_sided(bsdf: Mapping[str, Any]) -> dict[str, Any]:
    """A mesh may be open (the teapot's rim, a leaf): it looks the same from behind."""
    return dict(bsdf) if bsdf.get("type") == "twosided" else {"type": "twosided", "inner": dict(bsdf)}


def _grey(value: float) -> dict[str, Any]:
    return {"type": "uniform", "value": value}


def _film(size: tuple[int, int]) -> dict[str, Any]:
    width, height = size
    if not (1 <= width <= LARGEST_SIDE and 1 <= height <= LARGEST_SIDE):
        raise MotesError(f"a picture of {width} x {height} pixels", f"Choose sides from 1 to {LARGEST_SIDE}")
    return {"type": "hdrfilm", "width": width, "height": height, "rfilter": {"type": "gaussian"}, "pixel_format": "rgb"}


def _environment(mi: Any, env: str | os.PathLike[str]) -> dict[str, Any]:
    path = Path(env)
    if not path.is_file():
        raise FormatError(f"{path} does not exist", "Give the path of an environment map, an EXR or HDR picture")
    try:
        mi.Bitmap(native(path))
    except RuntimeError as error:
        reason = str(error).splitlines()[-1][:160]
        raise FormatError(f"{path} cannot be read as a picture: {reason}", "Give an EXR or HDR picture") from None
    return {"type": "envmap", "filename": native(path.resolve())}


def _studio(mi: Any, floor: Mapping[str, Any]) -> dict[str, Any]:
    """Floor, wall and lights."""
    transform = mi.ScalarTransform4f

    def softbox(
        at: tuple[float, float, float], towards: tuple[float, float, float], size: tuple[float, float], radiance: float
    ) -> dict[str, Any]:
        placed = transform().look_at(origin=list(at), target=list(towards), up=[0, 1, 0.01])
        return {
            "type": "rectangle",
            "to_world": placed.scale([0.5 * size[0], 0.5 * size[1], 1]),
            "emitter": {"type": "area", "radiance": _grey(radiance)},
            "bsdf": {"type": "diffuse", "reflectance": _grey(0.0)},
        }

    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(dict(floor))
    return {
        "floor": mitsuba_mesh(mi, _sweep(), properties),
        "key": softbox((-4.2, 5.2, 3.6), (0, 0.8, 0), (3.2, 3.2), 12.5),
        "fill": softbox((5.5, 2.8, 3.2), (0, 0.9, 0), (2.0, 4.0), 2.6),
        "rim": softbox((3.2, 4.6, -3.4), (0, 1.0, 0), (2.6, 1.4), 9.0),
        "dome": {"type": "constant", "radiance": _grey(0.3)},
    }


def _sweep() -> Mesh:
    """The floor that becomes the wall: a profile in z and y drawn along x."""
    angle = np.linspace(0, 0.5 * np.pi, 33)
    radius, back = 4.0, -4.5
    z = np.concatenate([[14.0], back - radius * np.sin(angle), [back - radius]])
    y = np.concatenate([[0.0], radius * (1 - np.cos(angle)), [14.0]])
    positions = np.array([[x, b, a] for x in (-24.0, 24.0) for a, b in zip(z, y, strict=True)])
    n = len(z)
    i = np.arange(n - 1)
    triangles = np.concatenate([np.stack([i, i + n, i + n + 1], -1), np.stack([i, i + n + 1, i + 1], -1)])
    return with_normals(Mesh(positions, triangles.astype(np.int32), name="floor"), crease_deg=60)
