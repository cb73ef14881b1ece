"""`Photograph`: a picture of any of the formats, its numbers as stored, and how they become linear light."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MissingExtraError, MotesError
from motes.files import reading
from motes.images import exr, jpeg, library, png, transfer_functions
from motes.images.transfer_functions import Transfer

Singles = NDArray[np.float32]
Floats = NDArray[np.float64]

SUFFIXES = (".exr", ".png", ".tif", ".tiff", ".jpg", ".jpeg")
PORTABLE = (
    b"PF",
    b"Pf",
    b"P1",
    b"P2",
    b"P3",
    b"P4",
    b"P5",
    b"P6",
)  # PFM and PNM: without a transfer function of their own
#: Bytes of a coefficient, of which the decoder of a progressive JPEG keeps one for each number of the picture.
COEFFICIENT = 2
# Exif's orientations 2 to 8 as (transpose, flip rows, flip columns), in this order.
_TURNS = {2: (0, 0, 1), 3: (0, 1, 1), 4: (0, 1, 0), 5: (1, 0, 0), 6: (1, 0, 1), 7: (1, 1, 1), 8: (1, 1, 0)}


@final
@dataclass(frozen=True, eq=False)
class Photograph:
    """A picture as it is stored.

    Parameters
    ----------
    path
        The file.
    stored
        (y, x, C) of uint8, uint16 or float32; C is 3 (R, G, B) or 1 (grey).
    transfer
        How the numbers become linear.
    alpha
        (y, x) or None; where it is 0 nothing was seen.
    notes
        What was done that one may want to know.
    """

    path: Path
    stored: NDArray[Any]
    transfer: Transfer
    alpha: NDArray[Any] | None = None
    notes: tuple[str, ...] = field(default=())

    @property
    def shape(self) -> tuple[int, int, int]:
        """Rows, columns, channels."""
        height, width, channels = self.stored.shape
        return height, width, channels

    @property
    def largest(self) -> int | None:
        """The largest code; None for numbers that have none."""
        return int(np.iinfo(self.stored.dtype).max) if self.stored.dtype.kind == "u" else None

    def linear(self, rows: slice = slice(None)) -> Singles:
        """Linear values (y, x, C) of the sRGB primaries; NaN where a channel is clipped at the largest code, not finite, or transparent.

        Raises
        ------
        MotesError
            When an ICC profile or primaries are damaged.
        """
        stored = self.stored[rows]
        try:
            if self.largest is None:
                values = np.array(stored, np.float32)
                lost = ~np.isfinite(values)
                if self.transfer.kind in ("srgb", "gamma"):
                    curve = (
                        transfer_functions.srgb_decode(values)
                        if self.transfer.kind == "srgb"
                        else np.power(np.maximum(values, 0), self.transfer.gamma)
                    )
                    values = curve.astype(np.float32)
            else:
                lost = stored == self.largest
                if self.transfer.kind == "icc":
                    values = transfer_functions.by_profile(stored, self.transfer.profile, self.largest)
                else:
                    values = self.transfer.table(self.largest)[stored]
            values[lost] = np.nan
            matrix = self.transfer.matrix(values.shape[-1])
        except MissingExtraError:
            raise
        except MotesError as error:
            raise FormatError(f"{self.path}: {error.message}", error.hint) from None
        if matrix is not None:  # a channel that is lost takes part in all three
            values = (values @ matrix.T).astype(np.float32)
        if self.alpha is not None:
            values[self.alpha[rows] == 0] = np.nan
        return values


def open_photograph(
    path: Path, stated: Transfer | None = None, layer: str | None = None, purpose: str = "Reading pictures"
) -> Photograph:
    """A picture of one of the formats, told by its first bytes.

    Parameters
    ----------
    path
        OpenEXR, PNG, TIFF or JPEG.
    stated
        The transfer function as somebody says it; what the file says when None.
    layer
        Of an OpenEXR file.
    purpose
        What for, for the errors of packages that are missing.

    Raises
    ------
    MissingExtraError
        Without the package OpenImageIO.
    FormatError
        When the file is no such picture, is damaged, would take too much memory, or does not say what its numbers are where its format leaves it open.
    """
    try:
        head = reading.head(path, 16)
        if head.startswith(library.EXR):
            return _exr(path, stated, layer, purpose)
        if layer is not None:
            raise FormatError(f"{path} has no layers; only OpenEXR pictures have", "Leave the layer out")
        if head.startswith(library.PNG):
            return _png(path, stated, purpose)
        if head.startswith((library.JPEG, *library.TIFF)):
            return _other(path, stated, purpose, "JPEG" if head.startswith(library.JPEG) else "TIFF")
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Check the path") from None
    raise FormatError(
        f"{path} is no picture of a known format; it starts with {head[:8]!r}",
        "Give OpenEXR, PNG, TIFF or JPEG pictures",
    )


def read_mask(path: Path, purpose: str = "Reading a mask") -> Floats:
    """A mask (y, x) in [0, 1]: the numbers as they are stored, without a transfer function, the mean of the colours, without alpha.

    Raises
    ------
    FormatError
        As `open_photograph`, or where a number is not finite.
    """
    try:
        if reading.head(path, 2) in PORTABLE:
            with library.opened(path, purpose) as opened:
                picture = Photograph(path, _codes(path, opened)[0], Transfer("linear"))
        else:
            picture = open_photograph(path, Transfer("linear"), purpose=purpose)
    except FileNotFoundError:
        raise FormatError(f"{path} does not exist", "Give the path of a picture: PNG, JPEG, TIFF, EXR or PFM") from None
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Check the path") from None
    values = picture.stored.mean(axis=2, dtype=np.float64)
    if picture.largest is not None:
        values /= picture.largest
    if not np.isfinite(values).all():
        raise FormatError(
            f"{path} has {int((~np.isfinite(values)).sum())} pixels that are not finite", "Repair the picture"
        )
    return np.asarray(np.clip(values, 0, 1))


def _exr(path: Path, stated: Transfer | None, layer: str | None, purpose: str) -> Photograph:
    found = exr.read_exr(path, purpose, layer)
    primaries = found.chromaticities
    if primaries is not None and transfer_functions.same_primaries(primaries, transfer_functions.SRGB):
        primaries = None
    meaning = stated or Transfer("linear", "OpenEXR pictures are", primaries=primaries)
    notes = (f"the layer {found.layer} of OpenEXR pictures",) if found.layer else ()
    return Photograph(path, found.values, meaning, _used(found.alpha), notes)


def _png(path: Path, stated: Transfer | None, purpose: str) -> Photograph:
    chunks = png.chunks_of(path)
    unsaid = Transfer("srgb", "no chunk says what the numbers are, and by custom they are then sRGB")
    meaning = stated or png.transfer_of(path, chunks) or unsaid
    with library.opened(path, purpose) as picture:
        held = picture.spec(0).pixel_bytes(True) if png.interlaced(chunks) else 0
        stored, alpha = _codes(path, picture, int(held))
    return Photograph(path, stored, meaning, _used(alpha))


def _other(path: Path, stated: Transfer | None, purpose: str, kind: str) -> Photograph:
    with library.opened(path, purpose) as picture:
        facts = picture.spec(0)
        if picture.seek_subimage(1, 0):
            raise FormatError(f"{path} has several pages", "Save each picture in a file of its own")
        space = facts.getattribute("tiff:ColorSpace") or facts.getattribute("jpeg:ColorSpace")
        if space is not None or facts.getattribute("tiff:PhotometricInterpretation") in (5, 8, 9, 10):
            raise FormatError(f"{path} holds {space or 'Lab colours'}, not R, G, B or grey", "Save it as RGB")
        held = COEFFICIENT * facts.nchannels if kind == "JPEG" and jpeg.progressive(path) else 0
        stored, alpha = _codes(path, picture, held)
        profile = facts.getattribute("ICCProfile")
        srgb = facts.getattribute("Exif:ColorSpace") == 1
        turn = int(facts.getattribute("Orientation") or 1)
    if stated is not None:
        meaning = stated
    elif stored.dtype.kind == "f":
        meaning = Transfer("linear", "TIFF pictures of floating-point numbers are")
    elif profile is not None:
        meaning = Transfer("icc", f"the {kind} holds it", profile=bytes(np.asarray(profile, np.uint8).tobytes()))
    elif srgb:
        meaning = Transfer("srgb", "its Exif data say so")
    else:
        raise FormatError(
            f"{path} is a {kind} that does not say what its numbers are: it has no ICC profile and no colour space in its Exif data",
            "Say it: --transfer linear, srgb or an exponent such as 2.2",
        )
    notes: tuple[str, ...] = ()
    if turn in _TURNS:
        stored, alpha = _turned(stored, turn), None if alpha is None else _turned(alpha, turn)
        notes = ("pictures were turned as their Exif orientation says",)
    return Photograph(path, stored, meaning, _used(alpha), notes)


def _codes(path: Path, picture: Any, held: int = 0) -> tuple[NDArray[Any], NDArray[Any] | None]:
    """Colours (y, x, C) and alpha (y, x) of a picture that is not OpenEXR, as they are stored; its decoder holds so many bytes a pixel."""
    facts = picture.spec(0)
    kind = "float" if str(facts.format) == "half" else str(facts.format)
    alpha = facts.alpha_channel
    n = facts.nchannels
    colours = n - (alpha >= 0)
    if kind not in library.KINDS or colours not in (1, 3) or (alpha >= 0 and alpha != n - 1):
        raise FormatError(
            f"{path} has {n} channels ({', '.join(facts.channelnames)[:80]}) of {facts.format}",
            "Pictures of 8 or 16 bits or floating-point numbers are read, RGB or grey, with or without alpha",
        )
    data = library.pixels(path, picture, 0, range(n), kind, held)
    return data[..., :colours], data[..., -1] if alpha >= 0 else None


def _used(alpha: NDArray[Any] | None) -> NDArray[Any] | None:
    """None for an alpha that leaves everything, or nothing: programs that have no use for it write either."""
    if alpha is None:
        return None
    with np.errstate(invalid="ignore"):  # of NaN that signal
        seen = alpha != 0
    return None if seen.all() or not seen.any() else alpha


def _turned(pixels: NDArray[Any], orientation: int) -> NDArray[Any]:
    transpose, rows, columns = _TURNS[orientation]
    if transpose:
        pixels = pixels.swapaxes(0, 1)
    if rows:
        pixels = pixels[::-1]
    if columns:
        pixels = pixels[:, ::-1]
    return np.ascontiguousarray(pixels)
