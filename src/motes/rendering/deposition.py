r"""Dust that settles on a mesh: how much of it lies where.

The optical thickness of the layer at a point x with normal n is that of a level, open surface times a share,

.. math::  \tau(x, t) = \tau_{open}(t) \; F(x) \, H(x) \, L(x) \, (1 - C(x)) \, N(x)

- F, *fall*: what arrives.  Dust comes down from directions omega spread about the source a (straight up unless told otherwise) with density
  p ~ (a . omega)^m, m = 1/spread^2; the surface catches it like light, and V, whether the way is free, is found with rays:
  :math:`F = \int V p \max(0, n \cdot \omega) d\omega \,/ \int p \, (a \cdot \omega) d\omega`.
- H, *hold*: what stays.  On a surface inclined by theta to the level, dust slides off beyond theta_s = 90 deg (1 - slipperiness), all but the share `adhesion`
  that sticks, and what sticks falls off beyond the vertical:
  :math:`H = [a + (1 - a)(1 - S((\theta - \theta_s)/w))] \, (1 - S((\theta - 90^\circ)/w))` with w = 15 deg and the smooth step S from -1 to 1.
- L, *lee*: where wind blows along the ground, dust is carried off from what it reaches: L = 1 - scour E.  E is the share of free rays against the wind, at
  elevations from 0 to 19 deg: behind a step of height h the shelter ends about 6 h away, as behind a step in a flow.
- C, *cleared*: what strokes, a painted mask or something that rubs have taken off (`motes.rendering.wiping`).
- N, *noise*: 1 + noise xi with smooth noise xi.

What becomes of the layer's look is Blinn's model, `motes.models.DustLayer`; tau_open(t) is the phenomenon ``dust`` of `motes.ageing`.

Sources: J. F. Blinn, "Light reflection functions for simulation of clouds and dusty surfaces", SIGGRAPH 1982 (the layer).  S. Hsu and T. Wong, "Simulating
dust accumulation", IEEE CG&A 15(1), 18-22, 1995 (an amount from inclination and stickiness, changed by exposure to wind and by scraping, perturbed
by noise).  The formulas for these ingredients are this module's own.  Dust that slides or is blown off is gone: it does not gather elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.ageing.phenomena import PHENOMENA
from motes.ageing.phenomenon import Option
from motes.errors import MotesError, ParameterError
from motes.material import Material
from motes.meshes.mesh import Mesh, unit
from motes.models import BRDF, Lambert, layer_of
from motes.rendering.gathering import falling, hold
from motes.rendering.noise import cloudy
from motes.rendering.rays import Progress, Surroundings
from motes.rendering.wiping import Stroke, look_up

Floats = NDArray[np.float64]

#: The numbers of a deposit that can be replaced.
SETTLING: dict[str, Option] = {
    "adhesion": Option(0.3, (0, 1), "share of the dust that sticks where the rest slides off; chosen"),
    "slipperiness": Option(
        0.2, (0, 1), "0: dust lies on anything up to the vertical; 1: it slides off any slope; chosen"
    ),
    "spread_deg": Option(15.0, (1, 60), "spread of the directions that dust falls from, in degrees; chosen"),
    "scour": Option(0.8, (0, 1), "share of the dust that wind carries off where it blows freely; chosen"),
    "noise": Option(0.25, (0, 1), "strength of the smooth noise; chosen"),
    "noise_scale": Option(0.06, (1e-4, 10), "size of its largest spots, as a share of the mesh's extent; chosen"),
}
SHELTER_DEG = 19.0  # rays against the wind reach up to here: their middle sees a step of height h from 6 h away
#: tau a day on a level surface; mirrors of five solar plants gathered 0.0015 to 0.0054 (docs/ageing.md).
GROWTH_PER_DAY = 0.005
LARGEST_TAU = 1000.0


class Points(NamedTuple):
    """Places on a mesh: positions (N, 3), unit normals (N, 3), texture coordinates (N, 2) or None."""

    positions: Floats
    normals: Floats
    uv: Floats | None

    @classmethod
    def of(cls, mesh: Mesh) -> Points:
        """The vertices of a mesh."""
        if mesh.normals is None:
            raise MotesError(f"{mesh.name} has no normals", "motes.meshes.mesh.with_normals computes them")
        return cls(mesh.positions, mesh.normals, mesh.uv)


@final
@dataclass(frozen=True, eq=False)
class Deposit:
    """How much dust lies where.

    Parameters
    ----------
    share
        (N,) tau over that of a level, open surface.
    factors
        What it is the product of: ``fall``, ``hold``, ``lee``, ``left`` (= 1 - cleared), ``noise``; (N,) each.
    options
        The numbers of `SETTLING` that were used.
    """

    share: Floats
    factors: Mapping[str, Floats]
    options: Mapping[str, float]

    def tau(self, open_tau: float) -> Floats:
        """Optical thickness (N,) where a level, open surface has `open_tau`; raises `ParameterError` for one out of range."""
        return float(checked_tau(np.full(1, open_tau), "tau of a level, open surface")[0]) * self.share


def deposit(
    mesh: Mesh,
    *,
    up: ArrayLike = (0.0, 1.0, 0.0),
    source: ArrayLike | None = None,
    wind: ArrayLike | None = None,
    strokes: Sequence[Stroke] = (),
    mask: Floats | None = None,
    rubbed_by: Mesh | None = None,
    others: Sequence[Mesh] = (),
    rays: int = 256,
    seed: int = 0,
    where: Points | None = None,
    progress: Progress | None = None,
    **options: Any,
) -> Deposit:
    """How much dust lies where on a mesh.

    Parameters
    ----------
    mesh
        With normals; it shelters itself.
    up
        The direction against gravity, (3,).
    source
        The mean direction that dust comes from, (3,); `up` when not given.
    wind
        The direction that the wind comes from, (3,); no wind when not given.  It carries dust off, so dust is left in the lee.
    strokes
        Of a brush or a finger.
    mask
        Numbers (H, W) in [0, 1] over the texture, the top row at v = 1; 1 is wiped clean.
    rubbed_by
        A mesh that rubs the dust off where it touches, within 0.3 % of the extent.
    others
        Meshes that shelter this one: what stands on it or over it.
    rays
        Directions of the fall; a quarter as many against the wind.
    seed
        Of the noise.
    where
        Places on the mesh; its vertices when not given.
    progress
        Called with (done, total, what).
    options
        By the names of `SETTLING`.

    Returns
    -------
    Deposit

    Raises
    ------
    ParameterError
        For an option that is not there or out of range.
    MotesError
        For a direction of no length, or a mask without texture coordinates.
    """
    values = settled_options(options)
    if not 1 <= rays <= 65536:
        raise ParameterError(f"rays = {rays} is outside [1, 65536]", "256 is usual")
    above = unit(up, "up")
    towards = above if source is None else unit(source, "source")
    points = Points.of(mesh) if where is None else where
    around = Surroundings([mesh, *others])
    fall = around.visible_share(
        points.positions, points.normals, falling(towards, values["spread_deg"], rays), "cosine", progress
    )
    fall /= (falling(towards, values["spread_deg"], rays) @ towards).mean()
    lee = np.ones(len(fall))
    if wind is not None:
        against = blowing(unit(wind, "wind"), above, max(rays // 4, 1))
        lee -= values["scour"] * around.visible_share(points.positions, points.normals, against, "one", progress)
    left = np.ones(len(fall))
    for k, stroke in enumerate(strokes):
        left *= 1 - stroke.taken(points.positions, seed + 100 + k)
    if mask is not None:
        if points.uv is None:
            raise MotesError(f"{mesh.name} has no texture coordinates, which a mask needs", "Unwrap it, or use strokes")
        left *= 1 - look_up(np.clip(mask, 0, 1), points.uv)
    if rubbed_by is not None:
        other = Surroundings([rubbed_by])
        left[other.touched(points.positions, points.normals, 0.003 * mesh.extent)] = 0.0
    size = values["noise_scale"] * mesh.extent
    noise = 1 + values["noise"] * cloudy(points.positions / size, seed) if values["noise"] else np.ones(len(fall))
    factors = {
        "fall": fall,
        "hold": hold(points.normals @ above, values["adhesion"], values["slipperiness"]),
        "lee": lee,
        "left": left,
        "noise": noise,
    }
    share = np.prod(list(factors.values()), axis=0)
    return Deposit(share, factors, values)


def settled_options(options: Mapping[str, Any]) -> dict[str, float]:
    """`SETTLING` with replacements, checked."""
    unknown = [name for name in options if name not in SETTLING]
    if unknown:
        raise ParameterError(f"dust has no option {unknown[0]!r}", f"It has {', '.join(SETTLING)}")
    return {
        name: float(option.checked("dust", name, options.get(name, option.default)))
        for name, option in SETTLING.items()
    }


def blowing(wind: Floats, above: Floats, n: int) -> Floats:
    """Directions (n, 3) against the wind: elevations from 0 to `SHELTER_DEG`, azimuths within 15 degrees of it."""
    level = wind - (wind @ above) * above
    if np.linalg.norm(level) < 1e-6:
        raise MotesError(
            "the wind blows straight along up", "Give a wind along the ground; --source is for dust from above"
        )
    along = level / np.linalg.norm(level)
    side = np.cross(above, along)
    k = np.arange(n) + 0.5
    elevation = np.deg2rad(SHELTER_DEG) * k / n
    azimuth = np.deg2rad(15) * (2 * ((k * (np.sqrt(5) - 1) / 2) % 1) - 1)
    flat = np.cos(azimuth)[:, None] * along + np.sin(azimuth)[:, None] * side
    return np.asarray(np.cos(elevation)[:, None] * flat + np.sin(elevation)[:, None] * above)


# ------------------------------------------------------------ tau


def open_tau(days: float, *, growth_per_day: float = GROWTH_PER_DAY, material: Material | None = None) -> float:
    """tau of a level, open surface after some days: that of a material's own dust, or the phenomenon ``dust`` at a rate.

    Parameters
    ----------
    days
        Since the surface was clean, or since time 0 of the material.
    growth_per_day
        Of tau; without a `material`.
    material
        A material with a dust layer on top, whose tau may follow time.

    Raises
    ------
    ParameterError
        For days or a rate below 0, or a material without dust.
    """
    layer = layer_of(dusted(days, growth_per_day=growth_per_day, material=material))
    assert layer is not None
    return float(checked_tau(np.ravel(layer.depth.value), "dust" if material is None else material.name)[0])


def dusted(days: float, *, growth_per_day: float = GROWTH_PER_DAY, material: Material | None = None) -> BRDF:
    """What a level, open surface is after some days: a model with dust on top; the arguments are those of `open_tau`."""
    if not (np.isfinite(days) and days >= 0):
        raise ParameterError(f"days = {days:g} is not a length of time", "Give a number of days, 0 or more")
    if material is not None:
        found = material.at(24 * days)
        if layer_of(found) is None:
            raise ParameterError(
                f"{material.name} has no layer of dust on top", "motes age MATERIAL --phenomenon dust lays one over it"
            )
        return found
    if not (np.isfinite(growth_per_day) and growth_per_day >= 0):
        raise ParameterError(f"growth_per_day = {growth_per_day:g} is not a rate", "Give tau a day, 0 or more")
    hours = 24 * max(days, 1.0)
    aged = PHENOMENA["dust"](Lambert(K_d=0.5), hours=hours, tau_growth=growth_per_day * hours / 24)
    return aged.at(24 * days)


def checked_tau(tau: Floats, what: str) -> Floats:
    """tau as it is; raises `ParameterError` when some are not numbers, below 0 or beyond `LARGEST_TAU`."""
    for bad, word in ((~np.isfinite(tau), "not finite"), (tau < 0, "negative"), (tau > LARGEST_TAU, "huge")):
        if bad.any():
            at = f", the first is number {int(np.argmax(bad))}" if len(tau) > 1 else ""
            raise ParameterError(
                f"{what}: {int(bad.sum())} of {len(tau)} values of tau are {word} ({tau[bad][0]:g}){at}",
                f"tau lies in [0, {LARGEST_TAU:g}]; 5 hides what is below, even seen from above",
            )
    return tau
