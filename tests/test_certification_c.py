"""Functions in C as subjects: what their declarations say, the exports of Motes, planted faults, and what does not compile."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import planted_faults as planted
from motes import OrenNayar, TorranceSparrow
from motes.certification import Outcome, certify
from motes.certification.recognising import specimen_of
from motes.certification.signature import declared
from motes.errors import DataError, FormatError, MotesError
from motes.exports import c

Run = Callable[..., tuple[int, str, str]]
needs_compiler = pytest.mark.skipif(
    shutil.which("cc") is None and shutil.which("gcc") is None, reason="cc is not installed"
)

GGX = """
#include <math.h>
/* Trowbridge-Reitz with Smith's masking; f(wi, wo) in a comment { is none */
static double lambda(double z, double a) { return 0.5 * (sqrt(1 + a * a * (1 - z * z) / (z * z)) - 1); }
double ggx(const double wi[3], const double *wo, double alpha) {
    if (wi[2] <= 1e-6 || wo[2] <= 1e-6) return 0.0;
    double x = wi[0] + wo[0], y = wi[1] + wo[1], z = wi[2] + wo[2];
    double n = sqrt(x * x + y * y + z * z), t = z / n * z / n * (alpha * alpha - 1) + 1;
    double d = alpha * alpha / (3.14159265358979323846 * t * t);
    return d / (1 + lambda(wi[2], alpha) + lambda(wo[2], alpha)) / (%s * wi[2] * wo[2]);
}
"""
LAMBERT = """
void paper(const float wi[3], const float wo[3], float result[3]) {
    for (int k = 0; k < 3; ++k) result[k] = wi[2] > 0 && wo[2] > 0 ? (3 - k) * 0.2f * %s : 0.0f;
}
void paper_sample(const float wi[3], const float u[2], float wo[3]) {
    float r = __builtin_sqrtf(u[0]), phi = 6.28318531f * u[1];
    wo[0] = r * __builtin_cosf(phi); wo[1] = r * __builtin_sinf(phi); wo[2] = __builtin_sqrtf(1 - u[0]);
}
float paper_pdf(const float wi[3], const float wo[3]) { return wo[2] > 0 ? wo[2] * %s : 0; }
"""


def written(path: Path, text: str) -> Path:
    path.write_text(text)
    return path


@needs_compiler
def test_a_right_one_raises_no_alarm(tmp_path: Path) -> None:
    file = written(tmp_path / "ggx.c", GGX % "4")
    found = certify(f"{file}:ggx", parameters={"alpha": 0.3}, as_model=planted.GGX)
    assert not found.findings
    assert found.kind == "function in C"
    assert "compiler" in found.versions
    rng = np.random.default_rng(3)
    w = rng.normal(size=(2, 200, 3))
    w[..., 2] = np.abs(w[..., 2])
    wi, wo = w / np.linalg.norm(w, axis=-1, keepdims=True)
    values = specimen_of(f"{file}:ggx", parameters={"alpha": 0.3}).eval(wi, wo)
    assert_allclose(values, planted.ggx(wi, wo, 0.3), rtol=1e-9)


@needs_compiler
@pytest.mark.parametrize(
    ("denominator", "alpha", "name"),
    [("4", 0.09, "alpha-squared"), ("1", 0.3, "factor-4"), ("3.14159265358979", 0.3, "factor-4-pi-for-4")],
)
def test_its_conventions_are_told(tmp_path: Path, denominator: str, alpha: float, name: str) -> None:
    file = written(tmp_path / "ggx.c", GGX % denominator)
    found = certify(f"{file}:ggx", parameters={"alpha": alpha}, as_model=planted.GGX)
    assert [f.name for f in found.check("conventions").findings] == [name]
    assert not found.ok


@needs_compiler
def test_its_samples_are_judged_in_float(tmp_path: Path) -> None:
    right = certify(f"{written(tmp_path / 'right.c', LAMBERT % ('0.318309886f', '0.318309886f'))}:paper")
    assert not right.findings
    assert right.check("sampling").outcome is Outcome.HOLDS
    wrong = certify(f"{written(tmp_path / 'wrong.c', LAMBERT % ('1', '1'))}:paper")
    assert [f.name for f in wrong.check("energy").findings] == ["factor-pi"]
    assert [f.name for f in wrong.check("sampling").findings] == ["scale-of-pdf"]


@needs_compiler
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_what_motes_exports_is_its_model(tmp_path: Path, scalar: str) -> None:
    model = OrenNayar((0.6, 0.4, 0.2), 0.4) + TorranceSparrow(0.3, 0.2)
    file = written(tmp_path / "paint.h", c.shader(model, scalar=scalar).source)
    found = certify(f"{file}:motes_eval", against=model)
    assert not found.findings, found.findings
    assert found.facts["computes in"] == scalar


@needs_compiler
def test_a_function_of_angles(tmp_path: Path) -> None:
    text = "#include <math.h>\ndouble f(double theta_i, double theta_r, double dphi) {\n    return (1 + 0.3 * sin(theta_i) * sin(theta_r) * cos(dphi)) / 8; }\n"
    found = certify(f"{written(tmp_path / 'a.c', text)}:f")
    assert {f.name for f in found.findings} == {"below-horizon"}
    assert_allclose(found.check("energy").numbers["spherical_albedo"], np.pi / 8, rtol=2e-3)


def test_declarations_are_understood() -> None:
    found = declared(
        "static inline void f(const double *wi, double const wo[3], const p_parameters *p, double f[31]) {", "f"
    )
    assert found is not None
    assert [(a.kind, a.name, a.size, a.constant) for a in found.arguments] == [
        ("double", "wi", 0, True),
        ("double", "wo", 3, True),
        ("p_parameters", "p", 0, True),
        ("double", "f", 31, False),
    ]
    assert declared("// void g(int a) {\n/* void g(int b) { */ void h(int c) {", "g") is None


@needs_compiler
@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("double g(const double wi[3], const double wo[3]) { return 1; }", "It has g"),
        ("double f(const double wi[3], const double wo[3]) { return one; }", "does not compile"),
        ("double f(const double wi[3]) { return 1; }", "not one of those that are known"),
        ("void f(const double wi[3], const double wo[3], double *out) { }", "not one of those that are known"),
        ("double f(const double wi[3], const double wo[3], double alpha) { return 1; }", "--set alpha=0.3"),
        ("double f(double (*g)(double), const double wo[3]) { return 1; }", "defines no function"),
    ],
)
def test_what_cannot_be_called_is_said(tmp_path: Path, text: str, says: str) -> None:
    file = written(tmp_path / "bad.c", text)
    with pytest.raises((FormatError, DataError)) as error:
        certify(f"{file}:f")
    assert says in str(error.value)


@needs_compiler
def test_what_is_included_is_certified_too(tmp_path: Path) -> None:
    written(tmp_path / "k.h", "static const double K = 0.1;\n")
    file = written(
        tmp_path / "f.c",
        '#include "k.h"\ndouble f(const double wi[3], const double wo[3]) { return wi[2] > 0 && wo[2] > 0 ? K : 0; }\n',
    )
    one = specimen_of(f"{file}:f")
    written(tmp_path / "k.h", "static const double K = 0.2;\n")
    two = specimen_of(f"{file}:f")
    assert one.digest != two.digest
    with pytest.raises(DataError, match="takes no alpha"):
        specimen_of(f"{file}:f", parameters={"alpha": 1.0})


def test_without_a_compiler_it_says_what_is_missing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "which", lambda name: None)
    file = written(tmp_path / "f.c", "double f(const double wi[3], const double wo[3]) { return 1; }")
    with pytest.raises(MotesError, match="no compiler for C"):
        certify(f"{file}:f")


@needs_compiler
def test_the_command_takes_it(motes: Run) -> None:
    Path("ggx.c").write_text(GGX % "4")
    status, out, err = motes("certify", "ggx.c:ggx", "--set", "alpha=0.09", "--as", planted.GGX, "--quiet")
    assert (status, out, err) == (1, "", "")
    assert "alpha-squared" in Path("certificate-ggx.html").read_text(encoding="utf-8")
