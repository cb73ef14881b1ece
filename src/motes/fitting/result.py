"""The family of results: what a fit returns: the material, error bars, residuals, and the reasons."""

from __future__ import annotations

import math
import os
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any, ClassVar, Self, final

import numpy as np
from numpy.typing import NDArray

from motes import outlets
from motes.arrays import Array
from motes.files import together, write_csv, write_json
from motes.fitting.error_bars import ErrorBars
from motes.fitting.formatting import MOST_CORRELATED, correlations_as_json, finite, with_error
from motes.fitting.origin_of_fit import Origin
from motes.fitting.shown import data_frame, notebook
from motes.fitting.verdicts import Status, Verdict
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF


@final
@dataclass(frozen=True)
class FittedParameter:
    """One parameter after a fit.

    ``value``, ``stderr`` and ``verdicts`` have an entry for each channel where the parameter was fitted per channel:
    arrays (C,) and a tuple of C; else a float, a float and a tuple of one.  ``stderr`` is one standard error, NaN where the data
    do not determine the parameter, where it sits at a bound, or where it was fixed.  ``intervals`` are the ends (2,) or (C, 2) of
    the intervals of 68 and 95 %, by ``"68"`` and ``"95"``: wider than one and two errors where little stands behind these."""

    name: str
    value: Array
    stderr: Array
    intervals: dict[str, NDArray[np.float64]]
    verdicts: tuple[Verdict, ...]
    symbol: str
    unit: str
    doc: str
    bounds: tuple[float, float]

    @property
    def verdict(self) -> Verdict:
        """The worst verdict over the channels."""
        order = list(Verdict)
        if Verdict.FIXED in self.verdicts:
            return Verdict.FIXED
        for verdict in (Verdict.UNIDENTIFIABLE, Verdict.AT_UPPER, Verdict.AT_LOWER, Verdict.WEAK):
            if verdict in self.verdicts:
                return verdict
        return order[0]


@final
@dataclass(frozen=True)
class Trial:
    """A model that was tried, as ``model="auto"`` compares them.

    ``left_out`` is the relative RMS of what the loss weighs, over blocks of directions that were left out and predicted by a fit to
    the others; NaN where none were. `motes.fitting.judgement` says what is chosen by it; maps choose by the ``bic``.  ``n_samples`` is
    smaller than the data's where large data were compared on an even part of them.  ``per_channel`` names what was fitted for each
    channel that is shared otherwise.
    """

    model: str
    n_parameters: int
    bic: float
    relative_rms: float
    objective: float
    status: Status
    chosen: bool
    n_samples: int
    left_out: float = math.nan
    per_channel: tuple[str, ...] = ()


#: Called with (done, total, what).
Progress = Callable[[int, int, str], None]


@dataclass(frozen=True)
class Result(ABC):
    """What every fit of a measurement returns.

    Parameters
    ----------
    material
        The fitted material.
    metrics
        ``relative_rms`` = RMS(f - r)/RMS(r), unweighted, over unmasked samples; ``rms_plain``, ``rms_linear``,
        ``rms_log``, ``rms_cube_root``: root mean squares of the residuals of each loss; ``objective`` (half the
        weighted sum of squares that was minimised), ``bic``, ``n_samples``, ``n_parameters``.
    status
        Why it stopped.
    tried
        The models compared.
    findings
        Sentences on what is odd about the data or the fit, and on what the data do not show or determine.  Of one time they are looked for
        when they are first read.
    measurement
        The data.
    predicted
        The fitted BRDF at the measured directions [1/sr].
    loss, robust
        What was minimised.
    model_text
        The model as text.
    iterations, seconds
        The effort.
    errors
        What the error bars take as independent, and why.
    dusty
        Whether a layer of dust lies on it: True, False, or None where the data cannot tell, or nothing was compared with one.
    origin
        What is needed to make it again; None where it was put together from other results.
    """

    material: Material
    metrics: dict[str, float]
    status: Status
    tried: tuple[Trial, ...]
    findings: Sequence[str]
    measurement: Measurement
    predicted: NDArray[np.float64]
    loss: str
    robust: str
    model_text: str
    iterations: int
    seconds: float
    errors: ErrorBars
    dusty: bool | None = field(default=None, kw_only=True)
    origin: Origin | None = field(default=None, kw_only=True)

    #: What `motes.outlets` calls results of this kind, and the ``format`` of their JSON.
    kind: ClassVar[str]
    format: ClassVar[str]

    def to_dict(self) -> dict[str, Any]:
        """Everything but the arrays over directions, as plain JSON values (NaN becomes None)."""
        about = {
            "format": self.format,
            "version": 1,
            "model": self.model_text,
            "loss": self.loss,
            "robust": self.robust,
            "status": str(self.status),
            "converged": self.status.ok,
            "errors": self.errors.to_dict(),
            "dusty": self.dusty,
        }
        after = {
            "findings": list(self.findings),
            "metrics": finite(self.metrics),
            "tried": [finite(asdict(trial) | {"status": str(trial.status)}) for trial in self.tried],
            "measurement": finite(self.measurement.summary()),
            "masked": dict(self.measurement.masked),
            "iterations": self.iterations,
            "seconds": round(self.seconds, 3),
            "origin": self.origin.to_dict() if self.origin else None,
        }
        return about | self.details() | after

    @abstractmethod
    def details(self) -> dict[str, Any]:
        """What `to_dict` says of this kind of fit alone."""

    @abstractmethod
    def table(self) -> list[dict[str, str]]:
        """The parameters as rows of text; digits follow the error."""

    @abstractmethod
    def csv_rows(self) -> Iterator[list[str]]:
        """The rows of ``parameters.csv``, the headings first."""

    @abstractmethod
    def records(self) -> list[dict[str, Any]]:
        """The parameters as rows of numbers, NaN where there is none."""

    def to_dataframe(self) -> Any:
        """`records` as a data frame of pandas; see `motes.fitting.shown.data_frame`."""
        return data_frame(self.records())

    def made_by(self, command: str) -> Self:
        """The same result, which says the command line that made it."""
        return replace(self, origin=replace(self.origin, command=command)) if self.origin else self

    def __repr__(self) -> str:
        rms = 100 * self.metrics["relative_rms"]
        status = "" if self.status.ok else ", not converged"
        return f"<{type(self).__name__} of {self.model_text} to {self.measurement.name!r}: relative RMS {rms:.3g} %{status}>"

    def _repr_html_(self) -> str:
        facts = [
            ("relative RMS", f"{100 * self.metrics['relative_rms']:.3g} %"),
            ("errors", str(self.errors)),
            ("status", str(self.status)),
            *(("finding", text) for text in self.findings),
        ]
        return notebook(f"{self.model_text}, fitted to {self.measurement.name}", self.table(), facts)

    @property
    def source(self) -> str:
        """Where the data say that they come from, such as ``"simulated by Motes"``; empty where they do not."""
        return str(self.measurement.provenance.get("source") or "")

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Write ``material.json``, ``fit.json`` and ``parameters.csv`` into `folder`, all of them or none; returns it."""
        with together(Path(folder)) as staging:
            self.material.save(staging / "material.json")
            write_json(staging / "fit.json", self.to_dict())
            write_csv(staging / "parameters.csv", self.csv_rows())
        return Path(folder)

    def report(self, path: str | os.PathLike[str]) -> Path:
        """Write a self-contained HTML report, or with a path ``NAME.pdf`` the same on paper; returns its path."""
        return outlets.report(self.kind, self, path)


@final
@dataclass(frozen=True, repr=False)
class Fit(Result):
    """The result of `motes.fit` for one time; see `Result` for what it shares with others.

    Parameters
    ----------
    parameters
        By name, in the order of the model.
    labels, correlations, covariance
        Names of the free quantities (``K_d[R]``, ``sigma_d``, ...), their correlation and covariance matrices (P, P); NaN
        rows where undetermined.
    n_starts
        From how many points the fit started.
    """

    parameters: dict[str, FittedParameter]
    labels: tuple[str, ...]
    correlations: NDArray[np.float64]
    covariance: NDArray[np.float64]
    n_starts: int

    kind: ClassVar[str] = "fit"
    format: ClassVar[str] = "motes fit"

    @property
    def brdf(self) -> BRDF:
        """The fitted BRDF."""
        return self.material.brdf

    @property
    def residuals(self) -> NDArray[np.float64]:
        """Fitted less measured (N, C) [1/sr]; NaN where masked."""
        difference = self.predicted - self.measurement.values[0]
        return np.where(self.measurement.mask[0], difference, np.nan)

    def details(self) -> dict[str, Any]:
        return {
            "parameters": {
                p.name: {
                    "value": finite(p.value),
                    "stderr": finite(p.stderr),
                    "intervals": finite(p.intervals),
                    "unit": p.unit,
                    "bounds": finite(list(p.bounds)),
                    "verdicts": [str(v) for v in p.verdicts],
                    "meaning": p.doc,
                }
                for p in self.parameters.values()
            },
            "labels": list(self.labels),
            **correlations_as_json(self.labels, self.correlations),
            "covariance": finite(self.covariance) if len(self.labels) <= MOST_CORRELATED else None,
            "n_starts": self.n_starts,
        }

    def table(self) -> list[dict[str, str]]:
        """The parameters as rows of text: name, channel, value, stderr, unit, verdict; digits follow the error."""
        rows = []
        for p, _, channel, value, stderr, verdict in self._cells():
            text, error = with_error(value, stderr)
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

    def records(self) -> list[dict[str, Any]]:
        """A row for each parameter and channel: ``parameter``, ``channel``, ``value``, ``stderr``, the ends of the intervals, ``unit``, ``verdict``."""
        rows = []
        for p, k, channel, value, stderr, verdict in self._cells():
            ends = {level: np.atleast_2d(both)[k] for level, both in p.intervals.items()}
            rows.append(
                {
                    "parameter": p.name,
                    "channel": channel,
                    "value": value,
                    "stderr": stderr,
                    **{f"{side}_{n}": float(e[i]) for n, e in ends.items() for i, side in enumerate(("low", "high"))},
                    "unit": p.unit,
                    "verdict": str(verdict).partition(":")[0],
                }
            )
        return rows

    def csv_rows(self) -> Iterator[list[str]]:
        yield ["parameter", "channel", "value", "stderr", "unit", "verdict", "source"]
        for p, _, channel, value, stderr, verdict in self._cells():
            yield [p.name, channel, repr(value), repr(stderr), p.unit, str(verdict), self.source]

    def _cells(self) -> Iterator[tuple[FittedParameter, int, str, float, float, Verdict]]:
        """Each parameter for each channel: its position and name (empty where all share the parameter), value, error and verdict."""
        for p in self.parameters.values():
            values, errors = np.atleast_1d(p.value), np.atleast_1d(p.stderr)
            for k, (value, stderr, verdict) in enumerate(zip(values, errors, p.verdicts, strict=True)):
                channel = self.material.channels[k] if np.size(p.value) > 1 else ""
                yield p, k, channel, float(value), float(stderr), verdict
