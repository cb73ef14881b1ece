"""Chunks that are written whole: the files are those that Zarr writes, byte for byte."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")
import zarr

from motes import maps
from motes.maps import chunks, zarrs
from motes.maps.chunks import Chunks

RNG = np.random.default_rng(3)
SHAPE, CHUNK = (7, 5, 2), (4, 3, 2)
CASES: dict[str, tuple[dict[str, Any], Any]] = {
    "float32": ({"dtype": "f4", "fill": np.nan}, RNG.random(SHAPE)),
    "verdicts": ({"dtype": "u1", "fill": 255}, RNG.integers(0, 4, SHAPE)),
    "uncompressed": ({"dtype": "u1", "fill": 0, "compressed": False}, RNG.integers(0, 2, SHAPE)),
}


def files(folder: Path) -> dict[str, bytes]:
    return {str(f.relative_to(folder)): f.read_bytes() for f in sorted(folder.rglob("*")) if f.is_file()}


def blocks(array: Any) -> list[tuple[tuple[int, int], tuple[slice, slice]]]:
    return [
        ((y, x), (slice(4 * y, min(4 * y + 4, 7)), slice(3 * x, min(3 * x + 3, 5)))) for y in (0, 1) for x in (0, 1)
    ]


def written_both_ways(store: Path, values: np.ndarray[Any, Any], **options: Any) -> tuple[Path, Path]:
    """The folders of an array that Zarr filled, and of one that `Chunks` did, block by block."""
    group = zarr.create_group(str(store), zarr_format=3)
    arrays = [
        zarrs.add(group, name, dims=("y", "x", "time"), shape=SHAPE, chunks=CHUNK, **options)
        for name in ("theirs", "ours")
    ]
    ours = Chunks.of(arrays[1], store)
    for place, where in blocks(arrays[0]):
        arrays[0][where] = values[where]
        ours.put(place, values[where])
    return store / "theirs", store / "ours"


@pytest.mark.parametrize("case", CASES)
def test_the_bytes_are_those_that_zarr_writes(case: str, tmp_path: Path) -> None:
    options, values = CASES[case]
    values = values.astype(options["dtype"])
    values[:4, :3] = options["fill"]  # nothing but the fill value: no file
    theirs, ours = written_both_ways(tmp_path / "a.zarr", values, **options)
    assert files(ours) == files(theirs)
    assert len(files(ours)) == 1 + 3
    np.testing.assert_array_equal(zarr.open_array(str(ours), mode="r")[...], values)


PARTS: list[Any] = [
    (slice(0, 7), slice(0, 5)), (slice(4, 7), slice(3, 5)), (slice(0, 4), slice(3, 5), slice(0, 2)), (slice(None), slice(0, 2)),
]  # fmt: skip


@pytest.mark.parametrize("part", PARTS)
def test_bare_numbers_are_read_from_their_files(part: Any, tmp_path: Path) -> None:
    values = CASES["float32"][1].astype("f4")
    values[:4, :3] = np.nan  # no file
    _, folder = written_both_ways(tmp_path / "a.zarr", values, compressed=False)
    array = zarr.open_group(str(tmp_path / "a.zarr"), mode="r")["ours"]
    found = chunks.plain(array, tmp_path / "a.zarr", part)
    assert found is not None
    np.testing.assert_array_equal(found, values[part])
    np.testing.assert_array_equal(zarrs.read(array, tmp_path / "a.zarr", part), array[part])
    last = folder / "c" / "1" / "1" / "0"
    last.write_bytes(last.read_bytes()[:-1])  # Zarr says what is wrong
    if part[0].stop != 4 and part[1].stop != 2:
        assert chunks.plain(array, tmp_path / "a.zarr", part) is None


def test_other_parts_and_other_numbers_are_left_to_zarr(tmp_path: Path) -> None:
    values = CASES["float32"][1].astype("f4")
    group = zarr.create_group(str(tmp_path / "a.zarr"), zarr_format=3)
    for name, options in {
        "bare": {"compressors": None},
        "packed": {},
        "turned": {"compressors": None, "serializer": zarr.codecs.BytesCodec(endian="big")},
    }.items():
        array = group.create_array(name, shape=SHAPE, chunks=CHUNK, dtype="f4", fill_value=np.nan, **options)
        array[...] = values
        parts = [(slice(1, 4), slice(0, 3)), (slice(0, 4), slice(0, 3), slice(1, 2)), ..., (0, slice(0, 3))]
        for part in parts if name == "bare" else [(slice(0, 4), slice(0, 3))]:
            assert chunks.plain(array, tmp_path / "a.zarr", part) is None
            np.testing.assert_array_equal(zarrs.read(array, tmp_path / "a.zarr", part), values[part])


def test_a_chunk_of_nothing_takes_the_place_of_what_was_there(tmp_path: Path) -> None:
    _, ours = written_both_ways(tmp_path / "a.zarr", CASES["float32"][1])
    array = zarr.open_group(str(tmp_path / "a.zarr"), mode="r+")["ours"]
    Chunks.of(array, tmp_path / "a.zarr").put((0, 0), np.full(CHUNK, np.nan))
    assert np.isnan(array[:4, :3]).all()
    assert not (ours / "c" / "0" / "0" / "0").exists()


@pytest.mark.parametrize("how", [{"compressors": zarr.codecs.GzipCodec()}, {"shards": (8, 6, 2)}])
def test_what_stores_of_others_have_is_left_to_zarr(how: dict[str, Any], tmp_path: Path) -> None:
    group = zarr.create_group(str(tmp_path / "a.zarr"), zarr_format=3)
    array = group.create_array("x", shape=SHAPE, chunks=CHUNK, dtype="f4", fill_value=np.nan, **how)
    values = CASES["float32"][1].astype("f4")
    ours = Chunks.of(array, tmp_path / "a.zarr")
    assert ours.encode is None
    for place, where in blocks(array):
        ours.put(place, values[where])
    np.testing.assert_array_equal(array[...], values)


def test_a_disk_that_refuses_leaves_what_was_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    _, folder = written_both_ways(tmp_path / "a.zarr", CASES["float32"][1])
    before = files(folder)
    array = zarr.open_group(str(tmp_path / "a.zarr"), mode="r+")["ours"]

    def full(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(chunks.os, "replace", full)
    with pytest.raises(OSError, match="No space"):
        Chunks.of(array, tmp_path / "a.zarr").put((0, 0), np.zeros(CHUNK))
    assert files(folder) == before


def test_a_store_that_was_opened_to_be_read_is_not_written(tmp_path: Path) -> None:
    _, folder = written_both_ways(tmp_path / "a.zarr", CASES["float32"][1])
    before = files(folder)
    array = zarr.open_group(str(tmp_path / "a.zarr"), mode="r")["ours"]
    with pytest.raises(ValueError, match="read-only"):
        Chunks.of(array, tmp_path / "a.zarr").put((0, 0), np.zeros(CHUNK))
    assert files(folder) == before


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
@pytest.mark.parametrize("compressed", [True, False])
@pytest.mark.parametrize("place", ["f_r/c/0/0/0/0/0", "f_r/zarr.json", "zarr.json", "wi/c/0/0"])
def test_a_pipe_in_a_store_is_refused_and_not_waited_for(tmp_path: Path, place: str, compressed: bool) -> None:
    store = maps.create_map(tmp_path / "m.zarr", (2, 2), [0, 0, 1], [0, 0, 1], compressed=compressed)
    store.write(0, 0, np.ones((2, 2, 1, 1, 3)))
    (store.path / place).unlink()
    os.mkfifo(store.path / place)
    # Where it is waited for, this child is ended, and says nothing.
    code = "import sys; from motes import maps; maps.open_map(sys.argv[1]).read_block((0, 0))"
    done = subprocess.run(
        [sys.executable, "-c", code, str(store.path)], capture_output=True, text=True, timeout=60, check=False
    )
    assert f"{place} is no regular file" in done.stderr.splitlines()[-1]
