"""`motes.plan`: which directions to measure."""

from __future__ import annotations

import math
import os
import time as clock
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from motes.directions import above, from_half_difference
from motes.errors import DataError, MotesError
from motes.fitting.front import fit
from motes.fitting.result import Fit
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, describe
from motes.planning.alternatives import usual_rivals, with_switch
from motes.planning.believed import TYPICAL, Prior, believed, of_fit
from motes.planning.criteria import Criterion, Term
from motes.planning.design import CHECK, FIND, Design
from motes.planning.expectations import expectations, overall, revealed, stays_unseen
from motes.planning.information import Noise, Subject, information
from motes.planning.offers import Offer
from motes.planning.rigs import measurement_of, offered
from motes.planning.swapping import chosen, even, exposures, places, spread
from motes.planning.timed import time_of, within
from motes.planning.travelling import ordered, travel_of

Floats = NDArray[np.float64]
PARAMETERS, CURVE = "parameters", "curve"
USUAL = "oren_nayar + torrance_sparrow"
USUAL_NOISE = 0.02
#: Of a criterion: how much telling rivals apart counts; and of the shots: how many check the model.
RIVALS, CHECKED = 0.1, 0.15


def plan(
    model: str | BRDF = USUAL,
    rig: str | os.PathLike[str] | Offer | Measurement = "tvbrdf",
    *,
    count: int = 12,
    prior: str | Material | BRDF | Sequence[str | Material | BRDF] | Prior = TYPICAL,
    goal: str = PARAMETERS,
    measured: Measurement | str | os.PathLike[str] | None = None,
    noise: float | None = None,
    floor: float = 1e-4,
    rivals: str | Sequence[str] = "auto",
    check: float = CHECKED,
    repeats: bool = False,
    minutes: float | None = None,
) -> Design:
    """Plan a measurement: the directions that tell most of a model's parameters, whatever the material is within a prior.

    Parameters
    ----------
    model
        Text such as ``"oren_nayar + torrance_sparrow"`` (values given in it are known and not to be found), or a BRDF.
    rig
        What can be measured: ``"tvbrdf"``, ``"hemisphere"``, ``"in_plane"``, a file ``rig.toml``, measured data (their directions), or an `Offer`.
    count
        How many shots to measure; a shot is a direction, or all that are recorded at once.
    prior
        What the material may be: ``"typical"`` (all that real materials span), ``"catalogue"`` (the presets), or materials.
    goal
        ``"parameters"`` (all of them), ``"curve"`` (the reflectance over the hemisphere), or the name of one parameter, such as ``"tau"``.
    measured
        What is measured already: the plan goes on from it, and its fit is the prior where none is given.
    noise
        Relative standard deviation of a reading; the default is that of `measured`, else 0.02.
    floor
        Standard deviation of a reading that does not go with its value, in f cos(theta_i) [1/sr].
    rivals
        Models to be told from this one: texts, ``"auto"`` (a highlight or dust, where the model has none) or ``"none"``.
    check
        The share of shots, in [0, 0.9], that do not serve the parameters but lie where a wrong model would be caught.
    repeats
        Whether a direction may be measured more than once.
    minutes
        How long the measurement may take, readings and moves, in place of `count`: each shot then counts by what it tells per second that
        it costs.  Of a rig whose costs are known.

    Returns
    -------
    Design

    Raises
    ------
    MotesError
        For a rig that sees nothing or has no direction left, a model without free parameters, or fewer directions than parameters.

    Examples
    --------
    >>> import motes
    >>> design = motes.plan("oren_nayar + torrance_sparrow", "tvbrdf", count=12)
    >>> design.shots, design.to_even < 0.7
    (12, True)
    """
    started = clock.perf_counter()
    subject = Subject.of(model)
    if not 0 <= check <= 0.9:
        raise MotesError(f"the share for checks is {check:g}, outside [0, 0.9]", "0.15 is the default; 0 is for none")
    whole = offered(rig)
    data = None if measured is None else measurement_of(measured)
    findings: list[str] = []
    belief = None
    if data is not None:
        data, fitted = _known(data, subject)
        if noise is None:
            noise = _noise_of(data, fitted)
        if prior == TYPICAL and fitted is not None:
            belief = of_fit(subject, fitted)
        elif fitted is None:
            findings.append(f"The {data.n_directions} measured directions do not determine the model yet: the prior is {prior!r}")  # fmt: skip
    belief = belief or believed(subject, prior)
    findings += belief.findings
    quality = Noise(USUAL_NOISE if noise is None else noise, floor)
    free = whole if data is None or repeats else whole.without(whole.near(data.wi, data.wo))
    planner = _Planner(subject, free, belief, quality, data, goal, _rivals(subject, rivals))
    if minutes is not None:
        found, checking = planner.timed(60 * _checked(minutes, free), check)
        count = _counted(len(found) + len(checking), planner, repeats)
        return planner.design(whole.shots, found, checking, findings, started)
    count = _counted(count, planner, repeats)
    found, checking = planner.taken(count, check, repeats)
    if len(found) + len(checking) < count:
        findings.append(
            f"Of {count} shots {len(found) + len(checking)} are planned: no more are {free.apart_deg:g} degrees apart"
        )
    return planner.design(whole.shots, found, checking, findings, started)


def _known(data: Measurement, subject: Subject) -> tuple[Measurement, Fit | None]:
    """The usable directions of what is measured, its last scan, and the fit; None where it is too little to fit."""
    data = data.at(-1)
    usable = data.mask[0].any(axis=1)
    if not usable.any():
        raise DataError("of what is measured no sample is usable", "motes info shows what was masked and why")
    data = data.select(usable)
    if int(data.mask[0].sum(axis=0).min()) <= subject.size:
        return data, None
    held = {s.name: s.value for s in subject.brdf.slots() if s.name not in subject.names}
    found = fit(data, describe(subject.brdf), fixed=held)
    assert isinstance(found, Fit)  # one time
    return data, found


def _noise_of(data: Measurement, fitted: Fit | None) -> float:
    """The relative noise of what is measured: as it says, else as its fit leaves it."""
    if data.uncertainties is not None:
        with np.errstate(all="ignore"):
            share = (data.uncertainties / np.abs(data.values))[data.mask]
        share = share[np.isfinite(share) & (share > 0)]
        if share.size:
            return float(np.clip(np.median(share), 1e-4, 1.0))
    if fitted is None:
        return USUAL_NOISE
    return float(np.clip(fitted.metrics["relative_rms"], 1e-3, 1.0))


def _rivals(subject: Subject, rivals: str | Sequence[str]) -> list[Subject]:
    texts = (
        usual_rivals(subject)
        if rivals == "auto"
        else ()
        if rivals == "none"
        else (rivals,)
        if isinstance(rivals, str)
        else rivals
    )
    return [Subject.of(text) for text in texts]


def _counted(count: int, planner: _Planner, repeats: bool) -> int:
    """The number of shots, checked."""
    if count < 1:
        raise MotesError(f"{count} shots are to be planned", "Ask for at least one")
    subject, offer = planner.subject, planner.offer
    if not repeats and count > offer.shots:
        raise MotesError(
            f"{count} shots are to be planned, and {offer.name} has {offer.shots} free ones",
            f"Ask for {offer.shots} or fewer, or allow repeats",
        )
    directions = count * offer.members.shape[1] + (0 if planner.data is None else planner.data.n_directions)
    if directions < subject.size:
        raise MotesError(
            f"{directions} direction(s) cannot determine the {subject.size} parameters of {describe(subject.brdf)}",
            f"Ask for {-(-subject.size // offer.members.shape[1])} or more, or hold parameters by a value in the model's text",
        )
    return count


def _checked(minutes: float, offer: Offer) -> float:
    """The minutes of a plan, checked."""
    if not 0 < minutes < math.inf:
        raise MotesError(f"{minutes:g} minutes are no time to measure in", "Give a number above 0")
    if not offer.cost.known:
        raise MotesError(
            f"what {offer.name} takes is not known, so that {minutes:g} minutes mean nothing",
            "Write [cost] into a rig.toml: reading_s, light_s_per_deg, view_s_per_deg",
        )
    if offer.cost.reading > 60 * minutes:
        raise MotesError(
            f"one reading takes {offer.cost.reading:g} s, more than the {60 * minutes:g} s there are",
            "Give more minutes",
        )
    if offer.cost.reading <= 0:
        raise MotesError(f"a reading of {offer.name} takes no time, so that any number fits", "Give reading_s above 0")
    return minutes


class _Planner:
    """A model, what can be measured, and what is known: from these to a design."""

    def __init__(
        self,
        subject: Subject,
        offer: Offer,
        belief: Prior,
        noise: Noise,
        data: Measurement | None,
        goal: str,
        rivals: Sequence[Subject],
    ) -> None:
        self.subject, self.offer, self.belief = subject, offer, belief
        self.noise, self.data, self.goal = noise, data, goal
        self.aim = self._aim()
        self.rivals = rivals

    def _aim(self) -> Floats | None:
        """W of the criterion for each material (B, P, P); see `motes.planning.criteria`."""
        subject = self.subject
        if self.goal == PARAMETERS:
            return None
        if self.goal == CURVE:
            wi, wo, weights = _hemisphere()
            f, slopes = subject.derivatives(self.belief.values, wi, wo)
            # Of what reaches an eye: both cosines, relative to the light that the material sends there.
            shown = np.sqrt(weights * wi[:, 2] * wo[:, 2])
            bright = np.square(f * shown).sum(axis=1)[:, None, None]
            return np.asarray(information(slopes * shown[:, None]) / bright)
        if self.goal not in subject.names:
            raise MotesError(
                f"{describe(subject.brdf)} has no parameter {self.goal!r} to plan for",
                f"The goal is {PARAMETERS}, {CURVE}, or one of {', '.join(subject.names)}",
            )
        unit = np.zeros((subject.size, subject.size))
        k = subject.names.index(self.goal)
        unit[k, k] = 1.0
        return np.broadcast_to(unit, (len(self.belief.values), *unit.shape))

    def _shots(self, rows: Floats) -> Floats:
        """Rows (B, N, P) of directions by shots (B, U, m, P), 0 where a shot has fewer."""
        members = self.offer.members
        return np.asarray(np.where((members >= 0)[None, :, :, None], rows[:, members], 0.0))

    def criterion(self) -> Criterion:
        """What the plan is to be good for, with nothing taken."""
        subject, values = self.subject, self.belief.values
        rows = self._shots(subject.rows(values, self.offer.wi, self.offer.wo, self.noise))
        start = np.broadcast_to(np.eye(subject.size), (len(values), subject.size, subject.size))
        if self.data is not None:
            start = start + information(subject.rows(values, self.data.wi, self.data.wo, self.noise))
        share = RIVALS if self.rivals else 0.0
        # det(M, d) / det(M) is the information on the switch to a rival with all parameters free: its divisor is the same for all.
        own = (1 - share) / (subject.size if self.aim is None else 1)
        terms = [Term(rows, start, own - share)] if self.aim is None else [Term(rows, start, own, self.aim)]
        if self.aim is not None and self.rivals:
            terms.append(Term(rows, start, -share))
        for rival in self.rivals:
            more = with_switch(subject, values, rival, self.offer.wi, self.offer.wo, self.noise)
            begin = np.broadcast_to(np.eye(subject.size + 1), (len(values), subject.size + 1, subject.size + 1))
            if self.data is not None:
                begin = begin + information(with_switch(subject, values, rival, self.data.wi, self.data.wo, self.noise))
            terms.append(Term(self._shots(more), begin, share / len(self.rivals)))
        return Criterion(terms)

    def taken(self, count: int, check: float, repeats: bool) -> tuple[list[int], list[int]]:
        """Shots that find the parameters, and shots that check the model."""
        least = -(-self.subject.size // self.offer.members.shape[1]) if self.data is None else 1
        checks = min(round(check * count), max(0, count - least))
        close = self.offer.conflicts()
        found = chosen(self.criterion(), count - checks, close, repeats=repeats)
        beside = None if self.data is None else places(self.data.wi, self.data.wo)
        return found, spread(self.offer, checks, found, close, beside)

    def timed(self, seconds: float, check: float) -> tuple[list[int], list[int]]:
        """Shots that find the parameters, and shots that check the model in their share of so many seconds."""
        offer, close = self.offer, self.offer.conflicts()
        found = within(self.criterion, offer, (1 - check) * seconds, close)
        beside = None if self.data is None else places(self.data.wi, self.data.wo)
        most = spread(offer, int(check * len(found) / (1 - check) + 1e-9), found, close, beside)
        low, high = 0, len(most) + 1
        while high - low > 1:  # as many as there is time for
            middle = (low + high) // 2
            takes = time_of(offer, ordered(offer, [*found, *most[:middle]]))
            low, high = (middle, high) if takes <= seconds else (low, middle)
        checking = most[:low]
        return found, checking

    def design(self, shots: int, found: list[int], checking: list[int], findings: list[str], started: float) -> Design:
        """The shots in their order, with what they will reveal."""
        offer, subject, values = self.offer, self.subject, self.belief.values
        order = ordered(offer, [*found, *checking])
        criterion = self.criterion()
        exposure = exposures(criterion, order)
        usual = even(offer, len(order))
        rows = [offer.directions_of([shot]) for shot in order]
        at = np.concatenate(rows)
        numbers = np.repeat(np.arange(len(rows)), [len(r) for r in rows])
        theirs = offer.directions_of(usual)
        planned, others, everything = (
            revealed(subject, values, *self._beside(which), self.noise)
            for which in (at, theirs, np.arange(len(offer.wi)))
        )
        expected = expectations(subject, planned, others, everything)
        checks = set(checking)
        travel = travel_of(offer, order)
        cost = offer.cost
        return Design(
            model=describe(subject.brdf),
            goal=self.goal,
            rig=offer.name,
            prior=self.belief.words,
            noise=self.noise,
            wi=offer.wi[at],
            wo=offer.wo[at],
            shot=numbers,
            purpose=tuple(CHECK if order[n] in checks else FIND for n in numbers),
            exposure=exposure[numbers],
            even_wi=offer.wi[theirs],
            even_wo=offer.wo[theirs],
            expected=expected,
            to_even=overall(planned, others),
            to_all=overall(planned, everything),
            travel=travel,
            even_travel=travel_of(offer, usual),
            seconds=travel + cost.reading * len(order) if cost.known else math.nan,
            offered=shots,
            materials=len(values),
            measured=0 if self.data is None else self.data.n_directions,
            findings=(*findings, *stays_unseen(expected, len(values))),
            took=clock.perf_counter() - started,
        )

    def _beside(self, which: NDArray[np.intp]) -> tuple[Floats, Floats]:
        """Directions of the offer together with what is measured."""
        wi, wo = self.offer.wi[which], self.offer.wo[which]
        if self.data is None:
            return wi, wo
        return np.concatenate([self.data.wi, wi]), np.concatenate([self.data.wo, wo])


def _hemisphere() -> tuple[Floats, Floats, Floats]:
    """Pairs of directions over the hemisphere, and weights of their solid angles: dense in the half angle near 0, where highlights are.

    d omega_i d omega_r = 4 cos(theta_d) d omega_h d omega_d, and an isotropic surface does not see phi_h.
    """
    right = 0.5 * np.pi
    (u, over_half), (v, over_difference) = (np.polynomial.legendre.leggauss(n) for n in (20, 10))
    u, v = 0.5 * (u + 1), 0.5 * (v + 1)
    half, difference = right * u**2, right * v
    over_half = over_half * np.sin(half) * u
    over_difference = over_difference * np.sin(difference) * np.cos(difference)
    azimuth = (np.arange(9) + 0.5) * right / 9
    h, d, p = (a.ravel() for a in np.meshgrid(np.arange(20), np.arange(10), azimuth, indexing="ij"))
    h, d = h.astype(int), d.astype(int)
    wi, wo = from_half_difference(half[h], difference[d], p)
    seen = above(wi, wo)
    return wi[seen], wo[seen], (over_half[h] * over_difference[d])[seen]
