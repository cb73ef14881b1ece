"""Choosing the kind of each parameter's trend by BIC: what all scans together say about each, and the best changes in turn."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.fitting.algebra import pseudo_inverse
from motes.fitting.joint import Joint, Part, chained, columns_for
from motes.fitting.losses import Floats
from motes.fitting.problem import Problem
from motes.fitting.scans import ScanFits
from motes.fitting.solver import Normal, Solution, minimize
from motes.fitting.time_result import Alternative
from motes.fitting.verdicts import Verdict
from motes.trends import KINDS

#: Kinds of trend that are compared, the simplest first.
CANDIDATE_KINDS = ("constant", "linear", "exponential", "logistic", "quadratic", "cubic", "monotone_spline")

MOST_CHANGES = 40
# Reduction of the objective at which a fit stops, and the most iterations: for the fit that trends are first compared at, and for those that compare them.
ROUGHLY: dict[str, Any] = {"reduction": 1e-4, "max_iterations": 20}
NEARLY: dict[str, Any] = {"reduction": 1e-7, "max_iterations": 60}
# Mean square, in standard errors, up to which scans agree on a value.
AGREEMENT = 9.0


def determined(kind: str, scans: int) -> bool:
    """Whether so many scans can determine a trend of this kind.

    A polynomial may pass through all scans; other laws, which can be wrong, need a scan more.
    """
    polynomial = kind in ("constant", "linear", "quadratic", "cubic")
    return len(KINDS[kind].coefficients) <= scans - (0 if polynomial else 1)


class Survey(NamedTuple):
    """A joint fit at coefficients: parameters (T, P), their derivatives (T, P, K), and the scans' normal equations."""

    x: Floats
    jacobian: Floats
    scan: Normal


def survey(joint: Joint, c: Floats) -> Survey:
    """What the profiles of all parts need, worked out once."""
    x, jacobian = joint.vectors(c)
    return Survey(x, jacobian, joint.problem.normal(x, joint.scans))


class Profile:
    """What all scans say about the values of one parameter, the trends of the others free to follow.

    Near the joint solution the objective is a quadratic in the parameters of all scans; eliminating the others' coefficients leaves a
    quadratic in this parameter's values, in which kinds of trends can be compared in no time.
    """

    def __init__(self, joint: Joint, c: Floats, index: int, at: Survey) -> None:
        self.joint, self.part, self.index = joint, joint.parts[index], index
        x, jacobian, scan = at
        scans = len(x)
        own = self.part.quantity.where
        self.values = x[:, own]
        rest = np.concatenate(
            [np.arange(s.start, s.stop) for k, s in enumerate(joint.slices()) if k != index] or [np.arange(0)]
        )
        width = own.stop - own.start
        matrix = np.zeros((scans * width, scans * width))
        cross = np.zeros((scans * width, len(rest)))
        for t in range(scans):
            rows = slice(t * width, (t + 1) * width)
            matrix[rows, rows] = scan.matrix[t][own, own]
            cross[rows] = scan.matrix[t][own] @ jacobian[t][:, rest]
        others = chained(jacobian[:, :, rest], scan.matrix)
        slope = np.einsum("tpk,tp->k", jacobian[:, :, rest], scan.gradient)
        low, high = joint.bounds
        pull = np.einsum("tpk,tp->k", jacobian, scan.gradient)
        held = ((c <= low) & (pull > 0)) | ((c >= high) & (pull < 0))
        free = ~held[rest]
        gradient = scan.gradient[:, own].ravel()
        self.objective = float(scan.objective.sum())
        pick = np.zeros((scans * width, scans, x.shape[1]))  # from the gradients of the scans to the one of this part
        for t in range(scans):
            pick[t * width : (t + 1) * width, t, own] = np.eye(width)
        if free.any():
            inverse = pseudo_inverse(others[np.ix_(free, free)], joint.columns.unit[rest[free], 0], 1e-11)
            onto = cross[:, free] @ inverse
            matrix = matrix - onto @ cross[:, free].T
            gradient = gradient - onto @ slope[free]
            self.objective -= 0.5 * float(slope[free] @ inverse @ slope[free])  # the others' own way to their minimum
            pick -= np.einsum("vk,tpk->vtp", onto, jacobian[:, :, rest[free]])
        self.matrix, self.gradient, self._pick = matrix, gradient, pick
        # Where the scans would like the values to be: the minimum of the quadratic, as far as they say.
        eigenvalues, vectors = np.linalg.eigh(matrix)
        along = vectors.T @ gradient
        most = eigenvalues.max(initial=0.0)
        move = vectors @ np.divide(along, eigenvalues, out=np.zeros_like(along), where=eigenvalues > 1e-6 * most)
        # No trend at all, within bounds or not, gets below this objective.
        seen = eigenvalues > 1e-12 * most
        self.least = self.objective - 0.5 * float(np.sum(along[seen] ** 2 / eigenvalues[seen]))
        self.wish = np.clip(self.values - move.reshape(self.values.shape), *self.part.quantity.bounds)

    def inflation(self, middles: Floats, noise: float) -> float:
        """How many times the variance of this part's smooth changes exceeds what the mean square `noise` of a residual says; at least 1.

        The samples of a highlight are brighter, so noisier, than most; an objective that weighs all alike then falls by more than it should when a
        coefficient is added.  `middles` are the sandwich's of the scans (T, P, P).  Counting the coefficient as so many makes the criterion fair:
        the composite-likelihood BIC of Gao and Song (2010).
        """
        if not noise > 0:
            return 1.0
        hours = self.joint.hours[self.joint.scans]
        smooth = np.stack(KINDS["cubic"].basis(hours, *self.part.interval), axis=1)  # (T, 4)
        directions = np.kron(smooth, np.eye(self.part.width))
        picked = np.einsum("vtp,vk->tpk", self._pick, directions)
        middle = chained(picked, middles)
        inverse = np.linalg.pinv(directions.T @ self.matrix @ directions, rcond=1e-9, hermitian=True)
        rank = int(np.linalg.matrix_rank(inverse, hermitian=True))
        return max(float(np.trace(inverse @ middle)) / (max(rank, 1) * noise), 1.0)

    def fitted(self, kind: str) -> tuple[float, Floats]:
        """The objective with another kind for this parameter, and its coefficients."""
        part = replace(self.part, kind=kind)
        hours = self.joint.hours[self.joint.scans]

        basis = part.basis(hours)

        def normal(batch: Floats) -> Normal:
            value, slopes = part.values(basis, batch)
            rows = slopes.reshape(len(batch), -1, part.size)
            move = (value - self.values).reshape(len(batch), -1)
            push = move @ self.matrix
            change = move @ self.gradient + 0.5 * np.einsum("bv,bv->b", move, push)
            transposed = np.swapaxes(rows, 1, 2)
            gradient = (transposed @ (self.gradient + push)[..., None])[..., 0]
            return Normal(self.objective + change, gradient, transposed @ (self.matrix @ rows))

        low, high = part.bounds
        solution = minimize(
            normal,
            part.starts(hours, self.wish),
            low,
            high,
            brightness=float(self.joint.brightness().sum()),
            unit=columns_for([part], self.joint.problem.unit).unit[:, 0],
            max_iterations=40,
            reduction=1e-8,
        )
        best = solution.best()
        return float(solution.normal.objective[best]), solution.x[best]

    def compared(self, below: float = math.inf) -> dict[str, tuple[float, Floats]]:
        """For each candidate kind that so many scans can tell: the BIC by the quadratic, and its coefficients.

        Those that can't have a BIC below `below` are left out.
        """
        table = {}
        for kind in CANDIDATE_KINDS:
            if not determined(kind, len(self.joint.scans)):
                continue
            parts = tuple(replace(p, kind=kind) if k == self.index else p for k, p in enumerate(self.joint.parts))
            changed = replace(self.joint, parts=parts)
            if changed.bic(max(self.least, 0.0)) < below:
                objective, c = self.fitted(kind)
                table[kind] = (changed.bic(max(objective, 0.0)), c)
        return table


def surveyed(joint: Joint, c: Floats) -> tuple[Joint, list[Profile]]:
    """The profiles of all parts at coefficients `c`, and the joint fit with their inflation."""
    at = survey(joint, c)
    noise = 2 * float(at.scan.objective.sum()) / joint.samples
    # With the leverage that a sample has within its scan: what is judged are changes from scan to scan.
    inverses = pseudo_inverse(at.scan.matrix, joint.problem.columns.unit[:, 0], 1e-12)
    middles = np.stack(
        [
            joint.problem.spread(x, inverse, np.array([t]))
            for x, inverse, t in zip(at.x, inverses, joint.scans, strict=True)
        ]
    )
    profiles = [Profile(joint, c, k, at) for k in range(len(joint.parts))]
    joint = replace(joint, inflation=tuple(p.inflation(middles, noise) for p in profiles))
    for profile in profiles:
        profile.joint = joint
    return joint, profiles


def first_guess(
    problem: Problem, hours: Floats, fits: ScanFits, scans: NDArray[np.intp], kinds: Mapping[str, str]
) -> tuple[Joint, Floats]:
    """A joint fit to start from: a cubic through the scans' own values, or what `kinds` asks for."""
    interval = (float(hours[scans[0]]), float(hours[scans[-1]]))
    flexible = "cubic" if len(scans) >= 6 else "linear" if len(scans) >= 2 else "constant"
    parts, starts = [], []
    for q in problem.quantities:
        kind = kinds.get(q.name, flexible)
        if any(
            c.is_time for c in KINDS[kind].coefficients
        ):  # has several valleys: `select` starts it from the flexible trend
            kind = flexible
        part = Part(q, kind, interval)
        values, errors = fits.x[:, q.where], fits.steps[:, q.where]
        known = np.isfinite(errors).all(axis=1)
        if known.any():  # a scan that cannot see the parameter takes the value of its neighbours
            values = np.stack([np.interp(hours[scans], hours[scans][known], v[known]) for v in values.T], axis=1)
        parts.append(part)
        starts.append(part.starts(hours[scans], values)[0])
    joint = Joint(problem, hours, scans, tuple(parts))

    def nearest(batch: Floats) -> Normal:
        """To the scans' own fits, as far as each determines what: by their normal matrices, without a look at the data."""
        results = []
        for c in batch:
            x, jacobian = joint.vectors(c)
            away = x - fits.x
            push = np.einsum("tpq,tq->tp", fits.normal.matrix, away)
            matrix = chained(jacobian, fits.normal.matrix)
            objective = fits.normal.objective.sum() + 0.5 * float(np.sum(away * push))
            results.append((objective, np.einsum("tpk,tp->k", jacobian, push), matrix))
        return Normal(*(np.array(part) for part in zip(*results, strict=True)))

    # Both the plain values and the nearest trends are starts: a scan on a false branch spoils one or the other.
    plain = np.concatenate(starts)[None]
    low, high = joint.bounds
    bright, unit = float(joint.brightness().sum()), joint.columns.unit[:, 0]
    near = minimize(nearest, plain, low, high, brightness=bright, unit=unit, max_iterations=30, reduction=1e-6)
    both = np.concatenate([plain, near.x])
    rough = joint.solve(both, **ROUGHLY)
    return joint, rough.x[rough.best()]


def steady_values(problem: Problem, fits: ScanFits) -> dict[str, Floats]:
    """Parameters that some scans do not determine and the others agree on, with that value (W,).

    Where a scan says nothing of a parameter its trend can wander off, into a minimum of its own; `select` tries whether a constant does.
    """
    found = {}
    for q in problem.quantities:
        values, errors = fits.x[:, q.where], fits.steps[:, q.where]
        unseen = (Verdict.UNIDENTIFIABLE, Verdict.WEAK)
        sure = np.array([not any(v in unseen for v in verdicts[q.where]) for verdicts in fits.verdicts])
        sure &= np.isfinite(errors).all(axis=1) & (errors > 0).all(axis=1)
        if sure.sum() < 2:
            continue
        weights = 1 / errors[sure] ** 2
        mean = (weights * values[sure]).sum(axis=0) / weights.sum(axis=0)
        if np.mean(weights * (values[sure] - mean) ** 2) < AGREEMENT:
            found[q.name] = mean
    return found


class Proposal(NamedTuple):
    """Another kind for the part at this position: the BIC expected, and its coefficients."""

    bic: float
    part: int
    kind: str
    coefficients: Floats


def _proposals(
    joint: Joint, profiles: list[Profile], bic: float, fixed_kinds: Mapping[str, str], refused: set[tuple[str, str]]
) -> list[Proposal]:
    """The best change for each part that promises a smaller BIC, the most promising first."""
    proposals = []
    for index, part in enumerate(joint.parts):
        name = part.quantity.name
        if name in fixed_kinds:
            continue
        better = [
            Proposal(guess, index, kind, coefficients)
            for kind, (guess, coefficients) in profiles[index].compared(bic).items()
            if kind != part.kind and guess < bic - 1e-9 and (name, kind) not in refused
        ]
        if better:
            proposals.append(min(better, key=lambda p: p.bic))
    return sorted(proposals, key=lambda p: p.bic)


def _changed(joint: Joint, c: Floats, proposals: list[Proposal]) -> tuple[Joint, Floats]:
    """The joint fit with other kinds, and the coefficients to start from."""
    by_index = {p.part: p for p in proposals}
    parts = tuple(replace(p, kind=by_index[k].kind) if k in by_index else p for k, p in enumerate(joint.parts))
    pieces = [by_index[k].coefficients if k in by_index else c[s] for k, s in enumerate(joint.slices())]
    return replace(joint, parts=parts), np.concatenate(pieces)


def _steadied(
    joint: Joint,
    solution: Solution,
    bic: float,
    fixed_kinds: Mapping[str, str],
    steady: Mapping[str, Floats],
    seen: set[tuple[str, ...]],
) -> tuple[Joint, Solution] | None:
    """The joint fit with constants for what is `steady`, all at once or one at a time, if that is better."""
    candidates = [
        Proposal(-math.inf, k, "constant", steady[p.quantity.name])
        for k, p in enumerate(joint.parts)
        if p.kind != "constant" and p.quantity.name in steady and p.quantity.name not in fixed_kinds
    ]
    choices = [candidates] if len(candidates) == 1 else [candidates, *([c] for c in candidates)] if candidates else []
    for chosen in choices:
        changed, start = _changed(joint, solution.x[0], chosen)
        kinds = tuple(p.kind for p in changed.parts)
        if kinds in seen:
            continue
        seen.add(kinds)
        tried = changed.solve(start[None], **NEARLY)
        if changed.bic(float(tried.normal.objective[0])) < bic:
            return changed, tried
    return None


def select(
    joint: Joint,
    c: Floats,
    fixed_kinds: Mapping[str, str],
    progress: Callable[[int, int, str], None] | None = None,
    steady: Mapping[str, Floats] | None = None,
) -> tuple[Joint, Solution, dict[str, list[Alternative]]]:
    """Choose the kind of each trend by BIC: the best single change by the quadratic is fitted in full, until none helps.

    `steady` are values that may be constant (`steady_values`).  Returns the joint fit, its solution, and for each parameter the alternatives with
    their distance in BIC.
    """
    solution = joint.solve(c[None], **ROUGHLY)
    settled = [
        Proposal(-math.inf, k, kind, Profile(joint, solution.x[0], k, survey(joint, solution.x[0])).fitted(kind)[1])
        for k, part in enumerate(joint.parts)
        if (kind := fixed_kinds.get(part.quantity.name, part.kind)) != part.kind
    ]
    if settled:
        joint, c = _changed(joint, solution.x[0], settled)
        solution = joint.solve(c[None], **NEARLY)
    refused: set[tuple[str, str]] = set()
    seen: set[tuple[str, ...]] = set()  # the inflation changes with the trends, so that a choice could come round again
    for step in range(MOST_CHANGES):
        joint, profiles = surveyed(joint, solution.x[0])
        bic = joint.bic(float(solution.normal.objective[0]))
        seen.add(tuple(p.kind for p in joint.parts))
        proposals = _proposals(joint, profiles, bic, fixed_kinds, refused)
        if not proposals:
            steadier = _steadied(joint, solution, bic, fixed_kinds, steady or {}, seen)
            if steadier is None:
                break
            joint, solution = steadier
            continue
        # All at once first; if that is no better, the most promising one.
        for chosen in (proposals, proposals[:1]) if len(proposals) > 1 else (proposals,):
            changed, start = _changed(joint, solution.x[0], chosen)
            if tuple(p.kind for p in changed.parts) in seen:
                continue
            tried = changed.solve(start[None], **NEARLY)
            new_bic = changed.bic(float(tried.normal.objective[0]))
            if progress:
                words = ", ".join(f"{joint.parts[p.part].quantity.name} {p.kind}" for p in chosen)
                progress(step, MOST_CHANGES, words)
            if new_bic < bic:
                joint, solution = changed, tried
                break
        else:
            refused.add((joint.parts[proposals[0].part].quantity.name, proposals[0].kind))
    solution = joint.solve(solution.x)
    joint, profiles = surveyed(joint, solution.x[0])
    bic = joint.bic(float(solution.normal.objective[0]))
    alternatives: dict[str, list[Alternative]] = {}
    for index, (part, where) in enumerate(zip(joint.parts, joint.slices(), strict=True)):
        own = [Alternative(part.kind, 0.0, part.trend(solution.x[0][where]))]
        settled_kind = part.quantity.name in fixed_kinds
        table = {} if settled_kind else profiles[index].compared()
        others = [
            Alternative(kind, (guess - bic) / joint.inflation[index], replace(part, kind=kind).trend(coefficients))
            for kind, (guess, coefficients) in table.items()
            if kind != part.kind
        ]
        alternatives[part.quantity.name] = sorted(own + others, key=lambda a: a.delta_bic)
    return joint, solution, alternatives
