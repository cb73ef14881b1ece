"""More fits against SciPy from 20 random starts, with formulas and residuals of its own: every model and loss on simulated
data, and dust layers, whose objective has the most valleys. The objective is never more than 0.1 % above SciPy's best."""

from __future__ import annotations

import numpy as np
import pytest

import motes
from fitting_oracle import MODELS, Oracle, Projected, scattered
from motes.measurements import Measurement

WORST = 1.001
ON, TS = "oren_nayar", "oren_nayar + torrance_sparrow"
DUSTY = "dust_layer(oren_nayar + torrance_sparrow)"


def vector(fit: motes.Fit, names) -> np.ndarray:
    return np.concatenate([np.atleast_1d(fit.parameters[name].value) for name in names])


def check(data: Measurement, model: str, loss: str, seed: int, starts: int = 20) -> motes.Fit:
    """Fit, and compare with the best of SciPy's; the objective must also be what the formulas of the oracle say."""
    fit = motes.fit(data, model, loss=loss)
    usable = data.mask[0].all(axis=1)
    oracle = Oracle(data.wi[usable], data.wo[usable], data.values[0][usable], model, loss)
    ours = 0.5 * np.sum(oracle.residuals(vector(fit, oracle.names)) ** 2)
    np.testing.assert_allclose(fit.metrics["objective"], ours, rtol=1e-8, atol=1e-15)
    best = oracle.best(starts, seed)
    assert ours <= WORST * best.cost + 1e-15, f"SciPy finds {best.cost:.6g} at {best.x}, we {ours:.6g}: {fit.status}"
    return fit


# ---------------------------------------------------------------- simulated: runs everywhere

TRUTH = {
    "lambert": motes.Lambert(K_d=0.5),
    ON: motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.5),
    TS: motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.5) + motes.TorranceSparrow(K_s=0.2, sigma_s=0.12),
    "dust_layer(oren_nayar)": motes.DustLayer(motes.OrenNayar(K_d=0.3, sigma_d=0.3), motes.Dust(w=0.9, g=0.3), tau=0.3),
    DUSTY: motes.DustLayer(
        motes.OrenNayar(K_d=0.3, sigma_d=0.3) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.15),
        motes.Dust(w=0.9, g=-0.3),
        tau=0.2,
    ),
}


@pytest.mark.parametrize("loss", ["linear", "plain", "log", "cube_root"])
@pytest.mark.parametrize("model", TRUTH)
def test_simulated(model: str, loss: str) -> None:
    wi, wo = scattered(120, 4)
    rng = np.random.default_rng(1)
    f = TRUTH[model].eval(wi, wo)
    data = Measurement.from_arrays(wi, wo, f * (1 + 0.05 * rng.standard_normal(f.shape)))
    fit = check(data, model, loss, seed=2)
    assert fit.status.ok


def test_simulated_data_of_another_model() -> None:
    """A misfit has more valleys than noise: dust seen as a highlight, and the other way round."""
    wi, wo = scattered(120, 5)
    for truth, model in ((DUSTY, TS), (TS, "dust_layer(oren_nayar)"), (DUSTY, ON)):
        data = Measurement.from_arrays(wi, wo, TRUTH[truth].eval(wi, wo)[:, :1])
        check(data, model, "linear", seed=3)


# ---------------------------------------------------------------- real data


@pytest.mark.parametrize("sample", [8, 19, 29, 40, 61])
def test_curet_under_dust(sample: int, shared_file) -> None:
    check(motes.read(shared_file("curet/abrdf.dat"), sample=sample), DUSTY, "linear", seed=sample)


def test_a_paint_with_a_refractive_index(shared_file) -> None:
    data = motes.read(shared_file("cornell/garnet_red.brdf"))
    fit = motes.fit(data, f"{TS}(fresnel=dielectric)", loss="plain")
    best = Projected(data.wi, data.wo, data.values[0], "plain", dielectric=True).best(8, seed=1)
    assert fit.metrics["objective"] <= WORST * best.cost


@pytest.mark.parametrize("paint", ["cayman", "garnet_red", "krylon_blue"])
def test_paints_by_log(paint: str, shared_file) -> None:
    """Every fifth wavelength and second direction, so that the dense Jacobian of SciPy is small enough."""
    data = motes.read(shared_file(f"cornell/{paint}.brdf"))
    few = Measurement.from_arrays(data.wi[::2], data.wo[::2], data.values[0][::2, ::5])
    check(few, TS, "log", seed=4, starts=3)


def test_relative_rms_of_sample_10(shared_file) -> None:
    """RMS(f - r)/RMS(r) is 4.8 %; over the mean of r it is 5.0 %."""
    data = motes.read(shared_file("curet/abrdf.dat"), sample=10)
    fit = motes.fit(data, ON, loss="plain")
    measured = data.values[0][data.mask[0]]
    assert fit.metrics["relative_rms"] == pytest.approx(np.sqrt(np.nanmean(fit.residuals**2) / np.mean(measured**2)))
    assert round(fit.metrics["relative_rms"], 3) == 0.048
    assert round(fit.metrics["rms_plain"] / measured.mean(), 3) == 0.050


def test_the_oracle_knows_the_models() -> None:
    """Both hold the same formulas: else the comparisons above would compare different things."""
    wi, wo = scattered(500, 9, widest=1.5)
    for model, truth in TRUTH.items():
        oracle = Oracle(wi, wo, np.zeros((500, truth.channels)), model, "plain")
        x = np.concatenate([np.atleast_1d(slot.value) for slot in truth.slots()])
        np.testing.assert_allclose(oracle.residuals(x), truth.eval(wi, wo).ravel(), rtol=1e-8, atol=1e-12)
        assert MODELS[model][0] == tuple(slot.name for slot in truth.slots())
