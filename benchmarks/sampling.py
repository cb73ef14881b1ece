"""Sampling: how many directions a second, and how much less noise than sampling by the cosine.

usage: python benchmarks/sampling.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import rivals
from motes import BRDF, Dust, DustLayer, MotesError, OrenNayar, TorranceSparrow
from motes.arrays import NUMPY
from motes.directions import from_spherical
from motes.models.lifting import averaged
from results import Effort, Goal, Number, Section, Table, command
from rivals import SURFACE
from timing import interleaved

MATERIALS: dict[str, BRDF] = {
    "rough diffuse, sigma_d = 0.6": OrenNayar(K_d=0.8, sigma_d=0.6),
    "diffuse and broad highlight, sigma_s = 0.3": OrenNayar(K_d=0.4, sigma_d=0.3) + TorranceSparrow(0.4, 0.3),
    "diffuse and sharp highlight, sigma_s = 0.05": OrenNayar(K_d=0.2, sigma_d=0.3) + TorranceSparrow(0.8, 0.05),
    "highlight alone, sigma_s = 0.1": TorranceSparrow(0.8, 0.1),
    "dust, g = 0.6": Dust(w=0.9, g=0.6),
    "dusty paint, tau = 0.2": DustLayer(
        OrenNayar(K_d=0.3, sigma_d=0.3) + TorranceSparrow(0.5, 0.08), Dust(w=0.9, g=0.3), tau=0.2
    ),
}
INCIDENCE = (0, 45, 75)  # degrees
ROUNDS = 16  # estimates of a variance
FARTHEST = 6.0  # standard errors that an estimate may be from the integral, before the sampling must be wrong
LABELS = {
    "sample": "Motes `sample`: direction, density and weight",
    "pdf": "Motes `pdf`",
    "eval": "Motes `eval`, for comparison",
    "sample_numpy": "the lobes over NumPy as they stand, sample",
    "pdf_numpy": "the lobes over NumPy as they stand, density",
    "roughplastic_sample": "Mitsuba `roughplastic`, sample and weight",
    "roughplastic_pdf": "Mitsuba `roughplastic`, density",
    "motes_dusty_sample": "the surface as Motes' Mitsuba plugin, sample and weight",
    "motes_dusty_pdf": "the surface as Motes' Mitsuba plugin, density",
}


def sampled_by_numpy(wi: NDArray[Any], u: NDArray[Any]) -> tuple[NDArray[Any], ...]:
    """Directions, densities and weights by the algebra that the engine compiles."""
    mean = averaged(SURFACE, wi)
    with np.errstate(all="ignore"):
        wo = mean.drawn(NUMPY, wi, u)
        density = mean.density(NUMPY, wi, wo)
        return wo, density, rivals.plain_numpy(wi, wo) * mean.weighing(NUMPY, wo, density)[:, None]


def throughput(effort: Effort) -> tuple[dict[str, Number], list[str]]:
    """Million samples a second of the dusty surface, by several means in turn; and what was skipped."""
    n = effort.pick(5_000, 1_000_000)
    wi, wo = (rivals.directions(n, seed) for seed in (1, 2))
    u = np.random.default_rng(3).random((n, 3), np.float32)
    pieces = [np.ascontiguousarray(w.T) for w in (wi, wo)]
    pairs = np.ascontiguousarray(u[:, :2])
    candidates: dict[str, tuple[Callable[[], Any], float]] = {
        "sample": (lambda: SURFACE.sample(pieces[0], pairs), n),
        "pdf": (lambda: SURFACE.pdf(*pieces), n),
        "eval": (lambda: SURFACE.eval(*pieces), n),
        "sample_numpy": (lambda: sampled_by_numpy(pieces[0], pairs), n),
        "pdf_numpy": (lambda: averaged(SURFACE, pieces[0]).density(NUMPY, *pieces), n),
    }
    skipped: list[str] = []
    try:
        candidates |= _drjit_candidates(wi, wo, u)
    except MotesError as error:
        skipped.append(rivals.skipped("Mitsuba", error))
    timings = interleaved(candidates, effort.pick(3, 7))
    figures: dict[str, Number] = {"samples": Number.of([n / 1e6])}
    for name, timing in timings.items():
        figures |= {
            f"{name}_rate": timing.rate.times(1e-6),
            f"{name}_share": timing.faster_than(timings["sample"]),
            f"{name}_cpu": timing.processor.times(1e9),
        }
    for name in ("sample", "pdf"):
        figures[f"{name}_over_numpy"] = timings[name].faster_than(timings[f"{name}_numpy"])
        figures[f"{name}_over_numpy_cpu"] = timings[name].cheaper_than(timings[f"{name}_numpy"])
    return figures, skipped


def _drjit_candidates(wi: rivals.Rows, wo: rivals.Rows, u: rivals.Rows) -> dict[str, tuple[Callable[[], Any], float]]:
    mi = rivals.mitsuba()
    import drjit as dr

    si, other = rivals.wavefront(mi, wi, wo)
    numbers = [mi.Float(np.ascontiguousarray(column)) for column in u.T]
    dr.eval(numbers)
    context, found = mi.BSDFContext(), {}

    def sample(bsdf: Any) -> None:
        sampled, weight = bsdf.sample(context, si, numbers[0], mi.Point2f(numbers[1], numbers[2]))
        dr.eval(sampled.wo, sampled.pdf, weight)
        dr.sync_thread()

    def pdf(bsdf: Any) -> None:
        dr.eval(bsdf.pdf(context, si, other))
        dr.sync_thread()

    for name, bsdf in rivals.bsdfs(mi).items():
        if name != "principled":
            found[f"{name}_sample"] = (lambda bsdf=bsdf: sample(bsdf), wi.shape[1])
            found[f"{name}_pdf"] = (lambda bsdf=bsdf: pdf(bsdf), wi.shape[1])
    return found


def estimates(brdf: BRDF, wi: NDArray[Any], u: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """One estimate of the directional albedo a random number: by the model's own sampling, and by sampling the cosine."""
    own = brdf.sample(wi, u).weight.mean(axis=-1)
    radius, phi = np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]
    wo = np.stack([radius * np.cos(phi), radius * np.sin(phi), np.sqrt(1 - u[:, 0])], axis=-1)
    return own, np.pi * brdf.eval(wi, wo).mean(axis=-1)


def variance(brdf: BRDF, theta_i: float, samples: int, seed: int) -> Number:
    """How many times the variance of an estimate by the model's own sampling that by the cosine has.

    Raises
    ------
    ArithmeticError
        When an estimate is not that of `directional_albedo`.
    """
    wi = from_spherical(theta_i, 0.3)
    expected = float(np.mean(brdf.directional_albedo(wi)))
    rng = np.random.default_rng(seed)
    ratios, own_all = [], []
    for _ in range(ROUNDS):
        own, cosine = estimates(brdf, wi, rng.random((samples // ROUNDS, 2)))
        ratios.append(cosine.var() / own.var())
        own_all.append(own)
    together = np.concatenate(own_all)
    error = abs(together.mean() - expected) / (together.std() / np.sqrt(len(together)) + 1e-4 * expected)
    if error > FARTHEST:
        raise ArithmeticError(f"{brdf}: {together.mean():.5g} is {error:.1f} standard errors from {expected:.5g}")
    return Number.of(ratios)


def _case(name: str) -> str:
    """The material and the angle of a figure ``variance_MATERIAL_ANGLE``."""
    _, material, degrees = name.split("_")
    return f"{list(MATERIALS)[int(material)]}, theta_i = {degrees}°"


def sampling(effort: Effort) -> Section:
    """Throughput, and variances of several materials at several angles of incidence."""
    figures, skipped = throughput(effort)
    samples = effort.pick(16_000, 1_600_000)
    figures["estimates"] = Number.of([samples])
    rows = []
    for k, (label, brdf) in enumerate(MATERIALS.items()):
        row = [label]
        for degrees in INCIDENCE:
            name = f"variance_{k}_{degrees}"
            figures[name] = variance(brdf, np.radians(degrees), samples, 100 * k + degrees)
            row.append(f"{{{name}}}")
        rows.append(row)
    ratios = {name: f for name, f in figures.items() if name.startswith("variance_")}
    least, most = (choose(ratios, key=lambda name: ratios[name].median) for choose in (min, max))
    figures |= {"least": ratios[least], "most": ratios[most]}
    speeds = [
        [label, f"{{{name}_rate}}", f"{{{name}_share}}", f"{{{name}_cpu}}"]
        for name, label in LABELS.items()
        if f"{name}_rate" in figures
    ]
    reading = [
        "`sample` takes {sample_over_numpy} as many directions a second as the same lobes over NumPy ({sample_over_numpy_cpu} by processor time), "
        "`pdf` {pdf_over_numpy} ({pdf_over_numpy_cpu})."
        + (" The plugin samples {motes_dusty_sample_share} times as fast as `sample`." if not skipped else ""),
        f"At equal samples the variance by the cosine is from {{least}} ({_case(least)}) to {{most}} times ({_case(most)}) that of the model's own sampling.",
    ]
    below = [_case(name) for name, f in ratios.items() if f.median < 0.98]
    if below:
        reading.append(f"The cosine does better here: {'; '.join(below)}.")
    return Section(
        title="Sampling",
        made_by="benchmarks/sampling.py, throughput() and variance()",
        intro=(
            "{samples:bare} million directions of the dusty RGB surface, one to each of as many incident ones; then the variance of estimates of the "
            "directional albedo by sampling the cosine over that by `model.sample`, from {estimates:count} samples each. Every mean was "
            "checked against `directional_albedo`."
        ),
        figures=figures,
        tables=[
            Table(["", "M/s, wall", "x Motes `sample`", "ns of processor"], speeds),
            Table(["variance: cosine / own", *(f"theta_i = {d}°" for d in INCIDENCE)], rows),
        ],
        goals=[
            Goal("Motes `sample`", "sample_rate", 60, unit=" M/s"),
            Goal("Motes `pdf`", "pdf_rate", 200, unit=" M/s"),
        ],
        reading=reading,
        skipped=skipped,
    )


if __name__ == "__main__":
    command(sampling, __doc__)
