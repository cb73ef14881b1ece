"""The documentation site: it builds without a warning, its links lead somewhere, it asks the network for nothing, and anyone can read it."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

pytest.importorskip("sphinx")
pytest.importorskip("myst_parser")
pytest.importorskip("furo")

from motes.models import BRDF, registered
from motes.presets import PRESETS
from viewer_support import SOURCES, browser, driver

ROOT = Path(__file__).resolve().parents[1]

SIZES = ((1400, 900), (820, 1000), (390, 800))


def links() -> ModuleType:
    """tools/site_links.py"""
    spec = importlib.util.spec_from_file_location("site_links", ROOT / "tools" / "site_links.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("docs") / "site"
    command = [sys.executable, str(ROOT / "tools" / "site_build.py"), "--output", str(out)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    return out


def test_it_has_every_page_and_what_the_code_declares(site: Path) -> None:
    for page in (ROOT / "docs").glob("*.md"):
        assert (site / f"{page.stem}.html").is_file()
    models, presets, api = (
        (site / f"{name}.html").read_text(encoding="utf-8") for name in ("models", "presets", "api")
    )
    for name, cls in registered(BRDF).items():
        assert f">{name}<" in models
        for p in cls.declared():
            assert f">{p.name}<" in models
    assert all(f">{name}<" in presets for name in PRESETS)
    assert 'id="motes.fit"' in api
    assert "<math" in api
    assert "mathjax" not in api.lower()
    assert "dust_layer" in (site / "searchindex.js").read_text(encoding="utf-8")


def test_faults_of_links_are_found(tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text(
        '<h1 id="top">A</h1><a href="b.html#here">b</a><a href="b.html#gone">b</a><a href="c.html">c</a><a href="#top">a</a>'
        '<script src="https://example.org/x.js"></script><link href="//example.org/x.css"><a href="https://example.org">out</a>'
    )
    (tmp_path / "b.html").write_text('<p id="here">B</p><img src="picture.png">')
    (tmp_path / "own.css").write_text("@import 'https://example.org/y.css'; a { background: url(//example.org/z.png) }")
    found = links().faults(tmp_path)
    assert len(found) == 7, found
    for part in ("x.js", "x.css", "y.css", "z.png", "#gone", "c.html", "picture.png"):
        assert sum(part in fault for fault in found) == 1


def test_anyone_can_read_it_and_nothing_is_asked_for(site: Path) -> None:
    axe = SOURCES / "node_modules" / "axe-core" / "axe.min.js"
    if not axe.is_file():
        pytest.skip("axe-core is not installed (npm ci in viewer)")
    with driver() as playwright, browser(playwright) as running:
        for width, height in SIZES:
            page = running.new_page(viewport={"width": width, "height": height})
            asked: list[str] = []
            page.on("request", lambda r, asked=asked: asked.append(r.url))
            for name in ("index", "models", "data", "api") if width == SIZES[0][0] else ("index", "dust"):
                page.goto((site / f"{name}.html").as_uri())
                assert page.evaluate("document.documentElement.scrollWidth <= window.innerWidth"), (name, width)
                page.add_script_tag(path=str(axe))
                result = page.evaluate("axe.run({ resultTypes: ['violations'] })")
                serious = [v for v in result["violations"] if v["impact"] in ("serious", "critical")]
                assert not serious, (name, width, [(v["id"], v["nodes"][0]["html"][:200]) for v in serious])
            assert all(url.startswith(("file:", "data:")) for url in asked), asked
            page.close()
