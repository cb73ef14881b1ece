"""The 27 sets of NIST's Statistical Reference Datasets for nonlinear regression, as NIST hands them out.

Source: National Institute of Standards and Technology, https://www.itl.nist.gov/div898/strd/nls/nls_main.shtml (a work of
the US government, in the public domain); the files are those of `nist/`, unchanged.  Each holds data, two starting points
(the first is far away), and values and standard errors certified to 11 digits.  The formulas stand in the files as text;
here they are as functions, in parameters ``b`` (P arrays) and predictors ``x``.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.solver import Normal

FOLDER = Path(__file__).parent / "nist"

Formula = Callable[..., NDArray]


def _exponentials(x, b):
    return b[0] * np.exp(-b[1] * x) + b[2] * np.exp(-b[3] * x) + b[4] * np.exp(-b[5] * x)


def _gaussians(x, b):
    first, second = ((x - b[3]) / b[4]) ** 2, ((x - b[6]) / b[7]) ** 2
    return b[0] * np.exp(-b[1] * x) + b[2] * np.exp(-first) + b[5] * np.exp(-second)


def _saturation(x, b):
    return b[0] * (1 - np.exp(-b[1] * x))


def _decay(x, b):
    return np.exp(-b[0] * x) / (b[1] + b[2] * x)


def _cubics(x, b):
    return (b[0] + x * (b[1] + x * (b[2] + x * b[3]))) / (1 + x * (b[4] + x * (b[5] + x * b[6])))


def _cycles(x, b):
    angle = 2 * np.pi * x
    return (
        b[0]
        + b[1] * np.cos(angle / 12)
        + b[2] * np.sin(angle / 12)
        + b[4] * np.cos(angle / b[3])
        + b[5] * np.sin(angle / b[3])
        + b[7] * np.cos(angle / b[6])
        + b[8] * np.sin(angle / b[6])
    )


FORMULAS: dict[str, Formula] = {
    "Bennett5": lambda x, b: b[0] * (b[1] + x) ** (-1 / b[2]),
    "BoxBOD": _saturation,
    "Chwirut1": _decay,
    "Chwirut2": _decay,
    "DanWood": lambda x, b: b[0] * x ** b[1],
    "ENSO": _cycles,
    "Eckerle4": lambda x, b: b[0] / b[1] * np.exp(-0.5 * ((x - b[2]) / b[1]) ** 2),
    "Gauss1": _gaussians,
    "Gauss2": _gaussians,
    "Gauss3": _gaussians,
    "Hahn1": _cubics,
    "Kirby2": lambda x, b: (b[0] + x * (b[1] + x * b[2])) / (1 + x * (b[3] + x * b[4])),
    "Lanczos1": _exponentials,
    "Lanczos2": _exponentials,
    "Lanczos3": _exponentials,
    "MGH09": lambda x, b: b[0] * (x * x + x * b[1]) / (x * x + x * b[2] + b[3]),
    "MGH10": lambda x, b: b[0] * np.exp(b[1] / (x + b[2])),
    "MGH17": lambda x, b: b[0] + b[1] * np.exp(-x * b[3]) + b[2] * np.exp(-x * b[4]),
    "Misra1a": _saturation,
    "Misra1b": lambda x, b: b[0] * (1 - (1 + b[1] * x / 2) ** -2),
    "Misra1c": lambda x, b: b[0] * (1 - (1 + 2 * b[1] * x) ** -0.5),
    "Misra1d": lambda x, b: b[0] * b[1] * x / (1 + b[1] * x),
    "Nelson": lambda x, b: b[0] - b[1] * x[0] * np.exp(-b[2] * x[1]),
    "Rat42": lambda x, b: b[0] / (1 + np.exp(b[1] - b[2] * x)),
    "Rat43": lambda x, b: b[0] / (1 + np.exp(b[1] - b[2] * x)) ** (1 / b[3]),
    "Roszman1": lambda x, b: b[0] - b[1] * x - np.arctan(b[2] / (x - b[3])) / np.pi,
    "Thurber": _cubics,
}


class Dataset(NamedTuple):
    """How hard NIST finds it; ``formula(x, b)``; starts (2, P); certified values and standard errors (P,) and sum of squares; y (N,), x (N,) or (2, N)."""

    difficulty: str
    formula: Formula
    starts: NDArray
    values: NDArray
    errors: NDArray
    squares: float
    y: NDArray
    x: NDArray


def read(name: str) -> Dataset:
    """One of NIST's files."""
    text = (FOLDER / f"{name}.dat").read_text()
    rows = re.findall(r"^ *b\d+ *=(.*)$", text, re.MULTILINE)
    table = np.array([row.split() for row in rows], float)
    assert len(table) == int(re.search(r"(\d+) Parameters", text)[1])
    squares = float(re.search(r"Residual Sum of Squares: *(\S+)", text)[1])
    # The last heading "Data:" is that of the numbers.
    heading, *lines = text[text.rindex("Data:") :].strip().splitlines()
    data = np.array([line.split() for line in lines if line.strip()], float).T
    assert data.shape == (len(heading.split()) - 1, int(re.search(r"(\d+) Observations", text)[1]))
    y = np.log(data[0]) if name == "Nelson" else data[0]  # whose model is of the logarithm
    difficulty = re.search(r"(\w+) Level of Difficulty", text)[1].lower()
    return Dataset(
        difficulty, FORMULAS[name], table[:, :2].T, table[:, 2], table[:, 3], squares, y, np.squeeze(data[1:])
    )


def jacobian(formula: Formula, x: NDArray, y: NDArray, points: NDArray) -> tuple[NDArray, NDArray]:
    """Residuals (B, N) and their derivatives (B, N, P) at points (B, P), by complex steps: exact to rounding."""

    def values(p):
        return formula(x, [p[:, k, None] for k in range(p.shape[1])])

    residual = values(points) - y
    slopes = np.empty((*residual.shape, points.shape[1]))
    for k in range(points.shape[1]):
        moved = points.astype(complex)
        moved[:, k] += 1e-30j
        slopes[..., k] = values(moved).imag / 1e-30
    return residual, slopes


def normal_equations(formula: Formula, x: NDArray, y: NDArray) -> Callable[[NDArray], Normal]:
    """What `motes.fitting.solver.minimize` asks for."""

    def normal(points):
        residual, slopes = jacobian(formula, x, y, points)
        return Normal(
            0.5 * np.sum(residual**2, axis=1),
            np.einsum("bn,bnk->bk", residual, slopes),
            np.einsum("bnk,bnl->bkl", slopes, slopes),
        )

    return normal


SETS = {name: read(name) for name in FORMULAS}
