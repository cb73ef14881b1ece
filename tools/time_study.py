"""How well joint fits over time find a known truth: simulated folders of each phenomenon, many seeds, one table.

usage: python tools/time_study.py [--seeds 30] [--step 2.5] [--processes 2] [--only dust] [-o docs/time_study.md]

Every phenomenon is measured by the simulated rig (12 scans, 2 % noise), written as a TVBRDF folder, read back, and fitted with the true model and the
trends left to be chosen.  Counted over seeds and parameters that the fit calls determined:

- trend: how often the chosen kind is the true one;
- coefficients: how often a true coefficient lies within 3 standard errors, where the kind is the true one;
- values: how often the true value at a scan lies within 3 standard errors of the band, whatever the kind;
- error: the mean absolute error of the joint fit at the scans over that of the separate fits of the scans, over the scans that determine the parameter.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
import time
import warnings
from concurrent.futures import ProcessPoolExecutor, as_completed
from pathlib import Path
from typing import Any

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(variable, "1")  # the processes share the processors already

import numpy as np  # noqa: E402

import motes  # noqa: E402
from motes.ageing import PHENOMENA, Rig, simulate  # noqa: E402
from motes.ageing.plaster import K_D_DRY, K_D_WET, MODEL  # noqa: E402
from motes.fitting import Verdict  # noqa: E402
from motes.material import Material  # noqa: E402
from motes.models import describe, parse  # noqa: E402
from motes.trends import KINDS, Trend  # noqa: E402

SCANS, HOURS, NOISE = 12, 6.0, 0.02
UNKNOWN = (Verdict.UNIDENTIFIABLE, Verdict.AT_LOWER, Verdict.AT_UPPER)


def plaster() -> Material:
    """The plaster of the demonstration, as a material with trends."""
    span = (0.0, HOURS)
    fixed = {"sigma_d": 0.35, "sigma_s": 0.16, "w": (0.85, 0.78, 0.66), "g": -0.2}
    brdf = parse(MODEL).model.with_parameters({"K_d": K_D_WET, "K_s": 0.6, "tau": 0.05, **fixed})
    trends = {
        "K_d": Trend("logistic", {"start": K_D_WET, "end": K_D_DRY, "middle": 2.0, "width": 0.4}, span),
        "K_s": Trend("exponential", {"start": 0.6, "end": 0.0, "time_constant": 1.0}, span),
        "tau": Trend("linear", {"start": 0.05, "end": 0.41}, span),
    }
    return Material(brdf, "plaster", ("R", "G", "B"), trends=trends)


def truths() -> dict[str, Material]:
    """What is simulated."""
    names = ("drying_paint", "drying_surface", "dust")
    return {name: PHENOMENA[name].example(HOURS) for name in names} | {"plaster": plaster()}


def true_trend(material: Material, name: str) -> Trend:
    """The trend of a parameter; a constant where it does not change."""
    if name in material.trends:
        return material.trends[name]
    return Trend("constant", {"value": material.brdf.parameters[name]}, (0.0, HOURS))


def study(phenomenon: str, seed: int, step: float) -> dict[str, Any]:
    """One folder, simulated, read and fitted: what came of each parameter."""
    material = truths()[phenomenon]
    with tempfile.TemporaryDirectory() as folder:
        simulate(Path(folder) / "s", material, scans=SCANS, hours=HOURS, noise=NOISE, seed=seed, rig=Rig(step_deg=step))
        data = motes.read(Path(folder) / "s")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        cpu = time.process_time()
        fit = motes.fit(data, describe(material.brdf))
        cpu = time.process_time() - cpu
    parameters = {}
    for name, found in fit.trends.items():
        truth = true_trend(material, name)
        values = truth(fit.hours).reshape(len(fit.hours), -1)
        band, error = found.band(fit.hours)
        seen = np.isfinite(found.scan_stderr)
        record: dict[str, Any] = {
            "known": found.verdict not in UNKNOWN,
            "verdict": found.verdict.name,
            "truth": truth.kind,
            "kind": found.trend.kind,
            "next": [(a.kind, float(a.delta_bic)) for a in found.alternatives[:3]],
            "joint": float(np.abs(band - values)[seen].mean()) if seen.any() else None,
            "single": float(np.abs(found.scan_values - values)[seen].mean()) if seen.any() else None,
            "inside": int((np.abs(band - values) <= 3 * error)[error > 0].sum()),
            "counted": int(np.count_nonzero(error > 0)),
            "scores": [],
        }
        if found.trend.kind == truth.kind and found.trend.covariance is not None:
            errors = np.sqrt(np.diag(found.trend.covariance))
            start = 0
            for coefficient in KINDS[truth.kind].coefficients:
                got = np.atleast_1d(found.trend.coefficients[coefficient.name])
                wanted = np.broadcast_to(truth.coefficients[coefficient.name], got.shape)
                for k in range(len(got)):
                    e = float(errors[start + k])
                    score = float((got[k] - wanted[k]) / e) if e > 0 else None
                    record["scores"].append((coefficient.name, k, score, float(got[k]), float(wanted[k]), e))
                start += len(got)
        parameters[name] = record
    return {
        "phenomenon": phenomenon,
        "seed": seed,
        "cpu_s": cpu,
        "status": fit.status.name,
        "outliers": [o.reason for o in fit.outliers],
        "parameters": parameters,
    }


def _share(part: int, whole: int) -> str:
    return f"{part}/{whole} ({100 * part / whole:.1f} %)" if whole else "-"


def table(runs: list[dict[str, Any]], step: float) -> str:
    """The results as Markdown."""
    seeds = len({r["seed"] for r in runs})
    lines = [
        f"{seeds} seeds, {SCANS} scans over {HOURS:g} h, {100 * NOISE:g} % noise, four cameras, the lamp in steps of {step:g} degrees "
        f"({4 * len(Rig(step_deg=step).wi)} directions), three channels; the true model given, the trends chosen.",
        "",
        "| phenomenon | parameter | true trend | determined | right trend | coefficients within 3 SE | values within 3 SE | error, joint over separate |",
        "|---|---|---|---|---|---|---|---|",
    ]
    total = np.zeros(6, int)
    ratios = []
    for phenomenon in dict.fromkeys(r["phenomenon"] for r in runs):
        own = [r["parameters"] for r in runs if r["phenomenon"] == phenomenon]
        for name in own[0]:
            records = [p[name] for p in own]
            known = [p for p in records if p["known"]]
            right = [p for p in known if p["kind"] == p["truth"]]
            scores = [s[2] for p in right for s in p["scores"] if s[2] is not None]
            counts = (
                len(right),
                len(known),
                sum(abs(s) <= 3 for s in scores),
                len(scores),
                sum(p["inside"] for p in known),
                sum(p["counted"] for p in known),
            )
            pairs = [(p["joint"], p["single"]) for p in known if p["single"]]
            ratio = float(np.divide(*np.mean(pairs, axis=0))) if pairs else float("nan")
            if len(known) >= len(records) / 2:
                total += counts
                ratios.append(ratio)
            lines.append(
                f"| {phenomenon} | {name} | {records[0]['truth']} | {_share(len(known), len(records))} | {_share(*counts[:2])} | {_share(*counts[2:4])} "
                f"| {_share(*counts[4:])} | {'-' if np.isnan(ratio) else f'{ratio:.2f}'} |"
            )
    lines += [
        f"| **all** | | | | **{_share(*total[:2])}** | **{_share(*total[2:4])}** | **{_share(*total[4:])}** | **{np.mean(ratios):.2f}** |",
        "",
        "*All* is over the parameters that at least half of the fits call determined. "
        f"CPU time of a fit: median {np.median([r['cpu_s'] for r in runs]):.1f} s, "
        f"longest {max(r['cpu_s'] for r in runs):.1f} s. "
        f"Scans left out as outliers: {sum(len(r['outliers']) for r in runs)} of {SCANS * len(runs)} "
        f"(none is one). Fits that did not converge: {sum(not r['status'].startswith(('CONV', 'SMALL', 'PERF')) for r in runs)} of {len(runs)}.",
        "",
    ]
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--seeds", type=int, default=30)
    parser.add_argument("--step", type=float, default=2.5, help="of the lamp [degrees]; the original rig's is 0.5")
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--only", choices=list(truths()), action="append")
    parser.add_argument("--raw", type=Path, help="write every run as JSON here")
    parser.add_argument("-o", "--output", type=Path, default=Path("docs/time_study.md"))
    options = parser.parse_args()
    jobs = [(name, seed) for seed in range(options.seeds) for name in options.only or truths()]
    runs = []
    with ProcessPoolExecutor(options.processes) as pool:
        futures = [pool.submit(study, name, seed, options.step) for name, seed in jobs]
        for done, future in enumerate(as_completed(futures), 1):
            runs.append(future.result())
            print(f"\r{done}/{len(jobs)}", end="", flush=True)
    print()
    runs.sort(key=lambda r: (list(truths()).index(r["phenomenon"]), r["seed"]))
    if options.raw:
        options.raw.write_text(json.dumps(runs, indent=1))
    text = table(runs, options.step)
    options.output.write_text("# Joint fits against a known truth\n\n" + text)
    print(text)


if __name__ == "__main__":
    main()
