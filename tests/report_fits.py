"""Fits made by hand from real evaluations and noise, so that the report's tests do not depend on the solver."""

from __future__ import annotations

from typing import Any

import numpy as np

from motes.directions import from_spherical
from motes.drawing.sphere import evaluate
from motes.fitting.error_bars import ErrorBars
from motes.fitting.result import Fit, FittedParameter, Trial
from motes.fitting.verdicts import Status, Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, describe


def goniometer(
    thetas_i: Any = (10, 30, 50, 70, 80), step: int = 15, azimuth_step: int = 15
) -> tuple[np.ndarray, np.ndarray]:
    """Pairs of directions on a regular set of angles [deg], the plane of incidence among them."""
    theta_i, theta_r, phi = np.meshgrid(
        thetas_i, np.arange(0, 90, step), np.arange(0, 181, azimuth_step), indexing="ij"
    )
    keep = (theta_r > 0) | (phi == 0)
    wi = from_spherical(np.deg2rad(theta_i[keep]), 0.0)
    wo = from_spherical(np.deg2rad(theta_r[keep]), np.deg2rad(phi[keep]))
    return wi, wo


def measured(truth: BRDF, wi: np.ndarray, wo: np.ndarray, noise: float = 0.01, **more: Any) -> Measurement:
    """A measurement of `truth` with relative noise."""
    f = evaluate(truth, wi, wo)
    f = f * (1 + noise * np.random.default_rng(7).standard_normal(f.shape))
    return Measurement.from_arrays(wi, wo, f, **more)


def as_fit(data: Measurement, brdf: BRDF, *, verdicts: dict[str, Verdict] | None = None, **changes: Any) -> Fit:
    """`brdf` as if it had been fitted to `data`, with the metrics that it really has."""
    mask, r = data.mask[0], np.nan_to_num(data.values[0])
    predicted = np.array(np.broadcast_to(evaluate(brdf, data.wi, data.wo), r.shape))
    cosine = np.broadcast_to(np.clip(data.wi[:, 2:3], 0, None), r.shape)

    def rms(x: np.ndarray) -> float:
        return float(np.sqrt(np.mean(x[mask] ** 2))) if mask.any() else float("nan")

    transforms = {
        "linear": lambda f: f * cosine,
        "plain": lambda f: f,
        "log": lambda f: np.log1p(np.maximum(f * cosine, -0.5)),
        "cube_root": lambda f: np.cbrt(f * cosine),
    }
    metrics = {f"rms_{name}": rms(t(predicted) - t(r)) for name, t in transforms.items()}
    signal = rms(r)
    metrics |= {
        "relative_rms": rms(predicted - r) / signal if signal > 0 else float("nan"),
        "bic": -100.0,
        "objective": 0.1,
    }
    parameters, labels = {}, []
    for slot in brdf.slots():
        value = slot.value
        n = np.atleast_1d(value).shape[-1]
        verdict = (verdicts or {}).get(slot.name, Verdict.IDENTIFIED)
        stderr = np.abs(np.asarray(value)) * 0.03 if verdict is Verdict.IDENTIFIED else np.asarray(value) * np.nan
        parameters[slot.name] = FittedParameter(
            name=slot.name,
            value=value,
            stderr=stderr if n > 1 else float(stderr),
            intervals={},
            verdicts=(verdict,) * n,
            symbol=slot.parameter.symbol,
            unit=slot.parameter.unit,
            doc=slot.parameter.doc,
            bounds=slot.parameter.fit_bounds,
        )
        labels += [slot.name] if n == 1 else [f"{slot.name}[{c}]" for c in data.channels[:n]]
    metrics |= {"n_samples": float(mask.sum()), "n_parameters": float(len(labels))}
    correlations = 0.9 ** np.abs(np.subtract.outer(np.arange(len(labels)), np.arange(len(labels))))
    wavelengths = () if data.wavelengths is None else tuple(float(w) for w in data.wavelengths)
    trial = Trial(
        model=describe(brdf),
        n_parameters=len(labels),
        bic=-100.0,
        relative_rms=metrics["relative_rms"],
        objective=0.1,
        status=Status.CONVERGED,
        chosen=True,
        n_samples=int(mask.sum()),
    )
    values: dict[str, Any] = {
        "material": Material(brdf, name=data.name, channels=data.channels, wavelengths=wavelengths),
        "parameters": parameters,
        "labels": tuple(labels),
        "correlations": correlations,
        "covariance": 1e-4 * correlations,
        "findings": (),
        "metrics": metrics,
        "status": Status.CONVERGED,
        "tried": (trial,),
        "measurement": data,
        "predicted": predicted,
        "loss": "linear",
        "robust": "none",
        "model_text": describe(brdf),
        "iterations": 12,
        "n_starts": 4,
        "seconds": 0.125,
        "errors": ErrorBars("independent", 0, "as asked for"),
    }
    return Fit(**(values | changes))
