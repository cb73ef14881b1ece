"""Input that nobody means, at the command line: an answer or one sentence, and never what asks for a report of a defect."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import measurement_files as files
from motes import read, workers
from motes.cli.statuses import DONE, USAGE
from motes.errors import FormatError
from motes.files import reading

Run = Callable[..., tuple[int, str, str]]
HEADER = "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,f_r\n"
LONG = "1" * 140_000  # beyond what the csv module takes for a cell
NOT_UTF_8 = os.fsdecode(b"caf\xe9")
on_posix = pytest.mark.skipif(os.name != "posix", reason="links, and names that are bytes, are of POSIX")


def table(name: str, scale: float = 1.0, more: str = "") -> str:
    """Write a table of sixty noisy values."""
    random = np.random.default_rng(1)
    rows = [
        f"{a:.2f},{p:.1f},{b:.2f},{q:.1f},{scale * (0.1 + 0.01 * noise):.6g}\n"
        for a, b, p, q, noise in zip(
            *random.uniform(0, 75, (2, 60)),
            *random.uniform(0, 360, (2, 60)),
            random.standard_normal(60),
            strict=True,
        )
    ]
    Path(name).write_text(HEADER + "".join(rows) + more)
    return name


def sentence(status: int, out: str, err: str) -> str:
    """The error, which must be one sentence and a hint."""
    assert status == USAGE, err
    assert out == ""
    lines = [line for line in err.splitlines() if not line.startswith("warning: rendering in scalar_rgb")]
    assert [line.partition(":")[0] for line in lines] == ["error", "hint"], err
    return err


def needs_mitsuba() -> None:
    from motes.rendering import llvm

    llvm.prepared()  # before Dr.Jit loads
    pytest.importorskip("mitsuba")


def strict(text: str) -> Any:
    """JSON as its standard has it, without infinities."""

    def refuse(name: str) -> None:
        raise AssertionError(name)

    return json.loads(text, parse_constant=refuse)


# ---------------------------------------------------------------- numbers


@pytest.mark.parametrize("scale", [1e-300, 1e-100, 1e9])
def test_values_of_any_scale_are_fitted_and_json(motes: Run, scale: float) -> None:
    status, out, _ = motes("fit", table("t.csv", scale), "-m", "lambert", "--json")
    assert status == DONE
    assert np.isclose(strict(out)["parameters"]["K_d"]["value"], np.pi * 0.1 * scale, rtol=0.2)


@pytest.mark.parametrize("value", ["1e300", "2e9", "1e400", "inf", "-1e200"])
def test_absurd_values_are_masked_and_counted(motes: Run, value: str) -> None:
    table("t.csv", more=f"10,0,10,0,{value}\n")
    status, out, _ = motes("fit", "t.csv", "--json", "-m", "lambert")
    assert status == DONE
    assert sum(strict(out)["masked"].values()) == 1
    assert np.isclose(strict(out)["parameters"]["K_d"]["value"], np.pi * 0.1, rtol=0.05)


def test_nothing_but_absurd_values(motes: Run) -> None:
    table("t.csv", 1e200)
    assert strict(motes("info", "t.csv", "--json")[1])["masked"]
    assert "beyond" in sentence(*motes("fit", "t.csv", "--json"))


@pytest.mark.parametrize("value", ["1e300", "2e9"])
def test_a_parameter_held_at_an_absurd_value(motes: Run, value: str) -> None:
    assert "held at" in sentence(*motes("fit", table("t.csv"), "-m", "oren_nayar", "--fix", f"K_d={value}"))
    status, out, _ = motes("fit", "t.csv", "-m", "oren_nayar", "--fix", "K_d=1e9", "--json")
    assert status == DONE
    assert strict(out)


# ---------------------------------------------------------------- texts


def test_cells_of_any_length(motes: Run) -> None:
    assert motes("fit", table("plain.csv", more=f"10,0,10,0,{LONG}\n"), "-m", "lambert")[0] == DONE
    table("quoted.csv", more=f'10,0,10,0,"{LONG}"\n')
    assert "field larger" in sentence(*motes("fit", "quoted.csv"))
    Path("header.csv").write_text(f'"{LONG}",{HEADER}1,1,1,1,1,1\n')
    sentence(*motes("info", "header.csv"))
    Path("photographs").mkdir()
    Path("photographs/lights.csv").write_text(f'file,theta_i_deg,phi_i_deg\n"{LONG}",1,1\n')
    assert "field larger" in sentence(*motes("stack", "photographs", "-o", "out.zarr"))


@pytest.mark.parametrize("option", ["path=x", "columns=x", "self=1", "column:=brdf"])
def test_options_that_no_reader_has(motes: Run, option: str) -> None:
    sentence(*motes("info", table("t.csv"), "--read", option))


# ---------------------------------------------------------------- names


@on_posix
def test_links_that_lead_nowhere(motes: Run) -> None:
    Path("self.csv").symlink_to("self.csv")
    Path("nowhere.csv").symlink_to("missing.csv")
    for name in ("self.csv", "nowhere.csv"):
        for command in ("info", "fit", "view"):
            assert "link" in sentence(*motes(command, name))
        sentence(*motes("export", name, "--to", "glsl"))
    sentence(*motes("fit", table("t.csv"), "-m", "lambert", "-o", "self.csv"))


def test_names_that_begin_with_a_tilde(motes: Run) -> None:
    table("~t.csv")
    Path("~nobody-has-this-name").mkdir()
    table("~nobody-has-this-name/t.csv")
    for name in ("~t.csv", "~nobody-has-this-name/t.csv"):
        assert motes("fit", name, "-m", "lambert", "-o", "~out")[0] == DONE
        assert motes("info", "~out")[0] == DONE
        assert read(name).n_directions == 60
    assert "does not exist" in sentence(*motes("info", "~nobody-has-this-name/missing.csv"))
    with pytest.raises(FormatError, match="does not exist"):
        read("~nobody-else/t.csv")


@on_posix
def test_paths_that_are_not_utf_8(motes: Run) -> None:
    name = table(f"{NOT_UTF_8}.csv")
    for arguments in (("info", name), ("info", name, "--json"), ("fit", name, "-m", "lambert", "-o", NOT_UTF_8)):
        assert motes(*arguments)[0] == DONE
    assert motes("view", NOT_UTF_8, "-o", f"{NOT_UTF_8}.html")[0] == DONE
    assert motes("export", NOT_UTF_8, "--to", "materialx", "-o", f"{NOT_UTF_8}.mtlx")[0] == DONE


@on_posix
def test_pictures_have_names_in_utf_8(motes: Run) -> None:
    needs_mitsuba()
    assert motes("fit", table("t.csv"), "-m", "lambert", "-o", "fit")[0] == DONE
    Path(f"{NOT_UTF_8}.exr").touch()
    for more in (("-o", f"{NOT_UTF_8}.png"), ("-o", "a.png", "--env", f"{NOT_UTF_8}.exr")):
        assert "UTF-8" in sentence(*motes("render", "fit", "--size", 4, "--samples", 1, *more))
    assert not list(Path().glob(".*"))


def test_maps_of_parameters_are_no_measured_material(motes: Run, shared: Callable[[str], Path]) -> None:
    needs_mitsuba()
    assert "maps of parameters" in sentence(
        *motes("render", "--compare", shared("data/staf-tvBTF45"), "-o", "a.png", "--size", 4)
    )


# ---------------------------------------------------------------- the surroundings


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("t.binary", files.merl_bytes()),
        ("t.bsdf", files.tensor_file(files.rgl_fields())),
        ("t.bin", files.mbsdf_bytes()),
    ],
)
def test_a_file_that_shrinks_while_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, content: bytes
) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    assert read(path)
    whole = np.fromfile

    def shrunk(file: Path, *arguments: Any, **options: Any) -> Any:
        with open(file, "r+b") as handle:
            handle.truncate(len(content) - 9)
        return whole(file, *arguments, **options)

    monkeypatch.setattr(reading.np, "fromfile", shrunk)
    with pytest.raises(FormatError, match=r"became shorter|truncated"):
        read(path)


def test_work_goes_on_where_no_threads_can_be_had(monkeypatch: pytest.MonkeyPatch) -> None:
    """As under ulimit -v and ulimit -u."""

    def refuse(self: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setenv("NUMBA_NUM_THREADS", "4")
    monkeypatch.setattr(workers, "_pool", None)
    monkeypatch.setattr(threading.Thread, "start", refuse)
    done: list[int] = []
    workers.spread(20, lambda task, _: done.append(task), lambda: None)
    assert done == list(range(20))


def test_a_thread_that_cannot_be_had_is_no_defect(motes: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: Any, **__: Any) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr("motes.measurements.read", refuse)
    assert "ulimit" in sentence(*motes("info", table("t.csv")))


@on_posix
def test_limited_memory_and_no_home(tmp_path: Path) -> None:
    """A user without an account and HOME, as in containers, and little memory: the same answer."""
    os.chdir(tmp_path)
    path = Path(table("t.csv")).absolute()
    code = (
        "import os, resource, sys, pwd\n"
        "for k in ('HOME', 'MOTES_CACHE', 'XDG_CACHE_HOME'): os.environ.pop(k, None)\n"
        "def none(number): raise KeyError(number)\n"
        "pwd.getpwuid = none\n"
        "resource.setrlimit(resource.RLIMIT_AS, (3 * 2**30, 3 * 2**30))\n"
        "from motes.cli.main import main\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", code, "fit", str(path), "-m", "oren_nayar", "--json"],
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert run.returncode == DONE, run.stderr
    assert strict(run.stdout)["converged"]
