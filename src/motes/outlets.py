"""What results can be handed to: pages that are written by rooms above the one the result comes from.

A fit knows that a page can be made of it, and not by whom: ``fit.report(path)`` calls `report` here with a name.  Which function writes
the page that goes by that name is said once, where the whole package is known: in ``motes/__init__.py``.  So no room imports one above
it, and the room of the pages is imported only when a page is wanted.
"""

from __future__ import annotations

import os
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Protocol, cast


class Writer(Protocol):
    """A function that writes a result as a page, and returns the path."""

    def __call__(self, result: object, path: str | os.PathLike[str], /) -> Path: ...


_WRITERS: dict[str, tuple[str, str]] = {}
_PRINTER: list[str] = []


def offer(name: str, module: str, function: str) -> None:
    """Say that ``function`` of ``module``, which is imported when first asked for, writes the page called `name`."""
    _WRITERS[name] = (module, function)


def offer_paper(module: str, function: str) -> None:
    """Say that ``function`` of ``module`` prints such a page: it takes the page's path and the PDF's."""
    _PRINTER[:] = module, function


def offered() -> tuple[str, ...]:
    """The names of the pages that can be written."""
    return tuple(_WRITERS)


def writer(name: str) -> Writer:
    """The function that writes the page called `name`."""
    module, function = _WRITERS[name]
    return cast(Writer, getattr(import_module(module), function))


def report(name: str, result: object, path: str | os.PathLike[str]) -> Path:
    """Write a result as the page called `name`; returns its path.  A path that ends in ``.pdf`` gets it on paper (see `motes.report.paper`)."""
    if os.path.splitext(path)[1].lower() != ".pdf":
        return writer(name)(result, path)
    with TemporaryDirectory(prefix="motes-") as folder:
        printer = getattr(import_module(_PRINTER[0]), _PRINTER[1])
        return cast(Path, printer(writer(name)(result, Path(folder, "report.html")), path))
