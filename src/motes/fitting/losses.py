r"""What "close" means: the functions of f and cos(theta_i) whose differences a fit makes small, and the robust
versions.

A loss is a transform T; the residual of a sample is sqrt(weight) (T(fitted) - T(measured)).

=============  ==================================  ============================================================
``linear``     :math:`f \cos\theta_i`              what a light makes visible; finite at grazing (Ngan et al. 2005)
``plain``      :math:`f`                           the BRDF itself; dominated by grazing angles and the highlight
``log``        :math:`\log(1 + f \cos\theta_i)`    weighs the dim parts of glossy materials more (Löw 2012)
``cube_root``  :math:`(f \cos\theta_i)^{1/3}`      about the eye's lightness; between the two (Fores et al. 2012)
=============  ==================================  ==========================================================================
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.errors import MotesError

Floats = NDArray[np.float64]
# The cube root has an infinite slope at 0: below this f cos(theta_i) [1/sr] its slope is held, so that a model at
# exactly 0 can still move; with data in other units it goes with them.
SMALLEST = 1e-6


class Functions(Protocol):
    """The array namespace that losses are written over: `numpy`, or a graph (`motes.graph.tracing.Graph`)."""

    def sqrt(self, x: Any, /) -> Any: ...

    def log1p(self, x: Any, /) -> Any: ...

    def cbrt(self, x: Any, /) -> Any: ...

    def maximum(self, a: Any, b: Any, /) -> Any: ...

    def where(self, condition: Any, a: Any, b: Any, /) -> Any: ...


@dataclass(frozen=True)
class Loss:
    """A transform of the BRDF and its derivative by f, as formulas (`transformed`, `sloped`) of a namespace, of f [1/sr] and of cos(theta_i)."""

    name: str
    meaning: str
    transformed: Callable[[Functions, Array, Array], Array]
    sloped: Callable[[Functions, Array, Array], Array]

    def transform(self, f: Floats, cosine: Floats) -> Floats:
        """The transform of f [1/sr]; both broadcast."""
        return np.asarray(self.transformed(np, f, cosine))

    def slope(self, f: Floats, cosine: Floats) -> Floats:
        """The derivative of `transform` by f."""
        return np.asarray(self.sloped(np, f, cosine))

    def of_unit(self, unit: float) -> Loss:
        """The same for data of such a unit (`motes.fitting.columns.unit_of`)."""
        return _cube_root(SMALLEST * unit) if self.name == "cube_root" and unit != 1 else self

    @property
    def is_linear(self) -> bool:
        """Whether the transform of a sum is the sum of transforms."""
        return self.name in ("linear", "plain")


def _cube_root(smallest: float) -> Loss:
    return Loss(
        "cube_root",
        "(f cos theta_i)^(1/3) - (r cos theta_i)^(1/3)",
        lambda xp, f, c: xp.cbrt(f * c),
        lambda xp, f, c: c / (3 * _square(xp.cbrt(xp.maximum(f * c, smallest)))),
    )


LOSSES = {
    loss.name: loss
    for loss in (
        Loss("linear", "(f - r) cos theta_i", lambda xp, f, c: f * c, lambda xp, f, c: c),
        Loss("plain", "f - r", lambda xp, f, c: f, lambda xp, f, c: 0 * c + 1.0),
        Loss(
            "log",
            "log(1 + f cos theta_i) - log(1 + r cos theta_i)",
            lambda xp, f, c: xp.log1p(f * c),
            lambda xp, f, c: c / (1 + f * c),
        ),
        _cube_root(SMALLEST),
    )
}


@dataclass(frozen=True)
class Robust:
    """A function rho of the squared residual z (in units of the noise squared) that grows slower than z.

    ``slope`` is its derivative by z: what a residual is multiplied by in the gradient.  ``bend`` is the derivative of
    that product by the residual, slope + 2 z slope': what J'J is multiplied by in the expected second derivative, and so
    in the standard errors.  Each is a formula (`of`, `sloped`, `bent`) of a namespace and of z.
    """

    name: str
    of: Callable[[Functions, Array], Array]
    sloped: Callable[[Functions, Array], Array]
    bent: Callable[[Functions, Array], Array]

    def rho(self, z: Floats) -> Floats:
        return np.asarray(self.of(np, z))

    def slope(self, z: Floats) -> Floats:
        return np.asarray(self.sloped(np, z))

    def bend(self, z: Floats) -> Floats:
        return np.asarray(self.bent(np, z))


def _square(x: Array) -> Array:
    return x * x


ROBUST = {
    robust.name: robust
    for robust in (
        Robust("none", lambda xp, z: z, lambda xp, z: 0 * z + 1.0, lambda xp, z: 0 * z + 1.0),
        Robust(
            "soft_l1",
            lambda xp, z: 2 * (xp.sqrt(1 + z) - 1),
            lambda xp, z: 1 / xp.sqrt(1 + z),
            lambda xp, z: 1 / ((1 + z) * xp.sqrt(1 + z)),
        ),
        Robust(
            "huber",
            lambda xp, z: xp.where(z <= 1, z, 2 * xp.sqrt(xp.maximum(z, 1.0)) - 1),
            lambda xp, z: 1 / xp.sqrt(xp.maximum(z, 1.0)),
            lambda xp, z: xp.where(z <= 1, 1.0, 0.0),
        ),
        Robust(
            "cauchy",
            lambda xp, z: xp.log1p(z),
            lambda xp, z: 1 / (1 + z),
            lambda xp, z: (1 - z) / ((1 + z) * (1 + z)),
        ),
    )
}


def loss_named(name: str) -> Loss:
    """The loss of that name."""
    if not isinstance(name, str) or name not in LOSSES:
        raise MotesError(f"loss {name!r} is not one of {', '.join(LOSSES)}", "linear is a good first choice")
    return LOSSES[name]


def robust_named(name: str) -> Robust:
    """The robust function of that name."""
    if not isinstance(name, str) or name not in ROBUST:
        raise MotesError(
            f"robust {name!r} is not one of {', '.join(ROBUST)}", "none is least squares; soft_l1 a mild choice"
        )
    return ROBUST[name]
