"""Grids of directions that measured tables are made of, and the solid angles of their bins."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes import directions

HALF_PI = directions.HALF_PI


def half_difference_grid(
    n_theta_h: int, n_theta_d: int, n_phi_d: int
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.bool_]]:
    """The bins of the MERL table (Matusik et al. 2003) at their centres, phi_h = 0.

    theta_h has square-root bins, theta_h = (pi/2) (i/n)^2 at the edges, theta_d and phi_d in [0, pi) even ones; phi_d
    varies fastest.

    Returns
    -------
    wi, wo
        (N, 3), of the N bins with both directions above the horizon.
    weights
        (N,) [sr^2/rad]: the integral of d omega_i d omega_o / d phi_h = sin(theta_h) d theta_h 4 cos(theta_d)
        sin(theta_d) d theta_d d phi_d over each bin, exact between its edges.
    above
        Which of all bins, in the order of the file, these are.

    Notes
    -----
    The same rotation as `motes.directions.from_half_difference`; written out since sines of three axes are cheap and
    those of 1.5 million points are not.
    """
    theta_h = ((np.arange(n_theta_h) + 0.5) / n_theta_h) ** 2 * HALF_PI
    theta_d = (np.arange(n_theta_d) + 0.5) / n_theta_d * HALF_PI
    phi_d = (np.arange(n_phi_d) + 0.5) / n_phi_d * np.pi
    sin_h, cos_h = np.sin(theta_h)[:, None, None], np.cos(theta_h)[:, None, None]
    x = np.sin(theta_d)[:, None] * np.cos(phi_d)
    y = np.sin(theta_d)[:, None] * np.sin(phi_d)
    z = np.cos(theta_d)[:, None]
    # wi is (x, y, z) and wo its mirror image (-x, -y, z), both rotated by theta_h about the y axis
    zi, zo = cos_h * z - sin_h * x, cos_h * z + sin_h * x
    above = (zi > directions.HORIZON) & (zo > directions.HORIZON)
    y = np.broadcast_to(y, above.shape)[above]
    wi = np.stack([(cos_h * x + sin_h * z)[above], y, zi[above]], axis=-1)
    wo = np.stack([(sin_h * z - cos_h * x)[above], -y, zo[above]], axis=-1)
    d_h = -np.diff(np.cos((np.arange(n_theta_h + 1) / n_theta_h) ** 2 * HALF_PI))
    d_d = 2 * np.diff(np.sin(np.arange(n_theta_d + 1) / n_theta_d * HALF_PI) ** 2)
    weights = np.broadcast_to(d_h[:, None, None] * d_d[:, None] * (np.pi / n_phi_d), above.shape)[above]
    return wi, wo, weights, above.reshape(-1)


def polar_bins(n: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Centres [rad] and solid angles per azimuth, |d cos theta|, of n even bins of the polar angle over [0, pi/2]."""
    edges = np.arange(n + 1) / n * HALF_PI
    return (edges[1:] + edges[:-1]) / 2, -np.diff(np.cos(edges))


def node_weights(theta: NDArray[np.float64]) -> NDArray[np.float64]:
    """Solid angles per azimuth of increasing polar angles: |d cos theta| between their midpoints, 0 and pi/2."""
    edges = np.concatenate([[0.0], (theta[1:] + theta[:-1]) / 2, [HALF_PI]])
    return np.asarray(np.abs(np.diff(np.cos(np.clip(edges, 0, HALF_PI)))))
