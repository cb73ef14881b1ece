"""Parameters: what is refused and with which sentence; models as values."""

from __future__ import annotations

from dataclasses import FrozenInstanceError, fields
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_array_equal

from catalogue import ENTRIES, Entry, parts
from motes.errors import MotesError, ParameterError
from motes.models import Conductor, Dielectric, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.parameters import Parameter, Parametrised

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)
DECLARED = {
    (type(part).__name__, p.name): p
    for entry in ENTRIES
    for part in parts(entry.model)
    for p in part.declared()  # type: ignore[attr-defined]
}
every_parameter = pytest.mark.parametrize("parameter", DECLARED.values(), ids=[".".join(key) for key in DECLARED])


# ---------------------------------------------------------------- Errors


def test_degrees_are_recognised() -> None:
    with pytest.raises(ParameterError) as caught:
        OrenNayar(sigma_d=20)
    assert str(caught.value) == (
        "OrenNayar: sigma_d = 20 is outside [0, 1.571] rad (standard deviation of the facets' slope angle). "
        "Angles are in radians: 20 degrees is 0.349"
    )


@pytest.mark.parametrize(
    ("make", "message", "hint"),
    [
        (lambda: Lambert(K_d=-0.1), "Lambert: K_d = -0.1 is outside [0, inf) (diffuse reflectance)", "Choose"),
        (lambda: Dust(g=1.0), "Dust: g = 1 is outside (-1, 1) (mean cosine of the deviation angle)", "g > 0 scatters"),
        (lambda: Dust(g=(0.1, -3)), "Dust: g = -3 is outside (-1, 1)", "g > 0 scatters"),
        (lambda: Dielectric(n=0.5), "Dielectric: n = 0.5 is outside [1, 10]", "Water 1.33"),
        (lambda: TorranceSparrow(sigma_s=0.0), "TorranceSparrow: sigma_s = 0 is outside [0.001, 1.571] rad", "Choose"),
        (lambda: OrenNayar(sigma_d=-1.0), "OrenNayar: sigma_d = -1 is outside [0, 1.571] rad", "Choose"),
        (lambda: DustLayer(Lambert(), tau=-1), "DustLayer: tau = -1 is outside [0, inf)", "Choose"),
    ],
)
def test_errors_say_what_where_and_the_range(make: Any, message: str, hint: str) -> None:
    with pytest.raises(ParameterError) as caught:
        make()
    assert caught.value.message.startswith(message)
    assert caught.value.hint.startswith(hint)
    assert isinstance(caught.value, MotesError)


BAD = {
    "NaN": float("nan"),
    "infinity": float("inf"),
    "-infinity": -float("inf"),
    "a NaN among numbers": [0.5, float("nan")],
    "an infinite array": np.array([np.inf, 0.5]),
    "a number as text": "0.5",
    "bytes": b"0.5",
    "a text": "shiny",
    "texts": ["a", "b"],
    "None": None,
    "None among numbers": [0.5, None],
    "true": True,
    "nothing": [],
    "an empty array": np.zeros((0, 3)),
    "a ragged list": [[1, 2], [3]],
    "complex": 1j,
    "a complex array": np.array([1j]),
    "a dictionary": {"value": 0.5},
    "a set": {0.5},
    "an object": object(),
    "a function": abs,
    "a date": np.datetime64("2020-01-01"),
    "an enormous integer": 10**400,
    "an integer that cannot be printed": 1 << 20_000,
    "a deep list": [[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["x"]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]],
}


@pytest.mark.parametrize("value", BAD.values(), ids=BAD)
@every_parameter
def test_what_is_no_number_within_bounds_is_refused(parameter: Parameter, value: Any) -> None:
    with pytest.raises(ParameterError) as caught:
        parameter.check("Model", value)
    assert caught.value.message.startswith(f"Model: {parameter.name} = ")
    assert len(caught.value.message) < 400
    assert "\n" not in caught.value.message


@every_parameter
def test_bounds(parameter: Parameter) -> None:
    """Both bounds are accepted, or neither where they are open, and nothing beyond."""
    for bound, beyond in zip(parameter.bounds, (-np.inf, np.inf), strict=True):
        if np.isfinite(bound):
            assert _accepts(parameter, bound) is not parameter.open
            assert not _accepts(parameter, float(np.nextafter(bound, beyond)))
            assert _accepts(parameter, float(np.nextafter(bound, -beyond)))


def _accepts(parameter: Parameter, value: float) -> bool:
    try:
        return parameter.check("Model", value) == value
    except ParameterError:
        return False


@every_parameter
def test_declarations_make_sense(parameter: Parameter) -> None:
    low, high = parameter.bounds
    assert low < high
    assert _accepts(parameter, parameter.default)
    assert np.isfinite(parameter.typical).all()
    assert low <= parameter.fit_bounds[0] < parameter.fit_bounds[1] <= high
    assert low <= parameter.typical[0] < parameter.typical[1] <= high
    assert all(parameter.fit_bounds[0] <= start <= parameter.fit_bounds[1] for start in parameter.starts)
    assert parameter.symbol
    assert parameter.doc[0].islower()


# ---------------------------------------------------------------- Values


@given(value=st.floats(0, 1e6))
def test_numbers_are_kept(value: float) -> None:
    for given_as in (value, np.float64(value), np.array(value)):
        kept = Lambert(given_as).K_d
        assert type(kept) is float
        assert kept == value


def test_whole_numbers_lists_and_arrays_become_float_arrays() -> None:
    assert type(Lambert(1).K_d) is float
    for value in ([1, 0], (1, 0), np.array([1, 0]), np.array([1, 0], np.uint8)):
        kept = Lambert(value).K_d
        assert kept.dtype == np.float64
        assert_array_equal(kept, [1, 0])
    assert Lambert(np.array([0.5], np.float32)).K_d.dtype == np.float32


def test_models_do_not_change() -> None:
    model = OrenNayar((0.5, 0.4))
    with pytest.raises(FrozenInstanceError):
        model.sigma_d = 0.1  # type: ignore[misc]
    with pytest.raises(ValueError, match="read-only"):
        model.K_d[0] = 0.1


@pytest.mark.parametrize("lock", [False, True])
@pytest.mark.parametrize(
    "view", [lambda a: a, lambda a: a[:], lambda a: a.reshape(1, 3), lambda a: np.broadcast_to(a, (2, 3))]
)
def test_what_the_caller_keeps_cannot_change_a_model(view: Any, lock: bool) -> None:
    mine = np.array([0.1, 0.2, 0.3])
    handed_over = view(mine)
    if lock and handed_over is not mine:
        handed_over.flags.writeable = False
    model = Lambert(handed_over)
    mine[0] = 0.9
    assert np.ravel(model.K_d)[0] == 0.1


@every_entry
def test_equal_models_have_equal_hashes(entry: Entry) -> None:
    twin = entry.model.with_parameters({name: np.array(value) for name, value in entry.model.parameters.items()})
    assert twin is not entry.model
    assert twin == entry.model
    assert hash(twin) == hash(entry.model)
    assert len({twin, entry.model}) == 1


@every_entry
def test_a_model_differs_when_any_parameter_does(entry: Entry) -> None:
    for slot in entry.model.slots():
        value = np.asarray(slot.value)
        other = entry.model.with_parameters({slot.name: value * 0.97 + 0.002})
        assert other != entry.model
        assert hash(other) != hash(entry.model)


def test_models_of_other_kinds_shapes_or_options_differ() -> None:
    different = [
        Lambert(0.5),
        Lambert((0.5,)),
        Lambert((0.5, 0.5)),
        OrenNayar(0.5),
        Dust(0.5),
        Dust(0.5, form="brightness"),
        Lambert(0.5) + Dust(0.5),
        Dust(0.5) + Lambert(0.5),
        TorranceSparrow(0.5),
        TorranceSparrow(0.5, fresnel=Dielectric()),
        TorranceSparrow(0.5, fresnel=Conductor()),
    ]
    assert len(set(different)) == len(different)
    assert Lambert(0.5) != 0.5


def test_equality_is_of_numbers_not_of_their_types() -> None:
    for a, b in ((Lambert([0.5, 0.25]), Lambert(np.array([0.5, 0.25], np.float32))), (Lambert(0.0), Lambert(-0.0))):
        assert a == b
        assert hash(a) == hash(b)


def test_tensors_compare_by_identity() -> None:
    torch = pytest.importorskip("torch")
    K_d = torch.tensor([0.5, 0.4], requires_grad=True)
    assert Lambert(K_d) == Lambert(K_d)
    assert hash(Lambert(K_d)) == hash(Lambert(K_d))
    assert Lambert(K_d) != Lambert(K_d.detach().clone())
    assert Lambert(K_d) != Lambert((0.5, 0.4))


# ---------------------------------------------------------------- Trees


@every_entry
def test_names_are_unique_in_a_tree(entry: Entry) -> None:
    names = [slot.name for slot in entry.model.slots()]
    assert len(set(names)) == len(names)
    assert list(entry.model.parameters) == names


def test_names_met_again_are_numbered_in_the_order_of_the_text() -> None:
    model = DustLayer(Lambert(0.1) + Lambert(0.2) + OrenNayar(0.3), Dust(0.4))
    assert list(model.parameters) == ["K_d", "K_d_2", "K_d_3", "sigma_d", "w", "g", "tau"]
    assert [model.parameters[name] for name in ("K_d", "K_d_2", "K_d_3")] == [0.1, 0.2, 0.3]


@every_entry
def test_each_name_reaches_its_own_parameter(entry: Entry) -> None:
    for slot in entry.model.slots():
        value = np.asarray(slot.value) * 0.97 + 0.002
        changed = entry.model.with_parameters({slot.name: value})
        for other in changed.slots():
            expected = value if other.name == slot.name else entry.model.parameters[other.name]
            assert_array_equal(other.value, expected)


def test_names_that_are_not_there_are_refused() -> None:
    with pytest.raises(ParameterError) as caught:
        OrenNayar().with_parameters({"sigma_s": 0.1})
    assert str(caught.value) == "OrenNayar has no parameter 'sigma_s'. It has K_d, sigma_d"


def test_new_values_are_checked() -> None:
    with pytest.raises(ParameterError, match=r"Dust: g = 2 is outside"):
        DustLayer(Lambert(), Dust()).with_parameters({"g": 2})
    with pytest.raises(ParameterError, match="disagree on the number of channels"):
        OrenNayar((0.1, 0.2)).__add__(Lambert((0.1, 0.2))).with_parameters({"K_d_2": (1, 2, 3)})


@every_entry
def test_every_field_is_a_parameter_an_option_or_a_part(entry: Entry) -> None:
    for part in parts(entry.model):
        assert isinstance(part, Parametrised)
        names = {p.name for p in part.declared()} | set(part.options()) | {p.name for p in part.declared_parts()}
        assert names == {f.name for f in fields(part)}
