"""What float32 makes of the values: errors beyond what the rounding of the directions themselves explains."""

from __future__ import annotations

import numpy as np

from motes.certification.certificate import Check, Finding
from motes.certification.hemisphere import grazing, upper
from motes.certification.specimen import Floats, Numbers, Specimen
from motes.certification.wording import degrees, plain, share, typical
from motes.directions import from_spherical

COUNT = 1500
#: A relative error beyond this, and beyond so many times what one rounding of the directions changes, is a loss of digits.
TOLERANCE, ROUNDINGS, MOST = 5e-4, 16.0, 2e-3
ULP = 6e-8


def check_precision(specimen: Specimen) -> Check:
    """At random pairs, and near the normal, the mirror direction and the horizon, where digits cancel."""
    if specimen.narrow is None:
        return Check(
            "precision", "Not judged: the subject cannot be computed in both float32 and float64.", judged=False
        )
    says, findings, numbers = [], [], {}
    for place, (a, b) in places().items():
        wi, wo = (w.astype(np.float32).astype(np.float64) for w in (a, b))
        wide, narrow = specimen.eval(wi, wo), specimen.narrow(wi.astype(np.float32), wo.astype(np.float32))
        error, allowed = _relative(wide, narrow), _allowed(specimen, wi, wo, wide)
        bad = error > allowed
        numbers[place] = {"largest_relative_error": plain(float(error.max()), 3), "share_beyond": plain(bad.mean(), 3)}
        says.append(f"{place} {error.max():.1g}")
        if bad.mean() > MOST:
            row = int(np.argmax(np.where(bad, error, 0)))
            lost = not np.isfinite(narrow[row]).all()
            found = "is not finite" if lost else f"is off by {share(error[row])}"
            name, why = _cause(place, lost)
            findings.append(
                Finding(name, f"In float32 it {found} at {share(bad.mean())} of the pairs {place}, as at {degrees(wi[row], wo[row])}", why)
            )  # fmt: skip
    return Check("precision", f"Largest relative errors of float32: {'; '.join(says)}.", tuple(findings), numbers)


def places() -> dict[str, tuple[Floats, Floats]]:
    """Pairs of directions by where they lie: anywhere, and where digits cancel."""
    rng = np.random.default_rng(9)
    theta, phi = rng.uniform(0.1, 1.3, COUNT), rng.uniform(-np.pi, np.pi, COUNT)
    off, around = 10 ** rng.uniform(-4, -1.5, (2, COUNT)), rng.uniform(-np.pi, np.pi, COUNT)
    mirror = from_spherical(np.clip(theta + off[0] * np.cos(around), 0, 1.5), phi + np.pi + off[1] * np.sin(around))
    small = 10 ** rng.uniform(-4, -1, (2, COUNT))
    low = grazing(COUNT, 10)
    return {
        "anywhere": (upper(COUNT, 11), upper(COUNT, 12)),
        "near the mirror direction": (from_spherical(theta, phi), mirror),
        "near the normal": (from_spherical(small[0], phi), from_spherical(small[1], around)),
        "near the horizon": low,
    }


def _relative(wide: Floats, narrow: Numbers) -> Floats:
    """The largest error over channels (N,), relative; what is not finite in float32 alone is an error of all of it."""
    floor = 1e-6 * typical(wide) + 1e-30
    with np.errstate(all="ignore"):
        error = np.abs(narrow.astype(np.float64) - wide) / (np.abs(wide) + floor)
    error = np.where(np.isfinite(wide), np.where(np.isfinite(error), error, 1.0), 0.0)
    return np.asarray(error.max(axis=1))


def _allowed(specimen: Specimen, wi: Floats, wo: Floats, wide: Floats) -> Floats:
    """What directions that are moved by a rounding change in float64 (N,), many times over, and a little more."""
    rng = np.random.default_rng(13)
    moved = np.zeros(len(wi))
    for _ in range(4):
        a, b = (w * (1 + ULP * rng.uniform(-1, 1, w.shape)) for w in (wi, wo))
        moved = np.maximum(moved, _relative(wide, specimen.eval(a, b)))
    return TOLERANCE + ROUNDINGS * moved


def _cause(place: str, lost: bool) -> tuple[str, str]:
    if lost:
        return "float32-range", "Does something overflow or vanish in float32, or is 0 divided by 0 there?"
    if place == "near the horizon":
        return (
            "float32-at-grazing",
            "Is 1 - sin² or a difference of nearly equal terms taken where the cosine is small?",
        )
    if place == "anywhere":
        return "float32", "Are nearly equal numbers subtracted, or large ones added up?"
    return (
        "float32-cancellation",
        "Is a sine taken as the root of 1 - cos², or an angle as an arc cosine, where the cosine is near 1? The cross product, or x² + y², keeps the digits.",
    )
