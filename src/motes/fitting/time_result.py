"""What a fit of several times returns: trends with bands, outliers, and what the data do not show."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, final

import numpy as np
from numpy.typing import ArrayLike

from motes.fitting.formatting import finite, with_error
from motes.fitting.losses import Floats
from motes.fitting.result import Result
from motes.fitting.verdicts import Verdict
from motes.models import BRDF
from motes.trends import Trend


@dataclass(frozen=True)
class Alternative:
    """Another kind of trend for one parameter: how much worse its BIC is (over the part's inflation), and the trend."""

    kind: str
    delta_bic: float
    trend: Trend


@final
@dataclass(frozen=True)
class ScanOutlier:
    """A scan left out of the trends: its position, its time [h], and why."""

    index: int
    hours: float
    reason: str


@final
@dataclass(frozen=True, repr=False)
class TrendFit:
    """The trend of one parameter.

    Parameters
    ----------
    trend
        With the covariance of its coefficients.
    verdict
        What the data say about the parameter over the whole time.
    alternatives
        The kinds compared, the best first, with their distance in BIC.
    scan_values, scan_stderr
        What each scan says on its own (T, W), W = 1 or the number of channels; NaN errors where a scan does not determine it.
    """

    name: str
    trend: Trend
    verdict: Verdict
    alternatives: tuple[Alternative, ...]
    scan_values: Floats
    scan_stderr: Floats
    symbol: str
    unit: str
    doc: str

    def __repr__(self) -> str:
        return f"<TrendFit of {self.name}: {self.trend.kind}, {str(self.verdict).partition(':')[0]}>"

    def band(self, hours: ArrayLike) -> tuple[Floats, Floats]:
        """Value and one standard error (T, W) at times [h].

        The error holds that of the coefficients, and how far the other kinds of trend that the data allow lie from the chosen one, by their weight
        exp(-delta BIC / 2): so that it opens where the data end.
        """
        t = np.atleast_1d(np.asarray(hours, float))
        value = self.trend(t).reshape(len(t), -1)
        own = np.nan_to_num(self.trend.stderr(t).reshape(len(t), -1))
        weights = np.exp(-0.5 * np.array([min(max(a.delta_bic, 0.0), 700.0) for a in self.alternatives]))
        weights /= weights.sum()
        between = sum(
            w * (a.trend(t).reshape(len(t), -1) - value) ** 2 for w, a in zip(weights, self.alternatives, strict=True)
        )
        return value, np.sqrt(own**2 + between)


@final
@dataclass(frozen=True, repr=False)
class TimeFit(Result):
    """The result of fitting a measurement with several times; see `Result` for what it shares with others.

    ``material`` has trends (``fit.material.at(hours)`` is a BRDF), ``predicted`` is (T, N, C), and ``metrics`` hold
    ``n_coefficients`` as well.

    Parameters
    ----------
    trends
        By parameter name, in the order of the model.
    hours
        The times of the scans (T,).
    outliers
        Scans that were left out.
    """

    trends: dict[str, TrendFit]
    hours: Floats
    outliers: tuple[ScanOutlier, ...]

    kind: ClassVar[str] = "fit over time"
    format: ClassVar[str] = "motes time fit"

    @property
    def brdf(self) -> BRDF:
        """The BRDF at the first scan."""
        return self.material.at(float(self.hours[0]))

    def details(self) -> dict[str, Any]:
        values = {name: t.band(self.hours) for name, t in self.trends.items()}
        return {
            "hours": finite(self.hours),
            "outliers": [{"scan": o.index, "hours": o.hours, "reason": o.reason} for o in self.outliers],
            "trends": {
                name: {
                    **finite(t.trend.to_dict()),
                    "verdict": str(t.verdict),
                    "unit": t.unit,
                    "meaning": t.doc,
                    "values": finite(values[name][0]),
                    "stderr": finite(values[name][1]),
                    "scan_values": finite(t.scan_values),
                    "scan_stderr": finite(t.scan_stderr),
                    "alternatives": [{"kind": a.kind, "delta_bic": finite(float(a.delta_bic))} for a in t.alternatives],
                }
                for name, t in self.trends.items()
            },
        }

    def table(self) -> list[dict[str, str]]:
        """The trends as rows of text: name, channel, kind, value at the first and the last scan, unit, verdict."""
        rows = []
        for t in self.trends.values():
            values, errors = t.band(self.hours[[0, -1]])
            for k in range(values.shape[1]):
                texts = [
                    " ± ".join(part for part in with_error(float(v), float(e)) if part)
                    for v, e in zip(values[:, k], errors[:, k], strict=True)
                ]
                rows.append(
                    {
                        "name": t.name,
                        "channel": self._channel(k, values),
                        "trend": t.trend.kind,
                        "first": texts[0],
                        "last": texts[1],
                        "unit": t.unit,
                        "verdict": str(t.verdict),
                        "meaning": t.doc,
                    }
                )
        return rows

    def records(self) -> list[dict[str, Any]]:
        """A row for each parameter, channel and scan: ``parameter``, ``channel``, ``hours``, ``value``, ``stderr``, ``trend``, ``unit``, ``verdict``."""
        rows = []
        for t in self.trends.values():
            values, errors = t.band(self.hours)
            for k, (value, stderr) in enumerate(zip(values.T, errors.T, strict=True)):
                about = {"parameter": t.name, "channel": self._channel(k, values)}
                kind = {"trend": t.trend.kind, "unit": t.unit, "verdict": str(t.verdict).partition(":")[0]}
                rows += [
                    {**about, "hours": float(h), "value": float(v), "stderr": float(e), **kind}
                    for h, v, e in zip(self.hours, value, stderr, strict=True)
                ]
        return rows

    def csv_rows(self) -> Iterator[list[str]]:
        yield [
            "parameter",
            "channel",
            "hours",
            "value",
            "stderr",
            "scan_value",
            "scan_stderr",
            "trend",
            "verdict",
            "source",
        ]
        scans = {int(s): k for k, s in enumerate(np.flatnonzero(self.measurement.mask.any(axis=(1, 2))))}
        for t in self.trends.values():
            values, errors = t.band(self.hours)
            for k in range(values.shape[1]):
                for i, hour in enumerate(self.hours):
                    own = (t.scan_values[scans[i], k], t.scan_stderr[scans[i], k]) if i in scans else (np.nan, np.nan)
                    numbers = [repr(float(v)) for v in (hour, values[i, k], errors[i, k], *own)]
                    yield [t.name, self._channel(k, values), *numbers, t.trend.kind, str(t.verdict), self.source]

    def _channel(self, k: int, values: Floats) -> str:
        return self.material.channels[k] if values.shape[1] > 1 else ""
