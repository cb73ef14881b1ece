"""`MapStack`: reflectance measured at every texel of a surface, as a Zarr store of chunks; `create_map`, `open_stack`."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.channels import RGB, names_or_default
from motes.errors import DataError, FormatError, ParameterError
from motes.maps import making, zarrs
from motes.maps.blocks import Blocks, block_shape
from motes.maps.opening import check, hours_of, reflectance, vectors
from motes.maps.zarrs import AXES, NAME
from motes.measurements import policy

#: Bytes that the name of a channel takes.
NAMED = 100

Singles = NDArray[np.float32]
Floats = NDArray[np.float64]


@final
@dataclass(frozen=True, eq=False)
class MapStack:
    """Measured reflectance f_r [1/sr] of a surface: (y, x, time, direction, channel), read by blocks of texels.

    Parameters
    ----------
    path
        Of the Zarr store.
    wi, wo
        (D, 3): one light and one viewer a direction, the same for all texels (both are distant).
    hours
        (T,) [h].
    channels
        C names.
    weights
        (D,), or None for all alike.
    blocks
        How the texels are divided for reading.
    array
        The Zarr array, float32 unless it says otherwise; NaN = not measured.
    attributes
        Of the store.
    time
        Which of the array's times it is, where it is one; None for all.
    """

    path: Path
    wi: Floats
    wo: Floats
    hours: Floats
    channels: tuple[str, ...]
    weights: Floats | None
    blocks: Blocks
    array: Any = field(repr=False)
    attributes: Mapping[str, Any] = field(repr=False)
    time: int | None = None

    @property
    def name(self) -> str:
        return str(self.attributes.get("name") or self.path.stem)

    @property
    def shape(self) -> tuple[int, int]:
        """(y, x): rows and columns of texels."""
        return self.blocks.shape

    @property
    def sizes(self) -> tuple[int, int, int]:
        """Times, directions, channels."""
        return len(self.hours), len(self.wi), len(self.channels)

    @property
    def reads_per_chunk(self) -> float:
        """How often a chunk of the store is read for all blocks to be read once; 1 where chunks are whole."""
        inner = math.prod(self.array.chunks[:2])
        return max(1.0, float(inner / math.prod(self.blocks.block)))

    def read_block(self, block: tuple[int, int]) -> Singles:
        """The values of a block (y, x, T, D, C), float32; NaN where it cannot be a value: see `usable`."""
        return self._values(self.blocks.slices(block))

    def at(self, time: int | None) -> MapStack:
        """The same map at one of its times, from 0; the whole of it for None."""
        if time is None:
            return self
        if self.time is not None or not 0 <= time < len(self.hours):
            raise DataError(
                f"time {time} is outside 0..{len(self.hours) - 1} of {self.path}", "Choose one of its times"
            )
        return replace(self, hours=self.hours[time : time + 1], time=time)

    def texels(self, y: int, x: int) -> Singles:
        """The values (T, D, C) of one texel."""
        return np.asarray(self._values((slice(y, y + 1), slice(x, x + 1)))[0, 0])

    def write(self, y: int, x: int, values: ArrayLike) -> None:
        """Put values (h, w, T, D, C) with their first texel at (y, x); whole chunks are quickest."""
        data = np.asarray(values, np.float32)
        if data.ndim != 5 or data.shape[2:] != self.sizes:
            raise DataError(
                f"values of shape {data.shape} do not fit a map (y, x, {', '.join(map(str, self.sizes))})",
                "Give texels with all times, directions and channels",
            )
        h, w = data.shape[:2]
        try:
            self.array[y : y + h, x : x + w, self._times] = data
        except OSError as error:
            raise zarrs.Unwritable(self.path, error) from error

    @cached_property
    def truth(self) -> Mapping[str, Any]:
        """Arrays of the parameters that are true of a simulated map, by name; empty for others."""
        truth = zarrs.member(zarrs.open_group(self.path), "truth", self.path)
        return {} if truth is None else zarrs.arrays(truth, self.path)

    def to_xarray(self) -> Any:
        """The store as an `xarray.Dataset`, its values read when they are used."""
        return open_dataset(self.path, self.channels)

    def summary(self) -> dict[str, Any]:
        """What ``motes info`` prints; plain JSON types."""
        times, directions, channels = self.sizes
        cells = math.prod(self.shape) * times * directions * channels
        return {
            "kind": "reflectance map",
            "name": self.name,
            "path": str(self.path),
            "shape": list(self.shape),
            "n_times": times,
            "times": self.hours.tolist(),
            "n_directions": directions,
            "n_channels": channels,
            "channels": list(self.channels),
            "theta_i_deg": _range(self.wi),
            "theta_r_deg": _range(self.wo),
            "weighted": self.weights is not None,
            "dtype": str(self.array.dtype),
            "chunks": list(self.array.chunks),
            "blocks": list(self.blocks.counts),
            "bytes": cells * self.array.dtype.itemsize,
            "truth": sorted(self.truth),
            "source": str(self.attributes.get("source", "")),
            "notes": [str(n) for n in self.attributes.get("notes") or ()],
        }

    @property
    def _times(self) -> slice:
        return slice(None) if self.time is None else slice(self.time, self.time + 1)

    def _values(self, where: tuple[slice, slice]) -> Singles:
        values = np.ascontiguousarray(zarrs.values(self.array, self.path, np.float32, (*where, self._times)))
        if values.min() >= 0 and values.max() < np.inf:  # NaN fails both; as good as always, and four times as quick
            return values
        return usable(values if values.flags.writeable else values.copy())


def usable(values: Singles) -> Singles:
    """Values (..., T, D, C) with NaN, in place, for what cannot be a value: infinite, or negative beyond noise.

    As in `motes.measurements.policy`, negative values that noise explains are data, for to leave them out would brighten
    what is dark.  A texel has few samples to tell its noise by, so the bound is coarse: no further below 0 than its
    brightest sample is above it.  Markers such as -1 and -999 are beyond that, and so is a texel without a positive one.
    Cost: a marker of -1 stays among the data of a texel that has a highlight above 1/sr.
    """
    with np.errstate(invalid="ignore"):
        values[~(np.abs(values) < np.inf)] = np.nan
        if np.nanmin(values, initial=0) < 0:
            # fmax ignores NaN; 0 for a texel without a value
            brightest = np.fmax.reduce(values, axis=(-3, -2, -1), keepdims=True, initial=0)
            values[values < -brightest] = np.nan
    return values


def open_dataset(path: Path, channels: Sequence[str]) -> Any:
    """A store as an `xarray.Dataset` with the channels named."""
    from motes.errors import MissingExtraError

    try:
        import xarray
    except ImportError:
        raise MissingExtraError("xarray", "scale", "A dataset") from None
    return xarray.open_zarr(str(path), consolidated=False, chunks=None).assign_coords(channel=list(channels))


def create_map(
    path: str | os.PathLike[str],
    shape: tuple[int, int],
    wi: ArrayLike,
    wo: ArrayLike,
    *,
    hours: ArrayLike = (0.0,),
    channels: Sequence[str] = RGB,
    wavelengths: ArrayLike | None = None,
    weights: ArrayLike | None = None,
    chunk: int | tuple[int, int] = 64,
    name: str | None = None,
    attributes: Mapping[str, Any] | None = None,
    compressed: bool = True,
) -> MapStack:
    """A new, empty map (all NaN), to fill with `MapStack.write`.

    Parameters
    ----------
    path
        The Zarr store; nothing may be there.
    shape
        Rows and columns of texels.
    wi, wo
        Unit vectors (D, 3) above the horizon; one of them may be (3,) for all.
    hours
        (T,), increasing [h].
    channels, wavelengths
        C names, and (C,) [nm] where they are spectral.
    weights
        (D,), the solid angles that directions stand for; None for all alike.
    chunk
        Rows and columns of texels in a chunk; a chunk holds all times, directions and channels of its texels.
    name
        Of the map; that of the store when not given.
    attributes
        Further attributes: ``source``, ``notes``.
    compressed
        False to save time on noisy float32, which hardly shrinks.

    Raises
    ------
    MotesError
        When something is at the path already, or it cannot be written.
    DataError
        For shapes that do not fit.
    """
    wi, wo = np.atleast_2d(np.asarray(wi, float)), np.atleast_2d(np.asarray(wo, float))
    n = max(len(wi), len(wo))
    wi, wo = (np.broadcast_to(w, (n, 3)) if len(w) == 1 else w for w in (wi, wo))
    wi, wo = policy.unit_directions(wi, "wi"), policy.unit_directions(wo, "wo")
    times = np.asarray(hours, float).reshape(-1)
    check(wi, wo, times, len(channels), "the new map")
    chunks = (chunk, chunk) if isinstance(chunk, int) else tuple(chunk)
    if min(*shape, *chunks, len(channels)) < 1:
        raise ParameterError(
            f"a map of {shape} texels in chunks of {chunks} with {len(channels)} channels", "All are >= 1"
        )
    chunks = (min(chunks[0], shape[0]), min(chunks[1], shape[1]))
    with making.whole(path) as store:
        group = making.new_group(store)
        group.attrs.update(
            {
                "format": zarrs.STACK,
                "version": zarrs.VERSION,
                "name": name or store.stem,
                "channels": list(channels),
                "conventions": zarrs.CONVENTIONS,
                "coordinates": "wi wo",
                **(attributes or {}),
            }
        )
        tail = (len(times), n, len(channels))
        zarrs.add(
            group,
            NAME,
            dims=AXES,
            shape=(*shape, *tail),
            chunks=(*chunks, *tail),
            compressed=compressed,
            attributes={"units": "1/sr", "long_name": "BRDF without the cosine; NaN = not measured"},
        )
        for label, w, to in (("wi", wi, "light"), ("wo", wo, "viewer")):
            about = {"long_name": f"unit vector to the {to}, z the normal"}
            zarrs.add(group, label, w, dims=("direction", "xyz"), attributes=about)
        zarrs.add(group, "time", times, dims=("time",), attributes={"units": "h"})
        if wavelengths is not None:
            nm = np.asarray(wavelengths, float).reshape(len(channels))
            zarrs.add(group, "wavelength", nm, dims=("channel",), attributes={"units": "nm"})
        if weights is not None:
            zarrs.add(group, "weight", np.asarray(weights, float).reshape(n), dims=("direction",))
    return open_stack(path, mode="r+")


def open_stack(path: object, mode: str = "r") -> MapStack:
    """The map in a Zarr store.

    Raises
    ------
    FormatError
        When it is not one: the array f_r, its axes, the directions or times are missing or do not fit.
    """
    folder = Path(str(path))
    group = zarrs.open_group(folder, mode)
    if group.attrs.get("format") == zarrs.FITTED:
        raise FormatError(
            f"{folder} holds fitted parameters, not measured reflectance", f"motes info {folder} shows them"
        )
    members = zarrs.arrays(group, folder)
    array = reflectance(members, folder)
    if mode == "r":  # what is opened to be filled has no files yet
        zarrs.check_chunks(array, folder)
        # A texel is read whole, and each channel has a name.
        zarrs.check_whole(array, folder, math.prod(array.shape[2:]) * array.dtype.itemsize + NAMED * array.shape[4])
    wi, wo = (vectors(members, name, array.shape[3], folder) for name in ("wi", "wo"))
    hours = hours_of(members.get("time"), array.shape[2], folder)
    check(wi, wo, hours, array.shape[4], folder)
    names = group.attrs.get("channels")
    channels = names_or_default(names, array.shape[4])
    weight = members.get("weight")
    weights = None if weight is None else zarrs.numbers(weight, folder)
    if weights is not None and (weights.shape != (len(wi),) or not (np.isfinite(weights) & (weights >= 0)).all()):
        raise FormatError(
            f"{folder}: weight has shape {weights.shape} or holds negative numbers", "One >= 0 a direction"
        )
    blocks = Blocks(array.shape[:2], block_shape(array.shape, array.chunks))
    if math.prod(blocks.counts) > zarrs.MOST_BLOCKS:
        raise FormatError(
            f"{folder} has {math.prod(blocks.counts):,} chunks, more than {zarrs.MOST_BLOCKS:,}", "Make them larger"
        )
    return MapStack(folder, wi, wo, hours, channels, weights, blocks, array, dict(group.attrs))


def _range(w: Floats) -> list[float]:
    theta = np.degrees(np.arccos(np.clip(w[:, 2], -1, 1)))
    return [float(theta.min()), float(theta.max())]
