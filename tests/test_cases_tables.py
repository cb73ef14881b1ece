"""Situations of users, each with its right outcome: tables as they are written, and measurements as instruments give them.

Each test writes its own input.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import motes
from motes.directions import HORIZON, above, from_spherical
from motes.measurements import READERS, Measurement, policy
from motes.measurements.doubts import implausible

Floats = NDArray[np.float64]
TRUTH = motes.OrenNayar(K_d=(0.55, 0.4, 0.25), sigma_d=0.35) + motes.TorranceSparrow(K_s=0.4, sigma_s=0.2)


def goniometer(theta_i: Sequence[float], theta_r: Sequence[float], phi: Sequence[float]) -> Floats:
    """theta_i, phi_i, theta_r, phi_r (N, 4) [degrees] of a grid."""
    return np.array([(i, 0.0, r, p) for i in theta_i for r in theta_r for p in phi], float)


def evaluated(brdf: Any, angles: Floats, noise: float = 0.0, seed: int = 0) -> Floats:
    """The BRDF (N, C) at angles [degrees] with relative noise; 0 at and below the horizon, where an instrument reads nothing."""
    wi = from_spherical(np.radians(angles[:, 0]), np.radians(angles[:, 1]))
    wo = from_spherical(np.radians(angles[:, 2]), np.radians(angles[:, 3]))
    f = brdf.eval(wi, wo)
    return np.asarray(f * (1 + noise * np.random.default_rng(seed).standard_normal(f.shape)))


def write(path: Path, header: str, rows: ArrayLike, digits: int = 6) -> Path:
    lines = [",".join(f"{x:.{digits}g}" for x in row) for row in np.asarray(rows, float)]
    path.write_text("\n".join([header, *lines]) + "\n")
    return path


HEADER = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,R,G,B"


# ---------------------------------------------------------------- 39: the horizon on rounded numbers


@pytest.mark.parametrize("unit", ["_deg", ""])
@pytest.mark.parametrize("digits", [4, 5, 6, 7, 9, 17])
def test_rows_at_90_degrees_are_at_the_horizon(tmp_path: Path, unit: str, digits: int) -> None:
    angles = goniometer(range(0, 91, 10), range(0, 91, 10), (0, 90, 180))
    f = evaluated(TRUTH, angles, 0.02)
    at_90 = (angles[:, [0, 2]] == 90).any(axis=1)
    f[at_90] = 0.0
    shown = angles if unit else np.radians(angles)
    # four decimals: 1.5708; five: 1.57080; six: 1.570796, which is below pi/2
    lines = [
        ",".join([*(f"{a:.{digits}f}" for a in row), *(f"{x:.6g}" for x in v)]) for row, v in zip(shown, f, strict=True)
    ]
    path = tmp_path / "grid.csv"
    path.write_text("\n".join([HEADER if unit else HEADER.replace("_deg", ""), *lines]) + "\n")
    data = motes.read(path)
    assert isinstance(data, Measurement)
    np.testing.assert_array_equal(~data.mask[0, :, 0], at_90)
    assert dict(data.masked) == {policy.BELOW_HORIZON: 3 * int(at_90.sum())}


def test_rows_at_90_degrees_do_not_change_a_fit(tmp_path: Path) -> None:
    angles = goniometer(range(0, 91, 10), range(0, 91, 10), (0, 90, 180))
    f = evaluated(TRUTH, angles, 0.02)
    inside = (angles[:, [0, 2]] < 90).all(axis=1)
    f[~inside] = np.random.default_rng(1).normal(0, 0.003, (int((~inside).sum()), 3))
    model = "oren_nayar + torrance_sparrow"
    whole = motes.fit(motes.read(write(tmp_path / "a.csv", HEADER, np.hstack([angles, f]))), model=model)
    part = motes.fit(motes.read(write(tmp_path / "b.csv", HEADER, np.hstack([angles, f])[inside])), model=model)
    for name, p in part.parameters.items():
        np.testing.assert_allclose(whole.parameters[name].value, p.value, rtol=1e-6)
    assert whole.metrics["relative_rms"] == pytest.approx(part.metrics["relative_rms"], rel=1e-6)
    assert part.metrics["relative_rms"] < 0.03
    assert abs(whole.parameters["sigma_d"].value - 0.35) < 0.03
    assert abs(whole.parameters["K_s"].value - 0.4) < 0.03


def test_one_epsilon_for_the_horizon() -> None:
    """Models are 0 where measurements are masked."""
    up = from_spherical(0.3, 0.0)
    for cosine, inside in (
        (6e-17, False),
        (3.3e-7, False),
        (0.99 * HORIZON, False),
        (1.01 * HORIZON, True),
        (1e-3, True),
    ):
        w = np.array([[np.sqrt(1 - cosine**2), 0.0, cosine]])
        assert above(w)[0] == inside
        for wi, wo in ((w, up[None]), (up[None], w)):
            assert bool(np.all(TRUTH.eval(wi, wo) > 0)) == inside
            assert bool(np.all(TRUTH.eval(wi, wo) == 0)) != inside
            assert Measurement.from_arrays(wi, wo, [0.2]).mask.all() == inside


# ---------------------------------------------------------------- 43: noise about 0


def test_a_dark_channel_is_not_biased_by_its_negative_noise() -> None:
    """In every channel the truth lies within one standard error as often as it should."""
    angles = goniometer((15, 30, 45, 60), range(0, 70, 5), (0, 60, 120, 180))
    wi, wo = (from_spherical(np.radians(angles[:, k]), np.radians(angles[:, k + 1])) for k in (0, 2))
    K_d = np.array([0.3, 0.02, 0.005])
    within, values = [], []
    for seed in range(240):
        noise = 0.003 * np.random.default_rng(seed).standard_normal((len(angles), 3))
        data = Measurement.from_arrays(wi, wo, K_d / np.pi + noise)
        assert data.mask.all()
        p = motes.fit(data, model="lambert").parameters["K_d"]
        values.append(p.value)
        within.append(np.abs(p.value - K_d) <= p.stderr)
    share = np.mean(within, axis=0)
    assert np.all((share > 0.60) & (share < 0.76)), share
    np.testing.assert_allclose(np.mean(values, axis=0), K_d, atol=4 * 0.0007 / np.sqrt(240))


# ---------------------------------------------------------------- 05: an uncertainty beside the value


@pytest.mark.parametrize("kind", ["brdf_unc", "sigma_brdf", "u(f_r)", "BRDF std", "rel_unc", "uncertainty (%)"])
def test_an_uncertainty_weighs_the_fit(kind: str, tmp_path: Path) -> None:
    brdf = motes.OrenNayar(K_d=0.4, sigma_d=0.35) + motes.TorranceSparrow(K_s=0.4, sigma_s=0.2)
    angles = goniometer((15, 30, 45, 60), range(5, 70, 10), (0, 45, 90, 135, 180))
    f = evaluated(brdf, angles, 0.02, seed=3)
    factor = {"rel_unc": 1 / f, "uncertainty (%)": 100 / f}.get(kind, 1.0)
    u = 0.02 * evaluated(brdf, angles) * factor
    data = motes.read(write(tmp_path / "scan.csv", f"{HEADER[:-5]}brdf,{kind}", np.hstack([angles, f, u])))
    assert data.channels == ("grey",)
    fit = motes.fit(data, model="oren_nayar + torrance_sparrow")
    for name, truth in (("K_d", 0.4), ("sigma_d", 0.35), ("K_s", 0.4), ("sigma_s", 0.2)):
        p = fit.parameters[name]
        assert abs(float(np.ravel(p.value)[0]) - truth) < 4 * float(np.ravel(p.stderr)[0])
        assert float(np.ravel(p.stderr)[0]) < 0.05
    assert 0.7 < fit.metrics["reduced_chi_square"] < 1.35


def test_reduced_chi_square_is_1_and_errors_are_calibrated() -> None:
    angles = goniometer((15, 35, 55), range(0, 70, 10), (0, 90, 180))
    wi, wo = (from_spherical(np.radians(angles[:, k]), np.radians(angles[:, k + 1])) for k in (0, 2))
    truth = motes.OrenNayar(K_d=(0.5, 0.3, 0.1), sigma_d=0.4)
    f = truth.eval(wi, wo)
    sigma = 0.002 + 0.03 * f
    chi, pulls = [], []
    for seed in range(80):
        noise = sigma * np.random.default_rng(seed).standard_normal(f.shape)
        fit = motes.fit(Measurement.from_arrays(wi, wo, f + noise, uncertainties=sigma), model="oren_nayar")
        chi.append(fit.metrics["reduced_chi_square"])
        pulls.append((fit.parameters["K_d"].value - np.array([0.5, 0.3, 0.1])) / fit.parameters["K_d"].stderr)
    assert abs(np.mean(chi) - 1) < 0.1
    assert 0.75 < np.sqrt(np.mean(np.square(pulls))) < 1.25


# ---------------------------------------------------------------- 06: the name of the time


@pytest.mark.parametrize(("name", "unit"), [("hours", 1.0), ("day", 24.0), ("time (min)", 1 / 60), ("t_s", 1 / 3600)])
def test_a_time_by_any_name_gives_scans(name: str, unit: float, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 90, 180))
    hours = np.array([0.0, 2, 4, 8, 16])
    rows = [
        np.hstack(
            [angles, np.full((len(angles), 1), h / unit), evaluated(motes.Lambert((0.1 + 0.01 * h, 0.2, 0.3)), angles)]
        )
        for h in hours
    ]
    data = motes.read(write(tmp_path / "t.csv", HEADER.replace("R,", f"{name},R,"), np.vstack(rows), 12))
    np.testing.assert_allclose(data.times, hours, rtol=1e-9)
    assert data.values.shape == (5, len(angles), 3)
    assert data.channels == ("R", "G", "B")


# ---------------------------------------------------------------- 10: azimuths from the mirror side


def in_plane(path: Path, phi_r: float) -> Path:
    """Signed theta_r, positive on the mirror side; `phi_r` is what the file says of it."""
    rows = []
    for theta_i in (20.0, 40.0, 60.0):
        for theta_r in range(-70, 71, 5):
            true = np.array([[theta_i, 0.0, float(theta_r), 180.0]])
            rows.append(
                [theta_i, theta_r, phi_r, *evaluated(TRUTH, true, 0.01, seed=abs(int(theta_i) * 1000 + theta_r))[0]]
            )
    return write(path, "theta_i_deg,theta_r_deg,phi_r_deg,R,G,B", rows)


def test_a_highlight_on_the_side_of_the_lamp_is_said(motes: Any, tmp_path: Path) -> None:
    wrong, right = in_plane(tmp_path / "wrong.csv", 0.0), in_plane(tmp_path / "right.csv", 180.0)
    said = json.loads(motes("info", wrong, "--json")[1])["findings"]
    assert len(said) == 1
    assert "side of the lamp" in said[0]
    assert "--read azimuth=mirror" in said[0]
    assert json.loads(motes("info", right, "--json")[1])["findings"] == []
    assert json.loads(motes("info", wrong, "--json", "--read", "azimuth=mirror")[1])["findings"] == []
    status, out, _ = motes("fit", wrong, "--no-report", "-m", "oren_nayar + torrance_sparrow", "--fix", "sigma_d=0.35")
    assert status == 0
    assert "azimuth=mirror" in out
    assert any("azimuth=mirror" in text for text in json.loads(Path("motes-wrong/fit.json").read_text())["findings"])


# ---------------------------------------------------------------- 12: one scan of one angle


def test_a_scan_of_one_angle_names_what_is_missing(motes: Any, tmp_path: Path) -> None:
    theta = np.arange(0.0, 80, 2)
    angles = np.stack([theta, 0 * theta, 8 + 0 * theta, 180 + 0 * theta], axis=1)
    f = evaluated(TRUTH, angles, 0.02)[:, :1]
    path = write(tmp_path / "one.csv", "theta_i_deg,brdf", np.hstack([theta[:, None], f]))
    status, _, error = motes("fit", path, "--no-report")
    assert status == 2
    assert "has no column theta_r, phi_r" in error
    reading = ("--read", "theta_r_deg=8", "--read", "phi_r_deg=180")
    status, out, _ = motes("fit", path, "--no-report", *reading, "-m", "oren_nayar + torrance_sparrow")
    assert status == 0
    assert "The viewer is within 8 degrees of the normal" in out


# ---------------------------------------------------------------- what nothing looked at


def flat(tmp_path: Path, values: Floats, header: str = HEADER) -> Measurement:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    data = motes.read(
        write(tmp_path / "t.csv", header, np.hstack([angles, np.broadcast_to(values, (len(angles), values.shape[-1]))]))
    )
    assert isinstance(data, Measurement)
    return data


@pytest.mark.parametrize(
    ("scale", "words"),
    [(np.pi, "=reflectance_factor'"), (100 * np.pi, "=reflectance_factor_percent'"), (1e5, "not in 1/sr")],
)
def test_more_light_out_than_in_is_said(scale: float, words: str, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.3), angles, 0.01)
    data = flat(tmp_path, scale * f)
    said = implausible(data)
    assert len(said) == 1
    assert said[0].startswith("More light out than in")
    assert words in said[0]
    assert implausible(flat(tmp_path, f)) == ()


def test_hardly_any_light_out_is_said(tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.3), angles, 0.01)
    assert implausible(flat(tmp_path, 1e-3 * f)) == ()  # soot
    said = implausible(flat(tmp_path, 1e-6 * f))
    assert said[0].startswith("Hardly any light out")


def test_a_few_directions_that_carry_the_misfit_are_said(tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.4, 0.3, 0.2), sigma_d=0.3), angles, 0.01)
    f[::17] *= 10
    data = flat(tmp_path, f)
    text = motes.fit(data, "oren_nayar").findings[0]
    assert "6 of 56 directions make" in text
    assert "--robust cauchy" in text
    mended = motes.fit(data, "oren_nayar", robust="cauchy")
    assert "cauchy lets them count less" in mended.findings[0]
    np.testing.assert_allclose(mended.parameters["K_d"].value, (0.4, 0.3, 0.2), rtol=0.05)


@pytest.mark.parametrize("full", [255, 4095, 65535])
def test_pixels_and_counts_are_said_to_be_that(full: int, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.3), angles, 0.01)
    said = implausible(flat(tmp_path, np.round(full * f / f.max())))
    assert f"whole numbers up to {full}" in said[0]
    assert "percent" not in said[0]


def test_light_back_to_the_lamp_is_odd_of_a_layer_and_not_of_a_powder(tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    for model in (motes.Hapke(w=0.5, g=-0.4), motes.Dust(w=0.5, g=-0.4)):
        f = evaluated(model, angles, 0.01)
        data = flat(tmp_path, np.broadcast_to(f, (len(angles), 3)))
        said = [s for s in motes.fit(data, model).findings if "back to the lamp" in s]
        assert bool(said) == isinstance(model, motes.Dust)


@pytest.mark.parametrize("filler", [0.0, 9999.0, 1e7])
def test_numbers_that_stand_for_no_reading_are_said_and_left_out_on_request(filler: float, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.3), angles, 0.01)
    f[3 : 3 + (1 if filler else 4), 1] = filler
    said = implausible(flat(tmp_path, f))
    assert "of G" in said[0]
    assert f"--read missing={filler:g}" in said[0].replace("10000000", "1e+07")
    path = next(tmp_path.glob("*.csv"))
    data = motes.read(path, missing=filler)
    assert implausible(data) == ()
    assert sum(data.masked.values()) == (1 if filler else 4)
    K_d = motes.fit(data, "oren_nayar").parameters["K_d"].value
    np.testing.assert_allclose(K_d, (0.8, 0.7, 0.6), rtol=0.02)


@pytest.mark.parametrize("places", [2, 3])
def test_rounded_zeros_and_sharp_highlights_are_no_stand_ins(places: int, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    dark = motes.OrenNayar(K_d=(0.03, 0.02, 0.02), sigma_d=0.3)
    metal = motes.TorranceSparrow(K_s=0.5, sigma_s=0.05)
    for model in (dark, metal):
        f = np.broadcast_to(np.round(evaluated(model, angles, 0.01), places), (len(angles), 3))
        said = implausible(flat(tmp_path, f))
        assert not [s for s in said if "no reading" in s]


def test_constant_and_repeated_columns_are_said(tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    f = evaluated(motes.OrenNayar(K_d=(0.4, 0.3, 0.2), sigma_d=0.3), angles, 0.01)
    f[:, 1] = f[:, 0]
    f[:, 2] = 0.25
    said = " ".join(implausible(flat(tmp_path, f)))
    assert "The same number stands at all directions in B" in said
    assert "R and G hold the same numbers" in said


def test_parameters_beyond_physics_and_poor_fits_are_said() -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 60, 120, 180))
    wi, wo = (from_spherical(np.radians(angles[:, k]), np.radians(angles[:, k + 1])) for k in (0, 2))
    bright = motes.fit(Measurement.from_arrays(wi, wo, evaluated(motes.Lambert(1.4), angles, 0.01)), model="lambert")
    assert any("K_d = 1.4 is above 1" in text for text in bright.findings)
    glossy = evaluated(motes.Lambert(0.1) + motes.TorranceSparrow(K_s=2.0, sigma_s=0.1), angles, 0.01)
    poor = motes.fit(Measurement.from_arrays(wi, wo, glossy), model="lambert")
    assert any(text.startswith("The model misses much") for text in poor.findings)
    assert "--model auto" in " ".join(poor.findings)


def test_a_simulation_says_that_it_is_one(motes: Any) -> None:
    assert motes("simulate", "scans", "--scans", "1", "--step-deg", "10")[0] == 0
    about = json.loads(motes("info", "scans", "--json")[1])
    assert about["simulated"] is True
    assert about["source"].startswith("simulated by Motes")
    status, out, _ = motes("fit", "scans", "-m", "lambert", "--no-report", "-o", "out")
    assert status == 0
    assert "simulated by Motes" in out
    assert json.loads(Path("out/fit.json").read_text())["measurement"]["source"].startswith("simulated")


def test_sources_name_a_layout_and_not_who_measured() -> None:
    for reader in READERS.values():
        assert not reader.source.startswith(("Gu ", "Gu,", "Sun,", "Matusik", "Dana", "Dupuy"))


# ---------------------------------------------------------------- 45: thousands of channels


def test_many_channels_are_read_and_saved_in_little_room(tmp_path: Path) -> None:
    """As many bands as a field spectrometer has, read; some of them fitted and saved."""
    angles = goniometer((35,), range(5, 76, 5), (0, 90, 180, 270))
    bands = np.arange(350, 2501)
    K_d = 0.2 + 0.3 * np.exp(-(((bands - 800) / 400.0) ** 2))
    shape = evaluated(motes.OrenNayar(K_d=1.0, sigma_d=0.35), angles)
    noise = 1 + 0.01 * np.random.default_rng(1).standard_normal((len(angles), len(bands)))
    header = HEADER[:-5] + ",".join(map(str, bands))
    data = motes.read(write(tmp_path / "hyper.csv", header, np.hstack([angles, shape * K_d * noise])))
    assert isinstance(data, Measurement)
    assert data.wavelengths is not None
    np.testing.assert_array_equal(data.wavelengths, bands)
    assert len(data.provenance["columns"]) == 5
    some = Measurement.from_arrays(data.wi, data.wo, data.values[0, :, ::10], wavelengths=bands[::10])
    fit = motes.fit(some, model="lambert")
    fit.save(tmp_path)
    saved = json.loads((tmp_path / "fit.json").read_text())
    assert saved["correlations"] is None
    assert len(saved["strongest_correlations"]) <= 1000
    assert (tmp_path / "fit.json").stat().st_size < 1e6


def test_a_folder_of_results_is_not_taken_over_without_a_word(motes: Any, tmp_path: Path) -> None:
    angles = goniometer((15, 45), range(5, 70, 10), (0, 90, 180))
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        write(tmp_path / folder / "scan.csv", HEADER, np.hstack([angles, evaluated(TRUTH, angles, 0.02)]))
    options = ("-m", "lambert", "--no-report", "--quiet")
    assert "held" not in motes("fit", "a/scan.csv", *options)[2]
    assert "held" not in motes("fit", "a/scan.csv", *options)[2]
    assert "motes-scan/ held the fit of a/scan.csv" in motes("fit", "b/scan.csv", *options)[2]
