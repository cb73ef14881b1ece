"""Mitsuba, with an LLVM that works and the plugins of Motes: the one place where it is loaded."""

from __future__ import annotations

import importlib
import logging
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from motes.errors import MissingExtraError, MotesError, ParameterError
from motes.rendering import llvm

logger = logging.getLogger("motes.rendering")

FAST, SLOW = "llvm_ad_rgb", "scalar_rgb"
_said: set[str] = set()
_raised: list[MotesError] = []  # by a plugin's constructor; Mitsuba turns exceptions into text
_listening = False


def load_mitsuba(variant: str | None = None) -> Any:
    """The module ``mitsuba`` with a variant set and the plugins of Motes registered.

    ``motes.rendering.load_mitsuba(variant: str | None = None) -> module``

    Everything in Motes that renders starts here.  LLVM is chosen before Mitsuba loads: the environment variable
    ``DRJIT_LIBLLVM_PATH`` if what it names is usable, the wheel karellen-llvm-core, a system LLVM of version 17 or later.

    Parameters
    ----------
    variant
        A name such as ``llvm_ad_spectral``.  None keeps the variant that is set already; where none is, it takes
        ``llvm_ad_rgb``, or ``scalar_rgb`` without a usable LLVM: a thousand times slower with these plugins, for small
        previews only.  The logger ``motes.rendering`` then says so, once, with the command that mends it.

    Raises
    ------
    MissingExtraError
        When Mitsuba is not installed.
    ParameterError
        When it has no such variant.
    MotesError
        When the variant that was asked for cannot run here.
    """
    choice = llvm.prepared()
    mi = _imported()
    if variant is None:
        variant = mi.variant() or (FAST if choice.path else SLOW)
        if variant == SLOW and mi.variant() is None:
            _say(slow_note())
    if variant not in mi.variants():
        raise ParameterError(f"Mitsuba has no variant {variant!r}", f"It has {', '.join(mi.variants())}")
    if variant.startswith("llvm") and choice.path is None:  # also one that was set before: it would abort
        message, hint = llvm.missing(choice)
        raise MotesError(f"the variant {variant} cannot run: {message}", f"{hint}; or use {SLOW}")
    if variant != mi.variant():
        try:
            mi.set_variant(variant)
        except ImportError as error:
            raise MotesError(f"the variant {variant} cannot run here: {error}", f"Use {FAST} or {SLOW}") from error
    register()
    return mi


def register() -> None:
    """Make the plugins known to Mitsuba: ``motes_NAME`` for each model (``motes_oren_nayar``), ``motes_dusty`` and ``motes_material``.

    ``motes.rendering.register() -> None``

    They are there for the variant that is set now and for each that is set later; calling it again adds those of models that were
    registered in between (`motes.models.register`).  Called
    before the first ``mitsuba.set_variant("llvm_...")`` it sees to it that a usable LLVM is found; if there is none, that
    call raises ImportError.

    Raises
    ------
    MissingExtraError
        When Mitsuba is not installed.

    Examples
    --------
    ::

        import mitsuba as mi
        from motes.rendering import register

        register()
        mi.set_variant("llvm_ad_spectral")
        bsdf = mi.load_dict({"type": "motes_dusty", "tau": 0.3, "base": {"type": "conductor"}})
    """
    global _listening
    choice = llvm.prepared()
    for why in choice.refused if choice.path else ():  # without any, `slow_note` or an error says it
        _say(f"LLVM not used: {why}")
    mi = _imported()
    if not _listening:
        mi.detail.add_variant_callback(lambda old, new: _register_plugins(mi))
        _listening = True
    if mi.variant() is not None:
        _register_plugins(mi)


def load_scene(description: Mapping[str, Any] | str | os.PathLike[str]) -> Any:
    """What Mitsuba makes of a description: a scene, or a single shape, BSDF or texture.

    Parameters
    ----------
    description
        A dictionary as for ``mitsuba.load_dict``, the path of an XML file, or XML text.

    Raises
    ------
    MotesError
        Instead of Mitsuba's RuntimeError: the error that a plugin of Motes raised as it is, others with their message.
    """
    mi = load_mitsuba()
    _raised.clear()
    try:
        if isinstance(description, Mapping):
            return mi.load_dict(dict(description))
        text = os.fspath(description)
        return mi.load_string(text) if text.lstrip().startswith("<") else mi.load_file(native(Path(text)))
    except (RuntimeError, TypeError, ValueError, OSError) as error:
        if _raised:
            raise _raised.pop() from error
        raise MotesError(f"Mitsuba cannot load this: {_last_sentence(str(error))}", "Correct the scene") from error


def native(path: str | os.PathLike[str]) -> str:
    """A path as Mitsuba takes it.

    Raises
    ------
    MotesError
        When it is not UTF-8, as names of other times may be.
    """
    text = os.fspath(path)
    try:
        text.encode()
    except UnicodeEncodeError:
        shown = os.fsencode(text).decode(errors="backslashreplace")
        raise MotesError(f"the path {shown} is not UTF-8, and Mitsuba takes no other", "Rename it") from None
    return text


def slow_note() -> str | None:
    """What to tell somebody whose pictures are made by the scalar variant for want of LLVM, or None."""
    choice = llvm.prepared()
    if choice.path is not None:
        return None
    message, hint = llvm.missing(choice)
    return (
        f"rendering in {SLOW}, a thousand times slower with Motes' plugins, so small previews only: {message}. {hint}"
    )


def _imported() -> Any:
    try:
        return importlib.import_module("mitsuba")
    except ModuleNotFoundError as error:
        if (error.name or "").split(".")[0] not in ("mitsuba", "drjit"):
            raise
        raise MissingExtraError("mitsuba", "render", "rendering") from None
    except ImportError as error:  # a shared library that it needs is not there
        raise MotesError(
            f"Mitsuba is installed but does not load: {error}",
            "On a bare Debian apt-get install libatomic1 may help",
        ) from error


def _register_plugins(mi: Any) -> None:
    from motes.rendering import plugins

    known = _registered.setdefault(mi.variant(), set())
    if known.issuperset(plugins.names()):
        return
    for name, constructor in plugins.constructors(mi).items():
        if name not in known:
            mi.register_bsdf(name, _recording(constructor))
            known.add(name)


_registered: dict[str, set[str]] = {}  # names of plugins by variant


def _recording(constructor: Any) -> Any:
    """The constructor, which leaves its `MotesError` for `load_scene`."""

    def construct(properties: Any) -> Any:
        try:
            return constructor(properties)
        except MotesError as error:
            _raised[:] = [_without_frames(error)]
            raise

    return construct


def _without_frames(error: MotesError) -> MotesError:
    """The same error without its traceback, whose frames would keep what is half made alive."""
    kept = type(error).__new__(type(error), *error.args)
    kept.__dict__.update(error.__dict__)
    return kept


def _last_sentence(text: str) -> str:
    """The end of Mitsuba's chain of messages, which is what happened, and where."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return " ".join(lines[-4:]) if lines else "it gave no reason"


def _say(note: str | None) -> None:
    if note and note not in _said:
        _said.add(note)
        logger.warning(note)
