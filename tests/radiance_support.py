"""Radiance's own programs and library, from the package pyradiance, run in processes of their own: a test that needs them is
skipped, by name, without it."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

SCRIPT = """
import json, sys
import pyradiance.bsdf as bsdf
data = bsdf.load_file(sys.argv[1])
print(json.dumps([list(map(float, bsdf.query(data, *row))) for row in json.load(sys.stdin)]))
"""


def folder() -> Path:
    found = importlib.util.find_spec("pyradiance")
    if found is None or found.origin is None:
        pytest.skip("needs the package pyradiance")
    return Path(found.origin).parent


def program(name: str, *arguments: str, input_: bytes | None = None, cwd: Path | None = None) -> bytes:
    """What a program of Radiance prints."""
    root = folder()
    environment = os.environ | {"PATH": f"{root / 'bin'}:{os.environ['PATH']}", "RAYPATH": f"{root / 'lib'}:."}
    done = subprocess.run(
        [root / "bin" / name, *arguments],
        input=input_,
        env=environment,
        cwd=cwd,
        capture_output=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr.decode()[-500:]
    return done.stdout


def query(path: Path, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """X, Y, Z (n, 3) of the BSDF by Radiance's library, at unit vectors in its own frame."""
    folder()
    rows = []
    for i, o in zip(wi, wo, strict=True):
        rows.append(
            [
                x
                for w in (i, o)
                for x in (np.degrees(np.arccos(np.clip(w[2], -1, 1))), np.degrees(np.arctan2(w[1], w[0])))
            ]
        )
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(path)],
        input=json.dumps(rows),
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-500:]
    return np.array(json.loads(done.stdout))
