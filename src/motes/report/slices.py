"""Choosing what to show: a fit's samples in the coordinates of the plane of incidence, slices through them, groups by angle of incidence.

All angles are isotropic ones: theta_i, theta_r and phi_r - phi_i.  In a slice theta_r carries a sign: positive on the side of the mirror direction.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.drawing.colour import Floats
from motes.fitting.result import Fit

# More samples than this are thinned where every one would be drawn or counted; pictures of averages use them all.
MOST_DOTS = 6000
# From so many samples on, any slice finds enough of them close by.
DENSE = 20_000
# Angles of incidence [deg] that one wants to see, grazing included; the nearest that were measured are taken.
TARGETS = (0, 15, 30, 45, 60, 75, 85)
NEAR_MIRROR = np.deg2rad(6.0)


@dataclass(frozen=True)
class Samples:
    """Measured and fitted values with their angles [rad].

    ``theta_i, theta_r, dphi, from_mirror`` (n,); ``measured, fitted`` (n, C) [1/sr], NaN where masked.  ``from_mirror`` is the angle between ``wo`` and the
    mirror direction of ``wi``.
    """

    theta_i: Floats
    theta_r: Floats
    dphi: Floats
    from_mirror: Floats
    measured: Floats
    fitted: Floats

    @classmethod
    def of(cls, fit: Fit) -> Self:
        """The samples of a fit; those masked in all channels are left out."""
        data = fit.measurement
        mask = data.mask[0]
        kept = mask.any(1) & directions.above(data.wi, data.wo)
        keep = (
            slice(None) if kept.all() else kept
        )  # a view, where it can be one: a dense measurement has millions of samples
        mask = mask[keep]
        fitted = np.broadcast_to(fit.predicted, data.values.shape[1:])
        across = data.wi[keep, :2] + data.wo[keep, :2]
        along = data.wi[keep, 2] - data.wo[keep, 2]
        chord = np.sqrt(across[:, 0] ** 2 + across[:, 1] ** 2 + along**2)  # |wo - mirrored wi|
        return cls(
            data.theta_i[keep],
            data.theta_r[keep],
            data.dphi[keep],
            2 * np.arcsin(np.minimum(0.5 * chord, 1)),
            _where(mask, data.values[0][keep]),
            _where(mask, fitted[keep]),
        )

    def __len__(self) -> int:
        return len(self.theta_i)

    def take(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> Samples:
        """Some of the samples."""
        return Samples(*(getattr(self, name)[which] for name in self.__dataclass_fields__))

    def thinned(self, most: int = MOST_DOTS) -> Samples:
        """At most so many samples, the same ones every time, drawn evenly (seed 0)."""
        if len(self) <= most:
            return self
        return self.take(np.sort(np.random.default_rng(0).choice(len(self), most, replace=False)))

    @property
    def ratio(self) -> Floats:
        """Measured over fitted (n, C); NaN where either is not positive."""
        good = (self.measured > 0) & (self.fitted > 0)
        return np.where(good, self.measured, np.nan) / np.where(good, self.fitted, 1.0)


def _where(mask: NDArray[np.bool_], values: Floats) -> Floats:
    return values if mask.all() else np.where(mask, values, np.nan)


@dataclass(frozen=True)
class Slice:
    """Samples near one angle of incidence and near a plane through the normal."""

    theta_i: float
    theta_r: Floats  # signed [rad]
    samples: Samples
    across: bool

    @property
    def title(self) -> str:
        return f"θᵢ = {np.degrees(self.theta_i):.3g}°"


def distinct_angles(theta: Floats, most: int = 12) -> Floats | None:
    """The angles [rad] of a measurement on a regular set of them (to half a degree), or None where there are more than `most`."""
    for part in (theta[:: max(1, len(theta) // 500)], theta):  # a few tell, most times
        rounded = np.unique(np.round(np.degrees(part) * 2))
        if len(rounded) > most:
            return None
    return np.deg2rad(rounded / 2)


@dataclass(frozen=True)
class Slices:
    """Slices with the tolerances [rad] within which samples were taken."""

    panels: tuple[Slice, ...]
    off_plane: float
    off_angle: float


def polar_slices(samples: Samples, *, across: bool = False, most: int = 6) -> Slices:
    """Slices along the plane of incidence, or across it (at right angles to it), at several angles of incidence.

    The tolerances are as small as the data allow: a regular measurement gives exact slices; scattered directions (CUReT) are taken within a few degrees.
    A panel needs three samples, across five.
    """
    side = np.cos(samples.dphi) if across else np.sin(samples.dphi)
    off_plane = np.arcsin(np.minimum(np.abs(side) * np.sin(samples.theta_r), 1))
    if across:  # normal incidence has no plane, and would be shown twice
        off_plane = np.where(samples.theta_i < np.deg2rad(3), np.inf, off_plane)
    regular = distinct_angles(samples.theta_i) is not None
    off_angle = np.deg2rad(0.6 if regular else 1.0 if len(samples) > DENSE else 3.0)
    tolerance = 0.0
    found: list[Slice] = []
    for degrees in (0.6, 1.5, 3, 5):
        tolerance = np.deg2rad(degrees)
        near = np.flatnonzero(off_plane <= tolerance)
        found = _panels(samples.take(near), off_angle, across, most) if len(near) else []
        if len(found) >= min(3, most) and np.median([len(s.theta_r) for s in found]) >= (5 if regular else 7):
            break
    return Slices(tuple(found), float(tolerance), float(off_angle))


def _panels(near: Samples, off_angle: float, across: bool, most: int) -> list[Slice]:
    panels: list[Slice] = []
    for center in _centers(near.theta_i, off_angle):
        which = np.abs(near.theta_i - center) <= off_angle
        chosen = near.take(which)
        signed = chosen.theta_r.copy()
        if not across:
            signed[np.cos(chosen.dphi) > 0] *= -1
        order = np.argsort(signed, kind="stable")
        signed, chosen = signed[order], chosen.take(order)
        if (
            len(order) > 120
        ):  # dense data: one sample in each step of 1.5 degrees, the one nearest to the angle of incidence
            step = np.round(np.degrees(signed) / 1.5)
            nearest = np.lexsort((np.abs(chosen.theta_i - center), step))
            first = nearest[np.r_[True, np.diff(step[nearest]) != 0]]
            signed, chosen = signed[first], chosen.take(first)
        if len(signed) >= (5 if across else 3):
            panels.append(Slice(float(np.mean(chosen.theta_i)), signed, chosen, across))
    if len(panels) > most:  # the well filled ones, spread evenly, the most grazing one among them
        typical = np.median([len(s.theta_r) for s in panels])
        panels = [s for s in panels if len(s.theta_r) >= 0.6 * typical]
        panels = [panels[k] for k in np.unique(np.linspace(0, len(panels) - 1, most).round().astype(int))]
    return panels


def _centers(theta_i: Floats, off_angle: float) -> list[float]:
    """Angles of incidence worth a panel: all of a regular measurement, else near each target the one with the most samples about it."""
    regular = distinct_angles(theta_i)
    if regular is not None:
        return [float(t) for t in regular]
    if len(theta_i) > DENSE:
        return [float(t) for t in np.deg2rad(TARGETS[1:])]
    centers: list[float] = []
    for target in np.deg2rad(TARGETS):
        candidates = target + np.deg2rad(np.arange(-5, 5.5, 0.5))
        candidates = candidates[(candidates >= 0) & (candidates < np.deg2rad(89))]
        counts = np.array([np.count_nonzero(np.abs(theta_i - c) <= off_angle) for c in candidates])
        score = counts / (1 + (np.degrees(candidates - target) / 2) ** 2)
        best = float(candidates[np.argmax(score)])
        if score.max() > 0 and all(abs(best - c) > 2 * off_angle for c in centers):
            centers.append(best)
    return centers


class Group(NamedTuple):
    """Samples of one angle of incidence, or of a range of them: its median [rad], words for it, and which samples."""

    theta_i: float
    title: str
    which: NDArray[np.bool_]


def incidence_groups(theta_i: Floats, most: int = 8) -> list[Group]:
    """Samples by angle of incidence: each of a regular measurement, else four equal shares."""
    regular = distinct_angles(theta_i, most)
    if regular is not None:
        return [Group(float(t), f"θᵢ = {np.degrees(t):.3g}°", np.abs(theta_i - t) <= np.deg2rad(0.3)) for t in regular]
    edges = np.quantile(theta_i, np.linspace(0, 1, 5))
    edges[0] = -1
    groups = []
    for low, high in itertools.pairwise(edges):
        which = (theta_i > low) & (theta_i <= high)
        if which.any():
            first, last = np.degrees(theta_i[which].min()), np.degrees(theta_i[which].max())
            groups.append(Group(float(np.median(theta_i[which])), f"θᵢ from {first:.0f}° to {last:.0f}°", which))
    return groups


@dataclass(frozen=True)
class NearMirror:
    """For each angle of incidence the sample nearest to the mirror direction, and the typical ratio far from it.

    ``theta_i, from_mirror`` (k,) [rad]; ``measured, fitted`` (k, C); ``elsewhere`` (k,): median of measured over fitted at more than 45 degrees from the
    mirror direction.
    """

    theta_i: Floats
    from_mirror: Floats
    measured: Floats
    fitted: Floats
    elsewhere: Floats


def near_mirror(samples: Samples) -> NearMirror | None:
    """The samples near the mirror direction, or None where fewer than three angles of incidence have one within 6 degrees."""
    regular = distinct_angles(samples.theta_i)
    step = np.deg2rad(5)
    centers = regular if regular is not None else np.arange(0.5, 18) * step
    half = np.deg2rad(0.6) if regular is not None else step / 2
    near = samples.take(samples.from_mirror <= NEAR_MIRROR)
    far = samples.take(samples.from_mirror > np.deg2rad(45)).thinned()
    rows, elsewhere = [], []
    for center in centers:
        which = np.flatnonzero(np.abs(near.theta_i - center) <= half)
        if len(which):
            rows.append(which[np.argmin(near.from_mirror[which])])
            elsewhere.append(_median(far.ratio[np.abs(far.theta_i - center) <= half]))
    if len(rows) < 3:
        return None
    at = near.take(np.array(rows))
    return NearMirror(at.theta_i, at.from_mirror, at.measured, at.fitted, np.array(elsewhere))


def ratio_by_angle(near: NearMirror) -> tuple[Floats, Floats]:
    """Angles of incidence [rad] and the geometric mean over the channels of measured over fitted."""
    good = (near.measured > 0) & (near.fitted > 0)
    log = np.log(np.where(good, near.measured, 1) / np.where(good, near.fitted, 1))
    keep = good.any(1)
    return near.theta_i[keep], np.exp(log[keep].sum(1) / good[keep].sum(1))


def grows(near: NearMirror) -> bool:
    """True when the measured highlight gains a factor of 1.5 or more on the fitted one from the steepest to the most grazing incidence."""
    _, ratio = ratio_by_angle(near)
    return len(ratio) >= 3 and bool(ratio[-1] >= 1.5 * ratio[0] and ratio[-1] >= 0.95 * ratio.max())


def _median(values: Floats) -> float:
    values = values[np.isfinite(values)]
    return float(np.median(values)) if values.size else float("nan")


def binned(x: Floats, y: Floats, edges: Floats) -> tuple[Floats, Floats]:
    """Percentiles 16, 50, 84 of y (3, bins) in bins of x, and the bins' middles; NaN where a bin has fewer than three values."""
    good = np.isfinite(y)
    x, y = x[good], y[good]
    quantiles = np.full((3, len(edges) - 1), np.nan)
    where = np.digitize(x, edges) - 1
    for k in range(len(edges) - 1):
        inside = y[where == k]
        if len(inside) >= 3:
            quantiles[:, k] = np.percentile(inside, (16, 50, 84))
    return 0.5 * (edges[1:] + edges[:-1]), quantiles
