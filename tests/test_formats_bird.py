"""BiRD JSON: values, units, uncertainties, polarisations, times; what is written is valid by the schema and reads back."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import format_files as files
from motes.directions import from_spherical
from motes.errors import MotesError
from motes.measurements import Measurement, read
from motes.measurements.bird_writing import write_bird


def bird(path: Path, **changes: object) -> Path:
    path.write_text(files.bird_json(**changes), encoding="utf-8")
    return path


def test_values_units_and_uncertainties(tmp_path: Path):
    m = read(bird(tmp_path / "a.json"))
    assert m.channels == ("450 nm", "650 nm")
    assert m.wavelengths.tolist() == [450, 650]
    np.testing.assert_allclose(m.values[0], [[0.10, 0.11], [0.12, 0.13], [0.14, 0.15]])
    np.testing.assert_allclose(m.uncertainties, 0.02 * m.values)
    np.testing.assert_allclose(m.wo[1], files.vector(30, 180), atol=1e-12)
    np.testing.assert_allclose(m.wi[2], files.vector(45, 0), atol=1e-12)
    assert (m.name, m.provenance["organization"], m.provenance["method"]) == ("tile", "Some Institute", "measurement")
    expanded = read(tmp_path / "a.json", coverage=2)
    np.testing.assert_allclose(expanded.uncertainties, 0.01 * m.values)
    assert any("k = 1" in note for note in m.provenance["notes"])


def test_one_uncertainty_for_all_and_none(tmp_path: Path):
    brdf = {"unit": "1/sr", "values": [0.5] * 6, "uncertainty": {"value": 0.004, "unit": "1/sr"}}
    np.testing.assert_allclose(read(bird(tmp_path / "a.json", BRDF=brdf, uBRDF=None)).uncertainties, 0.004)
    assert read(bird(tmp_path / "b.json", uBRDF=None)).uncertainties is None


def test_micrometres(tmp_path: Path):
    column = {"unit": "μm", "values": [0.45, 0.65] * 3}
    np.testing.assert_allclose(read(bird(tmp_path / "a.json", wavelength_i=column)).wavelengths, [450, 650])


def test_polarisations_are_channels_or_their_mean(tmp_path: Path):
    stokes = [[1, 1, 0, 0], [1, -1, 0, 0]] * 3
    changes = {
        "polarization_i": {"notation": "inStokes", "values": stokes},
        "wavelength_i": {"unit": "nm", "values": [550] * 6},
    }
    m = read(bird(tmp_path / "a.json", **changes))
    assert m.channels == ("550 nm p", "550 nm s")
    np.testing.assert_allclose(m.values[0, :, 1], [0.10, 0.12, 0.14])
    mean = read(tmp_path / "a.json", polarization="mean")
    np.testing.assert_allclose(mean.values[0, :, 0], [0.105, 0.125, 0.145])
    np.testing.assert_allclose(mean.uncertainties[0, :, 0], 0.01 * np.hypot([0.10, 0.12, 0.14], [0.11, 0.13, 0.15]))
    np.testing.assert_allclose(read(tmp_path / "a.json", polarization="s").values[0, :, 0], [0.10, 0.12, 0.14])


def test_a_geometry_that_was_measured_twice_stays_two(tmp_path: Path):
    same = {name: {"unit": "deg", "values": [20.0] * 6} for name in ("theta_i", "theta_r", "phi_i", "phi_r")}
    m = read(bird(tmp_path / "a.json", **same))
    assert m.n_directions == 3
    np.testing.assert_allclose(m.values[0], [[0.10, 0.11], [0.12, 0.13], [0.14, 0.15]])


@pytest.mark.parametrize(
    ("changes", "complaint"),
    [
        ({"theta_i": {"unit": "rad", "values": [0, 0, 30, 30, 45, 45]}}, "30 rad"),
        ({"theta_i": {"unit": "gon", "values": [0] * 6}}, "'gon'"),
        ({"theta_i": {"unit": "deg", "values": [0] * 5}}, "5 values"),
        ({"theta_i": {"unit": "deg", "values": ["a"] * 6}}, "'a'"),
        ({"theta_i": {"values": [0] * 6}}, "unit of theta_i"),
        ({"theta_i": None}, "theta_i"),
        ({"BRDF": {"unit": "%", "values": [0.1] * 6}}, "unit of BRDF"),
        ({"BRDF": {"unit": "1/sr", "values": [10**400] * 6}}, "too large"),
        ({"uBRDF": {"unit": "%", "values": [2, 2, 0, 2, 2, 2]}}, "uncertainty 3 is 0"),
        ({"uBRDF": {"unit": "%", "values": [2, 2, float("nan"), 2, 2, 2]}}, "uncertainty 3 is nan"),
        ({"uBRDF": {"unit": "nm", "values": [2] * 6}}, "unit of the uncertainty"),
        ({"wavelength_r": {"unit": "nm", "values": [700] * 6}}, "fluoresces"),
        ({"polarization_i": {"notation": "sp", "values": ["x"] * 6}}, "polarization_i"),
    ],
)
def test_contradictions_are_refused(tmp_path: Path, changes: dict, complaint: str):
    with pytest.raises(MotesError, match=complaint) as raised:
        read(bird(tmp_path / "a.json", **changes))
    assert raised.value.hint


def test_nested_and_broken_json(tmp_path: Path):
    for text, complaint in (
        ('{"theta_r": ' + "[" * 5000 + "]" * 5000 + "}", "nested"),
        (files.bird_json()[:300], "not JSON"),
        ('{"data": [1], "BRDF": 2}', "no object 'data'"),
        ('[{"BRDF": 1}]', "instead of an object"),
    ):
        (tmp_path / "a.json").write_text(text)
        with pytest.raises(MotesError, match=complaint):
            read(tmp_path / "a.json", format="bird")


def some_measurement(times: int = 2, **names: object) -> Measurement:
    rng = np.random.default_rng(1)
    values = rng.uniform(0.01, 1, (times, 20, 3))
    return Measurement.from_arrays(
        from_spherical(rng.uniform(0, 1.4, 20), rng.uniform(-3, 3, 20)),
        from_spherical(rng.uniform(0, 1.4, 20), rng.uniform(-3, 3, 20)),
        values,
        times=[0.0, 2.5][:times],
        uncertainties=0.02 * values,
        provenance={"name": "a paint", "source": "somewhere", "notes": ["a note"]},
        **names,
    )


@pytest.mark.parametrize("names", [{"wavelengths": [400, 550, 700]}, {"channels": ["R", "G", "B"]}], ids=["nm", "RGB"])
def test_what_is_written_reads_back(tmp_path: Path, names: dict):
    m = some_measurement(**names)
    assert write_bird(m, tmp_path / "a.json") == []
    back = read(tmp_path / "a.json")
    assert (back.channels, back.times.tolist(), back.name) == (m.channels, [0.0, 2.5], "a paint")
    np.testing.assert_allclose(back.values, m.values, rtol=1e-9)
    np.testing.assert_allclose(back.uncertainties, m.uncertainties, rtol=1e-9)
    np.testing.assert_allclose(back.wi, m.wi, atol=1e-10)
    np.testing.assert_allclose(back.wo, m.wo, atol=1e-10)


def test_what_the_format_cannot_hold_is_said(tmp_path: Path):
    m = some_measurement()
    values = m.values.copy()
    values[0, 3, 1] = -0.001
    spread = m.uncertainties.copy()
    spread[1, 2, 0] = np.nan
    m = Measurement.from_arrays(m.wi, m.wo, values, times=[0, 1], uncertainties=spread, common_uncertainty=0.03)
    said = " ".join(write_bird(m, tmp_path / "a.json"))
    assert "1 negative value" in said
    assert "Uncertainties are left out" in said
    assert "3.00%" in said
    back = read(tmp_path / "a.json")
    assert back.masked.get("not measured at this wavelength, polarisation or time") == 1
    assert "0.03" in json.loads((tmp_path / "a.json").read_text())["metadata"]["comments"]


def validator(shared_file):
    jsonschema = pytest.importorskip("jsonschema")
    referencing = pytest.importorskip("referencing")
    root = shared_file("bird/brdf_json_schema_v1.0.json")
    contents = []
    for file in sorted(root.parent.glob("*.json")):
        if file.name != "sample_holder_json_schema_v1.0.json":  # a stub that is no JSON, and that nothing refers to
            contents.append(json.loads(file.read_text()))
    registry = referencing.Registry().with_resources(
        (schema["$id"], referencing.Resource.from_contents(schema)) for schema in contents
    )
    return jsonschema.Draft202012Validator(json.loads(root.read_text()), registry=registry)


@pytest.mark.parametrize("names", [{"wavelengths": [400, 550, 700]}, {"channels": ["550 nm s", "550 nm p", "x"]}])
@pytest.mark.parametrize("method", ["measurement", "simulation"])
def test_what_is_written_is_valid_by_the_schema(tmp_path: Path, shared_file, names: dict, method: str):
    check = validator(shared_file)
    check.validate(files.bird_document())  # the specimen of these tests, too
    write_bird(
        some_measurement(**names),
        tmp_path / "a.json",
        method=method,
        metadata={"provenance": {"organization": "Some Institute", "email": "a@b.org"}},
    )
    document = json.loads((tmp_path / "a.json").read_text())
    check.validate(document)
    assert document["metadata"]["provenance"]["organization"] == "Some Institute"
    assert document["metadata"]["method"] == method
    document["data"]["BRDF"]["values"][0] = -1  # the check can fail
    assert not check.is_valid(document)


def test_the_command_line_takes_it_for_data(tmp_path: Path, motes: Callable[..., tuple[int, str, str]]):
    document = files.bird_document()
    document["metadata"]["comments"] = "x" * 10_000  # the data begin late
    (tmp_path / "a.json").write_text(json.dumps(document))
    status, printed, _ = motes("info", tmp_path / "a.json", "--json")
    assert (status, json.loads(printed)["format"]) == (0, "bird")
