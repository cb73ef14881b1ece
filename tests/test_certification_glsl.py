"""Functions in GLSL as subjects: the exports of Motes, planted faults, uniforms and arguments, and what does not compile."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import planted_faults as planted
from motes import OrenNayar, TorranceSparrow
from motes.certification import certify, glsl_specimen
from motes.errors import DataError, FormatError, MissingExtraError, MotesError
from motes.exports import glsl
from shader_runners import open_gl

Run = Callable[..., tuple[int, str, str]]

GGX = """#version 300 es
uniform float alpha;
float lambda(float z) { return 0.5 * (sqrt(1.0 + alpha * alpha * (1.0 - z * z) / (z * z)) - 1.0); }
vec3 ggx(vec3 wi, vec3 wo, float scale) {
    if (min(wi.z, wo.z) <= 1e-6) return vec3(0.0);
    float t = pow(normalize(wi + wo).z, 2.0) * (alpha * alpha - 1.0) + 1.0;
    float d = alpha * alpha / (3.14159265 * t * t);
    return vec3(scale * d / (1.0 + lambda(wi.z) + lambda(wo.z)) / (4.0 * wi.z * wo.z));
}
"""
PAPER = """
vec3 paper(vec3 wi, vec3 wo) { return wi.z > 0.0 && wo.z > 0.0 ? vec3(0.6, 0.4, 0.2) %s : vec3(0.0); }
vec3 paper_sample(vec3 wi, vec2 u) { float r = sqrt(u.x), p = 6.28318531 * u.y; return vec3(r * cos(p), r * sin(p), sqrt(1.0 - u.x)); }
float paper_pdf(vec3 wi, vec3 wo) { return max(wo.z, 0.0) %s; }
"""


@pytest.fixture(autouse=True)
def gl() -> None:
    open_gl()  # skips where there is none


def written(path: Path, text: str) -> Path:
    path.write_text(text)
    return path


def test_what_motes_exports_is_its_model(tmp_path: Path) -> None:
    model = OrenNayar((0.6, 0.4, 0.2), 0.4) + TorranceSparrow(0.3, 0.2)
    shader = glsl.shader(model)
    uniforms = {u.name: list(np.ravel(u.value)) if np.ndim(u.value) else u.value for u in shader.uniforms}
    found = certify(f"{written(tmp_path / 'paint.glsl', shader.source)}:motes_eval", parameters=uniforms, against=model)
    assert not found.findings, found.findings
    assert found.kind == "function in GLSL"
    assert "OpenGL" in found.versions


def test_its_conventions_are_told(tmp_path: Path) -> None:
    file = written(tmp_path / "ggx.glsl", GGX)
    right = certify(f"{file}:ggx", parameters={"alpha": 0.3, "scale": 1.0}, as_model=planted.GGX)
    assert not right.findings
    for alpha, scale, name in ((0.09, 1.0, "alpha-squared"), (0.3, 4.0, "factor-4")):
        found = certify(f"{file}:ggx", parameters={"alpha": alpha, "scale": scale}, as_model=planted.GGX)
        assert [f.name for f in found.check("conventions").findings] == [name]


def test_its_samples_are_judged(tmp_path: Path) -> None:
    right = certify(f"{written(tmp_path / 'right.glsl', PAPER % ('/ 3.14159265', '/ 3.14159265'))}:paper")
    assert not right.findings
    wrong = certify(f"{written(tmp_path / 'wrong.glsl', PAPER % ('', ''))}:paper")
    assert [f.name for f in wrong.check("energy").findings] == ["factor-pi"]
    assert [f.name for f in wrong.check("sampling").findings] == ["scale-of-pdf"]


@pytest.mark.parametrize(
    ("text", "options", "says"),
    [
        ("vec3 g(vec3 wi, vec3 wo) { return wi; }", {}, "It has g"),
        ("vec3 f(vec3 wi, vec3 wo) { return nothing; }", {}, "does not compile"),
        ("vec3 f(vec3 wi) { return wi; }", {}, "not one of those that are known"),
        ("vec3 f(vec3 wi, vec3 wo, float alpha) { return wi; }", {}, "--set alpha=0.3"),
        (
            "vec3 f(vec3 wi, vec3 wo) { return wi; }",
            {"parameters": {"alpha": 1.0}},
            "neither an argument nor a uniform",
        ),
        ("vec3 f(vec3 wi, vec3 wo) { return wi; }\nvoid main() {}", {}, "a main of its own"),
    ],
)
def test_what_cannot_be_run_is_said(tmp_path: Path, text: str, options: dict[str, object], says: str) -> None:
    file = written(tmp_path / "bad.glsl", text)
    with pytest.raises((FormatError, DataError)) as error:
        certify(f"{file}:f", **options)  # type: ignore[arg-type]
    assert says in str(error.value)


def test_without_opengl_it_says_what_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import moderngl

    def none(**options: object) -> None:
        raise ValueError("no display")

    file = written(tmp_path / "f.glsl", PAPER % ("", ""))
    glsl_specimen.open_gl.cache_clear()
    monkeypatch.setattr(moderngl, "create_standalone_context", none)
    with pytest.raises(MotesError, match=r"no OpenGL 4\.3 without a window here: no display"):
        certify(f"{file}:paper")
    monkeypatch.setitem(__import__("sys").modules, "moderngl", None)
    with pytest.raises(MissingExtraError, match="running GLSL needs the package moderngl"):
        certify(f"{file}:paper")
