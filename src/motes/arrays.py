"""Array namespaces: the functions that the models need, for every library whose arrays Motes accepts.

Formulas are written over a namespace ``xp`` that offers ``sqrt, exp, expm1, log1p, asin, minimum, maximum, where`` (and
arithmetic and comparisons on its arrays), nothing else.  Sampling needs ``sin, cos, log`` and ``stack`` too, and the
losses of fits, over NumPy, ``cbrt``.
`namespace` chooses from the types of the inputs, so that NumPy in means NumPy out, and a tensor in means a tensor of
the same library, with its gradient, out.

There is no ``acos``: see `motes.directions.polar_angle` for why angles are taken through ``asin``.
"""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np

# Any of: float, numpy.ndarray, torch.Tensor, jax.Array, a Dr.Jit array, motes.graph.symbols.Symbol.
Array = Any


#: Types of Python's numbers, which have no precision of their own.
_NUMBERS = frozenset((float, int, bool))


def _weak(function: Any) -> Any:
    """The NumPy function; Python numbers in give a Python number out, which leaves float32 arrays as they are."""

    def weak(first: Array, *others: Array) -> Array:
        result = function(first, *others)
        if type(first) not in _NUMBERS:  # as a rule, and it is asked hundreds of times a call
            return result
        return float(result) if all(type(x) in _NUMBERS for x in others) else result

    return weak


NUMPY = SimpleNamespace(
    name="numpy",
    sqrt=_weak(np.sqrt),
    exp=_weak(np.exp),
    expm1=_weak(np.expm1),
    asin=_weak(np.arcsin),
    log1p=_weak(np.log1p),
    cbrt=_weak(np.cbrt),
    minimum=_weak(np.minimum),
    maximum=_weak(np.maximum),
    where=_weak(np.where),
    sin=_weak(np.sin),
    cos=_weak(np.cos),
    log=_weak(np.log),
    stack=lambda parts: np.stack(np.broadcast_arrays(*parts), axis=-1),
)


def any_last(truths: Array) -> Array:
    """Where anything is true (or not 0) along the last axis of a NumPy array (..., C); few columns are taken in turn, ten times as fast."""
    if not 0 < truths.shape[-1] <= 8:
        return truths.any(axis=-1)
    found = truths[..., 0] != 0
    for k in range(1, truths.shape[-1]):
        found |= truths[..., k] != 0
    return found


# OpenBLAS shares the product of longer vectors among threads of its own, which then wait busily for more: in the way of those of this process.
_OF_ONE_THREAD = 8192


def dot(a: Array, b: Array) -> float:
    """The sum of the products of two arrays of NumPy's of one shape, by this thread alone."""
    left, right = a.reshape(-1), b.reshape(-1)
    rows = range(0, left.size, _OF_ONE_THREAD)
    return math.fsum(float(left[k : k + _OF_ONE_THREAD] @ right[k : k + _OF_ONE_THREAD]) for k in rows)


# Of many numbers so many are drawn to tell about where one of them would stand; and how far off it may be among the drawn, some three standard deviations.
_DRAWN, _BESIDE = 2048, 72


def sorted_part(numbers: Array, first: int, last: int) -> Array:
    """What would stand from `first` to `last` if an array (n,) of NumPy's were sorted, in any order.

    Of many numbers a few, evenly drawn, tell between which these are, as a rule, and there are few of those: a quarter of the time of
    `numpy.partition`, which is asked where they do not.
    """
    if len(numbers) >= 4 * _DRAWN:
        drawn = np.sort(numbers[:: len(numbers) // _DRAWN])
        each = len(numbers) / len(drawn)
        low = drawn[max(0, int(first / each - _BESIDE))]
        high = drawn[min(len(drawn) - 1, int(last / each + _BESIDE))]
        below = int(np.count_nonzero(numbers < low))
        between = numbers.compress((numbers >= low) & (numbers <= high))
        if below <= first <= last < below + len(between):
            first, last, numbers = first - below, last - below, between
    return np.partition(numbers, (first, last))[first : last + 1]


def median(numbers: Array) -> float:
    """The median of an array (n,) of NumPy's without NaN, n at least 1."""
    first, last = (len(numbers) - 1) // 2, len(numbers) // 2
    return float(sorted_part(numbers, first, last).mean())


def _torch() -> SimpleNamespace:
    import torch

    def like(a: Array, b: Array) -> tuple[Array, Array]:
        """Both as tensors: torch.minimum does not take Python numbers."""
        if not isinstance(a, torch.Tensor):
            a = torch.as_tensor(a, dtype=b.dtype, device=b.device)
        if not isinstance(b, torch.Tensor):
            b = torch.as_tensor(b, dtype=a.dtype, device=a.device)
        return a, b

    def pairwise(tensors: Any, numbers: Any) -> Any:
        return lambda a, b: (
            tensors(*like(a, b)) if isinstance(a, torch.Tensor) or isinstance(b, torch.Tensor) else numbers(a, b)
        )

    def lifted(function: Any) -> Any:
        """The function on tensors; a number becomes a float64 tensor of no dimension, which never promotes."""
        return lambda x: function(x if isinstance(x, torch.Tensor) else torch.tensor(float(x), dtype=torch.float64))

    def root(x: Any) -> Any:
        """A square root whose derivative at 0 is 0: an infinite one becomes NaN where the chain rule multiplies it by 0."""
        zero = x == 0
        return torch.where(zero, 0 * x, torch.sqrt(torch.where(zero, 1.0, x)))

    return SimpleNamespace(
        name="torch",
        sqrt=lifted(root),
        exp=lifted(torch.exp),
        expm1=lifted(torch.expm1),
        log1p=lifted(torch.log1p),
        asin=lifted(torch.asin),
        minimum=pairwise(torch.minimum, min),
        maximum=pairwise(torch.maximum, max),
        where=lambda c, a, b: torch.where(c, a, b) if isinstance(c, torch.Tensor) else (a if c else b),
        sin=lifted(torch.sin),
        cos=lifted(torch.cos),
        log=lifted(torch.log),
        stack=lambda parts: torch.stack(torch.broadcast_tensors(*parts), dim=-1),
    )


def _jax() -> SimpleNamespace:
    import jax.numpy as jnp

    def root(x: Array) -> Array:
        """See `_torch`."""
        zero = jnp.equal(x, 0)
        return jnp.where(zero, 0 * x, jnp.sqrt(jnp.where(zero, 1, x)))

    return SimpleNamespace(
        name="jax",
        sqrt=root,
        exp=jnp.exp,
        expm1=jnp.expm1,
        log1p=jnp.log1p,
        asin=jnp.arcsin,
        minimum=jnp.minimum,
        maximum=jnp.maximum,
        where=jnp.where,
        sin=jnp.sin,
        cos=jnp.cos,
        log=jnp.log,
        stack=lambda parts: jnp.stack(jnp.broadcast_arrays(*parts), axis=-1),
    )


class Columns(tuple[Array, ...]):
    """Components that are asked for like those of an array (..., n), ``w[..., 0]``: Dr.Jit keeps each in a variable."""

    __slots__ = ()

    def __getitem__(self, key: Any) -> Array:
        return super().__getitem__(key[-1] if isinstance(key, tuple) else key)


def _drjit() -> SimpleNamespace:
    import drjit as dr

    def root(x: Array) -> Array:
        """See `_torch`; the value is that of sqrt itself, and without a gradient so is the cost."""
        if not dr.grad_enabled(x):
            return dr.sqrt(x)
        return dr.replace_grad(dr.sqrt(x), dr.sqrt(dr.maximum(x, 1e-30)))

    def expm1(x: Array) -> Array:
        """Dr.Jit has no expm1: near 0 a series, beyond exp(x) - 1, whose exp a layer needs anyway. Within 4 ulp."""
        if isinstance(x, float):
            return math.expm1(x)
        last = 8 if dr.itemsize_v(x) == 4 else 14  # the next term is below an ulp at |x| = 0.35
        series = 0 * x + 1 / math.factorial(last)
        for k in range(last - 1, 0, -1):
            series = dr.fma(series, x, 1 / math.factorial(k))
        near = abs(x) < 0.35
        return dr.select(near, series * x, dr.exp(x) - 1)

    def log1p(x: Array) -> Array:
        """Dr.Jit has no log1p: log(u) x / (u - 1) with u = 1 + x as it is rounded, whose error cancels (Kahan)."""
        if isinstance(x, float):
            return math.log1p(x)
        u = 1 + dr.detach(x)
        exact = u == 1
        value = dr.select(exact, dr.detach(x), dr.log(u) * (dr.detach(x) / dr.select(exact, 1, u - 1)))
        return dr.replace_grad(value, dr.log(1 + x)) if dr.grad_enabled(x) else value

    return SimpleNamespace(
        name="drjit",
        sqrt=root,
        exp=dr.exp,
        expm1=expm1,
        log1p=log1p,
        asin=dr.asin,
        # As quick as dr.minimum and dr.maximum, and of equal numbers the first is taken and gets the gradient:
        # maximum(f, 0) of a black surface has one.
        minimum=lambda a, b: dr.select(a > b, b, a),
        maximum=lambda a, b: dr.select(a < b, b, a),
        where=dr.select,
        # Where both are asked for, Dr.Jit computes once what they share.
        sin=lambda x: dr.sincos(x)[0],
        cos=lambda x: dr.sincos(x)[1],
        log=dr.log,
        stack=Columns,
    )


_FACTORIES = {"torch": _torch, "jax": _jax, "jaxlib": _jax, "drjit": _drjit, "mitsuba": _drjit}
_made: dict[str, SimpleNamespace] = {}


def _library(x: Array) -> str | None:
    if isinstance(x, (np.ndarray, np.generic, float, int, tuple, list)) or x is None:
        return None
    root = type(x).__module__.split(".")[0]
    return root if root in _FACTORIES else None


def namespace(*arrays: Array) -> Any:
    """The namespace of the first array that is not NumPy's: a tensor's library, a symbol's graph, or NumPy.

    Parameters
    ----------
    *arrays
        Inputs of an evaluation: directions and parameters, of any shapes.
    """
    for x in arrays:
        graph = getattr(x, "graph", None)  # motes.graph.symbols.Symbol
        if graph is not None and hasattr(graph, "leaf"):
            return graph
        library = _library(x)
        if library is not None:
            if library not in _made:
                _made[library] = _FACTORIES[library]()
            return _made[library]
    return NUMPY


def is_foreign(x: Array) -> bool:
    """True for tensors, symbols and traced values: what NumPy must not convert, copy or inspect."""
    return (hasattr(x, "graph") and hasattr(x.graph, "leaf")) or _library(x) is not None
