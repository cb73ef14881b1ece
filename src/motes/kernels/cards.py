"""Where printed CUDA C++ runs: on a graphics card, by CuPy, or on the processor, by a C++ compiler, which checks the text where there is no card.

A kernel takes addresses and sizes, 64-bit integers all.  On a card it is started with a number of threads; on the processor it loops over them itself.
`machine_code` compiles a text for a card that need not be there.
"""

from __future__ import annotations

import atexit
import ctypes
import shutil
import subprocess
import tempfile
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from motes.errors import MissingExtraError, MotesError

#: A kernel: the number of threads, then its arguments.
Launch = Callable[..., None]
THREADS = 128  # of a block, as the hardware starts them
ROOM = 0.5  # of the free memory of a card that a call takes for its own use at most
STANDARD = "--std=c++17"


class Held(Protocol):
    """An array where kernels see it."""

    address: int

    def read(self, target: NDArray[Any]) -> None:
        """Copy it into an array of NumPy's."""


class Device(Protocol):
    """Where kernels run."""

    name: str

    def compiled(self, source: str, kernel: str) -> Launch:
        """A kernel of a text."""

    def held(self, values: NDArray[Any]) -> Held:
        """A copy of an array in one piece."""

    def room(self, bytes_each: int, most: int) -> tuple[Held, int]:
        """Memory that is not filled, for `most` groups or as many as serve, and their number."""


def device(name: str) -> Device:
    """The device of a name: ``"cuda"``, the card that CuPy uses, or ``"c++"``, the processor by a compiler, which is for checks.

    Raises
    ------
    MissingExtraError
        Without CuPy.
    MotesError
        Without a card or a compiler, or for another name.
    """
    if name == "cuda":
        return Card()
    if name == "c++":
        return Processor()
    raise MotesError(f'device {name!r} is not "cuda" or "c++"', "Leave it out for the compiled engine of the processor")


class Card:
    """A graphics card of NVIDIA's, by CuPy."""

    name = "cuda"

    def __init__(self) -> None:
        try:
            import cupy
        except ImportError as error:
            raise MissingExtraError("cupy", "cuda", "a graphics card") from error
        self._cupy: Any = cupy
        try:
            cupy.cuda.runtime.getDevice()
        except cupy.cuda.runtime.CUDARuntimeError as error:
            raise MotesError(f"there is no graphics card here: {error}", "Leave the device out") from error

    def compiled(self, source: str, kernel: str) -> Launch:
        function = self._cupy.RawModule(code=source, options=(STANDARD,)).get_function(kernel)

        def launch(threads: int, *arguments: int) -> None:
            function((-(-threads // THREADS),), (THREADS,), tuple(np.int64(a) for a in arguments))

        return launch

    def held(self, values: NDArray[Any]) -> Held:
        return _OnCard(self._cupy.asarray(np.ascontiguousarray(values)), self._cupy)

    def room(self, bytes_each: int, most: int) -> tuple[Held, int]:
        cupy = self._cupy
        free, _ = cupy.cuda.runtime.memGetInfo()
        count = int(max(1, min(most, ROOM * free // bytes_each)))
        return _OnCard(cupy.empty(count * bytes_each, np.uint8), cupy), count


class _OnCard:
    def __init__(self, array: Any, cupy: Any) -> None:
        self._array, self._cupy = array, cupy
        self.address = int(array.data.ptr)

    def read(self, target: NDArray[Any]) -> None:
        target[...] = self._cupy.asnumpy(self._array).reshape(target.shape)


class Processor:
    """The same text as C++, compiled and run here, one thread after the other: a check, not a fast way."""

    name = "c++"

    def __init__(self) -> None:
        self._compiler = next(filter(None, map(shutil.which, ("g++", "clang++", "c++"))), None)
        if self._compiler is None:
            raise MotesError("there is no C++ compiler here (g++, clang++, c++)", "apt-get install g++")

    @cached_property
    def _folder(self) -> tempfile.TemporaryDirectory[str]:
        folder = tempfile.TemporaryDirectory(prefix="motes-")
        atexit.register(folder.cleanup)  # a library that is loaded stays so
        return folder

    def compiled(self, source: str, kernel: str) -> Launch:
        folder = Path(tempfile.mkdtemp(dir=self._folder.name))  # a library is loaded once by its path
        text, library = folder / "kernel.cpp", folder / "kernel.so"
        text.write_text(source, encoding="utf-8")
        assert self._compiler is not None
        command = [self._compiler, "-std=c++17", "-O0", "-fPIC", "-shared", str(text), "-o", str(library)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            raise MotesError(
                f"the compiler refuses what was printed: {done.stderr[:300]}",
                "It is written for g++ 9 or clang 10 and later",
            )
        function = ctypes.CDLL(str(library))[kernel]
        function.restype = None

        def launch(threads: int, *arguments: int) -> None:
            function(*(ctypes.c_longlong(a) for a in arguments))

        return launch

    def held(self, values: NDArray[Any]) -> Held:
        return _Here(np.array(values, order="C"))

    def room(self, bytes_each: int, most: int) -> tuple[Held, int]:
        count = min(most, 4)
        return _Here(np.empty(count * bytes_each, np.uint8)), count


class _Here:
    def __init__(self, array: NDArray[Any]) -> None:
        self._array = array
        self.address = array.ctypes.data

    def read(self, target: NDArray[Any]) -> None:
        target[...] = self._array.reshape(target.shape)


# ---------------------------------------------------------------- without a card


def machine_code(source: str, architecture: str = "sm_90") -> bytes:
    """What NVIDIA's compiler makes of a text for cards of an architecture (``sm_80``: A100, ``sm_89``: RTX 40, ``sm_90``: H100); no card is needed.

    Raises
    ------
    MissingExtraError
        Without NVIDIA's compiler (NVRTC).
    MotesError
        Where it refuses the text.
    """
    try:
        from cuda.bindings import nvrtc

        nvrtc.nvrtcVersion()  # loads the library
    except (ImportError, RuntimeError) as error:
        raise MissingExtraError("cuda-bindings", "cuda", "compiling for a graphics card") from error

    def called(function: str, *arguments: Any) -> Any:
        status, *found = getattr(nvrtc, function)(*arguments)
        if status != nvrtc.nvrtcResult.NVRTC_SUCCESS:
            raise MotesError(
                f"NVIDIA's compiler refuses what was printed ({status.name}): {log()[:300]}",
                f"{architecture} may be unknown to it: name another architecture, such as sm_80",
            )
        return found[0] if found else None

    def log() -> str:
        _, size = nvrtc.nvrtcGetProgramLogSize(program)
        text = bytes(size)
        nvrtc.nvrtcGetProgramLog(program, text)
        return text.rstrip(b"\0").decode(errors="replace")

    program = called("nvrtcCreateProgram", source.encode(), b"kernels.cu", 0, [], [])
    try:
        options = [f"--gpu-architecture={architecture}".encode(), STANDARD.encode(), b"--disable-warnings"]
        called("nvrtcCompileProgram", program, len(options), options)
        code = bytes(called("nvrtcGetCUBINSize", program))
        called("nvrtcGetCUBIN", program, code)
        return code
    finally:
        nvrtc.nvrtcDestroyProgram(program)
