"""Fit every real measurement at hand and write docs/results.md.

usage: python tools/results.py [--data ../shared/data] [-o docs/results.md]

The page is made by this script alone; parts whose data are missing are left out, and the page says so.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np

import motes
from motes.files import write_text
from motes.measurements import list_samples

RICH = "oren_nayar + torrance_sparrow"
CORNELL = {"garnet_red.brdf": "garnet red", "krylon_blue.brdf": "Krylon blue", "cayman.brdf": "Cayman"}
FRESNEL = {
    "F = 1": RICH,
    "dielectric, n = 1.5": "oren_nayar + torrance_sparrow(fresnel=dielectric(n=1.5))",
    "dielectric, n fitted": "oren_nayar + torrance_sparrow(fresnel=dielectric)",
    "Schlick, f0 fitted": "oren_nayar + torrance_sparrow(fresnel=schlick)",
}
SHORT = {
    "lambert": "Lambert",
    "oren_nayar": "ON",
    "lambert + torrance_sparrow": "Lambert+TS",
    RICH: "ON+TS",
    "oren_nayar + torrance_sparrow(fresnel=schlick)": "ON+TS, Schlick",
    "eon + ggx(fresnel=schlick)": "EON+GGX, Schlick",
    "eon + gtr(fresnel=schlick)": "EON+GTR, Schlick",
    "coated_diffuse + ggx(fresnel=schlick)": "coat+GGX",
    "coated_diffuse + gtr(fresnel=schlick)": "coat+GTR",
    "coated_diffuse + hapke(B_0=0, h=0.1) + ggx(fresnel=schlick)": "coat+grazing rise+GGX",
    f"dust_layer({RICH})": "dust",
    f"dust_layer({RICH}, scattering=multiple)": "dust",
    "dust_layer(coated_diffuse + gtr(fresnel=schlick))": "dust",
    "dust_layer(coated_diffuse + gtr(fresnel=schlick), scattering=multiple)": "dust",
}
# Real materials ask for more than the source's models: a Fresnel term, energy that is kept, longer tails.
RICHER = {
    "ON+TS": RICH,
    "ON+TS, Schlick": "oren_nayar + torrance_sparrow(fresnel=schlick)",
    "EON+GGX, Schlick": "eon + ggx(fresnel=schlick)",
    "EON+GTR, Schlick": "eon + gtr(fresnel=schlick)",
}
MERL = ("pink-felt", "blue-acrylic", "alum-bronze", "special-walnut-224")


def percent(x: float) -> str:
    return f"{100 * x:.1f}"


def number(fit: motes.Fit, name: str) -> str:
    """A value with its error, or the reason why it has none."""
    p = fit.parameters.get(name)
    if p is None:
        return ""
    if np.ndim(p.value):
        return f"{np.min(p.value):.3g} to {np.max(p.value):.3g}"
    return (
        f"{p.value:.3g} ± {p.stderr:.1g}"
        if np.isfinite(p.stderr)
        else f"{p.value:.3g} ({p.verdict.name.lower().replace('_', ' ')})"
    )


def curet(folder: Path) -> list[str]:
    rows, table, dusty, unsure = [], [], 0, 0
    for sample in list_samples(folder):
        data = motes.read(folder, sample=int(sample))
        plain = [motes.fit(data, model, loss="plain") for model in ("oren_nayar", RICH)]
        linear = motes.fit(data, RICH)
        auto = motes.fit(data)
        rows.append([f.metrics["relative_rms"] for f in (*plain, linear, auto)])
        p = [number(plain[1], name) for name in ("K_d", "sigma_d", "K_s", "sigma_s")]
        masked = data.mask.size - int(data.mask.sum())
        dusty += auto.dusty is True
        unsure += auto.dusty is None
        table.append(
            f"| {sample} | {' | '.join(percent(x) for x in rows[-1])} ({SHORT.get(auto.model_text, auto.model_text)}) | {' | '.join(p)} | {masked} |"
        )
    medians = np.median(rows, axis=0)
    ten = motes.read(folder, sample=10)
    fits = {loss: motes.fit(ten, "oren_nayar", loss=loss) for loss in ("plain", "linear")}
    r, f = ten.values[0], fits["plain"].predicted
    to_mean = float(np.sqrt(np.mean((f - r) ** 2)) / r.mean())
    return [
        "## CUReT",
        "",
        f"{len(table)} samples, 205 directions each, grey. Relative RMS in percent: Oren-Nayar (ON) alone and with Torrance-Sparrow (ON+TS) by plain least",
        "squares, which minimises just this figure; ON+TS by the loss `linear`; and the model that `auto` chooses (loss `linear`). Parameters are those of ON+TS, plain.",
        "",
        f"**Medians: ON {percent(medians[0])} %, ON+TS {percent(medians[1])} %**, ON+TS linear {percent(medians[2])} %, auto {percent(medians[3])} %.",
        "",
        *[
            f"Sample 10, ON alone, loss `{loss}`: sigma_d = {fit.parameters['sigma_d'].value:.3f} rad, K_d = {fit.parameters['K_d'].value:.3f}, relative RMS"
            f" {percent(fit.metrics['relative_rms'])} %."
            for loss, fit in fits.items()
        ],
        f"Over the mean instead of the RMS of the data, plain: {percent(to_mean)} %.",
        "",
        f"`auto` calls {dusty} of the samples dusty, and cannot tell of {unsure}; none of them is ([verdicts.md](verdicts.md)).",
        "",
        "| sample | ON | ON+TS | ON+TS linear | auto | K_d | sigma_d [rad] | K_s | sigma_s [rad] | masked |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *table,
    ]


def cornell(folder: Path) -> list[str]:
    table = []
    for file, name in CORNELL.items():
        if not (folder / file).exists():
            continue
        data = motes.read(folder / file)
        for title, model in FRESNEL.items():
            fit = motes.fit(data, model)
            optics = number(fit, "n") or number(fit, "f0")
            values = [number(fit, k) for k in ("K_d", "sigma_d", "K_s", "sigma_s")]
            table.append(
                f"| {name} | {title} | {percent(fit.metrics['relative_rms'])} | {' | '.join(values)} | {optics} | {fit.seconds:.1f} |"
            )
    return [
        "## Cornell gloss paints",
        "",
        "1439 directions, 31 wavelengths, fitted together: K_d for each wavelength, one highlight for all. Loss `linear`. F = 1, as the source has it, cannot follow the",
        "rise of the highlight towards grazing; a Fresnel term mends it, and finds the refractive index of a varnish.",
        "",
        "| paint | Fresnel term | relative RMS [%] | K_d | sigma_d [rad] | K_s | sigma_s [rad] | n or f0 | seconds |",
        "|---|---|---|---|---|---|---|---|---|",
        *table,
    ]


def merl(data: Path) -> list[str]:
    writer = data.parent / "tools" / "write_merl.py"
    if not writer.exists() or not (data / "merl-nbrdf").exists():
        return []
    table = []
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, writer, folder, *MERL], check=True, capture_output=True)
        for name in MERL:
            start = time.perf_counter()
            measurement = motes.read(Path(folder) / f"{name}.binary")
            reading = time.perf_counter() - start
            for label, model, limit in (("ON+TS", RICH, None), ("ON+TS", RICH, 80), ("auto", "auto", 80)):
                fit = motes.fit(measurement, model, max_theta=None if limit is None else np.radians(limit))
                values = [number(fit, k) for k in ("K_d", "sigma_d", "K_s", "sigma_s", "tau")]
                table.append(
                    f"| {name} | {label} | {limit or 90}° | {percent(fit.metrics['relative_rms'])} | {fit.metrics['rms_linear']:.2g} | {' | '.join(values)} |"
                    f" {reading:.1f} + {fit.seconds:.1f} |"
                )
    return [
        "## MERL format",
        "",
        "90 x 90 x 180 bins, RGB, weighted by solid angle, loss `linear`. The values are *neural reconstructions* of MERL materials (Sztrajman et al. 2021), within 4 to 26 % of",
        "the measurement, not the measurement. The unweighted relative RMS counts every bin alike, the grazing ones too, where F = 1 grows without bound; the fit itself",
        "weighs by solid angle and cosine. Seconds: reading + fitting.",
        "",
        "| material | model | up to | relative RMS [%] | RMS of (f - r) cos theta_i | K_d | sigma_d [rad] | K_s | sigma_s [rad] | tau | seconds |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
        *table,
    ]


def others(data: Path) -> list[str]:
    table = []
    for path in (*sorted((data / "rgl").glob("*.bsdf")), *sorted((data / "mbsdf").glob("*.mbsdf"))):
        measurement = motes.read(path)
        for label, model in (("ON+TS", RICH), ("auto", "auto")):
            fit = motes.fit(measurement, model, loss="log")
            chosen = "" if model == RICH else f" ({fit.model_text})"
            masked = measurement.mask.size - int(measurement.mask.sum())
            share = percent(masked / measurement.mask.size)
            table.append(
                f"| {path.stem} | {label}{chosen} | {percent(fit.metrics['relative_rms'])} | {fit.metrics['rms_log']:.2g} | {share} |"
            )
    return [
        "## RGL and MBSDF",
        "",
        "Automotive paints, metallic and pearlescent foils, silk: mostly outside what these models describe. Loss `log`.",
        "",
        "| material | model | relative RMS [%] | RMS of the log residual | masked [%] |",
        "|---|---|---|---|---|",
        *table,
    ]


def weighted(fit: motes.Fit) -> float:
    """The relative RMS that the loss `linear` minimises: of (f - r) cos(theta_i), weighted as the fit weighs."""
    data = fit.measurement
    mask, measured = data.mask[0], data.values[0]
    weights = np.reshape(data.weights, (len(measured), -1)) * data.wi[:, 2:] ** 2 * mask
    off = np.where(mask, fit.predicted - measured, 0.0)
    return float(np.sqrt(np.sum(weights * off**2) / np.sum(weights * np.where(mask, measured, 0.0) ** 2)))


def richer(data: Path) -> list[str]:
    """A row a material, the models beside each other, by database."""
    page = []
    with tempfile.TemporaryDirectory() as folder:
        sources: dict[str, list[tuple[str, Callable[[], motes.Measurement]]]] = {
            "CUReT": [
                (f"sample {s}", partial(motes.read, data / "curet", sample=int(s)))
                for s in list_samples(data / "curet")
            ],
            "Cornell": [(name, partial(motes.read, data / "cornell" / file)) for file, name in CORNELL.items()],
            "MERL format": [(name, partial(merl_material, data, Path(folder), name)) for name in MERL],
            "RGL": [(path.stem, partial(motes.read, path)) for path in sorted((data / "rgl").glob("*.bsdf"))],
        }
        for database, materials in sources.items():
            limit = np.radians(80) if database == "MERL format" else None
            rows = {}
            for name, read in materials:
                measurement = read()
                fits = [motes.fit(measurement, model, max_theta=limit) for model in RICHER.values()]
                rows[name] = [weighted(fit) for fit in fits]
            medians = np.median(list(rows.values()), axis=0)
            page.append(
                f"| **{database}, median of {len(rows)}** | {' | '.join(f'**{percent(x)}**' for x in medians)} |"
            )
            page += [f"| {name} | {' | '.join(percent(x) for x in row)} |" for name, row in rows.items()]
    return [
        "## Models beside each other",
        "",
        "Relative RMS in percent of (f - r) cos theta_i, weighted as the loss `linear` weighs it (MERL format by solid angle and up to 80 degrees, the others every sample alike), K_s the",
        "same in all channels. TS is Torrance-Sparrow, ON Oren-Nayar; Schlick is a Fresnel term with f0 fitted.",
        "",
        f"| material | {' | '.join(RICHER)} |",
        f"|---|{'---|' * len(RICHER)}",
        *page,
    ]


def merl_material(data: Path, folder: Path, name: str) -> motes.Measurement:
    """A material that the writer of MERL files reconstructs."""
    subprocess.run(
        [sys.executable, data.parent / "tools" / "write_merl.py", folder, name], check=True, capture_output=True
    )
    return motes.read(folder / f"{name}.binary")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, default=Path(__file__).resolve().parents[2] / "shared" / "data")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path(__file__).resolve().parents[1] / "docs" / "results.md"
    )
    given = parser.parse_args()
    page = [
        "# Results on real measurements",
        "",
        "Written by `tools/results.py`: how far the models are from real materials. Relative RMS is RMS(f - r) / RMS(r), unweighted, over unmasked samples. ± is one standard",
        "error; a reason in brackets stands where there is none.",
        "",
        f"Made with Motes {motes.__version__}, Python {platform.python_version()}, NumPy {np.__version__}. Seconds are of a machine with two cores that did other things too.",
        "",
    ]
    parts = {
        "curet": lambda: curet(given.data / "curet"),
        "cornell": lambda: cornell(given.data / "cornell"),
        "merl-nbrdf": lambda: merl(given.data),
        "rgl": lambda: others(given.data),
        ".": lambda: richer(given.data),
    }
    for name, part in parts.items():
        if (given.data / name).exists():
            print(f"{name} ...", flush=True)
            with contextlib.redirect_stderr(io.StringIO()):
                page += [*part(), ""]
        else:
            page += [f"*{name}: no data at hand when this page was made.*", ""]
    page += [
        "## Where the models fall short",
        "",
        "- Glossy and metallic surfaces (most of CUReT, all of RGL): one highlight of Gaussian facets is too narrow at its foot; sigma_s at its upper bound of 1.57 rad",
        "  means that the fit uses the highlight as a second diffuse lobe.",
        "- F = 1 makes the highlight grow too slowly towards grazing for paints, and without bound at the horizon itself.",
        "- sigma_d at 0 or at its upper bound: the diffuse part is not Oren-Nayar's; its other parameters hold only together with this bound.",
        "- Errors of measured data are over blocks of directions ([fitting.md](fitting.md#standard-errors)): what the model misses alike in all of them no error shows.",
        "",
    ]
    write_text(given.output, "\n".join(page))
    print(given.output)


if __name__ == "__main__":
    main()
