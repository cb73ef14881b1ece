"""Write the example page of the viewer and the pictures of it, for the README and docs/viewer.md.

    python tools/viewer_pictures.py              the page and the pictures
    python tools/viewer_pictures.py --pictures   the pictures of the page that is there

The page is the fit of ``motes demo``, the same scans and the same model; the pictures carry the digest of the numbers in
the page that they show, so that a test can tell when they are of another.  Needs chromium and playwright.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import sys
import tempfile
import time
from pathlib import Path

import motes
from motes.ageing.plaster import MODEL
from motes.cli.demo_command import simulated_plaster
from motes.files import replacing
from motes.fitting.time_result import TimeFit

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
#: Seconds for one picture; its surroundings are drawn by the processor where there is no graphics device.
PATIENCE = 1200.0
#: The name of the text in a picture's PNG that holds `digest` of the page.
DIGEST = "motes-data-sha256"


def main() -> None:
    """See the module."""
    if "--pictures" not in sys.argv[1:]:
        example()
    photograph()


def example() -> None:
    """The example page."""
    motes.view(fit()).save(EXAMPLE)


def fit() -> TimeFit:
    """What ``motes demo`` fits, with the model that it finds."""
    with tempfile.TemporaryDirectory() as folder:
        data = motes.read(simulated_plaster(Path(folder) / "plaster"))
    found = motes.fit(data, model=MODEL)
    assert isinstance(found, TimeFit)
    return found


def embedded(page: Path) -> str:
    """The JSON of materials and data that a page of the viewer holds."""
    found = re.search(r'<script type="application/json" id="motes-data">(.*?)</script>', page.read_text(), re.DOTALL)
    assert found, f"{page} is no page of the viewer"
    return found[1]


def digest(page: Path) -> str:
    """SHA-256 of `embedded`."""
    return hashlib.sha256(embedded(page).encode()).hexdigest()


def photograph() -> None:
    """Pictures of the example page."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo
    from playwright.sync_api import sync_playwright

    text = PngInfo()
    text.add_text(DIGEST, digest(EXAMPLE))
    with sync_playwright() as playwright, tempfile.TemporaryDirectory() as folder:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=FLAGS)
        for name, (width, height), scheme, state in SHOTS:
            page = browser.new_page(viewport={"width": width, "height": height}, color_scheme=scheme)  # type: ignore[arg-type]
            page.goto(EXAMPLE.as_uri())
            while not page.evaluate("document.querySelector('.motes').motes?.firstPicture > 0"):
                time.sleep(0.1)
            # In few large frames: what is drawn is the same, and the frames' own cost is saved.
            page.evaluate("void (document.querySelector('.motes').motes.picture.pace.batch = 64)")
            page.evaluate("(x) => document.querySelector('.motes').motes.store.change(x)", state)
            page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
            end = time.monotonic() + PATIENCE
            while page.evaluate("document.querySelector('.motes').dataset.complete") != "true":
                if time.monotonic() > end:
                    sys.exit(f"{name} is not complete after {PATIENCE:g} s: {PICTURES / name}.png stays as it was")
                time.sleep(0.2)
            raw = Path(folder) / f"{name}.png"
            page.screenshot(path=raw, timeout=1000 * PATIENCE)
            page.close()
            with replacing(PICTURES / f"{name}.png") as temporary:
                Image.open(raw).convert("RGB").save(temporary, "PNG", optimize=True, pnginfo=text)
        browser.close()


if __name__ == "__main__":
    main()
