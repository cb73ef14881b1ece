"""Generated modules, compiled once and kept in the user's cache folder, so that the next process loads them in a fraction of a second.

The folder is ``$MOTES_CACHE``, or ``motes`` in the platform's place for caches.  It holds code that is executed: it is made readable by its
owner only, and one that others could write is not used (see `motes.files.trust`).
"""

from __future__ import annotations

import atexit
import contextlib
import hashlib
import importlib.util
import logging
import os
import platform
import shutil
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from motes.errors import MotesError
from motes.files.trust import distrusted


class _Distrusted(Exception):
    """A folder that others could put code into, in words."""


def cache_folder() -> Path:
    """Where kernels are kept: ``$MOTES_CACHE``, or ``motes`` in the platform's folder for caches.

    Raises
    ------
    MotesError
        When neither the environment nor the system says where the user's home is.
    """
    if chosen := os.environ.get("MOTES_CACHE"):
        return Path(chosen)
    if sys.platform == "darwin":
        return _home() / "Library" / "Caches" / "motes"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or _home() / "AppData" / "Local") / "motes" / "Cache"
    return Path(os.environ.get("XDG_CACHE_HOME") or _home() / ".cache") / "motes"


def _home() -> Path:
    try:
        return Path.home()
    except RuntimeError:  # no HOME, and no account with this number: containers that run as any user
        raise MotesError(
            "this user has no home folder to keep kernels in", "Name a folder for them in the environment: MOTES_CACHE"
        ) from None


def compiled_module(
    source: str, title: str, uses: Sequence[Any] = (), on_compile: Callable[[str], None] | None = None
) -> Any:
    """Import a generated module from the cache folder, compiled there; from a temporary folder where that is not possible.

    Parameters
    ----------
    source
        Of the module; the same source is compiled once.
    title
        What it is, for people who wait.
    uses
        The modules of Motes, besides those of this room, whose functions are compiled into it.
    on_compile
        Called with a sentence before something is compiled, which takes some seconds.
    """
    import llvmlite
    import numba

    from motes.kernels import intrinsics, vector_functions, vectors
    from motes.version import __version__

    versions = [
        __version__,
        numba.__version__,
        llvmlite.__version__,
        np.__version__,
        platform.python_version(),
        platform.machine(),
    ]
    used = [Path(m.__file__ or "").read_text(encoding="utf-8") for m in (intrinsics, vectors, vector_functions, *uses)]
    basis = [source, *versions, *used]
    name = "motes_" + hashlib.sha256("\0".join(basis).encode()).hexdigest()[:24]
    log = logging.getLogger(__name__)
    try:
        folder = cache_folder()
    except MotesError as error:
        log.info("%s", error)
        return _imported(source, name, title, _temporary(), f"not kept: {error.message}", on_compile)
    try:
        return _imported(source, name, title, folder, f"kept in {folder}", on_compile)
    except _Distrusted as reason:  # nothing in it is touched, whosever it is
        log.warning("the cache folder %s is not used, for code is run from it and %s", folder, reason)
        kept = f"not kept: {reason}"
    except Exception as error:  # not writable, full, or holding something broken
        log.info("the cache folder %s cannot be used: %s", folder, error)
        kept = f"not kept: {folder} cannot be used"
        for broken in (folder / "__pycache__").glob(f"{name}.*"):
            with contextlib.suppress(OSError):
                broken.unlink()
    return _imported(source, name, title, _temporary(), kept, on_compile)


def _temporary() -> Path:
    """A folder of this process alone, which goes with it."""
    folder = Path(tempfile.mkdtemp(prefix="motes-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def _imported(
    source: str, name: str, title: str, folder: Path, kept: str, on_compile: Callable[[str], None] | None
) -> Any:
    path = folder / f"{name}.py"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    compiled = folder / "__pycache__"
    there = [p for p in (path, compiled, *compiled.glob(f"{name}.*")) if os.path.lexists(p)]
    if reason := distrusted(folder, there):
        raise _Distrusted(reason)
    if not path.exists() or path.read_text(encoding="utf-8") != source:
        handle, temporary = tempfile.mkstemp(prefix=f".{name}.", suffix=".tmp", dir=folder)
        try:
            with os.fdopen(handle, "w", encoding="utf-8") as file:
                file.write(source)
            os.replace(temporary, path)
        except BaseException:
            Path(temporary).unlink(missing_ok=True)
            raise
    if not any(compiled.glob(f"{name}.*.nbi")):
        sentence = f"compiling {title} once ({kept})"
        logging.getLogger(__name__).info(sentence)
        if on_compile is not None:
            on_compile(sentence)
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # Numba looks for the functions of a cached kernel by the name of their module
    spec.loader.exec_module(module)
    return module
