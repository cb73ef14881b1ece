"""Light that facets pass on to each other: what is missing, white furnaces, a random walk on facets, colours, and dust on top."""

from __future__ import annotations

from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

import motes
from catalogue import dense_albedo, direction, fresnel, upper_directions
from facet_walk import walk, white
from golden import published
from motes.arrays import NUMPY
from motes.errors import ParameterError
from motes.models import (
    GGX,
    Beckmann,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Fresnel,
    Lambert,
    Reflection,
    Schlick,
    parse,
)
from motes.models.compensated import RegainedLobe
from motes.models.missing_energy import BECKMANN_MISSING, GGX_MISSING, MissingEnergy

Floats = NDArray[np.float64]
FACETS = {"ggx": GGX, "beckmann": Beckmann}
MISSING: dict[str, MissingEnergy] = {"ggx": GGX_MISSING, "beckmann": BECKMANN_MISSING}
#: What docs and constants state: of the missing energy, and of a white furnace.
STATED = {"ggx": (0.0008, 0.001), "beckmann": (0.003, 0.004)}
ROUGH = (0.001, 0.01, 0.06, 0.2, 0.45, 0.75, 1.0)
COSINES = (0.002, 0.02, 0.1, 0.25, 0.5, 0.75, 1.0)

# ---------------------------------------------------------------- What is missing


def test_what_is_missing_of_the_roughest_ggx() -> None:
    """At alpha = 1 its facets are those of a ball's upper half, and the integral is mu ln(1 + 1/mu)."""
    mu = np.array(COSINES)
    assert_allclose(GGX_MISSING(NUMPY, mu, 1.0), mu * np.log1p(1 / mu), atol=8e-4)
    assert_allclose(1 - GGX(1.0, 1.0).directional_albedo(direction(np.arccos(0.5)))[0], 0.5 * np.log(3), atol=1e-4)


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("alpha", [0.1, 0.5, 1.0])
def test_what_is_missing_is_what_one_reflection_leaves(name: str, alpha: float) -> None:
    """Against a dense rule over directions, where the formula was fitted to a sum over facets."""
    for cosine in (0.1, 0.3, 0.9):
        left = 1 - dense_albedo(FACETS[name](1.0, alpha), direction(np.arccos(cosine)), 80)
        assert_allclose(MISSING[name](NUMPY, cosine, alpha), left, atol=STATED[name][0] + 1e-4)


@pytest.mark.parametrize("name", FACETS)
def test_the_mean_of_what_is_missing(name: str) -> None:
    """By a rule in steps of alpha; an error of it counts by as much as is missing."""
    x, w = np.polynomial.legendre.leggauss(80)
    for alpha in ROUGH:
        ends = [0.0, *(min(k * alpha, 1.0) for k in (1, 3, 10)), 1.0]
        nodes = np.concatenate([a + 0.5 * (b - a) * (x + 1) for a, b in pairwise(ends)])
        weights = np.concatenate([(b - a) * w for a, b in pairwise(ends)])
        missing = MISSING[name](NUMPY, nodes, alpha)
        assert missing.min() >= 0
        exact = np.sum(missing * nodes * weights)
        assert abs(MISSING[name].mean(NUMPY, alpha) / exact - 1) * missing.max() < 0.001


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("alpha", ROUGH)
def test_a_white_furnace(name: str, alpha: float) -> None:
    """With F = 1 and K_s = 1 all light comes back, from anywhere, at any roughness: within what is stated, and the quadrature's 0.0003."""
    wi = np.array([direction(np.arccos(cosine)) for cosine in COSINES])
    albedo = FACETS[name](1.0, alpha, scattering="multiple").directional_albedo(wi, nodes=(80, 80))
    assert_allclose(albedo, 1.0, atol=STATED[name][1] + 3e-4)
    once = FACETS[name](1.0, alpha).directional_albedo(wi, nodes=(80, 80))
    assert once.min() < 1 - 0.04  # it would not be one


# ---------------------------------------------------------------- A random walk


TERMS = (Schlick(0.5), Dielectric(1.5), Schlick(0.9), Conductor(0.2, 3.0))


def reflectances(cosine: Floats) -> Floats:
    return np.stack([term.reflectance(NUMPY, cosine) for term in TERMS], -1)


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("alpha", [0.2, 0.5, 1.0])
def test_the_albedo_is_that_of_a_walk(name: str, alpha: float) -> None:
    """A walk among facets leaves after one of them as often as single scattering says, of which it knows nothing, and what comes back is within
    0.03 of it, of metals within 0.01; single scattering alone is up to 0.55 off."""
    for cosine in (0.1, 0.4, 0.95):
        wi = direction(np.arccos(cosine))
        found = walk(name, alpha, np.full(12_000, cosine), reflectances, np.random.default_rng(1))
        assert found.out[:, 2].min() > 0
        assert_allclose(np.mean(found.met == 1), FACETS[name](1.0, alpha).directional_albedo(wi)[0], atol=0.013)
        for term, share, close in zip(TERMS, found.left.mean(axis=0), (0.03, 0.03, 0.012, 0.012), strict=True):
            model = FACETS[name](1.0, alpha, term, "multiple")
            assert_allclose(model.directional_albedo(wi)[0], share, atol=close)


@pytest.mark.parametrize("name", FACETS)
def test_what_stays_is_what_a_walk_meets_again(name: str) -> None:
    """Of uniform light: the share that meets a second facet, and of that the share that meets a third, and so on."""
    rng = np.random.default_rng(2)
    for alpha in (0.4, 0.9):
        found = walk(name, alpha, np.sqrt(rng.random(20_000)), white, rng)
        assert found.left.min() == 1.0
        assert_allclose(np.mean(found.met > 1), MISSING[name].mean(NUMPY, alpha), atol=0.01)
        again = found.met[found.met > 1] - 1
        assert_allclose(1 - 1 / again.mean(), MISSING[name].staying(NUMPY, alpha), atol=0.025)


# ---------------------------------------------------------------- Colour, and what it is a part of


def test_mean_reflectances() -> None:
    """Over uniform light: of metals and glass within 0.0005, of Schlick's curve exactly."""
    n, k = np.array([0.14, 0.37, 1.4, 3.0]), np.array([4.0, 2.4, 1.9, 3.5])

    def exact(n: complex) -> float:
        return float(mp.quad(lambda mu: 2 * mu * fresnel(np.array([float(mu)]), n)[0], [0, 0.05, 0.3, 1]))

    assert_allclose(Conductor(n, k).mean(NUMPY), [exact(a + 1j * b) for a, b in zip(n, k, strict=True)], atol=5e-4)
    glass = np.array([1.1, 1.5, 2.5])
    assert_allclose(Dielectric(glass).mean(NUMPY), published.mean_fresnel(glass), atol=5e-4)
    schlick = Schlick(0.3)
    exactly = mp.quad(lambda mu: 2 * mu * (mp.mpf("0.3") + mp.mpf("0.7") * (1 - mu) ** 5), [0, 1])
    assert_allclose(schlick.mean(NUMPY), float(exactly), rtol=1e-14)


@pytest.mark.parametrize("name", FACETS)
def test_reciprocal_brighter_and_more_saturated(name: str) -> None:
    wi, wo = upper_directions(300, 1), upper_directions(300, 2)
    term = Schlick((0.9, 0.4))
    once, more = (FACETS[name]((0.8, 0.8), 0.7, term, scattering) for scattering in ("single", "multiple"))
    assert_allclose(more.eval(wi, wo), more.eval(wo, wi), rtol=1e-12)
    added = more.eval(wi, wo) - once.eval(wi, wo)
    assert np.all(added >= 0)
    # Reflected twice and more, colours multiply.
    assert np.all(added[:, 1] < added[:, 0] * 0.4)
    assert_allclose(FACETS[name](0.4, 0.7, term, "multiple").eval(wi, wo), 0.5 * more.eval(wi, wo), rtol=1e-12)


@pytest.mark.parametrize("name", FACETS)
@pytest.mark.parametrize("term", [None, Dielectric(1.5), Conductor(0.2, 3.0)])
def test_what_it_says_that_it_reflects(name: str, term: Fresnel | None) -> None:
    """The formula for what lies below a layer, against the integral; of the mean over uniform light as a standard lobe."""
    for alpha in (0.1, 0.4, 0.7):
        model = FACETS[name](0.9, alpha, term, "multiple")
        for cosine in (0.3, 0.9):
            whole = model.directional_albedo(direction(np.arccos(cosine)))[0]
            assert_allclose(model.reflected(NUMPY, cosine), whole, atol=0.03)
        diffuse = [lobe for lobe in model.standard_lobes(NUMPY, model, 0.6) if lobe.reflection is Reflection.DIFFUSE]
        again = model.spherical_albedo() - FACETS[name](0.9, alpha, term).spherical_albedo()
        assert_allclose([lobe.reflectance for lobe in diffuse], again, atol=1.2e-3)


@pytest.mark.parametrize("alpha", [0.005, 0.1, 0.8])
def test_the_lobe_of_what_comes_back(alpha: float) -> None:
    """Its density is that of its samples, by the share of them below a cosine, and no weight of it is large."""
    lobe, u = RegainedLobe(alpha), np.random.default_rng(3).random((50_000, 2))
    wi = np.broadcast_to(direction(0.3), (len(u), 3))
    wo = lobe.sample(NUMPY, wi, u)
    z = np.sort(wo[:, 2])
    c = 9 * alpha * alpha
    assert_allclose(np.log1p(z * z / c) / np.log1p(1 / c), (np.arange(len(z)) + 0.5) / len(z), atol=0.01)
    x, w = np.polynomial.legendre.leggauss(200)
    mu = (0.5 * (x + 1)) ** 3
    at = np.stack([np.sqrt(1 - mu * mu), 0 * mu, mu], -1)
    assert_allclose(np.sum(2 * np.pi * lobe.pdf(NUMPY, at, at) * 3 * (0.5 * (x + 1)) ** 2 * 0.5 * w), 1.0, rtol=1e-6)
    for name, missing in MISSING.items():
        weight = missing(NUMPY, mu, alpha) * mu / (np.pi * missing.mean(NUMPY, alpha) * lobe.pdf(NUMPY, at, at))
        assert weight.max() < (3.0 if name == "ggx" else 20.0)


# ---------------------------------------------------------------- Texts, fits, dust


def test_texts_and_words() -> None:
    model = GGX(0.8, 0.3, Schlick(0.5), "multiple")
    assert parse("ggx(scattering=multiple)").model == GGX(scattering="multiple")
    assert motes.models.describe(model) == "ggx(fresnel=schlick, scattering=multiple)"
    assert model.in_words() == "compensated GGX with Schlick Fresnel"
    assert motes.models.describe(GGX()) == "ggx"
    with pytest.raises(ParameterError, match="scattering"):
        GGX(scattering="twice")


def test_a_fit_finds_it_again_and_single_scattering_does_not() -> None:
    wi, wo = upper_directions(300, 5), upper_directions(300, 6)
    truth = Lambert(0.1) + GGX(0.8, 0.7, scattering="multiple")
    data = motes.Measurement.from_arrays(wi, wo, truth.eval(wi, wo))
    fit = motes.fit(data, "lambert + ggx(scattering=multiple)", errors="independent")
    for name, value in truth.parameters.items():
        assert_allclose(fit.parameters[name].value, value, rtol=1e-4)


def test_dust_lies_on_it_as_on_a_highlight_and_something_diffuse() -> None:
    """Without dust it is the bare base; white dust on white facets loses next to nothing; and the layer is nearly that with a Lambertian part
    of the same mean in the place of what comes back."""
    wi, wo = upper_directions(200, 1), upper_directions(200, 2)
    dust, base = Dust(1.0, 0.5), GGX(1.0, 0.6, scattering="multiple")
    assert_allclose(DustLayer(base, dust, 0.0, "multiple").eval(wi, wo), base.eval(wi, wo), rtol=1e-6, atol=1e-9)
    again = GGX(1.0, 0.6) + Lambert(float(GGX_MISSING.mean(NUMPY, 0.6)))
    for cosine in (0.3, 0.9):
        at = direction(np.arccos(cosine))
        white = DustLayer(GGX(1.0, 0.2, scattering="multiple"), dust, 0.5, "multiple")
        assert_allclose(white.directional_albedo(at), 1.0, atol=0.02)
        found, other = (DustLayer(below, dust, 1.0, "multiple").directional_albedo(at) for below in (base, again))
        assert_allclose(found, other, atol=0.04)
    once, further = base.pieces()
    assert once.spread() is not None
    assert further.spread() is None
    assert not further.leans()
