"""Errors over blocks of directions: what is made up for in them, their degrees of freedom, when they are chosen, and what they cover."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

import motes
from fitting_oracle import scattered
from motes.errors import DataError, MotesError
from motes.fitting.alike import FEWEST, MOST
from motes.fitting.clusters import evened, plain
from motes.fitting.error_bars import BEYOND, LEVELS, together
from motes.fitting.students_t import half_width
from motes.measurements import Measurement

Floats = NDArray[np.float64]
PAINT = "oren_nayar + torrance_sparrow"
SURFACE = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.25, sigma_s=0.2)
#: What oren_nayar + torrance_sparrow does not fit.
RICHER = motes.CoatedDiffuse(rho=(0.6, 0.4, 0.25), n=1.5) + motes.GTR(K_s=0.1, alpha=0.25, gamma=1.5)


def design(blocks: int = 9, each: int = 7, parameters: int = 4) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """The derivatives and residuals of a linear fit, and blocks of unequal leverage."""
    rng = np.random.default_rng(3)
    labels = np.repeat(np.arange(blocks), each)
    j = rng.normal(size=(len(labels), parameters)) * (1 + labels[:, None])
    y = rng.normal(size=len(labels)) + rng.normal(size=blocks)[labels]
    return j, j @ np.linalg.lstsq(j, y)[0] - y, labels


def by_block(j: Floats, e: Floats, labels: NDArray[np.intp]) -> tuple[Floats, Floats]:
    parts = [labels == k for k in range(labels.max() + 1)]
    return np.stack([j[k].T @ e[k] for k in parts]), np.stack([j[k].T @ j[k] for k in parts])


def test_the_sandwich_is_bell_and_mccaffreys() -> None:
    """CR2 by the symmetric root of what a block leaves of independent noise; and of it the mean is right."""
    j, e, labels = design()
    inverse = np.linalg.inv(j.T @ j)
    middle = evened(*by_block(j, e, labels), inverse).matrix
    left = np.eye(len(j)) - j @ inverse @ j.T
    scores, expected = [], np.zeros((4, 4))
    for k in range(9):
        at = labels == k
        values, vectors = np.linalg.eigh(left[np.ix_(at, at)])
        adjusted = j[at].T @ (vectors / np.sqrt(values)) @ vectors.T
        scores.append(adjusted @ e[at])
        expected += adjusted @ left[np.ix_(at, at)] @ adjusted.T
    assert_allclose(middle, np.array(scores).T @ np.array(scores), rtol=1e-9)
    assert_allclose(inverse @ expected @ inverse, inverse, rtol=1e-9)


def test_to_the_power_of_one_it_is_the_jackknife_that_leaves_out_a_block_at_a_time() -> None:
    j, e, labels = design()
    inverse = np.linalg.inv(j.T @ j)
    middle = evened(*by_block(j, e, labels), inverse, power=1.0).matrix
    moves = np.stack([np.linalg.lstsq(j[labels != k], e[labels != k])[0] for k in range(9)])
    assert_allclose(inverse @ middle @ inverse, moves.T @ moves, rtol=1e-9)


@pytest.mark.parametrize("power", [0.5, 1.0])
def test_degrees_of_freedom_are_those_of_the_quadratic_form(power: float) -> None:
    j, e, labels = design()
    inverse = np.linalg.inv(j.T @ j)
    freedom = evened(*by_block(j, e, labels), inverse, power).freedom
    left = np.eye(len(j)) - j @ inverse @ j.T
    for p in range(4):
        rows = []  # how each block's adjusted score depends on independent noise
        for k in range(9):
            at = labels == k
            values, vectors = np.linalg.eigh(left[np.ix_(at, at)])
            rows.append((vectors * values**-power) @ vectors.T @ j[at] @ inverse[:, p] @ left[at])
        form = np.array(rows) @ np.array(rows).T
        values = np.linalg.eigvalsh(form)
        assert_allclose(freedom[p], values.sum() ** 2 / (values**2).sum(), rtol=1e-9)
    assert freedom.min() > 1
    assert freedom.max() < 9


def test_what_is_not_free_has_no_part_in_it() -> None:
    j, e, labels = design()
    inverse = np.zeros((4, 4))
    inverse[:3, :3] = np.linalg.inv(j[:, :3].T @ j[:, :3])
    whole, part = evened(*by_block(j, e, labels), inverse), by_block(j[:, :3], e, labels)
    three = evened(*part, inverse[:3, :3])
    assert_allclose(whole.matrix[:3, :3], three.matrix, rtol=1e-9)
    assert_allclose(whole.freedom[:3], three.freedom, rtol=1e-9)


def test_without_leverages_scores_are_squared_by_block() -> None:
    j, e, labels = design()
    scores, shares = by_block(j, e, labels)
    middle = plain(scores, np.einsum("gpp->gp", shares))
    assert_allclose(middle.matrix, 9 / 8 * sum(np.outer(s, s) for s in scores), rtol=1e-12)
    alike = plain(scores, np.ones((9, 4)))
    assert_allclose(alike.freedom, 8)


@pytest.mark.parametrize(
    ("freedom", "level", "value"),
    [
        # Tables of Student's t; 1 and 2 in closed form.
        (1, 0.95, math.tan(0.475 * math.pi)),
        (1, 0.5, 1.0),
        (2, 0.95, 0.95 * math.sqrt(2 / (1 - 0.95**2))),
        (3, 0.95, 3.182446),
        (5, 0.99, 4.032143),
        (10, 0.95, 2.228139),
        (30, 0.9, 1.697261),
        (120, 0.95, 1.979930),
        (math.inf, 0.95, 1.959964),
        (math.inf, LEVELS["68"], 1.0),
    ],
)
def test_quantiles_of_students_t(freedom: float, level: float, value: float) -> None:
    assert_allclose(half_width(level, freedom), value, rtol=1e-6)


@pytest.mark.parametrize("freedom", [1, 1.01, 1.5, 2, 3.3, 8.7, 33.3, 300.5, 1e4, 9e5])
def test_quantiles_of_students_t_are_those_of_scipy(freedom: float) -> None:
    stats = pytest.importorskip("scipy.stats")
    for level in (1e-4, 0.1, 0.68, 0.95, 0.9999):
        assert_allclose(half_width(level, freedom), stats.t.ppf(0.5 + 0.5 * level, freedom), rtol=1e-8)


def test_residuals_that_go_together_are_seen_and_noise_is_not() -> None:
    rng = np.random.default_rng(0)
    labels = np.repeat(np.arange(24), 9)
    noise = rng.standard_normal((300, 1, len(labels), 3)) * rng.lognormal(size=(1, 1, len(labels), 3))
    assert sum(together(r, labels) for r in noise) == 0
    assert together(noise[0] + 2 * rng.standard_normal(24)[labels][:, None], labels)  # blocks
    assert together(np.repeat(noise[0, :, :, :1], 3, axis=-1), np.arange(len(labels)) % 24)  # channels alone
    assert not together(np.zeros((1, len(labels), 3)), labels)
    assert BEYOND > 5


def painted(surface: motes.BRDF = SURFACE, count: int = 200, **facts: Any) -> Measurement:
    wi, wo = scattered(count, seed=8)
    clean = surface.eval(wi, wo)
    values = clean * (1 + 0.02 * np.random.default_rng(4).standard_normal(clean.shape))
    return Measurement.from_arrays(wi, wo, values, **facts)


@pytest.mark.parametrize(
    ("facts", "surface", "kind", "why"),
    [
        ({"provenance": {"format": "curet"}}, SURFACE, "blocks", "neighbours share"),
        ({"provenance": {"format": "csv", "source": "simulated by Motes"}}, SURFACE, "independent", "are simulated"),
        ({"provenance": {"source": "simulated by Motes"}}, RICHER, "blocks", "go together"),
        ({}, SURFACE, "independent", "not said to be measured"),
        ({}, RICHER, "blocks", "go together"),
        ({"uncertainties": 0.02}, SURFACE, "independent", "with uncertainties"),
        ({"uncertainties": 0.02}, RICHER, "blocks", "go together"),
    ],
)
def test_the_measurement_says_what_is_independent(
    facts: dict[str, Any], surface: motes.BRDF, kind: str, why: str
) -> None:
    relative = facts.pop("uncertainties", None) if "uncertainties" in facts else None
    data = painted(surface, **facts)
    data = data if relative is None else data.with_uncertainties(relative=relative)
    fit = motes.fit(data, PAINT)
    assert fit.errors.kind == kind
    assert why in fit.errors.why
    assert (FEWEST <= fit.errors.blocks <= MOST) if kind == "blocks" else fit.errors.blocks == 0
    assert fit.to_dict()["errors"] == {"kind": kind, "blocks": fit.errors.blocks, "why": fit.errors.why}
    over = f"over {fit.errors.blocks} blocks of directions: " if kind == "blocks" else "over independent samples: "
    assert str(fit.errors).startswith(over)


def test_what_is_asked_for_is_done_or_refused() -> None:
    data = painted()
    assert motes.fit(data, PAINT, errors="blocks").errors.why == "as asked for"
    assert motes.fit(painted(RICHER), PAINT, errors="independent").errors.kind == "independent"
    few = painted(RICHER, 28)
    assert "28 usable directions are too few" in motes.fit(few, PAINT).errors.why
    with pytest.raises(DataError, match="28 usable directions are too few for blocks, of which there must be 8"):
        motes.fit(few, PAINT, errors="blocks")
    with pytest.raises(MotesError, match="errors 'hc3' is not one of auto, blocks"):
        motes.fit(data, PAINT, errors="hc3")


def test_intervals_are_quantiles_of_t_in_the_coordinate_of_the_fit_and_end_at_bounds() -> None:
    fit = motes.fit(painted(), PAINT, errors="independent")
    K_d, sigma_d = fit.parameters["K_d"], fit.parameters["sigma_d"]
    assert K_d.intervals["95"].shape == (3, 2)
    assert sigma_d.intervals["95"].shape == (2,)
    for level, width in (("68", 1.0), ("95", 1.96)):
        ends = np.stack([K_d.value - width * K_d.stderr, K_d.value + width * K_d.stderr], axis=-1)
        assert_allclose(K_d.intervals[level], ends, rtol=1e-3)  # 594 degrees of freedom
    low, high = sigma_d.intervals["68"] ** 2
    assert_allclose(0.5 * (low + high), sigma_d.value**2, rtol=1e-6)
    assert_allclose(0.5 * (math.sqrt(high) - math.sqrt(low)), sigma_d.stderr, rtol=1e-3)
    near = motes.fit(painted(motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.018)), "oren_nayar").parameters["sigma_d"]
    assert near.value > 0
    assert near.intervals["95"][0] == 0
    held = motes.fit(painted(), PAINT, fixed={"sigma_d": 0.4}).parameters["sigma_d"]
    assert np.isnan(held.intervals["68"]).all()


def test_trends_over_blocks_are_wider_where_the_model_misses() -> None:
    one = painted(RICHER, 120)
    wi, wo = one.wi, one.wo
    rng = np.random.default_rng(5)
    values = np.stack([RICHER.eval(wi, wo) * (1 + 0.02 * rng.standard_normal((120, 3))) for _ in range(4)])
    series = Measurement.from_arrays(wi, wo, values, times=np.arange(4.0), time_unit="h")
    kinds = dict.fromkeys(("K_d", "sigma_d", "K_s", "sigma_s"), "constant")
    blocks = motes.fit(series, PAINT, trends=kinds)
    alone = motes.fit(series, PAINT, trends=kinds, errors="independent")
    assert blocks.errors.kind == "blocks"
    ratio = np.sqrt(np.diag(blocks.trends["K_d"].trend.covariance / alone.trends["K_d"].trend.covariance))
    assert (ratio > 2).all()


def test_intervals_cover_where_noise_is_independent_and_where_the_model_misses() -> None:
    def cover(surface: motes.BRDF, truth: Floats, errors: str, repeats: int = 30) -> tuple[float, float]:
        inside: dict[str, list[NDArray[np.bool_]]] = {"68": [], "95": []}
        for k in range(repeats):
            wi, wo = scattered(200, seed=100 + k)
            clean = surface.eval(wi, wo)
            values = clean * (1 + 0.02 * np.random.default_rng(k).standard_normal(clean.shape))
            K_d = motes.fit(Measurement.from_arrays(wi, wo, values), PAINT, errors=errors).parameters["K_d"]
            for level, found in inside.items():
                low, high = K_d.intervals[level].T
                found.append((low < truth) & (truth < high))
        return 100 * float(np.mean(inside["68"])), 100 * float(np.mean(inside["95"]))

    for errors in ("auto", "blocks"):
        one, two = cover(SURFACE, np.array([0.6, 0.4, 0.25]), errors)
        assert 58 < one < 82
        assert two > 88
    wi, wo = scattered(6000, seed=1)
    nearest = motes.fit(Measurement.from_arrays(wi, wo, RICHER.eval(wi, wo)), PAINT).parameters["K_d"].value
    one, two = cover(RICHER, np.asarray(nearest), "auto")
    assert one > 50
    assert two > 85
    assert cover(RICHER, np.asarray(nearest), "independent")[0] < one - 15


def test_the_bootstrap_finds_the_errors_of_blocks_and_shows_its_progress() -> None:
    data, said = painted(RICHER), []
    boot = motes.fit(data, PAINT, errors="bootstrap", progress=lambda *step: said.append(step))
    sandwich = motes.fit(data, PAINT, errors="blocks")
    assert (boot.errors.kind, boot.errors.blocks) == ("bootstrap", sandwich.errors.blocks)
    assert f"by a bootstrap over {boot.errors.blocks} blocks" in str(boot.errors)
    K_d, other = boot.parameters["K_d"], sandwich.parameters["K_d"]
    assert_allclose(K_d.stderr, other.stderr, rtol=0.4)
    assert_allclose(K_d.value, other.value)
    assert ((K_d.intervals["95"][:, 0] < K_d.intervals["68"][:, 0]) & (K_d.intervals["68"][:, 0] < K_d.value)).all()
    assert_allclose(np.sqrt(np.diag(boot.covariance))[:3], K_d.stderr)
    assert [step for step in said if step[2] == "bootstrap"][-1][0] == 400
    again = motes.fit(data, PAINT, errors="bootstrap").parameters["K_d"]
    assert (again.stderr == K_d.stderr).all()


def test_the_bootstrap_of_a_mean_is_that_of_its_formula() -> None:
    """Of a Lambert surface, K_d is a weighted mean, whose block bootstrap has a closed form to first order."""
    wi, wo = scattered(240, seed=3)
    rng = np.random.default_rng(1)
    from motes.fitting.direction_blocks import blocks_of

    values = (0.5 + 0.05 * rng.standard_normal(24)[blocks_of(wi, wo)])[:, None] / np.pi
    fit = motes.fit(Measurement.from_arrays(wi, wo, values), "lambert", errors="bootstrap")
    count = fit.errors.blocks
    labels = blocks_of(wi, wo, count)
    weights = wi[:, 2] ** 2
    mean = np.sum(weights * values[:, 0]) / np.sum(weights)
    scores = np.bincount(labels, weights * (values[:, 0] - mean)) * np.pi / np.sum(weights)
    expected = math.sqrt(count / (count - 1) * np.sum(scores**2))
    assert_allclose(fit.parameters["K_d"].value, np.pi * mean)
    assert_allclose(fit.parameters["K_d"].stderr, expected, rtol=0.12)  # 400 draws: 3.5 %; few blocks: 4 %
    low, high = np.ravel(fit.parameters["K_d"].intervals["68"])
    assert_allclose(0.5 * (high - low), expected, rtol=0.2)


def test_profiles_of_what_is_linear_are_the_intervals_of_t() -> None:
    data = painted(motes.Lambert(K_d=(0.6, 0.4, 0.25)))
    for model in ("lambert", "lambert + torrance_sparrow(sigma_s=0.2)"):
        plain_, profile = (motes.fit(data, model, errors=e) for e in ("independent", "profile"))
        assert profile.errors.kind == "profile"
        assert "intervals by the profile likelihood" in str(profile.errors)
        K_d = profile.parameters["K_d"]
        for level in LEVELS:
            assert_allclose(K_d.intervals[level], plain_.parameters["K_d"].intervals[level], rtol=1e-3)
        assert_allclose(K_d.stderr, plain_.parameters["K_d"].stderr)


def test_a_profile_ends_where_the_fit_gets_too_bad() -> None:
    """By refits of our own, with the parameter held at the ends: twice the rise is the square of the quantile, in one unit."""
    fit = motes.fit(painted(count=60), PAINT, errors="profile", loss="linear")
    sigma_s, least = fit.parameters["sigma_s"], fit.metrics["objective"]
    rises = {}
    for level in LEVELS:
        ends = [motes.fit(painted(count=60), PAINT, fixed={"sigma_s": v}) for v in sigma_s.intervals[level]]
        rises[level] = np.array([2 * (end.metrics["objective"] - least) for end in ends])
        assert_allclose(rises[level][0], rises[level][1], rtol=0.02)  # on both sides
    freedom = 60 * 3 - 6
    ratio = (half_width(LEVELS["95"], freedom) / half_width(LEVELS["68"], freedom)) ** 2
    assert_allclose(rises["95"].mean() / rises["68"].mean(), ratio, rtol=0.02)


def test_a_profile_begins_at_a_bound() -> None:
    surface = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.0)
    for seed in range(10):
        wi, wo = scattered(200, seed=8)
        clean = surface.eval(wi, wo)
        values = clean * (1 + 0.02 * np.random.default_rng(seed).standard_normal(clean.shape))
        sigma_d = motes.fit(Measurement.from_arrays(wi, wo, values), "oren_nayar", errors="profile").parameters[
            "sigma_d"
        ]
        if sigma_d.value == 0:
            break
    assert sigma_d.value == 0
    assert sigma_d.intervals["95"][0] == 0
    assert 0 < sigma_d.intervals["68"][1] < sigma_d.intervals["95"][1] < 0.2


def test_trends_have_a_bootstrap_and_no_profile() -> None:
    one = painted(count=60)
    values = np.stack([one.values[0] * (1 + 0.01 * k) for k in range(3)])
    series = Measurement.from_arrays(one.wi, one.wo, values, times=np.arange(3.0), time_unit="h")
    kinds = {"K_d": "linear", "sigma_d": "constant"}
    fit = motes.fit(series, "oren_nayar", trends=kinds, errors="bootstrap")
    other = motes.fit(series, "oren_nayar", trends=kinds, errors="blocks")
    ratio = np.sqrt(np.diag(fit.trends["K_d"].trend.covariance / other.trends["K_d"].trend.covariance))
    assert ((ratio > 0.6) & (ratio < 1.4)).all()
    with pytest.raises(MotesError, match="errors 'profile' is for one time"):
        motes.fit(series, "oren_nayar", trends=kinds, errors="profile")
