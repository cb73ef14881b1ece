"""From the parameters at a time to the coefficients of their trends, by the chain rule.

The parameters are functions of a texel's vector of coefficients; the normal equations of each time are carried over to the coefficients, and added up.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from motes.fitting.printed.formulas import packed
from motes.fitting.printed.rows import Rows, Target, Uniform, lane_function
from motes.graph import tracing
from motes.graph.tracing import Graph, Symbol


@dataclass(frozen=True)
class Coefficients:
    """What a texel's parameter vector holds.

    Attributes
    ----------
    graph
        Of the trends.
    leaves
        The coefficients, in the order of the vector.
    basis
        Leaves for what the trends need of each time.
    values
        The value of each parameter of the normal equations, in their order.
    """

    graph: Graph
    leaves: tuple[Symbol, ...]
    basis: tuple[Symbol, ...]
    values: tuple[Symbol, ...]

    @classmethod
    def themselves(cls, count: int) -> Coefficients:
        """One time: the coefficients are the parameters."""
        graph = Graph()
        leaves = tuple(graph.leaf(f"x[{k}]") for k in range(count))
        return cls(graph, leaves, (), leaves)

    @property
    def static(self) -> bool:
        return self.leaves == self.values


class _Chain:
    """The slopes of the values by the coefficients: leaves for those that differ, numbers as they are.

    `apart` are places in a packed matrix of the parameters that are 0: two channels' own parameters have no sample in common.
    """

    def __init__(self, coefficients: Coefficients, apart: Collection[int]) -> None:
        self.local, self.size, self.apart = len(coefficients.values), len(coefficients.leaves), apart
        self.graph = Graph()
        self.rows: dict[Symbol, Symbol] = {}  # the leaf that stands for a slope
        self.slopes: list[dict[int, Symbol]] = []
        for tangents in tracing.forward(coefficients.values, coefficients.leaves):
            own = {k: tangents[leaf] for k, leaf in enumerate(coefficients.leaves) if leaf in tangents}
            self.slopes.append({k: self._slope(tangent) for k, tangent in own.items()})
        self.leaves = list(self.rows.values())

    def _slope(self, tangent: Symbol) -> Symbol:
        if tangent.op == "constant":
            return self.graph.constant(tangent.value)
        return self.rows.setdefault(tangent, self.graph.leaf(f"slope[{len(self.rows)}]"))

    def matrix(self, leaves: Sequence[Symbol]) -> list[Symbol]:
        """The packed matrix of the parameters, with its zeros."""
        return [self.graph.constant(0.0) if k in self.apart else leaf for k, leaf in enumerate(leaves)]

    def leaves_of(self, name: str, count: int) -> list[Symbol]:
        return [self.graph.leaf(f"{name}[{k}]") for k in range(count)]


def coefficients_apart(coefficients: Coefficients, apart: Collection[int]) -> set[int]:
    """Where all matrices of the coefficients are 0 (packed), of parameters whose matrices are 0 where they are `apart`."""
    if coefficients.static:
        return set(apart)
    chain = _Chain(coefficients, apart)
    local = chain.local * (chain.local + 1) // 2
    carried = _carried(chain, chain.matrix(chain.leaves_of("matrix", local)))
    return {k for k, symbol in enumerate(carried) if symbol.is_constant(0.0)}


def trend_functions(coefficients: Coefficients, apart: Collection[int]) -> list[str]:
    """``trends_at`` (parameters at a time, and their slopes), ``chain_rule`` (normal equations to the coefficients'), ``carry`` (a matrix
    likewise) and ``leverage_at`` (a
    covariance of the coefficients to that of the parameters); `apart` says where all matrices of the parameters are 0 (packed)."""
    chain = _Chain(coefficients, apart)
    x = Rows("x", "D").put(coefficients.leaves)
    first = lane_function(
        "trends_at",
        [x, Uniform("basis", coefficients.basis)],
        [Target("parameters", "D", coefficients.values), Target("slopes", "D", list(chain.rows))],
    )
    return [first, _chain_rule(chain), _carry(chain), _leverage(chain)]


def _chain_rule(chain: _Chain) -> str:
    normal = chain.leaves_of("normal", 2 + chain.local + chain.local * (chain.local + 1) // 2)
    gradient = [chain.graph.constant(0.0)] * chain.size
    for i, row in enumerate(chain.slopes):
        for k, slope in row.items():
            gradient[k] = gradient[k] + slope * normal[2 + i]
    matrix = _carried(chain, chain.matrix(normal[2 + chain.local :]))
    sources = [Rows("normal", "D").put(normal), Rows("slopes", "D").put(chain.leaves)]
    return lane_function("chain_rule", sources, [Target("total", "D", [*normal[:2], *gradient, *matrix])], add=True)


def _carry(chain: _Chain) -> str:
    matrix = chain.leaves_of("matrix", chain.local * (chain.local + 1) // 2)
    sources = [Rows("matrix", "D").put(matrix), Rows("slopes", "D").put(chain.leaves)]
    return lane_function("carry", sources, [Target("total", "D", _carried(chain, chain.matrix(matrix)))], add=True)


def _carried(chain: _Chain, matrix: list[Symbol]) -> list[Symbol]:
    """A packed matrix of the parameters as one of the coefficients."""
    local, slopes = chain.local, chain.slopes
    result = [chain.graph.constant(0.0)] * (chain.size * (chain.size + 1) // 2)
    for i in range(local):
        onto: dict[int, Symbol] = {}
        for j in range(local):
            for k, slope in slopes[j].items():
                term = slope * matrix[packed(i, j)]
                onto[k] = onto[k] + term if k in onto else term
        for m, slope in slopes[i].items():
            for k, value in onto.items():
                if m <= k:
                    result[packed(k, m)] = result[packed(k, m)] + slope * value
    return result


def _leverage(chain: _Chain) -> str:
    local, size, slopes = chain.local, chain.size, chain.slopes
    inverse = chain.leaves_of("inverse", size * (size + 1) // 2)
    zero = chain.graph.constant(0.0)
    result = []
    for i in range(local):
        onto = [zero] * size
        for k, slope in slopes[i].items():
            for m in range(size):
                onto[m] = onto[m] + slope * inverse[packed(k, m)]
        for j in range(i + 1):
            result.append(zero)
            for m, slope in slopes[j].items():
                result[-1] = result[-1] + slope * onto[m]
    sources = [Rows("inverse", "D").put(inverse), Rows("slopes", "D").put(chain.leaves)]
    return lane_function("leverage_at", sources, [Target("leverage", "D", result)])
