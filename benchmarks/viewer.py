"""The viewer in a browser without a graphics device: the first picture, frames while things move, the finished picture.

usage: python benchmarks/viewer.py [--effort quick|normal|full] [--json FILE]
"""

from __future__ import annotations

import shutil
import sys
import tempfile
import time
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from motes import BRDF, Dust, DustLayer, OrenNayar, TorranceSparrow, view
from results import Effort, Goal, Number, Section, Table, command

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests"))
from viewer_support import Viewed, browser, driver

COLOR, WHITE = (0.8, 0.55, 0.35), (0.9, 0.8, 0.7)
ROCK = OrenNayar(COLOR, 0.4) + TorranceSparrow(0.3, 0.15)
MODELS: dict[str, tuple[str, BRDF]] = {
    "rock": ("diffuse, with a highlight", ROCK),
    "single": ("the same under dust, single scattering", DustLayer(ROCK, Dust(WHITE, 0.3), 0.2)),
    "multiple": ("the same under dust, all orders", DustLayer(ROCK, Dust(WHITE, 0.3), 0.2, scattering="multiple")),
}
SQUARE, PAGE = (512, 512), (1440, 900)
PATIENCE = 900.0  # seconds
SETTLED = 3.0  # seconds after which a new browser has built its window, with which the page has nothing to do
# Turn the camera in every animation frame, and count those that were drawn: reading a pixel waits until it is.
TURN = """new Promise((done) => {
  const [gl, pixel, ends] = [app.picture.renderer.getContext(), new Uint8Array(4), []];
  let azimuth = 0;
  const step = () => {
    app.picture.renderer.setRenderTarget(null);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    ends.push(performance.now());
    azimuth = (azimuth + 3) % 180;
    app.store.change({ azimuth });
    if (ends.at(-1) - ends[0] < 1000 * x) requestAnimationFrame(() => requestAnimationFrame(step));
    else {
      const from = ends.length < 6 ? 0 : Math.floor(ends.length / 2); // after it has found what the machine can do
      done((1000 * (ends.length - 1 - from)) / (ends.at(-1) - ends[from]));
    }
  };
  step();
})"""


def viewer(effort: Effort) -> Section:
    """Each material in turn, round after round, each in a browser of its own, whose memory holds no program of another round."""
    if not (any(map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))) and find_spec("playwright")):
        return report({}, 0, ["Chromium, with playwright to drive it, was not found."])
    rounds = effort.pick(1, 2)
    square, page = effort.pick(((256, 256), (320, 240)), (SQUARE, PAGE))  # a browser hardly draws what is smaller
    models = effort.pick({"rock": MODELS["rock"]}, MODELS)
    found: dict[str, list[float]] = {}
    with tempfile.TemporaryDirectory() as folder, driver() as playwright:
        pages = {name: view(model).save(Path(folder) / f"{name}.html") for name, (_, model) in models.items()}
        for number in range(rounds):
            for name, file in pages.items():
                with browser(playwright) as running:
                    first, frames = moving(running, file, square, effort.pick(0.5, 4.0), effort.pick(0.0, SETTLED))
                    found.setdefault(f"{name}_first", []).append(first)
                    found.setdefault(f"{name}_frames", []).append(frames)
                    if number == 0:  # the longest, and the same work each time
                        found.setdefault(f"{name}_finished", []).append(finished(running, file, page))
    return report({name: Number.of(values) for name, values in found.items()}, rounds)


def moving(running: Any, file: Path, size: tuple[int, int], seconds: float, rest: float) -> tuple[float, float]:
    """Seconds to the first picture in a tab that is `rest` seconds old, and frames a second while the camera turns, of a stage of `size`."""
    with Viewed(running, file, size=size, coarse=1, rest=rest) as viewed:
        viewed.js("void (document.querySelector('.motes-stage').style.cssText = x)", stage(size))
        viewed.wait("app && app.firstPicture > 0")
        found = viewed.js("app.firstPicture") / 1000, float(viewed.js(TURN, seconds))
        viewed.errors[:] = [words for words in viewed.errors if "GPU stall due to ReadPixels" not in words]
        return found


def finished(running: Any, file: Path, size: tuple[int, int]) -> float:
    """Seconds from the start of the page until nothing of the picture would change."""
    with Viewed(running, file, size=size, coarse=1) as viewed:
        viewed.js("void (document.querySelector('.motes-stage').style.cssText = x)", stage(size))
        end = time.monotonic() + PATIENCE
        while not viewed.js("app && app.picture.complete && app.picture.frame > 0"):
            if time.monotonic() > end:
                raise TimeoutError(f"the picture was not finished after {PATIENCE:g} s")
            time.sleep(0.05)
        viewed.js("void app.picture.radiance()")  # waits for what is not drawn yet
        return float(viewed.js("performance.now()")) / 1000


def stage(size: tuple[int, int]) -> str:
    """The picture over the whole window."""
    return f"position: fixed; left: 0; top: 0; width: {size[0]}px; height: {size[1]}px; z-index: 9"


def report(figures: dict[str, Number], rounds: int, skipped: list[str] | None = None) -> Section:
    """A row for each material."""
    names = [name for name in MODELS if f"{name}_first" in figures]
    rows = [[MODELS[name][0], f"{{{name}_first}}", f"{{{name}_frames}}", f"{{{name}_finished}}"] for name in names]
    goals = []
    for name in names:
        goals += [
            Goal(f"viewer, {MODELS[name][0]}: first picture", f"{name}_first", 0.5, at_least=False, unit=" s"),
            Goal(f"viewer, {MODELS[name][0]}: frames while it turns", f"{name}_frames", 20, unit="/s"),
            Goal(
                f"viewer, {MODELS[name][0]}: finished at 1440 x 900", f"{name}_finished", 30, at_least=False, unit=" s"
            ),
        ]
    return Section(
        title="The viewer without a graphics device",
        made_by="benchmarks/viewer.py, viewer()",
        intro=(
            "Chromium with SwiftShader, which draws by the processor: the first picture at 512 x 512 from the start of the page, opened in a tab of a browser "
            "that has built its window and has not seen such a page before; frames a second there while the camera turns, at most 30, as every second frame "
            "turns; and once the picture at 1440 x 900 from the start of the page until nothing would change. The studio's light, the sphere; "
            "{rounds:count} rounds in turn."
        ),
        figures=figures | ({"rounds": Number.of([rounds])} if figures else {}),
        tables=[Table(["", "first picture [s]", "frames/s", "finished [s]"], rows)] if rows else [],
        goals=goals,
        reading=[],
        skipped=skipped or [],
    )


if __name__ == "__main__":
    command(viewer, __doc__)
