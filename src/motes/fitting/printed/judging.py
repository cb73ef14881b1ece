"""The steps of `motes.fitting.covariance`, as functions of rows: from the normal equations at a solution to standard errors and verdicts."""

from __future__ import annotations

import numpy as np

from motes.fitting import covariance, second_look
from motes.fitting.algebra import absolute
from motes.fitting.columns import Columns
from motes.fitting.losses import Floats
from motes.fitting.printed.formulas import Formula, Formulas, triangle_of
from motes.fitting.printed.rows import Rows, Target, Uniform, lane_function

#: What all texels share, in the order of the box: vectors of the columns, and numbers.
BOX = ("low", "high", "reduction", "rounding", "whole", "span", "least", "most", "rest")
NUMBERS = ("reduction", "rounding", "whole")


class _Printed:
    """The functions for so many coefficients; rows of packed matrices, of (P,) vectors and of single numbers."""

    def __init__(self, signed: Floats, squared: Floats) -> None:
        self.size = len(signed)
        self.signed, self.squared = signed, squared

    def start(self) -> tuple[Formulas, Columns, Uniform]:
        """A new graph, and the columns of its vectors."""
        algebra = Formulas()
        box = {name: algebra.number(name) if name in NUMBERS else algebra.vector(name, self.size) for name in BOX}
        columns = Columns(
            **{name: box[name] for name in BOX if name not in NUMBERS},
            signed=algebra.numbers(self.signed),
            squared=algebra.numbers(self.squared),
            fixed=algebra.numbers(np.zeros(self.size)),
        )
        return algebra, columns, Uniform("box", tuple(leaf for vector in box.values() for leaf in vector))

    @staticmethod
    def rows(**given: Formula) -> list[Rows | Uniform]:
        return [
            Rows(name, "D").put(triangle_of(formula) if formula.ndim == 2 else list(formula))
            for name, formula in given.items()
        ]

    def curvature(self) -> str:
        """``curvature_at``: the curvature, or where that has no minimum the matrix of the steps."""
        algebra = Formulas()
        bent, matrix = algebra.matrix("bent", self.size), algebra.matrix("matrix", self.size)
        least = -algebra.largest(-algebra.diagonal(bent))
        result = algebra.where(algebra.less(least, 0.0), matrix, bent)
        return lane_function(
            "curvature_at", self.rows(bent=bent, matrix=matrix), [Target("curvature", "D", triangle_of(result))]
        )

    def standing(self) -> str:
        """``standing_at``: at the lower bound, at the upper one, not seen, free."""
        algebra, columns, box = self.start()
        x, curvature = algebra.vector("x", self.size), algebra.matrix("curvature", self.size)
        bright = algebra.number("bright")
        stand = covariance.standing(algebra, x, curvature, columns, bright)
        results = [item for part in stand for item in algebra.lifted(part)]
        return lane_function(
            "standing_at", [*self.rows(x=x, curvature=curvature, bright=bright), box], [Target("stand", "D", results)]
        )

    def rest(self) -> str:
        """``rest_at``: the point with what is not seen at its default, and whether that is another point."""
        algebra, columns, box = self.start()
        x, matrix = algebra.vector("x", self.size), algebra.matrix("matrix", self.size)
        bright = algebra.number("bright")
        unseen = covariance.standing(algebra, x, matrix, columns, bright).unseen
        rested = covariance.rested(algebra, x, unseen, columns)
        moved = algebra.total(absolute(algebra, rested - x))
        return lane_function(
            "rest_at",
            [*self.rows(x=x, matrix=matrix, bright=bright), box],
            [Target("trial", "D", [*algebra.lifted(rested), *algebra.lifted(moved)])],
        )

    def among(self) -> str:
        """``among_at``: what is free and not blurred, or loose."""
        algebra = Formulas()
        free, blurred, loose = (algebra.vector(name, self.size) for name in ("free", "blurred", "loose"))
        result = algebra.maximum(free * (1.0 - blurred), loose)
        return lane_function(
            "among_at",
            self.rows(free=free, blurred=blurred, loose=loose),
            [Target("among", "D", algebra.lifted(result))],
        )

    def inverse(self) -> str:
        """``inverse_at``: the inverse of the curvature among some columns, and what is blurred, those before included, with their number."""
        algebra = Formulas()
        curvature, among = algebra.matrix("curvature", self.size), algebra.vector("among", self.size)
        before = algebra.vector("blurred", self.size)
        inverse = covariance.inverted(algebra, curvature, among)
        blurred = algebra.maximum(before, inverse.blurred)
        return lane_function(
            "inverse_at",
            self.rows(curvature=curvature, among=among, blurred=before),
            [
                Target("inverse", "D", algebra.lifted(triangle_of(inverse.matrix))),
                Target("now_blurred", "D", [*algebra.lifted(blurred), *algebra.lifted(algebra.total(blurred))]),
            ],
        )

    def row(self) -> str:
        """``row_at``: a row of inverse middle inverse, from a column of the inverse."""
        algebra = Formulas()
        inverse, middle = algebra.matrix("inverse", self.size), algebra.matrix("middle", self.size)
        column = algebra.vector("column", self.size)
        result = algebra.times(inverse, algebra.times(middle, column))
        given = self.rows(column=column, inverse=inverse, middle=middle)
        return lane_function("row_at", given, [Target("result", "D", algebra.lifted(result))])

    def noise(self) -> str:
        """``noise_at``: the variance of a residual."""
        algebra = Formulas()
        curvature, middle = algebra.matrix("curvature", self.size), algebra.matrix("middle", self.size)
        among = algebra.vector("among", self.size)
        noise = covariance.noise_of(algebra, curvature, middle, among)
        return lane_function(
            "noise_at",
            self.rows(curvature=curvature, middle=middle, among=among),
            [Target("noise", "D", algebra.lifted(noise))],
        )

    def push(self) -> str:
        """``push_at``: 1 where the data push a parameter out."""
        algebra = Formulas()
        unit, gradient, column, among = (
            algebra.vector(name, self.size) for name in ("unit", "gradient", "column", "among")
        )
        inverse, middle = algebra.matrix("inverse", self.size), algebra.matrix("middle", self.size)
        firm = covariance.pushed_out(algebra, unit, gradient, column, inverse, middle, among)
        given = self.rows(unit=unit, gradient=gradient, column=column, inverse=inverse, middle=middle, among=among)
        return lane_function("push_at", given, [Target("firm", "D", algebra.lifted(firm))])

    def errors(self) -> str:
        """``errors_at``: values and standard errors in the parameters' own units, verdicts, and 1 where these need a second look."""
        algebra, columns, box = self.start()
        size = self.size
        x, stand = algebra.vector("x", size), algebra.vector("stand", 4 * size)
        sandwich, relaxed = algebra.matrix("covariance", size), algebra.vector("relaxed", size)
        loose = algebra.vector("loose", size)
        blurred, wider_blurred = algebra.vector("blurred", size), algebra.vector("wider_blurred", size)
        standing = covariance.Standing(*(stand[k * size : (k + 1) * size] for k in range(4)))
        errors = covariance.errors(algebra, sandwich, relaxed, wider_blurred, standing, blurred, columns, loose)
        value = covariance.own_value(algebra, x, columns.squared)
        own = covariance.own_error(algebra, x, errors.stderr, columns.squared)
        stderr = algebra.where(algebra.less(0.5, errors.known), own, float("nan"))
        codes = covariance.judged(algebra, value, stderr, columns, errors.verdicts)
        given = self.rows(
            x=x, stand=stand, covariance=sandwich, relaxed=relaxed, loose=loose, blurred=blurred, wider_blurred=wider_blurred
        )  # fmt: skip
        asks = second_look.asks(algebra, value, stderr, columns)
        results = [item for part in (value, stderr, codes, asks) for item in algebra.lifted(part)]
        return lane_function("errors_at", [*given, box], [Target("found", "D", results)])


def verdict_functions(signed: Floats, squared: Floats, robust: bool) -> list[str]:
    """All of them, for columns of which some are signed, or in the square of their parameter (1, else 0)."""
    printed = _Printed(signed, squared)
    return [
        *([printed.curvature()] if robust else []),
        printed.standing(),
        printed.rest(),
        printed.among(),
        printed.inverse(),
        printed.row(),
        printed.noise(),
        printed.push(),
        printed.errors(),
    ]
