"""The steps of `motes.fitting.covariance`, as functions of rows: from the normal equations at a solution to standard errors and verdicts."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Collection
from functools import lru_cache
from typing import Any

import numpy as np

from motes.arrays import Array
from motes.fitting import covariance as steps
from motes.fitting import levenberg, second_look
from motes.fitting.algebra import absolute
from motes.fitting.columns import Columns
from motes.fitting.losses import Floats
from motes.fitting.printed.formulas import Formula, Formulas, triangle_of
from motes.fitting.printed.rows import Rows, Target, Uniform, lane_function
from motes.graph.symbols import Symbol

#: What all texels share, in the order of the box: vectors of the columns, and numbers.
BOX = ("low", "high", "unit", "reduction", "rounding", "whole", "span", "least", "most", "rest")
NUMBERS = ("reduction", "rounding", "whole")
# What the arguments of a function are by their names: packed matrices, and numbers; all others are vectors.
_MATRICES = frozenset({"matrix", "bent", "inverse", "middle", "covariance"})
# Those that are summed, in which what belongs to different channels does not meet.
_SUMMED = frozenset({"matrix", "bent", "middle"})
_NUMBERS = frozenset({"objective", "ending", "brightness", "squares"})


def _rest(algebra: Formulas, x: Formula, matrix: Formula, brightness: Formula, columns: Columns) -> tuple[Formula, ...]:
    """The point with what is not seen at its default, and whether that is another point."""
    rested = steps.rested(algebra, x, steps.standing(algebra, x, matrix, columns, brightness).unseen, columns)
    return rested, algebra.total(absolute(algebra, rested - x))


def _inverse(algebra: Formulas, matrix: Formula, among: Formula, blurred: Formula) -> tuple[Formula, Formula]:
    """The inverse of the curvature among some columns; and what is blurred, that before included, with its number."""
    inverse = steps.inverted(algebra, matrix, among)
    now = algebra.maximum(blurred, inverse.blurred)
    return inverse.matrix, np.concatenate([now, algebra.total(now)])


def _polished(
    algebra: Formulas,
    x: Formula,
    objective: Formula,
    ending: Formula,
    brightness: Formula,
    squares: Formula,
    gradient: Formula,
    inverse: Formula,
    among: Formula,
    columns: Columns,
    whole: Formula,
) -> tuple[Formula, Formula]:
    """A last step by the gradient at the solution, which is summed from residuals and so sure to more digits than moments are; and whether that
    gradient says that the fit ended elsewhere."""
    box = levenberg.Box(columns.low, columns.high, columns.unit)
    moved = levenberg.polished(algebra, x, objective, ending, gradient, inverse, among, box)
    return moved, levenberg.adrift(algebra, squares / whole, brightness, ending, gradient, inverse, among)


def _errors(
    algebra: Formulas,
    x: Formula,
    stand: Formula,
    covariance: Formula,
    relaxed: Formula,
    loose: Formula,
    blurred: Formula,
    wider_blurred: Formula,
    columns: Columns,
) -> tuple[Formula, ...]:
    """Values and standard errors in the parameters' own units, verdicts, and 1 where these need a second look."""
    standing = steps.Standing(*np.split(stand, 4))
    errors = steps.errors(algebra, covariance, relaxed, wider_blurred, standing, blurred, columns, loose)
    value = steps.own_value(algebra, x, columns.squared)
    own = steps.own_error(algebra, x, errors.stderr, columns.squared)
    stderr = algebra.where(algebra.less(0.5, errors.known), own, float("nan"))
    codes = steps.judged(algebra, value, stderr, columns, errors.verdicts)
    return value, stderr, codes, second_look.asks(algebra, value, stderr, columns)


#: The functions by name: what each computes from the rows that are its arguments, and the rows that the results go to, all of them or one each.
FUNCTIONS: dict[str, tuple[Callable[..., Any], tuple[str, ...]]] = {
    "standing_at": (steps.standing, ("stand",)),
    "rest_at": (_rest, ("trial",)),
    # What is free and not blurred, or loose.
    "among_at": (lambda algebra, free, blurred, loose: algebra.maximum(free * (1.0 - blurred), loose), ("among",)),
    "inverse_at": (_inverse, ("inverse", "now_blurred")),
    "polished": (_polished, ("point",)),
    # A row of inverse middle inverse, from a column of the inverse.
    "row_at": (
        lambda algebra, column, inverse, middle: algebra.times(inverse, algebra.times(middle, column)),
        ("result",),
    ),
    # Its element on the diagonal, alone.
    "variance_at": (
        lambda algebra, column, middle: algebra.total(column * algebra.times(middle, column)),
        ("variance",),
    ),
    "noise_at": (steps.noise_of, ("noise",)),
    "push_at": (steps.pushed_out, ("firm",)),
    "errors_at": (_errors, ("found",)),
}


def _curvature(algebra: Formulas, bent: Formula, matrix: Formula) -> Array:
    """The curvature, or where that has no minimum the matrix of the steps."""
    return algebra.where(algebra.less(-algebra.largest(-algebra.diagonal(bent)), 0.0), matrix, bent)


def verdict_functions(signed: Floats, squared: Floats, robust: bool, apart: Collection[int]) -> list[str]:
    """All of them, for columns of which some are signed, or in the square of their parameter (1, else 0), and some `apart` (packed)."""
    of = tuple(signed.tolist()), tuple(squared.tolist()), frozenset(apart)
    functions = ({"curvature_at": (_curvature, ("curvature",))} if robust else {}) | FUNCTIONS
    return [_printed(name, step, targets, *of) for name, (step, targets) in functions.items()]


@lru_cache(maxsize=64)
def _printed(
    name: str,
    step: Callable[..., Any],
    targets: tuple[str, ...],
    signed: tuple[float, ...],
    squared: tuple[float, ...],
    apart: frozenset[int],
) -> str:
    """The text of a function; the forms of a fit have the same."""
    algebra, size = Formulas(), len(signed)
    box = {key: algebra.vector(key, 1 if key in NUMBERS else size) for key in BOX}
    vectors = {key: vector for key, vector in box.items() if key not in NUMBERS}
    held = {
        "signed": algebra.numbers(np.array(signed)),
        "squared": algebra.numbers(np.array(squared)),
        "fixed": algebra.numbers(np.zeros(size)),
    }
    given: dict[str, Any] = box | {"columns": Columns(**vectors, **held)}
    sources: list[Rows | Uniform] = []
    _, *arguments = inspect.signature(step).parameters
    for argument in arguments:
        if argument not in given:
            count = 1 if argument in _NUMBERS else 4 * size if argument == "stand" else size
            if argument in _MATRICES:
                one = algebra.matrix(argument, size, apart if argument in _SUMMED else ())
            else:
                one = algebra.vector(argument, count)
            given[argument] = one
            sources.append(Rows(argument, "D").all(_rows(algebra, one)))
    if "columns" in arguments:
        sources.append(Uniform("box", tuple(leaf for vector in box.values() for leaf in vector)))
    found = step(algebra, **{argument: given[argument] for argument in arguments})
    parts = [_rows(algebra, part) for part in (found if isinstance(found, tuple) else (found,))]
    parts = parts if len(parts) == len(targets) else [[symbol for part in parts for symbol in part]]
    return lane_function(name, sources, [Target(to, "D", part) for to, part in zip(targets, parts, strict=True)])


def _rows(algebra: Formulas, formula: Formula) -> list[Symbol]:
    return algebra.lifted(triangle_of(formula) if formula.ndim == 2 else formula)
