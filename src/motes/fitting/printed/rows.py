"""Rows of lanes in memory, and the text of functions that compute rows from rows: see `motes.kernels.vectors` for the language."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from motes.graph.dependence import live
from motes.graph.tracing import Symbol

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


def computed(
    outputs: Sequence[Symbol],
    places: Mapping[Symbol, str],
    known: Mapping[Symbol, str] | None = None,
    suffix: str = "",
) -> tuple[list[str], dict[Symbol, str]]:
    """The lines of a program that computes `outputs`, and all names in it; `known` are names of lines before."""
    lines: list[str] = []
    names = dict(known or {})
    for k, symbol in enumerate(live(outputs, {*places, *names})):
        if symbol in names:
            continue
        if symbol in places:
            name = names[symbol] = f"a{k}{suffix}"
            lines.append(f"{name} = {places[symbol]}")
            if is_truth(symbol):
                names[symbol] = f"{name}_"
                lines.append(f"{name}_ = true {name}")
            continue
        name = names[symbol] = f"t{k}{suffix}"
        if symbol.op == "leaf":
            raise KeyError(f"the leaf {symbol!r} was not given")
        if symbol.op == "constant":
            lines.append(f"{name} = const {symbol.value!r}")
        else:
            lines.append(f"{name} = {symbol.op} {' '.join(names[a] for a in symbol.args)}")
    return lines, names


def is_truth(symbol: Symbol) -> bool:
    return symbol.op in ("lt", "le", "gt", "ge")


def intrinsic(name: str, call: str, arguments: Sequence[str], lines: Sequence[str]) -> str:
    """The text of an intrinsic of `motes.kernels.vectors`."""
    given = ", ".join(arguments)
    program = "\n".join([" ".join(arguments), *lines])
    return f'@intrinsic\ndef {name}(typing, {given}):\n    program = """\n{program}\n"""\n    return {call}program, {given})'
