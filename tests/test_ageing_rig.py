"""The simulated rig: what it writes is the documented format, and what is read back is the surface."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from motes import BRDF, Lambert, MotesError, OrenNayar, TorranceSparrow
from motes.ageing import Rig, drying_plaster, simulate
from motes.ageing.plaster import TRENDS
from motes.ageing.rig import CEILING, READ_NOISE
from motes.material import Material
from motes.measurements import Measurement, read

COARSE = Rig(step_deg=6.0)


def scan_lines(folder: Path, scan: int = 1, camera: int = 1) -> list[str]:
    return (folder / "tvBrdf-data" / f"scan{scan:02d}_brdf_camera{camera}_allexposures.txt").read_text().splitlines()


def measured(folder: Path, surface: object, **options: object) -> Measurement:
    data = read(simulate(folder, surface, **{"noise": 0.0, "rig": COARSE, "scans": 2, **options}))  # type: ignore[arg-type]
    assert isinstance(data, Measurement)
    return data


def test_first_record_is_the_documented_one(tmp_path: Path) -> None:
    lines = scan_lines(simulate(tmp_path / "s", Lambert(0.5), scans=1))
    assert lines[0] == "Exposure 0.200000 4.000000 32.000000"
    labels, numbers = zip(
        *((line.split()[0], [float(x) for x in line.split()[1:]]) for line in lines[1:4]), strict=True
    )
    assert labels == ("F", "L", "V")
    np.testing.assert_allclose(numbers[1], (0.978148, 0.0, 0.207912), atol=5e-7)
    np.testing.assert_allclose(numbers[2], (-0.207912, 0.0, 0.978148), atol=5e-7)


def test_folder_is_laid_out_as_documented(tmp_path: Path) -> None:
    folder = simulate(tmp_path / "s", Lambert(0.5), scans=3, rig=COARSE, name="plaster", process="drying")
    names = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
    scans = [f"tvBrdf-data/scan{t:02d}_brdf_camera{v}_allexposures.txt" for t in (1, 2, 3) for v in (1, 2, 3, 4)]
    assert names == [*scans, "tvBrdf-info.txt"]
    pattern = re.compile(r"([FLV])( -?\d\S*){3}")
    for scan in scans:
        first, *records = (folder / scan).read_text().splitlines()
        assert first.startswith("Exposure ")
        assert "".join(pattern.fullmatch(line)[1] for line in records) == "FLV" * (len(records) // 3)  # type: ignore[index]
    info = (folder / "tvBrdf-info.txt").read_text()
    assert "plaster" in info
    assert "drying" in info


def test_blue_comes_first(tmp_path: Path) -> None:
    radiance = [
        float(x)
        for x in scan_lines(simulate(tmp_path / "s", Lambert((0.9, 0.5, 0.1)), noise=0, scans=1))[1].split()[1:]
    ]
    np.testing.assert_allclose(radiance, np.array([0.1, 0.5, 0.9]) / np.pi * np.cos(np.radians(78)), rtol=1e-6)


def test_lamp_sweeps_half_degrees_in_the_plane_of_incidence() -> None:
    wi = Rig().wi
    assert len(wi) == 313  # 156 degrees in half degrees
    assert not wi[:, 1].any()
    np.testing.assert_allclose(np.degrees(np.arctan2(wi[:, 0], wi[:, 2])), np.arange(78, -78.1, -0.5), atol=1e-9)


def test_cameras_see_azimuths_off_the_plane_of_incidence() -> None:
    assert Rig().wo.shape == (4, 3)
    assert np.count_nonzero(Rig().wo[:, 1]) == 2


@pytest.mark.parametrize("irradiance", [1.0, 3.7])
def test_without_noise_the_surface_is_read_back(tmp_path: Path, irradiance: float) -> None:
    rig = Rig(step_deg=3, irradiance=irradiance)
    data = measured(tmp_path / "s", drying_plaster, rig=rig, scans=3, hours=4.0)
    np.testing.assert_allclose(data.times, (0, 2, 4), atol=1e-9)
    assert data.mask.all()
    assert data.channels == ("R", "G", "B")
    for t, hours in enumerate(data.times):
        np.testing.assert_allclose(data.values[t], drying_plaster(float(hours)).eval(data.wi, data.wo), rtol=1e-5)


def test_seeds_reproduce(tmp_path: Path) -> None:
    def text(name: str, seed: int) -> list[list[str]]:
        folder = simulate(tmp_path / name, drying_plaster, scans=2, seed=seed, rig=COARSE)
        return [scan_lines(folder, t, v) for t in (1, 2) for v in (1, 2, 3, 4)]

    first = text("a", 1)
    assert text("b", 1) == first
    other = text("c", 2)
    assert all(x != y for x, y in zip(other, first, strict=True))


def test_noise_is_relative_and_as_large_as_asked(tmp_path: Path) -> None:
    surface = OrenNayar(K_d=(0.6, 0.5, 0.4))
    data = measured(tmp_path / "s", surface, noise=0.05, rig=Rig(), scans=4, seed=3)
    relative = data.values / surface.eval(data.wi, data.wo) - 1
    assert data.values.size > 15_000
    assert relative.std() == pytest.approx(0.05, rel=0.03)
    assert abs(relative.mean()) < 0.001
    bright = data.wi[:, 2] > 0.9
    assert relative[:, bright].std() == pytest.approx(relative[:, ~bright].std(), rel=0.06)


def test_dark_records_keep_a_floor_of_read_noise() -> None:
    radiance = np.full((20_000, 3), 1e-9)
    rig = Rig()
    floor = rig._merge(radiance, 0.02, np.random.default_rng(0)).std()
    longest = READ_NOISE * CEILING * 0.2 / 32
    assert floor == pytest.approx(longest, rel=0.02)
    assert np.array_equal(rig._merge(radiance, 0.0, np.random.default_rng(0)), radiance)


def test_highlights_above_the_shortest_exposure_saturate(tmp_path: Path) -> None:
    mirror = TorranceSparrow(K_s=400.0, sigma_s=0.05)
    data = measured(tmp_path / "s", mirror, rig=Rig(), scans=1)
    radiance = data.values[0] * data.wi[:, 2:]
    true = mirror.eval(data.wi, data.wo) * data.wi[:, 2:]
    assert radiance.max() == pytest.approx(CEILING)
    assert np.count_nonzero(true > CEILING) > 10
    np.testing.assert_allclose(
        radiance, np.broadcast_to(np.minimum(true, CEILING), radiance.shape), rtol=1e-6, atol=1e-8
    )
    assert sum(data.masked.values()) >= 3 * np.count_nonzero(
        true > CEILING
    )  # the reader knows a plateau when it sees one


def test_a_material_and_a_grey_surface_can_be_measured(tmp_path: Path) -> None:
    data = measured(tmp_path / "s", Material(Lambert(0.3), name="card"))
    np.testing.assert_allclose(data.values, 0.3 / np.pi, rtol=1e-6)
    assert data.n_channels == 3


def test_plaster_dries_and_gathers_dust() -> None:
    early, late = drying_plaster(0.0).parameters, drying_plaster(6.0).parameters
    assert set(early) == set(TRENDS)
    assert (late["K_d"] > 2 * early["K_d"]).all()
    assert late["K_s"] < 0.01 * early["K_s"]
    assert late["tau"] > early["tau"] > 0


def brdf_of(channels: int) -> BRDF:
    return Lambert(np.full(channels, 0.5))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"scans": 0}, "0 scans"),
        ({"scans": 10**9}, "records"),
        ({"noise": -0.1}, "noise"),
        ({"noise": float("nan")}, "noise"),
        ({"hours": 0.0}, "0 h"),
        ({"hours": float("inf")}, "inf h"),
        ({"seed": -1}, "seed"),
        ({"surface": brdf_of(31)}, "31 channels"),
    ],
)
def test_what_cannot_be_simulated_is_an_error(tmp_path: Path, options: dict[str, object], words: str) -> None:
    with pytest.raises(MotesError, match=words):
        simulate(tmp_path / "s", **{"surface": Lambert(0.5), "rig": COARSE, **options})  # type: ignore[arg-type]
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "options",
    [
        {"step_deg": 0.0},
        {"step_deg": float("nan")},
        {"irradiance": 0.0},
        {"irradiance": float("inf")},
        {"exposures": ()},
        {"exposures": (1.0, -2.0)},
        {"arm_deg": (90.0, -78.0)},
        {"cameras_deg": ((95.0, 0.0),)},
    ],
)
def test_a_rig_that_cannot_be_built_is_an_error(options: dict[str, object]) -> None:
    with pytest.raises(MotesError):
        Rig(**options)  # type: ignore[arg-type]
