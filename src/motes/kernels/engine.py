"""The compiled engine: evaluation and gradients of models at many directions, on all cores.

A model is traced (`motes.graph.tracing`), printed as a module (`motes.kernels.loops`) and compiled once; the module and its machine
code are kept in the user's cache folder, so that the next process loads them in a fraction of a second.  Values of parameters are
inputs: a model of the same structure with other values uses the same kernel.

Work is cut into chunks of a fixed size that threads of this process take in turn.  The kernels release the interpreter's lock and have
no threads of their own, so forking and calling from several threads at once are safe, and no result depends on the number of
threads.  ``NUMBA_NUM_THREADS`` limits it.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from motes.errors import DataError
from motes.graph import tracing
from motes.graph.recording import Kind, recorded
from motes.kernels import gradients, grouped, grouping, loops
from motes.kernels.jobs import CHUNK, Array, Job, address, place, target_of
from motes.kernels.memory import empty
from motes.kernels.module_cache import cache_folder, compiled_module
from motes.kernels.uniform import Uniform
from motes.parameters import Parametrised

__all__ = [
    "CHUNK",
    "THRESHOLD",
    "address",
    "available",
    "cache_folder",
    "call",
    "density",
    "evaluate",
    "module",
    "on_compile",
    "sample",
    "serves",
    "threshold",
    "vjp",
]

#: The printer of each kind of kernel, and what it is a trace of.
_PRINTERS = {
    "evaluation": (loops.evaluation, Kind.VALUE),
    "numbers": (loops.numbers, Kind.VALUE),
    "apart": (loops.apart, Kind.VALUE),
    "group numbers": (grouped.numbers, Kind.VALUE),
    "grouped": (grouped.evaluation, Kind.VALUE),
    "gradient": (gradients.gradient, Kind.VALUE),
    "density": (loops.evaluation, Kind.DENSITY),
    "sampling": (loops.sampling, Kind.SAMPLE),
}
#: Below this number of directions NumPy is fast enough, and there is nothing to compile.
THRESHOLD = 100_000
#: The same of samples and their densities, in thresholds of values: what NumPy does with them it does as fast, and compiling takes up to twice as long.
SAMPLES = 5
#: The first LLVM that reads what `motes.kernels.assembly` writes.
LEAST_LLVM = (20, 0, 0)
#: Called with a sentence before a kernel is compiled, which takes some seconds and is done once.
on_compile: Callable[[str], None] | None = None


# ---------------------------------------------------------------- what others call


def available() -> bool:
    """Whether kernels can be compiled here."""
    try:
        import llvmlite.binding
    except Exception:  # an installation that does not fit its Python fails in many ways
        return False
    return bool(llvmlite.binding.llvm_version_info >= LEAST_LLVM)


def threshold(kind: Kind) -> int:
    """From how many directions on it is worth compiling."""
    return THRESHOLD if kind is Kind.VALUE else SAMPLES * THRESHOLD


def serves(kind: Kind, model: Parametrised) -> bool:
    """Whether kernels can be compiled here, and the formulas of a model be recorded."""
    return available() and recorded(kind, model, int(model.channels)) is not None  # type: ignore[attr-defined]


def evaluate(model: Parametrised, wi: ArrayLike, wo: ArrayLike, out: Array | None = None) -> Array:
    """The BRDF of a model at many directions [1/sr], as ``model.eval`` gives it.

    Parameters
    ----------
    model
        A BRDF with NumPy parameters.  Parameters with axes besides the channels broadcast against the directions.
    wi, wo
        Unit vectors (..., 3) that broadcast.  Both float32: computed in float32; otherwise in float64.  Any strides are read
        where they are; (N, 3) in one piece and the transposed view of a (3, N) array, which is faster, in particular.
    out
        An array (..., C) of the same precision to fill.

    Returns
    -------
    array (..., C)
        `out`, or a new array: the transposed view of a (C, N) array where the directions are of that kind.
    """
    job = Job(model, wi, wo)
    shape = (*job.shape, job.channels)
    if out is not None and (out.shape != shape or out.dtype != job.scalar or not out.flags.writeable):
        found = f"{out.dtype} {out.shape}" + ("" if out.flags.writeable else ", read-only")
        raise DataError(
            f"out is an array {found}, expected {job.scalar} {shape}, writeable", "Leave out= to have one made"
        )
    target = target_of(out, shape, job)
    if job.count and job.apart and _worth_apart(job):
        _evaluate_apart(job, target)
    elif job.count and not (job.many and _evaluate_grouped(job, target)):
        _run("evaluation", job, *place(target))
    if out is None:
        return target.reshape(shape) if len(job.shape) != 1 else target
    if not np.may_share_memory(out, target):
        out[...] = target.reshape(shape)
    return out


def density(model: Parametrised, wi: ArrayLike, wo: ArrayLike) -> Array:
    """The density with which samples are chosen [1/sr], as ``model.pdf`` gives it; inputs as for `evaluate`, an array (...) out."""
    job = Job(model, wi, wo)
    found = empty((job.count,), job.scalar)
    if job.count:
        _run("density", job, address(found), 1, job.count)
    return found.reshape(job.shape)


def sample(model: Parametrised, wi: ArrayLike, u: ArrayLike) -> tuple[Array, Array, Array]:
    """Directions ``wo`` (..., 3), their density (...) and weights (..., C), as ``model.sample`` gives them.

    Parameters
    ----------
    model
        As for `evaluate`.
    wi
        Unit vectors (..., 3).
    u
        Random numbers (..., 2) in [0, 1) that broadcast against them; both float32: computed in float32.
    """
    job = Job(model, wi, u, second=("u", 2), more=4)
    wo, chances, weights = job.room(3), empty((job.count,), job.scalar), job.room(job.channels)
    if job.count:
        _run("sampling", job, *place(wo), address(chances), *place(weights))
    return wo.reshape((*job.shape, 3)), chances.reshape(job.shape), weights.reshape((*job.shape, job.channels))


def call(kind: Kind, model: Parametrised, a: Array, b: Array) -> list[Array]:
    """`evaluate`, `density` or `sample`."""
    if kind is Kind.SAMPLE:
        return list(sample(model, a, b))
    return [density(model, a, b) if kind is Kind.DENSITY else evaluate(model, a, b)]


def _run(kind: str, job: Job, *targets: int) -> None:
    """Compute all of a call, into `targets`: places, as the driver of that kind takes them."""
    kernel = _kernel(kind, job)
    constants, varying = _constants(kernel, job), job.rows(kernel.varying)
    others = (constants, address(varying), job.count, *targets)

    def work(first: int, last: int, room: int) -> None:
        for piece in job.pieces(first, last):
            kernel.driver(*piece.wi, *piece.wo, *others, room, piece.first, piece.last)

    job.run(work)


def _constants(kernel: _Kernel, job: Job) -> int:
    """The address of what a kernel wants beforehand, which is computed once for a model and lives as long as it."""
    found = job.known.constants.get(id(kernel))
    if found is None or found[0] is not kernel:
        constants = kernel.constants(job.uniform)
        found = job.known.constants[id(kernel)] = (kernel, constants, address(constants))
    return int(found[2])


def _evaluate_apart(job: Job, target: Array) -> None:
    """Rows of directions, each with parameters of its own: what depends on them alone is computed once for a row, in float64."""
    numbers, kernel = _kernels_apart(job)
    constants, values = numbers.constants(job.uniform), job.of_rows(numbers.varying)
    rows, length = values.shape[1], job.shape[-1]
    at_once = max(1, CHUNK // length)
    nothing = np.zeros((3, at_once))  # in the place of directions, on which the numbers do not depend

    def work(task: int, room: int) -> None:
        first, last = task * at_once, min(rows, (task + 1) * at_once)
        count = last - first
        here = np.ascontiguousarray(values[:, first:last])
        table = np.empty((numbers.width, count))
        directions = (address(nothing), 1, at_once) * 2
        numbers.driver(*directions, address(constants), address(here), count, address(table), 1, count, room, 0, count)
        own = np.ascontiguousarray(table.T, job.scalar)
        (wi, *wi_steps), (wo, *wo_steps) = job.beginnings(first, last)
        kernel.driver(
            *(address(wi), *wi_steps), *(address(wo), *wo_steps),
            address(own), numbers.width, *place(target), length, room, first, last,
        )  # fmt: skip

    job.spread(-(-rows // at_once), work)


def _evaluate_grouped(job: Job, target: Array) -> bool:
    """Texels in groups of about the same value of a parameter, or False where that does not serve."""
    kernels = _kernels_grouped(job)
    return kernels is not None and grouping.evaluate(job, target, *kernels, lambda: _kernel("evaluation", job))


def vjp(model: Parametrised, wi: ArrayLike, wo: ArrayLike, upstream: ArrayLike) -> dict[str, Array]:
    """Gradients by the parameters: the vector-Jacobian product of `evaluate`.

    Parameters
    ----------
    model, wi, wo
        As for `evaluate`.
    upstream
        The derivative of some number by every value of `evaluate`; broadcasts to (..., C).

    Returns
    -------
    dict
        For every slot of the model the derivative of that number, float64, in the shape of the parameter's value.  Sums over directions are made in
        a fixed order: in the precision of the directions over runs of 1024, in float64 beyond.
    """
    job = Job(model, wi, wo)
    shape = (*job.shape, job.channels)
    try:
        seed = np.broadcast_to(np.asarray(upstream, job.scalar), shape)
    except ValueError:
        raise DataError(
            f"upstream has shape {np.shape(upstream)}, expected {shape}", "Give one number for every value"
        ) from None
    seed = seed if len(shape) == 2 else seed.reshape(-1, job.channels)
    kernel = _kernel("gradient", job)
    constants, varying = _constants(kernel, job), job.rows(kernel.varying)
    slopes = np.zeros_like(varying)
    totals = np.zeros((job.chunks, len(kernel.printed.totals)))

    others = (constants, address(varying), job.count, *place(seed), address(slopes))

    def work(chunk: int, room: int) -> None:
        sums = address(totals[chunk])
        for wi, wo, first, last in job.pieces(*job.range(chunk)):
            kernel.driver(*wi, *wo, *others, sums, room, first, last)

    job.spread(job.chunks, work, gradients.room(kernel.printed))
    return job.gathered(
        kernel.uniform.pullback(job.uniform, totals.sum(axis=0)), dict(zip(kernel.varying, slopes, strict=True))
    )


# ---------------------------------------------------------------- kernels


@dataclass(frozen=True)
class _Kernel:
    """A compiled driver, and the functions that connect its constants with parameters."""

    driver: Callable[..., None]
    uniform: Uniform
    printed: Any
    code: Any

    @property
    def width(self) -> int:
        """How many numbers the driver computes at a place."""
        return int(self.printed.width)

    @property
    def varying(self) -> tuple[tracing.TracedParameter, ...]:
        """Parameters that the driver reads a row of."""
        found: tuple[tracing.TracedParameter, ...] = self.printed.varying
        return found

    def constants(self, value: Callable[[tracing.TracedParameter], float]) -> Array:
        """What the driver wants beforehand, from the values of parameters."""
        return self.uniform.constants(value)


_kernels: dict[tuple[Any, ...], _Kernel] = {}
_pairs: dict[tuple[Any, ...], tuple[_Kernel, _Kernel]] = {}
_grouped: dict[tuple[Any, ...], tuple[_Kernel, _Kernel] | None] = {}
_lock = threading.RLock()


def _forked() -> None:
    """In a child of this process: a thread of the parent, which the child has not, may have held the lock."""
    global _lock
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def _kernel(kind: str, job: Job) -> _Kernel:
    """The kernel for a call, from memory, from the cache folder, or compiled."""
    key = (kind, job.known.key, job.varying, job.scalar)
    kernel = _kernels.get(key)
    if kernel is None:
        with _lock:
            kernel = _kernels.get(key) or _made(kind, job, _trace(kind, job))
            _kernels[key] = kernel
    return kernel


_worth: dict[tuple[Any, ...], bool] = {}


def _worth_apart(job: Job) -> bool:
    key = (job.known.key, job.varying)
    if key not in _worth:
        _worth[key] = loops.worth_apart(tracing.trace(job.model, job.channels), job.varying)
    return _worth[key]


def _kernels_apart(job: Job) -> tuple[_Kernel, _Kernel]:
    """The kernels of the numbers of rows, and of the rows: of one graph, so that both have the numbers in one order."""
    key = (job.known.key, job.varying, job.scalar)
    pair = _pairs.get(key)
    if pair is None:
        with _lock:
            trace = _trace("apart", job)
            pair = _pairs.get(key) or (_made("numbers", job, trace), _made("apart", job, trace))
            _pairs[key] = pair
    return pair


def _kernels_grouped(job: Job) -> tuple[_Kernel, _Kernel] | None:
    """The kernels of the numbers of groups, and of the groups; None where it is not worth it."""
    key = (job.known.key, job.varying)
    if key not in _grouped:
        with _lock:
            trace = _trace("grouped", job)
            worth = key not in _grouped and grouped.grouping(trace, job.varying) is not None
            pair = (_made("group numbers", job, trace), _made("grouped", job, trace)) if worth else None
            _grouped.setdefault(key, pair)
    return _grouped[key]


def _trace(kind: str, job: Job) -> tracing.Trace:
    found = recorded(_PRINTERS[kind][1], job.model, job.channels)
    return found or tracing.trace(job.model, job.channels)  # which says what is wrong


def _made(kind: str, job: Job, trace: tracing.Trace) -> _Kernel:
    scalar = np.dtype(np.float64) if kind.endswith("numbers") else job.scalar
    printed = _PRINTERS[kind][0](trace, job.varying, scalar.name)
    parameters = [p for p in trace.parameters if p.slot not in job.varying]
    uniform = Uniform(trace, parameters, printed.constants, printed.totals, scalar)
    code = module(printed.source, f"the {kind} of {type(job.model).__name__} in {scalar.name}")
    return _Kernel(getattr(code, printed.driver), uniform, printed, code)


def module(source: str, title: str) -> Any:
    """The kernels of a generated module, compiled and kept; see `motes.kernels.module_cache.compiled_module`."""
    return compiled_module(source, title, on_compile)
