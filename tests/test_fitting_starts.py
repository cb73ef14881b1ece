"""The search for starts: what creeps far above the others is given up, and nothing else is."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import motes
from motes.fitting import starts
from motes.fitting.problem import Problem
from motes.fitting.setup import Wishes, prepare
from motes.fitting.solver import Normal
from motes.measurements import Measurement

MODEL = "oren_nayar + torrance_sparrow"


def problem(noise: float, misfit: float = 0.0) -> Problem:
    """A rough surface with a highlight, 300 directions; and what the model does not know of."""
    rng = np.random.default_rng(1)
    z, phi = rng.uniform(0.2, 1, (2, 300)), rng.uniform(-np.pi, np.pi, (2, 300))
    wi, wo = np.stack([np.sqrt(1 - z**2) * np.cos(phi), np.sqrt(1 - z**2) * np.sin(phi), z], axis=-1)
    truth = motes.OrenNayar(K_d=0.2, sigma_d=0.4) + motes.TorranceSparrow(0.3, 0.2)
    f = truth.eval(wi, wo) * (1 + noise * rng.standard_normal((300, 1)) + misfit * np.sin(9 * phi[0])[:, None])
    wishes = Wishes("linear", "none", "measurement", (), ())
    return prepare(Measurement.from_arrays(wi, wo, f), MODEL, wishes).problem


def passes(monkeypatch: pytest.MonkeyPatch, given: Problem) -> tuple[int, np.ndarray]:
    """How many parameter vectors are looked at in the search, and the starts that it finds."""
    count = 0
    normal = Problem.normal

    def counted(self: Problem, x: Any, sets: Any = None) -> Normal:
        nonlocal count
        count += 1
        return normal(self, x, sets)

    with monkeypatch.context() as patch:
        patch.setattr(Problem, "normal", counted)
        found = starts.starting_points(given, None, 16)
    return count, found


def test_a_search_that_creeps_far_above_the_others_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    given = problem(noise=0.02)
    few, found = passes(monkeypatch, given)
    monkeypatch.setattr(starts, "HOPELESS", np.inf)
    many, all_ = passes(monkeypatch, given)
    assert few <= 0.75 * many
    np.testing.assert_allclose(found[0], all_[0], rtol=1e-3)
    np.testing.assert_allclose(given.normal(found[:1]).objective, given.normal(all_).objective.min(), rtol=1e-6)


def test_where_nothing_fits_well_every_search_is_finished(monkeypatch: pytest.MonkeyPatch) -> None:
    given = problem(noise=0.02, misfit=0.9)
    _, found = passes(monkeypatch, given)
    monkeypatch.setattr(starts, "HOPELESS", np.inf)
    _, all_ = passes(monkeypatch, given)
    assert len(found) == len(all_)
    np.testing.assert_allclose(found, all_, rtol=0.02, atol=1e-3)
    monkeypatch.setattr(starts, "PATIENCE", 60)
    _, at_once = passes(monkeypatch, given)
    np.testing.assert_allclose(found[0], at_once[0], rtol=0.02, atol=1e-3)


def test_searches_that_come_together_are_followed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    given = problem(noise=0.02)
    lanes = 0
    normal = Problem.normal

    def counted(self: Problem, x: Any, sets: Any = None) -> Normal:
        nonlocal lanes
        lanes += len(x)
        return normal(self, x, sets)

    monkeypatch.setattr(Problem, "normal", counted)
    found = starts.starting_points(given, None, 16)
    together, lanes = lanes, 0
    monkeypatch.setattr(starts, "SETTLED", 1000)
    apart = starts.starting_points(given, None, 16)
    assert together < 0.9 * lanes
    np.testing.assert_allclose(found[0], apart[0], rtol=1e-2)
