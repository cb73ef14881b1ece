"""An RGL tensor file, which Mitsuba's ``measured`` and other renderers load as a measured material.

The layout and the parameters are those of Dupuy and Jakob 2018 (see `motes.measurements.rgl`).  The distribution D of facets
is that which would reflect as the BRDF does back to the light (their section 4.1, solved by power iteration), so that the
values, f cos(theta_o) 4 sigma/D, vary little.  They lie on even steps of u, without a warp: u_x goes as the root of theta_m,
so a highlight has its share of nodes without one, and a diffuse surface under it is not squeezed into the rest.
"""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.directions import from_spherical
from motes.exports.shaders import plain
from motes.exports.subject import Subject
from motes.files import replacing
from motes.measurements._tensor_file import DTYPES, MAGIC
from motes.measurements._warp import Grid

SUFFIX = ".bsdf"
Array = NDArray[np.float64]

THETA_I = np.concatenate(
    [np.linspace(0, 80, 25), [81.5, 83, 84.5, 86, 87, 88, 88.75, 89.4]]
)  # nodes of the incident angle [deg]
FACETS = 512  # nodes of D over the polar angle
VALUES = 80  # nodes of the values along each axis of the square
FLOOR = 1e-3  # of the mean: D divides
HORIZON = 5e-3  # cosine of what counts as level


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    said = [
        f"Values lie on {len(THETA_I)} angles of incidence up to {THETA_I[-1]:g} degrees x {VALUES} x {VALUES} directions, "
        "denser towards the mirror direction; between them and beyond is interpolation.",
    ]
    if subject.wavelengths:
        said.append("The file is spectral: renderers that know only RGB cannot read it.")
    return said


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the file."""
    fields = tensor_fields(subject)
    names = {np.dtype(dtype): code for code, dtype in DTYPES.items()}
    table = 18 + sum(2 + len(name) + 11 + 8 * array.ndim for name, array in fields.items())
    head, at = [MAGIC + b"\x01\x00" + struct.pack("<I", len(fields))], table
    body = []
    for name, array in fields.items():
        padding = -at % 8
        at += padding
        head.append(struct.pack("<H", len(name)) + name.encode())
        head.append(struct.pack(f"<HBQ{array.ndim}Q", array.ndim, names[array.dtype], at, *array.shape))
        body.append(bytes(padding) + array.tobytes())
        at += array.nbytes
    with replacing(path) as temporary, open(temporary, "wb") as file:
        file.writelines([*head, *body])
    return [path]


def tensor_fields(subject: Subject) -> dict[str, NDArray[np.generic]]:
    """The fields of the file, in the types that it has.

    Raises
    ------
    DataError
        When the channels are neither one, nor three, nor wavelengths.
    """
    if not subject.wavelengths:
        subject.colored("an RGL file without wavelengths")
    theta_i = np.deg2rad(THETA_I)
    theta_m, ndf = facets(subject)
    u_x = np.linspace(0, 1, FACETS)
    sigma = _projected_area(theta_m) @ ndf
    channels = max(subject.brdf.channels, 3) if not subject.wavelengths else subject.brdf.channels
    n = len(theta_i)
    fields_ndf = Grid(np.broadcast_to(ndf, (2, FACETS))[None, None, :, :, None])
    sigma_i = np.interp(np.sqrt(theta_i / (np.pi / 2)), u_x, sigma)
    nodes = np.linspace(0, 1, VALUES)
    u = np.stack(np.meshgrid(nodes, nodes, indexing="xy"), axis=-1).reshape(-1, 2)
    values = np.empty((1, n, channels, VALUES, VALUES))
    luminance = np.empty((1, n, VALUES, VALUES))  # the density by which renderers draw u: f cos d omega_o/du
    for t, theta in enumerate(theta_i):
        wm = from_spherical(u[:, 0] ** 2 * np.pi / 2, (2 * u[:, 1] - 1) * np.pi)
        wi = np.broadcast_to(from_spherical(theta, 0.0), wm.shape)
        wo = 2 * np.sum(wi * wm, axis=-1, keepdims=True) * wm - wi
        below = wo[:, 2] < HORIZON
        level = wo * [1, 1, 0] + [0, 0, HORIZON]
        level /= np.linalg.norm(level, axis=-1, keepdims=True)
        # Beyond the horizon f cos goes on as its point reflection about the value there: smooth, whether it ends at 0 or not.
        up = np.where(below[:, None], np.maximum(wo * [1, 1, -1], [-1, -1, HORIZON]), wo)
        f = _f_cos(subject, wi, up)
        f[below] = np.clip(2 * _f_cos(subject, wi[below], level[below]) - f[below], -f[below], 2 * f[below])
        cos_d, sin_m = np.maximum(np.sum(wi * wm, axis=-1), 0), np.hypot(wm[:, 0], wm[:, 1])
        drawn = np.where(below, 0, np.maximum(f.mean(axis=-1), 0) * cos_d * u[:, 0] * sin_m)
        luminance[0, t] = drawn.reshape(VALUES, VALUES)
        scaled = f * (4 * sigma_i[t]) / fields_ndf.eval(u)
        values[0, t] = np.broadcast_to(scaled, (len(u), channels)).T.reshape(channels, VALUES, VALUES)
    luminance += FLOOR * luminance.mean(axis=(2, 3), keepdims=True)
    text = f"{plain(subject.title)}. {' '.join(map(plain, subject.notes))}".strip()
    fields: dict[str, NDArray[np.generic]] = {
        "description": np.frombuffer(text.encode(), np.uint8),
        "jacobian": np.array([1], np.uint8),
        "phi_i": np.zeros(1, "<f4"),
        "theta_i": theta_i.astype("<f4"),
        "ndf": np.broadcast_to(ndf, (2, FACETS)).astype("<f4"),
        "sigma": np.broadcast_to(sigma, (2, FACETS)).astype("<f4"),
        "vndf": np.ones((1, n, 2, 2), "<f4"),
        "luminance": luminance.astype("<f4"),
    }
    if subject.wavelengths:
        fields |= {"wavelengths": np.array(subject.wavelengths, "<f4"), "spectra": values.astype("<f4")}
    else:
        fields["rgb"] = values.astype("<f4")
    return fields


def _f_cos(subject: Subject, wi: Array, wo: Array) -> Array:
    """f cos(theta_o) (n, C)."""
    values = np.asarray(subject.brdf.eval(np.ascontiguousarray(wi), np.ascontiguousarray(wo)), np.float64)
    return values * wo[:, 2:]


def facets(subject: Subject) -> tuple[Array, Array]:
    """Polar angles (n,) [rad] at even steps of u = sqrt(2 theta/pi), and a distribution of facets D (n,) at them, such that
    the integral of D cos(theta) is 1.

    Back to the light, f = D F/(4 sigma cos(theta)), and sigma is linear in D: D is the eigenvector of
    4 f cos(theta) sigma[D] with the largest eigenvalue, which is positive.
    """
    theta = np.linspace(0, 1, FACETS) ** 2 * np.pi / 2
    w = from_spherical(np.minimum(theta, np.arccos(1e-3)), 0.0)
    f = np.asarray(subject.brdf.eval(w, w), np.float64).mean(axis=-1)
    f = np.maximum(f, FLOOR * max(float(f.mean()), 1e-30))
    ndf, area = np.ones(FACETS), _projected_area(theta)
    for _ in range(30):
        ndf = 4 * f * np.maximum(np.cos(theta), 1e-2) * (area @ ndf)
        ndf /= _integral(theta, ndf * np.cos(theta) * 2 * np.pi * np.sin(theta))
    return theta, np.maximum(ndf, FLOOR * ndf.mean())


def _integral(x: Array, y: Array) -> float:
    return float(np.sum((y[1:] + y[:-1]) / 2 * np.diff(x)))


def _projected_area(theta: Array) -> Array:
    """The matrix (n, n) that makes sigma of D: the integral of D(m) max(0, w.m) over directions m, for w at polar angles theta."""
    azimuth = (np.arange(64) + 0.5) / 64 * np.pi
    cos, sin = np.cos(theta), np.sin(theta)
    area = np.zeros((len(theta), len(theta)))
    for phi in azimuth:
        area += np.maximum(np.outer(cos, cos) + np.outer(sin, sin) * np.cos(phi), 0)
    return area * (np.gradient(theta) * sin * (2 * np.pi / len(azimuth)))
