"""A plaster that dries while dust settles on it: the time-varying material of the demonstration.

It has the shape of what "Time-Varying BRDFs" (TVCG 2007) is about, in the models of its appendices: a wet surface is
dark and shows a highlight; as it dries the highlight decays exponentially and the diffuse reflectance climbs to its dry
value along a logistic curve; dust gathers in proportion to time.  The numbers are chosen, not measured.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from motes.models import BRDF, parse
from motes.trends import Trend

MODEL = "dust_layer(oren_nayar + torrance_sparrow)"
K_D_WET, K_D_DRY = np.array([0.34, 0.29, 0.23]), np.array([0.74, 0.69, 0.61])

#: Parameter -> its value as a function of the time [h] since the plaster was laid.
TRENDS: dict[str, Callable[[float], Any]] = {
    "K_d": lambda hours: K_D_WET + (K_D_DRY - K_D_WET) / (1 + np.exp(-(hours - 2.0) / 0.4)),
    "sigma_d": lambda hours: 0.35,
    "K_s": lambda hours: 0.6 * np.exp(-hours / 1.0),
    "sigma_s": lambda hours: 0.16,
    "w": lambda hours: np.array([0.85, 0.78, 0.66]),
    "g": lambda hours: -0.2,
    "tau": lambda hours: 0.05 + 0.06 * hours,
}


def trends(last: float) -> dict[str, Trend]:
    """The same as trends that a fit can find, from 0 h to `last`."""
    interval = (0.0, last)
    start = {name: trend(0.0) for name, trend in TRENDS.items()}
    K_d = {"start": K_D_WET, "end": K_D_DRY, "middle": 2.0, "width": 0.4}
    return {
        **{name: Trend("constant", {"value": value}, interval) for name, value in start.items()},
        "K_d": Trend("logistic", K_d, interval),
        "K_s": Trend("exponential", {"start": start["K_s"], "end": 0.0, "time_constant": 1.0}, interval),
        "tau": Trend("linear", {"start": start["tau"], "end": TRENDS["tau"](last)}, interval),
    }


def drying_plaster(hours: float, scattering: str = "single") -> BRDF:
    """The plaster, three channels (R, G, B), at a time [h] >= 0 after it was laid.

    In its dust light is scattered once, as in the source, or as often as it is (``scattering="multiple"``).

    Examples
    --------
    >>> wet, dry = drying_plaster(0.0).parameters, drying_plaster(6.0).parameters
    >>> round(wet["K_s"], 3), round(dry["K_s"], 3)
    (0.6, 0.001)
    """
    values = {name: trend(hours) for name, trend in TRENDS.items()}
    return replace(parse(MODEL).model, scattering=scattering).with_parameters(values)  # type: ignore[call-arg]
