"""What reading a table takes: at most 20 times the file, or 64 MiB, as for every other format."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from motes.errors import FormatError
from motes.measurements import _cells
from motes.measurements.table import read_table

resource = pytest.importorskip("resource")
#: A process reads a small file first, so that what imports take does not count, and then says how much more the large one took.
ASKED = """
import resource, sys, motes
motes.read(sys.argv[1])
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
data = motes.read(sys.argv[2])
print((resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * (1 if sys.platform == "darwin" else 1024), data.n_directions)
"""
HEAD = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,R\n"


def test_short_cells_take_no_more_than_twenty_times_the_file(tmp_path: Path) -> None:
    """Cells of two characters are the worst: as texts of their own, each takes 60 bytes."""
    count = 350_000
    rng = np.random.default_rng(4)
    cells = rng.integers([10, 10, 10, 10, 1], [80, 99, 80, 99, 9], (count, 5))
    rows = "".join(f"{a},{b},{c},{d},.{e}\n" for a, b, c, d, e in cells.tolist())
    small, large = tmp_path / "small.csv", tmp_path / "large.csv"
    small.write_text(HEAD + rows[:3000].rsplit("\n", 1)[0] + "\n")
    large.write_text(HEAD + rows)
    done = subprocess.run(
        [sys.executable, "-c", ASKED, str(small), str(large)], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    taken, directions = map(int, done.stdout.split())
    assert directions == count
    assert taken <= max(20 * large.stat().st_size, 64 * 2**20)


def test_the_parts_of_a_long_table_are_put_together(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Plain numbers, numbers with units and words for what is missing; a mistake names its line in whatever part it stands."""
    rows = [f"{20 + k % 50},0,{k % 70},{k % 360},{0.1 + k / 1000}" for k in range(100)]
    path = tmp_path / "a.csv"
    path.write_text(HEAD + "\n".join(rows) + "\n")
    whole = read_table(path)
    monkeypatch.setattr("motes.measurements._cell_numbers.PART", 7)
    monkeypatch.setattr(_cells, "PART", 7)
    parts = read_table(path)
    np.testing.assert_array_equal(parts.wi, whole.wi)
    np.testing.assert_array_equal(parts.values, whole.values)
    rows[60] = rows[60].rpartition(",")[0] + ",NA"
    rows[61] = rows[61].replace(",", " deg,", 1)
    path.write_text(HEAD + "\n".join(rows) + "\n")
    missing = read_table(path)
    assert np.flatnonzero(~np.isfinite(missing.values.reshape(-1))).tolist() == [60]
    np.testing.assert_array_equal(missing.wi, whole.wi)
    rows[80] = rows[80].rpartition(",")[0] + ",many"
    path.write_text(HEAD + "\n".join(rows) + "\n")
    with pytest.raises(FormatError, match=r"line 82: 'many' is not a number"):
        read_table(path)


def test_rows_are_cut_when_they_are_asked_for() -> None:
    rows = _cells.Rows(["1,2,,", '"3",4,5', "6,7"], ",")
    assert list(rows) == [["1", "2", "", ""], ["3", "4", "5"], ["6", "7"]]
    assert list(rows.of_width(2)) == [["1", "2"], ["3", "4", "5"], ["6", "7"]]
    assert list(rows.of_width(2).without([1])) == [["1", "2"], ["6", "7"]]
    assert (len(rows), rows[1], list(rows[1:])) == (3, ["3", "4", "5"], [["3", "4", "5"], ["6", "7"]])
