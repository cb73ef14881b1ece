"""The surface of another program at every texel of a map: its parameters, fitted to each texel's material, and how far each is from it.

A fit of one material takes a quarter of a second, too long for a million.  So a few texels that lie far apart are fitted singly; they say which of the
surface's texts serves the map, where the search begins, and which directions show all of its highlights.  A thousand texels, or all of a small map, are
fitted by the batched solver of the engine (`motes.fitting.texels`), at thousands of directions as a single fit.  All others lie on planes through the
parameters of the nearest of these; where such a texel is farther from its material than they are from theirs, it is fitted, too, at hundreds of
directions.  Errors are counted for every texel at directions that no fit has seen, and some texels are fitted singly after all, to compare.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from motes.exports.surface_fit import CLEARLY
from motes.exports.texel_planes import NEIGHBOURS, between
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
#: Polar angles of the light, and viewers for each and each way to choose them: of nodes,
#: of other fits, and of the errors, which are counted elsewhere.
DENSE, FITTED, COUNTED = (10, 48), (8, 12), (9, 16)
ELSEWHERE = (0.21, 0.77)
#: Values of texels at a time, at all directions and channels: 32 MB of them.
TOGETHER = 8 * 2**20
#: Texels that planes go through.
NODES = 1024
#: A texel is fitted where it is farther than so many times what its neighbours are.
FARTHER = 1.15


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
    fits
        How many texels the batched solver fitted; the others lie on planes between them.
    compared
        Of texels that were fitted singly, too: row, `seen` of the single fit and of what stands here, both over directions of their own.
    """

    kind: type[Surface]
    text: str
    values: dict[str, Floats]
    found: Bools
    seen: Floats
    relative_rms: Floats
    fits: int
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
        whole = int(self.found.sum())
        how = f" ({self.fits:,} fits, planes between)" if self.fits < whole else ""
        return (
            f"Parameters of {program} fitted to {whole:,} texels{how}: over the hemisphere {shown} relative RMS "
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
        return TexelSurfaces(
            self.kind, self.text, values, found, among(self.seen), among(self.relative_rms), self.fits, compared
        )

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
    count = len(next(iter(values.values())))

    def told(done: int) -> None:
        if progress is not None:
            progress(done, count, "texels")

    work = _Work(singles, surface, text, exact, list(known.values()), count)
    nodes = np.unique(np.linspace(0, count - 1, NODES).astype(int)) if count <= NODES else _some(count)
    work.solve(nodes, DENSE)
    told(len(nodes))
    if count > len(nodes):
        work.between(nodes, told)
    told(count)
    return _compared(singles, work.result(), known)


def _some(count: int) -> NDArray[np.int_]:
    """Rows from all over, at random."""
    return np.sort(np.random.default_rng(0).choice(count, NODES, replace=False))


class _Work:
    """The fits of all texels, in the making."""

    def __init__(
        self, singles: _Singles, surface: type[Surface], text: str, exact: list[BRDF], known: list[BRDF], count: int
    ) -> None:
        self.singles, self.surface, self.text = singles, surface, text
        self.exact, self.known = exact, known
        self.fits = 0
        wi, wo, weights = pairs(*exact, lights=COUNTED[0], viewers=COUNTED[1], shift=ELSEWHERE)
        self.counted_at = wi, wo, weights
        self.solver, self.starts = _solver(text, exact, known, FITTED)
        self.raw = np.full((count, self.solver.size), np.nan)
        self.off = np.full((2, count), np.nan)

    def solve(self, rows: NDArray[np.int_], directions: tuple[int, int]) -> None:
        """Fit some texels; one that planes gave something stays as it is where the fit is no nearer."""
        solver = self.solver if directions == FITTED else _solver(self.text, self.exact, self.known, directions)[0]
        for part in _parts(rows, len(solver.wi) * solver.channels):
            values = np.broadcast_to(
                self.singles.rows(part).eval(solver.wi, solver.wo), (len(part), len(solver.wi), solver.channels)
            )
            fit = solver.fit(values, self.starts)
            good = (fit.status == TexelStatus.CONVERGED) | (fit.status == TexelStatus.MAX_ITERATIONS)
            new = np.where(good[:, None], fit.x, np.nan)
            off = self.count(part, new)
            nearer = ~(off[0] >= self.off[0, part])  # where there was nothing, too
            self.raw[part[nearer]], self.off[:, part[nearer]] = new[nearer], off[:, nearer]
        self.fits += len(rows)

    def between(self, nodes: NDArray[np.int_], told: Callable[[int], None]) -> None:
        """All texels that are no nodes: on planes, and where these are not near, fitted."""
        points = _spread(self.singles.values)
        good = nodes[np.isfinite(self.raw[nodes]).all(axis=1)]
        rest = np.setdiff1d(np.arange(len(self.raw)), nodes)
        if len(good) <= NEIGHBOURS:
            return self.solve(rest, FITTED)
        low, high = self.solver.bounds
        step = max(1, len(rest) // 64)
        for start in range(0, len(rest), step):
            rows = rest[start : start + step]
            found = between(points[rows], points[good], self.raw[good], self.off[0, good])
            self.raw[rows] = np.clip(found.values, low, high)
            for part in _parts(rows, len(self.counted_at[0]) * self.solver.channels):
                self.off[:, part] = self.count(part, self.raw[part])
            far = rows[self.off[0, rows] > FARTHER * found.known]
            if len(far):
                self.solve(far, FITTED)
            told(len(nodes) + start + len(rows))
        return None

    def count(self, rows: NDArray[np.int_], raw: Floats) -> Floats:
        """`seen` and the relative RMS of parameter vectors of some texels (2, N), at directions that no fit has seen."""
        wi, wo, weights = self.counted_at
        off = np.full((2, len(rows)), np.nan)
        whole = np.flatnonzero(np.isfinite(raw).all(axis=1))
        if len(whole):
            found = self.named(raw[whole])
            model = self.surface().with_parameters(for_directions(self.surface(), found, slice(None)))
            wanted, got = (m.eval(wi, wo) for m in (self.singles.rows(rows[whole]), model))
            off[:, whole] = seen(got, wanted, wi, wo, weights), relative_rms(got, wanted, wi, weights)
        return off

    def named(self, raw: Floats) -> dict[str, Floats]:
        """Parameters as the program has them."""
        return self.surface.admissible(_named(parse(self.text).model, self.solver, raw))

    def result(self) -> TexelSurfaces:
        found: Bools = np.asarray(np.isfinite(self.raw).all(axis=1))
        values = self.named(self.raw)
        return TexelSurfaces(self.surface, self.text, values, found, self.off[0], self.off[1], self.fits, ())


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
    points = _spread(values)
    some = np.unique(np.linspace(0, len(points) - 1, min(len(points), AMONG)).astype(int))
    points = np.clip(points[some], -0.5, 1.5)
    chosen = [int(np.argmin(np.abs(points - np.median(points, axis=0)).sum(axis=1)))]
    distance = np.linalg.norm(points - points[chosen[0]], axis=1)
    while len(chosen) < most and distance.max() > 1e-3:
        chosen.append(int(np.argmax(distance)))
        distance = np.minimum(distance, np.linalg.norm(points - points[chosen[-1]], axis=1))
    return [int(some[k]) for k in chosen]


def _spread(values: Mapping[str, Floats]) -> Floats:
    """Parameters as points (N, P), nearly all of them within 0 and 1 along each axis."""
    table = np.column_stack([np.asarray(v, np.float64) for v in values.values()])
    low, high = np.quantile(table[:: max(1, len(table) // AMONG)], (0.01, 0.99), axis=0)
    return np.asarray((table - low) / np.where(high > low, high - low, 1.0))


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


def _solver(text: str, exact: list[BRDF], known: list[BRDF], directions: tuple[int, int]) -> tuple[TexelSolver, Floats]:
    """The batched solver, and where it begins (K, P)."""
    wi, wo, weights = pairs(*exact, *GLINTS[1:], lights=directions[0], viewers=directions[1])
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


def _named(surface: BRDF, solver: TexelSolver, raw: Floats) -> dict[str, Floats]:
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


def _parts(rows: NDArray[np.int_], each: int) -> list[NDArray[np.int_]]:
    """Rows in parts whose values, so many each, go into memory together."""
    size = max(1, TOGETHER // each)
    return [rows[k : k + size] for k in range(0, len(rows), size)]


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
