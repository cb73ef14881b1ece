"""What channels are called: how many get which names, which names are colours, and which are wavelengths.

A measurement, a material, a map and a picture have channels with names.  One is grey, three are red, green and blue, spectra are
named by their wavelengths in nm, and what is none of these is numbered from 1.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

GREY = ("grey",)
RGB = ("R", "G", "B")
#: The only channel of a grey picture in an EXR file.
LUMINANCE = "Y"

_COLOURS = {"r": 0, "red": 0, "g": 1, "green": 1, "b": 2, "blue": 2}
_WAVELENGTH = re.compile(r"\s*(\d+(?:\.\d+)?)\s*nm\s*", re.IGNORECASE)


def default_names(count: int) -> tuple[str, ...]:
    """Names for channels of which nothing is known but how many there are.

    Examples
    --------
    >>> default_names(1), default_names(3), default_names(2)
    (('grey',), ('R', 'G', 'B'), ('channel 1', 'channel 2'))
    """
    return {1: GREY, 3: RGB}.get(count) or numbered(count)


def numbered(count: int) -> tuple[str, ...]:
    """``channel 1``, ``channel 2``, ..."""
    return tuple(f"channel {k}" for k in range(1, count + 1))


def names_or_default(names: object, count: int) -> tuple[str, ...]:
    """`names` where they are a list of as many, else the default ones."""
    if isinstance(names, (list, tuple)) and len(names) == count:
        return tuple(str(name) for name in names)
    return default_names(count)


def spectral_names(wavelengths: Iterable[float]) -> tuple[str, ...]:
    """Names for wavelengths [nm].

    Examples
    --------
    >>> spectral_names((400, 412.5))
    ('400 nm', '412.5 nm')
    """
    return tuple(f"{w:g} nm" for w in wavelengths)


def wavelengths_of(names: Sequence[str]) -> tuple[float, ...] | None:
    """The wavelengths [nm] that names say; None unless all are wavelengths.

    Examples
    --------
    >>> wavelengths_of(("400 nm", "412.5nm")), wavelengths_of(("R", "G", "B"))
    ((400.0, 412.5), None)
    """
    found = [_WAVELENGTH.fullmatch(name) for name in names]
    return tuple(float(m[1]) for m in found if m) if names and all(found) else None


def colours_of(names: Sequence[str]) -> tuple[int, int, int] | None:
    """Which of red (0), green (1) and blue (2) each of three channels is; None unless they are the three, in any order.

    Examples
    --------
    >>> colours_of(("B", "g", "Red")), colours_of(("grey",))
    ((2, 1, 0), None)
    """
    found = [_COLOURS.get(name.strip().lower(), -1) for name in names]
    if sorted(found) != [0, 1, 2]:
        return None
    first, second, third = found
    return first, second, third
