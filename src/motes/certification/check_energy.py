"""The white furnace: how much of the light from each direction leaves, and whether that is more than arrived."""

from __future__ import annotations

import numpy as np

from motes.certification.certificate import Check, Finding, Outcome
from motes.certification.hemisphere import ANGLES, albedo
from motes.certification.specimen import Floats, Specimen
from motes.certification.wording import plain
from motes.channels import names_or_default
from motes.directions import from_spherical

#: Above 1 by more than this and by more than four standard errors of the rule is a fault; half as much is a doubt.
FAULT, DOUBT = 1e-2, 2e-3
PHI = 0.3
SCALES = (
    (np.pi, "factor-pi", "f is pi times too large: is it a reflectance factor (pi f), or is 1/pi missing?"),
    (4.0, "factor-4", "f is 4 times too large: is the 4 of 4 cos(theta_i) cos(theta_r) missing?"),
    (4 * np.pi, "factor-4-pi", "f is 4 pi times too large: is a phase function normalised to 4 pi, or a brightness meant?"),
    (100.0, "percent", "Are the values percent?"),
    (255.0, "8-bit", "Are the values 8-bit numbers, 0 to 255?"),
    (1500.0, "merl-scale", "Is the scale of a MERL table (1, 1.15, 1.66)/1500 missing?"),
)  # fmt: skip


def check_energy(specimen: Specimen) -> Check:
    """The directional albedo at `ANGLES`, by a rule of its own, which asks nothing of the subject's sampling."""
    if specimen.pairs is not None:
        return Check(
            "energy", "Not judged: it has values at single pairs of directions, and no integral of them.", judged=False
        )
    lights = from_spherical(np.radians(ANGLES), PHI)
    found = [albedo(specimen.eval, wi) for wi in lights]
    values, errors = np.stack([a for a, _ in found]), np.stack([e for _, e in found])
    values = np.nan_to_num(values, posinf=np.finfo(np.float64).max)
    errors = np.where(np.isfinite(errors), errors, 0.0)  # values whose squares overflow
    peaks = _peaks(specimen, lights, values.shape[1])
    total = values + peaks
    excess = total - 1 - 4 * errors
    worst = np.unravel_index(int(np.argmax(excess)), excess.shape)
    findings: tuple[Finding, ...] = ()
    if excess.max() > DOUBT:
        findings = (_explained(specimen, total, float(excess.max()), int(worst[0])),)
    spherical = _spherical(total)
    lost = " with what mirrors or goes through" if peaks.any() else ""
    says = (
        f"Of light along the normal {_range(total[0])} leaves{lost}, of light from {ANGLES[-2]:g}° {_range(total[-2])}, "
        f"of uniform light {_range(spherical)}; the most is {total.max():.4g}, from {ANGLES[int(worst[0])]:g}°."
    )
    own = specimen.material.channels if specimen.material is not None else ()
    numbers = {
        "channels": list(names_or_default(own, values.shape[1])),
        "theta_i_deg": list(ANGLES),
        "directional_albedo": plain(total),
        "standard_error": plain(errors, 2),
        "in_peaks_or_through": plain(peaks),
        "spherical_albedo": plain(spherical),
    }
    return Check("energy", says, findings, numbers)


def _range(values: Floats) -> str:
    low, high = float(values.min()), float(values.max())
    return f"{low:.3g}" if high - low < 5e-3 else f"{low:.3g} to {high:.3g}"


def _spherical(values: Floats) -> Floats:
    """Of uniform light (C,): the trapezoid rule over sin², to 90 degrees as at the last angle."""
    u = np.append(np.sin(np.radians(ANGLES)) ** 2, 1.0)
    padded = np.concatenate([values, values[-1:]])
    return np.asarray(np.sum(0.5 * (padded[1:] + padded[:-1]) * np.diff(u)[:, None], axis=0))


def _peaks(specimen: Specimen, lights: Floats, channels: int) -> Floats:
    """What Dirac peaks and transmission add (A, C), by the subject's own samples; 0 where it has none."""
    shares = np.zeros((len(lights), channels))
    if specimen.sample is None:
        return shares
    numbers = np.random.default_rng(21).random((20_000 if specimen.transmits else 2_000, 2))
    for k, wi in enumerate(lights):
        drawn = specimen.sample(wi, numbers)
        if drawn.weight is None or (drawn.peaks is None and not specimen.transmits):
            continue
        other = drawn.wo[:, 2] < 0
        if drawn.peaks is not None:
            other = other | drawn.peaks
        shares[k] = np.where(other[:, None], np.nan_to_num(drawn.weight), 0.0).mean(0)
    return shares


def _explained(specimen: Specimen, total: Floats, excess: float, at: int) -> Finding:
    worst = float(total.max())
    says = f"More light leaves than arrives: {worst:.4g} times as much from {ANGLES[at]:g}°"
    outcome = Outcome.FAULT if excess > FAULT else Outcome.DOUBT
    outcome = Outcome.DOUBT if specimen.measured and worst < 2 else outcome
    name, why = _cause(total.max(axis=1), excess)
    return Finding(name, says, why, outcome)


def _cause(curve: Floats, excess: float) -> tuple[str, str]:
    """What probably makes an albedo curve (A,) exceed 1."""
    cosine = np.cos(np.radians(ANGLES))
    steep = np.array(ANGLES) >= 60
    slope = float(np.polyfit(np.log(cosine[steep]), np.log(np.maximum(curve[steep], 1e-9)), 1)[0])
    if curve[0] <= 1 + DOUBT:
        if slope < -0.7:
            return (
                "unclamped-at-grazing",
                "It grows without bound towards grazing: is it divided by a cosine once too often, or without the masking that balances it?",
            )
        if curve[-1] > curve[0] + 0.02:
            return "too-much-at-grazing", (
                "Energy holds along the normal alone: are a diffuse part and a highlight added without one giving way to the other?"
            )
        return "energy", "Do the albedos of its parts add up to more than 1?"
    for factor, name, why in SCALES:
        if curve.max() / factor <= 1 + DOUBT:
            # A little too much is no factor: what is left would be dark.
            why += " Or does each of its parts return all of the light?" if curve.max() < 2 else ""
            return (name, why) if excess > 0.1 else ("energy", "Do the albedos of its parts add up to more than 1?")
    return "energy", "No known factor explains it: is the distribution of facets or the phase function not normalised?"
