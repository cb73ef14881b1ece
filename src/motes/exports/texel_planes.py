"""Values at scattered points by planes through those of the points around them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: Nodes that a plane goes through, as nearly as it can; the nearer ones count more.
NEIGHBOURS = 16
#: What keeps planes flat along directions in which nodes do not differ, relative to the spread of the points.
RIDGE = 1e-3
#: Points at a time: their distances to a thousand nodes are 4 MB.
TOGETHER = 512


class Between(NamedTuple):
    """Values (M, S), and for each point the mean over its nodes of what is known of them (M,), by the same weights."""

    values: Floats
    known: Floats


def between(points: Floats, nodes: Floats, values: Floats, known: Floats) -> Between:
    """Values at points.

    Parameters
    ----------
    points
        (M, P), in coordinates of about the same spread.
    nodes
        (N, P), more than `NEIGHBOURS` of them.
    values
        (N, S) at the nodes.
    known
        (N,) something else that is known of them.
    """
    found = Between(np.empty((len(points), values.shape[1])), np.empty(len(points)))
    for start in range(0, len(points), TOGETHER):
        part = slice(start, start + TOGETHER)
        here = points[part]
        squares = (here * here).sum(axis=1)[:, None] + (nodes * nodes).sum(axis=1) - 2 * here @ nodes.T
        nearest = np.argpartition(squares, NEIGHBOURS, axis=1)[:, :NEIGHBOURS]
        weight = 1 / (np.sqrt(np.maximum(np.take_along_axis(squares, nearest, 1), 0.0)) + 1e-3)
        off = nodes[nearest] - here[:, None]
        columns = np.concatenate([np.ones((*off.shape[:2], 1)), off], axis=-1)
        heavy = weight[..., None] * columns
        normal = np.swapaxes(heavy, 1, 2) @ columns + RIDGE * np.eye(columns.shape[-1])
        right = np.swapaxes(heavy, 1, 2) @ values[nearest]
        found.values[part] = np.linalg.solve(normal, right)[:, 0]
        found.known[part] = (weight * known[nearest]).sum(axis=1) / weight.sum(axis=1)
    return found
