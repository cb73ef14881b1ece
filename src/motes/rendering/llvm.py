"""Which LLVM Dr.Jit uses: chosen before Dr.Jit or Mitsuba starts it, because a wrong one ends the interpreter.

Dr.Jit takes LLVM 15 or later, by itself the first that it finds, as soon as it is imported.  But 15 and 16 abort the process
on kernels that render, and without any the process may die of SIGFPE.  So Motes chooses: a library counts only if its
version, read in a process of its own, is `OLDEST` or newer.
"""

from __future__ import annotations

import os
import platform
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from motes.errors import install_command

VARIABLE = "DRJIT_LIBLLVM_PATH"
OLDEST = 17
_SECONDS = 60  # far more than loading takes, on a busy machine too

# LLVMGetVersion came with LLVM 16.  Prints the version, or "old".
_PROBE = """
import ctypes, sys
library = ctypes.CDLL(sys.argv[1])
if not hasattr(library, "LLVMOrcCreateLLJIT"):
    raise SystemExit("it is not LLVM, or has no compiler in it")
if hasattr(library, "LLVMGetVersion"):
    numbers = [ctypes.c_uint() for _ in range(3)]
    library.LLVMGetVersion(*map(ctypes.byref, numbers))
    print(*(n.value for n in numbers), sep=".")
else:
    print("old")
"""


@dataclass(frozen=True)
class Choice:
    """The library to use, or None; `refused` says of each better candidate why it was not taken.

    `too_late` is True where Dr.Jit was imported before and took what cannot be used.
    """

    path: Path | None
    version: str = ""
    refused: tuple[str, ...] = ()
    too_late: bool = False


def refusal(path: Path) -> tuple[str, str]:
    """The version of a library, and why it cannot be used (empty when it can); asked in a process of its own."""
    try:
        done = subprocess.run(
            [sys.executable, "-I", "-S", "-c", _PROBE, str(path)], capture_output=True, text=True, timeout=_SECONDS
        )
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        return "", f"it could not be tried: {error}"
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines()
        return "", lines[-1] if lines else f"loading it ended the process with code {done.returncode}"
    version = done.stdout.strip()
    if version == "old" or not version or int(version.split(".")[0]) < OLDEST:
        known = "older than 16" if version == "old" else version
        return version, f"its version is {known}, and Dr.Jit needs {OLDEST} or later"
    return version, ""


def choose(candidates: Sequence[Path]) -> Choice:
    """The first of `candidates` that can be used."""
    refused: list[str] = []
    for path in candidates:
        version, why = refusal(path)
        if not why:
            return Choice(path, version, tuple(refused))
        refused.append(f"{path}: {why}")
    return Choice(None, refused=tuple(refused))


def candidates() -> list[Path]:
    """Libraries in the order of preference: the environment's, the wheel's, the system's from the newest."""
    named = os.environ.get(VARIABLE)
    return _once([Path(named)] if named else []) + _found()


def _found() -> list[Path]:
    """What is installed, without asking the environment."""
    wheel = sorted((Path(sys.prefix) / "lib").glob("libLLVM.so.*"))  # karellen-llvm-core
    return _once([*wheel, *sorted(_system(), key=_named_version, reverse=True)])


def _once(paths: Sequence[Path]) -> list[Path]:
    """Each file once, whatever links lead to it."""
    return list({os.path.realpath(path): path for path in reversed(paths)}.values())[::-1]


def _system() -> Iterator[Path]:
    """Where distributions put LLVM; those whose name says that they are too old are left out."""
    if sys.platform == "darwin":
        patterns = [f"{top}/opt/llvm*/lib/libLLVM.dylib" for top in ("/opt/homebrew", "/usr/local")]
    elif sys.platform == "win32":
        patterns = [str(Path(os.environ.get("PROGRAMFILES", "C:/Program Files")) / "LLVM/bin/LLVM-C.dll")]
    else:
        folders = [f"/usr/lib/{platform.machine()}-linux-gnu", "/usr/lib64", "/usr/lib", "/usr/local/lib"]
        patterns = [f"{folder}/libLLVM*.so*" for folder in folders] + ["/usr/lib/llvm-*/lib/libLLVM*.so*"]
    for pattern in patterns:
        anchor = Path(pattern).anchor
        for path in Path(anchor).glob(pattern[len(anchor) :]):
            if _named_version(path) == 0 or _named_version(path) >= OLDEST:
                yield path


def _named_version(path: Path) -> int:
    """The major version in a file's name (or its folder's: llvm-19), or 0."""
    numbers = re.search(r"LLVM[-.a-z]*(\d\d+)", path.name) or re.search(r"llvm[-@](\d+)", str(path))
    return int(numbers.group(1)) if numbers else 0


def suggest() -> None:
    """Name a library to Dr.Jit in case it is imported before `prepared` is asked; costs a look into a few folders."""
    if VARIABLE not in os.environ and "drjit" not in sys.modules:
        for path in _found()[:1]:
            os.environ[VARIABLE] = str(path)


@cache
def prepared() -> Choice:
    """Choose once for the process, and tell Dr.Jit by its environment variable.

    Without a usable library the variable names nothing that exists, so that Dr.Jit reports a missing LLVM rather than
    finds an old one by itself.  Where Dr.Jit was imported before, it has chosen, and its choice is judged.
    """
    if "drjit" in sys.modules and sys.platform == "linux":
        return _already_loaded()
    choice = choose(candidates())
    os.environ[VARIABLE] = str(choice.path) if choice.path else str(Path(sys.prefix) / "no-usable-LLVM")
    return choice


def _already_loaded() -> Choice:
    """The library that this process has loaded."""
    lines = Path("/proc/self/maps").read_text().splitlines()
    loaded = [Path(line.split(maxsplit=5)[5]) for line in lines if "libLLVM" in line]
    if not loaded:
        return Choice(None, refused=("Dr.Jit was imported before motes.rendering, and found none",), too_late=True)
    choice = choose(loaded[:1])
    return choice if choice.path else Choice(None, refused=choice.refused, too_late=True)


def missing(choice: Choice) -> tuple[str, str]:
    """What to say where no library is usable: a sentence, and the next step."""
    tried = f" ({'; '.join(choice.refused)})" if choice.refused else ""
    if choice.too_late:
        return (
            f"Dr.Jit has no LLVM {OLDEST} or later{tried}",
            f"Import motes.rendering before mitsuba and drjit, or name a library in the environment variable {VARIABLE}",
        )
    wheel = sys.platform == "linux" and platform.machine() == "x86_64"
    step = (
        f"Run {install_command('render')}"  # which brings an LLVM
        if wheel
        else f"Install LLVM {OLDEST} or later (brew install llvm, apt-get install libllvm19, ...)"
    )
    return (
        f"no LLVM {OLDEST} or later was found{tried}",
        f"{step}, or name the library in the environment variable {VARIABLE}",
    )
