"""``motes`` with Zarr stores: fit, info, simulate, stack; what it says of bad input, full disks and kills."""

from __future__ import annotations

import json
import os
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("zarr")

import maps_support as support
from motes import maps, read

Run = Callable[..., tuple[int, str, str]]
SECONDS = 120
MOTES = (sys.executable, "-m", "motes.cli.main")


@pytest.fixture(scope="module")
def paint(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return maps.simulate_map(tmp_path_factory.mktemp("maps") / "paint.zarr", (24, 16), times=4, lights=8, chunk=8).path


def refused(result: tuple[int, str, str], *words: str) -> None:
    """Exit status 2, a sentence and a hint."""
    status, out, err = result
    assert (status, out) == (2, ""), result
    assert [line.partition(":")[0] for line in err.splitlines()] == ["error", "hint"], err
    for word in words:
        assert word in err


def test_a_map_is_no_single_material_and_the_hints_hold(motes: Run, paint: Path) -> None:
    assert motes("fit", paint, "-m", "lambert", "--block", 8, "--no-report", "-o", "fitted.zarr")[0] == 0
    for command in (("export", "fitted.zarr", "--to", "glsl"), ("view", "gold", "--against", "fitted.zarr")):
        refused(motes(*command), "material for every texel", "motes view fitted.zarr", "one texel's")
    assert motes("view", "fitted.zarr", "--no-open")[0] == 0
    fitted = maps.open_map("fitted.zarr")
    assert isinstance(fitted, maps.FittedMap)
    assert fitted.material(0, 1).channels == ("R", "G", "B")
    refused(motes("export", paint, "--to", "glsl"), "measured reflectance", "motes fit")


def test_fit_of_a_map_writes_maps_and_a_page(motes: Run, paint: Path) -> None:
    status, out, err = motes("fit", paint, "-m", "lambert", "--block", 8)
    assert (status, err) == (0, "")
    for words in ("16 x 24 texels, 4 times", "K_d", "1536 converged", "6 of 6 done"):
        assert words in out
    assert sorted(p.name for p in Path().iterdir()) == [
        "motes-paint.html",
        "motes-paint.png",
        "motes-paint.zarr",
    ]
    fitted = maps.open_map("motes-paint.zarr")
    assert isinstance(fitted, maps.FittedMap)
    assert fitted.done().all()
    status, out, err = motes("fit", paint, "-m", "lambert", "--block", 8, "--json", "--no-report")
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert (result["kind"], result["blocks_done"], result["parameters"]) == ("fitted map", 6, ["K_d"])
    assert result["truth"]["K_d"]["median_error"] > 0
    refused(motes("fit", paint, "-m", "oren_nayar", "--block", 8), "another run", "--restart")
    assert motes("fit", paint, "-m", "lambert", "--loss", "plain", "--quiet", "--restart") == (0, "", "")


def test_options_reach_the_fit(motes: Run, paint: Path) -> None:
    options = ("--weights", "uniform", "--fix", "K_d=0.5,0.4,0.3", "--max-theta-deg", 60, "-o", "out.zarr")
    status, out, _ = motes("fit", paint, "-m", support.MODEL, *options, "--fix", "sigma_d=0.3", "--json")
    result = json.loads(out)
    assert (status, result["parameters"]) == (0, ["K_s", "sigma_s"])
    assert result["fixed"] == {"K_d": [0.5, 0.4, 0.3], "sigma_d": 0.3}
    assert maps.open_map("out.zarr").plan.settings.max_theta == pytest.approx(np.pi / 3)  # type: ignore[union-attr]
    assert Path("out.html").is_file()


def test_trends_and_pictures(motes: Run, paint: Path) -> None:
    pytest.importorskip("OpenEXR")
    status, out, err = motes("fit", paint, "-m", "lambert", "--trend", "K_d=linear", "-o", "out.zarr", "--exr", "exr")
    assert (status, err) == (0, "")
    assert "K_d_start" in out
    assert "4 times together" in out
    fitted = maps.open_map("out.zarr")
    back = read("exr")
    np.testing.assert_allclose(back.at(1)["K_d"], fitted.values("K_d")[:, :, -1], rtol=1e-4)  # type: ignore[union-attr]
    status, out, _ = motes("info", "exr")
    assert status == 0
    assert "16 x 24 texels" in out


def test_info_of_maps(motes: Run, paint: Path) -> None:
    status, out, err = motes("info", paint)
    assert (status, err) == (0, "")
    for words in ("reflectance map", "16 x 24 texels", "4 times, 0 to 6 h", "16, one light", "R, G, B", "simulated"):
        assert words in out
    assert json.loads(motes("info", paint, "--json")[1])["shape"] == [24, 16]
    motes("fit", paint, "-m", "lambert", "-o", "out.zarr", "--quiet")
    status, out, err = motes("info", "out.zarr")
    assert (status, err) == (0, "")
    assert "lambert" in out
    assert json.loads(motes("info", "out.zarr", "--json")[1])["fits"]["converged"] == 1536


def test_simulate_makes_a_map(motes: Run) -> None:
    status, out, err = motes("simulate", "m.zarr", "--size", 10, "--scans", 2, "--hours", 3, "--noise", 0, "--seed", 1)
    assert (status, err) == (0, "")
    assert "motes fit m.zarr" in out
    made = maps.open_map("m.zarr")
    assert (made.shape, made.hours.tolist()) == ((10, 10), [0, 3])
    refused(motes("simulate", "m.zarr"), "exists")
    refused(motes("simulate", "n.zarr", "--phenomenon", "dust"), "--phenomenon is not offered for maps")
    refused(motes("simulate", "rig", "--size", 10), "--size is for maps")
    assert not Path("n.zarr").exists()
    assert not Path("rig").exists()


def test_stack_makes_a_map_of_pictures(motes: Run) -> None:
    pytest.importorskip("OpenEXR")
    import measurement_files as files

    Path("shots").mkdir()
    lines = ["file,theta_i_deg,phi_i_deg"]
    for k in range(3):
        files.write_exr(Path("shots") / f"{k}.exr", np.full((5, 4, 3), 0.1))
        lines.append(f"{k}.exr,{20 * k},0")
    Path("shots/lights.csv").write_text("\n".join(lines))
    status, out, err = motes("stack", "shots")
    assert (status, err) == (0, "")
    assert "motes fit shots.zarr" in out
    assert maps.open_map("shots.zarr").sizes == (1, 3, 3)
    result = json.loads(motes("stack", "shots", "-o", "b.zarr", "--linear", "--chunk", 2, "--json")[1])
    assert result["chunks"][:2] == [2, 2]
    refused(motes("stack", "shots"), "exists")
    refused(motes("stack", "shots", "-o", "c.zarr", "--table", "none.csv"), "none.csv does not exist")
    refused(motes("stack", "nowhere"), "does not exist")
    refused(motes("stack", "shots", "--chunk", 0), "--chunk")


# ---------------------------------------------------------------- bad input


def test_bad_input_is_explained_and_leaves_nothing(motes: Run, paint: Path) -> None:
    refused(motes("fit", "nothing.zarr"), "does not exist")
    Path("empty.zarr").mkdir()
    refused(motes("fit", "empty.zarr"), "not a Zarr group")
    refused(motes("fit", paint, "--sample", 1), "--sample 1 chooses one sample", "--time chooses one time")
    refused(motes("fit", paint, "--read", "times=0,1,2,3"), "--read times=0,1,2,3", "the store's array time")
    refused(motes("fit", paint, "--read", "angles=deg"), "--read angles=deg", "docs/maps.md")
    refused(motes("fit", paint, "--time", 4), "--time 4 is not among the 4 time(s)", "0 to 3")
    refused(motes("fit", paint, "--time", 0, "--trend", "K_d=linear"), "one time has no trend", "Leave --time out")
    refused(motes("fit", paint, "-m", "paint"), "not a model")
    refused(motes("fit", paint, "--workers", 0), "0 workers")
    refused(motes("fit", paint, "-o", "/proc/motes/out.zarr", "-m", "lambert"), "cannot be written")
    Path("table.csv").write_text("theta_i,theta_r,phi_r,grey\n0.1,0.2,0,0.3\n")
    for option in (
        ("--workers", 2),
        ("--scheduler", "tcp://a:1"),
        ("--block", 8),
        ("--exr", "x"),
        ("--restart",),
        ("--covariance",),
    ):
        refused(motes("fit", "table.csv", *option), f"{option[0]} is for maps")
    assert sorted(p.name for p in Path().iterdir()) == ["empty.zarr", "table.csv"]


def test_a_failed_chunk_is_listed_and_the_status_is_1(motes: Run, paint: Path) -> None:
    support.copy(paint, Path("map.zarr"))
    support.damage(Path("map.zarr"), "1/0/0/0/0")
    status, out, err = motes("fit", "map.zarr", "-m", "lambert", "--block", 8, "-o", "out.zarr")
    assert status == 1
    assert "5 of 6 done" in out
    assert "256 not fitted" in out
    first, second = err.splitlines()
    assert first.startswith("warning: block (1, 0), rows 8 to 15, columns 0 to 7, could not be fitted: ")
    assert second.startswith("warning: 1 of 6 blocks failed")
    assert "Only 5 of 6 blocks" in Path("out.html").read_text()
    assert motes("fit", "map.zarr", "-m", "lambert", "--block", 8, "-o", "out.zarr")[0] == 1


def test_a_scheduler_that_is_not_there_is_explained(motes: Run, paint: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("distributed")
    monkeypatch.setattr("motes.maps.cluster.CONNECT", 0.5)
    result = motes("fit", paint, "-m", "lambert", "--scheduler", "tcp://127.0.0.1:9")
    refused(result, "no scheduler answers at tcp://127.0.0.1:9")


def process(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(  # type: ignore[call-overload, no-any-return]
        [*MOTES, *map(str, arguments)],
        **{"capture_output": True, "text": True, "timeout": SECONDS, "env": environment, **options},
    )


def test_a_disk_that_fills_up_keeps_finished_blocks(tmp_path: Path) -> None:
    """In the middle of the run: the first block has no data, so that nothing large is written for it."""
    source = maps.simulate_map(tmp_path / "map.zarr", (64, 32), times=4, lights=3).path
    values, out = support.values_of(source), tmp_path / "out.zarr"
    values[:32] = np.full((32, *values.shape[1:]), np.nan, "f4")
    arguments = ("fit", source, "-m", "lambert", "--block", 32, "-o", out, "--no-report")
    # First without limits: a kernel that is not cached yet is a large file, too.
    whole = maps.fit_map(source, "lambert", out=tmp_path / "whole.zarr", block=(32, 32))

    def small_files() -> None:  # every piece of metadata is smaller than this, K_d of a block larger
        resource.setrlimit(resource.RLIMIT_FSIZE, (30_000, 30_000))

    result = process(*arguments, preexec_fn=small_files)
    assert result.returncode == 2, result.stderr
    assert [line.partition(":")[0] for line in result.stderr.splitlines()] == ["error", "hint"]
    assert "disk is full: File too large" in result.stderr
    assert "after the 1 blocks that are done" in result.stderr
    assert maps.open_map(out).done().ravel().tolist() == [True, False]  # type: ignore[union-attr]
    assert not list(out.rglob("*.partial"))
    assert process(*arguments).returncode == 0
    assert support.contents(out) == support.contents(whole.path)


@pytest.mark.skipif(os.geteuid() != 0, reason="mounting a small file system needs root")
def test_a_disk_that_is_really_full(paint: Path, tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=140k", "tmpfs", str(disk)], capture_output=True)
    if mount.returncode != 0:
        pytest.skip("mounting is not allowed here")
    try:
        out = disk / "out.zarr"
        arguments = ("fit", paint, "-m", "lambert", "--block", 8, "-o", out, "--no-report")
        result = process(*arguments)
        assert result.returncode == 2
        assert "disk is full" in result.stderr
        done = maps.open_map(out).done().sum()  # type: ignore[union-attr]
        assert 0 < done < 6
        subprocess.run(["mount", "-o", "remount,size=16m", str(disk)], check=True)
        assert process(*arguments).returncode == 0
        whole = maps.fit_map(paint, "lambert", out=tmp_path / "whole.zarr", block=(8, 8))
        assert support.contents(out) == support.contents(whole.path)
    finally:
        subprocess.run(["umount", str(disk)], check=False)


def test_killed_and_run_again(paint: Path, tmp_path: Path) -> None:
    """SIGKILL in the middle; the same command does the rest."""
    out = tmp_path / "out.zarr"
    arguments = ("fit", paint, "-m", "lambert", "--block", 2, "-o", out, "--no-report")
    running = subprocess.Popen([*MOTES, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    records = out / "run" / "done" / "c"
    until = time.monotonic() + SECONDS
    while len(list(records.glob("*/*"))) < 5 and time.monotonic() < until and running.poll() is None:
        time.sleep(0.005)
    running.send_signal(signal.SIGKILL)
    running.wait()
    left = maps.open_map(out).done()  # type: ignore[union-attr]
    assert 5 <= left.sum() < left.size
    assert process(*arguments).returncode == 0
    whole = maps.fit_map(paint, "lambert", out=tmp_path / "whole.zarr", block=(2, 2))
    assert support.contents(out) == support.contents(whole.path)


def test_the_bar_shows_rate_and_time_left(paint: Path, tmp_path: Path) -> None:
    """On a terminal: a pseudo one."""
    pty = pytest.importorskip("pty")
    controller, terminal = pty.openpty()
    command = [*MOTES, "fit", paint, "-m", "lambert", "--block", "2", "-o", tmp_path / "out.zarr", "--no-report"]
    environment = {**os.environ, "COLUMNS": "140", "TERM": "xterm"}
    running = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=terminal, env=environment)
    os.close(terminal)
    shown = b""
    try:
        while piece := os.read(controller, 65536):
            shown += piece
    except OSError:  # how Linux says that the other end closed
        pass
    os.close(controller)
    assert running.wait(SECONDS) == 0
    text = shown.decode()
    assert "texels/s" in text
    assert "left" in text
    assert "fitting" in text
