"""The command line that is being run, for files that say how they were made."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterator, Sequence
from contextvars import ContextVar

from motes.files.writing import identity

ARGUMENTS: ContextVar[tuple[str, ...]] = ContextVar("arguments", default=())


def command() -> str:
    """As a shell takes it."""
    return shlex.join(["motes", *ARGUMENTS.get()])


#: What a folder of results holds that cannot be made again from the rest of it.
_SOURCES = (".json", ".csv")
_OUTPUT = ("-o", "--output")


def read_by(arguments: Sequence[str]) -> frozenset[tuple[int, int]]:
    """The files that a command line names, and those that folders on it are read for; not those that it asks to write."""
    asked = {arguments[k + 1] for k, word in enumerate(arguments[:-1]) if word in _OUTPUT}
    asked |= {word.partition("=")[2] for word in arguments if word.partition("=")[0] in _OUTPUT and "=" in word}
    written = {identity(word) for word in asked}
    named = {identity(file) for word in arguments if word not in asked for file in _files(word)}
    return frozenset(found for found in named - written if found)


def _files(word: str) -> Iterator[str]:
    for path in (word, word.rpartition("=")[2], word.rpartition(":")[0]):  # file, NAME=file, file:function
        try:
            if os.path.isfile(path):
                yield path
            elif path and os.path.isdir(path):
                yield from (entry.path for entry in os.scandir(path) if entry.name.endswith(_SOURCES))
        except (OSError, ValueError):  # no path at all; the command says so
            continue
