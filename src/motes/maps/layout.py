"""How fits are laid out in a store: a map for each parameter, with trends for each coefficient, and what every fit has besides."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.covariance import VERDICTS
from motes.fitting.texels import NO_VERDICT, TexelSolver, TexelStatus
from motes.fitting.verdicts import Verdict
from motes.maps.plan import Plan

NOT_FITTED = 255
FLAGS = {**{status.name.lower(): int(status) for status in TexelStatus}, "not_fitted": NOT_FITTED}
# What every fit has beside its parameters: kind of number, fill, attributes.
EXTRAS: dict[str, tuple[str, Any, dict[str, Any]]] = {
    "relative_rms": ("f4", np.nan, {"units": "1", "long_name": "residual over data, root mean squares, weighted"}),
    "status": (
        "u1",
        NOT_FITTED,
        {
            "long_name": "how the fit ended",
            "flag_values": list(FLAGS.values()),
            "flag_meanings": " ".join(FLAGS),
        },
    ),
    "iterations": ("u1", 0, {"long_name": "iterations of the fit"}),
}

#: Verdicts as they are stored: names and codes.
VERDICT_FLAGS = {
    **{verdict.name.lower(): code for code, verdict in enumerate(VERDICTS) if verdict is not Verdict.FIXED},
    "not_fitted": NO_VERDICT,
}
#: From what is well to what is worst, for what stands for several.
WORST = ("not_fitted", "identified", "weak", "at_lower", "at_upper", "unidentifiable")


class Variable(NamedTuple):
    """A map in the store: a quantity, with trends a coefficient of its trend, and the solver's columns that it holds."""

    name: str
    quantity: str
    coefficient: str | None
    columns: tuple[int, ...]
    per_channel: bool
    unit: str
    doc: str


def verdict_attributes(variable: Variable) -> dict[str, Any]:
    """What is said of a map of verdicts."""
    return {
        "long_name": f"what the data say about {variable.name}",
        "flag_values": list(VERDICT_FLAGS.values()),
        "flag_meanings": " ".join(VERDICT_FLAGS),
    }


def covariance_attributes(names: Sequence[str]) -> dict[str, Any]:
    """What is said of the covariances of the fits."""
    return {
        "long_name": "covariance of the parameters; NaN for what has no standard error",
        "labels": list(names),
        "packing": "lower triangle, row by row: (0, 0), (1, 0), (1, 1), (2, 0), ...; rows and columns as labels",
    }


def worst(codes: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """The worst of verdicts along the last axis."""
    rank = np.zeros(256, np.uint8)
    rank[[VERDICT_FLAGS[name] for name in WORST]] = np.arange(len(WORST))
    back = np.array([VERDICT_FLAGS[name] for name in WORST], np.uint8)
    found: NDArray[np.uint8] = back[rank[codes].max(axis=-1)]
    return found


def labels(variables: Iterable[Variable], channels: Sequence[str]) -> tuple[str, ...]:
    """Names of the solver's columns: ``K_d[R]``, ``sigma_d``, with trends ``K_s_start``."""
    named: dict[int, str] = {}
    for v in variables:
        for k, column in enumerate(v.columns):
            named[column] = f"{v.name}[{channels[k]}]" if v.per_channel else v.name
    return tuple(named[k] for k in sorted(named))


def stored_variables(plan: Plan, channels: int) -> dict[str, Variable]:
    """The variables of a plan, without its data."""
    up = np.array([[0.0, 0.0, 1.0]])
    hours = None if plan.settings.trends is None else np.array([0.0, 1.0])
    solver = TexelSolver(
        plan.model,
        up,
        up,
        channels,
        hours=hours,
        trends=plan.fitting.trends,
        fixed=plan.fitting.fixed,
        per_channel=plan.fitting.per_channel,
    )
    return {v.name: v for v in variables_of(solver.columns, hours is not None)}


def stored(
    name: str, variables: Mapping[str, Variable], grid: tuple[int, ...], channels: int
) -> tuple[np.dtype[Any], tuple[int, ...]] | None:
    """What a store has under a name, kind of numbers and shape; None for a name that it has not.

    `grid` is (y, x), of fits of every time alone (y, x, T).
    """
    if name in EXTRAS:
        return np.dtype(EXTRAS[name][0]), grid
    if name == "covariance":
        size = sum(len(v.columns) for v in variables.values())
        return np.dtype("f4"), (*grid, size * (size + 1) // 2)
    of = variables.get(name.removesuffix("_stderr").removesuffix("_verdict"))
    if of is None:
        return None
    return np.dtype("u1" if name.endswith("_verdict") else "f4"), (*grid, *((channels,) if of.per_channel else ()))


def variables_of(columns: Sequence[Any], joint: bool) -> list[Variable]:
    """The maps that hold a solver's columns: one a quantity, with trends one a coefficient."""
    found: dict[tuple[str, str | None], list[int]] = {}
    for k, column in enumerate(columns):
        found.setdefault((column.quantity, column.coefficient), []).append(k)
    variables = []
    for (quantity, coefficient), own in found.items():
        parameter, channel = columns[own[0]].parameter, columns[own[0]].channel
        name = quantity if coefficient is None else f"{quantity}_{coefficient}"
        doc = parameter.doc if coefficient is None else f"{parameter.doc}: {coefficient} of its trend"
        times = coefficient in ("time_constant", "middle", "width")
        unit = "h" if times else "1" if coefficient and coefficient.startswith("share") else parameter.unit
        variables.append(Variable(name, quantity, coefficient, tuple(own), channel is not None, unit, doc))
    return variables
