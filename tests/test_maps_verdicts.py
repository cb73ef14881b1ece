"""Maps have what a single fit has: robust losses, one time of several, verdicts, covariances, the same chooser."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")

import xarray

import maps_support as support
from motes import maps
from motes.cli.main import main
from motes.errors import MotesError
from motes.fitting import fit
from motes.fitting.covariance import VERDICTS
from motes.maps.choosing import choose, compared
from motes.maps.settings import Settings
from motes.maps.simulated import fill, two_views
from motes.measurements import Measurement

MODEL = "oren_nayar"


def surface(y: Any, x: Any, t: Any) -> dict[str, Any]:
    colour = np.array([0.7, 0.4, 0.3]) * (0.6 + 0.1 * t + 0.02 * x)[..., None]
    return {"K_d": colour, "sigma_d": 0.3 + 0.02 * y + 0 * t + 0 * x}


def make(path: Path, from_above: bool = False) -> maps.MapStack:
    """4 x 5 texels, 3 times, 1 % noise; one texel has outliers, one no data."""
    wi, wo = two_views(12)
    stack = maps.create_map(path, (4, 5), wi, (0, 0, 1) if from_above else wo, hours=(0, 1, 3), chunk=4)
    fill(stack, MODEL, surface, 0.01, 0)
    values = support.values_of(path)
    values[0, 1, :, ::6] = 3 * np.asarray(values[0, 1, :, ::6])
    values[3, 4] = np.nan
    return maps.open_map(path)  # type: ignore[return-value]


@pytest.fixture(scope="module")
def stack(tmp_path_factory: pytest.TempPathFactory) -> maps.MapStack:
    return make(tmp_path_factory.mktemp("maps") / "flat.zarr")


@pytest.fixture(scope="module")
def robust(stack: maps.MapStack, tmp_path_factory: pytest.TempPathFactory) -> maps.FittedMap:
    out = tmp_path_factory.mktemp("fits") / "out.zarr"
    return maps.fit_map(stack, MODEL, out=out, robust="huber", time=1, covariance=True)


def measured(stack: maps.MapStack, y: int, x: int, time: int) -> Measurement:
    return Measurement.from_arrays(stack.wi, stack.wo, stack.texels(y, x)[time], channels=("R", "G", "B"))


def test_a_texel_at_one_time_under_a_robust_loss_is_what_motes_fit_finds(
    stack: maps.MapStack, robust: maps.FittedMap
) -> None:
    assert robust.hours.tolist() == [1.0]
    for y, x in ((0, 1), (2, 3)):
        alone = fit(measured(stack, y, x, 1), MODEL, robust="huber")
        for name, parameter in alone.parameters.items():
            assert np.all(np.abs(robust.values(name)[y, x, 0] - parameter.value) < 0.02 * parameter.stderr), name
            codes = np.atleast_1d(robust.verdicts(name)[y, x, 0])
            assert tuple(VERDICTS[c] for c in codes) == parameter.verdicts
        covariance = robust.covariance((slice(y, y + 1), slice(x, x + 1)))[0, 0, 0]
        np.testing.assert_allclose(covariance, alone.covariance, rtol=0.02, atol=0.02 * np.abs(covariance).min())
    plain = fit(measured(stack, 0, 1, 1), MODEL)
    assert abs(plain.parameters["K_d"].value[0] - robust.values("K_d")[0, 1, 0, 0]) > 0.01  # it matters


def test_covariances_are_named_symmetric_and_agree_with_the_errors(robust: maps.FittedMap) -> None:
    assert robust.labels == ("K_d[R]", "K_d[G]", "K_d[B]", "sigma_d")
    full = robust.covariance()
    assert full.shape == (4, 5, 1, 4, 4)
    np.testing.assert_array_equal(full, np.swapaxes(full, -1, -2))
    diagonal = np.diagonal(full, axis1=-2, axis2=-1)
    np.testing.assert_allclose(diagonal[..., 3], np.square(robust.read_map("sigma_d_stderr")), rtol=1e-5)
    np.testing.assert_allclose(diagonal[..., 1], np.square(robust.read_map("K_d_stderr")[..., 1]), rtol=1e-5)
    assert np.isnan(full[3, 4]).all()
    data = xarray.open_zarr(robust.path)
    assert data.covariance.attrs["labels"] == list(robust.labels)
    flags = dict(
        zip(data.K_d_verdict.attrs["flag_meanings"].split(), data.K_d_verdict.attrs["flag_values"], strict=True)
    )
    assert flags == {"identified": 0, "weak": 1, "unidentifiable": 2, "at_lower": 3, "at_upper": 4, "not_fitted": 255}
    counts = robust.verdict_counts()["sigma_d"]
    assert set(counts) == set(flags)
    assert (counts["identified"] + counts["weak"], counts["not_fitted"], sum(counts.values())) == (19, 1, 20)


def test_a_store_of_an_earlier_version_opens(stack: maps.MapStack, robust: maps.FittedMap, tmp_path: Path) -> None:
    old = support.copy(robust.path, tmp_path / "old.zarr")
    group = maps.zarrs.open_group(old, "r+")
    for name in ("K_d_verdict", "sigma_d_verdict", "covariance"):
        del group[name]
    plan = dict(group["run"].attrs["plan"])
    for name in ("robust", "time", "covariance"):
        del plan["settings"][name]
    group["run"].attrs["plan"] = {**plan, "tried": {"lambert": 12.5, MODEL: 0.0}}
    group.attrs["version"] = 1
    found = maps.open_map(old)
    assert isinstance(found, maps.FittedMap)
    assert found.summary()["verdicts"] == {}
    assert [(t.model, t.bic, t.chosen) for t in found.plan.tried] == [("lambert", 12.5, False), (MODEL, 0.0, True)]
    json.dumps(found.summary(), allow_nan=False)
    found.report(tmp_path / "old.html")
    with pytest.raises(MotesError, match="holds no verdicts"):
        found.verdicts("K_d")
    with pytest.raises(MotesError, match="--covariance"):
        found.covariance()
    group["run/done"][0, 0] = 0
    with pytest.raises(MotesError, match="begun by an earlier Motes"):
        maps.fit_map(stack.path, MODEL, out=old)


def test_a_fixed_camera_above_a_flat_sample(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """One viewer says nothing about sigma_d, nor about K_d beside it: the terminal says so, and the page shows where."""
    source, out = make(tmp_path / "above.zarr", from_above=True).path, tmp_path / "out.zarr"
    assert main(["fit", str(source), "-m", MODEL, "--time", "-1", "-o", str(out)]) == 0
    printed = capsys.readouterr().out
    assert "unidentifiable: the data do not determine it" in printed
    (note,) = (line for line in printed.splitlines() if "unidentifiable" in line)
    assert "K_d in " in note
    assert "sigma_d in " in note
    fitted = maps.open_map(out)
    assert isinstance(fitted, maps.FittedMap)
    counts = fitted.summary()["verdicts"]
    # Where noise pushes sigma_d to a bound it is held there, and K_d beside it is known.
    assert counts["K_d"]["unidentifiable"] >= 0.8 * 19 * 3
    assert counts["sigma_d"]["unidentifiable"] >= 0.8 * 19
    assert counts["sigma_d"]["identified"] == 0
    alone = fit(measured(maps.open_map(source), 2, 2, 2), MODEL)  # type: ignore[arg-type]
    assert tuple(VERDICTS[c] for c in fitted.verdicts("K_d")[2, 2, 0]) == alone.parameters["K_d"].verdicts
    page = out.with_suffix(".html").read_text()
    assert "verdict on sigma_d" in page
    assert "determined in 0 % of its values" in page


def test_one_chooser(stack: maps.MapStack, monkeypatch: pytest.MonkeyPatch) -> None:
    """The numbers of `motes.fit` on the same texels, summed; a texel with few samples does not count, nor keep a model out."""
    monkeypatch.setattr("motes.maps.choosing.TEXEL_CANDIDATES", ("lambert", MODEL))
    rows = np.stack([stack.texels(y, x)[0] for y, x in ((0, 0), (2, 2), (3, 4))])
    rows = np.concatenate([rows, rows[:1]])
    rows[3, 1:] = np.nan  # lambert has as many parameters as this has samples
    choice = choose(stack, Settings.of(stack, "auto"), rows)
    assert choice.model == MODEL
    alone = [{m: fit(measured(stack, y, x, 0), m) for m in ("lambert", MODEL)} for y, x in ((0, 0), (2, 2))]
    for trial in choice.tried:
        metrics = [one[trial.model].metrics for one in alone]
        assert trial.bic == pytest.approx(sum(m["bic"] for m in metrics), rel=1e-4)
        assert trial.relative_rms == pytest.approx(np.mean([m["relative_rms"] for m in metrics]), rel=1e-3)
    assert [t.chosen for t in choice.tried] == [False, True]
    small, large = choice.tried
    # On the texels that have enough for both; without the larger where most texels have too few for it.
    assert [t.bic for t in compared([[small, small, None], [None, large, None]])] == [small.bic, large.bic]
    (only,) = compared([[small, small, small], [None, large, None]])
    assert (only.model, only.bic) == ("lambert", pytest.approx(3 * small.bic))
