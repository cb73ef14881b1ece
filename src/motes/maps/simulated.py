"""`simulate_map`: a small surface that dries and loses its gloss, every texel another, measured with noise; the truth is kept."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.directions import from_spherical
from motes.errors import ParameterError
from motes.maps import making, zarrs
from motes.maps.stack import MapStack, create_map, open_stack
from motes.models import BRDF, describe, parse

Floats = NDArray[np.float64]
#: A surface: row and column indices and hours, which broadcast, to parameters by name; K_d has the channels last.
Surface = Callable[[Floats, Floats, Floats], Mapping[str, Floats]]

MODEL = "oren_nayar + torrance_sparrow"
DRYING_TIME = 1.5  # hours


def simulate_map(
    path: str | os.PathLike[str],
    size: tuple[int, int] = (64, 64),
    *,
    times: int = 4,
    hours: float = 6.0,
    lights: int = 24,
    noise: float = 0.01,
    seed: int = 0,
    chunk: int = 32,
    progress: Callable[[int, int, str], None] | None = None,
) -> MapStack:
    """Write a map of a drying surface: oren_nayar + torrance_sparrow with another value of every parameter at every texel.

    Parameters
    ----------
    path
        The Zarr store; nothing may be there.
    size
        Rows and columns of texels.
    times, hours
        How many times, from 0 to so many hours.
    lights
        Places of the light, each seen by two viewers: from above, and from 40 degrees.
    noise
        Relative standard deviation of every value.
    seed
        Of the noise.
    chunk
        Rows and columns of texels in a chunk.
    progress
        Called with (done, total, what) in texels.

    Returns
    -------
    MapStack
        Its `truth` holds the parameters.
    """
    if min(*size, times, lights, chunk) < 1 or not 0 <= noise < 1 or not hours > 0:
        raise ParameterError(
            f"a map of {size} texels, {times} times over {hours:g} h, {lights} lights, noise {noise:g}",
            "Sizes are at least 1, hours above 0, the noise from 0 to below 1",
        )
    wi, wo = two_views(lights)
    at = np.linspace(0, hours, times)

    def surface(y: Floats, x: Floats, t: Floats) -> dict[str, Floats]:
        return drying_surface(y / max(size[0] - 1, 1), x / max(size[1] - 1, 1), t)

    with making.whole(path) as store:
        stack = create_map(
            store, size, wi, wo, hours=at, chunk=chunk, compressed=False,
            attributes={"source": "simulated by Motes", "notes": [f"relative noise {noise:g}, seed {seed}"]},
        )  # fmt: skip
        fill(stack, MODEL, surface, noise, seed, progress)
    return open_stack(path)


def two_views(lights: int) -> tuple[Floats, Floats]:
    """Directions (2 N, 3): N lights on a spiral to 75 degrees, half of them within 30, each from above and from 40 degrees."""
    k = np.arange(lights) + 0.5
    share = k / lights
    theta = np.radians(np.where(share < 0.5, 60 * share, 30 + 90 * (share - 0.5)))
    phi = k * np.pi * (3 - np.sqrt(5))
    wi = from_spherical(theta, phi)
    views = from_spherical(np.radians([0.0, 40.0]), 0.0)
    return np.tile(wi, (2, 1)), np.repeat(views, lights, axis=0)


def drying_surface(y: Floats, x: Floats, t: Floats) -> dict[str, Floats]:
    """Parameters at positions (y, x) in [0, 1] and times [h]: stripes of paint that dry from the left."""
    wet = np.exp(-np.maximum(t - 1.2 * x, 0) / DRYING_TIME)
    stripes = 0.5 + 0.5 * np.sin(2 * np.pi * (3 * x + 1.5 * y + 0.6 * np.sin(2 * np.pi * y)))
    first, second = np.array([0.72, 0.42, 0.25]), np.array([0.25, 0.45, 0.62])
    colour = first * stripes[..., None] + second * (1 - stripes[..., None])
    return {
        "K_d": colour * (1 - 0.4 * wet)[..., None],
        "sigma_d": 0.25 + 0.35 * y + 0 * wet,
        "K_s": 0.05 + 0.35 * wet * (0.6 + 0.4 * stripes),
        "sigma_s": 0.1 + 0.12 * (1 - wet) + 0.08 * stripes,
    }


def fill(
    stack: MapStack,
    model: str | BRDF,
    surface: Surface,
    noise: float,
    seed: int,
    progress: Callable[[int, int, str], None] | None = None,
) -> None:
    """Measure a surface into an empty map, block by block, with relative noise; keep the parameters under ``truth``."""
    brdf = model if isinstance(model, BRDF) else parse(model).model
    colours = {slot.name: slot.parameter.per_channel for slot in brdf.slots()}
    group = zarrs.open_group(stack.path, mode="r+").create_group("truth")
    group.attrs["model"] = describe(brdf)
    arrays: dict[str, Any] = {}
    total, done = stack.shape[0] * stack.shape[1], 0
    for block in stack.blocks:
        rows, columns = stack.blocks.slices(block)
        y, x = np.meshgrid(*(np.arange(s.start, s.stop, dtype=float) for s in (rows, columns)), indexing="ij")
        true = {
            name: np.broadcast_to(v, (*y.shape, len(stack.hours), *v.shape[3:]))
            for name, v in surface(y[..., None], x[..., None], stack.hours).items()
        }
        for name, value in true.items():
            if name not in arrays:
                dims = ("y", "x", "time", *(("channel",) if value.ndim == 4 else ()))
                arrays[name] = zarrs.add(
                    group,
                    name,
                    dims=dims,
                    shape=(*stack.shape, *value.shape[2:]),
                    chunks=(*stack.blocks.block, *value.shape[2:]),
                )
            arrays[name][rows, columns] = value.astype(np.float32)
        rng = np.random.default_rng([seed, *block])
        values = np.empty((*y.shape, *stack.sizes), np.float32)
        for k, row in enumerate(values):  # a row of texels at a time: what is held beside the block stays small
            at = brdf.with_parameters({n: _for_directions(v[k], colours[n]) for n, v in true.items()})
            row[...] = at.eval(stack.wi, stack.wo)
            row *= 1 + noise * rng.standard_normal(row.shape, np.float32)
        stack.write(rows.start, columns.start, values)
        done += y.size
        if progress:
            progress(done, total, "simulating")


def _for_directions(value: Floats, colour: bool) -> ArrayLike:
    """Values (x, T) or (x, T, C) with an axis for directions."""
    if value.ndim == 3:
        return value[:, :, None, :]
    return value[:, :, None, None] if colour else value[:, :, None]
