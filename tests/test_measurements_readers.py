"""Each reader against the description of its format: on files written here, and on the real ones in ../shared."""

from __future__ import annotations

import struct
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import format_files
import measurement_files as files
from effort import units
from motes import directions
from motes.errors import FormatError, MotesError
from motes.measurements import READERS, Measurement, Reader, list_samples, policy, read, registry

# ---------------------------------------------------------------- CUReT


def test_curet_angles_samples_and_values(tmp_path: Path):
    angles = files.some_angles(12)
    angles[4] = [0.5, 1.25, 0.9, 1.25]  # equal azimuths: backscatter
    values = {3: list(np.linspace(0.1, 0.9, 12)), 7: [0.2] * 10 + [-0.009, -99]}
    folder = files.curet_folder(tmp_path / "curet", values, angles)
    for path in (folder, folder / "abrdf.dat", folder / "table.txt"):
        m = read(path, sample=3)
        np.testing.assert_allclose(m.values[0, :, 0], values[3], atol=5e-4)
        np.testing.assert_allclose(m.theta_r, angles[:, 0], atol=1e-6)
        np.testing.assert_allclose(m.theta_i, angles[:, 2], atol=1e-6)
    assert m.dphi[4] == pytest.approx(0, abs=1e-6)
    assert m.channels == ("grey",)
    assert list_samples(folder) == ["3", "7"]
    assert dict(read(folder, sample="7").masked) == {policy.NEGATIVE: 1}
    with pytest.raises(FormatError, match=r"has 2 samples.*--sample: 3, 7"):
        read(folder)
    with pytest.raises(FormatError, match=r"no sample 10.*--sample: 3, 7"):
        read(folder, sample=10)
    only = files.curet_folder(tmp_path / "one", {5: values[3]}, angles)
    assert read(only).provenance["sample"] == "5"


def test_curet_table_is_matched_by_its_first_column(tmp_path: Path):
    angles = files.some_angles(12)
    folder = files.curet_folder(tmp_path, {1: list(np.linspace(0.1, 0.9, 12))}, angles)
    expected = read(folder)
    lines = (folder / "table.txt").read_text().splitlines()
    (folder / "table.txt").write_text("\n".join(reversed(lines)))
    np.testing.assert_array_equal(read(folder).wi, expected.wi)


def test_curet_clipped_sample(tmp_path: Path):
    rng = np.random.default_rng(5)
    angles = files.some_angles(60, seed=9)
    values = np.minimum(0.05 + rng.exponential(0.1, 60), 0.8)
    values[[3, 14, 15, 40]] = 1.0
    m = read(files.curet_folder(tmp_path, {1: list(values)}, angles))
    assert dict(m.masked) == {policy.CLIPPED: 4}
    assert m.values[0, 3, 0] == 1.0


def test_curet_bad_files(tmp_path: Path):
    folder = files.curet_folder(tmp_path, {1: [0.5] * 12}, files.some_angles(12))
    table = (folder / "table.txt").read_text()
    for damaged, message in (
        (table.replace("5  ", "5  x", 1), "not a number|has"),
        ("\n".join(table.splitlines()[:-1]), "12 values for the 11 directions"),
        (table.replace("12  ", "13  "), "first column"),
        ("", "empty"),
        (table.replace("1  0", "1  nan  0", 1), "has 6 numbers"),
    ):
        (folder / "table.txt").write_text(damaged)
        with pytest.raises(FormatError, match=message):
            read(folder)
    (folder / "table.txt").unlink()
    with pytest.raises(FormatError, match=r"table\.txt is missing"):
        read(folder)


def test_curet_real(shared_file):
    path = shared_file("curet/abrdf.dat")
    raw = np.loadtxt(path)
    table = np.loadtxt(path.parent / "table.txt")
    samples = list_samples(path)
    assert len(samples) == 41
    for row in raw:
        m = read(path, sample=int(row[0]))
        assert (m.n_directions, m.n_channels) == (205, 1)
        np.testing.assert_array_equal(m.values[0, :, 0], row[1:])
        assert not m.masked  # averaged over channels: no sample repeats its maximum; the negative ones are noise
    assert np.count_nonzero(raw[:, 1:] < 0) > 0
    same = np.abs(table[:, 2] - table[:, 4]) < 1e-9
    assert same.any()
    np.testing.assert_allclose(m.dphi[same], 0, atol=1e-6)
    assert units(lambda: read(path, sample=10)) < 50  # a third of one here


# ---------------------------------------------------------------- Cornell


def test_cornell(tmp_path: Path):
    text = files.cornell_text(9)
    (tmp_path / "paint.brdf").write_text(text)
    m = read(tmp_path / "paint.brdf")
    rows = np.array([line.split() for line in text.splitlines()[-9:]], float)
    np.testing.assert_array_equal(m.values[0], rows[:, 4:])
    np.testing.assert_allclose(m.theta_i, rows[:, 0], atol=1e-12)
    np.testing.assert_allclose(m.theta_r, rows[:, 2], atol=1e-12)
    np.testing.assert_allclose(m.dphi, rows[:, 3], atol=1e-12)
    assert m.wavelengths.tolist() == [400, 550, 700]
    assert m.channels == ("400 nm", "550 nm", "700 nm")
    assert m.name == "Test Paint"


def test_cornell_rows_may_be_broken_over_lines(tmp_path: Path):
    text = files.cornell_text(4)
    (tmp_path / "a.brdf").write_text(text)
    head, tail = text.split("values\n")
    (tmp_path / "b.brdf").write_text(head + "values\n" + tail.replace(" ", "\n", 7))
    np.testing.assert_array_equal(read(tmp_path / "a.brdf").values, read(tmp_path / "b.brdf").values)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("\n3\n", "\n0\n", "starts with '0'"),
        ("\n3\n", "\n999999999\n", "starts with '999999999'"),
        ("\n3\n", "\n5000\n", "truncated"),
        ("400 550", "550 400", "not positive and increasing"),
        ("400 550", "nan 550", "not positive and increasing"),
        ("\n0.", "\nx.", "not a number"),
        ("\n0.", "\n80.", "not angles in radians"),
    ],
)
def test_cornell_bad_files(tmp_path: Path, old: str, new: str, message: str):
    (tmp_path / "a.brdf").write_text(files.cornell_text().replace(old, new, 1))
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.brdf", format="cornell")
    (tmp_path / "b.brdf").write_text(files.cornell_text()[:-5])
    assert read(tmp_path / "b.brdf").n_directions == 9  # a shorter last number is still a number
    (tmp_path / "b.brdf").write_text(files.cornell_text().rsplit(" ", 1)[0])
    with pytest.raises(FormatError, match="truncated or has ragged rows"):
        read(tmp_path / "b.brdf")


@pytest.mark.parametrize("name", ["cayman", "garnet_red", "krylon_blue"])
def test_cornell_real(shared_file, name: str):
    m = read(shared_file(f"cornell/{name}.brdf"))
    assert (m.n_directions, m.n_channels) == (1439, 31)
    np.testing.assert_array_equal(m.wavelengths, np.arange(400, 701, 10))
    assert not m.masked
    np.testing.assert_allclose(np.unique(np.degrees(m.theta_i)), np.arange(10, 81, 10), atol=1e-3)
    # phi_s = +-pi is the specular side: the highlight is there
    brightest = np.argmax(m.values[0, :, 15])
    assert abs(m.dphi[brightest]) == pytest.approx(np.pi, abs=1e-5)
    assert m.theta_r[brightest] == pytest.approx(m.theta_i[brightest], abs=0.07)


# ---------------------------------------------------------------- MERL


@pytest.fixture(scope="module")
def merl_file(tmp_path_factory) -> tuple[Path, dict[int, tuple[float, float, float]]]:
    """A whole MERL table, 34,992,012 bytes of mostly zeros (a sparse file), with numbers in bins drawn at random."""
    path = tmp_path_factory.mktemp("merl") / "test.binary"
    rng = np.random.default_rng(11)
    n = 90 * 90 * 180
    bins = {int(b): tuple(rng.uniform(1, 2, 3)) for b in rng.integers(0, n, 400)}
    with path.open("wb") as file:
        file.write(struct.pack("<3i", 90, 90, 180))
        for b, rgb in bins.items():
            for plane, value in enumerate(rgb):
                file.seek(12 + 8 * (plane * n + b))
                file.write(struct.pack("<d", value))
        file.truncate(34_992_012)
    return path, bins


def merl_index(wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """Where the format says that a pair of directions is looked up, from its definition alone."""
    theta_h, theta_d, phi_d = directions.half_difference(wi, wo)
    phi_d = np.where(phi_d < 0, phi_d + np.pi, phi_d)
    i = np.floor(90 * np.sqrt(theta_h / (np.pi / 2)))
    j = np.floor(90 * theta_d / (np.pi / 2))
    k = np.floor(180 * phi_d / np.pi)
    return (k + 180 * (j + 90 * i)).astype(int)


def test_merl_bins_land_where_the_format_looks_them_up(merl_file):
    path, bins = merl_file
    assert units(lambda: read(path)) < 500  # 70 here
    m = read(path)
    index = merl_index(m.wi, m.wo)
    assert len(np.unique(index)) == m.n_directions
    row_of = {b: i for i, b in enumerate(index.tolist())}
    kept = [b for b in bins if b in row_of]
    assert 200 < len(kept) < 400  # a quarter of all bins lie below the horizon
    for b in kept:
        expected = np.array(bins[b]) * [1, 1.15, 1.66] / 1500
        np.testing.assert_allclose(m.values[0, row_of[b]], expected, rtol=1e-14)
    assert np.count_nonzero(m.values) == 3 * len(kept)


def test_merl_bins_below_the_horizon_are_the_ones_left_out(merl_file):
    path, _ = merl_file
    m = read(path)
    assert m.wi[:, 2].min() > 0
    assert m.wo[:, 2].min() > 0
    i, j, k = np.meshgrid(np.arange(90), np.arange(90), np.arange(180), indexing="ij")
    wi, wo = directions.from_half_difference(
        ((i + 0.5) / 90) ** 2 * np.pi / 2, (j + 0.5) / 90 * np.pi / 2, (k + 0.5) / 180 * np.pi
    )
    above = (wi[..., 2] > 1e-12) & (wo[..., 2] > 1e-12)
    assert m.n_directions == np.count_nonzero(above)
    np.testing.assert_allclose(m.wi, wi[above], atol=1e-14)
    np.testing.assert_allclose(m.wo, wo[above], atol=1e-14)
    assert m.provenance["dropped"] == {"bins below the horizon": 90 * 90 * 180 - m.n_directions}


def test_merl_weights_integrate_over_pairs_of_directions(merl_file):
    """With phi_h integrated out and half of phi_d, the pairs of hemispheres measure (2 pi)^2 / (2 pi) / 2 = pi."""
    m = read(merl_file[0])
    assert m.weights.sum() == pytest.approx(np.pi, rel=3e-4)
    # with both cosines the hemispheres measure pi^2, and pi^2 / (2 pi) / 2 = pi / 4
    assert (m.weights * m.wi[:, 2] * m.wo[:, 2]).sum() == pytest.approx(np.pi / 4, rel=1e-3)
    # and over the half vectors near the normal: d omega_i d omega_o = 4 cos(theta_d) d omega_h d omega_d
    near = np.rad2deg(directions.half_difference(m.wi, m.wo)[0]) < 10
    whole = (1 - np.cos(np.radians(10))) * 2 * np.pi  # all theta_d; a sliver at grazing is below the horizon
    assert m.weights[near].sum() == pytest.approx(whole, rel=0.1)


def test_merl_negative_bins_are_masked(tmp_path: Path):
    data = bytearray(files.merl_bytes(4))
    struct.pack_into("<d", data, 12, -1.0)
    (tmp_path / "a.binary").write_bytes(bytes(data))
    m = read(tmp_path / "a.binary")
    assert dict(m.masked) == {"negative (invalid bin)": 1}
    assert m.values[0, 0, 0] == pytest.approx(-1 / 1500)


@pytest.mark.parametrize(
    ("header", "size", "message"),
    [
        ((90, 90, 180), 1000, "exactly 34,992,012"),
        ((4, 4, 8), -8, "exactly"),
        ((4, 4, 8), 8, "exactly"),
        ((2000, 2000, 4000), 0, "exactly"),
        ((4, 4, 16), 0, "without reciprocity"),
        ((0, 0, 0), 0, "sizes"),
        ((-4, -4, -8), 0, "sizes"),
        ((2**30, 2**30, 2**31 - 1), 0, "sizes"),
        ((5, 4, 8), 0, "sizes"),
    ],
)
def test_merl_bad_headers(tmp_path: Path, header: tuple[int, int, int], size: int, message: str):
    data = struct.pack("<3i", *header) + files.merl_bytes(4)[12:]
    data = data[:size] if size < 0 or size > 100 else data + b"\0" * size
    (tmp_path / "a.binary").write_bytes(data)
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.binary", format="merl")


def test_merl_from_the_tool_that_writes_such_files(shared, tmp_path: Path):
    tool = shared("tools/write_merl.py")
    nets = np.load(shared("data/merl-nbrdf/nets.npz"), allow_pickle=False)
    name = sorted(nets.files)[0]
    subprocess.run([sys.executable, str(tool), str(tmp_path), name], check=True, capture_output=True)
    m = read(tmp_path / f"{name}.binary")
    assert not m.masked  # the tool writes -1 below the horizon only, and the same bins are left out here
    assert m.n_directions == pytest.approx(0.752 * 90 * 90 * 180, rel=2e-3)
    assert m.values.min() >= 0


# ---------------------------------------------------------------- slices of MERL tables


def test_merl_slice_curve(tmp_path: Path):
    (tmp_path / "a.alta").write_text(files.alta_text())
    m = read(tmp_path / "a.alta")
    np.testing.assert_allclose(m.wi[:, 2], np.linspace(1, 0.1, 7), atol=1e-4)
    np.testing.assert_array_equal(m.wi, m.wo)
    np.testing.assert_array_equal(m.values[0], np.tile([0.1, 0.2, 0.3], (7, 1)))
    for old, new, message in (
        ("1 3", "2 3", "Only #DIM 1 3"),
        ("0.1\t0.2", "0.1", "3 numbers"),
        ("1.0000", "1.7", "not a cosine"),
    ):
        (tmp_path / "b.alta").write_text(files.alta_text().replace(old, new, 1))
        with pytest.raises(FormatError, match=message):
            read(tmp_path / "b.alta", format="merl-slice")


def test_merl_slice_picture(tmp_path: Path):
    pytest.importorskip("OpenEXR")
    pixels = np.zeros((512, 512, 3))
    pixels[0, 300], pixels[400, 0] = (0.5, 0.25, 0.125), (1, 2, 4)
    files.write_exr(tmp_path / "slice.exr", pixels)
    m = read(tmp_path / "slice.exr")
    theta_h, theta_d, phi_d = directions.half_difference(m.wi, m.wo)
    np.testing.assert_allclose(phi_d, np.pi / 2, atol=1e-9)
    lit = np.flatnonzero(m.values[0, :, 0])
    np.testing.assert_array_equal(m.values[0, lit], [(0.5, 0.25, 0.125), (1, 2, 4)])
    np.testing.assert_allclose(np.degrees(theta_h[lit]), [300.5 / 512 * 90, 0.5 / 512 * 90], atol=1e-9)
    np.testing.assert_allclose(np.degrees(theta_d[lit]), [90 - 0.5 / 512 * 90, 90 - 400.5 / 512 * 90], atol=1e-9)
    assert not m.masked


def test_merl_slices_real(shared_file):
    felt = read(shared_file("merl-slices/pink-felt-1d.alta"))
    np.testing.assert_allclose(felt.values[0, 0], [0.109704419970512, 0.0794405192136765, 0.0616232864558697])
    assert felt.wi[0, 2] == pytest.approx(0.999984567305837, abs=1e-15)
    pytest.importorskip("OpenEXR")
    fabric = read(shared_file("merl-slices/red-fabric-slice-alta.exr"))
    assert fabric.n_directions == 512 * 512
    mean = fabric.values[0].mean(axis=0)
    assert mean[0] > 2 * mean[1] > 0  # it is red


# ---------------------------------------------------------------- MBSDF


def test_mbsdf_bins(tmp_path: Path):
    values = np.arange(5 * 5 * 6 * 3, dtype=float).reshape(5, 5, 6, 3)
    values[1, 2, 3, 0] = -1e-3
    (tmp_path / "a.mbsdf").write_bytes(files.mbsdf_bytes(values=values))
    m = read(tmp_path / "a.mbsdf")
    for i, j, k in ((0, 0, 0), (1, 2, 3), (4, 0, 5), (2, 4, 1)):
        row = np.argmin(
            (np.degrees(m.theta_i) - (18 * i + 9)) ** 2
            + (np.degrees(m.theta_r) - (18 * j + 9)) ** 2
            + (np.degrees(np.abs(m.dphi)) - (30 * k + 15)) ** 2
        )
        np.testing.assert_allclose(m.values[0, row], values[i, j, k], rtol=1e-6)
    assert not m.masked


def test_mbsdf_weights_integrate_over_pairs_of_directions(tmp_path: Path):
    """phi_i integrated out and half of dphi: (2 pi)^2 / (2 pi) / 2 = pi, and pi/4 with both cosines."""
    (tmp_path / "a.mbsdf").write_bytes(files.mbsdf_bytes(30, 4))
    m = read(tmp_path / "a.mbsdf")
    assert m.weights.sum() == pytest.approx(np.pi, rel=1e-12)
    assert (m.weights * m.wi[:, 2] * m.wo[:, 2]).sum() == pytest.approx(np.pi / 4, rel=1e-3)


def test_mbsdf_metadata_lines_and_scalar_tables(tmp_path: Path):
    data = files.mbsdf_bytes()
    (tmp_path / "a.mbsdf").write_bytes(data.replace(b"V1\n", b'V1\nname="x"\nvendor="y"\n'))
    (tmp_path / "b.mbsdf").write_bytes(data)
    np.testing.assert_array_equal(read(tmp_path / "a.mbsdf").values, read(tmp_path / "b.mbsdf").values)
    scalar = (
        b"NVIDIA ARC MBSDF V1\nMBSDF_DATA_REFLECTION=\n"
        + struct.pack("<3i", 0, 2, 2)
        + np.arange(8, dtype="<f4").tobytes()
    )
    (tmp_path / "c.mbsdf").write_bytes(scalar)
    assert read(tmp_path / "c.mbsdf").values.ravel().tolist() == list(range(8))


@pytest.mark.parametrize(
    ("sizes", "message"),
    [
        ((1, 32000, 32000), "truncated"),
        ((1, 2**31 - 1, 2**31 - 1), "no MBSDF table"),
        ((7, 5, 6), "type 7"),
        ((1, 0, 6), "type 1 with 0"),
        ((1, -5, 6), "-5"),
    ],
)
def test_mbsdf_bad_headers(tmp_path: Path, sizes: tuple[int, int, int], message: str):
    good = files.mbsdf_bytes()
    at = good.index(b"REFLECTION=\n") + 12
    (tmp_path / "a.mbsdf").write_bytes(good[:at] + struct.pack("<3i", *sizes) + good[at + 12 :])
    with pytest.raises(FormatError, match=message):
        read(tmp_path / "a.mbsdf")
    (tmp_path / "b.mbsdf").write_bytes(good[:-1])
    with pytest.raises(FormatError, match="truncated"):
        read(tmp_path / "b.mbsdf")


def test_mbsdf_with_the_older_header_and_with_a_transmission(tmp_path: Path) -> None:
    """MBSDF_DATA= is a reflection; what the file holds besides, before or behind the table, is said."""
    good = files.mbsdf_bytes()
    plain = tmp_path / "plain.mbsdf"
    plain.write_bytes(good)
    older = good.replace(b"MBSDF_DATA_REFLECTION=", b"MBSDF_DATA=")
    transmission = b"MBSDF_DATA_TRANSMISSION=\n" + struct.pack("<3i", 0, 2, 2) + np.zeros(8, "<f4").tobytes()
    before = good.replace(b"V1\n", b"V1\n" + transmission)
    for name, data, told in (
        ("older", older, False),
        ("both", good + transmission, True),
        ("older-both", older + transmission, True),
        ("before", before, True),
        ("spaced", good + b"\n" + transmission, True),
    ):
        path = tmp_path / f"{name}.mbsdf"
        path.write_bytes(data)
        m = read(path)
        np.testing.assert_array_equal(m.values, read(plain).values)
        assert any("transmission" in note for note in m.provenance["notes"]) == told, name
    alone = tmp_path / "alone.mbsdf"
    alone.write_bytes(b"NVIDIA ARC MBSDF V1\n" + transmission)
    with pytest.raises(FormatError, match="neither MBSDF_DATA_REFLECTION= nor MBSDF_DATA="):
        read(alone)


def test_mbsdf_real(shared_file):
    m = read(shared_file("mbsdf/carpaint_blue.mbsdf"))
    assert (m.n_directions, m.channels) == (45 * 45 * 90, ("R", "G", "B"))
    raw = np.fromfile(shared_file("mbsdf/carpaint_blue.mbsdf"), "<f4", 45 * 45 * 90 * 3, offset=55)
    assert np.count_nonzero(raw < 0) > 60_000  # colours outside the gamut are data
    assert sum(m.masked.values()) < 1e-4 * raw.size
    np.testing.assert_array_equal(np.unique(np.degrees(m.theta_r).round(6)), np.arange(1, 90, 2))
    # the highlight is where light reflects: dphi = pi and theta_r near theta_i
    at_31 = np.abs(np.degrees(m.theta_i) - 31) < 0.1
    brightest = np.flatnonzero(at_31)[np.argmax(m.values[0, at_31, 1])]
    assert np.degrees(abs(m.dphi[brightest])) == pytest.approx(179, abs=0.1)
    assert np.degrees(m.theta_r[brightest]) == pytest.approx(31, abs=4.1)
    assert any("repeat" in note for note in m.provenance["notes"])


# ---------------------------------------------------------------- CSV


def table(tmp_path: Path, text: str) -> Measurement:
    path = tmp_path / "table.csv"
    path.write_text(text)
    return read(path)


def test_csv_full(tmp_path: Path):
    m = table(tmp_path, files.csv_text())
    assert m.values.shape == (2, 6, 3)
    np.testing.assert_allclose(m.times, [0, 1 / 60])
    assert (m.time_unit, m.channels) == ("h", ("R", "G", "B"))
    np.testing.assert_allclose(np.degrees(m.theta_i), 10.0 * np.arange(6), atol=1e-9)
    np.testing.assert_allclose(np.degrees(m.theta_r), 5 + 10.0 * np.arange(6), atol=1e-9)
    np.testing.assert_allclose(np.degrees(m.dphi[1:]), 30.0 * np.arange(1, 6), atol=1e-9)
    np.testing.assert_array_equal(m.weights, np.arange(1, 7))
    rows = [line.split(",") for line in files.csv_text().splitlines()[2:]]
    np.testing.assert_array_equal(m.values.reshape(12, 3), [[float(x) for x in row[6:]] for row in rows])


def test_csv_radians_degrees_and_missing_phi_i(tmp_path: Path):
    a = table(tmp_path, "theta_i,theta_r,phi_r,f\n0.5,0.25,3.0,1\n")
    b = table(tmp_path, f"phi_r_deg;theta_o_deg;f;theta_i_rad\n{np.degrees(3.0)};{np.degrees(0.25)};1;0.5\n")
    np.testing.assert_allclose(a.wi, b.wi, atol=1e-12)
    np.testing.assert_allclose(a.wo, b.wo, atol=1e-12)
    assert "phi_i is missing and taken as 0" in a.provenance["notes"]
    np.testing.assert_allclose(a.wi[0], [np.sin(0.5), 0, np.cos(0.5)], atol=1e-15)
    # a negative polar angle is the opposite azimuth
    c = table(tmp_path, "theta_i,theta_r,phi_r,f\n0.5,-0.25,0,1\n")
    assert abs(c.dphi[0]) == pytest.approx(np.pi)


def test_csv_wavelengths_empty_cells_comments(tmp_path: Path):
    m = table(
        tmp_path,
        "\ufeff# by hand\n\ntheta_i\ttheta_r\tphi_r\t400\t500 nm # two\n0.1\t0.2\t0.3\t0.5\t\n0.1\t0.3\t0.3\t-99\tinf\n",
    )
    assert m.wavelengths.tolist() == [400, 500]
    assert m.channels == ("400 nm", "500 nm")
    assert dict(m.masked) == {policy.NOT_FINITE: 2, policy.NEGATIVE: 1}


def test_csv_scans_that_share_some_directions(tmp_path: Path):
    m = table(
        tmp_path, "time,theta_i,theta_r,phi_r,f\n1,.1,.2,0,10\n1,.1,.3,0,11\n2,.1,.3,0,21\n2,.1,.4,0,22\n1,.1,.5,0,12\n"
    )
    assert m.values.shape == (2, 4, 1)
    by_angle = {round(t, 9): m.values[:, i, 0].tolist() for i, t in enumerate(m.theta_r)}
    assert by_angle[0.3] == [11, 21]
    assert by_angle[0.2][0] == 10
    assert np.isnan(by_angle[0.2][1])
    assert dict(m.masked) == {policy.NOT_MEASURED: 3}


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("theta_i,theta_r,phi_r,f\n", "no row below it"),
        ("theta_i,theta_r,f\n1,1,1\n", "no column phi_r"),
        ("theta_i,theta_r,phi_r\n.1,.1,.1\n", "no column of values"),
        ("theta_i,theta_r,phi_r,f,f\n.1,.1,.1,1,1\n", "the same channel"),
        ("theta_i,theta_r,phi_r,f\n.1,.1,.1\n", "line 2 has 3 cells"),
        ("theta_i,theta_r,phi_r,f\n.1,.1,.1,1\n\n# x\n.1,.1,.1,bright\n", "line 5: 'bright' is not a number"),
        ("theta_i,theta_r,phi_r,f\n.1,,.1,1\n", "line 2: theta_r is missing"),
        ("theta_i,theta_r,phi_r,f\n.1,80,.1,1\n", r"theta_r = 80 is outside.*theta_r_deg"),
        ("theta_i_deg,theta_r_deg,phi_r_deg,f\n1000,1,.1,1\n", "theta_i_deg = 1000 is outside"),
        ("theta_i,theta_i_deg,theta_r,phi_r,f\n.1,.1,.1,.1,1\n", "are both theta_i"),
        ("theta_i,theta_r,phi_r,time,time_s,f\n.1,.1,.1,1,1,1\n", "are both time"),
        ("theta_i,theta_r,phi_r,weight,f\n.1,.1,.1,-1,1\n", "the weight is missing or below 0"),
    ],
)
def test_csv_bad_tables(tmp_path: Path, text: str, message: str):
    with pytest.raises(MotesError, match=message):
        table(tmp_path, text)


def test_csv_with_a_time_in_each_row_is_refused_before_it_fills_the_memory(tmp_path: Path):
    rng = np.random.default_rng(1)
    rows = "".join(f"{t},{a:.5f},{b:.5f},0,1\n" for t, (a, b) in enumerate(rng.uniform(0, 1.5, (5000, 2))))
    with pytest.raises(FormatError, match="must share most of their directions"):
        table(tmp_path, "time,theta_i,theta_r,phi_r,f\n" + rows)


# ---------------------------------------------------------------- finding the format


def every_format(folder: Path) -> dict[str, Path]:
    """One small valid file or folder of each format."""
    made = {
        "curet": files.write_all(folder / "a", files.curet_bytes()),
        "tvbrdf": files.write_all(folder / "b", files.tvbrdf_bytes()),
    }
    for name, data in {
        "cornell": files.cornell_text().encode(),
        "csv": files.csv_text().encode(),
        "merl": files.merl_bytes(),
        "mbsdf": files.mbsdf_bytes(),
        "rgl": files.tensor_file(files.rgl_fields()),
        "merl-slice": files.alta_text().encode(),
        "bird": format_files.bird_json().encode(),
        "openmaterial": format_files.xompt_json().encode(),
        "astm": format_files.astm_text().encode(),
        "pab-opto": format_files.pab_text(30, 0).encode(),
        "bsdf-xml": format_files.klems_xml().encode(),
        "zemax": format_files.zemax_text().encode(),
        "lighttools": format_files.lighttools_text().encode(),
    }.items():
        made[name] = folder / f"{name}.data"  # the name says nothing
        made[name].write_bytes(data)
    return made


def test_the_format_is_found_from_the_content(tmp_path: Path):
    made = every_format(tmp_path)
    # Those have tests of their own: maps need OpenEXR, and UTIA tables are known by their size and name.
    assert {*made, "staf", "native-staf", "utia"} == set(READERS)
    for name, path in made.items():
        m = read(path, sample=3) if name == "curet" else read(str(path))
        assert m.provenance["format"] == name
        assert m.provenance["source"] == READERS[name].source
        assert m.provenance["notes"]
        assert list_samples(path) == (["3", "7"] if name == "curet" else [])
        others = [
            n
            for n, r in READERS.items()
            if n not in (name, "csv")  # any text may be a table, which is asked last
            and r.sniff(path, path.read_bytes()[:4096] if path.is_file() else b"")
        ]
        assert others == []


def test_options_that_a_format_does_not_have(tmp_path: Path):
    (tmp_path / "a").write_text(files.cornell_text())
    with pytest.raises(MotesError, match="cornell has no option 'sample'; it has none"):
        read(tmp_path / "a", sample=3)
    with pytest.raises(MotesError, match="no option 'times'"):
        read(tmp_path / "a", times=[1])
    with pytest.raises(FormatError, match=r"no format 'exr'.*cornell"):
        read(tmp_path / "a", format="exr")


def test_what_is_not_a_measurement(tmp_path: Path):
    (tmp_path / "empty").touch()
    (tmp_path / "noise").write_bytes(np.random.default_rng(0).bytes(1000))
    (tmp_path / "folder").mkdir()
    (tmp_path / "folder" / "x").touch()
    for name, message in (
        ("none", "does not exist"),
        ("empty", "is empty"),
        ("noise", "no known format"),
        ("folder", "holds x"),
    ):
        with pytest.raises(FormatError, match=message) as error:
            read(tmp_path / name)
        assert error.value.hint


@pytest.mark.skipif(not hasattr(__import__("os"), "mkfifo"), reason="no pipes here")
def test_a_pipe_does_not_hang(tmp_path: Path):
    import os

    os.mkfifo(tmp_path / "pipe")
    for format in (None, "csv"):
        with pytest.raises(FormatError, match="neither a file nor a folder"):
            read(tmp_path / "pipe", format=format)


def test_importing_is_light():
    heavy = "('llvmlite', 'OpenEXR', 'xarray', 'matplotlib', 'scipy')"
    code = f"import sys, motes.measurements; print([m for m in {heavy} if m in sys.modules])"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"


# ---------------------------------------------------------------- formats of other packages


class EntryPoint:
    """What `importlib.metadata` tells of a reader that a package adds."""

    def __init__(self, value: str, reader: object) -> None:
        self.value, self.reader = value, reader

    def load(self) -> object:
        if isinstance(self.reader, Exception):
            raise self.reader
        return self.reader


def test_other_packages_add_formats(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def sniff(path: Path, head: bytes) -> bool:
        return head.startswith(b"LAB 1")

    def read_lab(path: Path, *, scale: float = 1.0) -> Measurement:
        w = directions.from_spherical([0.1, 0.2], 0.0)
        return Measurement.from_arrays(w, w, [scale, scale], provenance={"format": "lab"})

    points = [
        EntryPoint("lab:READER", Reader("lab", "a format of the laboratory's", "the laboratory", sniff, read_lab)),
        EntryPoint("broken:READER", ImportError("no module named broken")),
        EntryPoint("wrong:READER", 7),
        EntryPoint("thief:READER", Reader("merl", "", "", sniff, read_lab)),
    ]
    monkeypatch.setattr(registry.metadata, "entry_points", lambda group: points if group == "motes.readers" else [])
    (tmp_path / "a.lab").write_bytes(b"LAB 1\n")
    assert read(tmp_path / "a.lab").provenance["format"] == "lab"
    assert read(tmp_path / "a.lab", format="lab", scale=2.0).values.max() == 2
    assert {*registry.readers()} == {*READERS, "lab"}
    (tmp_path / "b.bin").write_bytes(b"LAB 2\0")
    for option in ({}, {"format": "unheard-of"}):
        with pytest.raises(FormatError) as caught:
            read(tmp_path / "b.bin", **option)
        for words in ("lab", "no module named broken", "wrong:READER is a int", "name of another format, merl"):
            assert words in str(caught.value)


# ---------------------------------------------------------------- what a killed writer left


@pytest.mark.parametrize("format", [None, "staf"])
def test_a_folder_whose_writer_was_killed_is_read_whole(tmp_path: Path, format: str | None) -> None:
    """All its files are there, some of them still in the hidden folder in which they were written: the first power of t would be missing."""
    rng = np.random.default_rng(1)
    maps = {name: rng.uniform(0, 1, (2, 4, 5, 1)).repeat(3, axis=3) for name in ("Diffuse", "Specular", "Roughness")}
    folder = files.staf_folder(tmp_path / "staf", maps)
    whole = read(folder, format=format).coefficients
    decided = folder / ".motes-0123456789abcdef.decided"
    decided.mkdir()
    for name in maps:
        (folder / f"{name}-1.exr").rename(decided / f"{name}-1.exr")
    found = read(folder, format=format).coefficients
    for name in maps:
        np.testing.assert_array_equal(found[name], whole[name])
    assert not decided.exists()
