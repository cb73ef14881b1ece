"""STAF parameter maps."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial.polynomial import polyval

import measurement_files as files
from motes.errors import FormatError, MissingExtraError, ParameterError
from motes.measurements import ParameterMaps, read

pytest.importorskip("OpenEXR")  # which writes the pictures
pytest.importorskip("OpenImageIO")


def coefficients(size: tuple[int, int] = (3, 4)) -> dict[str, np.ndarray]:
    """Numbers that half floats hold exactly."""
    rng = np.random.default_rng(1)

    def maps(n: int, channels: int) -> np.ndarray:
        return np.broadcast_to(rng.integers(1, 64, (n, *size, channels)) / 64, (n, *size, 3)).copy()

    return {"Diffuse": maps(4, 3), "Specular": maps(3, 1), "Roughness": maps(2, 1)}


def test_maps_are_polynomials_of_time(tmp_path: Path):
    c = coefficients()
    maps = read(files.staf_folder(tmp_path / "tvBTF", c))
    assert isinstance(maps, ParameterMaps)
    assert (maps.shape, maps.names, maps.name) == ((3, 4), ("Diffuse", "Specular", "Roughness"), "tvBTF")
    for t in (0.0, 0.3, 1.0):
        raw = maps.raw(t)
        np.testing.assert_allclose(raw["Diffuse"], polyval(t, c["Diffuse"]), rtol=1e-12)
        np.testing.assert_allclose(raw["Specular"], polyval(t, c["Specular"])[..., 0], rtol=1e-12)
        R, S = raw["Roughness"], raw["Specular"]
        at = maps.at(t)
        assert (at["K_d"].shape, at["K_s"].shape, at["sigma_s"].shape) == ((3, 4, 3), (3, 4), (3, 4))
        np.testing.assert_allclose(at["sigma_s"], R, rtol=1e-12)
        np.testing.assert_allclose(at["K_s"], S / (np.pi * R**2 * (1 - np.exp(-1 / R**2))), rtol=1e-12)
        assert maps.mean(t)["Roughness"] == pytest.approx(R.mean())
    json.dumps(maps.summary(), allow_nan=False)
    with pytest.raises(ParameterError, match=r"t = 1.5 is outside \[0, 1\]"):
        maps.at(1.5)
    with pytest.raises(ParameterError):
        maps.at(float("nan"))
    with pytest.raises(ValueError, match="read-only"):
        maps.coefficients["Diffuse"][0] = 0


def test_polynomials_are_clamped_at_0_and_no_roughness_is_no_highlight(tmp_path: Path):
    c = coefficients()
    c["Diffuse"][0, 0, 0], c["Specular"][0, 0, 1], c["Roughness"][0, 0, 2] = -4, -4, -4
    c["Roughness"][0, 0, 3] = c["Roughness"][1, 0, 3] = 0
    maps = read(files.staf_folder(tmp_path, c))
    assert maps.raw(0.5)["Diffuse"][0, 0].max() < 0
    at = maps.at(0.5)
    np.testing.assert_array_equal(at["K_d"][0, 0], 0)
    assert at["K_s"][0, 1] == 0
    for x in (2, 3):
        assert (at["sigma_s"][0, x], at["K_s"][0, x]) == (0, 0)
    assert np.all(np.isfinite(at["K_s"]))
    assert maps.summary()["clamped_at_0"]["Roughness"] == 12  # two texels at six times


def test_specular_may_have_colours_but_roughness_may_not(tmp_path: Path):
    c = coefficients()
    c["Specular"][0, ..., 1] *= 2
    assert read(files.staf_folder(tmp_path / "a", c)).at(0)["K_s"].shape == (3, 4, 3)
    c["Roughness"][0, ..., 1] *= 2
    with pytest.raises(FormatError, match="Roughness has colours"):
        read(files.staf_folder(tmp_path / "b", c))


def test_the_library_is_quiet_about_damage(tmp_path: Path, capfd: pytest.CaptureFixture[str]):
    folder = files.staf_folder(tmp_path, coefficients((64, 64)))
    data = (folder / "Diffuse-0.exr").read_bytes()
    (folder / "Diffuse-0.exr").write_bytes(data[:-40])
    with pytest.raises(FormatError, match="cannot be decoded"):
        read(folder)
    assert capfd.readouterr() == ("", "")


def test_incomplete_and_damaged_folders(tmp_path: Path):
    folder = files.staf_folder(tmp_path / "a", coefficients())
    with pytest.raises(FormatError, match="Give the folder"):
        read(folder / "Diffuse-0.exr")
    (folder / "Diffuse-1.exr").rename(folder / "x")
    with pytest.raises(FormatError, match=r"Diffuse for the powers \[0, 2, 3\]"):
        read(folder)
    (folder / "x").rename(folder / "Diffuse-1.exr")
    files.write_exr(folder / "Specular-1.exr", np.ones((3, 5, 3)))
    with pytest.raises(FormatError, match=r"is \(3, 5\) and the maps before it \(3, 4\)"):
        read(folder)
    files.write_exr(folder / "Specular-1.exr", np.full((3, 4, 3), np.nan))
    with pytest.raises(FormatError, match="not finite"):
        read(folder)
    good = (folder / "Specular-0.exr").read_bytes()
    for damaged in (b"", good[:7], good[:200], good[:-10], b"x" * 500):
        (folder / "Specular-1.exr").write_bytes(damaged)
        with pytest.raises(FormatError):
            read(folder)
    # a header that claims 2^31 pixels is refused before it is decoded
    at = good.index(b"dataWindow") + len(b"dataWindow\0box2i\0") + 4
    (folder / "Specular-1.exr").write_bytes(good[: at + 8] + b"\xb0\xb3\0\0" * 2 + good[at + 16 :])
    with pytest.raises(FormatError, match=r"MiB of memory|cannot be decoded"):
        read(folder)
    for name in ("Roughness-0.exr", "Roughness-1.exr"):
        (folder / name).unlink()
    with pytest.raises(FormatError, match=r"Roughness for the powers \[\]"):
        read(folder)


def test_without_the_library_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    folder = files.staf_folder(tmp_path, coefficients())
    monkeypatch.setitem(__import__("sys").modules, "OpenImageIO", None)
    with pytest.raises(MissingExtraError, match=r"OpenImageIO.*pip install.*\[exr\]"):
        read(folder)


def test_nothing_is_claimed_that_the_files_do_not_say(tmp_path: Path):
    plain = read(files.staf_folder(tmp_path / "a", {**coefficients(), "Roughness": np.full((1, 3, 4, 3), 0.125)}))
    assert "do not say whose it is" in plain.provenance["source"]
    assert not any("texture" in note or "not read" in note for note in plain.provenance["notes"])
    c = coefficients() | {"Height": np.ones((2, 3, 4, 3)), "Normal": np.ones((1, 3, 4, 3))}
    notes = read(files.staf_folder(tmp_path / "b", c)).provenance["notes"]
    assert notes[0] == "not read, for the model has no place for it: Height-0.exr, Height-1.exr, Normal-0.exr"
    assert "look like those of a texture set" in notes[1]
    smooth = read(files.staf_folder(tmp_path / "c", {**coefficients(), "Roughness": np.full((1, 3, 4, 3), 0.75)}))
    assert "a Roughness (mean 0.75 at t = 0)" in smooth.provenance["notes"][0]


def test_real_means(shared_file):
    """The table that documents the data, of the polynomials before the clamp, to its three digits."""
    maps = read(shared_file("staf-tvBTF45"))
    assert maps.shape == (460, 460)
    table = {
        "Roughness": (0.065, 0.14, 0.18, 0.203, 0.227, 0.272),
        "Specular": (0.202, 0.078, 0.026, 0.016, 0.019, 0.006),
    }
    for name, means in table.items():
        for t, mean in zip((0, 0.2, 0.4, 0.6, 0.8, 1), means, strict=True):
            assert round(maps.mean(t)[name], 3) == mean
    at = maps.at(1)
    assert at["K_s"].min() >= 0
    assert np.all(np.isfinite(at["K_s"]))
