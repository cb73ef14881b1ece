"""What of a formula depends on parameters alone, for a few sets of them: Python's own numbers, where NumPy would take longer to look at its arrays.

A layer of dust with all orders of scattering, and its derivatives, is 16,000 operations on parameters and 1,600 on parameters and directions.
An operation on an array of a few numbers takes NumPy half a microsecond, and Python a fifteenth of that for each number.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
#: So many numbers at most are worked on one by one.
FEW = 12
_ROUNDED = ("exp", "expm1", "log", "log1p", "sin", "cos", "arcsin")


def _of_number(name: str) -> Callable[[float], float]:
    function = getattr(np, name)
    return lambda x: float(function(x))  # NumPy's, so that the last digit does not depend on how many sets there are


#: The functions of generated code, over numbers.
NUMBERS: dict[str, Callable[..., Any]] = {name: _of_number(name) for name in _ROUNDED} | {
    "sqrt": math.sqrt,
    "minimum": lambda a, b: a if a < b or a != a else b,
    "maximum": lambda a, b: a if a > b or a != a else b,
    "where": lambda condition, a, b: a if condition else b,
}


@dataclass(frozen=True)
class Alone:
    """Two functions of the same text, over arrays and over numbers: those of the shared parameters, or of all.

    Both take what was found before, as a tuple, and values of parameters; they return a tuple.

    Attributes
    ----------
    takes
        The slots of the parameters.
    mixed
        Whether each of the results has the shape of all of them together.
    """

    takes: tuple[str, ...]
    over_arrays: Callable[..., tuple[Any, ...]]
    over_numbers: Callable[..., tuple[float, ...]]
    mixed: bool = False


@dataclass(frozen=True)
class Results:
    """What was found: as arrays of one shape, and as the rows that these were made of where it was found one by one."""

    arrays: tuple[Any, ...] = ()
    shape: tuple[int, ...] = ()
    rows: Sequence[tuple[float, ...]] | None = ((),)


def found(alone: Alone, parameters: Sequence[Any], before: Results) -> Results:
    """The results of a function for parameters that broadcast against each other.

    Not one by one where some results would have a smaller shape over arrays: what is computed of them would take longer.
    """
    shapes = {np.shape(value) for value in parameters} - {()}
    shape = np.broadcast_shapes(*shapes, before.shape)
    alike = alone.mixed or len(shapes) <= 1
    if before.rows is not None and alike and 0 < math.prod(shape) <= FEW:
        columns = [np.broadcast_to(value, shape).ravel().tolist() for value in parameters]
        which = np.broadcast_to(np.arange(len(before.rows)).reshape(before.shape), shape).ravel().tolist()
        try:
            rows = [
                alone.over_numbers(before.rows[k], *row)
                for k, row in zip(which, zip(*columns, strict=True), strict=True)
            ]
        except (ZeroDivisionError, ValueError):
            pass  # NumPy goes on with an infinity or a NaN, which `where` may leave out
        else:
            table = np.array(rows).T
            return Results(tuple(table.reshape(len(table), *shape)), shape, rows)
    return Results(alone.over_arrays(before.arrays, *parameters), shape, None)
