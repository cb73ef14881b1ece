"""What fits make of dust that is real: measurements simulated by photons, which know nothing of the model that is fitted."""

from __future__ import annotations

import re
from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest

import motes
import photons
from motes import BRDF, Lambert, TorranceSparrow
from motes.directions import from_spherical
from motes.measurements import Measurement
from motes.models import GGX
from photons import Layer

CASES = [(0.2, 0.95, 0.6), (0.5, 0.9, 0.3), (2.0, 0.95, 0.6)]  # tau, w, g


def measured(layer: Layer, noise: float = 0.02, seed: int = 1) -> Measurement:
    """120 pairs of directions, up to 75 degrees, with noise of so much of each value; the photons' own is far less."""
    random = np.random.default_rng(seed)
    wo = from_spherical(np.radians(np.arange(0, 76, 15))[:, None], np.radians([0, 45, 90, 135, 180])).reshape(-1, 3)
    parts = []
    for k, theta_i in enumerate(np.radians([5, 25, 45, 65])):
        wi = from_spherical(theta_i, 0.0)
        seen, _ = photons.both(layer, wi, wo, 2**16, seed=seed + k)
        assert np.median(seen.error / seen.value) < 0.3 * noise
        values = seen.value * (1 + noise * random.standard_normal(len(wo)))
        parts.append((np.broadcast_to(wi, wo.shape), wo, values[:, None]))
    return Measurement.from_arrays(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


@lru_cache
def scattered(tau: float, w: float, g: float) -> Measurement:
    return measured(Layer(Lambert(0.3), tau, w, g))


def values(fit: motes.Fit) -> dict[str, float]:
    return {name: float(np.ravel(p.value)[0]) for name, p in fit.parameters.items()}


def rows(section: str, case: tuple[float, float, float]) -> list[float]:
    """The numbers of a case in the table of a section of the page, which shows these very fits."""
    page = (Path(__file__).parents[1] / "docs" / "dust.md").read_text(encoding="utf-8")
    text = page.partition(f"## {section}\n")[2].partition("\n## ")[0]
    tau, w, g = case
    (row,) = re.findall(rf"^\| {tau:g}, {w:g}, {g:g} \| (.*) \|$", text, re.MULTILINE)
    return [float(x) for x in re.findall(r"[\d.]+", row)]


@pytest.mark.parametrize("case", CASES)
def test_single_scattering_mistakes_real_dust(case: tuple[float, float, float]) -> None:
    """The form of the source follows such data well, with thinner dust that gives back more light than it gets: not a finding."""
    fit = motes.fit(scattered(*case), "dust_layer(lambert)")
    assert fit.metrics["relative_rms"] < 0.1
    found = values(fit)
    assert found["w"] > 1.3
    assert found["tau"] < 0.6 * case[0]
    here = [found["tau"], found["w"], found["g"], 100 * fit.metrics["relative_rms"]]
    np.testing.assert_allclose(rows("What single scattering misses", case), here, rtol=0.05)


@pytest.mark.parametrize("case", CASES)
def test_multiple_scattering_finds_real_dust(case: tuple[float, float, float]) -> None:
    """tau, w, g and the base within 3 standard errors, with no w beyond what a particle can do."""
    fit = motes.fit(scattered(*case), "dust_layer(lambert, scattering=multiple)")
    found = values(fit)
    errors = {name: float(np.ravel(p.stderr)[0]) for name, p in fit.parameters.items()}
    for name, true in zip(("tau", "w", "g", "K_d"), (*case, 0.3), strict=True):
        assert abs(found[name] - true) < 3 * errors[name], name
        assert errors[name] < 0.2 * max(true, 0.6), name  # what it finds says something
    shown = rows("All orders of scattering", case)
    here = [x for name in ("tau", "w", "g") for x in (found[name], errors[name])]
    np.testing.assert_allclose(shown, [*here, 100 * fit.metrics["relative_rms"]], rtol=0.1)


#: Over Lambert's 0.1 and facets that reflect half: what it is made of, the text of the fit, and tau, w, g.
GLOSSY: dict[str, tuple[BRDF, str, tuple[float, float, float]]] = {
    "Torrance-Sparrow": (
        TorranceSparrow(0.5, 0.15, "facets"),
        "torrance_sparrow(normalization=facets)",
        (0.5, 0.9, 0.6),
    ),
    "GGX": (GGX(0.5, 0.3), "ggx", (0.5, 0.9, 0.3)),
    "GGX, narrower": (GGX(0.5, 0.2), "ggx", (0.2, 0.95, 0.6)),
}
# What the model is off by in tau, w and g over a highlight, beside standard errors: docs/dust.md states it.
OFF = (0.02, 0.03, 0.02)


@pytest.mark.parametrize("name", GLOSSY)
def test_dust_over_a_highlight_is_found(name: str) -> None:
    """tau, w and g within 3 standard errors and what the model is off by; and the highlight's width."""
    highlight, text, case = GLOSSY[name]
    fit = motes.fit(
        measured(Layer(Lambert(0.1) + highlight, *case)), f"dust_layer(lambert + {text}, scattering=multiple)"
    )
    found = values(fit)
    errors = {key: float(np.ravel(p.stderr)[0]) for key, p in fit.parameters.items()}
    for key, true, off in zip(("tau", "w", "g"), case, OFF, strict=True):
        assert abs(found[key] - true) < 3 * errors[key] + off, key
        assert errors[key] < 0.1 * max(true, 0.4), key
    width = "alpha" if "alpha" in found else "sigma_s"
    true = float(getattr(highlight, width))
    assert abs(found[width] / true - 1) < 0.04
    page = (Path(__file__).parents[1] / "docs" / "dust.md").read_text(encoding="utf-8")
    shown_for = f"{name} | {true:g} | {', '.join(f'{x:g}' for x in case)}"
    (row,) = re.findall(rf"^\| {re.escape(shown_for)} \| (.*) \|$", page, re.MULTILINE)
    shown = [float(x) for x in re.findall(r"[\d.]+", row)]
    here = [x for key in ("tau", "w", "g") for x in (found[key], errors[key])]
    np.testing.assert_allclose(shown, [*here, 100 * fit.metrics["relative_rms"]], rtol=0.1)


def test_without_dust_the_surface_is_found() -> None:
    fit = motes.fit(measured(Layer(Lambert(0.3), 0.0, 0.9, 0.3)), "lambert")
    assert abs(fit.parameters["K_d"].value - 0.3) < 3 * fit.parameters["K_d"].stderr
