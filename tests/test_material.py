"""Materials as JSON: they come back, they say their conventions, and damaged ones are refused with a sentence."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from catalogue import ENTRIES, WAVELENGTHS, Entry, direction
from motes.errors import FormatError, MotesError, ParameterError
from motes.material import Material, load
from motes.models import Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.trends import Tabulated, Trend

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)

DRYING = Material(
    DustLayer(OrenNayar((0.5, 0.4, 0.3), 0.4) + TorranceSparrow(0.3, 0.15), Dust((0.7, 0.6, 0.5), 0.3), 0.0),
    name="drying plaster",
    channels=("red", "green", "blue"),
    trends={
        "K_s": Trend("exponential", {"start": 0.3, "end": 0.05, "time_constant": 0.5}, (0.0, 3.0), (0.0, np.inf)),
        "K_d": Trend("linear", {"start": (0.5, 0.4, 0.3), "end": (0.8, 0.7, 0.6)}, (0.0, 3.0), (0.0, np.inf)),
        "tau": Tabulated(np.array([0.0, 1.0, 3.0]), np.array([0.0, 0.1, 0.5])),
    },
    about={"data": "simulated", "relative_rms": 0.05, "notes": ["by hand"]},
)


@every_entry
def test_a_saved_material_comes_back(entry: Entry, tmp_path: Path) -> None:
    spectral = entry.name == "spectral"
    material = Material(
        entry.model,
        name=f"a {entry.name} <&> «grün»",
        channels=tuple(f"c{k}" for k in range(entry.model.channels)),
        wavelengths=tuple(WAVELENGTHS) if spectral else (),
        about={"loss": "linear", "nested": {"a": [1, 2.5, None, True]}},
    )
    path = material.save(tmp_path / "folder" / "material.json")
    assert load(path) == material
    assert (
        load(str(path)).brdf.eval(direction(0.3), direction(0.5)).tolist()
        == entry.model.eval(direction(0.3), direction(0.5)).tolist()
    )


def test_a_saved_material_with_trends_comes_back(tmp_path: Path) -> None:
    again = load(DRYING.save(tmp_path / "drying.json"))
    for hours in (0.0, 0.7, 3.0, 10.0):
        assert again.at(hours) == DRYING.at(hours)
    assert again.interval == (0.0, 3.0)
    assert again.about == DRYING.about


def test_the_file_says_its_conventions(tmp_path: Path) -> None:
    data = json.loads(DRYING.save(tmp_path / "m.json").read_text(encoding="utf-8"))
    assert data["format"] == "motes material"
    assert data["version"] == 1
    assert data["model"] == "dust_layer(oren_nayar + torrance_sparrow)"
    assert data["conventions"]["angles"] == "radians"
    assert "without the cosine" in data["conventions"]["brdf"]
    assert data["time_unit"] == "h"
    assert data["parameters"]["sigma_d"] == {
        "value": 0.4,
        "unit": "rad",
        "meaning": "standard deviation of the facets' slope angle",
    }


def test_options_are_part_of_the_model(tmp_path: Path) -> None:
    model = TorranceSparrow(normalization="facets") + Dust(form="brightness")
    data = Material(model).to_dict()
    assert data["model"] == "torrance_sparrow(normalization=facets) + dust(form=brightness)"
    assert Material.from_dict(data).brdf == model


# ---------------------------------------------------------------- Time


def test_parameters_follow_their_trends() -> None:
    now = DRYING.at(hours=1.0).parameters
    assert_allclose(now["K_s"], 0.05 + 0.25 * np.exp(-2.0), rtol=1e-14)
    assert_allclose(now["K_d"], [0.6, 0.5, 0.4], rtol=1e-14)
    assert now["tau"] == 0.1
    assert now["sigma_d"] == 0.4
    assert DRYING.at(100.0).parameters["tau"] == 0.5


def test_many_times_at_once_are_each_time() -> None:
    hours = np.array([0.0, 0.5, 2.0, 9.0])
    wi, wo = np.stack([direction(t) for t in (0.1, 0.5, 1.0, 1.2, 1.4)]), direction(0.6, 2.0)
    many = DRYING.at(hours).eval(wi, wo)
    assert many.shape == (4, 5, 3)
    for k, t in enumerate(hours):
        assert_allclose(many[k], DRYING.at(t).eval(wi, wo), rtol=1e-14)


def test_a_material_without_trends_does_not_change() -> None:
    assert Material(Lambert(0.3)).at(5.0) == Lambert(0.3)
    assert Material(Lambert(0.3)).interval is None


def test_extrapolated_parameters_stay_within_what_the_model_accepts() -> None:
    rising = Trend("linear", {"start": 0.1, "end": 1.5}, (0.0, 1.0))
    sinking = Trend("linear", {"start": 0.5, "end": -0.9}, (0.0, 1.0))
    material = Material(OrenNayar() + Dust(), trends={"sigma_d": rising, "g": sinking})
    assert material.at(5.0).parameters["sigma_d"] == np.pi / 2
    assert -1 < material.at(5.0).parameters["g"] < -0.99999


@pytest.mark.parametrize("hours", [np.nan, np.inf, [0.0, np.nan]])
def test_times_must_be_finite(hours: Any) -> None:
    with pytest.raises(ParameterError, match="is not finite"):
        DRYING.at(hours)


def test_trends_are_of_parameters_that_are_there() -> None:
    with pytest.raises(ParameterError, match=r"lambert has no parameter 'tau' to follow a trend. It has K_d"):
        Material(Lambert(), trends={"tau": Tabulated(np.array([0.0]), np.array([1.0]))})


# ---------------------------------------------------------------- Damage


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "is not JSON"),
        (b"{", "is not JSON"),
        (b"\xff\xfe\x00", "cannot be read as JSON"),
        (b"[" * 100_000, "nested 100000 deep"),
        (b"null", "holds a NoneType instead of an object"),
        (b"[]", "holds a list instead of an object"),
        (b"{}", "is not a Motes material"),
        (b'"motes material"', "holds a str instead of an object"),
        (b'{"format": "motes material"}', "version None"),
        (b'{"format": "motes material", "version": 2}', "version 2 is newer than 1"),
        (b'{"format": "motes material", "version": 1}', "incomplete or damaged"),
        (b'{"format": "motes material", "version": 1, "parameters": {}, "model": "phong"}', "'phong' is not a model"),
        (b"1" * 5000, "cannot be read as JSON"),
    ],
)
def test_damaged_files_are_refused(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "material.json"
    path.write_bytes(content)
    with pytest.raises(MotesError, match=message):
        load(path)


def test_what_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FormatError, match="cannot be read: No such file"):
        load(tmp_path / "nothing.json")
    with pytest.raises(FormatError, match="cannot be read: Is a directory"):
        load(tmp_path)


def test_an_enormous_file_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "large.json"
    with path.open("wb") as file:
        file.truncate(65 * 2**20)
    with pytest.raises(FormatError, match="more than the 67108864"):
        load(path)


def nodes(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """The paths to everything inside a JSON value."""
    yield path
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from nodes(inner, (*path, key))


def changed(data: Any, path: tuple[Any, ...], change: Callable[[Any], Any]) -> Any:
    """A copy of `data` with what is at `path` replaced; `change` returns DELETED to take it out."""
    if not path:
        return change(data)
    data = copy.copy(data)
    inner = changed(data[path[0]], path[1:], change)
    if inner is DELETED:
        del data[path[0]]
    else:
        data[path[0]] = inner
    return data


DELETED = object()
WHOLE = DRYING.to_dict()
junk = st.one_of(
    st.just(DELETED),
    st.none(),
    st.booleans(),
    st.integers(),
    st.just(10**400),
    st.floats(),
    st.text(max_size=5),
    st.just([]),
    st.just({}),
    st.lists(st.floats() | st.none() | st.text(max_size=2), max_size=4),
    st.just([[[0.1, 0.2], [0.3]]]),
    st.sampled_from([p for p in WHOLE.values() if isinstance(p, (dict, list))]),
)


@settings(max_examples=600)
@given(path=st.sampled_from(list(nodes(WHOLE))), value=junk)
def test_damage_gives_a_material_or_a_motes_error(path: tuple[Any, ...], value: Any) -> None:
    """Anything anywhere in the JSON replaced by anything; what loads can be used, or says why not."""
    damaged = changed(WHOLE, path, lambda _: value)
    try:
        material = Material.from_dict(damaged)
        material.at(1.0).eval(direction(0.2), direction(0.4))
        material.to_dict()
    except MotesError:
        return


@settings(max_examples=150)
@given(data=st.data())
def test_damaged_bytes_give_a_material_or_a_motes_error(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    content = bytearray(json.dumps(WHOLE).encode())
    for _ in range(data.draw(st.integers(1, 3))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    content = content[: data.draw(st.integers(0, len(content)) | st.just(len(content)))]
    path = tmp_path_factory.getbasetemp() / "damaged.json"
    path.write_bytes(content)
    try:
        load(path).at(0.5)
    except MotesError:
        return


# ---------------------------------------------------------------- Writing


def test_a_failed_save_leaves_the_old_file_and_nothing_else(tmp_path: Path) -> None:
    path = Material(Lambert(0.3)).save(tmp_path / "m.json")
    before = path.read_bytes()
    with pytest.raises(ValueError, match="JSON compliant"):
        replace(DRYING, about={"rms": float("nan")}).save(path)
    assert path.read_bytes() == before
    assert_array_equal([p.name for p in tmp_path.iterdir()], ["m.json"])


def test_a_folder_that_cannot_be_written_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("not a folder")
    with pytest.raises(MotesError, match="cannot be written"):
        Material(Lambert()).save(tmp_path / "file" / "m.json")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"about": {"data": {"source": float("inf")}}}, r"about\.data\.source is inf, not a finite number"),
        ({"name": [float("nan")]}, r"name\.0 is nan"),
        ({"channels": [f"c{k}" for k in range(31)]}, "31 channels are named, and a parameter has 3 values"),
        ({"wavelengths_nm": [400.0, 500.0]}, "2 wavelengths do not fit 3 channels"),
        ({"wavelengths_nm": [400.0, 500.0, -1.0]}, "or are no lengths"),
        (
            {"trends": {"K_d": {"kind": "tabulated", "hours": [0, 1], "values": [[1] * 4] * 2}}},
            "a parameter has 4 values",
        ),
        ({"trends": {"K_d": {"kind": "tabulated", "hours": [0, 1], "values": 1}}}, "damaged|as many values"),
        ({"trends": {"K_d": {"kind": "tabulated", "hours": [0, None], "values": [1, 1]}}}, "increasing times"),
    ],
)
def test_what_does_not_fit_is_refused(tmp_path: Path, change: dict[str, object], message: str) -> None:
    path = tmp_path / "material.json"
    rgb = Material(OrenNayar(K_d=(0.3, 0.4, 0.5)), channels=("R", "G", "B"))
    load(rgb.save(path))
    path.write_text(json.dumps({**rgb.to_dict(), **change}))
    with pytest.raises(MotesError, match=message) as caught:
        load(path)
    assert caught.value.hint


def test_channels_are_named_after_what_the_material_has() -> None:
    colour = Lambert(K_d=(0.1, 0.2, 0.3))
    assert Material(Lambert(K_d=0.5)).channels == ("grey",)
    assert Material(colour).channels == ("R", "G", "B")
    assert Material(colour, wavelengths=(450, 550, 650)).channels == ("450 nm", "550 nm", "650 nm")
    assert Material(Lambert(K_d=(0.1, 0.2))).channels == ("channel 1", "channel 2")
    with pytest.raises(ParameterError, match="2 channels are named, and a parameter has 3 values"):
        Material(colour, wavelengths=(450, 550))
