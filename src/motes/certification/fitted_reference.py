"""The model that a subject should be, with the parameters that nobody gave fitted to it: once for each cosine that its values might include."""

from __future__ import annotations

import numpy as np

from motes.certification.check_conventions import compared_pairs
from motes.certification.model_specimen import of_model
from motes.certification.rivals import FACTORS, distance
from motes.certification.specimen import Specimen
from motes.errors import DataError, MotesError
from motes.fitting import Fit, fit
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, parse

#: Values that a fit is made of: enough for any model, few enough to take a moment.
MOST = 1500


def reference_by_model(specimen: Specimen, text: str) -> Specimen:
    """The model of a text as a specimen.

    Raises
    ------
    ParameterError
        When the text is no model.
    DataError
        When it has parameters without a value, and none of the subject's values is a number that could be fitted.
    """
    parsed = parse(text)
    free = [slot.name for slot in parsed.model.slots() if slot.name not in parsed.fixed]
    if not free:
        return of_model(Material(parsed.model, name=text))
    wi, wo = compared_pairs(specimen)
    step = max(1, len(wi) // MOST)
    wi, wo = wi[::step], wo[::step]
    values = specimen.eval(wi, wo)
    good = np.isfinite(values).all(axis=1)
    if not (values[good] > 0).any():
        raise DataError(
            f"{specimen.name} has no values above 0 that {', '.join(free)} could be fitted to",
            f"Give values: --as '{text}' with {free[0]}=...",
        )
    wi, wo, values = wi[good], wo[good], values[good]
    found: list[tuple[float, BRDF]] = []
    for _, of in FACTORS:
        factor = of(wi[:, 2:], wo[:, 2:])
        try:
            fitted = fit(Measurement.from_arrays(wi, wo, values / factor), text)
        except MotesError:  # values that no model of the kind has
            continue
        assert isinstance(fitted, Fit)  # one time
        brdf = fitted.material.brdf
        found.append((distance(values, factor * np.asarray(brdf.eval(wi, wo))), brdf))
    if not found:
        raise DataError(f"{text} cannot be fitted to {specimen.name}", "Give its parameters values")
    # The values as they are come first: a cosine has to explain clearly more.
    plain = found[0]
    best = min(found, key=lambda pair: pair[0])
    _, brdf = best if best[0] < 0.5 * plain[0] else plain
    return of_model(Material(brdf, name=f"{text}, fitted"))
