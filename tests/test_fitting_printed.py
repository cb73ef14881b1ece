"""The pieces of the batched solver, each against plain NumPy: separated formulas, normal equations, and the algebra of the steps."""

from __future__ import annotations

import numpy as np
import pytest

from motes.arrays import NUMPY
from motes.fitting import covariance, levenberg
from motes.fitting.algebra import ARRAYS
from motes.fitting.columns import Columns
from motes.fitting.covariance import LEAST_REMAINDER
from motes.fitting.losses import LOSSES, ROBUST
from motes.fitting.printed import module, normal
from motes.fitting.printed.formulas import Formulas, packed, triangle_of
from motes.fitting.printed.moments import moments
from motes.fitting.printed.traced import Traced
from motes.graph import separation, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS
from motes.models import parse

COUNT = 40


def _trace(text: str, channels: int) -> tuple[tracing.Trace, list[str]]:
    brdf = parse(text).model
    per_channel = {
        s.name: np.full(channels, s.parameter.default)
        for s in brdf.slots()
        if s.parameter.per_channel and not s.parameter.shared_in_fit
    }
    return tracing.trace(brdf.with_parameters(per_channel), channels, horizon=False), [s.name for s in brdf.slots()]


def _traced(
    text: str,
    channels: int,
    fitted: list[str] | None = None,
    loss: str = "linear",
    robust: str = "none",
    by_channel: bool = False,
) -> Traced:
    trace, names = _trace(text, channels)
    return Traced.of(trace, fitted or names, LOSSES[loss], ROBUST[robust], by_channel)


def _values(model: Traced, rng: np.random.Generator) -> dict[tracing.Symbol, np.ndarray]:
    """Numbers for the leaves: unit vectors, parameters, and data of which some are missing."""
    values = {}
    for w in ("wi", "wo"):
        v = rng.normal(size=(3, COUNT))
        v[2] = np.abs(v[2]) + 0.3
        v /= np.linalg.norm(v, axis=0)
        values |= {f"{w}.{axis}": x for axis, x in zip("xyz", v, strict=True)}
    values |= {"cosine": values["wi.z"], "root": rng.uniform(0.5, 1.5, COUNT), "noise": np.float64(0.3)}
    values["bending"] = np.float64(0.3)
    numbers = {
        leaf: values[leaf.value] if leaf.value in values else np.float64(rng.uniform(0.2, 0.8))
        for leaf, bit in model.leaves.items()
        if leaf not in model.data.leaves
    }
    for k, leaf in enumerate(model.data.raw):
        numbers[leaf] = rng.uniform(0.2, 0.8, COUNT)
        numbers[leaf][3 + 4 * k] = np.nan
    stored = tracing.evaluate(NUMPY, list(model.data.stored), numbers)
    return numbers | dict(zip(model.data.leaves, (np.broadcast_to(x, COUNT) for x in stored), strict=True))


@pytest.mark.parametrize(
    ("text", "channels", "fitted", "loss", "robust"),
    [
        ("oren_nayar", 3, None, "linear", "none"),
        ("oren_nayar + torrance_sparrow", 3, None, "linear", "none"),
        ("dust_layer(oren_nayar + torrance_sparrow)", 3, ["K_d", "sigma_d", "K_s", "sigma_s"], "linear", "none"),
        ("dust_layer(oren_nayar + torrance_sparrow)", 3, None, "plain", "none"),
        ("torrance_sparrow(normalization='facets', fresnel=schlick)", 1, None, "linear", "huber"),
        ("oren_nayar + torrance_sparrow", 2, None, "log", "none"),
        ("oren_nayar + torrance_sparrow", 2, None, "cube_root", "cauchy"),
        ("lambert", 2, None, "linear", "soft_l1"),
    ],
)
def test_the_forms_are_the_normal_equations(
    text: str, channels: int, fitted: list[str] | None, loss: str, robust: str
) -> None:
    """Against residuals and derivatives that are summed here, of the losses' NumPy."""
    plain = loss in ("linear", "plain") and robust == "none"
    for by_channel in (True, False) if plain else (True,):
        model = _traced(text, channels, fitted, loss, robust, by_channel)
        trace, names = _trace(text, channels)
        numbers = _values(model, np.random.default_rng(5))
        by_name = {leaf.value: value for leaf, value in numbers.items()}
        given = {leaf: by_name[leaf.value] for leaf in trace.leaves()}
        free = [p.symbol for slot in fitted or names for p in trace.parameters if p.slot == slot]
        f = tracing.evaluate(NUMPY, list(trace.outputs), given)
        zero = trace.graph.constant(0.0)
        slopes = [
            tracing.evaluate(NUMPY, [row.get(p, zero) for p in free], given)
            for row in tracing.forward(trace.outputs, free)
        ]
        raw = np.stack([by_name[f"raw[{c}]"] for c in range(channels)])
        there = np.isfinite(raw) if by_channel else np.isfinite(raw).all(axis=0) & np.ones(raw.shape, bool)
        root, cosine = by_name["root"], by_name["cosine"]
        residual, rows = np.zeros(raw.shape), np.zeros((channels, len(free), COUNT))
        for c in range(channels):
            use = LOSSES[loss]
            r = root * (use.transform(f[c] + 0 * root, cosine) - use.transform(raw[c], cosine))
            residual[c] = np.where(there[c], r, 0.0)
            rows[c] = [np.where(there[c], root * use.slope(f[c] + 0 * root, cosine) * s, 0.0) for s in slopes[c]]
        unit, rho = by_name["noise"], ROBUST[robust]
        z = (residual / unit) ** 2
        objective = 0.5 * unit**2 * rho.rho(z).sum()
        psi = residual * rho.slope(z)
        gradient = np.einsum("cpn,cn->p", rows, psi)
        stepping = np.maximum(rho.bend(z), by_name["bending"] * rho.slope(z))
        matrix = np.einsum("cpn,cn,cqn->pq", rows, stepping, rows)
        curvature = np.einsum("cpn,cn,cqn->pq", rows, rho.bend(z), rows)
        size = len(free)
        inverse = np.array([[by_name[f"leverage[{packed(i, j)}]"] for j in range(size)] for i in range(size)]) * 0.02
        numbers |= {leaf: 0.02 * numbers[leaf] for leaf in model.leverage}
        leverage = np.einsum("cpn,pq,cqn->cn", rows, inverse, rows) * rho.bend(z)
        middle = np.einsum("cpn,cn,cqn->pq", rows, (psi / np.maximum(1 - leverage, LEAST_REMAINDER)) ** 2, rows)

        fit = normal.direct(model) if by_channel else moments(model)
        assert fit is not None

        def sums(integrands: tuple[tracing.Symbol, ...], numbers: dict = numbers) -> list[float]:
            return [np.sum(np.broadcast_to(x, COUNT)) for x in tracing.evaluate(NUMPY, list(integrands), numbers)]

        opened = sums(fit.opening)
        assert opened[1] == there.sum()
        targets = [
            root * LOSSES[loss].transform(np.where(t, y, 0), cosine) * t for y, t in zip(raw, there, strict=True)
        ]
        assert opened[0] == pytest.approx(np.sum(np.square(targets)), rel=1e-9)
        known = numbers | dict(zip((*fit.opened, *fit.summed), [*opened, *sums(fit.sums)], strict=True))
        found = [float(x) for x in tracing.evaluate(NUMPY, [fit.objective, *fit.gradient, *fit.matrix], known)]
        triangle = np.tril_indices(size)
        assert found[0] == pytest.approx(objective, rel=1e-9)
        np.testing.assert_allclose(found[1 : 1 + size], gradient, rtol=1e-8, atol=1e-9)
        np.testing.assert_allclose(found[1 + size :], matrix[triangle], rtol=1e-8, atol=1e-9)
        if robust != "none":
            np.testing.assert_allclose(sums(fit.curving), curvature[triangle], rtol=1e-8, atol=1e-9)
        squares, _, *closing = sums(fit.closing)
        assert squares == pytest.approx(np.sum(residual**2), rel=1e-9)
        np.testing.assert_allclose(closing[:size], gradient, rtol=1e-8, atol=1e-9)
        np.testing.assert_allclose(closing[size:-1], middle[triangle], rtol=1e-8, atol=1e-9)
        assert closing[-1] == 0  # no clamp acts


def test_the_cheaper_form_is_taken() -> None:
    for text, fitted in (
        ("oren_nayar", None),
        ("lambert", None),
        ("dust_layer(oren_nayar + torrance_sparrow)", ["K_d", "sigma_d", "K_s", "sigma_s"]),
    ):
        trace, names = _trace(text, 3)
        assert module.equations(trace, fitted or names, LOSSES["linear"], ROBUST["none"]).form == "moments"
        assert module.equations(trace, fitted or names, LOSSES["log"], ROBUST["none"]).form == "direct"
        assert module.equations(trace, fitted or names, LOSSES["linear"], ROBUST["huber"]).form == "direct"


def test_moments_sum_one_exponential_a_sample() -> None:
    """The whole of Oren-Nayar is summed once: what is left at every point is the highlight and its slope."""
    model = _traced("dust_layer(oren_nayar + torrance_sparrow)", 3, ["K_d", "sigma_d", "K_s", "sigma_s"])
    fit = moments(model)
    assert fit is not None
    functions = [
        symbol.op
        for symbol in tracing.live(fit.sums)
        if tracing.dependence(fit.sums, model.leaves)[symbol] & PARAMETERS
    ]
    assert functions.count("exp") == 1
    assert len(fit.sums) == 15
    alone = moments(_traced("oren_nayar", 3))
    assert alone is not None
    assert not alone.sums


def test_terms_multiply_out_to_the_formula() -> None:
    graph = tracing.Graph()
    x, y, p, q = (graph.leaf(name) for name in "xypq")
    leaves = {x: DIRECTIONS, y: DIRECTIONS, p: PARAMETERS, q: PARAMETERS}
    formula = (
        (p * x + 2 * q * y) * (q - p) / (1 + q)
        - graph.exp(-(x * p)) * y / x
        + graph.where(x < y, p * x, q * x)
        + (-(p * q)) * (x + p * y)
    )
    (formula,) = separation.gathered([formula], leaves)
    terms = separation.terms(formula, tracing.dependence([formula], leaves))
    total = graph.constant(0.0)
    for key, value in terms.items():
        for factor in key:
            value = value * factor
            assert not tracing.dependence([factor], leaves)[factor] & DIRECTIONS
        total = total + value
    numbers = dict(zip(leaves, np.random.default_rng(3).uniform(0.5, 2, (4, 20)), strict=True))
    a, b = tracing.evaluate(NUMPY, [formula, total], numbers)
    np.testing.assert_allclose(a, b, rtol=1e-13)
    assert len(terms) > 3


def test_a_clamp_is_found_and_taken_off() -> None:
    model = _traced("oren_nayar", 1)
    bits = tracing.dependence(model.outputs, model.leaves)
    assert len(separation.clamps(model.outputs, bits)) == 1
    plain = separation.unclamped(model.outputs, bits)
    assert not separation.clamps(plain, tracing.dependence(plain, model.leaves))


SIZE, LANES = 4, 30


class _Both:
    """The same numbers as arrays and as leaves of formulas."""

    def __init__(self) -> None:
        self.algebra = Formulas()
        self.numbers: dict[tracing.Symbol, np.ndarray] = {}
        rng = self.rng = np.random.default_rng(7)
        a = rng.normal(size=(LANES, SIZE + 3, SIZE))
        full = np.swapaxes(a, 1, 2) @ a
        full[0, 1:, 0] = full[0, 0, 1:] = 0.0
        self.matrix = self.of("matrix", np.moveaxis(full, 0, 2))
        self.middle = self.of("middle", np.moveaxis(full[::-1] + np.eye(SIZE), 0, 2))
        self.x, self.gradient = (
            self.of("x", rng.normal(size=(SIZE, LANES))),
            self.of("gradient", rng.normal(size=(SIZE, LANES))),
        )
        self.low, self.high = self.of("low", np.full((SIZE, LANES), -1.0)), self.of("high", np.full((SIZE, LANES), 1.1))
        self.none = self.of("none", np.zeros((SIZE, LANES)))
        self.one = self.of("one", np.ones((SIZE, LANES)))

    def of(self, name: str, array: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if array.ndim == 3:
            formula = self.algebra.matrix(name, len(array))
            self.numbers |= {formula[i, j]: array[i, j] for i in range(len(array)) for j in range(len(array))}
            return array, formula
        if array.ndim == 1:
            formula = self.algebra.number(name)
            self.numbers[formula[0]] = array
            return array, formula
        formula = self.algebra.vector(name, len(array))
        self.numbers |= dict(zip(formula, array, strict=True))
        return array, formula

    def scalar(self, name: str, low: float, high: float) -> tuple[np.ndarray, np.ndarray]:
        return self.of(name, self.rng.uniform(low, high, LANES))

    def same(self, step, *given, rtol: float = 1e-9) -> None:
        """A step over arrays and over formulas gives the same numbers."""
        found = step(ARRAYS, *(pair[0] for pair in given))
        printed = step(self.algebra, *(pair[1] for pair in given))
        parts = zip(_flat(found), _flat(printed), strict=True)
        for number, formula in parts:
            symbols = self.algebra.lifted(triangle_of(formula) if np.ndim(formula) == 2 else formula)
            values = [np.broadcast_to(v, LANES) for v in tracing.evaluate(NUMPY, symbols, self.numbers)]
            expected = np.stack(triangle_of(number)) if number.ndim == 3 else np.atleast_2d(number)
            np.testing.assert_allclose(values, expected, rtol=rtol, atol=1e-12)


def _flat(found) -> list:
    return [part for item in found for part in _flat(item)] if isinstance(found, tuple) else [found]


def _bundle(kind, *pairs):
    """What steps take together, over arrays and over formulas."""
    return tuple(kind(*(pair[k] for pair in pairs)) for k in range(2))


def _step(algebra, at, damping, box, stopped, given):
    scale = levenberg.scale_of(algebra, at.matrix, box)
    return levenberg.bounded_step(algebra, at, damping, box, stopped, given, scale)


def test_the_steps_of_an_iteration_are_printed_as_numpy_runs_them() -> None:
    both = _Both()
    bright, damping = both.scalar("bright", 1, 2), both.scalar("damping", 1e-4, 1)
    objective, trial, promised = (both.scalar(name, 0.1, 1) for name in ("objective", "trial", "promised"))
    growth, idle = both.scalar("growth", 2, 8), both.of("idle", np.arange(LANES) % 10.0)
    reduction, noise = both.of("reduction", np.full(LANES, 1e-3)), both.of("noise", np.full(LANES, 1e-2))
    stopped = both.of("stopped", (both.rng.uniform(size=(SIZE, LANES)) < 0.2).astype(float))
    given = both.of("given", 0.1 * stopped[0])
    ending = both.of("ending", np.arange(LANES) % 6.0)
    at = _bundle(levenberg.At, both.x, objective, both.gradient, both.matrix)
    unit = both.of("unit", np.geomspace(1e-3, 1e3, SIZE * LANES).reshape(SIZE, LANES))
    box = _bundle(levenberg.Box, both.low, both.high, unit)
    state = _bundle(levenberg.Damping, damping, growth, idle)
    precision = _bundle(levenberg.Precision, reduction, noise)
    both.same(levenberg.held, at, box, both.none, bright)
    both.same(levenberg.diagonal_of, both.matrix, box)
    both.same(_step, at, damping, box, stopped, given)
    both.same(levenberg.proposal, at, state, given, box, precision, bright)
    both.same(levenberg.judged, objective, trial, promised, state, precision)
    both.same(levenberg.polished, both.x, objective, ending, both.gradient, both.middle, both.one, box)


def test_the_steps_to_errors_and_verdicts_are_printed_as_numpy_runs_them() -> None:
    both = _Both()
    bright, relaxed = both.scalar("bright", 1, 2), both.of("relaxed", both.rng.uniform(size=(SIZE, LANES)))
    among = both.of("among", (both.rng.uniform(size=(SIZE, LANES)) < 0.8).astype(float))
    span, squared = both.of("span", np.full((SIZE, LANES), 0.7)), both.of("squared", np.ones((SIZE, LANES)))
    zero, one, x = both.none, both.one, both.x
    size = both.of("size", np.geomspace(1e-3, 1e3, SIZE * LANES).reshape(SIZE, LANES))
    columns = tuple(
        Columns(*(pair[k] for pair in (both.low, both.high, size, span, zero, one, zero, squared, span, zero)))
        for k in range(2)
    )
    both.same(covariance.standing, x, both.matrix, columns, bright)
    both.same(covariance.rested, x, among, columns)
    both.same(covariance.inverted, both.matrix, among)
    both.same(covariance.noise_of, both.matrix, both.middle, among)
    unit = both.of("unit", np.repeat(np.eye(SIZE)[:, :1], LANES, axis=1))
    both.same(covariance.pushed_out, unit, both.gradient, span, both.middle, both.matrix, among)
    stand = tuple(covariance.Standing(zero[k], zero[k], zero[k], among[k]) for k in range(2))
    both.same(covariance.errors, both.matrix, relaxed, zero, stand, zero, columns, one)
    both.same(covariance.own_error, x, one, squared)
    both.same(covariance.judged, x, span, columns, zero)
    both.same(lambda algebra, inverse, middle: algebra.sandwich(inverse, middle), both.matrix, both.middle)
