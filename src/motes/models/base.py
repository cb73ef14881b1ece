"""`BRDF`: what every model offers: `eval`, `sample`, `pdf`, `directional_albedo`, `spherical_albedo`, and ``+``; and `Sum`.

A model declares its facts in its own file, and nobody asks for its name or its type: parameters and parts with their roles and
places (`motes.parameters`), what kind of reflection each `Component` is, its words, and the lobes that other programs know.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple, Self, final

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY, Array, is_foreign, namespace
from motes.directions import LONGEST, Geometry, Vector
from motes.errors import DataError, ParameterError
from motes.graph.recording import Kind
from motes.kernels import engine, immediate
from motes.models.albedo import directional_albedo
from motes.models.components import Component, Piece, Reflecting
from motes.models.lifting import averaged, broadcast, leading, lifted, matching
from motes.models.lobes import Reflection
from motes.models.standard import StandardLobe
from motes.parameters import Place, part


class Sampled(NamedTuple):
    """What `BRDF.sample` returns."""

    wo: Array
    pdf: Array
    weight: Array


@dataclass(frozen=True, eq=False)
class BRDF(Reflecting, ABC):
    """A reflectance model with its parameters: an immutable value.

    Parameters may be numbers, NumPy arrays, or tensors of PyTorch or JAX.  The last axis of a per-channel parameter
    (``K_d``, ``w``, ...) is the channels; all other axes broadcast against the directions."""

    #: False when eval(wi, wo) differs from eval(wo, wi).
    reciprocal: ClassVar[bool] = True
    #: What people call it, in a report: "Oren-Nayar".  The name of the class where it is empty.
    words: ClassVar[str] = ""
    #: What becomes of it in programs that take lobes and not formulas: the conversion of `standard_lobes` and what it loses, in a
    #: sentence that those files say.  Empty where nothing is lost.
    approximation: ClassVar[str] = "A model without standard lobes of its own: a diffuse lobe of its spherical albedo."

    # ------------------------------------------------------------ what a model defines

    @abstractmethod
    def formula(self, xp: Array, geometry: Geometry) -> Array:
        """The BRDF [1/sr], elementwise, where both directions are above the horizon."""

    # ------------------------------------------------------------ what a model may say besides

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        """The lobes that other programs know whose sum comes nearest: for closures, node graphs and stock plugins.

        Parameters
        ----------
        xp
            Namespace for what arithmetic alone does not say, such as ``xp.exp``.
        values
            This model once more, with what stands for its parameters: numbers, or symbols that are printed in another language.
            A fact that is a number in any case, such as an option, is read from `self`.
        cos_view
            The cosine towards the viewer where the program knows it, else a mean (`motes.models.standard.MEAN_COSINE`).

        Returns
        -------
        list of StandardLobe
            Without an own declaration one diffuse lobe of the spherical albedo.
        """
        return [StandardLobe(Reflection.DIFFUSE, 1.0, tint=tuple(float(a) for a in self.spherical_albedo()))]

    def printed_highlight(self, strength: Array, width: Array) -> tuple[Array, Array] | None:
        """K_s and sigma_s of equations (9)-(11) for values of the strength and the width of this model's own highlight.

        None unless its highlight is that one, with F = 1: for layouts that hold no other.
        """
        return None

    def in_words(self) -> str:
        """The model as reports name it: ``(Oren-Nayar + Torrance-Sparrow) under dust``."""
        own = self.words or type(self).__name__
        terms = [f"with {type(term).__name__} Fresnel" for term in self.at_place(Place.FRESNEL)]
        return " ".join([own, *terms])

    def terms(self) -> tuple[BRDF, ...]:
        """The BRDFs whose sum this is: itself alone, unless it is a sum."""
        return (self,)

    def pieces(self) -> tuple[BRDF | Piece, ...]:
        """What a layer of dust above tells apart of a term: its highlights, and the rest."""
        return (self,)

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

        Raises
        ------
        DataError
            When a component of a direction in a NumPy array is beyond 1.01: no unit vector has it.

        Examples
        --------
        >>> from motes import Lambert
        >>> Lambert(K_d=(0.5, 0.25)).eval([0, 0, 1], [0, 0.6, 0.8]).round(4)
        array([0.1592, 0.0796])
        """
        found, wi, wo, xp = self._recorded(Kind.VALUE, wi, wo)
        if found is not None:
            return found[0]
        model = lifted(self, xp, wi)
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
        found, wi, u, xp = self._recorded(Kind.SAMPLE, wi, u)
        if found is not None:
            return Sampled(*found)
        shape = np.broadcast_shapes(tuple(wi.shape[:-1]), tuple(u.shape[:-1]))
        wi = broadcast(wi, (*shape, 3))
        mean = averaged(self, wi)
        with np.errstate(all="ignore"):
            wo = mean.drawn(xp, wi, u)
            pdf = self.pdf(wi, wo)
            return Sampled(wo, pdf, self.eval(wi, wo) * mean.weighing(xp, wo, pdf)[..., None])

    def pdf(self, wi: Array, wo: Array) -> Array:
        """The density with which `sample` chooses ``wo`` [1/sr]; shape (...).

        It integrates to 1 less the share of samples lost below the horizon.
        """
        found, wi, wo, xp = self._recorded(Kind.DENSITY, wi, wo)
        if found is not None:
            return found[0]
        with np.errstate(all="ignore"):
            return averaged(self, wi).density(xp, wi, wo)

    def directional_albedo(self, wi: Array, *, nodes: tuple[int, int] = (48, 64)) -> Array:
        """The share of light from ``wi`` that the surface reflects: the integral of eval cos(theta_r) over ``wo``.

        Each component is integrated in the coordinates of its own lobe: Gauss-Legendre along the polar angle, equal
        steps in azimuth, or Gauss-Legendre along two slopes. About four digits with the default number of `nodes`; not the same as K_d, and for the models
        as printed it may exceed 1.

        Parameters
        ----------
        wi
            Unit vectors (..., 3).
        nodes
            Numbers of steps in the polar angle and in azimuth, or in the slopes.

        Returns
        -------
        array (..., C)
        """
        wi, _, xp, _ = self._prepared(wi, wi)
        return directional_albedo(self, self.channels, xp, wi, nodes)

    def spherical_albedo(self, *, nodes: int = 32) -> NDArray[np.float64]:
        """The share of uniform light from the hemisphere that is reflected; shape (C,).  NumPy parameters only."""
        x, weights = np.polynomial.legendre.leggauss(nodes)
        theta = 0.25 * np.pi * (x + 1)
        wi = np.stack([np.sin(theta), 0 * theta, np.cos(theta)], -1)
        measure = 0.25 * np.pi * weights * np.sin(2 * theta)
        return np.asarray(np.sum(self.directional_albedo(wi) * measure[:, None], axis=0))

    def __add__(self, other: BRDF) -> Sum:
        """Light reflected by either: the sum of the two BRDFs."""
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

    def _recorded(self, kind: Kind, a: Array, b: Array) -> tuple[list[Array] | None, Array, Array, Array]:
        """What a recorded formula gives for NumPy's arrays: few at once, many through the engine.

        None where none serves, for then the equations run as they stand; with the inputs as arrays, and their namespace.
        """
        found = immediate.call(kind, self, a, b, engine.threshold(kind))
        if found is not None:
            return found, a, b, NUMPY
        a, b, xp, shape = self._prepared(a, b, (3, 2) if kind is Kind.SAMPLE else (3, 3))
        if xp is NUMPY:
            # What counts is how many pairs there are once all shapes are broadcast: an outer product is small in each factor.
            large = math.prod(shape) >= engine.threshold(kind) and engine.serves(kind, self)
            found = engine.call(kind, self, a, b) if large else immediate.call(kind, self, a, b)
        return found, a, b, xp

    def _prepared(
        self, a: Array, b: Array, last: tuple[int, int] = (3, 3)
    ) -> tuple[Array, Array, Array, tuple[int, ...]]:
        """Both inputs as arrays of one library, its namespace, and the shape to which they and the parameters broadcast."""
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
                except (TypeError, ValueError, OverflowError):
                    raise DataError(f"{what} are not numbers: {str(x)[:80]}", f"Pass arrays (..., {n})") from None
                if what == "directions":
                    _check_lengths(x)
                if foreign is not None:
                    x = matching(x, foreign)
            if len(x.shape) == 0 or x.shape[-1] != n:
                raise DataError(
                    f"{what} of shape {tuple(x.shape)}: the last axis must have length {n}", f"Pass arrays (..., {n})"
                )
            prepared.append(x)
        shapes = [tuple(x.shape[:-1]) for x in prepared] + leading(self)
        try:
            shape = np.broadcast_shapes(*shapes)
        except ValueError:
            listed = ", ".join(str(shape) for shape in dict.fromkeys(shapes) if shape)
            raise DataError(
                f"{type(self).__name__}: shapes that do not broadcast: {listed}",
                "All but the last axis of directions, random numbers and parameters must match, or be 1 or absent",
            ) from None
        return prepared[0], prepared[1], xp, shape

    # ------------------------------------------------------------ sampling; parameters broadcast against (...): see `averaged`

    def drawn(self, xp: Array, wi: Array, u: Array) -> Array:
        """Directions (..., 3) that `sample` chooses."""
        components, chances = self._chances(xp, wi)
        u0, u1 = u[..., 0], u[..., 1]
        start: Array = 0.0
        wo: Array = None
        for component, chance in zip(components, chances, strict=True):
            inside = (u0 - start) / xp.maximum(chance, 1e-30)
            inside = xp.maximum(xp.minimum(inside, 1 - 1e-7), 0.0)
            candidate = component.lobe.sample(xp, wi, xp.stack([inside, u1 + 0 * inside]))
            if wo is not None:
                chosen = u0 >= start
                candidate = xp.stack([xp.where(chosen, candidate[..., k], wo[..., k]) for k in range(3)])
            wo, start = candidate, start + chance
        return wo

    def density(self, xp: Array, wi: Array, wo: Array) -> Array:
        """The density (...) of `drawn` [1/sr]."""
        components, chances = self._chances(xp, wi)
        total: Array = 0.0
        for component, chance in zip(components, chances, strict=True):
            total = total + chance * component.lobe.pdf(xp, wi, wo)
        return Geometry(xp, Vector.split(wi), Vector.split(wo)).above_horizon(total)

    def weighing(self, xp: Array, wo: Array, density: Array) -> Array:
        """The factor (...) of the value in the weight of a sample: its cosine over its density."""
        return xp.where(density > 0, xp.maximum(wo[..., 2], 0.0) / xp.maximum(density, 1e-30), 0.0)

    def _chances(self, xp: Array, wi: Array) -> tuple[list[Component], list[Array]]:
        """The components, and the chance that `sample` takes each."""
        components = self.components(xp, xp.maximum(wi[..., 2], 1e-4))
        total: Array = 1e-30
        for component in components:
            total = total + component.importance
        return components, [(c.importance + 1e-30 / len(components)) / total for c in components]


def _check_lengths(w: NDArray[Any]) -> None:
    """Refuse what is far too long for a unit vector, and would overflow in one way here and in another in the engine; NaN may pass."""
    if w.size == 0:
        return
    largest = max(w.max(), -w.min())
    if np.isnan(largest):
        largest = np.abs(w[~np.isnan(w)]).max(initial=0.0)
    if largest > LONGEST:
        raise DataError(
            f"a direction has a component of {largest:.4g}: directions are unit vectors",
            "Divide each by its length: w / np.linalg.norm(w, axis=-1, keepdims=True)",
        )


@final
@dataclass(frozen=True, eq=False)
class Sum(BRDF):
    """Light reflected by ``a``, and by ``b`` besides: what ``a + b`` makes."""

    approximation: ClassVar[str] = ""

    a: BRDF = part(BRDF, place=Place.TERM, advice="A Fresnel term goes inside: TorranceSparrow(fresnel=...)")
    b: BRDF = part(BRDF, place=Place.TERM, advice="A Fresnel term goes inside: TorranceSparrow(fresnel=...)")

    @property
    def reciprocal(self) -> bool:  # type: ignore[override]
        return self.a.reciprocal and self.b.reciprocal

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.a.formula(xp, geometry) + self.b.formula(xp, geometry)

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return self.a.components(xp, cos_theta_i) + self.b.components(xp, cos_theta_i)

    def reflected(self, xp: Array, cos_theta_i: Array) -> Array:
        return self.a.reflected(xp, cos_theta_i) + self.b.reflected(xp, cos_theta_i)

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        a, b = self.a.standard_lobes(xp, values.a, cos_view), self.b.standard_lobes(xp, values.b, cos_view)
        return a + b

    def terms(self) -> tuple[BRDF, ...]:
        return (*self.a.terms(), *self.b.terms())

    def in_words(self) -> str:
        return f"{self.a.in_words()} + {self.b.in_words()}"
