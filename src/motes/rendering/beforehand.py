"""Formulas over Dr.Jit in which what depends on uniform parameters alone is computed once, by NumPy, and not at every hit.

A parameter that is the same all over a surface is *known*: its value is a number of this process, in float64.  What is computed of
known numbers is known, too; where it meets something that differs from hit to hit, it becomes a variable of Dr.Jit that kernels read
from memory, so that other values need no new kernel.  A layer of dust needs some four thousand operations for the numbers that depend on
tau, w and g alone (`motes.models.multiple_scattering`), and two hundred at a hit.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import numpy as np

from motes import arrays
from motes.arrays import NUMPY, Array

_FUNCTIONS = ("sqrt", "exp", "expm1", "log1p", "asin", "minimum", "maximum", "where", "sin", "cos", "log")


def _binary(function: Callable[[Any, Any], Any]) -> tuple[Callable[..., Number], Callable[..., Number]]:
    return (lambda self, other: self.numbers.apply(function, function, self, other)), (
        lambda self, other: self.numbers.apply(function, function, other, self)
    )


class Number:
    """A value in a formula: known, or one for every hit.

    Attributes
    ----------
    numbers
        The namespace that it belongs to.
    value
        A float or an array of channels (C,) where it is known, else of Dr.Jit.
    known
        Which of the two.
    """

    __slots__ = ("known", "numbers", "value")

    def __init__(self, numbers: Numbers, value: Array, known: bool) -> None:
        self.numbers, self.value, self.known = numbers, value, known

    __add__, __radd__ = _binary(operator.add)
    __sub__, __rsub__ = _binary(operator.sub)
    __mul__, __rmul__ = _binary(operator.mul)
    __truediv__, __rtruediv__ = _binary(operator.truediv)
    __lt__, __le__, __gt__, __ge__ = (_binary(f)[0] for f in (operator.lt, operator.le, operator.gt, operator.ge))

    def __neg__(self) -> Number:
        return self.numbers.apply(operator.neg, operator.neg, self)


class Numbers:
    """An array namespace (see `motes.arrays`) whose arrays are `Number`s.

    Parameters
    ----------
    mi
        Mitsuba, with a variant set that compiles.
    """

    name = "drjit"

    def __init__(self, mi: Any) -> None:
        self._mi, self._variables = mi, dict[tuple[bytes, bool], Any]()
        self._kept = dict[int, tuple[Any, Any]]()
        drjit = arrays.namespace(mi.Float(0.0))
        for name in _FUNCTIONS:
            setattr(self, name, self._function(getattr(NUMPY, name), getattr(drjit, name)))
        self.stack = drjit.stack

    def __getattr__(self, name: str) -> Any:
        # Only for what is not there: the functions are set above, by name.
        raise AttributeError(f"formulas over Dr.Jit have no {name}")

    def known(self, value: Array) -> Number:
        """A number that is the same at every hit: a float, or an array of channels (C,)."""
        # NumPy's numbers divide by 0 as Dr.Jit's do; Python's do not.
        return Number(self, np.asarray(value, np.float64)[()], True)

    def keep(self, owner: Any, make: Callable[[], Any]) -> Any:
        """What was made for `owner` before, or what is made now: as long as its numbers are the same, so is it."""
        if id(owner) not in self._kept:
            self._kept[id(owner)] = owner, make()  # with its owner, so that no other comes to have its id
        return self._kept[id(owner)][1]

    def differing(self, value: Array) -> Array:
        """A value of Dr.Jit as a number of this namespace; numbers as they are."""
        return value if isinstance(value, (Number, float, int)) else Number(self, value, False)

    def found(self, number: Array) -> Array:
        """A number as a value of Dr.Jit; what is none as it is."""
        if not isinstance(number, Number):
            return number
        return self._variable(number.value) if number.known else number.value

    def apply(self, known: Callable[..., Any], differing: Callable[..., Any], *args: Array) -> Number:
        """A function of numbers, by NumPy where all are known."""
        if all(a.known for a in args if isinstance(a, Number)):
            return Number(self, known(*(a.value if isinstance(a, Number) else a for a in args)), True)
        return Number(self, differing(*map(self.found, args)), False)

    def _function(self, known: Callable[..., Any], differing: Callable[..., Any]) -> Callable[..., Array]:
        def function(*args: Array) -> Array:
            if any(isinstance(a, Number) for a in args):
                return self.apply(known, differing, *args)
            return known(*args)

        return function

    def _variable(self, value: Array) -> Any:
        """A known value as a variable of Dr.Jit: the same for equal values, so that what is computed of it is found again."""
        import drjit as dr

        given = np.asarray(value)
        truth = given.dtype == np.bool_
        key = (given.astype(np.float64).tobytes(), truth)
        if key not in self._variables:
            each = [dr.opaque(self._mi.Float, float(v)) for v in given.ravel()]
            found = self._mi.UnpolarizedSpectrum(each) if given.ndim else each[0]
            self._variables[key] = found != 0 if truth else found
        return self._variables[key]
