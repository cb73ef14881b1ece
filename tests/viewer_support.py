"""Pages of the viewer in a real browser: Debian's chromium, driven by playwright, on its software renderer.

Without them the tests are skipped, by name.
"""

from __future__ import annotations

import base64
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from motes.directions import from_spherical
from motes.material import Material
from motes.measurements import Measurement
from motes.models import BRDF, Dust, DustLayer, OrenNayar, TorranceSparrow
from motes.trends import Trend

ROOT = Path(__file__).resolve().parents[1]
SOURCES = ROOT / "viewer"
STATIC = ROOT / "src" / "motes" / "viewer" / "static"
FLAGS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
#: Small: the software renderer's time goes with the pixels, of which one stands for a square of so many to the side.
SIZE, COARSE = (400, 480), 2
PATIENCE = 60.0

ROCK = OrenNayar(K_d=(0.8, 0.55, 0.35), sigma_d=0.4) + TorranceSparrow(K_s=0.3, sigma_s=0.15)
DUSTY = DustLayer(ROCK, Dust(w=(0.7, 0.6, 0.5), g=0.3), tau=0.2)


def chromium() -> str:
    for name in ("chromium", "chromium-browser", "google-chrome"):
        if path := shutil.which(name):
            return path
    pytest.skip("chromium is not installed")


def node() -> str:
    """Node, with the packages of the viewer beside it."""
    path = shutil.which("node")
    if path is None:
        pytest.skip("node is not installed")
    if not (SOURCES / "node_modules" / "three").is_dir():
        pytest.skip("the viewer's npm packages are not installed (npm ci in viewer)")
    return path


@contextmanager
def driver() -> Iterator[Any]:
    """Playwright, of which a process holds one at a time."""
    chromium()
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        pytest.skip("playwright is not installed")
    with sync_playwright() as playwright:
        yield playwright


@contextmanager
def browser(playwright: Any, *flags: str) -> Iterator[Any]:
    """A browser; `flags` replace those of the software renderer."""
    running = playwright.chromium.launch(executable_path=chromium(), args=list(flags) or FLAGS)
    yield running
    running.close()


class Viewed:
    """A page of the viewer that is open, with what went wrong on it and what it asked the network for."""

    def __init__(
        self,
        running: Any,
        file: Path,
        *,
        fragment: str = "",
        size: tuple[int, int] = SIZE,
        coarse: float = COARSE,
        rest: float = 0.0,
        **options: Any,
    ) -> None:
        self.context = running.new_context(
            viewport={"width": size[0], "height": size[1]},
            device_scale_factor=1 / coarse,
            accept_downloads=True,
            **options,
        )
        self.errors: list[str] = []
        self.requests: list[str] = []
        self.page = self.context.new_page()
        self.page.on("console", lambda m: self.errors.append(m.text) if m.type in ("error", "warning") else None)
        self.page.on("pageerror", lambda e: self.errors.append(str(e)))
        self.page.on("request", lambda r: self._asked(r.url))
        time.sleep(rest)  # a new browser builds its own window meanwhile, for seconds
        self.page.goto(file.resolve().as_uri() + fragment)

    def _asked(self, url: str) -> None:
        if not url.startswith(("file:", "data:", "blob:")):
            self.requests.append(url)

    def js(self, expression: str, argument: Any = None) -> Any:
        """The value of an expression in which ``app`` is the viewer and ``x`` the argument."""
        return self.page.evaluate(
            f"(x) => {{ const app = document.querySelector('.motes').motes; return ({expression}); }}", argument
        )

    def wait(self, expression: str, why: str = "") -> Any:
        """Wait for an expression to be true; the page's policy forbids playwright's own way, which evaluates text."""
        end = time.monotonic() + PATIENCE
        while not (value := self.js(expression)):
            assert time.monotonic() < end, f"{why or expression} did not come true; {self.errors}"
            time.sleep(0.03)
        return value

    def settled(self) -> Viewed:
        """Wait for the first picture and the plots."""
        self.wait("app && app.firstPicture > 0 && !app.plotsDue", "the first picture")
        return self

    def complete(self) -> Viewed:
        """Wait for the picture to be finished, in few large frames: what is drawn is the same, and the frames' own cost is saved."""
        self.js("void (app.picture.pace.batch = 64)")
        self.settled().wait("app.picture.complete && !app.plotsDue", "the finished picture")
        return self

    def state(self, key: str) -> Any:
        return self.js("app.store.state[x]", key)

    def set(self, **changes: Any) -> None:
        self.js("void app.store.change(x)", changes)

    def evaluate(self, index: int, wi: NDArray[Any], wo: NDArray[Any]) -> NDArray[np.float32]:
        """Values of the shader, (N, C)."""
        flat = [np.round(np.ravel(w), 9).tolist() for w in (wi, wo)]
        values = self.js("Array.from(app.evaluate(x[0], x[1], x[2]))", [index, *flat])
        return np.array(values, np.float32).reshape(len(wi), -1)

    def pixels(self) -> NDArray[np.uint8]:
        """What the canvas shows after the next full frame, (H, W, 4), the top row first."""
        # A change of the state is drawn from the next animation frame on.
        self.js("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(0))))")
        self.wait("!app.plotsDue && !app.picture.moved && app.picture.frame > 0")
        data = self.js("app.canvas.toDataURL('image/png')")
        return decoded(base64.b64decode(data.partition(",")[2]))

    def messages(self) -> str:
        return self.page.inner_text(".motes-messages")

    def drop(self, name: str, content: bytes | str, *, shift: bool = False) -> None:
        """Drop a file onto the viewer."""
        data = content.encode() if isinstance(content, str) else content
        self.js(
            "(() => { const bytes = Uint8Array.from(atob(x[1]), (c) => c.charCodeAt(0));"
            "const transfer = new DataTransfer(); transfer.items.add(new File([bytes], x[0]));"
            "app.canvas.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true, shiftKey: x[2] })); })()",
            [name, base64.b64encode(data).decode("ascii"), shift],
        )

    def close(self) -> None:
        """Close the page; nothing may have gone wrong on it, and nothing may have been asked of the network."""
        self.context.close()
        assert not self.errors, self.errors
        assert not self.requests, self.requests

    def __enter__(self) -> Viewed:
        return self

    def __exit__(self, kind: Any, *rest: Any) -> None:
        if kind is None:
            self.close()
        else:
            self.context.close()


def decoded(png: bytes) -> NDArray[np.uint8]:
    """A PNG as (H, W, 4)."""
    import io

    from PIL import Image

    return np.array(Image.open(io.BytesIO(png)).convert("RGBA"))


def drying() -> Material:
    """A material that follows time, with bands."""
    interval = (0.0, 6.0)
    trends = {
        "K_d": Trend("logistic", {"start": (0.34, 0.29, 0.23), "end": (0.74, 0.69, 0.61), "middle": 2.0, "width": 0.4}, interval, (0, np.inf)),
        "K_s": Trend("exponential", {"start": 0.6, "end": 0.0, "time_constant": 1.0}, interval, (0, np.inf), np.diag([1e-4, 1e-4, 1e-3])),
        "tau": Trend("linear", {"start": 0.02, "end": 0.5}, interval, (0, np.inf)),
    }  # fmt: skip
    return Material(DUSTY, name="plaster", channels=("R", "G", "B"), trends=trends)


def measured(brdf: BRDF) -> Measurement:
    """In-plane samples of a material at three angles of incidence, with a known error of 5 %."""
    theta_r = np.deg2rad(np.arange(-80, 81, 4))
    pairs = [(from_spherical(np.deg2rad(i), 0.0), from_spherical(np.abs(t), np.pi if t > 0 else 0.0)) for i in (20, 45, 70) for t in theta_r]  # fmt: skip
    wi, wo = (np.array(w) for w in zip(*pairs, strict=True))
    return Measurement.from_arrays(wi, wo, 1.05 * np.asarray(brdf.eval(wi, wo)), provenance={"name": "made <b>up</b>"})
