"""Values of parameters in the shapes in which formulas and lobes want them, for NumPy, PyTorch and JAX.

The last axis of a per-channel value is the channels; all other axes broadcast against the directions."""

from __future__ import annotations

from copy import copy
from typing import TypeVar

import numpy as np

from motes.arrays import NUMPY, Array, is_foreign, namespace
from motes.parameters import Parametrised

P = TypeVar("P", bound=Parametrised)


def leading(model: Parametrised) -> list[tuple[int, ...]]:
    """The shapes of the parameters without their channels: what must broadcast against the directions."""
    shapes = [(tuple(getattr(s.value, "shape", ())), s.parameter.per_channel) for s in model.slots()]
    return [shape[:-1] if per_channel else shape for shape, per_channel in shapes]


def sliced(model: P, shape: tuple[int, ...], start: int, stop: int) -> P:
    """A copy with the parameters of the directions `start` to `stop` in the flattened `shape`."""
    changes = {}
    for slot, axes in zip(model.slots(), leading(model), strict=True):
        if axes:
            last = slot.value.shape[len(axes) :]
            changes[slot.path] = np.broadcast_to(slot.value, (*shape, *last)).reshape(-1, *last)[start:stop]
    return unchecked(model, changes)


def lifted(model: P, xp: Array, like: Array, extra_axes: int = 0) -> P:
    """A copy whose values broadcast against geometry of shape (..., 1): shared values get the channel axis, all the
    library and type.

    `extra_axes` are inserted between the axes of the directions and the channels.
    """
    changes = {}
    for slot in model.slots():
        value = slot.value
        if isinstance(value, float):
            continue
        if not is_foreign(value) or xp is not NUMPY:
            value = matching(value, like)
        shape = tuple(value.shape)
        if not shape:
            changes[slot.path] = value
            continue
        if not slot.parameter.per_channel:
            value = value[..., None]
        for _ in range(extra_axes if len(value.shape) > 1 else 0):
            value = value[..., None, :]
        changes[slot.path] = value
    return unchecked(model, changes)


def averaged(model: P, like: Array, extra_axes: int = 0) -> P:
    """A copy whose values broadcast against (...): means over the channels; `extra_axes` follow the directions."""
    changes = {}
    for slot in model.slots():
        value = slot.value
        if isinstance(value, float):
            continue
        value = matching(value, like)
        if slot.parameter.per_channel and len(value.shape):
            value = value.mean(-1)
        for _ in range(extra_axes if len(value.shape) else 0):
            value = value[..., None]
        changes[slot.path] = value
    return unchecked(model, changes)


def unchecked(model: P, by_path: dict[tuple[str, ...], Array]) -> P:
    """A copy with values put in as they are: for values that were checked in another shape."""
    clone = copy(model)
    vars(clone).pop("_slots", None)  # those of the values before
    for path, value in by_path.items():
        if len(path) == 1:
            object.__setattr__(clone, path[0], value)
    for name, child in model.children().items():
        inner = {path[1:]: value for path, value in by_path.items() if len(path) > 1 and path[0] == name}
        if inner:
            object.__setattr__(clone, name, unchecked(child, inner))
    return clone


def matching(x: Array, like: Array) -> Array:
    """`x` in the library, type and device of `like`; tensors keep their gradients."""
    xp = namespace(like)
    if xp.name == "torch":
        import torch

        if isinstance(x, torch.Tensor):
            return x.to(dtype=like.dtype, device=like.device)
        return torch.as_tensor(np.array(x), dtype=like.dtype, device=like.device)
    if xp.name == "jax":
        import jax.numpy as jnp

        return jnp.asarray(x, dtype=like.dtype)
    return np.asarray(x, dtype=like.dtype)


def broadcast(x: Array, shape: tuple[int, ...]) -> Array:
    xp = namespace(x)
    if xp.name == "torch":
        return x.expand(shape)
    if xp.name == "jax":
        import jax.numpy as jnp

        return jnp.broadcast_to(x, shape)
    return np.broadcast_to(x, shape)
