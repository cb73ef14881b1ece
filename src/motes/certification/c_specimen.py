"""A function in C as a specimen: compiled by the system's compiler, in a folder of its own, and called in this process."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from motes.certification.function_specimen import divided
from motes.certification.signature import ANGLES, SHAPES, Argument, Signature, declared, functions, numbers_for
from motes.certification.specimen import Drawn, Floats, Specimen, digest_of
from motes.directions import phi, theta
from motes.errors import DataError, FormatError, MotesError

COMPILERS = ("cc", "gcc", "clang")
SECONDS = 120
_INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def of_c(path: Path, source: str, function: str, parameters: Mapping[str, Any], cosine: bool) -> Specimen:
    """A function out of a file of C; ``FUNCTION_sample(wi, u, wo)`` and ``FUNCTION_pdf(wi, wo)`` beside it are called, too.

    Raises
    ------
    FormatError
        When there is no such function, its declaration is not understood, or it does not compile.
    MotesError
        When there is no compiler.
    """
    main = declared(source, function)
    if main is None:
        raise FormatError(
            f"{path} defines no function {function!r}",
            f"It has {', '.join(functions(source)) or 'none that is understood'}",
        )
    sample, density = declared(source, f"{function}_sample"), declared(source, f"{function}_pdf")
    known = {a.name for s in (main, sample, density) if s is not None for a in _further(s)}
    unknown = [name for name in parameters if name not in known]
    if unknown:
        raise DataError(
            f"{function} takes no {unknown[0]}", f"It takes {', '.join(sorted(known)) or 'no further numbers'}"
        )
    channels = _channels(main)
    lines = [f'#include "{path.resolve()}"', *_loop(main, "motes_certified_f", parameters, channels)]
    if sample is not None:
        lines += _loop(sample, "motes_certified_sample", parameters, 3)
    if density is not None:
        lines += _loop(density, "motes_certified_pdf", parameters, 1)
    library, version = compiled("\n".join(lines) + "\n", path)

    def value(wi: Floats, wo: Floats) -> Floats:
        pair = _angles(wi, wo) if _by_angles(main) else (wi, wo)
        values = _call(library.motes_certified_f, main.scalar, *pair, channels)
        return divided(values, wo) if cosine else values

    return Specimen(
        name=function,
        kind="function in C",
        eval=value,
        digest=digest_of(*_sources(path, source), repr(sorted(parameters.items()))),
        sample=None if sample is None else _sampler(library.motes_certified_sample, sample.scalar),
        pdf=None
        if density is None
        else lambda wi, wo: _call(library.motes_certified_pdf, density.scalar, wi, wo, 1)[:, 0],
        single=main.scalar == "float",
        strict=False,
        facts={
            "called as": f"{function}({', '.join(a.name for a in main.arguments)})",
            "computes in": main.scalar,
            "answers": "f times the cosine of wo, divided here" if cosine else "f in 1/sr, without a cosine",
            **{name: str(value) for name, value in parameters.items()},
        },
        versions={"compiler": version},
    )


# ---------------------------------------------------------------- what is called


def _by_angles(signature: Signature) -> bool:
    return tuple(a.name for a in signature.arguments[:3]) == ANGLES


def _fixed(signature: Signature) -> tuple[Argument, ...]:
    """The arguments that are directions, random numbers, results or a struct of defaults."""
    if _by_angles(signature):
        return signature.arguments[:3] + tuple(a for a in signature.arguments[3:] if a.size is not None)
    return tuple(a for a in signature.arguments if a.size is not None)


def _further(signature: Signature) -> tuple[Argument, ...]:
    return tuple(a for a in signature.arguments if a not in _fixed(signature))


def _channels(signature: Signature) -> int:
    """How many values it gives."""
    results = [
        a for a in signature.arguments if a.size is not None and not a.constant and a.kind in ("float", "double")
    ]
    vectors = [a for a in signature.arguments if a.size is not None and a.constant and a.kind in ("float", "double")]
    right = (len(vectors) == 2 or _by_angles(signature)) and (
        (signature.returns == "void" and len(results) == 1 and (results[0].size or 0) > 0)
        or (signature.returns in ("float", "double") and not results)
    )
    if not right:
        raise FormatError(
            f"the declaration of {signature.name} is not one of those that are known", f"Known are {SHAPES}"
        )
    return (results[0].size or 1) if results else 1


def _loop(signature: Signature, name: str, parameters: Mapping[str, Any], size: int) -> list[str]:
    """A function over arrays of pairs that calls it."""
    scalar = signature.scalar
    values = dict(
        zip((a.name for a in _further(signature)), numbers_for(signature, _further(signature), parameters), strict=True)
    )
    second = 2 if name.endswith("sample") else 3
    inputs = iter(("motes_a + 3 * motes_k", f"motes_b + {second} * motes_k"))
    angles = iter(f"motes_a[3 * motes_k + {part}]" for part in range(3))
    passed = []
    for argument in signature.arguments:
        if argument.name in values:
            passed.append(f"({argument.kind}){float(values[argument.name])!r}")
        elif argument.size is None:
            passed.append(next(angles))
        elif argument.kind.endswith("_parameters"):  # as Motes exports: a struct whose values lie beside it
            passed.append(f"&{argument.kind.removesuffix('_parameters')}_defaults")
        elif argument.constant:
            passed.append(next(inputs))
        else:
            passed.append(f"motes_result + {size} * motes_k")
    call = f"{signature.name}({', '.join(passed)});"
    body = call if signature.returns == "void" else f"motes_result[motes_k] = {call}"
    return [
        f"void {name}(long motes_n, const {scalar} *motes_a, const {scalar} *motes_b, {scalar} *motes_result) {{",
        f"    for (long motes_k = 0; motes_k < motes_n; ++motes_k) {body}",
        "}",
    ]


def _angles(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """theta_i, theta_r, dphi in the place of the first direction."""
    packed = np.stack([theta(wi), theta(wo), np.mod(phi(wo) - phi(wi), 2 * np.pi)], -1)
    return packed, wo


def _call(function: Any, scalar: str, a: Floats, b: Floats, size: int) -> Floats:
    number = np.float32 if scalar == "float" else np.float64
    arrays = [np.ascontiguousarray(np.broadcast_to(w, (len(b), w.shape[-1])), number) for w in (a, b)]
    values = np.empty((len(b), size), number)
    function(ctypes.c_long(len(b)), *(ctypes.c_void_p(x.ctypes.data) for x in (*arrays, values)))
    return values.astype(np.float64)


def _sampler(function: Any, scalar: str) -> Callable[[Floats, Floats], Drawn]:
    def drawn(wi: Floats, u: Floats) -> Drawn:
        return Drawn(_call(function, scalar, np.broadcast_to(wi, (len(u), 3)), u, 3), np.full(len(u), np.nan), None)

    return drawn


# ---------------------------------------------------------------- compiling


def compiled(text: str, path: Path) -> tuple[ctypes.CDLL, str]:
    """A library made of a text in C, and the compiler's version; `path` is what errors call it.

    Raises
    ------
    FormatError
        When it does not compile.
    MotesError
        When there is no compiler.
    """
    compiler = next((found for name in COMPILERS if (found := shutil.which(name))), None)
    if compiler is None:
        raise MotesError(f"there is no compiler for C ({', '.join(COMPILERS)})", "Install gcc or clang")
    with tempfile.TemporaryDirectory(prefix="motes-c-") as folder:
        source, library = Path(folder) / "run.c", Path(folder) / "run.so"
        source.write_text(text, encoding="utf-8")
        options = ("-std=gnu11", "-O1", "-ffp-contract=off", "-w", "-shared", "-fPIC")
        try:
            done = subprocess.run(
                [compiler, *options, str(source), "-o", str(library), "-lm"],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=SECONDS,
                check=False,
            )
        except subprocess.TimeoutExpired:
            raise FormatError(f"{path} takes more than {SECONDS} s to compile", "Compile it alone first") from None
        if done.returncode != 0:
            lines = (
                [line for line in done.stderr.splitlines() if "error" in line]
                or done.stderr.splitlines()
                or ["no reason"]
            )
            raise FormatError(
                f"{path} does not compile: {lines[0][:300]}", f"Try it alone first: {Path(compiler).name} -c {path}"
            )
        version = subprocess.run(
            [compiler, "--version"], capture_output=True, text=True, errors="replace", timeout=SECONDS, check=False
        )
        loaded = ctypes.CDLL(str(library))
    return loaded, (version.stdout.splitlines() or ["unknown"])[0]


def _sources(path: Path, source: str) -> list[str]:
    """The file and those beside it that it includes: what is certified."""
    texts, seen, left = [source], {path.resolve()}, [(path, source)]
    while left:
        where, text = left.pop()
        for name in _INCLUDE.findall(text):
            file = (where.parent / name).resolve()
            if file.is_file() and file not in seen:
                seen.add(file)
                texts.append(file.read_text(encoding="utf-8", errors="replace"))
                left.append((file, texts[-1]))
    return texts
