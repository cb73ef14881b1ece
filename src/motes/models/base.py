"""`BRDF`: what every model offers: `eval`, `sample`, `pdf`, `directional_albedo`, `spherical_albedo`, and ``+``."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from copy import copy
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY, Array, is_foreign, namespace
from motes.directions import Geometry, Vector
from motes.errors import DataError, ParameterError
from motes.models.lobes import Lobe
from motes.parameters import Parametrised

if TYPE_CHECKING:
    from motes.models.sums import Sum

P = TypeVar("P", bound=Parametrised)


class Sampled(NamedTuple):
    """What `BRDF.sample` returns."""

    wo: Array
    pdf: Array
    weight: Array


@dataclass(frozen=True)
class Component:
    """A part of a BRDF with the lobe that samples it.

    ``formula(xp, geometry)`` is the part's value [1/sr]; ``importance`` is about the share of light it reflects, a
    number or an array that broadcasts against directions."""

    formula: Callable[[Array, Geometry], Array]
    lobe: Lobe
    importance: Array


@dataclass(frozen=True, eq=False)
class BRDF(Parametrised, ABC):
    """A reflectance model with its parameters: an immutable value.

    Parameters may be numbers, NumPy arrays, or tensors of PyTorch or JAX.  The last axis of a per-channel parameter
    (``K_d``, ``w``, ...) is the channels; all other axes broadcast against the directions."""

    #: False when eval(wi, wo) differs from eval(wo, wi).
    reciprocal: ClassVar[bool] = True

    # ------------------------------------------------------------ what a model defines

    @abstractmethod
    def formula(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr], elementwise, where both directions are above the horizon."""

    @abstractmethod
    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        """The parts that are sampled and integrated each in its own way; their formulas add up to `formula`."""

    # ------------------------------------------------------------ what users call

    def eval(self, wi: Array, wo: Array) -> Array:
        """The BRDF [1/sr], without the cosine.

        Parameters
        ----------
        wi, wo
            Unit vectors (..., 3) to the light and to the viewer, away from the surface, z the normal; they broadcast.
            NumPy arrays, or tensors of PyTorch or JAX; large NumPy arrays go through the compiled engine.

        Returns
        -------
        array (..., C)
            Exactly 0 where a direction is at or below the horizon; NaN where a direction is NaN.

        Examples
        --------
        >>> from motes import Lambert
        >>> Lambert(K_d=(0.5, 0.25)).eval([0, 0, 1], [0, 0.6, 0.8]).round(4)
        array([0.1592, 0.0796])
        """
        wi, wo, xp = self._prepared(wi, wo)
        if xp is NUMPY:
            from motes.kernels import engine

            if max(wi.size, wo.size) >= 3 * engine.THRESHOLD and engine.available():
                return engine.evaluate(self, wi, wo)
        model = self._lifted(xp, wi)
        geometry = Geometry(xp, Vector.of(wi), Vector.of(wo))
        with np.errstate(all="ignore"):  # directions below the horizon are computed, then masked
            return model.value(xp, geometry)

    def sample(self, wi: Array, u: Array) -> Sampled:
        """Choose outgoing directions about where the BRDF times the cosine is large.

        Parameters
        ----------
        wi
            Unit vectors (..., 3) to the light.
        u
            Uniform random numbers (..., 2) in [0, 1).

        Returns
        -------
        wo (..., 3), pdf (...) per solid angle [1/sr], weight (..., C) = eval(wi, wo) cos(theta_r) / pdf
            A sample below the horizon has weight 0 and pdf 0: its energy is lost.
        """
        wi, u, xp = self._prepared(wi, u, last=(3, 2))
        shape = np.broadcast_shapes(tuple(wi.shape[:-1]), tuple(u.shape[:-1]))
        wi = _broadcast(wi, (*shape, 3))
        with np.errstate(all="ignore"):
            components, chances = self._chances(xp, wi)
            u0, u1 = u[..., 0], u[..., 1]
            start: Array = 0.0
            wo: Array = None
            for component, chance in zip(components, chances, strict=True):
                inside = (u0 - start) / xp.maximum(chance, 1e-30)
                inside = xp.maximum(xp.minimum(inside, 1 - 1e-7), 0.0)
                candidate = component.lobe.sample(xp, wi, xp.stack([inside, u1 + 0 * inside]))
                wo = candidate if wo is None else xp.where((u0 >= start)[..., None], candidate, wo)
                start = start + chance
            pdf = self.pdf(wi, wo)
            cos_theta_r = xp.maximum(wo[..., 2], 0.0)
            scale = xp.where(pdf > 0, cos_theta_r / xp.maximum(pdf, 1e-30), 0.0)
            return Sampled(wo, pdf, self.eval(wi, wo) * scale[..., None])

    def pdf(self, wi: Array, wo: Array) -> Array:
        """The density with which `sample` chooses ``wo`` [1/sr]; shape (...).

        It integrates to 1 less the share of samples lost below the horizon.
        """
        wi, wo, xp = self._prepared(wi, wo)
        with np.errstate(all="ignore"):
            components, chances = self._chances(xp, wi)
            total: Array = 0.0
            for component, chance in zip(components, chances, strict=True):
                total = total + chance * component.lobe.pdf(xp, wi, wo)
            return Geometry(xp, *(Vector(w[..., 0], w[..., 1], w[..., 2]) for w in (wi, wo))).above_horizon(total)

    def directional_albedo(self, wi: Array, *, nodes: tuple[int, int] = (48, 64)) -> Array:
        """The share of light from ``wi`` that the surface reflects: the integral of eval cos(theta_r) over ``wo``.

        Each component is integrated in the coordinates of its own lobe: Gauss-Legendre along the polar angle, equal
        steps in azimuth. About four digits with the default number of `nodes`; not the same as K_d, and for the models
        as printed it may exceed 1.

        Parameters
        ----------
        wi
            Unit vectors (..., 3).
        nodes
            Numbers of steps in the polar angle and in azimuth.

        Returns
        -------
        array (..., C)
        """
        wi, _, xp = self._prepared(wi, wi)
        shape = np.broadcast_shapes(tuple(wi.shape[:-1]), *self._leading())
        if xp is NUMPY and np.prod(shape) > 256:  # a bounded number of pairs at a time
            flat = np.broadcast_to(wi, (*shape, 3)).reshape(-1, 3)
            parts = [
                self._at(shape, k, k + 256).directional_albedo(flat[k : k + 256], nodes=nodes)
                for k in range(0, len(flat), 256)
            ]
            return np.concatenate(parts).reshape(*shape, -1)
        polar, weights = np.polynomial.legendre.leggauss(nodes[0])
        grid = np.stack(
            np.meshgrid(0.5 * (polar + 1), (np.arange(nodes[1]) + 0.5) / nodes[1], indexing="ij"), -1
        ).reshape(-1, 2)
        grid_weights = np.repeat(0.5 * weights / nodes[1], nodes[1])
        u, grid_weights = _like(grid, wi), _like(grid_weights, wi)
        wi = _broadcast(wi[..., None, :], (*wi.shape[:-1], len(grid), 3))
        with np.errstate(all="ignore"):
            # The same parts twice: with channels for their formulas, without for their lobes.
            formulas = [part.formula for part in self._lifted(xp, wi, extra_axes=1).components(xp, 1.0)]
            lobes = [part.lobe for part in self._averaged(wi, extra_axes=1).components(xp, 1.0)]
            total: Array = 0.0
            for formula, lobe in zip(formulas, lobes, strict=True):
                wo = lobe.sample(xp, wi, _broadcast(u, (*wi.shape[:-1], 2)))
                geometry = Geometry(xp, Vector.of(wi), Vector.of(wo))
                value = geometry.above_horizon(formula(xp, geometry))
                pdf = lobe.pdf(xp, wi, wo)[..., None]
                cosine = xp.maximum(wo[..., 2:3], 0.0)
                ratio = xp.where(pdf > 0, value * cosine / xp.maximum(pdf, 1e-30), 0.0)
                total = total + (ratio * grid_weights[:, None]).sum(-2)
        return total

    def spherical_albedo(self, *, nodes: int = 32) -> NDArray[np.float64]:
        """The share of uniform light from the hemisphere that is reflected; shape (C,).  NumPy parameters only."""
        x, weights = np.polynomial.legendre.leggauss(nodes)
        theta = 0.25 * np.pi * (x + 1)
        wi = np.stack([np.sin(theta), 0 * theta, np.cos(theta)], -1)
        measure = 0.25 * np.pi * weights * np.sin(2 * theta)
        return np.sum(self.directional_albedo(wi) * measure[:, None], axis=0)

    def __add__(self, other: BRDF) -> Sum:
        """Light reflected by either: the sum of the two BRDFs."""
        from motes.models.sums import Sum

        return Sum(self, other) if isinstance(other, BRDF) else NotImplemented

    # ------------------------------------------------------------ shared by the models

    def value(self, xp: Array, geometry: Geometry) -> Array:
        """`formula` above the horizon, 0 elsewhere; what the engine traces."""
        return geometry.above_horizon(self.formula(xp, geometry))

    def _channel_counts(self) -> dict[str, int]:
        """The length of the last axis of the per-channel parameters that are arrays."""
        arrays = {slot.name: slot.value for slot in self.slots() if slot.parameter.per_channel}
        return {name: value.shape[-1] for name, value in arrays.items() if len(getattr(value, "shape", ()))}

    @property
    def channels(self) -> int:
        """The number of channels: the longest last axis of the per-channel parameters, or 1."""
        return max(self._channel_counts().values(), default=1)

    def check_channels(self) -> None:
        """Raise `ParameterError` when two parameters disagree on the number of channels."""
        counts = self._channel_counts()
        several = {name: n for name, n in counts.items() if n != 1}
        if len(set(several.values())) > 1:
            listed = ", ".join(f"{name} has {n}" for name, n in several.items())
            raise ParameterError(
                f"{type(self).__name__}: parameters disagree on the number of channels: {listed}",
                "The last axis of a per-channel parameter is the channels; give one value, or as many as the others",
            )

    def __post_init__(self) -> None:
        super().__post_init__()
        self.check_channels()

    def _prepared(self, a: Array, b: Array, last: tuple[int, int] = (3, 3)) -> tuple[Array, Array, Array]:
        """Both inputs as arrays of one library, and its namespace."""
        values = [slot.value for slot in self.slots()]
        xp = namespace(a, b, *values)
        foreign = next((x for x in (a, b, *values) if is_foreign(x)), None)
        prepared = []
        for x, n, what in (
            (a, last[0], "directions"),
            (b, last[1], "directions" if last[1] == 3 else "random numbers"),
        ):
            if not is_foreign(x):
                try:
                    x = np.asarray(x)
                    if x.dtype not in (np.float32, np.float64):
                        x = x.astype(np.float64)
                except (TypeError, ValueError):
                    raise DataError(f"{what} are not numbers: {str(x)[:80]}", f"Pass arrays (..., {n})") from None
                if foreign is not None:
                    x = _like(x, foreign)
            if len(x.shape) == 0 or x.shape[-1] != n:
                raise DataError(
                    f"{what} of shape {tuple(x.shape)}: the last axis must have length {n}", f"Pass arrays (..., {n})"
                )
            prepared.append(x)
        shapes = [tuple(x.shape[:-1]) for x in prepared] + self._leading()
        try:
            np.broadcast_shapes(*shapes)
        except ValueError:
            listed = ", ".join(str(shape) for shape in dict.fromkeys(shapes) if shape)
            raise DataError(
                f"{type(self).__name__}: shapes that do not broadcast: {listed}",
                "All but the last axis of directions, random numbers and parameters must match, or be 1 or absent",
            ) from None
        return prepared[0], prepared[1], xp

    def _leading(self) -> list[tuple[int, ...]]:
        """The shapes of the parameters without their channels: what must broadcast against the directions."""
        shapes = [(tuple(getattr(s.value, "shape", ())), s.parameter.per_channel) for s in self.slots()]
        return [shape[:-1] if per_channel else shape for shape, per_channel in shapes]

    def _at(self, shape: tuple[int, ...], start: int, stop: int) -> Self:
        """A copy with the parameters of the directions `start` to `stop` in the flattened `shape`."""
        changes = {}
        for slot, leading in zip(self.slots(), self._leading(), strict=True):
            if leading:
                last = slot.value.shape[len(leading) :]
                changes[slot.path] = np.broadcast_to(slot.value, (*shape, *last)).reshape(-1, *last)[start:stop]
        return _unchecked(self, changes)

    def _lifted(self, xp: Array, like: Array, extra_axes: int = 0) -> Self:
        """A copy whose values broadcast against geometry of shape (..., 1): shared values get the channel axis, all the
        library and type.

        `extra_axes` are inserted between the axes of the directions and the channels.
        """
        changes = {}
        for slot in self.slots():
            value = slot.value
            if isinstance(value, float):
                continue
            if not is_foreign(value) or xp is not NUMPY:
                value = _like(value, like)
            shape = tuple(value.shape)
            if not shape:
                changes[slot.path] = value
                continue
            if not slot.parameter.per_channel:
                value = value[..., None]
            for _ in range(extra_axes if len(value.shape) > 1 else 0):
                value = value[..., None, :]
            changes[slot.path] = value
        return _unchecked(self, changes)

    def _averaged(self, like: Array, extra_axes: int = 0) -> Self:
        """A copy whose values broadcast against (...): means over the channels; `extra_axes` follow the directions."""
        changes = {}
        for slot in self.slots():
            value = slot.value
            if isinstance(value, float):
                continue
            value = _like(value, like)
            if slot.parameter.per_channel and len(value.shape):
                value = value.mean(-1)
            for _ in range(extra_axes if len(value.shape) else 0):
                value = value[..., None]
            changes[slot.path] = value
        return _unchecked(self, changes)

    def _chances(self, xp: Array, wi: Array) -> tuple[list[Component], list[Array]]:
        """The components with parameters that broadcast against (...), and the chance that `sample` takes each."""
        components = self._averaged(wi).components(xp, xp.maximum(wi[..., 2], 1e-4))
        total: Array = 1e-30
        for component in components:
            total = total + component.importance
        chances = [(component.importance + 1e-30 / len(components)) / total for component in components]
        return components, chances


def _unchecked(model: P, by_path: dict[tuple[str, ...], Array]) -> P:
    """A copy with values put in as they are: for values that were checked in another shape."""
    clone = copy(model)
    for path, value in by_path.items():
        if len(path) == 1:
            object.__setattr__(clone, path[0], value)
    for name, child in model.children().items():
        inner = {path[1:]: value for path, value in by_path.items() if len(path) > 1 and path[0] == name}
        if inner:
            object.__setattr__(clone, name, _unchecked(child, inner))
    return clone


def _like(x: Array, like: Array) -> Array:
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


def _broadcast(x: Array, shape: tuple[int, ...]) -> Array:
    xp = namespace(x)
    if xp.name == "torch":
        return x.expand(shape)
    if xp.name == "jax":
        import jax.numpy as jnp

        return jnp.broadcast_to(x, shape)
    return np.broadcast_to(x, shape)
