"""Derive the polynomials of `motes.printing.elementary` and `motes.models.beckmann`: minimax fits (Remez) in 40-digit arithmetic, rounded.

    python tools/minimax.py            # prints the tables that the two hold

Each is the polynomial P of a given degree with the smallest largest |weight(x) (F(x) - P(x))| on an interval:

- exp(r) = 1 + r + r^2 P(r) on |r| <= ln(2)/2, the weight that of a relative error of exp(r) - 1, so that expm1 can share it;
- 2^r = 1 + r P(r) on |r| <= 1/2, a relative error of 2^r - 1;
- asin(x) = x + x^3 P(x^2) on 0 <= x <= 0.7072, a relative error of asin(x);
- sin(x) = x + x^3 P(x^2) and cos(x) = 1 - x^2/2 + x^4 P(x^2) on 0 <= x <= pi/4, relative errors of sin(x) and cos(x);
- 1/sqrt(pi) - a exp(a^2) erfc(a) = P(t), t = (a - 2)/(a + 2), on 0 <= a <= 6, weighted by the exp(-a^2) that multiplies it in Beckmann's masking.

ln(2) is split in two numbers, the first short enough that its product with any exponent is exact, and pi/2 in more,
all but the last of which have products with small numbers that are.
"""

from __future__ import annotations

from collections.abc import Callable

import mpmath as mp
import numpy as np

mp.mp.dps = 40
Function = Callable[[mp.mpf], mp.mpf]


def remez(F: Function, weight: Function, a: float, b: float, degree: int) -> tuple[list[mp.mpf], mp.mpf]:
    """Coefficients, lowest first, and the largest weighted error."""
    # The extrema are sought on a fixed grid that crowds the ends, as the extrema do.
    grid = [mp.mpf(a) + (mp.mpf(b) - a) * (1 - mp.cos(mp.pi * k / 4000)) / 2 for k in range(4001)]
    grid = [x for x in grid if abs(x) > 1e-6]  # weights vanish at 0
    values, weights = [F(x) for x in grid], [weight(x) for x in grid]
    middle = [(1 - np.cos(np.pi * k / (degree + 1))) / 2 for k in range(degree + 2)]
    points = [min(range(len(grid)), key=lambda j, t=t: abs(grid[j] - (a + (b - a) * t))) for t in middle]
    for _ in range(60):
        rows = mp.matrix(degree + 2, degree + 2)
        right = mp.matrix(degree + 2, 1)
        for i, j in enumerate(points):
            for power in range(degree + 1):
                rows[i, power] = grid[j] ** power
            rows[i, degree + 1] = (-1) ** i / weights[j]
            right[i] = values[j]
        solution = mp.lu_solve(rows, right)
        coefficients, level = [solution[k] for k in range(degree + 1)], abs(solution[degree + 1])
        errors = [w * (v - mp.polyval(coefficients[::-1], x)) for x, v, w in zip(grid, values, weights, strict=True)]
        # One extremum from every run of errors of one sign; of too many, drop the smaller end.
        runs: list[list[int]] = [[0]]
        for j in range(1, len(grid)):
            if mp.sign(errors[j]) == mp.sign(errors[runs[-1][0]]):
                runs[-1].append(j)
            else:
                runs.append([j])
        extrema = [max(run, key=lambda j: abs(errors[j])) for run in runs]
        while len(extrema) > degree + 2:
            extrema.pop(0 if abs(errors[extrema[0]]) < abs(errors[extrema[-1]]) else -1)
        if len(extrema) < degree + 2:
            raise ArithmeticError(f"only {len(extrema)} extrema for degree {degree}")
        points, largest = extrema, max(abs(e) for e in errors)
        if largest < level * mp.mpf("1.0001"):
            return coefficients, largest
    raise ArithmeticError("Remez did not converge")


def main() -> None:
    def exp_tail(r: mp.mpf) -> mp.mpf:
        return (mp.expm1(r) - r) / (r * r)

    def power(r: mp.mpf) -> mp.mpf:
        return (2**r - 1) / r

    def asin_tail(z: mp.mpf) -> mp.mpf:
        x = mp.sqrt(z)
        return (mp.asin(x) - x) / (x * z)

    def sin_tail(z: mp.mpf) -> mp.mpf:
        x = mp.sqrt(z)
        return (mp.sin(x) - x) / (x * z)

    def cos_tail(z: mp.mpf) -> mp.mpf:
        return (mp.cos(mp.sqrt(z)) - 1 + z / 2) / (z * z)

    def slope(t: mp.mpf) -> mp.mpf:
        return 2 * (1 + t) / (1 - t)

    def masked(t: mp.mpf) -> mp.mpf:
        a = slope(t)
        return 1 / mp.sqrt(mp.pi) - a * mp.exp(a * a) * mp.erfc(a)

    half, eighth = mp.log(2) / 2, (mp.pi / 4) ** 2
    fits = (
        ("EXP", exp_tail, lambda r: r * r / abs(mp.expm1(r)), -half, half, {np.float32: 4, np.float64: 9}),
        (
            "EXP2",
            power,
            lambda r: r / (2**r - 1),
            mp.mpf("-0.5"),
            mp.mpf("0.5"),
            {np.float32: 4, np.float64: 10},
        ),
        (
            "ASIN",
            asin_tail,
            lambda z: z ** mp.mpf(1.5) / mp.asin(mp.sqrt(z)),
            0,
            mp.mpf("0.7072") ** 2,
            {np.float32: 6, np.float64: 17},
        ),
        (
            "SIN",
            sin_tail,
            lambda z: z ** mp.mpf(1.5) / mp.sin(mp.sqrt(z)),
            0,
            eighth,
            {np.float32: 2, np.float64: 5},
        ),
        ("COS", cos_tail, lambda z: z * z / mp.cos(mp.sqrt(z)), 0, eighth, {np.float32: 2, np.float64: 5}),
        ("MASKED", masked, lambda t: mp.exp(-(slope(t) ** 2)), -1, 0.5, {np.float64: 14}),
    )
    for name, F, weight, a, b, degrees in fits:
        for scalar, degree in degrees.items():
            coefficients, error = remez(F, weight, a, b, degree)
            bits = mp.log(error, 2)
            print(f"# {name}, {scalar.__name__}: degree {degree}, error 2^{float(bits):.1f}")
            for c in coefficients:
                print(f"    {scalar(mp.nstr(c, 25))!r},")
    for scalar, places in ((np.float32, 14), (np.float64, 32)):
        high = mp.floor(mp.log(2) * 2**places) / 2**places
        print(f"# ln(2), {scalar.__name__}:\n    {scalar(float(high))!r}, {scalar(mp.nstr(mp.log(2) - high, 25))!r}")
    for scalar, cuts in ((np.float32, (11, 22, 33)), (np.float64, (33, 66))):
        rest, parts = mp.pi / 2, []
        for places in cuts:
            part = mp.floor(rest * 2**places) / 2**places
            parts.append(scalar(float(part)))
            rest -= part
        print(f"# pi/2, {scalar.__name__}:\n    {(*parts, scalar(mp.nstr(rest, 25)))!r}")


if __name__ == "__main__":
    main()
