"""A tensor tree in a BSDF file of Radiance: an isotropic BRDF in cells that are small where it changes.

The finest cells are 1/64 of the cube's edge (`motes.measurements._tree_cells`), each the mean of 8 points; cells that differ
by little are joined.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from motes.exports import tristimulus, window_xml
from motes.exports.subject import Subject
from motes.measurements._tree_cells import serialize, to_disk

SUFFIX = ".xml"
HALVINGS = 6
PER_AXIS = 2  # points across a cell
TOLERANCE = 0.005  # cells within this of their mean are joined
CHROMATICITY_TOLERANCE = 0.001


def limits(subject: Subject) -> list[str]:
    """What the format cannot say."""
    return [
        *window_xml.limits(subject),
        f"Cells are 1/{2**HALVINGS} of a hemisphere's width; those that differ by less than {TOLERANCE:.1%} are joined.",
    ]


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the tree."""
    names, f = tristimulus.evaluator(subject)
    n = 2**HALVINGS
    inner = (np.arange(n * PER_AXIS) + 0.5) / (n * PER_AXIS)
    square = np.stack(np.meshgrid(inner, inner, indexing="ij"), axis=-1).reshape(-1, 2)
    x, y = to_disk(square)
    wo = np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], axis=-1)
    grid = np.zeros((n, n, n, len(names)))
    for k in range(n // 2):  # the upper half is not used
        total = np.zeros((len(wo), len(names)))
        for u in inner[PER_AXIS * k : PER_AXIS * (k + 1)]:
            sin = 1 - 2 * u
            wi = np.broadcast_to([-sin, 0.0, np.sqrt(1 - sin**2)], wo.shape)
            total += f(np.ascontiguousarray(wi), wo)
        mean = (total / PER_AXIS).reshape(n, PER_AXIS, n, PER_AXIS, len(names)).mean(axis=(1, 3))
        grid[k] = mean
    trees = _named(grid, names)
    basis = "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>"
    blocks = {
        name: (basis, serialize(tree, TOLERANCE if name == "Visible" else CHROMATICITY_TOLERANCE))
        for name, tree in trees.items()
    }
    definition = "<IncidentDataStructure>TensorTree3</IncidentDataStructure>"
    return window_xml.write(subject, path, definition, blocks)


def _named(grid: np.ndarray, names: tuple[str, ...]) -> dict[str, np.ndarray]:
    """The trees that Radiance reads: Y, and for colours the chromaticity u', v' (CIE 1976)."""
    if len(names) == 1:
        return {"Visible": grid[..., 0]}
    x, y, z = np.moveaxis(grid, -1, 0)
    sum_ = x + 15 * y + 3 * z
    with np.errstate(divide="ignore", invalid="ignore"):
        u = np.where(sum_ > 0, 4 * x / sum_, 4 / 19)
        v = np.where(sum_ > 0, 9 * y / sum_, 9 / 19)
    return {"Visible": y, "CIE-u": u, "CIE-v": v}
