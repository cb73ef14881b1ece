"""A sphere of a material, lit by one lamp and a dim white dome: what the numbers look like."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.channels import default_names
from motes.drawing.colour import Floats, channels_to_srgb, srgb_encode
from motes.models import BRDF

# Directions evaluated at a time: the arrays of a pass stay in the cache, and far below the size at which kernels are compiled.
CHUNK = 1 << 13
# Values (directions x channels) of a picture at a time, where there are many channels.
AT_ONCE = 1 << 21


class Light(NamedTuple):
    """A distant lamp: its direction as seen from the sphere (x right, y up, z to the camera), and words for it."""

    name: str
    direction: tuple[float, float, float]
    words: str


def _lamp(name: str, from_camera_deg: float, words: str) -> Light:
    """A lamp so many degrees from the camera, towards the upper left."""
    angle, up = np.deg2rad(from_camera_deg), np.deg2rad(30)
    x, y, z = -np.sin(angle) * np.cos(up), np.sin(angle) * np.sin(up), np.cos(angle)
    return Light(name, (float(x), float(y), float(z)), words)


LIGHTS = {
    light.name: light
    for light in (
        _lamp("front", 0, "from the camera"),
        _lamp("three-quarter", 45, "45° to the side"),
        _lamp("side", 90, "from the side"),
        _lamp("back", 135, "from behind"),
    )
}


def evaluate(brdf: BRDF, wi: ArrayLike, wo: ArrayLike) -> Floats:
    """``brdf.eval`` of many pairs of directions (n, 3) in pieces that stay in the cache; (n, C)."""
    wi, wo = np.broadcast_arrays(wi, wo)
    parts = [np.asarray(brdf.eval(wi[k : k + CHUNK], wo[k : k + CHUNK])) for k in range(0, len(wi), CHUNK)]
    return np.concatenate(parts) if parts else np.zeros((0, brdf.channels))


def sphere_radiance(
    brdf: BRDF,
    size: int = 256,
    *,
    light: str | Sequence[float] = "three-quarter",
    dome: float = 0.15,
    samples: int = 2,
) -> tuple[Floats, Floats]:
    """Radiance of an orthographic sphere, before any colour: for those who want channels rather than a picture.

    The lamp is distant and parallel, without shadows but the sphere's own; the dome is uniform white from all sides, for which the exact answer for a
    convex body is the directional albedo towards the camera.  Together they make a white diffuser that faces the lamp 1.

    Parameters
    ----------
    brdf
        Parameters without axes but channels.
    size
        Pixels along a side; the sphere fills the square but for a pixel.
    light
        A name of `LIGHTS`, or a direction to the lamp (x right, y up, z to the camera).
    dome
        Share of the dome, 0 to 1; the lamp has the rest.
    samples
        Samples a pixel along each side.  The outline is smooth also with 1.

    Returns
    -------
    radiance (size, size, C)
        Mean over the part of the pixel that the sphere covers.
    coverage (size, size)
        That part, 0 to 1.
    """
    (radiance,), coverage = sphere_radiances(brdf, size, [light], dome=dome, samples=samples)
    return radiance, coverage


def sphere_radiances(
    brdf: BRDF,
    size: int,
    lights: Sequence[str | Sequence[float]],
    *,
    dome: float = 0.15,
    samples: int = 1,
    colours: Floats | None = None,
) -> tuple[list[Floats], Floats]:
    """`sphere_radiance` under several lights, sharing what they have in common: a list of radiances, and the coverage.

    `colours` (C, K) makes K numbers of a radiance's channels at once: pictures of thousands of wavelengths need no room for each.
    """
    n = size * samples
    # float32: a picture has eight bits, and half the memory traffic is half the time.
    axis = (((np.arange(n) + 0.5) / n * 2 - 1) * size / (size - 2)).astype(np.float32)
    x, y = np.meshgrid(axis, -axis)
    radius = np.sqrt(x * x + y * y)
    # The part of each small square inside the circle, as if the edge were straight: smooth outlines at no cost.
    part = np.clip(0.5 + (1 - radius) * (0.5 * (size - 2) * samples), 0, 1)
    inside = part > 0
    part = part[inside, None]
    shrink = np.minimum(
        1, np.float32(0.9995) / np.maximum(radius[inside], np.float32(1e-6))
    )  # squares on the edge take the normal just inside
    x, y = x[inside] * shrink, y[inside] * shrink
    x[(x == 0) & (y == 0)] = 1e-4  # azimuth needs a side, also in the middle
    normal = np.stack([x, y, np.sqrt(1 - x * x - y * y)], -1)
    under_dome = dome * _seen_under_dome(brdf, normal[:, 2], colours) if dome else np.float32(0)

    def pixels(values: Floats) -> Floats:
        """Sums over the squares of each pixel."""
        grid = np.zeros((n, n, values.shape[-1]), np.float32)
        grid[inside] = values
        return grid.reshape(size, samples, size, samples, -1).sum((1, 3)) if samples > 1 else grid

    covered = pixels(part)
    radiances: list[Floats] = []
    for light in lights:
        towards = np.asarray(LIGHTS[light].direction if isinstance(light, str) else light, np.float32)
        lamp = np.float32(1 - dome) * _lit(brdf, normal, towards / np.linalg.norm(towards), colours)
        radiances.append(pixels((lamp + under_dome) * part) / np.maximum(covered, 1e-6))
    return radiances, covered[..., 0] / samples**2


def _lit(brdf: BRDF, normal: Floats, towards: Floats, colours: Floats | None) -> Floats:
    """Radiance (n, C) towards the camera under a lamp that makes a white diffuser facing it 1: pi f cos(theta_i)."""
    cos_i = normal @ towards
    lit = np.flatnonzero(cos_i > 0)
    x, y, cos_r = normal[lit].T
    cos_i = cos_i[lit]
    sin_r = np.sqrt(x * x + y * y)
    # The local frame: the camera's direction projected onto the surface, its cross product with the normal, and the normal.
    wi = np.stack([(towards[2] - cos_r * cos_i) / sin_r, (y * towards[0] - x * towards[1]) / sin_r, cos_i], -1)
    wo = np.stack([sin_r, np.zeros_like(sin_r), cos_r], -1)
    value = np.zeros((len(normal), brdf.channels if colours is None else colours.shape[1]), np.float32)
    step = max(256, AT_ONCE // brdf.channels)
    for k in range(0, len(lit), step):
        part = slice(k, k + step)
        seen = np.float32(np.pi) * evaluate(brdf, wi[part], wo[part]) * cos_i[part, None]
        value[lit[part]] = seen if colours is None else seen @ colours
    return value


def _seen_under_dome(brdf: BRDF, cos_theta_r: Floats, colours: Floats | None) -> Floats:
    """Radiance (n, C) towards polar angles under uniform unit radiance: for a reciprocal BRDF its directional albedo, interpolated."""
    theta = np.linspace(0, np.deg2rad(89), 24)
    w = directions.from_spherical(theta, 0.0)
    if brdf.reciprocal:
        albedo = np.asarray(brdf.directional_albedo(w, nodes=(24, 32)))
    else:  # the integral is over wi, and f depends on which direction is which: a plain cosine-weighted grid
        u, v = np.meshgrid((np.arange(48) + 0.5) / 48, (np.arange(48) + 0.5) / 48)
        wi = directions.from_spherical(np.arcsin(np.sqrt(u.ravel())), 2 * np.pi * v.ravel())
        albedo = np.stack([np.pi * evaluate(brdf, wi, np.broadcast_to(wo, wi.shape)).mean(0) for wo in w])
    albedo = albedo if colours is None else albedo @ colours
    theta_r = np.arccos(np.clip(cos_theta_r, 0, 1))
    return np.stack([np.interp(theta_r, theta, albedo[:, c]) for c in range(albedo.shape[-1])], -1).astype(np.float32)


def render_sphere(
    brdf: BRDF,
    size: int = 256,
    *,
    light: str | Sequence[float] = "three-quarter",
    channels: Sequence[str] | None = None,
    wavelengths: ArrayLike | None = None,
    exposure: float = 1.0,
    dome: float = 0.15,
    samples: int = 2,
) -> NDArray[np.uint8]:
    """A picture of a sphere of the material: 8-bit sRGB with straight alpha, (size, size, 4); see `sphere_radiance` for the light.

    Parameters
    ----------
    brdf, size, light, dome, samples
        As in `sphere_radiance`.
    channels, wavelengths
        Names (C,) and, for spectra, wavelengths (C,) [nm]; by default R, G, B for three channels, else grey.
    exposure
        Factor on the radiance; at 1 a white diffuser that faces the lamp is display white.  What is brighter clips.

    Examples
    --------
    >>> from motes import Lambert
    >>> picture = render_sphere(Lambert(K_d=1.0), 65, light="front")
    >>> picture[32, 32].tolist(), picture[0, 0].tolist()
    ([255, 255, 255, 255], [0, 0, 0, 0])
    """
    if channels is None:
        channels = default_names(brdf.channels)
    matrix = channels_to_srgb(channels, wavelengths).matrix
    radiance, coverage = sphere_radiance(brdf, size, light=light, dome=dome, samples=samples)
    rgb = np.broadcast_to(radiance, (size, size, len(matrix))) @ matrix
    return np.concatenate([srgb_encode(exposure * rgb), np.round(255 * coverage).astype(np.uint8)[..., None]], axis=-1)
