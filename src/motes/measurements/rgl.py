"""RGL ``.bsdf`` (Dupuy and Jakob 2018): adaptive measurements in a tensor file, and their evaluation at any directions.

The values lie on a grid of the unit square that a warp maps onto directions of the half vector wm so that it follows
the material's lobe, for each node of theta_i (and phi_i):

    u = (sqrt(2 theta_m / pi), (phi_m - phi_i + pi) / (2 pi) mod 1);   s = inverse of the vndf warp (u | theta_i);
    f_r cos(theta_o) = rgb(s | theta_i) ndf(u) / (4 sigma(theta_i))

Negative channels, of colours outside the gamut of R, G and B or of noise, are data like others; see `motes.measurements.policy`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Self, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.errors import DataError, FormatError, MotesError
from motes.measurements._angles import node_weights
from motes.measurements._tensor_file import MAGIC, TensorFile
from motes.measurements._warp import Grid, Warp, bracket
from motes.measurements.measurement import Measurement

NAME = "rgl"
SOURCE = "in the layout of the RGL material database (Dupuy, Jakob, ACM TOG 37(6), 2018)"


def sniff(path: Path, head: bytes) -> bool:
    return head.startswith(MAGIC)


def read_rgl(path: Path, *, resolution: int = 32) -> Measurement:
    """A sample of the file: its angles of incidence x a grid of outgoing directions in its own warped coordinates.

    Parameters
    ----------
    path
        The ``.bsdf`` file.
    resolution
        Outgoing directions an incident one, along each axis of the warped square; its cells are sampled at their
        centres, so that the directions crowd where the lobe is.  The weights are the cells' solid angles times those of
        the nodes of theta_i.
    """
    if not (isinstance(resolution, (int, np.integer)) and 2 <= resolution <= 512):
        raise MotesError(
            f"resolution = {resolution!r} is not a whole number from 2 to 512", "The default is 32, that of the files"
        )
    brdf = TensorBRDF.load(path)
    wi, wo, weights = brdf.directions(int(resolution))
    above = directions.above(wo)
    values = brdf.eval(wi[above], wo[above])
    return Measurement.from_arrays(
        wi[above],
        wo[above],
        values,
        channels=brdf.channels,
        wavelengths=brdf.wavelengths,
        weights=weights[above],
        provenance={
            "format": NAME,
            "path": str(path),
            "name": brdf.description or path.stem,
            "source": SOURCE,
            "isotropic": brdf.isotropic,
            "resolution": int(resolution),
            "notes": [
                f"f_r in 1/sr, interpolated at the centres of {resolution} x {resolution} cells of the warped square "
                "for each of its angles of incidence, weighted by solid angle",
                f"{int(np.count_nonzero(~above)):,} of {len(above):,} directions of that grid are below the horizon",
            ],
            "dropped": {"grid directions below the horizon": int(np.count_nonzero(~above))},
        },
    )


@final
@dataclass(frozen=True, eq=False)
class TensorBRDF:
    """A measured material of the RGL database, to be evaluated at any directions.

    Parameters
    ----------
    description
        What the file says it is.
    phi_i, theta_i
        Nodes of the incident direction [rad]; one or two of phi_i for an isotropic material.
    ndf, sigma
        Distribution of facet normals over u and projected facet area over the incident direction, (n_phi, n_theta).
    vndf
        Density of visible normals (n_phi_i, n_theta_i, n, n), which makes the warp.
    values
        The measurement on the warped square (n_phi_i, n_theta_i, C, n, n).
    channels, wavelengths
        Names, and [nm] for a spectral file.
    jacobian
        Whether values are to be multiplied by ndf / (4 sigma).
    """

    description: str
    phi_i: NDArray[np.float64]
    theta_i: NDArray[np.float64]
    ndf: NDArray[np.float64]
    sigma: NDArray[np.float64]
    vndf: NDArray[np.float64]
    values: NDArray[np.float64]
    channels: tuple[str, ...]
    wavelengths: NDArray[np.float64] | None
    jacobian: bool

    @classmethod
    def load(cls, path: str | Path) -> Self:
        """Read a ``.bsdf`` file.

        Raises
        ------
        FormatError
            When it is not one, is truncated, or lacks or contradicts its own fields.
        """
        path = Path(path)
        fields = TensorFile(path)
        phi_i, theta_i = fields.array("phi_i", 1), fields.array("theta_i", 1)
        ndf, sigma, vndf = fields.array("ndf", 2), fields.array("sigma", 2), fields.array("vndf", 4)
        spectral = "spectra" in fields
        values = fields.array("spectra" if spectral else "rgb", 5)
        wavelengths = fields.array("wavelengths", 1) if spectral else None
        nodes = (len(phi_i), len(theta_i))
        consistent = (
            vndf.shape[:2] == nodes
            and values.shape[:2] == nodes
            and min(*vndf.shape[2:], *values.shape[3:], *ndf.shape, *sigma.shape) >= 2
        )
        if not consistent or values.shape[2] != (3 if wavelengths is None else len(wavelengths)):
            raise FormatError(
                f"{path}: vndf has shape {vndf.shape} and the values {values.shape} for {nodes} incident directions",
                "The file is damaged",
            )
        for name, node in (("phi_i", phi_i), ("theta_i", theta_i)):
            if not np.all(np.isfinite(node)) or np.any(np.diff(node) <= 0) or np.any(np.abs(node) > 7):
                raise FormatError(f"{path}: {name} does not increase", "The file is damaged")
        if theta_i[0] < 0 or theta_i[-1] > directions.HALF_PI + 1e-3:
            raise FormatError(
                f"{path}: theta_i spans {theta_i[0]:g} to {theta_i[-1]:g} rad, not within 0 to pi/2",
                "The file is damaged",
            )
        mass = vndf.sum(axis=(2, 3))
        if not (np.all(np.isfinite(vndf)) and np.all(vndf >= 0) and np.all(mass > 0) and np.all(mass < 1e30)):
            raise FormatError(f"{path}: vndf is not a density (negative, zero or not finite)", "The file is damaged")
        return cls(
            description=fields.string("description"),
            phi_i=phi_i,
            theta_i=theta_i,
            ndf=ndf,
            sigma=sigma,
            vndf=vndf,
            values=values,
            channels=("R", "G", "B") if wavelengths is None else tuple(f"{w:g} nm" for w in wavelengths),
            wavelengths=wavelengths,
            jacobian=bool(fields.array("jacobian", 1).any()),
        )

    @property
    def isotropic(self) -> bool:
        return len(self.phi_i) <= 2

    def eval(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """BRDF f_r (..., C) [1/sr] without the cosine, at directions (..., 3); exactly 0 outside the upper hemisphere.

        Linear in the file's own interpolants; negative values, out of gamut, are returned as they are.
        """
        wi, wo = np.asarray(wi, np.float64), np.asarray(wo, np.float64)
        shape = np.broadcast_shapes(wi.shape, wo.shape)
        if shape[-1:] != (3,):
            raise DataError(
                f"wi and wo have shapes {wi.shape} and {wo.shape}, not (..., 3)", "Give directions with x, y, z last"
            )
        wi, wo = (np.broadcast_to(w, shape).reshape(-1, 3) for w in (wi, wo))
        finite = np.isfinite(wi).all(axis=1) & np.isfinite(wo).all(axis=1)
        above = finite & directions.above(wi, wo)
        result = np.where(finite, 0.0, np.nan)[:, None] * np.ones(len(self.channels))
        result[above] = self._eval(wi[above], wo[above])
        return result.reshape(*shape[:-1], len(self.channels))

    def _eval(self, wi: NDArray[np.float64], wo: NDArray[np.float64]) -> NDArray[np.float64]:
        # A surface with a mirror symmetry is measured over part of the circle only: bring wi there, and wo along.
        flip_y = flip_x = np.ones(len(wi))
        if self._symmetry >= 2:
            flip_y = np.where(wi[:, 1] >= 0, -1.0, 1.0)
            flip_x = np.where(wi[:, 0] >= 0, -1.0, 1.0) if self._symmetry == 4 else flip_y
        flip = np.stack([flip_x, flip_y, np.ones(len(wi))], axis=-1)
        wi, wo = wi * flip, wo * flip
        wm = wi + wo
        theta_i, phi_i = directions.theta(wi), directions.phi(wi)
        phi_m = directions.phi(wm) - (phi_i if self.isotropic else 0)
        u = np.stack([np.sqrt(directions.theta(wm) / directions.HALF_PI), (phi_m + np.pi) / (2 * np.pi) % 1], axis=-1)
        nodes = self._nodes(phi_i, theta_i)
        s = self._warp.invert(u, nodes)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            value = self._grid.eval(s, nodes)
            if self.jacobian:
                u_i = np.stack([np.sqrt(theta_i / directions.HALF_PI), (phi_i + np.pi) / (2 * np.pi)], axis=-1)
                value *= self._ndf.eval(u) / (4 * self._sigma.eval(u_i))
            return value / wo[:, 2:]

    def directions(self, resolution: int) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Pairs of directions that follow the lobe: the file's incident directions x `resolution`^2 centres of cells of
        the warped square.

        Returns
        -------
        wi, wo
            (N, 3); some of wo lie below the horizon.
        weights
            (N,) solid angle of the cell [sr] x that of the node of theta_i: d omega_o = 4 (wi.wm) d omega_m, and
            d omega_m = 2 pi^2 u_x sin(theta_m) d u = 2 pi^2 u_x sin(theta_m) d s / density(u).
        """
        centres = (np.arange(resolution) + 0.5) / resolution
        s = np.stack(np.meshgrid(centres, centres, indexing="xy"), axis=-1).reshape(-1, 2)
        polar = node_weights(self.theta_i)
        parts = []
        for p, phi_i in enumerate(self.phi_i if not self.isotropic else self.phi_i[:1]):
            for t, theta_i in enumerate(self.theta_i):
                if np.cos(theta_i) <= directions.HORIZON:
                    continue
                u, density = self._warp.sample(s, p, t)
                theta_m = u[:, 0] ** 2 * directions.HALF_PI
                phi_m = (2 * u[:, 1] - 1) * np.pi + (phi_i if self.isotropic else 0)
                wm = directions.from_spherical(theta_m, phi_m)
                wi = np.broadcast_to(directions.from_spherical(theta_i, phi_i), wm.shape)
                cos_d = np.sum(wi * wm, axis=-1)
                with np.errstate(divide="ignore", invalid="ignore"):
                    solid_angle = (
                        8 * np.pi**2 * np.maximum(cos_d, 0) * u[:, 0] * np.sin(theta_m) / (density * resolution**2)
                    )
                weight = np.where(np.isfinite(solid_angle), solid_angle, 0.0) * polar[t]
                parts.append((wi, 2 * cos_d[:, None] * wm - wi, weight))
        if not parts:
            raise DataError("The file has no incident direction above the horizon", "It is damaged")
        wi, wo, weights = (np.concatenate(x) for x in zip(*parts, strict=True))
        return wi, wo, weights

    @cached_property
    def _symmetry(self) -> int:
        """How many times the measured range of phi_i covers the circle; 0 for an isotropic material."""
        return 0 if self.isotropic else int(np.rint(2 * np.pi / (self.phi_i[-1] - self.phi_i[0])))

    @cached_property
    def _warp(self) -> Warp:
        return Warp(self.vndf)

    @cached_property
    def _grid(self) -> Grid:
        return Grid(np.moveaxis(self.values, 2, -1))

    @cached_property
    def _ndf(self) -> Grid:
        return Grid(self.ndf[None, None, :, :, None])

    @cached_property
    def _sigma(self) -> Grid:
        return Grid(self.sigma[None, None, :, :, None])

    def _nodes(
        self, phi_i: NDArray[np.float64], theta_i: NDArray[np.float64]
    ) -> list[tuple[NDArray[np.intp], NDArray[np.intp], NDArray[np.float64]]]:
        """The incident nodes around each direction and their weights: 2 of theta_i, times 2 of phi_i if anisotropic."""
        t0, t1, wt = bracket(self.theta_i, theta_i)
        if self.isotropic:
            zero = np.zeros_like(t0)
            return [(zero, t0, 1 - wt), (zero, t1, wt)]
        p0, p1, wp = bracket(self.phi_i, phi_i)
        return [(p, t, a * b) for p, a in ((p0, 1 - wp), (p1, wp)) for t, b in ((t0, 1 - wt), (t1, wt))]
