"""What a page gets to show: materials with their printed shaders, trends at many times, measured points."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from motes.channels import default_names
from motes.drawing.colour import channels_to_srgb
from motes.errors import DataError, ParameterError
from motes.exports.subject import subject
from motes.fitting.result import Fit
from motes.material import Material
from motes.measurements import Measurement
from motes.measurements.origin import not_measured
from motes.models import BRDF
from motes.trends import Trend
from motes.version import __version__
from motes.viewer.contract import (
    VERSION,
    MaterialJson,
    MaterialView,
    MeasurementView,
    Payload,
    ScansView,
    TimeView,
    TrendView,
)
from motes.viewer.declarations import declared, range_view
from motes.viewer.packing import deflated, packed
from motes.viewer.shader_library import in_stages, library
from motes.viewer.shipped_shapes import shapes

Floats = NDArray[np.float64]
#: Times at which trends are evaluated; between them the page takes straight lines.
MOMENTS = 161
#: Directions that a page holds of a measurement, and numbers in all its scans.
MOST_DIRECTIONS, MOST_NUMBERS = 6000, 600_000
#: Within so many degrees of the plane of incidence a sample counts as in it: what the polar plot shows.
PLANE_DEG = 3.0
MOST_MATERIALS = 2
#: What a page says of the data behind a material.
PASSED_ON = ("format", "sample", "name", "source", "simulated")


def payload(
    materials: list[Material], measurement: Measurement | None = None, fit: Any = None, notes: tuple[str, ...] = ()
) -> Payload:
    """Everything the page needs, as plain JSON values.

    Parameters
    ----------
    materials
        One, or two to compare.
    measurement
        Points to show over the first of them.
    fit
        The `Fit` or `TimeFit` that gave the first, or the dictionary of its ``fit.json``: for what each scan said.
    notes
        Sentences to show.

    Raises
    ------
    ParameterError
        For a material whose parameters are not one set of numbers, or for other than one or two materials.
    """
    if not 1 <= len(materials) <= MOST_MATERIALS:
        raise ParameterError(f"{len(materials)} materials were given", "A page shows one, or two to compare")
    views = [_material(material, fit if k == 0 else None) for k, material in enumerate(materials)]
    points = None if measurement is None else _points(measurement)
    origins = [not_measured(material.about.get("data")) for material in materials]
    if measurement is not None:
        origins.append(not_measured(measurement.provenance))
    said = [text for text in dict.fromkeys(origins) if text]
    return {
        "format": "motes view",
        "version": VERSION,
        "motes": __version__,
        "materials": views,
        "measurement": points,
        "notes": [*said, *notes, *([points["note"]] if points and points["note"] else [])],
        "library": deflated(library()),
        "models": declared(own=False),
        "shapes": shapes(),
    }


def as_material(what: Material | BRDF) -> Material:
    """A BRDF as a material, with names for its channels."""
    if isinstance(what, BRDF):
        return Material(what, channels=default_names(what.channels))
    return what


# ------------------------------------------------------------ materials


def _material(material: Material, fit: Any) -> MaterialView:
    seen = subject(material)  # at its first moment
    color = channels_to_srgb(seen.channels, seen.wavelengths or None)
    written = Material(
        seen.brdf, material.name, seen.channels, material.wavelengths, material.trends, _plain(material.about)
    )
    return {
        "json": cast(MaterialJson, _finite(written.to_dict())),
        "shader": in_stages(seen.brdf, material.name),
        "ranges": {slot.name: range_view(slot.parameter) for slot in seen.brdf.slots()},
        "time": _time(material, fit),
        "to_srgb": color.matrix.tolist(),
        "color": color.meaning,
    }


def _time(material: Material, fit: Any) -> TimeView | None:
    interval = material.interval
    if interval is None:
        return None
    hours = np.linspace(*interval, MOMENTS)
    course = material.at(hours).parameters
    trends: dict[str, TrendView] = {}
    for slot in material.brdf.slots():
        if (trend := material.trends.get(slot.name)) is None:
            continue
        value = np.reshape(course[slot.name], (MOMENTS, -1))
        stderr = trend.stderr(hours).reshape(MOMENTS, -1) if isinstance(trend, Trend) else np.full((1, 1), np.nan)
        fitted = getattr(fit, "trends", {}).get(slot.name)
        if fitted is not None:
            stderr = fitted.band(hours)[1]
        trends[slot.name] = {
            "kind": trend.kind,
            "values": value.tolist(),
            "stderr": _finite(stderr.tolist()) if np.isfinite(stderr).any() else None,
            "scans": _scans(slot.name, fit),
        }
    return {"hours": hours.tolist(), "interval": interval, "trends": trends}


def _scans(name: str, fit: Any) -> ScansView | None:
    """What each scan said of a parameter, from a `TimeFit` or from the dictionary of a ``fit.json``."""
    if fit is None or isinstance(fit, Fit):
        return None
    if isinstance(fit, Mapping):
        entry = (fit.get("trends") or {}).get(name) if isinstance(fit.get("trends"), Mapping) else None
        if not isinstance(entry, Mapping):
            return None
        hours, values, stderr = fit.get("hours"), entry.get("scan_values"), entry.get("scan_stderr")
    else:
        entry = fit.trends.get(name)
        if entry is None:
            return None
        usable = np.flatnonzero(fit.measurement.mask.any(axis=(1, 2)))
        hours, values, stderr = fit.hours[usable], entry.scan_values, entry.scan_stderr
    try:
        t, v, e = (np.asarray(x, np.float64) for x in (hours, values, stderr))
    except (TypeError, ValueError, OverflowError):
        return None
    if v.ndim != 2 or v.shape != e.shape or len(v) != len(t):
        return None
    return {"hours": t.tolist(), "values": _finite(v.tolist()), "stderr": _finite(e.tolist())}


# ------------------------------------------------------------ measured points


def _points(data: Measurement) -> MeasurementView:
    chosen = _thinned(data)
    some = data.select(chosen)
    values = np.where(some.mask, some.values, np.nan)
    note = ""
    if len(chosen) < data.n_directions:
        note = (
            f"{data.name} has {data.n_directions:,} pairs of directions; the page holds {len(chosen):,} of them, first those in the plane of incidence, "
            "the rest at random."
        )
    return {
        "name": data.name,
        "channels": list(data.channels),
        "hours": data.times.tolist(),
        "time_unit": data.time_unit,
        "count": len(chosen),
        "total": data.n_directions,
        "wi": packed(some.wi, "<f4"),
        "wo": packed(some.wo, "<f4"),
        "values": packed(values, "<f4"),
        "note": note,
    }


def _thinned(data: Measurement) -> NDArray[np.int64]:
    """Indices of the directions that a page shows: usable ones, half the room for those in the plane of incidence."""
    usable = np.flatnonzero(data.mask.any(axis=(0, 2)))
    if not len(usable):
        raise DataError(f"{data.name} has no usable sample", "motes info says what was masked, and why")
    most = max(min(MOST_DIRECTIONS, MOST_NUMBERS // (data.n_times * data.n_channels)), 16)
    if len(usable) <= most:
        return usable
    rng = np.random.default_rng(0)
    aside = np.abs(np.sin(data.dphi)) * np.minimum(np.sin(data.theta_i), np.sin(data.theta_r))
    level = aside[usable] <= np.sin(np.deg2rad(PLANE_DEG))
    inside, outside = rng.permutation(usable[level]), rng.permutation(usable[~level])
    n_inside = min(len(inside), max(most // 2, most - len(outside)))
    return np.sort(np.concatenate([inside[:n_inside], outside[: most - n_inside]]))


def _finite(x: Any) -> Any:
    """JSON has no NaN and no infinity: None instead."""
    if isinstance(x, float):
        return x if np.isfinite(x) else None
    if isinstance(x, (list, tuple)):
        return [_finite(v) for v in x]
    if isinstance(x, dict):
        return {str(k): _finite(v) for k, v in x.items()}
    return x


def _plain(about: Mapping[str, Any]) -> dict[str, Any]:
    """What is known of a material, without paths of the machine that made it: pages are handed on."""
    data = about.get("data")
    known = {key: data[key] for key in PASSED_ON if key in data} if isinstance(data, Mapping) else {}
    return {
        **{key: value for key, value in about.items() if key not in ("path", "data")},
        **({"data": known} if known else {}),
    }
