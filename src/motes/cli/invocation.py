"""The command line that is being run, for files that say how they were made."""

from __future__ import annotations

import shlex
from contextvars import ContextVar

ARGUMENTS: ContextVar[tuple[str, ...]] = ContextVar("arguments", default=())


def command() -> str:
    """As a shell takes it."""
    return shlex.join(["motes", *ARGUMENTS.get()])
