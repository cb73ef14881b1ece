"""Reference values of equations (1)-(13), and the arguments at which they hold; see README.md beside this file."""

from __future__ import annotations

import csv
import functools
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from numpy.typing import NDArray

HERE = Path(__file__).parent
WHOLE = HERE.parents[2] / "shared" / "golden"  # the whole tables, where this checkout has them beside it
SOURCES = ("copied", "whole")

Rows = dict[str, NDArray[np.float64]]


def _read(source: str, name: str) -> dict[str, list[str]]:
    path = (HERE if source == "copied" else WHOLE) / name
    if not path.exists():
        pytest.skip(f"../{path.relative_to(HERE.parents[2])} is missing")
    with path.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


@functools.cache
def appendices(source: str = "copied") -> Rows:
    """The columns of appendices.csv, the directions ``wi, wo`` (N, 3), and the arguments of the equations.

    The arguments are computed from the angles in 40-digit arithmetic and rounded once, so that an equation that is given them is
    not blamed for an ill-conditioned function that came before it: cos(phi_r - phi_i) near 0, 1 - cos(gamma) near gamma = 0.
    """
    columns = {name: np.array(text, np.float64) for name, text in _read(source, "appendices.csv").items()}
    with mp.workdps(40):
        arguments = [_arguments(*angles) for angles in zip(*(columns[k] for k in _ANGLES), strict=True)]
    columns |= {name: np.array([a[name] for a in arguments], np.float64) for name in arguments[0]}
    for w, letter in (("wi", "i"), ("wo", "r")):
        theta, phi = columns[f"theta_{letter}"], columns[f"phi_{letter}"]
        columns[w] = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    columns["F"], columns["n"] = np.ones_like(columns["w"]), 1.2 + columns["w"]
    return columns


_ANGLES = ("theta_r", "theta_i", "phi_r", "phi_i", "theta_h")


def _arguments(*angles: float) -> dict[str, float]:
    theta_r, theta_i, phi_r, phi_i, theta_h = (mp.mpf(float(angle)) for angle in angles)
    alpha, beta, cos_dphi = max(theta_r, theta_i), min(theta_r, theta_i), mp.cos(phi_r - phi_i)
    wi_dot_wo = mp.sin(theta_i) * mp.sin(theta_r) * cos_dphi + mp.cos(theta_i) * mp.cos(theta_r)
    exact = {
        "alpha": alpha,
        "beta": beta,
        "cos_dphi": cos_dphi,
        "one_less_abs_cos_dphi": 1 - abs(cos_dphi),
        "sin_alpha": mp.sin(alpha),
        "sin_alpha_less_cube": mp.sin(alpha) - (2 * beta / mp.pi) ** 3,
        "tan_beta": mp.tan(beta),
        "tan_half": mp.tan((alpha + beta) / 2),
        "cos_theta_i": mp.cos(theta_i),
        "cos_theta_r": mp.cos(theta_r),
        "cos_theta_h": mp.cos(theta_h),
        "sin2_half_gamma": (1 + wi_dot_wo) / 2,
        "cos2_half_gamma": (1 - wi_dot_wo) / 2,
        "cos_theta_d": mp.sqrt((1 + wi_dot_wo) / 2),
    }
    return {name: float(value) for name, value in exact.items()}


def scatmech(source: str, model: str) -> Rows:
    """The rows of scatmech.csv for ``torrance_sparrow`` or ``dust``: ``parameter``, ``value``, and the directions ``wi, wo`` (N, 3)."""
    text = _read(source, "scatmech.csv")
    chosen = [k for k, name in enumerate(text.pop("model")) if name == model]
    columns = {name: np.array([values[k] for k in chosen], np.float64) for name, values in text.items()}
    zero = np.zeros_like(columns["dphi"])
    for w, theta, phi in (("wi", columns["theta_i"], zero), ("wo", columns["theta_r"], columns["dphi"])):
        columns[w] = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    return columns


def extended() -> Rows:
    """The columns of extended.csv and the directions ``wi, wo`` (N, 3); the table is beside the checkout, or the test is skipped."""
    columns = {name: np.array(text, np.float64) for name, text in _read("whole", "extended.csv").items()}
    zero = np.zeros_like(columns["dphi"])
    for w, theta, phi in (("wi", columns["theta_i"], zero), ("wo", columns["theta_r"], columns["dphi"])):
        columns[w] = np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1)
    return columns
