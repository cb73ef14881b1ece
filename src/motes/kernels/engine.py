"""The compiled engine: evaluation and gradients of models at many directions, on all cores.

A model is traced (`motes.graph.tracing`), printed as a Numba module (`motes.kernels.numba`) and compiled once; the module and its machine
code are kept in the user's cache folder, so that the next process loads them in a fraction of a second.  Values of parameters are
inputs: a model of the same structure with other values uses the same kernel.

Work is cut into chunks of a fixed size that threads of this process take in turn.  The kernels release the interpreter's lock and have
no threads of their own, so forking and calling from several threads at once are safe, and no result depends on the number of
threads.  ``NUMBA_NUM_THREADS`` limits it.

The cache folder is ``$MOTES_CACHE``, or ``motes`` in the platform's place for caches.  It holds code that is executed, and is made
readable by its owner only.
"""

from __future__ import annotations

import atexit
import contextlib
import hashlib
import importlib.util
import logging
import os
import platform
import shutil
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import workers
from motes.errors import DataError, ParameterError
from motes.graph import tracing
from motes.kernels import numba as numba_code
from motes.kernels import numpy as numpy_code
from motes.parameters import Parametrised, Slot

#: Below this number of directions NumPy is fast enough, and there is nothing to compile.
THRESHOLD = 100_000
#: Called with a sentence before a kernel is compiled, which takes some seconds and is done once.
on_compile: Callable[[str], None] | None = None

CHUNK = 32 * numba_code.TILE  # directions that a thread takes at a time
Array = NDArray[Any]


# ---------------------------------------------------------------- what others call


def available() -> bool:
    """Whether kernels can be compiled here."""
    try:
        import numba
    except Exception:  # an installation of Numba that does not fit its Python or NumPy fails in many ways
        return False
    return not numba.config.DISABLE_JIT


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
    job = _Job(model, wi, wo)
    shape = (*job.shape, job.channels)
    if out is not None and (out.shape != shape or out.dtype != job.scalar or not out.flags.writeable):
        found = f"{out.dtype} {out.shape}" + ("" if out.flags.writeable else ", read-only")
        raise DataError(
            f"out is an array {found}, expected {job.scalar} {shape}, writeable", "Leave out= to have one made"
        )
    target = _target(out, shape, job)
    if job.count:
        kernel = _kernel("evaluation", job)
        constants = kernel.constants(job.uniform)
        varying = job.rows(kernel.varying)

        def work(chunk: int, room: int) -> None:
            kernel.driver(
                *_place(job.wi),
                *_place(job.wo),
                address(constants),
                address(varying),
                job.count,
                *_place(target),
                room,
                *job.range(chunk),
            )

        job.run(work)
    if out is None:
        return target.reshape(shape) if len(job.shape) != 1 else target
    if not np.may_share_memory(out, target):
        out[...] = target.reshape(shape)
    return out


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
    job = _Job(model, wi, wo)
    shape = (*job.shape, job.channels)
    try:
        seed = np.broadcast_to(np.asarray(upstream, job.scalar), shape)
    except ValueError:
        raise DataError(
            f"upstream has shape {np.shape(upstream)}, expected {shape}", "Give one number for every value"
        ) from None
    seed = seed if len(shape) == 2 else seed.reshape(-1, job.channels)
    kernel = _kernel("gradient", job)
    constants = kernel.constants(job.uniform)
    varying = job.rows(kernel.varying)
    slopes = np.zeros_like(varying)
    totals = np.zeros((job.chunks, len(kernel.totals)))

    def work(chunk: int, room: int) -> None:
        kernel.driver(
            *_place(job.wi), *_place(job.wo), address(constants), address(varying), job.count, *_place(seed),
            address(slopes), address(totals[chunk]), room, *job.range(chunk),
        )  # fmt: skip

    job.run(work)
    return job.gathered(
        kernel.pullback(job.uniform, totals.sum(axis=0)), dict(zip(kernel.varying, slopes, strict=True))
    )


def cache_folder() -> Path:
    """Where kernels are kept: ``$MOTES_CACHE``, or ``motes`` in the platform's folder for caches."""
    if chosen := os.environ.get("MOTES_CACHE"):
        return Path(chosen)
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "motes"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "motes" / "Cache"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "motes"


# ---------------------------------------------------------------- one call


class _Job:
    """Checked inputs of a call: directions as (N, 3) arrays, parameters as uniform numbers or values that vary."""

    def __init__(self, model: Parametrised, wi: ArrayLike, wo: ArrayLike) -> None:
        self.model = model
        wi, wo = np.asarray(wi), np.asarray(wo)
        for name, w in (("wi", wi), ("wo", wo)):
            if w.ndim == 0 or w.shape[-1] != 3:
                raise DataError(f"{name} has shape {w.shape}: the last axis must have length 3", "Pass arrays (..., 3)")
        single = all(w.dtype.kind == "f" and w.dtype.itemsize == 4 for w in (wi, wo))
        self.scalar = np.dtype(np.float32 if single else np.float64)
        self.channels = int(model.channels)  # type: ignore[attr-defined]
        self.slots = {slot.name: slot for slot in model.slots()}
        batches = {name: _batch(slot) for name, slot in self.slots.items()}
        try:
            self.shape = np.broadcast_shapes(wi.shape[:-1], wo.shape[:-1], *batches.values())
        except ValueError:
            listed = ", ".join(f"{name} {shape}" for name, shape in batches.items() if shape)
            raise ParameterError(
                f"{type(model).__name__}: directions {wi.shape}, {wo.shape} and parameters do not broadcast ({listed or 'no axes'})",
                "All axes of a parameter but the channels must fit those of the directions",
            ) from None
        self.count = int(np.prod(self.shape))
        self.chunks = -(-self.count // CHUNK)
        self.wi, self.wo = (self._flat(w) for w in (wi, wo))
        self.varying = tuple(name for name, shape in batches.items() if np.prod(shape) != 1)

    def _flat(self, w: Array) -> Array:
        """Directions as (N, 3), without a copy where strides can say it."""
        w = w.astype(self.scalar, copy=False)
        if not w.flags.aligned:
            w = w.copy()
        w = np.broadcast_to(w, (*self.shape, 3))
        return w if w.ndim == 2 else w.reshape(-1, 3)

    def uniform(self, parameter: tracing.TracedParameter) -> float:
        """The value of a parameter that all directions share."""
        value = np.ravel(self.slots[parameter.slot].value)
        return float(value[parameter.channel or 0])

    def rows(self, parameters: Sequence[tracing.TracedParameter]) -> Array:
        """The values of varying parameters, a row each."""
        rows = np.empty((len(parameters), self.count), self.scalar)
        for row, parameter in zip(rows, parameters, strict=True):
            slot = self.slots[parameter.slot]
            value = np.asarray(slot.value)
            value = value[..., parameter.channel or 0] if slot.parameter.per_channel else value
            row.reshape(self.shape)[...] = value
        return rows

    def gathered(
        self, sums: dict[tracing.TracedParameter, float], slopes: dict[tracing.TracedParameter, Array]
    ) -> dict[str, Array]:
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

    def run(self, work: Callable[[int, int], None]) -> None:
        """Call ``work(chunk, room)`` for every chunk, on all cores; `room` is the address of scratch memory."""
        items = (6 + self.channels) * numba_code.TILE
        workers.spread(
            self.chunks, lambda chunk, room: work(chunk, address(room)), lambda: np.empty(items, self.scalar)
        )


def _batch(slot: Slot) -> tuple[int, ...]:
    """The axes of a parameter that broadcast against the directions."""
    shape = np.shape(slot.value)
    return shape[:-1] if slot.parameter.per_channel else shape


def _summed(x: Array, shape: tuple[int, ...]) -> Array:
    """`x` summed over the axes along which an array of `shape` was broadcast, in float64."""
    x = x.sum(axis=tuple(range(x.ndim - len(shape))), dtype=np.float64)
    axes = tuple(k for k, n in enumerate(shape) if n == 1 and x.shape[k] != 1)
    total: Array = x.sum(axis=axes, keepdims=True)
    return total


def _target(out: Array | None, shape: tuple[int, ...], job: _Job) -> Array:
    """An array (N, C) to write to: `out` itself where that is possible."""
    if out is not None and out.flags.aligned and not any(np.may_share_memory(out, w) for w in (job.wi, job.wo)):
        flat = out.reshape(job.count, job.channels)
        if np.may_share_memory(out, flat):  # not a copy
            return flat
    rows = any(w.strides[0] == w.itemsize for w in (job.wi, job.wo)) and len(job.shape) == 1
    return (
        np.empty((job.channels, job.count), job.scalar).T if rows else np.empty((job.count, job.channels), job.scalar)
    )


def address(x: Array) -> int:
    """Where an array begins in memory."""
    return int(x.__array_interface__["data"][0])


def _place(x: Array) -> tuple[int, int, int]:
    """Address, step and stride in items of an array (N, k)."""
    return address(x), x.strides[0] // x.itemsize, x.strides[1] // x.itemsize


# ---------------------------------------------------------------- kernels


@dataclass(frozen=True)
class _Kernel:
    """A compiled driver, and the functions that connect its constants with parameters."""

    driver: Callable[..., None]
    varying: tuple[tracing.TracedParameter, ...]
    totals: tuple[tracing.Symbol, ...]
    _uniform: tuple[tracing.TracedParameter, ...]
    _constants: Callable[..., tuple[Any, ...]]
    _pullback: Callable[..., tuple[Any, ...]]
    _scalar: np.dtype[Any]

    def constants(self, value: Callable[[tracing.TracedParameter], float]) -> Array:
        """What the driver wants beforehand, from the values of parameters."""
        with np.errstate(all="ignore"):
            return np.array(self._constants(*(np.float64(value(p)) for p in self._uniform)), self._scalar)

    def pullback(
        self, value: Callable[[tracing.TracedParameter], float], totals: NDArray[np.float64]
    ) -> dict[tracing.TracedParameter, float]:
        """Derivatives by the uniform parameters from derivatives by the constants."""
        with np.errstate(all="ignore"):
            slopes = self._pullback(*(np.float64(value(p)) for p in self._uniform), *totals)
        return dict(zip(self._uniform, map(float, slopes), strict=True))


_kernels: dict[tuple[Any, ...], _Kernel] = {}
_lock = threading.RLock()


def _forked() -> None:
    """In a child of this process: a thread of the parent, which the child has not, may have held the lock."""
    global _lock
    _lock = threading.RLock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def _kernel(kind: str, job: _Job) -> _Kernel:
    """The kernel for a call, from memory, from the cache folder, or compiled."""
    key = (kind, tracing.key(job.model, job.channels), job.varying, job.scalar)
    kernel = _kernels.get(key)
    if kernel is None:
        with _lock:
            kernel = _kernels.get(key) or _made(kind, job)
            _kernels[key] = kernel
    return kernel


def _made(kind: str, job: _Job) -> _Kernel:
    trace = tracing.trace(job.model, job.channels)
    printed = getattr(numba_code, kind)(trace, job.varying, job.scalar.name)
    uniform = tuple(p for p in trace.parameters if p.slot not in job.varying)
    names = {p.symbol: f"p{k}" for k, p in enumerate(uniform)}
    seeds = {symbol: trace.graph.leaf(f"total[{k}]") for k, symbol in enumerate(printed.totals)}
    slopes = tracing.adjoint(seeds, list(names))
    zero = trace.graph.constant(0.0)
    constants = numpy_code.scalar_function("constants", names, printed.constants)
    names |= {seed: f"d{k}" for k, seed in enumerate(seeds.values())}
    pullback = numpy_code.scalar_function("pullback", names, [slopes.get(p.symbol, zero) for p in uniform])
    driver = getattr(
        module(printed.source, f"the {kind} of {type(job.model).__name__} in {job.scalar.name}"), printed.driver
    )
    return _Kernel(driver, printed.varying, printed.totals, uniform, constants, pullback, job.scalar)


def module(source: str, title: str, uses: Sequence[Any] = ()) -> Any:
    """Import a generated module from the cache folder, compiled there; from a temporary folder where that is not possible.

    `uses` are the modules of Motes, besides those of this room, whose functions are compiled into it.
    """
    import llvmlite
    import numba

    from motes.kernels import intrinsics, vectors
    from motes.version import __version__

    versions = [
        __version__,
        numba.__version__,
        llvmlite.__version__,
        np.__version__,
        platform.python_version(),
        platform.machine(),
    ]
    used = [Path(m.__file__ or "").read_text(encoding="utf-8") for m in (intrinsics, vectors, *uses)]
    basis = [source, *versions, *used]
    name = "motes_" + hashlib.sha256("\0".join(basis).encode()).hexdigest()[:24]
    folder = cache_folder()
    try:
        return _imported(source, name, title, folder, f"kept in {folder}")
    except Exception as error:  # not writable, full, or holding something broken
        logging.getLogger(__name__).info("the cache folder %s cannot be used: %s", folder, error)
        for broken in (folder / "__pycache__").glob(f"{name}.*"):
            with contextlib.suppress(OSError):
                broken.unlink()
    temporary = Path(tempfile.mkdtemp(prefix="motes-"))
    atexit.register(shutil.rmtree, temporary, ignore_errors=True)
    return _imported(source, name, title, temporary, f"not kept: {folder} cannot be used")


def _imported(source: str, name: str, title: str, folder: Path, kept: str) -> Any:
    path = folder / f"{name}.py"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    if not path.exists() or path.read_text(encoding="utf-8") != source:
        handle, temporary = tempfile.mkstemp(prefix=f".{name}.", suffix=".tmp", dir=folder)
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(source)
            os.replace(temporary, path)
        except BaseException:
            Path(temporary).unlink(missing_ok=True)
            raise
    if not any((folder / "__pycache__").glob(f"{name}.*.nbi")):
        sentence = f"compiling {title} once ({kept})"
        logging.getLogger(__name__).info(sentence)
        if on_compile is not None:
            on_compile(sentence)
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # Numba looks for the functions of a cached kernel by the name of their module
    spec.loader.exec_module(module)
    return module
