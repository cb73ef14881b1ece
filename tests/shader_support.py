"""Directions and models on which printed shaders are compared with NumPy, and the comparison."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from motes.arrays import NUMPY
from motes.directions import Geometry, Vector
from motes.models import (
    BRDF,
    EON,
    GGX,
    GTR,
    Beckmann,
    CoatedDiffuse,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Hapke,
    Lambert,
    OrenNayar,
    Retro,
    Schlick,
    Sheen,
    TorranceSparrow,
)

COUNT = 4096
# Errors are relative to the value or, where that is smaller, to a floor [1/sr]: a third of white paper, and a thirtieth.  In float32 the tail
# exp(-t^2) of a highlight is good to t^2 times the precision of its argument, so that a low floor sees larger errors.
FLOOR, LOW_FLOOR = 0.1, 0.01
TOLERANCE, LOW_TOLERANCE = 2e-6, 4e-6
# A normalised narrow highlight is 1/(pi sigma_s^2) = 32 times as high, and so are the parts of its tail that count.
STEEP = frozenset({"facets_narrow_schlick"})
PLASTER = OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4)
COAT = TorranceSparrow(K_s=0.3, sigma_s=0.15)
MODELS: dict[str, BRDF] = {
    "lambert": Lambert(K_d=(0.8, 0.5, 0.2)),
    "oren_nayar": PLASTER,
    "oren_nayar_rough": OrenNayar(K_d=(1.0, 0.5, 0.25), sigma_d=1.2),
    "eon": EON(rho=(1.0, 0.5, 0.25), r=0.9),
    "torrance_sparrow": COAT,
    "facets_wide_dielectric": TorranceSparrow(1.0, 0.6, "facets", Dielectric((1.33, 1.5, 1.9))),
    "facets_narrow_schlick": TorranceSparrow((1.0, 0.9, 0.8), 0.1, "facets", Schlick(0.05)),
    "conductor": TorranceSparrow(0.9, 0.2, "facets", Conductor((0.14, 0.37, 1.4), (4.0, 2.4, 1.9))),
    "ggx": GGX((1.0, 0.5, 0.25), 0.4, Schlick((0.04, 0.3, 0.9))),
    "compensated": GGX(0.7, 0.6, Conductor((0.14, 0.37, 1.4), (4.0, 2.4, 1.9)), "multiple")
    + Beckmann((0.3, 0.2, 0.1), 0.7, Schlick((0.4, 0.8, 0.9)), "multiple"),
    "gtr": GTR((0.8, 0.5, 0.25), 0.3, 1.5),
    "beckmann": Beckmann(0.8, 0.5, Dielectric((1.33, 1.5, 1.9))),
    "two_normalised": TorranceSparrow((0.6, 0.5, 0.4), 0.3, "facets") + TorranceSparrow(0.2, 0.5, "facets"),
    "coated_diffuse": CoatedDiffuse((0.9, 0.5, 0.2), 1.5),
    "hapke": Hapke((0.95, 0.5, 0.2), -0.3, 0.6, 0.1),
    "retro": Retro((0.8, 0.5, 0.25), 0.3),
    "sheen": Sheen((0.8, 0.5, 0.25), 0.4),
    "dust_forward": Dust((0.7, 0.6, 0.5), 0.6),
    "dust_backward": Dust((0.7, 0.6, 0.5), -0.4),
    "dust_brightness": Dust((0.7, 0.6, 0.5), 0.3, form="brightness"),
    "plaster_and_coat": PLASTER + COAT,
    "dusty": DustLayer(PLASTER + COAT, Dust((0.7, 0.6, 0.5), 0.3), tau=0.2),
    "dusty_thin": DustLayer(PLASTER + COAT, Dust((0.7, 0.6, 0.5), 0.3), tau=1e-4),
    "grey": OrenNayar(0.5, 0.3) + COAT,
    "two_coats_under_dust": DustLayer(
        Lambert((0.1, 0.2, 0.3)) + (PLASTER.with_parameters({"K_d": 0.4}) + COAT) + Lambert(0.05),
        Dust(0.5, -0.2),
        tau=0.7,
    )
    + TorranceSparrow(0.2, 0.08, fresnel=Dielectric(1.4)),
}
SPECTRAL = OrenNayar(np.linspace(0.2, 0.8, 7), 0.2) + TorranceSparrow(np.linspace(0.3, 0.1, 7), 0.2)


def directions(count: int = COUNT, seed: int = 1) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """``wi, wo`` (count, 3): uniform, grazing, near the mirror direction, in the plane of incidence with opposed azimuths, below the horizon."""
    rng = np.random.default_rng(seed)
    theta = np.arccos(rng.uniform(0, 1, (2, count)))
    phi = rng.uniform(-np.pi, np.pi, (2, count))
    part = np.array_split(np.arange(count), 8)
    theta[:, part[1]] = np.pi / 2 - 10 ** rng.uniform(-4, -1, (2, len(part[1])))  # both graze
    phi[1, part[1][::2]] = phi[0, part[1][::2]] + np.pi  # ... opposed
    theta[1, part[2]] = np.abs(
        theta[0, part[2]] + 0.05 * rng.standard_normal(len(part[2]))
    )  # about the mirror direction
    phi[1, part[2]] = phi[0, part[2]] + np.pi + 0.05 * rng.standard_normal(len(part[2]))
    phi[1, part[3]] = phi[0, part[3]] + np.pi  # exactly opposed azimuths
    phi[1, part[4]] = phi[0, part[4]] + np.pi / 2 * rng.choice([-1, 1], len(part[4]))  # cos(dphi) about 0
    theta[0, part[5]] = np.pi / 2 - 10 ** rng.uniform(-4, -1, len(part[5]))  # one grazes
    theta[0, part[6]] *= 1e-3  # normal incidence
    theta[1, part[7]] = rng.uniform(0, np.pi, len(part[7]))  # half of them below
    w = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1).astype(np.float32)
    w[:, 0] = (0, 0, 1)
    return w[0], w[1]


def expected(model: BRDF, wi: NDArray[np.float32], wo: NDArray[np.float32]) -> NDArray[np.float64]:
    """NumPy's values in float64 at the directions as the shader gets them; three channels where there is one."""
    wi, wo = np.float64(wi), np.float64(wo)
    with np.errstate(all="ignore"):
        value = model.value(NUMPY, Geometry(NUMPY, Vector.of(wi), Vector.of(wo)))
    return np.broadcast_to(value, (len(wi), max(3, model.channels)))


def error(result: NDArray[np.floating], reference: NDArray[np.float64], floor: float = FLOOR) -> float:
    """The largest error relative to the value, or to `floor` where that is larger."""
    assert result.shape == reference.shape
    return float(np.max(np.abs(result - reference) / np.maximum(np.abs(reference), floor)))


def check(name: str, result: NDArray[np.floating], reference: NDArray[np.float64]) -> None:
    """Within the tolerance of float32, and exactly 0 below the horizon."""
    assert error(result, reference) <= (LOW_TOLERANCE if name in STEEP else TOLERANCE)
    assert error(result, reference, LOW_FLOOR) <= LOW_TOLERANCE
    below = (reference == 0).all(axis=1)
    assert 100 < below.sum() < len(below) / 4
    assert not result[below].any()
