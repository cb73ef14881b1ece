"""One call of a kernel: its inputs, checked and laid out, cut into chunks that threads take in turn."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import workers
from motes.errors import DataError, ParameterError
from motes.graph import tracing
from motes.graph.tracing import TracedParameter
from motes.kernels.assembly import LINE
from motes.kernels.loops import TILE, WHOLE
from motes.kernels.memory import empty
from motes.kernels.remembered import Remembered
from motes.parameters import Parametrised, Slot

CHUNK = 32 * TILE  # directions that a thread takes at a time
# Chunks that a thread takes together where there are many and nothing is summed over them: each time costs some 10 microseconds, as 3,000 directions do.
SEVERAL = 16
# Rows of an outer product at least so long are computed where they are, one call of the driver each; shorter ones are copied, a chunk at a time.
LONG = TILE // 2
# Rows with parameters of their own at least so long are computed one by one, with what depends on parameters alone computed once for each.
SHORTEST_ROW = 32
# From so many texels on what depends on one parameter alone may be computed for groups of them (`motes.kernels.grouped`).
MANY = 16_384
Array = NDArray[Any]


_SINGLE, _DOUBLE = np.dtype(np.float32), np.dtype(np.float64)


class Known:
    """What calls ask of a model, found once.

    Attributes
    ----------
    slots
        By name.
    batches
        The axes of parameters that broadcast against the directions, of those that have some.
    varying
        Slots that may differ from direction to direction.
    key
        See `motes.graph.tracing.key`.
    constants
        What depends on parameters alone, by the kernel that asks for it; filled by `motes.kernels.engine`.
    """

    def __init__(self, model: Parametrised) -> None:
        self.channels = int(model.channels)  # type: ignore[attr-defined]
        self.slots = {slot.name: slot for slot in model.slots()}
        self.batches = {name: shape for name, slot in self.slots.items() if (shape := _batch(slot))}
        self.varying = tuple(name for name, shape in self.batches.items() if math.prod(shape) != 1)
        self.key = tracing.key(model, self.channels)
        self.constants: dict[Any, Any] = {}


_known = Remembered(Known)


class Piece(NamedTuple):
    """Directions that one call of a driver computes, `first` to `last` of all, and where it finds each array: see `place`."""

    wi: tuple[int, int, int]
    wo: tuple[int, int, int]
    first: int
    last: int


class _Rows(NamedTuple):
    """Where the rows of a broadcast array (..., n, 3) lie, as numbers alone: there may be a thousand to a call."""

    start: int
    axes: tuple[tuple[int, int], ...]  # lengths and steps [bytes] of all axes before the rows, the last one first
    length: int
    step: int
    stride: int
    item: int

    @classmethod
    def of(cls, w: Array, shape: tuple[int, ...]) -> _Rows:
        """Of an array of `shape` and some components, or of one (N, 3) with as many directions."""
        w = w.reshape(*shape, w.shape[-1])  # a view: it is one already, or (N, 3) in even steps
        axes = zip(shape[-2::-1], w.strides[-3::-1], strict=True)
        return cls(address(w), tuple(axes), shape[-1], w.strides[-2], w.strides[-1], w.itemsize)

    def place(self, row: int) -> tuple[int, int, int]:
        """See `place`, for an array of which only this row is there, in its place."""
        at, rest = self.start - row * self.length * self.step, row
        for length, step in self.axes:
            rest, k = divmod(rest, length)
            at += k * step
        return at, self.step // self.item, self.stride // self.item


class Job:
    """Checked inputs of a call: directions (..., 3) that are broadcast, parameters as uniform numbers or values that vary.

    In the place of ``wo`` there may be something else: `second` says its name and the length of its last axis.  Besides the channels a
    call has `more` results.
    """

    def __init__(
        self, model: Parametrised, wi: ArrayLike, wo: ArrayLike, second: tuple[str, int] = ("wo", 3), more: int = 0
    ) -> None:
        self.model = model
        self.known = _known.of(model)
        wi, wo = np.asarray(wi), np.asarray(wo)
        for (name, n), w in ((("wi", 3), wi), (second, wo)):
            if w.ndim == 0 or w.shape[-1] != n:
                raise DataError(
                    f"{name} has shape {w.shape}: the last axis must have length {n}", f"Pass arrays (..., {n})"
                )
        single = all(w.dtype.kind == "f" and w.dtype.itemsize == 4 for w in (wi, wo))
        self.scalar = _SINGLE if single else _DOUBLE
        self.channels, self.slots, self.varying = self.known.channels, self.known.slots, self.known.varying
        self._items = (wi.shape[-1] + wo.shape[-1] + more + self.channels) * TILE
        batches = self.known.batches
        self.shape = wi.shape[:-1]
        if batches or wo.shape[:-1] != self.shape:
            try:
                self.shape = np.broadcast_shapes(wi.shape[:-1], wo.shape[:-1], *batches.values())
            except ValueError:
                listed = ", ".join(f"{name} {shape}" for name, shape in batches.items())
                raise ParameterError(
                    f"{type(model).__name__}: directions {wi.shape}, {wo.shape} and parameters do not broadcast ({listed or 'no axes'})",
                    "All axes of a parameter but the channels must fit those of the directions",
                ) from None
        self.count = math.prod(self.shape)
        self.chunks = -(-self.count // CHUNK)
        self.wi, self.wo = self._spread(wi), self._spread(wo)

    def _spread(self, w: Array) -> Array:
        """Directions of the shape of the call, (N, 3) where strides can say it; a view in any case but of odd types and places."""
        w = w.astype(self.scalar, copy=False)
        if not w.flags.aligned:
            w = w.copy()
        if w.shape[:-1] != self.shape:
            w = np.broadcast_to(w, (*self.shape, w.shape[-1]))
        if w.ndim == 2:
            return w
        whole = w.ndim == 1 or _even(w) or (self.shape[-1] < LONG and self._slab > CHUNK)
        return w.reshape(-1, w.shape[-1]) if whole else w

    @property
    def _slab(self) -> int:
        """The number of directions to an entry of the first axis."""
        return math.prod(self.shape[1:])

    def pieces(self, first: int, last: int) -> Iterator[Piece]:
        """What to compute for some directions: all of it at once, or the rows of an outer product."""
        if self.wi.ndim == self.wo.ndim == 2:
            yield Piece(*self._places, first, last)
            return
        length, slab = self.shape[-1], self._slab
        if length < LONG:
            begin, end = first // slab, -(-last // slab)
            copies = [w if w.ndim == 2 else w[begin:end].reshape(-1, w.shape[-1]) for w in (self.wi, self.wo)]
            starts = [0 if w.ndim == 2 else begin * slab for w in (self.wi, self.wo)]
            moved = [_moved(w, start) for w, start in zip(copies, starts, strict=True)]
            yield Piece(moved[0], moved[1], first, last)
            return
        wi, wo = self._rows
        while first < last:
            row = first // length
            end = min(last, (row + 1) * length)
            yield Piece(wi.place(row), wo.place(row), first, end)
            first = end

    @cached_property
    def _places(self) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
        return place(self.wi), place(self.wo)  # NumPy takes some microseconds to say where an array is, in each chunk

    @cached_property
    def _rows(self) -> tuple[_Rows, _Rows]:
        return _Rows.of(self.wi, self.shape), _Rows.of(self.wo, self.shape)

    def room(self, lanes: int) -> Array:
        """A new array (N, lanes): the transposed view of a (lanes, N) array where the directions are of that kind."""
        rows = any(w.strides[0] == w.itemsize for w in (self.wi, self.wo)) and len(self.shape) == 1
        return empty((lanes, self.count), self.scalar).T if rows else empty((self.count, lanes), self.scalar)

    def uniform(self, parameter: TracedParameter) -> float:
        """The value of a parameter that all directions share."""
        return float(parameter.of(np.ravel(self.slots[parameter.slot].value)))

    def rows(self, parameters: Sequence[TracedParameter]) -> Array:
        """The values of varying parameters, a row each."""
        rows = with_room(len(parameters), self.count, self.scalar)
        for row, parameter in zip(rows, parameters, strict=True):
            slot = self.slots[parameter.slot]
            value = np.asarray(slot.value)
            value = parameter.of(value) if slot.parameter.per_channel else value
            row.reshape(self.shape)[...] = value
        return rows

    @cached_property
    def apart(self) -> bool:
        """Whether the parameters that vary are uniform over each row of the last axis, and rows are long enough for that to matter."""
        shapes = [self.known.batches[name] for name in self.varying]
        return bool(shapes) and self.shape[-1] >= SHORTEST_ROW and all(shape[-1] == 1 for shape in shapes)

    @cached_property
    def many(self) -> bool:
        """Whether there are so many texels in float32, one after the other, that they may be sorted by a parameter."""
        flat = self.wi.ndim == self.wo.ndim == 2
        return bool(self.varying) and self.scalar == np.float32 and self.count >= MANY and flat

    def of_rows(self, parameters: Sequence[TracedParameter]) -> Array:
        """The values (P, rows) of varying parameters that are uniform over each row of the last axis, in float64."""
        shape = self.shape[:-1]
        values = np.empty((len(parameters), int(np.prod(shape))))
        for row, parameter in zip(values, parameters, strict=True):
            slot = self.slots[parameter.slot]
            value = np.asarray(slot.value)
            value = value[..., parameter.channel or 0] if slot.parameter.per_channel else value
            row.reshape(shape)[...] = value[..., 0]
        return values

    def beginnings(self, first: int, last: int) -> tuple[tuple[Array, int, int], tuple[Array, int, int]]:
        """Of `wi` and `wo`: where rows of the last axis begin in memory, step and stride in items; see `place`."""
        rows = np.unravel_index(np.arange(first, last), self.shape[:-1])
        found = []
        for w in (self.wi, self.wo):
            w = w.reshape(*self.shape, 3)  # a view, see `_Rows.of`
            at = np.full(last - first, address(w), np.int64)
            for k, step in zip(rows, w.strides[:-2], strict=True):
                at += k * step
            found.append((at, w.strides[-2] // w.itemsize, w.strides[-1] // w.itemsize))
        return found[0], found[1]

    def gathered(self, sums: dict[TracedParameter, float], slopes: dict[TracedParameter, Array]) -> dict[str, Array]:
        """Derivatives by slot, in the shape of the values."""
        gradients = {name: np.zeros(np.shape(slot.value)) for name, slot in self.slots.items()}
        for parameter, total in sums.items():
            np.reshape(gradients[parameter.slot], -1)[parameter.channel or 0] = total
        for parameter, slope in slopes.items():
            slot, gradient = self.slots[parameter.slot], gradients[parameter.slot]
            target = gradient[..., parameter.channel or 0] if slot.parameter.per_channel else gradient
            target[...] = _summed(slope.reshape(self.shape), target.shape)
        return gradients

    def range(self, chunk: int) -> tuple[int, int]:
        """The first direction of a chunk and the one after its last."""
        return chunk * CHUNK, min(self.count, (chunk + 1) * CHUNK)

    def shares(self) -> list[tuple[int, int]]:
        """Ranges of directions, whole chunks, for threads to take in turn: fewer at a time towards the end, so that all are done at about the same time."""
        found, chunk, most = [], 0, SEVERAL if self.wi.ndim == self.wo.ndim == 2 else 1
        while chunk < self.chunks:
            end = chunk + max(1, min(most, (self.chunks - chunk) // (4 * workers.threads())))
            found.append((chunk * CHUNK, min(self.count, end * CHUNK)))
            chunk = end
        return found

    def run(self, work: Callable[[int, int, int], None]) -> None:
        """Call ``work(first, last, room)`` for all directions, on all cores; `room` is the address of scratch memory."""
        shares = self.shares()
        self.spread(len(shares), lambda share, room: work(*shares[share], room))

    def spread(self, tasks: int, work: Callable[[int, int], None], more: int = 0) -> None:
        """Call ``work(task, room)`` for every task, on all cores; `room` is the address of scratch memory, with `more` items than usual."""
        items = self._items + more + LINE // self.scalar.itemsize
        workers.spread(tasks, lambda task, room: work(task, aligned(room)), lambda: np.empty(items, self.scalar))


def aligned(room: Array) -> int:
    """Where in an array's memory the first whole cache line begins: vectors across two lines take twice as long to read."""
    return -(-address(room) // LINE) * LINE


def _batch(slot: Slot) -> tuple[int, ...]:
    """The axes of a parameter that broadcast against the directions."""
    shape = np.shape(slot.value)
    return shape[:-1] if slot.parameter.per_channel else shape


def _even(w: Array) -> bool:
    """Whether all but the last axis of an array are one axis with even steps."""
    axes = [(n, step) for n, step in zip(w.shape[:-1], w.strides[:-1], strict=True) if n != 1]
    return all(step == n * inner for (_, step), (n, inner) in pairwise(axes))


def _summed(x: Array, shape: tuple[int, ...]) -> Array:
    """`x` summed over the axes along which an array of `shape` was broadcast, in float64."""
    x = x.sum(axis=tuple(range(x.ndim - len(shape))), dtype=np.float64)
    axes = tuple(k for k, n in enumerate(shape) if n == 1 and x.shape[k] != 1)
    total: Array = x.sum(axis=axes, keepdims=True)
    return total


def target_of(out: Array | None, shape: tuple[int, ...], job: Job) -> Array:
    """An array (N, C) to write to: `out` itself where that is possible."""
    if out is not None and out.flags.aligned and not any(np.may_share_memory(out, w) for w in (job.wi, job.wo)):
        flat = out.reshape(job.count, job.channels)
        if np.may_share_memory(out, flat):  # not a copy
            return flat
    return job.room(job.channels)


def with_room(rows: int, count: int, scalar: np.dtype[Any]) -> Array:
    """A new array (rows, count) behind which a kernel may read what would make its last vector whole."""
    return np.empty(rows * count + WHOLE, scalar)[: rows * count].reshape(rows, count)


def address(x: Array) -> int:
    """Where an array begins in memory."""
    return int(x.__array_interface__["data"][0])


def place(x: Array) -> tuple[int, int, int]:
    """Address, step and stride in items of an array (N, k)."""
    return address(x), x.strides[0] // x.itemsize, x.strides[1] // x.itemsize


def _moved(x: Array, first: int) -> tuple[int, int, int]:
    """The place of an array (n, k) whose first entry is the one numbered `first`."""
    start, step, stride = place(x)
    return start - first * step * x.itemsize, step, stride
