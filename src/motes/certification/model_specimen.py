"""A BRDF of Motes as a specimen: by the equations, not by the compiled engine, so that the page is the same on every machine with this NumPy."""

from __future__ import annotations

import json
from collections.abc import Mapping

import numpy as np

from motes.arrays import NUMPY
from motes.certification.specimen import Drawn, Floats, Numbers, Slopes, Specimen, digest_of
from motes.directions import Geometry, Vector
from motes.kernels.numpy import residual_function
from motes.material import Material
from motes.models import BRDF, describe

STEP = 1e-6


def of_model(material: Material, hours: float | None = None) -> Specimen:
    """A material, at a time [h] where it changes (the first of its interval when not given)."""
    moment = hours if hours is not None else material.interval[0] if material.interval else 0.0
    brdf = material.at(moment)
    facts = {"model": describe(brdf)} | {
        slot.name: ", ".join(f"{v:.6g}" for v in np.ravel(slot.value))
        + (f" {slot.parameter.unit}" if slot.parameter.unit else "")
        for slot in brdf.slots()
    }
    if material.trends:
        facts["moment"] = f"{moment:g} h"
    return Specimen(
        name=material.name,
        kind=f"Motes material at {moment:g} h" if material.trends else "Motes material",
        eval=lambda wi, wo: _value(brdf, wi, wo),
        digest=digest_of(json.dumps(material.to_dict(), sort_keys=True), repr(moment)),
        sample=lambda wi, u: Drawn(*map(np.asarray, brdf.sample(wi, u))),
        pdf=lambda wi, wo: np.asarray(brdf.pdf(wi, wo)),
        narrow=lambda wi, wo: _value(_narrow(brdf), wi, wo),
        slopes=lambda wi, wo: _slopes(brdf, wi, wo),
        model=brdf,
        material=material,
        moment=moment if material.interval is not None else None,
        reciprocal=brdf.reciprocal,
        facts=facts,
    )


def _value(brdf: BRDF, wi: Numbers, wo: Numbers) -> Floats:
    with np.errstate(all="ignore"):
        values = np.asarray(brdf.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo))))
    return np.broadcast_to(values, (len(wi), max(values.shape[-1], brdf.channels)))


def _narrow(brdf: BRDF) -> BRDF:
    """With parameters in float32, which would otherwise carry float64 into the arithmetic."""
    return brdf.with_parameters({slot.name: np.asarray(slot.value, np.float32) for slot in brdf.slots()})


def _slopes(brdf: BRDF, wi: Floats, wo: Floats) -> Mapping[str, Slopes]:
    """The derivatives that fits use, against central differences."""
    slots = {slot.name: slot for slot in brdf.slots()}
    function = residual_function(brdf, tuple(slots))
    values = {name: np.asarray(slot.value, np.float64) for name, slot in slots.items()}
    _, said = function.values_and_jacobian(function.geometry(wi, wo), values)
    found = {}
    for name, slot in slots.items():
        low, high = slot.parameter.bounds
        value = values[name]
        h = STEP * np.maximum(np.abs(value), 0.1)
        up, down = np.minimum(value + h, high), np.maximum(value - h, low)
        if slot.parameter.open:
            up, down = np.where(up >= high, value, up), np.where(down <= low, value, down)
        ends = [_value(brdf.with_parameters({name: end}), wi, wo) for end in (up, down)]
        with np.errstate(all="ignore"):
            found[name] = Slopes(np.broadcast_to(said[name], ends[0].shape), (ends[0] - ends[1]) / (up - down))
    return found
