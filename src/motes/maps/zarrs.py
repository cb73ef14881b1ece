"""Zarr groups as this room uses them: version 3, on a disk, with named dimensions; what a damaged one says."""

from __future__ import annotations

import json
import math
import os
import shlex
from collections.abc import Iterator, Mapping
from itertools import chain, islice
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import budget
from motes.maps.chunks import plain
from motes.maps.frames import check_frames, is_regular
from motes.material import CONVENTIONS as MATERIAL_CONVENTIONS
from motes.quiet import without_warnings

NAME = "f_r"
AXES = ("y", "x", "time", "direction", "channel")
#: The arrays of a map and their axes.
MEMBERS = {
    NAME: AXES,
    "wi": ("direction", "xyz"),
    "wo": ("direction", "xyz"),
    "time": ("time",),
    "wavelength": ("channel",),
    "weight": ("direction",),
}
STACK, FITTED = "motes map", "motes fitted map"
# Of stores of measured maps; and of fitted ones, which since 2 hold verdicts.
VERSION, FITTED_VERSION = 1, 2
CONVENTIONS = {
    **MATERIAL_CONVENTIONS,
    "map": "rows y downwards, columns x to the right; one frame, one light and one viewer a direction for all texels",
}
# Bytes of one chunk, and of a small array that is read whole, beyond which a store is refused.
LARGEST_CHUNK, LARGEST_TABLE = 4 * 2**30, 2**28
LARGEST_ATTRIBUTES = 2**20
# Files of an array of which the largest is taken for the size that its chunks have.
MOST_LOOKED_AT = 1000
MOST_BLOCKS = 10_000_000
# Chunks that are looked for whether there are files or not.
FEW_CHUNKS = 10_000
#: What to do when a disk refuses.
PLACE = "Choose a place that is writable and has room, with -o"


def zarr() -> Any:
    """The package, or the error that names the extra."""
    try:
        import zarr
    except ImportError:
        raise missing("zarr") from None
    return zarr


def missing(package: str) -> MissingExtraError:
    """The error that names the extra which brings a package."""
    return MissingExtraError(package, "scale", "A reflectance map")


def is_store(path: object) -> bool:
    """Whether a path is, or is named as, a Zarr store."""
    folder = Path(str(path))
    return folder.suffix == ".zarr" or any((folder / name).is_file() for name in ("zarr.json", ".zgroup", ".zarray"))


def kind_of(path: object) -> str:
    """``"fitted"`` for what `motes.maps.fit_map` wrote, ``"stack"`` for any other group."""
    return "fitted" if open_group(path).attrs.get("format") == FITTED else "stack"


def open_group(path: object, mode: str = "r") -> Any:
    """The Zarr group at a path.

    Raises
    ------
    FormatError
        When there is none, or of version 2.
    """
    library = zarr()
    folder = Path(str(path))
    if not folder.exists():
        raise FormatError(f"{folder} does not exist", "Check the path")
    if (folder / ".zgroup").is_file() or (folder / ".zarray").is_file():
        raise FormatError(
            f"{folder} is a Zarr store of version 2; maps are read from version 3", f"Convert it: {_conversion(folder)}"
        )
    for file in chain(*(folder.glob(f"{below}zarr.json") for below in ("", "*/", "run/*/", "truth/*/"))):
        is_regular(file, folder)
    try:
        group = library.open_group(str(folder), mode=mode, use_consolidated=False, zarr_format=3)
    except Exception as error:  # the library raises what it likes
        raise FormatError(
            f"{folder} is not a Zarr group that can be opened: {_shortly(error)}",
            "A map is a Zarr v3 group with an array f_r (y, x, time, direction, channel)",
        ) from None
    _check_opened(group, folder)
    return group


def _check_opened(node: Any, where: object) -> None:
    """The library takes anything for the attributes of a group or an array, and chunks that hold nothing."""
    if not isinstance(node.metadata.attributes, Mapping):
        raise FormatError(
            f"{where}: the attributes of {node.basename or 'the store'} are no object", "Write the store again"
        )
    for chunk in (getattr(node, "chunks", None), getattr(node, "shards", None)):
        if chunk is not None and 0 in chunk:
            raise FormatError(
                f"{where}: a chunk of {node.basename} has the shape {tuple(chunk)}, which holds nothing",
                "Write the store again",
            )


def rewritten(folder: Path, change: str = "") -> str:
    """The command that writes a store again, as version 3 with fresh encodings, after a change: a method call of an `xarray.Dataset`."""
    return _python(
        f"import xarray; xarray.open_zarr({_text(folder)}, consolidated=False){change}.drop_encoding()"
        f".to_zarr({_text(_beside(folder))}, zarr_format=3, consolidated=False)"
    )


def _conversion(folder: Path) -> str:
    """The command that makes version 3 of version 2.  Stores that xarray did not write do not name their axes, and the command must."""
    found = [name for name in MEMBERS if (folder / name / ".zarray").is_file()]
    named = [name for name in found if _names_axes(folder / name / ".zattrs")]
    if NAME not in found or named:
        return rewritten(folder)
    members = ", ".join(f"{_text(name)}: ({list(MEMBERS[name])}, a({_text(name)}))".replace("'", '"') for name in found)
    return _python(
        f"import dask.array, xarray, zarr; n = {_text(folder)}; a = lambda k: dask.array.from_zarr(n, component=k); "
        f'xarray.Dataset({{{members}}}, attrs=dict(zarr.open_group(n, mode="r").attrs))'
        f".to_zarr({_text(_beside(folder))}, zarr_format=3, consolidated=False)"
    )


def _names_axes(file: Path) -> bool:
    try:
        with file.open("rb") as stream:
            return b"_ARRAY_DIMENSIONS" in stream.read(LARGEST_ATTRIBUTES)
    except OSError:
        return False


def _beside(folder: Path) -> Path:
    return folder.with_name(f"{folder.stem}-again.zarr")


def _text(value: object) -> str:
    return json.dumps(str(value), ensure_ascii=False)


def _python(code: str) -> str:
    return f"python -c {shlex.quote(code)}"


def arrays(group: Any, where: object) -> dict[str, Any]:
    """The arrays of a group by name; sub-groups are left out."""
    try:
        found = dict(group.arrays())
    except Exception as error:
        raise FormatError(
            f"{where} holds an array that cannot be opened: {_shortly(error)}", "Write it again"
        ) from None
    for array in found.values():
        _check_opened(array, where)
    return found


def dimensions(array: Any) -> tuple[str, ...]:
    """The names of an array's axes; those without are ``"?"``."""
    names = getattr(array.metadata, "dimension_names", None) or ("?",) * array.ndim
    return tuple(str(name) if name else "?" for name in names)


def numbers(array: Any, where: object) -> NDArray[np.float64]:
    """A small array whole, as float64."""
    check_whole(array, where, math.prod(array.shape) * max(array.dtype.itemsize, 8))
    if array.dtype.kind not in "fiu" or math.prod(array.shape) * array.dtype.itemsize > LARGEST_TABLE:
        raise FormatError(
            f"{where}: {array.basename} ({array.dtype}, {array.shape}) is not a table of numbers",
            f"It holds numbers, {LARGEST_TABLE // 2**20} MiB of them at most",
        )
    return values(array, where, np.float64)


def member(group: Any, name: str, where: object) -> Any | None:
    """What a group has under a name, None for nothing; a `FormatError` for what is there and cannot be opened."""
    try:
        found = group[name]
    except KeyError:
        return None
    except Exception as error:  # the library raises what it likes on damaged metadata
        raise FormatError(f"{where}: {name} cannot be opened: {_shortly(error)}", "Write the store again") from None
    _check_opened(found, where)
    return found


def read(array: Any, where: object, part: Any = ...) -> NDArray[Any]:
    """A part of an array as it is stored, its chunks checked before they are decoded.

    Raises
    ------
    FormatError
        When a chunk would take too much memory, or is damaged.
    """
    check_chunks(array, where)
    check_whole(array, where, _length(array.shape, part) * array.dtype.itemsize)
    check_count(array, where, part)
    try:
        found = plain(array, Path(str(where)), part)
        if found is not None:
            return found
        check_frames(array, where, part)
        return np.asarray(array[part])
    except MotesError:
        raise
    except MemoryError:
        raise
    except Exception as error:  # of codecs: RuntimeError, ValueError and others
        raise unreadable(array, where, error) from None


def values(array: Any, where: object, kind: Any, part: Any = ...) -> NDArray[Any]:
    """A part of an array as numbers of a kind, `unpacked`."""
    raw = read(array, where, part)
    try:
        return unpacked(raw, array.attrs, kind)
    except (TypeError, ValueError, OverflowError) as error:  # attributes that are no numbers
        raise unreadable(array, where, error) from None


def unreadable(array: Any, where: object, error: Exception) -> FormatError:
    """The refusal of an array, in a sentence."""
    return FormatError(f"{where}: {array.basename} cannot be read: {_shortly(error)}", "Write the store again")


def unpacked(raw: NDArray[Any], attributes: Mapping[str, Any], kind: Any) -> NDArray[Any]:
    """Numbers as they are meant: the CF attributes ``_FillValue``, ``scale_factor`` and ``add_offset`` applied."""
    fill, scale, offset = (attributes.get(name) for name in ("_FillValue", "scale_factor", "add_offset"))
    # A signalling NaN is one; what is too large becomes infinite, and is masked, as is an infinity times 0.
    with np.errstate(invalid="ignore", over="ignore"):
        values = raw.astype(kind, copy=False)
        missing = None if not isinstance(fill, (int, float)) or np.isnan(fill) else raw == fill
        if scale is not None or offset is not None:
            values = values * kind(1 if scale is None else scale) + kind(offset or 0)
        if missing is not None and missing.any():
            values = np.where(missing, kind(np.nan), values)
    return values


def check_chunks(array: Any, where: object) -> None:
    """Refuse chunks that would take more memory than their files may (`motes.files.budget`): a chunk is decoded whole."""
    size = math.prod(array.chunks) * array.dtype.itemsize
    if size <= budget.LEAST:
        return
    largest = 0
    for file in islice((Path(str(where)) / array.path).rglob("*"), MOST_LOOKED_AT):
        largest = max(largest, file.stat().st_size if file.is_file() else 0)
    if size > LARGEST_CHUNK or size > budget.allowed(largest):
        raise FormatError(
            f"{where}: one chunk of {array.basename} is {budget.mebibytes(size)} and is read whole, and its files have {largest:,} bytes at most",
            f"Write the store again with chunks of 64 x 64 texels. {budget.advice(size)}",
        )


def check_whole(array: Any, where: object, size: int) -> None:
    """Refuse `size` bytes of an array that its store does not have (`motes.files.budget`): what has no file is made up of the fill value.

    Raises
    ------
    FormatError
        With the shape, and how to ask for more.
    """
    if size <= budget.LEAST:
        return
    stored = 0
    for file in _files(where):
        stored += os.path.getsize(file)
        if budget.allowed(stored) >= size:
            return
    shape = " x ".join(map(str, array.shape))
    budget.check(Path(str(where)), size, f"what is to be read of {array.basename} ({shape})", stored)


def check_count(array: Any, where: object, part: Any) -> None:
    """Refuse to look for many more chunks than there are files: each that is missing takes its time.

    Raises
    ------
    FormatError
        With both numbers.
    """
    count = math.prod(map(_count, _ranges(array.shape, part, array.chunks)))
    if count <= FEW_CHUNKS:
        return
    found = sum(1 for _ in islice(_files(where), count))
    if count > FEW_CHUNKS + budget.FACTOR * found:
        raise FormatError(
            f"{where}: {array.basename} is in {count:,} chunks, and the store has {found:,} files",
            "The store is damaged, or its chunks are far too small: write it again",
        )


def _files(where: object) -> Iterator[str]:
    return (os.path.join(root, name) for root, _, names in os.walk(str(where)) for name in names)


def _ranges(shape: tuple[int, ...], part: Any, steps: tuple[int, ...]) -> Iterator[range]:
    """What a part of an array (slices or numbers along its first axes) goes through along each axis, in chunks of `steps`."""
    given = tuple(each for each in (part if isinstance(part, tuple) else (part,)) if each is not Ellipsis)
    for k, (n, step) in enumerate(zip(shape, steps, strict=True)):
        each = given[k] if k < len(given) else slice(None)
        start, stop, _ = each.indices(n) if isinstance(each, slice) else (each, each + 1, 1)
        yield range(start // step, -(-max(start, stop) // step) if stop > start else start // step)


def _count(numbers: range) -> int:
    """`len`, of ranges that no machine could count too."""
    return max(0, numbers.stop - numbers.start)


def _length(shape: tuple[int, ...], part: Any) -> int:
    """The count of the numbers in a part of an array."""
    return math.prod(map(_count, _ranges(shape, part, (1,) * len(shape))))


def consolidate(folder: Path) -> None:
    """Metadata in one place: without it xarray warns."""
    with without_warnings():  # that this is not in the specification of version 3 yet
        zarr().consolidate_metadata(str(folder))


class Unwritable(MotesError):
    """The refusal of a disk, in a sentence."""

    def __init__(self, where: object, error: OSError, hint: str = PLACE) -> None:
        super().__init__(f"{where} cannot be written: {error.strerror or error}", hint)
        self.refusal = error


def add(
    group: Any,
    name: str,
    values: NDArray[Any] | None = None,
    *,
    dims: tuple[str, ...],
    shape: tuple[int, ...] = (),
    chunks: tuple[int, ...] = (),
    dtype: Any = "f4",
    fill: Any = np.nan,
    attributes: Mapping[str, Any] | None = None,
    compressed: bool = True,
) -> Any:
    """A new array with named axes: of `values`, in one chunk, or empty of a shape.

    Noisy floating-point numbers hardly shrink: LZ4 on bytes of equal weight takes 0.81 of them, Zstandard 0.87 in four times the time.
    """
    if values is not None:
        shape, dtype, fill = values.shape, values.dtype, 0
        chunks = tuple(max(1, n) for n in shape)
    from zarr.codecs import BloscCodec

    size = np.dtype(dtype).itemsize
    codec = BloscCodec(typesize=size, cname="lz4", clevel=5, shuffle="shuffle", blocksize=0) if compressed else None
    array = group.create_array(
        name,
        shape=shape,
        chunks=chunks,
        dtype=dtype,
        fill_value=fill,
        dimension_names=dims,
        attributes=dict(attributes or {}),
        compressors=codec,
    )
    if values is not None:
        array[...] = values
    return array


def size_on_disk(path: object) -> int:
    """Bytes of all files below a path."""
    return sum(map(os.path.getsize, _files(path)))


def _shortly(error: Exception) -> str:
    return " ".join((str(error) or type(error).__name__).split())[:200]
