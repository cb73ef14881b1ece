"""Measured reflectance as a specimen: RGL files and MERL tables answer for any directions, samples of any other format at their own."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.certification.specimen import Floats, Specimen, digest_of
from motes.errors import DataError
from motes.files import reading
from motes.measurements import Measurement, merl, read, rgl
from motes.rendering.measured import table


def of_file(path: Path) -> Specimen:
    """Measured data at a path.

    Raises
    ------
    FormatError
        When it cannot be read.
    DataError
        When it holds maps of parameters.
    """
    head = reading.head(path, 4096) if path.is_file() else b""
    if path.is_file() and rgl.sniff(path, head):
        return _of_rgl(path)
    if path.is_file() and merl.sniff(path, head) and path.stat().st_size == 12 + 24 * int(np.prod(merl.FULL)):
        return _of_merl(path)
    found = read(path)
    if not isinstance(found, Measurement):
        raise DataError(
            f"{path} holds maps of parameters: a material for every texel", "Give one of them as a material"
        )
    return of_measurement(found)


def of_measurement(data: Measurement) -> Specimen:
    """The samples of the first time that are not masked in any channel."""
    usable = data.mask[0].all(axis=1)
    if not usable.any():
        raise DataError(f"{data.name} has no usable sample at its first time", "motes info says what was masked")
    wi, wo, values = data.wi[usable], data.wo[usable], np.asarray(data.values[0][usable], np.float64)
    rows = {_key(a, b): k for k, (a, b) in enumerate(zip(wi, wo, strict=True))}

    def value(a: Floats, b: Floats) -> Floats:
        return values[[rows[_key(x, y)] for x, y in zip(a, b, strict=True)]]

    masked = ", ".join(f"{count:,} {reason}" for reason, count in data.masked.items()) or "none"
    return Specimen(
        name=data.name,
        kind="measured samples",
        eval=value,
        digest=digest_of(*(np.ascontiguousarray(x).tobytes() for x in (wi, wo, values))),
        measured=True,
        pairs=(wi, wo),
        facts={"samples": f"{len(wi):,} pairs of directions, {data.n_channels} channels", "masked": masked},
    )


def _key(wi: Floats, wo: Floats) -> bytes:
    return wi.tobytes() + wo.tobytes()


def _of_rgl(path: Path) -> Specimen:
    brdf = rgl.TensorBRDF.load(path)
    return Specimen(
        name=path.stem,
        kind="RGL file",
        eval=brdf.eval,
        digest=digest_of(path.read_bytes()),
        measured=True,
        facts={
            "description": brdf.description,
            "angles of incidence": f"{len(brdf.phi_i)} x {len(brdf.theta_i)}",
            "channels": f"{len(brdf.channels)}",
        },
    )


def _of_merl(path: Path) -> Specimen:
    values = table(path)
    return Specimen(
        name=path.stem,
        kind="MERL table",
        eval=lambda wi, wo: _interpolated(values, wi, wo),
        digest=digest_of(path.read_bytes()),
        measured=True,
        facts={
            "bins": " x ".join(map(str, merl.FULL)),
            "interpolated": "linearly between the middles of its bins, those without a value filled from their neighbours",
        },
    )


def _interpolated(values: NDArray[np.float32], wi: Floats, wo: Floats) -> Floats:
    """A table (90, 90, 182, 3) over theta_h, theta_d and phi_d with a bin more on either side, linearly; 0 below the horizon."""
    theta_h, theta_d, phi_d = directions.half_difference(wi, wo)
    scale = 2 / np.pi
    places = (np.sqrt(np.clip(theta_h * scale, 0, 1)) * 90, theta_d * scale * 90, phi_d % np.pi / np.pi * 180 + 1)
    corners = []
    for place, count in zip(places, values.shape[:3], strict=True):
        place = np.clip(place - 0.5, 0, count - 1)
        low = np.minimum(place.astype(int), count - 2)
        corners.append(((low, 1 - (place - low)), (low + 1, place - low)))
    total = np.zeros((len(wi), values.shape[3]))
    for h, a in corners[0]:
        for d, b in corners[1]:
            for p, c in corners[2]:
                total += (a * b * c)[:, None] * values[h, d, p]
    return np.where(directions.above(wi, wo)[:, None], total, 0.0)
