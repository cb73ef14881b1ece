"""The pieces of the batched solver, each against plain NumPy: the step, separated formulas, vectors, and normal equations."""

from __future__ import annotations

import numpy as np
import pytest

from motes.arrays import NUMPY
from motes.fitting import levenberg
from motes.fitting.levenberg import packed
from motes.fitting.printed import normal
from motes.graph import separation, tracing
from motes.graph.tracing import DIRECTIONS, PARAMETERS
from motes.models import parse


def _traced(text: str, channels: int, fitted: list[str] | None = None) -> tuple[tracing.Trace, normal.Traced]:
    brdf = parse(text).model
    per_channel = {
        s.name: np.full(channels, s.parameter.default)
        for s in brdf.slots()
        if s.parameter.per_channel and not s.parameter.shared_in_fit
    }
    trace = tracing.trace(brdf.with_parameters(per_channel), channels, horizon=False)
    return trace, normal.Traced.of(trace, fitted or [s.name for s in brdf.slots()])


def _random_leaves(
    leaves: dict[tracing.Symbol, int], count: int, rng: np.random.Generator
) -> dict[tracing.Symbol, np.ndarray]:
    """Values for all leaves: unit vectors, parameters, data."""
    values = {}
    for w in ("wi", "wo"):
        v = rng.normal(size=(3, count))
        v[2] = np.abs(v[2]) + 0.3
        v /= np.linalg.norm(v, axis=0)
        values |= {f"{w}.{axis}": x for axis, x in zip("xyz", v, strict=True)}
    return {
        leaf: values[leaf.value]
        if leaf.value in values
        else (rng.uniform(0.2, 0.8, count) if bit != PARAMETERS else np.float64(rng.uniform(0.2, 0.8)))
        for leaf, bit in leaves.items()
    }


@pytest.mark.parametrize(
    ("text", "channels", "fitted", "form"),
    [
        ("oren_nayar", 3, None, "moments"),
        ("oren_nayar + torrance_sparrow", 3, None, "moments"),
        ("dust_layer(oren_nayar + torrance_sparrow)", 3, ["K_d", "sigma_d", "K_s", "sigma_s"], "moments"),
        ("dust_layer(oren_nayar + torrance_sparrow)", 3, None, None),
        ("torrance_sparrow(normalization='facets', fresnel=schlick)", 1, None, None),
        ("lambert", 2, None, "moments"),
    ],
)
def test_both_forms_are_the_normal_equations(
    text: str, channels: int, fitted: list[str] | None, form: str | None
) -> None:
    """Against residuals and derivatives that are summed here."""
    rng = np.random.default_rng(5)
    trace, model = _traced(text, channels, fitted)
    leaves = _random_leaves(model.leaves, 40, rng)
    leaves[model.weight] = (rng.uniform(size=40) < 0.8).astype(float)
    raw = [leaves[v] for v in model.values]
    offsets = tracing.evaluate(NUMPY, list(model.offsets), leaves)
    for v, given, offset in zip(model.values, raw, offsets, strict=True):
        leaves[v] = leaves[model.weight] * (given - offset)
    scale = leaves[trace.graph.leaf("scale")]
    plain = [f * scale for f in tracing.evaluate(NUMPY, list(trace.outputs), leaves)]
    tangents = tracing.forward(trace.outputs, list(model.parameters))
    zero = trace.graph.constant(0.0)
    weight = leaves[model.weight]
    residuals = [weight * (f - y) for f, y in zip(plain, raw, strict=True)]
    rows = [
        np.stack(
            [
                np.broadcast_to(x, 40) * scale * weight
                for x in tracing.evaluate(NUMPY, [t.get(p, zero) for p in model.parameters], leaves)
            ]
        )
        for t in tangents
    ]
    objective = 0.5 * sum(np.sum(r * r) for r in residuals)
    gradient = sum(row @ r for row, r in zip(rows, residuals, strict=True))
    matrix = sum(row @ row.T for row in rows)
    middle = sum((row * r * r) @ row.T for row, r in zip(rows, residuals, strict=True))
    forms = [normal.direct(model), normal.moments(model)]
    assert forms[1] is not None
    if form:
        assert normal.cheapest(model).form == form
    for fit in forms:
        sums = [np.sum(np.broadcast_to(x, 40)) for x in tracing.evaluate(NUMPY, [*fit.opening, *fit.sums], leaves)]
        known = leaves | dict(zip((*fit.opened, *fit.summed), sums, strict=True))
        found = [float(x) for x in tracing.evaluate(NUMPY, [fit.objective, *fit.gradient, *fit.matrix], known)]
        size = len(model.parameters)
        assert found[0] == pytest.approx(objective, rel=1e-9)
        np.testing.assert_allclose(found[1 : 1 + size], gradient, rtol=1e-8, atol=1e-9)
        triangle = [matrix[i, j] for i in range(size) for j in range(i + 1)]
        np.testing.assert_allclose(found[1 + size :], triangle, rtol=1e-8, atol=1e-9)
        squares, clamped, *closing = [
            np.sum(np.broadcast_to(x, 40)) for x in tracing.evaluate(NUMPY, list(fit.closing), leaves)
        ]
        assert squares == pytest.approx(2 * objective, rel=1e-9)
        assert clamped == 0
        np.testing.assert_allclose(
            closing, [middle[i, j] for i in range(size) for j in range(i + 1)], rtol=1e-8, atol=1e-9
        )


def test_moments_sum_one_exponential_a_sample() -> None:
    """The whole of Oren-Nayar is summed once: what is left at every point is the highlight and its slope."""
    _, model = _traced("dust_layer(oren_nayar + torrance_sparrow)", 3, ["K_d", "sigma_d", "K_s", "sigma_s"])
    fit = normal.moments(model)
    assert fit is not None
    functions = [
        symbol.op
        for symbol in tracing.live(fit.sums)
        if tracing.dependence(fit.sums, model.leaves)[symbol] & PARAMETERS
    ]
    assert functions.count("exp") == 1
    assert len(fit.sums) == 15
    _, diffuse = _traced("oren_nayar", 3)
    alone = normal.moments(diffuse)
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
    _, model = _traced("oren_nayar", 1)
    bits = tracing.dependence(model.outputs, model.leaves)
    assert len(separation.clamps(model.outputs, bits)) == 1
    plain = separation.unclamped(model.outputs, bits)
    assert not separation.clamps(plain, tracing.dependence(plain, model.leaves))


def _system(rng: np.random.Generator, size: int, lanes: int) -> tuple[np.ndarray, list[np.ndarray], np.ndarray]:
    a = rng.normal(size=(lanes, size + 3, size))
    full = np.swapaxes(a, 1, 2) @ a
    return full, [full[:, i, j] for i in range(size) for j in range(i + 1)], rng.normal(size=(size, lanes))


def test_a_free_step_solves_the_damped_equations() -> None:
    rng = np.random.default_rng(7)
    size, lanes = 5, 30
    full, triangle, gradient = _system(rng, size, lanes)
    x = rng.normal(size=(size, lanes))
    damping = rng.uniform(1e-3, 1, lanes)
    nothing = [np.zeros(lanes)] * size
    wide = [np.full(lanes, 1e9)] * size
    step = levenberg.bounded_step(NUMPY, x, gradient, triangle, damping, [-w for w in wide], wide, nothing, nothing)
    diagonal = np.einsum("lii->li", full)
    damped = full + np.einsum("l,li,ij->lij", damping, diagonal, np.eye(size))
    expected = -np.linalg.solve(damped, gradient.T[..., None])[..., 0]
    np.testing.assert_allclose(np.stack(step.step, axis=1), expected, rtol=1e-9)
    assert not np.any(step.leaving)


def test_what_leaves_the_box_stops_and_the_others_are_solved_for_again() -> None:
    rng = np.random.default_rng(8)
    size, lanes = 3, 1
    full, triangle, gradient = _system(rng, size, lanes)
    x = [np.zeros(lanes)] * size
    low, high = [np.full(lanes, -1e9)] * size, [np.full(lanes, 1e9)] * size
    nothing = [np.zeros(lanes)] * size
    damping = np.zeros(lanes)
    free = levenberg.bounded_step(NUMPY, x, gradient, triangle, damping, low, high, nothing, nothing)
    (first, *_) = free.step
    bound = 0.5 * first
    low[0], high[0] = (bound, high[0]) if first < 0 else (low[0], bound)
    once = levenberg.bounded_step(NUMPY, x, gradient, triangle, damping, low, high, nothing, nothing)
    assert once.leaving == 1
    np.testing.assert_allclose(once.step[0], bound)
    twice = levenberg.bounded_step(NUMPY, x, gradient, triangle, damping, low, high, once.stopped, once.step)
    rest = -np.linalg.solve(full[0, 1:, 1:], gradient[1:, 0] + full[0, 1:, 0] * bound)
    np.testing.assert_allclose(np.ravel(twice.step), [float(bound[0]), *rest], rtol=1e-9)


def test_what_is_held() -> None:
    one = np.ones(1)
    x = [0.0 * one, 1.0 * one, 0.5 * one, 0.5 * one, 0.5 * one]
    gradient = [one, -one, one, one, 0 * one]
    matrix = [np.zeros(1)] * 15
    for k in range(5):
        matrix[packed(k, k)] = one if k != 3 else 0 * one
    low, high, fixed = [0 * one] * 5, [one] * 5, [0 * one] * 4 + [one]
    stuck = levenberg.held(NUMPY, x, gradient, matrix, low, high, fixed, one)
    assert [s.item() for s in stuck] == [1, 1, 0, 1, 1]  # pushed out low, pushed out high, free, unseen, fixed


def test_a_worse_or_broken_point_is_refused_and_damps() -> None:
    objective, trial = np.array([1.0, 1.0, 1.0]), np.array([0.5, 2.0, np.nan])
    half, two, zero = np.full(3, 0.5), np.full(3, 2.0), np.zeros(3)
    verdict = levenberg.judged(NUMPY, objective, trial, half, np.full(3, 1e-3), two, zero, 1e-5, zero)
    assert verdict.better.tolist() == [1, 0, 0]
    assert verdict.damping[0] < 1e-3
    np.testing.assert_allclose(verdict.damping[1:], 2e-3)
    np.testing.assert_allclose(verdict.growth, [2, 4, 4])


def test_vectors_compute_what_numpy_does() -> None:
    numba = pytest.importorskip("numba")
    from numba.extending import intrinsic

    from motes.kernels import vectors

    program = """x box out
a0 = row x D 0
a1 = splat box D 1
t0 = mul a0 a1
t1 = exp t0
t2 = expm1 t0
t3 = lt a0 a1
t4 = where t3 t1 t2
t5 = sqrt t1
t6 = minimum a0 a1
t7 = div t5 a1
t8 = neg t7
t9 = sub t8 t6
c = const -0.25
u = maximum t9 c
put out D 0 t1
put out D 16 t2
put out D 32 t4
put out D 48 u
put out D 64 t3"""

    @intrinsic
    def run(typing, x, box, out):  # type: ignore[no-untyped-def]
        return vectors.rows(16, "D", program, x, box, out)

    @numba.njit
    def call(x, box, out):  # type: ignore[no-untyped-def]
        run(x, box, out)

    x = np.random.default_rng(2).uniform(-3, 3, 16)
    box, out = np.array([9.0, 1.3]), np.zeros(80)
    call(x.ctypes.data, box.ctypes.data, out.ctypes.data)
    t1, t2 = np.exp(1.3 * x), np.expm1(1.3 * x)
    expected = [t1, t2, np.where(x < 1.3, t1, t2), np.maximum(-np.sqrt(t1) / 1.3 - np.minimum(x, 1.3), -0.25), x < 1.3]
    np.testing.assert_allclose(out.reshape(5, 16), np.stack(expected), rtol=1e-14)
