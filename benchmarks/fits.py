"""How long a fit takes, against SciPy on the same data in the same run: CUReT, Cornell and a MERL table.

usage: python benchmarks/fits.py [--data ../shared/data] [--repeat 3] [--json]

Data that are missing are simulated at the same directions' number. SciPy's `least_squares` starts once, where our fit ended, moved by a tenth,
so that the ratio flatters SciPy: it neither searches for starts nor makes standard errors.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

import motes
from motes.measurements import Measurement

MODEL = "oren_nayar + torrance_sparrow"
MATERIAL = "pink-felt"


def best(work: Callable[[], object], repeat: int) -> float:
    """The least wall time [s] of several."""
    seconds = []
    for _ in range(repeat):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
    return min(seconds)


def simulated(n: int, channels: int) -> Measurement:
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


def merl(data: Path, folder: str) -> Measurement:
    writer = data.parent / "tools" / "write_merl.py"
    if not writer.exists():
        return simulated(1_100_000, 3)
    subprocess.run([sys.executable, writer, folder, MATERIAL], check=True, capture_output=True)
    return motes.read(Path(folder) / f"{MATERIAL}.binary")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, default=Path(__file__).resolve().parents[2] / "shared" / "data")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--json", action="store_true")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    curet, cornell = given.data / "curet", given.data / "cornell" / "krylon_blue.brdf"
    results = []
    with tempfile.TemporaryDirectory() as folder:
        cases = {
            "CUReT sample": lambda: motes.read(curet, sample=10) if curet.exists() else simulated(205, 1),
            "Cornell paint": lambda: motes.read(cornell) if cornell.exists() else simulated(1439, 31),
            "MERL table": lambda: merl(given.data, folder),
        }
        for name, read in cases.items():
            data = read()
            large = data.values.size > 1_000_000
            repeat = 1 if large else given.repeat
            fit = motes.fit(data, MODEL)
            row = {"data": name, "samples": int(data.mask.sum()), "parameters": int(fit.metrics["n_parameters"])}
            row["fit_s"] = best(lambda data=data: motes.fit(data, MODEL), repeat)
            row["auto_s"] = best(lambda data=data: motes.fit(data), 1)
            row["scipy_s"] = best(scipy_fit(data, fit), 1)
            row["ratio"] = row["scipy_s"] / row["fit_s"]
            results.append(row)
    if given.json:
        print(json.dumps({"cores": os.cpu_count(), "results": results}, indent=1))
        return
    print(
        f"{'data':15}{'samples':>10}{'values':>8}{'fit [s]':>10}{'auto [s]':>10}{'SciPy, one start [s]':>22}{'ratio':>8}"
    )
    for row in results:
        print(
            f"{row['data']:15}{row['samples']:10,}{row['parameters']:8}{row['fit_s']:10.3f}{row['auto_s']:10.2f}"
            f"{row['scipy_s']:22.2f}{row['ratio']:8.1f}"
        )


if __name__ == "__main__":
    main()
