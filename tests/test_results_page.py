"""What the page of results of real materials says: its figures by formulas written down again here, on data that are made here."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import motes
from motes.measurements import Measurement

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))

import leaderboard
import published_fits


@pytest.fixture(scope="module")
def coloured() -> Measurement:
    """A coloured highlight, which one K_s for all channels cannot have, with weights that matter."""
    rng = np.random.default_rng(3)
    z, phi = rng.uniform(0.2, 1, (2, 200)), rng.uniform(0, 2 * np.pi, (2, 200))
    wi, wo = np.stack([np.sqrt(1 - z * z) * np.cos(phi), np.sqrt(1 - z * z) * np.sin(phi), z], axis=-1)
    surface = motes.OrenNayar(K_d=(0.2, 0.3, 0.4), sigma_d=0.3) + motes.TorranceSparrow(
        K_s=(0.6, 0.3, 0.1), sigma_s=0.3
    )
    return Measurement.from_arrays(wi, wo, surface.eval(wi, wo), weights=rng.uniform(0.1, 2, 200))


def test_the_loss_is_what_a_fit_minimises_and_ks_per_channel_is_an_entry_of_its_own(coloured: Measurement) -> None:
    names = ["ON+TS", "ON+TS, K_s per channel"]
    shared, own = leaderboard.fits(coloured, names, None)
    cosines, weights = coloured.wi[:, 2:], np.asarray(coloured.weights).reshape(-1, 1)
    measured = coloured.values[0]
    off, whole = (shared.predicted - measured) * cosines, measured * cosines
    assert leaderboard.weighted(shared) == pytest.approx(np.sqrt((weights * off**2).sum() / (weights * whole**2).sum()))
    alike = np.sqrt((off**2).sum() / (whole**2).sum())
    assert leaderboard.weighted(shared, np.ones(200)) == pytest.approx(alike)
    assert leaderboard.weighted(shared) > 0.05 > 1e-4 > leaderboard.weighted(own)
    assert own.parameters["K_s"].value == pytest.approx([0.6, 0.3, 0.1], rel=1e-3)


def test_the_best_come_first_and_wins_are_counted_among_five() -> None:
    losses = np.tile(np.arange(10.0, 0.0, -1.0), (3, 1))  # the last is the best
    losses[0, 0] = 0.5
    every = {"one": {f"a{k}": np.stack([row, row], axis=-1) for k, row in enumerate(losses)}}
    lines = leaderboard.leaderboard("loss", 0, every, {"ON+TS": (11.9,)})
    assert lines[2].startswith("| layer over EON+GTR, K_s per channel | **1.0** | 1.0 | 3 |")
    assert lines[-1] == "| ON+TS | **10.0** | 10.0 (11.9) | 1 |"
    assert "| layer over EON+GTR | **6.0** | 6.0 | 2 |" in lines


def test_published_fits_by_hand(tmp_path: Path) -> None:
    """At wi = wo = z: D G F / (4 pi cos cos) with all cosines 1, by Ngan's and Löw's conventions."""
    text = "dull = Aggregate(Lambertian(albedo = [0.1,0.2,0.3]), Model({}))\n"
    (tmp_path / "ngan_cooktorrance.fit").write_text(
        text.format("albedo = [0.5,0.5,0.5], roughness = [0.2], eta = [0.04]")
    )
    (tmp_path / "low_lowmicrofacet_E2.fit").write_text(text.format("A = [2,3,4], B = [50], C = [1.5], eta = [1.5]"))
    z, diffuse = np.array([[0.0, 0.0, 1.0]]), np.array([0.1, 0.2, 0.3]) / np.pi
    ngan = (1.0, 1.15, 1.66) * (diffuse + 0.5 * 0.04 / (np.pi * 0.2**2) / np.pi)
    assert published_fits.evaluate(tmp_path, "Ngan, Cook-Torrance", "dull", z, z)[0] == pytest.approx(ngan)
    low = diffuse + np.array([2, 3, 4]) * 0.04 / np.pi
    assert published_fits.evaluate(tmp_path, "Löw, microfacet", "dull", z, z)[0] == pytest.approx(low)
    assert np.isnan(published_fits.evaluate(tmp_path, "Löw, microfacet", "shiny", z, z)).all()
