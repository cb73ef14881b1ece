"""When to scan: the moments that are known to be best, errors against regression, and bad input."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import motes
from motes.cli.main import main
from motes.errors import MotesError
from motes.trends import Trend


def grey(kind: str, **coefficients: float) -> motes.Material:
    """Something matte whose brightness hardly changes, so that every scan tells as much of it."""
    return motes.Material(motes.Lambert(0.5), trends={"K_d": Trend(kind, coefficients, (0.0, 12.0))})


def test_a_straight_line_is_scanned_at_its_ends() -> None:
    found = motes.plan_times(grey("linear", start=0.5, end=0.502), count=4)
    assert sorted(np.abs(found.hours - 6).round(1).tolist()) == [5.9, 5.9, 6.0, 6.0]
    assert found.to_even < 0.9


def test_the_errors_are_those_of_regression() -> None:
    """By the textbook: the covariance of a straight line through readings at the moments, each the mean of the rig's 260."""
    found = motes.plan_times(grey("linear", start=0.5, end=0.5001), count=5, noise=0.02, floor=1e-9)
    u = found.even / 12
    x = np.stack([1 - u, u], axis=1)
    sigma = 0.02 * 0.5 / np.sqrt(260)
    expected = sigma * np.sqrt(np.diag(np.linalg.inv(x.T @ x)))
    np.testing.assert_allclose(
        [found.even_stderr["K_d.start"], found.even_stderr["K_d.end"]], expected, rtol=0.15
    )  # of trends within 25 % the median


def test_the_error_of_the_curve_is_that_of_regression_at_each_moment(tmp_path: Path) -> None:
    found = motes.plan_times(grey("linear", start=0.5, end=0.5001), count=5, scanned=[3.0], noise=0.02, floor=1e-9)
    (course,) = found.courses
    sigma = 0.02 * 0.5 / np.sqrt(260)
    for scans, errors in ((found.hours, course.planned), (found.even, course.even)):
        u = np.append(scans, 3.0) / 12
        x = np.stack([1 - u, u], axis=1)
        at = np.stack([1 - course.hours / 12, course.hours / 12], axis=1)
        expected = sigma * np.sqrt(np.einsum("ti,ij,tj->t", at, np.linalg.inv(x.T @ x), at))
        np.testing.assert_allclose(errors[0], expected, rtol=1e-3)
    picture = found.picture(tmp_path / "when.svg").read_text(encoding="utf-8")
    words = [node.get("aria-label") or "" for node in ElementTree.fromstring(picture).iter() if node.get("aria-label")]
    assert any("K_d goes from 0.5 to 0.5" in said for said in words), words
    assert any(said.startswith("Standard error of K_d over time") for said in words), words


def test_what_scans_cannot_tell_has_no_error_in_the_picture(tmp_path: Path) -> None:
    found = motes.plan_times(grey("exponential", start=0.5, end=0.3, time_constant=3.0), count=2)
    assert np.isinf(found.courses[0].planned).any()
    assert "its standard error, where the scans tell" in found.picture(tmp_path / "when.svg").read_text(
        encoding="utf-8"
    )


def test_a_decay_is_scanned_where_its_determinant_is_largest() -> None:
    """Three moments for start, end and time constant, against a search over all of them with derivatives by differences."""

    def value(t: Any, c: Any) -> Any:
        return c[1] + (c[0] - c[1]) * np.exp(-t / c[2])

    t, c = np.linspace(0, 12, 61), np.array([0.5, 0.52, 3.0])
    slopes = np.stack([(value(t, c + d) - value(t, c - d)) / 2e-6 for d in 1e-6 * np.eye(3)], axis=1)
    dets = [(abs(np.linalg.det(slopes[[0, k, 60]])), t[k]) for k in range(1, 60)]
    best = max(dets)[1]
    found = motes.plan_times(grey("exponential", start=0.5, end=0.52, time_constant=3.0), count=3)
    assert found.hours[0] == 0
    assert found.hours[2] == 12
    assert found.hours[1] == pytest.approx(best, abs=0.5)


def test_what_was_scanned_counts() -> None:
    line = grey("linear", start=0.5, end=0.502)
    assert motes.plan_times(line, count=1, scanned=[0.0, 0.1, 0.2]).hours.tolist() == [12.0]
    assert motes.plan_times(line, count=1, scanned=[12.0, 11.9, 11.8]).hours.tolist() == [0.0]


def test_too_few_scans_are_said() -> None:
    found = motes.plan_times(grey("exponential", start=0.5, end=0.3, time_constant=3.0), count=2)
    assert "Not determined" in found.findings[0]


def test_channels_and_goals() -> None:
    paint = motes.ageing.age(motes.Material(motes.OrenNayar((0.8, 0.7, 0.6), 0.4) + motes.TorranceSparrow(0.3, 0.15)), "drying_paint", hours=6)  # fmt: skip
    every = motes.plan_times(paint, count=5)
    one = motes.plan_times(paint, count=5, goal="sigma_s")
    assert every.to_even < 1
    names = [name for name in every.stderr if name.startswith("sigma_s")]
    assert np.prod([one.stderr[n] for n in names]) < np.prod([one.even_stderr[n] for n in names])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"material": motes.Material(motes.Lambert(0.5))}, "does not change"),
        ({"count": 0}, "at least one"),
        ({"hours": (3.0, 1.0)}, "does not go forward"),
        ({"goal": "tau"}, "tau of"),
        ({"count": 500}, "more than the 121"),
    ],
)
def test_bad_input_is_answered_in_a_sentence(given: dict[str, Any], said: str) -> None:
    with pytest.raises(MotesError) as caught:
        motes.plan_times(**{"material": grey("linear", start=0.5, end=0.6), **given})
    assert said in str(caught.value)
    assert caught.value.hint


def test_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    material, table = tmp_path / "m.json", tmp_path / "when.csv"
    grey("linear", start=0.5, end=0.6).save(material)
    arguments = ["plan", "--when", str(material), "--count", "3", "-o", str(table)]
    assert main([*arguments, "--hours", "0,6", "--scanned", "1,2", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found["hours"]) == 3
    assert max(found["hours"]) <= 6
    assert table.read_text().startswith("scan,time_h")
    assert main(arguments) == 0
    assert "evenly spaced scans" in capsys.readouterr().out
    assert main([*arguments, "--hours", "6"]) == 2
    assert main(["plan", "--hours", "0,6", "-o", str(table)]) == 2
