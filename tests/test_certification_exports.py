"""Agreement of exports in `motes certify`: right ones agree, planted faults are found and named, what cannot be run is said."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import motes
from motes.certification import Certificate, Outcome, certify, check_exports, export_runs
from motes.certification.export_runs import RUNNERS
from motes.errors import MotesError
from motes.exports import SURFACES, TARGETS
from motes.exports.shaders import Shader
from motes.rendering import loading
from motes.trends import Trend
from shader_runners import open_gl, open_gpu, tool

PAINT = motes.Material(
    motes.Lambert((0.6, 0.4, 0.1)) + motes.GGX((0.3, 0.2, 0.1), 0.3), name="red paint", channels=("R", "G", "B")
)


@pytest.fixture
def only(monkeypatch: pytest.MonkeyPatch) -> Callable[..., Certificate]:
    """Certify with some targets alone."""

    def certified(*targets: str, subject: Any = PAINT) -> Certificate:
        monkeypatch.setattr(check_exports, "RUNNERS", {name: RUNNERS[name] for name in targets})
        return certify(subject, exports=True)

    return certified


def rows(found: Certificate) -> list[Mapping[str, Any]]:
    return list(found.check("exports").numbers["targets"])


def test_every_target_is_known() -> None:
    assert set(RUNNERS) == {*TARGETS, *SURFACES}


def test_all_exports_of_a_right_material(tmp_path: Path) -> None:
    """What can be run here agrees; the rest is named with its reason, in the sentence and on the page."""
    found = certify(PAINT, exports=True, date="2026-01-31")
    check = found.check("exports")
    assert check.outcome is Outcome.HOLDS, check.says
    outcomes = {row["target"]: row["outcome"] for row in rows(found)}
    assert {t for t, o in outcomes.items() if o == "agrees"} >= {"merl", "csv", "bird", "rgl", "klems", "tensortree", "zemax"}  # fmt: skip
    assert {"osl", "three", "openmaterial", *SURFACES} <= {t for t, o in outcomes.items() if o == "not run"}
    for target, outcome in outcomes.items():
        assert target in check.says
        if outcome == "not run" and target not in SURFACES:
            assert f"{target} was not run: " in check.says
    page = found.report(tmp_path / "page.html").read_text(encoding="utf-8")
    assert "Agreement of exports" in page
    assert page.count("– not run") == sum(row["outcome"] == "not run" for row in rows(found))


def test_the_programs_are_really_run(only: Callable[..., Certificate]) -> None:
    """Where they are installed: no row says that it was not run, and float32 shows in the differences."""
    tool("cc"), tool("glslangValidator"), open_gl(), open_gpu()
    pytest.importorskip("MaterialX")
    found = rows(only("c", "glsl", "wgsl", "hlsl", "materialx"))
    assert [row["target"] for row in found] == ["c", "c", "glsl", "glsl", "wgsl", "hlsl", "materialx"]
    assert all(row["outcome"] == "agrees" for row in found)
    assert found[0]["largest"] < 1e-12
    assert all(1e-8 < row["largest"] < 1e-4 for row in found[1:])


def test_it_is_left_out_unless_asked_for() -> None:
    check = certify(PAINT).check("exports")
    assert check.outcome is Outcome.NOT_JUDGED
    assert "--exports" in check.says
    grey = certify(lambda wi, wo: np.full(len(wi), 0.1), exports=True).check("exports")
    assert grey.outcome is Outcome.NOT_JUDGED
    assert "materials of Motes alone" in grey.says


# ---------------------------------------------------------------- planted faults


def with_source(module: Any, monkeypatch: pytest.MonkeyPatch, change: Callable[[str], str]) -> None:
    """Let a module print another text."""
    printed = module.shader

    def shader(*given: Any, **more: Any) -> Shader:
        right = printed(*given, **more)
        text = change(right.source)
        assert text != right.source
        return replace(right, source=text)

    monkeypatch.setattr(module, "shader", shader)


def faults(found: Certificate, target: str) -> str:
    """The cause that the only finding about a target names."""
    assert not found.ok
    named = {finding.name: finding.probably for finding in found.check("exports").findings}
    assert set(named) == {f"export-{target}"}
    assert {row["outcome"] for row in rows(found) if row["target"] == target} == {"differs"}
    return named[f"export-{target}"]


def test_a_missing_pi_in_c(only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch) -> None:
    tool("cc")
    with_source(export_runs.c_header, monkeypatch, lambda text: text.replace("f[c] = ", "f[c] = 3.141592653589793 * "))
    assert "pi times too large" in faults(only("c"), "c")


def test_reversed_channels_in_glsl(only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch) -> None:
    open_gl()
    printed = export_runs.glsl_shader.shader

    def reversed_(*given: Any, **more: Any) -> Shader:
        right = printed(*given, **more)
        turned = [replace(u, value=u.value[::-1]) if isinstance(u.value, tuple) else u for u in right.uniforms]
        return replace(right, uniforms=tuple(turned))

    monkeypatch.setattr(export_runs.glsl_shader, "shader", reversed_)
    assert "order B, G, R" in faults(only("glsl", "csv"), "glsl")


def test_a_leak_below_the_horizon_in_glsl(only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch) -> None:
    open_gl()
    with_source(export_runs.glsl_shader, monkeypatch, lambda text: text.replace("wi.z > 1e-06", "wi.z > -2.0"))
    found = only("glsl")
    assert faults(found, "glsl")
    assert float(rows(found)[0]["at"].partition("theta_i = ")[2].partition("°")[0]) > 90


def test_alpha_squared_in_the_buffer_of_wgsl(only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch) -> None:
    open_gpu()
    packed = export_runs.wgsl_shader.pack
    monkeypatch.setattr(export_runs.wgsl_shader, "pack", lambda model: packed(model.with_parameters({"alpha": 0.09})))
    assert "alpha" in faults(only("wgsl"), "wgsl")


def test_a_shader_of_hlsl_that_is_not_a_number(
    only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch
) -> None:
    open_gpu(), tool("glslangValidator")
    monkeypatch.setattr(export_runs, "run_hlsl", lambda device, shader, buffer, wi, wo: np.full((len(wi), 3), np.nan))
    found = only("hlsl")
    assert faults(found, "hlsl")
    assert "all of its value" in found.check("exports").findings[0].says


def test_a_document_of_materialx_that_takes_a_cosine(
    only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch
) -> None:
    open_gl()
    pytest.importorskip("MaterialX")
    right = export_runs.shaders_of

    def wrong(path: Path, node: str) -> tuple[str, str, str]:
        vertex, pixel, version = right(path, node)
        text = pixel.replace("vec4(motes_certified_out,", "vec4(motes_certified_out * vd.i_geomprop_motes_view.z,")
        assert text != pixel
        return vertex, text, version

    monkeypatch.setattr(export_runs, "shaders_of", wrong)
    assert "cosine of wo" in faults(only("materialx"), "materialx")


def exporting(monkeypatch: pytest.MonkeyPatch, brdf: motes.BRDF) -> None:
    """Let `export` write another material."""
    right = export_runs.export
    monkeypatch.setattr(
        export_runs, "export", lambda material, *given, **more: right(replace(material, brdf=brdf), *given, **more)
    )


@pytest.mark.parametrize("target", ["merl", "csv", "bird", "rgl", "zemax", "klems", "tensortree"])
def test_tables_a_quarter_too_bright(
    target: str, only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch
) -> None:
    exporting(monkeypatch, motes.Lambert((0.75, 0.5, 0.125)) + motes.GGX((0.375, 0.25, 0.125), 0.3))
    cause = faults(only(target), target)
    assert ("Is a normalisation missing" in cause) == (target not in export_runs.XYZ)


def test_a_plugin_of_mitsuba_with_another_material(
    only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch
) -> None:
    try:
        loading.load_mitsuba(export_runs.VARIANT)
    except MotesError as error:
        pytest.skip(f"mitsuba is not installed, or cannot run here: {error}")
    assert only("mitsuba").ok
    exporting(monkeypatch, motes.Lambert((0.6, 0.4, 0.1)) + motes.GGX((0.3, 0.2, 0.1), 0.09))
    assert "alpha" in faults(only("mitsuba"), "mitsuba")


# ---------------------------------------------------------------- what cannot be run


def test_what_is_missing_is_named(only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch) -> None:
    def absent() -> Any:
        raise MotesError("the package wgpu is not installed", "pip install wgpu")

    monkeypatch.setattr("motes.certification.c_specimen.shutil.which", lambda name: None)
    monkeypatch.setattr(export_runs, "open_gpu", absent)
    found = only("c", "wgsl", "csv")
    check = found.check("exports")
    assert found.ok
    assert check.outcome is Outcome.HOLDS  # of the table, which was read back
    assert "c was not run: there is no compiler for C" in check.says
    assert "wgsl was not run: the package wgpu is not installed" in check.says
    assert not check.says.partition(" agree")[0].startswith(("c,", "wgsl"))
    nothing = only("wgsl").check("exports")
    assert nothing.outcome is Outcome.NOT_JUDGED


def test_a_shader_that_does_not_compile_is_a_fault(
    only: Callable[..., Certificate], monkeypatch: pytest.MonkeyPatch
) -> None:
    tool("cc")
    with_source(export_runs.c_header, monkeypatch, lambda text: text.replace("#endif\n", "#endif\nno such thing;\n", 1))
    found = only("c")
    assert not found.ok
    assert "does not compile" in found.check("exports").findings[0].says


def test_spectra_and_single_channels(only: Callable[..., Certificate]) -> None:
    spectrum = motes.Lambert(np.linspace(0.2, 0.8, 7)) + motes.GGX(0.2, 0.3)
    found = {row["target"]: row for row in rows(only("c", "merl", "csv", "klems", subject=spectrum))}
    assert found["csv"]["outcome"] == "agrees"
    assert found["merl"]["outcome"] == "not run"
    assert found["klems"]["outcome"] == "not run"
    assert "7 channels" in found["klems"]["how"]
    grey = rows(only("merl", "csv", "zemax", subject=motes.Lambert(0.5)))
    assert [row["outcome"] for row in grey] == ["agrees"] * 3


def test_two_channels_in_shaders(only: Callable[..., Certificate]) -> None:
    """Arrays, as a spectrum has them, shorter than a colour."""
    open_gl(), open_gpu(), tool("glslangValidator")
    found = rows(only("glsl", "wgsl", "hlsl", "mitsuba", subject=motes.Lambert((0.2, 0.8)) + motes.GGX(0.2, 0.3)))
    assert [row["outcome"] for row in found] == ["agrees"] * 4 + ["not run"]


def test_a_material_that_changes_is_exported_at_its_moment(only: Callable[..., Certificate]) -> None:
    span = (0.0, 4.0)
    fading = motes.Material(
        motes.Lambert(0.2),
        name="fading",
        channels=("grey",),
        trends={"K_d": Trend("linear", {"start": 0.2, "end": 0.8}, span)},
    )
    found = rows(only("csv", "merl", subject=fading))
    assert [row["outcome"] for row in found] == ["agrees"] * 2
