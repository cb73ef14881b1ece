"""Rows of lanes in memory, and the text of functions that compute rows from rows: see `motes.kernels.vectors` for the language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from motes.graph.tracing import Symbol
from motes.kernels.programs import computed, intrinsic

LANES = 16  # texels in a block: two vectors of eight floats


@dataclass
class Rows:
    """Rows of a buffer, one for each quantity: `LANES` items each."""

    name: str
    scalar: str
    where: dict[Symbol, int] = field(default_factory=dict)

    def put(self, symbols: Iterable[Symbol]) -> Rows:
        for symbol in symbols:
            self.where.setdefault(symbol, len(self.where))
        return self

    def all(self, symbols: Iterable[Symbol]) -> Rows:
        """One row for each of so many symbols; those of constants are never read."""
        self.where |= {symbol: k for k, symbol in enumerate(symbols) if symbol.op != "constant"}
        return self


@dataclass(frozen=True)
class Uniform:
    """Numbers that all lanes share: an array of float64."""

    name: str
    symbols: tuple[Symbol, ...]


@dataclass(frozen=True)
class Target:
    """Where results go: the name of a buffer, its scalar type, and what goes into its rows, one after the other; None leaves a row alone."""

    name: str
    scalar: str
    symbols: Sequence[Symbol | None]


def lane_function(name: str, sources: Sequence[Rows | Uniform], targets: Sequence[Target], add: bool = False) -> str:
    """A function that computes rows from rows, in float64.

    Parameters
    ----------
    sources
        Where the leaves are.
    add
        Whether results are added to what the rows hold.
    """
    places = {
        symbol: f"row {source.name} {source.scalar} {k * LANES}"
        for source in sources
        if isinstance(source, Rows)
        for symbol, k in source.where.items()
    }
    places |= {
        symbol: f"splat {source.name} D {k}"
        for source in sources
        if isinstance(source, Uniform)
        for k, symbol in enumerate(source.symbols)
    }
    lines, names = computed([symbol for target in targets for symbol in target.symbols if symbol is not None], places)
    for target in targets:
        lines += [
            f"{'add' if add else 'put'} {target.name} {target.scalar} {row * LANES} {names[symbol]}"
            for row, symbol in enumerate(target.symbols)
            if symbol is not None
        ]
    arguments = [source.name for source in sources] + [target.name for target in targets]
    return intrinsic(name, 'vectors.rows(LANES, "D", ', arguments, lines)


def each_function(
    name: str, results: Sequence[Symbol], places: Mapping[Symbol, str], arguments: Sequence[str], target: str
) -> str:
    """A function that computes rows for every sample, in float32, and stores them one after the other in `target`.

    `places` says where the leaves are, in the language of the programs; `arguments` are the addresses in them, ``samples`` among them.
    """
    lines, names = computed(results, places)
    for k, symbol in enumerate(results):
        lines.append(f"put {target} F sample*{len(results) * LANES}+{k * LANES} {names[symbol]}")
    return intrinsic(name, "vectors.each(LANES, ", [*arguments, target], lines)
