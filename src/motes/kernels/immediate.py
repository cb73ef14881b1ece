"""Models at a few directions, or some thousand: nothing is compiled, and what is the same for every call is done once.

Running the formula of a model over NumPy costs a quarter of a millisecond however few directions there are: parts and parameters are walked through,
checked and brought into shape, and some 200 operations make an array each.  Here a model is recorded once for its structure, and what depends
on its parameters alone is computed once for each model, which is immutable.  A call then runs what is left of the formula, printed in two
ways: over NumPy's scalars for single directions, and over rows of memory that are used again and again (`motes.kernels.registers`) for more.
Both do the same operations in the same order, so what a direction gives does not depend on how many others there are.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.arrays import is_foreign
from motes.directions import HORIZON, LONGEST
from motes.graph import tracing
from motes.graph.recording import Kind, recorded
from motes.kernels.remembered import Remembered
from motes.kernels.straight_line import Formula
from motes.parameters import Parametrised

__all__ = ["call"]

Array = NDArray[Any]
#: Up to so many directions one at a time is quicker.
FEW = 6
#: Directions that are computed at once: their rows fit the level-2 cache.
BLOCK = 2048
#: Models of more channels are not printed channel by channel.
CHANNELS = 64
# What arrays' own methods call, some calls later.
_least, _most = np.minimum.reduce, np.maximum.reduce
_SCALARS = (np.dtype(np.float32), np.dtype(np.float64))


def call(kind: Kind, model: Parametrised, a: Any, b: Any, below: float = math.inf) -> list[Array] | None:
    """What ``model.eval``, ``model.pdf`` and ``model.sample`` give at some directions; None for what this way does not serve.

    That is: tensors, parameters with a value for every direction, formulas that cannot be recorded, and everything that is to be refused.

    Parameters
    ----------
    kind
        What of the model.
    model
        A BRDF.
    a, b
        Unit vectors ``wi, wo`` (..., 3) that broadcast; for samples ``wi`` and random numbers (..., 2).
    below
        So many directions are not served either.

    Returns
    -------
    list of arrays, or None
        The value (..., C); or the density (...); or, of samples, ``wo`` (..., 3), the density (...) and the weight (..., C).
    """
    if type(a) is not np.ndarray or type(b) is not np.ndarray:
        return None
    ready = _ready(kind, model)
    if ready is None or a.shape[-1:] != (3,) or b.shape[-1:] != (ready.second,):
        return None
    if a.dtype not in _SCALARS or b.dtype not in _SCALARS:
        return None
    shape = a.shape[:-1]
    if shape != b.shape[:-1]:
        try:
            shape = np.broadcast_shapes(shape, b.shape[:-1])
        except ValueError:
            return None
        a, b = np.broadcast_to(a, (*shape, 3)), np.broadcast_to(b, (*shape, ready.second))
    count = math.prod(shape)
    if count >= below:
        return None
    scalar = a.dtype if a.dtype == b.dtype else _SCALARS[1]
    with np.errstate(all="ignore"):  # directions below the horizon are computed, then masked
        work = ready.each if count <= FEW else ready.blocks
        found = work(a.reshape(-1, 3), b.reshape(-1, ready.second), scalar)
    return found and [x.reshape(shape + x.shape[1:]) for x in found]


def _above_horizon(value: tracing.Symbol) -> tracing.Symbol:
    """What `Geometry.above_horizon` chooses where both directions are above; `value` itself where it did not choose."""
    for _ in range(2):
        is_choice = value.op == "where" and value.args[0].op == "gt" and value.args[0].args[1].is_constant(HORIZON)
        value = value.args[1] if is_choice else value
    return value


class _Ready:
    """A model with its recorded formula and the values of what depends on parameters alone."""

    def __init__(self, kind: Kind, model: Parametrised) -> None:
        channels = int(model.channels)  # type: ignore[attr-defined]
        slots = {slot.name: slot for slot in model.slots()}
        if channels > CHANNELS or any(is_foreign(slot.value) for slot in slots.values()):
            raise ValueError("not served")
        if any(np.ndim(slot.value) > slot.parameter.per_channel for slot in slots.values()):
            raise ValueError("a value for every direction")
        key = (kind, tracing.key(model, channels))
        if key not in _formulas:
            trace = recorded(kind, model, channels)
            if trace is None:
                raise ValueError("a formula that cannot be recorded")
            above = [_above_horizon(symbol) for symbol in trace.outputs]
            _formulas[key] = Formula(trace.directions, trace.parameters, (trace.outputs, above))
        self._formula = _formulas[key]
        self._sampling = kind is Kind.SAMPLE
        self.second = 2 if self._sampling else 3
        self._widths = {Kind.VALUE: (channels,), Kind.DENSITY: (0,), Kind.SAMPLE: (3, 0, channels)}[kind]
        with np.errstate(all="ignore"):
            self._values = self._formula.constants(
                *(np.float64(p.of(np.ravel(slots[p.slot].value))) for p in self._formula.parameters)
            )
        self._constants: dict[Any, list[Any]] = {}

    def constants(self, scalar: np.dtype[Any], rows: bool) -> list[Any]:
        """In a precision: numbers, or arrays without axes."""
        found = self._constants.get((scalar, rows))
        if found is None:
            found = [x if isinstance(x, np.bool_) else scalar.type(x) for x in self._values]
            found = [np.array(x) for x in found] if rows else found
            self._constants[scalar, rows] = found
        return found

    def each(self, a: Array, b: Array, scalar: np.dtype[Any]) -> list[Array] | None:
        """One direction at a time; None where a component is that of no unit vector."""
        function, constants = self._formula.of_scalars(scalar), self.constants(scalar, rows=False)
        found = np.empty((len(a), sum(max(1, n) for n in self._widths)), scalar)
        for results, first, second in zip(found, a, b, strict=True):
            pair = [*first, *second]
            if a.dtype != b.dtype:
                pair = [scalar.type(x) for x in pair]
            for x in pair:
                if x > LONGEST or x < -LONGEST:  # random numbers, which are below 1, may be looked at too
                    return None
            results[:] = function(*pair, *constants)
        if len(self._widths) == 1:
            return [found if self._widths[0] else found[:, 0]]
        return [found[:, :3], found[:, 3], found[:, 4:]]

    def blocks(self, a: Array, b: Array, scalar: np.dtype[Any]) -> list[Array] | None:
        """The same for many directions, some at a time."""
        count = len(a)
        size = min(count, BLOCK)
        inputs = np.empty((3 + self.second, size), scalar)
        found = [np.empty((count, n) if n else count, scalar) for n in self._widths]
        columns = [column for x in found for column in (x.T if x.ndim > 1 else [x])]
        constants = self.constants(scalar, rows=True)
        rooms: dict[bool, tuple[Array, Array]] = {}
        for start in range(0, count, BLOCK):
            end = min(count, start + BLOCK)
            rows = inputs[:, : end - start]
            rows[:3], rows[3:] = a[start:end].T, b[start:end].T
            if not _fits(rows):
                return None
            above = not self._sampling and bool(_least(rows[2]) > HORIZON and _least(rows[5]) > HORIZON)
            function, numbers, truths = self._formula.of_rows(scalar, above)
            if above not in rooms:
                rooms[above] = np.empty((numbers, size), scalar), np.empty((truths, size), np.bool_)
            whole = end - start == size
            room = rooms[above] if whole else [x[:, : end - start] for x in rooms[above]]
            function(*room, columns if count == size else [x[start:end] for x in columns], *rows, *constants)
        return found


def _fits(rows: Array) -> bool:
    """Whether no component is beyond that of a unit vector; NaN may pass."""
    flat = rows.ravel()
    return bool(max(_most(flat), -_least(flat)) <= LONGEST) or not (np.abs(rows) > LONGEST).any()


_formulas: dict[Any, Formula] = {}
_models: Remembered[dict[Kind, _Ready | None]] = Remembered(lambda model: {})


def _ready(kind: Kind, model: Parametrised) -> _Ready | None:
    """What is known of a model, or None where this way does not serve it."""
    known = _models.of(model)
    if kind not in known:
        try:
            known[kind] = _Ready(kind, model)
        except (TypeError, ValueError):  # also where a field is nothing that can be looked up by
            known[kind] = None
    return known[kind]
