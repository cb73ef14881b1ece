"""The models beside those of the appendices: values of independent origin, white furnaces, limits, and how well they sample."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.testing import assert_allclose

import golden
from catalogue import column, dense_albedo, direction, upper_directions
from motes.models import EON, Lambert

# ---------------------------------------------------------------- EON


def test_eon_of_the_table() -> None:
    """50-digit values that others computed, at edges of the domain as well."""
    rows = golden.extended()
    value = EON(column(rows["rho"]), rows["r"]).eval(rows["wi"], rows["wo"])[:, 0]
    assert_allclose(value, rows["f_eon"], rtol=1e-10)


@pytest.mark.parametrize("r", [0.0, 0.1, 0.5, 1.0])
@pytest.mark.parametrize("theta_i", [0.0, 0.6, 1.2, 1.5, 1.56])
def test_a_white_eon_is_a_white_furnace(r: float, theta_i: float) -> None:
    """All light comes back, from every direction, at every roughness; 2e-6 is the quadrature's at 1.56 rad."""
    assert_allclose(dense_albedo(EON(1.0, r), direction(theta_i)), 1.0, rtol=4e-6)


def test_a_smooth_eon_is_lambert() -> None:
    wi, wo = upper_directions(500, 1), upper_directions(500, 2)
    assert_allclose(EON((0.9, 0.2), 0.0).eval(wi, wo), Lambert((0.9, 0.2)).eval(wi, wo), rtol=1e-14)


def test_eon_is_continuous_where_its_two_forms_meet() -> None:
    wi = direction(0.7)
    one, other = (EON(0.8, 1.0).eval(wi, direction(0.9, np.pi / 2 + d)) for d in (-1e-9, 1e-9))
    assert_allclose(one, other, rtol=1e-8)
