"""What holds the repository together: the rooms' imports, the entry point, the Makefile, the version."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tomllib
from importlib import metadata
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


def test_rooms_import_one_way() -> None:
    command = shutil.which("lint-imports", path=os.path.dirname(sys.executable)) or shutil.which("lint-imports")
    assert command, "import-linter is among the packages of motes[dev]"
    result = subprocess.run([command, "--no-cache"], cwd=ROOT, capture_output=True, text=True, timeout=300)
    assert result.returncode == 0, result.stdout
    assert "1 kept, 0 broken" in result.stdout


def test_the_command_is_the_entry_point_of_the_package() -> None:
    (entry,) = (e for e in metadata.entry_points(group="console_scripts") if e.name == "motes")
    from motes.cli.main import main

    assert entry.load() is main


def test_the_version_is_said_once() -> None:
    import motes

    assert motes.__version__ == PROJECT["project"]["version"] == metadata.version("motes")


def test_rooms_are_attributes_of_the_package_from_the_start() -> None:
    """As the README writes them, in a process that has imported nothing else."""
    asked = "import motes; motes.directions.from_spherical(0.1, 0.2); assert not hasattr(motes, 'nowhere') and not hasattr(motes, '_x')"
    subprocess.run([sys.executable, "-c", asked], check=True, timeout=60)


def test_everything_an_extra_names_is_in_all_or_dev() -> None:
    extras = PROJECT["project"]["optional-dependencies"]
    (everything,) = extras["all"]
    named = set(re.fullmatch(r"motes\[(.*)\]", everything)[1].split(","))  # type: ignore[index]
    assert named == set(extras) - {
        "all",
        "test",
        "dev",
        "docs",
        "cuda",
    }  # the last is of use with a graphics card alone
    assert "motes[all,test]" in extras["dev"]


def test_continuous_integration_runs_make_test() -> None:
    run = ROOT / ".ci" / "run"
    assert os.access(run, os.X_OK)
    assert run.read_text().splitlines()[-1] == "exec make test"
    assert "make test" in (ROOT / ".github" / "workflows" / "ci.yml").read_text()


def test_the_newest_and_the_lowest_are_tried_every_week() -> None:
    weekly = (ROOT / ".github" / "workflows" / "weekly.yml").read_text()
    assert "cron:" in weekly
    assert ".ci/run" in weekly
    assert "make test-lowest" in weekly


def test_everything_has_a_lowest_version() -> None:
    """`make test-lowest` installs these."""
    named = [
        *PROJECT["project"]["dependencies"],
        *(r for e in PROJECT["project"]["optional-dependencies"].values() for r in e),
    ]
    for requirement in named:
        if not requirement.startswith("motes["):
            assert re.match(r"[\w-]+>=[\d.]+( *;.*)?$", requirement), requirement


def make(*arguments: str, **options: object) -> subprocess.CompletedProcess[str]:
    environment = {k: v for k, v in os.environ.items() if not k.startswith("MAKE")}
    return subprocess.run(["make", *arguments], cwd=ROOT, capture_output=True, text=True, timeout=60, env=environment)


needs_make = pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")


@needs_make
def test_make_demo_and_test_install_first(tmp_path: Path) -> None:
    demo = make("-n", "demo", f"VENV={tmp_path}/v").stdout.splitlines()
    assert demo[-1] == f"{tmp_path}/v/bin/motes demo -o out/demo"
    assert any("-m venv" in line for line in demo)
    assert any("--editable '.[all]'" in line for line in demo)
    test = make("-n", "test", f"VENV={tmp_path}/v").stdout
    assert "--editable '.[dev]'" in test
    assert "pytest -n 2" in test
    assert "--no-print-directory lint" in test
    lint = make("-n", "lint", f"VENV={tmp_path}/v").stdout
    for check in ("ruff check", "ruff format --check", "mypy", "lint-imports", "tools/rooms.py"):
        assert check in lint


@needs_make
def test_make_test_lowest_runs_tests_that_exist(tmp_path: Path) -> None:
    lines = make("-n", "test-lowest", f"LOWEST={tmp_path}/v").stdout.splitlines()
    assert any("--resolution lowest-direct --editable '.[all,test]'" in line for line in lines)
    files = re.findall(r"tests/test_\w+\.py", lines[-1])
    assert len(files) >= 15
    assert [name for name in files if not (ROOT / name).is_file()] == []


@needs_make
def test_make_explains_an_old_python(tmp_path: Path) -> None:
    result = make("demo", "PYTHON=", f"VENV={tmp_path}/v")
    assert result.returncode == 2
    assert "Motes needs Python 3.11 or later" in result.stdout
    assert not list(tmp_path.iterdir())


@needs_make
def test_make_does_not_install_twice(tmp_path: Path) -> None:
    for extra in ("all", "dev"):
        stamp = tmp_path / f".installed-{extra}"
        stamp.touch()
        os.utime(stamp, (2**31 - 1, 2**31 - 1))
    assert "venv" not in make("-n", "demo", f"VENV={tmp_path}").stdout.replace(str(tmp_path), "")
