"""Instruments by name or from a file: what they can measure (`Offer`)."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.ageing.rig import Rig
from motes.directions import from_spherical
from motes.errors import DataError, MotesError
from motes.files.finding import existing
from motes.measurements import Measurement, read
from motes.planning.offers import Offer
from motes.planning.rig_file import read_rig

Floats = NDArray[np.float64]
#: Records of the lamp's sweep: 65 by four cameras are 260 directions.
SWEEP = 65


def paired(lights: Floats, views: Floats) -> tuple[Floats, Floats]:
    """All pairs (L V, 3) of lights (L, 3) and views (V, 3), the views of a light one after the other."""
    return np.repeat(lights, len(views), axis=0), np.tile(views, (len(lights), 1))


def _tvbrdf() -> Offer:
    usual = Rig()
    rig = Rig(step_deg=abs(usual.arm_deg[1] - usual.arm_deg[0]) / (SWEEP - 1))
    views, lights = paired(rig.wo, rig.wi)  # a camera's sweep is one after the other, as it is recorded
    return Offer.of("the rig of Time-Varying BRDFs", lights, views)


def _hemisphere() -> Offer:
    """Lamp at phi = 0 every 10 degrees to 80, detector every 10 degrees to 80 and every 20 degrees around; not within 5 of the lamp."""
    polar = np.radians(np.arange(0, 81, 10.0))
    lights = from_spherical(polar, 0.0)
    theta, phi = (a.ravel() for a in np.meshgrid(polar[1:], np.radians(np.arange(0, 181, 20.0)), indexing="ij"))
    views = np.concatenate([from_spherical(polar[:1], 0.0), from_spherical(theta, phi)])
    wi, wo = paired(lights, views)
    free = np.einsum("nk,nk->n", wi, wo) < np.cos(np.radians(5.0))
    return Offer.of("a goniometer over the hemisphere", wi[free], wo[free])


def _in_plane() -> Offer:
    """Lamp every 15 degrees to 75, detector every 5 degrees from -80 to 80 in the plane of incidence, not within 5 of the lamp."""
    angles = np.radians(np.arange(-80, 81, 5.0))
    wi, wo = paired(from_spherical(np.radians(np.arange(0, 76, 15.0)), 0.0), from_spherical(angles, 0.0))
    free = np.einsum("nk,nk->n", wi, wo) < np.cos(np.radians(4.9))
    return Offer.of("a goniometer in the plane of incidence", wi[free], wo[free])


#: Instruments that have a name.
RIGS: Mapping[str, Callable[[], Offer]] = {"tvbrdf": _tvbrdf, "hemisphere": _hemisphere, "in_plane": _in_plane}


def offered(rig: str | os.PathLike[str] | Offer | Measurement) -> Offer:
    """What an instrument can measure.

    Parameters
    ----------
    rig
        An `Offer`; a name of `RIGS`; a file ``.toml`` (see `motes.planning.rig_file`); or a measurement, or its file or folder: the
        directions that it has.

    Raises
    ------
    MotesError
        Where it names nothing, or sees nothing.
    """
    if isinstance(rig, Offer):
        return rig
    if isinstance(rig, Measurement):
        usable = rig.mask.any(axis=(0, 2))
        return Offer.of(f"the directions of {rig.name}", rig.wi[usable], rig.wo[usable])
    text = os.fspath(rig)
    if text in RIGS:
        return RIGS[text]()
    try:
        path = existing(text)
    except MotesError as error:
        if os.sep in text or "." in text:
            raise
        raise DataError(
            f"{text} is no rig and no file", f"Name one of {', '.join(RIGS)}, a rig.toml, or measured data"
        ) from error
    if Path(path).suffix.lower() == ".toml":
        return read_rig(Path(path))
    return offered(measurement_of(path))


def measurement_of(data: Measurement | str | os.PathLike[str]) -> Measurement:
    """A measurement, read where it is a path; raises `DataError` for what has no directions: maps of parameters or of tables."""
    found = data if isinstance(data, Measurement) else read(data)
    if not isinstance(found, Measurement):
        raise DataError(f"{data} is a map, and not the measurement of one place", "Give measured data of directions")
    return found
