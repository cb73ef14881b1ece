"""How far residuals are alike, against fields whose correlation is known, and how many blocks that asks for."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from motes.directions import from_spherical
from motes.fitting.alike import APART, FEWEST, MOST, MOST_DIRECTIONS, SIDE, STEP, count_of_blocks, distance_alike
from motes.measurements import Measurement
from scattered_directions import scattered

Floats = NDArray[np.float64]


def independent(count: int, channels: int = 3, seed: int = 2) -> Floats:
    return np.random.default_rng(seed).standard_normal((1, count, channels))


@pytest.mark.parametrize("length", [0.1, 0.2, 0.4])
def test_the_distance_is_that_at_which_a_known_correlation_is_lost(length: float) -> None:
    rng = np.random.default_rng(1)
    at = rng.uniform(0, 1.5, (300, 3))
    # Draws from the normal distribution of this covariance, by its root: no random waves, no blocks.
    apart = np.linalg.norm(at[:, None] - at[None], axis=-1)
    values, vectors = np.linalg.eigh(np.exp(-0.5 * (apart / length) ** 2))
    sums = rng.standard_normal((400, 300)) @ (vectors * np.sqrt(np.maximum(values, 0.0))).T
    assert abs(distance_alike(at, sums) - length * math.sqrt(-2 * math.log(APART))) < STEP
    assert distance_alike(at, rng.standard_normal((400, 300))) == 0.5 * STEP


def test_the_distance_is_that_of_pairs_taken_one_by_one() -> None:
    rng = np.random.default_rng(7)
    for count, scans, wave in ((40, 1, 3.0), (90, 2, 5.0), (90, 1, 9.0)):
        at = rng.uniform(0, 1.2, (count, 3))
        sums = np.sin(wave * at.sum(axis=1) + np.arange(scans)[:, None]) + 0.2 * rng.standard_normal((scans, count))
        products: dict[int, list[float]] = {}
        for i, j in itertools.combinations(range(count), 2):
            products.setdefault(int(math.dist(at[i], at[j]) / STEP), []).append(float(sums[:, i] @ sums[:, j]))
        least = APART * np.mean(np.sum(sums**2, axis=0))
        first = next(step for step in sorted(products) if np.mean(products[step]) < least)
        assert distance_alike(at, sums) == pytest.approx(STEP * (first + 0.5))


def test_steps_in_which_no_pair_lies_say_nothing_and_what_is_alike_everywhere_is_one() -> None:
    lattice = np.stack(np.meshgrid(*[np.arange(5) * 0.2] * 3), axis=-1).reshape(-1, 3)
    found = distance_alike(lattice, independent(125)[..., 0])
    assert found == pytest.approx(STEP * 3.5)  # 0.2 is in the step from 0.18 to 0.24
    assert distance_alike(lattice, np.ones((1, 125))) > 0.8 * math.sqrt(3) - STEP
    assert distance_alike(lattice, np.zeros((1, 125))) > 0.8 * math.sqrt(3) - STEP


def test_independent_residuals_get_the_most_blocks_and_broad_ones_the_fewest() -> None:
    wi, wo = scattered(400)
    assert count_of_blocks(wi, wo, independent(400)) == MOST
    assert count_of_blocks(wi, wo, np.ones((1, 400, 3))) == FEWEST
    between = (np.sin(6.5 * wi[:, 2]) * np.sin(6.5 * wo[:, 2]))[None, :, None]
    counts = [count_of_blocks(wi, wo, between, side) for side in (SIDE + 0.2, SIDE, SIDE - 0.1)]
    assert FEWEST < counts[0] < counts[1] < counts[2] < MOST
    assert count_of_blocks(wi, wo, between) == count_of_blocks(wi, wo, between, SIDE) == counts[1]


def test_what_goes_together_in_each_scan_does_though_scans_differ() -> None:
    wi, wo = scattered(400)
    signs = np.resize([1.0, -1.0], 6)[:, None, None]
    assert count_of_blocks(wi, wo, signs * np.ones((6, 400, 3))) == FEWEST


def test_directions_in_one_plane_are_cut_along_what_they_vary_in() -> None:
    light, view = np.meshgrid(np.linspace(0, 1.3, 20), np.linspace(-1.3, 1.3, 20))
    wi, wo = (from_spherical(np.abs(angle.ravel()), np.where(angle.ravel() < 0, np.pi, 0.0)) for angle in (light, view))
    assert count_of_blocks(wi, wo, independent(400)) > 2 * FEWEST
    assert count_of_blocks(wi, wo, np.ones((1, 400, 3))) == FEWEST


def test_many_directions_are_told_by_a_part_of_them_in_any_order() -> None:
    count, side = 5 * MOST_DIRECTIONS, 1.5
    wi, wo = scattered(count)
    broad = (np.sin(6 * wi[:, 2]) * np.sin(6 * wo[:, 2]))[None, :, None]
    assert FEWEST < count_of_blocks(wi, wo, broad + 0.5 * independent(count, 1), side) < MOST
    order = np.random.default_rng(3).permutation(count)
    found = []
    for noise in np.linspace(0.1, 1.5, 15):  # another part of the directions would give another count for some of these
        misses = broad + noise * independent(count, 1)
        found.append(count_of_blocks(wi, wo, misses, side))
        assert count_of_blocks(wi[order], wo[order], misses[:, order], side) == found[-1]
    assert len(set(found)) > 2


def test_a_fit_has_blocks_as_long_as_its_residuals_are_alike() -> None:
    wi, wo = scattered(400)
    surface = motes.OrenNayar(K_d=(0.6, 0.4, 0.25), sigma_d=0.4)
    noise = 1 + 0.02 * independent(400)[0]
    right = Measurement.from_arrays(wi, wo, surface.eval(wi, wo) * noise)
    assert motes.fit(right, "oren_nayar", errors="blocks").errors.blocks == MOST
    assert motes.fit(right, "lambert", errors="blocks").errors.blocks < MOST // 2


def test_places_that_cannot_be_cut_into_a_few_even_blocks_are_cut_as_they_can_be() -> None:
    # One place of 100 pairs and seven of 14: cut in eight, half of the blocks would have to lie in the first.
    theta = np.repeat(np.linspace(0.0, 1.2, 8), [100] + [14] * 7)
    wi, wo = from_spherical(theta, 0.0), from_spherical(theta, np.pi)
    values = np.cos(theta)[:, None] * np.ones(3) / np.pi
    assert motes.fit(Measurement.from_arrays(wi, wo, values), "lambert", errors="blocks").errors.blocks == 8
