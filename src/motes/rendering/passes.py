"""Rendering as Motes does it: the same noise in every run, and passes that an interrupt need not wait long for."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.rendering.flat import LAMP_DEG, check_lamp
from motes.rendering.interrupts import interrupt_after
from motes.rendering.lookup import FILTERS, GAPS, MOST_REPEATS, one_of

Floats = NDArray[np.floating[Any]]
STILL, FILM = 64, 32  # samples a pixel, when nothing else is said
PATHS_AT_ONCE = 1 << 23  # some seconds on two cores


@final
@dataclass(frozen=True)
class Look:
    """How a material is looked at.

    Parameters
    ----------
    scene
        ``sphere``, ``bunny``, ``teapot``, ``flat``, the path of a mesh, or of a Mitsuba scene (.xml) with ``$material`` in it.
    size
        Width and height in pixels of a panel; a Mitsuba scene has its own.
    samples
        Paths a pixel.
    seed
        Of the paths.
    env
        An environment map in place of the studio's lights.
    up
        The up direction of a mesh from a file.
    lamp_deg
        theta and phi [degrees] of the lamp over a flat sample.
    repeat
        Copies of a map along each side of a flat sample or of a mesh's texture, around a sphere; None for 1, and 2 around a sphere.
    filter
        Of a map: ``nearest``, or ``bilinear``, which mixes the light of four texels, not their parameters.
    gaps
        Texels without a fit: ``fill`` from the nearest that has one, or ``mark``.
    strict
        Texels with a parameter that the data do not determine count as such.
    """

    scene: str = "sphere"
    size: tuple[int, int] = (512, 512)
    samples: int = STILL
    seed: int = 0
    env: Path | None = None
    up: tuple[float, ...] = (0.0, 1.0, 0.0)
    lamp_deg: tuple[float, ...] = LAMP_DEG
    repeat: int | None = None
    filter: str = FILTERS[0]
    gaps: str = GAPS[0]
    strict: bool = False

    def __post_init__(self) -> None:
        check_lamp(self.lamp_deg)
        if self.repeat is not None and not 1 <= self.repeat <= MOST_REPEATS:
            raise MotesError(f"{self.repeat} copies of a map are outside [1, {MOST_REPEATS}]", "1 shows it once")
        one_of("the look of a map", "filter", self.filter, FILTERS)
        one_of("the look of a map", "gaps", self.gaps, GAPS)
        if not 1 <= self.samples <= 1 << 20:
            raise MotesError(f"{self.samples} samples a pixel are outside [1, {1 << 20}]", f"{STILL} are usual")
        if not 0 <= self.seed < 1 << 32:
            raise MotesError(f"the seed {self.seed} is outside [0, {1 << 32})", "Any whole number in it will do")

    @property
    def is_xml(self) -> bool:
        """Whether the scene is a file of Mitsuba's."""
        return Path(self.scene).suffix.lower() == ".xml"


def rendered(description: Callable[[], Mapping[str, Any]], look: Look) -> Floats:
    """The radiance (H, W, 3) of a scene that is described when it is needed."""
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    with interrupt_after(mi):
        # Mitsuba's optimisation merges what is alike in an order that changes from run to run, and with it the noise.
        scene = mi.load_dict(dict(description()), optimize=False)
    return traced(mi, scene, look)


def traced(mi: Any, scene: Any, look: Look) -> Floats:
    """All samples of a scene, in passes that an interrupt need not wait long for."""
    width, height = (int(n) for n in scene.sensors()[0].film().size())
    passes = min(-(-width * height * look.samples // PATHS_AT_ONCE), look.samples)
    total: Floats = np.zeros((height, width, 3), np.float32)
    for k in range(passes):
        samples = (k + 1) * look.samples // passes - k * look.samples // passes
        with interrupt_after(mi):
            image = mi.render(scene, spp=_stratified(samples), seed=look.seed + k)
            total += np.array(image, np.float32)[..., :3] * np.float32(samples / look.samples)
    return total


def _stratified(samples: int) -> int:
    """The number that Mitsuba's multijitter rounds up to, with a warning where it has to."""
    across = math.isqrt(samples - 1) + 1
    return across * -(-samples // across)
