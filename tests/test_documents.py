"""The Python of README and docs runs as it is printed, on small data that stand in for the reader's own."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motes
from catalogue import upper_directions
from motes.ageing import age
from motes.cli.demo_command import simulated_plaster
from motes.measurements import Measurement

ROOT = Path(__file__).resolve().parents[1]
ROCK = motes.OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.15)
TEXTS = {
    name: re.findall(r"```python\n(.*?)```", (ROOT / name).read_text("utf-8"), re.DOTALL)
    for name in ("README.md", *sorted(f"docs/{path.name}" for path in (ROOT / "docs").glob("*.md")))
    if not name.startswith("docs/tutorial_")  # tests/test_tutorials.py runs these, with their commands
}


def directions(n: int = 60) -> dict[str, Any]:
    return {"wi": upper_directions(n, 1), "wo": upper_directions(n, 2)}


def demonstration(folder: Path) -> dict[str, Any]:
    """What the commands of the README leave behind."""
    simulated_plaster(folder / "out" / "demo" / "plaster")
    (folder / "plaster").mkdir()
    age(motes.Material(ROCK), "drying_paint", hours=6).save(folder / "plaster" / "material.json")
    return {}


def dried(folder: Path) -> dict[str, Any]:
    """A material that changes, as the files that the texts load."""
    paint = age(motes.Material(ROCK), "drying_paint", hours=6)
    for name in ("paint.json", "fitted.json"):
        paint.save(folder / name)
    return {"material": paint}


def chair(folder: Path) -> dict[str, Any]:
    corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 1 1\nv 1 1 1\n"
    (folder / "chair.obj").write_text(corners + "f 1 2 3\nf 1 3 4\nf 4 3 6\nf 4 6 5\n")
    return {}


def texels(folder: Path) -> dict[str, Any]:
    given = directions(40)
    values = np.broadcast_to(np.float32(ROCK.eval(given["wi"], given["wo"])), (5001, 40, 3))
    return {**given, "values": values}


def paint_map(folder: Path) -> dict[str, Any]:
    from motes.maps import simulate_map

    simulate_map(folder / "paint.zarr", (21, 31), times=2)
    return {}


def fitted_map(folder: Path) -> dict[str, Any]:
    from motes.maps import fit_map, simulate_map

    simulate_map(folder / "small.zarr", (9, 8), times=1)
    return {
        "fitted": fit_map(
            folder / "small.zarr", "oren_nayar + torrance_sparrow", out=folder / "fit.zarr", covariance=True
        )
    }


def own_map(folder: Path) -> dict[str, Any]:
    import xarray

    height, width, hours = 4, 5, [0.0, 1.0, 2.0]
    given = directions(12)
    values = np.full((height, width, 3, 12, 3), 0.2, np.float32)
    return {**given, "maps": motes.maps, "xarray": xarray, "x": 0, "y": 0} | {
        "height": height, "width": width, "hours": hours, "values": values,
    }  # fmt: skip


def fitted(folder: Path) -> dict[str, Any]:
    given = directions()
    data = Measurement.from_arrays(given["wi"], given["wo"], ROCK.eval(given["wi"], given["wo"]))
    fit = motes.fit(replace(data, provenance={"name": "rock"}), model="oren_nayar + torrance_sparrow")
    return {"motes": motes, "fit": fit, "other": motes.Material(ROCK), **dried(folder)}


def surface(folder: Path) -> dict[str, Any]:
    return {**directions(), "model": ROCK, "upstream": 1.0, "u": np.full((60, 2), 0.5)}


#: What the blocks of a text need: for each, functions that write files and give names.
NEEDS: dict[str, list[tuple[Callable[[Path], dict[str, Any]], ...]]] = {
    "README.md": [(demonstration,)],
    "docs/ageing.md": [(dried, surface)],
    "docs/certify.md": [()],
    "docs/data.md": [()],
    "docs/deposition.md": [(chair,)],
    "docs/engine.md": [(surface,), (texels,)],
    "docs/exports.md": [(dried,), (surface,)],
    "docs/maps.md": [(paint_map,), (own_map,), (fitted_map,), (fitted_map,)],
    "docs/plan.md": [()],
    "docs/real_dusts.md": [(dried,)],
    "docs/viewer.md": [(fitted,)],
}
ELSEWHERE = {
    "docs/rendering.md": "tests/test_rendering_plugins.py",  # needs a variant of its own in this process
    "docs/scaling.md": "tests/test_maps_cluster.py",  # needs a scheduler
}
PACKAGES = {"docs/maps.md": ("zarr", "xarray"), "docs/deposition.md": ("mitsuba",), "docs/viewer.md": ("anywidget",)}


def test_every_block_is_run() -> None:
    """A block that is new needs a line in `NEEDS`: the functions that give what it uses, or none."""
    found = {name: len(blocks) for name, blocks in TEXTS.items() if blocks}
    assert found == {name: len(needs) for name, needs in NEEDS.items()} | {
        name: 1 for name, test in ELSEWHERE.items() if (ROOT / test).is_file()
    }


@pytest.mark.parametrize(("name", "k"), [(name, k) for name, needs in NEEDS.items() for k in range(len(needs))])
def test_a_block_runs(name: str, k: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for package in PACKAGES.get(name, ()):
        pytest.importorskip(package)
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    for given in NEEDS[name][k]:
        names |= given(tmp_path)
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", module="zarr|xarray|numcodecs")
        exec(compile(TEXTS[name][k], f"{name}, block {k + 1}", "exec"), names)
