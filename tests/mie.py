"""Scattering by spheres (Mie theory), averaged over sizes: what published optics of dust were computed from, computed once more.

The series and their recurrences are those of Bohren and Huffman, Absorption and Scattering of Light by Small Particles, 1983, chapter 4.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def sphere(x: float, m: complex) -> tuple[float, float, float]:
    """Efficiencies of extinction and scattering, and g, of a sphere of size parameter x = 2 pi r / wavelength and index m = n + ik."""
    last = int(x + 4 * x ** (1 / 3) + 2)
    n = np.arange(1, last + 1)
    # The logarithmic derivative downwards, from far beyond where it matters.
    start = int(max(last, abs(m) * x)) + 16
    derivative = np.zeros(start + 1, complex)
    for k in range(start, 0, -1):
        derivative[k - 1] = k / (m * x) - 1 / (derivative[k] + k / (m * x))
    d = derivative[1 : last + 1]
    # psi by its ratios downwards, chi upwards: each the way in which it is stable.
    ratio = np.zeros(start + 1)  # psi_k / psi_(k-1)
    for k in range(start, 0, -1):
        ratio[k - 1] = 1 / ((2 * k + 1) / x - ratio[k]) if k < start else x / (2 * k + 1)
    psi = np.sin(x) * np.concatenate([[1.0], np.cumprod(ratio[:last])])
    if abs(np.sin(x)) < 0.1:  # psi_0 may vanish: go on from psi_1
        first = np.sin(x) / x - np.cos(x)
        psi = np.concatenate([[np.sin(x)], first * np.concatenate([[1.0], np.cumprod(ratio[1:last])])])
    chi = np.empty(last + 1)
    chi[0], chi[1] = np.cos(x), np.cos(x) / x + np.sin(x)
    for k in range(2, last + 1):
        chi[k] = (2 * k - 1) / x * chi[k - 1] - chi[k - 2]
    xi = psi - 1j * chi
    a = ((d / m + n / x) * psi[1:] - psi[:-1]) / ((d / m + n / x) * xi[1:] - xi[:-1])
    b = ((d * m + n / x) * psi[1:] - psi[:-1]) / ((d * m + n / x) * xi[1:] - xi[:-1])
    extinction = 2 / x**2 * np.sum((2 * n + 1) * (a + b).real)
    scattering = 2 / x**2 * np.sum((2 * n + 1) * (abs(a) ** 2 + abs(b) ** 2))
    along = n[:-1] * (n[:-1] + 2) / (n[:-1] + 1) * (a[:-1] * a[1:].conj() + b[:-1] * b[1:].conj()).real
    cross = (2 * n + 1) / (n * (n + 1)) * (a * b.conj()).real
    g = 4 / (x**2 * scattering) * (np.sum(along) + np.sum(cross))
    return float(extinction), float(scattering), float(g)


def lognormal(
    wavelength: float, m: complex, mode: float, sigma: float, smallest: float, largest: float, steps: int = 160
) -> tuple[float, float]:
    """w and g of spheres whose radii are lognormal by number, cut at both ends; lengths in one unit."""
    low, high = max(smallest, mode / sigma**5), min(largest, mode * sigma**7)
    r = np.exp(np.linspace(np.log(low), np.log(high), steps))
    # Radii are equally far apart in the logarithm; areas are what sections are in proportion to.
    share = np.exp(-0.5 * (np.log(r / mode) / np.log(sigma)) ** 2) * r**2
    found = np.array([sphere(2 * np.pi * x / wavelength, m) for x in r])
    extinct, scattered = share @ found[:, 0], share @ found[:, 1]
    return float(scattered / extinct), float(share @ (found[:, 1] * found[:, 2]) / scattered)
