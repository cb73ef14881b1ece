"""What reads each format as a user would, and what must hold of what comes out: for tools/fuzz.py."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np

from motes import load, maps, meshes
from motes.cli import dust_command, options, view_command
from motes.files import structured
from motes.images import photograph, transfer_functions
from motes.maps import lights
from motes.measurements import READERS, Measurement, list_samples, read
from motes.models import describe, parse
from motes.trends import trend_from_dict
from motes.viewer.payload import payload

UP = np.array([[0.0, 0.0, 1.0]])


def measurement(path: Path, name: str, turn: int) -> str:
    """By the name of its format; every tenth by its content."""
    chosen = {"format": name.split()[0]} if turn % 10 else {}
    sample = {"sample": 3} if name == "curet" else {}
    found = read(path, **chosen, **sample)
    json.dumps(found.summary(), allow_nan=False)
    if isinstance(found, Measurement) and sum(found.masked.values()) != np.count_nonzero(~found.mask):
        return "counts of masked samples do not add up"
    if turn % 10 == 0 or READERS[name.split()[0]].takes_sample:
        list_samples(path, **chosen)
    return "read"


def picture(path: Path, _name: str, _turn: int) -> str:
    stated = transfer_functions.Transfer("linear") if path.suffix == ".tif" else None
    found = photograph.open_photograph(path, stated)
    height, width, channels = found.stored.shape
    rows = max(2**20 // (width * channels), 1)  # as they are read, some at a time
    for first in range(0, height, rows):
        values = found.linear(slice(first, first + rows))
        if values.ndim != 3 or np.isinf(values).any():
            return "not an array of numbers"
    return "read"


def mesh(path: Path, _name: str, _turn: int) -> str:
    found = meshes.read_mesh(path)
    bad = not np.isfinite(found.positions).all() or found.triangles.max() >= len(found.positions)
    return "positions or triangles that are none" if bad or found.triangles.min() < 0 else "read"


def material(path: Path, _name: str, _turn: int) -> str:
    found = load(path)
    json.dumps(found.to_dict(), allow_nan=False)
    brdf = found.at(hours=1.0) if found.trends else found.brdf
    return "read" if np.asarray(brdf.eval(UP, UP)).size else "a material that gives nothing"


def model(path: Path, _name: str, _turn: int) -> str:
    """The text that --model takes; said again, it is the same model."""
    found = parse(path.read_text(encoding="utf-8", errors="surrogateescape"))
    found.model.eval(UP, UP)
    return "read" if type(parse(describe(found.model)).model) is type(found.model) else "another model when said again"


def trend(path: Path, _name: str, _turn: int) -> str:
    found = trend_from_dict(structured.json_object(path))
    json.dumps(found.to_dict(), allow_nan=False)
    values = np.asarray(found(np.array([-1.0, 0.0, 2.0, 5.0, 30.0])))
    return "read" if not np.isnan(values).any() else "a trend without values"


def folder_of_a_fit(path: Path, _name: str, _turn: int) -> str:
    """As motes view does."""
    page = payload([load(path / "material.json")], None, view_command._fit_json(path / "fit.json"))
    json.dumps(page, allow_nan=False)
    return "read"


def store(path: Path, _name: str, _turn: int) -> str:
    """As motes info does, and the first texel."""
    found = maps.open_map(path)
    json.dumps(found.summary(), allow_nan=False)
    if isinstance(found, maps.FittedMap):
        found.material(0, 0)
    else:
        found.texels(0, 0)
    return "read"


def table_of_lights(path: Path, _name: str, _turn: int) -> str:
    rows = lights.rows_of(path, path.parent)
    good = all(np.isfinite([*row.wi, *row.wo, row.hours, row.scale]).all() for row in rows)
    return "read" if good else "a row that is not numbers"


def dust(path: Path, _name: str, _turn: int) -> str:
    """The options of motes dust, a line each, on a mesh and with a mask beside them."""
    from motes.rendering.deposition import deposit, open_tau, settled_options
    from motes.rendering.wiping import read_mask

    given: dict[str, str] = {}
    for line in path.read_text(encoding="utf-8", errors="surrogateescape").splitlines():
        name, _, text = line.partition("=")
        given[name] = text
    settled = settled_options(options.numbers(given.get("set", "noise=0.1").split(), "--set"))
    try:
        days = float(given.get("days", "1"))
    except ValueError:  # the command line says so
        return "refused"
    level = open_tau(days)
    directions = {
        name: dust_command.vector(given[name], f"--{name}") for name in ("up", "source", "wind") if name in given
    }
    found = deposit(
        meshes.read_mesh(path.parent / "a.ply"),
        mask=read_mask(path.parent / "mask.png"),
        strokes=[dust_command._stroke(given["stroke"])] if "stroke" in given else [],
        rays=4,
        **directions,
        **settled,
    )
    tau = found.tau(level)
    return "read" if np.isfinite(tau).all() and tau.min() >= 0 else "a thickness that is none"


#: The readers that are none of measurements.
OTHERS: dict[str, Callable[[Path, str, int], str]] = {
    "picture": picture,
    "mesh": mesh,
    "material": material,
    "model": model,
    "trend": trend,
    "folder of a fit": folder_of_a_fit,
    "reflectance map": store,
    "fitted map": store,
    "table of lights": table_of_lights,
    "dust": dust,
}
