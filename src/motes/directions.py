"""Directions in the local frame (z = the surface normal): angles, half vectors, Rusinkiewicz coordinates, and the
geometry of a pair.

``wi`` points to the light, ``wo`` to the viewer; both are unit vectors away from the surface, arrays of shape (..., 3).
"""

from __future__ import annotations

import math
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import workers
from motes.arrays import Array

HALF_PI = 1.5707963267948966
# A direction is above the surface where its cosine to the normal is above this, and at the horizon or below it otherwise:
# in models, measurements, fits and maps alike.  cos(90 degrees) comes out as 6e-17, and 1.570796 rad, which is 90
# degrees with six decimals, as 3e-7; directions steeper than 89.99994 degrees are lost, which no instrument resolves.
HORIZON = 1e-6
# Cosines are kept at or above this where they divide.  It is far below what a unit vector in float64 can resolve near
# the horizon, so it changes no value; it keeps products of two cosines away from underflow in float32, and masked
# directions free of 0/0.
SMALLEST_COSINE = 1e-12
# Of a component of a direction; a unit vector has 1, and printed digits little more.
LONGEST = 1.01
# Directions that are looked at together: their numbers stay in cache.
AT_ONCE = 8192


class Vector(NamedTuple):
    """A direction by components: symbols and structure-of-arrays tiles look like slices of an (..., 3) array."""

    x: Array
    y: Array
    z: Array

    @classmethod
    def of(cls, w: Array) -> Vector:
        """The components of an (..., 3) array, each with a last axis of length 1 to broadcast against channels."""
        return cls(w[..., 0:1], w[..., 1:2], w[..., 2:3])

    @classmethod
    def split(cls, w: Array) -> Vector:
        """The components of an (..., 3) array, each of shape (...): what lobes compute with."""
        return cls(w[..., 0], w[..., 1], w[..., 2])


def polar_angle(xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
    """Polar angle [rad] in [0, pi/2] from its cosine and sine, accurate at both ends.

    acos(cos_theta) loses half the digits near 0, where the cosine is flat: in float32 an angle of 0.003 comes out 1 %
    wrong, and (theta_h / sigma_s)^2 with it.  The arc sine of the smaller of the two is well conditioned everywhere,
    its derivative is bounded by sqrt(2), and its polynomial on [0, 0.7072] needs no square root."""
    small = xp.asin(xp.minimum(cos_theta, sin_theta))
    return xp.where(sin_theta < cos_theta, small, HALF_PI - small)


def elevation(xp: Array, cos_theta: Array, sin_theta: Array) -> Array:
    """The angle above the horizon [rad], pi/2 less the polar angle, as accurate as `polar_angle` at both ends."""
    small = xp.asin(xp.minimum(cos_theta, sin_theta))
    return xp.where(sin_theta < cos_theta, HALF_PI - small, small)


class Geometry:
    """What the equations need of a pair of directions, computed once and when asked for.

    All of it is isotropic: of the azimuths only phi_r - phi_i enters.  This is the one place where an azimuth against the surface
    would: an anisotropic model (brushed metal, cloth) needs cos(phi_h) and sin(phi_h) of the half vector, or x and y of the two
    directions themselves, which are components of `wi` and `wo` along the surface's tangent and bitangent.  They become further
    properties here, in the manner of `cos_dphi`; tracing, kernels and shaders record components, and print what is used of them.
    Lobes get all three components already.  What assumes isotropy stands elsewhere: tables over (theta_i, theta_r, phi) in
    `motes.exports`, the frame about the normal in shaders that are told no tangent, and measurements that are folded by symmetry.

    Parameters
    ----------
    xp
        Namespace; see `motes.arrays`.
    wi, wo
        Vectors (`Vector`) of broadcastable components; unit length is taken for granted.
    """

    def __init__(self, xp: Array, wi: Vector, wo: Vector) -> None:
        self.xp, self.wi, self.wo = xp, wi, wo

    @cached_property
    def cos_theta_i(self) -> Array:
        return self.xp.maximum(self.wi.z, SMALLEST_COSINE)

    @cached_property
    def cos_theta_r(self) -> Array:
        return self.xp.maximum(self.wo.z, SMALLEST_COSINE)

    @cached_property
    def sin_theta_i(self) -> Array:
        return self.xp.sqrt(self.wi.x * self.wi.x + self.wi.y * self.wi.y)

    @cached_property
    def sin_theta_r(self) -> Array:
        return self.xp.sqrt(self.wo.x * self.wo.x + self.wo.y * self.wo.y)

    @cached_property
    def theta_i(self) -> Array:
        return polar_angle(self.xp, self.cos_theta_i, self.sin_theta_i)

    @cached_property
    def theta_r(self) -> Array:
        return polar_angle(self.xp, self.cos_theta_r, self.sin_theta_r)

    @cached_property
    def sin_alpha(self) -> Array:
        return self.xp.maximum(self.sin_theta_i, self.sin_theta_r)

    @cached_property
    def sin_alpha_less_cube(self) -> Array:
        """sin(alpha) - (2 beta/pi)^3 without the cancellation at mutual grazing.

        With e = 1 - 2 beta/pi, the elevation of the steeper direction, the cube is 1 - e (3 - e (3 - e)); and
        1 - sin(alpha) = cos(alpha)^2 / (1 + sin(alpha)).
        """
        xp = self.xp
        steeper = xp.maximum(
            elevation(xp, self.cos_theta_i, self.sin_theta_i), elevation(xp, self.cos_theta_r, self.sin_theta_r)
        )
        e = (1 / HALF_PI) * steeper
        cos_alpha = xp.minimum(self.cos_theta_i, self.cos_theta_r)
        return e * (3 - e * (3 - e)) - cos_alpha * cos_alpha / (1 + self.sin_alpha)

    @cached_property
    def one_less_abs_cos_dphi(self) -> Array:
        """1 - abs(cos(phi_r - phi_i)) = sin^2 / (1 + abs(cos)), with the sine from the cross product, which does not cancel."""
        xp = self.xp
        cross = self.wi.x * self.wo.y - self.wi.y * self.wo.x
        sine = cross / xp.maximum(self.sin_theta_i * self.sin_theta_r, 1e-30)
        return xp.minimum(sine * sine, 1.0) / (1 + xp.maximum(self.cos_dphi, -self.cos_dphi))

    @cached_property
    def tan_beta(self) -> Array:
        return self.xp.minimum(self.sin_theta_i, self.sin_theta_r) / self.xp.maximum(self.cos_theta_i, self.cos_theta_r)

    @cached_property
    def tan_half(self) -> Array:
        """tan((alpha + beta)/2) = (sin alpha + sin beta) / (cos alpha + cos beta), whichever of the two is alpha."""
        return (self.sin_theta_i + self.sin_theta_r) / (self.cos_theta_i + self.cos_theta_r)

    @cached_property
    def cos_dphi(self) -> Array:
        """cos(phi_r - phi_i); at normal incidence, where azimuth means nothing and its factors vanish, it is 0."""
        dot = self.wi.x * self.wo.x + self.wi.y * self.wo.y
        cosine = dot / self.xp.maximum(self.sin_theta_i * self.sin_theta_r, 1e-30)
        return self.xp.maximum(self.xp.minimum(cosine, 1.0), -1.0)

    @cached_property
    def _sum_xy2(self) -> Array:
        x, y = self.wi.x + self.wo.x, self.wi.y + self.wo.y
        return x * x + y * y

    @cached_property
    def _sum_z(self) -> Array:
        return self.cos_theta_i + self.cos_theta_r

    @cached_property
    def sin2_half_gamma(self) -> Array:
        """sin^2(gamma/2) of the deviation angle gamma: cos(gamma) = -wi . wo, so it is the squared length of wi + wo over 4."""
        return 0.25 * (self._sum_xy2 + self._sum_z * self._sum_z)

    @cached_property
    def cos2_half_gamma(self) -> Array:
        x, y, z = self.wi.x - self.wo.x, self.wi.y - self.wo.y, self.cos_theta_i - self.cos_theta_r
        return 0.25 * (x * x + y * y + z * z)

    @cached_property
    def cos_theta_d(self) -> Array:
        """wi . wh = wo . wh, half the length of wi + wo for unit vectors: the cosine of Rusinkiewicz's difference angle."""
        return self.xp.sqrt(self.sin2_half_gamma)

    @cached_property
    def _inverse_sum(self) -> Array:
        return 0.5 / self.cos_theta_d

    @cached_property
    def cos_theta_h(self) -> Array:
        return self._sum_z * self._inverse_sum

    @cached_property
    def sin_theta_h(self) -> Array:
        return self.xp.sqrt(self._sum_xy2) * self._inverse_sum

    @cached_property
    def theta_h(self) -> Array:
        return polar_angle(self.xp, self.cos_theta_h, self.sin_theta_h)

    def above_horizon(self, value: Array) -> Array:
        """`value` where both directions are above the surface, exactly 0 elsewhere; a NaN cosine stays NaN."""
        xp, z_i, z_o = self.xp, self.wi.z, self.wo.z
        # A cosine that is clamped from both sides is 0, or NaN for a NaN; max(z, 0) would leave what is within HORIZON.
        nothing_i, nothing_o = (xp.maximum(xp.minimum(z, 0.0), 0.0) for z in (z_i, z_o))
        return xp.where(z_i > HORIZON, xp.where(z_o > HORIZON, value, nothing_o), nothing_i)


# ---------------------------------------------------------------- Coordinates of measurements (NumPy, float64)


def above(*ws: ArrayLike) -> NDArray[np.bool_]:
    """Where all of some directions (..., 3) are above the horizon, `HORIZON`; not where a component is NaN."""
    result: NDArray[np.bool_] = np.asarray(np.asarray(ws[0], np.float64)[..., 2] > HORIZON)
    for w in ws[1:]:
        result = result & (np.asarray(w, np.float64)[..., 2] > HORIZON)
    return result


def unit(vector: ArrayLike) -> NDArray[np.float64] | None:
    """A vector (3,) at length 1, whatever its own length is; None when it has no direction: 0, NaN or infinite."""
    v = np.asarray(vector, np.float64)
    largest = np.abs(v).max()
    if not (np.isfinite(largest) and largest > 0):
        return None
    v = v / largest  # squares of what is large are not numbers
    return np.asarray(v / np.linalg.norm(v))


def from_spherical(theta: ArrayLike, phi: ArrayLike) -> NDArray[np.float64]:
    """Unit vectors (..., 3) from polar angle and azimuth [rad]."""
    theta, phi = np.broadcast_arrays(np.asarray(theta, np.float64), np.asarray(phi, np.float64))
    sin_theta = np.sin(theta)
    return np.stack([sin_theta * np.cos(phi), sin_theta * np.sin(phi), np.cos(theta)], axis=-1)


def theta(w: ArrayLike) -> NDArray[np.float64]:
    """Polar angle [rad] in [0, pi] of directions (..., 3)."""
    w = np.asarray(w, np.float64)
    angle: NDArray[np.float64] = np.arctan2(np.hypot(w[..., 0], w[..., 1]), w[..., 2])
    return angle


def phi(w: ArrayLike) -> NDArray[np.float64]:
    """Azimuth [rad] in (-pi, pi] of directions (..., 3)."""
    w = np.asarray(w, np.float64)
    angle: NDArray[np.float64] = np.arctan2(w[..., 1], w[..., 0])
    return angle


def _rotate(w: NDArray[np.float64], axis: int, angle: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rotate about the y (1) or z (2) axis, counter-clockwise as seen from its tip."""
    a, b = ((2, 0), (0, 1))[axis - 1]
    rotated = np.array(np.broadcast_to(w, (*np.broadcast_shapes(w.shape[:-1], angle.shape), 3)))
    cos, sin = np.cos(angle), np.sin(angle)
    rotated[..., a] = cos * w[..., a] - sin * w[..., b]
    rotated[..., b] = sin * w[..., a] + cos * w[..., b]
    return rotated


def from_half_difference(
    theta_h: ArrayLike, theta_d: ArrayLike, phi_d: ArrayLike, phi_h: ArrayLike = 0.0
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """``wi, wo`` (..., 3) from half and difference angles [rad] (Rusinkiewicz 1998)."""
    angles = [np.asarray(a, np.float64) for a in (theta_h, theta_d, phi_d, phi_h)]
    theta_h, theta_d, phi_d, phi_h = np.broadcast_arrays(*angles)
    difference = from_spherical(theta_d, phi_d)
    wh = from_spherical(theta_h, phi_h)
    wi = _rotate(_rotate(difference, 1, theta_h), 2, phi_h)
    return wi, 2 * np.sum(wi * wh, axis=-1, keepdims=True) * wh - wi


def half_difference(
    wi: ArrayLike, wo: ArrayLike
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """``theta_h, theta_d, phi_d`` [rad] of pairs of directions (..., 3) (Rusinkiewicz 1998); phi_d in (-pi, pi]."""
    # A component in one piece: all that follows takes half the time.
    wi, wo = np.asarray(wi, np.float64, order="F"), np.asarray(wo, np.float64, order="F")
    wh = wi + wo
    theta_h = theta(wh)
    difference = _rotate(_rotate(wi, 2, -phi(wh)), 1, -theta_h)
    return theta_h, theta(difference), phi(difference)


def half_vectors_within(angle: float, wi: NDArray[np.float64], wo: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Where the half vectors of pairs of directions (N, 3) are within an angle below pi/2 [rad] of the normal."""
    found = np.empty(len(wi), bool)

    def looked(task: int, _: None) -> None:
        rows = slice(task * AT_ONCE, (task + 1) * AT_ONCE)
        x, y, z = np.add(wi[rows].T, wo[rows].T, order="C")
        np.greater(z, math.cos(angle) * np.sqrt(x * x + y * y + z * z), out=found[rows])

    workers.spread(-(-len(wi) // AT_ONCE), looked, lambda: None)
    return found


def frame(normal: ArrayLike) -> NDArray[np.float64]:
    """An orthonormal frame (..., 3, 3) with rows tangent, bitangent, normal (Duff et al. 2017, JCGT 6(1))."""
    n = np.asarray(normal, np.float64)
    sign = np.copysign(1.0, n[..., 2])
    a = -1.0 / (sign + n[..., 2])
    b = n[..., 0] * n[..., 1] * a
    tangent = np.stack([1 + sign * n[..., 0] ** 2 * a, sign * b, -sign * n[..., 0]], -1)
    bitangent = np.stack([b, sign + n[..., 1] ** 2 * a, -n[..., 1]], -1)
    return np.stack([tangent, bitangent, n], -2)
