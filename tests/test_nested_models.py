"""A richer model never ends farther from the data than a simpler one within it: where each is the simpler one, and what fits end at."""

from __future__ import annotations

import numpy as np
import pytest

import motes
from fitting_oracle import scattered
from motes.fitting.climbing import climb
from motes.fitting.nested import Found, carried, nearer
from motes.fitting.setup import Wishes, prepare
from motes.measurements import Measurement
from motes.models import parse
from motes.models.base import BRDF

WISHES = Wishes("linear", "none", "measurement", (), ())
COAT, TAIL = "coated_diffuse + ggx(fresnel=schlick)", "coated_diffuse + gtr(fresnel=schlick)"
POWDER = "coated_diffuse + hapke(B_0=0, h=0.1) + ggx(fresnel=schlick)"
FACETS, RISING = "oren_nayar + torrance_sparrow", "oren_nayar + torrance_sparrow(fresnel=schlick)"
#: A model, and one within it.
PAIRS = (
    (POWDER, COAT),
    (RISING, FACETS),
    (f"dust_layer({FACETS})", FACETS),
    (f"dust_layer({TAIL})", TAIL),
    (FACETS, "lambert + torrance_sparrow"),
)


def simulated(seed: int = 3, count: int = 150) -> Measurement:
    """A coat with two highlights, which none of the models follows, and noise."""
    wi, wo = scattered(count, seed)
    body = motes.CoatedDiffuse(rho=0.4, n=1.4) + motes.GGX(K_s=0.3, alpha=0.12) + motes.Beckmann(K_s=0.2, alpha=0.5)
    f = body.eval(wi, wo)[:, :1]
    return Measurement.from_arrays(wi, wo, f * (1 + 0.02 * np.random.default_rng(seed).normal(size=f.shape)))


@pytest.mark.parametrize(
    ("richer", "simpler", "within"),
    [
        (motes.OrenNayar(K_d=0.6), motes.Lambert(K_d=0.6), 1e-12),
        (motes.EON(rho=0.6), motes.Lambert(K_d=0.6), 1e-12),
        (motes.CoatedDiffuse(rho=0.6), motes.Lambert(K_d=0.6), 1e-9),
        (parse("torrance_sparrow(fresnel=schlick)").model, motes.TorranceSparrow(), 1e-12),
        # The masking of GTR is an integral by the trapezoidal rule.
        (motes.GTR(K_s=0.3, alpha=0.4), motes.GGX(K_s=0.3, alpha=0.4), 2e-3),
        (motes.DustLayer(motes.OrenNayar(), motes.Dust()), motes.OrenNayar(), 1e-12),
        (motes.DustLayer(motes.OrenNayar(), motes.Dust(), scattering="multiple"), motes.OrenNayar(), 1e-9),
        *((motes.Lambert() + part, motes.Lambert(), 1e-12) for part in (motes.GGX(), motes.Retro(), motes.Sheen())),
        (motes.Lambert() + motes.Hapke(), motes.Lambert(), 1e-12),
    ],
)
def test_a_model_is_the_simpler_one_where_it_says_so(richer: BRDF, simpler: BRDF, within: float) -> None:
    inside = {slot.name for slot in simpler.slots()}
    new = [slot for slot in richer.slots() if slot.name not in inside and slot.parameter.simpler is not None]
    assert new
    # The roughness of a diffuse part, and what lends its name to a part that is there already, are told apart by where they stand.
    wi, wo = scattered(200, 1)
    at = richer.with_parameters({slot.name: slot.parameter.simpler for slot in new})
    np.testing.assert_allclose(at.eval(wi, wo), simpler.eval(wi, wo), rtol=within, atol=1e-12)


def test_what_is_nearer_is_taken_and_nothing_else() -> None:
    data = simulated()
    problem = prepare(data, f"dust_layer({FACETS})", WISHES).problem
    base = motes.OrenNayar(K_d=0.4, sigma_d=0.2) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.2)
    at = nearer(problem, [Found.of(base)], np.inf)
    assert at is not None
    off = (base.eval(data.wi, data.wo) - data.values[0]) * data.wi[:, 2:]
    objective = 0.5 * float(np.sum(off**2))
    assert problem.normal(at[None]).objective[0] == pytest.approx(objective, rel=1e-9)
    assert nearer(problem, [Found.of(base)], 0.999 * objective) is None
    # Without the simpler values the layer is there, and its base is not what was found.
    assert problem.normal(carried(problem, Found.of(base))[None]).objective[0] != pytest.approx(objective, rel=1e-3)


def test_richer_candidates_end_no_farther_from_the_data() -> None:
    models = list(dict.fromkeys(text for pair in PAIRS for text in pair))
    rungs = {rung.text: rung.objective for rung in climb(simulated(), WISHES, models=models)}
    assert list(rungs) == models
    for richer, simpler in PAIRS:
        assert rungs[richer] <= (1 + 1e-6) * rungs[simpler], richer


def test_compared_models_and_a_layer_alone_end_no_farther_from_the_data() -> None:
    data = simulated(5)
    found = {
        row.fit.model_text: row.fit for row in motes.compare(data, [RISING, FACETS, "lambert + torrance_sparrow"]).rows
    }
    objective = {text: fit.metrics["objective"] for text, fit in found.items()}
    assert objective[RISING] <= (1 + 1e-6) * objective[FACETS]
    assert objective[FACETS] <= (1 + 1e-6) * objective["lambert + torrance_sparrow"]
    layer, base = (motes.fit(data, text).metrics["objective"] for text in (f"dust_layer({COAT})", COAT))
    assert layer <= (1 + 1e-6) * base
