"""Fitting models to measurements."""

from motes.fitting.result import Fit, FittedParameter, Status, Trial, Verdict
from motes.fitting.static import CANDIDATES, fit

__all__ = ["CANDIDATES", "Fit", "FittedParameter", "Status", "Trial", "Verdict", "fit"]
