"""What is printed for kernels over directions, and what LLVM makes of it."""

from __future__ import annotations

import math
import re
from collections.abc import Callable

import pytest

from catalogue import ENTRIES

pytest.importorskip("llvmlite")

from motes.graph import tracing
from motes.graph.recording import Kind, recorded
from motes.kernels import gradients, loops, machine_code
from motes.kernels.lowering import lowered
from motes.models import Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow

DUSTY = next(entry.model for entry in ENTRIES if entry.name == "dust_layer")


def test_printing_is_deterministic() -> None:
    texts = {gradients.gradient(tracing.trace(DUSTY, 3), ("tau",), "float32").source for _ in range(3)}
    assert len(texts) == 1


def test_a_module_holds_what_it_needs() -> None:
    plain = loops.evaluation(tracing.trace(Lambert()), (), "float64").source
    assert "def exp(" not in plain
    sample = recorded(Kind.SAMPLE, DUSTY, 3)
    assert sample is not None
    full = loops.sampling(sample, (), "float64").source
    assert "def exp(" in full
    assert "float32" not in full.partition("F, I")[2]
    program = loops.evaluation(tracing.trace(DUSTY, 3), (), "float64").source
    assert re.search(r"t\d+ = exp2_below t\d+\n", program)
    assert "def exp(" not in program, "vectors bring their own functions"


def test_what_depends_on_uniform_parameters_alone_is_a_constant() -> None:
    kernel = loops.evaluation(tracing.trace(OrenNayar()), (), "float64")
    span = kernel.source.split("def stretch")[1].split("@kernel")[0]
    assert "0.09" not in span, "sigma_d^2 / (sigma_d^2 + 0.09) is computed beforehand"
    varying = loops.evaluation(tracing.trace(OrenNayar()), ("sigma_d",), "float64")
    assert "0.09" in varying.source
    assert [p.slot for p in varying.varying] == ["sigma_d"]
    assert not {p.symbol for p in varying.varying} & set(varying.constants)


def test_division_by_a_constant_is_multiplication() -> None:
    trace = tracing.trace(TorranceSparrow())
    kernel = loops.evaluation(trace, (), "float64")
    (sigma_s,) = (p.symbol for p in trace.parameters if p.slot == "sigma_s")
    assert 1 / sigma_s * math.sqrt(1 / math.log(2)) in kernel.constants, "which exponentials to the base 2 are of"
    assert sigma_s not in kernel.constants


def test_a_gradient_adds_up_derivatives_by_constants() -> None:
    trace = tracing.trace(DustLayer(OrenNayar() + TorranceSparrow(), Dust()))
    kernel = gradients.gradient(trace, (), "float32")
    assert kernel.totals
    assert all(symbol.op not in ("lt", "le", "gt", "ge") for symbol in kernel.totals), "a truth value has no derivative"
    assert kernel.source.count("\nsum sums ") == len(kernel.totals)


@pytest.mark.parametrize("printer", [loops.evaluation, gradients.gradient])
def test_the_loop_is_vectorised_and_calls_nothing(printer: Callable[..., loops.Kernel]) -> None:
    source = printer(tracing.trace(DUSTY, 3), (), "float32").source
    ir = str(machine_code.optimised(lowered(source).text))
    assert re.search(r"fdiv [\w ]*<\d+ x float>", ir)
    assert re.search(r"call [\w ]*<\d+ x float> @llvm\.sqrt", ir)
    called = set(re.findall(r"call [^@\n]*@([\w.\"]+)\(", ir))
    assert not [name for name in called if re.search(r"^(exp|expm1|asin|pow|sqrt)f?$", name)], called


def test_samples_are_made_in_whole_vectors_of_the_processor() -> None:
    trace = recorded(Kind.SAMPLE, DUSTY, 3)
    assert trace is not None
    text = machine_code.assembly(lowered(loops.sampling(trace, (), "float32").source).text)
    whole = {64: "zmm", 32: "ymm", 16: "xmm"}[machine_code.vector_bytes()]
    assert len(re.findall(rf"v?mulps.*%{whole}", text)) > 50
