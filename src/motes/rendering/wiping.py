"""Where dust was taken off again: strokes of a brush or a finger, a painted mask, something that rubs against the surface."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import final

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.images import photograph
from motes.meshes.meshfile import LARGEST
from motes.rendering.gathering import smooth_step
from motes.rendering.noise import gradient_noise

Floats = NDArray[np.float64]


@final
@dataclass(frozen=True, eq=False)
class Stroke:
    """A stroke of a brush through points in space, which takes dust off whatever it passes.

    Parameters
    ----------
    points
        (K, 3), K >= 1, in the units of the mesh.
    radius
        Half the width of the brush.
    strength
        The share of the dust that it takes, 0 to 1.
    bristles
        How many streaks of left dust there are across its width; 0 for a smooth cloth.
    """

    points: Floats
    radius: float
    strength: float = 1.0
    bristles: int = 12

    def __post_init__(self) -> None:
        points = np.asarray(self.points, np.float64)
        if points.ndim != 2 or points.shape[1] != 3 or not len(points):
            raise MotesError(f"a stroke has points of shape {points.shape}", "Give one or more points of x, y, z")
        if not (np.abs(points) <= LARGEST).all():
            raise MotesError(
                f"a stroke goes through a coordinate that is not a number within {LARGEST:g}",
                "Give x, y, z of the mesh",
            )
        if not 1 / LARGEST <= self.radius <= LARGEST:
            raise MotesError(f"a stroke has the radius {self.radius:g}", "Give a length above 0, in units of the mesh")
        if not 0 <= self.strength <= 1:
            raise MotesError(f"a stroke has the strength {self.strength:g}", "Give the share that it takes, 0 to 1")
        object.__setattr__(self, "points", points)

    def taken(self, points: Floats, seed: int) -> Floats:
        """The share of the dust that is gone at points (N, 3), (N,)."""
        distance, side = self._distance(points)
        inside = 1 - smooth_step((distance / self.radius - 0.85) / 0.15)
        if self.bristles:
            # Hairs leave streaks along the stroke: noise that varies across it alone.
            across = np.stack([0.5 * self.bristles * side / self.radius, 0 * side + 0.37, 0 * side + 0.71], -1)
            inside = inside * (1 - np.clip(2.5 * gradient_noise(across, seed), 0, 0.9))
        return self.strength * inside

    def _distance(self, points: Floats) -> tuple[Floats, Floats]:
        """The distance to the line of the stroke, and the same with a sign that tells its two sides apart."""
        least = np.full(len(points), np.inf)
        side = np.zeros(len(points))
        starts = self.points[:-1] if len(self.points) > 1 else self.points
        ends = self.points[1:] if len(self.points) > 1 else self.points
        for a, b in zip(starts, ends, strict=True):
            along = b - a
            t = np.clip((points - a) @ along / max(float(along @ along), 1e-300), 0, 1)
            off = points - a - t[:, None] * along
            distance = np.linalg.norm(off, axis=1)
            closer = distance < least
            # A direction across the stroke; which one does not matter, but all points must agree on it.
            across = np.cross(along, [0.3, 0.9, 0.2])
            least = np.where(closer, distance, least)
            side = np.where(closer, np.copysign(distance, off @ across), side)
        return least, side


def read_mask(path: str | os.PathLike[str]) -> Floats:
    """A picture as numbers (H, W) in [0, 1], the mean of its colours, the top row first: 1 is wiped clean.

    Eight-bit pictures are taken as they are stored, without sRGB's curve: a painted mask means its numbers.

    Raises
    ------
    FormatError
        When it is not there, not a picture, or holds something that is not a number.
    """
    return photograph.read_mask(Path(path))


def look_up(picture: Floats, uv: Floats) -> Floats:
    """A picture (H, W), its top row at v = 1, at texture coordinates (N, 2): bilinear, repeating."""
    height, width = picture.shape
    x, y = uv[:, 0] * width - 0.5, (1 - uv[:, 1]) * height - 0.5
    left, top = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    fx, fy = x - left, y - top

    def at(row: NDArray[np.int64], column: NDArray[np.int64]) -> Floats:
        return np.asarray(picture[row % height, column % width])

    upper = (1 - fx) * at(top, left) + fx * at(top, left + 1)
    lower = (1 - fx) * at(top + 1, left) + fx * at(top + 1, left + 1)
    return np.asarray((1 - fy) * upper + fy * lower)
