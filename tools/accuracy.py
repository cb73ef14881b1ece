"""Measure how exact the equations and the models are, and print the tables of docs/accuracy.md.

    python tools/accuracy.py            # needs the development extras: mpmath, scipy, pytest

The reference values, the models and their known integrals are those of the tests (tests/golden, tests/catalogue.py).
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import golden
from catalogue import ENTRIES, dense_albedo, direction, reference, upper_directions
from golden.equations import EQUATIONS
from motes.arrays import NUMPY
from motes.models import BRDF, Conductor, Dielectric, Dust, Lambert, OrenNayar, TorranceSparrow

Floats = NDArray[np.float64]
PAIRS = 40_000
STEEPEST = 1.55  # rad


class Row(NamedTuple):
    """A line of a table: what, and the errors measured."""

    what: str
    errors: tuple[float, ...]


def largest(got: Any, expected: Floats, floor: Any = 1e-300) -> float:
    """The largest error relative to the expected value, or to `floor` where that is larger."""
    got = np.asarray(got, np.float64)
    return float(np.max(np.abs(got - expected) / np.maximum(np.abs(expected), floor)))


def equations() -> Iterator[Row]:
    """Each equation given its own arguments, in float64."""
    rows = golden.appendices()
    for name, equation in EQUATIONS.items():
        if equation.column and name not in ("alpha", "beta"):
            yield Row(f"`{name}`", (largest(equation.evaluate(NUMPY, rows), rows[equation.column]),))


def models() -> Iterator[Row]:
    """Models from directions to values, in float64."""
    rows = golden.appendices()
    for entry in ENTRIES:
        model, expected = entry.at_rows(rows)
        yield Row(f"`{entry.name}`", (largest(model.eval(rows["wi"], rows["wo"])[:, 0], expected),))
    for name, model in (("torrance_sparrow", TorranceSparrow), ("dust", Dust)):
        rows = golden.scatmech("copied", name)
        value = model(1.0, rows["parameter"]).eval(rows["wi"], rows["wo"])[:, 0]
        yield Row(f"`{name}` of SCATMECH", (largest(value, rows["value"]),))


def anywhere() -> tuple[Floats, Floats]:
    """Pairs of directions, uniform over the hemisphere down to `STEEPEST`."""
    wi, wo = upper_directions(PAIRS, 1), upper_directions(PAIRS, 2)
    keep = np.minimum(wi[:, 2], wo[:, 2]) >= np.cos(STEEPEST)
    return wi[keep], wo[keep]


def near_the_mirror(width: float) -> tuple[Floats, Floats]:
    """Pairs about the mirror direction, as near as `width` and as far as six times that."""
    wi, _ = anywhere()
    rng = np.random.default_rng(3)
    wo = wi * np.array([-1, -1, 1]) + 6 * width * rng.random((len(wi), 1)) * rng.normal(size=wi.shape)
    wo /= np.linalg.norm(wo, axis=-1, keepdims=True)
    keep = wo[:, 2] >= np.cos(STEEPEST)
    return wi[keep], wo[keep]


def in_float32(model: BRDF, floor: float, *samples: tuple[Floats, Floats]) -> tuple[float, float]:
    """The largest relative errors of float32 where the value is at least `floor`: on the same rounded directions, and with their rounding."""
    same, rounded = [], []
    for wi, wo in samples:
        wi32, wo32 = wi.astype(np.float32), wo.astype(np.float32)
        value = reference(model, wi32, wo32)
        assert value.dtype == np.float32
        exact, asked = reference(model, wi32.astype(float), wo32.astype(float)), reference(model, wi, wo)
        there = exact >= floor
        same.append(largest(value[there], exact[there]))
        rounded.append(largest(value[there], asked[there]))
    return max(same), max(rounded)


def float32() -> Iterator[Row]:
    """Models in float32."""
    for name, model in (
        ("Lambert", Lambert(0.8)),
        ("Dust, g = 0", Dust(1.0, 0.0)),
        ("Dust, g = 0.95", Dust(1.0, 0.95)),
    ):
        yield Row(name, in_float32(model, 0.0, anywhere(), near_the_mirror(0.05)))
    for sigma_d in (0.1, 0.4, 1.0, 1.5):
        least = 0.1 / np.pi
        yield Row(
            f"OrenNayar, sigma_d = {sigma_d}, where f >= 0.1 K_d / pi",
            in_float32(OrenNayar(1.0, sigma_d), least, anywhere(), near_the_mirror(0.05)),
        )
    for sigma_s in (0.6, 0.15, 0.03, 0.01):
        for least in (1e-4, 1e-30):
            yield Row(
                f"TorranceSparrow, sigma_s = {sigma_s}, where f >= {least:g} K_s / 4",
                in_float32(TorranceSparrow(1.0, sigma_s), least / 4, anywhere(), near_the_mirror(sigma_s)),
            )
    for fresnel in (Dielectric(1.5), Conductor(0.14, 4.0)):
        model = TorranceSparrow(1.0, 0.3, fresnel=fresnel)
        yield Row(
            f"TorranceSparrow, sigma_s = 0.3, {fresnel}", in_float32(model, 1e-5, anywhere(), near_the_mirror(0.3))
        )


def float32_at_reference_rows() -> Iterator[Row]:
    """Models in float32 against 50-digit arithmetic, theta <= 1.55."""
    rows = golden.appendices()
    chosen = np.maximum(rows["theta_i"], rows["theta_r"]) <= STEEPEST
    rows = {name: column[chosen] for name, column in rows.items()}
    wi, wo = rows["wi"].astype(np.float32), rows["wo"].astype(np.float32)
    for entry in ENTRIES:
        if entry.name in ("lambert", "oren_nayar", "torrance_sparrow", "dust_forward", "dust_layer"):
            model, expected = entry.at_rows(rows)
            there = expected > 2.5e-5
            yield Row(f"`{entry.name}`", (largest(model.eval(wi, wo)[there, 0], expected[there]),))


def albedo() -> Iterator[Row]:
    """`directional_albedo` with its default nodes against a dense rule."""
    for theta_i in (0.0, 1.0, 1.45, 1.55):
        wi = direction(theta_i, 0.4)
        errors = {e.name: largest(e.model.directional_albedo(wi), dense_albedo(e.model, wi), 1.0) for e in ENTRIES}
        worst = max(errors, key=errors.__getitem__)
        yield Row(f"theta_i = {theta_i} rad, the worst model (`{worst}`)", (errors[worst],))


TABLES = {
    "Equations": (equations, "equation", ("largest relative error",)),
    "Models": (models, "model", ("largest relative error",)),
    "Float32": (float32, "model", ("given the rounded directions", "with the rounding of directions")),
    "Float32 against the reference": (float32_at_reference_rows, "model", ("largest relative error",)),
    "Directional albedo": (albedo, "incidence", ("largest error",)),
}


def tables() -> Iterator[tuple[str, list[Row]]]:
    """The title and the rows of each table."""
    for title, (rows, _, _) in TABLES.items():
        yield title, list(rows())


def rounded_up(error: float) -> str:
    """Two digits, never less than the error."""
    if error == 0:
        return "0"
    power = np.floor(np.log10(error)) - 1
    return f"{np.ceil(error / 10**power - 1e-9) * 10**power:.1e}"


def main() -> None:
    for title, rows in tables():
        _, what, columns = TABLES[title]
        print(f"<!-- table: {title} -->")
        print(f"| {what} | {' | '.join(columns)} |\n|---|{'---|' * len(columns)}")
        for row in rows:
            print(f"| {row.what} | {' | '.join(rounded_up(error) for error in row.errors)} |")
        print()


if __name__ == "__main__":
    main()
