"""What a fit of texels needs of its directions: numbers for symbols that depend on them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np

from motes.fitting.losses import Floats
from motes.fitting.texel_setup import TexelSetup
from motes.graph import tracing
from motes.graph.tracing import Symbol
from motes.kernels import numpy as numpy_code
from motes.models import BRDF


class Sampled:
    """The values of symbols at the directions of a fit.

    Parameters
    ----------
    trace, model
        Of the model, with values for what is held.
    fitted
        The slots whose parameters are not held.
    """

    def __init__(self, trace: tracing.Trace, model: BRDF, fitted: Collection[str], fit: TexelSetup) -> None:
        held = [p for p in trace.parameters if p.slot not in fitted]
        self.leaves = {leaf: f"d{k}" for k, leaf in enumerate(trace.directions)}
        self.leaves |= {trace.graph.leaf(name): name for name in ("root", "cosine")}
        self.leaves |= {p.symbol: f"p{k}" for k, p in enumerate(held)}
        slots = {slot.name: slot for slot in model.slots()}
        numbers = [float(np.ravel(slots[p.slot].value)[p.channel or 0]) for p in held]
        self.root = np.sqrt(fit.weights) / fit.size_of_residuals
        self.directions = [*fit.wi.T, *fit.wo.T, self.root, fit.wi[:, 2]]
        self.numbers = numbers
        self.count = len(fit.wi)

    def columns(self, symbols: Sequence[Symbol], more: int = 0) -> Floats:
        """Of symbols that hold no parameter of the fit: (len(symbols), D + more), the last without weight."""
        longer = [np.append(x, np.full(more, 0.0 if x is self.root else x[-1])) for x in self.directions]
        found = self._values(symbols, self.leaves, [*longer, *self.numbers])
        return np.stack([np.broadcast_to(row, self.count + more) for row in found])

    def __call__(self, symbols: Sequence[Symbol], parameter: Symbol, values: Floats) -> Floats:
        """Of symbols that hold one parameter, at values (K,) of it: (len(symbols), K, D)."""
        found = self._values(
            symbols, self.leaves | {parameter: "p"}, [*self.directions, *self.numbers, values[:, None]]
        )
        return np.stack([np.broadcast_to(row, (len(values), self.count)) for row in found])

    @staticmethod
    def _values(
        symbols: Sequence[Symbol], leaves: dict[Symbol, str], given: Sequence[Floats | float]
    ) -> tuple[Any, ...]:
        function = numpy_code.scalar_function("columns", leaves, symbols)
        with np.errstate(all="ignore"):
            found: tuple[Any, ...] = function(*given)
        return found
