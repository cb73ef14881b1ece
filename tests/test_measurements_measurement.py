"""`Measurement` and the policy for invalid data."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motes.directions import from_spherical
from motes.errors import DataError, MotesError
from motes.measurements import Measurement, policy


def pairs(n: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return (
        from_spherical(rng.uniform(0.1, 1.4, n), rng.uniform(-3, 3, n)),
        from_spherical(rng.uniform(0.1, 1.4, n), rng.uniform(-3, 3, n)),
    )


def test_policy_masks_counts_and_keeps_the_values():
    wi, wo = pairs(8)
    wo[5] = from_spherical(np.pi / 2, 0.0)  # cos(pi/2) is 6e-17 in floating point
    wi[6] = from_spherical(2.0, 0.3)
    values = np.array([0.1, -200.0, np.nan, np.inf, 0.0, 0.5, -0.6, 0.7])
    m = Measurement.from_arrays(wi, wo, values, mask=np.array([1, 1, 1, 1, 1, 1, 1, 0], bool)[:, None])
    assert m.mask[0, :, 0].tolist() == [True, False, False, False, True, False, False, False]
    assert dict(m.masked) == {
        policy.BELOW_HORIZON: 2,  # the negative sample below the horizon counts once, under the first rule it breaks
        policy.NOT_FINITE: 2,
        policy.NEGATIVE: 1,
        policy.EXCLUDED: 1,
    }
    np.testing.assert_array_equal(m.values[0, :, 0], values)
    assert sum(m.masked.values()) == np.count_nonzero(~m.mask)


def test_reasons_of_the_reader_come_first():
    wi, wo = pairs(3)
    m = Measurement.from_arrays(
        wi, wo, [-1.0, -2e4, 3.0], reasons={"out of gamut": np.array([1, 0, 0], bool)[None, :, None]}
    )
    assert dict(m.masked) == {"out of gamut": 1, policy.NEGATIVE: 1}


@pytest.mark.parametrize(
    ("scale", "accepted"),
    [(1 + 9e-4, True), (1 - 9e-4, True), (1.0011, False), (0.998, False), (np.nan, False), (0, False)],
)
def test_directions_off_unit_length(scale: float, accepted: bool):
    wi, wo = pairs(5)
    wi[3] *= scale
    if accepted:
        m = Measurement.from_arrays(wi, wo, np.ones(5))
        np.testing.assert_allclose(np.linalg.norm(m.wi, axis=1), 1, rtol=0, atol=1e-15)
    else:
        with pytest.raises(DataError, match=r"wi in row 3 .*of length"):
            Measurement.from_arrays(wi, wo, np.ones(5))


@pytest.mark.parametrize(
    "change",
    [
        {"values": np.ones(4)},
        {"values": np.ones((2, 2, 5, 1))},
        {"values": ["a"] * 5},
        {"wi": np.ones((5, 2))},
        {"wi": np.empty((0, 3)), "wo": np.empty((0, 3))},
        {"times": [1.0, 1.0], "values": np.ones((2, 5, 1))},
        {"times": [2.0, np.nan], "values": np.ones((2, 5, 1))},
        {"times": [0.0, 1.0, 2.0]},
        {"channels": ("R", "R", "B"), "values": np.ones((5, 3))},
        {"channels": ("R", "G")},
        {"wavelengths": [400.0, 500.0]},
        {"wavelengths": [-400.0]},
        {"weights": np.ones(4)},
        {"weights": [1, 1, 1, 1, -1]},
        {"weights": np.zeros(5)},
        {"weights": [1, 1, 1, 1, np.inf]},
        {"mask": np.ones((3, 5, 1), bool)},
    ],
)
def test_arrays_that_do_not_fit_are_errors_with_a_hint(change: dict):
    wi, wo = pairs(5)
    arguments = {"wi": wi, "wo": wo, "values": np.ones(5)} | change
    with pytest.raises(MotesError) as error:
        Measurement.from_arrays(**arguments)
    assert error.value.hint


def test_shapes_defaults_and_immutability():
    wi, wo = pairs(4)
    grey, rgb = Measurement.from_arrays(wi, wo, np.ones(4)), Measurement.from_arrays(wi, wo, np.ones((4, 3)))
    assert (grey.channels, rgb.channels) == (("grey",), ("R", "G", "B"))
    spectral = Measurement.from_arrays(wi, wo, np.ones((4, 2)), wavelengths=[400, 402.5])
    assert spectral.channels == ("400 nm", "402.5 nm")
    timed = Measurement.from_arrays(wi, wo, np.ones((3, 4, 1)))
    assert timed.time_unit == "scan"
    assert timed.times.tolist() == [0, 1, 2]
    assert grey.times.tolist() == [0]
    assert grey.time_unit == "h"
    for array in (
        grey.wi,
        grey.wo,
        grey.values,
        grey.times,
        grey.mask,
        grey.weights,
        spectral.wavelengths,
        timed.at(1).values,
    ):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    with pytest.raises(AttributeError):
        grey.values = np.ones(4)


def test_the_callers_arrays_stay_writable_and_apart():
    wi, wo = pairs(4)
    values = np.ones(4)
    m = Measurement.from_arrays(wi, wo, values)
    values[0], wi[0] = 7, 0
    assert m.values[0, 0, 0] == 1
    assert np.linalg.norm(m.wi[0]) == pytest.approx(1)


def test_angles():
    m = Measurement.from_arrays(
        from_spherical([0.3, 0.3, 0.3, 0], 0.5), from_spherical(0.7, [0.5, 0.5 + np.pi, 0.0, 1.0]), np.ones(4)
    )
    np.testing.assert_allclose(m.theta_i, [0.3, 0.3, 0.3, 0], atol=1e-15)
    np.testing.assert_allclose(m.theta_r, 0.7)
    np.testing.assert_allclose(np.abs(m.dphi), [0, np.pi, 0.5, 0], atol=1e-15)
    assert m.dphi[2] == pytest.approx(-0.5)


def test_parts_count_their_own_masked_samples():
    wi, wo = pairs(6)
    values = np.arange(12.0).reshape(2, 6, 1) + 1
    values[0, :2] = [[-2e4], [-1e4]]
    values[1, 4] = np.nan
    m = Measurement.from_arrays(wi, wo, values, times=[0.5, 1.0], weights=np.arange(1.0, 7))
    assert dict(m.at(0).masked) == {policy.NEGATIVE: 2}
    assert dict(m.at(-1).masked) == {policy.NOT_FINITE: 1}
    assert m.at(1).times.tolist() == [1.0]
    part = m.select([4, 0])
    assert dict(part.masked) == {policy.NEGATIVE: 1, policy.NOT_FINITE: 1}
    np.testing.assert_array_equal(part.wi, m.wi[[4, 0]])
    np.testing.assert_array_equal(part.weights, [5, 1])
    np.testing.assert_array_equal(part.values, m.values[:, [4, 0]])
    assert m.select(np.array([1, 0, 0, 0, 0, 0], bool)).n_directions == 1
    for bad in ([6], [-7], [], [True], np.zeros(6, bool), [0.5]):
        with pytest.raises(DataError):
            m.select(bad)
    for bad_time in (2, -3):
        with pytest.raises(DataError, match="There is no time"):
            m.at(bad_time)


def test_with_mask():
    wi, wo = pairs(4)
    m = Measurement.from_arrays(wi, wo, [-1e4, 1, 2, 3])
    extra = np.array([False, False, True, True])[None, :, None]
    more = m.with_mask(extra, "grazing")
    assert dict(more.masked) == {policy.NEGATIVE: 1, "grazing": 1}
    assert more.mask[0, :, 0].tolist() == [False, False, True, True]
    again = more.with_mask(m.values < 3, "grazing")
    assert dict(again.masked) == {policy.NEGATIVE: 1, "grazing": 2}
    assert again.mask[0, :, 0].tolist() == [False, False, True, False]  # what was masked stays masked
    assert dict(m.masked) == {policy.NEGATIVE: 1}
    assert dict(again.select([3]).masked) == {"grazing": 1}
    with pytest.raises(DataError, match="does not broadcast"):
        m.with_mask(np.ones(3, bool), "x")


def test_all_masked_is_not_an_error():
    wi, wo = pairs(3)
    m = Measurement.from_arrays(wi, wo, [np.inf, np.nan, np.nan])
    summary = m.summary()
    assert summary["n_usable"] == 0
    assert summary["f_r"] is None
    json.dumps(summary, allow_nan=False)


def test_summary_is_json_and_to_xarray_keeps_everything():
    wi, wo = pairs(4)
    m = Measurement.from_arrays(
        wi,
        wo,
        np.arange(1.0, 17).reshape(2, 4, 2),
        times=[0, 2],
        wavelengths=[450, 650],
        provenance={"name": "x", "notes": ["a"], "count": np.int64(3), "array": np.ones(2), "path": "p"},
    )
    summary = json.loads(json.dumps(m.summary(), allow_nan=False))
    assert (summary["name"], summary["count"], summary["n_samples"]) == ("x", 3, 16)
    pytest.importorskip("xarray")
    dataset = m.to_xarray()
    assert dataset["f_r"].dims == ("time", "direction", "channel")
    assert float(dataset["f_r"].sel(time=2.0, channel="650 nm")[3]) == 16
    assert dataset["wavelength"].values.tolist() == [450, 650]
    np.testing.assert_array_equal(dataset["wo"], m.wo)


def test_a_summary_has_no_number_that_json_has_not():
    wi, wo = pairs(2)
    m = Measurement.from_arrays(
        wi,
        wo,
        np.full((2, 1), 1e-320),
        uncertainties=np.full((2, 1), 0.02),
        provenance={"exposures": (0.2, np.inf), "gain": np.float64("nan"), "array": np.array([1, -np.inf])},
    )
    summary = json.loads(json.dumps(m.summary(), allow_nan=False))
    assert summary["uncertainties"]["relative_median"] is None
    assert (summary["exposures"], summary["gain"], summary["array"]) == ([0.2, None], None, [1, None])


def test_uncertainties_go_along(tmp_path):
    wi, wo = pairs(4)
    values = np.arange(1.0, 17).reshape(2, 4, 2)
    u = 0.01 * values
    u[0, 1, 0] = np.nan
    m = Measurement.from_arrays(wi, wo, values, times=[0, 2], uncertainties=u, common_uncertainty=0.02)
    np.testing.assert_array_equal(m.uncertainties, u)
    np.testing.assert_array_equal(m.at(1).uncertainties, u[1:])
    np.testing.assert_array_equal(m.select([3, 0]).uncertainties, u[:, [3, 0]])
    assert m.select([0]).common_uncertainty == m.at(0).common_uncertainty == 0.02
    np.testing.assert_array_equal(m.with_mask(values > 3, "dark").uncertainties, u)
    with pytest.raises(ValueError, match="read-only"):
        m.uncertainties[0, 0, 0] = 1
    facts = json.loads(json.dumps(m.summary(), allow_nan=False))
    assert facts["uncertainties"] == {"n_samples": 15, "range": [0.01, 0.16], "relative_median": pytest.approx(0.01)}
    assert facts["common_uncertainty"] == 0.02
    pytest.importorskip("xarray")
    data = m.to_xarray()
    np.testing.assert_array_equal(data["f_r_uncertainty"], u)
    assert data.attrs["common_uncertainty"] == 0.02


def test_uncertainties_broadcast():
    wi, wo = pairs(4)
    for one, expected in ((0.1, 0.1), (np.full(4, 0.2), 0.2), (np.full((4, 3), 0.3), 0.3)):
        m = Measurement.from_arrays(wi, wo, np.ones((4, 3)), uncertainties=one)
        np.testing.assert_array_equal(m.uncertainties, np.full((1, 4, 3), expected))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"uncertainties": [0.1, 0, 0.1]}, "direction 1, channel 0, time 0 is 0"),
        ({"uncertainties": [0.1, 0.1, -0.1]}, "direction 2.*-0.1"),
        ({"uncertainties": [np.inf, 0.1, 0.1]}, "inf"),
        ({"uncertainties": [0.1, 0.1]}, "does not fit the values"),
        ({"common_uncertainty": 2}, "outside"),
        ({"common_uncertainty": 0}, "outside"),
    ],
)
def test_uncertainties_that_are_none(options, message):
    with pytest.raises(DataError, match=message):
        Measurement.from_arrays(*pairs(3), np.ones(3), **options)


class TestNegativeValues:
    """Noise about 0 is data; markers and readings far below the noise are not."""

    def noise(self, n: int = 400, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        return *pairs(n, seed), 0.003 * np.random.default_rng(seed).standard_normal(n)

    @pytest.mark.parametrize("truth", [0.0, 0.002, 0.1])
    @pytest.mark.parametrize("digits", [9, 3])
    def test_noise_is_kept(self, truth: float, digits: int):
        wi, wo, noise = self.noise()
        m = Measurement.from_arrays(wi, wo, np.round(truth + noise, digits))
        assert m.mask.all()

    def test_noise_that_an_instrument_divides_by_a_cosine_is_kept(self):
        wi, wo, noise = self.noise()
        assert Measurement.from_arrays(wi, wo, 0.001 + noise / wi[:, 2]).mask.all()

    @pytest.mark.parametrize("marker", [-1, -99, -999, -9999.0])
    @pytest.mark.parametrize("rows", [[7], [3, 50, 51, 200]])
    def test_markers_are_masked(self, marker: float, rows: list[int]):
        wi, wo, noise = self.noise()
        values = 0.1 + noise
        values[rows] = marker
        m = Measurement.from_arrays(wi, wo, values)
        assert np.flatnonzero(~m.mask[0, :, 0]).tolist() == rows
        assert set(m.masked) <= {policy.MARKER, policy.NEGATIVE}

    def test_an_uncertainty_can_explain_more(self):
        wi, wo, noise = self.noise()
        values = 0.1 + noise
        values[7] = -1
        assert not Measurement.from_arrays(wi, wo, values).mask.all()
        assert Measurement.from_arrays(wi, wo, values, uncertainties=np.where(values < 0, 0.3, 0.003)).mask.all()

    def test_a_channel_without_a_positive_value_is_no_noise(self):
        wi, wo, noise = self.noise()
        m = Measurement.from_arrays(wi, wo, -np.abs(noise))
        assert not m.mask.any()

    def test_a_saturated_colour_is_data(self):
        wi, wo, noise = self.noise()
        values = np.stack([-0.2 + 0 * noise, 0.05 + noise, 0.6 + noise], axis=1)
        values[::2, 0] *= -0.1
        assert Measurement.from_arrays(wi, wo, values).mask.all()
        assert not Measurement.from_arrays(wi, wo, values, channels=["400", "500", "600"]).mask.all()


@given(st.lists(st.floats(), min_size=1, max_size=20), st.integers(0, 2**32 - 1))
def test_whatever_the_values_the_counts_add_up(values: list[float], seed: int):
    wi, wo = pairs(len(values), seed)
    m = Measurement.from_arrays(wi, wo, values)
    assert sum(m.masked.values()) == np.count_nonzero(~m.mask)
    usable = np.array(values)[m.mask[0, :, 0]]
    assert np.all(np.isfinite(usable))


class TestClipping:
    """`policy.clipped` finds a ceiling, and nothing where there is none."""

    @staticmethod
    def glossy(n: int = 300, digits: int = 3) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        wi, wo = pairs(n, seed=3)
        wh = wi + wo
        cos_h = wh[:, 2] / np.linalg.norm(wh, axis=1)
        return wi, wo, np.round(0.1 + 3 * np.exp(-((np.arccos(cos_h) / 0.3) ** 2)), digits)

    def test_a_ceiling_is_found(self):
        wi, wo, f = self.glossy()
        saturated = np.minimum(f, 1.5)
        n = np.count_nonzero(f >= 1.5)
        assert n >= 10
        found = policy.clipped(wi, wo, saturated[None, :, None])
        np.testing.assert_array_equal(found[0, :, 0], f >= 1.5)

    def test_a_ceiling_near_the_median_is_found_where_values_are_not_rounded(self):
        wi, wo, f = self.glossy(digits=12)
        f = (0.5 + f) * (1 + 0.1 * wi[:, 2])  # the floor, too, is not one number
        ceiling = float(np.quantile(f, 0.8))
        assert ceiling < 3 * np.median(f)
        found = policy.clipped(wi, wo, np.minimum(f, ceiling)[None, :, None])
        np.testing.assert_array_equal(found[0, :, 0], f >= ceiling)

    def test_no_ceiling_no_clipping(self):
        wi, wo, f = self.glossy()
        assert not policy.clipped(wi, wo, f[None, :, None]).any()

    def test_a_matte_surface_in_few_digits_is_not_clipped(self):
        wi, wo = pairs(200)
        f = np.round(0.3 + 0.01 * np.sin(np.arange(200)), 2)
        assert not policy.clipped(wi, wo, f[None, :, None]).any()
        assert not policy.clipped(wi, wo, np.full((1, 200, 1), 0.3)).any()

    def test_geometries_that_symmetry_makes_equal_are_not_a_plateau(self):
        """Normal incidence at many azimuths, mirror images and swapped pairs repeat the same value without clipping."""
        wi, wo, f = self.glossy(60)
        top = from_spherical(np.zeros(40), np.linspace(0, 6, 40))
        mirror = wi * [1, -1, 1], wo * [1, -1, 1]
        all_wi, all_wo = np.concatenate([top, wi, mirror[0], wo]), np.concatenate([top, wo, mirror[1], wi])
        values = np.concatenate([np.full(40, 5.0), f, f, f])[None, :, None]
        assert not policy.clipped(all_wi, all_wo, values).any()

    def test_each_time_and_channel_has_its_own_ceiling(self):
        wi, wo, f = self.glossy()
        values = np.stack([np.stack([f, np.minimum(f, 1.0)], -1), np.stack([np.minimum(f, 2.0), f], -1)])
        found = policy.clipped(wi, wo, values).any(axis=1)
        assert found.tolist() == [[False, True], [True, False]]
