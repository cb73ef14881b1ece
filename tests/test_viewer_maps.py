"""The page of a fitted map in a real browser: at each texel what was fitted there, by pointer and by keys; thinned where it must be, and said."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motes
from motes.cli.main import main
from motes.drawing.colour import sequential, srgb_encode
from motes.errors import ParameterError
from motes.fitting.verdicts import Verdict
from motes.maps.layout import VERDICT_FLAGS
from motes.viewer import map_payload
from viewer_support import SOURCES, Viewed, browser, driver, node

pytest.importorskip("zarr")
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    with driver() as playwright, browser(playwright) as running:
        yield running


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("maps")


@pytest.fixture(scope="module")
def fitted(folder: Path) -> Any:
    from motes.maps import fit_map, simulate_map

    simulate_map(folder / "small.zarr", (9, 12), times=3)
    return fit_map(folder / "small.zarr", "oren_nayar", out=folder / "fitted.zarr")


@pytest.fixture(scope="module")
def joint(folder: Path, fitted: Any) -> Any:
    from motes.maps import fit_map

    return fit_map(folder / "small.zarr", "oren_nayar", out=folder / "joint.zarr", trends={"K_d": "linear"})


def told(viewed: Viewed, x: int, y: int) -> dict[str, dict[str, str]]:
    """What the page says of a texel."""
    rows = viewed.page.evaluate("([x, y]) => document.querySelector('main').motesMap.told(x, y)", [x, y])
    return {row["name"]: row for row in rows}


def numbers(text: str) -> list[float]:
    return [float("nan" if word == "–" else word) for word in text.split(", ")]


def pixel(viewed: Viewed, x: int, y: int) -> list[int]:
    return viewed.page.evaluate(
        "([x, y]) => Array.from(document.querySelector('canvas').getContext('2d').getImageData(x, y, 1, 1).data.slice(0, 3))",
        [x, y],
    )


def test_every_texel_says_what_was_fitted_there(chrome: Any, fitted: Any, folder: Path) -> None:
    page_file = motes.view(fitted).save(folder / "map.html")
    names = {code: name for name, code in VERDICT_FLAGS.items()}
    with Viewed(chrome, page_file, size=(1200, 800)) as viewed:
        page = viewed.page
        slider = page.get_by_role("slider", name="scan, from 0")
        for time in range(3):
            for y, x in ((0, 0), (8, 11), (4, 7)):
                found = told(viewed, x, y)
                assert list(found) == ["K_d", "sigma_d"]
                for name in ("K_d", "sigma_d"):
                    for key, map_ in (("value", name), ("error", f"{name}_stderr")):
                        np.testing.assert_allclose(
                            numbers(found[name][key]), np.ravel(fitted.read_map(map_)[y, x, time]), rtol=3e-3, atol=1e-6
                        )
                    codes = np.ravel(fitted.verdicts(name)[y, x, time])
                    if len(set(codes.tolist())) == 1:
                        assert found[name]["verdict"] == names[int(codes[0])]
            if time < 2:
                slider.press("ArrowRight")
        # Colours: K_d as sRGB, sigma_d on the ramp, verdicts by their key; grey is none of them.
        values = fitted.read_map("K_d")[:, :, 2]
        bright = np.quantile(fitted.read_map("K_d"), 0.99)
        expected = srgb_encode(np.asarray(values[3, 5], float) / bright)
        np.testing.assert_allclose(pixel(viewed, 5, 3), expected, atol=1.01)
        page.get_by_label("Map", exact=True).select_option(label="sigma_d")
        sigma = np.asarray(fitted.read_map("sigma_d"), float)
        low, high = np.quantile(sigma, (0.01, 0.99))
        ramp = sequential(np.linspace(0, 1, 256))
        k = int(np.round(np.clip((sigma[3, 5, 2] - low) / (high - low), 0, 1) * 255))
        np.testing.assert_allclose(pixel(viewed, 5, 3), ramp[k], atol=3)
        page.get_by_label("Show", exact=True).select_option("error")
        assert pixel(viewed, 5, 3) != ramp[k].tolist()
        assert "Standard error of sigma_d" in page.inner_text(".motes-view")
        page.get_by_label("Show", exact=True).select_option("verdict")
        assert re.search(r"(identified|weak|unidentifiable|at lower|at upper): \d", page.inner_text(".motes-scale"))
        page.get_by_label("Map", exact=True).select_option(label="how fits ended")
        assert "converged: " in page.inner_text(".motes-scale")


def test_the_pointer_and_the_keys_go_from_texel_to_texel(chrome: Any, fitted: Any, folder: Path) -> None:
    page_file = motes.view(fitted).save(folder / "map.html")
    with Viewed(chrome, page_file, size=(1200, 800)) as viewed:
        page = viewed.page
        canvas = page.get_by_role("application")
        box = canvas.bounding_box()
        assert box["width"] / box["height"] == pytest.approx(12 / 9, rel=0.01)
        page.mouse.move(box["x"] + 3.5 * box["width"] / 12, box["y"] + 7.5 * box["height"] / 9)
        assert page.inner_text(".motes-where").startswith("Row 7, column 3 at 0 h: converged, relative residual")
        rows = page.locator(".motes-table tbody tr").all_inner_texts()
        value = fitted.read_map("sigma_d")[7, 3, 0]
        assert float(rows[1].split()[1]) == pytest.approx(float(value), rel=1e-3)
        for key, where in (
            ("ArrowUp", "Row 6, column 3 "),
            ("ArrowRight", "Row 6, column 4 "),
            ("Shift+ArrowLeft", "Row 6, column 0 "),
            ("ArrowLeft", "Row 6, column 0 "),
        ):
            canvas.press(key)
            assert where in page.inner_text(".motes-where")
        dots = page.locator(".motes-chart path.dots").first.get_attribute("d")
        assert dots.count("M") == 3  # a dot for each time, and no line between fits that know nothing of each other
        assert page.locator(".motes-chart path.line").count() == 0


def test_trends_are_shown_at_every_time_and_by_their_coefficients(chrome: Any, joint: Any, folder: Path) -> None:
    page_file = motes.view(joint).save(folder / "joint.html")
    with Viewed(chrome, page_file) as viewed:
        viewed.page.get_by_role("slider", name="scan, from 0").press("PageUp")
        found = told(viewed, 2, 5)
        assert list(found)[:2] == ["K_d", "sigma_d"]
        assert set(joint.variables) <= set(found)
        np.testing.assert_allclose(numbers(found["K_d"]["value"]), joint.values("K_d")[5, 2, 2], rtol=1e-3)
        name = next(v.name for v in joint.variables.values() if v.quantity == "K_d")
        np.testing.assert_allclose(numbers(found[name]["error"]), joint.read_map(f"{name}_stderr")[5, 2], rtol=1e-2)
        assert found["K_d"]["verdict"] in {v.name.lower() for v in Verdict}


def test_a_large_map_is_thinned_and_it_is_said(
    chrome: Any, fitted: Any, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(map_payload, "MOST_NUMBERS", 9 * 12 * 30 // 4)
    shown = motes.view(fitted)
    step = shown.payload["step"]
    assert step > 1
    assert f"every {step}th of a row and of a column" in " ".join(shown.payload["notes"])
    with Viewed(chrome, shown.save(folder / "thin.html")) as viewed:
        found = told(viewed, 1, 2)
        np.testing.assert_allclose(numbers(found["K_d"]["value"]), fitted.read_map("K_d")[2 * step, step, 0], rtol=1e-3)
        viewed.page.get_by_role("application").press("Shift+ArrowLeft")
        viewed.page.get_by_role("application").press("Shift+ArrowUp")
        viewed.page.get_by_role("application").press("ArrowDown")
        assert viewed.page.inner_text(".motes-where").startswith(f"Row {step}, column 0")  # counted in the whole map


def test_the_page_of_a_map_is_for_everybody(chrome: Any, fitted: Any, folder: Path) -> None:
    node()
    page_file = motes.view(fitted).save(folder / "map.html")
    axe = (SOURCES / "node_modules" / "axe-core" / "axe.min.js").read_text()
    for size, scheme in (((360, 740), "light"), ((1280, 800), "dark")):
        with Viewed(chrome, page_file, size=size, color_scheme=scheme, bypass_csp=True) as viewed:
            viewed.page.evaluate(axe)
            found = viewed.page.evaluate("axe.run().then((r) => r.violations.map((v) => [v.impact, v.id]))")
            assert not [v for v in found if v[0] in ("serious", "critical")], found
            wide = viewed.page.evaluate("document.documentElement.scrollWidth <= innerWidth + 1")
            assert wide
    text = page_file.read_text(encoding="utf-8")
    assert "connect-src 'none'" in text.replace("&#x27;", "'")
    assert "These pictures stand in" in text


def test_the_command(fitted: Any, folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "map.html"
    assert main(["view", str(folder / "fitted.zarr"), "-o", str(out), "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["shape"] == [9, 12]
    assert said["bytes"] == out.stat().st_size
    assert main(["view", str(folder / "small.zarr"), "-o", str(out)]) == 2
    assert "motes fit" in capsys.readouterr().err
    assert main(["view", str(folder / "fitted.zarr"), "--against", "gold"]) == 2
    assert "shown alone" in capsys.readouterr().err
    with pytest.raises(ParameterError, match="shown alone"):
        motes.view(fitted, motes.Lambert())
