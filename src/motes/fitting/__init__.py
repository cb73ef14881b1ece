"""Fitting models to measurements."""

from motes.fitting.choice import CANDIDATES
from motes.fitting.front import fit
from motes.fitting.result import Fit, FittedParameter, Trial
from motes.fitting.verdicts import Status, Verdict

__all__ = ["CANDIDATES", "Fit", "FittedParameter", "Status", "Trial", "Verdict", "fit"]
