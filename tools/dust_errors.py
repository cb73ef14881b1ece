"""Measure how far layers of dust are from the truth: print the tables of errors, and draw the map of them.

usage: python tools/dust_errors.py [--scattering single|multiple] [--quick] [GOLDEN [PICTURE]]
       (default: multiple, ../shared/golden/dust_layer_exact.csv, docs/pictures/dust_errors.png)

Five parts, each against another reference: rows of discrete ordinates over Lambertian bases (GOLDEN); white dust over white, which keeps all light; the photon
Monte Carlo over glossy bases (tests/photons.py), whose own standard errors are printed beside; discrete ordinates of two dusts,
one on the other; and discrete ordinates solved here over a grid of (tau, w, g), which is the map.
About three minutes.  Needs the development extras.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import discrete_ordinates
import photons
from motes import BRDF, Dust, DustLayer, Lambert, TorranceSparrow
from motes.directions import from_spherical
from motes.models import GGX

ROOT = Path(__file__).resolve().parents[1]
Floats = NDArray[np.float64]
STEEPEST = np.radians(80.0)  # beyond it BRDFs are not judged; albedos are
TAU = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)
W = (0.3, 0.6, 0.8, 0.9, 0.95, 0.99, 1.0)
G = (-0.6, 0.0, 0.3, 0.6, 0.85)
ABOUT_MIRROR = np.radians([-20.0, -10.0, -5.0, 0.0, 5.0, 10.0, 20.0])


def dusty(base: BRDF, tau: Any, w: Any, g: Any, scattering: str) -> DustLayer:
    """The model that is judged."""
    chosen = {} if scattering == "single" else {"scattering": scattering}
    return DustLayer(base, Dust(w=w, g=g), tau, **chosen)


def percent(errors: Any) -> str:
    """Median, 95th percentile and worst of relative errors."""
    size = np.abs(np.asarray(errors, float))
    return " | ".join(f"{100 * x:.2g}" for x in (np.median(size), np.quantile(size, 0.95), size.max()))


def table(title: str, header: str, rows: list[str]) -> None:
    columns = header.count("|") + 1
    print(f"\n## {title}\n\n| {header} |\n|{'---|' * columns}")
    print("\n".join(f"| {row} |" for row in rows))


# ---------------------------------------------------------------- Rows of the reference table


def golden(path: Path, scattering: str) -> None:
    """Errors over the rows, all together and by band."""
    with path.open(encoding="utf-8") as file:
        found = list(csv.DictReader(file))
    r = {name: np.array([float(row[name]) for row in found]) for name in found[0]}
    wi, wo = from_spherical(r["theta_i"], 0.0), from_spherical(r["theta_r"], r["dphi"])
    model = dusty(Lambert(r["base"][:, None]), r["tau"], r["w"][:, None], r["g"], scattering)
    of_brdf = model.eval(wi, wo)[:, 0] / r["brdf"] - 1
    of_albedo = np.array([albedo_of(r, k, scattering) for k in range(len(found))]) / r["albedo"] - 1
    seen = np.maximum(r["theta_i"], r["theta_r"]) <= STEEPEST
    rows = []
    for name, bands in {
        "": [(-np.inf, np.inf)],
        "tau": [(0, 0.1), (0.1, 1), (1, 5), (5, 100)],
        "w": [(0, 0.5), (0.5, 0.85), (0.85, 0.97), (0.97, 1.01)],
        "g": [(-1, -0.1), (-0.1, 0.1), (0.1, 0.5), (0.5, 0.7), (0.7, 1)],
        "base": [(0, 0.1), (0.1, 0.6), (0.6, 1.1)],
    }.items():
        for low, high in bands:
            chosen = np.ones(len(found), bool) if not name else (r[name] >= low) & (r[name] < high)
            if chosen.any():
                what = f"{name} {low:g} to {high:g}" if name else "all"
                counts = f"{chosen.sum()} | {(chosen & seen).sum()}"
                rows.append(f"{what} | {counts} | {percent(of_albedo[chosen])} | {percent(of_brdf[chosen & seen])}")
    table(
        f"Rows of discrete ordinates ({scattering}), errors in percent",
        "rows | for albedos | for BRDFs | albedo: median | 95 % | worst | BRDF: median | 95 % | worst",
        rows,
    )
    for what, errors, chosen in (("albedo", of_albedo, seen | True), ("BRDF", of_brdf, seen)):
        order = np.argsort(-np.where(chosen, abs(errors), 0))[:5]
        print(f"\nThe worst rows by their {what}:")
        for k in order:
            print(f"- {100 * errors[k]:+.2g} % at " + ", ".join(f"{name} = {r[name][k]:.3g}" for name in list(r)[:9]))


def albedo_of(r: dict[str, Floats], k: int, scattering: str) -> float:
    model = dusty(Lambert(r["base"][k]), r["tau"][k], r["w"][k], r["g"][k], scattering)
    return float(model.directional_albedo(from_spherical(r["theta_i"][k], 0.0))[0])


# ---------------------------------------------------------------- The white furnace


def furnace(scattering: str) -> None:
    """What white dust over white gains or loses, at worst over tau, by g and angle, in percent."""
    angles, rows = np.radians([0.0, 30.0, 60.0, 75.0, 84.0, 88.0, 89.4]), []
    for g in (*G, 0.9):
        found = [given_back(dusty(Lambert(1.0), tau, 1.0, g, scattering), angles) for tau in TAU]
        worst = np.abs(np.array(found) - 1).max(axis=0)
        rows.append(f"{g:g} | " + " | ".join(f"{100 * x:.2g}" for x in worst))
    header = "g | " + " | ".join(f"{np.degrees(angle):.3g}°" for angle in angles)
    table(f"White dust over white ({scattering}): light gained or lost, the worst over tau, in percent", header, rows)


def given_back(model: BRDF, theta_i: Floats, count: int = 48) -> Floats:
    """The directional albedo of a smooth BRDF of one channel: towards the horizon nodes are closer than those of the model's own quadrature."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    root, azimuth = 0.5 * (nodes + 1), (np.arange(3 * count) + 0.5) * np.pi / (3 * count)
    theta_r, dphi = np.meshgrid(np.arccos(root**2), azimuth, indexing="ij")
    value = model.eval(from_spherical(theta_i[:, None, None], 0.0), from_spherical(theta_r, dphi))[..., 0]
    found: Floats = value.mean(axis=-1) @ (2 * np.pi * weights * root**3)  # of cos dcos
    return found


# ---------------------------------------------------------------- The map


def errors_at(tau: float, w: float, g: float, scattering: str) -> tuple[float, float]:
    """The worst relative error of the albedo and the median one of the BRDF, over black and bright bases and three incidences."""
    of_albedo, of_brdf = [], []
    azimuths = np.radians([0.0, 60.0, 120.0, 180.0])
    for base in (Lambert(0.0), Lambert(0.8)):
        model = dusty(base, tau, w, g, scattering)
        for theta_i in np.radians([20.0, 50.0, 75.0]):
            truth = discrete_ordinates.layer(base, tau, w, g, theta_i, 48 if abs(g) > 0.7 else 24)
            wi = from_spherical(theta_i, 0.0)
            seen = truth.cosines >= np.cos(STEEPEST)
            wo = from_spherical(np.arccos(truth.cosines[seen])[:, None], azimuths)
            of_albedo.append(float(model.directional_albedo(wi)[0]) / truth.albedo - 1)
            of_brdf.append(model.eval(wi, wo)[..., 0] / truth.brdf(azimuths)[seen] - 1)
    return float(np.abs(of_albedo).max()), float(np.median(np.abs(np.concatenate(of_brdf))))


def error_map(path: Path, scattering: str, quick: bool) -> None:
    taus, ws = (TAU[::3], W[::3]) if quick else (TAU, W)
    figure = Figure(figsize=(2.5 * len(G) + 1, 5.2), dpi=110)
    grid = figure.subplots(2, len(G), squeeze=False)
    grids = np.array([[[errors_at(tau, w, g, scattering) for tau in taus] for w in ws] for g in G])
    names = ("albedo, the worst", "BRDF, the median")
    for line, name, values in zip(grid, names, np.moveaxis(grids, -1, 0), strict=True):
        for axes, g, cells in zip(line, G, values, strict=True):
            axes.imshow(
                np.log10(np.maximum(cells, 1e-6)), vmin=-4, vmax=0, cmap="viridis", origin="lower", aspect="auto"
            )
            for (row, column), value in np.ndenumerate(cells):
                tone = "white" if value < 0.03 else "black"
                axes.text(column, row, f"{100 * value:.2g}", ha="center", va="center", fontsize=6, color=tone)
            axes.set_title(f"{name}: g = {g:g}", fontsize=8)
            axes.set_xticks(range(len(taus)), [f"{t:g}" for t in taus], fontsize=6)
            axes.set_yticks(range(len(ws)), [f"{w:g}" for w in ws], fontsize=6)
            axes.set_xlabel("tau", fontsize=7)
    for line in grid:
        line[0].set_ylabel("w", fontsize=7)
    figure.tight_layout()
    figure.savefig(path, metadata={"Software": None})
    print(
        f"\n{path}: errors in percent over black and bright bases, incidence of 20, 50 and 75 degrees, viewers up to 80 degrees"
    )
    rows = [f"{g:g} | {percent(grids[k, ..., 0])} | {percent(grids[k, ..., 1])}" for k, g in enumerate(G)]
    table("The map, by g, errors in percent", "g | albedo: median | 95 % | worst | BRDF: median | 95 % | worst", rows)


# ---------------------------------------------------------------- Glossy bases


#: Dark bodies with highlights, of which half the light is mirrored.
GLOSSY: dict[str, Callable[[float], BRDF]] = {
    "Torrance-Sparrow": lambda alpha: (
        Lambert(0.1)
        + TorranceSparrow(K_s=0.5, sigma_s=alpha, normalization="facets")  # sigma_s is alpha for small slopes
    ),
    "GGX": lambda alpha: Lambert(0.1) + GGX(K_s=0.5, alpha=alpha),
}


def glossy_row(name: str, alpha: float, g: float, tau: float, scattering: str, count: int) -> str:
    """Errors within 20 degrees of the mirror direction, at incidences of 25 and 55 degrees, and of the albedos there."""
    layer = photons.Layer(GLOSSY[name](alpha), tau, 0.9, g)
    model = dusty(layer.base, tau, 0.9, g, scattering)
    errors, noise, albedos = [], [], []
    for theta_i in np.radians([25.0, 55.0]):
        wi = from_spherical(theta_i, 0.0)
        inside = from_spherical(theta_i + ABOUT_MIRROR, np.pi)
        beside = from_spherical(theta_i, np.pi + ABOUT_MIRROR[:3])
        wo = np.concatenate([inside, beside])
        seen, albedo = photons.both(layer, wi, wo, count)
        errors += list(model.eval(wi, wo)[:, 0] / seen.value - 1)
        noise += list(seen.error / seen.value)
        albedos.append((float(model.directional_albedo(wi)[0] / albedo.value - 1), float(albedo.error / albedo.value)))
    size, (worst, error) = np.abs(errors), max(albedos, key=lambda pair: abs(pair[0]))
    return (
        f"{name} | {alpha:g} | {g:g} | {tau:g} | {100 * np.median(size):.2g} | {100 * size.max():.2g} | {100 * max(noise):.1g} | "
        f"{100 * worst:+.2g} | {100 * error:.1g}"
    )


def glossy_table(scattering: str, count: int) -> None:
    cases = product(GLOSSY, (0.1, 0.3), (0.0, 0.6, 0.85), (0.1, 0.5, 1.0))
    table(
        f"Over glossy bases ({scattering}), w = 0.9, errors in percent within 20 degrees of the mirror direction",
        "base | alpha | g | tau | BRDF: median | worst | standard error of the reference | albedo: worst | standard error",
        [glossy_row(*case, scattering, count) for case in cases],
    )


# ---------------------------------------------------------------- Dust over dust

#: tau, w, g of what lies above, and of what lies below.
UPPER = ((0.1, 0.5, 0.3), (0.1, 0.97, 0.6), (0.5, 0.5, 0.6), (0.5, 0.97, 0.3), (2.0, 0.8, 0.6), (0.5, 0.9, -0.4))
LOWER = ((0.2, 0.97, 0.6), (1.0, 0.99, 0.5), (1.0, 0.5, 0.6), (5.0, 0.99, 0.0), (30.0, 0.999, 0.6), (0.3, 0.9, 0.85))


def stacks_table(scattering: str) -> None:
    """Errors of two layers over black, grey and bright bases, at three incidences and for viewers up to 80 degrees, by what lies below."""
    azimuths, rows, every = np.radians([0.0, 60.0, 120.0, 180.0]), [], []
    for lower in LOWER:
        off: list[tuple[float, float, float]] = []
        for upper, K_d, theta_i in product(UPPER, (0.0, 0.3, 0.8), np.radians([20.0, 50.0, 75.0])):
            truth = discrete_ordinates.layers(Lambert(K_d), [upper, lower], theta_i, 32)
            model = dusty(dusty(Lambert(K_d), *lower, scattering), *upper, scattering)
            seen = truth.cosines >= np.cos(STEEPEST)
            wi, wo = (
                from_spherical(theta_i, 0.0),
                from_spherical(np.arccos(truth.cosines[seen])[:, None], azimuths),
            )
            brdf = np.abs(model.eval(wi, wo)[..., 0] / truth.brdf(azimuths)[seen] - 1)
            albedo = float(model.directional_albedo(wi, nodes=(24, 32))[0]) / truth.albedo - 1
            off.append((albedo, float(np.median(brdf)), float(brdf.max())))
        every += off
        rows.append(
            f"{', '.join(f'{x:g}' for x in lower)} | " + " | ".join(percent(part) for part in zip(*off, strict=True))
        )
    rows.append("all | " + " | ".join(percent(part) for part in zip(*every, strict=True)))
    table(
        f"Dust over dust ({scattering}), errors in percent",
        "tau, w, g below | albedo: median | 95 % | worst | median BRDF of a case: median | 95 % | worst | worst BRDF of a case: median | 95 % | worst",
        rows,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("golden", nargs="?", type=Path, default=ROOT.parent / "shared/golden/dust_layer_exact.csv")
    parser.add_argument("picture", nargs="?", type=Path, default=ROOT / "docs/pictures/dust_errors.png")
    parser.add_argument("--scattering", choices=("single", "multiple"), default="multiple")
    parser.add_argument("--quick", action="store_true", help="a coarse map, and few photons")
    chosen = parser.parse_args()
    if chosen.golden.exists():
        golden(chosen.golden, chosen.scattering)
    else:
        print(f"{chosen.golden} is missing: its rows are left out")
    furnace(chosen.scattering)
    glossy_table(chosen.scattering, 2**11 if chosen.quick else 2**16)
    stacks_table(chosen.scattering)
    error_map(chosen.picture, chosen.scattering, chosen.quick)


if __name__ == "__main__":
    main()
