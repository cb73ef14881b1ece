"""The error of float32 is bounded, and docs/accuracy.md states what tools/accuracy.py measures."""

from __future__ import annotations

import importlib.util
import re
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

import golden
from catalogue import ENTRIES, Entry, upper_directions

ROOT = Path(__file__).parents[1]
STATED = re.compile(r"<!-- table: (.+?) -->\n.*\n.*\n((?:\|.*\n?)+)")


@pytest.fixture(scope="module")
def accuracy() -> ModuleType:
    spec = importlib.util.spec_from_file_location("accuracy", ROOT / "tools" / "accuracy.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_page_states_what_the_tool_measures(accuracy: ModuleType) -> None:
    """Every line of every table, and no figure more than twice what is stated; libraries round differently by an ulp or two."""
    page = dict(STATED.findall((ROOT / "docs" / "accuracy.md").read_text(encoding="utf-8")))
    assert list(page) == list(accuracy.TABLES)
    for title, rows in accuracy.tables():
        lines = [[cell.strip() for cell in line.strip("|").split("|")] for line in page[title].splitlines()]
        # Which model is worst may differ by a rounding error.
        names = [
            [re.sub(r" \(`.*`\)", "", name) for name in column]
            for column in ([x[0] for x in lines], [r.what for r in rows])
        ]
        assert names[0] == names[1]
        for (name, *stated), row in zip(lines, rows, strict=True):
            for figure, measured in zip(stated, row.errors, strict=True):
                assert measured <= 2 * float(figure) + 1e-16, f"{title}: {name} is {measured:.1e}, not {figure}"


@pytest.mark.parametrize("source", golden.SOURCES)
@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_float32_against_the_reference(entry: Entry, source: str) -> None:
    """Theta up to 1.55 rad, from directions that are rounded to float32 on: 1e-5 relative where there is a highlight to speak of.

    Further down its tail, exp(-t^2) with t = theta_h / sigma_s multiplies the error of t by 2 t^2.
    """
    rows = golden.appendices(source)
    chosen = np.maximum(rows["theta_i"], rows["theta_r"]) <= 1.55
    rows = {name: column[chosen] for name, column in rows.items()}
    model, expected = entry.at_rows(rows)
    narrow = model.with_parameters({name: np.asarray(value, np.float32) for name, value in model.parameters.items()})
    value = narrow.eval(rows["wi"].astype(np.float32), rows["wo"].astype(np.float32))
    assert value.dtype == np.float32
    error = np.abs(value[:, 0] - expected)
    # Parameters are rounded too: sigma_s by 6e-8, so that t^2 is by 1.2e-7.
    t = rows["theta_h"] / rows["sigma_s"]
    if "beckmann" in entry.name:  # exp(-(tan(theta_h) / alpha)^2)
        t = np.tan(rows["theta_h"]) / model.parameters["alpha"]
    highlight = "torrance" in entry.name or "beckmann" in entry.name
    allowed = 1e-5 * np.where(highlight & (t > 3), t * t / 9, 1.0)
    # Where a conductor reflects next to nothing (n + ik near 1, some rows) F is right to 2e-5 of all light, not of itself.
    floor = 2e-5 * 0.7 * rows["rho_s"] if entry.name == "torrance_sparrow_conductor" else 0.0
    if "multiple" in entry.name or "over_a_highlight" in entry.name:
        # Higher orders are sums of terms of both signs, right to three millionths of 1/sr; and what is scattered again is what is left of
        # numbers near 1, where dust that absorbs scatters forward: the engine finds these in float64.
        floor, allowed = 3e-6, 4 * allowed
    if (
        "compensated" in entry.name
    ):  # what is missing is the square of a polynomial: right to a hundred-millionth of 1/sr
        floor = 1e-8
    assert np.all(error <= allowed * expected + floor + 1e-37)


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_float32_against_float64_on_the_same_directions(entry: Entry) -> None:
    wi, wo = (upper_directions(20_000, seed).astype(np.float32) for seed in (1, 2))
    keep = np.minimum(wi[:, 2], wo[:, 2]) >= np.float32(np.cos(1.55))
    wi, wo = wi[keep], wo[keep]
    value, exact = entry.model.eval(wi, wo), entry.model.eval(wi.astype(np.float64), wo.astype(np.float64))
    assert value.dtype == np.float32
    there = exact > 1e-4 * exact.max()
    assert np.max(np.abs(value - exact)[there] / exact[there]) <= 1e-5
