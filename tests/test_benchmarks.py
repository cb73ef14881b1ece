"""The benchmarks run, measure what they say, and write a page on which every figure is one of a run's."""

from __future__ import annotations

import importlib
import re
import shutil
import subprocess
import sys
import threading
import time
from collections import namedtuple
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

pytest.importorskip("llvmlite")
pytest.importorskip("scipy")

from motes import Lambert, MotesError, OrenNayar
from motes.kernels import engine

ROOT = Path(__file__).resolve().parents[1]
BENCHMARKS = ROOT / "benchmarks"
PARTS = {
    "evaluate": "evaluation",
    "instruction_sets": "instruction_sets",
    "dust": "dust_cost",
    "sampling": "sampling",
    "texels": "texel_fits",
    "map_fits": "map_fits",
    "map_losses": "map_losses",
    "growth": "growth",
    "fits": "material_fits",
    "joint": "joint_fits",
    "starting": "starting",
    "memory": "map_memory",
    "gpu": "gpu",
    "viewer": "viewer",
}
NEEDS = {"memory": "zarr", "map_fits": "zarr", "map_losses": "zarr"}


@pytest.fixture(scope="module", autouse=True)
def scripts() -> Iterator[None]:
    """The scripts import one another as they do when run from their folder."""
    sys.path.insert(0, str(BENCHMARKS))
    yield
    sys.path.remove(str(BENCHMARKS))


def module(name: str) -> Any:
    return importlib.import_module(name)


@pytest.fixture(scope="module")
def sections(scripts: None, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Every benchmark, with sizes that mean nothing, and as a file gives it back."""
    folder = tmp_path_factory.mktemp("bench")
    module("memory").FOLDER = module("map_fits").FOLDER = folder
    results = module("results")
    found = {}
    for name, function in PARTS.items():
        if name in NEEDS:
            pytest.importorskip(NEEDS[name])
        section = getattr(module(name), function)(results.Effort("quick"))
        section.write(folder / f"{name}.json")
        found[name] = results.Section.read(folder / f"{name}.json")
        assert found[name] == section
    return found


def cells(page: str) -> list[list[str]]:
    """The cells of all rows of tables that are not headings or rulers."""
    lines = page.splitlines()
    rows = [
        line
        for line, after in zip(lines, [*lines[1:], ""], strict=True)
        if line.startswith("|") and not line.startswith("|---") and not after.startswith("|---")
    ]
    return [[cell.strip() for cell in row.strip("|").split("|")] for row in rows]


# ---------------------------------------------------------------- the benchmarks


def test_every_script_has_a_part_here(scripts: None) -> None:
    run = module("run")
    assert set(run.SCRIPTS) == {*PARTS, "scale_out"}  # which starts schedulers, and is tested apart
    for name, function in PARTS.items():
        assert hasattr(module(name), function)


@pytest.mark.parametrize("name", PARTS)
def test_each_benchmark_measures(sections: dict[str, Any], name: str) -> None:
    section = sections[name]
    if name == "gpu" and not section.figures:
        assert "no CUDA device" in section.skipped[0]
        return
    if name == "viewer" and not section.figures:
        assert "was not found" in section.skipped[0]
        return
    assert section.tables
    assert all(table.rows for table in section.tables)
    for figure in section.figures.values():
        assert np.isfinite([figure.low, figure.median, figure.high]).all()
        assert figure.low <= figure.median <= figure.high
    script, _, function = section.made_by.partition(", ")
    assert script == f"benchmarks/{name}.py"
    for maker in re.findall(r"(\w+)\(\)", function):
        assert callable(getattr(module(name), maker))


def test_what_was_timed_is_what_is_shown(sections: dict[str, Any]) -> None:
    figures = sections["evaluate"].figures
    for name in ("rows32", "pieces32", "rows64", "numpy", "gradient"):
        # A thread at work for a nanosecond is a nanosecond of processor time: at most as many as there are processors.
        nanoseconds = 1e3 / figures[f"{name}_rate"].median
        assert 0 < figures[f"{name}_cpu"].low <= 1.5 * module("rivals").cores() * nanoseconds + 50
    assert figures["rows32_share"].median == 1
    assert sections["texels"].figures["near_clean"].median == 100
    assert sections["memory"].figures["peak_16"].median > 0.05


def test_what_a_candidate_leaves_at_work_is_not_the_next_ones(scripts: None) -> None:
    left: list[threading.Thread] = []

    def works_on() -> None:
        end = time.process_time() + 0.03
        left.append(threading.Thread(target=lambda: [None for _ in iter(lambda: time.process_time() < end, False)]))
        left[-1].start()

    timings = module("timing").interleaved({"it": (works_on, 1), "next": (lambda: time.sleep(0.005), 1)}, 2, warm=False)
    for thread in left:
        thread.join()
    assert max(timings["next"].cpu) < 0.004


# ---------------------------------------------------------------- the page


def scaled(sections: list[Any], factor: float) -> list[Any]:
    return [replace(s, figures={name: f.times(factor) for name, f in s.figures.items()}) for s in sections]


def test_every_figure_of_the_page_is_one_of_the_run(sections: dict[str, Any]) -> None:
    page, results = module("page"), module("results")
    run = page.Run("quick", {"Processor": "one"})
    given = list(sections.values())
    text = page.page(run, given, {})
    other = page.page(run, scaled(given, 1.7), {})
    before, after = cells(text), cells(other)
    assert len(before) == len(after) > 50
    numbers = 0
    for row, changed in zip(before, after, strict=True):
        assert row[0] == changed[0]
        if row[0] == "Processor":
            continue
        goal = row[1][:1] in "≥≤" and row[1] != ""  # name, goal, measured, verdict, section
        for cell, moved in zip(row[2:3] if goal else row[1:], changed[2:3] if goal else changed[1:], strict=True):
            if cell and cell not in ("0.00", "0"):
                numbers += 1
                assert cell != moved, row
    assert numbers > 150
    for section in given:
        shown = {format(f, spec) for f in section.figures.values() for spec in ("", "bare", "count")}
        for row in (row for table in section.tables for row in table.rows):
            assert all(section.filled(cell) in shown for cell in row[1:] if cell)
        # Sentences hold no figure but through a name: what is left are sizes, settings and the names of parameters.
        for line in section.reading:
            left = re.sub(r"\{[^}]*\}|`[^`]*`|\w+ = [\d.,]+°?|[\d,]+ x [\d,]+( x \d+)?|\b1 %|float32", "", line)
            left = re.sub(r"\d+ times as many|takes [\d.]+ GB of disk", "", left)
            assert not re.search(r"\d", left), line
    assert results.digits(0.1234) == "0.123"


def test_goals_are_judged() -> None:
    results, page = module("results"), module("page")
    figures = {"rate": results.Number(99.0, 90, 120), "ratio": results.Number(1.9, 1, 3)}
    goals = [
        results.Goal("fast", "rate", 100, unit=" M/s"),
        results.Goal("fast enough", "rate", 99),
        results.Goal("cheap", "ratio", 2, at_least=False),
        results.Goal("cheaper", "ratio", 1.5, at_least=False),
    ]
    section = results.Section("A title", "benchmarks/x.py, x()", "It has {rate:bare}.", figures, goals=goals)
    text = page.page(page.Run("quick", {}), [section], {})
    verdicts = [row[3] for row in cells(text) if row[-1] == "A title"]
    assert verdicts == ["**missed**", "met", "met", "**missed**"]
    assert "≥ 100 M/s | 99.0 (90.0–120) M/s" in text
    assert "It has 99.0." in text


@pytest.mark.parametrize(
    ("number", "text"),
    [
        ((0, 0, 0), "0"),
        ((468.2, 455.4, 480), "468 (455–480)"),
        ((1.005, 1.004, 1.0049), "1.00"),
        ((737_412, 1, 2), "737,000 (1.00–2.00)"),
        ((-0.0249, -0.05, 0.2), "-0.0249 (-0.0500–0.200)"),
        ((8.64e-5, 1e-5, 2e9), "8.64e-05 (1.00e-05–2.00e+09)"),
        ((np.nan, 1, 2), "none (1.00–2.00)"),
    ],
)
def test_figures_are_written_with_their_spread(number: tuple[float, float, float], text: str) -> None:
    assert format(module("results").Number(*number)) == text


def test_medians_and_quartiles() -> None:
    Number = module("results").Number
    assert Number.of([5, 1, 2, 3, 4]) == Number(3, 2, 4)
    assert format(Number.of([1234.4]), "count") == "1,234"
    assert Number(2e-6, 1e-6, 4e-6).rate(2) == Number(1e6, 5e5, 2e6)


# ---------------------------------------------------------------- measuring


def test_candidates_take_turns() -> None:
    calls: list[str] = []
    timings = module("timing").interleaved(
        {"a": (lambda: calls.append("a"), 1), "b": (lambda: calls.append("b"), 1)}, 3, warm=False
    )
    assert calls == ["a", "b"] * 3
    assert [len(t.wall) for t in timings.values()] == [3, 3]


def test_seconds_are_divided_by_items_and_repeats(monkeypatch: pytest.MonkeyPatch) -> None:
    timing, now = module("timing"), [0.0, 0.0]
    clock = SimpleNamespace(perf_counter=lambda: now[0], process_time=lambda: now[1])
    monkeypatch.setattr(timing, "time", clock)
    monkeypatch.setattr(timing, "settle", lambda: None)
    monkeypatch.setattr(timing, "awake", lambda: None)

    def call(seconds: float) -> None:
        now[0] += seconds
        now[1] += 2 * seconds

    timings = timing.interleaved({"long": (lambda: call(8.0), 4), "short": (lambda: call(1e-4), 10)}, 3)
    assert timings["long"].wall == pytest.approx([2.0] * 3)
    assert timings["short"].wall == pytest.approx([1e-5] * 3)
    assert timings["short"].cpu == pytest.approx([2e-5] * 3)
    assert timings["long"].busy.median == pytest.approx(2)


def test_a_ratio_is_one_of_work_done() -> None:
    x = np.linspace(0, 1, 20_000)

    def work(times: int) -> None:
        for _ in range(times):
            np.exp(x)

    timings = module("timing").interleaved({"one": (lambda: work(10), 1), "four": (lambda: work(40), 2)}, 7)
    assert 1.3 < timings["one"].cheaper_than(timings["four"]).median < 3  # four times the work for twice the items
    Timing = module("timing").Timing
    one, two = Timing([1, 2, 4], [1, 1, 1]), Timing([2, 6, 8], [3, 4, 5])
    assert one.faster_than(two).median == 2  # by rounds: 2, 3, 2
    assert one.cheaper_than(two).median == 4
    assert one.rate.median == 0.5


def test_the_roof_moves_all_the_bytes() -> None:
    roof = module("roof")
    n = 2 * roof.CHUNK + 8 * roof.LANES
    a, b, out = (roof.aligned(3, n) for _ in range(3))
    rng = np.random.default_rng(0)
    a[...], b[...] = rng.random((2, 3, n), np.float32)
    roof.stream(a, b, out)
    np.testing.assert_array_equal(out, a + b)
    assert roof.instructions()  # the machine does store past its caches
    with pytest.raises(ValueError, match="aligned"):
        roof.stream(a[:, :-3], b[:, :-3], out[:, :-3])


def test_rivals_compute_the_same_surface() -> None:
    rivals, check = module("rivals"), module("evaluate").check
    wi, wo = (rivals.directions(5003, seed, np.float64) for seed in (1, 2))
    expected = rivals.plain_numpy(wi.T, wo.T).T
    out = np.empty_like(expected)
    rivals.numpy_blocks(wi, wo, out, 1000)
    np.testing.assert_allclose(out, expected, rtol=1e-12, atol=1e-14)
    torch = pytest.importorskip("torch")
    found = rivals._formula("torch")(*(torch.from_numpy(row) for w in (wi, wo) for row in w))
    np.testing.assert_allclose(np.stack([f.numpy() for f in found]), expected, rtol=1e-12, atol=1e-14)
    check("the same", out, expected)
    with pytest.raises(ArithmeticError, match="another is off by"):
        check("another", out * 1.001, expected)


def test_the_code_for_a_gpu_runs_on_the_cpu() -> None:
    pytest.importorskip("torch")
    pytest.importorskip("mitsuba")
    from plugin_support import needs_llvm

    if needs_llvm.args[0]:
        pytest.skip(needs_llvm.kwargs["reason"])
    gpu, rivals, results = module("gpu"), module("rivals"), module("results")
    section = gpu.compared(results.Effort("quick"), "a test", "cpu", rivals.CPU_VARIANT)
    assert {"engine_rate", "eager_rate", "motes_dusty_rate", "roughplastic_share"} <= set(section.figures)
    assert section.skipped == ["torch.compile: not compiled in a quick run"]


def test_variances_are_those_of_closed_forms() -> None:
    sampling = module("sampling")
    # The weight of a cosine-sampled f is pi f; sampled as itself, in exact proportion to f cos, it would be constant.
    assert sampling.variance(OrenNayar(0.8, 0.0), 0.5, 3200, 1).median == pytest.approx(1, abs=0.5)

    class Brighter(Lambert):
        def sample(self, wi: Any, u: Any) -> Any:
            sampled = super().sample(wi, u)
            return sampled._replace(weight=sampled.weight * 1.05)

    with pytest.raises(ArithmeticError, match="standard errors"):
        sampling.variance(Brighter(0.5), 0.5, 3200, 1)


def test_growth_is_an_exponent() -> None:
    growth, Timing = module("growth"), module("timing").Timing
    times = {n: Timing([1.0] * 3, [1e-9 * n**1.3 * f for f in (1, 2, 3)]) for n in (10, 10**5, 10**6, 10**7)}
    times[10].cpu = [1.0] * 3
    slope = growth.slope(times, 10**5)
    assert slope.median == pytest.approx(1.3)
    assert growth.slope({k: times[k] for k in (10**5, 10**6)}, 10**6).median == pytest.approx(1.3)
    assert growth.sizes(3, 8, 10**6)[-1] < 10**8  # no more than memory holds
    assert growth.sizes(3, 8, 10**15) == [1000]
    repeated = growth.repeated(np.arange(6).reshape(2, 3), 7, 1)
    np.testing.assert_array_equal(repeated, [[0, 1, 2, 0, 1, 2, 0], [3, 4, 5, 3, 4, 5, 3]])


def test_scaling_is_judged_by_rounds() -> None:
    pytest.importorskip("distributed")
    workers, processes = {1: [2.0, 4.0, 9.0], 2: [1.25, 2.0, 9.0]}, {1: [2.0, 2.0, 2.0], 2: [1.0, 1.0, 1.0]}
    maps = {"fits": 1000, "blocks": 4, "seconds": {"workers": workers, "processes": processes}}
    names = ("tasks", "tasks_per_second", "scheduler_cpu_ms_per_task", "scheduler_memory_mib")
    estimates = ("estimated_scheduler_cpu_minutes_for_1e6", "workers_kept_busy_with_blocks_of_2_s")
    section = module("scale_out").report(maps, dict.fromkeys((*names, *estimates), 7.0), 3)
    assert section.figures["workers_efficiency_2"].median == 0.8  # of 0.8, 1, 0.5
    assert section.figures["processes_efficiency_2"].median == 1
    assert not section.goals[0].met(section.figures)
    assert section.figures["workers_rate_2"].median == 500
    assert [row[0] for row in section.tables[0].rows] == [
        "1 worker",
        "2 workers",
        "1 process alone",
        "2 processes alone",
    ]
    assert "7.00 minutes" in section.filled(section.reading[1])


def test_a_map_that_cannot_be_made_is_skipped_by_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    memory, results = module("memory"), module("results")
    with pytest.raises(MotesError, match="ended with code"):
        memory.fitted(0, 2, tmp_path)
    assert not list(tmp_path.iterdir())
    Usage = namedtuple("Usage", "free")
    monkeypatch.setattr(shutil, "disk_usage", lambda folder: Usage(1000))
    monkeypatch.setattr(memory, "FOLDER", tmp_path)
    section = memory.map_memory(results.Effort("quick"))
    assert section.skipped[0].startswith("map of 16 x 16 texels: the disk has less than")
    assert not section.goals


# ---------------------------------------------------------------- running them all


def test_a_run_writes_a_page_and_pictures(sections: dict[str, Any], tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    run, page, machine = module("run"), module("page"), module("machine")
    for name, section in sections.items():
        section.write(tmp_path / f"{name}.json")
    whole = page.Run("quick", machine.description(), [page.Part(name, 1.0, None) for name in sections])
    whole.printed.append(page.Printed("Others", "python benchmarks/other.py", "| a | b |\n|---|---|\n| 1 | 2 |\n"))
    whole.write(tmp_path / "run.json")
    assert page.Run.read(tmp_path / "run.json") == whole
    run.written(whole, tmp_path, tmp_path / "docs" / "page.md")
    text = (tmp_path / "docs" / "page.md").read_text(encoding="utf-8")
    for name in ("Processor", "Caches", "Memory", "Python", "Packages"):
        assert f"| {name} |" in text
    titles = [*(section.title for section in sections.values()), "Others"]
    assert re.findall(r"^## (.*)$", text, re.M)[-len(titles) :] == titles
    pictures = re.findall(r"!\[.*\]\((.*)\)", text)
    assert len(pictures) == 2
    for picture in pictures:
        assert "<svg" in (tmp_path / "docs" / picture).read_text(encoding="utf-8")
    assert str(ROOT) not in text
    assert "{" not in text


def test_a_script_that_fails_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = module("run")
    (tmp_path / "bad.py").write_text("raise ValueError('it broke')")
    (tmp_path / "slow.py").write_text("import time; time.sleep(20)")
    monkeypatch.setattr(run, "HERE", tmp_path)
    monkeypatch.setitem(run.LIMIT, "quick", 0.5)
    whole = run.measured("quick", ["bad", "slow"], tmp_path)
    assert whole.parts[1].failed == "failed: not done after 0 s"
    monkeypatch.setitem(run.LIMIT, "quick", 60)
    whole = run.measured("quick", ["bad"], tmp_path)
    assert whole.parts[0].failed == "failed: ValueError: it broke"
    run.written(whole, tmp_path, tmp_path / "page.md")
    assert "| bad |" in (tmp_path / "page.md").read_text()
    assert "ValueError: it broke" in (tmp_path / "page.md").read_text()


def test_the_command_runs_one_and_writes_elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    command = [sys.executable, str(BENCHMARKS / "run.py"), "--quick", "--only", "joint", "--folder", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "benchmarks.md").read_text(encoding="utf-8")
    assert "## Fits over time" in text
    assert "| joint |" in text
    monkeypatch.setattr(sys, "argv", [*command[1:], "--page-only", "-o", str(tmp_path / "again.md")])
    assert module("run").main() == 0
    assert (tmp_path / "again.md").read_text(encoding="utf-8") == text


def test_the_page_in_the_repository_is_of_these_scripts() -> None:
    path = ROOT / "docs" / "benchmarks.md"
    if not path.exists():
        pytest.skip("docs/benchmarks.md has not been made")
    text = path.read_text(encoding="utf-8")
    assert "Written by `benchmarks/run.py` (`make bench`), effort `" in text
    assert "effort `quick`" not in text
    assert "failed: " not in text
    for script in re.findall(r"^Made by `(?:python )?(benchmarks/\w+\.py)", text, re.M):
        assert (ROOT / script).exists()
    for picture in re.findall(r"!\[.*\]\((.*)\)", text):
        assert (path.parent / picture).exists()


def test_the_engine_is_what_is_measured() -> None:
    rivals = module("rivals")
    assert engine.available()
    assert sum(np.size(slot.value) for slot in rivals.SURFACE.slots()) == rivals.PARAMETERS


def test_files_are_made_in_a_place_of_their_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    places = module("places")
    monkeypatch.setattr(places, "FOLDER", tmp_path / "places")
    with places.fresh() as folder:
        assert folder.parent == tmp_path / "places"
        assert 0 < places.a_file(folder) < 1e5
        store = folder / "store"
        for name in ("K_d/c/0", "time/c"):
            (store / name).mkdir(parents=True)
            (store / name / "0").touch()
        copied = places.emptied(store, folder / "copy")
        assert sorted(str(p.relative_to(copied)) for p in copied.rglob("*")) == ["K_d", "time", "time/c", "time/c/0"]
    assert not folder.exists()
