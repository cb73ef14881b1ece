"""The flat sample: lit by one distant lamp and seen from straight above, as samples are measured, so that the picture is the BRDF.

The sample lies in the plane of x, to the right, and y, upwards; the camera looks down along z and has no perspective.  The lamp's light
is scaled by its own cosine: a white diffuse surface has radiance 1 wherever the lamp stands, and what is seen of a surface is pi times its BRDF.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from motes.directions import from_spherical
from motes.errors import MotesError

#: Where the lamp stands when nothing is said: halfway down to the left, a little behind; (theta, phi) in degrees.
LAMP_DEG = (45.0, 135.0)
LOWEST_DEG = 85.0


def check_lamp(lamp_deg: tuple[float, ...]) -> None:
    """Raise `MotesError` for a lamp that is not above the sample."""
    if len(lamp_deg) != 2 or not np.isfinite(lamp_deg).all() or not 0 <= lamp_deg[0] <= LOWEST_DEG:
        raise MotesError(
            f"the lamp at {', '.join(f'{a:g}' for a in lamp_deg)} degrees is not above the sample",
            f"Give theta, from 0 overhead to {LOWEST_DEG:g}, and phi, 0 on the right and 90 behind: 45,135",
        )


def size_of(aspect: float, side: int) -> tuple[int, int]:
    """Pixels across and upwards of a sample `aspect` times as wide as high whose longer side has `side`."""
    if aspect >= 1:
        return side, max(round(side / aspect), 1)
    return max(round(side * aspect), 1), side


def flat(
    bsdf: Mapping[str, Any],
    aspect: float,
    film: Mapping[str, Any],
    *,
    lamp_deg: tuple[float, ...] = LAMP_DEG,
    environment: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """The scene as a dictionary for Mitsuba, the sample under the key ``object``.

    Parameters
    ----------
    bsdf
        A dictionary for Mitsuba; its texture coordinates run from 0 to 1 to the right and upwards.
    aspect
        How many times the sample is as wide as it is high.
    film
        Of Mitsuba; a pixel is the mean over its own area.  A film of another aspect shows all of the sample, and black beside it.
    lamp_deg
        theta and phi of the lamp.
    environment
        Light from all around, in place of the lamp.
    """
    from motes.rendering import load_mitsuba, load_scene

    mi = load_mitsuba()
    check_lamp(lamp_deg)
    transform = mi.ScalarTransform4f
    half = (1.0, 1 / aspect) if aspect >= 1 else (aspect, 1.0)
    pixels = film["width"], film["height"]
    seen = max(half[0], half[1] * pixels[0] / pixels[1])
    upwards = seen * pixels[1] / pixels[0]
    # The size of a picture is whole numbers: where the sample misses its edge by less than a pixel, it is made to fill it.
    across = half[0] if seen - half[0] < 2 * seen / pixels[0] else seen
    upwards = half[1] if upwards - half[1] < 2 * upwards / pixels[1] else upwards
    theta, phi = (math.radians(a) for a in lamp_deg)
    to_lamp = np.asarray(from_spherical(theta, phi), float)
    lamp = {
        "type": "directional",
        "direction": (-to_lamp).tolist(),
        "irradiance": {"type": "uniform", "value": math.pi / float(to_lamp[2])},
    }
    # The camera's x runs to the left where it looks along z; `look_at` turns it.
    camera = transform().look_at(origin=[0, 0, 2], target=[0, 0, 0], up=[0, 1, 0])
    return {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 2, "hide_emitters": True},
        "sensor": {
            "type": "orthographic",
            "to_world": camera.scale([across, upwards * pixels[0] / pixels[1], 1]),
            "film": {**film, "rfilter": {"type": "box"}},
            "sampler": {"type": "multijitter"},
        },
        "object": {"type": "rectangle", "to_world": transform().scale([half[0], half[1], 1]), "bsdf": load_scene(bsdf)},
        **({"lamp": lamp} if environment is None else {"environment": dict(environment)}),
    }
