"""Meshes from files, checked and mended.

Files are PLY (ASCII, binary of either byte order), OBJ, STL and glTF (.glb, .gltf).  What a file lacks or has wrong is mended where that is harmless,
and said in `Mesh.notes`: normals are computed, triangles without an area are left out.  What would show in a picture as nonsense (positions that are not
numbers, indices beyond the vertices) is an error.  Faces that look inwards are said, and turned when asked for.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MotesError
from motes.meshes import by_trimesh, obj, ply, winding
from motes.meshes.mesh import Mesh, cross_products, with_normals

READERS: dict[str, Callable[[Path], Mesh]] = {
    ".ply": ply.read_ply,
    ".obj": obj.read_obj,
    ".stl": by_trimesh.read_stl,
    ".glb": by_trimesh.read_gltf,
    ".gltf": by_trimesh.read_gltf,
}
SUFFIXES = tuple(READERS)
#: The largest coordinate: glTF and USD hold single precision, to 3e38, and squares of distances stay numbers in doubles.
LARGEST = 1e30
_SINGLE = float(np.finfo(np.float32).max)
TURN = "motes dust --outwards turns them"


def read_mesh(path: str | os.PathLike[str], *, outwards: bool = False) -> Mesh:
    """Read a PLY, OBJ, STL or glTF file, checked and mended.

    Parameters
    ----------
    path
        The file; its suffix says what it is.
    outwards
        Turn faces so that neighbours agree and closed surfaces look outwards.

    Raises
    ------
    MissingExtraError
        Without the package trimesh, for STL and glTF.
    FormatError
        When the file is not there, is none of these, is damaged, or holds no triangle with an area.
    """
    file = Path(path)
    suffix = file.suffix.lower()
    if suffix not in READERS:
        raise FormatError(
            f"{file} is not a mesh by its name: {suffix or 'no suffix'}",
            f"Meshes are {', '.join(SUFFIXES)} files; Blender exports them",
        )
    try:
        raw = READERS[suffix](file)
        return mended(raw, outwards)
    except MotesError:
        raise
    except OSError as error:
        raise FormatError(f"{file} cannot be read: {error.strerror or error}", "Give the path of a mesh") from error
    except (ValueError, OverflowError, LookupError, TypeError, RecursionError) as error:
        said = " ".join(str(error).split())[:100] or type(error).__name__
        raise FormatError(f"{file} cannot be read as a mesh: {said}", "The file is damaged; export it again") from None


def mended(mesh: Mesh, outwards: bool = False) -> Mesh:
    """The mesh, checked: triangles without an area left out, normals that are missing or not numbers computed, faces turned outwards if asked for.

    Raises
    ------
    FormatError
        For positions that are not finite, indices beyond the vertices, or no triangle that has an area.
    """
    n = len(mesh.positions)
    bad = ~np.isfinite(mesh.positions).all(axis=1)
    if bad.any():
        raise FormatError(
            f"{mesh.name} has {int(bad.sum())} of {n} vertices whose position is not finite, the first is vertex {int(np.argmax(bad))}",
            "Export it again; a modifier that divides by zero is a usual cause",
        )
    if n and (largest := float(np.abs(mesh.positions).max())) > LARGEST:
        raise FormatError(
            f"{mesh.name} has a coordinate of {largest:.3g}, beyond {LARGEST:g}",
            "Export it again in metres; what is larger has no areas that can be computed",
        )
    if mesh.triangles.size and (mesh.triangles.min() < 0 or mesh.triangles.max() >= n):
        worst = mesh.triangles.max() if mesh.triangles.max() >= n else mesh.triangles.min()
        raise FormatError(f"{mesh.name} has a face with vertex {int(worst)} of {n} vertices", "The file is damaged")
    notes = list(mesh.notes)
    area = np.linalg.norm(cross_products(mesh), axis=1)
    longest = float(np.ptp(mesh.positions, axis=0).max()) if n else 0.0
    keep = area > 1e-14 * longest**2
    if not keep.any():
        raise FormatError(f"{mesh.name} has no triangle with an area", "Export the mesh with its faces")
    if not keep.all():
        notes.append(f"{int((~keep).sum())} of {len(keep)} triangles have no area and were left out")
        mesh = replace(mesh, triangles=mesh.triangles[keep])
    if mesh.uv is not None and not (np.abs(mesh.uv) <= _SINGLE).all():
        notes.append("the texture coordinates are not all numbers of single precision and were left out")
        mesh = replace(mesh, uv=None)
    # What is not a number says that there is none; a number that a file of single precision cannot hold says nothing.
    if huge := [name for name, values in mesh.attributes.items() if _beyond_single(values)]:
        notes.append(f"{' and '.join(huge)} of the vertices holds numbers beyond single precision and was left out")
        mesh = replace(mesh, attributes={name: v for name, v in mesh.attributes.items() if name not in huge})
    if outwards:
        turned = winding.turned_outwards(replace(mesh, notes=()))
        notes += turned.notes
        mesh = replace(turned, notes=mesh.notes)
    if mesh.normals is not None:
        length = np.linalg.norm(np.where(np.abs(mesh.normals) <= LARGEST, mesh.normals, np.nan), axis=1)
        good = np.isfinite(length) & (length > 1e-6)
        used = np.unique(mesh.triangles)
        if good[used].all():
            normals = np.where(good[:, None], mesh.normals / np.where(good, length, 1)[:, None], 0)
            mesh = replace(mesh, normals=np.nan_to_num(normals))
            return replace(mesh, notes=(*notes, *_sides(mesh)))
        notes.append(f"{int((~good[used]).sum())} normals have no direction; all were computed anew")
    else:
        notes.append("the file has no normals; they were computed")
    mesh = replace(mesh, normals=None)
    return with_normals(replace(mesh, notes=(*notes, *_sides(mesh))))


def _beyond_single(values: NDArray[np.float64]) -> bool:
    """Whether some of the numbers are finite and yet too large for single precision, in which meshes are written."""
    return bool((np.isfinite(values) & (np.abs(values) > _SINGLE)).any())


def _sides(mesh: Mesh) -> list[str]:
    """What is to be said of the sides to which faces, or the normals of the file, look."""
    found = winding.examined(mesh.positions, mesh.triangles)
    sign = 1.0
    if mesh.normals is not None:
        towards = np.einsum("ij,ij->i", cross_products(mesh), mesh.normals[mesh.triangles].sum(axis=1))
        sign = float(np.sign(towards.sum()))
    elif found.disagreeing:
        return [f"faces disagree on which side is out along {found.disagreeing} of {found.edges} edges; {TURN}"]
    if found.closed and sign * found.volume < 0:
        what = "faces" if mesh.normals is None else "normals"
        return [f"the mesh is inside out: its {what} point inwards (its volume is {sign * found.volume:.3g}); {TURN}"]
    return []
