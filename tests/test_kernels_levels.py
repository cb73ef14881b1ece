"""Kernels for a level of x86-64 that the environment names: what is refused, and what other processes then compute."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from motes import Dust, DustLayer, MotesError, OrenNayar, TorranceSparrow
from motes.kernels import engine, machine_code

SURFACE = DustLayer(OrenNayar((0.8, 0.7, 0.6), 0.4) + TorranceSparrow(0.3, 0.15), Dust((0.7, 0.6, 0.5), 0.3), 0.2)
AVX2 = "x86-64-v3"
# In another process: values, a gradient and samples at directions from a file, and the widest registers of its kernels.
OTHER = """
import sys
import numpy as np
from motes.kernels import engine, machine_code
from motes.kernels.lowering import lowered
from test_kernels_levels import SURFACE

given = np.load(sys.argv[1])
wi, wo, u = given["wi"], given["wo"], given["u"]
found = {}
for scalar in (np.float32, np.float64):
    a, b = wi.astype(scalar), wo.astype(scalar)
    found[f"value {scalar.__name__}"] = engine.evaluate(SURFACE, a, b)
    found[f"slope {scalar.__name__}"] = engine.vjp(SURFACE, a, b, 1.0)["sigma_d"]
    found[f"wo {scalar.__name__}"] = engine.sample(SURFACE, a, u.astype(scalar))[0]
text = "".join(machine_code.assembly(lowered(kernel.printed.source).text) for kernel in engine._kernels.values())
found["wide"], found["narrow"], found["estimates"] = "%zmm" in text, "%ymm" in text, "vrsqrt" in text or "vrcp" in text
np.savez(sys.argv[2], **found)
"""


def has(level: str) -> bool:
    return machine_code.host_features().issuperset(machine_code.features_of(level))


def test_levels_hold_those_before_them() -> None:
    assert "sse4.2" in machine_code.features_of("x86-64-v2")
    assert {"sse4.2", "avx2", "fma"} <= set(machine_code.features_of(AVX2))
    assert "avx512f" not in machine_code.features_of(AVX2)
    assert {"avx2", "avx512f"} <= set(machine_code.features_of("x86-64-v4"))


@pytest.mark.parametrize(
    ("level", "there", "message", "hint"),
    [
        ("avx2", AVX2, "'avx2', expected one of x86-64-v2, x86-64-v3, x86-64-v4; this processor has x86-64-v2, x86-64-v3", "x86-64-v2, x86-64-v3, or none"),
        ("x86-64-v4", AVX2, "lacks avx512f, avx512bw, avx512cd, avx512dq, avx512vl; this processor has x86-64-v2, x86-64-v3", "Name one of"),
        ("x86-64-v2", None, "lacks cx16, popcnt", "Name none"),
    ],
)  # fmt: skip
def test_what_a_processor_lacks_is_refused(
    monkeypatch: pytest.MonkeyPatch, level: str, there: str | None, message: str, hint: str
) -> None:
    monkeypatch.setattr(machine_code, "host_features", lambda: set(machine_code.features_of(there)) if there else set())
    monkeypatch.setenv("MOTES_PROCESSOR", level)
    with pytest.raises(MotesError) as caught:
        machine_code.processor.__wrapped__()
    assert message in caught.value.message
    assert hint in caught.value.hint


def test_a_level_is_what_is_compiled_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(machine_code, "host_features", lambda: set(machine_code.features_of("x86-64-v4")))
    widths = {"x86-64-v2": 16, AVX2: 32, "x86-64-v4": 64}
    for level, width in widths.items():
        monkeypatch.setenv("MOTES_PROCESSOR", level)
        told = machine_code.processor.__wrapped__()
        assert told[0] == level
        monkeypatch.setattr(machine_code, "processor", lambda told=told: told)
        assert machine_code.vector_bytes() == width
        assert level in machine_code.description().split("\0")  # which the names of kernels in the cache are made of
        monkeypatch.undo()
        monkeypatch.setattr(machine_code, "host_features", lambda: set(machine_code.features_of("x86-64-v4")))


@pytest.mark.skipif(not has(AVX2), reason="this processor has no AVX2")
def test_values_by_the_instructions_of_avx2(tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    wi, wo = (rng.normal(size=(200, 3)) for _ in range(2))
    wi, wo = (w / np.linalg.norm(w, axis=-1, keepdims=True) for w in (wi, wo))
    wi[:, 2], wo[:, 2] = np.abs(wi[:, 2]), np.abs(wo[:, 2])
    u = rng.random((200, 2))
    np.savez(tmp_path / "given.npz", wi=wi, wo=wo, u=u)
    here = os.pathsep.join([str(Path(__file__).parent), os.environ.get("PYTHONPATH", "")])
    environment = os.environ | {"MOTES_PROCESSOR": AVX2, "MOTES_CACHE": str(tmp_path / "cache"), "PYTHONPATH": here}
    run = [sys.executable, "-c", OTHER, str(tmp_path / "given.npz"), str(tmp_path / "found.npz")]
    subprocess.run(run, env=environment, check=True, timeout=120)
    found = np.load(tmp_path / "found.npz")
    assert found["narrow"]
    assert not found["wide"]
    assert not found["estimates"]  # of which makers' processors give different bits
    for scalar, most in ((np.float32, 1e-5), (np.float64, 1e-12)):
        a, b = wi.astype(scalar), wo.astype(scalar)
        expected = SURFACE.eval(a.astype(np.float64), b.astype(np.float64))
        error = np.abs(found[f"value {scalar.__name__}"] - expected) / np.maximum(expected, 0.01)
        assert error.max() < most
        slope = engine.vjp(SURFACE, a, b, 1.0)["sigma_d"]
        assert found[f"slope {scalar.__name__}"] == pytest.approx(slope, rel=100 * most)
        sampled = engine.sample(SURFACE, a, u.astype(scalar))[0]
        assert np.abs(found[f"wo {scalar.__name__}"] - sampled).max() < 100 * most
    assert len(list((tmp_path / "cache").iterdir())) == 6
