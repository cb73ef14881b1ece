"""Damaged, truncated and hostile files: every reader gives a measurement or a MotesError, soon and in little memory."""

from __future__ import annotations

import json
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import format_files
import measurement_files as files
from effort import unit
from motes.errors import MotesError
from motes.measurements import READERS, Measurement, ParameterMaps, TabulatedMaps, list_samples, read

MEMORY, EFFORT = 200e6, 1000  # bytes, and units of work: seven seconds


def staf_bytes(folder: Path) -> dict[str, bytes]:
    rng = np.random.default_rng(1)
    maps = {name: rng.uniform(0, 1, (2, 4, 5, 1)).repeat(3, axis=3) for name in ("Diffuse", "Specular", "Roughness")}
    files.staf_folder(folder, maps)
    return {f.name: f.read_bytes() for f in folder.iterdir()}


# The files of a small valid specimen of each format, and the one to read ("" for the folder).
SPECIMENS: dict[str, tuple[Callable[[], dict[str, bytes]], str]] = {
    "curet": (files.curet_bytes, ""),
    "cornell": (lambda: {"a": files.cornell_text().encode()}, "a"),
    "merl": (lambda: {"a": files.merl_bytes()}, "a"),
    "merl-slice": (lambda: {"a": files.alta_text().encode()}, "a"),
    "rgl": (lambda: {"a": files.tensor_file(files.rgl_fields())}, "a"),
    "mbsdf": (lambda: {"a": files.mbsdf_bytes()}, "a"),
    "tvbrdf": (files.tvbrdf_bytes, ""),
    "csv": (lambda: {"a": files.csv_text().encode()}, "a"),
    "bird": (lambda: {"a": format_files.bird_json().encode()}, "a"),
    "openmaterial": (lambda: {"a": format_files.xompt_json().encode()}, "a"),
    "astm": (lambda: {"a": format_files.astm_text().encode()}, "a"),
    "pab-opto": (lambda: {"a": format_files.pab_text(30, 0, step=30).encode()}, "a"),
    "bsdf-xml": (lambda: {"a": format_files.tree_xml().encode()}, "a"),
    "zemax": (lambda: {"a": format_files.zemax_text().encode()}, "a"),
    "lighttools": (lambda: {"a": format_files.lighttools_text().encode()}, "a"),
}
# Large, or pictures: damaged by tests of their own.
APART = {"staf", "native-staf", "utia"}


def test_every_reader_is_fuzzed():
    assert {*SPECIMENS, *APART} == set(READERS)


def survives(path: Path, name: str) -> None:
    """Reading, by content and by force, is quick, lean, and fails with nothing but a MotesError."""
    options = [{}, {"format": name}]
    if READERS[name].takes_sample:
        options.append({"format": name, "sample": 3})
    for option in options:
        tracemalloc.start()
        start = time.process_time()
        try:
            result = read(path, **option)
            json.dumps(result.summary(), allow_nan=False)
            if isinstance(result, Measurement):
                assert sum(result.masked.values()) == np.count_nonzero(~result.mask)
                assert np.all(np.isfinite(result.values[result.mask]))
            else:
                assert isinstance(result, ParameterMaps | TabulatedMaps)
            list_samples(path, format=name)
        except MotesError as error:
            complete = bool(error.message and error.hint)
        else:
            complete = True
        finally:
            seconds, (_, peak) = time.process_time() - start, tracemalloc.get_traced_memory()
            tracemalloc.stop()
        assert complete, "an error without a message or a hint"
        assert seconds < EFFORT * unit()
        assert peak < MEMORY


@st.composite
def damage(draw: st.DrawFn) -> Callable[[bytes], bytes]:
    """A way to damage a file: cut it, flip bytes in it, insert into it, double a part, or replace it."""
    kind = draw(st.sampled_from(["cut", "flip", "flip", "insert", "digit", "double", "replace"]))
    where = draw(st.lists(st.floats(0, 1, exclude_max=True), min_size=1, max_size=4))
    nasty = [b"\xff" * 8, b"\x00" * 8, b"nan ", b"1e308 ", b"-", b"\n", b"9" * 12]
    what = draw(st.binary(min_size=1, max_size=16) | st.sampled_from(nasty))

    def apply(data: bytes) -> bytes:
        at = [int(w * len(data)) for w in where]
        if kind == "cut":
            return data[: at[0]]
        if kind == "replace":
            return what
        if kind == "double":
            return data[: at[0]] + data[min(at) : at[0]] + data[at[0] :]
        for a in at:
            if kind == "digit" and data[a : a + 1].isdigit():
                data = data[:a] + b"%d" % (what[0] % 10) + data[a + 1 :]
            else:
                data = data[:a] + what + data[a if kind == "insert" else a + len(what) :]
        return data

    return apply


@pytest.mark.parametrize("name", SPECIMENS)
@settings(max_examples=60)
@given(data=st.data())
def test_damaged_files(name: str, data: st.DataObject, tmp_path_factory: pytest.TempPathFactory):
    make, target = SPECIMENS[name]
    specimen = make()
    victim = data.draw(st.sampled_from(sorted(specimen)))
    for change in data.draw(st.lists(damage(), min_size=1, max_size=2)):
        specimen[victim] = change(specimen[victim])
    folder = tmp_path_factory.mktemp("fuzz", numbered=True)
    survives(files.write_all(folder, specimen) / target, name)


@pytest.mark.parametrize("name", SPECIMENS)
@settings(max_examples=30)
@given(content=st.binary(max_size=400))
def test_random_bytes_behind_the_right_beginning(name: str, content: bytes, tmp_path_factory: pytest.TempPathFactory):
    """Random bytes alone, and after the part of a valid file that makes it look right."""
    make, target = SPECIMENS[name]
    for keep in (0, 12, 60):
        specimen = make()
        victim = sorted(specimen)[-1]
        specimen[victim] = specimen[victim][:keep] + content
        folder = tmp_path_factory.mktemp("fuzz", numbered=True)
        survives(files.write_all(folder, specimen) / target, name)


@pytest.mark.parametrize("name", SPECIMENS)
def test_every_truncation(name: str, tmp_path: Path):
    make, target = SPECIMENS[name]
    specimen = make()
    victim = sorted(specimen)[-1]
    whole = specimen[victim]
    for n in np.unique(np.linspace(0, len(whole) - 1, 40).astype(int)):
        specimen[victim] = whole[:n]
        survives(files.write_all(tmp_path / "x", specimen) / target, name)


@settings(max_examples=60)
@given(data=st.data())
def test_damaged_maps(data: st.DataObject, tmp_path_factory: pytest.TempPathFactory):
    pytest.importorskip("OpenEXR")
    folder = tmp_path_factory.mktemp("staf", numbered=True)
    specimen = staf_bytes(folder)
    victim = data.draw(st.sampled_from(sorted(specimen)))
    (folder / victim).write_bytes(data.draw(damage())(specimen[victim]))
    survives(folder, "staf")
    slice_folder = tmp_path_factory.mktemp("slice", numbered=True)
    (slice_folder / "a").write_bytes(data.draw(damage())(specimen[victim]))
    survives(slice_folder / "a", "merl-slice")


@settings(max_examples=25)
@given(data=st.data())
def test_damaged_tables_of_one_size(data: st.DataObject, tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("utia", numbered=True)
    (folder / "m001_a.bin").write_bytes(data.draw(damage())(format_files.utia_bytes()))
    survives(folder / "m001_a.bin", "utia")


@settings(max_examples=60)
@given(data=st.data())
def test_damaged_maps_of_the_authors(data: st.DataObject, tmp_path_factory: pytest.TempPathFactory):
    pytest.importorskip("OpenEXR")
    folder = tmp_path_factory.mktemp("native", numbered=True)
    format_files.native_staf_folder(folder, lambda path, pixels: files.write_exr(path, pixels, np.float32), times=2)
    victim = data.draw(st.sampled_from(sorted(file for file in folder.rglob("*") if file.is_file())))
    victim.write_bytes(data.draw(damage())(victim.read_bytes()))
    survives(folder, "native-staf")
