"""Whether samples follow their density, and weights are f cos / pdf: chi-square at several angles, and rivals of a density that fails."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.certification.certificate import Check, Finding, Outcome
from motes.certification.chi_square import Bins, chi_square, sidak, survival
from motes.certification.specimen import Drawn, Floats, Specimen
from motes.certification.wording import plain, share
from motes.directions import from_spherical

ANGLES = (0.0, 50.0, 80.0)
SAMPLES = 40_000
#: The chance that a subject without fault fails at any of its angles.
SIGNIFICANCE = 1e-3

Factor = Callable[[Floats, Floats], Floats]


def _half(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """cos(theta_h) and the cosine between a direction and the half vector, (...)."""
    h = wi + wo
    length = np.maximum(np.linalg.norm(h, axis=-1), 1e-12)
    return h[..., 2] / length, np.sum(wo * h, axis=-1) / length


def _sine(w: Floats) -> Floats:
    return np.maximum(np.hypot(w[..., 0], w[..., 1]), 1e-9)


#: What a density may lack: a name, the question, and the factor that mends it.
FACTORS: tuple[tuple[str, str, Factor], ...] = (
    (
        "jacobian-of-half-vector",
        "Divided by 4 (wo . h) it is right: is it the density of half vectors, without the Jacobian 1 / (4 wo . h)?",
        lambda wi, wo: 1 / (4 * np.maximum(_half(wi, wo)[1], 1e-9)),
    ),
    (
        "jacobian-without-4",
        "Divided by 4 it is right: does the Jacobian of the half vector lack its 4?",
        lambda wi, wo: np.full(wo.shape[:-1], 0.25),
    ),
    (
        "jacobian-twice",
        "Times 4 (wo . h) it is right: is the Jacobian of the half vector applied twice, or to samples that are no half vectors?",
        lambda wi, wo: 4 * np.maximum(_half(wi, wo)[1], 0),
    ),
    (
        "cosine-missing-in-pdf",
        "Times cos(theta_r) / pi or a like factor it is right: does it lack the cosine of wo?",
        lambda wi, wo: wo[..., 2],
    ),
    (
        "cosine-too-many-in-pdf",
        "Divided by cos(theta_r) it is right: is it a density per projected solid angle, or does it have the cosine once too often?",
        lambda wi, wo: 1 / np.maximum(wo[..., 2], 1e-6),
    ),
    (
        "cosine-of-half-vector-missing",
        "Times cos(theta_h) it is right: does D lack the cosine with which half vectors are drawn?",
        lambda wi, wo: _half(wi, wo)[0],
    ),
    (
        "sine-in-pdf",
        "Divided by sin(theta_r) it is right: is it a density of angles (theta, phi) and not of solid angle?",
        lambda wi, wo: 1 / _sine(wo),
    ),
    (
        "sine-missing-in-pdf",
        "Times sin(theta_r) it is right: are angles drawn evenly that should be drawn by solid angle?",
        lambda wi, wo: _sine(wo),
    ),
    ("scale-of-pdf", "It differs by a constant factor alone: is it normalised, and times the chance of its lobe?", lambda wi, wo: np.ones(wo.shape[:-1])),
)  # fmt: skip


@dataclass(frozen=True)
class _Run:
    """One angle: where samples fell, what the density expects there, and how likely that is."""

    wi: Floats
    bins: Bins
    drawn: Drawn
    counts: Floats
    shares: Floats
    density: Callable[[Floats], Floats]

    @property
    def lost(self) -> float:
        return SAMPLES - float(self.counts.sum())

    def chance(self, shares: Floats) -> tuple[float, float, int]:
        """The chance of so bad an agreement, the statistic, its degrees of freedom."""
        if not np.all(shares >= -1e-12):  # a mended density that is none
            return 0.0, float("inf"), 1
        expected = SAMPLES * np.append(shares, max(1 - shares.sum(), 1e-6 / SAMPLES))
        statistic, freedom = chi_square(np.append(self.counts, self.lost), expected)
        # One pooled bin is no agreement: nothing is expected where samples are.
        return survival(statistic, freedom) if freedom else float(shares.sum() > 0.5), statistic, freedom


def check_sampling(specimen: Specimen) -> Check:
    """At three angles, with the significance shared by them (Sidak)."""
    if specimen.sample is None or specimen.pdf is None:
        which = "samples" if specimen.sample is None else "a density of its samples"
        return Check("sampling", f"Not judged: the subject has no {which}.", judged=False)
    level = sidak(SIGNIFICANCE, len(ANGLES))
    lights = from_spherical(np.radians(ANGLES), 0.5)
    runs = [run for k, wi in enumerate(lights) if (run := _run(specimen, wi, k)) is not None]
    wrong = _directions(specimen, lights)
    if wrong is not None:
        return Check("sampling", f"Not judged further: {wrong.says}.", (wrong,), judged=False)
    if not runs:
        return Check(
            "sampling", "Not judged: all samples are mirrored or go through, which has no density.", judged=False
        )
    judged = [run.chance(run.shares) for run in runs]
    findings = [
        f for f in (_density(specimen, runs, judged, level), _weights(specimen, runs), _same(runs, specimen)) if f
    ]
    angles = [ANGLES[k] for k, wi in enumerate(lights) if any(np.array_equal(run.wi, wi) for run in runs)]
    says = (
        f"{SAMPLES:,} samples at each of {len(runs)} angles, in bins as fine as they lie dense: chi-square "
        + ", ".join(f"{statistic:.0f} of {freedom} at {a:g}°" for (_, statistic, freedom), a in zip(judged, angles, strict=True))
        + f"; judged at {level:.2g} each, so that a right one fails in {share(SIGNIFICANCE)} of cases (Sidak)."
    )  # fmt: skip
    numbers = {
        "theta_i_deg": angles,
        "samples": SAMPLES,
        "level": plain(level),
        "chance": plain([p for p, _, _ in judged]),
        "chi_square": plain([s for _, s, _ in judged]),
        "degrees_of_freedom": [n for _, _, n in judged],
        "integral_of_density": plain([float(run.shares.sum()) for run in runs]),
        "share_above_horizon": plain([float(run.counts.sum()) / SAMPLES for run in runs]),
        "picture": _picture(runs[min(1, len(runs) - 1)]),
    }
    return Check("sampling", says, tuple(findings), numbers)


def _run(specimen: Specimen, wi: Floats, k: int) -> _Run | None:
    assert specimen.sample is not None
    assert specimen.pdf is not None
    first = specimen.sample(wi, np.random.default_rng(100 + k).random((SAMPLES, 2)))
    drawn = specimen.sample(wi, np.random.default_rng(200 + k).random((SAMPLES, 2)))
    seen = first.wo[_smooth(first)]
    lowest = -1.0 if specimen.transmits else 0.0
    if np.count_nonzero(seen[:, 2] > lowest) < 200:
        return None
    bins = Bins.of(seen, lowest=lowest)
    density = specimen.pdf

    def shaped(wo: Floats) -> Floats:
        flat = wo.reshape(-1, 3)
        return density(np.broadcast_to(wi, flat.shape), flat).reshape(wo.shape[:-1])

    return _Run(wi, bins, drawn, bins.count(drawn.wo[_smooth(drawn)]), bins.integrate(shaped), shaped)


def _smooth(drawn: Drawn) -> NDArray[np.bool_]:
    finite: NDArray[np.bool_] = np.asarray(np.isfinite(drawn.wo).all(axis=1))
    return finite if drawn.peaks is None else finite & ~drawn.peaks


def _directions(specimen: Specimen, lights: Floats) -> Finding | None:
    """Whether samples are unit vectors, and on the side from which they can be seen."""
    assert specimen.sample is not None
    for wi in lights:
        drawn = specimen.sample(wi, np.random.default_rng(300).random((2000, 2)))
        lost = (
            drawn.peaks is not None and not np.isfinite(drawn.wo).any()
        )  # a renderer's own way to say that there is none
        length = np.linalg.norm(drawn.wo, axis=1)
        off = np.mean(~(np.abs(length - 1) < 1e-3)) if drawn.peaks is None else np.mean(np.abs(length - 1) >= 1e-3)
        if off > 1e-3 and not lost:
            says = f"{share(float(off))} of the samples are no unit vectors"
            return Finding("samples-not-unit", says, "Are they left unnormalised, or divided by 0?")
        if drawn.peaks is None and not specimen.transmits and np.mean(drawn.wo[:, 2] > 0) < 0.01:
            says = "Almost all samples lie below the horizon"
            return Finding(
                "samples-below-horizon",
                says,
                "Do they point the way that light travels? Here they point away from the surface.",
            )
    return None


def _density(
    specimen: Specimen, runs: list[_Run], judged: list[tuple[float, float, int]], level: float
) -> Finding | None:
    numbers = all(np.isfinite(run.shares).all() for run in runs)
    if numbers and all(p > level for p, _, _ in judged) and all(run.shares.sum() <= 1 + 2e-3 for run in runs):
        return None
    if not numbers:
        return Finding("density-not-finite", "The density is not a finite number everywhere", "Is it divided by 0?")
    if any((run.shares < -1e-9).any() for run in runs):
        return Finding(
            "density-negative", "The density is negative somewhere", "Is its sign wrong, or the horizon's test missing?"
        )
    totals = ", ".join(f"{run.shares.sum():.4g}" for run in runs)
    kept = ", ".join(f"{run.counts.sum() / SAMPLES:.4g}" for run in runs)
    says = (
        f"Samples do not follow the density: over the hemisphere it integrates to {totals}, and {kept} of the samples lie there; "
        f"the chance of such a chi-square is {min(p for p, _, _ in judged):.1g}"
    )
    name, why = _rival(specimen, runs, judged, level)
    return Finding(name, says, why)


def _rival(
    specimen: Specimen, runs: list[_Run], judged: list[tuple[float, float, int]], level: float
) -> tuple[str, str]:
    """The factor that mends the density at every angle: as it stands, or but for a constant."""
    assert specimen.pdf is not None
    density = specimen.pdf
    before = max(statistic / max(freedom, 1) for _, statistic, freedom in judged)
    for free in (False, True):  # a factor as it stands before one with a constant besides
        for name, why, factor in FACTORS[::-1] if free else FACTORS:  # the constant alone first
            left = []
            for run in runs:

                def mended(wo: Floats, wi: Floats = run.wi, factor: Factor = factor) -> Floats:
                    flat = wo.reshape(-1, 3)
                    light = np.broadcast_to(wi, flat.shape)
                    return (density(light, flat) * factor(light, flat)).reshape(wo.shape[:-1])

                shares = run.bins.integrate(mended)
                if free and shares.sum() > 0:
                    shares = shares * (run.counts.sum() / SAMPLES / shares.sum())
                p, statistic, freedom = run.chance(shares)
                left.append((p > level and shares.sum() <= 1 + 2e-3, statistic / max(freedom, 1)))
                if not left[-1][0]:
                    break
            if len(left) == len(runs) and all(good for good, _ in left) and max(s for _, s in left) < before:
                return name, why
    swapped = []
    for run in runs:

        def turned(wo: Floats, wi: Floats = run.wi) -> Floats:
            flat = wo.reshape(-1, 3)
            return density(flat, np.broadcast_to(wi, flat.shape)).reshape(wo.shape[:-1])

        swapped.append(run.chance(run.bins.integrate(turned))[0])
    if all(p > level for p in swapped):
        return "pdf-swapped", "With wi and wo exchanged it is right: are they swapped in the density?"
    if (empty := max(_empty(run) for run in runs)) > 1e-3:
        why = f"It is 0 at {share(empty)} of the samples of an angle: does it leave directions out (by a test of sides) that the sampling keeps?"
        return "samples-without-density", why
    if all(abs(run.shares.sum() - run.counts.sum() / SAMPLES) < 0.03 for run in runs):
        return (
            "shape-of-pdf",
            "Its integral is right and its shape is not: is it that of another width, another lobe's chance, or of samples drawn otherwise?",
        )
    return "pdf", "No known factor mends it."


def _empty(run: _Run) -> float:
    """The share of samples whose direction has no density by itself."""
    wo = run.drawn.wo[_smooth(run.drawn)]
    return float(np.mean(run.density(wo[wo[:, 2] > run.bins.z[0]]) <= 0))


def _off_horizon(specimen: Specimen, wo: Floats) -> NDArray[np.bool_]:
    return np.asarray((np.abs(wo[:, 2]) if specimen.transmits else wo[:, 2]) > 1e-3)


def _weights(specimen: Specimen, runs: list[_Run]) -> Finding | None:
    """Whether the weight of each sample is f cos / pdf of the sample's own density."""
    ratios, cosines, densities = [], [], []
    for run in runs:
        drawn = run.drawn
        good = _smooth(drawn) & _off_horizon(specimen, drawn.wo) & (drawn.pdf > 0)
        if drawn.weight is None or not good.any():
            continue
        rows = np.flatnonzero(good)[:4000]
        wo, pdf = drawn.wo[rows], drawn.pdf[rows]
        expected = specimen.eval(np.broadcast_to(run.wi, wo.shape), wo) * np.abs(wo[:, 2:]) / pdf[:, None]
        bright = np.argmax(expected, axis=1)
        pick = np.arange(len(rows)), bright
        usable = expected[pick] > 1e-6
        ratios.append(drawn.weight[rows][pick][usable] / expected[pick][usable])
        cosines.append(np.abs(wo[usable, 2]))
        densities.append(pdf[usable])
    if not ratios or not len(ratio := np.concatenate(ratios)):
        return None
    cosine, pdf = np.concatenate(cosines), np.concatenate(densities)
    tolerance = 2e-2 if specimen.single else 1e-3
    off = float(np.mean(~(np.abs(ratio - 1) <= tolerance)))
    if off <= 0.01:
        return None
    says = f"The weight of {share(off)} of the samples is not f cos / pdf: half of them are more than {np.median(ratio):.3g} times that"
    rivals = (
        ("weight-without-cosine", "Times cos(theta_r) it is: is the cosine forgotten?", ratio * cosine),
        ("weight-not-divided", "Divided by the density it is: is the weight f cos, not divided by the pdf?", ratio / pdf),
        ("weight-with-cosine-twice", "Divided by cos(theta_r) it is: is the cosine taken twice?", ratio / cosine),
        ("weight-f-alone", "It is f alone: neither times the cosine nor divided by the density.", ratio * cosine / pdf),
    )  # fmt: skip
    for name, why, left in rivals:
        if np.mean(np.abs(left - 1) <= 2 * tolerance) > 0.98:
            return Finding(name, says, why)
    spread = np.percentile(ratio, [5, 95])
    if spread[1] / spread[0] < 1 + 2 * tolerance:
        return Finding(
            "weight-scale", says, f"It is {np.median(ratio):.4g} times that everywhere: is a chance or a 1/pi missing?"
        )
    return Finding("weight", says, "No known factor explains it: is another density divided by than is returned?")


def _same(runs: list[_Run], specimen: Specimen) -> Finding | None:
    """Whether the density that comes with a sample is the one that is asked for by itself."""
    assert specimen.pdf is not None
    off = []
    for run in runs:
        good = _smooth(run.drawn) & _off_horizon(specimen, run.drawn.wo)
        wo = run.drawn.wo[good][:4000]
        asked, came = specimen.pdf(np.broadcast_to(run.wi, wo.shape), wo), run.drawn.pdf[good][:4000]
        off.append(np.abs(asked - came) > (2e-2 if specimen.single else 1e-3) * np.maximum(asked, came))
    part = float(np.mean(np.concatenate(off)))
    if part <= 0.01:
        return None
    return Finding(
        "pdf-of-sample",
        f"With {share(part)} of the samples comes another density than the same directions have by themselves",
        "Is it that of the chosen lobe alone, where the other lobes could have sent the sample there, too?",
        Outcome.FAULT,
    )


def _picture(run: _Run, rows: int = 24, columns: int = 48) -> dict[str, object]:
    """Counts and expectations on a coarse grid of (cos(theta_r), phi), for people."""
    z, phi = np.linspace(0 if run.bins.z[0] == 0 else -1, 1, rows + 1), np.linspace(-np.pi, np.pi, columns + 1)
    coarse = Bins(z, phi)
    counts = coarse.count(run.drawn.wo[_smooth(run.drawn)]).astype(int)
    return {
        "lowest": float(z[0]),
        "counts": counts.tolist(),
        "expected": plain(SAMPLES * coarse.integrate(run.density), 4),
    }
