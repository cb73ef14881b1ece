"""Colour, spheres, scales and slices: the numbers behind the pictures of a report."""

from __future__ import annotations

import io

import numpy as np
import pytest

from motes import Dielectric, Dust, Lambert, OrenNayar, TorranceSparrow
from motes.directions import frame, from_spherical
from motes.drawing.colour import channels_to_srgb, diverging, png, sequential, srgb_encode, xyz_bar
from motes.drawing.markup import Html, escape, join, tag
from motes.drawing.svg import Panel, Scale, number
from motes.measurements import Measurement
from motes.report import render_sphere, sphere_radiance
from motes.report.slices import Samples, distinct_angles, grows, incidence_groups, near_mirror, polar_slices
from report_fits import as_fit, goniometer, measured

# ---------------------------------------------------------------- colour


def test_the_matching_functions_are_near_the_tables_of_the_cie():
    # CIE 15, colour matching functions of the 1931 standard observer.
    table = {
        430: (0.28390, 0.01160, 1.38560),
        460: (0.29080, 0.06000, 1.66920),
        500: (0.00490, 0.32300, 0.27200),
        555: (0.51205, 1.00000, 0.00575),
        600: (1.06220, 0.63100, 0.00080),
        650: (0.28350, 0.10700, 0.00000),
    }
    assert xyz_bar(list(table)) == pytest.approx(np.array(list(table.values())), abs=0.04)


def test_equal_reflectance_is_neutral_in_every_kind_of_channels():
    wavelengths = np.arange(400, 701, 10.0)
    for names, nm in (
        (("grey",), None),
        (("R", "G", "B"), None),
        ([f"{w:g} nm" for w in wavelengths], wavelengths),
        (("a", "b"), None),
    ):
        rgb = 0.4 * np.ones(len(names)) @ channels_to_srgb(names, nm).matrix
        assert rgb == pytest.approx([0.4] * 3, abs=2e-3), names


def test_channels_named_in_another_order_keep_their_colours():
    assert np.array([0.1, 0.2, 0.3]) @ channels_to_srgb(("B", "G", "R")).matrix == pytest.approx([0.3, 0.2, 0.1])


def test_spectra_have_the_colours_that_people_see():
    nm = np.arange(400, 701, 10.0)
    names = [f"{w:g}" for w in nm]
    matrix = channels_to_srgb(names, nm).matrix
    red, green, blue = (np.exp(-0.5 * ((nm - peak) / 25) ** 2) @ matrix for peak in (640, 535, 450))
    assert red.argmax() == 0
    assert green.argmax() == 1
    assert blue.argmax() == 2
    yellow = (nm > 500) @ matrix
    assert yellow[0] > 0.8
    assert yellow[1] > 0.8
    assert yellow[2] < 0.3


def test_wavelengths_outside_the_visible_are_shown_in_grey():
    color = channels_to_srgb(["1000 nm", "1100 nm", "1200 nm"], [1000, 1100, 1200])
    assert "grey" in color.meaning
    assert np.array([1.0, 2.0, 3.0]) @ color.matrix == pytest.approx([2, 2, 2])


def test_the_transfer_curve_of_srgb():
    # IEC 61966-2-1: the toe, mid grey, and the ends; outside and NaN are clipped.
    assert srgb_encode([0, 0.0031308, 0.18, 0.5, 1, 7, -1, np.nan]).tolist() == [0, 10, 118, 188, 255, 255, 0, 0]


@pytest.mark.parametrize("channels", [3, 4])
@pytest.mark.parametrize("grey", [False, True])
def test_png_files_read_back_by_another_program(channels, grey):
    image = pytest.importorskip("PIL.Image")
    pixels = np.random.default_rng(3).integers(0, 256, (13, 7, channels), dtype=np.uint8)
    if grey:
        pixels[..., :3] = pixels[..., :1]
    back = image.open(io.BytesIO(png(pixels))).convert("RGB" if channels == 3 else "RGBA")
    assert np.array_equal(np.asarray(back), pixels)


def test_colour_maps_are_symmetric_and_ordered_in_lightness():
    ends = diverging([-1.0, 0.0, 1.0]).astype(int)
    assert ends[1].min() > 240
    assert ends[0][2] > ends[0][0]  # blue
    assert ends[2][0] > ends[2][2]  # red
    luminance = sequential(np.linspace(0, 1, 20)) @ np.array([0.299, 0.587, 0.114])
    assert np.all(np.diff(luminance) > 0)


# ---------------------------------------------------------------- spheres


def test_a_lambertian_sphere_follows_the_cosine():
    radiance, coverage = sphere_radiance(Lambert(K_d=0.6), 101, light="front", dome=0.15, samples=1)
    axis = (np.arange(101) + 0.5) / 101 * 2 - 1
    x, y = np.meshgrid(axis * 101 / 99, axis * 101 / 99)
    inside = x * x + y * y < 0.95
    expected = 0.6 * (0.85 * np.sqrt(1 - x[inside] ** 2 - y[inside] ** 2) + 0.15)
    assert radiance[inside, 0] == pytest.approx(expected, rel=1e-4)
    assert coverage.sum() == pytest.approx(np.pi * (99 / 2) ** 2, rel=1e-3)


def test_radiance_under_the_lamp_is_pi_f_cos_in_frames_made_another_way():
    brdf = OrenNayar(K_d=(0.5, 0.3, 0.1), sigma_d=0.5) + TorranceSparrow(K_s=0.5, sigma_s=0.3)
    light = np.array([-0.5, 0.4, 0.768])
    light /= np.linalg.norm(light)
    size = 64
    radiance, coverage = sphere_radiance(brdf, size, light=light, dome=0.0, samples=1)
    for row, column in ((20, 15), (32, 32), (40, 22), (10, 30)):
        x, y = ((np.array([column, row]) + 0.5) / size * 2 - 1) * size / (size - 2) * np.array([1, -1])
        normal = np.array([x, y, np.sqrt(1 - x * x - y * y)])
        axes = frame(normal)
        expected = (
            np.pi * np.asarray(brdf.eval(axes @ light, axes @ np.array([0.0, 0.0, 1.0]))) * max(0, normal @ light)
        )
        assert coverage[row, column] == 1
        assert radiance[row, column] == pytest.approx(expected, rel=2e-4)


def test_the_dome_is_the_integral_over_the_hemisphere():
    brdf = OrenNayar(K_d=0.7, sigma_d=0.6) + TorranceSparrow(K_s=0.2, sigma_s=0.5)
    radiance, _ = sphere_radiance(brdf, 64, dome=1.0, samples=1)
    row, column = 32, 50
    x, y = ((np.array([column, row]) + 0.5) / 64 * 2 - 1) * 64 / 62
    theta_r = np.arcsin(np.hypot(x, y))
    u, v = np.meshgrid((np.arange(400) + 0.5) / 400, (np.arange(400) + 0.5) / 400)
    wi = from_spherical(np.arcsin(np.sqrt(u.ravel())), 2 * np.pi * v.ravel())  # cosine-weighted
    brute = np.pi * np.mean(brdf.eval(wi, np.broadcast_to(from_spherical(theta_r, 0.0), wi.shape)))
    assert radiance[row, column, 0] == pytest.approx(brute, rel=2e-3)


def test_the_dome_over_dust_that_is_not_reciprocal_has_its_closed_form():
    # f = w cos_i / (cos_i + cos_r): 2 pi w times the integral of mu^2 / (mu + mu_r) from 0 to 1.
    radiance, _ = sphere_radiance(Dust(w=0.5, g=0.0, form="brightness"), 65, dome=1.0, samples=1)
    mu = 1.0
    expected = 2 * np.pi * 0.5 * (0.5 - mu + mu**2 * np.log((1 + mu) / mu))
    assert radiance[32, 32, 0] == pytest.approx(expected, rel=2e-3)


def test_pictures_have_transparent_corners_and_light_where_the_lamp_is():
    picture = render_sphere(OrenNayar(K_d=(0.8, 0.2, 0.1)), 48, light="side")
    assert picture.shape == (48, 48, 4)
    assert picture.dtype == np.uint8
    assert picture[0, 0].tolist() == [0, 0, 0, 0]
    assert picture[24, 10, 0] > picture[24, 38, 0] + 40
    assert picture[24, 10, 0] > picture[24, 10, 2]  # reddish
    bright = render_sphere(OrenNayar(K_d=(0.8, 0.2, 0.1)), 48, light="side", exposure=2.0)
    assert bright[24, 10, 1] > picture[24, 10, 1]


# ---------------------------------------------------------------- markup and charts


def test_everything_is_escaped_but_markup():
    hostile = "<script>\"&'\0\udcff"
    assert "<" not in escape(hostile)
    assert escape(hostile).encode("utf-8")
    assert tag("p", hostile, Html("<b>x</b>"), title=hostile).count("<") == 4
    assert join("a<b", None, Html("<i>")) == "a&lt;b<i>"
    assert Panel(Scale(0, 1), Scale(0, 1), title="<b>").svg('"<&').count("<b>") == 0


@pytest.mark.parametrize(
    ("scale", "marks"),
    [
        (Scale(0, 1), [0, 0.2, 0.4, 0.6, 0.8, 1.0]),
        (Scale(-90, 90, ticks=(-90, 0, 90, 120)), [-90, 0, 90]),
        (Scale(0.05, 200, True), [0.1, 1, 10, 100]),
        (Scale(0.9, 11, True), [1, 2, 5, 10]),
    ],
)
def test_ticks(scale, marks):
    assert scale.marks() == pytest.approx(marks)


def test_ticks_are_few_and_inside_whatever_the_range():
    rng = np.random.default_rng(5)
    for log in (False, True):
        for _ in range(300):
            low = 10 ** rng.uniform(-9, 6)
            scale = Scale(low, low * 10 ** rng.uniform(0.01, 9), log)
            marks = scale.marks()
            assert 2 <= len(marks) <= 9, scale
            assert all(scale.low * (1 - 1e-9) <= m <= scale.high * (1 + 1e-9) for m in marks)
            assert len({number(m) for m in marks}) == len(marks), scale


def test_ratio_scales_hold_one_and_what_they_are_given():
    for low, high in ((0.99, 1.01), (0.3, 1.2), (1.5, 400), (1e-7, 2)):
        scale = Scale.ratios(low, high)
        assert scale.low < low
        assert scale.high > high
        assert 1.0 in scale.marks()
        assert 2 <= len(scale.marks()) <= 12


def test_scales_map_their_ends_and_leave_out_what_has_no_place():
    assert Scale(2, 4)([2, 3, 4]) == pytest.approx([0, 0.5, 1])
    assert Scale(0.01, 100, True)([0.01, 1, 100]) == pytest.approx([0, 0.5, 1])
    assert np.isnan(Scale(0.01, 100, True)([0.0, -1.0])).all()
    for empty in (
        Scale.around([]),
        Scale.around([np.nan], log=True),
        Scale.around([0.0, -1.0], log=True),
        Scale.around([5.0]),
    ):
        assert empty.high > empty.low
    assert Scale.around([3, 5], zero=True).low == 0


def test_numbers_read_well():
    assert [number(x) for x in (0, 0.001, 1e-4, -30, 2.5e-7, 1e6)] == ["0", "0.001", "10⁻⁴", "−30", "2.5·10⁻⁷", "10⁶"]


def test_missing_values_break_lines_and_drop_dots():
    panel = Panel(Scale(0, 10), Scale(0, 1))
    panel.line([0, 1, 2, 3, 4], [0.1, 0.2, np.nan, 0.3, 0.4])
    panel.dots([0, 1, 2], [0.5, np.nan, 0.5])
    svg = panel.svg("words")
    assert svg.count("M") == 2 + 2 + 1 + len(panel.x.marks()) + len(
        panel.y.marks(5)
    )  # two pieces, two dots, the frame, the grid
    assert "nan" not in svg


# ---------------------------------------------------------------- slices


def test_slices_of_a_goniometer_are_exact_and_signed():
    wi, wo = goniometer()
    brdf = OrenNayar(K_d=0.5) + TorranceSparrow(K_s=0.2, sigma_s=0.2)
    samples = Samples.of(as_fit(measured(brdf, wi, wo), brdf))
    slices = polar_slices(samples)
    assert [round(np.degrees(s.theta_i)) for s in slices.panels] == [10, 30, 50, 70, 80]
    assert np.degrees(slices.off_plane) < 1
    for part in slices.panels:
        assert np.degrees(part.theta_r) == pytest.approx([-75, -60, -45, -30, -15, 0, 15, 30, 45, 60, 75])
        mirror = part.samples.from_mirror[np.argmin(np.abs(part.theta_r - part.theta_i))]
        assert np.degrees(mirror) < 8  # the positive side is the mirror's
    across = polar_slices(samples, across=True)
    assert all(np.degrees(part.theta_r) == pytest.approx([0, 15, 30, 45, 60, 75]) for part in across.panels)


def test_dense_data_give_near_samples_and_stay_few():
    rng = np.random.default_rng(1)
    n = 60_000
    wi = from_spherical(np.arccos(rng.uniform(0.02, 1, n)), rng.uniform(-np.pi, np.pi, n))
    wo = from_spherical(np.arccos(rng.uniform(0.02, 1, n)), rng.uniform(-np.pi, np.pi, n))
    brdf = OrenNayar(K_d=0.5)
    samples = Samples.of(as_fit(measured(brdf, wi, wo), brdf))
    slices = polar_slices(samples)
    assert len(slices.panels) >= 4
    for part in slices.panels:
        assert 3 <= len(part.theta_r) <= 130
        assert np.abs(part.samples.theta_i - part.theta_i).max() < 2.5 * slices.off_angle
    some, again = samples.thinned(500), samples.thinned(500)
    assert len(some) == 500
    assert np.array_equal(some.measured, again.measured)


def test_samples_leave_out_what_is_masked():
    wi, wo = goniometer()
    data = measured(Lambert(K_d=(0.5, 0.4)), wi, wo, channels=("a", "b"))
    mask = np.ones((1, len(wi), 2), bool)
    mask[0, 3] = False
    mask[0, 5, 1] = False
    samples = Samples.of(as_fit(data.with_mask(mask, "test"), Lambert(K_d=(0.5, 0.4))))
    assert len(samples) == len(wi) - 1
    assert np.isnan(samples.measured).sum() == 1


def test_a_missing_fresnel_term_is_seen_near_the_mirror_direction():
    wi, wo = goniometer((10, 20, 30, 40, 50, 60, 70, 80), step=10)
    truth = OrenNayar(K_d=0.2, sigma_d=0.2) + TorranceSparrow(K_s=6.0, sigma_s=0.2, fresnel=Dielectric(n=1.5))
    without = OrenNayar(K_d=0.2, sigma_d=0.2) + TorranceSparrow(K_s=0.4, sigma_s=0.2)
    data = measured(truth, wi, wo)
    near = near_mirror(Samples.of(as_fit(data, without)))
    assert np.degrees(near.theta_i) == pytest.approx([10, 20, 30, 40, 50, 60, 70, 80])
    assert np.degrees(near.from_mirror).max() < 0.1
    assert grows(near)
    assert near.elsewhere == pytest.approx(np.ones(8), abs=0.15)
    assert not grows(near_mirror(Samples.of(as_fit(data, truth))))


def test_no_near_mirror_samples_is_none():
    wi, wo = goniometer((10, 50))
    assert near_mirror(Samples.of(as_fit(measured(Lambert(), wi, wo), Lambert()))) is None


def test_groups_partition_the_samples():
    scattered = np.random.default_rng(2).uniform(0, 1.5, 400)
    for theta in (np.deg2rad([10.0, 10.0, 20.0, 45.0]), scattered):
        groups = incidence_groups(theta)
        assert sum(g.which.sum() for g in groups) == len(theta)
        assert len(groups) <= 8
    assert distinct_angles(scattered) is None


def test_measurement_is_the_one_of_the_package():
    assert isinstance(measured(Lambert(), *goniometer()), Measurement)
