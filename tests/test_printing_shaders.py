"""Printed shaders, read: names, comments, brackets, uniforms, and what cannot be printed."""

from __future__ import annotations

import re
import sys
from typing import Any

import numpy as np
import pytest

import motes.equations
from motes.errors import ParameterError
from motes.exports import c, glsl, hlsl, wgsl
from motes.models import Dielectric, Lambert, OrenNayar
from motes.printing import glsl as glsl_language
from motes.printing.names import record
from shader_support import MODELS, SPECTRAL

ALL = MODELS | {"spectral": SPECTRAL}
EQUATIONS = "alpha beta C1 C2 C3 rho_d1 rho_d2 rho_d rho_s D G Phi dust_brdf slant_depth tan_beta cos_dphi theta_h"


def declared(source: str) -> list[str]:
    """The names that a GLSL text declares inside functions."""
    return re.findall(r"^ +(?:const )?(?:float|vec3|bool|int) (\w+) =", source, re.MULTILINE)


# ---------------------------------------------------------------- readable


def test_every_equation_of_a_model_is_named_and_numbered() -> None:
    source = glsl.shader(MODELS["dusty"]).source
    for number in (1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13):
        assert f"// Equation ({number})" in source
    assert "(12) / (4 pi cos(theta_i))" in source  # the BRDF made of (12)
    names = declared(source)
    for name in EQUATIONS.split():
        assert name in names
    assert "TVCG 13(3), 2007 (https://doi.org/10.1109/TVCG.2007.1013)" in source
    assert "1/sr, without the cosine" in source


def test_names_follow_the_source(monkeypatch: pytest.MonkeyPatch) -> None:
    """A renamed equation is renamed in the shader, too: nothing is typed twice."""

    exec(compile(_SOURCE_OF_TILT, motes.equations.__file__, "exec"), motes.equations.__dict__)
    try:
        monkeypatch.setattr(motes.equations, "D", motes.equations.__dict__["Tilt"])
        names = {name.text: name for name in record(MODELS["torrance_sparrow"]).names.values()}
    finally:
        del motes.equations.__dict__["Tilt"]
    assert names["Tilt"].comment == ("Equation (10), under another name.",)
    assert names["Tilt"].equation
    assert "slope" in names
    assert "D" not in names or not names["D"].equation


_SOURCE_OF_TILT = '''
def Tilt(xp, theta_h, sigma_s):
    """Equation (10), under another name."""
    slope = theta_h / sigma_s
    return xp.exp(-(slope * slope))
'''


@pytest.mark.parametrize("name", ALL)
def test_names_are_unique_and_not_reserved(name: str) -> None:
    shader = glsl.shader(ALL[name])
    function = shader.source[shader.source.index("motes_eval_with(") :]
    assert all(found.text.isidentifier() for found in record(ALL[name]).names.values())
    names = declared(function)
    assert len(names) == len(set(names))
    assert not set(names) & set(glsl_language.language("300 es").reserved)
    assert not set(names) & {uniform.slot for uniform in shader.uniforms}


def test_brackets_are_those_that_the_order_needs() -> None:
    source = glsl.shader(MODELS["oren_nayar"]).source
    assert "rho_d1 = K_d * INV_PI * (C1 + cos_dphi * C2 * tan_beta + one_less_abs_cos_dphi * C3 * tan_half);" in source
    assert "C1 = 1.0 - 0.5 * (s2 / (s2 + 0.33));" in source


@pytest.mark.parametrize("name", ["dusty", "two_coats_under_dust"])
def test_long_numbers_are_explained(name: str) -> None:
    """Every number of the formula that is no number of an equation says what it is made of."""
    source = glsl.shader(MODELS[name]).source
    formula = source[source.index("motes_eval_with(") : source.index("vec3 motes_eval(vec3 wi")]
    lines = [line for line in formula.split("\n") if re.search(r"\d\.\d{6,}", line.partition("//")[0])]
    assert len(lines) > 4
    assert all(re.search(r"//.*(pi|= )", line) for line in lines)
    assert "0.6366197723675814 * beta;  // 2/pi = 0.6366" in formula
    assert "1e-12;  // cosines divide" in formula


def test_a_long_equation_is_one_function() -> None:
    source = glsl.shader(MODELS["two_normalised"]).source
    assert source.count("float motes_facet_area(float sigma_s) {") == 1
    assert "motes_facet_area(sigma_s) " in source
    assert "motes_facet_area(sigma_s_2) " in source


def test_what_a_lambda_or_a_comprehension_computes_is_not_named_for_it(monkeypatch: pytest.MonkeyPatch) -> None:
    exec(compile(_SOURCE_OF_NAMELESS, motes.equations.__file__, "exec"), motes.equations.__dict__)
    try:
        monkeypatch.setattr(motes.equations, "D", motes.equations.__dict__["Nameless"])
        names = {found.text for found in record(MODELS["torrance_sparrow"]).names.values()}
    finally:
        del motes.equations.__dict__["Nameless"]
    assert "Nameless" in names
    assert all(name.isidentifier() for name in names)


_SOURCE_OF_NAMELESS = """
def Nameless(xp, theta_h, sigma_s):
    slopes = tuple(xp.minimum(t, 9.0) / sigma_s for t in (theta_h, theta_h + 1))
    square = lambda x: x * x
    return xp.exp(-square(slopes[0])) + 0.01 * xp.exp(-square(slopes[1]))
"""


def test_recording_leaves_the_profiler_as_it_was() -> None:
    seen = []

    def profiler(frame: Any, event: str, argument: Any) -> None:
        seen.append(event)

    sys.setprofile(profiler)
    try:
        record(MODELS["lambert"])
        assert sys.getprofile() is profiler
    finally:
        sys.setprofile(None)


def test_a_title_cannot_leave_its_comment() -> None:
    title = "a\\\nvoid evil() {}\r\x00*/ \N{LINE SEPARATOR} ??/"
    for shader in (glsl.shader, hlsl.shader, wgsl.shader, c.shader):
        source = shader(MODELS["lambert"], title=title).source
        first = source.split("\n")[0]
        assert first.startswith("// a/ void evil() {}")
        assert "\\" not in source
        assert "*/" not in source
        assert "\N{LINE SEPARATOR}" not in source
        assert "??/" not in source


def test_uniforms_say_what_they_are() -> None:
    shader = glsl.shader(OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4) + OrenNayar(K_d=0.1), name="left_eval")
    described = {u.name: (u.glsl_type, u.value, u.slot, u.parameter.name) for u in shader.uniforms}
    assert described == {
        "left_K_d": ("vec3", (0.8, 0.7, 0.6), "K_d", "K_d"),
        "left_sigma_d": ("float", 0.4, "sigma_d", "sigma_d"),
        "left_K_d_2": ("float", 0.1, "K_d_2", "K_d"),
        "left_sigma_d_2": ("float", 0.3, "sigma_d_2", "sigma_d"),
    }
    assert "left_sigma_d;  // standard deviation of the facets' slope angle, [0, 1.571] rad; here 0.4" in shader.source


# ---------------------------------------------------------------- refused


@pytest.mark.parametrize(
    ("model", "options", "says"),
    [
        (Lambert(np.full((4, 3), 0.5)), {}, r"K_d has shape \(4, 3\)"),
        (OrenNayar(0.5, np.array([0.1, 0.2])), {}, r"sigma_d has shape \(2,\)"),
        (Dielectric(1.5), {}, "Dielectric is not a BRDF"),
        (Lambert(np.full(300, 0.5)), {}, "300 channels"),
        (Lambert(0.5), {"name": "1st"}, "'1st' is not the name"),
        (Lambert(0.5), {"name": "gl_eval"}, "is not the name"),
        (Lambert(0.5), {"name": "a__b"}, "is not the name"),
        (Lambert(0.5), {"name": "a;}"}, "is not the name"),
        (Lambert(0.5), {"name": "a" * 100}, "100 letters"),
        (Lambert(0.5), {"version": "100"}, "'100' is not one of 300 es, 450"),
    ],
)
def test_what_cannot_be_printed_is_refused(model: Any, options: dict[str, str], says: str) -> None:
    with pytest.raises(ParameterError, match=says):
        glsl.shader(model, **options)


def test_a_symbolic_tensor_is_refused() -> None:
    torch = pytest.importorskip("torch")
    assert glsl.shader(Lambert(torch.tensor(0.5))).uniforms[0].value == 0.5
    with pytest.raises(ParameterError, match="plain numbers"):
        glsl.shader(Lambert(torch.tensor([0.5, 0.5, 0.5], requires_grad=True)))
