"""Models at a few directions, or some thousand: nothing is compiled, and what is the same for every call is done once.

Running the formula of a model over NumPy costs a quarter of a millisecond however few directions there are: parts and parameters are walked through,
checked and brought into shape, and some 200 operations make an array each.  Here a model is recorded once for its structure, and what depends
on its parameters alone is computed once for each model, which is immutable.  A call then runs what is left of the formula, printed in two
ways: over NumPy's scalars for single directions, and over rows of memory that are used again and again (`motes.kernels.registers`) for more.
Both do the same operations in the same order, so what a direction gives does not depend on how many others there are.
"""

from __future__ import annotations

import math
import weakref
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import is_foreign
from motes.directions import HORIZON, LONGEST
from motes.graph import tracing
from motes.kernels.straight_line import Formula
from motes.parameters import Parametrised

__all__ = ["evaluate"]

Array = NDArray[Any]
#: Up to so many directions one at a time is quicker.
FEW = 6
#: Directions that are computed at once: their rows fit the level-2 cache.
BLOCK = 2048
#: Models of more channels are not printed channel by channel.
CHANNELS = 64
_SCALARS = (np.dtype(np.float32), np.dtype(np.float64))


def evaluate(model: Parametrised, wi: Any, wo: Any, below: float = math.inf) -> Array | None:
    """The BRDF of a model at some directions, as ``model.eval`` gives it; None for what this way does not serve.

    That is: tensors, parameters with a value for every direction, formulas that cannot be recorded, and everything that is to be refused.

    Parameters
    ----------
    model
        A BRDF.
    wi, wo
        Unit vectors (..., 3) that broadcast.
    below
        So many directions are not served either.

    Returns
    -------
    array (..., C), or None
    """
    if type(wi) is not np.ndarray or type(wo) is not np.ndarray:
        return None
    ready = _ready(model)
    if ready is None or wi.shape[-1:] != (3,) or wo.shape[-1:] != (3,):
        return None
    if wi.dtype not in _SCALARS or wo.dtype not in _SCALARS:
        return None
    if wi.shape != wo.shape:
        try:
            wi, wo = np.broadcast_arrays(wi, wo)
        except ValueError:
            return None
    scalar = wi.dtype if wi.dtype == wo.dtype else _SCALARS[1]
    shape = wi.shape[:-1]
    count = wi.size // 3
    if count >= below:
        return None
    out = np.empty((count, ready.channels), scalar)
    with np.errstate(all="ignore"):  # directions below the horizon are computed, then masked
        fits = ready.each(wi, wo, out) if count <= FEW else ready.blocks(wi, wo, out)
    return out.reshape(*shape, ready.channels) if fits else None


# ---------------------------------------------------------------- what is recorded once for a structure, and computed once for a model


def _recorded(model: Parametrised, channels: int) -> Formula | None:
    """The formula of a model, with a look at the horizon and without; None where symbols cannot follow it."""
    try:
        trace = tracing.trace(model, channels)
    except Exception:  # a formula of somebody's own may do anything
        return None
    above = [_above_horizon(symbol) for symbol in trace.outputs]
    return Formula(trace.directions, trace.parameters, (trace.outputs, above))


def _above_horizon(value: tracing.Symbol) -> tracing.Symbol:
    """What `Geometry.above_horizon` chooses where both directions are above; `value` itself where it did not choose."""
    for _ in range(2):
        is_choice = value.op == "where" and value.args[0].op == "gt" and value.args[0].args[1].is_constant(HORIZON)
        value = value.args[1] if is_choice else value
    return value


class _Ready:
    """A model with its structure and the values of what depends on parameters alone."""

    def __init__(self, model: Parametrised) -> None:
        self.channels = int(model.channels)  # type: ignore[attr-defined]
        slots = {slot.name: slot for slot in model.slots()}
        if self.channels > CHANNELS or any(is_foreign(slot.value) for slot in slots.values()):
            raise ValueError("not served")
        if any(np.ndim(slot.value) > slot.parameter.per_channel for slot in slots.values()):
            raise ValueError("a value for every direction")
        key = tracing.key(model, self.channels)
        if key not in _formulas:
            _formulas[key] = _recorded(model, self.channels)
        found = _formulas[key]
        if found is None:
            raise ValueError("a formula that cannot be recorded")
        self._formula = found
        values = (np.float64(np.ravel(slots[p.slot].value)[p.channel or 0]) for p in found.parameters)
        with np.errstate(all="ignore"):
            self._values = found.constants(*values)
        self._constants: dict[Any, list[Any]] = {}

    def constants(self, scalar: np.dtype[Any], rows: bool) -> list[Any]:
        """In a precision: numbers, or arrays without axes."""
        found = self._constants.get((scalar, rows))
        if found is None:
            found = [x if isinstance(x, np.bool_) else scalar.type(x) for x in self._values]
            found = [np.array(x) for x in found] if rows else found
            self._constants[scalar, rows] = found
        return found

    def each(self, wi: Array, wo: Array, out: Array) -> bool:
        """One direction at a time; False where a component is that of no unit vector."""
        kind = out.dtype
        function, constants = self._formula.of_scalars(kind), self.constants(kind, rows=False)
        for w, i, o in zip(out, wi.reshape(-1, 3), wo.reshape(-1, 3), strict=True):
            pair = [*i, *o] if i.dtype == o.dtype else [kind.type(x) for x in (*i, *o)]
            for x in pair:
                if x > LONGEST or x < -LONGEST:
                    return False
            w[:] = function(*pair, *constants)
        return True

    def blocks(self, wi: Array, wo: Array, out: Array) -> bool:
        """The same for many directions, some at a time."""
        kind, count = out.dtype, len(out)
        wi, wo = wi.reshape(-1, 3), wo.reshape(-1, 3)
        pairs = np.empty((6, min(count, BLOCK)), kind)
        constants = self.constants(kind, rows=True)
        rooms: dict[bool, tuple[Array, Array]] = {}
        for start in range(0, count, BLOCK):
            end = min(count, start + BLOCK)
            rows = pairs[:, : end - start]
            rows[:3], rows[3:] = wi[start:end].T, wo[start:end].T
            if not _fits(rows):
                return False
            above = bool(rows[2::3].min() > HORIZON)
            function, numbers, truths = self._formula.of_rows(kind, above)
            if above not in rooms:
                rooms[above] = np.empty((numbers, pairs.shape[1]), kind), np.empty((truths, pairs.shape[1]), np.bool_)
            room = (x[:, : end - start] for x in rooms[above])
            function(*room, [out[start:end, c] for c in range(out.shape[1])], *rows, *constants)
        return True


def _fits(rows: Array) -> bool:
    """Whether no component is beyond that of a unit vector; NaN may pass."""
    return bool(max(rows.max(), -rows.min()) <= LONGEST) or not (np.abs(rows) > LONGEST).any()


_formulas: dict[Any, Formula | None] = {}
# By identity: models are equal by value, which takes long to find out; and they are immutable.  An entry goes with its model.
_models: dict[int, tuple[weakref.ref[Parametrised], _Ready | None]] = {}


def _ready(model: Parametrised) -> _Ready | None:
    """What is known of a model, or None where this way does not serve it."""
    number = id(model)
    known = _models.get(number)
    if known is not None and known[0]() is model:
        return known[1]
    try:
        ready: _Ready | None = _Ready(model)
    except (TypeError, ValueError):  # also where a field is nothing that can be looked up by
        ready = None
    _models[number] = (weakref.ref(model, partial(_forget, number)), ready)
    return ready


def _forget(number: int, _: object) -> None:
    _models.pop(number, None)
