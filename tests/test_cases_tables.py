"""Situations of users, each with its right outcome: tables as they are written, and measurements as instruments give them.

Each test writes its own input.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

import motes
from motes.directions import HORIZON, above, from_spherical
from motes.measurements import Measurement, policy

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
