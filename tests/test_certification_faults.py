"""Planted faults are found and named; right ones raise no alarm."""

from __future__ import annotations

from typing import Any

import pytest

import planted_faults as planted
from motes.certification import Outcome, certify
from planted_faults import CONVENTIONS, PHYSICS, Planted


@pytest.mark.parametrize("case", [*PHYSICS, *CONVENTIONS], ids=str)
def test_a_planted_fault_is_found_and_named(case: Planted) -> None:
    found = certify(case.function, name=case.name, date="2026-01-01", **case.options)
    names = [finding.name for finding in found.check(case.check).findings]
    assert case.found in names, [(f.name, f.says, f.probably) for f in found.findings]
    assert found.outcome is (Outcome.DOUBT if case.found == "below-horizon" else Outcome.FAULT)


RIGHT: dict[str, tuple[Any, dict[str, Any]]] = {
    "lambert": (planted.lambert, {"as_model": "lambert(K_d=(0.6, 0.4, 0.2))", **planted.WHITE}),
    "ggx": (planted.ggx, {"as_model": planted.GGX, **planted.FACETS}),
    "dust": (planted.henyey_greenstein, {"as_model": planted.DUST, "parameters": {"g": 0.4}}),
    "weights": (
        planted.lambert,
        {
            "sample": planted.weighted(
                planted.cosine_sample, planted.cosine_pdf, planted.lambert, lambda f, c, p: f * c / p
            ),
            "pdf": planted.cosine_pdf,
        },
    ),
    "gradient": (planted.squared, {"gradient": planted.dusty_gradient(1.0), "parameters": {"alpha": 0.3}}),
    "f cos, and said so": (
        lambda wi, wo: planted.ggx(wi, wo) * wo[:, 2:],
        {"cosine": True, "as_model": planted.GGX},
    ),
}


@pytest.mark.parametrize("name", RIGHT)
def test_right_functions_raise_no_alarm(name: str) -> None:
    function, options = RIGHT[name]
    found = certify(function, name=name, **options)
    assert not found.findings, [(f.name, f.says, f.probably) for f in found.findings]
    assert found.ok
