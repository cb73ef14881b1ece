"""What the numbers of a picture mean: transfer functions, primaries, ICC profiles; to linear values of the sRGB primaries.

Sources: IEC 61966-2-1 (sRGB), ITU-R BT.709 and BT.2020, SMPTE EG 432-1 (P3), PNG third edition (gAMA, cHRM, cICP), ICC.1 (profiles, by LittleCMS).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.errors import MissingExtraError, MotesError

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]

#: x and y of red, green, blue and white.
SRGB = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
BT2020 = (0.708, 0.292, 0.170, 0.797, 0.131, 0.046, 0.3127, 0.3290)
P3_D65 = (0.680, 0.320, 0.265, 0.690, 0.150, 0.060, 0.3127, 0.3290)
SAME = 0.0016  # chromaticities as close as this are the same: files round them to 3 digits
# Bradford's cone responses, as in ICC.1 annex E.
_BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])
LOWEST_GAMMA, HIGHEST_GAMMA = 0.05, 20.0


@final
@dataclass(frozen=True)
class Transfer:
    """How codes from 0 to 1 become linear light of the sRGB primaries.

    Parameters
    ----------
    kind
        ``linear``, ``srgb``, ``gamma`` or ``icc``.
    said
        Where that is known from, for people: ``its gAMA chunk says``.
    gamma
        The exponent, for ``gamma``.
    profile
        The ICC profile, for ``icc``; it brings its own primaries.
    primaries
        x and y of red, green, blue and white, or None for those of sRGB.
    """

    kind: str
    said: str = ""
    gamma: float = 1.0
    profile: bytes = b""
    primaries: tuple[float, ...] | None = None

    def __str__(self) -> str:
        what = {"linear": "linear", "srgb": "sRGB (IEC 61966-2-1)", "icc": "an ICC profile"}.get(
            self.kind, f"gamma {self.gamma:.4g}"
        )
        other = " of primaries other than sRGB's, turned into those" if self.primaries and self.kind != "icc" else ""
        return f"{what}{other}: {self.said}" if self.said else f"{what}{other}"

    def table(self, largest: int) -> Singles:
        """The linear value of every code from 0 to the largest."""
        codes = np.arange(largest + 1) / largest
        if self.kind == "srgb":
            codes = srgb_decode(codes)
        elif self.kind == "gamma":
            codes = codes**self.gamma
        return codes.astype(np.float32)

    def matrix(self, channels: int) -> Floats | None:
        """From the picture's primaries to those of sRGB (3, 3), or None where nothing is to be done."""
        if channels != 3 or self.primaries is None or self.kind == "icc" or same_primaries(self.primaries, SRGB):
            return None
        return to_srgb(self.primaries)


def asked(text: str) -> Transfer:
    """``linear``, ``srgb`` or an exponent such as ``2.2``, as somebody says it.

    Raises
    ------
    MotesError
        For anything else.
    """
    word = text.strip().lower()
    if word in ("linear", "srgb"):
        return Transfer(word, "as asked")
    try:
        gamma = float(word)
    except ValueError:
        gamma = np.nan
    if not LOWEST_GAMMA <= gamma <= HIGHEST_GAMMA:
        raise MotesError(
            f"the transfer function {text[:40]!r} is not known", "Say linear, srgb, or an exponent such as 2.2"
        )
    return Transfer("linear", "as asked") if gamma == 1 else Transfer("gamma", "as asked", gamma)


def srgb_decode(encoded: ArrayLike) -> Floats:
    """sRGB in [0, 1] to linear (IEC 61966-2-1)."""
    e = np.asarray(encoded, np.float64)
    return np.where(e <= 0.04045, e / 12.92, ((e + 0.055) / 1.055) ** 2.4)


def same_primaries(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return bool(np.abs(np.subtract(a, b)).max() < SAME)


def to_srgb(primaries: tuple[float, ...]) -> Floats:
    """The matrix (3, 3) from linear values of some primaries to those of sRGB; white stays white (adapted after Bradford).

    Raises
    ------
    MotesError
        Where the primaries span no colours.
    """
    own, target = _to_xyz(primaries), _to_xyz(SRGB)
    cones = _BRADFORD @ own.sum(axis=1), _BRADFORD @ target.sum(axis=1)
    if np.min(cones[0]) <= 0:
        raise _no_colours(primaries)
    adapted = np.linalg.solve(_BRADFORD, np.diag(cones[1] / cones[0]) @ _BRADFORD)
    return np.asarray(np.linalg.solve(target, adapted @ own))


def _to_xyz(primaries: tuple[float, ...]) -> Floats:
    """Columns are XYZ of red, green and blue, which add up to the white of Y = 1."""
    x, y = np.array(primaries[0::2], float), np.array(primaries[1::2], float)
    if (
        not (np.isfinite(x).all() and np.isfinite(y).all())
        or np.abs(y).min() < 1e-4
        or max(np.abs(x).max(), np.abs(y).max()) > 10
    ):
        raise _no_colours(primaries)
    columns = np.stack([x / y, np.ones(4), (1 - x - y) / y])
    if abs(np.linalg.det(columns[:, :3])) < 1e-6:
        raise _no_colours(primaries)
    return columns[:, :3] * np.linalg.solve(columns[:, :3], columns[:, 3])


def _no_colours(primaries: tuple[float, ...]) -> MotesError:
    shown = ", ".join(f"{x:.4g}" for x in primaries)
    return MotesError(
        f"the primaries {shown} (x and y of red, green, blue and white) span no colours", "The file is damaged"
    )


def by_profile(codes: NDArray[Any], profile: bytes, largest: int) -> Singles:
    """Codes (..., C) through an ICC profile to linear values of sRGB's primaries, C = 3, or to linear grey, C = 1.

    Raises
    ------
    MissingExtraError
        Without the package imagecodecs.
    MotesError
        When the profile is damaged, or for other channels.
    """
    try:
        import imagecodecs
    except ImportError:
        raise MissingExtraError("imagecodecs", "pictures", "Pictures with an ICC profile") from None
    space = "rgb" if codes.shape[-1] == 3 else "gray"
    try:
        if space == "rgb":
            wanted = imagecodecs.cms_profile("rgb", whitepoint=SRGB[6:], primaries=SRGB[:6], gamma=1.0)
        else:
            wanted = imagecodecs.cms_profile("gray", whitepoint=(*SRGB[6:], 1.0), gamma=1.0)
        whole = np.ascontiguousarray(codes.reshape(1, -1, codes.shape[-1]) if space == "rgb" else codes.reshape(1, -1))
        found = imagecodecs.cms_transform(
            whole,
            profile,
            wanted,
            colorspace=space,
            outcolorspace=space,
            outdtype="float32",
            intent=imagecodecs.CMS.INTENT.RELATIVE_COLORIMETRIC,
        )
    except Exception as error:  # CmsError, ValueError, RuntimeError: what a damaged profile makes of the library
        said = " ".join(str(error).split())[:120]
        raise MotesError(
            f"the ICC profile cannot be used: {said}",
            "Say what the numbers are: --transfer linear, srgb or an exponent",
        ) from None
    return np.asarray(found, np.float32).reshape(codes.shape)
