"""The viewer's reader of tables comes to the same as Python's: both run through `tests/tables.json`."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.directions import HORIZON
from viewer_support import SOURCES, node

HERE = Path(__file__).parent
TABLES: list[dict[str, Any]] = json.loads((HERE / "tables.json").read_text(encoding="utf-8"))["tables"]
SCRIPT = """
import {{ readTable }} from './table.mjs';
import {{ decoded }} from './cells.mjs';
import {{ readFileSync }} from 'node:fs';
const found = JSON.parse(readFileSync({tables!r}, 'utf8')).tables.map(({{ text }}) => {{
  try {{
    return readTable('table.csv', decoded(new TextEncoder().encode(text).buffer));
  }} catch (error) {{
    return {{ refused: error.message, hint: error.hint ?? '', kind: error.name }};
  }}
}});
const nan = (key, value) => (typeof value === 'number' && !Number.isFinite(value) ? null : value);
console.log(JSON.stringify(found, nan));
"""


@pytest.fixture(scope="module")
def found(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """What the viewer's reader makes of each table."""
    run_node, esbuild = node(), SOURCES / "node_modules" / ".bin" / "esbuild"
    folder = tmp_path_factory.mktemp("viewer")
    for name in ("table", "cells"):
        bundle = [
            str(esbuild),
            f"src/{name}.ts",
            "--bundle",
            "--format=esm",
            f"--outfile={folder / name}.mjs",
            "--log-level=error",
        ]
        subprocess.run(bundle, cwd=SOURCES, check=True, timeout=120)
    (folder / "run.mjs").write_text(SCRIPT.format(tables=str(HERE / "tables.json")))
    run = subprocess.run([run_node, "run.mjs"], cwd=folder, check=True, timeout=120, capture_output=True, text=True)
    result: list[dict[str, Any]] = json.loads(run.stdout)
    return result


@pytest.mark.parametrize("index", range(len(TABLES)), ids=[t["name"] for t in TABLES])
def test_the_viewer_reads_the_same(index: int, found: list[dict[str, Any]]) -> None:
    table, read = TABLES[index], found[index]
    if "refused" in table:
        assert table["refused"] in read.get("refused", "read")
        assert read["kind"] == "Problem"
        assert read["hint"]
        return
    assert "refused" not in read, read
    assert read["channels"] == table["channels"]
    np.testing.assert_allclose(read["wavelengths"] or [], table.get("wavelengths", []), rtol=1e-12)
    samples = read["samples"]
    times = table.get("times", [0.0])
    np.testing.assert_allclose(sorted({s["hours"] for s in samples}), times, rtol=1e-12)
    for t, hours in enumerate(times):
        now = [s for s in samples if abs(s["hours"] - hours) < 1e-9]
        expected = np.array(table["values"][t], float)
        np.testing.assert_allclose(np.array([s["values"] for s in now], float), expected, rtol=1e-12)
        if "uncertainties" in table:
            np.testing.assert_allclose([s["uncertainties"] for s in now], table["uncertainties"][t], rtol=1e-12)
        else:
            assert all(s["uncertainties"] is None for s in now)
        wi, wo = (np.array([s[w] for s in now]) for w in ("wi", "wo"))
        for w, name in ((wi, "theta_i"), (wo, "theta_r")):
            np.testing.assert_allclose(
                np.degrees(np.arctan2(np.hypot(w[:, 0], w[:, 1]), w[:, 2])), table[name], atol=1e-9
            )
        if "dphi" in table:
            cross, dot = wi[:, 0] * wo[:, 1] - wi[:, 1] * wo[:, 0], np.sum(wi[:, :2] * wo[:, :2], axis=1)
            np.testing.assert_allclose(np.arctan2(cross, dot), np.radians(table["dphi"]), atol=1e-12)
    for words in table.get("notes", ()):
        assert words in " ".join(read["notes"])


def test_the_horizon_of_the_viewer_is_that_of_all() -> None:
    declared = re.search(r"export const HORIZON = (\S+);", (SOURCES / "src" / "table.ts").read_text())
    assert declared
    assert float(declared[1]) == HORIZON
