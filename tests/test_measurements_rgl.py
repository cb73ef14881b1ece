"""RGL tensor files: evaluation against Mitsuba's ``measured`` BSDF, which shares no code with ours; the measurement."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest

import measurement_files as files
from motes.directions import from_spherical
from motes.errors import FormatError, MotesError
from motes.measurements import read
from motes.measurements._warp import Warp
from motes.measurements.rgl import TensorBRDF
from motes.rendering import load_mitsuba

REAL = ["aurora_white", "cc_ibiza_sunset", "chm_orange", "ilm_solo_m_68", "irid_flake_paint1", "vch_silk_blue"]


def mitsuba_eval(path: Path, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """f_r cos(theta_o) (N, 3) by Mitsuba, in float32."""
    pytest.importorskip("mitsuba")
    mi = load_mitsuba("scalar_rgb")
    bsdf = mi.load_dict({"type": "measured", "filename": str(path)})
    context, interaction = mi.BSDFContext(), mi.SurfaceInteraction3f()
    result = []
    for i, o in zip(wi.tolist(), wo.tolist(), strict=True):
        interaction.wi = i
        result.append(np.array(bsdf.eval(context, interaction, o)).ravel())
    return np.array(result, np.float64)


def directions(n: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Half of them anywhere above the surface, half about the mirror direction; rounded to float32, as in Mitsuba."""
    rng = np.random.default_rng(seed)
    wi = from_spherical(np.arccos(rng.uniform(0.03, 1, n)), rng.uniform(-np.pi, np.pi, n))
    wo = from_spherical(np.arccos(rng.uniform(0.03, 1, n)), rng.uniform(-np.pi, np.pi, n))
    near = wi * [-1, -1, 1] + rng.normal(0, 0.05, (n, 3))
    near[:, 2] = np.maximum(np.abs(near[:, 2]), 0.03)
    wo[n // 2 :] = (near / np.linalg.norm(near, axis=1, keepdims=True))[n // 2 :]
    return wi.astype("f4").astype(float), wo.astype("f4").astype(float)


def assert_like_mitsuba(path: Path, n: int, worst: float, median: float) -> None:
    """Relative differences; against a hundredth of the median where values are smaller than that."""
    wi, wo = directions(n, seed=12)
    theirs = mitsuba_eval(path, wi, wo)
    ours = TensorBRDF.load(path).eval(wi, wo) * wo[:, 2:]
    error = np.abs(ours - theirs) / np.maximum(np.abs(theirs), 0.01 * np.median(np.abs(theirs)))
    assert error.max() < worst
    assert np.median(error) < median
    assert np.count_nonzero(theirs) > 0.95 * theirs.size


@pytest.mark.parametrize("name", REAL)
def test_real_files_agree_with_mitsuba(shared_file, name: str):
    # float32 there against float64 here: 3.7e-4 at worst, on the flanks of the sharpest lobe, and 8e-7 in the median
    assert_like_mitsuba(shared_file(f"rgl/{name}_rgb.bsdf"), n=2400, worst=5e-4, median=2e-6)


@pytest.mark.parametrize("n_phi", [1, 4], ids=["isotropic", "anisotropic"])
@pytest.mark.parametrize("jacobian", [0, 1])
def test_files_written_here_agree_with_mitsuba(tmp_path: Path, n_phi: int, jacobian: int):
    fields = files.rgl_fields(n_phi=n_phi, n_theta=5, size=7)
    fields["jacobian"][0] = jacobian
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(fields))
    assert_like_mitsuba(tmp_path / "a.bsdf", n=1000, worst=2e-5, median=1e-6)


def test_anisotropic_over_half_the_circle_agrees_with_mitsuba(tmp_path: Path):
    fields = files.rgl_fields(n_phi=5)
    fields["phi_i"] = np.linspace(-np.pi, 0, 5).astype("<f4")
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(fields))
    assert_like_mitsuba(tmp_path / "a.bsdf", n=1000, worst=2e-5, median=1e-6)


def test_eval_broadcasts_and_is_zero_below_the_horizon(tmp_path: Path):
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(files.rgl_fields()))
    brdf = TensorBRDF.load(tmp_path / "a.bsdf")
    wi, wo = from_spherical(0.4, 0.1), from_spherical(np.linspace(0, 3, 10).reshape(2, 5), 2.0)
    f = brdf.eval(wi, wo)
    assert f.shape == (2, 5, 3)
    np.testing.assert_array_equal(f[1, 1:], 0)  # theta_o > pi/2
    assert np.all(f[0] > 0)
    assert np.isnan(brdf.eval([np.nan, 0, 1], wi)).all()
    turned = brdf.eval(from_spherical(0.4, 1.1), from_spherical(0.7, 2.3))
    np.testing.assert_allclose(turned, brdf.eval(from_spherical(0.4, 0), from_spherical(0.7, 1.2)), rtol=1e-12)
    with pytest.raises(MotesError, match=r"not \(\.\.\., 3\)"):
        brdf.eval(np.ones(2), np.ones(2))


def test_no_directions_give_no_values(tmp_path: Path):
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(files.rgl_fields()))
    found = TensorBRDF.load(tmp_path / "a.bsdf")
    assert found.eval(np.empty((0, 3)), np.empty((0, 3))).shape == (0, len(found.channels))


def test_spectral_files(tmp_path: Path):
    fields = files.rgl_fields()
    fields["wavelengths"] = np.array([400, 550, 700], "<f4")
    fields["spectra"] = fields.pop("rgb")
    (tmp_path / "spec.bsdf").write_bytes(files.tensor_file(fields))
    fields["rgb"] = fields.pop("spectra")
    (tmp_path / "rgb.bsdf").write_bytes(files.tensor_file(fields))
    spectral, rgb = read(tmp_path / "spec.bsdf", resolution=4), read(tmp_path / "rgb.bsdf", resolution=4)
    assert spectral.wavelengths.tolist() == [400, 550, 700]
    np.testing.assert_array_equal(spectral.values, rgb.values)


def test_warp_samples_its_density_and_inverts():
    rng = np.random.default_rng(13)
    density = rng.uniform(0, 1, (1, 2, 6, 8)) ** 3
    density[0, 0, 2, :4] = 0  # cells without mass, too
    warp = Warp(density)
    s = rng.uniform(0, 1, (5000, 2))
    one = np.zeros(len(s), int)
    for t in (0, 1):
        u, pdf = warp.sample(s, 0, t)
        assert np.all((u >= 0) & (u <= 1))
        np.testing.assert_allclose(warp.invert(u, [(one, one + t, np.ones(len(s)))]), s, atol=1e-9)
        # the mean of 1/pdf over samples of pdf is the area where it is positive
        assert np.mean(1 / pdf) == pytest.approx(1, rel=0.1)
        # moments of the density by quadrature on a fine grid
        fine = (np.arange(400) + 0.5) / 400
        x, y = np.meshgrid(fine, fine)
        grid = bilinear(density[0, t], x, y)
        assert u[:, 0].mean() == pytest.approx((grid * x).sum() / grid.sum(), abs=0.015)
        assert u[:, 1].mean() == pytest.approx((grid * y).sum() / grid.sum(), abs=0.015)


def bilinear(grid: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    scipy = pytest.importorskip("scipy.interpolate")
    ny, nx = grid.shape
    interpolate = scipy.RegularGridInterpolator((np.linspace(0, 1, ny), np.linspace(0, 1, nx)), grid)
    return interpolate(np.stack([y, x], -1))


@pytest.mark.parametrize("name", ["aurora_white", "cc_ibiza_sunset"])
def test_the_sampled_measurement_integrates_like_the_whole(shared_file, name: str):
    """The weights are solid angles: directional albedos by them and by a fine grid of the hemisphere agree."""
    path = shared_file(f"rgl/{name}_rgb.bsdf")
    brdf, m = TensorBRDF.load(path), read(path, resolution=48)
    z, phi = (np.arange(300) + 0.5) / 300, (np.arange(400) + 0.5) / 400 * 2 * np.pi
    grid = from_spherical(np.arccos(z)[:, None], phi)
    for theta in brdf.theta_i[1:5]:
        whole = (brdf.eval(from_spherical(theta, 0.0), grid) * z[:, None, None]).mean(axis=(0, 1)) * 2 * np.pi
        here = np.abs(m.theta_i - theta) < 1e-6
        share = m.weights[here, None] * m.values[0, here] * m.wo[here, 2:]
        around = brdf.theta_i[np.searchsorted(brdf.theta_i, theta) + np.array([-1, 0, 1])]
        polar = -np.diff(np.cos((around[1:] + around[:-1]) / 2))[0]
        np.testing.assert_allclose(share.sum(axis=0) / polar, whole, rtol=0.03)


def test_the_weights_are_solid_angles(tmp_path: Path):
    """At each incidence they measure the hemisphere of outgoing directions, 2 pi, and pi with the cosine."""
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(files.rgl_fields(n_theta=6)))
    theta_i = TensorBRDF.load(tmp_path / "a.bsdf").theta_i
    m = read(tmp_path / "a.bsdf", resolution=256)
    edges = np.concatenate([[0], (theta_i[1:] + theta_i[:-1]) / 2, [np.pi / 2]])
    for theta, low, high in zip(theta_i[:-1], edges[:-1], edges[1:], strict=False):
        here = np.abs(m.theta_i - theta) < 1e-6
        solid_angle = m.weights[here] / (np.cos(low) - np.cos(high))
        assert solid_angle.sum() == pytest.approx(2 * np.pi, rel=0.01)
        assert (solid_angle * m.wo[here, 2]).sum() == pytest.approx(np.pi, rel=0.01)


def test_the_sampled_measurement_covers_the_peak(shared_file):
    path = shared_file("rgl/chm_orange_rgb.bsdf")
    m = read(path)
    assert (m.channels, m.provenance["resolution"]) == (("R", "G", "B"), 32)
    assert m.provenance["name"] == "TeckWrap vinyl wrapping film (Orange CHM11E)"
    brdf = TensorBRDF.load(path)
    for theta in brdf.theta_i[:-1]:
        wi = from_spherical(theta, 0.0)
        mirror = brdf.eval(wi, wi * [-1, -1, 1])
        sampled = m.values[0, np.abs(m.theta_i - theta) < 1e-6]
        assert np.all(sampled.max(axis=0) > 0.5 * mirror)
    assert m.wo[:, 2].min() > 0
    assert m.provenance["dropped"]["grid directions below the horizon"] == 7 * 32 * 32 - m.n_directions
    assert not m.masked


def test_channels_out_of_gamut_are_data(tmp_path: Path):
    fields = files.rgl_fields()
    fields["rgb"][:, :, 2, ::2] *= -1
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(fields))
    m = read(tmp_path / "a.bsdf", resolution=8)
    assert (m.values[..., 2] < 0).any()
    assert m.mask.all()


@pytest.mark.parametrize("resolution", [0, 1, 10_000, 3.5, "x"])
def test_resolutions_out_of_range(tmp_path: Path, resolution):
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(files.rgl_fields()))
    with pytest.raises(MotesError, match="resolution"):
        read(tmp_path / "a.bsdf", resolution=resolution)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"vndf": None}, "no field 'vndf'"),
        ({"rgb": None}, "no field 'rgb'"),
        ({"theta_i": np.array([0, 1, 0.5, 1.5], "<f4")}, "theta_i does not increase"),
        ({"theta_i": np.array([0, 1, 2, 3], "<f4")}, "theta_i spans"),
        ({"theta_i": np.array([0, np.nan, 2, 3], "<f4")}, "theta_i does not increase"),
        ({"vndf": np.zeros((1, 4, 6, 6), "<f4")}, "not a density"),
        ({"vndf": np.full((1, 4, 6, 6), np.nan, "<f4")}, "not a density"),
        ({"vndf": -np.ones((1, 4, 6, 6), "<f4")}, "not a density"),
        ({"vndf": np.ones((1, 3, 6, 6), "<f4")}, "for .* incident directions"),
        ({"vndf": np.ones((1, 4, 1, 6), "<f4")}, "for .* incident directions"),
        ({"rgb": np.ones((1, 4, 2, 5, 5), "<f4")}, "for .* incident directions"),
        ({"ndf": np.ones((4, 4, 4), "<f4")}, "'ndf' has shape"),
    ],
)
def test_damaged_fields(tmp_path: Path, changes: dict, message: str):
    fields = {k: v for k, v in (files.rgl_fields() | changes).items() if v is not None}
    (tmp_path / "a.bsdf").write_bytes(files.tensor_file(fields))
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.bsdf")


def test_absurd_shapes_are_refused_before_anything_is_allocated(tmp_path: Path):
    data = files.tensor_file(files.rgl_fields())
    at = data.index(b"vndf") + 4 + 11
    for shape in ((2**40, 2**40, 2**40, 2**40), (1, 4, 2**20, 2**20), (1, 4, 6, 2**62)):
        (tmp_path / "a.bsdf").write_bytes(data[:at] + struct.pack("<4Q", *shape) + data[at + 32 :])
        with pytest.raises(FormatError, match="truncated: field 'vndf'"):
            read(tmp_path / "a.bsdf")
    (tmp_path / "a.bsdf").write_bytes(data[:14] + struct.pack("<I", 2**32 - 1) + data[18:])
    with pytest.raises(FormatError, match="claims 4294967295 fields"):
        read(tmp_path / "a.bsdf")
    (tmp_path / "a.bsdf").write_bytes(data[:12] + b"\x02\x00" + data[14:])
    with pytest.raises(FormatError, match="version"):
        read(tmp_path / "a.bsdf")
    for n in (13, 17, 30, 100, len(data) - 1):
        (tmp_path / "a.bsdf").write_bytes(data[:n])
        with pytest.raises(FormatError, match=r"truncated|version|no field"):
            read(tmp_path / "a.bsdf")
