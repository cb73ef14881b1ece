"""The highlight of a BSDF of Mitsuba, as dust above it needs it: how much light of each direction it reflects, and how wide it is.

A foreign BSDF cannot be evaluated at another roughness, and tells nobody what it reflects.  But it can be sampled: what its glossy and mirroring samples
carry is their share of the light, and half of the facets that mirror light from above are tilted by less than atan(alpha), if they are those of GGX.
That is measured once, when a scene loads, at one place of the surface.  From then on a layer of dust blurs it as it blurs a highlight of Motes
(`motes.models.bending`).
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.arrays import Array
from motes.directions import Geometry
from motes.models import GGX
from motes.models.components import Piece

Floats = NDArray[np.float64]
COSINES = np.linspace(0.08, 1.0, 12)
#: Samples at each cosine; a variant that does not compile takes them one by one.
SAMPLES, FEW = 4096, 1024
#: Multiples of these, modulo 1, fill a cube evenly: powers of the root of x^4 = x + 1
#: (Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
STEPS = 1.2207440846057596 ** -np.arange(1, 4)
#: A mirror has this roughness: far less than dust adds.
LEAST_ROUGHNESS = 0.01
#: Less light than this is no highlight.
FAINT = 1e-3
#: Shares that differ by no more are of no colour.
EVEN = 0.005


class Measured(NamedTuple):
    """What was measured of a BSDF.

    Attributes
    ----------
    shares
        Of the highlight (4, C), or (4, 1) where all channels are alike: the coefficients of 1, x, x^2 and x^5 in the share of light that it
        reflects, x = 1 - cos(theta).
    alpha
        Its roughness.
    diffuse
        The share (C,) of uniform light that all else reflects, over what `eval_diffuse_reflectance` tells: nothing where it tells of the highlight alone.
    """

    shares: Floats
    alpha: float
    diffuse: Floats


def basis(x: Any) -> list[Any]:
    """What `Measured.shares` are the coefficients of."""
    squared = x * x
    return [x * 0 + 1, x, squared, squared * squared * x]


def measure(mi: Any, bsdf: Any) -> Measured | None:
    """The highlight of a BSDF, from its samples; None where it has none that reflects.

    C is 3, or 1 where channels are wavelengths or the variant has one.
    """
    mirrors = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.DeltaReflection
    if not bsdf.flags() & mirrors:
        return None
    wo, weight, kind = _sampled(mi, bsdf)  # (cosines, samples, ...)
    glossy = (kind & int(mirrors)) != 0
    shares = np.mean(weight * glossy[..., None], axis=1)
    diffuse = np.mean(weight * ((kind & int(mi.BSDFFlags.DiffuseReflection)) != 0)[..., None], axis=1)
    above = glossy[-1]
    alpha = max(_roughness(wo[-1, above], weight[-1, above].mean(1)), LEAST_ROUGHNESS)
    found = np.clip(shares, 0.0, 1.0)
    if found.max() < FAINT:
        return None
    fitted = np.linalg.lstsq(np.stack(basis(1 - COSINES), -1), found, rcond=None)[0]
    if np.ptp(found, axis=1).max() < EVEN:
        fitted = fitted.mean(1, keepdims=True)  # one number for all channels costs less at every hit
    uniform = np.average(diffuse, axis=0, weights=COSINES)
    return Measured(fitted, alpha, np.clip(uniform, 0.0, 1.0) / np.maximum(_told(mi, bsdf, len(uniform)), FAINT))


def _told(mi: Any, bsdf: Any, channels: int) -> Floats:
    """The diffuse reflectance that a BSDF tells of itself."""
    told = mi.unpolarized_spectrum(bsdf.eval_diffuse_reflectance(_place(mi, 0.0, 1.0)))
    found = np.array([float(np.ravel(np.array(x))[0]) for x in told])
    return found if len(found) == channels else found.mean(keepdims=True)


def _roughness(wo: Floats, weight: Floats) -> float:
    """tan(theta_h) in the middle of the weight, for light from above."""
    if not weight.any():
        return 0.0
    squared = (1 - wo[:, 2]) / np.maximum(1 + wo[:, 2], 1e-9)
    order = np.argsort(squared)
    total = np.cumsum(weight[order])
    return float(np.sqrt(squared[order][np.searchsorted(total, 0.5 * total[-1])]))


def _sampled(mi: Any, bsdf: Any) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Samples for light from each cosine: directions (cosines, N, 3), weights (cosines, N, C), and kinds (cosines, N)."""
    one_by_one = mi.variant().startswith("scalar")
    shape = (len(COSINES), FEW if one_by_one else SAMPLES)
    chosen, u, v = (0.5 + STEPS[:, None] * np.arange(shape[1])) % 1
    cosine, chosen, u, v = (np.broadcast_to(x, shape).ravel() for x in (COSINES[:, None], chosen, u, v))
    sine = np.sqrt(1 - cosine * cosine)
    if one_by_one:
        rows = [
            _sample(mi, bsdf, *each) for each in zip(*(x.tolist() for x in (sine, cosine, chosen, u, v)), strict=True)
        ]
        columns = [([*bs.wo], [*weight], int(bs.sampled_type)) for bs, weight in rows]
        wo, weight, kind = (np.array(column) for column in zip(*columns, strict=True))
    else:
        count = cosine.size
        given = [mi.Float(x) for x in (sine, cosine, chosen, u, v)]
        bs, weight = _sample(mi, bsdf, *given, count=count)
        wo, weight = (np.stack([np.broadcast_to(np.array(x), count) for x in found], -1) for found in (bs.wo, weight))
        kind = np.broadcast_to(np.array(bs.sampled_type), count)
    if mi.is_spectral or weight.shape[-1] != 3:
        weight = weight.mean(-1, keepdims=True)
    weight = np.nan_to_num(np.asarray(weight, np.float64))
    return wo.reshape(*shape, 3), weight.reshape(*shape, -1), kind.astype(np.int64).reshape(shape)


def _place(mi: Any, sine: Any, cosine: Any, count: int = 1) -> Any:
    """Where light comes from a direction, in the middle of all textures."""
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, count)
    si.wi = mi.Vector3f(sine, 0.0, cosine)
    si.n, si.sh_frame, si.uv = mi.Normal3f(0, 0, 1), mi.Frame3f(mi.Vector3f(0, 0, 1)), mi.Point2f(0.5, 0.5)
    if mi.is_spectral:
        si.wavelengths = type(si.wavelengths)(*np.linspace(420.0, 680.0, len(si.wavelengths)).tolist())
    return si


def _sample(
    mi: Any, bsdf: Any, sine: Any, cosine: Any, chosen: Any, u: Any, v: Any, *, count: int = 1
) -> tuple[Any, Any]:
    import drjit as dr

    si = _place(mi, sine, cosine, count)
    with dr.suspend_grad():  # type: ignore[no-untyped-call]
        bs, weight = bsdf.sample(mi.BSDFContext(), si, chosen, mi.Point2f(u, v))
    return bs, mi.unpolarized_spectrum(weight)


def facets(shares: Iterable[Array], alpha: float) -> Piece:
    """A measured highlight as dust above sees it; `shares` are those of `Measured` as numbers of the namespace that formulas run over."""
    given = tuple(shares)

    def reflected(xp: Array, cosine: Array) -> Array:
        total: Array = 0.0
        for share, term in zip(given, basis(1 - cosine), strict=True):
            total = total + share * term
        return xp.minimum(xp.maximum(total, 0.0), 1.0)

    def formula(xp: Array, geometry: Geometry) -> Array:
        """The facets of GGX that are most like it."""
        return reflected(xp, geometry.cos_theta_d) * GGX(1.0, alpha).formula(xp, geometry)

    # The BSDF samples it: no parts.
    return Piece(formula, lambda xp: partial(reflected, xp), lambda xp, cosine: [], alpha)
