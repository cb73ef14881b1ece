"""A fit in sentences: did it converge, how close is it, what is determined, where it misses."""

from __future__ import annotations

import math

import numpy as np

from motes.fitting.result import Fit
from motes.fitting.verdicts import Verdict
from motes.report.slices import NearMirror, Samples, grows, ratio_by_angle


def percent(share: float) -> str:
    """A share as text: two digits, and none too many."""
    if not math.isfinite(share):
        return "not defined"
    value = 100 * share
    if value >= 1e5:
        return f"{value:.1e} %"
    if value == 0 or value >= 10:
        return f"{value:,.0f} %"
    return f"{value:.1f} %" if value >= 0.95 else f"{value:.2g} %"


def count(n: float, one: str, many: str | None = None) -> str:
    """``1 sample``, ``1,439 samples``."""
    return f"{int(n):,} {one if n == 1 else many or one + 's'}"


def verdict(fit: Fit) -> str:
    """How it ended, and how close it is, in a sentence or two."""
    share = fit.metrics.get("relative_rms", math.nan)
    n = fit.metrics.get("n_samples", float(fit.measurement.mask.sum()))
    ended = "The fit converged" if fit.status.ok else "The fit did not converge: do not trust its numbers"
    if not math.isfinite(share):
        return f"{ended}. Its distance from the data is not defined: no usable sample has a value above 0."
    if share <= 0.1:
        close = "the model follows the measurement closely"
    elif share <= 0.3:
        close = "the model follows the measurement in outline"
    else:
        close = "the model misses much of the measurement"
    join = ". As it stands, " if not fit.status.ok else " and " if share <= 0.3 else ", but "
    return f"{ended}{join}{close}: relative RMS {percent(share)} over {count(n, 'sample')}."


def determined(fit: Fit) -> str:
    """Which parameters the data determine."""
    free = {name: p for name, p in fit.parameters.items() if p.verdict is not Verdict.FIXED}
    sentences = []
    groups = (
        (Verdict.UNIDENTIFIABLE, "not determined by these data"),
        (Verdict.WEAK, "only weakly determined"),
        (Verdict.AT_LOWER, "at its lower bound"),
        (Verdict.AT_UPPER, "at its upper bound"),
    )
    for kind, words in groups:
        for name, p in free.items():
            hits = sum(v is kind for v in p.verdicts)
            if hits:
                where = (
                    f" in {hits} of {len(p.verdicts)} channels"
                    if len(p.verdicts) > 1 and hits < len(p.verdicts)
                    else ""
                )
                sentences.append(f"{name} is {words}{where}")
    if not free:
        return "All parameters were fixed."
    if not sentences:
        return (
            "The data determine its parameter." if len(free) == 1 else f"The data determine all {len(free)} parameters."
        )
    return "; ".join(sentences) + "."


def misses(samples: Samples, near: NearMirror | None) -> str | None:
    """Where the fit is furthest off, when it is off by a quarter or more; None when nowhere."""
    if near is not None:
        theta_i, by_angle = ratio_by_angle(near)
        degrees = np.degrees(theta_i)
        if grows(near):
            return (
                f"The measured highlight grows towards grazing faster than the fitted one: measured over fitted goes from {by_angle[0]:.2g} "
                f"at θᵢ = {degrees[0]:.0f}° to {by_angle[-1]:.2g} at {degrees[-1]:.0f}°."
            )
        worst = int(np.argmax(np.abs(np.log(by_angle)))) if len(by_angle) else 0
        if len(by_angle) and abs(math.log(by_angle[worst])) > math.log(1.25):
            return f"Near the mirror direction the measurement is {by_angle[worst]:.2g} times the fit at θᵢ = {degrees[worst]:.0f}°."
    ratio = samples.thinned().ratio
    log = np.abs(np.log(ratio[np.isfinite(ratio)]))
    if log.size and np.median(log) > math.log(1.25):
        return (
            f"Half of the samples differ from the fit by more than a factor of {math.exp(float(np.median(log))):.2g}."
        )
    return None
