"""Properties of the models: each runs on every entry of the catalogue."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal
from numpy.typing import NDArray

import golden
from catalogue import ENTRIES, SPECIAL, SPECIAL_WI, SPECIAL_WO, Entry, dense_albedo, direction, parts, upper_directions
from motes.errors import DataError, ParameterError
from motes.kernels import engine
from motes.models import BRDF, Dust, DustLayer, Fresnel, Lambert, OrenNayar, Sum, TorranceSparrow, registered
from motes.parameters import Parameter, Parametrised, Role

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)


@pytest.fixture(autouse=True)
def by_the_equations(monkeypatch: pytest.MonkeyPatch) -> None:
    """These tests are about the formulas over NumPy; the tests of the engine compare the engine with them."""
    monkeypatch.setattr(engine, "THRESHOLD", 10**18)


# ---------------------------------------------------------------- The catalogue is complete


def subclasses(cls: type) -> Iterator[type]:
    for sub in cls.__subclasses__():
        yield sub
        yield from subclasses(sub)


@pytest.mark.parametrize("base", [BRDF, Fresnel])
def test_every_class_has_an_entry(base: type) -> None:
    # What other rooms derive for their own use (the place of a nested BSDF under dust) is no model; the surfaces of other
    # programs are as those have them, neither reciprocal nor conserving all, and tests/test_exports_surfaces.py holds them.
    concrete = {
        cls
        for cls in subclasses(base)
        if not cls.__abstractmethods__
        and cls.__module__.startswith("motes.models.")
        and not cls.__module__.startswith("motes.models.surfaces.")
    }
    assert concrete
    assert concrete <= {type(part) for entry in ENTRIES for part in parts(entry.model)}


def test_every_name_of_an_expression_has_an_entry() -> None:
    assert set(registered(Parametrised).values()) <= {type(part) for entry in ENTRIES for part in parts(entry.model)}


def test_every_option_has_an_entry() -> None:
    options = {option for entry in ENTRIES for part in parts(entry.model) for option in part.options().items()}  # type: ignore[attr-defined]
    assert {
        ("form", "brdf"),
        ("form", "brightness"),
        ("normalization", "printed"),
        ("normalization", "facets"),
    } <= options


# ---------------------------------------------------------------- Values


@pytest.mark.parametrize("source", golden.SOURCES)
@every_entry
def test_values_end_to_end(entry: Entry, source: str) -> None:
    """From directions to the value, against 50-digit arithmetic (and closed forms on top of it, for what the table has not)."""
    rows = golden.appendices(source)
    model, expected = entry.at_rows(rows)
    assert_allclose(model.eval(rows["wi"], rows["wo"])[:, 0], expected, rtol=1e-9, atol=1e-300)


@pytest.mark.parametrize("source", golden.SOURCES)
@pytest.mark.parametrize(
    ("name", "model"),
    [
        ("torrance_sparrow", lambda parameter: TorranceSparrow(1.0, parameter)),
        ("dust", lambda parameter: Dust(1.0, parameter)),
    ],
)
def test_values_of_scatmech(name: str, model: Any, source: str) -> None:
    rows = golden.scatmech(source, name)
    assert_allclose(model(rows["parameter"]).eval(rows["wi"], rows["wo"])[:, 0], rows["value"], rtol=1e-11, atol=1e-300)


def test_oren_nayar_is_clamped_at_0_where_equation_1_is_negative() -> None:
    wi, wo = direction(1.5), direction(1.55, np.pi)
    assert_array_equal(
        OrenNayar((0.1, 0.2, 0.9), 1.5).eval(wi, wo) > 0, [False, False, True]
    )  # (7) outweighs it for a white one
    assert_array_equal(OrenNayar(0.2, 1.5).eval(wi, wo), [0.0])


# ---------------------------------------------------------------- Shapes and types


@pytest.mark.parametrize(
    ("wi", "wo", "leading"),
    [
        ((), (), ()),
        ((5,), (), (5,)),
        ((), (5,), (5,)),
        ((4, 1), (5,), (4, 5)),
        ((1,), (1,), (1,)),
        ((2, 1, 3), (4, 1), (2, 4, 3)),
        ((0,), (), (0,)),
    ],
)
@every_entry
def test_shapes_broadcast(entry: Entry, wi: tuple[int, ...], wo: tuple[int, ...], leading: tuple[int, ...]) -> None:
    a = upper_directions(int(np.prod(wi)), 1).reshape(*wi, 3)
    b = upper_directions(int(np.prod(wo)), 2).reshape(*wo, 3)
    value = entry.model.eval(a, b)
    assert value.shape == (*leading, entry.model.channels)
    wide_a, wide_b = (np.broadcast_to(w, (*leading, 3)).reshape(-1, 3) for w in (a, b))
    one_by_one = [entry.model.eval(x, y) for x, y in zip(wide_a, wide_b, strict=True)]
    assert_allclose(
        value.reshape(-1, entry.model.channels), np.reshape(one_by_one, (-1, entry.model.channels)), rtol=1e-13
    )
    assert entry.model.pdf(a, b).shape == leading


@every_entry
def test_parameters_with_leading_axes_are_many_models_at_once(entry: Entry) -> None:
    rng = np.random.default_rng(3)
    factors = {slot.name: rng.uniform(0.8, 1.0, 6) for slot in entry.model.slots()}
    stacked, single = {}, [{} for _ in range(6)]  # type: ignore[var-annotated]
    for slot in entry.model.slots():
        values = [np.asarray(slot.value) * f for f in factors[slot.name]]
        if slot.parameter.name == "n":
            values = [np.maximum(v, 1.05) for v in values]
        stacked[slot.name] = np.reshape(values, (6, -1)) if slot.parameter.per_channel else np.array(values)
        for k, value in enumerate(values):
            single[k][slot.name] = value
    many = entry.model.with_parameters(stacked)
    wi, wo, u = upper_directions(6, 4), upper_directions(6, 5), rng.random((6, 2))
    each = [entry.model.with_parameters(values) for values in single]
    assert_allclose(many.eval(wi, wo), [m.eval(a, b) for m, a, b in zip(each, wi, wo, strict=True)], rtol=1e-13)
    assert_allclose(many.pdf(wi, wo), [m.pdf(a, b) for m, a, b in zip(each, wi, wo, strict=True)], rtol=1e-12)
    assert_allclose(
        many.directional_albedo(wi), [m.directional_albedo(a) for m, a in zip(each, wi, strict=True)], rtol=1e-11
    )
    sampled = many.sample(wi, u)
    for k, model in enumerate(each):
        one = model.sample(wi[k], u[k])
        for a, b in zip(sampled, one, strict=True):
            assert_allclose(a[k], b, rtol=1e-9, atol=1e-12)


def test_directional_albedo_of_many_models_comes_in_parts() -> None:
    """More than 256 of them, with leading axes of the directions, of a shared and of a per-channel parameter."""
    K_d, sigma_d = np.linspace(0.1, 0.9, 60).reshape(20, 1, 3), np.linspace(0, 1, 15)
    wi = upper_directions(15, 6)
    many = OrenNayar(K_d, sigma_d).directional_albedo(wi, nodes=(8, 8))
    assert many.shape == (20, 15, 3)
    for j, k in ((0, 0), (19, 14), (7, 3)):
        assert_allclose(
            many[j, k], OrenNayar(K_d[j, 0], sigma_d[k]).directional_albedo(wi[k], nodes=(8, 8)), rtol=1e-12
        )


@every_entry
def test_float32_in_is_float32_out(entry: Entry) -> None:
    wi, wo = upper_directions(7, 1).astype(np.float32), upper_directions(7, 2).astype(np.float32)
    u = np.random.default_rng(3).random((7, 2), np.float32)
    arrays = {
        slot.name: np.atleast_1d(np.asarray(slot.value)) if slot.parameter.per_channel else slot.value
        for slot in entry.model.slots()
    }
    narrow = {name: np.asarray(value, np.float32) for name, value in arrays.items()}
    for model in (entry.model, entry.model.with_parameters(arrays), entry.model.with_parameters(narrow)):
        results = {
            "eval": model.eval(wi, wo),
            "pdf": model.pdf(wi, wo),
            "albedo": model.directional_albedo(wi, nodes=(4, 4)),
        }
        results |= model.sample(wi, u)._asdict()
        assert {name: value.dtype for name, value in results.items()} == dict.fromkeys(results, np.dtype(np.float32))


@every_entry
def test_lists_and_whole_numbers_are_directions_too(entry: Entry) -> None:
    assert_array_equal(
        entry.model.eval([0, 0, 1], [[0, 0, 1]]), entry.model.eval(np.array([0.0, 0, 1]), np.array([[0.0, 0, 1]]))
    )


@every_entry
def test_channels_are_independent(entry: Entry) -> None:
    """Each channel is the model with that channel's parameters."""
    wi, wo = upper_directions(20, 1), upper_directions(20, 2)
    value = entry.model.eval(wi, wo)
    for c in range(entry.model.channels):
        one = {s.name: s.value[..., c] for s in entry.model.slots() if np.ndim(s.value) and np.shape(s.value)[-1] > 1}
        assert_allclose(entry.model.with_parameters(one).eval(wi, wo)[:, 0], value[:, c], rtol=1e-14)


@pytest.mark.parametrize(
    ("wi", "wo", "model"),
    [
        (np.zeros((2, 3)), np.zeros((3, 3)), Lambert()),
        (np.zeros((4, 3)), np.zeros((4, 3)), OrenNayar(np.ones((5, 3)))),
        (np.zeros(2), np.zeros(3), Lambert()),
        (1.0, [0, 0, 1], Lambert()),
        (["x", "y", "z"], [0, 0, 1], Lambert()),
        ([[0, 0, 1], [0, 1]], [0, 0, 1], Lambert()),
    ],
)
def test_what_is_no_direction_is_refused(wi: Any, wo: Any, model: BRDF) -> None:
    with pytest.raises(DataError):
        model.eval(wi, wo)


def test_channels_that_disagree_are_refused() -> None:
    with pytest.raises(ParameterError, match=r"K_d has 3, K_s has 2\. .*one value"):
        OrenNayar((0.1, 0.2, 0.3)) + TorranceSparrow((0.1, 0.2))


def test_only_models_add_up() -> None:
    with pytest.raises(ParameterError, match="Sum: b = 1 is not a BRDF"):
        Sum(Lambert(), 1)  # type: ignore[arg-type]
    with pytest.raises(TypeError):
        Lambert() + 1  # type: ignore[operator]


# ---------------------------------------------------------------- Symmetry and energy


@every_entry
def test_reciprocity_where_declared(entry: Entry) -> None:
    wi, wo = upper_directions(2000, 1), upper_directions(2000, 2)
    forth, back = entry.model.eval(wi, wo), entry.model.eval(wo, wi)
    assert entry.model.reciprocal is entry.reciprocal
    if entry.reciprocal:
        assert_allclose(forth, back, rtol=1e-12)
    else:
        assert np.abs(forth / back - 1).max() > 0.1


@every_entry
def test_isotropy(entry: Entry) -> None:
    """Turning both directions about the normal changes nothing."""
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    c, s = np.cos(2.1), np.sin(2.1)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    assert_allclose(entry.model.eval(wi @ turn.T, wo @ turn.T), entry.model.eval(wi, wo), rtol=1e-10, atol=1e-300)


@pytest.mark.parametrize(("theta_i", "tolerance"), [(0.0, 5e-4), (1.0, 5e-4), (1.45, 5e-4), (1.55, 2e-3)])
@every_entry
def test_directional_albedo_is_the_integral(entry: Entry, theta_i: float, tolerance: float) -> None:
    """The largest errors are 1.1e-4 up to 1.45 rad, at wide highlights and dust, and 1.8e-3 at 1.55 rad (docs/accuracy.md)."""
    wi = direction(theta_i, 0.4)
    unit = 4 * np.pi if not entry.reciprocal else 1.0  # what equation (12) lacks
    assert_allclose(entry.model.directional_albedo(wi), dense_albedo(entry.model, wi), rtol=0, atol=tolerance * unit)


@pytest.mark.parametrize("theta_i", [0.0, 0.5, 1.2])
@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.directional], ids=str)
def test_known_directional_albedos(entry: Entry, theta_i: float) -> None:
    assert entry.directional is not None
    if np.cos(theta_i) >= entry.where:
        expected = entry.directional(np.cos(theta_i))
        assert_allclose(dense_albedo(entry.model, direction(theta_i)), expected, rtol=1e-4)
        assert_allclose(entry.model.directional_albedo(direction(theta_i)), expected, rtol=6e-4)


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.spherical], ids=str)
def test_known_spherical_albedos(entry: Entry) -> None:
    assert entry.spherical is not None
    expected, tolerance = entry.spherical
    assert_allclose(entry.model.spherical_albedo(), [expected], atol=max(tolerance, 2e-5), rtol=0)


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.at_most], ids=str)
def test_no_more_light_leaves_than_arrives(entry: Entry) -> None:
    """Of uniform light, with every reflectance at its largest, 1."""
    assert entry.at_most is not None
    of_light = (Role.DIFFUSE_COLOUR, Role.HIGHLIGHT_STRENGTH, Role.SINGLE_SCATTERING_ALBEDO)
    white = {slot.name: 1.0 for slot in entry.model.slots(*of_light)}
    albedo = entry.model.with_parameters(white).spherical_albedo()
    assert np.all(albedo <= entry.at_most)
    assert np.all(albedo >= 0.03)


@pytest.mark.parametrize("sigma_s", [0.05, 0.2, 0.5, 1.0, np.pi / 2])
def test_normalised_facets_return_no_more_than_all_light_from_anywhere(sigma_s: float) -> None:
    model = TorranceSparrow(1.0, sigma_s, normalization="facets")
    for theta_i in (0.0, 0.7, 1.3, 1.5):
        assert dense_albedo(model, direction(theta_i))[0] <= 1 + 1e-5


@every_entry
def test_nothing_is_negative(entry: Entry) -> None:
    assert entry.model.eval(upper_directions(5000, 1), upper_directions(5000, 2)).min() >= 0


# ---------------------------------------------------------------- The horizon, NaN, extremes


@every_entry
def test_exactly_0_at_and_below_the_horizon(entry: Entry) -> None:
    up, flat = direction(0.4), np.array([1.0, 0.0, 0.0])
    for wi, wo in (
        (up, -up),
        (-up, up),
        (-up, -up),
        (flat, up),
        (up, flat),
        (flat, flat),
        (up, np.array([0.6, 0.8, -0.0])),
    ):
        assert_array_equal(entry.model.eval(wi, wo), np.zeros(entry.model.channels))
        assert_array_equal(entry.model.pdf(wi, wo), 0.0)


@every_entry
def test_no_number_of_directions_makes_other_lengths_pass(entry: Entry, monkeypatch: pytest.MonkeyPatch) -> None:
    """What is far from a unit vector is refused, by the equations and by the engine alike; printed digits are not."""
    up = direction(0.4)
    for threshold in (1, 10**18):
        monkeypatch.setattr(engine, "THRESHOLD", threshold)
        for length in (1e200, -1e200, 1e160, 5.0):
            for wi, wo in ((up * length, up), (up, up * length), (np.stack([up, np.full(3, np.nan), up * length]), up)):
                with pytest.raises(DataError, match=r"component of .* unit vectors"):
                    entry.model.eval(wi, wo)
    assert np.isfinite(entry.model.eval(up * 1.0009, up)).all()


@every_entry
def test_nan_stays_nan(entry: Entry) -> None:
    up, nan = direction(0.4), np.full(3, np.nan)
    for wi, wo in ((nan, up), (up, nan), (nan, nan)):
        assert np.isnan(entry.model.eval(wi, wo)).all()
        assert np.isnan(entry.model.pdf(wi, wo)).all()
    mixed = entry.model.eval(np.stack([up, nan, up]), up)
    assert_array_equal(np.isnan(mixed).all(axis=-1), [False, True, False])


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@every_entry
def test_special_directions_give_numbers(entry: Entry, dtype: type) -> None:
    wi, wo = SPECIAL_WI.astype(dtype), SPECIAL_WO.astype(dtype)
    value = entry.model.eval(wi, wo)
    assert dict(zip(SPECIAL, np.isfinite(value).all(axis=-1), strict=True)) == dict.fromkeys(SPECIAL, True)
    assert np.isfinite(entry.model.pdf(wi, wo)).all()
    assert np.isfinite(entry.model.directional_albedo(wi, nodes=(6, 6))).all()
    for u in ([0.0, 0.0], [0.5, 0.25], [1 - 2.0**-24, 1 - 2.0**-24]):
        for part in entry.model.sample(wi, np.array(u, dtype)):
            assert np.isfinite(part).all()


def within(p: Parameter) -> st.SearchStrategy[float]:
    """Anything that the declaration accepts, the bounds themselves with preference; 1e6 for infinity, and what float32 can tell from an open bound."""
    low, high = (float(np.clip(b, -1e6, 1e6)) for b in p.bounds)
    if p.open:
        low, high = low + 1e-6, high - 1e-6
    return st.sampled_from([low, high, p.default]) | st.floats(low, high)


@st.composite
def extreme_directions(draw: st.DrawFn) -> NDArray[np.float64]:
    theta = draw(
        st.sampled_from(
            [0.0, 1e-300, 1e-12, 1e-4, np.pi / 4, np.pi / 2, np.nextafter(np.pi / 2, 0), np.pi / 2 - 1e-7, 3.0, np.pi]
        )
        | st.floats(0, np.pi)
    )
    return direction(theta, draw(st.sampled_from([0.0, np.pi / 2, np.pi, -np.pi]) | st.floats(-4, 4)))


@given(data=st.data())
@every_entry
def test_numbers_everywhere(entry: Entry, data: st.DataObject) -> None:
    """No NaN and nothing negative at any parameters within bounds, in any directions: retro, mirror, grazing, normal, below."""
    model = entry.model.with_parameters({slot.name: data.draw(within(slot.parameter)) for slot in entry.model.slots()})
    wi = data.draw(extreme_directions())
    mirror = np.array([-wi[0], -wi[1], wi[2]])
    wo = data.draw(st.sampled_from([wi, mirror, -wi]) | extreme_directions())
    u = np.array(data.draw(st.tuples(*[st.floats(0, 1, exclude_max=True)] * 2)))
    for dtype in (np.float64, np.float32):
        a, b = wi.astype(dtype), wo.astype(dtype)
        sampled = model.sample(a, np.minimum(u, 1 - 2.0**-24).astype(dtype))
        for name, value in {"eval": model.eval(a, b), "pdf": model.pdf(a, b), **sampled._asdict()}.items():
            assert not np.isnan(value).any(), (name, dtype)
            assert name == "wo" or np.all(value >= 0), (name, dtype)


# ---------------------------------------------------------------- Limits


@pytest.fixture(scope="module")
def pairs() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    return upper_directions(3000, 11), upper_directions(3000, 12)


def test_oren_nayar_without_slopes_is_lambert(pairs: Any) -> None:
    assert_allclose(OrenNayar((0.9, 0.2), 0.0).eval(*pairs), Lambert((0.9, 0.2)).eval(*pairs), rtol=1e-15)
    assert_allclose(OrenNayar(0.9, 1e-4).eval(*pairs), Lambert(0.9).eval(*pairs), rtol=1e-3)


@pytest.mark.parametrize("entry", [entry for entry in ENTRIES if entry.reciprocal], ids=str)
def test_a_layer_of_no_dust_is_its_base_and_a_thick_one_is_dust(entry: Entry, pairs: Any) -> None:
    powder = Dust(0.7, 0.3)
    base, only_dust = entry.model.eval(*pairs), powder.eval(*pairs)
    assert_array_equal(DustLayer(entry.model, powder, tau=0.0).eval(*pairs), base)
    assert_allclose(
        DustLayer(entry.model, powder, tau=60.0).eval(*pairs), np.broadcast_to(only_dust, base.shape), rtol=1e-14
    )
    # Between the two, and linear in tau while it is thin.
    depth = 1e-9 * (1 / pairs[0][:, 2:] + 1 / pairs[1][:, 2:])
    change = DustLayer(Lambert(0.0), powder, tau=1e-9).eval(*pairs)
    assert_allclose(change, depth * only_dust, rtol=1e-5)


def test_dust_is_continuous_where_its_two_formulas_meet(pairs: Any) -> None:
    at_0 = Dust(0.5, 0.0).eval(*pairs)
    for g in (1e-9, -1e-9):
        assert_allclose(Dust(0.5, g).eval(*pairs), at_0, rtol=1e-8)
    assert_allclose(at_0[:, 0], 0.5 / (4 * np.pi * (pairs[0][:, 2] + pairs[1][:, 2])), rtol=1e-14)


def test_brightness_is_the_brdf_times_4_pi_cos(pairs: Any) -> None:
    dust = Dust((0.7, 0.3), 0.4)
    assert_allclose(
        replace(dust, form="brightness").eval(*pairs), dust.eval(*pairs) * 4 * np.pi * pairs[0][:, 2:], rtol=1e-14
    )


def test_a_sum_is_a_sum(pairs: Any) -> None:
    a, b = OrenNayar((0.8, 0.7), 0.4), TorranceSparrow(0.3, 0.2)
    assert_allclose((a + b).eval(*pairs), a.eval(*pairs) + b.eval(*pairs), rtol=1e-15)


def test_normalisation_is_a_factor(pairs: Any) -> None:
    """Continuous too where `facet_area` changes its method, at sigma_s = 0.25."""
    for sigma_s in (0.1, 0.25 - 1e-9, 0.25 + 1e-9, 0.8):
        printed, facets = TorranceSparrow(1.0, sigma_s), TorranceSparrow(1.0, sigma_s, normalization="facets")
        ratio = printed.eval(*pairs) / np.maximum(facets.eval(*pairs), 1e-300)
        ratio = ratio[printed.eval(*pairs) > 1e-200]
        assert_allclose(ratio, ratio[0], rtol=1e-12)
    narrow = [
        TorranceSparrow(1.0, s, normalization="facets").eval(direction(0.3), direction(0.3, np.pi))
        for s in (0.25 - 1e-9, 0.25 + 1e-9)
    ]
    assert_allclose(narrow[0], narrow[1], rtol=1e-7)


@pytest.mark.parametrize(
    ("options", "message"), [({"normalization": "unit"}, "printed, facets"), ({"fresnel": 1.5}, "Dielectric")]
)
def test_options_that_are_not_there_are_refused(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        TorranceSparrow(**options)


def test_a_layer_needs_a_base_and_dust_that_is_a_brdf() -> None:
    with pytest.raises(ParameterError, match="form"):
        Dust(form="printed")
    with pytest.raises(ParameterError, match="brightness"):
        DustLayer(Lambert(), Dust(form="brightness"))
    with pytest.raises(ParameterError, match=r"dust = .* is not a Dust"):
        DustLayer(Lambert(), Lambert())  # type: ignore[arg-type]
