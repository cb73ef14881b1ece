"""The form ``series``: sums over samples as Chebyshev series in the highlight's width, against sums made sample by sample in float64."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from motes.fitting.losses import LOSSES, ROBUST
from motes.fitting.printed.formulas import packed
from motes.fitting.printed.module import equations, equations_of_whole
from motes.fitting.printed.normal import NormalEquations
from motes.fitting.printed.series import FLOOR, TOLERANCE, Coordinate, coefficients, terms_needed
from motes.fitting.texel_forms import Forms
from motes.fitting.texel_kernel import Recorded
from motes.fitting.texels import TexelSolver, TexelStatus
from motes.graph import tracing
from motes.kernels import engine

Floats = NDArray[np.float64]
PAINT = "oren_nayar + torrance_sparrow"
PARAMETERS = ("K_d", "sigma_d", "K_s", "sigma_s")


def _directions(count: int, seed: int = 3) -> tuple[Floats, Floats]:
    """Pairs of directions, every other one near the mirror direction, none close to grazing."""
    rng = np.random.default_rng(seed)
    z, phi = rng.uniform(0.3, 0.98, 4 * count), rng.uniform(0, 2 * np.pi, 4 * count)
    w = np.stack([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z], axis=1)
    wi, wo = w[: 2 * count], w[2 * count :].copy()
    near = wi[::2] * [-1, -1, 1] + rng.normal(0, 0.25, (count, 3))
    wo[::2] = near / np.linalg.norm(near, axis=1, keepdims=True)
    good = wo[:, 2] > 0.2
    return wi[good][:count], wo[good][:count]


WI, WO = _directions(100)


def _rendered(x: Floats, model: str = PAINT) -> NDArray[np.float32]:
    """Texels (M, D, 3) of parameter vectors (M, 6)."""
    values = {"K_d": x[:, None, :3], "sigma_d": x[:, 3:4], "K_s": x[:, 4][:, None, None], "sigma_s": x[:, 5:6]}
    surface = (motes.OrenNayar() + motes.TorranceSparrow()).with_parameters(values)
    return np.asarray(surface.eval(WI, WO), np.float32)


def _truth(count: int, seed: int = 5, width: tuple[float, float] = (0.1, 0.4)) -> Floats:
    low, high = np.array([0.1, 0.1, 0.1, 0.1, 0.05, width[0]]), np.array([0.9, 0.9, 0.9, 0.8, 0.5, width[1]])
    return np.random.default_rng(seed).uniform(low, high, (count, 6))


def _noisy(values: NDArray[np.float32], seed: int = 6, noise: float = 0.02) -> NDArray[np.float32]:
    return (values * (1 + noise * np.random.default_rng(seed).standard_normal(values.shape))).astype(np.float32)


@pytest.fixture(scope="module")
def solver() -> TexelSolver:
    return TexelSolver(PAINT, WI, WO, 3)


@pytest.fixture(scope="module")
def forms(solver: TexelSolver) -> Forms:
    chosen = solver.kernel("cheapest")
    assert isinstance(chosen, Forms)
    return chosen


def _equations(model: str, **options: object) -> tuple[TexelSolver, Recorded, NormalEquations]:
    fit = TexelSolver(model, WI, WO, 3, **options)  # type: ignore[arg-type]
    recorded = Recorded.of(fit)
    found = recorded.equations_of_whole(fit, ROBUST["none"])
    assert found is not None
    return fit, recorded, found


@pytest.mark.parametrize(
    "model",
    [PAINT, "lambert + torrance_sparrow(normalization=facets)", "oren_nayar + torrance_sparrow(fresnel=schlick)"],
)
def test_the_normal_equations_are_the_sums_over_residuals(model: str) -> None:
    """For parameters between the nodes, against the model's residuals and derivatives at every sample."""
    _, recorded, series = _equations(model)
    assert series.tables is not None
    rng = np.random.default_rng(11)
    values = rng.uniform(0.05, 0.6, (len(WI), 3))
    sampled = dict(zip(recorded.sampled.leaves, (*recorded.sampled.directions, *recorded.sampled.numbers), strict=True))
    once = dict(zip(series.model.data.raw, values.T, strict=True)) | sampled
    kept = tracing.evaluate(np, series.model.data.stored, once)
    data = sampled | dict(zip(series.model.data.leaves, kept, strict=True)) | series.tables.columns
    opened = [np.sum(x * np.ones(len(WI))) for x in tracing.evaluate(np, series.opening, data)]
    shared = dict(zip(series.opened, opened, strict=True)) | series.tables.numbers
    for _ in range(5):
        x = {p: float(rng.uniform(0.1, 0.5)) for p in series.model.parameters}
        x[series.tables.parameter] = float(rng.uniform(series.tables.low, 0.6))
        sums = tracing.evaluate(np, series.tables.values, x | shared)
        wanted = (series.objective, *series.gradient, *series.matrix)
        found = tracing.evaluate(np, wanted, x | shared | dict(zip(series.summed, sums, strict=True)))
        plain = series.model.unclamped()
        residuals = np.stack(tracing.evaluate(np, plain.residuals(), x | data))
        zero = plain.graph.constant(0.0)
        rows = [row.get(p, zero) for row in plain.slopes for p in plain.parameters]
        slopes = np.stack([s * np.ones(len(WI)) for s in tracing.evaluate(np, rows, x | data)])
        slopes = slopes.reshape(3, len(x), len(WI))
        square = np.sum((values * WI[:, 2:3]) ** 2)
        terms = square + np.sum((residuals + values.T * WI[:, 2]) ** 2)  # what the objective is the difference of
        assert found[0] - 0.5 * FLOOR * square == pytest.approx(0.5 * np.sum(residuals**2), abs=2e-6 * terms)
        gradient = np.einsum("cd,cpd->p", residuals, slopes)
        matrix = np.einsum("cpd,cqd->pq", slopes, slopes)
        size = np.sqrt(np.diag(matrix))
        np.testing.assert_array_less(np.abs(found[1 : 1 + len(x)] - gradient), 5e-5 * size * np.sqrt(terms))
        for i in range(len(x)):
            for j in range(i + 1):
                assert found[1 + len(x) + packed(i, j)] == pytest.approx(matrix[i, j], abs=1e-3 * size[i] * size[j])


def test_the_gradient_is_that_of_the_objective(solver: TexelSolver) -> None:
    """To the last digit: else a fit would stop where the two disagree."""
    _, _, series = _equations(PAINT)
    assert series.tables is not None
    rng = np.random.default_rng(12)
    shared = {leaf: float(rng.normal()) for leaf in series.opened} | series.tables.numbers
    at = dict.fromkeys(series.model.parameters, 0.3)

    def objective(width: float) -> float:
        x = at | {series.tables.parameter: width} | shared  # type: ignore[union-attr]
        sums = dict(zip(series.summed, tracing.evaluate(np, series.tables.values, x), strict=True))  # type: ignore[union-attr]
        return float(tracing.evaluate(np, [series.objective], x | sums)[0])

    k = series.model.parameters.index(series.tables.parameter)
    sums = dict(zip(series.summed, tracing.evaluate(np, series.tables.values, at | shared), strict=True))
    slope = float(tracing.evaluate(np, [series.gradient[k]], at | shared | sums)[0])
    step = 1e-5
    assert slope == pytest.approx((objective(0.3 + step) - objective(0.3 - step)) / (2 * step), rel=1e-7)


def test_the_error_of_a_series_is_bounded() -> None:
    """By what is left out of it, at parameters between the nodes; the bound is what was asked for."""
    angles = np.arccos(np.clip(np.sum((WI + WO) * [0, 0, 1], axis=1) / np.linalg.norm(WI + WO, axis=1), -1, 1))
    coordinate = Coordinate(0.04, 1.5, 0.3)
    found = coefficients(np.exp(-((angles / coordinate.nodes()[0][:, None]) ** 2)))
    count, bound = terms_needed(found, TOLERANCE)
    assert bound <= TOLERANCE
    assert terms_needed(found, 1e-3)[0] < count
    widths = np.random.default_rng(13).uniform(0.04, 1.5, 300)
    first, last = coordinate.ends
    u = 2 * (widths / (widths + coordinate.shape) - first) / (last - first) - 1
    error = np.polynomial.chebyshev.chebval(u, found[:count]).T - np.exp(-((angles / widths[:, None]) ** 2))
    largest = np.abs(found).sum(axis=0).max()
    assert 0.01 * bound < np.abs(error).max() / largest < 1.01 * bound
    _, _, series = _equations(PAINT)
    assert series.tables is not None
    assert 0 < series.tables.error <= TOLERANCE


def test_it_serves_texels_that_miss_nothing_alone(forms: Forms, solver: TexelSolver) -> None:
    """What misses a sample is fitted by the other form, bit for bit, and does nothing to its neighbours."""
    values = _noisy(_rendered(_truth(40)))
    start = solver.coordinates(np.repeat([[0.5, 0.5, 0.5, 0.4, 0.2, 0.2]], 40, axis=0))
    whole = forms.fit(values, start)
    holes = values.copy()
    holes[3, 7] = np.nan
    holes[4, 8, 1] = np.inf
    holes[5] = np.nan
    mixed = forms.fit(holes, start)
    other = forms.other.fit(holes, start)
    missing = np.isin(np.arange(40), (3, 4, 5))
    for name in ("points", "errors", "codes", "states"):
        np.testing.assert_array_equal(getattr(mixed, name)[~missing], getattr(whole, name)[~missing])
        np.testing.assert_array_equal(getattr(mixed, name)[missing], getattr(other, name)[missing])
    assert solver.finished(mixed).status[5] == TexelStatus.NO_DATA
    np.testing.assert_array_equal(forms.quick.fit(holes, start).state("partial"), missing)


TIMES = np.linspace(0.0, 6.0, 5)
TRENDS = {"K_d": "exponential", "sigma_s": "quadratic"}


@pytest.fixture(scope="module")
def over_time() -> TexelSolver:
    return TexelSolver(PAINT, WI, WO, 3, hours=TIMES, trends=TRENDS)


def _series(solver: TexelSolver, coefficients: Floats) -> NDArray[np.float32]:
    """Texels (M, T, D, 3) of coefficients (M, P), by the trends themselves."""
    points, values = solver.coordinates(coefficients), np.empty((len(coefficients), len(TIMES), 6))
    for texel, row in zip(values, points, strict=True):
        first = 0
        for part in solver.parts:
            trend = part.trend(row[first : first + part.size])
            texel[:, part.quantity.where] = np.array([np.atleast_1d(trend(hour)) for hour in TIMES])
            first += part.size
    return np.stack([_rendered(values[:, t]) for t in range(len(TIMES))], axis=1)


def _coefficients(solver: TexelSolver, count: int, width: tuple[float, float] = (0.15, 0.4)) -> Floats:
    """Coefficients (M, P) within ordinary ranges; the time constant is 2 to 4 hours."""
    ranges = {"K_d": (0.1, 0.9), "sigma_d": (0.1, 0.8), "K_s": (0.1, 0.5), "sigma_s": width}
    each = [ranges[c.quantity] if c.value else (2.0, 4.0) for c in solver.columns]
    return np.random.default_rng(17).uniform(*np.array(each).T, (count, solver.size))


def test_trends_are_fitted_without_a_look_at_the_data(over_time: TexelSolver) -> None:
    """The same as by the form that sums over the samples at every point, to less than a hundredth of a standard error."""
    forms = over_time.kernel("cheapest")
    assert isinstance(forms, Forms)
    assert [over_time.columns[k].coefficient for k in forms.domain.columns] == ["c0", "c1", "c2"]
    truth = _coefficients(over_time, 100)
    values = _noisy(_series(over_time, truth))
    near = over_time.coordinates(truth * np.random.default_rng(18).uniform(0.8, 1.2, truth.shape))
    found, other = forms.fit(values, near), forms.other.fit(values, near)
    assert not forms.quick.fit(values, near).state("adrift").any()  # else the other form would fit them
    np.testing.assert_array_equal(found.codes, other.codes)
    assert np.nanmax(np.abs(found.values - other.values) / other.errors) < 2e-3
    np.testing.assert_allclose(found.errors, other.errors, rtol=0.02)
    near_truth = np.abs(found.values - truth) < 5 * found.errors
    assert near_truth.mean() > 0.999


def test_a_texel_that_misses_a_sample_at_one_time_is_fitted_by_the_other_form(over_time: TexelSolver) -> None:
    forms = over_time.kernel("cheapest")
    assert isinstance(forms, Forms)
    truth = _coefficients(over_time, 40)
    values, start = _noisy(_series(over_time, truth)), over_time.coordinates(truth)
    whole = forms.fit(values, start)
    holes = values.copy()
    holes[3, 4, 99] = np.nan
    holes[4, 1, 8, 1] = np.inf
    mixed, other = forms.fit(holes, start), forms.other.fit(holes, start)
    missing = np.isin(np.arange(40), (3, 4))
    for name in ("points", "errors", "codes", "states"):
        np.testing.assert_array_equal(getattr(mixed, name)[~missing], getattr(whole, name)[~missing])
        np.testing.assert_array_equal(getattr(mixed, name)[missing], getattr(other, name)[missing])
    np.testing.assert_array_equal(forms.quick.fit(holes, start).state("partial"), missing)


def test_a_trend_that_leaves_the_series_is_fitted_by_the_other_form(over_time: TexelSolver) -> None:
    """One coefficient at the end of where series hold is enough."""
    forms = over_time.kernel("cheapest")
    assert isinstance(forms, Forms)
    truth = _coefficients(over_time, 30)
    truth[:, forms.domain.columns[2]] = 0.5 * forms.domain.low
    values, near = _noisy(_series(over_time, truth), noise=1e-4), over_time.coordinates(truth)
    found, other = forms.fit(values, near), forms.other.fit(values, near)
    np.testing.assert_array_equal(found.points, other.points)
    assert (found.points[:, forms.domain.columns[2]] < forms.domain.low).mean() > 0.9
    assert forms.one_for(near) is forms.other
    held = np.zeros(over_time.size, bool)
    held[forms.domain.columns[0]] = True
    a, b = (form.fit(values, near, held=held, close=False) for form in (forms, forms.other))
    np.testing.assert_array_equal(a.points, b.points)


def test_a_form_is_compiled_when_a_texel_needs_it(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    compiled = engine.module
    monkeypatch.setattr(engine, "module", lambda source, *rest: asked.append(source) or compiled(source, *rest))
    solver = TexelSolver(PAINT, WI, WO, 3)
    forms = solver.kernel("cheapest")
    assert isinstance(forms, Forms)
    assert not asked
    start = solver.coordinates(np.repeat([[0.5, 0.5, 0.5, 0.4, 0.2, 0.2]], 8, axis=0))
    values = _noisy(_rendered(_truth(8)))
    forms.fit(values, start)
    assert asked == [forms.quick.source]
    values[2, 7] = np.nan
    forms.fit(values, start)
    assert asked == [forms.quick.source, forms.other.source]


def test_a_highlight_narrower_than_the_samples_is_fitted_by_the_other_form(forms: Forms, solver: TexelSolver) -> None:
    column = list(solver.facts.low[:, 0]).index(0.005)
    assert list(forms.domain.columns) == [column]
    assert forms.domain.low > 0.01
    assert forms.domain.narrowed_low
    assert not forms.domain.narrowed_high
    x = _truth(30, 7, (0.021, 0.024))
    values = _noisy(_rendered(x), noise=1e-4)
    near = solver.coordinates(x * np.random.default_rng(8).uniform(0.95, 1.05, x.shape))
    found, other = forms.fit(values, near), forms.other.fit(values, near)
    assert (found.points[:, column] < forms.domain.low).mean() > 0.9
    np.testing.assert_array_equal(found.points, other.points)
    np.testing.assert_array_equal(found.errors, other.errors)
    held = np.zeros(6, bool)
    held[column] = True
    a, b = (form.fit(values, near, held=held, close=False) for form in (forms, forms.other))
    np.testing.assert_array_equal(a.points, b.points)


def test_the_last_pass_catches_a_wrong_series(solver: TexelSolver) -> None:
    """With a basis that is off by 2 % all fits end where the residuals' own gradient says that the minimum is elsewhere."""
    wrong = TexelSolver(PAINT, WI, WO, 3).kernel("cheapest")
    assert isinstance(wrong, Forms)
    wrong.quick.basis = wrong.quick.basis * (1 + 0.02 * np.sin(np.arange(wrong.quick.basis.size)))
    values = _noisy(_rendered(_truth(200)), noise=0.005)
    start = solver.coordinates(np.repeat([[0.5, 0.5, 0.5, 0.4, 0.2, 0.2]], 200, axis=0))
    assert wrong.quick.fit(values, start).state("adrift").mean() > 0.95
    right = solver.kernel("cheapest").fit(values, start)
    found = wrong.fit(values, start)
    assert (np.abs(found.values - right.values) < 0.01 * right.errors).mean() > 0.999
    quick = solver.kernel("cheapest").quick.fit(values, start)  # type: ignore[union-attr]
    assert quick.state("adrift").sum() == 0


def test_starts_are_compared_by_one_kernel(forms: Forms, solver: TexelSolver) -> None:
    """The two round objectives differently, by more than the starts of a highlight that is hardly there differ."""
    (column,) = forms.domain.columns
    points = solver.coordinates(_truth(3))
    assert forms.one_for(points) is forms
    points[1, column] = 0.5 * forms.domain.low
    assert forms.one_for(points) is forms.other
    points[1, column] = forms.domain.low
    assert forms.one_for(points) is forms.other


def test_the_form_is_chosen_by_what_it_costs() -> None:
    def form(count: int, model: str = PAINT, **options: object) -> str:
        return TexelSolver(model, WI[:count], WO[:count], 3, **options).kernel("cheapest").form  # type: ignore[arg-type]

    assert form(100) == "series"
    assert form(12) == "moments"  # so few samples are summed sooner than series
    assert form(100, "oren_nayar") == "moments"  # no parameter meets directions in a function
    _, recorded, series = _equations(PAINT)
    other = equations(recorded.trace, recorded.fitted, LOSSES["linear"], ROBUST["none"])
    assert series.work(100) < 0.8 * other.work(100)
    bounds = dict.fromkeys(PARAMETERS, (0.01, 1.0))
    for loss, robust in (("log", "none"), ("linear", "huber")):
        given = (recorded.trace, recorded.fitted, LOSSES[loss], ROBUST[robust])
        data = (recorded.sampled, bounds, 100)
        assert equations_of_whole(*given, *data, lambda: other) is None
