"""The TVBRDF folder format: reading, writing, and all that a folder can lack."""

from __future__ import annotations

import errno
import sys
from pathlib import Path

import numpy as np
import pytest

import measurement_files as files
from effort import units
from motes.errors import DataError, FormatError, MotesError
from motes.measurements import _common_directions, _timestamps, list_samples, policy, read
from motes.measurements.tvbrdf_writing import write_tvbrdf

# The first record that the database documents, of sample01/tvBrdf-data/scan01_brdf_camera1_allexposures.txt
DOCUMENTED = """Exposure 0.200000 4.000000 32.000000
F 0.669680 0.778409 0.834711
L 0.978148 0.000000 0.207912
V -0.207912 0.000000 0.978148
"""


def sample(folder: Path, **kwargs) -> Path:
    return files.write_all(folder, files.tvbrdf_bytes(**kwargs))


def scan(folder: Path, t: int, v: int) -> Path:
    return folder / "tvBrdf-data" / f"scan{t:02d}_brdf_camera{v}_allexposures.txt"


def test_the_documented_record(tmp_path: Path):
    path = tmp_path / "scan01_brdf_camera1_allexposures.txt"
    path.write_text(DOCUMENTED)
    for where in (path, tmp_path):
        m = read(where)
        assert m.channels == ("R", "G", "B")  # written blue first
        np.testing.assert_allclose(m.values[0, 0] * 0.207912, [0.834711, 0.778409, 0.669680], rtol=1e-5)
        np.testing.assert_allclose(m.wi[0], [0.978148, 0, 0.207912], atol=1e-6)
        np.testing.assert_allclose(m.wo[0], [-0.207912, 0, 0.978148], atol=1e-6)
        assert "carry the scale of the source" in m.provenance["notes"][0]
    np.testing.assert_allclose(read(path, irradiance=2.0).values * 2, m.values)
    for bad in (0, -1, np.nan, np.inf, "bright"):
        with pytest.raises(DataError, match="irradiance"):
            read(path, irradiance=bad)


def test_a_sample_merges_cameras_and_scans(tmp_path: Path):
    folder = sample(tmp_path / "sample01", n_lights=5)
    m = read(folder)
    assert m.values.shape == (2, 4 * 5, 3)
    np.testing.assert_allclose(m.times, [0, 0.01])
    assert (m.time_unit, m.name) == ("h", "plaster (drying)")
    assert m.provenance["exposures"] == (0.2, 4.0, 32.0)
    assert m.mask.all()
    # camera 3, scan 2, third light, straight from the text
    lines = scan(folder, 2, 3).read_text().splitlines()[7:10]
    f, light, view = (np.array(line.split()[1:], float) for line in lines)
    row = 2 * 5 + 2
    np.testing.assert_allclose(m.wi[row], light, atol=1e-6)
    np.testing.assert_allclose(m.wo[row], view, atol=1e-6)
    np.testing.assert_allclose(m.values[1, row], f[::-1] / light[2], rtol=1e-6)


def test_missing_scans_and_cameras_are_masked_and_reported(tmp_path: Path):
    folder = sample(tmp_path / "sample01", n_scans=4, n_lights=3)
    (folder / "tvBrdf-info.txt").write_text("Number of scans: 5\n")
    scan(folder, 1, 2).unlink()
    for v in range(1, 5):
        scan(folder, 3, v).unlink()
    m = read(folder)
    assert m.values.shape == (5, 12, 3)
    expected = np.ones((5, 12), bool)
    expected[0, 3:6] = False
    expected[[2, 4]] = False
    np.testing.assert_array_equal(m.mask, np.repeat(expected[:, :, None], 3, axis=2))
    assert dict(m.masked) == {policy.NOT_MEASURED: 3 * np.count_nonzero(~expected)}
    assert np.isnan(m.values[~m.mask]).all()
    notes = " | ".join(m.provenance["notes"])
    assert "Missing scans, masked: 3, 5" in notes
    assert "Missing cameras, masked: scan 1 (camera 2)" in notes
    for t in range(1, 5):
        for v in (2, 3):
            scan(folder, t, v).unlink(missing_ok=True)
    m = read(folder)
    assert m.n_directions == 6
    assert "Only cameras 1, 4 of 4 are there" in m.provenance["notes"]


def test_directions_that_differ_between_scans(tmp_path: Path):
    def text(rows: list[tuple[float, float]]) -> str:
        out = "Exposure 1\n"
        for x, f in rows:
            out += f"F {f} {f} {f}\nL {x:.7f} 0 {np.sqrt(1 - x * x):.7f}\nV 0 0 1\n"
        return out

    name = "scan{:02d}_brdf_camera1_allexposures.txt"
    (tmp_path / name.format(1)).write_text(text([(0.1, 1), (0.2, 2), (0.3, 3)]))
    (tmp_path / name.format(2)).write_text(text([(0.1 + 4e-7, 4), (0.3, 5), (0.4, 6)]))
    m = read(tmp_path)
    np.testing.assert_allclose(m.wi[:, 0], [0.1, 0.2, 0.3, 0.4], atol=1e-6)
    radiance = m.values[:, :, 0] * m.wi[:, 2]
    np.testing.assert_allclose(radiance, [[1, 2, 3, np.nan], [4, np.nan, 5, 6]], rtol=1e-6)
    assert dict(m.masked) == {policy.NOT_MEASURED: 6}


def test_a_direction_measured_twice_in_each_scan_stays_two(tmp_path: Path):
    record = "F {} 1 1\nL 0 0 1\nV 0.6 0 0.8\n"
    for t in (1, 2):
        text = "".join(record.format(10 * t + k) for k in range(2))
        (tmp_path / f"scan{t:02d}_brdf_camera1_allexposures.txt").write_text(text)
    m = read(tmp_path)
    np.testing.assert_array_equal(m.values[:, :, 2], [[10, 11], [20, 21]])


def test_repeated_directions_are_told_apart_in_any_order(tmp_path: Path):
    def text(lights: str, first: int) -> str:
        return "".join(
            f"F 1 1 {first + k}\n{ {'a': 'L 0 0 1', 'b': 'L 0.6 0 0.8'}[l] }\nV 0 0 1\n" for k, l in enumerate(lights)
        )

    for t, lights in enumerate(("aab", "baa", "aaa"), 1):
        (tmp_path / f"scan{t:02d}_brdf_camera1_allexposures.txt").write_text(text(lights, 10 * t))
    m = read(tmp_path)
    radiance = np.round(m.values[:, :, 0] * m.wi[:, 2], 9)
    assert m.wi[:, 0].tolist() == [0, 0, 0.6, 0]  # the third "a" of the last scan is a direction of its own
    np.testing.assert_array_equal(np.sort(radiance[1, [0, 1]]), [21, 22])
    np.testing.assert_array_equal(radiance[:, 2], [12, 20, np.nan])
    assert np.sort(radiance[2, [0, 1, 3]]).tolist() == [30, 31, 32]


def test_light_below_the_horizon_and_broken_values(tmp_path: Path):
    path = tmp_path / "scan01_brdf_camera1_allexposures.txt"
    path.write_text(
        "F 1 1 1\nL 0.6 0 -0.8\nV 0 0 1\nF -9e5 nan 3\nL 0 0 1\nV 0.6 0 0.8\n"
        "F 1 2 3\nL 1 0 0\nV 0 0 1\nF 1 2 3\nL 0 0 1\nV 0 0 1\n"
    )
    m = read(path)
    assert dict(m.masked) == {policy.BELOW_HORIZON: 6, policy.NOT_FINITE: 1, policy.NEGATIVE: 1}
    np.testing.assert_array_equal(m.values[0, 3], [3, 2, 1])
    assert np.isnan(m.values[0, 0]).all()
    assert m.values[0, 1, 2] == -9e5


def test_a_database_folder_lists_its_samples(tmp_path: Path):
    for n in (1, 7):
        sample(tmp_path / f"sample{n:02d}")
    (tmp_path / "readme").mkdir()
    assert list_samples(tmp_path) == ["sample01", "sample07"]
    assert list_samples(tmp_path / "sample01") == []
    for which in (7, "7", "07", "sample07"):
        assert read(tmp_path, sample=which).provenance["sample"] == "sample07"
    assert read(tmp_path / "sample07", sample=7).provenance["sample"] == "sample07"
    with pytest.raises(FormatError, match=r"holds 2 samples.*sample01, sample07"):
        read(tmp_path)
    with pytest.raises(FormatError, match=r"no sample 3"):
        read(tmp_path, sample=3)
    with pytest.raises(FormatError, match="Leave sample out"):
        read(tmp_path / "sample01", sample=3)


@pytest.mark.parametrize(
    ("line", "text", "message"),
    [
        (5, "M 0 0 1", "record 2: 'M' stands where L is expected"),
        (4, "F x 1 1", "record 2: entry 1 is 'x', not a number"),
        (3, "V 0.5 0 1", r"V in row 0 .* of length 1.118"),
        (6, "V 0 0 nan", r"V in row 1 .* of length nan"),
        (8, "L 0 0 0", r"L in row 2 .* of length 0"),
    ],
)
def test_damaged_scans(tmp_path: Path, line: int, text: str, message: str):
    folder = sample(tmp_path / "sample01")
    path = scan(folder, 2, 1)
    lines = path.read_text().splitlines()
    lines[line] = text
    path.write_text("\n".join(lines))
    with pytest.raises(MotesError, match=message) as error:
        read(folder)
    assert "scan02_brdf_camera1" in str(error.value)


def test_truncated_and_empty_scans(tmp_path: Path):
    folder = sample(tmp_path / "sample01")
    path = scan(folder, 1, 4)
    text = path.read_text()
    path.write_text(text[: text.rindex("V")])
    with pytest.raises(FormatError, match="truncated within record 3"):
        read(folder)
    path.write_text("")
    with pytest.raises(FormatError, match="holds no record"):
        read(folder)
    path.write_text("Exposure 1 2 3\n")
    with pytest.raises(FormatError, match="holds no record"):
        read(folder)
    path.write_bytes(b"\0" * 100)
    with pytest.raises(FormatError, match="binary"):
        read(folder)


def test_absurd_scan_numbers_are_refused(tmp_path: Path):
    folder = sample(tmp_path / "sample01")
    scan(folder, 1, 1).rename(folder / "tvBrdf-data" / "scan999999_brdf_camera1_allexposures.txt")
    with pytest.raises(FormatError, match="numbered up to 999999"):
        read(folder)
    folder = sample(tmp_path / "sample02")
    (folder / "tvBrdf-info.txt").write_text("Number of scans: 900000\n")
    m = read(folder)
    assert m.n_times == 2
    assert any("says 900000 scans" in note for note in m.provenance["notes"])
    (tmp_path / "sample03").mkdir()
    (tmp_path / "sample03" / "tvBrdf-info.txt").write_text("x")
    with pytest.raises(FormatError, match="holds no scan file"):
        read(tmp_path / "sample03")


# ---------------------------------------------------------------- times

STAMPS = {
    "seconds, labelled": "scan 1: 0 s\nscan 2: 36 s\nscan 3: 90.5 s\n",
    "seconds, bare numbers": "Scan01 0\nScan02 36\nScan03 90.5\n",
    "minutes": "scan 1 = 0 min\nscan 2 = 0.6 min\nscan 3 = 1.5083333333 min\n",
    "clock times": "1  11:59:30\n2  12:00:06\n3  12:01:00.5\n",
    "past midnight": "scan01 23:59:30\nscan02 00:00:06\nscan03 00:01:00.5\n",
    "ISO 8601": "2005-03-31T23:59:30\n2005-04-01T00:00:06\n2005-04-01T00:01:00.5\n",
    "year first": "Time: 2005/03/31 23:59:30, 2005/04/01 00:00:06, 2005/04/01 00:01:00.5\n",
    "American": "03/31/2005 23:59:30\n04/01/2005 00:00:06\n04/01/2005 00:01:00.5\n",
    "asctime": "Thu Mar 31 23:59:30 2005\nFri Apr  1 00:00:06 2005\nFri Apr  1 00:01:00.5 2005\n",
    "one line": "Time stamps: 0 36 90.5\n",
    "a list below a heading": "Time stamps (s):\n0\n36\n90.5\n",
    "hours": "Time stamps [h] = 0, 0.01, 0.0251388888888\n",
    "among other lines": "Wet (drying)\nExposures: .2 4\nNumber of scans: 3\nscan 1: 0\nscan 2: 36\nscan 3: 90.5\n",
}


@pytest.mark.parametrize("text", STAMPS.values(), ids=STAMPS.keys())
def test_time_stamps(text: str):
    np.testing.assert_allclose(_timestamps.hours(text, 3), [0, 36 / 3600, 90.5 / 3600], atol=1e-9)


@pytest.mark.parametrize(
    "text",
    [
        "",
        "soon\nlater\nmuch later",
        "1: 0\n2: 36\n",
        "12:00\n11:00\n10:00:00\n12:61",
        "2005-02-31 1:00 2005-02-32 1:00 2005-13-01 1:00",
        "scan 1: 9e999\nscan 2: 1\nscan 3: 2",
    ],
)
def test_time_stamps_that_cannot_be_read(text: str):
    assert _timestamps.hours(text, 3) is None


@pytest.mark.parametrize("unit", [" ", "1 ", "scan ", ":", "a:1:", "1:11", "time=", "Mar ", "mar", "time:\n", "time:"])
def test_time_stamps_do_not_hang(unit: str):
    text = unit * (500_000 // len(unit))
    answers: list[object] = []
    # 15 here; a pattern that backtracks would take hours
    assert units(lambda: answers.append(_timestamps.hours(text, 3))) < 1000
    assert answers == [None]


@pytest.mark.parametrize("order", ["forwards", "backwards"])
def test_repeated_directions_out_of_place_take_linear_time(order: str):
    """Steps of the interpreter, counted: four times the rows take four times the steps, and each sample has a place of its own."""

    def steps(n: int) -> int:
        up, side = np.tile([0.0, 0.0, 1.0], (n, 1)), np.tile([0.6, 0.0, 0.8], (n, 1))
        scans = [np.concatenate([up, side]), np.concatenate([side, up, up])]
        taken = 0

        def count(*_: object) -> object:
            nonlocal taken
            taken += 1
            return count

        before = sys.gettrace()
        sys.settrace(count)
        try:
            union, (first, second) = _common_directions.union(scans if order == "forwards" else scans[::-1])
        finally:
            sys.settrace(before)
        assert len(union) == 3 * n
        for scan, index in zip(scans if order == "forwards" else scans[::-1], (first, second), strict=True):
            assert len(set(index.tolist())) == len(scan)
            np.testing.assert_array_equal(union[index], scan)
        return taken

    assert steps(400) < 5 * steps(100)


def test_times_fall_back_to_the_scans_and_can_be_given(tmp_path: Path):
    folder = sample(tmp_path / "sample01")
    (folder / "tvBrdf-info.txt").write_text("plaster\n3 exposures\nsometime\n")
    m = read(folder)
    assert (m.times.tolist(), m.time_unit) == ([0, 1], "scan")
    assert any("indices of the scans" in note for note in m.provenance["notes"])
    m = read(folder, times=[0.5, 2])
    assert (m.times.tolist(), m.time_unit) == ([0.5, 2], "h")
    (folder / "tvBrdf-info.txt").unlink()
    assert read(folder).time_unit == "scan"
    for bad in ([1], [2, 1], [0, np.nan], "now", ["a", "b"]):
        with pytest.raises(MotesError):
            read(folder, times=bad)


# ---------------------------------------------------------------- writing


def measured(n_scans: int = 3, n_lights: int = 7) -> list[list[tuple[np.ndarray, np.ndarray, np.ndarray]]]:
    rng = np.random.default_rng(21)
    return [[(L, V, rng.uniform(1e-4, 2, L.shape)) for L, V in files.rig(n_lights)] for _ in range(n_scans)]


def test_round_trip(tmp_path: Path):
    scans = measured()
    folder = write_tvbrdf(
        tmp_path / "new" / "sample05",
        name="plaster: white",
        process="drying",
        times_seconds=[0, 36, 100.25],
        scans=scans,
        exposures=(0.2, 4, 32),
        irradiance=2.5,
    )
    m = read(folder)
    assert m.name == "plaster white (drying)"
    np.testing.assert_allclose(m.times, np.array([0, 36, 100.25]) / 3600, rtol=1e-12)
    assert m.provenance["exposures"] == (0.2, 4, 32)
    assert m.provenance["irradiance"] == 2.5
    for t, cameras in enumerate(scans):
        wi, wo, radiance = (np.concatenate(x) for x in zip(*cameras, strict=True))
        np.testing.assert_allclose(m.wi, wi, atol=1e-9)
        np.testing.assert_allclose(m.wo, wo, atol=1e-9)
        np.testing.assert_allclose(m.values[t], radiance / (2.5 * wi[:, 2:]), rtol=2e-8)
    assert m.mask.all()
    # the documented layout, to the letter
    lines = scan(folder, 1, 1).read_text().splitlines()
    assert lines[0] == "Exposure 0.200000 4.000000 32.000000"
    assert [line[:2] for line in lines[1:]] == ["F ", "L ", "V "] * 7
    np.testing.assert_allclose(np.array(lines[1].split()[1:], float), scans[0][0][2][0, ::-1], rtol=1e-8)
    assert sorted(p.name for p in (tmp_path / "new").iterdir()) == ["sample05"]


def test_writing_keeps_its_hands_off_what_is_there(tmp_path: Path):
    arguments = {"name": "a", "process": "b", "times_seconds": [0], "scans": measured(1)}
    (tmp_path / "empty").mkdir()
    assert read(write_tvbrdf(tmp_path / "empty", **arguments)).n_times == 1
    with pytest.raises(MotesError, match="exists and is not an empty folder"):
        write_tvbrdf(tmp_path / "empty", **arguments)
    (tmp_path / "file").write_text("x")
    with pytest.raises(MotesError, match="exists and is not an empty folder"):
        write_tvbrdf(tmp_path / "file", **arguments)
    with pytest.raises(MotesError, match="cannot be written"):
        write_tvbrdf(tmp_path / "file" / "below", **arguments)
    assert (tmp_path / "file").read_text() == "x"


def test_a_full_disk_leaves_nothing_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    written = []
    write = Path.write_text

    def full(self: Path, text: str, **kwargs) -> int:
        written.append(self.name)
        if len(written) > 5:
            raise OSError(errno.ENOSPC, "No space left on device")
        return write(self, text, **kwargs)

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(MotesError, match="cannot be written: No space left on device"):
        write_tvbrdf(tmp_path / "sample01", name="a", process="b", times_seconds=[0, 1, 2], scans=measured())
    assert len(written) == 6
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "change",
    [
        {"times_seconds": [0]},
        {"times_seconds": [1, 0]},
        {"scans": [], "times_seconds": []},
        {"irradiance": 0},
        {"scans": [[(np.ones((3, 3)), np.ones((3, 3)), np.ones((2, 3)))]] * 2},
    ],
)
def test_what_cannot_be_written(tmp_path: Path, change: dict):
    arguments = {"name": "a", "process": "b", "times_seconds": [0, 1], "scans": measured(2)} | change
    with pytest.raises(DataError):
        write_tvbrdf(tmp_path / "x", **arguments)
    assert list(tmp_path.iterdir()) == []
