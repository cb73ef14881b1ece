"""The hint that a highlight wants a Fresnel term: given where the measurement has one and the model has none, and nowhere else."""

from __future__ import annotations

import numpy as np
import pytest

import motes
from motes.directions import from_spherical
from motes.fitting.grazing import by_angle, without_fresnel
from motes.measurements import Measurement
from motes.models.fresnel import Dielectric

BODY = motes.OrenNayar(K_d=(0.3, 0.1, 0.05), sigma_d=0.3)
VARNISHED = BODY + motes.TorranceSparrow(K_s=2.0, sigma_s=0.15, fresnel=Dielectric(n=1.5))
PLAIN = BODY + motes.TorranceSparrow(K_s=0.2, sigma_s=0.15)
MODEL = "oren_nayar + torrance_sparrow"


def measured(brdf: motes.BRDF, most: float = 75.0) -> Measurement:
    """As a goniometer goes: about the mirror direction, at many angles of incidence, with 2 % noise."""
    incidence, off = np.meshgrid(np.radians(np.arange(5, most + 1, 5)), np.radians(np.arange(-20, 21, 4)))
    theta_r = np.clip(incidence + off, 0, np.radians(most))
    wi, wo = from_spherical(incidence.ravel(), 0.0), from_spherical(theta_r.ravel(), np.pi)
    values = brdf.eval(wi, wo)
    return Measurement.from_arrays(wi, wo, values * (1 + 0.02 * np.random.default_rng(1).standard_normal(values.shape)))


def hints(fit: motes.Fit | motes.TimeFit) -> list[str]:
    return [found for found in fit.findings if "Fresnel" in found]


def test_a_varnish_without_its_term_is_told() -> None:
    fit = motes.fit(measured(VARNISHED), MODEL)
    (hint,) = hints(fit)
    assert "torrance_sparrow(fresnel=schlick) in place of torrance_sparrow" in hint
    assert "--max-theta-deg" not in hint
    angles, ratio = by_angle(fit)
    assert f"from {ratio[0]:.2g} at {np.degrees(angles[0]):.0f} degrees to {ratio[-1]:.2g}" in hint
    # What it says is so: the fit with the term follows.
    mended = motes.fit(measured(VARNISHED), "oren_nayar + torrance_sparrow(fresnel=schlick)")
    assert mended.metrics["relative_rms"] < 0.5 * fit.metrics["relative_rms"]
    assert not hints(mended)


def test_where_the_model_follows_nothing_is_told() -> None:
    fit = motes.fit(measured(PLAIN), MODEL)
    assert not hints(fit)
    np.testing.assert_allclose(by_angle(fit)[1], 1.0, atol=0.02)


def test_without_grazing_samples_nothing_is_told() -> None:
    assert not hints(motes.fit(measured(VARNISHED, most=55), MODEL))


def test_auto_has_looked_at_the_term_itself() -> None:
    assert not hints(motes.fit(measured(VARNISHED), "auto"))


def test_series_are_told_too() -> None:
    one = measured(VARNISHED)
    series = Measurement.from_arrays(one.wi, one.wo, np.repeat(one.values, 3, axis=0), times=[0.0, 1.0, 2.0])
    assert len(hints(motes.fit(series, MODEL))) == 1


def test_where_samples_at_the_horizon_outweigh_all_others_the_option_that_leaves_them_out_is_named() -> None:
    one = measured(VARNISHED)
    wi, wo = from_spherical(np.full(30, np.radians(86)), 0.0), from_spherical(np.linspace(1.42, 1.5, 30), np.pi / 2)
    huge = np.tile(np.linspace(5, 50, 30)[:, None], (1, 3))
    data = Measurement.from_arrays(np.r_[one.wi, wi], np.r_[one.wo, wo], np.r_[one.values[0], huge])
    fit = motes.fit(data, MODEL)
    assert [hint for hint in hints(fit) if "--max-theta-deg 80" in hint]


@pytest.mark.parametrize(
    ("brdf", "expected"),
    [
        (PLAIN, True),
        (VARNISHED, False),
        (BODY, False),
        (motes.DustLayer(PLAIN, motes.Dust(w=0.5, g=0.1), tau=0.2), True),
    ],
)
def test_who_lacks_a_term(brdf: motes.BRDF, expected: bool) -> None:
    assert without_fresnel(brdf) is expected
