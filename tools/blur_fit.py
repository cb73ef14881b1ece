"""Fit the numbers of `motes.models.bending` to photons, and print them.

usage: python tools/blur_fit.py [STEPS] [PHOTONS]        (default: 12 steps, 32768 photons for each direction; about ten minutes)

What each number is, by its name: ``width`` and ``bend`` scale the widths of the highlight and of the phase function in the lobe k, ``narrower`` is how
fast the second falls with the first; ``own`` is where half of the light keeps the highlight's own shape; ``far`` (with (1 - g)^2: ``far_2``) is
what the phase function's tail takes; ``once...`` and ``horizon`` split what arrives diffusely into light scattered once and more often, of
which ``bent, level, deep`` say what is still bent and not yet diffuse; ``height`` and ``steep`` are the height of that light's lobe; ``lost`` is
what a wide lobe loses on its way out.

The cases are highlights of GGX and Torrance-Sparrow on a dark body; of each the BRDF about the mirror direction, and the albedo, which counts five
times; and white dust over facets that lose nothing but what they send to each other.  Starts from the numbers that are there.
"""

from __future__ import annotations

import sys
from itertools import product
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import photons
from motes import BRDF, Dust, DustLayer, Lambert, TorranceSparrow
from motes.directions import from_spherical
from motes.models import GGX, bending

Floats = NDArray[np.float64]
ABOUT_MIRROR = np.radians([-20.0, -10.0, -5.0, 0.0, 5.0, 10.0, 20.0])
MOST = 2.0  # an error that counts no more


class Case(NamedTuple):
    model: DustLayer
    wi: Floats
    wo: Floats
    brdf: Floats
    noise: Floats
    albedo: float


def cases(count: int) -> list[Case]:
    """What photons say."""
    found = []
    kinds = (
        *product((0.05, 0.1, 0.2, 0.3), (0.9,), (0.3, 0.6, 0.75, 0.85), (0.1, 0.5, 1.0), (25.0, 55.0)),
        *product((0.1, 0.3), (0.7, 1.0), (0.0, 0.6, 0.85), (0.3, 1.5), (8.0, 65.0)),
    )
    for number, (alpha, w, g, tau, degrees) in enumerate(kinds):
        glossy = GGX(0.5, alpha) if number % 4 < 2 else TorranceSparrow(0.5, alpha, "facets")
        base: BRDF = Lambert(0.1) + glossy
        theta = np.radians(degrees)
        wi = from_spherical(theta, 0.0)
        wo = np.concatenate(
            [from_spherical(theta + ABOUT_MIRROR, np.pi), from_spherical(theta, np.pi + ABOUT_MIRROR[:3])]
        )
        seen, albedo = photons.both(photons.Layer(base, tau, w, g), wi, wo, count)
        model = DustLayer(base, Dust(w, g), tau, "multiple")
        found.append(Case(model, wi, wo, seen.value, seen.error / seen.value, float(albedo.value)))
    return found


def errors(found: list[Case]) -> Floats:
    """Relative errors, of albedos times five."""
    off: list[float] = []
    for case in found:
        value = case.model.eval(case.wi, case.wo)[:, 0]
        off += list((value / case.brdf - 1) / np.hypot(1, case.noise / 0.02))
        off.append(5 * (float(case.model.directional_albedo(case.wi, nodes=(16, 24))[0]) / case.albedo - 1))
    for tau, g, theta in product((0.3, 1.0), (0.3, 0.6, 0.85), (0.1, 0.9)):
        model = DustLayer(GGX(1.0, 0.1), Dust(1.0, g), tau, "multiple")
        gained = float(model.directional_albedo(from_spherical(theta, 0.0), nodes=(16, 24))[0]) - 1
        off.append(5 * max(gained, 0.0))
    return np.array(off)


def report(found: list[Case]) -> str:
    off = errors(found)
    rows = off[: 11 * len(found)].reshape(len(found), 11)
    brdf, albedo = np.abs(rows[:, :10]), np.abs(rows[:, 10]) / 5
    inner = brdf[:, [1, 2, 3, 4, 5, 8, 9]]
    return (
        f"BRDF within 10 degrees {100 * inner.max():.2g} %, within 20 {100 * brdf.max():.2g} % (95 % of them {100 * np.quantile(brdf, 0.95):.2g} %); "
        f"albedo {100 * albedo.max():.2g} % (95 %: {100 * np.quantile(albedo, 0.95):.2g} %); white facets {20 * off[11 * len(found) :].max():.2g} %"
    )


def main() -> None:
    steps, count = (int(x) for x in (sys.argv[1:] + ["12", "32768"][len(sys.argv) - 1 :])[:2])
    found = cases(count)
    names = list(bending.FITTED)
    start = np.array([bending.FITTED[name] for name in names])
    print(report(found))

    def loss(x: Floats) -> Floats:
        bending.FITTED.update(zip(names, x.tolist(), strict=True))
        off = np.clip(errors(found), -MOST, MOST)
        return np.asarray(off * np.sqrt(np.abs(off) + 0.02))  # large errors count more than their squares

    best = least_squares(loss, start, x_scale=np.maximum(np.abs(start), 0.2), max_nfev=steps)
    bending.FITTED.update(zip(names, np.round(best.x, 3).tolist(), strict=True))
    print(report(found))
    print(bending.FITTED)


if __name__ == "__main__":
    main()
