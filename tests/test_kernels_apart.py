"""Parameters that are uniform over rows of directions: what depends on them alone is computed once for a row, and says the same."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("llvmlite")

from motes import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.graph import tracing
from motes.kernels import engine, jobs, loops

TEXELS, SEEN = 7, 40
RNG = np.random.default_rng(5)
SIGMA, K_S = RNG.uniform(0.1, 0.6, (TEXELS, 1)), RNG.uniform(0.1, 0.9, (TEXELS, 1))
COLORS = RNG.uniform(0.1, 0.9, (TEXELS, 1, 3))


@pytest.fixture
def apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """Models that are compiled in a second have their numbers computed apart, too."""
    monkeypatch.setattr(loops, "LEAST_APART", 1)
    monkeypatch.setattr(engine, "_worth", {})


def directions(*shape: int, seed: int = 1) -> NDArray[np.float64]:
    w = np.random.default_rng(seed).normal(size=(*shape, 3))
    w[..., 2] = np.abs(w[..., 2]) - 0.1  # some below the horizon
    return w / np.linalg.norm(w, axis=-1, keepdims=True)


def surface(sigma_d: Any = SIGMA, K_s: Any = K_S, K_d: Any = COLORS) -> BRDF:
    return OrenNayar(K_d, sigma_d) + TorranceSparrow(K_s[..., None] if np.ndim(K_s) else K_s, 0.3)


def asked(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The rows of each call that is computed apart."""
    found: list[int] = []
    plain = engine._evaluate_apart

    def noted(job: jobs.Job, target: NDArray[Any]) -> None:
        found.append(job.count // job.shape[-1])
        plain(job, target)

    monkeypatch.setattr(engine, "_evaluate_apart", noted)
    return found


@pytest.mark.usefixtures("apart")
@pytest.mark.parametrize("scalar", [np.float64, np.float32])
@pytest.mark.parametrize(
    "shapes",
    [
        ((SEEN,), (SEEN,)),
        ((TEXELS, SEEN), (SEEN,)),
        ((TEXELS, 1), (TEXELS, SEEN)),
        ((1, SEEN), (TEXELS, 1)),
        ((2, TEXELS, SEEN), (TEXELS, SEEN)),
    ],
)
def test_values_are_those_of_the_equations(
    shapes: tuple[tuple[int, ...], tuple[int, ...]], scalar: type, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of every layout of directions, and written to memory that is given."""
    calls, model = asked(monkeypatch), surface()
    wi, wo = (directions(*shape, seed=k).astype(scalar) for k, shape in enumerate(shapes))
    expected = model.eval(wi.astype(np.float64), wo.astype(np.float64))
    assert expected.max() > 0.1
    found = engine.evaluate(model, wi, wo)
    assert found.shape == expected.shape
    assert found.dtype == scalar
    tolerance = 1e-13 if scalar is np.float64 else 2e-5
    assert np.abs(found - expected).max() < tolerance * expected.max()
    for out in (np.empty(expected.shape, scalar), np.empty(expected.shape[::-1], scalar).T):
        assert engine.evaluate(model, wi, wo, out=out) is out
        assert np.array_equal(out, found)
    assert calls == [expected[..., 0].size // SEEN] * 3


@pytest.mark.usefixtures("apart")
def test_bits_are_those_of_each_texel_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever stands beside it, and in whatever task it is."""
    model, wi, wo = surface(), directions(SEEN), directions(SEEN, seed=2)
    together = engine.evaluate(model, wi, wo)
    for k in range(TEXELS):
        alone = engine.evaluate(surface(SIGMA[k : k + 1], K_S[k : k + 1], COLORS[k : k + 1]), wi, wo)
        assert np.array_equal(alone[0], together[k])
    monkeypatch.setattr(engine, "CHUNK", 2 * SEEN)  # two rows to a task
    assert np.array_equal(engine.evaluate(model, wi, wo), together)


@pytest.mark.usefixtures("apart")
def test_other_layouts_are_computed_as_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """Short rows, parameters that vary along them, and none that varies."""
    calls = asked(monkeypatch)
    for model, shape in (
        (surface(), (jobs.SHORTEST_ROW - 1,)),
        (surface(SIGMA[:, 0], 0.3, 0.5), (TEXELS,)),
        (surface(np.linspace(0.1, 0.5, SEEN), K_S, COLORS), (SEEN,)),
        (surface(0.3, 0.2, (0.5, 0.4, 0.3)), (SEEN,)),
    ):
        wi, wo = directions(*shape), directions(*shape, seed=2)
        assert np.abs(engine.evaluate(model, wi, wo) - model.eval(wi, wo)).max() < 1e-12
    assert calls == []


def test_it_is_for_models_with_much_to_compute_beforehand() -> None:
    tau = np.array([[0.1], [0.2]])
    for scattering, worth in (("single", False), ("multiple", True)):
        trace = tracing.trace(DustLayer(Lambert(0.5), Dust(0.9), tau, scattering))
        assert loops.worth_apart(trace, ("tau",)) is worth
        assert not loops.worth_apart(trace, ("base.K_d",))
