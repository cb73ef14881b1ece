"""C99, C++ and CUDA: how they write a recorded model, in float or double.

The elementary functions are those of the compiler's library.  Minima and maxima keep a NaN of the operand written first, which is the one that
matters (see `motes.graph.nan`); fmin and fmax would drop it.
"""

from __future__ import annotations

from collections.abc import Collection

from motes.graph import nan
from motes.printing.language import Language, indented
from motes.printing.names import Recording
from motes.printing.shading import body, components

_WORDS = """inline restrict asm fortran acos asin atan ceil cos erf exp exp2 expm1 fabs floor fma fmax fmin fmod gamma hypot index j0 j1 jn y0 y1 yn log
log1p log2 logb main NULL pow remainder rint round sin signbit sqrt tan tgamma time trunc alignas alignof and bitand bitor catch class compl
concept constexpr decltype delete explicit export friend mutable namespace new noexcept not nullptr operator or private protected public
requires template this thread_local throw try typeid typename using virtual wchar_t xor div abs near far"""


def language(scalar: str) -> Language:
    """C in ``"float"`` or ``"double"``."""
    suffix = "f" if scalar == "float" else ""
    return Language(
        title=f"C99, C++ and CUDA, {scalar}",
        number=scalar,
        color=scalar,
        direction=scalar,
        truth="int",
        templates={
            "sqrt": f"sqrt{suffix}({{0}})",
            "asin": f"asin{suffix}({{0}})",
            "exp": f"exp{suffix}({{0}})",
            "expm1": f"expm1{suffix}({{0}})",
            "log1p": f"log1p{suffix}({{0}})",
            "where": "({0} ? {1} : {2})",
        },
        constant=f"const {scalar} {{name}} = {{value}};",
        declaration="const {type} {name} = {value};",
        splat="{0}",
        components=("{0}[0]", "{0}[1]", "{0}[2]"),
        literal=lambda value: f"{value!r}{suffix}",
        qualifier="MOTES_FUNCTION ",
        reserved=frozenset(_WORDS.split()),
        own=(),
    )


def define(
    recording: Recording, scalar: str, *, name: str, prefix: str, split: Collection[str], channels: int
) -> list[str]:
    """Lines that define ``name(wi, wo, p, f)``: the parameters are in a struct ``prefix_parameters``, the channels in the array ``f``."""
    target = language(scalar)
    parameters = recording.trace.parameters
    given = components(recording, target) | {p.symbol: p.slot for p in parameters}
    printed = body(recording, target, prefix=prefix, given=given, split=split, vectors=False, first=nan.first)
    shared = [f"const {scalar} {p.slot} = p->{p.slot};" for p in parameters if p.slot not in split]
    each = [f"const {scalar} {p.slot} = p->{p.slot}[c];" for p in parameters if p.slot in split]
    loop = [*each, *printed.each, f"f[c] = {printed.result};"]
    inside = [*printed.constants, *shared, "", *printed.shared]
    inside += [f"for (int c = 0; c < {channels}; ++c) {{", *indented(loop), "}"]
    functions = [
        f"{target.qualifier}{scalar} {prefix}_{op}({scalar} a, {scalar} b) {{ return a {sign} b ? b : a; }}"
        for op, sign in (("min", ">"), ("max", "<"))
        if any(f"{prefix}_{op}(" in text for text in (*inside, *printed.functions))
    ]
    lines = [*functions, *([""] if functions else [])]
    lines += [line for function in printed.functions for line in [*function.split("\n"), ""]]
    head = (
        f"void {name}(const {scalar} wi[3], const {scalar} wo[3], const {prefix}_parameters *p, {scalar} f[{channels}])"
    )
    return [*lines, f"{target.qualifier}{head} {{", *indented(inside), "}"]
