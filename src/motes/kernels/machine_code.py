"""From LLVM's text to functions that can be called: optimised once, for the processor at hand or for a level that it has.

What is made is an object, as linkers know them, that another process loads in some milliseconds.  ``$MOTES_PROCESSOR`` names a level of x86-64, for
instructions that other machines have, too, and for the same bits on all of them; it is read once, when the first kernel is asked for.
"""

from __future__ import annotations

import ctypes
import functools
import os
import threading
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from motes.errors import MotesError
from motes.kernels import object_code

#: Kernels are functions of integers; they let go of the interpreter's lock.
Kernel = Callable[..., Any]
_lock = threading.RLock()
#: The levels of x86-64 (System V ABI, "Micro-Architecture Levels"), and what each adds to those before it, in LLVM's names.
LEVELS = {
    "x86-64-v2": ("cx16", "popcnt", "sahf", "sse3", "sse4.1", "sse4.2", "ssse3"),
    "x86-64-v3": ("avx", "avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe", "xsave"),
    "x86-64-v4": ("avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"),
}


def _machine() -> Any:
    """What LLVM knows of this processor; an engine takes one for itself."""
    return object_code.machine_for(*processor())


@functools.cache
def processor() -> tuple[str, str]:
    """The processor's name, and what it can do; or a level of it."""
    from llvmlite import binding

    if level := os.environ.get("MOTES_PROCESSOR"):
        return level, ",".join(f"+{feature}" for feature in _allowed(level))
    try:
        return binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    except RuntimeError:  # LLVM knows the name of this processor only
        return binding.get_host_cpu_name(), ""


def host_features() -> set[str]:
    """What the processor at hand can do, in LLVM's names; nothing where LLVM does not know."""
    from llvmlite import binding

    try:
        return {feature for feature, has in binding.get_host_cpu_features().items() if has}
    except RuntimeError:
        return set()


def features_of(level: str) -> list[str]:
    """What a level of x86-64 can do: what it adds, and what those before it do."""
    return [feature for name, more in LEVELS.items() if name <= level for feature in more]


def _allowed(level: str) -> list[str]:
    """The same, of a level that the processor at hand has.

    Raises
    ------
    MotesError
        When there is no such level, or the processor lacks some of it.
    """
    there = host_features()
    has = ", ".join(name for name in LEVELS if there.issuperset(features_of(name)))
    hint = f"Name one of {has}, or none" if has else "Name none"
    this = f"this processor has {has or 'none of them'}"
    if level not in LEVELS:
        raise MotesError(f"MOTES_PROCESSOR is {level!r}, expected one of {', '.join(LEVELS)}; {this}", hint)
    if lacking := [feature for feature in features_of(level) if feature not in there]:
        raise MotesError(f"MOTES_PROCESSOR is {level}, but this processor lacks {', '.join(lacking)}; {this}", hint)
    return features_of(level)


def is_x86() -> bool:
    """Whether this process runs on a processor of Intel's kind."""
    from llvmlite import binding

    return str(binding.get_process_triple()).startswith(("x86_64", "i386", "i686"))


def vector_bytes() -> int:
    """The bytes of the processor's vectors."""
    features = set(processor()[1].split(","))
    return 64 if "+avx512f" in features else 32 if "+avx" in features else 16


def long_roots() -> bool:
    """Whether roots of vectors of 64 bytes take so long that a dozen multiplications are made in the meantime.

    So it is on Intel's processors: 18 cycles for 8 numbers in float64, in which two pipes do 36 operations.  AMD's have a faster way to them.  It is
    known by name and not measured, and roots have the same bits either way.
    """
    from llvmlite import binding

    return vector_bytes() == 64 and not str(binding.get_host_cpu_name()).startswith("znver")


def without_estimates() -> bool:
    """Whether 1/sqrt(x) is made without the processor's estimate of 12 bits, which makers' processors give different bits of: where a level is named.

    That of 14 bits, of AVX-512, is kept: Intel says what each of its bits is, and a tenth of the time goes without it.
    """
    return processor()[0] in LEVELS and vector_bytes() < 64


def tuning() -> str:
    """The processor for which LLVM orders a program of vectors; nothing where that is the one at hand.

    What LLVM knows of Intel's processors with AVX-512 makes it ask for roots and divisions later than its tables for none in particular do.
    """
    return "generic" if long_roots() else ""


def description() -> str:
    """What compiled code depends on: the version of LLVM and the processor."""
    import llvmlite
    from llvmlite import binding

    versions = [llvmlite.__version__, *map(str, binding.llvm_version_info)]
    return "\0".join([*versions, binding.get_process_triple(), *processor(), str(long_roots())])


def compiled(text: str) -> bytes:
    """The object of a module, or of a part of one."""
    return object_code.object_of(text, *processor())


def assembly(text: str) -> str:
    """The processor's instructions of a module, for people."""
    machine = _machine()
    return str(machine.emit_assembly(optimised(text, machine)))


def optimised(text: str, machine: Any = None) -> Any:
    """LLVM's module of a text, as it is before it becomes an object."""
    return object_code.optimised_for(text, machine or _machine())


def loaded(codes: Sequence[bytes], kernels: Mapping[str, tuple[int, bool]]) -> dict[str, Kernel]:
    """The functions of objects that call each other, by name; of each the number of arguments, and whether it returns an integer."""
    from llvmlite import binding

    with _lock:
        engine = binding.create_mcjit_compiler(binding.parse_assembly(""), _machine())
        for code in codes:
            engine.add_object_file(binding.ObjectFileRef.from_data(code))
        engine.finalize_object()
        return {name: _called(engine, name, *how) for name, how in kernels.items()}


def _called(engine: Any, name: str, count: int, returns: bool) -> Kernel:
    kind = ctypes.CFUNCTYPE(ctypes.c_int64 if returns else None, *[ctypes.c_int64] * count)
    function: Any = kind(engine.get_function_address(name))
    function.engine = engine  # its memory is the function's
    kernel: Kernel = function
    return kernel
