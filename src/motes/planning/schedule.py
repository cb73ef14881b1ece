"""`plan_times`: when to scan something that changes, so that the trends of its parameters come out best."""

from __future__ import annotations

import math
import os
import time as clock
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple, final

import numpy as np
from numpy.typing import NDArray

from motes.directions import above
from motes.errors import DataError, MotesError
from motes.files import write_csv, write_json, write_text
from motes.fitting.formatting import finite
from motes.material import Material
from motes.measurements import Measurement
from motes.models import describe
from motes.planning.believed import AROUND
from motes.planning.criteria import Criterion, Term
from motes.planning.information import Noise, Subject, information
from motes.planning.offers import Offer
from motes.planning.rigs import offered
from motes.planning.seen_over_time import Course, drawn
from motes.planning.swapping import chosen
from motes.presets import named
from motes.trends import KINDS, Trend

Floats = NDArray[np.float64]
#: Moments to choose from, evenly spaced; and trends drawn around the one that is believed, for each channel.
MOMENTS, DRAWS = 121, 6
#: Directions of a scan that stand for all of them: which they are matters little for when to scan.
MOST_DIRECTIONS = 60


class _Coefficient(NamedTuple):
    """A number of a trend: whose it is, what it is called, and by how much it may differ."""

    parameter: str
    name: str
    span: float


@final
@dataclass(frozen=True, eq=False)
class Schedule:
    """When to scan: what `motes.plan_times` returns.

    Attributes
    ----------
    hours
        The moments [h], increasing.
    even
        As many, evenly spaced.
    stderr, even_stderr
        For each coefficient, as ``parameter.coefficient``, the median over materials of its standard error with these moments and with the
        even ones; infinite where they do not determine it.
    to_even
        How many times as large the errors are as those of the even moments: geometric mean over coefficients that both determine.
    courses
        How each parameter that changes is believed to go, and its standard error at each moment.
    """

    material: str
    model: str
    goal: str
    hours: Floats
    even: Floats
    scanned: Floats
    stderr: dict[str, float]
    even_stderr: dict[str, float]
    to_even: float
    findings: tuple[str, ...]
    took: float
    courses: tuple[Course, ...]

    def to_dict(self) -> dict[str, Any]:
        """All of it as plain JSON values."""
        made: dict[str, Any] = {
            "format": "motes schedule",
            "version": 1,
            "material": self.material,
            "model": self.model,
            "goal": self.goal,
            "hours": self.hours,
            "even_hours": self.even,
            "scanned_hours": self.scanned,
            "stderr": self.stderr,
            "even_stderr": self.even_stderr,
            "errors_to_even": self.to_even,
            "findings": list(self.findings),
            "planning_seconds": self.took,
        }
        plain: dict[str, Any] = finite(made)
        return plain

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write `to_dict` as a JSON file; returns its path."""
        return write_json(path, self.to_dict())

    def table(self, path: str | os.PathLike[str]) -> Path:
        """Write the moments as CSV; returns its path."""
        return write_csv(path, [["scan", "time_h"], *([k + 1, round(float(t), 6)] for k, t in enumerate(self.hours))])

    def picture(self, path: str | os.PathLike[str]) -> Path:
        """Write an SVG picture: what is believed of each parameter, when it is scanned, and its error at each moment; returns its path."""
        return write_text(path, drawn(self.courses, self.hours, self.even, self.scanned))

    def summary(self) -> list[tuple[str, str]]:
        """Facts for people: a label and a text each."""
        facts = [
            ("scan at", f"{', '.join(f'{t:.4g}' for t in self.hours)} h"),
            ("for", f"{self.material}: the trends of {self.model}, {self.goal}"),
        ]
        if len(self.scanned):
            facts.append(("beside", f"{len(self.scanned)} scans that are made, until {self.scanned.max():.4g} h"))
        if math.isfinite(self.to_even):
            facts.append(("errors", f"{self.to_even:.2g} times those of as many evenly spaced scans"))
        return facts


def plan_times(
    material: Material | str,
    *,
    count: int = 6,
    hours: tuple[float, float] | None = None,
    rig: str | os.PathLike[str] | Offer | Measurement = "tvbrdf",
    scanned: Sequence[float] = (),
    goal: str = "parameters",
    noise: float = 0.02,
    floor: float = 1e-4,
) -> Schedule:
    """Plan when to scan something that changes.

    Parameters
    ----------
    material
        What is believed of it, with trends: of a fit to the scans so far, or of a similar surface; or what names it.  Trends around it, within 25 %, count too.
    count
        How many scans.
    hours
        First and last moment [h] that a scan can be made; the interval of the trends by default.
    rig
        What each scan measures; see `motes.plan`.
    scanned
        Moments [h] of scans that are made already.
    goal
        ``"parameters"``, or the name of one whose trend is wanted.
    noise, floor
        Of a reading; see `motes.plan`.

    Raises
    ------
    MotesError
        For a material that does not change, an interval that does not go forward, or a goal that does not change.
    """
    started = clock.perf_counter()
    believed = named(material) if isinstance(material, str) else material
    trends = {name: trend for name, trend in believed.trends.items() if isinstance(trend, Trend)}
    interval = believed.interval
    if not trends or interval is None:
        raise DataError(
            f"{believed.name} does not change: it has no trends by formula",
            "Give the material.json of a fit to several times, or one of motes age",
        )
    if count < 1:
        raise MotesError(f"{count} scans are to be planned", "Ask for at least one")
    first, last = hours or interval
    if not (math.isfinite(first) and math.isfinite(last) and first < last):
        raise MotesError(f"{first:g} to {last:g} h does not go forward in time", "Give the first and the last hour")
    if goal != "parameters" and goal not in trends:
        raise MotesError(f"{goal} of {believed.name} does not change", f"The goal is parameters, or one of {', '.join(trends)}")  # fmt: skip
    done = np.sort(np.asarray(scanned, float))
    if not np.isfinite(done).all():
        raise MotesError("a scan was made at no finite hour", "Give hours as numbers")
    moments = np.linspace(first, last, MOMENTS)
    if count > len(moments):
        raise MotesError(f"{count} scans are more than the {MOMENTS} moments there are", f"Ask for {MOMENTS} or fewer")
    subject = Subject.of(believed.at(first))
    names, rows, courses = _rows(
        believed, trends, subject, np.concatenate([moments, done]), offered(rig), Noise(noise, floor)
    )
    size = len(names)
    before = np.eye(size) + information(rows[:, MOMENTS:].reshape(len(rows), -1, size))
    aim = None
    if goal != "parameters":
        aim = np.broadcast_to(np.diag([float(c.parameter == goal) for c in names]), before.shape)
    taken = sorted(chosen(Criterion([Term(rows[:, :MOMENTS], before, 1.0, aim)]), count, None))
    evenly = _evenly(count)
    scans = [rows[:, [*which, *range(MOMENTS, rows.shape[1])]] for which in (taken, evenly)]
    mine, theirs = (np.median(_errors(some, np.broadcast_to(np.eye(size), before.shape)), axis=0) for some in scans)
    spans = np.array([c.span for c in names])
    wanted = np.array([goal in ("parameters", c.parameter) for c in names])
    with np.errstate(all="ignore"):
        both = np.isfinite(mine) & np.isfinite(theirs) & wanted
        to_even = float(np.exp(np.mean(np.log((mine / theirs)[both])))) if both.any() else math.nan
    labels = [f"{c.parameter}.{c.name}" for c in names]
    lost = [label for label, error in zip(labels, mine, strict=True) if not math.isfinite(error)]
    said = (f"Not determined by these scans: {', '.join(lost)}; ask for more of them",) if lost else ()
    return Schedule(
        material=believed.name,
        model=describe(believed.brdf),
        goal=goal,
        hours=moments[taken],
        even=moments[evenly],
        scanned=done,
        stderr=dict(zip(labels, (mine * spans).tolist(), strict=True)),
        even_stderr=dict(zip(labels, (theirs * spans).tolist(), strict=True)),
        to_even=to_even,
        findings=said,
        took=clock.perf_counter() - started,
        courses=tuple(_courses(trends, subject, courses, moments, scans)),
    )


def _evenly(count: int) -> list[int]:
    """Evenly spaced moments from the first to the last; the last one alone where one is asked for."""
    return [MOMENTS - 1] if count == 1 else [int(k) for k in np.round(np.linspace(0, MOMENTS - 1, count))]


def _courses(
    trends: dict[str, Trend],
    subject: Subject,
    believed: list[tuple[Floats, Floats]],
    moments: Floats,
    scans: Sequence[Floats],
) -> Iterator[Course]:
    """Of each parameter that changes, in its channels: values and standard errors at the moments, of the trends that are believed alone."""
    for k, q in enumerate(subject.quantities):
        if q.name in trends:
            apart = np.asarray(trends[q.name](float(moments[0]))).size > 1
            channels = range(len(believed) if apart else 1)
            errors = [
                np.stack([_errors(rows[[c * DRAWS]], believed[c][1][None, : len(moments), k])[0] for c in channels])
                for rows in scans
            ]
            yield Course(q.name, q.parameter.unit, moments, np.stack([believed[c][0][: len(moments), k] for c in channels]), *errors)  # fmt: skip


def _rows(
    believed: Material, trends: dict[str, Trend], subject: Subject, moments: Floats, offer: Offer, noise: Noise
) -> tuple[list[_Coefficient], Floats, list[tuple[Floats, Floats]]]:
    """The coefficients of all parameters (those without a trend have one, their value), rows (B, T, P, K) of what a scan tells of them, and
    for each channel what is believed: values (T, P), and their derivatives (T, P, K) by the coefficients over their spans.

    A scan at time t has the information M(t) on the parameters, whose derivatives by the coefficients are G(t): G' M G in all, which is R'R with
    R = L' G and M = L L'.
    """
    some = np.unique(np.round(np.linspace(0, len(offer.wi) - 1, min(MOST_DIRECTIONS, len(offer.wi)))).astype(int))
    wi, wo, share = offer.wi[some], offer.wo[some], len(offer.wi) / len(some)
    assert above(wi, wo).all()
    duration = max(trend.interval[1] - trend.interval[0] for trend in trends.values())
    names: list[_Coefficient] = []
    for q in subject.quantities:
        low, high = q.parameter.typical
        if q.name not in trends:
            names.append(_Coefficient(q.name, "value", high - low))
            continue
        for c in KINDS[trends[q.name].kind].coefficients:
            span = high - low if c.bounds is None else duration if c.is_time else 1.0
            names.append(_Coefficient(q.name, c.name, span))
    rng = np.random.default_rng(1)
    values = believed.at(float(moments[0])).parameters
    found, itself = [], []
    for channel in range(len(believed.channels)):
        for draw in range(DRAWS):
            p, slopes = _parameters(believed, trends, subject, names, values, moments, channel, draw, rng)
            if draw == 0:
                itself.append((p, slopes))
            x = subject.inside(p)
            readings = subject.rows(x, wi, wo, noise) * math.sqrt(share)
            # The coordinate of a fit may be the square of a parameter.
            by = np.stack([2 * x[:, k] if q.parameter.squared else np.ones(len(x)) for k, q in enumerate(subject.quantities)], axis=1)  # fmt: skip
            matrix = information(readings)
            ridge = 1e-12 * np.trace(matrix, axis1=1, axis2=2)[:, None, None] * np.eye(subject.size)
            root = np.swapaxes(np.linalg.cholesky(matrix + ridge), 1, 2)
            found.append(root @ (slopes * (by / subject.spans)[:, :, None]))
    return names, np.stack(found), itself


def _parameters(
    believed: Material,
    trends: dict[str, Trend],
    subject: Subject,
    names: list[_Coefficient],
    values: Any,
    moments: Floats,
    channel: int,
    draw: int,
    rng: np.random.Generator,
) -> tuple[Floats, Floats]:
    """Values (T, P) of the parameters of one channel and draw, and their derivatives (T, P, K) by the coefficients over their spans."""

    def one(value: Any) -> float:
        flat = np.atleast_1d(np.asarray(value, float))
        near = float(flat[channel % len(flat)])
        return near if draw == 0 else near * (1 + AROUND * rng.uniform(-1, 1))

    p = np.empty((len(moments), subject.size))
    slopes = np.zeros((len(moments), subject.size, len(names)))
    for k, q in enumerate(subject.quantities):
        if q.name not in trends:
            column = names.index(next(c for c in names if c.parameter == q.name))
            p[:, k], slopes[:, k, column] = one(values[q.name]), names[column].span
            continue
        trend = trends[q.name]
        family = KINDS[trend.kind].coefficients
        drawn = {c.name: one(trend.coefficients[c.name]) for c in family}
        drawn = {c.name: min(max(drawn[c.name], 0.0), 1.0) if c.bounds and not c.is_time else drawn[c.name] for c in family}  # fmt: skip
        single = Trend(trend.kind, drawn, trend.interval, trend.bounds)
        p[:, k] = single(moments)
        for name, slope in single.jacobian(moments).items():
            column = next(j for j, c in enumerate(names) if (c.parameter, c.name) == (q.name, name))
            slopes[:, k, column] = slope * names[column].span
    return p, slopes


def _errors(rows: Floats, by: Floats) -> Floats:
    """Standard errors (B, Q) of what has the derivatives `by` (B, Q, K), from some scans (B, T, P, K) without any prior; infinite where they tell nothing."""
    matrix = information(rows.reshape(len(rows), -1, rows.shape[-1]))
    scale = np.sqrt(np.maximum(np.einsum("bkk->bk", matrix), 1e-300))
    values, vectors = np.linalg.eigh(matrix / scale[:, :, None] / scale[:, None, :])
    along = np.square((by / scale[:, None, :]) @ vectors)
    with np.errstate(all="ignore"):
        # A direction in which the matrix has nothing but rounding leaves all that points along it undetermined.
        inverse = np.where(values > 1e-12, 1 / values, np.inf)
        points = along > 1e-9 * along.sum(axis=2, keepdims=True)
        return np.asarray(np.sqrt(np.sum(np.where(points, along * inverse[:, None, :], 0.0), axis=2)))
