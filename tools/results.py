"""Fit every real measurement at hand and write docs/results.md.

usage: python tools/results.py [--data ../shared/data] [-o docs/results.md] [--only PART ...] [--jobs N]

The page is made by this script alone; parts whose data are missing are left out, and the page says so.  With ``--only`` the other
parts stay as the page has them; each says by which commit it was made.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from commits import commit_of_sources
from leaderboard import CORNELL, RICHER, richer
from leaderboard_study import differences
from published_fits import published

import motes
from motes.directions import half_difference
from motes.files import write_text
from motes.measurements import list_samples

RICH = "oren_nayar + torrance_sparrow"
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


def chosen(fit: motes.Fit, label: str) -> str:
    """What `auto` chose, in brackets."""
    return f" ({SHORT.get(fit.model_text, fit.model_text)})" if label == "auto" else ""


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
        near = int(np.sum(half_difference(data.wi, data.wo)[0] < 0.02))
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
        "rise of the highlight towards grazing; a Fresnel term mends it, and finds the refractive index of a varnish for the red and the blue. Cayman's highlight",
        f"is hardly seen: {near} of its directions have a half vector within 0.02 rad of the normal, so that its strength and index are not to be believed.",
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
                values = [number(fit, k) for k in ("K_d", "sigma_d", "K_s", "sigma_s")]
                table.append(
                    f"| {name} | {label}{chosen(fit, label)} | {limit or 90}° | {percent(fit.metrics['relative_rms'])} | {fit.metrics['rms_linear']:.2g} | {' | '.join(values)} |"
                    f" {reading:.1f} + {fit.seconds:.1f} |"
                )
    return [
        "## MERL format",
        "",
        "90 x 90 x 180 bins, RGB, weighted by solid angle, loss `linear`. The values are *neural reconstructions* of MERL materials (Sztrajman et al. 2021), within 4 to 26 % of",
        "the measurement, not the measurement. The unweighted relative RMS counts every bin alike, the grazing ones too, where F = 1 grows without bound; the fit itself",
        "weighs by solid angle and cosine. What `auto` chose stands in brackets; blank: it has no such parameter. Seconds: reading + fitting.",
        "",
        "| material | model | up to | relative RMS [%] | RMS of (f - r) cos theta_i | K_d | sigma_d [rad] | K_s | sigma_s [rad] | seconds |",
        "|---|---|---|---|---|---|---|---|---|---|",
        *table,
    ]


def others(data: Path) -> list[str]:
    table = []
    for path in (*sorted((data / "rgl").glob("*.bsdf")), *sorted((data / "mbsdf").glob("*.mbsdf"))):
        measurement = motes.read(path)
        for label, model in (("ON+TS", RICH), ("auto", "auto")):
            fit = motes.fit(measurement, model, loss="log")
            masked = measurement.mask.size - int(measurement.mask.sum())
            share = percent(masked / measurement.mask.size)
            table.append(
                f"| {path.stem} | {label}{chosen(fit, label)} | {percent(fit.metrics['relative_rms'])} | {fit.metrics['rms_log']:.2g} | {share} |"
            )
    return [
        "## RGL and MBSDF",
        "",
        "Automotive paints, metallic and pearlescent foils, silk: mostly outside what these models describe. Loss `log`, so that the second column of numbers is what was",
        "made small; the first counts samples along the surface, where the values are largest, most, and can be anything.",
        "",
        "| material | model | relative RMS [%] | RMS of the log residual | masked [%] |",
        "|---|---|---|---|---|",
        *table,
    ]


# What published fits are compared with.
OURS = {name: RICHER[name] for name in ("ON+TS, Schlick", "EON+GTR, Schlick")}
# The parts of the page: what it needs, its heading, and what makes it.
PARTS: dict[str, tuple[str, str, Callable[[Path, int], list[str]]]] = {
    "curet": ("curet", "CUReT", lambda data, jobs: curet(data / "curet")),
    "cornell": ("cornell", "Cornell gloss paints", lambda data, jobs: cornell(data / "cornell")),
    "merl": ("merl-nbrdf", "MERL format", lambda data, jobs: merl(data)),
    "others": ("rgl", "RGL and MBSDF", lambda data, jobs: others(data)),
    "models": (".", "Models beside each other", richer),
    "differences": (".", "Beside the earlier study", differences),
    "published": ("merl-fits", "Published fits", lambda data, jobs: published(data, OURS, jobs)),
}


def section(page: str, heading: str) -> list[str]:
    """A part of a page, without the blank lines after it; nothing where it has none."""
    _, found, rest = page.partition(f"\n## {heading}\n")
    return [f"## {heading}", *rest.split("\n## ")[0].rstrip().split("\n")] if found else []


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, default=Path(__file__).resolve().parents[2] / "shared" / "data")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path(__file__).resolve().parents[1] / "docs" / "results.md"
    )
    parser.add_argument("--only", nargs="+", choices=PARTS, default=list(PARTS), metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes for the parts of many fits")
    given = parser.parse_args()
    before = given.output.read_text() if given.output.exists() else ""
    commit = commit_of_sources()
    page = [
        "# Results on real measurements",
        "",
        "Written by `tools/results.py`: how far the models are from real materials. Relative RMS is RMS(f - r) / RMS(r), unweighted, over unmasked samples. ± is one standard",
        "error; a reason in brackets stands where there is none.",
        "",
        f"Made with Motes {motes.__version__}, Python {platform.python_version()}, NumPy {np.__version__}. Seconds are of a machine with two cores that did other things too.",
        "",
    ]
    for name, (needed, heading, part) in PARTS.items():
        if name not in given.only:
            page += [*section(before, heading), ""]
        elif (given.data / needed).exists():
            print(f"{name} ...", flush=True)
            with contextlib.redirect_stderr(io.StringIO()):
                made = part(given.data, given.jobs)
            page += [*made, "", f"*By commit {commit}.*", ""]
        else:
            page += [f"*{heading}: no data at hand when this page was made.*", ""]
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
