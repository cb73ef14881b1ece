"""Models beside each other: every number against another way to it, and the colours against BT.2100 and BT.2124."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import numpy as np
import pytest

import motes
from fitting_oracle import scattered
from motes import directions
from motes.cli.comparing import split_models
from motes.cli.main import main
from motes.drawing.colour_difference import WHITE, delta_e_itp, itp, perceptual_quantiser
from motes.errors import DataError, MotesError
from motes.fitting.model_table import Comparison, sphere_difference
from motes.measurements import Measurement

TRUTH = motes.OrenNayar((0.6, 0.4, 0.25), 0.4) + motes.TorranceSparrow(0.25, 0.15)
MODELS = ["lambert", "oren_nayar + torrance_sparrow"]


def data() -> Measurement:
    wi, wo = scattered(120, 3)
    noise = 1 + 0.02 * np.random.default_rng(1).standard_normal((120, 3))
    return Measurement.from_arrays(wi, wo, TRUTH.eval(wi, wo) * noise)


@pytest.fixture(scope="module")
def found() -> Comparison:
    return motes.compare(data(), MODELS)


def test_each_row_is_the_fit_of_its_model(found: Comparison) -> None:
    for text, row in zip(MODELS, found.rows, strict=True):
        alone = motes.fit(data(), text)
        assert row.fit.model_text == text
        assert row.fit.metrics["objective"] == pytest.approx(alone.metrics["objective"], rel=1e-6)
    small, large = found.rows
    assert [row.chosen for row in found.rows] == [False, True]
    assert large.delta_bic == 0
    assert small.delta_bic == pytest.approx(small.fit.metrics["bic"] - large.fit.metrics["bic"], rel=1e-3)
    assert small.left_out > 5 * large.left_out
    assert large.left_out == pytest.approx(0.02, rel=0.5)  # the noise
    assert small.delta_e > 3 * large.delta_e
    assert found.dusty is None


def test_the_table_and_its_files(found: Comparison, tmp_path: Path) -> None:
    records = found.records()
    assert [record["model"] for record in records] == MODELS
    assert records[1]["sigma_d"] == pytest.approx(0.4, abs=0.05)
    saved = json.loads(found.save(tmp_path / "c.json").read_text())
    assert saved["dusty"] is None
    assert [one["model"] for one in saved["models"]] == MODELS
    assert [one["left_out"] for one in saved["models"]] == pytest.approx([row.left_out for row in found.rows])
    page = found.report(tmp_path / "c.html").read_text()
    ends = re.findall(r"\+([\d.]+) %<", page.partition("all on one scale")[2])
    assert len(ends) >= len(found.rows)
    assert len(set(ends)) == 1  # models are compared by colours
    for text in MODELS:
        assert page.count(text) >= 2  # in the table, and above its residuals
    assert "http" not in page.replace("http-equiv", "").replace("http://www.w3.org", "")


def test_a_dataframe_or_what_to_install(found: Comparison, monkeypatch: pytest.MonkeyPatch) -> None:
    pandas = pytest.importorskip("pandas")
    frame = found.to_dataframe()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame["model"]) == MODELS
    assert frame["left_out"].dtype == float
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(MotesError, match="pandas"):
        found.to_dataframe()


def test_what_cannot_be_compared() -> None:
    with pytest.raises(DataError, match="takes two"):
        motes.compare(data(), ["lambert"])
    wi, wo = scattered(30, 1)
    series = Measurement.from_arrays(wi, wo, np.full((2, 30, 1), 0.2), times=[0, 1])
    with pytest.raises(DataError, match="2 times"):
        motes.compare(series, MODELS)


def test_the_command_compares(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, out = tmp_path / "t.csv", tmp_path / "out"
    one = data()
    angles = np.degrees(np.stack([f(w) for w in (one.wi, one.wo) for f in (directions.theta, directions.phi)], axis=-1))
    rows = [",".join(f"{x:.6f}" for x in row) for row in np.hstack([angles, one.values[0]])]
    table.write_text("\n".join(["theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,R,G,B", *rows]))
    assert main(["fit", str(table), "--models", "lambert, oren_nayar", "-o", str(out), "--json"]) == 0
    assert [one["model"] for one in json.loads(capsys.readouterr().out)["models"]] == ["lambert", "oren_nayar"]
    assert {file.name for file in out.iterdir()} == {"comparison.json", "comparison.html"}
    assert main(["fit", str(table), "--models", "lambert,oren_nayar", "--trend", "K_d=linear"]) == 2
    assert "--models" in capsys.readouterr().err


def test_commas_inside_brackets_belong_to_a_model() -> None:
    assert split_models("lambert, dust_layer(oren_nayar(sigma_d=0.3), scattering=multiple),eon") == [
        "lambert",
        "dust_layer(oren_nayar(sigma_d=0.3), scattering=multiple)",
        "eon",
    ]


# ---------------------------------------------------------------- colours


def test_the_quantiser_and_greys() -> None:
    """SMPTE ST 2084: 100 cd/m^2 is the code 0.5081, 10,000 is 1; ITU-R BT.2408: diffuse white is 58 %."""
    np.testing.assert_allclose(perceptual_quantiser([0, 100, 10_000]), [0, 0.5081, 1], atol=5e-5)
    assert perceptual_quantiser(WHITE) == pytest.approx(0.58, abs=0.001)
    grey = itp([0.4, 0.4, 0.4])
    assert grey[0] == pytest.approx(perceptual_quantiser(0.4 * WHITE), abs=1e-4)
    np.testing.assert_allclose(grey[1:], 0, atol=1e-4)


def test_differences_are_distances() -> None:
    rng = np.random.default_rng(5)
    a, b, c = rng.uniform(0, 1, (3, 50, 3))
    np.testing.assert_allclose(delta_e_itp(a, b), delta_e_itp(b, a))
    assert (delta_e_itp(a, c) <= delta_e_itp(a, b) + delta_e_itp(b, c) + 1e-12).all()
    # One code step of ten bits in I alone is 0.7: a grey that differs by it.
    y = np.array([0.5, 0.5 * 1.01])
    step = np.diff(perceptual_quantiser(y * WHITE))[0]
    assert delta_e_itp([y[0]] * 3, [y[1]] * 3) == pytest.approx(720 * step, rel=1e-3)


def test_a_sphere_of_the_data_themselves_has_no_difference() -> None:
    wi, wo = scattered(200, 3)
    exact = motes.fit(Measurement.from_arrays(wi, wo, TRUTH.eval(wi, wo)), "oren_nayar + torrance_sparrow")
    assert sphere_difference(exact) < 1e-3
    off = motes.fit(Measurement.from_arrays(wi, wo, TRUTH.eval(wi, wo)), "lambert")
    assert sphere_difference(off) > 1
