"""What of a kernel depends on uniform parameters alone: computed beforehand, and gone back through by gradients.

Both are functions of numbers (`motes.kernels.numpy.function_of_numbers`).  What the way back needs of the way there is kept with it, and all of it is kept
for the values of the last call: a material is evaluated more than once.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.graph import tracing
from motes.graph.tracing import Symbol, Trace, TracedParameter
from motes.kernels.numpy import function_of_numbers

_BEFORE, _TOTAL = 1, 2  # bits of what is known before the directions are looked at, and of what is added up over them
Value = Callable[[TracedParameter], float]


class Uniform:
    """The functions that connect a kernel's constants with parameters.

    Parameters
    ----------
    trace
        What the kernel was printed from.
    parameters
        Those that are uniform.
    constants, totals
        What the driver reads, in `scalar`, and those of them by which it adds up derivatives.
    """

    def __init__(
        self,
        trace: Trace,
        parameters: Sequence[TracedParameter],
        constants: Sequence[Symbol],
        totals: Sequence[Symbol],
        scalar: np.dtype[Any],
    ) -> None:
        self.parameters, self._count, self._scalar = tuple(parameters), len(constants), scalar
        leaves = {p.symbol: f"p{k}" for k, p in enumerate(parameters)}
        seeds = {symbol: trace.graph.leaf(f"total[{k}]") for k, symbol in enumerate(totals)}
        slopes = tracing.adjoint(seeds, list(leaves))
        zero = trace.graph.constant(0.0)
        wanted = [slopes.get(symbol, zero) for symbol in leaves]
        bits = tracing.dependence(wanted, dict.fromkeys(leaves, _BEFORE) | dict.fromkeys(seeds.values(), _TOTAL))
        between = tracing.frontier(wanted, bits, _BEFORE)
        self._there = function_of_numbers("constants", leaves, [*constants, *between])
        names = {symbol: f"b{k}" for k, symbol in enumerate(between)}
        names |= {seed: f"d{k}" for k, seed in enumerate(seeds.values())}
        self._back = function_of_numbers("pullback", names, wanted)
        self._last: tuple[bytes, NDArray[Any], tuple[float, ...]] | None = None

    def constants(self, value: Value) -> NDArray[Any]:
        """What the driver wants beforehand, from the values of parameters; not to be written to."""
        return self._found(value)[0]

    def pullback(self, value: Value, totals: NDArray[np.float64]) -> dict[TracedParameter, float]:
        """Derivatives by the uniform parameters from derivatives by the constants."""
        slopes = self._back(*self._found(value)[1], *totals.tolist())
        return dict(zip(self.parameters, map(float, slopes), strict=True))

    def _found(self, value: Value) -> tuple[NDArray[Any], tuple[float, ...]]:
        values = [value(p) for p in self.parameters]
        key, last = np.array(values, np.float64).tobytes(), self._last
        if last is None or last[0] != key:
            found = self._there(*values)
            with np.errstate(all="ignore"):
                constants = np.array(found[: self._count], self._scalar)
            constants.flags.writeable = False
            last = self._last = key, constants, found[self._count :]
        return last[1:]
