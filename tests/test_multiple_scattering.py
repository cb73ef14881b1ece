"""All orders of scattering in dust: against discrete ordinates, closed forms, limits, and what physics allows."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from catalogue import upper_directions
from motes.arrays import NUMPY
from motes.directions import from_spherical
from motes.errors import ParameterError
from motes.material import Material, load
from motes.models import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow, describe, parse
from motes.models.multiple_scattering import Diffused
from motes.models.slants import Slant

GOLDEN = Path(__file__).parent.parent.parent / "shared/golden/dust_layer_exact.csv"
needs_golden = pytest.mark.skipif(not GOLDEN.is_file(), reason="../shared/golden/dust_layer_exact.csv is not there")
PAINT = OrenNayar((0.5, 0.3, 0.2), 0.4) + TorranceSparrow(0.2, 0.1)
Floats = NDArray[np.float64]


def layer(base: BRDF | float, tau: object, w: object, g: object, scattering: str = "multiple") -> DustLayer:
    return DustLayer(Lambert(base) if isinstance(base, float) else base, Dust(w, g), tau, scattering)


@pytest.fixture(scope="module")
def rows() -> NDArray[np.void]:
    return np.genfromtxt(GOLDEN, delimiter=",", names=True)


@needs_golden
def test_the_brdf_of_discrete_ordinates(rows: NDArray[np.void]) -> None:
    """Up to 80 degrees: half of the rows within 0.1 %, 95 % within 1.5 %, all within 6 %."""
    model = layer(Lambert(rows["base"][:, None]), rows["tau"], rows["w"][:, None], rows["g"])
    wi, wo = from_spherical(rows["theta_i"], 0 * rows["theta_i"]), from_spherical(rows["theta_r"], rows["dphi"])
    error = np.abs(np.asarray(model.eval(wi, wo))[:, 0] / rows["brdf"] - 1)
    error = error[np.maximum(rows["theta_i"], rows["theta_r"]) <= np.radians(80)]
    assert np.median(error) < 0.001
    assert np.percentile(error, 95) < 0.015
    assert error.max() < 0.06


@needs_golden
def test_the_albedo_of_discrete_ordinates(rows: NDArray[np.void]) -> None:
    """Half of the rows within 0.05 %, 95 % within 0.5 %, all within 2 %; the worst reflect one per cent of light."""
    model = layer(Lambert(rows["base"][:, None]), rows["tau"], rows["w"][:, None], rows["g"])
    wi = from_spherical(rows["theta_i"], 0 * rows["theta_i"])
    error = np.abs(np.asarray(model.directional_albedo(wi, nodes=(24, 32)))[:, 0] / rows["albedo"] - 1)
    assert np.median(error) < 0.0005
    assert np.percentile(error, 95) < 0.005
    assert np.mean(error > 0.01) < 0.01
    assert error.max() < 0.02


@pytest.mark.parametrize("g", [-0.75, -0.6, 0.0, 0.5, 0.8, 0.85, 0.9])
def test_a_white_furnace(g: float) -> None:
    """White dust over white loses no light: within 0.1 % up to 89.4 degrees, at any thickness.

    By a rule of its own: nodes in the root of the cosine, closer towards the horizon than those of the models' quadrature.
    """
    nodes, weights = np.polynomial.legendre.leggauss(48)
    root, azimuths = 0.5 * (nodes + 1), (np.arange(160) + 0.5) * np.pi / 160
    measure = 2 * np.pi * weights * root**3  # of cos dcos over half a turn
    wo = from_spherical(np.arccos(root**2)[:, None], azimuths)
    wi = from_spherical(np.arccos([0.0105, 0.02, 0.035, 0.06, 0.1, 0.4, 0.7, 1.0]), 0.0)[:, None, None]
    for tau in (0.003, 0.01, 0.1, 0.5, 2.0, 10.0, 100.0, 1e5):
        value = np.asarray(layer(1.0, tau, 1.0, g).eval(wi, wo))[..., 0]
        np.testing.assert_allclose(value.mean(-1) @ measure, 1.0, atol=1e-3, err_msg=f"tau = {tau}")


def test_higher_orders_are_isotropic_half_space() -> None:
    """Chandrasekhar's H functions: w H(i) H(r) / (4 pi (mu_i + mu_r)) for isotropic particles."""
    w = 0.8
    nodes, weights = np.polynomial.legendre.leggauss(80)
    nodes, weights = 0.5 * (nodes + 1), 0.5 * weights
    H = np.ones_like(nodes)
    for _ in range(300):
        H = 1 / (np.sqrt(1 - w) + 0.5 * w * (weights * nodes * H / (nodes[:, None] + nodes)).sum(axis=1))
    i, r = nodes[::8][:, None], nodes[4::8][None]
    exact = w * H[::8][:, None] * H[4::8][None] / (4 * np.pi * (i + r))
    wi, wo = from_spherical(np.arccos(i), 0 * i), from_spherical(np.arccos(r), 1.0 + 0 * r)
    value = np.asarray(Dust(w, 0.0, scattering="multiple").eval(wi, wo))[..., 0]
    steep = np.minimum(i, r) > 0.15
    np.testing.assert_allclose(value[steep], exact[steep], rtol=0.025)


def test_reciprocity_is_exact_and_nothing_negative() -> None:
    rng = np.random.default_rng(7)
    n = 4000
    model = layer(
        OrenNayar(rng.uniform(0, 0.9, (n, 1)), rng.uniform(0, 1, n)), 10 ** rng.uniform(-3, 3, n),
        rng.uniform(0, 1, (n, 1)) ** 0.3, rng.uniform(-0.75, 0.9, n),
    )  # fmt: skip
    wi, wo = upper_directions(n, 1), upper_directions(n, 2)
    there, back = np.asarray(model.eval(wi, wo)), np.asarray(model.eval(wo, wi))
    np.testing.assert_allclose(there, back, rtol=1e-11)
    assert (there >= 0).all()
    slant = Slant.of(NUMPY, wi[:, 2])
    parts = Diffused(NUMPY, model.tau, model.dust.w[:, 0], model.dust.g)
    for share in (parts.escaping(slant), parts.arriving(slant), parts.mean_arriving, parts.mean_returned):
        assert (np.asarray(share) >= 0).all()
        assert (np.asarray(share) <= 1).all()
    dark = layer(TorranceSparrow(1.0, 0.02), model.tau, model.dust.w, model.dust.g)  # 0 but about the mirror direction
    assert (np.asarray(dark.eval(wi, wo)) >= 0).all()


@pytest.mark.parametrize("base", [Lambert(0.5), PAINT, TorranceSparrow(0.8, 0.1)])
def test_black_dust_only_takes_light(base: BRDF) -> None:
    wi, wo = upper_directions(200, 3), upper_directions(200, 4)
    for tau in (0.1, 1.0, 5.0):
        through = np.exp(-tau * (1 / wi[:, 2:] + 1 / wo[:, 2:]))
        np.testing.assert_allclose(layer(base, tau, 0.0, 0.3).eval(wi, wo), base.eval(wi, wo) * through, rtol=1e-12)


def test_without_dust_it_is_the_base_to_the_last_bit() -> None:
    wi, wo = upper_directions(200, 3), upper_directions(200, 4)
    np.testing.assert_array_equal(layer(PAINT, 0.0, 0.9, 0.5).eval(wi, wo), PAINT.eval(wi, wo))


def test_a_thick_layer_is_the_half_space() -> None:
    wi, wo = upper_directions(200, 3), upper_directions(200, 4)
    deep = np.asarray(Dust((0.9, 0.5, 0.99), 0.5, scattering="multiple").eval(wi, wo))
    np.testing.assert_allclose(layer(PAINT, 1e4, (0.9, 0.5, 0.99), 0.5).eval(wi, wo), deep, rtol=2e-3)
    np.testing.assert_allclose(layer(PAINT, float("inf"), (0.9, 0.5, 0.99), 0.5).eval(wi, wo), deep, rtol=1e-9)


def test_a_thin_film_over_black_scatters_once() -> None:
    """The difference goes with tau squared."""
    wi, wo = upper_directions(200, 5), upper_directions(200, 6)
    steep = np.minimum(wi[:, 2], wo[:, 2]) > 0.3
    ratios = []
    for tau in (1e-2, 1e-3):
        once, all_orders = (
            np.asarray(layer(0.0, tau, 0.9, 0.3, k).eval(wi, wo))[steep] for k in ("single", "multiple")
        )
        ratios.append(np.median(all_orders / once - 1))
    assert ratios[1] < 0.15 * ratios[0] < 0.01


def phase(cosine: Floats, g: float) -> Floats:
    return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * cosine) ** 1.5)


def scattered_on(mu: Floats, g: float) -> Floats:
    """The share of light scattered once that goes on downwards, by quadrature over the lower hemisphere."""
    nodes, weights = np.polynomial.legendre.leggauss(64)
    down, azimuths = 0.5 * (nodes + 1), (np.arange(256) + 0.5) / 256 * np.pi
    sines = np.sqrt(1 - mu**2)[:, None, None] * np.sqrt(1 - down**2)[:, None]
    values = phase(mu[:, None, None] * down[:, None] + sines * np.cos(azimuths), g)
    share: Floats = 2 * np.pi * values.mean(axis=2) @ (0.5 * weights)
    return share


@pytest.mark.parametrize("albedo", [0.0, 0.3, 0.8, 1.0])
@pytest.mark.parametrize("g", [-0.5, 0.0, 0.6])
def test_a_thin_film_is_the_first_order_in_tau(albedo: float, g: float) -> None:
    """Over a base light scattered once comes to the viewer on four ways; the rest goes with tau squared, or with tau and what is fitted."""
    w = 0.9
    wi, wo = upper_directions(60, 5), upper_directions(60, 6)
    steep = np.minimum(wi[:, 2], wo[:, 2]) > 0.3
    wi, wo = wi[steep], wo[steep]
    i, r = wi[:, 2], wo[:, 2]
    nodes, weights = np.polynomial.legendre.leggauss(32)
    returned = float(2 * (1 - scattered_on(0.5 * (nodes + 1), g)) @ (0.5 * weights))  # of uniform light, by tau
    body = albedo / np.pi
    first = w * phase(-np.sum(wi * wo, axis=1), g) / (i * r) - body * (1 / i + 1 / r)
    first += body * w * (scattered_on(i, g) / i + scattered_on(r, g) / r) + body * albedo * w * returned
    size = w * phase(-np.sum(wi * wo, axis=1), g) / (i * r) + body * (1 / i + 1 / r)
    off = []
    for tau in (1e-2, 1e-3):
        slope = (np.asarray(layer(albedo, tau, w, g).eval(wi, wo))[:, 0] - body) / tau
        off.append(float(np.median(np.abs(slope - first) / size)))
    assert off[1] < 0.2 * off[0] + 0.003
    assert off[0] < 0.06


def test_white_dust_brightens_a_dark_surface() -> None:
    """The figures of single scattering were 0.20, 0.19, 0.19."""
    wi = np.array([np.sqrt(1 - 0.49), 0, 0.7])
    found = [float(np.asarray(layer(0.2, tau, 1.0, 0.0).directional_albedo(wi))[0]) for tau in (0.2, 1.0, 5.0)]
    np.testing.assert_allclose(found, [0.28, 0.49, 0.80], atol=0.01)


def test_a_base_that_reflects_more_than_it_receives_is_finite() -> None:
    wi, wo = upper_directions(100, 1), upper_directions(100, 2)
    assert np.isfinite(layer(Lambert(3.0), 2.0, 1.0, 0.5).eval(wi, wo)).all()


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: layer(0.5, 0.3, 1.2, 0.0), r"w = 1.2 is outside \[0, 1\]"),
        (lambda: layer(0.5, 0.3, (0.5, 1.5, 0.4), 0.0), r"w = 1.5 is outside"),
        (lambda: layer(0.5, 0.3, 0.5, 0.95), r"g = 0.95 is outside \[-0.75, 0.9\]"),
        (lambda: layer(0.5, float("nan"), 0.5, 0.5), "tau = nan"),
        (lambda: Dust(1.1, scattering="multiple"), "w = 1.1"),
        (lambda: Dust(0.5, form="brightness", scattering="multiple"), "as printed, which knows one scattering"),
        (lambda: DustLayer(Lambert(0.5), Dust(0.5, scattering="multiple"), 0.1), "a bed without an end"),
        (lambda: layer(0.5, 0.3, 0.5, 0.0, "twice"), "is not one of single, multiple"),
    ],
)
def test_what_cannot_be_is_refused(make: object, words: str) -> None:
    with pytest.raises(ParameterError, match=words) as caught:
        make()  # type: ignore[operator]
    assert caught.value.hint or "is not one of" in words


def test_the_bounds_are_those_of_particles() -> None:
    for model in (layer(0.5, 0.3, 0.5, 0.0), Dust(0.5, scattering="multiple")):
        bounds = {slot.name: slot.parameter.bounds for slot in model.slots()}
        assert bounds["w"] == (0, 1)
        assert bounds["g"] == (-0.75, 0.9)
    assert {s.name: s.parameter.bounds for s in layer(0.5, 0.3, 0.5, 0.0, "single").slots()}["w"][1] == np.inf


def test_texts_and_files_carry_the_form(tmp_path: Path) -> None:
    text = "dust_layer(oren_nayar, scattering=multiple)"
    model = parse(text).model
    assert isinstance(model, DustLayer)
    assert model.scattering == "multiple"
    assert parse(describe(model)).model == model
    path = Material(model, "a").save(tmp_path / "a.json")
    assert load(path).brdf == model
    old = parse("dust_layer(oren_nayar)").model
    assert isinstance(old, DustLayer)
    assert old.scattering == "single"


def test_a_fit_finds_what_it_was_made_of() -> None:
    truth = layer(OrenNayar((0.5, 0.3, 0.2), 0.3), 0.6, (0.95, 0.9, 0.8), 0.5)
    rng = np.random.default_rng(1)
    theta, phi = np.radians(rng.uniform(0, 75, (2, 400))), rng.uniform(0, 2 * np.pi, 400)
    wi, wo = from_spherical(theta[0], 0 * phi), from_spherical(theta[1], phi)
    values = np.asarray(truth.eval(wi, wo)) * (1 + 0.01 * rng.standard_normal((400, 3)))
    fit = motes.fit(
        motes.measurements.Measurement.from_arrays(wi, wo, values), "dust_layer(oren_nayar, scattering=multiple)"
    )
    for name, value in truth.parameters.items():
        found = fit.parameters[name]
        assert np.all(np.abs(np.asarray(found.value) - value) <= 4 * np.asarray(found.stderr)), name
