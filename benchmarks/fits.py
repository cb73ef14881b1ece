"""How long a fit of one material takes, against SciPy on the same data in the same run: CUReT, Cornell and a MERL table.

usage: python benchmarks/fits.py [--effort quick|normal|full] [--json FILE]

Measurements are looked for beside the repository, in ../shared/data; those that are missing are skipped by name.  SciPy's `least_squares`
starts once, where our fit ended, moved by a tenth, so that the ratio flatters SciPy: it neither searches for starts nor makes standard errors.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

import motes
from motes.measurements import Measurement
from results import Effort, Goal, Number, Section, Table, command
from timing import interleaved

DATA = Path(__file__).resolve().parents[2] / "shared" / "data"
MODEL = "oren_nayar + torrance_sparrow"
MATERIAL = "pink-felt"
SIZES = (300, 10_000, 100_000, 1_000_000)
LARGE = 1_000_000  # values: fits of so many take seconds, and fewer rounds


def simulated(n: int, channels: int) -> Measurement:
    """A rough surface with a highlight and 2 % noise."""
    rng = np.random.default_rng(1)
    z, phi = rng.uniform(0.2, 1, (2, n)), rng.uniform(-np.pi, np.pi, (2, n))
    wi, wo = np.stack([np.sqrt(1 - z**2) * np.cos(phi), np.sqrt(1 - z**2) * np.sin(phi), z], axis=-1)
    truth = motes.OrenNayar(K_d=np.linspace(0.2, 0.6, channels), sigma_d=0.4) + motes.TorranceSparrow(0.3, 0.2)
    f = truth.eval(wi, wo)
    return Measurement.from_arrays(wi, wo, f * (1 + 0.02 * rng.standard_normal(f.shape)))


def scipy_fit(data: Measurement, fit: motes.Fit) -> Callable[[], object]:
    """One SciPy fit of the same residuals through the public `eval`, derivatives by finite differences."""
    usable = data.mask[0].all(axis=1)
    wi, wo, values = data.wi[usable], data.wo[usable], data.values[0][usable]
    factor = wi[:, 2:3] * np.sqrt(data.weights[usable] / data.weights[usable].mean())[:, None]
    channels = values.shape[1]

    def residuals(x: np.ndarray) -> np.ndarray:
        diffuse = motes.OrenNayar(x[:channels], float(x[channels]))
        brdf = diffuse + motes.TorranceSparrow(float(x[channels + 1]), float(x[channels + 2]))
        return ((brdf.eval(wi, wo) - values) * factor).ravel()

    x = np.concatenate([np.atleast_1d(p.value) for p in fit.parameters.values()])
    low = np.zeros(len(x))
    high = np.full(len(x), np.inf)
    low[-1], high[-1], high[channels] = 0.005, np.pi / 2, np.pi / 2
    x0 = np.clip(0.9 * x + 1e-3, low, high)
    return lambda: least_squares(residuals, x0, bounds=(low, high), x_scale="jac", max_nfev=30)


def merl(folder: Path) -> Measurement:
    """A table in MERL's format, written by the tool beside the data."""
    writer = DATA.parent / "tools" / "write_merl.py"
    subprocess.run([sys.executable, writer, folder, MATERIAL], check=True, capture_output=True)
    return motes.read(folder / f"{MATERIAL}.binary")


def measurements(effort: Effort, skipped: list[str]) -> Iterator[tuple[str, str, Measurement]]:
    """A key, a title and the data of each case that is there."""
    yield "small", "simulated, small", simulated(100, 3)
    yield "simulated", "simulated", simulated(effort.pick(100, 1439), 3)
    curet, cornell = DATA / "curet", DATA / "cornell" / "krylon_blue.brdf"
    for key, title, path, read in (
        ("curet", "CUReT, sample 10", curet, lambda: motes.read(curet, sample=10)),
        ("cornell", "Cornell, Krylon blue, 31 wavelengths", cornell, lambda: motes.read(cornell)),
    ):
        if not path.exists():
            skipped.append(f"{title}: ../shared/data/{path.relative_to(DATA)} is missing")
        elif key == "curet" or effort.name != "quick":
            yield key, title, read()
    if not all((DATA.parent / name).exists() for name in ("tools/write_merl.py", "data/merl-nbrdf")):
        skipped.append("MERL: ../shared/tools/write_merl.py or ../shared/data/merl-nbrdf is missing")
    elif effort.name != "quick":
        with tempfile.TemporaryDirectory() as folder:
            data = merl(Path(folder))
        yield "merl", f"MERL format, {MATERIAL}, 90 x 90 x 180 bins", data


def by_size(effort: Effort, figures: dict[str, Number]) -> Table:
    """Fits to measurements of growing size, each of them new: what is kept of one that was fitted before is found out, too."""
    rows: list[list[str]] = []
    for values in SIZES[: effort.pick(1, len(SIZES))]:
        made = [simulated(values // 3, 3) for _ in range(effort.pick(1, 3 if values > LARGE // 4 else 7))]
        motes.fit(simulated(values // 3, 3), MODEL)  # touches memory
        wall, processor = [], []
        for data in made:
            start, cpu = time.perf_counter(), time.process_time()
            motes.fit(data, MODEL)
            wall.append(1e3 * (time.perf_counter() - start))
            processor.append(1e3 * (time.process_time() - cpu))
        key = f"of_{values}"
        figures |= {key: Number.of(wall), f"{key}_cpu": Number.of(processor)}
        figures[f"{key}_rounds"] = Number.of([len(made)])
        rows.append([f"{values:,}", f"{{{key}_rounds:count}}", f"{{{key}}}", f"{{{key}_cpu}}"])
    return Table(["values of a new measurement", "rounds", "fit [ms]", "processor [ms]"], rows)


def material_fits(effort: Effort) -> Section:
    """For each measurement our fit, our choice of a model, and SciPy's one start, in turn."""
    figures: dict[str, Number] = {}
    rows: list[list[str]] = []
    skipped: list[str] = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # verdicts on the data's quality are not the matter here
        for key, title, data in measurements(effort, skipped):
            fit = motes.fit(data, MODEL)
            calls: dict[str, tuple[Callable[[], object], float]] = {
                "fit": (lambda data=data: motes.fit(data, MODEL), 1),
                "auto": (lambda data=data: motes.fit(data), 1),
                "scipy": (scipy_fit(data, fit), 1),
            }
            large = data.values.size > LARGE
            rounds = effort.pick(1, 3 if large else 5)
            timings = interleaved(calls, rounds, warm=not large and effort.name != "quick")
            figures |= {
                f"{key}_values": Number.of([data.mask.sum()]),
                f"{key}_parameters": Number.of([fit.metrics["n_parameters"]]),
                f"{key}_rounds": Number.of([rounds]),
                f"{key}_ratio": timings["fit"].faster_than(timings["scipy"]),
                f"{key}_ratio_cpu": timings["fit"].cheaper_than(timings["scipy"]),
                **{f"{key}_{name}": timing.seconds for name, timing in timings.items()},
            }
            names = ("values", "parameters", "rounds")
            row = [title, *(f"{{{key}_{name}:count}}" for name in names)]
            rows.append([*row, *(f"{{{key}_{name}}}" for name in ("fit", "auto", "scipy", "ratio", "ratio_cpu"))])
        sizes = by_size(effort, figures)
    figures["small_fit_ms"] = figures["small_fit"].times(1e3)
    ratios = {name: f for name, f in figures.items() if name.endswith("_ratio")}
    least, most = (choose(ratios, key=lambda name: ratios[name].median) for choose in (min, max))
    figures |= {"least": ratios[least], "most": ratios[most]}
    return Section(
        title="Fits of one material",
        made_by="benchmarks/fits.py, material_fits()",
        intro=(
            f"`motes.fit` of `{MODEL}`, from reading the arrays to standard errors; `auto` compares several models. "
            "SciPy's `least_squares` starts once, a tenth from where our fit ended, without searching for starts and without errors, so the ratio flatters it."
        ),
        figures=figures,
        tables=[
            Table(
                [
                    "data",
                    "values",
                    "parameters",
                    "rounds",
                    "fit [s]",
                    "auto [s]",
                    "SciPy, one start [s]",
                    "SciPy / fit",
                    "by processor time",
                ],
                rows,
            ),
            sizes,
        ],
        goals=[Goal("a fit of 300 values, from all starts", "small_fit_ms", 8, at_least=False, unit=" ms")],
        reading=[
            "A whole fit with its search for starts is {least} to {most} times as fast as a single start of SciPy's."
        ],
        skipped=skipped,
    )


if __name__ == "__main__":
    command(material_fits, __doc__)
