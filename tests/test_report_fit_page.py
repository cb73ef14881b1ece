"""The report as a page: self-contained, escaped, complete, the same every time, and calm about poor data."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest

import motes
from effort import units
from motes import Dielectric, Dust, DustLayer, Lambert, MotesError, OrenNayar, TorranceSparrow
from motes.directions import from_spherical
from motes.fitting.result import Fit
from motes.fitting.verdicts import Status, Verdict
from motes.measurements import Measurement
from motes.report import write_report
from motes.report.fit_page import render
from report_fits import as_fit, goniometer, measured

VOID = {"meta", "img", "br", "hr", "link", "image"}
GLOSSY = OrenNayar(K_d=0.5, sigma_d=0.3) + TorranceSparrow(K_s=0.4, sigma_s=0.15)
COLOURED = OrenNayar(K_d=(0.5, 0.3, 0.1), sigma_d=0.3) + TorranceSparrow(K_s=0.4, sigma_s=0.15)
HOSTILE = '<script>alert("x")</script>&\'" $\\frac{1}{0}$ \0\udcff'


class Page(HTMLParser):
    """What a page holds; an assertion where its elements do not nest."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(text)
        self.close()
        assert not self.open, f"left open: {self.open}"

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))
        assert len(dict(attrs)) == len(attrs), f"an attribute twice in <{tag}>"
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data

    def of(self, name: str) -> list[dict[str, str | None]]:
        return [attributes for tag, attributes in self.tags if tag == name]

    def anchors(self) -> list[str | None]:
        return [a.get("id") for a in self.of("section")]


def page_of(fit: Fit) -> Page:
    text = render(fit)
    assert "nan" not in re.sub(r"data:[^\"]*|not a number", "", text).replace("nanmetre", "").lower().split()
    return Page(text)


@pytest.fixture(scope="module")
def glossy() -> Fit:
    return as_fit(
        measured(GLOSSY, *goniometer(), provenance={"name": "a glossy card", "format": "csv", "notes": ["a note"]}),
        GLOSSY,
    )


def spectral_fit() -> Fit:
    nm = np.arange(400, 701, 10.0)
    K_d = 0.05 + 0.5 * np.exp(-(((nm - 460) / 40) ** 2))
    truth = OrenNayar(K_d=K_d, sigma_d=0.2) + TorranceSparrow(K_s=5.0, sigma_s=0.15, fresnel=Dielectric(n=1.5))
    fitted = OrenNayar(K_d=K_d, sigma_d=0.2) + TorranceSparrow(K_s=0.5, sigma_s=0.15)
    wi, wo = goniometer((10, 20, 30, 40, 50, 60, 70, 80), step=10)
    return as_fit(measured(truth, wi, wo, wavelengths=nm, provenance={"name": "blue paint"}), fitted)


# ---------------------------------------------------------------- what must be there


def test_the_page_is_whole_and_asks_the_network_for_nothing(glossy, tmp_path):
    path = write_report(glossy, tmp_path / "report.html")
    assert path == tmp_path / "report.html"
    text = path.read_text(encoding="utf-8")
    page = Page(text)
    policy = next(a["content"] for a in page.of("meta") if a.get("http-equiv") == "Content-Security-Policy")
    assert policy.startswith("default-src 'none'; img-src data:; style-src 'unsafe-inline'")
    assert not page.of("script")
    assert not page.of("link")
    assert not page.of("iframe")
    for tag, attributes in page.tags:
        for name in ("src", "href", "xlink:href", "srcset", "poster", "data", "action"):
            value = attributes.get(name)
            assert value is None or value.startswith(("data:", "#")), (tag, name, value)
        assert not any(name.startswith("on") for name in attributes), tag
    assert "url(" not in text
    assert "@import" not in text
    assert path.stat().st_size < 1_000_000


def test_every_section_is_there(glossy):
    page = page_of(glossy)
    assert page.anchors() == [
        "spheres",
        "parameters",
        "slices",
        "highlight",
        "residuals",
        "lobes",
        "metrics",
        "models",
        "masked",
        "correlations",
        "data",
        "use",
    ]
    linked = [a["href"] for a in page.of("a") if (a["href"] or "").startswith("#")]
    assert linked == [f"#{anchor}" for anchor in page.anchors()]
    assert page.of("h1")
    for words in (
        "a glossy card",
        "Oren-Nayar + Torrance-Sparrow",
        "relative RMS",
        "K_d",
        "sigma_s",
        "± ",
        "rad",
        "a note",
        "linear",
        "cube_root",
    ):
        assert words in page.text, words
    assert page.of("html")[0]["lang"] == "en"


def test_pictures_have_words(glossy):
    page = page_of(glossy)
    assert len(page.of("img")) == 5  # the sphere above, and four lamps
    assert all(a.get("alt") for a in page.of("img"))
    panels = [a for a in page.of("svg") if a.get("class") == "panel"]
    assert len(panels) >= 15
    assert all(a.get("role") == "img" and a.get("aria-label") for a in panels)


def test_text_in_charts_is_not_small():
    style = (Path(motes.__file__).parent / "drawing" / "panel.css").read_text(encoding="utf-8")
    sizes = [float(px) for px in re.findall(r"svg \.[\w, .]*\{[^}]*font-size: ([\d.]+)px", style)]
    assert len(sizes) >= 3
    assert min(sizes) >= 11


def test_the_same_fit_gives_the_same_bytes(glossy):
    assert render(glossy) == render(glossy)


def test_it_needs_no_plotting_library(tmp_path, glossy):
    script = (
        "import sys\n"
        "for name in ('matplotlib', 'PIL', 'scipy'): sys.modules[name] = None\n"
        f"sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
        "from report_fits import as_fit, goniometer, measured\n"
        "from motes import OrenNayar\n"
        "brdf = OrenNayar(K_d=(0.5, 0.4, 0.3))\n"
        f"as_fit(measured(brdf, *goniometer()), brdf).report({str(tmp_path / 'report.html')!r})\n"
    )
    done = subprocess.run([sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "report.html").stat().st_size > 50_000


def test_the_material_in_the_page_loads(glossy, tmp_path):
    import base64

    link = next(a for a in page_of(glossy).of("a") if a.get("download") == "material.json")
    (tmp_path / "material.json").write_bytes(base64.b64decode(link["href"].split(",", 1)[1]))
    assert motes.load(tmp_path / "material.json").brdf == glossy.brdf


# ---------------------------------------------------------------- names out of files


def test_hostile_names_are_text():
    data = measured(
        COLOURED,
        *goniometer(),
        channels=("<script>1</script>", "<img src=x onerror=y>", "b&\"'"),
        provenance={
            "name": HOSTILE,
            "format": HOSTILE,
            "path": HOSTILE,
            "source": HOSTILE,
            "notes": [HOSTILE, "</p><h1>"],
        },
    )
    mask = np.ones(data.mask.shape, bool)
    mask[0, 0, 0] = False
    text = render(as_fit(data.with_mask(mask, "<script>reason</script>"), COLOURED))
    page = Page(text)
    assert not page.of("script")
    assert len(page.of("h1")) == 1
    assert not any("onerror" in a for _, a in page.tags)
    assert "<script>reason</script>" in page.text
    assert '<script>alert("x")</script>' in page.text
    assert text.encode("utf-8")


# ---------------------------------------------------------------- what it says


def test_a_good_fit_is_called_close(glossy):
    page = page_of(glossy)
    assert "follows the measurement closely" in page.text
    assert "The data determine all 4 parameters." in page.text
    assert "The measured highlight grows" not in page.text


def test_a_missing_fresnel_term_is_named():
    page = page_of(spectral_fit())
    assert "The measured highlight grows towards grazing faster than the fitted one" in page.text
    assert "shape of the Fresnel term of a dielectric" in page.text
    assert "fresnel=dielectric adds it" in page.text


def test_spectra_are_curves_with_the_table_folded():
    page = page_of(spectral_fit())
    assert "wavelength [nm]" in page.text
    assert "Relative RMS at each wavelength" in page.text
    assert any("K_d against wavelength" in (a.get("aria-label") or "") for a in page.of("svg"))
    assert "Channels shown: 450 nm, 550 nm, 650 nm; 28 others are not drawn." in page.text
    assert "Table of K_d: 31 channels" in page.text
    assert "The ten strongest of" in page.text  # 34 free quantities make no readable heat map
    assert "CIE 1931" in page.text


def test_verdicts_and_a_failure_to_converge_are_said():
    data = measured(GLOSSY, *goniometer())
    verdicts = {
        "sigma_d": Verdict.UNIDENTIFIABLE,
        "K_s": Verdict.AT_LOWER,
        "sigma_s": Verdict.WEAK,
        "K_d": Verdict.FIXED,
    }
    correlations = np.full((4, 4), np.nan)
    fit = as_fit(data, GLOSSY, verdicts=verdicts, status=Status.MAX_ITERATIONS, correlations=correlations)
    page = page_of(fit)
    assert "did not converge" in page.text
    for words in (
        "sigma_d is not determined by these data",
        "K_s is at its lower bound",
        "sigma_s is only weakly determined",
        "✗ unidentifiable",
        "the data do not determine it",
        "held",
    ):
        assert words in page.text, words
    assert "No correlations: K_d, sigma_d, K_s, sigma_s" in page.text


def test_what_was_masked_is_counted():
    data = measured(COLOURED, *goniometer())
    mask = np.ones(data.mask.shape, bool)
    mask[0, :7] = False
    page = page_of(as_fit(data.with_mask(mask, "too dark to see"), COLOURED))
    assert re.search(r"too dark to see\s*21", page.text)
    assert f"21 of {data.n_directions:,} directions × 3 channels" in page.text


def test_dust_and_models_compared():
    brdf = DustLayer(COLOURED, Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2)
    fit = as_fit(measured(brdf, *goniometer()), brdf)
    tried = (
        *(type(t)(**{**t.__dict__, "chosen": False, "bic": -60.0, "model": "lambert"}) for t in fit.tried),
        *fit.tried,
    )
    fit = as_fit(fit.measurement, brdf, tried=tried)
    page = page_of(replace(fit, dusty=True))
    assert "(Oren-Nayar + Torrance-Sparrow) under dust" in page.text
    for doubtful in (None, False):
        assert "Oren-Nayar + Torrance-Sparrow, with a grazing roll-off" in page_of(replace(fit, dusty=doubtful)).text
    assert "+40.0" in page.text
    assert "✓ chosen" in page.text


# ---------------------------------------------------------------- poor data


def test_one_direction():
    wi, wo = from_spherical([0.3], [0.0]), from_spherical([0.5], [1.0])
    page = page_of(as_fit(measured(Lambert(K_d=0.5), wi, wo), Lambert(K_d=0.5)))
    assert "The data hold 1 usable direction" in page.text
    assert "lobes" in page.anchors()


def test_a_channel_without_data():
    data = measured(COLOURED, *goniometer())
    mask = np.ones(data.mask.shape, bool)
    mask[..., 1] = False
    page = page_of(as_fit(data.with_mask(mask, "broken sensor"), COLOURED))
    assert "No usable sample: G" in page.text


def test_nothing_left():
    data = measured(COLOURED, *goniometer()).with_mask(np.zeros((1, 1, 1), bool), "all of it")
    page = page_of(as_fit(data, COLOURED))
    assert "not defined" in page.text
    assert "No usable sample: R, G, B" in page.text
    assert "all of it" in page.text


def test_black_and_broken_materials():
    wi, wo = goniometer()
    zeros = Measurement.from_arrays(wi, wo, np.zeros(len(wi)))
    page = page_of(as_fit(zeros, Lambert(K_d=0.0)))
    assert "not defined" in page.text
    data = measured(GLOSSY, wi, wo)
    fit = as_fit(data, GLOSSY)
    page_of(as_fit(data, GLOSSY, predicted=np.full_like(fit.predicted, np.nan), metrics={}))


def test_values_over_twelve_decades():
    wi, wo = goniometer()
    wide = 10 ** np.random.default_rng(4).uniform(-10, 2, (len(wi), 3))
    page_of(as_fit(Measurement.from_arrays(wi, wo, wide), COLOURED))


def test_five_channels_without_wavelengths():
    brdf = Lambert(K_d=(0.1, 0.2, 0.3, 0.4, 0.5))
    page = page_of(as_fit(measured(brdf, *goniometer()), brdf))
    assert "the mean of the 5 channels is shown in grey" in page.text
    assert "2 others are not drawn" in page.text


def test_a_folder_that_cannot_be_written_is_an_error_of_one_sentence(glossy, tmp_path):
    (tmp_path / "file").write_text("in the way", encoding="utf-8")
    with pytest.raises(MotesError, match="cannot be written"):
        write_report(glossy, tmp_path / "file" / "report.html")
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


# ---------------------------------------------------------------- large and real


def test_dense_data_are_thinned_and_the_caption_says_so():
    rng = np.random.default_rng(1)
    n = 100_000
    wi = from_spherical(np.arccos(rng.uniform(0.02, 1, n)), 0.0)
    wo = from_spherical(np.arccos(rng.uniform(0.02, 1, n)), rng.uniform(0, np.pi, n))
    fit = as_fit(measured(COLOURED, wi, wo), COLOURED)
    texts = []
    effort = units(lambda: texts.append(render(fit)))
    (text,) = texts
    assert len(text) < 1_500_000
    assert "Drawn from 6,000 of 100,000 directions, chosen evenly at random (seed 0)." in Page(text).text
    assert effort < 500  # 50 where it was written; drawing every sample would be more


def test_curet(shared, tmp_path):
    fit = motes.fit(motes.read(shared("data/curet/abrdf.dat"), sample=10), model="oren_nayar")
    path = fit.report(tmp_path / "report.html")
    page = Page(path.read_text(encoding="utf-8"))
    assert path.stat().st_size < 1_000_000
    assert "slices" in page.anchors()
    assert "205" in page.text
    row = next(t for t in fit.table() if t["name"] == "sigma_d")
    assert row["value"] in page.text
    assert row["stderr"] in page.text


def test_cornell_paint_shows_the_grazing_rise(shared, tmp_path):
    fit = motes.fit(motes.read(shared("data/cornell/krylon_blue.brdf")), model="oren_nayar + torrance_sparrow")
    page = page_of(fit)
    assert "The measured highlight grows towards grazing faster than the fitted one" in page.text
    assert "shape of the Fresnel term of a dielectric" in page.text
    assert len(json.dumps(page.text)) < 200_000


def test_a_browser_has_nothing_to_complain_about(glossy, tmp_path):
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if chromium is None:
        pytest.skip("no chromium on PATH")
    write_report(glossy, tmp_path / "report.html")
    broken = (
        (tmp_path / "report.html")
        .read_text(encoding="utf-8")
        .replace("</main>", '<img src="https://example.org/x.png"></main>')
    )
    (tmp_path / "broken.html").write_text(broken, encoding="utf-8")

    def console(name: str) -> list[str]:
        options = "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update"
        command = [
            chromium,
            *options.split(),
            "--host-resolver-rules=MAP * ~NOTFOUND",
            f"--user-data-dir={tmp_path / 'profile'}",
            "--enable-logging=stderr",
            "--dump-dom",
            (tmp_path / name).as_uri(),
        ]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        assert "</footer>" in done.stdout
        return [line for line in done.stderr.splitlines() if "CONSOLE" in line]

    assert console("report.html") == []
    assert any("Content Security Policy" in line for line in console("broken.html"))
