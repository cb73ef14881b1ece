"""A fit as text: rows for people, JSON and CSV for machines."""

from __future__ import annotations

import csv
import json
import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from motes.errors import MotesError
from motes.files import replacing, write_text

if TYPE_CHECKING:
    from motes.fitting.over_time import TimeFit
    from motes.fitting.result import Fit


def _finite(x: Any) -> Any:
    """JSON has no NaN: None instead."""
    if isinstance(x, float):
        return x if math.isfinite(x) else None
    if isinstance(x, np.ndarray):
        return _finite(x.tolist())
    if isinstance(x, np.generic):
        return _finite(x.item())
    if isinstance(x, (list, tuple)):
        return [_finite(v) for v in x]
    if isinstance(x, dict):
        return {str(k): _finite(v) for k, v in x.items()}
    return x


def with_error(value: float, stderr: float) -> tuple[str, str]:
    """Value and standard error as text, the error to two digits and the value to the same place."""
    if not math.isfinite(stderr) or stderr <= 0:
        return f"{value:.4g}", ""
    places = max(0, 1 - math.floor(math.log10(stderr)))
    if places > 8 or abs(value) >= 1e6:
        return f"{value:.6g}", f"{stderr:.2g}"
    return f"{value:.{places}f}", f"{stderr:.{places}f}"


def parameter_rows(fit: Fit) -> list[dict[str, str]]:
    """One row for each parameter and channel."""
    rows = []
    for p in fit.parameters.values():
        values, errors = np.atleast_1d(p.value), np.atleast_1d(p.stderr)
        for k, (value, stderr, verdict) in enumerate(zip(values, errors, p.verdicts, strict=True)):
            text, error = with_error(float(value), float(stderr))
            channel = fit.material.channels[k] if len(values) > 1 else ""
            rows.append(
                {
                    "name": p.name,
                    "channel": channel,
                    "value": text,
                    "stderr": error,
                    "unit": p.unit,
                    "verdict": str(verdict),
                    "meaning": p.doc,
                }
            )
    return rows


def fit_to_dict(fit: Fit) -> dict[str, Any]:
    """Plain JSON values."""
    m = fit.measurement
    return {
        "format": "motes fit",
        "version": 1,
        "model": fit.model_text,
        "loss": fit.loss,
        "robust": fit.robust,
        "status": str(fit.status),
        "converged": fit.status.ok,
        "parameters": {
            p.name: {
                "value": _finite(p.value),
                "stderr": _finite(p.stderr),
                "unit": p.unit,
                "bounds": _finite(list(p.bounds)),
                "verdicts": [str(v) for v in p.verdicts],
                "meaning": p.doc,
            }
            for p in fit.parameters.values()
        },
        "labels": list(fit.labels),
        "correlations": _finite(fit.correlations),
        "metrics": _finite(fit.metrics),
        "tried": [
            {
                "model": t.model,
                "n_parameters": t.n_parameters,
                "bic": _finite(t.bic),
                "relative_rms": _finite(t.relative_rms),
                "objective": _finite(t.objective),
                "status": str(t.status),
                "chosen": t.chosen,
                "n_samples": t.n_samples,
            }
            for t in fit.tried
        ],
        "measurement": _finite(m.summary()),
        "masked": dict(m.masked),
        "iterations": fit.iterations,
        "n_starts": fit.n_starts,
        "seconds": round(fit.seconds, 3),
    }


def save_fit(fit: Fit, folder: str | os.PathLike[str]) -> Path:
    """Write ``material.json``, ``fit.json`` and ``parameters.csv``."""
    target = Path(folder)
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MotesError(
            f"{target} cannot be made: {error.strerror or error}", "Choose another folder with -o"
        ) from error
    fit.material.save(target / "material.json")
    write_text(target / "fit.json", json.dumps(fit_to_dict(fit), indent=1, allow_nan=False) + "\n")
    with replacing(target / "parameters.csv") as temporary, temporary.open("w", newline="", encoding="utf-8") as handle:
        writer = csv.writer(handle)
        writer.writerow(["parameter", "channel", "value", "stderr", "unit", "verdict"])
        for p in fit.parameters.values():
            values, errors = np.atleast_1d(p.value), np.atleast_1d(p.stderr)
            for k, (value, stderr, verdict) in enumerate(zip(values, errors, p.verdicts, strict=True)):
                channel = fit.material.channels[k] if len(values) > 1 else ""
                writer.writerow([p.name, channel, repr(float(value)), repr(float(stderr)), p.unit, str(verdict)])
    return target


# ---------------------------------------------------------------- over time


def trend_rows(fit: TimeFit) -> list[dict[str, str]]:
    """One row for each parameter and channel: kind of trend, value at the first and the last scan, verdict."""
    ends = fit.hours[[0, -1]]
    rows = []
    for t in fit.trends.values():
        values, errors = t.band(ends)
        for k in range(values.shape[1]):
            texts = [
                " ± ".join(part for part in with_error(float(v), float(e)) if part)
                for v, e in zip(values[:, k], errors[:, k], strict=True)
            ]
            channel = fit.material.channels[k] if values.shape[1] > 1 else ""
            rows.append(
                {
                    "name": t.name,
                    "channel": channel,
                    "trend": t.trend.kind,
                    "first": texts[0],
                    "last": texts[1],
                    "unit": t.unit,
                    "verdict": str(t.verdict),
                    "meaning": t.doc,
                }
            )
    return rows


def time_fit_to_dict(fit: TimeFit) -> dict[str, Any]:
    """Plain JSON values."""
    values = {name: t.band(fit.hours) for name, t in fit.trends.items()}
    return {
        "format": "motes time fit",
        "version": 1,
        "model": fit.model_text,
        "loss": fit.loss,
        "robust": fit.robust,
        "status": str(fit.status),
        "converged": fit.status.ok,
        "hours": _finite(fit.hours),
        "findings": list(fit.findings),
        "outliers": [{"scan": o.index, "hours": o.hours, "reason": o.reason} for o in fit.outliers],
        "trends": {
            name: {
                **_finite(t.trend.to_dict()),
                "verdict": str(t.verdict),
                "unit": t.unit,
                "meaning": t.doc,
                "values": _finite(values[name][0]),
                "stderr": _finite(values[name][1]),
                "scan_values": _finite(t.scan_values),
                "scan_stderr": _finite(t.scan_stderr),
                "alternatives": [{"kind": a.kind, "delta_bic": _finite(float(a.delta_bic))} for a in t.alternatives],
            }
            for name, t in fit.trends.items()
        },
        "metrics": _finite(fit.metrics),
        "tried": [
            {
                "model": t.model,
                "n_parameters": t.n_parameters,
                "bic": _finite(t.bic),
                "relative_rms": _finite(t.relative_rms),
                "objective": _finite(t.objective),
                "status": str(t.status),
                "chosen": t.chosen,
                "n_samples": t.n_samples,
            }
            for t in fit.tried
        ],
        "measurement": _finite(fit.measurement.summary()),
        "masked": dict(fit.measurement.masked),
        "iterations": fit.iterations,
        "seconds": round(fit.seconds, 3),
    }


def save_time_fit(fit: TimeFit, folder: str | os.PathLike[str]) -> Path:
    """Write ``material.json``, ``fit.json`` and ``parameters.csv``."""
    target = Path(folder)
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise MotesError(
            f"{target} cannot be made: {error.strerror or error}", "Choose another folder with -o"
        ) from error
    fit.material.save(target / "material.json")
    write_text(target / "fit.json", json.dumps(time_fit_to_dict(fit), indent=1, allow_nan=False) + "\n")
    with replacing(target / "parameters.csv") as temporary, temporary.open("w", newline="", encoding="utf-8") as handle:
        writer = csv.writer(handle)
        writer.writerow(
            ["parameter", "channel", "hours", "value", "stderr", "scan_value", "scan_stderr", "trend", "verdict"]
        )
        for t in fit.trends.values():
            values, errors = t.band(fit.hours)
            scans = {int(s): k for k, s in enumerate(np.flatnonzero(fit.measurement.mask.any(axis=(1, 2))))}
            for k in range(values.shape[1]):
                channel = fit.material.channels[k] if values.shape[1] > 1 else ""
                for i, hour in enumerate(fit.hours):
                    own = (t.scan_values[scans[i], k], t.scan_stderr[scans[i], k]) if i in scans else (np.nan, np.nan)
                    numbers = [repr(float(v)) for v in (hour, values[i, k], errors[i, k], *own)]
                    writer.writerow([t.name, channel, *numbers, t.trend.kind, str(t.verdict)])
    return target
