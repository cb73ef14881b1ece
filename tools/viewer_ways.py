"""Ways to draw dust with all orders of scattering in the viewer without a graphics device, side by side, for docs/viewer.md.

    python tools/viewer_ways.py             the ways
    python tools/viewer_ways.py --finished  the finished picture at 1440 x 900, as it is

Each way is the program of the page with its text changed.  What counts is the processor time of chromium's drawing process: to compile the program, and
to draw 256 x 256 pixels of a sphere with 2 and with 34 directions of the sky.  Needs chromium, playwright and Linux.
"""

from __future__ import annotations

import os
import re
import statistics
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from motes import view

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "benchmarks")]
from viewer import MODELS, PAGE, finished, stage  # noqa: E402
from viewer_support import Viewed, browser, driver  # noqa: E402

SIDE, ROUNDS, PASSES = 512, 5, 8
FETCH = re.compile(
    r"row = mix\(texelFetch\(kept, ivec2\(column, (\d+)\), 0\), texelFetch\(kept, ivec2\(column \+ 1, \d+\), 0\), part\);"
)
BOTH = "mix(texelFetch(kept, ivec2(column, r), 0), texelFetch(kept, ivec2(column + 1, r), 0), part)"
# Compile a program anew (a constant differs, so that nothing remembers it), and draw.
DRAW = """(() => {
  const { picture, store, pair } = app;
  const { program } = picture.shown[0];
  if (x.text) { program.fragmentShader = x.text; program.needsUpdate = true; }
  for (let k = 0; k < x.passes; k += 1) {
    picture.shade(store.state, pair.shownValues(store.state), x.side, x.side, x.count);
    picture.radiance();
  }
})()"""


def in_a_loop(text: str) -> str:
    """All rows of the table by a loop into an array: fewer lines to compile."""
    rows = 1 + max(int(found[1]) for found in FETCH.finditer(text))
    loop = f"vec4 row; vec4 rows[{rows}]; for (int r = 0; r < {rows}; ++r) rows[r] = {BOTH};"
    return FETCH.sub(r"row = rows[\1];", text).replace("vec4 row;", loop)


def without(text: str, *functions: str) -> str:
    """The text without functions of it, each of which ends with a brace at the start of a line."""
    for function in functions:
        text = re.sub(rf"^\w+ {function}\(.*?^\}}\n", "", text, flags=re.MULTILINE | re.DOTALL)
    return text


WAYS: dict[str, Any] = {
    "as it is": lambda text: text,
    "without the text of the first stage, which it does not call": lambda text: without(text, "motes_eval_parameters", "motes_eval_with", "motes_eval"),
    "rows of the table read in a loop": in_a_loop,
    "the nearest share of the table, not between two": lambda text: FETCH.sub(r"row = texelFetch(kept, ivec2(column, \1), 0);", text),
    "no table (wrong; a bound)": lambda text: FETCH.sub(r"row = vec4(part, share, 0.3, 0.4) * (0.5 + \1.0);", text),
    "directions below the horizon computed, too": lambda text: text.replace("while (wi.z <= 0.0 && next < end)", "if (next < end)").replace(
        "more = wi.z > 0.0;", "more = next <= end && count-- > 0;"
    ).replace("bool more = true;", "bool more = true; int count = skyCount;"),
    "no BRDF (wrong; a bound)": lambda text: text.replace("sum += reflected(wi, wo, share)", "sum += vec3(1.0)"),
}  # fmt: skip


def drawing() -> float:
    """Seconds of processor time of the drawing processes that this one started."""
    parents, busy = {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
            command = (folder / "cmdline").read_text()
        except OSError:  # it has ended
            continue
        parents[int(folder.name)] = int(fields[1])
        if "--type=gpu-process" in command:
            busy[int(folder.name)] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def ours(process: int) -> bool:
        return process == os.getpid() or (process in parents and ours(parents[process]))

    return sum(seconds for process, seconds in busy.items() if ours(process))


def spent(viewed: Viewed, count: int, passes: int, text: str = "", side: int = SIDE // 2) -> float:
    """Processor time [ms]."""
    before = drawing()
    viewed.js(DRAW, {"text": text, "count": count, "passes": passes, "side": side})
    time.sleep(0.05)
    return 1000 * (drawing() - before)


def main() -> None:
    """See the module."""
    if "--finished" in sys.argv[1:]:
        with tempfile.TemporaryDirectory() as folder, driver() as playwright, browser(playwright) as running:
            before = drawing()
            finished(running, view(MODELS["multiple"][1]).save(Path(folder) / "dusty.html"), PAGE)
            print(f"{drawing() - before:.0f} s of processor time")
    else:
        side_by_side()


def side_by_side() -> None:
    """Each way, round after round."""
    found: dict[str, list[tuple[float, float, float]]] = {name: [] for name in WAYS}
    with tempfile.TemporaryDirectory() as folder, driver() as playwright, browser(playwright) as running:
        page = view(MODELS["multiple"][1]).save(Path(folder) / "dusty.html")
        with Viewed(running, page, size=(SIDE, SIDE), coarse=1) as viewed:
            viewed.js("void (document.querySelector('.motes-stage').style.cssText = x)", stage((SIDE, SIDE)))
            viewed.settled()
            viewed.js("void (cancelAnimationFrame(app.pending), (app.pending = 1))")  # it draws no more by itself
            whole = viewed.js("app.picture.shown[0].program.fragmentShader")
            for number in range(ROUNDS):
                for which, (name, way) in enumerate(WAYS.items()):
                    text = way(whole)
                    assert which == 0 or text != whole, name
                    text = text.replace("GRAZING = 0.01", f"GRAZING = 0.010{number}{which}")
                    compiled = spent(viewed, 2, 1, text, side=16)
                    few, many = (spent(viewed, count, PASSES) / PASSES for count in (2, 34))
                    found[name].append((compiled, few, (many - few) / 32))
            wrong = [words for words in viewed.errors if "GPU stall due to ReadPixels" not in words]
            assert not wrong, wrong
            viewed.errors.clear()
    print("| way | compiling [ms] | a frame of 2 directions [ms] | each further direction [ms] |\n|---|---|---|---|")
    for name, rounds in found.items():
        compiled, few, further = (statistics.median(column) for column in zip(*rounds, strict=True))
        print(f"| {name} | {compiled:.0f} | {few:.0f} | {further:.1f} |")


if __name__ == "__main__":
    main()
