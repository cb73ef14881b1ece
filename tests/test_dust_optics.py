"""Real dusts: the numbers follow from what their sources say of index and sizes, and they do what materials need."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.special import spherical_jn, spherical_yn

import mie
import motes as library
from motes.channels import RGB
from motes.errors import ParameterError
from motes.models.dust_optics import DUSTS, RGB_WAVELENGTHS, dust_optics

ROOT = Path(__file__).resolve().parents[1]
SIZES = {  # mode radius, sigma, smallest and largest radius [µm], as the sources state
    "desert": (0.5, 2.2, 0.02, 5.0),
    "desert_coarse": (1.9, 2.15, 0.005, 60.0),
    "sahara": (0.41406, 2.0, 1.25, 2.5),
    "mountain": (0.41406, 2.0, 1.25, 2.5),
    "soil": (0.471, 2.51, 0.005, 20.0),
    "soot": (0.0118, 2.0, 0.005, 20.0),
    "volcanic_ash": (0.16174, 2.8, 1.25, 2.5),
    "mars": (0.41406, 2.0, 1.25, 2.5),
    "snow": (66.298, 1.5, 0.05, 10_000.0),
}
INDEX = {  # n and k at wavelengths [nm], of the same sources
    "desert": {400: (1.53, 0.013), 550: (1.53, 0.0055), 700: (1.53, 0.004)},
    "desert_coarse": {400: (1.53, 0.013), 550: (1.53, 0.0055), 700: (1.53, 0.004)},
    "sahara": {405: (1.5115, 0.01044), 555: (1.5073, 0.003345), 705: (1.5008, 0.0008623)},
    "mountain": {405: (1.525, 0.001275), 555: (1.525, 0.00084), 705: (1.525, 0.000665)},
    "soil": {400: (1.53, 0.008), 550: (1.53, 0.008), 700: (1.53, 0.008)},
    "soot": {400: (1.75, 0.46), 550: (1.75, 0.44), 700: (1.75, 0.43)},
    "volcanic_ash": {405: (1.54, 0.00513), 555: (1.5399, 0.004199), 705: (1.5376, 0.003808)},
    "mars": {405: (1.4977, 0.009151), 555: (1.4995, 0.003394), 705: (1.4966, 0.0009428)},
    "snow": {705: (1.3068, 3.17e-8)},
}


def test_mie_theory_against_its_definition() -> None:
    """The coefficients by SciPy's spherical Bessel functions, and the sphere that is small."""
    for x, m in ((0.7, 1.5 + 0.1j), (6.0, 1.33 + 1e-3j), (25.0, 1.53 + 0.008j), (np.pi, 1.4 + 0j)):
        n = np.arange(1, int(x + 4 * x ** (1 / 3) + 2) + 1)

        def psi(z: complex, n: np.ndarray = n) -> tuple[np.ndarray, np.ndarray]:
            return z * spherical_jn(n, z), spherical_jn(n, z) + z * spherical_jn(n, z, True)

        inner, inner_slope = psi(m * x)
        outer, outer_slope = psi(x + 0j)
        xi = outer + 1j * x * spherical_yn(n, x)
        xi_slope = outer_slope + 1j * (spherical_yn(n, x) + x * spherical_yn(n, x, True))
        a = (m * inner * outer_slope - outer * inner_slope) / (m * inner * xi_slope - xi * inner_slope)
        b = (inner * outer_slope - m * outer * inner_slope) / (inner * xi_slope - m * xi * inner_slope)
        extinction, scattering, _ = mie.sphere(x, m)
        np.testing.assert_allclose(extinction, 2 / x**2 * np.sum((2 * n + 1) * (a + b).real), rtol=1e-7)
        np.testing.assert_allclose(scattering, 2 / x**2 * np.sum((2 * n + 1) * (abs(a) ** 2 + abs(b) ** 2)), rtol=1e-7)
    x, m = 0.01, 1.5 + 0j
    _, scattering, g = mie.sphere(x, m)
    np.testing.assert_allclose(scattering, 8 / 3 * x**4 * ((m**2 - 1) / (m**2 + 2)).real ** 2, rtol=1e-3)  # Rayleigh
    assert abs(g) < 1e-3


@pytest.mark.parametrize("name", DUSTS)
def test_the_numbers_follow_from_their_sources(name: str) -> None:
    """w and g of spheres with the stated index and sizes: no number was mistyped, and no dust mistaken for another."""
    dust = DUSTS[name]
    mode, sigma, smallest, largest = SIZES[name]
    for nm, (n, k) in INDEX[name].items():
        at = dust.wavelengths.index(nm)
        w, g = mie.lognormal(nm / 1000, complex(n, k), mode, sigma, smallest, largest, 80 if name == "snow" else 160)
        assert abs(w - dust.w[at]) < (1e-5 if name == "snow" else 0.006), (nm, w)
        assert abs(g - dust.g[at]) < 0.008, (nm, g)


@pytest.mark.parametrize("name", DUSTS)
def test_tables_are_smooth_and_physical(name: str) -> None:
    """One wrong digit stands out from its neighbours."""
    dust = DUSTS[name]
    assert dust_optics(name) is dust
    assert dust.name == name
    nm, w, g = (np.array(x) for x in (dust.wavelengths, dust.w, dust.g))
    assert len(nm) == len(w) == len(g) >= 3
    assert np.all(np.diff(nm) > 0)
    assert np.all((w > 0) & (w < 1) & (g > 0) & (g < 1))
    for values in (w, g):
        between = values[:-2] + (values[2:] - values[:-2]) * (nm[1:-1] - nm[:-2]) / (nm[2:] - nm[:-2])
        assert np.all(abs(values[1:-1] - between) < 0.03)
    assert "doi:" in dust.source
    assert dust.words
    assert dust.grains
    assert dust.trust.endswith(".")


def test_channels_are_looked_up() -> None:
    sahara = DUSTS["sahara"]
    w, g = sahara.values(RGB)
    red, blue = (
        np.interp(RGB_WAVELENGTHS[0], sahara.wavelengths, sahara.w),
        np.interp(464.2, sahara.wavelengths, sahara.w),
    )
    np.testing.assert_allclose(np.asarray(w)[[0, 2]], [red, blue])
    np.testing.assert_allclose(g, np.interp(RGB_WAVELENGTHS, sahara.wavelengths, sahara.g).mean())
    np.testing.assert_array_equal(np.asarray(sahara.values(("B", "G", "R"))[0]), np.asarray(w)[::-1])
    np.testing.assert_allclose(sahara.values(("405 nm", "1005 nm"))[0], [0.6873, 0.9815])
    np.testing.assert_allclose(sahara.values(("a", "b"), (405, 1005))[0], [0.6873, 0.9815])
    np.testing.assert_allclose(sahara.values(("grey",))[0], np.interp(550, sahara.wavelengths, sahara.w))
    assert isinstance(sahara.values(("a", "b"))[0], float)  # channels that say nothing have no colour
    assert sahara.dust().channels == 3


def test_what_is_not_known_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"405, 1005\] nm"):
        DUSTS["mars"].at(380.0)
    with pytest.raises(ParameterError, match="nan nm is outside"):
        DUSTS["mars"].at([500.0, np.nan])
    with pytest.raises(ParameterError, match="'house' is not a dust") as caught:
        dust_optics("house")
    assert "soot" in str(caught.value.hint)


def test_motes_age_lays_them(motes: Callable[..., tuple[int, str, str]], tmp_path: Path) -> None:
    library.Material(library.Lambert((0.5, 0.4, 0.3)), "card", RGB).save(tmp_path / "card.json")
    command = ("age", tmp_path / "card.json", "-p", "dust", "--hours", 10, "-o", tmp_path / "dusty.json")
    status, told, _ = motes(*command, "--dust", "sahara")
    assert status == 0
    assert "Saharan dust" in told
    dusty = library.load(tmp_path / "dusty.json")
    w, g = DUSTS["sahara"].values(RGB)
    np.testing.assert_allclose(dusty.at(10).parameters["w"], w)
    np.testing.assert_allclose(dusty.at(10).parameters["g"], g)
    for more, expected in (
        (("--dust", "lint"), "Choose one of desert"),
        (("--dust", "soot", "--set", "w=0.5"), "both"),
        (("--dust", "soot", "--from", tmp_path / "card.json"), "both"),
    ):
        status, _, error = motes(*command, *more)
        assert status == 2
        assert expected in error
    status, _, error = motes("age", tmp_path / "card.json", "-p", "drying_paint", "--dust", "soot", "--hours", 2)
    assert status == 2
    assert "--phenomenon dust" in error


def test_the_page_shows_the_table() -> None:
    """Every dust has a row with its values at red, green and blue, its words and its trust."""
    page = (ROOT / "docs" / "real_dusts.md").read_text(encoding="utf-8")
    rows = {row[0]: row for row in re.findall(r"^\| `(\w+)` \| (.*?) \| (.*?) \| (.*?) \|$", page, re.MULTILINE)}
    assert list(rows) == list(DUSTS)
    for name, dust in DUSTS.items():
        w, g = dust.values(RGB)
        digits = 5 if name == "snow" else 2
        shown = ", ".join(f"{x:.{digits}f}" for x in np.asarray(w))
        assert rows[name][1:] == (dust.words, shown, f"{g:.2f}")
        assert f"- `{name}`: {dust.grains}; {dust.source}. {dust.trust}" in page


def test_the_command_names_all_of_them() -> None:
    names = re.compile("`?" + "`?(?:, | or )`?".join(DUSTS) + "`?")
    from motes.cli.age_command import age

    assert names.search(re.sub(r"\s+", " ", age.__doc__ or ""))
    assert names.search((ROOT / "docs" / "cli.md").read_text(encoding="utf-8"))
