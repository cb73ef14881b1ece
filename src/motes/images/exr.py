"""OpenEXR pictures as float32 arrays: layers, parts, data windows.

A picture is what its display window shows.  Pixels that the data window lacks are NaN: nobody stored them.
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, NamedTuple, final

import numpy as np
from numpy.typing import NDArray

from motes.channels import LUMINANCE, RGB
from motes.errors import FormatError
from motes.files import budget, reading, replacing
from motes.images import library

MAGIC = library.EXR
HEADER = 65536
# The best that lossless compression makes of a measured picture is far below.
LARGEST_RATIO = 1000
COLOURS = {
    word: name for name, words in zip(RGB, (("r", "red"), ("g", "green"), ("b", "blue")), strict=True) for word in words
}
GREYS = {"y", "l", "grey", "gray", "luminance", "luma", "mono", "intensity", "bw"}
ALPHAS = {"a", "alpha"}
MOST_PARTS = 256


def size(path: Path) -> tuple[int, int] | None:
    """(height, width) from the header, or None where it is not a plain scan-line or tiled picture of sane size.

    For telling formats apart, which works without any library.
    """
    header = reading.head(path, HEADER)
    if not header.startswith(MAGIC) or len(header) < 8 or header[5] & 0x18:  # deep or multi-part
        return None
    at = 8
    window: tuple[int, ...] | None = None
    try:
        while header[at] != 0:
            name_end = header.index(0, at)
            type_end = header.index(0, name_end + 1)
            (length,) = struct.unpack_from("<i", header, type_end + 1)
            if length < 0:
                return None
            if header[at:name_end] == b"dataWindow" and length == 16:
                window = struct.unpack_from("<4i", header, type_end + 5)
            at = type_end + 5 + length
    except (IndexError, ValueError, struct.error):
        return None
    if window is None:
        return None
    height, width = window[3] - window[1] + 1, window[2] - window[0] + 1
    if height < 1 or width < 1 or height * width * 2 > LARGEST_RATIO * path.stat().st_size:
        return None
    return height, width


@final
class Layer(NamedTuple):
    """The colours of one layer: its part, its name (``""`` for the one without), and the channels of a part by what they are."""

    part: int
    name: str
    colours: dict[str, int]  # R, G, B or Y
    alpha: int | None


@final
class Picture(NamedTuple):
    """What is read of a file: values (y, x, C) float32, C = 3 or 1, alpha (y, x) or None, the layer, the primaries or None."""

    values: NDArray[np.float32]
    alpha: NDArray[np.float32] | None
    layer: str
    chromaticities: tuple[float, ...] | None


def read_exr(path: Path, purpose: str, layer: str | None = None) -> Picture:
    """The colours, or the grey, of a picture.

    Parameters
    ----------
    path
        An OpenEXR file.
    purpose
        What for, for the error without the library.
    layer
        The layer, such as ``ViewLayer.Combined``, or one channel, such as ``Depth.Z``, which is taken as grey.  When not given: the layer without a
        name, or the only one that has colours.

    Raises
    ------
    MissingExtraError
        Without the package OpenImageIO.
    FormatError
        When the file is not an EXR, is damaged, would take too much memory, or does not say which of its channels are the picture.
    """
    if not reading.head(path, 4).startswith(MAGIC):
        raise FormatError(f"{path} is not an OpenEXR picture", "Check the file")
    with library.opened(path, purpose) as picture:
        names = _names(path, picture)
        chosen = _chosen(path, names, layer)
        facts = picture.spec(chosen.part)
        places = [chosen.colours[c] for c in RGB if c in chosen.colours] or [chosen.colours[LUMINANCE]]
        wanted = [*places, *([] if chosen.alpha is None else [chosen.alpha])]
        formats = facts.channelformats or (facts.format,) * facts.nchannels
        for k in wanted:
            if str(formats[k]) not in ("half", "float"):
                raise FormatError(
                    f"{path}: the channel {facts.channelnames[k]} holds {formats[k]}, which is for names and not for light",
                    "Give a picture of half or float numbers",
                )
        shown = _shown(path, library.pixels(path, picture, chosen.part, wanted, "float"), facts)
        primaries = facts.getattribute("chromaticities")
    good = isinstance(primaries, tuple) and len(primaries) == 8
    return Picture(
        shown[..., : len(places)],
        None if chosen.alpha is None else shown[..., -1],
        chosen.name,
        tuple(float(x) for x in primaries) if good else None,
    )


def rgb(path: Path, purpose: str) -> NDArray[np.float32]:
    """R, G and B (height, width, 3); a grey channel Y serves for all three."""
    values = read_exr(path, purpose).values
    return values if values.shape[-1] == 3 else np.repeat(values, 3, axis=-1)


def write(path: Path, picture: NDArray[np.floating[Any]], purpose: str) -> Path:
    """R, G, B (y, x, 3), or Y (y, x), as float32, whole or not at all.

    Raises
    ------
    MissingExtraError
        Without the package OpenImageIO.
    MotesError
        When the file cannot be written.
    """
    OpenImageIO = library.oiio(purpose)
    values = np.ascontiguousarray(picture.reshape(*picture.shape[:2], -1), np.float32)
    facts = OpenImageIO.ImageSpec(values.shape[1], values.shape[0], values.shape[2], OpenImageIO.FLOAT)
    facts.channelnames = RGB if values.shape[2] == 3 else (LUMINANCE,)
    facts.attribute("compression", "zip")
    with replacing(path) as temporary:
        out = OpenImageIO.ImageOutput.create("openexr")
        done = out.open(str(temporary), facts) and out.write_image(values)
        said = out.geterror()
        if not (out.close() and done):
            raise OSError(0, f"{said or out.geterror()}".replace(str(temporary), str(path))[:200])
    return path


def _names(path: Path, picture: Any) -> list[tuple[int, str, int]]:
    """(part, full name, place within the part) of all channels.  A part's name stands before those of its channels."""
    found: list[tuple[int, str, int]] = []
    part = 0
    facts = picture.spec(0)
    count = int(facts.getattribute("oiio:subimages") or 1)
    if count > MOST_PARTS:
        raise FormatError(f"{path} has {count} parts, more than {MOST_PARTS}", "Split it")
    for part in range(count):
        facts = picture.spec(part)
        own = str(facts.getattribute("name") or f"part {part}") if count > 1 else ""
        if facts.deep:
            continue
        for k, name in enumerate(facts.channelnames):
            full = name if not own or name.startswith(f"{own}.") else f"{own}.{name}"
            found.append((part, full, k))
    return found


def _layers(names: list[tuple[int, str, int]]) -> list[Layer]:
    """What has three colours, or a grey alone; a Y among X and Z is a direction and not a grey."""
    grouped: dict[tuple[int, str], dict[str, int]] = {}
    for part, full, k in names:
        name, _, last = full.rpartition(".")
        grouped.setdefault((part, name), {})[last.lower()] = k
    found = []
    for (part, name), channels in grouped.items():
        alpha = next((channels[c] for c in channels if c in ALPHAS), None)
        colours = {COLOURS[c]: k for c, k in channels.items() if c in COLOURS}
        others = [c for c in channels if c not in COLOURS and c not in ALPHAS]
        if len(colours) == 3:
            found.append(Layer(part, name, colours, alpha))
        elif not colours and len(others) == 1 and others[0] in GREYS:
            found.append(Layer(part, name, {LUMINANCE: channels[others[0]]}, alpha))
    return found


def _chosen(path: Path, names: list[tuple[int, str, int]], layer: str | None) -> Layer:
    layers = _layers(names)
    listed = ", ".join(full for _, full, _ in names[:12]) + (f" and {len(names) - 12} more" if len(names) > 12 else "")
    if layer is not None:
        for one in layers:
            if one.name == layer:
                return one
        for part, full, k in names:
            if full == layer:
                return Layer(part, layer, {LUMINANCE: k}, None)
        raise FormatError(
            f"{path} has no layer or channel {layer[:60]!r}; it has the channels {listed}",
            "A layer is named by what stands before the last point, such as ViewLayer.Combined",
        )
    unnamed = [one for one in layers if not one.name]
    candidates = unnamed or layers
    if len(candidates) == 1:
        return candidates[0]
    if candidates:
        several = ", ".join(one.name for one in candidates[:8])
        raise FormatError(
            f"{path} has {len(candidates)} layers with colours: {several}", f"Choose one: --layer {candidates[0].name}"
        )
    first = next((full for _, full, _ in names if full.rpartition(".")[2].lower() not in ALPHAS), "NAME")
    raise FormatError(
        f"{path} has the channels {listed}, neither R, G and B nor a grey Y",
        f"Where one of them is the picture, name it: --layer {first}",
    )


def _shown(path: Path, data: NDArray[np.float32], facts: Any) -> NDArray[np.float32]:
    """The data window's pixels in the display window; NaN where there are none."""
    if (facts.x, facts.y, facts.width, facts.height) == (
        facts.full_x,
        facts.full_y,
        facts.full_width,
        facts.full_height,
    ):
        return data
    width, height = int(facts.full_width), int(facts.full_height)
    if width < 1 or height < 1:
        return data
    # Four times: its colours are taken out of it, without alpha, and those who compute with them make them float64.
    budget.check(path, 4 * width * height * data.shape[-1] * 4, f"its display window of {width} x {height} pixels")
    shown = np.full((height, width, data.shape[-1]), np.nan, np.float32)
    left, top = facts.x - facts.full_x, facts.y - facts.full_y
    x0, x1 = max(left, 0), min(left + facts.width, width)
    y0, y1 = max(top, 0), min(top + facts.height, height)
    if x0 < x1 and y0 < y1:
        shown[y0:y1, x0:x1] = data[y0 - top : y1 - top, x0 - left : x1 - left]
    return shown
