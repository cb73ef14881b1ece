"""Texels with gross outliers under the squared loss: how many end above the best fit that random starts find.

usage: python benchmarks/outliers.py [--texels 2000] [--random 80]

The surface, the directions and the parameters are those of texels.py; 5 % of the samples are a tenth, three or five times what they were.  Prints a line with
the bands of starts that `motes.fitting.texels_nearest.bands` makes, and one without.
"""

from __future__ import annotations

import argparse

import numpy as np

from texel_cases import NOISE, Case
from texels import solver

SPOILT, FACTORS, ABOVE = 0.05, (0.1, 3.0, 5.0), 1e-3
LEAST = (0.05, 0.05, 0.05, 0.0, 0.02, 0.02)
MOST = (1.0, 1.0, 1.0, 1.2, 1.5, 0.8)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--texels", type=int, default=2000)
    parser.add_argument("--random", type=int, default=80)
    a = parser.parse_args()
    fitter, rng = solver(), np.random.default_rng(31)
    clean = Case.of(a.texels).clean
    values = clean * (1 + NOISE * rng.standard_normal(clean.shape))
    bad = rng.random(values.shape) < SPOILT
    values[bad] *= rng.choice(FACTORS, bad.sum())
    values = values.astype(np.float32)
    starts = fitter.starts(values[:: max(1, a.texels // 30)])
    low, high = fitter.bounds
    best = np.full(a.texels, np.inf)
    for k in range(a.random):
        own = rng.uniform(LEAST, MOST, (a.texels, len(LEAST)))
        if k % 2:
            own[:, 5] = np.exp(rng.uniform(np.log(LEAST[5]), np.log(MOST[5]), a.texels))
        fit = fitter.fit(values, np.clip(own, low, high), own_starts=True)
        best = np.fmin(best, fit.relative_rms.astype(float) ** 2)
    found = {}
    for name in ("with bands", "without"):
        if name == "without":
            vars(fitter)["_bands"] = ()
        found[name] = fitter.fit(values, starts).relative_rms.astype(float) ** 2
    best = np.fmin(best, np.fmin.reduce(list(found.values())))
    for name, squares in found.items():
        above = squares / best - 1
        print(
            f"{name}: {np.sum(above > ABOVE)} of {a.texels} end more than {ABOVE:.1%} above the best, by {above.max():.2%} at most"
        )


if __name__ == "__main__":
    main()
