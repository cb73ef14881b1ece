"""Where what acts on one channel stands in a parameter vector: its own parameters first, then those that all channels share."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from motes.fitting.losses import Floats
from motes.fitting.quantities import Quantity


class ChannelLayout:
    """The K parameters that act on each of C channels, out of P.

    Attributes
    ----------
    order
        Their names: those that each channel has for itself, then shared ones.
    index
        Their positions (C, K) in the parameter vector.
    """

    def __init__(self, quantities: Sequence[Quantity], channels: int) -> None:
        own = [q for q in quantities if q.per_channel]
        shared = [q for q in quantities if not q.per_channel]
        self.order = [q.name for q in (*own, *shared)]
        positions = [np.arange(q.where.start, q.where.stop) for q in own]
        self.index = np.stack([*positions, *(np.full(channels, q.where.start) for q in shared)], axis=1)
        self._size = quantities[-1].where.stop
        # Of one channel nothing is to be sorted.
        self._alone = len(self.index) == 1 and np.array_equal(self.index[0], np.arange(self._size))
        self._squares = [(index[:, None], index[None, :]) for index in self.index]

    def vector(self, parts: Floats) -> Floats:
        """Sum (B, C, K) into (B, P)."""
        if self._alone:
            return parts[:, 0]
        total = np.zeros((len(parts), self._size))
        for c, index in enumerate(self.index):
            total[:, index] += parts[:, c]
        return total

    def matrix(self, parts: Floats) -> Floats:
        """Sum (B, C, K, K) into (B, P, P)."""
        if self._alone:
            return parts[:, 0]
        total = np.zeros((len(parts), self._size, self._size))
        for c, (rows, columns) in enumerate(self._squares):
            total[:, rows, columns] += parts[:, c]
        return total
