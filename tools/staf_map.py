"""A real surface as a map: the STAF parameter maps of rusting iron, measured by a simulated rig, fitted back, compared.

usage: python tools/staf_map.py STAF_FOLDER [--size 460] [--times 16] [--noise 0.01] [--work FOLDER] [--docs docs]

Writes docs/real_map.md and docs/pictures/real_map.png.  The whole map is 3.2 GB on the disk for a while, in --work (a temporary folder when not
given); memory stays below a gigabyte.
"""

from __future__ import annotations

import argparse
import os
import platform
import resource
import tempfile
import time
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import motes
from motes import maps
from motes.ageing.rust import highlight_strength
from motes.directions import from_spherical
from motes.maps.comparison import compare
from motes.maps.simulated import fill
from motes.maps.staf_layout import staf_area

MODEL = "lambert + torrance_sparrow"
LIGHTS, NEAR, FAR = 80, 25.0, 75.0  # degrees
SMALLEST = 0.001  # rad: below, there is no highlight
SHOWN = (0.0, 1 / 3, 2 / 3, 1.0)
PANEL = 170  # pixels
DETERMINED = 0.1  # rad: widths with a larger standard error are not drawn

Floats = NDArray[np.float64]


def lights() -> Floats:
    """Half of the lights within 25 degrees of the viewer, who looks from above, where the highlight is; the others out to 75."""
    k = np.arange(LIGHTS) + 0.5
    share = k / LIGHTS
    theta = np.where(share < 0.5, NEAR * np.sqrt(2 * share), NEAR + (FAR - NEAR) * (2 * share - 1))
    return np.asarray(from_spherical(np.radians(theta), k * np.pi * (3 - np.sqrt(5))))


def parameters(source: Path, size: int, times: int) -> dict[str, Floats]:
    """The true parameters (y, x, T[, 3]), float32, of the middle of the maps."""
    staf = motes.read(source)
    y, x = ((n - min(size, n)) // 2 for n in staf.shape)
    rows, columns = slice(y, y + size), slice(x, x + size)
    found: dict[str, list[Floats]] = {"K_d": [], "K_s": [], "sigma_s": []}
    for t in np.linspace(0, 1, times):
        raw = staf.raw(float(t))
        sigma_s = raw["Roughness"][rows, columns]
        dark = sigma_s < SMALLEST
        found["K_d"].append(np.maximum(raw["Diffuse"][rows, columns], 0))
        found["K_s"].append(np.where(dark, 0, highlight_strength(raw["Specular"][rows, columns], sigma_s)))
        found["sigma_s"].append(np.where(dark, np.nan, sigma_s))
    return {name: np.stack(v, axis=2).astype(np.float32) for name, v in found.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source", type=Path)
    parser.add_argument("--size", type=int, default=460)
    parser.add_argument("--times", type=int, default=16)
    parser.add_argument("--noise", type=float, default=0.01)
    parser.add_argument("--work", type=Path)
    parser.add_argument("--docs", type=Path, default=Path("docs"))
    a = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="staf-map-", dir=a.work) as work:
        run(a, Path(work))


def run(a: argparse.Namespace, work: Path) -> None:
    true = parameters(a.source, a.size, a.times)
    shape = true["K_s"].shape[:2]
    hours = np.linspace(0, 1, a.times)
    chunk = -(-a.size // -(-a.size // 64))  # about 64, with little left over at the edges
    options = {"chunk": chunk, "compressed": False, "name": "rusting iron"}
    stack = maps.create_map(work / "iron.zarr", shape, lights(), (0, 0, 1), hours=hours, **options)
    began = time.perf_counter()
    stack = measured(stack, true, a.noise)
    rendered = time.perf_counter() - began
    size = maps.zarrs.size_on_disk(stack.path)
    marks: list[tuple[float, float]] = []

    def progress(done: int, total: int, what: str) -> None:
        if what.startswith("fitting"):
            marks.append((time.perf_counter(), time.process_time()))

    began = time.perf_counter()
    fitted = maps.fit_map(stack, MODEL, out=work / "fit.zarr", progress=progress)
    whole = time.perf_counter() - began
    seconds, processor = (end - start for start, end in zip(marks[0], marks[-1], strict=True))
    fits = shape[0] * shape[1] * a.times
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    lines = [
        f"{fits:,} fits in {seconds:.1f} s ({processor:.1f} s of processor): {fits / seconds:,.0f}/s; {whole - seconds:.1f} s before them"
    ]
    errors = table(fitted, stack, true)
    folder = a.docs / "pictures"
    folder.mkdir(parents=True, exist_ok=True)
    draw(folder / "real_map.png", fitted, true)
    text = page(a, shape, fitted.counts(), errors, seconds, processor, whole, rendered, size, peak)
    motes.files.write_text(a.docs / "real_map.md", text)
    print("\n".join([*lines, *errors, f"peak memory {peak:.2f} GiB"]))


def measured(stack: maps.MapStack, true: dict[str, Floats], noise: float) -> maps.MapStack:
    """The map with what the rig measures of a surface with these parameters."""

    def surface(y: Floats, x: Floats, t: Floats) -> dict[str, Floats]:
        where = (y[..., 0].astype(int), x[..., 0].astype(int))
        now = {name: value[where].astype(float) for name, value in true.items()}
        # No highlight: any width will do for rendering; the truth that is compared has none.
        return {**now, "sigma_s": np.where(np.isnan(now["sigma_s"]), 0.1, now["sigma_s"])}

    fill(stack, MODEL, surface, noise, seed=45)
    return maps.open_map(stack.path)


def table(fitted: maps.FittedMap, stack: maps.MapStack, true: dict[str, Floats]) -> list[str]:
    """Rows of Markdown: the errors of each map, over all texels and times."""
    rows = []
    found = compare(fitted, stack)
    seen = np.isfinite(true["sigma_s"]) & (true["K_s"] > 0)
    values = {name: fitted.values(name) for name in true}
    stderr = fitted.read_map("sigma_s_stderr")
    strong = seen & (true["K_s"] * staf_area(true["sigma_s"]) > 0.01) & (true["sigma_s"] > 0.05)
    for name, where, words in (
        ("K_d", np.ones(seen.shape, bool), "all"),
        ("K_s", seen, "with a highlight"),
        ("sigma_s", seen, "with a highlight"),
        ("K_s", strong, "Specular > 0.01 and sigma_s > 0.05"),
        ("sigma_s", strong, "Specular > 0.01 and sigma_s > 0.05"),
    ):
        value, truth = values[name][where], true[name][where].astype(float)
        good = np.isfinite(value)
        error = np.abs(value - truth)[good]
        relative = error / np.maximum(truth[good], 1e-9)
        bound = fitted.read_map(f"{name}_stderr")[where][good]
        known = np.isfinite(bound)
        inside = np.mean(error[known] <= 2 * bound[known])
        rows.append(
            f"| `{name}` | {words} | {np.median(truth[good]):.3g} | {np.median(error):.2g} | {100 * np.median(relative):.2f} % "
            f"| {100 * np.quantile(relative, 0.9):.1f} % | {100 * inside:.1f} % | {100 * good.mean():.2f} % |"
        )
    assert set(found) == set(true)
    assert stderr.shape == seen.shape
    return rows


def page(
    a: argparse.Namespace,
    shape: tuple[int, int],
    counts: dict[str, int],
    errors: list[str],
    seconds: float,
    processor: float,
    whole: float,
    rendered: float,
    size: int,
    peak: float,
) -> str:
    fits = shape[0] * shape[1] * a.times
    ended = ", ".join(f"{n:,} {name.replace('_', ' ')}" for name, n in counts.items() if n)
    newline = "\n"
    return f"""# A real surface as a map

Written by `python tools/staf_map.py`. **Real parameter maps, simulated measurement**: the maps are those of rusting cast iron (tvBTF45 of Gu et al.,
*Time-varying Surface Appearance*, 2006, refitted as polynomials of time by Meister et al.), {shape[1]} x {shape[0]} texels at {a.times} times. A simulated
rig measures them: {LIGHTS} lights, half of them within {NEAR:g} degrees of the viewer, who looks from above, the others out to {FAR:g} degrees, three channels,
{100 * a.noise:g} % noise on every value. `motes.maps.fit_map` fits `{MODEL}` to what was measured, each texel and time alone, and knows nothing of the truth.

![The diffuse colour, sigma_s and Specular at four times: true and fitted](pictures/real_map.png)

| map | texels and times | true median | median error | relative, median | relative, 90 % below | within 2 standard errors | fitted |
|---|---|---|---|---|---|---|---|
{newline.join(errors)}

"Specular" is the energy of the highlight, S = K_s pi sigma_s^2 (1 - exp(-1/sigma_s^2)). Where it is faint against the diffuse part, or narrower than the lights
are apart, the noise hides it, and the standard errors say so. In the picture a width is grey where there is no highlight (true), or where its standard error
is unknown or above {DETERMINED:g} rad (fitted).

- {fits:,} fits, reading and writing included, in {processor:.1f} s of processor time, {1e6 * processor / fits:.2f} µs each, which took {seconds:.1f} s,
  {processor / seconds:.2f} of {os.cpu_count()} processors at work; {whole - seconds:.1f} s before them for the starts and
  the kernel (compiled once for a model).
- They ended: {ended}.
- {size / 1e9:.2f} GB measured (float32), rendered in {rendered:.0f} s; peak memory of the whole script {peak:.2f} GiB, with the truth
  that it keeps to compare.
- {platform.machine()}, {os.cpu_count()} cores, {platform.system()}; Python {platform.python_version()}, NumPy {np.__version__},
  Motes {motes.__version__}.
"""


def draw(path: Path, fitted: maps.FittedMap, true: dict[str, Floats]) -> None:
    """True and fitted maps at four times, in few colours so that the file stays small."""
    from io import BytesIO

    from matplotlib.figure import Figure
    from PIL import Image

    from motes.drawing.colour import srgb_encode

    times = [round(t * (len(fitted.hours) - 1)) for t in SHOWN]
    step = max(1, fitted.shape[0] // PANEL)
    where = (slice(None, None, step), slice(None, None, step))
    fit = {name: fitted.values(name, where) for name in true}
    stderr = fitted.read_map("sigma_s_stderr", where)
    with np.errstate(invalid="ignore"):
        fit["width"] = np.where(stderr < DETERMINED, fit["sigma_s"], np.nan)
    real = {name: value[where].astype(float) for name, value in true.items()}
    real["width"] = np.where(real["K_s"] > 0, real["sigma_s"], np.nan)
    rows: list[tuple[str, list[Floats], tuple[float, float] | None]] = []
    for label, source in (("true", real), ("fitted", fit)):
        rows.append((f"diffuse\n{label}", [srgb_encode(3 * source["K_d"][:, :, k]) for k in times], None))
    for label, source in (("true", real), ("fitted", fit)):
        rows.append((f"$\\sigma_s$ [rad]\n{label}", [source["width"][:, :, k] for k in times], (0.0, 0.4)))
    for label, source in (("true", real), ("fitted", fit)):
        weight = source["K_s"] * staf_area(source["sigma_s"])
        rows.append((f"Specular\n{label}", [np.sqrt(np.maximum(weight[:, :, k], 0)) for k in times], (0.0, 0.6)))
    dpi, left, right, top = 100, 0.62, 0.62, 0.28
    inch = PANEL / dpi
    width, height = left + len(times) * inch + right, top + len(rows) * inch + 0.05
    figure = Figure(figsize=(width, height), dpi=dpi)
    for r, (label, pictures, scale) in enumerate(rows):
        for c, picture in enumerate(pictures):
            box = (
                (left + c * inch) / width,
                1 - (top + (r + 1) * inch) / height,
                0.98 * inch / width,
                0.98 * inch / height,
            )
            axes = figure.add_axes(box)
            options = {} if scale is None else {"vmin": scale[0], "vmax": scale[1], "cmap": "magma"}
            drawn = axes.imshow(picture, interpolation="nearest", **options)
            if scale:
                drawn.cmap.set_bad("0.5")
            axes.set_xticks([])
            axes.set_yticks([])
            if r == 0:
                axes.set_title(f"t = {fitted.hours[times[c]]:.2f}", fontsize=9)
            if c == 0:
                axes.set_ylabel(label, fontsize=9)
        if scale and r % 2 == 0:
            box = (
                (left + len(times) * inch + 0.05) / width,
                1 - (top + (r + 2) * inch) / height,
                0.1 / width,
                1.98 * inch / height,
            )
            bar = figure.colorbar(drawn, cax=figure.add_axes(box))
            bar.ax.tick_params(labelsize=7)
            if "Specular" in label:  # the colours go with the square root
                bar.set_ticks([0, 0.1**0.5, 0.2**0.5, 0.3**0.5])
                bar.set_ticklabels(["0", "0.1", "0.2", "0.3"])
    buffer = BytesIO()
    figure.savefig(buffer, metadata={"Software": None})
    buffer.seek(0)
    few = Image.open(buffer).convert("RGB").quantize(96, dither=Image.Dither.NONE)
    few.save(path, optimize=True)


if __name__ == "__main__":
    main()
