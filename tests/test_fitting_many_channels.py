"""Hundreds of channels: the arrow algebra against dense matrices, and parts that stand for all channels."""

from __future__ import annotations

import numpy as np
import pytest

import motes
from motes import OrenNayar
from motes.directions import from_spherical
from motes.fitting import channels_among_many, problem, static
from motes.fitting.algebra import ARRAYS
from motes.fitting.arrowhead import Arrowhead
from motes.measurements import Measurement
from motes.models import DustLayer, TorranceSparrow

CHANNELS = 180


def measured(noise: float = 0.01, dust: bool = False) -> Measurement:
    """A smooth spectrum at 60 directions, some samples masked."""
    rng = np.random.default_rng(5)
    theta = np.radians(rng.uniform(0, 70, (2, 60)))
    wi, wo = from_spherical(theta[0], 0 * theta[0]), from_spherical(theta[1], rng.uniform(0, 6.28, 60))
    shape = 0.4 + 0.3 * np.sin(np.arange(CHANNELS) / 30)
    base = OrenNayar(K_d=shape, sigma_d=0.4) + TorranceSparrow(K_s=0.2, sigma_s=0.2)
    f = np.asarray((DustLayer(base, motes.Dust(w=0.8, g=0.2), 0.4) if dust else base).eval(wi, wo))
    values = f * (1 + noise * rng.standard_normal(f.shape))
    return Measurement.from_arrays(wi, wo, values, mask=rng.uniform(size=f.shape) > 0.05)


def arrow(rng: np.random.Generator, lanes: int) -> tuple[Arrowhead, np.ndarray]:
    """Positive matrices of a random Jacobian, with two parameters of each of 20 channels and three shared ones."""
    own, shared = np.stack([np.arange(20), 23 + np.arange(20)], axis=1), np.array([20, 21, 22])
    matrix = np.zeros((43, 43, lanes))
    for channel in own:
        index = np.concatenate([channel, shared])
        jacobian = rng.standard_normal((lanes, 30, 5))
        matrix[np.ix_(index, index)] += np.einsum("bnk,bnl->klb", jacobian, jacobian)
    scale = 1 / np.sqrt(np.einsum("ppb->pb", matrix))
    return Arrowhead(own, shared), matrix * scale[:, None] * scale[None]


def test_the_arrow_algebra_is_that_of_dense_matrices() -> None:
    rng = np.random.default_rng(3)
    algebra, matrix = arrow(rng, 4)
    right = rng.standard_normal((43, 4))
    np.testing.assert_allclose(algebra.solve(matrix, right), ARRAYS.solve(matrix, right), rtol=1e-9, atol=1e-11)
    np.testing.assert_allclose(algebra.inverse(matrix), ARRAYS.inverse(matrix), rtol=1e-9, atol=1e-11)


def test_what_the_data_see_only_in_sums_has_a_large_inverse() -> None:
    """Two shared parameters that act alike, and two of one channel."""
    algebra, matrix = arrow(np.random.default_rng(4), 1)
    for one, other in ((21, 22), (5, 28)):
        same = matrix.copy()
        same[other], same[:, other] = same[one], same[:, one]
        same[other, other] = same[one, one]
        same[one, other] = same[other, one] = same[one, one]
        for inverse in (algebra.inverse(same), ARRAYS.inverse(same)):
            large = np.diag(inverse[..., 0]) > 1e6
            assert set(np.flatnonzero(large)) == {one, other}
    singular = np.zeros((43, 43, 1))
    np.testing.assert_array_equal(algebra.solve(singular, np.ones((43, 1))), ARRAYS.solve(singular, np.ones((43, 1))))


@pytest.mark.parametrize("robust", ["none", "huber"])
def test_a_fit_of_many_channels_is_that_of_dense_matrices(robust: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """With starts from 64 channels and arrows, or from all channels and dense matrices: one optimum, the same errors."""
    data = measured()
    text = "oren_nayar + torrance_sparrow"
    found = motes.fit(data, text, robust=robust)
    for module in (problem, channels_among_many):
        monkeypatch.setattr(module, "CHANNELS", 10_000)
    dense = motes.fit(data, text, robust=robust)
    assert found.status.ok
    assert found.metrics["objective"] <= dense.metrics["objective"] * (1 + 1e-6)
    for name, p in dense.parameters.items():
        error = np.asarray(p.stderr)
        np.testing.assert_allclose(found.parameters[name].value, p.value, atol=1e-3 * error.max(), err_msg=name)
        np.testing.assert_allclose(found.parameters[name].stderr, error, rtol=1e-3, err_msg=name)
        assert found.parameters[name].verdicts == p.verdicts


def test_candidates_are_compared_on_some_channels_and_the_chosen_one_fitted_to_all() -> None:
    data = measured(dust=True)
    fit = motes.fit(data)
    chosen = next(trial for trial in fit.tried if trial.chosen)
    assert "dust" in chosen.model
    assert chosen.n_samples < data.mask.sum() / 2
    assert fit.metrics["n_samples"] == data.mask.sum()
    assert np.shape(fit.parameters["K_d"].value) == (CHANNELS,)
    assert abs(float(fit.parameters["sigma_d"].value) - 0.4) < 4 * float(np.asarray(fit.parameters["sigma_d"].stderr))


def test_a_rise_among_some_channels_is_that_among_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """What the second look asks: by how much the sum of squares rises where a parameter is held elsewhere."""
    data = measured(0.05, dust=True)
    attempt = static._Attempt(
        data, "dust_layer(oren_nayar)", static.Wishes("linear", "none", "measurement", (), ()), False
    )
    objective, x = attempt.problem, attempt.x
    where = {q.name: q.where.start for q in objective.quantities}
    columns = [where["K_d"] + 40, where["K_d"] + 90, where["w"] + 3, where["tau"], where["sigma_d"]]
    points, held = np.repeat(x[None], len(columns), axis=0), np.zeros((len(columns), len(x)), bool)
    for k, column in enumerate(columns):
        points[k, column] *= 1.3
        held[k, column] = True
    base = float(objective.normal(x[None]).objective[0])
    some = objective.refitted(x, points, held, max_iterations=400, reduction=1e-12) - base
    every = objective.solve(points, held=held, max_iterations=400, reduction=1e-12).normal.objective - base
    assert some[:4] / every[:4] == pytest.approx(1, abs=0.45)
    assert abs(some[4]) < 1e-9  # sigma_d is 0 here: 1.3 times that is no other place


def test_channels_without_samples_stand_for_none() -> None:
    data = measured()
    dark = data.with_mask(np.arange(CHANNELS) % 7 > 0, "no light")
    chosen = channels_among_many.even_channels(dark.mask)
    assert chosen is not None
    assert (chosen % 7 > 0).all()
    assert len(chosen) == channels_among_many.CHANNELS
    assert channels_among_many.even_channels(dark.mask[..., :100]) is None
    fit = motes.fit(dark, "lambert")
    K_d = np.asarray(fit.parameters["K_d"].value)
    for channel in (1, 100, 179):  # each by itself
        one = Measurement.from_arrays(data.wi, data.wo, data.values[0][:, [channel]], mask=dark.mask[0][:, [channel]])
        np.testing.assert_allclose(motes.fit(one, "lambert").parameters["K_d"].value, K_d[channel], rtol=1e-6)
