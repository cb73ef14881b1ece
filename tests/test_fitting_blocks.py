"""Blocks of directions: what they keep together, how even and how compact they are."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.directions import from_half_difference, from_spherical
from motes.fitting.direction_blocks import BLOCKS, LEAST_DIRECTIONS, SAME, blocks_of, coordinates, end_of_first
from scattered_directions import scattered

Floats = NDArray[np.float64]


def turned(w: Floats, angle: Floats) -> Floats:
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * w[:, 0] - s * w[:, 1], s * w[:, 0] + c * w[:, 1], w[:, 2]], axis=-1)


def same_partition(a: NDArray[np.intp], b: NDArray[np.intp]) -> bool:
    return len(set(zip(a.tolist(), b.tolist(), strict=True))) == a.max() + 1 == b.max() + 1


@pytest.mark.parametrize("single", [False, True])
def test_what_an_isotropic_surface_cannot_tell_apart_is_in_one_block(single: bool) -> None:
    wi, wo = scattered(300)
    angle = np.random.default_rng(1).uniform(0, 6, 300)
    mirrored = np.array([1.0, -1.0, 1.0])
    others = [(wo, wi), (turned(wi, angle), turned(wo, angle)), (wi * mirrored, wo * mirrored)]
    every_wi, every_wo = (np.concatenate([pair[k] for pair in [(wi, wo), *others]]) for k in (0, 1))
    if single:  # as files have them
        every_wi, every_wo = (w.astype(np.float32).astype(float) for w in (every_wi, every_wo))
    labels = blocks_of(every_wi, every_wo).reshape(4, 300)
    assert (labels == labels[0]).all()
    assert labels.max() == BLOCKS - 1


def test_coordinates_are_the_angles_that_directions_are_made_from() -> None:
    rng = np.random.default_rng(3)
    theta_h, theta_d, phi_d, phi_h = rng.uniform(0, 1, (4, 500)) * np.array([[1.2], [0.35], [6.2], [6.2]])
    folded = np.abs(np.arcsin(np.sin(phi_d)))
    expected = np.stack([theta_h, theta_d, np.sin(theta_h) * np.sin(theta_d) * folded], axis=-1)
    np.testing.assert_allclose(coordinates(*from_half_difference(theta_h, theta_d, phi_d, phi_h)), expected, atol=1e-12)


def test_azimuth_means_nothing_where_light_and_viewer_mirror_each_other_or_meet() -> None:
    wi, wo = scattered(200)
    for theta_h, theta_d in ((0.0, 0.6), (0.6, 0.0)):
        phi = np.linspace(0, np.pi, 40)
        ring_wi, ring_wo = from_half_difference(theta_h, theta_d, phi)
        labels = blocks_of(np.concatenate([wi, ring_wi]), np.concatenate([wo, ring_wo]))
        assert len(set(labels[200:].tolist())) == 1


@pytest.mark.parametrize(("count", "step"), [(5000, 0.0), (20_000, 0.0), (20_000, 1e-3), (20_000, 0.05)])
def test_a_cut_that_is_looked_for_nearby_is_the_one_that_sorting_finds(count: int, step: float) -> None:
    """With `step` many pairs are at one place, and near the middle there may be no cut."""
    rng = np.random.default_rng(count)
    along = rng.uniform(0, 1.5, count)
    along = np.round(along / step) * step if step else along
    for share in (0.5, 1 / 3, 2 / 5, 0.02):
        order = np.sort(along)
        cuts = np.array(
            [k for k in range(LEAST_DIRECTIONS, count - LEAST_DIRECTIONS + 1) if order[k] - order[k - 1] > SAME]
        )
        expected = order[cuts[np.argmin(np.abs(cuts - share * count))]]
        assert end_of_first(along, share) == expected
    assert end_of_first(np.full(count, 0.3), 0.5) is None


def test_the_order_of_directions_does_not_matter() -> None:
    wi, wo = scattered(311)
    order = np.random.default_rng(2).permutation(311)
    labels = blocks_of(wi, wo)
    assert (blocks_of(wi[order], wo[order]) == labels[order]).all()
    assert (blocks_of(wi, wo) == labels).all()


@pytest.mark.parametrize("count", [1, 2, 5, 10, 24, 60])
def test_blocks_are_as_many_as_asked_for_and_even(count: int) -> None:
    sizes = np.bincount(blocks_of(*scattered(1000), count))
    assert len(sizes) == count
    assert sizes.min() >= LEAST_DIRECTIONS
    assert sizes.max() <= sizes.min() + 2


def test_blocks_are_compact() -> None:
    wi, wo = scattered(2000)
    labels = blocks_of(wi, wo)
    half = (wi + wo) / np.linalg.norm(wi + wo, axis=1, keepdims=True)
    theta_h, theta_d = (np.arccos(np.clip((half * w).sum(axis=1), -1, 1)) for w in (np.array([0.0, 0.0, 1.0]), wi))
    for angle in (theta_h, theta_d):  # far narrower than what is left of them when labels are drawn by lot
        spread = np.array([angle[labels == k].std() for k in range(labels.max() + 1)])
        assert np.sqrt(np.mean(spread**2)) < 0.6 * angle.std()


def test_few_directions_and_few_places_make_few_blocks() -> None:
    assert blocks_of(*scattered(LEAST_DIRECTIONS - 1)).tolist() == [0] * (LEAST_DIRECTIONS - 1)
    assert np.bincount(blocks_of(*scattered(30))).min() >= LEAST_DIRECTIONS
    wi, wo = scattered(5)
    labels = blocks_of(np.repeat(wi, 20, axis=0), np.repeat(wo, 20, axis=0))
    assert same_partition(labels, np.repeat(np.arange(5), 20))
    assert blocks_of(np.zeros((0, 3)), np.zeros((0, 3))).tolist() == []


def test_a_grid_of_angles_is_cut_between_its_planes() -> None:
    theta = np.linspace(0.0, 1.2, 7)
    i, o, phi = (a.ravel() for a in np.meshgrid(theta, theta, np.linspace(0, np.pi, 9), indexing="ij"))
    wi, wo = from_spherical(i, 0.0 * phi), from_spherical(o, phi)
    labels = blocks_of(wi, wo).reshape(7, 7, 9)
    assert (labels == labels.transpose(1, 0, 2)).all()
    assert labels.max() == BLOCKS - 1
