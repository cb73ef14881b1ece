"""Soiling: known growth and resets are found again, errors are honest, and the measured mirrors say what they say."""

from __future__ import annotations

import numpy as np
import pytest

import motes
from motes.directions import from_spherical
from motes.errors import DataError, ParameterError
from motes.material import Material
from motes.soiling import Series, Soiling, cleanings, fit_soiling, growth, read_soiling, slant

THETA = np.deg2rad(15)
NOISE = 0.0006


def mirror(
    seed: int, rate: float = 0.005, walk: float = 0.0, resets: tuple[tuple[float, float], ...] = (), readings: int = 12
) -> tuple[Series, np.ndarray]:
    """Simulated readings of `motes.DustLayer` over a mirror with black dust, and the true tau."""
    rng = np.random.default_rng(seed)
    days = np.linspace(0, 6, readings)
    tau = rate * days + np.concatenate([[0], np.cumsum(rng.normal(0, np.sqrt(walk * np.diff(days))))])
    for day, gain in resets:
        tau = tau - gain * (days > day)
    lobe = motes.TorranceSparrow(K_s=1.0, sigma_s=0.05)
    wi, wo = from_spherical(THETA, 0.0), from_spherical(THETA, np.pi)
    offset = 0.2  # dust that is there already at the first reading
    seen = [motes.DustLayer(lobe, motes.Dust(w=0.0), tau=offset + t).eval(wi, wo)[0] for t in tau]
    clean = motes.DustLayer(lobe, motes.Dust(w=0.0), tau=offset).eval(wi, wo)[0]
    R = 0.95 * np.array(seen) / clean + rng.normal(0, NOISE, readings)
    return Series("made up", "2020-01-01", "m", 0.0, days, R, np.full(readings, NOISE)), tau


def test_known_growth_and_resets_are_found() -> None:
    truth = ((2.2, 0.015), (4.5, 0.010))
    z, found, gains = [], 0, []
    for seed in range(60):
        series, tau = mirror(seed, walk=1e-6, resets=truth)
        fit = fit_soiling(series)
        z.append((fit.rate - 0.005) / fit.rate_stderr)
        if [round(r.days, 1) for r in fit.resets] == [1.9, 4.6] or len(fit.resets) == 2:
            found += 1
            assert all(r.before < day < r.after for r, (day, _) in zip(fit.resets, truth, strict=True))
            gains += [(r.gain - gain) / r.stderr for r, (_, gain) in zip(fit.resets, truth, strict=True)]
        mean, error = fit.tau(series.days)
        assert np.all(np.abs(mean - tau) < 5 * error + 1e-9)
    assert found >= 57
    assert 0.6 < np.std(z) < 1.4
    assert abs(np.mean(z)) < 0.4
    assert 0.6 < np.std(gains) < 1.4


@pytest.mark.parametrize("walk", [0.0, 1e-6, 4e-6])
def test_errors_are_honest_and_resets_are_not_invented(walk: float) -> None:
    fits = [fit_soiling(mirror(seed, walk=walk)[0]) for seed in range(80)]
    z = np.array([(f.rate - 0.005) / f.rate_stderr for f in fits])
    assert np.std(z) < 1.35
    assert np.mean(np.abs(z) < 2) > 0.9
    assert sum(bool(f.resets) for f in fits) <= 8
    if walk > 0:
        assert np.std(z) > 0.65  # nor are they too wide


def test_band_opens_beyond_the_last_reading_and_is_narrow_at_one() -> None:
    fit = fit_soiling(mirror(5, walk=4e-6)[0])
    _, error = fit.tau(np.array([0.0, 3.0, 3.27, 3.27 + 0.27, 8.0, 20.0]))
    assert error[0] == 0
    assert error[-1] > error[-2] > error[2]
    _, at, between = (
        fit.tau(fit.series.days[6])[1],
        fit.tau(fit.series.days[6])[1],
        fit.tau(0.5 * (fit.series.days[6] + fit.series.days[7]))[1],
    )
    assert between > at
    np.testing.assert_allclose(fit.attenuation(4.0), np.exp(-fit.tau(4.0)[0] * slant(THETA)))


def test_the_trend_ages_a_material() -> None:
    fit = fit_soiling(mirror(1)[0])
    trend = fit.trend(days=10)
    material = Material(motes.DustLayer(motes.Lambert(0.2), tau=0.0), trends={"tau": trend})
    assert material.at(24.0).parameters["tau"] == pytest.approx(fit.rate)
    assert trend.stderr(240.0)[0] == pytest.approx(10 * fit.rate_stderr)


def test_means_by_site_and_cleanings() -> None:
    series = [mirror(k, rate=0.004)[0] for k in range(6)]
    (row,) = growth([fit_soiling(s) for s in series])
    assert (row.mirrors, row.resets) == (6, 0)
    assert abs(row.rate - 0.004) < 4 * row.stderr
    first, second = (
        series[0],
        Series("made up", "2020-02-01", "m", 0.0, series[1].days, series[1].reflectance, series[1].stderr, None, 31.0),
    )
    ((a, b, gain, error),) = cleanings([second, first])
    assert (a, b) == (first, second)
    assert abs(gain - 0.024) < 5 * error


def test_slant_is_that_of_the_dust_layer() -> None:
    wi, wo = from_spherical(0.3, 0.0), from_spherical(1.1, 2.0)
    base = motes.Lambert(0.7)
    ratio = motes.DustLayer(base, motes.Dust(w=0.0), tau=0.4).eval(wi, wo) / base.eval(wi, wo)
    np.testing.assert_allclose(ratio, np.exp(-0.4 * slant(0.3, 1.1)), rtol=1e-12)
    with pytest.raises(ParameterError, match="horizon"):
        slant(15.0)


@pytest.mark.parametrize(
    ("days", "R", "error", "message"),
    [
        ([0, 1], [0.9, 0.8], [0.01, 0.01], "three or more"),
        ([0, 1, 1], [0.9, 0.8, 0.8], [0.01] * 3, "do not go forward"),
        ([0, 1, 2], [95, 94, 93], [0.01] * 3, "outside"),
        ([0, 1, 2], [0.9, 0.8, 0.7], [0.01, 0, 0.01], "positive error"),
    ],
)
def test_bad_series_are_named(days: list[float], R: list[float], error: list[float], message: str) -> None:
    with pytest.raises(DataError, match=message):
        Series("s", "c", "m", 0.0, np.array(days, float), np.array(R, float), np.array(error, float))


# ------------------------------------------------------------ the measured mirrors


@pytest.fixture(scope="module")
def fits() -> list[Soiling]:
    pytest.importorskip("mirror_soiling_data", reason="the package mirror-soiling-data is not installed")
    pytest.importorskip("openpyxl", reason="the package openpyxl is not installed")
    return [fit_soiling(one) for one in read_soiling()]


def test_all_sites_are_read(fits: list[Soiling]) -> None:
    assert {f.series.site for f in fits} == {"ablrf", "mount_isa", "port_augusta", "qut", "wodonga"}
    assert len(fits) >= 100
    first = next(
        f.series
        for f in fits
        if (f.series.site, f.series.campaign, f.series.mirror) == ("qut", "2017-08-07", "Mirror_1")
    )
    assert first.tilt_deg == 0
    assert first.reflectance[0] == pytest.approx(0.9218888888888889)
    assert first.days[1] == pytest.approx(42954.743055555555 - 42954.479166666664)


def test_rain_resets_every_mirror_at_wodonga(fits: list[Soiling]) -> None:
    rainy = [f for f in fits if (f.series.site, f.series.campaign) == ("wodonga", "2022-02-20")]
    assert len(rainy) == 5
    for fit in rainy:  # two rainy gaps in eleven; every reset lies in one of them, and the first is seen by all
        assert fit.series.rained is not None
        assert int(fit.series.rained.sum()) == 2
        assert fit.resets
        assert all(reset.rained for reset in fit.resets)
        assert fit.resets[0].gain > 5 * fit.resets[0].stderr
    dry = [f for f in fits if (f.series.site, f.series.campaign) == ("wodonga", "2022-04-21")]
    assert not any(f.resets or f.series.rained.any() for f in dry)


def test_steeper_mirrors_gather_less(fits: list[Soiling]) -> None:
    rows = {(g.site, g.tilt_deg): g for g in growth(fits)}
    for site, flat, steep in (
        ("wodonga", 0.0, 60.0),
        ("mount_isa", 0.0, 85.0),
        ("qut", 0.0, 65.0),
        ("port_augusta", 0.0, 90.0),
    ):
        assert rows[site, flat].rate > rows[site, steep].rate
    assert rows["mount_isa", 0.0].rate - rows["mount_isa", 90.0].rate > 3 * np.hypot(
        rows["mount_isa", 0.0].stderr, rows["mount_isa", 90.0].stderr
    )
