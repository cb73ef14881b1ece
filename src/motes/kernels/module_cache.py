"""Generated modules, compiled once and kept in the user's cache folder, so that the next process loads them in a fraction of a second.

The folder is ``$MOTES_CACHE``, or ``motes`` in the platform's place for caches.  It holds code that is executed: it is made readable by its
owner only, and one that others could write is not used (see `motes.files.trust`).
"""

from __future__ import annotations

import hashlib
import json
import logging
import os
import sys
import tempfile
from collections.abc import Callable, Sequence
from itertools import accumulate
from pathlib import Path
from types import SimpleNamespace

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


def compiled_module(source: str, title: str, on_compile: Callable[[str], None] | None = None) -> SimpleNamespace:
    """The kernels of a generated module by name, from the cache folder; compiled, and kept there where that is possible.

    Parameters
    ----------
    source
        Of the module (see `motes.kernels.lowering`); the same source is compiled once.
    title
        What it is, for people who wait.
    on_compile
        Called with a sentence before something is compiled, which takes about a second.
    """
    from motes.kernels import (
        assembly,
        compiling,
        lowered_values,
        lowering,
        machine_code,
        object_code,
        transposing,
        vector_functions,
        vectors,
    )
    from motes.printing import elementary
    from motes.version import __version__

    makers = (
        assembly, elementary, lowered_values, lowering, machine_code, object_code, transposing, vector_functions, vectors
    )  # fmt: skip
    used = [Path(m.__file__ or "").read_text(encoding="utf-8") for m in makers]
    basis = [source, __version__, machine_code.description(), *used]
    name = "motes_" + hashlib.sha256("\0".join(basis).encode()).hexdigest()[:24]
    log = logging.getLogger(__name__)
    folder, kept = None, ""
    try:
        folder = cache_folder()
        kept = f"kept in {folder}"
        if (found := _read(folder, name)) is not None:
            return SimpleNamespace(**machine_code.loaded(*found))
    except MotesError as error:
        log.info("%s", error)
        folder, kept = None, f"not kept: {error.message}"
    except _Distrusted as reason:  # nothing in it is touched, whosever it is
        log.warning("the cache folder %s is not used, for code is run from it and %s", folder, reason)
        folder, kept = None, f"not kept: {reason}"
    except OSError as error:
        log.info("the cache folder %s cannot be used: %s", folder, error)
        folder, kept = None, f"not kept: {folder} cannot be used"
    sentence = f"compiling {title} once ({kept})"
    log.info(sentence)
    if on_compile is not None:
        on_compile(sentence)
    with compiling.Parts(source) as parts:
        lowered = lowering.lowered(source)
        codes = parts.compiled(lowered.parts)
    if folder is not None:
        try:
            keep(folder, name, codes, lowered.kernels)
        except OSError as error:  # full, say
            log.info("the cache folder %s cannot be used: %s", folder, error)
    return SimpleNamespace(**machine_code.loaded(codes, lowered.kernels))


def _read(folder: Path, name: str) -> tuple[list[bytes], dict[str, tuple[int, bool]]] | None:
    """What was compiled, and its kernels; None where it is not there, or damaged."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    path = folder / name
    there = os.path.lexists(path)
    if reason := distrusted(folder, [path] if there else []):
        raise _Distrusted(reason)
    if not there:
        return None
    head, _, code = path.read_bytes().partition(b"\n")
    try:
        said = json.loads(head)
        if said["sha256"] != hashlib.sha256(code).hexdigest():
            return None
        ends = list(accumulate(map(int, said["bytes"])))
        codes = [code[first:last] for first, last in zip([0, *ends], ends, strict=False)]
        return codes, {str(kernel): (int(count), bool(returns)) for kernel, (count, returns) in said["kernels"].items()}
    except (ValueError, KeyError, TypeError, AttributeError):  # no object of JSON, or one of something else
        return None


def keep(folder: Path, name: str, codes: Sequence[bytes], kernels: dict[str, tuple[int, bool]]) -> None:
    """Keep what was compiled: written beside and renamed, so that it is there whole or not at all."""
    code = b"".join(codes)
    about = {"sha256": hashlib.sha256(code).hexdigest(), "bytes": [len(part) for part in codes], "kernels": kernels}
    head = json.dumps(about)
    handle, temporary = tempfile.mkstemp(prefix=f".{name}.", suffix=".tmp", dir=folder)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(head.encode() + b"\n" + code)
        os.replace(temporary, folder / name)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise
