"""Zarr stores whose metadata claim axes that their files do not hold: what has no file is made up of the fill value, in memory, unless it is refused."""

from __future__ import annotations

import json
import resource
import sys
from pathlib import Path

import numpy as np
import pytest

zarr = pytest.importorskip("zarr")

from motes import maps  # noqa: E402
from motes.errors import FormatError  # noqa: E402
from motes.maps import zarrs  # noqa: E402

LENGTHS = (5_000_000, 2**31, 2**63, 10**30)
WI = np.array([[0.0, 0, 1], [0.6, 0, 0.8]])


def claimed(path: Path, member: str, axis: int, length: int) -> Path:
    """A map with one axis of one array made that long."""
    maps.create_map(path, (3, 4), WI, WI[::-1], hours=(0.0, 1.0), weights=(1.0, 2.0), chunk=2)
    file = path / member / "zarr.json"
    about = json.loads(file.read_text())
    about["shape"][axis] = length
    file.write_text(json.dumps(about))
    return path


def held() -> float:
    """The most memory that this process has had [MiB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="kibibytes as Linux counts them")
@pytest.mark.parametrize(
    ("member", "axis"),
    [*(("f_r", axis) for axis in (2, 3, 4)), ("wi", 0), ("wi", 1), ("wo", 0), ("time", 0), ("weight", 0)],
)
def test_an_axis_that_no_file_holds_is_refused_before_memory_is_taken(tmp_path: Path, member: str, axis: int) -> None:
    before = held()
    for length in LENGTHS:
        path = claimed(tmp_path / f"{length}.zarr", member, axis, length)
        with pytest.raises(FormatError, match=r"zarr(:| has) .*(shape|would take|chunks|cannot)") as caught:
            maps.open_map(path).texels(0, 0)
        assert caught.value.hint
        assert "more memory than there is" not in caught.value.message  # of the system, when it has been asked
    assert held() - before < 100


@pytest.mark.parametrize("member", ["f_r", "wi", "time", "weight"])
def test_chunks_that_hold_nothing_are_refused(tmp_path: Path, member: str) -> None:
    """They were divided by, or doubled for ever."""
    path = maps.create_map(
        tmp_path / "a.zarr", (3, 4), WI, WI[::-1], hours=(0.0, 1.0), weights=(1.0, 2.0), chunk=2
    ).path
    file = path / member / "zarr.json"
    about = json.loads(file.read_text())
    for axis in range(len(about["shape"])):
        shape = [0 if k == axis else n for k, n in enumerate(about["chunk_grid"]["configuration"]["chunk_shape"])]
        file.write_text(
            json.dumps({**about, "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": shape}}})
        )
        with pytest.raises(FormatError, match=f"a chunk of {member} has the shape .*0.*, which holds nothing"):
            maps.open_map(path)
    file.write_text(json.dumps(about))
    maps.open_map(path).texels(0, 0)


@pytest.mark.parametrize("scale", [1e300, -1e39, float("inf")])
def test_a_scale_beyond_single_precision_leaves_nothing_that_counts(tmp_path: Path, scale: float) -> None:
    stack = maps.create_map(tmp_path / "a.zarr", (2, 2), WI, WI[::-1], hours=(0.0,), chunk=2)
    stack.write(0, 0, np.zeros((2, 2, 1, 2, 3), np.float32))
    file = stack.path / "f_r" / "zarr.json"
    about = json.loads(file.read_text())
    about["attributes"]["scale_factor"] = scale
    file.write_text(json.dumps(about))
    assert not np.isfinite(maps.open_map(stack.path).texels(0, 0)).any()


def test_a_time_that_has_no_number_is_refused(tmp_path: Path) -> None:
    """A map of three times, of which two are said."""
    path = claimed(tmp_path / "a.zarr", "f_r", 2, 3)
    with pytest.raises(FormatError, match=r"time has shape \(2,\), and the values have 3 times"):
        maps.open_map(path)


def test_what_its_files_hold_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """More than the least that any file may take, from files that are large enough for it; and on demand."""
    monkeypatch.setattr(zarrs.budget, "LEAST", 2**10)
    made = maps.create_map(tmp_path / "a.zarr", (40, 40), WI, WI[::-1], hours=(0.0,), chunk=4)
    made.write(0, 0, np.random.default_rng(1).random((40, 40, 1, 2, 3), np.float32))
    assert maps.open_map(made.path).read_block((0, 0)).nbytes == 38400
    for file in (made.path / "f_r" / "c").rglob("*"):
        if file.is_file():
            file.unlink()
    monkeypatch.setattr(zarrs.budget, "FACTOR", 1)
    with pytest.raises(FormatError, match=r"what is to be read of f_r \(40 x 40 x 1 x 2 x 3\) would take 0 MiB"):
        maps.open_map(made.path).read_block((0, 0))
    monkeypatch.setenv("MOTES_LARGEST_MIB", "1")
    assert np.isnan(maps.open_map(made.path).read_block((0, 0))).all()


@pytest.mark.parametrize(
    ("part", "count"),
    [
        (..., 120),
        ((slice(1, 3), slice(0, 1), slice(None)), 2 * 1 * 4 * 5),
        ((slice(None), 1), 3 * 4 * 5),
        ((slice(5, 2),), 0),
    ],
)
def test_a_part_is_counted_as_it_is_read(part: object, count: int) -> None:
    shape = (3, 2, 4, 5)
    assert zarrs._length(shape, part) == count == np.zeros(shape)[part].size
