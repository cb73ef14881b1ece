"""Rusting iron: the STAF maps as materials that follow time."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import motes
from motes.ageing import rusting_material
from motes.ageing.rust import MEAN_K_D, MEAN_R, MEAN_SPECULAR, MEAN_TIMES, control_values, highlight_strength, masked
from motes.directions import from_spherical
from motes.errors import ParameterError
from motes.material import load
from motes.measurements.parameter_maps import ParameterMaps


def small(seed: int = 0) -> ParameterMaps:
    rng = np.random.default_rng(seed)
    shapes = {"Diffuse": (4, 3, 5, 3), "Specular": (4, 3, 5, 1), "Roughness": (4, 3, 5, 1)}
    maps = {name: rng.uniform(-0.05, 0.05, shape).astype(np.float32) for name, shape in shapes.items()}
    for name, base in (("Diffuse", 0.3), ("Specular", 0.2), ("Roughness", 0.2)):
        maps[name][0] += base
    maps["Roughness"][0, 1, 2] = -0.3  # never a highlight
    maps["Roughness"][:, 2, 3, 0] = (-0.05, 0.4, 0, 0)  # none before t = 1/8
    return ParameterMaps(maps, {"name": "small", "source": "made up"})


def test_control_values_are_the_polynomial() -> None:
    powers = np.array([0.3, -0.2, 0.5, 0.1])
    c, t = control_values(powers), np.linspace(0, 1, 7)
    bernstein = sum(c[k] * b * t**k * (1 - t) ** (3 - k) for k, b in enumerate((1, 3, 3, 1)))
    np.testing.assert_allclose(bernstein, np.polynomial.polynomial.polyval(t, powers), rtol=1e-12)


@pytest.mark.parametrize("texel", [(0, 0), (2, 4), (2, 3)])
def test_a_texel_is_the_maps_at_that_texel(texel: tuple[int, int]) -> None:
    maps = small()
    material = rusting_material(maps, texel, hours=(2, 10))
    for t in np.linspace(0, 1, 41):
        now, expected = (
            material.at(2 + 8 * t).parameters,
            {name: value[texel] for name, value in maps.at(float(t)).items()},
        )
        np.testing.assert_allclose(now["K_d"], expected["K_d"], atol=1e-6)
        if expected["sigma_s"] > 0.001:
            assert now["sigma_s"] == pytest.approx(expected["sigma_s"], abs=1e-6)
            assert now["K_s"] == pytest.approx(expected["K_s"], rel=1e-5, abs=1e-6)
        else:
            assert now["K_s"] == 0


def test_texels_without_roughness_are_masked_and_counted(tmp_path: Path) -> None:
    maps = small()
    seen = masked(maps)
    assert seen.counts == (2, 1, 1, 1, 1, 1)
    assert sorted(map(tuple, np.argwhere(~seen.valid))) == [(1, 2), (2, 3)]
    mean = rusting_material(maps)
    assert mean.about["texels_without_roughness"]["0"] == 2
    assert load(mean.save(tmp_path / "m.json")).at(0.3) == mean.at(0.3)
    with pytest.raises(ParameterError, match="nowhere positive"):
        rusting_material(maps, (1, 2))
    with pytest.raises(ParameterError, match="outside the maps of 3 x 5"):
        rusting_material(maps, (3, 0))
    with pytest.raises(ParameterError, match="does not go forward"):
        rusting_material(maps, hours=(2, 2))


def test_specular_is_the_weight_of_the_lobe() -> None:
    # pi R^2 (1 - exp(-1/R^2)) is the integral of D cos over the hemisphere in tan(theta_h) <= 1; to a few per cent the facets' area.
    for R in (0.05, 0.1, 0.2):
        K_s = float(highlight_strength(0.2, R))
        facets = motes.TorranceSparrow(K_s=0.2, sigma_s=R, normalization="facets")
        w = from_spherical(0.3, 0.0)
        printed = motes.TorranceSparrow(K_s=K_s, sigma_s=R)
        assert printed.eval(w, w)[0] == pytest.approx(facets.eval(w, w)[0], rel=0.06)
    assert highlight_strength(0.2, -0.1) == 0
    assert highlight_strength(-0.2, 0.1) == 0


# ------------------------------------------------------------ the measured maps

# R and Specular as documented with the data: means over the map at t = 0, .2, .4, .6, .8, 1.
DOCUMENTED = {
    "Roughness": (0.065, 0.140, 0.180, 0.203, 0.227, 0.272),
    "Specular": (0.202, 0.078, 0.026, 0.016, 0.019, 0.006),
}


@pytest.fixture(scope="module")
def iron(shared: Callable[[str], Path]) -> ParameterMaps:
    pytest.importorskip("OpenEXR", reason="reading STAF maps needs OpenEXR")
    maps = motes.read(shared("data/staf-tvBTF45"))
    assert isinstance(maps, ParameterMaps)
    return maps


def test_mean_trends_reproduce_the_documented_table(iron: ParameterMaps) -> None:
    material = rusting_material(iron)
    for k, t in enumerate(MEAN_TIMES):
        now = material.at(float(t)).parameters
        assert abs(now["sigma_s"] - DOCUMENTED["Roughness"][k]) <= 0.0005
        # Back from K_s to the weight of the lobe.
        weight = now["K_s"] * np.pi * now["sigma_s"] ** 2 * (1 - np.exp(-1 / now["sigma_s"] ** 2))
        assert abs(weight - DOCUMENTED["Specular"][k]) <= 0.0005
        assert abs(iron.mean(float(t))["Specular"] - DOCUMENTED["Specular"][k]) <= 0.0005


def test_defaults_of_rusting_are_the_means(iron: ParameterMaps) -> None:
    raw = [iron.raw(float(t)) for t in MEAN_TIMES]
    np.testing.assert_allclose([r["Roughness"].mean() for r in raw], MEAN_R, atol=0.0005)
    np.testing.assert_allclose([r["Specular"].mean() for r in raw], MEAN_SPECULAR, atol=0.0005)
    np.testing.assert_allclose([r["Diffuse"].mean((0, 1)) for r in raw], MEAN_K_D, atol=0.0005)
    np.testing.assert_allclose(MEAN_R, DOCUMENTED["Roughness"])
    np.testing.assert_allclose(MEAN_SPECULAR, DOCUMENTED["Specular"])


def test_measured_texels_without_roughness(iron: ParameterMaps) -> None:
    assert masked(iron).counts == (24, 0, 0, 0, 0, 0)
