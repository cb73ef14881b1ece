"""The report of a fit over time: self-contained, escaped, complete, the same every time, and true to the fit."""

from __future__ import annotations

import base64
import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import motes
from effort import units
from motes import Material, MotesError, OrenNayar, TorranceSparrow
from motes.fitting.formatting import with_error
from motes.fitting.time_result import ScanOutlier, TimeFit
from motes.fitting.verdicts import Status, Verdict
from motes.measurements import Measurement
from motes.report import write_time_report
from motes.report.time_page import SECTIONS, changes, render
from motes.report.time_plots import Times, narrowed, relative_rms
from motes.trends import Trend
from report_fits import goniometer
from test_report_fit_page import HOSTILE, Page

HOURS = (0.0, 0.5, 1.0, 2.0, 3.5, 6.0)


def fitted(n: int, seed: int = 3, **more: object) -> TimeFit:
    """A surface that brightens while its highlight decays, fitted to simulated scans."""
    wi, wo = goniometer(thetas_i=(5, 30, 55, 75), step=15, azimuth_step=30)
    K_d = np.linspace(0.15, 0.6, n) if n > 1 else 0.3
    material = Material(
        OrenNayar(K_d=K_d, sigma_d=0.3) + TorranceSparrow(K_s=0.5, sigma_s=0.2),
        trends={
            "K_d": Trend("exponential", {"start": K_d, "end": 1.5 * K_d, "time_constant": 2.0}, (0, 6)),
            "K_s": Trend("exponential", {"start": 0.5, "end": 0.0, "time_constant": 1.5}, (0, 6)),
        },
    )
    truth = np.stack([np.asarray(material.at(h).eval(wi, wo)) for h in HOURS])
    noisy = truth * (1 + 0.02 * np.random.default_rng(seed).standard_normal(truth.shape))
    about = {"name": "a coat of paint", "format": "csv"}
    data = Measurement.from_arrays(wi, wo, noisy, times=HOURS, time_unit="h", **{"provenance": about, **more})
    fit = motes.fit(data, "oren_nayar + torrance_sparrow")
    assert isinstance(fit, TimeFit)
    return fit


@pytest.fixture(scope="module")
def paint() -> TimeFit:
    return fitted(3, channels=("R", "G", "B"))


@pytest.fixture(scope="module")
def spectral() -> TimeFit:
    return fitted(7, wavelengths=np.linspace(400, 700, 7))


def page_of(fit: TimeFit) -> Page:
    text = render(fit)
    words = re.sub(r"data:[^\"]*|not a number|<style>.*?</style>", "", text, flags=re.DOTALL)
    assert not re.search(r"\b(nan|None|inf)\b", words)
    return Page(text)


def test_every_section_is_there(paint: TimeFit) -> None:
    page = page_of(paint)
    anchors = page.anchors()
    assert anchors == [s.anchor for s in SECTIONS if s.anchor in anchors]
    assert set(anchors) >= {s.anchor for s in SECTIONS} - {"models"}
    assert {a["href"] for a in page.of("a") if str(a["href"]).startswith("#")} == {f"#{a}" for a in anchors}
    for words in ("a coat of paint", "0 h to 6 h", "relative RMS", "The fit converged"):
        assert words in page.text


def test_the_page_asks_the_network_for_nothing(paint: TimeFit) -> None:
    page = page_of(paint)
    policy = next(m["content"] for m in page.of("meta") if m.get("http-equiv") == "Content-Security-Policy")
    assert str(policy).startswith("default-src 'none'")
    assert not page.of("script")
    assert not page.of("link")
    for _, attributes in page.tags:
        for name in ("src", "href"):
            assert str(attributes.get(name) or "data:").startswith(("data:", "#"))
        assert not any(name.startswith("on") for name in attributes)
    assert "url(" not in "".join(str(a.get("style")) for _, a in page.tags)


def test_a_panel_a_parameter(paint: TimeFit) -> None:
    page = page_of(paint)
    labels = [str(a["aria-label"]) for a in page.of("svg") if a.get("role") == "img"]
    for name, t in paint.trends.items():
        (label,) = [text for text in labels if text.startswith(f"{name} against time")]
        assert t.trend.kind.replace("_", " ") in label
        first = np.ravel(t.trend(0.0))
        assert f"from {', '.join(f'{v:.3g}' for v in first)} at 0 h" in label
    assert "BIC of the next: " in page.text
    assert "68 % and 95 % band" in page.text


def test_the_filmstrip_shows_the_material_as_it_changes(paint: TimeFit) -> None:
    page = page_of(paint)
    strip = [a for a in page.of("img") if str(a["alt"]).startswith("Sphere at")]
    by_light: dict[str, list[str]] = {}
    for picture in strip:
        by_light.setdefault(str(picture["alt"]).partition(", ")[2], []).append(str(picture["src"]))
    assert len(by_light) == 2
    for pictures in by_light.values():
        assert len(set(pictures)) == len(pictures) >= 6
    assert str(strip[0]["alt"]).startswith("Sphere at 0 h")
    assert any(str(a["alt"]).startswith("Sphere at 6 h") for a in strip)


def test_coefficients_stand_in_the_table_with_their_errors(paint: TimeFit) -> None:
    text = page_of(paint).text
    for t in paint.trends.values():
        start = 0
        for name, value in t.trend.coefficients.items():
            for v in np.ravel(value):
                assert t.trend.covariance is not None
                variance = float(t.trend.covariance[start, start])
                number, error = with_error(float(v), variance**0.5 if variance > 0 else float("nan"))
                found = f"{number}± {error}" if error else f"{number}–"
                assert found.replace("-", "−") in text, (t.name, name)
                start += 1
        assert str(t.verdict).partition(":")[0] in text


def test_channels_of_a_spectrum_are_thinned(spectral: TimeFit) -> None:
    page = page_of(spectral)
    assert "4 of 7 channels are not drawn" in page.text
    assert "450 nm" in page.text
    assert "Coefficients of the parameters with 7 channels" in page.text


def test_a_narrowed_trend_is_the_same_where_it_is_left(spectral: TimeFit) -> None:
    t = spectral.trends["K_d"]
    part = narrowed(t, [1, 5])
    hours = np.linspace(-1, 8, 7)
    for whole, some in zip(t.band(hours), part.band(hours), strict=True):
        np.testing.assert_allclose(some, whole[:, [1, 5]], rtol=1e-12)
    shared = spectral.trends["K_s"]
    assert narrowed(shared, [1, 5]) is shared


def test_the_residuals_of_the_scans_add_up(paint: TimeFit) -> None:
    mask = paint.measurement.mask
    power = (np.where(mask, paint.measurement.values, 0) ** 2).sum(axis=(1, 2))
    total = np.sqrt(np.sum(relative_rms(paint) ** 2 * power) / power.sum())
    assert total == pytest.approx(paint.metrics["relative_rms"], rel=1e-12)


def test_what_moves_is_said_in_a_sentence(paint: TimeFit) -> None:
    sentence = changes(paint)
    moving = [t.name for t in paint.trends.values() if t.trend.kind != "constant"]
    assert {"K_d", "K_s"} <= set(moving)
    assert all(name in sentence for name in paint.trends)
    still = {name: replace(t, trend=Trend("constant", {"value": 0.5}, (0, 6))) for name, t in paint.trends.items()}
    assert changes(replace(paint, trends=still)).startswith("Nothing is seen to change with time; ")
    one = {**still, "K_s": paint.trends["K_s"]}
    assert changes(replace(paint, trends=one)).startswith(f"K_s ({paint.trends['K_s'].trend.kind}) changes with time; ")


def test_outliers_findings_and_verdicts_are_said(paint: TimeFit) -> None:
    trends = {**paint.trends, "sigma_s": replace(paint.trends["sigma_s"], verdict=Verdict.UNIDENTIFIABLE)}
    page = page_of(
        replace(
            paint,
            outliers=(ScanOutlier(2, 1.0, "it lies 40 standard errors from the trends of the others"),),
            findings=("Scan 2 at 1 h was left out: it lies 40 standard errors from the trends of the others.",),
            trends=trends,
            status=Status.MAX_ITERATIONS,
        )
    )
    assert "Scan 2 at 1 h was left out" in page.text
    assert "× " in page.text
    assert page.text.count("×") > len(trends)
    assert "sigma_s (width of the distribution of facet normals) is not determined" in page.text
    assert "5 of 6" in page.text
    assert "do not trust its numbers" in page.text


def test_missing_scans_and_channels(paint: TimeFit) -> None:
    mask = paint.measurement.mask.copy()
    mask[1] = False
    mask[3, :, 2] = False
    data = paint.measurement.with_mask(mask, "lost")
    fit = motes.fit(data, "oren_nayar + torrance_sparrow")
    assert isinstance(fit, TimeFit)
    page = page_of(fit)
    assert "More than usual of scans 1 (100 %), 3 (33 %)" in page.text
    assert "lost" in page.text
    assert Times.of(fit).kept.tolist() == [0, 2, 3, 4, 5]


def test_times_that_are_indices(paint: TimeFit) -> None:
    page = page_of(replace(paint, measurement=replace(paint.measurement, time_unit="scan")))
    assert "scan 0 to scan 6" in page.text
    assert " h " not in page.text.partition("Where the data")[0].replace(" f h ", "")


def test_the_material_can_be_taken_from_the_page(paint: TimeFit) -> None:
    page = page_of(paint)
    (link,) = [a for a in page.of("a") if a.get("download") == "material.json"]
    data = json.loads(base64.b64decode(str(link["href"]).partition(",")[2]))
    material = Material.from_dict(data)
    for hours in (0.0, 2.5, 9.0):
        for name, value in paint.material.at(hours).parameters.items():
            np.testing.assert_allclose(material.at(hours).parameters[name], value)
    assert "material.at(hours=3)" in page.text


def test_names_out_of_files_are_text(paint: TimeFit) -> None:
    data = replace(
        paint.measurement,
        channels=(HOSTILE, "b", "c"),
        provenance={"name": HOSTILE, "path": HOSTILE, "notes": [HOSTILE]},
    )
    material = Material(paint.material.brdf, HOSTILE, (HOSTILE, "b", "c"), (), paint.material.trends)
    text = render(replace(paint, measurement=data, material=material, findings=(HOSTILE,)))
    assert "<script" not in text
    assert not Page(text).of("script")
    assert 'alert("x")' in Page(text).text


def test_the_same_bytes_whole_small_and_quick(paint: TimeFit, tmp_path: Path) -> None:
    write_time_report(paint, tmp_path / "warm.html")
    path = tmp_path / "report.html"
    assert units(lambda: paint.report(path)) < 400  # 40 here
    assert path.read_bytes() == (tmp_path / "warm.html").read_bytes()
    assert path.stat().st_size < 2_000_000
    assert {p.name for p in tmp_path.iterdir()} == {"warm.html", "report.html"}
    (tmp_path / "file").write_text("mine")
    with pytest.raises(MotesError):
        write_time_report(paint, tmp_path / "file" / "report.html")


def test_one_channel_and_few_scans() -> None:
    fit = fitted(1)
    data = fit.measurement
    early = Measurement.from_arrays(data.wi, data.wo, data.values[:2], times=HOURS[:2], time_unit="h")
    few = motes.fit(early, "oren_nayar")
    assert isinstance(few, TimeFit)
    for each in (fit, few):
        page = page_of(each)
        assert "all channels" not in page.text
        assert len([a for a in page.of("svg") if " against time, " in str(a.get("aria-label"))]) >= len(each.trends)
