"""`motes.compare`: models beside each other on one measurement: how close, how good at what they have not seen, what a lit sphere looks like."""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from motes import outlets
from motes.drawing.colour import channels_to_srgb
from motes.drawing.colour_difference import delta_e_itp
from motes.drawing.sphere import LIGHTS
from motes.errors import DataError
from motes.files import write_json
from motes.fitting.climbing import climb
from motes.fitting.direction_blocks import coordinates
from motes.fitting.formatting import finite
from motes.fitting.front import fit_beside
from motes.fitting.judgement import Contender, judged
from motes.fitting.losses import Floats
from motes.fitting.nested import Found, simplest_first
from motes.fitting.result import Fit, Progress
from motes.fitting.setup import Wishes
from motes.fitting.shown import data_frame
from motes.measurements import Measurement
from motes.models import parse

# Pixels along the diameter of the sphere whose colours are compared; of larger data so many pairs of directions stand for all.
PIXELS, MOST_PAIRS = 48, 20_000


@dataclass(frozen=True)
class Compared:
    """A model of a comparison.

    Attributes
    ----------
    fit
        Its fit to all data.
    left_out
        The relative RMS, weighted as the loss weighs, of blocks of directions that a fit to the others predicts; NaN where too few.
    delta_bic
        Its BIC less the smallest, on the samples that were compared.
    delta_e
        The mean Delta E ITP of a sphere under a lamp 45 degrees to the side, against the measurement.
    chosen
        Whether it is what `motes.fit` would take of these.
    """

    fit: Fit
    left_out: float
    delta_bic: float
    delta_e: float
    chosen: bool


@dataclass(frozen=True)
class Comparison:
    """Models beside each other; what `motes.compare` returns.

    Attributes
    ----------
    rows
        In the order in which the models were given.
    dusty
        The verdict on dust, as of `Fit.dusty`: None unless a layer and a model without one were compared.
    """

    measurement: Measurement
    rows: tuple[Compared, ...]
    dusty: bool | None

    def records(self) -> list[dict[str, Any]]:
        """A row a model: numbers for tables, parameters with a column each (of several channels their mean)."""
        found = []
        for row in self.rows:
            m = row.fit.metrics
            values = {p.name: float(np.mean(np.asarray(p.value, float))) for p in row.fit.parameters.values()}
            found.append(
                {
                    "model": row.fit.model_text,
                    "n_parameters": int(m["n_parameters"]),
                    "relative_rms": m["relative_rms"],
                    **{name: m[name] for name in ("rms_linear", "rms_log", "rms_cube_root", "rms_plain")},
                    "left_out": row.left_out,
                    "delta_bic": row.delta_bic,
                    "delta_e_itp": row.delta_e,
                    "chosen": row.chosen,
                    "status": str(row.fit.status),
                    **values,
                }
            )
        return found

    def to_dict(self) -> dict[str, Any]:
        """All of it as plain JSON values; each model with what `Fit.to_dict` says."""
        numbers = ("left_out", "delta_bic", "delta_e_itp", "chosen")
        return {
            "format": "motes comparison",
            "version": 1,
            "dusty": self.dusty,
            "models": [
                {**{name: finite(record[name]) for name in numbers}, **row.fit.to_dict()}
                for record, row in zip(self.records(), self.rows, strict=True)
            ],
        }

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write `to_dict` as a JSON file; returns its path."""
        return write_json(path, self.to_dict())

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a page with the table and the residuals of all models side by side; returns its path."""
        return outlets.report("comparison", self, path)

    def to_dataframe(self) -> Any:
        """`records` as a data frame of pandas; see `motes.fitting.shown.data_frame`."""
        return data_frame(self.records())


def compare(
    data: Measurement,
    models: Sequence[str],
    *,
    loss: str = "linear",
    robust: str = "none",
    weights: str | ArrayLike = "measurement",
    fixed: Mapping[str, Any] | None = None,
    per_channel: Collection[str] = (),
    max_theta: float | None = None,
    time: int | None = None,
    progress: Progress | None = None,
) -> Comparison:
    """Fit several models to a measurement of one time, and put them beside each other.

    Parameters
    ----------
    data
        The measurement.
    models
        Two or more, as texts of `motes.fit`, the simplest first: of those that predict alike the first is chosen.
    loss, robust, weights, fixed, per_channel, max_theta, progress
        As of `motes.fit`; names that a model does not have are passed over.
    time
        Which of several times.

    Returns
    -------
    Comparison

    Raises
    ------
    DataError
        For less than two models, several times without ``time``, or too few samples for a model.

    Examples
    --------
    >>> import motes
    >>> table = motes.compare(data, ["oren_nayar", "oren_nayar + torrance_sparrow"])  # doctest: +SKIP
    >>> table.to_dataframe()[["model", "left_out", "delta_bic", "delta_e_itp"]]  # doctest: +SKIP
    """
    texts = list(dict.fromkeys(text.strip() for text in ([models] if isinstance(models, str) else models)))
    if len(texts) < 2:
        raise DataError(f"{len(texts)} model(s) to compare: it takes two", "Name more, such as lambert and oren_nayar")
    if data.n_times > 1 and time is None:
        raise DataError(
            f"the measurement has {data.n_times} times, and one is compared",
            "Choose one with --time, or time= in Python",
        )
    steps, fits = 2 * len(texts), dict[str, Fit]()
    say = progress or (lambda done, total, what: None)
    given = {
        "loss": loss,
        "robust": robust,
        "weights": weights,
        "max_theta": max_theta,
        "scale": 1.0,
        "time": time,
        "trends": "auto",
        "errors": "auto",
    }
    for k, text in enumerate(simplest_first(texts)):
        say(k, steps, text)
        names = parse(text).model.parameters
        own = {
            "fixed": {name: value for name, value in (fixed or {}).items() if name in names},
            "per_channel": [name for name in per_channel if name in names],
        }
        one = fit_beside(data, text, given | own, [Found.of(other.brdf) for other in fits.values()])
        assert isinstance(one, Fit)
        fits[text] = one
    found = [fits[text] for text in texts]
    counted = iter(range(len(texts), steps))
    wishes = Wishes(loss, robust, weights, fixed or {}, per_channel)
    rungs = climb(found[0].measurement, wishes, lambda text: say(next(counted, steps), steps, text), models=texts)
    if len(rungs) < len(texts):
        raise DataError(
            "too few samples to leave some out for each model", "Measure more directions, or compare smaller models"
        )
    judgement = judged([Contender.of([rung]) for rung in rungs])
    smallest = min(rung.bic for rung in rungs)
    say(steps, steps, "done")
    rows = tuple(
        Compared(
            one, rung.trial().left_out, rung.bic - smallest, sphere_difference(one), rung.text == judgement.chosen.text
        )
        for one, rung in zip(found, rungs, strict=True)
    )
    return Comparison(found[0].measurement, rows, judgement.dusty)


def sphere_difference(fit: Fit) -> float:
    """The mean Delta E ITP over a sphere under one lamp 45 degrees to the side, between a fit and its measurement.

    At each pixel both are taken at the measured pair of directions that is nearest in Rusinkiewicz's coordinates, so that nothing is
    made up between measurements; it is NaN where nothing was measured.
    """
    data = fit.measurement
    usable = np.flatnonzero(data.mask[0].all(axis=1))
    if not len(usable):
        return math.nan
    usable = usable[:: max(1, len(usable) // MOST_PAIRS)]
    wi, wo = _sphere()
    near = _nearest(coordinates(wi, wo), coordinates(data.wi[usable], data.wo[usable]))
    colour = channels_to_srgb(data.channels, data.wavelengths)
    light = math.pi * wi[:, 2:3]
    measured, fitted = (light * (x[usable][near] @ colour.matrix) for x in (data.values[0], fit.predicted))
    return float(np.mean(delta_e_itp(np.maximum(measured, 0), np.maximum(fitted, 0))))


def _sphere() -> tuple[Floats, Floats]:
    """Directions to the light and the viewer (N, 3), in the frame of the surface, at each lit pixel of a sphere."""
    at = (np.arange(PIXELS) + 0.5) / PIXELS * 2 - 1
    x, y = (grid.ravel() for grid in np.meshgrid(at, at))
    inside = x * x + y * y < 0.99
    x, y = x[inside], y[inside]
    normal = np.stack([x, y, np.sqrt(1 - x * x - y * y)], axis=-1)
    light = np.array(LIGHTS["three-quarter"].direction)
    lit = normal @ light > 0.02
    normal = normal[lit]
    # What is isotropic needs the cosines to the normal and the angle between the two alone: the viewer in the plane of x and z.
    cos_i, cos_r = normal @ light, normal[:, 2]
    sin_i, sin_r = np.sqrt(1 - cos_i**2), np.sqrt(1 - cos_r**2)
    cos_phi = np.clip((light[2] - cos_i * cos_r) / np.maximum(sin_i * sin_r, 1e-9), -1, 1)
    wo = np.stack([sin_r, 0 * sin_r, cos_r], axis=-1)
    wi = np.stack([sin_i * cos_phi, sin_i * np.sqrt(1 - cos_phi**2), cos_i], axis=-1)
    return wi, wo


def _nearest(a: Floats, b: Floats) -> Any:
    """For each row of a the row of b that is nearest."""
    squares = np.sum(b * b, axis=1)
    return np.concatenate(
        [
            np.argmin(squares - 2 * part @ b.T, axis=1)
            for part in np.array_split(a, max(1, len(a) * len(b) // 2_000_000))
        ]
    )
