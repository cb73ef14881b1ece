"""The tutorials run as they are written, one block after the other, each from an empty folder, and come to what they say."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]
TUTORIALS = sorted((ROOT / "docs").glob("tutorial_*.md"))
PACKAGES = {
    "tutorial_merl": ("MaterialX",),
    "tutorial_mesh": ("mitsuba", "MaterialX"),
    "tutorial_photographs": ("zarr", "png", "OpenImageIO"),
    "tutorial_paper": ("pandas",),
}


def run(name: str, folder: Path) -> str:
    """All that the blocks of a tutorial say."""
    for package in PACKAGES[name]:
        pytest.importorskip(package)
    command = folder / "bin" / "motes"
    command.parent.mkdir()
    command.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m motes.cli.main "$@"\n')
    command.chmod(0o755)
    environment = {**os.environ, "PATH": f"{command.parent}:{os.environ['PATH']}", "PYTHONPATH": str(ROOT / "src")}
    text = (ROOT / "docs" / f"{name}.md").read_text(encoding="utf-8")
    said = []
    for language, block in re.findall(r"^```(sh|python)\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
        program = ["bash", "-ec", block] if language == "sh" else [sys.executable, "-c", block]
        done = subprocess.run(
            program, capture_output=True, text=True, timeout=600, cwd=folder, env=environment, check=False
        )
        assert done.returncode == 0, f"{block}\n{done.stdout}\n{done.stderr}"
        said.append(done.stdout)
    return "\n".join(said)


def numbers(line: str) -> list[float]:
    return [float(x) for x in re.findall(r"\d*\.\d+(?:e-?\d+)?", line)]


def test_there_is_a_test_for_each() -> None:
    assert [path.stem for path in TUTORIALS] == sorted(PACKAGES)


def test_the_researchers(tmp_path: Path) -> None:
    said = run("tutorial_merl", tmp_path)
    fit = json.loads((tmp_path / "paint" / "fit.json").read_text())
    assert fit["metrics"]["relative_rms"] < 0.1, said
    assert len(json.loads((tmp_path / "rivals" / "comparison.json").read_text())["models"]) == 3
    for name in ("paint.html", "paint.mtlx", "paint-certificate.html"):
        assert (tmp_path / name).stat().st_size > 1000


def test_the_artists(tmp_path: Path) -> None:
    run("tutorial_mesh", tmp_path)
    for name in ("bunny.glb", "bunny.ply", "dusty.png", "dusty.mtlx", "clay.osl"):
        assert (tmp_path / name).stat().st_size > 1000, name


def test_the_labs(tmp_path: Path) -> None:
    *_, colours, width = run("tutorial_photographs", tmp_path).strip().splitlines()
    np.testing.assert_allclose(numbers(colours), (0.6, 0.3, 0.2, 0.2, 0.3, 0.5), rtol=0.05)
    np.testing.assert_allclose(numbers(width), (0.2,), rtol=0.05)


def test_the_metrologists(tmp_path: Path) -> None:
    run("tutorial_paper", tmp_path)
    fit = json.loads((tmp_path / "paper" / "fit.json").read_text())
    found = fit["parameters"]["sigma_d"]
    assert abs(np.ravel(found["value"])[0] - 0.25) < 4 * np.ravel(found["stderr"])[0]
    assert 0.8 < fit["metrics"]["reduced_chi_square"] < 1.2
