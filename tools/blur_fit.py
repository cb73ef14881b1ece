"""Fit the numbers of `motes.models.bending` to photons, and print them.

usage: python tools/blur_fit.py [STEPS] [PHOTONS]        (default: 40 steps, 131072 photons for each direction; about five minutes)

What each number is, by its name: ``width`` and ``bend`` scale the widths of the highlight and of the phase function in the lobe k, ``narrower`` is how
fast the second falls with the first; ``own`` is where half of the light keeps the highlight's own shape; ``..._again`` is the same for light that was
scattered more often; ``far`` (with (1 - g)^2: ``far_2``) is what the phase function's tail takes; ``once...`` and ``horizon`` split what arrives
diffusely into light scattered once and more often, of which ``bent, level, deep`` say what is still bent and not yet diffuse; ``height`` and ``steep``
are the height of that light's lobe, and ``uneven`` bounds it where one of the directions grazes; ``lost`` is what a wide lobe loses on its way out.

The cases are highlights of GGX and Torrance-Sparrow on a dark body, of which the BRDF about the mirror direction and the albedo count, and white dust over
white facets, of which the albedo counts a little, more where light is gained.  What docs/dust.md has a table of counts most.  Errors enter by their cubes: the
worst matter.  Starts from the numbers that are there.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import photons
from motes import BRDF, Dust, DustLayer, Lambert, TorranceSparrow
from motes.arrays import NUMPY
from motes.directions import Geometry, Vector, from_spherical
from motes.models import GGX, bending
from motes.models.lifting import lifted

Floats = NDArray[np.float64]
ABOUT_MIRROR = np.radians([-20.0, -10.0, -5.0, 0.0, 5.0, 10.0, 20.0])
FACETS: tuple[Callable[[Floats, Floats], BRDF], ...] = (GGX, lambda K_s, alpha: TorranceSparrow(K_s, alpha, "facets"))
#: What counts as one: an error of a BRDF, of an albedo, and of a white one that is too large or too small.
BRDF_OFF, ALBEDO_OFF, GAINED, LOST = 0.1, 0.013, 0.16, 0.4
OTHERS = 0.3  # what a case counts that docs/dust.md does not list
MOST = 8.0  # an error that counts no more
SEED = 11  # other photons than those of tests and tables
COARSE, FINE = (12, 16), (40, 48)  # nodes for albedos: at each step, and once for how far the first are off


class Case(NamedTuple):
    alpha: float
    w: float
    g: float
    tau: float
    degrees: float

    @property
    def listed(self) -> bool:
        return self.w == 0.9 and self.alpha in (0.1, 0.3) and self.g in (0.0, 0.6, 0.85)


LISTED = (
    *product((0.05, 0.1, 0.2, 0.3), (0.9,), (0.0, 0.3, 0.6, 0.75, 0.85), (0.1, 0.5, 1.0), (25.0, 55.0)),
    *product((0.1, 0.3), (0.7, 1.0), (0.0, 0.6, 0.85), (0.3, 1.5), (8.0, 65.0)),
)
WHITE = tuple(product((0.1, 0.3), (1.0,), (0.0, 0.3, 0.6, 0.85), (0.1, 0.5, 2.0), (25.0, 55.0, 75.0, 85.0, 89.0)))


class Batch:
    """All cases over one kind of facets, and what photons say of them.

    Parameters
    ----------
    facets
        Makes a highlight of a strength and a roughness.
    cases
        What lies on it, and from where light comes.
    white
        Facets that reflect all and nothing below them, of which the albedo is judged alone; else half, over a dark body.
    """

    def __init__(self, facets: Callable[..., BRDF], cases: list[Case], white: bool, count: int) -> None:
        def base(strength: Floats | float, alpha: Floats | float) -> BRDF:
            return facets(strength, alpha) if white else Lambert(0.1) + facets(0.5, alpha)

        self.cases, self.white = cases, white
        # Parameters (N, 1) against directions (N, K), w with an axis for channels.
        alpha, w, g, tau = (np.array([getattr(case, name) for case in cases])[:, None] for name in Case._fields[:4])
        self.model = DustLayer(base(1.0, alpha), Dust(w[..., None], g), tau, "multiple")
        theta = np.radians([case.degrees for case in cases])[:, None]
        self.wi = from_spherical(theta, 0 * theta)
        inside = from_spherical(theta + ABOUT_MIRROR, np.pi)
        beside = from_spherical(theta, np.pi + ABOUT_MIRROR[:3])
        self.wo = np.concatenate([inside, beside], axis=1)[:, : 0 if white else None]
        found = [
            photons.both(photons.Layer(base(1.0, case.alpha), case.tau, case.w, case.g), i[0], o, count, seed=SEED)
            for case, i, o in zip(cases, self.wi, self.wo, strict=True)
        ]
        self.brdf = np.array([seen.value for seen, _ in found])
        self.noise = np.array([seen.error / seen.value for seen, _ in found])
        self.albedo = np.array([float(albedo.value) for _, albedo in found])
        self.counts = np.array([1.0 if case.listed else OTHERS for case in cases])
        self.correction = self._albedo(FINE) - self._albedo(COARSE)

    def errors(self) -> tuple[Floats, Floats]:
        """Relative errors of BRDFs (N, K) and of albedos (N,)."""
        # Not `eval`, which records a formula once: these numbers change.
        wi = np.broadcast_to(self.wi, self.wo.shape)
        with np.errstate(all="ignore"):
            geometry = Geometry(NUMPY, Vector.of(wi), Vector.of(self.wo))
            value = lifted(self.model, NUMPY, wi).value(NUMPY, geometry)[..., 0]
        return value / self.brdf - 1, (self._albedo(COARSE) + self.correction) / self.albedo - 1

    def losses(self) -> Floats:
        """All errors by what counts as one."""
        brdf, albedo = self.errors()
        if self.white:
            return albedo / np.where(albedo > 0, GAINED, LOST)
        brdf = brdf / np.hypot(1, self.noise / 0.02) * (self.counts[:, None] / BRDF_OFF)
        return np.concatenate([brdf.ravel(), albedo * (self.counts / ALBEDO_OFF)])

    def _albedo(self, nodes: tuple[int, int]) -> Floats:
        return np.asarray(self.model.directional_albedo(self.wi, nodes=nodes))[:, 0, 0]


def report(batches: list[Batch]) -> str:
    found = [(batch, *batch.errors()) for batch in batches]
    lines = []
    for what in ("listed", "all"):
        chosen = [
            (np.abs(brdf[keep]), np.abs(albedo[keep]))
            for batch, brdf, albedo in found
            if not batch.white
            for keep in [[what == "all" or case.listed for case in batch.cases]]
        ]
        brdf, albedo = (np.concatenate(parts) for parts in zip(*chosen, strict=True))
        inner = brdf[:, [1, 2, 3, 4, 5, 8, 9]]
        lines.append(
            f"{what}: BRDF within 10 degrees {100 * inner.max():.2g} %, within 20 {100 * brdf.max():.2g} % "
            f"(95 %: {100 * np.quantile(brdf, 0.95):.2g} %); albedo {100 * albedo.max():.2g} % (95 %: {100 * np.quantile(albedo, 0.95):.2g} %), "
            f"beyond 2 %: {(albedo > 0.02).sum()} of {len(albedo)}"
        )
    for degrees in (25.0, 55.0, 75.0, 85.0, 89.0):
        off = [
            albedo[k]
            for batch, _, albedo in found
            if batch.white
            for k, case in enumerate(batch.cases)
            if case.degrees == degrees
        ]
        lines.append(f"white, at {degrees:g} degrees: {100 * min(off):+.2g} to {100 * max(off):+.2g} %")
    return "\n".join(lines)


def main() -> None:
    steps, count = (int(x) for x in (sys.argv[1:] + ["40", "131072"][len(sys.argv) - 1 :])[:2])
    batches = [
        Batch(facets, [Case(*case) for case in cases], white, count)
        for facets in FACETS
        for cases, white in ((LISTED, False), (WHITE, True))
    ]
    names = list(bending.FITTED)
    start = np.array([bending.FITTED[name] for name in names])
    print(report(batches), flush=True)

    def loss(x: Floats) -> Floats:
        bending.FITTED.update(zip(names, x.tolist(), strict=True))
        off = np.clip(np.concatenate([batch.losses() for batch in batches]), -MOST, MOST)
        return np.asarray(off * np.sqrt(np.abs(off)))

    best = least_squares(loss, start, x_scale=np.maximum(np.abs(start), 0.2), max_nfev=steps)
    bending.FITTED.update(zip(names, np.round(best.x, 3).tolist(), strict=True))
    print(report(batches))
    print(bending.FITTED)


if __name__ == "__main__":
    main()
