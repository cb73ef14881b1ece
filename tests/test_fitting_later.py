"""What is found out when somebody reads it: findings of a fit, and the digest of its data."""

from __future__ import annotations

import copy
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import motes
from motes.directions import from_spherical
from motes.fitting import origin_of_fit, static
from motes.fitting.later import Later
from motes.measurements import Measurement
from motes.measurements.doubts import implausible


def measured(scale: float) -> Measurement:
    rng = np.random.default_rng(5)
    wi, wo = (from_spherical(rng.uniform(0, 1.2, 60), rng.uniform(-3, 3, 60)) for _ in range(2))
    f = motes.OrenNayar(0.6, 0.3).eval(wi, wo) * scale
    return Measurement.from_arrays(wi, wo, f * (1 + 0.02 * rng.standard_normal(f.shape)))


def test_sentences_are_found_once_and_are_a_tuple_in_all_but_name() -> None:
    calls = []

    def find() -> tuple[str, ...]:
        calls.append(1)
        return "a", "b"

    said = Later(find)
    assert not calls
    same: Later = said
    assert said == same
    assert ("a", "b") == said == ("a", "b")
    assert said != ("a",)
    assert said == Later(lambda: ("a", "b"))
    assert (*said, "c") == said.__add__(("c",)) == ("a", "b", "c")
    assert (said[0], said[1:], len(said)) == ("a", ("b",), 2)
    assert hash(said) == hash(("a", "b"))
    assert repr(said) == "('a', 'b')"
    assert type(pickle.loads(pickle.dumps(said))) is tuple
    assert copy.copy(said) == said
    assert len(calls) == 1


def test_findings_and_digests_wait_until_they_are_read(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    asked: list[str] = []

    def told(name: str, function: object) -> object:
        return lambda *given: (asked.append(name), function(*given))[1]  # type: ignore[operator]

    monkeypatch.setattr(static, "implausible", told("data", static.implausible))
    monkeypatch.setattr(static, "implausible_fit", told("fit", static.implausible_fit))
    monkeypatch.setattr(origin_of_fit, "digest", told("digest", origin_of_fit.digest))
    data = measured(4.0)
    fits = [motes.fit(data, "oren_nayar"), motes.fit(data)]
    assert not asked
    for fit in fits:
        again = replace(fit, seconds=1.0)
        assert not asked
        written = pickle.loads(pickle.dumps(again))
        assert sorted(asked) == ["data", "digest", "fit"]
        assert written.findings == fit.findings
        assert fit.findings[: len(implausible(data))] == implausible(data)
        assert any("More light out than in: the fitted" in text for text in fit.findings)
        assert written.origin.sha256_of_arrays == origin_of_fit.digest(data)
        assert written.to_dict()["findings"] == list(fit.findings)
        asked.clear()
        origin_of_fit._digests.clear()
