"""The commands of README.md run as they are written, from a clean folder."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import motes
from motes.cli.demo_command import simulated_plaster
from viewer_support import chromium

ROOT = Path(__file__).resolve().parents[1]
BLOCKS = re.findall(r"```sh\n(.*?)```", (ROOT / "README.md").read_text("utf-8"), re.DOTALL)
#: Blocks of commands of make, and of motes.
MAKE, *MOTES = BLOCKS


def shell(script: str, folder: Path) -> str:
    """What a script says in a shell of its own that stops at the first failure."""
    environment = {k: v for k, v in os.environ.items() if k != "VIRTUAL_ENV"}
    environment["PYTHONPATH"] = str(ROOT / "src")
    done = subprocess.run(
        ["bash", "-ec", script], capture_output=True, text=True, timeout=1200, cwd=folder, env=environment, check=False
    )
    assert done.returncode == 0, f"{script}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What ``make demo`` leaves behind: an environment to activate, and the scans of the demonstration."""
    clean = tmp_path_factory.mktemp("clean")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", clean / ".venv"], check=True)
    command = clean / ".venv" / "bin" / "motes"
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m motes.cli.main "$@"\n')
    command.chmod(0o755)
    simulated_plaster(clean / "out" / "demo" / "plaster")
    return clean


def test_readme_has_the_blocks_that_are_run_here() -> None:
    assert [line.split()[0] for line in MAKE.splitlines()] == ["make", "make"]
    assert len(MOTES) == 2
    for block in MOTES:
        assert {line.split()[0] for line in block.splitlines()} <= {".", "motes"}


def test_make_demo_writes_where_the_readme_goes_on() -> None:
    recipe = shell("make -n -B demo", ROOT)
    assert ".venv/bin/motes demo -o out/demo" in recipe
    assert re.search(r"^test:", (ROOT / "Makefile").read_text(), re.MULTILINE)  # make -n would run it: it calls make


def test_commands_run_one_after_the_other(folder: Path) -> None:
    for package in ("mitsuba", "zarr", "MaterialX"):
        pytest.importorskip(package)
    chromium()  # prints the report
    shell("\n".join(MOTES), folder)
    for name in re.findall(
        r"-o (\S+)", "\n".join(line.partition("#")[0] for block in MOTES for line in block.splitlines())
    ):
        assert (folder / name).exists(), name
    said = re.search(r"plaster/: ([\w., ]+);", MOTES[0])
    assert said
    assert sorted(path.name for path in (folder / "plaster").iterdir()) == sorted(said[1].split(", "))
    assert motes.load(folder / "dusty.json").at(4000).parameters["tau"] > 0.1
    assert json.loads((folder / "plaster" / "fit.json").read_text())["converged"] is True
    assert (folder / "bunny.png").stat().st_size > 20_000
    assert (folder / "motes-map.html").exists()
