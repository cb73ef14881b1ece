"""A fitted map on a stage: every texel with its own parameters."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.maps import FittedMap, moment
from motes.measurements.origin import not_measured
from motes.meshes.shapes import SHAPES
from motes.rendering.map_textures import known_at
from motes.rendering.passes import Look, rendered
from motes.rendering.scenes import FLAT, Subject, on_stage, preview, subject
from motes.rendering.user_scene import user_scene

Floats = NDArray[np.floating[Any]]
ROUND = ("sphere", "grid")
AROUND = 2  # copies of a map around a sphere, which is twice as long as it is high


def map_stage(fitted: FittedMap, look: Look, hours: tuple[float, float]) -> tuple[Callable[[float], Floats], list[str]]:
    """What draws a fitted map at a time [h], and sentences on what is shown.

    Parameters
    ----------
    fitted
        The map.
    look
        The scene, and how it is rendered.
    hours
        The first and the last time that will be drawn.

    Raises
    ------
    MotesError
        For a scene that the map cannot lie on, or a map that cannot be shown.
    """
    notes = _notes(fitted, look, hours)
    if look.is_xml:
        if look.repeat is not None:
            raise MotesError("--repeat was given for a Mitsuba scene", "Scale to_uv of its motes_map there")
        return user_scene(look, fitted.path, "motes_map"), notes
    aspect = fitted.shape[1] / fitted.shape[0]
    item = _subject(look, aspect)
    around = look.scene in ROUND
    across, upwards = _copies(look, aspect)
    if (across, upwards) != (1, 1):
        notes.append(f"{across:g} x {upwards:.3g} copies of the map, every second one mirrored")

    def described(time: float) -> dict[str, Any]:
        from motes.rendering import load_mitsuba

        transform = load_mitsuba().ScalarTransform4f()
        bsdf = {
            "type": "motes_map",
            "filename": str(fitted.path),
            "time": float(time),
            "filter": look.filter,
            "gaps": look.gaps,
            "strict": look.strict,
            # The first row is at the top, where v is 1; around a sphere the middle of the map is in front, where u and v are 1/2.
            "to_uv": transform.translate([0.5, 0.5, 0]).scale([across, -upwards, 1]).translate([-0.5, -0.5, 0])
            if around
            else transform.translate([0, upwards, 0]).scale([across, -upwards, 1]),
        }
        return preview(item, bsdf, size=look.size, env=look.env, lamp_deg=look.lamp_deg)

    return lambda time: rendered(lambda: described(time), look), notes


def settings_of(fitted: FittedMap) -> dict[str, Any]:
    """What decides how a map looks, without reading it: the plan of its fit, and the names, sizes and dates of its files."""
    files = sorted(
        (str(path.relative_to(fitted.path)), path.stat().st_size, path.stat().st_mtime_ns)
        for path in fitted.path.rglob("*")
        if path.is_file()
    )
    return {"map": str(fitted.path.resolve()), "plan": fitted.plan.to_dict(), "files": files}


def _subject(look: Look, aspect: float) -> Subject:
    item = subject(look.scene, look.up)
    if item.name == FLAT and item.mesh is None:
        return item._replace(aspect=aspect)
    if item.mesh is None:  # as a mesh whose poles are above and below, and u = 0 behind
        ball = on_stage(SHAPES["sphere"]())
        assert ball.normals is not None
        turn = np.array([-1.0, 1.0, -1.0])
        return Subject(replace(ball, positions=ball.positions * turn, normals=ball.normals * turn), item.name)
    if item.mesh.uv is None:
        raise MotesError(
            f"{look.scene} has no texture coordinates, and a map lies by them",
            "Unwrap it, or choose flat, sphere, teapot or another mesh",
        )
    return item


def _copies(look: Look, aspect: float) -> tuple[float, float]:
    """Copies of the map to the right and upwards; around a sphere as many upwards as leave texels square at its middle."""
    if look.scene in ROUND:
        around = look.repeat or AROUND
        return around, around / 2 * aspect
    return look.repeat or 1, look.repeat or 1


def _notes(fitted: FittedMap, look: Look, hours: tuple[float, float]) -> list[str]:
    """What is shown between texels, where nothing was fitted, and out of the map's times."""
    now = moment(fitted, hours[0])
    known = known_at(fitted, now, look.strict)
    gaps, total = int((~known).sum()), known.size
    said = [not_measured({"source": fitted.origin})]
    said.append(
        "each point has the parameters of its own texel (nearest)"
        if look.filter == "nearest"
        else "between texels their light is mixed, not their parameters (bilinear)"
    )
    if gaps:
        why = "no fit" if not look.strict else "no fit, or a parameter that the data do not determine"
        how = "they have the parameters of the nearest one that has" if look.gaps == "fill" else "they are magenta"
        said.append(f"{gaps:,} of {total:,} texels have {why}: {how}")
    if bridged := int(now.bridged.sum()):
        said.append(
            f"{bridged:,} of {total:,} texels have no fit at {now.hours:g} h itself: their scans before and after stand for it"
        )
    lost = {name: int(where.sum()) for name, where in now.undetermined.items() if where.any()}
    if lost and not look.strict:
        listed = ", ".join(f"{name} at {n:,}" for name, n in lost.items())
        said.append(f"the data do not determine {listed} of {total:,} texels; shown as fitted")
    first, last = fitted.interval
    if hours[0] < first or hours[1] > last:
        how = "trends go on" if fitted.joint else "the nearest scan is held"
        said.append(f"the map has {first:g} to {last:g} h: outside {how}")
    return [note for note in said if note]
