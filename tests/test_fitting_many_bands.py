"""Spectra of hundreds of bands: what a fit of them takes of memory."""

from __future__ import annotations

import tracemalloc

import numpy as np

import motes
from motes.directions import from_spherical

BANDS = 400


def test_the_blocks_of_error_bars_do_not_keep_a_matrix_each() -> None:
    """A curvature of all bands is the largest thing in a fit; some of them are needed at a time, not one a block."""
    rng = np.random.default_rng(5)
    theta, phi = np.radians(rng.uniform(0, 75, (2, 60))), np.radians(rng.uniform(0, 360, (2, 60)))
    wi, wo = from_spherical(theta[0], phi[0]), from_spherical(theta[1], phi[1])
    f = motes.OrenNayar(K_d=tuple(np.linspace(0.2, 0.6, BANDS)), sigma_d=0.35).eval(wi, wo)
    data = motes.Measurement.from_arrays(
        wi, wo, f * (1 + 0.01 * rng.standard_normal(f.shape)), channels=tuple(map(str, range(BANDS)))
    )
    motes.fit(data, "oren_nayar", errors="blocks")  # what is loaded once is not counted
    tracemalloc.start()
    try:
        motes.fit(data, "oren_nayar", errors="blocks")
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    matrix = 8 * (BANDS + 1) ** 2
    assert most < 16 * matrix + 20 * f.nbytes
