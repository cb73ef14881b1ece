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


@pytest.fixture(scope="module")
def pages(tool: ModuleType) -> ModuleType:
    return sys.modules["calibration_page"]


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
def test_wrong_errors_are_seen(tool: ModuleType, pages: ModuleType, spread: float, shift: float, right: bool) -> None:
    rng = np.random.default_rng(8)
    truth = np.zeros(4000)
    value = rng.standard_normal(4000)
    ranks = tool.from_error(truth, value + shift, np.full(4000, spread))
    counts, _ = np.histogram(ranks, pages.BINS, (0, 1))
    low, high = pages.histogram_band(len(ranks))
    shares = counts * pages.BINS / len(ranks)
    assert bool(np.all((low <= shares) & (shares <= high))) is right
    levels = np.linspace(0, 1, 201)
    off = pages.covered(ranks, levels) - levels
    if spread != 1:
        assert np.abs(off).max() > pages.distance_band(len(ranks))
        assert (off.sum() > 0) == (spread > 1)
    if right:
        assert np.abs(off).max() <= pages.distance_band(len(ranks))


def test_what_has_no_error_has_no_rank(tool: ModuleType, pages: ModuleType) -> None:
    drawn = pages.Ranks(
        "map", "a", "b", {"K_d": np.r_[np.full(60, 0.5), np.full(20, np.nan)], "K_s": np.full(80, np.nan)}
    )
    assert drawn.stated == pytest.approx(0.375)
    assert list(drawn.known) == ["K_d"]
    assert np.isnan(tool.from_error(np.array([1.0]), np.array([1.0]), np.array([np.nan])))[0]


def test_a_study_goes_on_where_it_stopped(tool: ModuleType, tmp_path: Path) -> None:
    """The same parts in one go and in two; one that was cut off is made again, and none is made twice."""
    made: list[int] = []

    def part(k: int) -> dict[str, np.ndarray]:
        made.append(k)
        return {n: np.array([np.nan if n == "K_s" else (k + 0.5) / 10]) for n in tool.NAMES}

    case = tool.Case("time", "EON + GTR", "auto", part, 0.5)
    whole = tool.went_on(case, 10, tmp_path / "whole", np.inf)
    assert made == [0, 1, 2, 3, 4]
    made.clear()
    tool.went_on(case, 4, tmp_path / "parts", np.inf)
    file = tmp_path / "parts" / case.file
    file.write_text(file.read_text(encoding="utf-8")[:-9], encoding="utf-8")
    again = tool.went_on(case, 10, tmp_path / "parts", np.inf)
    assert made == [0, 1, 1, 2, 3, 4]
    for name in tool.NAMES:
        np.testing.assert_array_equal(
            tool.together(case, whole).by_name[name], tool.together(case, again).by_name[name]
        )
    assert len(tool.went_on(case, 100, tmp_path / "parts", -np.inf)) == 5  # no time is left


def test_the_page_is_of_this_tool(tool: ModuleType, pages: ModuleType) -> None:
    page = (ROOT / "docs" / "calibration.md").read_text(encoding="utf-8")
    cases = {(case.kind, case.data, case.errors) for case in tool.CASES}
    rows = [
        line.strip("| ").split(" | ") for line in page.splitlines() if line.startswith(("| static", "| time", "| map"))
    ]
    assert {tuple(row[:3]) for row in rows} == cases
    assert tool.page(["| " + " | ".join(row) + " |" for row in rows]) == page
    for name in ("ranks", "coverage"):
        figure = (ROOT / "docs" / "pictures" / f"calibration-{name}.svg").read_text(encoding="utf-8")
        assert figure.count('class="panel"') == len(tool.CASES)
