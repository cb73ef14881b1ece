"""Stores appear whole or not at all, whatever ends the process that makes them; one process at a time works on one."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("zarr")

import maps_support as support
from image_files import png_bytes
from motes import maps
from motes.errors import MotesError
from motes.maps import making

SOURCES = str(Path(maps.__file__).resolve().parents[2])
# Every so many-th operation is tried; 1 takes minutes.
STEP = os.environ.get("MOTES_KILL_EVERY", "29")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork")
@pytest.mark.parametrize("job", ["simulate", "stack", "create", "restart"])
def test_killed_at_any_operation_it_can_go_on(job: str, tmp_path: Path) -> None:
    """What is there is nothing or whole, and the same command then makes what it makes undisturbed, and leaves nothing else."""
    pictures = tmp_path / "pictures"
    pictures.mkdir()
    for k in range(2):
        (pictures / f"{k}.png").write_bytes(png_bytes(np.full((2, 3, 1), 90 + k, np.uint8), [0]))
    (pictures / "lights.csv").write_text("file,theta_i_deg,phi_i_deg\n0.png,10,0\n1.png,30,0\n")
    environment = {**os.environ, "PYTHONPATH": SOURCES, "PICTURES": str(pictures)}
    script = Path(__file__).with_name("kill_everywhere.py")
    command = [sys.executable, script, job, tmp_path, STEP]
    result = subprocess.run(command, capture_output=True, text=True, timeout=900, env=environment)
    assert result.returncode == 0, result.stderr
    undisturbed, *killed = (json.loads(line) for line in result.stdout.splitlines())
    assert (undisturbed["ended"], undisturbed["left"]) == (0, ["out.zarr"])
    assert sum(one["ended"] == 137 for one in killed) >= 4
    for one in killed:
        # Zarr's threads make a folder that another has just made: a run may have an operation less than the first, and then ends whole.
        assert one["ended"] == 137 or (one["ended"], one["after"]) == (0, undisturbed["after"])
        assert one["after"] in {"nothing", undisturbed["after"]} or (
            job == "restart" and one["after"] == undisturbed["again"]
        )
        assert one["again"] == undisturbed["again"]
        # A store that was whole already needs no other run, which would remove what was left beside it.
        assert one["left"] == ["out.zarr"] or one["after"] == undisturbed["after"]
    assert any(one["after"] == "nothing" for one in killed)


def test_an_interrupt_leaves_nothing(tmp_path: Path) -> None:
    def interrupted(done: int, total: int, what: str) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        maps.simulate_map(tmp_path / "deep" / "a.zarr", (4, 4), times=1, lights=2, chunk=2, progress=interrupted)
    assert list(tmp_path.iterdir()) == []


def test_what_others_left_is_removed_and_what_they_work_on_is_not(tmp_path: Path) -> None:
    left, worked_on, young = (tmp_path / f".motes-{name}.making" for name in ("left", "worked", "young"))
    for folder in (left, worked_on, young):
        folder.mkdir()
        (folder / "half").write_text("x")
    with making.at_work(worked_on, "another"):
        for folder in (left, worked_on):
            os.utime(folder, (0, 0))
        maps.create_map(tmp_path / "a.zarr", (2, 2), (0, 0, 1), (0, 0, 1))
    assert sorted(p.name for p in tmp_path.iterdir()) == [worked_on.name, young.name, "a.zarr"]


def test_a_store_that_another_made_meanwhile_is_kept(tmp_path: Path) -> None:
    def both() -> None:
        with making.whole(tmp_path / "a") as store:
            making.new_group(store)
            (tmp_path / "a").mkdir()
            (tmp_path / "a" / "theirs").write_text("theirs")

    with pytest.raises(MotesError, match="was made by another process meanwhile"):
        both()
    assert [p.name for p in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a" / "theirs").read_text() == "theirs"


def test_a_link_to_an_empty_folder_is_filled_where_it_points(tmp_path: Path) -> None:
    (tmp_path / "disk").mkdir()
    (tmp_path / "a.zarr").symlink_to(tmp_path / "disk")
    maps.create_map(tmp_path / "a.zarr", (2, 2), (0, 0, 1), (0, 0, 1))
    assert (tmp_path / "disk" / "zarr.json").is_file()
    assert (tmp_path / "a.zarr").is_symlink()


def test_the_refusal_of_a_disk_names_the_path_that_was_asked_for(tmp_path: Path) -> None:
    def filled() -> None:
        with making.whole(tmp_path / "a.zarr") as store:
            stack = maps.create_map(store, (2, 2), (0, 0, 1), (0, 0, 1))
            raise maps.zarrs.Unwritable(stack.path, OSError(28, "No space left on device"))

    with pytest.raises(MotesError, match="cannot be written: No space left on device") as caught:
        filled()
    assert str(caught.value).startswith(str(tmp_path / "a.zarr"))
    assert list(tmp_path.iterdir()) == []


def test_two_fits_into_one_store(tmp_path: Path) -> None:
    """The second is refused while the first is at work, with or without restart; the first is undisturbed."""
    source = maps.simulate_map(tmp_path / "map.zarr", (8, 4), times=1, lights=2, chunk=4).path
    out, refused = tmp_path / "out.zarr", []

    def fit(**options: Any) -> maps.FittedMap:
        return maps.fit_map(source, "lambert", out=out, block=(4, 4), **options)

    def second(done: int, total: int, what: str) -> None:
        if what == "fitting":
            for restart in (False, True):
                with pytest.raises(MotesError, match="another process is at work") as caught:
                    fit(restart=restart)
                refused.append(caught.value.hint)

    first = fit(progress=second)
    assert len(refused) == 6
    assert first.done().all()
    whole = maps.fit_map(source, "lambert", out=tmp_path / "whole.zarr", block=(4, 4))
    assert support.contents(out) == support.contents(whole.path)
    fit(restart=True)
