"""The tool that studies calibration sees errors that are right, too small, too large and off to one side."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from scipy import stats

from motes.fitting.error_bars import LEVELS
from motes.fitting.result import FittedParameter
from motes.fitting.verdicts import Verdict

ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    sys.path.insert(0, str(ROOT / "tools"))
    try:
        spec = importlib.util.spec_from_file_location("calibration_study", ROOT / "tools" / "calibration_study.py")
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
    finally:
        sys.path.remove(str(ROOT / "tools"))
    return module


@pytest.mark.parametrize("freedom", [3.0, 7.5, 40.0])
def test_degrees_of_freedom_come_back_from_two_intervals(tool: ModuleType, freedom: float) -> None:
    small, large = (stats.t.ppf(0.5 + LEVELS[level] / 2, freedom) for level in LEVELS)
    assert tool.freedom_of(large / small) == pytest.approx(freedom, rel=1e-4)
    normal = stats.norm.ppf(0.975) / stats.norm.ppf(0.5 + LEVELS["68"] / 2)
    assert tool.freedom_of(normal) > 1e5


@pytest.mark.parametrize("squared", [False, True])
def test_ranks_of_students_t_are_those_of_its_distribution(tool: ModuleType, squared: bool) -> None:
    """The intervals of a parameter, in the coordinate in which they are symmetric; one end cut off at a bound changes nothing."""
    freedom, scale, power = 6.0, 0.02, 2 if squared else 1
    value = 0.3
    half = {level: scale * stats.t.ppf(0.5 + share / 2, freedom) for level, share in LEVELS.items()}
    ends = {
        level: np.array([max(value**power - h, 0) ** (1 / power), (value**power + h) ** (1 / power)])
        for level, h in half.items()
    }
    fitted = FittedParameter("a", value, 0.1, ends, (Verdict.IDENTIFIED,), "a", "", "", (0.0, 1.0))
    for truth in (0.27, 0.3, 0.34):
        expected = stats.t.cdf((truth**power - value**power) / scale, freedom)
        assert tool.from_intervals(np.array([truth]), fitted, squared)[0] == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize(
    ("spread", "shift", "right"), [(1, 0, True), (0.7, 0, False), (1.4, 0, False), (1, 0.3, False)]
)
def test_wrong_errors_are_seen(tool: ModuleType, spread: float, shift: float, right: bool) -> None:
    rng = np.random.default_rng(8)
    truth = np.zeros(4000)
    value = rng.standard_normal(4000)
    ranks = tool.from_error(truth, value + shift, np.full(4000, spread))
    counts, _ = np.histogram(ranks, tool.BINS, (0, 1))
    low, high = tool.histogram_band(len(ranks))
    shares = counts * tool.BINS / len(ranks)
    assert bool(np.all((low <= shares) & (shares <= high))) is right
    levels = np.linspace(0, 1, 201)
    off = tool.covered(ranks, levels) - levels
    if spread != 1:
        assert np.abs(off).max() > tool.distance_band(len(ranks))
        assert (off.sum() > 0) == (spread > 1)
    if right:
        assert np.abs(off).max() <= tool.distance_band(len(ranks))


def test_what_has_no_error_has_no_rank(tool: ModuleType) -> None:
    drawn = tool.Drawn({"K_d": np.r_[np.full(60, 0.5), np.full(20, np.nan)], "K_s": np.full(80, np.nan)})
    assert drawn.stated == pytest.approx(0.375)
    assert list(drawn.known) == ["K_d"]
    assert np.isnan(tool.from_error(np.array([1.0]), np.array([1.0]), np.array([np.nan])))[0]


def test_the_page_is_of_this_tool(tool: ModuleType) -> None:
    page = (ROOT / "docs" / "calibration.md").read_text(encoding="utf-8")
    cases = {(case.kind, case.data, case.errors) for case in tool.CASES}
    rows = [
        line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith(("| static", "| time", "| map"))
    ]
    assert len(rows) >= 8
    assert {tuple(row[:3]) for row in rows} <= cases
    kinds = {row[0] for row in rows}
    assert kinds == set(tool.KINDS)
    lines = ["| " + " | ".join(row) + " |" for row in rows]
    assert tool.page(lines, ("map",)) == page
    for name in ("ranks", "coverage"):
        figure = (ROOT / "docs" / "pictures" / f"calibration-{name}.svg").read_text(encoding="utf-8")
        assert figure.count('class="panel"') == sum(case.kind == "map" for case in tool.CASES)
