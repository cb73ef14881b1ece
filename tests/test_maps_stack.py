"""Reflectance maps as Zarr stores: making, opening, and what is refused."""

from __future__ import annotations

import bz2
import gzip
import json
import lzma
import shlex
import subprocess
import sys
import tracemalloc
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")
import xarray
import zarr

import maps_support as support
from motes import maps
from motes.directions import from_spherical
from motes.errors import DataError, FormatError, MissingExtraError, MotesError, ParameterError
from motes.maps import frames
from motes.maps.blocks import LARGE, SMALL, Blocks, block_shape
from motes.maps.zarrs import AXES

WI = from_spherical(np.radians([10.0, 30.0, 50.0, 70.0]), np.radians([0.0, 90.0, 180.0, 270.0]))
UP = (0.0, 0.0, 1.0)


def small(path: Path, **options: Any) -> maps.MapStack:
    return maps.create_map(path, (6, 5), WI, UP, **{"hours": (0, 1.5), "chunk": (4, 3), **options})


def test_a_new_map_is_what_was_asked_for(tmp_path: Path) -> None:
    weights = [1, 2, 3, 4]
    made = small(tmp_path / "a.zarr", weights=weights, attributes={"source": "a test"}, wavelengths=(610, 550, 460))
    assert np.isnan(made.read_block((0, 0))).all()
    values = np.random.default_rng(1).random((6, 5, *made.sizes)).astype(np.float32)
    for block in made.blocks:
        y, x = made.blocks.slices(block)
        made.write(y.start, x.start, values[y, x])
    found = maps.open_map(tmp_path / "a.zarr")
    assert isinstance(found, maps.MapStack)
    assert (found.shape, found.sizes, found.channels, found.name) == ((6, 5), (2, 4, 3), ("R", "G", "B"), "a")
    np.testing.assert_allclose(found.wi, WI)
    np.testing.assert_allclose(found.wo, np.tile(UP, (4, 1)))
    np.testing.assert_array_equal(found.hours, [0, 1.5])
    np.testing.assert_array_equal(found.weights, weights)
    np.testing.assert_array_equal(found.texels(5, 4), values[5, 4])
    json.dumps(found.summary(), allow_nan=False)


def test_xarray_reads_it_with_coordinates(tmp_path: Path) -> None:
    small(tmp_path / "a.zarr").write(0, 0, np.full((6, 5, 2, 4, 3), 0.25))
    data = xarray.open_zarr(tmp_path / "a.zarr")  # consolidated metadata, or this warns
    assert data.f_r.dims == AXES
    assert {"wi", "wo", "time"} <= set(data.coords)
    assert data.wi.dims == ("direction", "xyz")
    assert (data.time.values.tolist(), data.time.attrs["units"], data.f_r.attrs["units"]) == ([0, 1.5], "h", "1/sr")
    assert float(data.f_r.mean()) == 0.25
    named = maps.open_map(tmp_path / "a.zarr").to_xarray()
    assert named.f_r.sel(channel="G").shape == (6, 5, 2, 4)


def test_a_map_that_xarray_wrote_is_read(tmp_path: Path) -> None:
    values = np.random.default_rng(2).random((6, 5, 2, 4, 1)).astype(np.float64)
    values[0, 0, 0, :3, 0] = -9, np.inf, -0.01
    data = xarray.Dataset(
        {"f_r": (AXES, values)},
        coords={
            "wi": (("direction", "xyz"), WI),
            "wo": (("direction", "xyz"), np.tile(UP, (4, 1))),
            "time": ("time", np.array([0, 90], "timedelta64[m]").astype("timedelta64[s]")),
        },
    )
    data.to_zarr(tmp_path / "x.zarr", zarr_format=3, consolidated=False)
    found = maps.open_map(tmp_path / "x.zarr")
    np.testing.assert_array_equal(found.hours, [0, 1.5])
    assert found.channels == ("grey",)
    read = found.read_block((0, 0))
    assert read.dtype == np.float32
    assert np.isnan(read[0, 0, 0, :2, 0]).all()  # what cannot be a value
    assert read[0, 0, 0, 2, 0] == np.float32(-0.01)  # noise, and so a datum, as in `motes.read`
    np.testing.assert_allclose(read[1:], values[1:], rtol=1e-6)


def test_packed_numbers_are_unpacked(tmp_path: Path) -> None:
    made = small(tmp_path / "a.zarr")
    group = zarr.open_group(str(made.path), mode="r+", use_consolidated=False)
    del group["f_r"]
    about = {"scale_factor": 0.01, "add_offset": 0.5, "_FillValue": 9}
    packed = group.create_array(
        "f_r", shape=(6, 5, 2, 4, 3), chunks=(6, 5, 2, 4, 3), dtype="u2", dimension_names=AXES, attributes=about
    )
    packed[...] = 3
    packed[0, 0, 0, 0, 0] = 9
    read = maps.open_map(made.path).read_block((0, 0))
    assert np.isnan(read[0, 0, 0, 0, 0])
    assert read[1, 1, 1, 1, 1] == pytest.approx(0.53)


def test_blocks_cover_every_texel_once() -> None:
    blocks = Blocks((70, 41), (16, 12))
    seen = np.zeros(blocks.shape, int)
    for block in blocks:
        seen[blocks.slices(block)] += 1
        assert seen[blocks.slices(block)].size == blocks.texels(block)
    assert (seen == 1).all()
    few = blocks.spread(6)
    assert 4 <= len(few) <= 6
    assert len({y for y, _ in few}) >= 3
    assert len({x for _, x in few}) >= 3
    assert set(Blocks((3, 3), (2, 2)).spread(16)) == {(0, 0), (0, 1), (1, 0), (1, 1)}


@pytest.mark.parametrize(
    ("shape", "chunks", "whole"),
    [
        ((460, 460, 16, 80, 3), (64, 64, 16, 80, 3), True),
        ((4096, 4096, 1, 20, 3), (8, 8, 1, 20, 3), True),
        ((4096, 4096, 8, 100, 3), (4096, 4096, 1, 1, 3), False),
        ((5, 7, 2, 3, 1), (5, 7, 2, 3, 1), True),
    ],
)
def test_blocks_are_whole_chunks_of_bounded_size(shape: tuple[int, ...], chunks: tuple[int, ...], whole: bool) -> None:
    height, width = block_shape(shape, chunks)
    size = 4 * height * width * int(np.prod(shape[2:]))
    if whole:
        assert height % chunks[0] == 0 or height == shape[0]
        assert width % chunks[1] == 0 or width == shape[1]
    assert size <= max(2 * SMALL, LARGE, 4 * int(np.prod(chunks)))


def refused(path: Path, *words: str, error: type[Exception] = FormatError) -> None:
    with pytest.raises(error) as caught:
        maps.open_map(path)
    assert isinstance(caught.value, MotesError)
    for word in words:
        assert word in str(caught.value)


def test_what_is_no_map_is_refused(tmp_path: Path) -> None:
    refused(tmp_path / "nothing.zarr", "does not exist")
    (tmp_path / "empty.zarr").mkdir()
    refused(tmp_path / "empty.zarr", "not a Zarr group")
    (tmp_path / "broken.zarr").mkdir()
    (tmp_path / "broken.zarr" / "zarr.json").write_text("{")
    refused(tmp_path / "broken.zarr", "not a Zarr group")
    zarr.create_group(str(tmp_path / "bare.zarr"))
    refused(tmp_path / "bare.zarr", "no array f_r", "holds nothing")
    zarr.create_group(str(tmp_path / "old.zarr"), zarr_format=2)
    refused(tmp_path / "old.zarr", "version 2", "zarr_format=3")


def rewritten(path: Path, drop: str, **arrays: Any) -> Path:
    """A map with an array replaced."""
    made = small(path)
    group = zarr.open_group(str(made.path), mode="r+", use_consolidated=False)
    del group[drop]
    if arrays:
        values, dims = arrays["values"], arrays["dims"]
        array = group.create_array(
            arrays.get("name", drop), shape=values.shape, dtype=values.dtype, dimension_names=dims
        )
        array[...] = values
    return made.path


def obeyed(folder: Path, monkeypatch: pytest.MonkeyPatch) -> maps.MapStack:
    """What comes of the command in the hint, run as it is printed."""
    monkeypatch.chdir(folder.parent)
    with pytest.raises(FormatError) as refusal:
        maps.open_map(folder.name)
    _, _, command = refusal.value.hint.partition(": ")
    words = shlex.split(command)
    assert words[:2] == ["python", "-c"]
    subprocess.run([sys.executable, *words[1:]], check=True, timeout=120)
    return maps.open_map(f"{folder.stem}-again.zarr")


@pytest.mark.parametrize("name", ["old.zarr", "it's $HOME, 'old' \"one\".zarr"])
@pytest.mark.parametrize("by", ["xarray", "zarr"])
def test_the_hint_for_version_2_runs(tmp_path: Path, by: str, name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("dask")
    made = small(tmp_path / "new.zarr")
    made.write(0, 0, np.random.default_rng(1).random((6, 5, *made.sizes)))
    old = tmp_path / name
    if by == "xarray":
        dataset = xarray.open_zarr(str(made.path), consolidated=False).drop_encoding()
        dataset.to_zarr(str(old), zarr_format=2)  # with Blosc, which version 3 does not take over
    else:
        group = zarr.create_group(str(old), zarr_format=2)
        for key, array in zarr.open_group(str(made.path), mode="r", use_consolidated=False).arrays():
            group.create_array(key, shape=array.shape, dtype=array.dtype, chunks=array.chunks)[...] = array[...]
        group.attrs.update({"channels": ["R", "G", "B"]})
    found = obeyed(old, monkeypatch)
    assert found.channels == made.channels
    np.testing.assert_array_equal(found.wi, made.wi)
    np.testing.assert_array_equal(found.hours, made.hours)
    np.testing.assert_array_equal(found.texels(1, 2), made.texels(1, 2))


def test_the_hint_for_axes_in_another_order_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = small(tmp_path / "new.zarr")
    made.write(0, 0, np.random.default_rng(1).random((6, 5, *made.sizes)))
    turned = xarray.open_zarr(str(made.path), consolidated=False).transpose(
        "time", "direction", "channel", "y", "x", ...
    )
    turned.drop_encoding().to_zarr(str(tmp_path / "turned.zarr"), zarr_format=3, consolidated=False)
    found = obeyed(tmp_path / "turned.zarr", monkeypatch)
    np.testing.assert_array_equal(found.texels(1, 2), made.texels(1, 2))


def test_wrong_axes_say_what_to_do(tmp_path: Path) -> None:
    values = np.zeros((5, 6, 2, 4, 3), "f4")
    swapped = rewritten(tmp_path / "a.zarr", "f_r", values=values, dims=("x", "y", *AXES[2:]))
    refused(swapped, "axes (x, y, time, direction, channel)", ".transpose(")
    other = rewritten(tmp_path / "b.zarr", "f_r", values=values, dims=("y", "x", "time", "angle", "channel"))
    refused(other, "axes (y, x, time, angle, channel)", "dimension_names")
    static = rewritten(
        tmp_path / "c.zarr", "f_r", values=values[:, :, 0], dims=("y", "x", "direction", "channel"), name="v"
    )
    refused(static, "no array f_r", "v (y, x, direction, channel)")
    text = rewritten(tmp_path / "d.zarr", "f_r", values=values.astype(bool), dims=AXES)
    refused(text, "not numbers")


def test_missing_and_misfit_coordinates(tmp_path: Path) -> None:
    refused(rewritten(tmp_path / "a.zarr", "wi"), "no array wi", "light")
    refused(rewritten(tmp_path / "b.zarr", "wo"), "no array wo", "viewer")
    refused(rewritten(tmp_path / "c.zarr", "time"), "2 times and no coordinate time")
    three = rewritten(tmp_path / "d.zarr", "wi", values=WI[:3], dims=("direction", "xyz"))
    refused(three, "shape (3, 3), not (4, 3)")
    long = rewritten(tmp_path / "e.zarr", "wi", values=2 * WI, dims=("direction", "xyz"))
    refused(long, "of length 2", error=DataError)
    back = rewritten(tmp_path / "f.zarr", "time", values=np.array([2.0, 1.0]), dims=("time",))
    refused(back, "do not increase", error=DataError)


def test_absurd_sizes_are_refused_before_anything_is_read(tmp_path: Path) -> None:
    made = small(tmp_path / "a.zarr")
    file = made.path / "f_r" / "zarr.json"
    about = json.loads(file.read_text())
    about["shape"] = [2**24, 2**24, *about["shape"][2:]]
    file.write_text(json.dumps(about))
    refused(made.path, "chunks, more than")
    about["chunk_grid"]["configuration"]["chunk_shape"][:2] = [2**16, 2**16]
    file.write_text(json.dumps(about))
    refused(made.path, "MiB", "chunks of 64 x 64")


def test_a_new_map_does_not_overwrite(tmp_path: Path) -> None:
    made = small(tmp_path / "a.zarr")
    before = support.contents(made.path)
    with pytest.raises(MotesError, match="exists and is not empty"):
        small(tmp_path / "a.zarr")
    assert support.contents(made.path) == before
    for bad in ({"hours": (1, 0)}, {"chunk": 0}, {"hours": ()}, {"channels": ()}):
        with pytest.raises((DataError, ParameterError)):
            small(tmp_path / "b.zarr", **bad)
    assert not (tmp_path / "b.zarr").exists()
    with pytest.raises(MotesError, match="cannot be written"):
        small(Path("/proc/motes/a.zarr"))
    with pytest.raises(DataError, match="do not fit"):
        made.write(0, 0, np.zeros((2, 2, 1, 1, 1)))


def test_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    small(tmp_path / "a.zarr")
    monkeypatch.setitem(sys.modules, "zarr", None)
    with pytest.raises(MissingExtraError, match=r"zarr.*pip install.*\[scale\]"):
        maps.open_map(tmp_path / "a.zarr")


def test_simulated_maps_keep_their_truth(tmp_path: Path) -> None:
    made = maps.simulate_map(tmp_path / "a.zarr", (9, 5), times=2, lights=5, noise=0, chunk=4)
    again = maps.simulate_map(tmp_path / "b.zarr", (9, 5), times=2, lights=5, noise=0.1, seed=3, chunk=4)
    third = maps.simulate_map(tmp_path / "c.zarr", (9, 5), times=2, lights=5, noise=0.1, seed=3, chunk=4)
    assert support.contents(again.path) == support.contents(third.path) != support.contents(made.path)
    from motes import OrenNayar, TorranceSparrow

    true = {name: np.asarray(a[8, 4, 1]) for name, a in made.truth.items()}
    model = OrenNayar(K_d=true["K_d"], sigma_d=true["sigma_d"]) + TorranceSparrow(
        K_s=true["K_s"], sigma_s=true["sigma_s"]
    )
    np.testing.assert_allclose(made.texels(8, 4)[1], model.eval(made.wi, made.wo), rtol=1e-5)
    ratio = again.read_block((0, 0)) / made.read_block((0, 0))
    assert ratio.std() == pytest.approx(0.1, rel=0.05)
    with pytest.raises(ParameterError):
        maps.simulate_map(tmp_path / "d.zarr", (0, 5))


def test_chunks_that_claim_more_than_their_files_hold_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = small(tmp_path / "a.zarr")
    made.write(0, 0, np.ones((6, 5, *made.sizes), np.float32))
    file = made.path / "f_r" / "zarr.json"
    about = json.loads(file.read_text())
    about["shape"][:2] = about["chunk_grid"]["configuration"]["chunk_shape"][:2] = [2000, 2000]
    file.write_text(json.dumps(about))
    refused(made.path, "MiB and is read whole", "MOTES_LARGEST_MIB=")
    monkeypatch.setenv("MOTES_LARGEST_MIB", "4000")
    assert maps.open_stack(made.path).shape == (2000, 2000)
    for name in ("wo", "f_r"):  # what no float holds, in a sentence, too
        file = made.path / name / "zarr.json"
        about = json.loads(file.read_text())
        about["chunk_grid"]["configuration"]["chunk_shape"][0] = 10**400
        file.write_text(json.dumps(about))
        refused(made.path, "more than 1e+12 MiB", "It is damaged")


def test_large_chunks_can_be_made_and_filled(tmp_path: Path) -> None:
    """A new map has no files, of which its chunks could be 20 times as large."""
    wi = np.tile([0.0, 0.0, 1.0], (700, 1))
    made = maps.create_map(tmp_path / "a.zarr", (64, 64), wi, wi, hours=np.arange(2.0), chunk=64)
    assert np.prod(made.array.chunks) * 4 > 64 * 2**20
    refused(made.path, "MiB and is read whole")
    made.write(0, 0, np.random.default_rng(1).random((64, 64, 2, 700, 3), np.float32))
    assert maps.open_stack(made.path).texels(63, 63).shape == (2, 700, 3)


@pytest.mark.parametrize("what", ["f_r/zarr.json", "zarr.json", "time/zarr.json"])
def test_attributes_that_are_no_object_are_refused(tmp_path: Path, what: str) -> None:
    file = small(tmp_path / "a.zarr").path / what
    file.write_text(json.dumps({**json.loads(file.read_text()), "attributes": "x"}))
    refused(tmp_path / "a.zarr", "Write the store again" if what != "zarr.json" else "a.zarr")


def test_a_damaged_chunk_is_a_sentence(tmp_path: Path) -> None:
    made = small(tmp_path / "a.zarr")
    made.write(0, 0, np.ones((6, 5, *made.sizes), np.float32))
    support.damage(made.path, "0/0/0/0/0")
    with pytest.raises(FormatError, match="f_r cannot be read"):
        maps.open_stack(made.path).texels(0, 0)


CLASSES = {"zstd": "ZstdCodec", "gzip": "GzipCodec", "blosc": "BloscCodec"}


def bombed(path: Path, codec: str, shards: tuple[int, ...] | None) -> Path:
    """A map whose only chunk is replaced by one of ones, many thousand times as many as it should have, that the library itself has packed."""
    made = small(path)
    group = zarr.open_group(str(made.path), mode="r+", use_consolidated=False)
    del group["f_r"]
    shape = (6, 5, 2, 4, 3)
    for name, size, dtype in (("f_r", shape, "f4"), ("large", (70 * 2**20,), "u1")):
        outer = shards if name == "f_r" else None if shards is None else size
        array = group.create_array(
            name, shape=size, chunks=size, shards=outer, dtype=dtype, compressors=getattr(zarr.codecs, CLASSES[codec])(),
            dimension_names=AXES if name == "f_r" else None,
        )  # fmt: skip
        array[...] = 1 if name == "f_r" else np.ones(size, dtype)
    (file,) = [f for f in (made.path / "large" / "c").rglob("*") if f.is_file()]
    (target,) = [f for f in (made.path / "f_r" / "c").rglob("*") if f.is_file()]
    maps.open_stack(made.path).texels(0, 0)  # it is well so far
    target.write_bytes(file.read_bytes())
    del group["large"]
    return made.path


@pytest.mark.parametrize("shards", [None, (6, 5, 2, 4, 3)], ids=["chunks", "shards"])
@pytest.mark.parametrize("codec", CLASSES)
def test_a_chunk_that_decodes_to_more_than_it_should_is_refused_before(
    tmp_path: Path, codec: str, shards: tuple[int, ...] | None
) -> None:
    path = bombed(tmp_path / "a.zarr", codec, shards)
    found = maps.open_stack(path)
    tracemalloc.start()
    try:
        with pytest.raises(FormatError, match=r"decodes to .* MiB or more, and a chunk has 0 MiB") as caught:
            found.texels(0, 0)
        assert tracemalloc.get_traced_memory()[1] < 16 * 2**20
    finally:
        tracemalloc.stop()
    assert caught.value.hint


def test_sizes_of_frames_are_read_as_the_library_writes_them() -> None:
    """Frames of Zstandard of every width of the size, and streams in several members."""
    numcodecs = pytest.importorskip("numcodecs")
    for n in (1, 255, 256, 257, 65791, 65792, 10**6):
        assert frames._zstd(numcodecs.Zstd().encode(bytes(n))[:18]) == n
    assert frames._zstd(bytes.fromhex("28b52ffdc05b7f6d0911 6ba02030bd") + bytes(4)) > 2**40
    members = gzip.compress(bytes(1000)) + gzip.compress(bytes(500))
    assert frames._counted(frames.STREAMS["gzip"], members, 10**6) == 1500
    assert frames._counted(frames.STREAMS["gzip"], members[:-30], 10**6) <= 1500
    for name, packed in (("bz2", bz2.compress(bytes(10**7))), ("lzma", lzma.compress(bytes(10**7)))):
        assert frames._counted(frames.STREAMS[name], packed, 2**30) == 10**7
        assert 10**6 < frames._counted(frames.STREAMS[name], packed, 10**6) < 4 * 10**6
