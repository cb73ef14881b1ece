"""`export_exr`: fitted maps as polynomials of time in OpenEXR pictures, in the layout of the STAF data.

``Diffuse-d.exr``, ``Specular-d.exr`` and ``Roughness-d.exr`` hold the coefficient of t^d at each texel, with t from 0 at the first time to 1 at the
last: Diffuse is K_d, Roughness is sigma_s, and Specular the weight S of the highlight, K_s = S / (pi R^2 (1 - exp(-1/R^2))), as `motes.read`
takes them back.  Parameters that the layout does not know (sigma_d, say) go into pictures of their own names, which its readers pass over.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.files import together
from motes.images import exr, library
from motes.maps.fitted import FittedMap
from motes.models import BRDF
from motes.parameters import Role, Slot

Floats = NDArray[np.float64]

MOST_DEGREE = 3
PURPOSE = "The export as pictures"


def export_exr(
    fitted: FittedMap,
    folder: str | os.PathLike[str],
    *,
    progress: Callable[[int, int, str], None] | None = None,
) -> list[Path]:
    """Write the maps of a fit as EXR pictures in the STAF layout, which `motes.read` reads.

    Parameters
    ----------
    fitted
        From `motes.maps.fit_map`.
    folder
        Made where it does not exist.
    progress
        Called with (done, total, what).

    Returns
    -------
    list of Path
        The pictures, float32.  Polynomials are of degree 3, or less where there are fewer than 4 times; exact at 4 times or fewer, least squares
        beyond.  A texel without a fit at some times is taken from the others; one without any is 0, which is no highlight.

    Raises
    ------
    MotesError
        For models that the layout cannot hold: under dust, with a Fresnel term, several lobes of a kind, coloured lobes' widths.

    Notes
    -----
    One map with its coefficients is held at a time: 48 bytes a texel for a coloured cubic.
    """
    library.oiio(PURPOSE)  # before anything is worked out
    layout = _layout(fitted)
    gloss, diffuse = layout.gloss, layout.diffuse
    degree = min(MOST_DEGREE, len(fitted.hours) - 1)
    held = fitted.brdf.parameters

    def value(name: str, where: tuple[slice, slice]) -> Floats:
        """A parameter (y, x, T) or (y, x, T, C) of a block, fitted or held."""
        if name in fitted.quantities:
            return fitted.values(name, where)
        size = tuple(s.stop - s.start for s in where)
        constant = np.asarray(held[name], float)
        return np.broadcast_to(constant, (*size, len(fitted.hours), *constant.shape))

    def specular(where: tuple[slice, slice]) -> Floats:
        if gloss is None:
            return np.zeros((*(s.stop - s.start for s in where), len(fitted.hours)))
        strength, width = value(gloss.strength.name, where), value(gloss.width.name, where)
        many = strength.ndim == 4
        printed = gloss.model.printed_highlight(strength, width[..., None] if many else width)
        assert printed is not None
        K_s, sigma_s = printed
        specular: Floats = K_s * staf_area(sigma_s)
        return specular

    def zeros(where: tuple[slice, slice]) -> Floats:
        return np.zeros((*(s.stop - s.start for s in where), len(fitted.hours)))

    maps: dict[str, Callable[[tuple[slice, slice]], Floats]] = {
        "Diffuse": (lambda w: value(diffuse.name, w)) if diffuse else zeros,
        "Specular": specular,
        "Roughness": (lambda w: value(gloss.width.name, w)) if gloss else zeros,
    }
    for name in layout.others:
        maps[name] = partial(value, name)
    target = Path(folder)
    written = []
    with together(target) as staging:
        for k, (name, of) in enumerate(maps.items()):
            if progress:
                progress(k, len(maps), f"writing {name}")
            coefficients = np.zeros((degree + 1, *fitted.shape, 3), np.float32)
            for block in fitted.blocks:
                where = fitted.blocks.slices(block)
                part = polynomials(of(where), fitted.hours, degree)
                coefficients[(slice(None), *where)] = part if part.ndim == 4 else part[..., None]
            for d, picture in enumerate(coefficients):
                written.append(target / exr.write(staging / f"{name}-{d}.exr", picture, PURPOSE).name)
    return written


def staf_area(sigma_s: Floats) -> Floats:
    """S / K_s of the STAF layout: pi R^2 (1 - exp(-1/R^2))."""
    r2 = np.square(sigma_s)
    with np.errstate(divide="ignore", over="ignore"):
        return np.pi * r2 * -np.expm1(-1 / r2)


def polynomials(values: Floats, hours: Floats, degree: int) -> Floats:
    """Coefficients (degree + 1, y, x[, C]) of t^d that fit values (y, x, T[, C]) at times, t from 0 to 1; NaN is left out."""
    span = hours[-1] - hours[0]
    t = (hours - hours[0]) / span if span > 0 else np.zeros(len(hours))
    rows = np.moveaxis(values, 2, -1)  # (y, x[, C], T)
    flat = rows.reshape(-1, len(t))
    good = np.isfinite(flat)
    result = np.zeros((len(flat), degree + 1))
    for pattern in np.unique(good, axis=0):
        n = int(pattern.sum())
        if n == 0:
            continue
        own = np.flatnonzero((good == pattern).all(axis=1))
        powers = min(degree, n - 1) + 1
        basis = np.linalg.pinv(np.vander(t[pattern], powers, increasing=True))
        result[own, :powers] = flat[own][:, pattern] @ basis.T
    return np.moveaxis(result.reshape(*rows.shape[:-1], degree + 1), -1, 0)


class _Gloss(NamedTuple):
    """The highlight of a map: the term that it is, and the parameters of its strength and width in the whole model."""

    model: BRDF
    strength: Slot
    width: Slot


class _Layout(NamedTuple):
    """What the layout knows, the diffuse colour and the highlight, and the names of the parameters that it does not know."""

    diffuse: Slot | None
    gloss: _Gloss | None
    others: list[str]


def _layout(fitted: FittedMap) -> _Layout:
    """What of the model goes where."""
    brdf = fitted.brdf
    hint = "Export lambert or oren_nayar, torrance_sparrow, or a sum of the two; the Zarr store holds every model"
    for term in brdf.terms():
        own = {p.role for p in term.declared()} & {Role.DIFFUSE_COLOUR, Role.HIGHLIGHT_STRENGTH}
        if len(own) != 1:
            raise MotesError(
                f"the STAF layout has no place for {term.in_words()}, and the model is {fitted.model}",
                hint,
            )
    colours, strengths = brdf.slots(Role.DIFFUSE_COLOUR), brdf.slots(Role.HIGHLIGHT_STRENGTH)
    if len(colours) > 1 or len(strengths) > 1:
        raise MotesError(f"the STAF layout holds one lobe of a kind, and the model is {fitted.model}", hint)
    gloss = None
    if strengths:
        term = next(term for term in brdf.terms() if term.slots(Role.HIGHLIGHT_STRENGTH))
        width = brdf.beside(strengths[0], Role.HIGHLIGHT_WIDTH)
        if width is None or term.printed_highlight(1.0, 0.1) is None:
            raise MotesError(
                f"the STAF layout holds the highlight of equations (9)-(11) with F = 1, and the model is {fitted.model}",
                hint,
            )
        gloss = _Gloss(term, strengths[0], width)
    if len(fitted.channels) not in (1, 3):
        raise MotesError(f"the STAF layout holds 1 or 3 channels, and the map has {len(fitted.channels)}", hint)
    known = {slot.name for slot in (*colours, *gloss[1:])} if gloss else {slot.name for slot in colours}
    return _Layout(colours[0] if colours else None, gloss, [q for q in brdf.parameters if q not in known])
