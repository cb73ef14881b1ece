"""Fits of MERL materials that others have published, for the page of results: Löw's and Ngan's, beside fits of our own.

The files hold a line a material, `name = Aggregate(Lambertian(albedo = [r, g, b]), Model(...))`, with Lambert's albedo over pi.  Their authors' conventions:

- Ngan, Durand and Matusik (EGSR 2005), Cook-Torrance: albedo D G F / (pi cos_i cos_r), D Beckmann's normalised distribution, F Schlick's with
  `eta` the reflectance at 0; the whole times (1, 1.15, 1.66), the factors of MERL's channels, which were left out of the fits;
- Löw, Kronander, Ynnerman and Unger (TOG 2012), microfacet, fitted in the loss E2: A D G F / (pi cos_i cos_r), D = (1 + B (1 - cos theta_h))^-C, F that of
  a dielectric of refractive index `eta`.

G is that of V-grooves in both.
"""

from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from processes import spread

import motes

Floats = NDArray[np.float64]
# Bins of a MERL material that stand for all where many models are fitted.
PART = 30_000
CHANNELS = np.array([1.0, 1.15, 1.66])
#: The published fits that are compared: what they are called, their file, and how it is evaluated.
PUBLISHED: dict[str, tuple[str, Callable[[dict[str, Floats], Floats, Floats], Floats]]] = {}


def parameters(path: Path, material: str) -> dict[str, Floats]:
    """The numbers of a material in a file of fits; Lambert's albedo as ``diffuse``.

    Raises
    ------
    LookupError
        Where the file has no such material.
    """
    for line in path.read_text().splitlines():
        name, _, rest = line.partition(" = ")
        if name.strip() == material:
            found = re.findall(r"(\w+) = (\[[^\]]*\]|[-+.\deE]+)", rest)
            numbers = [(key, np.array([float(x) for x in value.strip("[]").split(",")])) for key, value in found]
            return {"diffuse": numbers[0][1], **dict(numbers[1:])}
    raise LookupError(f"{path.name} has no fit of {material}")


def evaluate(folder: Path, fit: str, material: str, wi: Floats, wo: Floats) -> Floats:
    """A published fit (N, 3) [1/sr] at pairs of directions (N, 3); NaN where there is none."""
    file, function = PUBLISHED[fit]
    try:
        return function(parameters(folder / file, material), wi, wo)
    except LookupError:
        return np.full(wi.shape, np.nan)


def _ngan(p: dict[str, Floats], wi: Floats, wo: Floats) -> Floats:
    cos_h, cos_d, grooves = _facets(wi, wo)
    width = p["roughness"] ** 2
    spread = np.exp((1 - 1 / cos_h**2) / width) / (np.pi * width * cos_h**4)
    fresnel = p["eta"] + (1 - p["eta"]) * (1 - cos_d) ** 5
    return np.asarray(CHANNELS * (p["diffuse"] / np.pi + p["albedo"] * _over(spread * fresnel * grooves, wi, wo)))


def _low(p: dict[str, Floats], wi: Floats, wo: Floats) -> Floats:
    cos_h, cos_d, grooves = _facets(wi, wo)
    spread = (1 + p["B"] * (1 - cos_h)) ** -p["C"]
    root = np.sqrt(np.maximum(p["eta"] ** 2 + cos_d**2 - 1, 0))
    first = ((root - cos_d) / (root + cos_d)) ** 2
    second = ((cos_d * (root + cos_d) - 1) / (cos_d * (root - cos_d) + 1)) ** 2
    return np.asarray(p["diffuse"] / np.pi + p["A"] * _over(spread * 0.5 * first * (1 + second) * grooves, wi, wo))


def _facets(wi: Floats, wo: Floats) -> tuple[Floats, Floats, Floats]:
    """cos theta_h, cos theta_d and the shadowing of V-grooves (N, 1)."""
    half = wi + wo
    half = half / np.linalg.norm(half, axis=-1, keepdims=True)
    cos_h, cos_d = half[:, 2:3], np.sum(wi * half, axis=-1, keepdims=True)
    return cos_h, cos_d, np.minimum(1, 2 * cos_h * np.minimum(wi[:, 2:3], wo[:, 2:3]) / cos_d)


def _over(x: Floats, wi: Floats, wo: Floats) -> Floats:
    return x / (np.pi * wi[:, 2:3] * wo[:, 2:3])


PUBLISHED["Ngan, Cook-Torrance"] = ("ngan_cooktorrance.fit", _ngan)
PUBLISHED["Löw, microfacet"] = ("low_lowmicrofacet_E2.fit", _low)


def log_distance(values: Floats, data: motes.Measurement) -> float:
    """The RMS of the residual of the loss `log`, weighted as the measurement weighs."""
    mask, measured = data.mask[0], np.where(data.mask[0], data.values[0], 0.0)
    weights = np.reshape(data.weights, (len(measured), -1)) * mask
    off = np.log1p(values * data.wi[:, 2:]) - np.log1p(measured * data.wi[:, 2:])
    return float(np.sqrt(np.sum(weights * off**2) / np.sum(weights)))


def compared(data: Path, folder: Path, ours: dict[str, str], name: str) -> Floats:
    """How far published fits of a material are from its reconstruction, and then fits of our own models."""
    measurement = merl_material(data, folder, name)
    given = {"loss": "log", "max_theta": np.radians(80), "per_channel": ["K_s"], "errors": "independent"}
    fits = [motes.fit(measurement, model, **given) for model in ours.values()]
    used = fits[0].measurement
    others = [evaluate(data / "merl-fits", fit, name, used.wi, used.wo) for fit in PUBLISHED]
    return np.array([log_distance(values, used) for values in (*others, *(fit.predicted for fit in fits))])


def published(data: Path, ours: dict[str, str], jobs: int) -> list[str]:
    """The part of the page: published fits of MERL materials, beside fits of models of our own, by what they are called."""
    materials = dozen(data)
    with tempfile.TemporaryDirectory() as folder:
        tasks = [(data, Path(folder), ours, name) for name in materials]
        rows = dict(zip(materials, spread(compared, tasks, jobs), strict=True))
    every, names = np.array(list(rows.values())), (*PUBLISHED, *ours)
    nearest = np.bincount(np.nanargmin(every, axis=1), minlength=len(names))
    wins = [
        f"| {own} | {' | '.join(wins_over(every[:, len(PUBLISHED) + k], other) for other in every.T)} |"
        for k, own in enumerate(ours)
    ]
    return [
        "## Published fits",
        "",
        "The parameters that Ngan, Durand and Matusik (2005; Cook-Torrance) and Löw, Kronander, Ynnerman and Unger (2012; microfacet, loss E2)",
        "published for MERL materials, as BBM (2023) collects them and evaluated by their authors' conventions (`tools/published_fits.py`), beside fits of",
        "our own. RMS of the residual of the loss `log`, which is Löw's, times 1000, weighted by solid angle, up to 80 degrees, 30,000 of the bins; ours are",
        "fitted in this loss with K_s per channel, as theirs are. **Theirs were fitted to the measurements, ours to the reconstructions that both are",
        "compared with**, which differ by 4 to 26 %: much of their distance may be that. Ngan fitted another loss (`linear`). A blank: no fit was published.",
        "",
        f"On how many of the {len(rows)} materials of the leaderboard a fit of ours is nearer:",
        "",
        f"| nearer than | {' | '.join(names)} |",
        "|---" * (1 + len(names)) + "|",
        *wins,
        f"| nearest of all in | {' | '.join(map(str, nearest))} |",
        "",
        f"| material | {' | '.join(names)} |",
        "|---" * (1 + len(names)) + "|",
        f"| **median of {len(rows)}** | {' | '.join(f'**{1000 * x:.1f}**' for x in np.nanmedian(every, axis=0))} |",
        *[
            f"| {name} | {' | '.join(f'{1000 * x:.1f}' if np.isfinite(x) else '' for x in row)} |"
            for name, row in rows.items()
        ],
    ]


def wins_over(own: Floats, other: Floats) -> str:
    """In how many rows a fit is nearer than another one; blank against itself."""
    return "" if np.array_equal(own, other) else f"{np.sum(own < other)} of {np.isfinite(other).sum()}"


def dozen(data: Path) -> list[str]:
    """Every fifth of the MERL materials that can be reconstructed."""
    if not (data / "merl-nbrdf").exists():
        return []
    with np.load(data / "merl-nbrdf" / "nets.npz") as nets:
        return sorted(nets.files)[::5]


def merl_material(data: Path, folder: Path, name: str) -> motes.Measurement:
    """A material that the writer of MERL files reconstructs: an even part of its bins, since many models are fitted."""
    path = folder / f"{name}.binary"
    subprocess.run(
        [sys.executable, data.parent / "tools" / "write_merl.py", folder, name], check=True, capture_output=True
    )
    found = motes.read(path)
    path.unlink()
    return found.select(np.sort(np.random.default_rng(1).choice(found.n_directions, PART, replace=False)))
