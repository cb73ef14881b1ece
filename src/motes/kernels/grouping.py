"""One call of a model at texels that are grouped: see `motes.kernels.grouped`, whose kernels are run here."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

import numpy as np

from motes import workers
from motes.graph.tracing import TracedParameter
from motes.kernels import grouped
from motes.kernels.jobs import CHUNK, Array, Job, address, place, with_room


class Made(Protocol):
    """A compiled kernel: its module and driver, what was printed, and the values that the driver wants beforehand."""

    @property
    def driver(self) -> Callable[..., None]: ...
    @property
    def code(self) -> Any: ...
    @property
    def printed(self) -> Any: ...
    @property
    def width(self) -> int: ...
    @property
    def varying(self) -> tuple[TracedParameter, ...]: ...
    def constants(self, value: Callable[[TracedParameter], float]) -> Array: ...


def evaluate(job: Job, target: Array, numbers: Made, kernel: Made, alone: Callable[[], Made]) -> bool:
    """Fill `target`, or return False where there are too few texels to a group.

    Parameters
    ----------
    numbers, kernel
        Of `grouped.numbers` and `grouped.evaluation`.
    alone
        Gives the kernel that evaluates texels one by one, which is made only if it is needed.
    """
    varying = job.rows(kernel.varying)
    own, seen = varying[kernel.printed.key], np.zeros(grouped.KEYS, np.int32)
    kernel.code.seen(address(own), job.count, address(seen))
    keys = np.flatnonzero(seen)
    if len(keys) * grouped.FULL > job.count:
        return False
    extras, near = grouped.polynomials(keys, _numbers(job, numbers, keys))
    constants = np.broadcast_to(kernel.constants(job.uniform), (len(keys), len(kernel.printed.constants)))
    rows = np.ascontiguousarray(np.concatenate([constants, extras], axis=1)[:, kernel.printed.columns], job.scalar)
    group = np.zeros(grouped.KEYS, np.int32)
    group[keys] = np.arange(len(keys))
    others = (address(rows), rows.shape[1], len(keys), address(group), address(varying), job.count, *place(target))

    def work(chunk: int, room: Array) -> None:
        kernel.driver(*place(job.wi), *place(job.wo), *others, address(room), *job.range(chunk))

    workers.spread(job.chunks, work, lambda: grouped.room(kernel.printed, CHUNK, len(keys), job.channels))
    if not near.all():
        seen[keys[near]] = 0
        which = np.empty(job.count + 1, np.int32)
        which = which[: kernel.code.among(address(own), job.count, address(seen), address(which))]
        _one_by_one(job, target, which, varying, alone())
    return True


def _numbers(job: Job, numbers: Made, keys: Array) -> Array:
    """The numbers (numbers, groups, places), in float64."""
    places = np.ascontiguousarray(grouped.places(keys).ravel())
    count = places.size
    table, nothing = np.empty((numbers.width, count)), np.zeros((3, count))  # they do not depend on directions
    constants, room = numbers.constants(job.uniform), np.empty(0)
    directions = (address(nothing), 1, count) * 2
    numbers.driver(*directions, address(constants), address(places), count, *place(table.T), address(room), 0, count)
    return table.reshape(numbers.width, len(keys), -1)


def _one_by_one(job: Job, target: Array, which: Array, varying: Array, kernel: Made) -> None:
    count = len(which)
    constants, here = kernel.constants(job.uniform), with_room(len(varying), count, job.scalar)
    np.take(varying, which, axis=1, out=here)
    wi, wo = (np.ascontiguousarray(w[which].T).T for w in (job.wi, job.wo))
    found = np.empty((job.channels, count), job.scalar).T
    others = (address(constants), address(here), count, *place(found))

    def work(chunk: int, room: int) -> None:
        kernel.driver(*place(wi), *place(wo), *others, room, chunk * CHUNK, min(count, (chunk + 1) * CHUNK))

    job.spread(-(-count // CHUNK), work)
    target[which] = found
