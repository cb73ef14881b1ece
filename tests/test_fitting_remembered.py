"""What is found once of a measurement and remembered: it is of that measurement alone, and of the file as it is."""

from __future__ import annotations

import gc
import os
from pathlib import Path

import numpy as np
import pytest

from motes.directions import from_spherical
from motes.fitting import direction_blocks
from motes.fitting.direction_blocks import blocks_of
from motes.fitting.origin_of_fit import _file_digest, digest, origin_of
from motes.measurements import Measurement
from motes.measurements.doubts import implausible


def measured(values: float, seed: int = 1) -> Measurement:
    rng = np.random.default_rng(seed)
    wi, wo = (from_spherical(rng.uniform(0, 1.2, 60), rng.uniform(-3, 3, 60)) for _ in range(2))
    return Measurement.from_arrays(wi, wo, np.full((60, 1), values))


def test_blocks_are_those_of_their_directions_and_number() -> None:
    one, other = measured(0.1), measured(0.1, seed=2)
    for data in (one, other):
        for count in (5, 8):
            fresh = blocks_of(data.wi.copy(), data.wo.copy(), count)  # which may be written to: nothing is remembered
            assert np.array_equal(blocks_of(data.wi, data.wo, count), fresh)
            assert blocks_of(data.wi, data.wo, count) is blocks_of(data.wi, data.wo, count)
    with pytest.raises(ValueError, match="read-only"):
        blocks_of(one.wi, one.wo, 5)[0] = 1


def test_blocks_go_with_their_directions() -> None:
    data = measured(0.1)
    key = (id(data.wi), id(data.wo), 5)
    blocks_of(data.wi, data.wo, 5)
    assert key in direction_blocks._known
    del data
    gc.collect()
    assert key not in direction_blocks._known


def test_directions_that_are_changed_have_other_blocks() -> None:
    rng = np.random.default_rng(3)
    wi, wo = (from_spherical(rng.uniform(0, 1.2, 60), rng.uniform(-3, 3, 60)) for _ in range(2))
    before = blocks_of(wi, wo, 6).copy()
    wi[:] = wi[::-1].copy()
    assert not np.array_equal(blocks_of(wi, wo, 6), before)


def test_findings_and_digests_are_those_of_their_measurement() -> None:
    dull, bright = measured(0.1), measured(0.9)
    assert implausible(dull) == implausible(dull) != implausible(bright)
    for data in (dull, bright, dull):
        assert origin_of(data, {}).sha256_of_arrays == digest(data)
    assert digest(dull) != digest(bright)


def test_a_file_that_was_written_anew_has_another_digest(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    path.write_text("one")
    first, when = _file_digest(path), path.stat().st_mtime_ns
    path.write_text("two")  # as long
    os.utime(path, ns=(when + 1, when + 1))
    assert _file_digest(path) != first
    assert _file_digest(tmp_path / "none") is None
