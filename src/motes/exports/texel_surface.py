"""The surface of another program at every texel of a map: its parameters, fitted to each texel's material, and how far each is from it.

A fit of one material takes a quarter of a second, too long for a million.  So a few texels that lie far apart are fitted singly; they say which of the
surface's texts serves the map, where the search begins, and which directions show all of its highlights.  All texels are then fitted by the batched
solver of the engine (`motes.fitting.texels`), a thousand times faster.  Errors are counted at other directions than those of the fit, and some texels
are fitted singly after all, to compare.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.exports.surface_fit import CLEARLY
from motes.fitting.conversion import (
    GLINTS,
    Conversion,
    check_reciprocal,
    coloured_strengths,
    convert,
    pairs,
    relative_rms,
    seen,
)
from motes.fitting.texels import TexelSolver, TexelStatus
from motes.models import BRDF, Surface, parse

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]
Progress = Callable[[int, int, str], None]
S = TypeVar("S", bound=Surface)

#: Texels that are fitted singly before all others, and those that are after them, to compare; how many the first are chosen among.
FIRST, HELD_OUT, AMONG = 6, 6, 4096
#: Polar angles of the light, and viewers for each and each way to choose them: of the fit, and of the errors, which are counted elsewhere.
FITTED, COUNTED = (8, 12), (9, 16)
ELSEWHERE = (0.21, 0.77)
#: Texels at a time: the values of so many at all directions are 30 MB.
TOGETHER = 2048


@dataclass(frozen=True)
class TexelSurfaces:
    """A surface at every texel.

    Attributes
    ----------
    kind
        Of surface.
    text
        What of it was fitted, and what was held: one for all texels, so that neighbours end in the same valley.
    values
        All parameters as the program has them, (N,), or (N, C) for colours; NaN where `found` says that there are none.
    found
        Which texels were converted (N,).
    seen, relative_rms
        How far each texel's surface is from its material over the hemisphere (N,): of the cube roots of what a picture shows, and of values times
        both cosines.
    compared
        Of texels that were fitted singly, too: row, `seen` of the single fit and of the batched one, both over directions of their own.
    """

    kind: type[Surface]
    text: str
    values: dict[str, Floats]
    found: Bools
    seen: Floats
    relative_rms: Floats
    compared: tuple[tuple[int, float, float], ...]

    def model(self, rows: Any) -> Surface:
        """The surfaces of some texels, for directions (D, 3)."""
        return self.kind().with_parameters(for_directions(self.kind(), self.values, rows))

    @property
    def added(self) -> float:
        """By how much `seen` of the batched fit exceeds that of the single one, at most over those compared."""
        return max((batched - single for _, single, batched in self.compared), default=0.0)

    def said(self, program: str) -> str:
        """The errors, in a sentence about the surface of a program."""
        off = self.quantiles()
        values, seen = off["relative_rms"], off["relative_rms_of_cube_roots"]
        shown, also = (", ".join(f"{100 * x:.2g} %" for x in of.values()) for of in (values, seen))
        return (
            f"Parameters of {program} fitted at {int(self.found.sum()):,} texels: over the hemisphere {shown} relative RMS "
            f"(median, 95 %, worst), {also} of cube roots."
        )

    def compared_in_words(self) -> str:
        """How much nearer single fits are, in a sentence; nothing where there are none."""
        if not self.compared:
            return ""
        near = min(batched - single for _, single, batched in self.compared)
        return (
            f"At {len(self.compared)} texels that were fitted singly, too, those fits are nearer by "
            f"{100 * near:.2g} to {100 * self.added:.2g} % of cube roots."
        )

    def spread(self, known: Bools) -> TexelSurfaces:
        """The same with rows for other texels, too: these are `known`, all others were not found."""
        place = np.flatnonzero(known)

        def among(values: Floats) -> Floats:
            whole = np.full((len(known), *values.shape[1:]), np.nan)
            whole[place] = values
            return whole

        found = np.zeros(len(known), bool)
        found[place] = self.found
        compared = tuple((int(place[row]), single, batched) for row, single, batched in self.compared)
        values = {name: among(value) for name, value in self.values.items()}
        return TexelSurfaces(self.kind, self.text, values, found, among(self.seen), among(self.relative_rms), compared)

    def quantiles(self) -> dict[str, dict[str, float]]:
        """The errors: median, 95 % and worst over texels."""
        return {
            name: dict(
                zip(("median", "95 %", "worst"), map(float, np.quantile(of[self.found], (0.5, 0.95, 1.0))), strict=True)
            )
            for name, of in (("relative_rms", self.relative_rms), ("relative_rms_of_cube_roots", self.seen))
        }


def for_directions(model: BRDF, values: Mapping[str, Floats], rows: Any) -> dict[str, Floats]:
    """Parameters of texels with axes for directions and, where a parameter has them, channels."""
    found = {}
    for slot in model.slots():
        if slot.name in values:
            part = values[slot.name][rows]
            wide = part[:, None] if part.ndim == 2 or not slot.parameter.per_channel else part[:, None, None]
            found[slot.name] = wide
    return found


def fit_texels(
    model: BRDF,
    values: Mapping[str, Floats],
    surface: type[S],
    texts: tuple[str, ...] = (),
    progress: Progress | None = None,
) -> TexelSurfaces:
    """The parameters of a surface with which it looks most like the material of each texel.

    Parameters
    ----------
    model
        With the parameters that all texels share.
    values
        The others by name, (N,), or (N, C): one or three channels.
    surface
        The kind of surface.
    texts
        What of it is fitted, the simplest first; its `candidates` when not given.
    progress
        Told the number of texels done, how many there are, and a word.

    Raises
    ------
    MotesError
        For a model that is not reciprocal, or black at all texels.
    """
    singles = _Singles(model, values)
    first = _far_apart(values, FIRST)
    text, known = _chosen(singles, surface, texts or surface.candidates, first)
    exact = [singles.at(k) for k in known]
    solver, starts = _solver(text, exact, list(known.values()))
    count = len(next(iter(values.values())))
    raw = np.full((count, solver.size), np.nan, np.float32)
    for rows in _parts(count):
        data = singles.rows(rows).eval(solver.wi, solver.wo)
        fit = solver.fit(np.broadcast_to(data, (rows.stop - rows.start, len(solver.wi), solver.channels)), starts)
        good = (fit.status == TexelStatus.CONVERGED) | (fit.status == TexelStatus.MAX_ITERATIONS)
        raw[rows] = np.where(good[:, None], fit.x, np.nan)
        if progress is not None:
            progress(rows.stop, count, "texels")
    found: Bools = np.asarray(np.isfinite(raw).all(axis=1))
    all_of_them = surface.admissible(_named(parse(text).model, solver, raw))
    nothing = np.full((2, count), np.nan)
    result = TexelSurfaces(surface, text, all_of_them, found, nothing[0], nothing[1], ())
    _count_errors(singles, result, exact)
    return _compared(singles, result, known)


class _Singles:
    """The materials of texels."""

    def __init__(self, model: BRDF, values: Mapping[str, Floats]) -> None:
        self.model, self.values = model, values
        check_reciprocal(model)

    def at(self, row: int) -> BRDF:
        return self.model.with_parameters({name: value[row] for name, value in self.values.items()})

    def rows(self, rows: Any) -> BRDF:
        return self.model.with_parameters(for_directions(self.model, self.values, rows))


def _far_apart(values: Mapping[str, Floats], most: int) -> list[int]:
    """Rows that are far from each other in the cloud of parameters; the first is the nearest to its middle.  Fewer where texels are alike."""
    table = np.column_stack([np.asarray(v, np.float64) for v in values.values()])
    some = np.unique(np.linspace(0, len(table) - 1, min(len(table), AMONG)).astype(int))
    low, high = np.quantile(table[some], (0.01, 0.99), axis=0)
    points = np.clip((table[some] - low) / np.where(high > low, high - low, 1.0), -0.5, 1.5)
    chosen = [int(np.argmin(np.abs(points - np.median(points, axis=0)).sum(axis=1)))]
    distance = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < most and distance.max() > 1e-3:
        chosen.append(int(np.argmax(distance)))
        distance = np.minimum(distance, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return [int(some[k]) for k in chosen]


def _chosen(
    singles: _Singles, surface: type[Surface], texts: tuple[str, ...], rows: list[int]
) -> tuple[str, dict[int, BRDF]]:
    """The simplest text that no later one is clearly nearer than, over these texels together, with the fits of it."""
    best, chosen = np.inf, ""
    before: dict[int, BRDF] = {}
    known: dict[int, BRDF] = {}
    for text in texts:
        fits: dict[int, BRDF] = {}
        off = []
        for row in rows:
            exact = singles.at(row)
            fits[row] = convert(exact, text, loss="cube_root", start=before.get(row)).brdf
            off.append(Conversion.between(exact, _as_the_program(fits[row])).seen)
        before = fits
        if np.mean(off) < CLEARLY * best or not chosen:
            best, chosen, known = float(np.mean(off)), text, fits
    assert all(isinstance(each, surface) for each in known.values())
    return chosen, known


def _as_the_program(found: BRDF) -> Surface:
    assert isinstance(found, Surface)
    return found.canonical()


def _solver(text: str, exact: list[BRDF], known: list[BRDF]) -> tuple[TexelSolver, Floats]:
    """The batched solver, and where it begins (K, P)."""
    wi, wo, weights = pairs(*exact, *GLINTS[1:], lights=FITTED[0], viewers=FITTED[1])
    target, _ = parse(text)
    channels = max(model.channels for model in exact)
    strengths = coloured_strengths(exact[0], target)
    # The viewer's cosine once: by how much of a picture shows the surface from there.
    solver = TexelSolver(text, wi, wo, channels, loss="cube_root", weights=weights / wo[:, 2], per_channel=strengths)
    starts = np.empty((len(known), solver.size))
    for start, model in zip(starts, known, strict=True):
        for k, column in enumerate(solver.columns):
            value = np.ravel(model.parameters[column.quantity])
            start[k] = value[(column.channel or 0) % len(value)]
    return solver, starts


def _named(surface: BRDF, solver: TexelSolver, raw: NDArray[np.float32]) -> dict[str, Floats]:
    """All parameters by name, colours with all channels."""
    found: dict[str, Floats] = {}
    for slot in surface.slots():
        columns = [k for k, column in enumerate(solver.columns) if column.quantity == slot.name]
        shape = (len(raw), solver.channels) if slot.parameter.per_channel else (len(raw),)
        value: Any = raw[:, columns] if slot.parameter.per_channel else raw[:, columns[0]] if columns else slot.value
        found[slot.name] = np.array(np.broadcast_to(value if columns else slot.value, shape), np.float64)
    missing = ~np.isfinite(raw).all(axis=1)
    for value in found.values():
        value[missing] = np.nan
    return found


def _parts(count: int) -> list[slice]:
    return [slice(k, min(k + TOGETHER, count)) for k in range(0, count, TOGETHER)]


def _count_errors(singles: _Singles, result: TexelSurfaces, exact: list[BRDF]) -> None:
    """The errors at directions that the fit has not seen, into the result."""
    lights, viewers = COUNTED
    wi, wo, weights = pairs(*exact, lights=lights, viewers=viewers, shift=ELSEWHERE)
    for rows in _parts(len(result.found)):
        good = np.flatnonzero(result.found[rows]) + rows.start
        if not len(good):
            continue
        wanted, got = (m.eval(wi, wo) for m in (singles.rows(good), result.model(good)))
        result.relative_rms[good] = relative_rms(got, wanted, wi, weights)
        result.seen[good] = seen(got, wanted, wi, wo, weights)


def _compared(singles: _Singles, result: TexelSurfaces, known: Mapping[int, BRDF]) -> TexelSurfaces:
    """Some texels fitted singly, from the nearest to the farthest; none of them is one of the first."""
    others = np.setdiff1d(np.flatnonzero(result.found), list(known))
    if not len(others):
        return result
    order = others[np.argsort(result.seen[others])]
    places = np.unique(np.linspace(0, len(order) - 1, HELD_OUT).round().astype(int))
    compared = []
    for row in (int(k) for k in order[places]):
        exact = singles.at(row)
        alone = _as_the_program(convert(exact, result.text, loss="cube_root").brdf)
        batched = result.kind().with_parameters({name: value[row] for name, value in result.values.items()})
        a, b = (Conversion.between(exact, model).seen for model in (alone, batched))
        compared.append((row, a, b))
    return replace(result, compared=tuple(compared))
