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

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError

Floats = NDArray[np.float64]
# The cube root has an infinite slope at 0: below this f cos(theta_i) [1/sr] its slope is held, so that a model at
# exactly 0 can still move.
SMALLEST = 1e-6


@dataclass(frozen=True)
class Loss:
    """A transform of the BRDF and its derivative by f; both take f [1/sr] and cos(theta_i), broadcast."""

    name: str
    meaning: str
    transform: Callable[[Floats, Floats], Floats]
    slope: Callable[[Floats, Floats], Floats]


LOSSES = {
    loss.name: loss
    for loss in (
        Loss("linear", "(f - r) cos theta_i", lambda f, c: f * c, lambda f, c: c),
        Loss("plain", "f - r", lambda f, c: f, lambda f, c: np.ones_like(c)),
        Loss(
            "log",
            "log(1 + f cos theta_i) - log(1 + r cos theta_i)",
            lambda f, c: np.log1p(f * c),
            lambda f, c: c / (1 + f * c),
        ),
        Loss(
            "cube_root",
            "(f cos theta_i)^(1/3) - (r cos theta_i)^(1/3)",
            lambda f, c: np.cbrt(f * c),
            lambda f, c: c / (3 * np.cbrt(np.maximum(f * c, SMALLEST)) ** 2),
        ),
    )
}


@dataclass(frozen=True)
class Robust:
    """A function rho of the squared residual z (in units of the noise squared) that grows slower than z.

    ``slope`` is its derivative by z: what a residual is multiplied by in the gradient.  ``bend`` is the derivative of
    that product by the residual, slope + 2 z slope': what J'J is multiplied by in the expected second derivative, and so
    in the standard errors.
    """

    name: str
    rho: Callable[[Floats], Floats]
    slope: Callable[[Floats], Floats]
    bend: Callable[[Floats], Floats]


ROBUST = {
    robust.name: robust
    for robust in (
        Robust("none", lambda z: z, np.ones_like, np.ones_like),
        Robust(
            "soft_l1",
            lambda z: 2 * (np.sqrt(1 + z) - 1),
            lambda z: 1 / np.sqrt(1 + z),
            lambda z: 1 / ((1 + z) * np.sqrt(1 + z)),
        ),
        Robust(
            "huber",
            lambda z: np.where(z <= 1, z, 2 * np.sqrt(np.maximum(z, 1)) - 1),
            lambda z: 1 / np.sqrt(np.maximum(z, 1)),
            lambda z: np.where(z <= 1, 1.0, 0.0),
        ),
        Robust("cauchy", np.log1p, lambda z: 1 / (1 + z), lambda z: (1 - z) / ((1 + z) * (1 + z))),
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
