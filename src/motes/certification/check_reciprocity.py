"""Whether light may be turned around: f(wi, wo) = f(wo, wi), and what probably breaks it where it may not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from motes.certification.certificate import Check, Finding, Outcome
from motes.certification.specimen import Floats, Specimen
from motes.certification.wording import degrees, plain, share, typical
from motes.directions import from_spherical

POLAR = np.arange(5.0, 86.0, 10.0)
AZIMUTHS = np.array([2.0, 25.0, 50.0, 75.0, 90.0, 110.0, 135.0, 160.0, 178.0, 180.0])
#: Relative differences beyond which a pair counts, in float64 and float32, and the share of pairs that makes a fault.
TOLERANCE, SINGLE, MOST = 1e-3, 1e-2, 0.01
#: That of measured values, which noise and the interpolation of tables move.
MEASURED = 0.2

Corrected = Callable[[Floats, Floats, Floats], Floats]  # values (N, C), cosines (N, 1) of wi and wo

RIVALS: tuple[tuple[str, str, Corrected], ...] = (
    (
        "cosine-included",
        "f cos(theta_r) is reciprocal no more, and this divided by it is: does it include the cosine of wo?",
        lambda f, ci, co: f / co,
    ),
    (
        "cosine-of-light-included",
        "Divided by cos(theta_i) it is reciprocal: does it include the cosine of wi?",
        lambda f, ci, co: f / ci,
    ),
    (
        "cosine-of-viewer-divided",
        "Times cos(theta_r) it is reciprocal: is it divided by that cosine, as a reflected radiance or a CCBSDF?",
        lambda f, ci, co: f * co,
    ),
    (
        "cosine-of-light-divided",
        "Times cos(theta_i) it is reciprocal: is it divided by that cosine once too often?",
        lambda f, ci, co: f * ci,
    ),
)


def check_reciprocity(specimen: Specimen) -> Check:
    """The differences over a grid of both polar angles, the worst of ten azimuths each: a map."""
    if specimen.pairs is not None:
        return Check(
            "reciprocity",
            "Not judged: it has values at single pairs of directions, not at the pairs turned around.",
            judged=False,
        )
    a, b, d = np.meshgrid(np.radians(POLAR), np.radians(POLAR), np.radians(AZIMUTHS), indexing="ij")
    shape = a.shape
    wi, wo = from_spherical(a, 0.7).reshape(-1, 3), from_spherical(b, 0.7 + d).reshape(-1, 3)
    forth, back = specimen.eval(wi, wo), specimen.eval(wo, wi)
    cosines = wi[:, 2:], wo[:, 2:]
    tolerance = MEASURED if specimen.measured else SINGLE if specimen.single else TOLERANCE
    differs = _difference(forth, back)
    off = float(np.mean(differs > tolerance))
    worst = int(np.argmax(differs))
    numbers = {
        "theta_deg": POLAR.tolist(),
        "largest_relative_difference": plain(differs.reshape(shape).max(-1), 3),
        "share_of_pairs_beyond": plain(off, 3),
        "tolerance": tolerance,
    }
    says = (
        f"{len(wi):,} pairs turned around: {share(off)} differ by more than {share(tolerance)}, the largest relative difference is "
        f"{differs[worst]:.2g}."
    )
    if off <= MOST:
        return Check("reciprocity", says, (), numbers)
    found = f"f(wi, wo) and f(wo, wi) differ by up to {share(differs[worst])}, at {degrees(wi[worst], wo[worst])}"
    name, why = _cause(forth, back, cosines, off, tolerance, specimen.measured)
    if specimen.reciprocal is False:
        why = f"It says of itself that it is not reciprocal. {why}"
    doubt = specimen.measured and not name.startswith("cosine")
    if doubt:
        name, why = "measured-asymmetry", "An instrument's errors, above all towards grazing; noise is not reciprocal."
    finding = Finding(name, found, why, Outcome.DOUBT if doubt else Outcome.FAULT)
    return Check("reciprocity", says, (finding,), numbers)


def _difference(forth: Floats, back: Floats) -> Floats:
    """The largest relative difference over channels (N,); values far below the rest count by the scale of all."""
    size = np.maximum(np.abs(forth), np.abs(back))
    floor = 1e-5 * typical(size) + 1e-12
    with np.errstate(all="ignore"):
        ratio = np.abs(forth - back) / (size + floor)
    return np.asarray(np.nan_to_num(ratio, nan=0.0, posinf=1.0).max(axis=1))


def _cause(
    forth: Floats, back: Floats, cosines: tuple[Floats, Floats], off: float, tolerance: float, measured: bool
) -> tuple[str, str]:
    ci, co = cosines
    fitting = []
    most = 0.4 * off if measured else max(MOST, 0.02 * off)  # of measured pairs some are asymmetric in any case
    for name, why, corrected in RIVALS:
        turned, there = corrected(back, co, ci), corrected(forth, ci, co)
        if np.mean(_difference(there, turned) > tolerance) <= most:
            # f cos(theta_r) and f / cos(theta_i) are reciprocal after the same corrections: the one that leaves less to explain is the likelier,
            # and a cosine too many likelier than one too few.
            less = 1.0 if name.endswith("included") else 1.25
            fitting.append((less * float(np.std(np.log(np.maximum(there, 1e-30)))), name, why))
    if fitting:
        _, name, why = min(fitting)
        alike = " A factor of one cosine and a division by the other look alike here; --as tells them apart."
        return name, why + (alike if len(fitting) > 1 else "")
    if _one_sided(forth, back, ci, co):
        return (
            "one-sided-factor",
            "A factor depends on one direction alone: is masking, transmission or a Fresnel term taken for the way in and not for the way out?",
        )
    return "not-reciprocal", "Something treats light and viewer differently; no factor of one direction explains it."


def _one_sided(forth: Floats, back: Floats, ci: Floats, co: Floats) -> bool:
    """Whether log f(wi, wo) - log f(wo, wi) is h(theta_i) - h(theta_r) for some h: what a factor of one direction makes of it."""
    good = (forth > 0).all(1) & (back > 0).all(1)
    if good.mean() < 0.5:
        return False
    ratio = np.log(forth[good] / back[good])
    angles = np.round(np.degrees(np.arccos(np.stack([ci[good, 0], co[good, 0]])))).astype(int)
    columns = np.unique(angles)
    design = (angles[0][:, None] == columns).astype(float) - (angles[1][:, None] == columns)
    solved = np.linalg.lstsq(design, ratio, rcond=None)[0]
    left = ratio - design @ solved
    return bool(np.sqrt(np.mean(left**2)) < 0.02 * np.sqrt(np.mean(ratio**2)) + 1e-9)
