"""Fits of maps: right values, blocks, resuming, failures, trends, pictures."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")
import xarray

import maps_support as support
from maps_support import BLOCK, MODEL
from motes import maps, read
from motes.errors import DataError, FormatError, MotesError
from motes.fitting import fit
from motes.fitting.texels import TexelSolver
from motes.maps import plan as plans
from motes.maps import settings
from motes.maps import staf_layout as exr
from motes.maps.comparison import compare, quartiles
from motes.maps.work import fit_block, write_block
from motes.measurements import Measurement, ParameterMaps


@pytest.fixture(scope="module")
def paint(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """24 x 20 texels, 3 times, 28 directions, 1 % noise."""
    path = tmp_path_factory.mktemp("maps") / "paint.zarr"
    return maps.simulate_map(path, (24, 20), times=3, lights=14, chunk=8).path


@pytest.fixture(scope="module")
def fitted(paint: Path, tmp_path_factory: pytest.TempPathFactory) -> maps.FittedMap:
    return maps.fit_map(paint, MODEL, out=tmp_path_factory.mktemp("fits") / "paint.zarr", block=BLOCK)


def again(fitted: maps.FittedMap, paint: Path, out: Path, **options: Any) -> maps.FittedMap:
    """A further run with the settings of the fixture."""
    return maps.fit_map(paint, MODEL, out=out, **{"block": BLOCK, **options})


def undone(fitted: maps.FittedMap, to: Path, blocks: list[tuple[int, int]]) -> Path:
    """A copy in which some blocks are not done, and hold nonsense."""
    path = support.copy(fitted.path, to)
    group = maps.zarrs.open_group(path, "r+")
    for block in blocks:
        group["run/done"][block] = 0
        for name in ("K_d", "status"):
            group[name][fitted.blocks.slices(block)] = 77
    return path


# ---------------------------------------------------------------- values


def test_maps_are_as_right_as_their_errors_say(paint: Path, fitted: maps.FittedMap) -> None:
    stack = maps.open_map(paint)
    assert fitted.counts()["converged"] == 24 * 20 * 3
    found = compare(fitted, stack)
    assert set(found) == {"K_d", "sigma_d", "K_s", "sigma_s"}
    for name, numbers in found.items():
        # 95.4 % of normal errors; somewhat less of errors that are estimated from 84 samples
        assert 0.9 < numbers["within_2_stderr"] < 0.975, name
        assert abs(numbers["bias"]) < 0.2 * numbers["rms_error"] + 1e-3, name
    assert found["K_d"]["median_error"] < 0.005 * found["K_d"]["median_truth"]
    assert float(np.median(fitted.read_map("relative_rms"))) == pytest.approx(0.01, rel=0.1)


def test_one_solver_finds_the_starts_and_fits_the_texels(
    paint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[TexelSolver] = []

    def counted(*arguments: Any, **options: Any) -> TexelSolver:
        made.append(TexelSolver(*arguments, **options))
        return made[-1]

    monkeypatch.setattr(settings, "TexelSolver", counted)
    held = {"sigma_s": 0.17}
    first = maps.fit_map(paint, MODEL, out=tmp_path / "first.zarr", block=BLOCK, fixed=held)
    assert len(made) == 1
    other = maps.fit_map(paint, MODEL, out=tmp_path / "other.zarr", block=BLOCK, fixed={"sigma_s": 0.18})
    assert len(made) == 2
    assert (first.read_map("K_s") != other.read_map("K_s")).any()


def test_a_texel_is_what_motes_fit_finds(paint: Path, fitted: maps.FittedMap) -> None:
    stack = maps.open_map(paint)
    for y, x, t in ((0, 0, 0), (13, 7, 1), (23, 19, 2)):
        alone = fit(Measurement.from_arrays(stack.wi, stack.wo, stack.texels(y, x)[t], channels=("R", "G", "B")), MODEL)
        for name, parameter in alone.parameters.items():
            value = fitted.values(name)[y, x, t]
            stderr = fitted.read_map(f"{name}_stderr")[y, x, t]
            assert np.all(np.abs(value - parameter.value) < 0.05 * parameter.stderr), name
            # `motes.fit` allows for leverage (HC3), which is up to a fifth for the highlight with 84 samples.
            np.testing.assert_allclose(stderr, parameter.stderr, rtol=0.25)


def test_the_store_follows_the_conventions(fitted: maps.FittedMap) -> None:
    data = xarray.open_zarr(fitted.path)
    assert data.K_d.dims == ("y", "x", "time", "channel")
    for name in ("sigma_d", "K_d_stderr", "relative_rms", "status"):
        assert data[name].dims[:3] == ("y", "x", "time")
    assert data.sigma_d.attrs["units"] == "rad"
    flags = dict(zip(data.status.attrs["flag_meanings"].split(), data.status.attrs["flag_values"], strict=True))
    assert flags == {"converged": 0, "max_iterations": 1, "no_data": 2, "failed": 3, "not_fitted": 255}
    assert (data.status == 0).all()
    assert data.attrs["conventions"]["angles"] == "radians"
    assert fitted.to_xarray().K_d.sel(channel="B").shape == (24, 20, 3)
    json.dumps(fitted.summary(), allow_nan=False)


def test_materials_of_texels(paint: Path, fitted: maps.FittedMap) -> None:
    material = fitted.material(3, 4)
    assert material.channels == ("R", "G", "B")
    for k, hours in enumerate(fitted.hours):
        np.testing.assert_allclose(material.at(hours).parameters["K_d"], fitted.values("K_d")[3, 4, k], rtol=1e-6)
    with pytest.raises(DataError, match="outside the map"):
        fitted.material(24, 0)


def test_numbers_of_whole_maps(fitted: maps.FittedMap) -> None:
    low, middle, high, stderr = quartiles(fitted)["sigma_s"]
    values = fitted.read_map("sigma_s")
    np.testing.assert_allclose([low, middle, high], np.quantile(values.astype(float), (0.25, 0.5, 0.75)), rtol=1e-6)
    assert 0 < stderr < low
    with pytest.raises(MotesError, match="no map 'tau'"):
        fitted.read_map("tau")
    with pytest.raises(MotesError, match="no parameter 'tau'"):
        fitted.values("tau")


# ---------------------------------------------------------------- blocks and resuming


def test_results_do_not_depend_on_blocks(paint: Path, fitted: maps.FittedMap, tmp_path: Path) -> None:
    # The starts come from texels that depend on the blocks; with the same starts all is the same.
    whole = maps.open_map(fitted.path)
    solver, stack = whole.plan.solver, maps.open_map(paint)
    everything = solver.fit(stack.read_block((0, 0)).reshape(-1, *stack.sizes[1:]), whole.plan.starts)
    assert everything.x[:, :3].tobytes() == np.asarray(whole.read_map("K_d")).reshape(-1, 3).tobytes()
    assert everything.stderr[:, 3].tobytes() == np.asarray(whole.read_map("sigma_d_stderr")).ravel().tobytes()


def test_a_rerun_does_only_what_is_not_done(
    paint: Path, fitted: maps.FittedMap, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[tuple[int, int]] = []

    def counted(whole: Any, block: tuple[int, int], fit: Any) -> Any:
        done.append(block)
        return write_block(whole, block, fit)

    monkeypatch.setattr("motes.maps.run.write_block", counted)
    path = undone(fitted, tmp_path / "a.zarr", [(0, 1), (2, 2)])
    (path / "K_d" / "c" / "x.deadbeef.partial").write_bytes(b"left by a killed process")
    steps: list[tuple[int, int, str]] = []
    again(fitted, paint, path, progress=lambda *step: steps.append(step))
    assert done == [(0, 1), (2, 2)]
    assert support.contents(path) == support.contents(fitted.path)
    assert not list(path.rglob("*.partial"))
    first, last = steps[1], steps[-1]
    assert first[:2] == (24 * 20 - 64 - 8 * 4, 24 * 20)
    assert last[:2] == (24 * 20, 24 * 20)
    done.clear()
    again(fitted, paint, path)
    assert done == []


def test_an_interrupt_keeps_finished_blocks(
    paint: Path, fitted: maps.FittedMap, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = undone(fitted, tmp_path / "a.zarr", [(0, 0), (0, 1), (0, 2), (1, 0)])
    calls = 0

    def interrupted(*arguments: Any) -> Any:
        nonlocal calls
        calls += 1
        if calls == 3:
            raise KeyboardInterrupt
        return fit_block(*arguments)

    with monkeypatch.context() as patch:
        patch.setattr("motes.maps.run.fit_block", interrupted)
        with pytest.raises(KeyboardInterrupt):
            again(fitted, paint, path)
    assert (~maps.open_map(path).done()).sum() == 2
    again(fitted, paint, path)
    assert support.contents(path) == support.contents(fitted.path)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"model": "lambert"}, 'model was "oren_nayar + torrance_sparrow" and is "lambert"'),
        ({"loss": "plain"}, "loss"),
        ({"fixed": {"K_s": 0.2}}, "fixed"),
        ({"max_theta": 1.0}, "max_theta"),
        ({"robust": "huber"}, 'robust was "none" and is "huber"'),
        ({"time": 1}, "time was null and is 1"),
        ({"covariance": True}, "covariance"),
        ({"block": (16, 8)}, "block"),
        ({"per_channel": ["K_s"]}, "per_channel"),
    ],
)
def test_another_run_is_not_mixed_in(paint: Path, fitted: maps.FittedMap, options: dict[str, Any], words: str) -> None:
    before = support.contents(fitted.path)
    model = options.pop("model", MODEL)
    with pytest.raises(MotesError, match="blocks of another run") as caught:
        maps.fit_map(paint, model, out=fitted.path, **{"block": BLOCK, **options})
    assert words in str(caught.value)
    assert "--restart" in caught.value.hint
    assert support.contents(fitted.path) == before


def test_another_map_is_not_mixed_in(paint: Path, fitted: maps.FittedMap, tmp_path: Path) -> None:
    other = support.copy(paint, tmp_path / "paint.zarr")
    out = undone(fitted, tmp_path / "out.zarr", [(0, 1)])
    again(fitted, other, out)  # only moved: it goes on
    assert support.contents(out) == support.contents(fitted.path)
    values = support.values_of(other)
    values[...] = 2 * np.asarray(values[...])
    with pytest.raises(MotesError, match="the measured values changed"):
        again(fitted, other, out)
    restarted = again(fitted, other, out, restart=True)
    assert np.median(restarted.read_map("K_s") / fitted.read_map("K_s")) == pytest.approx(2, rel=0.02)


def test_what_is_no_fit_is_not_overwritten(paint: Path, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("mine")
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "mine").write_text("mine")
    other = support.copy(paint, tmp_path / "map.zarr")
    for path in (tmp_path / "file", tmp_path / "folder", other):
        for restart in (False, True):
            with pytest.raises(MotesError, match="exists and is not"):
                maps.fit_map(paint, "lambert", out=path, restart=restart)
    assert (tmp_path / "folder" / "mine").read_text() == "mine"
    assert support.contents(other) == support.contents(paint)


# ---------------------------------------------------------------- bad data


def test_nan_and_dead_texels_are_marked(paint: Path, fitted: maps.FittedMap, tmp_path: Path) -> None:
    source = support.copy(paint, tmp_path / "map.zarr")
    values = support.values_of(source)
    data = np.asarray(values[...])
    data[1, 2] = np.nan  # not measured
    data[3, 4] = 0  # dead
    data[5, 6, 1, 2:] = np.nan  # too few at one time
    data[7, 8, 2, ::5] = np.nan  # enough left
    data[9, 10, 0, 4] = -1
    values[...] = data
    out = maps.fit_map(source, MODEL, out=tmp_path / "out.zarr", block=BLOCK)
    status, K_d = out.read_map("status"), out.read_map("K_d")
    expected = np.zeros(status.shape, int)
    expected[1, 2] = expected[3, 4] = expected[5, 6, 1] = 2
    np.testing.assert_array_equal(status, expected)
    assert np.isnan(K_d[expected == 2]).all()
    assert np.isfinite(K_d[expected == 0]).all()
    np.testing.assert_allclose(K_d[9, 10, 0], fitted.read_map("K_d")[9, 10, 0], rtol=0.05)
    assert len(out.material(5, 6).trends["K_d"].hours) == 2
    with pytest.raises(DataError, match="Its status says why"):
        out.material(1, 2)
    # The export needs numbers everywhere: none is no reflectance, one of three is taken from the others.
    pytest.importorskip("OpenEXR")
    maps.export_exr(out, tmp_path / "exr")
    back = read(tmp_path / "exr")
    assert isinstance(back, ParameterMaps)
    np.testing.assert_array_equal(back.at(0)["K_d"][1, 2], 0)
    np.testing.assert_allclose(back.at(1)["K_d"][5, 6], K_d[5, 6, 2], rtol=1e-5)


def test_a_chunk_that_cannot_be_read_is_listed_and_the_rest_is_done(
    paint: Path, fitted: maps.FittedMap, tmp_path: Path
) -> None:
    source = support.copy(paint, tmp_path / "map.zarr")
    file = support.damage(source, "1/0/0/0/0")
    out = maps.fit_map(source, MODEL, out=tmp_path / "out.zarr", block=BLOCK)
    ((block, reason),) = out.failures
    assert block == (1, 0)
    assert reason
    assert (out.read_map("status", out.blocks.slices((1, 0))) == 255).all()
    assert out.done().sum() == 8
    assert out.summary()["failures"][0]["block"] == [1, 0]
    # Mended, the same call does the rest.
    file.write_bytes((paint / "f_r" / "c" / "1/0/0/0/0").read_bytes())
    out = maps.fit_map(source, MODEL, out=tmp_path / "out.zarr", block=BLOCK)
    assert out.failures == ()
    assert out.done().all()
    assert np.isfinite(out.read_map("K_d")).all()


def test_nothing_readable_and_nothing_measured(paint: Path, tmp_path: Path) -> None:
    source = support.copy(paint, tmp_path / "map.zarr")
    values = support.values_of(source)
    values[...] = np.full(values.shape, np.nan, "f4")
    with pytest.raises(DataError, match="none of"):
        maps.fit_map(source, "lambert", out=tmp_path / "out.zarr")
    assert not (tmp_path / "out.zarr").exists()
    broken = support.copy(paint, tmp_path / "broken.zarr")
    for file in (broken / "f_r" / "c").rglob("*"):
        if file.is_file():
            file.write_bytes(b"x")
    with pytest.raises(DataError, match="can be read"):
        maps.fit_map(broken, "lambert", out=tmp_path / "out.zarr")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"model": "paint"}, "not a model"),
        ({"loss": "cubic"}, "is not one of"),
        ({"fixed": ["tau"]}, "no parameter 'tau'"),
        ({"per_channel": ["K_d", "w"]}, "no parameter 'w'"),
        ({"trends": {"K_d": "cyclic"}}, "is not one of"),
        ({"trends": {"w": "linear"}}, "no parameter 'w'"),
        ({"model": "auto", "trends": {"k_d": "linear"}}, "no model that auto tries has a parameter 'k_d'"),
        ({"trends": "auto"}, "not chosen for maps"),
        ({"trends": {"K_d": "linear"}, "time": 1}, "one time has no trend"),
        ({"time": 3}, "outside 0..2"),
        ({"robust": "bisquare"}, "is not one of"),
        ({"weights": [1.0, 2.0]}, "do not fit the map's 28 directions"),
        ({"model": "auto", "fixed": ["K_d"]}, "held without a value"),
        ({"weights": "heavy"}, "is not 'measurement' or 'uniform'"),
        ({"max_theta": 0.0}, "max_theta"),
        ({"max_theta": 0.001}, "none of the 28 directions"),
        ({"block": (0, 4)}, "at least 1"),
        ({"workers": 0}, "cannot work"),
        ({"workers": 2, "scheduler": "tcp://127.0.0.1:1"}, "both"),
    ],
)
def test_bad_options(paint: Path, tmp_path: Path, options: dict[str, Any], words: str) -> None:
    model = options.pop("model", MODEL)
    with pytest.raises(MotesError, match=words):
        maps.fit_map(paint, model, out=tmp_path / "out.zarr", **options)
    assert not (tmp_path / "out.zarr").exists()


def test_damaged_fits_are_explained(fitted: maps.FittedMap, tmp_path: Path) -> None:
    path = support.copy(fitted.path, tmp_path / "a.zarr")
    file = path / "run" / "zarr.json"
    about = json.loads(file.read_text())
    del about["attributes"]["plan"]["starts"]
    file.write_text(json.dumps(about))
    with pytest.raises(FormatError, match="damaged fitted map"):
        maps.open_map(path)
    with pytest.raises(FormatError, match="holds fitted parameters"):
        maps.fit_map(fitted.path, MODEL, out=tmp_path / "b.zarr")
    path = support.copy(fitted.path, tmp_path / "c.zarr")
    file = path / "time" / "zarr.json"
    about = json.loads(file.read_text())
    about["shape"] = [len(fitted.hours) - 1]
    file.write_text(json.dumps(about))
    with pytest.raises(FormatError, match="maps do not go with"):
        maps.open_map(path)


# ---------------------------------------------------------------- options


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("K_d_verdict", {"data_type": "float32", "fill_value": 0.0}),
        ("status", {"data_type": "uint16"}),
        ("sigma_d", {"data_type": "int32", "fill_value": 0}),
        ("K_d", {"shape": [2**20, 2**20, 1, 3]}),
        ("K_d", {"node_type": "nothing"}),
        ("time", {"fill_value": "NaN"}),
        ("status", {"shape": [12], "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": [12]}}}),
    ],
)
def test_maps_of_another_kind_or_size_are_refused(
    fitted: maps.FittedMap, tmp_path: Path, name: str, change: dict[str, Any]
) -> None:
    copy = support.copy(fitted.path, tmp_path / "copy.zarr")
    about = copy / name / "zarr.json"
    about.write_text(json.dumps(json.loads(about.read_text()) | change))
    if name == "time":
        shutil.rmtree(copy / "time" / "c")

    def use() -> None:
        found = maps.open_map(copy)
        assert isinstance(found, maps.FittedMap)
        found.summary()
        found.material(0, 0)

    with pytest.raises((FormatError, DataError)) as caught:
        use()
    assert caught.value.hint


def test_a_map_that_lacks_a_parameter_is_refused(fitted: maps.FittedMap, tmp_path: Path) -> None:
    copy = support.copy(fitted.path, tmp_path / "copy.zarr")
    shutil.rmtree(copy / "sigma_d")
    with pytest.raises(FormatError, match="it lacks sigma_d"):
        maps.open_map(copy)


def test_the_model_may_be_chosen(paint: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("motes.maps.choosing.TEXEL_CANDIDATES", ("lambert", MODEL))
    chosen = maps.fit_map(paint, "auto", out=tmp_path / "a.zarr")
    assert chosen.model == MODEL
    first, second = chosen.plan.tried
    assert (first.model, second.model, first.chosen, second.chosen) == ("lambert", MODEL, False, True)
    assert first.bic > second.bic + 100
    assert second.relative_rms == pytest.approx(0.01, rel=0.1)
    assert first.relative_rms > 5 * second.relative_rms
    assert chosen.quantities == ("K_d", "sigma_d", "K_s", "sigma_s")
    assert [t["bic"] for t in chosen.summary()["tried"]] == [first.bic, second.bic]
    with pytest.raises(MotesError, match="no model that auto tries has a parameter 'alpha'"):
        maps.fit_map(paint, "auto", out=tmp_path / "b.zarr", fixed={"alpha": 0.4})
    with pytest.raises(MotesError, match="nothing to fit"):
        maps.fit_map(
            paint, "auto", out=tmp_path / "b.zarr", fixed=dict.fromkeys(("K_d", "K_s", "sigma_d", "sigma_s"), 0.4)
        )


def test_directions_weights_and_starts_reach_the_solver(paint: Path, tmp_path: Path) -> None:
    from motes import OrenNayar, TorranceSparrow

    stack = maps.open_map(paint)
    near = np.minimum(stack.wi[:, 2], stack.wo[:, 2]) >= np.cos(0.9)
    assert 0 < near.sum() < len(near)
    out = maps.fit_map(paint, MODEL, out=tmp_path / "a.zarr", max_theta=0.9, loss="plain")
    rows = np.ascontiguousarray(stack.texels(2, 3)[:, near])
    direct = TexelSolver(MODEL, stack.wi[near], stack.wo[near], 3, loss="plain").fit(rows, out.plan.starts)
    np.testing.assert_array_equal(out.read_map("sigma_s")[2, 3], direct.x[:, 5])
    model = OrenNayar(K_d=(0.1, 0.2, 0.3), sigma_d=0.5) + TorranceSparrow(K_s=0.4, sigma_s=0.3)
    given = plans.Plan.make(stack, plans.Settings.of(stack, model, weights="uniform"), model)
    np.testing.assert_allclose(given.starts[-1], [0.1, 0.2, 0.3, 0.5, 0.4, 0.3])


def test_trends_are_fitted_over_all_times(tmp_path: Path) -> None:
    stack = maps.create_map(tmp_path / "a.zarr", (5, 4), *maps.simulated.two_views(6), hours=(0, 1, 2, 4), chunk=3)
    start, rng = np.random.default_rng(3).uniform(0.2, 0.6, (5, 4, 3)), np.random.default_rng(4)
    share = np.array([0, 1, 2, 4]) / 4
    K_d = start[:, :, None] * (1 + share[:, None])
    values = K_d[..., None, :] / np.pi * (1 + 0.01 * rng.standard_normal((5, 4, 4, 12, 3)))
    values[1, 1, 2] = np.nan  # one time was not measured: the trend carries over it
    stack.write(0, 0, values)
    out = maps.fit_map(stack, "lambert", out=tmp_path / "out.zarr", trends={"K_d": "linear"})
    assert out.joint
    assert list(out.variables) == ["K_d_start", "K_d_end"]
    assert out.read_map("K_d_start").shape == (5, 4, 3)
    assert out.read_map("status").shape == (5, 4)
    np.testing.assert_allclose(out.read_map("K_d_end"), 2 * start, rtol=0.02)
    np.testing.assert_allclose(out.values("K_d"), K_d, rtol=0.02)
    material = out.material(1, 1)
    np.testing.assert_allclose(material.at(3.0).parameters["K_d"], start[1, 1] * 1.75, rtol=0.02)
    assert material.trends["K_d"].kind == "linear"
    page = out.report(tmp_path / "page.html").read_text()
    assert "fitted together as trends" in page


# ---------------------------------------------------------------- pictures


def test_polynomials_are_least_squares() -> None:
    hours = np.array([1.0, 2.0, 4.0, 5.0, 9.0])
    t = (hours - 1) / 8
    values = np.random.default_rng(5).normal(size=(3, 2, 5))
    found = exr.polynomials(values, hours, 3)
    for y, x in np.ndindex(3, 2):
        np.testing.assert_allclose(found[:, y, x], np.polynomial.polynomial.polyfit(t, values[y, x], 3), rtol=1e-8)
    values[0, 0, 1:] = np.nan
    values[0, 1] = np.nan
    found = exr.polynomials(values, hours, 3)
    np.testing.assert_allclose(found[:, 0, 0], [values[0, 0, 0], 0, 0, 0], atol=1e-12)
    np.testing.assert_array_equal(found[:, 0, 1], 0)


def test_the_staf_reader_reads_the_export_back(fitted: maps.FittedMap, tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    files = maps.export_exr(fitted, tmp_path / "exr")
    assert len(files) == 4 * 3  # quadratics: three times
    back = read(tmp_path / "exr")
    assert isinstance(back, ParameterMaps)
    assert back.shape == (24, 20)
    for k, t in enumerate((0.0, 0.5, 1.0)):
        at = back.at(t)
        np.testing.assert_allclose(at["K_d"], fitted.read_map("K_d")[:, :, k], rtol=1e-5)
        np.testing.assert_allclose(at["sigma_s"], fitted.read_map("sigma_s")[:, :, k], rtol=1e-4)
        np.testing.assert_allclose(at["K_s"], fitted.read_map("K_s")[:, :, k], rtol=1e-4)


def test_models_that_the_layout_cannot_hold(fitted: maps.FittedMap, tmp_path: Path) -> None:
    from dataclasses import replace

    for model, words in (
        ("dust_layer(lambert)", "no place for Lambert under dust"),
        ("lambert + oren_nayar", "one lobe of a kind"),
        ("lambert + torrance_sparrow(fresnel=schlick)", "with F = 1"),
    ):
        other = replace(fitted, plan=replace(fitted.plan, model=model))
        with pytest.raises(MotesError, match=words):
            maps.export_exr(other, tmp_path / "exr")
    assert not (tmp_path / "exr").exists()


def test_facets_and_matte_models_are_exported(paint: Path, fitted: maps.FittedMap, tmp_path: Path) -> None:
    pytest.importorskip("OpenEXR")
    from dataclasses import replace

    from motes import TorranceSparrow

    # The same numbers, understood as those of normalised facets.
    plan = replace(fitted.plan, model="oren_nayar + torrance_sparrow(normalization=facets)")
    maps.export_exr(replace(fitted, plan=plan), tmp_path / "exr")
    at, wi, wo = read(tmp_path / "exr").at(0), maps.open_map(paint).wi, maps.open_map(paint).wo  # type: ignore[union-attr]
    for y, x in ((0, 0), (20, 11)):
        given = {name: float(fitted.read_map(name)[y, x, 0]) for name in ("K_s", "sigma_s")}
        back = TorranceSparrow(K_s=at["K_s"][y, x], sigma_s=at["sigma_s"][y, x])
        true = TorranceSparrow(**given, normalization="facets")
        np.testing.assert_allclose(back.eval(wi, wo), true.eval(wi, wo), rtol=1e-4)
    matte = maps.fit_map(paint, "lambert", out=tmp_path / "c.zarr")
    maps.export_exr(matte, tmp_path / "matte")
    at = read(tmp_path / "matte").at(0)  # type: ignore[union-attr]
    assert at["K_s"].max() == at["sigma_s"].max() == 0
    np.testing.assert_allclose(at["K_d"], matte.read_map("K_d")[:, :, 0], rtol=1e-6)


def test_the_page_shows_every_map(fitted: maps.FittedMap, tmp_path: Path) -> None:
    page = fitted.report(tmp_path / "page.html").read_text()
    assert (tmp_path / "page.png").read_bytes().startswith(b"\x89PNG")
    for words in (*fitted.quantities, "converged: 1,440", "24", "6 h", "data:image/png"):
        assert words in page
    assert "<script" not in page
    assert "http://" not in page.replace("http-equiv", "")
    assert len(page) < 1_000_000
    assert os.path.getsize(tmp_path / "page.png") > 1000


def test_names_are_escaped_on_the_page(paint: Path, tmp_path: Path) -> None:
    source = support.copy(paint, tmp_path / "map.zarr")
    maps.zarrs.open_group(source, "r+").attrs["name"] = "<script>alert(1)</script>"
    out = maps.fit_map(source, "lambert", out=tmp_path / "out.zarr")
    assert "<script" not in out.report(tmp_path / "page.html").read_text()


def test_finished_blocks_are_what_the_store_says(fitted: maps.FittedMap, tmp_path: Path) -> None:
    """The listing of files agrees with Zarr's own reading of the record."""
    path = undone(fitted, tmp_path / "a.zarr", [(0, 1), (2, 2)])
    out = maps.open_map(path)
    assert out.done().shape == (3, 3)
    np.testing.assert_array_equal(out.done(), np.asarray(out.group["run/done"][...]) == 1)
    assert out.done().sum() == 7
