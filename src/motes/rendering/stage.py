"""A material on a stage: from a time to a picture's radiance."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.ageing import age
from motes.errors import MotesError
from motes.material import Material
from motes.meshes.shapes import SHAPES
from motes.models import layer_of
from motes.rendering.deposition import Deposit, checked_tau, deposit, open_tau
from motes.rendering.passes import Look, rendered
from motes.rendering.rays import Progress
from motes.rendering.scenes import FLAT, Subject, on_stage, preview, subject
from motes.rendering.user_scene import user_scene

if TYPE_CHECKING:
    from motes.maps import FittedMap

Floats = NDArray[np.floating[Any]]
SMALL = 96  # pixels along a side, and 16 samples, where only the scalar variant runs
HOURS_A_DAY = 24.0


class Stage(NamedTuple):
    """What is drawn at a time [h], and sentences on what was assumed for it."""

    draw: Callable[[float], Floats]
    notes: tuple[str, ...] = ()


def stage(
    material: Material | FittedMap,
    look: Look,
    folder: Path,
    *,
    hours: tuple[float, float] = (0.0, 24.0),
    settling: Mapping[str, Any] | None = None,
    scattering: str | None = None,
    progress: Progress | None = None,
) -> Stage:
    """A material on its stage.

    Parameters
    ----------
    material
        May follow time; or a fitted map.
    look
        The scene, and how it is rendered.
    folder
        Where the material is written for Mitsuba to read, for as long as the stage is used.
    hours
        Over which dust gathers, where `settling` is wanted and the material has none.
    settling
        Keyword arguments of `motes.rendering.deposition.deposit`: dust then lies where it would settle.  None leaves a layer of dust even, except on a mesh
        whose file holds ``tau``, which is used.
    scattering
        ``"single"`` or ``"multiple"``, of dust that is laid over a material that has none; multiple where not given.
    progress
        Called with (done, total, what) while rays are traced.

    Raises
    ------
    MotesError
        For an unknown scene, a tau out of range, or a scene that Mitsuba cannot load.
    """
    if not isinstance(material, Material):
        return _map_stage(material, look, hours, settling)
    if look.is_xml:
        if settling is not None:
            raise MotesError(
                "dust cannot be deposited in a Mitsuba scene",
                "motes dust writes a mesh with tau, which the scene can load as the attribute vertex_tau",
            )
        return Stage(user_scene(look, _saved(material, folder)))
    item = subject(look.scene, look.up)
    notes: list[str] = []
    share: Deposit | None = None
    own: Floats | None = None
    if settling is not None:
        if item.name == FLAT and item.mesh is None:
            raise MotesError(
                "dust lies evenly on a flat sample",
                "Leave --deposit out, or choose another scene: sphere, bunny, teapot",
            )
        item = _as_mesh(item)
        assert item.mesh is not None
        share = deposit(item.mesh, progress=progress, **settling)
    elif item.mesh is not None and "tau" in item.mesh.attributes:
        own = checked_tau(item.mesh.attributes["tau"], look.scene)
        notes.append(f"dust lies as {item.name} says: tau up to {own.max():.3g}")
    dusty = share is not None or own is not None
    if dusty and layer_of(material.brdf) is None:
        material = age(material, "dust", hours=_gathering(hours), scattering=scattering)
        grown = (
            "" if own is not None else f", tau to {open_tau(hours[1] / HOURS_A_DAY, material=material):.3g} in the open"
        )
        notes.append(
            f"the material has no dust; that of the phenomenon lies on it{grown}; {scattering or 'multiple'} scattering"
        )
    file, layer = _saved(material, folder), layer_of(material.brdf)

    def described(time: float) -> dict[str, Any]:
        bsdf: dict[str, Any] = {"type": "motes_material", "filename": str(file), "time": float(time)}
        shown = item
        if item.mesh is not None and dusty:
            tau = own if share is None else share.tau(open_tau(time / HOURS_A_DAY, material=material))
            assert tau is not None
            assert layer is not None
            shown = Subject(item.mesh.with_attribute("tau", tau), item.name)
            bsdf[layer.depth.name] = {"type": "mesh_attribute", "name": "vertex_tau"}
        return preview(shown, bsdf, size=look.size, env=look.env, lamp_deg=look.lamp_deg)

    def draw(time: float) -> Floats:
        return rendered(lambda: described(time), look)

    return Stage(draw, tuple(notes))


def _map_stage(fitted: FittedMap, look: Look, hours: tuple[float, float], settling: Mapping[str, Any] | None) -> Stage:
    """A fitted map on its stage."""
    from motes.rendering.map_stage import map_stage

    if settling is not None:
        raise MotesError(
            f"dust cannot be deposited on the map {fitted.name}",
            "In a Mitsuba scene motes_dusty lies over a nested motes_map",
        )
    draw, notes = map_stage(fitted, look, hours)
    return Stage(draw, tuple(notes))


def _gathering(hours: tuple[float, float]) -> tuple[float, float]:
    """When dust gathers: from 0, or the first time before it, to the last time."""
    first = min(hours[0], 0.0)
    return first, hours[1] if hours[1] > first else first + HOURS_A_DAY


def _saved(material: Material, folder: Path) -> Path:
    """The material as a file of its own in the folder."""
    return material.save(folder / f"material-{len(list(folder.iterdir()))}.json")


def _as_mesh(item: Subject) -> Subject:
    """The sphere of the preview as a mesh, which can carry dust."""
    return item if item.mesh is not None else Subject(on_stage(SHAPES["sphere"]()), item.name)


def measured_stage(path: str | os.PathLike[str], look: Look) -> Stage:
    """A measured material, RGL or MERL, on the same stage; it does not change with time."""
    from motes.rendering.measured import measured_bsdf

    if look.is_xml:
        raise MotesError("a measured material cannot be put into a Mitsuba scene", "Compare on a sphere, or a mesh")
    bsdf = measured_bsdf(path)
    item = subject(look.scene, look.up)

    def draw(_: float) -> Floats:
        shown = {"type": "twosided", "inner": bsdf}
        return rendered(lambda: preview(item, shown, size=look.size, env=look.env, lamp_deg=look.lamp_deg), look)

    return Stage(draw)
