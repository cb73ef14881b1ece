"""The command line as its own process: bad input, full disks, closed pipes, interrupts, and how quickly it starts."""

from __future__ import annotations

import json
import os
import resource
import signal
import struct
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from motes import Lambert
from motes.ageing import Rig, drying_plaster, simulate
from motes.cli.main import main

MOTES = (sys.executable, "-m", "motes.cli.main")
SECONDS = 120  # after which a command counts as hung; none takes more than a few

HEADER = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,grey\n"


def motes(*arguments: object, **options: object) -> subprocess.CompletedProcess[str]:
    # Unbuffered output would not fail at the end, where buffered output does.
    environment = {k: v for k, v in os.environ.items() if k not in ("MOTES_DEBUG", "PYTHONUNBUFFERED")}
    return subprocess.run(  # type: ignore[call-overload, no-any-return]
        [*MOTES, *map(str, arguments)],
        **{"capture_output": True, "text": True, "timeout": SECONDS, "env": environment, **options},
    )


def explained(result: subprocess.CompletedProcess[str]) -> str:
    """Standard error, which must be one sentence and a hint."""
    assert result.returncode == 2, result
    assert result.stdout == ""
    lines = result.stderr.splitlines()
    assert [line.split(":")[0] for line in lines] == ["error", "hint"], result.stderr
    return result.stderr


# ---------------------------------------------------------------- bad input


def csv_rows(n: int, value: str) -> str:
    return HEADER + "".join(f"{i % 80},0,{(7 * i) % 80},180,{value}\n" for i in range(n))


def truncated_scan(folder: Path) -> Path:
    sample = simulate(folder / "sample", Lambert(0.5), scans=1, rig=Rig(step_deg=20))
    file = sample / "tvBrdf-data" / "scan01_brdf_camera2_allexposures.txt"
    file.write_text(file.read_text()[:-9])
    return sample


BAD: dict[str, Callable[[Path], Path | bytes | str]] = {
    "empty.csv": lambda _: b"",
    "zeros.bin": lambda _: bytes(4096),
    "garbage.bin": lambda _: bytes((97 * i * i + 13 * i + 7) % 256 for i in range(5000)),
    "text.txt": lambda _: "Dear sir or madam,\nnothing is measured here.\n",
    "one_sample.csv": lambda _: csv_rows(1, "0.3"),
    "all_masked.csv": lambda _: csv_rows(30, "-1"),
    "all_nan.csv": lambda _: csv_rows(30, "nan"),
    "short_row.csv": lambda _: csv_rows(30, "0.3") + "10,0,20\n",
    "words.csv": lambda _: csv_rows(30, "0.3") + "10,0,20,0,bright\n",
    "header_only.csv": lambda _: HEADER,
    # sizes that would allocate terabytes
    "absurd.binary": lambda _: struct.pack("<3i", 90, 90, 2**31 - 1) + bytes(64),
    "absurd.bsdf": lambda _: (
        b"tensor_file\0\1\0"
        + struct.pack("<I", 1)
        + struct.pack("<H4sHBQ3Q", 4, b"vndf", 3, 10, 64, 2**40, 2**40, 2**40)
    ),
    "fields.bsdf": lambda _: b"tensor_file\0\1\0" + struct.pack("<I", 2**32 - 1),
    "absurd.mbsdf": lambda _: (
        b"NVIDIA ARC MBSDF V1\nMBSDF_DATA_REFLECTION=\n" + struct.pack("<3i", 1, 2**31 - 1, 2**31 - 1)
    ),
    "absurd.brdf": lambda _: "# Cornell\n999999999\n400 410 420\n0 0 0 0 0.1\n",
    "truncated.binary": lambda _: struct.pack("<3i", 90, 90, 180) + bytes(1000),
    "truncated.mbsdf": lambda _: b"NVIDIA ARC MBSDF V1\nMBSDF_DATA_REFL",
    "truncated.brdf": lambda _: "# Cornell\n3\n400 410 420\n0.1 0 0.2 3.14 0.1 0.1\n",
    "truncated scan": truncated_scan,
    "empty folder": lambda folder: folder,
    "damaged.json": lambda _: '{"format": "motes material", "version": 1',
    "other.json": lambda _: '{"format": "something else"}',
    "material.json": lambda _: json.dumps(
        {"format": "motes material", "version": 1, "model": "lambert", "parameters": 3}
    ),
}


#: Run the command lines of standard input (JSON, one a line), and say what each returned and wrote.
EACH = """
import contextlib, io, json, sys, traceback
from motes.cli.main import main
for line in sys.stdin:
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main(json.loads(line))
        except BaseException:
            status = traceback.format_exc()
    print(json.dumps([status, out.getvalue(), err.getvalue()]), flush=True)
"""


@pytest.fixture(scope="module")
def told(tmp_path_factory: pytest.TempPathFactory) -> dict[tuple[str, str], subprocess.CompletedProcess[str]]:
    """``told["fit", name]``: what became of a bad input; all of them in one process, for starting takes longer than they do."""
    commands: dict[tuple[str, str], list[str]] = {}
    for name, make in BAD.items():
        folder = tmp_path_factory.mktemp("bad")
        (folder / "in").mkdir()
        made = make(folder / "in")
        path = made if isinstance(made, Path) else folder / "in" / name
        if not isinstance(made, Path):
            path.write_bytes(made.encode() if isinstance(made, str) else made)
        commands["fit", name] = ["fit", str(path), "-o", str(folder / "out")]
        commands["info", name] = ["info", str(path), "--json"]
    given = "".join(json.dumps(command) + "\n" for command in commands.values())
    run = [sys.executable, "-c", EACH]
    done = subprocess.run(run, input=given, capture_output=True, text=True, timeout=SECONDS)
    assert (done.returncode, done.stderr) == (0, "")
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    return {
        key: subprocess.CompletedProcess(command, *line)
        for (key, command), line in zip(commands.items(), lines, strict=True)
    }


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_explained_and_leaves_nothing(
    told: dict[tuple[str, str], subprocess.CompletedProcess[str]], name: str
) -> None:
    explained(told["fit", name])
    assert not Path(told["fit", name].args[-1]).exists()


@pytest.mark.parametrize("name", ["garbage.bin", "absurd.bsdf", "damaged.json", "truncated.binary"])
def test_info_explains_bad_input_too(told: dict[tuple[str, str], subprocess.CompletedProcess[str]], name: str) -> None:
    explained(told["info", name])


def test_a_process_of_its_own_says_the_same(tmp_path: Path) -> None:
    (tmp_path / "garbage.bin").write_bytes(bytes(range(256)) * 20)
    explained(motes("fit", tmp_path / "garbage.bin", "-o", tmp_path / "out"))
    assert not (tmp_path / "out").exists()


def test_devices_and_pipes_are_not_read(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    explained(motes("info", tmp_path / "pipe"))
    explained(motes("info", "/dev/zero"))


# ---------------------------------------------------------------- output that cannot be written


@pytest.fixture(scope="module")
def plaster(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return simulate(tmp_path_factory.mktemp("cli") / "plaster", drying_plaster, scans=2, rig=Rig(step_deg=2))


def test_an_output_folder_that_cannot_be_made_is_found_before_the_fit(tmp_path: Path, plaster: Path) -> None:
    (tmp_path / "file").write_text("mine")
    for out in (tmp_path / "file", tmp_path / "file" / "deeper", Path("/proc/motes/out"), Path("/dev/null/out")):
        assert "cannot be written" in explained(motes("fit", plaster, "-o", out))
    explained(motes("demo", "-o", tmp_path / "file"))
    assert "cannot be written" in explained(motes("simulate", tmp_path / "file" / "deeper", "--scans", 1))
    assert (tmp_path / "file").read_text() == "mine"


@pytest.mark.parametrize("command", ["fit", "simulate"])
def test_a_disk_that_fills_up_leaves_nothing(tmp_path: Path, plaster: Path, command: str) -> None:
    def small_files() -> None:  # no file may grow beyond 1000 bytes: fit.json and the scans are larger
        resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))

    out = tmp_path / "out"
    arguments = ("fit", plaster, "-m", "lambert", "-o", out) if command == "fit" else ("simulate", out, "--scans", 1)
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    assert "large" in explained(motes(*arguments, preexec_fn=small_files, env=environment))
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no /dev/full")
def test_standard_output_on_a_full_disk_is_an_error(plaster: Path) -> None:
    with open("/dev/full", "w") as full:
        result = motes("info", plaster, capture_output=False, stdout=full, stderr=subprocess.PIPE)
    assert result.returncode == 2
    assert result.stderr.startswith("error: No space left on device")
    assert len(result.stderr.splitlines()) == 2


def test_standard_output_that_goes_away_ends_quietly(plaster: Path) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    result = motes("info", plaster, capture_output=False, stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert (result.returncode, result.stderr) == (141, "")


def test_a_shell_that_closed_standard_output_is_no_problem(plaster: Path) -> None:
    result = motes("info", plaster, capture_output=False, stderr=subprocess.PIPE, preexec_fn=lambda: os.close(1))
    assert (result.returncode, result.stderr) == (0, "")


def test_a_terminal_of_another_encoding_gets_its_table(tmp_path: Path, plaster: Path) -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "ascii"}
    result = motes("fit", plaster, "-m", "lambert", "--no-report", "-o", tmp_path / "out", env=environment)
    assert result.returncode == 0
    assert "K_d" in result.stdout


def test_an_interrupt_leaves_nothing(tmp_path: Path) -> None:
    data = simulate(tmp_path / "data", drying_plaster, scans=4, rig=Rig(step_deg=0.05))
    out = tmp_path / "out"
    process = subprocess.Popen(
        [*MOTES, "fit", str(data), "-o", str(out)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        # A shell lets its background jobs ignore the signal, and their children inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    deadline = time.monotonic() + SECONDS
    while not list(out.glob(".motes-*")):  # the fit begins when its folder is there
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    process.send_signal(signal.SIGINT)
    stdout, stderr = process.communicate(timeout=SECONDS)
    assert (process.returncode, stdout, stderr) == (130, "", "interrupted\n")
    assert not out.exists()


@pytest.mark.skipif(os.name != "posix", reason="there is no SIGKILL")
def test_a_fit_that_is_killed_spares_older_results_and_starts_again(tmp_path: Path, plaster: Path) -> None:
    data = simulate(tmp_path / "data", drying_plaster, scans=6, rig=Rig(step_deg=0.5))
    out = tmp_path / "out"
    arguments = ("--no-report", "--quiet", "-o", out)
    assert motes("fit", plaster, "-m", "lambert", *arguments).returncode == 0
    before = {file.name: file.read_bytes() for file in out.iterdir()}
    process = subprocess.Popen([*MOTES, "fit", str(data), *map(str, arguments)])
    deadline = time.monotonic() + SECONDS
    while not list(out.glob(".motes-*")):
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    process.kill()
    process.wait()
    assert {file.name: file.read_bytes() for file in out.iterdir() if file.is_file()} == before
    (left,) = out.glob(".motes-*")
    os.utime(left, (0, 0))  # another day
    assert motes("fit", plaster, "-m", "oren_nayar", *arguments).returncode == 0
    assert {file.name for file in out.iterdir()} == set(before)
    assert json.loads((out / "fit.json").read_text())["model"] == "oren_nayar"


# ---------------------------------------------------------------- real data


def test_curet_sample_10_as_documented(tmp_path: Path, shared: Callable[[str], Path]) -> None:
    # From SciPy's least_squares on the same formula: sigma_d [rad], K_d, and RMS(f - r) / RMS(r).
    expected = {"plain": (0.38436, 0.84839, 0.04818), "linear": (0.34216, 0.83360, 0.05510)}
    for loss, (sigma_d, K_d, relative_rms) in expected.items():
        options = ("--sample", 10, "-m", "oren_nayar", "--loss", loss, "--no-report", "--json", "-o", tmp_path / loss)
        result = json.loads(motes("fit", shared("data/curet"), *options).stdout)
        assert result["parameters"]["sigma_d"]["value"] == pytest.approx(sigma_d, abs=2e-5)
        assert result["parameters"]["K_d"]["value"] == pytest.approx(K_d, abs=2e-5)
        assert result["metrics"]["relative_rms"] == pytest.approx(relative_rms, abs=2e-5)


FORMATS = {
    "cornell/cayman.brdf": "cornell",
    "curet": "container",
    "mbsdf/carpaint_blue.mbsdf": "mbsdf",
    "rgl/vch_silk_blue_rgb.bsdf": "rgl",
    "merl-slices/pink-felt-1d.alta": "merl-slice",
    "staf-tvBTF45": "staf",
}


@pytest.mark.parametrize("name", FORMATS)
def test_info_knows_the_formats(shared: Callable[[str], Path], capsys: pytest.CaptureFixture[str], name: str) -> None:
    status = main(["info", str(shared(f"data/{name}")), "--json"])
    written = capsys.readouterr()
    assert (status, written.err) == (0, "")
    summary = json.loads(written.out)
    assert FORMATS[name] in (summary["kind"], summary.get("format"))


def test_parameter_maps_are_not_fitted(tmp_path: Path, shared: Callable[[str], Path]) -> None:
    assert "motes info" in explained(motes("fit", shared("data/staf-tvBTF45"), "-o", tmp_path / "out"))


# ---------------------------------------------------------------- start


def modules(*arguments: str) -> set[str]:
    """The modules that a command line imports."""
    result = subprocess.run(
        [sys.executable, "-X", "importtime", *arguments], capture_output=True, text=True, timeout=SECONDS
    )
    assert result.returncode == 0
    return {line.rpartition("|")[2].strip() for line in result.stderr.splitlines()}


HEAVY = {
    "llvmlite",
    "matplotlib",
    "scipy",
    "xarray",
    "OpenImageIO",
    "imagecodecs",
    "openpyxl",
    "trimesh",
    "torch",
    "jax",
    "mitsuba",
    "rich.markdown",
    "rich.progress",
}


def test_help_loads_no_numpy() -> None:
    # It takes longer to import than everything that --help needs.
    assert "numpy" not in modules("-m", "motes.cli.main", "--help")


def test_help_and_version_import_little() -> None:
    imported = modules("-m", "motes.cli.main", "--help")
    assert not HEAVY & imported
    assert not {"motes.fitting", "motes.measurements", "motes.report"} & imported
    assert "cyclopts" not in modules("-m", "motes.cli.main", "--version")


def test_importing_the_package_is_light() -> None:
    imported = modules("-c", "import motes")
    assert "motes" in imported
    assert not (HEAVY | {"rich", "cyclopts", "motes.fitting", "motes.measurements"}) & imported
