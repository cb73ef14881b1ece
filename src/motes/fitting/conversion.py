"""From one model to another: the parameters that come nearest over the hemisphere, with the distance that is left.

Formulas between parameters (alpha = roughness^2, sigma_s = alpha) hold for one angle or for small values; what a program shows is light from everywhere.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from motes.directions import above, from_spherical
from motes.errors import MotesError
from motes.fitting.front import fit
from motes.fitting.losses import loss_named
from motes.fitting.result import Fit
from motes.measurements import Measurement
from motes.models import BRDF, GGX, Lambert, describe, parse
from motes.parameters import Role

Floats = NDArray[np.float64]
#: Polar angles of the light [rad], Gauss-Legendre nodes of [0, pi/2], and directions towards the viewer for each.
LIGHTS, VIEWERS = 10, 150
#: What finds the directions of highlights that the source has not: where large values count less, a fit would else not see a glint of its own.
GLINTS = (GGX(1.0, 0.006), GGX(1.0, 0.05))


@dataclass(frozen=True)
class Conversion:
    """What `convert` returns.

    Attributes
    ----------
    brdf
        The other model.
    relative_rms
        The root mean square of what differs over the hemisphere (values times both cosines), relative to that of the source.
    albedo
        The largest difference of the directional albedos at the same angles, over channels.
    seen
        The root mean square of what differs in the cube roots of what a picture shows, relative to that of the source: about the eye's lightness.
    """

    brdf: BRDF
    relative_rms: float
    albedo: float
    seen: float

    @classmethod
    def between(cls, source: BRDF, brdf: BRDF) -> Conversion:
        """Another model in the place of a source, and how far it is from it."""
        wi, wo, weights = pairs(source, brdf)  # directions of both, of which a fit sees those of the source alone
        got, wanted = brdf.eval(wi, wo), source.eval(wi, wo)
        off = float(relative_rms(got, wanted, wi, weights))
        return cls(brdf, off, _albedo(brdf, source), float(seen(got, wanted, wi, wo, weights)))

    def said(self) -> str:
        """A sentence for people and for files."""
        return (
            f"Converted to {describe(self.brdf)} by a fit over the hemisphere: {100 * self.relative_rms:.2g} % relative RMS, albedos within "
            f"{self.albedo:.2g}."
        )


def convert(model: BRDF | str, to: str, *, loss: str = "linear", start: BRDF | None = None) -> Conversion:
    """The parameters of another model with which it reflects most nearly the same.

    Parameters
    ----------
    model
        A BRDF, or its text with values: ``"oren_nayar(K_d=0.5, sigma_d=0.3)"``.
    to
        The text of the other: ``"eon + ggx(fresnel=schlick)"``; values given in it are held.
    loss
        What is made small, see `motes.fitting.losses`: ``"linear"`` for energy, ``"cube_root"`` for what the eye sees.
    start
        A model of the same kind as the other, such as one found with more of it held: the search begins at its values, too.

    Returns
    -------
    Conversion
        With its error: nothing is exact but a model of the same kind.

    Raises
    ------
    MotesError
        For a source that is not reciprocal (brightness of dust), or black.

    Examples
    --------
    >>> from motes import Beckmann
    >>> found = convert(Beckmann(0.5, 0.3), "torrance_sparrow(normalization=facets)")
    >>> round(float(found.brdf.parameters["sigma_s"]), 2)
    0.31
    """
    source = parse(model).model if isinstance(model, str) else model
    check_reciprocal(source)
    linear = loss_named(loss).is_linear
    wi, wo, weights = pairs(source, *(() if linear else GLINTS))
    if not linear:
        weights = weights / wo[:, 2]  # the viewer's cosine once: by how much of a picture shows the surface from there
    values = source.eval(wi, wo)
    if not values.any():
        raise MotesError(f"{describe(source)} reflects nothing: there is nothing to convert", "Give it a colour")
    about = {"name": describe(source), "simulated": f"values of {describe(source)}"}
    data = Measurement.from_arrays(wi, wo, values, weights=weights, provenance=about)
    target, held = parse(to)
    strengths = coloured_strengths(source, target)
    wanted: str | BRDF = to
    if start is not None:
        values = {name: value for name, value in start.parameters.items() if name not in held}
        wanted = target.with_parameters(values)
    found = fit(
        data, wanted, loss=loss, per_channel=strengths, errors="independent", fixed=held if start is not None else ()
    )
    assert isinstance(found, Fit)  # one time
    return Conversion.between(source, found.material.brdf)


def check_reciprocal(source: BRDF) -> None:
    """Refuse what is no BRDF: dust in the form of brightness."""
    if not source.reciprocal:
        raise MotesError(f"{describe(source)} is not reciprocal, so it is no BRDF", "Give dust form='brdf'")


def coloured_strengths(source: BRDF, target: BRDF) -> tuple[str, ...]:
    """The strengths of the target's highlights that have a value per channel in a fit, because those of the source have."""
    if not any(np.ndim(s.value) and s.parameter.shared_in_fit for s in source.slots()):
        return ()
    return tuple(slot.name for slot in target.slots(Role.HIGHLIGHT_STRENGTH) if slot.parameter.per_channel)


def pairs(
    *models: BRDF, lights: int = LIGHTS, viewers: int = VIEWERS, shift: tuple[float, float] = (0.5, 0.5)
) -> tuple[Floats, Floats, Floats]:
    """Directions for every light, as many after the cosine as after each model's own lobes, and the weight of each: solid angle times cosine.

    Parameters
    ----------
    *models
        Whose lobes are seen.
    lights, viewers
        Polar angles of the light, and directions towards the viewer for each of them and each way to choose them.
    shift
        Of the points that choose them; another one has other directions.
    """
    x, polar = np.polynomial.legendre.leggauss(lights)
    theta = 0.25 * np.pi * (x + 1)
    numbers = even(viewers, shift)
    samplers = (Lambert(1.0), *models)
    found: list[tuple[Floats, Floats, Floats]] = []
    for light, share in zip(from_spherical(theta, 0.0), polar * np.sin(theta), strict=True):
        chosen = np.concatenate([np.asarray(m.sample(light, numbers).wo) for m in samplers])
        chosen = chosen[above(chosen)]
        density = sum(np.asarray(m.pdf(light, chosen)) for m in samplers)
        # The loss brings the light's cosine; the viewer's makes it what reaches the viewer from the surface as it is seen.
        found.append((np.broadcast_to(light, chosen.shape), chosen, share * chosen[:, 2] ** 2 / density))
    wi, wo, weights = (np.concatenate(parts) for parts in zip(*found, strict=True))
    return wi, wo, weights


def even(count: int, shift: tuple[float, float] = (0.5, 0.5)) -> Floats:
    """Evenly spread points (count, 2) of the unit square: Roberts' sequence, moved by `shift`."""
    ratio = 1.32471795724474602596  # the root of x^3 = x + 1
    k = np.arange(1, count + 1)[:, None]
    return np.asarray((np.asarray(shift) + k * np.array([1 / ratio, 1 / ratio**2])) % 1.0)


def relative_rms(got: Floats, wanted: Floats, wi: Floats, weights: Floats) -> Floats:
    """The relative root mean square of values (..., D, C) at directions (D, 3) as `pairs` has them, (...)."""
    return _rms(got, wanted, weights * wi[:, 2] ** 2)


def seen(got: Floats, wanted: Floats, wi: Floats, wo: Floats, weights: Floats) -> Floats:
    """As `relative_rms`, of the cube roots of values times the light's cosine, over how much of a picture shows each direction."""
    cosine = wi[:, 2:]
    return _rms(np.cbrt(got * cosine), np.cbrt(wanted * cosine), weights / wo[:, 2])


def _rms(got: Floats, wanted: Floats, shares: Floats) -> Floats:
    part = shares[:, None]
    squares = [np.sum(part * x * x, axis=(-2, -1)) for x in (got - wanted, wanted)]
    return np.asarray(np.sqrt(squares[0] / squares[1]))


def _albedo(brdf: BRDF, source: BRDF) -> float:
    """The largest difference of directional albedos, up to 80 degrees."""
    wi = from_spherical(np.radians(np.linspace(0, 80, 9)), 0.0)
    return float(np.max(np.abs(brdf.directional_albedo(wi) - source.directional_albedo(wi))))
