"""The plugins cost about what Mitsuba's own do: processor time of the same scene, taken in turn."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from motes.rendering import load_mitsuba
from plugin_support import needs_llvm

pytestmark = needs_llvm


@pytest.fixture(scope="module")
def render() -> ModuleType:
    """The benchmark, whose scenes these are."""
    path = Path(__file__).resolve().parents[1] / "benchmarks" / "render.py"
    spec = importlib.util.spec_from_file_location("render_benchmark", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_dusty_sphere_costs_about_what_principled_does(render: ModuleType) -> None:
    """A guard against gross slowness only; `benchmarks/render.py` measures whether it is within a tenth."""
    load_mitsuba("llvm_ad_rgb")
    names = ("principled", "motes_dusty (equations 1-13)", "motes_dusty over diffuse")
    scenes = [render.sphere(render.SURFACES[name], 128) for name in names]
    for scene in scenes:  # compiles
        render.rendered(scene, 0, 16)
    # What else the machine does only adds: the least of several rounds counts, and more are taken while it matters.
    used = np.full(len(scenes), np.inf)
    for k in range(24):
        used = np.minimum(used, [render.rendered(scene, k, 16)[1] for scene in scenes])
        if k >= 3 and np.all(used[1:] <= 2 * used[0]):
            break
    assert np.all(used[1:] <= 2 * used[0]), dict(zip(names, used, strict=True))
