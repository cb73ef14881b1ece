"""Which conventions a subject follows: what physics alone tells, and with a reference which rival hypothesis its values follow."""

from __future__ import annotations

import numpy as np

from motes.certification.certificate import Check, Finding, Outcome
from motes.certification.hemisphere import turned, upper
from motes.certification.rivals import Rival, constant, distance, rivals
from motes.certification.specimen import Floats, Specimen
from motes.certification.wording import plain, share

COUNT = 900
#: What a hypothesis may leave: of a formula in float64, of one in float32 or a table, of an instrument.
EXACT, CLOSE, NEAR = 2e-4, 3e-3, 0.05
SHOWN = 6
UNDECIDED = (
    "Without a reference (--as MODEL or --against MATERIAL) physics alone is judged: the cosine by reciprocity, a factor by the energy, "
    "the normal by rotation. Alpha or its square, degrees, the sign of g and the order of the channels cannot be told."
)


def check_conventions(specimen: Specimen, reference: Specimen | None) -> Check:
    """By physics; against `reference` by rival hypotheses."""
    if specimen.pairs is None:
        turning, frame = _frame(specimen)
    else:
        turning, frame = "", None
    if reference is None:
        return Check(
            "conventions",
            f"{turning} {UNDECIDED}".strip(),
            () if frame is None else (frame,),
            {"reference": None},
            judged=bool(turning),
        )
    wi, wo = compared_pairs(specimen)
    values = specimen.eval(wi, wo)
    usable = np.isfinite(values).all(1)
    if not usable.any():
        return Check("conventions", "Not judged: no value is a finite number.", judged=False)
    wi, wo, values = wi[usable], wo[usable], values[usable]
    expected = reference.eval(wi, wo)
    if expected.shape[1] not in (1, values.shape[1]) and values.shape[1] != 1:
        return Check(
            "conventions",
            f"Not judged: {specimen.name} has {values.shape[1]} channels and {reference.name} {expected.shape[1]}.",
            judged=False,
        )
    before = distance(values, expected)
    allowed = _allowed(specimen, reference)
    numbers = {"reference": reference.name, "reference_kind": reference.kind, "difference": plain(before, 3)}
    if before <= allowed:
        return Check(
            "conventions",
            f"{turning} It agrees with {reference.name}: the mean difference is {share(before)} of the values.".strip(),
            () if frame is None else (frame,),
            numbers,
        )
    ranked = rivals(values, wi, wo, reference)
    numbers["rivals"] = [
        {
            "changes": [c.name for c in rival.changes],
            "scale": plain(rival.scale, 5),
            "difference": plain(rival.residual, 3),
        }
        for rival in ranked[:SHOWN]
    ]
    says = f"It differs from {reference.name} by {share(before)} of the values in the mean"
    return Check(
        "conventions",
        f"{turning} {says}.".strip(),
        tuple(_named(ranked[0], before, allowed, says, specimen.measured)),
        numbers,
    )


def _allowed(specimen: Specimen, reference: Specimen) -> float:
    if specimen.measured or reference.measured:
        return NEAR
    return CLOSE if specimen.single or reference.single else EXACT


def _named(best: Rival, before: float, allowed: float, says: str, measured: bool) -> list[Finding]:
    """A finding for each change, and for the constant; one without a name where nothing explains it."""
    explains = best.residual <= max(allowed, 0.02 * before) and (best.changes or best.scale != 1)
    if not explains:
        parts = [c.asks for c in best.changes]
        if best.scale != 1:
            parts.append(f"The constant is {best.scale:.4g}.")
        nearest = f" The nearest of them leaves {share(best.residual)}: {' '.join(parts)}" if parts else ""
        outcome = Outcome.DOUBT if measured else Outcome.FAULT  # no model follows every material
        return [Finding("differs", says, f"No rival hypothesis explains it: is it another model?{nearest}", outcome)]
    found = [
        Finding(change.name, says, f"{change.asks} That leaves {share(best.residual)}.") for change in best.changes
    ]
    if best.scale != 1:
        known = constant(best.scale)
        name, asks = known or ("scale", f"It is {best.scale:.5g} times the reference.")
        if known is None:
            asks += " Is a normalisation missing, or another strength given?"
        found.append(Finding(name, says, f"{asks} That leaves {share(best.residual)}."))
    return found


def compared_pairs(specimen: Specimen) -> tuple[Floats, Floats]:
    """Pairs to compare at, and which of them count: not too near the horizon, a third of them about the mirror direction."""
    if specimen.pairs is not None:
        wi, wo = specimen.pairs
        above = (wi[:, 2] > 0.05) & (wo[:, 2] > 0.05)
        if above.sum() > 4 * COUNT:
            above &= np.arange(len(wi)) % int(above.sum() // (2 * COUNT)) == 0
        return wi[above], wo[above]
    a, b = upper(COUNT, 15), upper(COUNT, 16)
    rng = np.random.default_rng(17)
    near = turned(a[: COUNT // 3]) + rng.normal(0, 0.1, (COUNT // 3, 3))
    b[: COUNT // 3] = near / np.linalg.norm(near, axis=1, keepdims=True)
    above = (a[:, 2] > 0.1) & (b[:, 2] > 0.1)
    return a[above], b[above]


def _frame(specimen: Specimen) -> tuple[str, Finding | None]:
    """Whether turning both directions about z, y or x changes the values: isotropy, and which axis is the normal."""
    a, b = upper(500, 18), upper(500, 19)
    left = {axis: _turned(specimen, a, b, k) for k, axis in enumerate("xyz")}
    if left["z"] <= 1e-2 or np.isnan(left["z"]):
        return "It is isotropic: turning both directions about the normal changes nothing.", None
    axis = min("xy", key=lambda name: left[name])
    if left[axis] <= 1e-2:
        return "", Finding(
            f"normal-is-{axis}",
            f"Turning both directions about z changes the values by {share(left['z'])}, and about {axis} not at all",
            f"Is {axis} the normal, where here z is?",
        )
    return (
        f"It is anisotropic: turning both directions about the normal changes the values by {share(left['z'])}.",
        None,
    )


def _turned(specimen: Specimen, a: Floats, b: Floats, axis: int) -> float:
    """The mean change of the values as both directions are turned about an axis, where all stay above the horizon."""
    changes = []
    for angle in (0.4, 1.1, 2.3):
        c, s = np.cos(angle), np.sin(angle)
        p, q = (axis + 1) % 3, (axis + 2) % 3
        turn = np.eye(3)
        turn[p, p], turn[p, q], turn[q, p], turn[q, q] = c, -s, s, c
        x, y = a @ turn.T, b @ turn.T
        keep = np.minimum.reduce([w[:, k] for w in (a, b, x, y) for k in {2, axis}]) > 0.05
        if keep.sum() < 20:
            continue
        first, then = specimen.eval(a[keep], b[keep]), specimen.eval(x[keep], y[keep])
        good = np.isfinite(first).all(1) & np.isfinite(then).all(1)
        if good.any() and (first[good].any() or then[good].any()):
            changes.append(distance(first[good], then[good]))
    return max(changes, default=float("nan"))
