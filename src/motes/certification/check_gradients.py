"""Whether derivatives by the parameters are those of the values."""

from __future__ import annotations

import numpy as np

from motes.certification.certificate import Check, Finding
from motes.certification.hemisphere import upper
from motes.certification.specimen import Slopes, Specimen
from motes.certification.wording import plain, share

PAIRS = 400
#: Of the largest derivative of each parameter, in float64 and float32; and the share of pairs that may lie at a kink.
TOLERANCE, SINGLE, KINKS = 1e-3, 2e-2, 0.02
FACTORS = (
    (0.0, "gradient-missing", "No derivative arrives: is the parameter detached, or a copy differentiated?"),
    (-1.0, "gradient-sign", "It is minus the difference: is the sign wrong?"),
    (2.0, "gradient-factor-2", "It is twice the difference: is it a derivative by the square, or a term counted twice?"),
    (0.5, "gradient-factor-half", "It is half the difference: does the derivative of a square lack its 2?"),
    (np.pi / 180, "gradient-per-degree", "It is pi/180 of the difference: is it per degree, and the parameter in radians?"),
    (180 / np.pi, "gradient-per-radian", "It is 180/pi times the difference: is it per radian, and the parameter in degrees?"),
    (np.pi, "gradient-factor-pi", "It is pi times the difference: is 1/pi missing in the derivative?"),
)  # fmt: skip


def check_gradients(specimen: Specimen) -> Check:
    """Against central differences of the values themselves."""
    if specimen.slopes is None:
        return Check("gradients", "Not judged: the subject gives no derivatives.", judged=False)
    wi, wo = upper(PAIRS, 7), upper(PAIRS, 8)
    both = (wi[:, 2] > 0.1) & (wo[:, 2] > 0.1)
    slopes = specimen.slopes(wi[both], wo[both])
    if not slopes:
        return Check("gradients", "Not judged: the subject has no parameters to differentiate by.", judged=False)
    tolerance = SINGLE if specimen.single else TOLERANCE
    findings, worst = [], {}
    for name, pair in slopes.items():
        worst[name], finding = _judged(name, pair, tolerance)
        if finding is not None:
            findings.append(finding)
    most = max(worst, key=lambda name: worst[name])
    says = (
        f"{int(both.sum())} pairs by {len(worst)} parameter{'s' * (len(worst) > 1)}: the 98th percentile of the error is {worst[most]:.2g} "
        f"of the largest derivative ({most})."
    )
    return Check(
        "gradients",
        says,
        tuple(findings),
        {"error": {n: plain(v, 3) for n, v in worst.items()}, "tolerance": tolerance},
    )


def _judged(name: str, slopes: Slopes, tolerance: float) -> tuple[float, Finding | None]:
    said, wanted = np.broadcast_arrays(slopes.said, slopes.differences)
    if not np.isfinite(said).all():
        part = float(np.mean(~np.isfinite(said)))
        return 1.0, Finding(
            "gradient-not-finite",
            f"The derivative by {name} is no finite number at {share(part)} of the pairs",
            "Is a root or an arc cosine differentiated where its slope is infinite, or a branch that is not taken?",
        )
    scale = max(float(np.max(np.abs(wanted))), slopes.noise / tolerance)
    if scale == 0:
        scale = float(np.max(np.abs(said))) or 1.0
    error = np.abs(said - wanted) / scale
    high = float(np.percentile(error, 100 * (1 - KINKS)))
    if high <= tolerance:
        return high, None
    says = f"The derivative by {name} is off by {share(high)} of the largest (98th percentile)"
    weights = wanted * wanted
    factor = float(np.sum(said * wanted) / np.sum(weights)) if np.sum(weights) > 0 else 1.0
    left = float(np.percentile(np.abs(said - factor * wanted) / scale, 100 * (1 - KINKS)))
    if left <= max(tolerance, 0.02 * high):
        for value, word, why in FACTORS:
            if abs(factor - value) <= 0.005 * max(abs(value), 0.1):
                return high, Finding(word, says, why)
        return high, Finding(
            "gradient-scale",
            says,
            f"It is {factor:.4g} times the difference: the chain rule of another parametrisation?",
        )
    return high, Finding("gradient", says, "Is a term of it missing, or one that depends on the parameter held fixed?")
