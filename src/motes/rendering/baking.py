"""Dust as a texture: the deposit at the centre of each texel, for programs that take pictures rather than numbers at vertices."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.files import replacing
from motes.meshes.mesh import Mesh
from motes.rendering.deposition import Deposit, Points, deposit
from motes.rendering.loading import native
from motes.rendering.rays import Surroundings

LARGEST = 8192
SUFFIXES = (".exr", ".pfm")
GROWN = 8  # texels by which islands are widened, so that filtering at their edges finds dust


class Baked(NamedTuple):
    """The deposit at the covered texels, and which these are: a mask (size, size), the top row at v = 1."""

    deposit: Deposit
    covered: NDArray[np.bool_]

    def texture(self, open_tau: float) -> NDArray[np.float32]:
        """tau (size, size); the surroundings of the islands are filled from their edges, the rest is 0."""
        picture = np.zeros(self.covered.shape, np.float32)
        picture[self.covered] = self.deposit.tau(open_tau)
        return _grown(picture, self.covered)


def bake(mesh: Mesh, size: int = 1024, **arguments: Any) -> Baked:
    """`deposit` at the texels of a square texture.

    Parameters
    ----------
    mesh
        With texture coordinates; what lies outside the unit square is not baked.
    size
        Texels along a side.
    arguments
        Of `deposit`.

    Raises
    ------
    MotesError
        For a mesh without texture coordinates, a size out of range, or nothing within the unit square.
    """
    if mesh.uv is None or mesh.normals is None:
        raise MotesError(
            f"{mesh.name} has no texture coordinates", "Unwrap it, or write tau at the vertices: -o NAME.ply"
        )
    if not 1 <= size <= LARGEST:
        raise MotesError(f"a texture of {size} x {size}", f"Choose a size from 1 to {LARGEST}")
    # The mesh laid out flat in its own texture; rays straight down tell which triangle each texel belongs to.
    flat = replace(
        mesh,
        positions=np.concatenate([mesh.uv, np.zeros((len(mesh.uv), 1))], axis=1),
        normals=None,
        uv=None,
        attributes={},
    )
    centres = (np.arange(size) + 0.5) / size
    u, v = np.meshgrid(centres, centres[::-1])
    origins = np.stack([u.ravel(), v.ravel(), np.full(u.size, 1.0)], -1)
    triangle, weights = Surroundings([flat]).crossings(origins, np.array([0.0, 0.0, -1.0]))
    covered = triangle >= 0
    if not covered.any():
        raise MotesError(
            f"the texture coordinates of {mesh.name} cover no texel of the unit square",
            "Unwrap it into the square from 0 to 1, or choose a larger texture",
        )
    corners = mesh.triangles[triangle[covered]]
    b = weights[covered][:, :, None]
    normals = (mesh.normals[corners] * b).sum(1)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    places = Points((mesh.positions[corners] * b).sum(1), normals, (mesh.uv[corners] * b).sum(1))
    return Baked(deposit(mesh, where=places, **arguments), covered.reshape(size, size))


def _grown(picture: NDArray[np.float32], covered: NDArray[np.bool_]) -> NDArray[np.float32]:
    """The picture with the means of covered neighbours in the texels around, `GROWN` times over."""
    height, width = picture.shape
    picture, covered = picture.copy(), covered.copy()
    for _ in range(GROWN):
        padded, known = np.pad(picture * covered, 1), np.pad(covered.astype(np.float32), 1)
        total = np.zeros_like(picture)
        count = np.zeros_like(picture)
        for i, j in np.ndindex(3, 3):
            total += padded[i : i + height, j : j + width]
            count += known[i : i + height, j : j + width]
        new = ~covered & (count > 0)
        picture[new] = total[new] / count[new]
        covered |= new
    return picture


def write_texture(path: str | os.PathLike[str], picture: NDArray[np.float32]) -> Path:
    """Write numbers (H, W), or colours (H, W, 3), as EXR or PFM in float32, whole or not at all.

    Raises
    ------
    MotesError
        For another suffix, or when the file cannot be written.
    """
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    target = Path(path)
    if target.suffix.lower() not in SUFFIXES:
        raise MotesError(f"{target} is not a texture by its name", f"Textures are {' and '.join(SUFFIXES)} files")
    with replacing(target) as temporary:
        # Mitsuba goes by the suffix, which the temporary file does not have.
        kind = mi.Bitmap.FileFormat.OpenEXR if target.suffix.lower() == ".exr" else mi.Bitmap.FileFormat.PFM
        mi.Bitmap(np.ascontiguousarray(picture, np.float32)).write(native(temporary), kind)
    return target
