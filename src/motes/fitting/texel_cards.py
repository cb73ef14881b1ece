"""A batched fit on another device than the processor's compiled engine: data over, the kernel, results back, a piece after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.printed.rows import LANES
from motes.fitting.printed.translated import KERNEL, translated
from motes.kernels.cards import Device

PIECE = 1 << 18  # texels that are there at a time; whole blocks
Doubles = NDArray[np.float64]
Singles = NDArray[np.float32]


class Wanted(NamedTuple):
    """What a run of the kernel is to do: the most iterations, of how many times one serves first steps, and what is closed
    (`motes.fitting.printed.driver_text.FIT`)."""

    limit: int
    every: int
    close: int


class OnDevice:
    """The kernel of a form, translated and compiled for a device.

    Parameters
    ----------
    source
        The module for the processor.
    sizes
        Times, given samples, and samples with those that fill up.
    items
        Float64 numbers that a block of `LANES` texels needs room for.
    shared
        What depends on directions alone (columns, samples), and what trends need.
    """

    def __init__(
        self, device: Device, source: str, sizes: tuple[int, int, int], items: int, shared: tuple[Singles, Doubles]
    ) -> None:
        self._device, self._sizes, self._bytes = device, sizes, 8 * items
        self._launch = device.compiled(translated(source), KERNEL)
        self._columns, self._basis = (device.held(part) for part in shared)
        self._row = shared[0].shape[1]

    def run(
        self,
        data: Singles,
        box: Doubles,
        held: Doubles,
        noise: Doubles,
        wanted: Wanted,
        results: Sequence[NDArray[Any]],
        residuals: Singles | None,
    ) -> None:
        """Fit texels (M, ...).

        Parameters
        ----------
        held, noise
            Of each texel (M, P) and (M,), or what all share: (P,) and (1,).
        results
            Points and states, in and out, values, errors, verdicts and covariances: a row a texel.
        residuals
            (blocks of `LANES` texels, values, LANES), or None.
        """
        texels, device = len(data), self._device
        bounds = device.held(box)
        room, blocks = device.room(self._bytes, -(-min(texels, PIECE) // LANES))
        held_step, noise_step = held.shape[-1] if held.ndim > 1 else 0, int(len(noise) > 1)
        for first in range(0, texels, PIECE):
            last = min(texels, first + PIECE)
            values = device.held(data[first:last])
            holds = device.held(held[first:last] if held_step else held)
            units = device.held(noise[first:last] if noise_step else noise)
            outs = [device.held(part[first:last]) for part in results]
            points, states, found, errors, codes, covariances = (out.address for out in outs)
            piece = slice(first // LANES, -(-last // LANES))
            left = None if residuals is None else device.held(residuals[piece])
            self._launch(
                blocks * LANES,
                values.address, *self._sizes, self._columns.address, self._row, self._basis.address, bounds.address,
                last - first, points, states, holds.address, held_step, units.address, noise_step,
                wanted.limit, 0, wanted.every, wanted.close, found, errors, codes, covariances if results[-1].shape[1] else 0,
                0 if left is None else left.address, room.address, self._bytes, blocks,
            )  # fmt: skip
            for out, part in zip(outs, results, strict=True):
                out.read(part[first:last])
            if left is not None and residuals is not None:
                left.read(residuals[piece])
