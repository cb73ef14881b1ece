"""How fits are laid out in a store: a map for each parameter, with trends for each coefficient, and what every fit has besides."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from motes.fitting.texels import TexelSolver, TexelStatus
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


class Variable(NamedTuple):
    """A map in the store: a quantity, with trends a coefficient of its trend, and the solver's columns that it holds."""

    name: str
    quantity: str
    coefficient: str | None
    columns: tuple[int, ...]
    per_channel: bool
    unit: str
    doc: str


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
        trends=plan.settings.trends,
        fixed=plan.fitting.fixed,
        per_channel=plan.fitting.per_channel,
    )
    return {v.name: v for v in variables_of(solver.columns, hours is not None)}


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
