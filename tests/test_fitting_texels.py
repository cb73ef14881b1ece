"""The batched solver: the same optimum as SciPy and as `motes.fit`, standard errors, and nothing that depends on neighbours."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import least_squares

import motes
from motes.fitting import texel_kernel
from motes.fitting.texels import NO_VERDICT, TexelSolver, TexelStatus
from motes.fitting.texels_slow import fit_slowly

DUSTY = motes.DustLayer(motes.OrenNayar() + motes.TorranceSparrow(), motes.Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2)
HELD = ("w", "g", "tau")
LOW, HIGH = (
    np.array([0.1, 0.1, 0.1, 0.1, 0.05, 0.1]),
    np.array([0.9, 0.9, 0.9, 0.8, 0.5, 0.4]),
)  # K_d, sigma_d, K_s, sigma_s


def directions(count: int = 100, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of directions, every other one near the mirror direction, none close to grazing."""
    rng = np.random.default_rng(seed)
    pairs: list[tuple[np.ndarray, np.ndarray]] = []
    while len(pairs) < count:
        wi, wo = (_direction(rng) for _ in range(2))
        if len(pairs) % 2:
            wo = np.array([-wi[0], -wi[1], wi[2]]) + rng.normal(0, 0.25, 3)
            wo /= np.linalg.norm(wo)
        if wo[2] > 0.2:
            pairs.append((wi, wo))
    both = np.array(pairs)
    return both[:, 0], both[:, 1]


def _direction(rng: np.random.Generator) -> np.ndarray:
    z, phi = rng.uniform(0.25, 0.98), rng.uniform(0, 2 * np.pi)
    s = np.sqrt(1 - z * z)
    return np.array([s * np.cos(phi), s * np.sin(phi), z])


WI, WO = directions()


def rendered(model: motes.BRDF, x: np.ndarray, wi: np.ndarray = WI, wo: np.ndarray = WO) -> np.ndarray:
    """The dusty surface for parameter vectors (M, 6): (M, D, 3)."""
    values = {"K_d": x[:, None, :3], "sigma_d": x[:, 3:4], "K_s": x[:, 4][:, None, None], "sigma_s": x[:, 5:6]}
    return model.with_parameters(values).eval(wi, wo)


def truth(count: int, seed: int = 5) -> np.ndarray:
    return np.random.default_rng(seed).uniform(LOW, HIGH, (count, 6))


def near(x: np.ndarray, seed: int = 6) -> np.ndarray:
    return x * np.random.default_rng(seed).uniform(0.7, 1.3, x.shape)


@pytest.fixture(scope="module")
def solver() -> TexelSolver:
    return TexelSolver(DUSTY, WI, WO, 3, fixed=HELD)


@pytest.fixture(scope="module")
def clean() -> tuple[np.ndarray, np.ndarray]:
    x = truth(20_000)
    return x, rendered(DUSTY, x).astype(np.float32)


def test_the_columns_are_named(solver: TexelSolver) -> None:
    names = [(c.quantity, c.channel, c.coefficient) for c in solver.columns]
    assert names[:4] == [("K_d", 0, None), ("K_d", 1, None), ("K_d", 2, None), ("sigma_d", None, None)]
    assert [n[0] for n in names[4:]] == ["K_s", "sigma_s"]


FORMS = {"cheapest": "series", "moments": "moments", "direct": "direct"}


@pytest.mark.parametrize("form", FORMS)
def test_every_texel_without_noise_ends_at_the_truth(solver: TexelSolver, clean, form: str) -> None:
    x, values = clean
    compiled = solver.kernel(form)
    assert compiled.form == FORMS[form]
    result = solver.finished(compiled.fit(values, solver.coordinates(near(x))))
    off = np.abs(result.x / x - 1).max(axis=1)
    assert off.max() < 0.01
    assert np.quantile(off, 0.99) < 1e-3
    assert (result.status == TexelStatus.CONVERGED).all()
    assert result.iterations.mean() < 6
    assert result.relative_rms.max() < 1e-4


def test_the_optimum_is_scipys() -> None:
    count = 120  # benchmarks/fits.py does it for more
    x = truth(count, 11)
    rng = np.random.default_rng(12)
    values = rendered(DUSTY, x)
    values = (values * (1 + 0.02 * rng.standard_normal(values.shape))).astype(np.float32)
    solver = TexelSolver(DUSTY, WI, WO, 3, fixed=HELD, loss="linear")
    result = solver.fit(values, near(x), own_starts=True)
    low, high = (b.copy() for b in solver.bounds)
    excess = []
    for k in range(count):

        def residuals(p: np.ndarray, k: int = k) -> np.ndarray:
            return ((rendered(DUSTY, p[None])[0] - values[k]) * WI[:, 2:3]).ravel()

        best = least_squares(residuals, np.clip(x[k], low, high), bounds=(low, high), x_scale=0.3)
        ours = float(np.sum(residuals(result.x[k].astype(float)) ** 2))
        excess.append(ours / (2 * best.cost) - 1)
        own = ((values[k] * WI[:, 2:3]) ** 2).sum()
        assert result.relative_rms[k] == pytest.approx(np.sqrt(ours / own), rel=1e-3)
    assert max(excess) < 1e-3


@pytest.mark.parametrize("form", ["cheapest", "moments"])
def test_the_moments_and_the_sums_themselves_agree(solver: TexelSolver, form: str) -> None:
    x = truth(300, 21)
    noise = 1 + 0.05 * np.random.default_rng(22).standard_normal((300, len(WI), 3))
    values = (rendered(DUSTY, x) * noise).astype(np.float32)
    a, b = (solver.finished(solver.kernel(form).fit(values, solver.coordinates(near(x)))) for form in (form, "direct"))
    np.testing.assert_allclose(a.x, b.x, rtol=2e-3, atol=2e-4)
    np.testing.assert_allclose(a.stderr, b.stderr, rtol=0.02, atol=1e-5)
    np.testing.assert_allclose(a.relative_rms, b.relative_rms, rtol=1e-4)


def test_standard_errors_cover_the_truth(solver: TexelSolver) -> None:
    x = np.repeat(np.array([[0.5, 0.4, 0.3, 0.4, 0.25, 0.25]]), 3000, axis=0)
    noise = 1 + 0.02 * np.random.default_rng(31).standard_normal((len(x), len(WI), 3))
    result = solver.fit((rendered(DUSTY, x) * noise).astype(np.float32), x[:1])
    covered = np.mean(np.abs(result.x - x) < result.stderr, axis=0)
    assert (covered > 0.6).all()
    assert (covered < 0.76).all()


@pytest.mark.parametrize("trends", [None, {"K_d": "exponential", "sigma_s": "linear"}])
def test_errors_and_optimum_are_those_of_the_slow_path(trends: dict[str, str] | None) -> None:
    base = motes.OrenNayar(sigma_d=0.35) + motes.TorranceSparrow()
    hours = np.array([0.0, 1.0, 2.5, 4.0, 7.0])
    solver = TexelSolver(base, WI, WO, 3, fixed=("sigma_d",), hours=hours if trends else None, trends=trends)
    rng = np.random.default_rng(41)
    size = solver.size
    low, high = solver.bounds
    start = np.array([0.5 if h > 10 else 0.5 * (g + h) for g, h in zip(low, high, strict=True)])
    for k, column in enumerate(solver.columns):
        start[k] = (
            {"K_d": 0.5, "K_s": 0.3, "sigma_s": 0.2}[column.quantity] if column.coefficient != "time_constant" else 2.0
        )
    count = 6
    true = start * rng.uniform(0.7, 1.3, (count, size))
    values = np.stack([_series(solver, base, x) for x in true])
    values = (values * (1 + 0.02 * rng.standard_normal(values.shape))).astype(np.float32)
    fast = solver.fit(values, start[None])
    slow = solver.finished(fit_slowly(solver, values, solver.coordinates(start[None]), False))
    np.testing.assert_allclose(fast.relative_rms, slow.relative_rms, rtol=2e-4)
    assert (np.abs(fast.x - slow.x) < 1e-3 * slow.stderr + 1e-6).all()
    np.testing.assert_allclose(fast.stderr, slow.stderr, rtol=2e-3)
    np.testing.assert_array_equal(fast.verdicts, slow.verdicts)


def _series(solver: TexelSolver, base: motes.BRDF, x: np.ndarray) -> np.ndarray:
    """What a vector of parameters, or of coefficients, looks like: (D, C), or (T, D, C)."""
    if not solver.parts:
        values = {"K_d": x[:3], "K_s": x[3], "sigma_s": x[4]}
        return base.with_parameters(values).eval(WI, WO)
    frames, start = [], 0
    pieces = {}
    for part in solver.parts:
        pieces[part.quantity.name] = part.trend(x[start : start + part.size])
        start += part.size
    for hour in solver.hours:
        frames.append(base.with_parameters({name: trend(hour) for name, trend in pieces.items()}).eval(WI, WO))
    return np.stack(frames)


def test_a_texel_does_not_depend_on_its_neighbours_or_on_threads(solver: TexelSolver, monkeypatch) -> None:
    x = truth(5000, 51)
    noise = 1 + 0.2 * np.random.default_rng(52).standard_normal((len(x), len(WI), 3))
    values = (rendered(DUSTY, x) * noise).astype(np.float32)
    starts = np.array([[0.5, 0.5, 0.5, 0.4, 0.2, 0.15], [0.3, 0.3, 0.3, 0.2, 0.4, 0.4]])
    whole = solver.fit(values, starts)
    order = np.random.default_rng(53).permutation(len(x))[:777]
    monkeypatch.setattr(texel_kernel, "TASK", 32)
    part = solver.fit(values[order], starts)
    for a, b in zip(whole[:-1], part[:-1], strict=True):
        np.testing.assert_array_equal(a[order], b)


def test_missing_samples_count_for_nothing(solver: TexelSolver) -> None:
    x = truth(64, 61)
    values = rendered(DUSTY, x).astype(np.float32)
    values[0] = np.nan
    values[1] = 0
    values[2, 10:] = np.nan
    values[3, ::2] = np.inf
    values[4, 2:] = np.nan  # six values for six parameters
    result = solver.fit(values, near(x), own_starts=True)
    assert result.status[[0, 1, 4]].tolist() == [TexelStatus.NO_DATA] * 3
    assert np.isnan(result.x[[0, 1, 4]]).all()
    ok = np.ones(64, bool)
    ok[[0, 1, 2, 4]] = False
    np.testing.assert_allclose(result.x[ok], x[ok], rtol=0.01)
    assert (result.verdicts[[0, 1, 4]] == NO_VERDICT).all()


def test_a_channel_may_be_missing_by_itself(solver: TexelSolver) -> None:
    """As if its sample had no weight: the other channels of the sample count."""
    rng = np.random.default_rng(62)
    x = truth(3, 63)
    values = (rendered(DUSTY, x) * (1 + 0.02 * rng.standard_normal((3, len(WI), 3)))).astype(np.float32)
    values[:, ::2, 1] = np.inf
    values[1:, 1::3, 2] = np.nan
    fast = solver.fit(values, near(x), own_starts=True)
    slow = solver.finished(fit_slowly(solver, values, solver.coordinates(near(x)), True))
    assert (np.abs(fast.x - slow.x) < 1e-3 * slow.stderr).all()
    np.testing.assert_allclose(fast.stderr, slow.stderr, rtol=2e-3)
    np.testing.assert_allclose(fast.relative_rms, slow.relative_rms, rtol=1e-4)


def test_a_clamped_model_is_fitted_as_it_is() -> None:
    """Equation (1) is negative near grazing forward scatter; the moments do not know that the model is 0 there."""
    rng = np.random.default_rng(71)
    theta, phi = np.arccos(rng.uniform(0.03, 0.4, 80)), rng.uniform(0, 2 * np.pi, 80)
    wi = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=1)
    wo = np.stack([-wi[:, 0], -wi[:, 1], wi[:, 2]], axis=1)
    surface = motes.OrenNayar(K_d=0.3, sigma_d=1.2)
    values = surface.eval(wi, wo)
    assert (values == 0).mean() > 0.2
    solver = TexelSolver("oren_nayar", wi, wo, 1)
    assert solver.kernel("cheapest").form == "moments"
    result = solver.fit(values[None].astype(np.float32), [[0.5, 0.9]])
    np.testing.assert_allclose(result.x[0], [0.3, 1.2], rtol=1e-3)


def test_bounds_hold_and_have_no_errors() -> None:
    solver = TexelSolver("oren_nayar + torrance_sparrow", WI, WO, 1)
    dent = motes.TorranceSparrow(K_s=0.05, sigma_s=0.2).eval(WI, WO)  # less light than the diffuse part: no highlight
    values = (motes.OrenNayar(K_d=0.4, sigma_d=0.4).eval(WI, WO) - dent).astype(np.float32)
    result = solver.fit(values[None], [[0.5, 0.3, 0.3, 0.2]])
    low, high = solver.bounds
    assert (result.x >= low - 1e-6).all()
    assert (result.x <= high + 1e-6).all()
    at_bound = np.abs(result.x[0] - low) < 1e-6
    assert at_bound[2]  # K_s
    assert np.isnan(result.stderr[0][at_bound]).all()


def test_starts_are_found_and_serve_all_texels() -> None:
    solver = TexelSolver("oren_nayar + torrance_sparrow", WI, WO, 3)
    model = motes.OrenNayar() + motes.TorranceSparrow()
    x = truth(2000, 81)
    x[:1000, 5] = 0.06  # two materials: a sharp highlight and a broad one
    values = rendered(model, x).astype(np.float32)
    starts = solver.starts(values[::100])
    assert starts.shape[1] == solver.size
    assert 1 <= len(starts) <= 6
    result = solver.fit(values, starts)
    assert np.mean(result.relative_rms < 1e-3) > 0.999


def test_joint_fits_find_their_starts() -> None:
    hours = np.linspace(0, 8, 7)
    solver = TexelSolver("oren_nayar(sigma_d=0.3)", WI, WO, 1, hours=hours, trends={"K_d": "logistic"})
    rng = np.random.default_rng(91)
    true = np.stack(
        [rng.uniform(0.2, 0.4, 40), rng.uniform(0.6, 0.8, 40), rng.uniform(2, 6, 40), rng.uniform(0.3, 1, 40)], axis=1
    )
    base = motes.OrenNayar(sigma_d=0.3)
    values = np.stack([_series(solver, base, x) for x in true]).astype(np.float32)
    result = solver.fit(values, solver.starts(values[:8]))
    np.testing.assert_allclose(result.x, true, rtol=0.02)


@pytest.mark.parametrize(
    ("loss", "robust"), [("log", "none"), ("cube_root", "none"), ("linear", "cauchy"), ("plain", "huber")]
)
def test_every_loss_and_robust_function_is_compiled(loss: str, robust: str) -> None:
    """Against `motes.fit` on the same data, a tenth of which is far off."""
    rng = np.random.default_rng(96)
    surface = motes.OrenNayar(K_d=0.6, sigma_d=0.5)
    values = (surface.eval(WI, WO) * (1 + 0.02 * rng.standard_normal((2, 100, 1)))).astype(np.float32)
    values[:, ::10] *= 1.5
    solver = TexelSolver("oren_nayar", WI, WO, 1, loss=loss, robust=robust)
    fast = solver.fit(values, [[0.3, 0.3]])
    for k, texel in enumerate(values):
        single = motes.fit(
            motes.Measurement.from_arrays(WI, WO, texel.astype(float)), "oren_nayar", loss=loss, robust=robust
        )
        for c, name in enumerate(("K_d", "sigma_d")):
            p = single.parameters[name]
            stderr = np.ravel(p.stderr)[0]
            assert abs(fast.x[k, c] - np.ravel(p.value)[0]) < 1e-3 * stderr
            assert fast.stderr[k, c] == pytest.approx(stderr, rel=2e-3)


def test_covariances_have_the_errors_on_their_diagonal(solver: TexelSolver) -> None:
    x = truth(40, 97)
    noise = 1 + 0.02 * np.random.default_rng(98).standard_normal((40, len(WI), 3))
    values = (rendered(DUSTY, x) * noise).astype(np.float32)
    fit = solver.fit(values, near(x), own_starts=True, covariance=True)
    assert fit.covariance is not None
    assert fit.covariance.shape == (40, 21)
    rows, columns = np.tril_indices(6)
    np.testing.assert_allclose(np.sqrt(fit.covariance[:, rows == columns]), fit.stderr, rtol=1e-5)
    single = motes.fit(motes.Measurement.from_arrays(WI, WO, values[0].astype(float)), DUSTY, fixed=HELD)
    np.testing.assert_allclose(fit.covariance[0], single.covariance[rows, columns], rtol=0.01, atol=1e-9)


def test_weights_count() -> None:
    rng = np.random.default_rng(95)
    values = (motes.OrenNayar(K_d=0.5, sigma_d=0.4).eval(WI, WO) * rng.uniform(0.5, 1.5, (100, 1))).astype(np.float32)
    kept = rng.uniform(size=100) < 0.5
    weighted = TexelSolver("oren_nayar", WI, WO, 1, weights=np.where(kept, 1.0, 0.0)).fit(values[None], [[0.5, 0.3]])
    alone = TexelSolver("oren_nayar", WI[kept], WO[kept], 1).fit(values[None, kept], [[0.5, 0.3]])
    np.testing.assert_allclose(weighted.x, alone.x, rtol=1e-4)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"wi": WI[:, :2]}, "shape"),
        ({"wi": 2 * WI}, "length 2"),
        ({"wi": -WI}, "horizon"),
        ({"wo": WO[:5]}, "come in pairs"),
        ({"weights": np.zeros(100)}, "weights"),
        ({"fixed": ("K_x",)}, "K_x"),
        ({"trends": {"K_d": "linear"}}, "hours"),
        ({"hours": [0, 1, 1]}, "forward"),
        ({"hours": [0, 1, 2], "trends": {"K_d": "wobbly"}}, "wobbly"),
        ({"hours": [0, 1, 2], "trends": {"K_q": "linear"}}, "K_q"),
        ({"loss": "huge"}, "huge"),
        ({"fixed": ("K_d", "sigma_d")}, "nothing to fit"),
    ],
)
def test_what_does_not_fit_is_refused(change: dict, message: str) -> None:
    arguments = {"model": "oren_nayar", "wi": WI, "wo": WO, "channels": 1} | change
    with pytest.raises(motes.MotesError) as error:
        TexelSolver(**arguments)
    assert message in str(error.value) + (error.value.hint or "")


def test_wrong_data_and_starts_are_refused(solver: TexelSolver) -> None:
    with pytest.raises(motes.MotesError, match="do not fit"):
        solver.fit(np.zeros((2, 99, 3), np.float32), [[0.5] * 6])
    with pytest.raises(motes.MotesError, match="do not fit"):
        solver.fit(np.zeros((2, 100, 3), np.float32), [[0.5] * 5])
    with pytest.raises(motes.MotesError, match="not finite"):
        solver.fit(np.zeros((2, 100, 3), np.float32), [[np.nan] * 6])
    with pytest.raises(motes.MotesError, match="none of 4 texels"):
        solver.starts(np.full((4, 100, 3), np.nan, np.float32))
