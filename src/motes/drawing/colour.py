"""Colour for pictures: channels to linear sRGB, the transfer curve, two colour maps, PNG.  No dependency but NumPy."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.channels import colours_of
from motes.images import png_writing

Floats = NDArray[np.floating[Any]]

# XYZ (D65 white) to linear sRGB: IEC 61966-2-1.
_XYZ_TO_SRGB = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]])
_WHITE = np.linalg.inv(_XYZ_TO_SRGB) @ np.ones(3)
# Linear sRGB to XYZ relative to white: a neutral surface has X = Y = Z, as under equal-energy light.
SRGB_TO_XYZ = np.linalg.inv(_XYZ_TO_SRGB) / _WHITE[:, None]
# Luminance of linear sRGB, the second row of the inverse.
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
# ColorBrewer RdBu, 11 classes (Brewer 2003), reversed: blue negative, red positive; told apart with every common colour deficiency.
_DIVERGING = (
    "053061",
    "2166ac",
    "4393c3",
    "92c5de",
    "d1e5f0",
    "f7f7f7",
    "fddbc7",
    "f4a582",
    "d6604d",
    "b2182b",
    "67001f",
)
# viridis (van der Walt, Smith 2015), ten stops.
_SEQUENTIAL = ("440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725")


def xyz_bar(wavelengths: ArrayLike) -> Floats:
    """The CIE 1931 2-degree colour matching functions (W, 3) at wavelengths [nm], in their multi-lobe approximation.

    Source: C. Wyman, P.-P. Sloan, P. Shirley, "Simple analytic approximations to the CIE XYZ color matching functions", JCGT 2(2), 2013.  The error is below
    0.03 of functions that peak at 1 to 1.8.
    """
    nm = np.asarray(wavelengths, np.float64)

    def lobe(center: float, below: float, above: float) -> Floats:
        return np.exp(-0.5 * ((nm - center) / np.where(nm < center, below, above)) ** 2)

    x = 1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2)
    y = 0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1)
    z = 1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)
    return np.stack([x, y, z], -1)


class ColorOf(NamedTuple):
    """How channels become linear sRGB: a matrix (C, 3), and a sentence that says so."""

    matrix: Floats
    meaning: str


def channels_to_srgb(channels: Sequence[str], wavelengths: ArrayLike | None = None) -> ColorOf:
    """The matrix from channel values to linear sRGB in which a surface of equal reflectance in all channels is neutral.

    Channels named R, G, B are taken as linear sRGB, and X, Y, Z as CIE XYZ relative to white; wavelengths that cover the
    visible are integrated against the colour matching functions under equal-energy light and scaled so that white is white
    (a von Kries adaptation in XYZ); anything else becomes its mean, in grey.

    Parameters
    ----------
    channels
        C names.
    wavelengths
        (C,) [nm], increasing, or None.
    """
    n = len(channels)
    colours = colours_of(channels)
    if colours is not None:
        return ColorOf(np.eye(3)[list(colours)], "R, G and B are shown as linear sRGB")
    if tuple(channels) == ("X", "Y", "Z"):
        return ColorOf(np.linalg.inv(SRGB_TO_XYZ).T, "X, Y and Z are turned into sRGB, equal ones being neutral")
    if wavelengths is not None and n >= 3:
        nm = np.asarray(wavelengths, np.float64)
        # Weights of the trapezoid rule, the ends standing for as much on their outer side.
        curves = xyz_bar(nm) * np.gradient(nm)[:, None]
        if nm.min() <= 480 and nm.max() >= 620 and np.all(np.diff(nm) > 0):
            matrix = (curves / curves.sum(0) * _WHITE) @ _XYZ_TO_SRGB.T
            return ColorOf(
                matrix,
                "spectra are turned into sRGB through the CIE 1931 2° colour matching functions "
                "(analytic fit of Wyman, Sloan and Shirley 2013), equal-energy light, white kept white, out-of-gamut values clipped",
            )
    return ColorOf(
        np.full((n, 3), 1 / n), "shown in grey" if n == 1 else f"the mean of the {n} channels is shown in grey"
    )


def srgb_curve(linear: ArrayLike) -> NDArray[np.float64]:
    """Linear values of [0, 1] along the curve of sRGB (IEC 61966-2-1), to [0, 1]."""
    x = np.asarray(linear, np.float64)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)


def srgb_encode(linear: ArrayLike) -> NDArray[np.uint8]:
    """Linear values to 8-bit sRGB (IEC 61966-2-1); what lies outside [0, 1] is clipped, NaN becomes 0."""
    return np.round(255 * srgb_curve(np.clip(np.nan_to_num(np.asarray(linear, np.float64)), 0, 1))).astype(np.uint8)


def _map(stops: tuple[str, ...], t: ArrayLike) -> NDArray[np.uint8]:
    table = np.array([[int(s[k : k + 2], 16) for k in (0, 2, 4)] for s in stops], np.float64)
    t = np.clip(np.asarray(t, np.float64), 0, 1)
    position = np.linspace(0, 1, len(stops))
    return np.stack([np.interp(t, position, table[:, k]) for k in range(3)], -1).round().astype(np.uint8)


def diverging(t: ArrayLike) -> NDArray[np.uint8]:
    """RGB (..., 3) for t in [-1, 1]: blue, white at 0, red."""
    return _map(_DIVERGING, 0.5 * (np.asarray(t, np.float64) + 1))


def sequential(t: ArrayLike) -> NDArray[np.uint8]:
    """RGB (..., 3) for t in [0, 1]: dark blue to yellow."""
    return _map(_SEQUENTIAL, t)


def hex_color(rgb: ArrayLike) -> str:
    """``#rrggbb`` of three 8-bit values."""
    return "#" + "".join(f"{int(v):02x}" for v in np.asarray(rgb))


def png(pixels: NDArray[np.uint8]) -> bytes:
    """A PNG file of 8-bit pixels (H, W, 3) or (H, W, 4), straight alpha; grey pictures are stored as grey."""
    n = pixels.shape[-1]
    if np.array_equal(pixels[..., 0], pixels[..., 1]) and np.array_equal(pixels[..., 0], pixels[..., 2]):
        pixels = pixels[..., [0, 3]] if n == 4 else pixels[..., :1]
    return png_writing.encoded(pixels)


def data_uri(file: bytes, kind: str = "image/png") -> str:
    """The file as a ``data:`` address."""
    return f"data:{kind};base64,{base64.b64encode(file).decode('ascii')}"
