"""Write the example page of the viewer and the pictures of it, for the README and docs/viewer.md.

    python tools/viewer_pictures.py              the page and the pictures
    python tools/viewer_pictures.py --pictures   the pictures of the page that is there

A simulated plaster, fitted; needs chromium and playwright.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
import time
from pathlib import Path

import motes
from motes.ageing.plaster import drying_plaster
from motes.ageing.rig import simulate
from motes.files import replacing

ROOT = Path(__file__).resolve().parents[1]
EXAMPLE = ROOT / "docs" / "viewer_example.html"
PICTURES = ROOT / "docs" / "pictures"
FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
#: Name, size, colour scheme, what is set.
SHOTS = (
    ("viewer", (1440, 900), "light", {"shape": "bunny", "hours": 1.2, "azimuth": 25}),
    ("viewer_dusty", (1200, 760), "dark", {"shape": "teapot", "hours": 5.5, "environment": "sky", "azimuth": -20}),
    ("viewer_narrow", (390, 844), "light", {"hours": 0.0}),
)
PATIENCE = 300.0


def main() -> None:
    """See the module."""
    if "--pictures" not in sys.argv[1:]:
        example()
    photograph()


def example() -> None:
    """The example page."""
    with tempfile.TemporaryDirectory() as folder:
        data = motes.read(simulate(Path(folder) / "plaster", drying_plaster, scans=12, name="Drying plaster"))
    fit = motes.fit(data, model="dust_layer(oren_nayar + torrance_sparrow)")
    motes.view(fit).save(EXAMPLE)


def photograph() -> None:
    """Pictures of the example page."""
    from PIL import Image
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for name, (width, height), scheme, state in SHOTS:
            page = browser.new_page(viewport={"width": width, "height": height}, color_scheme=scheme)  # type: ignore[arg-type]
            page.goto(EXAMPLE.as_uri())
            while not page.evaluate("document.querySelector('.motes').motes?.firstPicture > 0"):
                time.sleep(0.1)
            page.evaluate("(x) => document.querySelector('.motes').motes.store.change(x)", state)
            end = time.monotonic() + PATIENCE
            while (
                page.evaluate("document.querySelector('.motes').dataset.complete") != "true" or time.monotonic() > end
            ):
                time.sleep(0.2)
            raw = Path(folder) / f"{name}.png"
            page.screenshot(path=raw)
            page.close()
            with replacing(PICTURES / f"{name}.png") as temporary:
                Image.open(raw).convert("RGB").save(temporary, "PNG", optimize=True)
        browser.close()


if __name__ == "__main__":
    main()
