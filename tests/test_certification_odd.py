"""Functions that nobody means, and that people write: each gets a finding or a sentence, a page and a file, and no defect."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import planted_faults as planted
from motes.certification import certify
from motes.errors import MotesError

Function = Callable[..., Any]
WHITE = planted.WHITE


def constant(value: Any) -> Function:
    return lambda wi, wo: np.full(len(wi), value)


FOUND: dict[str, tuple[Function, dict[str, Any], list[str]]] = {
    "NaN": (constant(np.nan), {}, ["nan"]),
    "infinite": (constant(np.inf), {}, ["infinite", "below-horizon"]),
    "huge": (constant(1e300), {}, ["below-horizon", "energy"]),
    "negative": (constant(-1.0), {}, ["sign", "below-horizon"]),
    "black": (constant(0.0), {}, ["black"]),
    "whole numbers": (constant(1), {}, ["below-horizon", "factor-pi"]),
    "noise": (
        lambda wi, wo: np.random.default_rng(int(1e6 * abs((wi @ [1, 2, 3]).sum()))).random(len(wi)),
        {},
        ["below-horizon", "factor-pi", "not-reciprocal"],
    ),
    "density NaN": (planted.lambert, WHITE | {"pdf": constant(np.nan)}, ["density-not-finite"]),
    "density infinite": (planted.lambert, WHITE | {"pdf": constant(np.inf)}, ["density-not-finite"]),
    "density 0": (planted.lambert, WHITE | {"pdf": constant(0.0)}, ["samples-without-density"]),
    "density negative": (
        planted.lambert,
        WHITE | {"pdf": lambda wi, wo: -planted.cosine_pdf(wi, wo)},
        ["density-negative"],
    ),
    "samples NaN": (
        planted.lambert,
        WHITE | {"sample": lambda wi, u: np.full((len(u), 3), np.nan)},
        ["samples-not-unit"],
    ),
    "samples too long": (
        planted.lambert,
        WHITE | {"sample": lambda wi, u: 5 * planted.cosine_sample(wi, u)},
        ["samples-not-unit"],
    ),
    "samples below": (
        planted.lambert,
        WHITE | {"sample": lambda wi, u: -planted.cosine_sample(wi, u)},
        ["samples-below-horizon"],
    ),
    "samples all one": (
        planted.lambert,
        WHITE | {"sample": lambda wi, u: np.tile([0.0, 0.6, 0.8], (len(u), 1))},
        ["shape-of-pdf"],
    ),
    "derivative NaN": (
        planted.squared,
        {"gradient": lambda wi, wo, alpha: {"alpha": np.full(len(wi), np.nan)}, "parameters": {"alpha": 0.3}},
        ["gradient-not-finite"],
    ),
    "a parameter of three numbers": (
        lambda wi, wo, K: planted.above(wi, wo, np.broadcast_to(np.asarray(K) / np.pi, (len(wi), 3))),
        {
            "gradient": lambda wi, wo, K: {"K": planted.above(wi, wo, np.full((len(wi), 3), 1 / np.pi))},
            "parameters": {"K": [0.3, 0.2, 0.1]},
        },
        [],
    ),
    "NaN against a model": (constant(np.nan), {"as_model": "ggx(K_s=1, alpha=0.1)"}, ["nan"]),
    "black against a model": (constant(0.0), {"as_model": "lambert(K_d=0.5)"}, ["black", "differs"]),
    "against a black model": (planted.lambert, {"as_model": "lambert(K_d=0)"}, ["differs"]),
    "against other channels": (
        lambda wi, wo: planted.above(wi, wo, np.full((len(wi), 7), 0.1)),
        {"as_model": "lambert(K_d=(0.5, 0.4, 0.3))"},
        [],
    ),
}


@pytest.mark.parametrize("name", FOUND)
def test_it_is_found(name: str, tmp_path: Path) -> None:
    function, options, expected = FOUND[name]
    found = certify(function, name=name, **options)
    assert [f.name for f in found.findings] == expected
    assert found.report(tmp_path / "page.html").stat().st_size > 1000
    assert json.loads(found.save(tmp_path / "page.json").read_text())["outcome"] == str(found.outcome)


SAID: dict[str, tuple[Function, dict[str, Any], str]] = {
    "no channels": (lambda wi, wo: np.zeros((len(wi), 0)), {}, r"of shape \(\d+, 0\)"),
    "complex": (constant(1j), {}, "answers complex numbers"),
    "raises": (lambda wi, wo: wi[100], {}, "IndexError"),
    "samples of two numbers": (planted.lambert, WHITE | {"sample": lambda wi, u: u}, "directions of shape"),
    "density of seven": (planted.lambert, WHITE | {"pdf": lambda wi, wo: np.zeros(7)}, "answers 7 numbers"),
    "derivative of another": (
        planted.squared,
        {"gradient": lambda wi, wo, alpha: {"beta": np.ones(len(wi))}, "parameters": {"alpha": 0.3}},
        "no dictionary of its parameters",
    ),
    "NaN to fit": (constant(np.nan), {"as_model": "ggx"}, "no values above 0"),
}


@pytest.mark.parametrize("name", SAID)
def test_it_is_said(name: str) -> None:
    function, options, says = SAID[name]
    with pytest.raises(MotesError, match=says) as error:
        certify(function, name=name, **options)
    assert error.value.hint
