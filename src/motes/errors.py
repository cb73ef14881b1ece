"""The errors a user can cause: one sentence with the value and the range, and a hint with the next step."""

from __future__ import annotations

import shlex
from pathlib import Path


class MotesError(Exception):
    """Something a user can mend.

    Parameters
    ----------
    message
        One sentence: what is wrong, where, the value found and the range or shape expected.
    hint
        The next step, as a sentence.  The command line prints it on a line of its own.
    """

    def __init__(self, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.hint = hint

    def __str__(self) -> str:
        return f"{self.message}. {self.hint}" if self.hint else self.message


class ParameterError(MotesError, ValueError):
    """A model parameter out of its range, or of a shape that does not fit."""


class FormatError(MotesError, ValueError):
    """A file that is not what it claims to be: truncated, of the wrong kind, or with absurd sizes."""


class DataError(MotesError, ValueError):
    """Measurements that cannot be used as they are: nothing left unmasked, directions that are not unit vectors."""


def install_command(extra: str) -> str:
    """The command that installs an extra: of the folder that Motes runs from, or, where it was installed from one, to be run in that folder."""
    root = Path(__file__).resolve().parents[2]
    if (root / "pyproject.toml").is_file() and (root / "src" / "motes").is_dir():
        return f"pip install -e {shlex.quote(f'{root}[{extra}]')}"
    return f"In the folder of Motes' source: pip install '.[{extra}]'"


class MissingExtraError(MotesError, ImportError):
    """An optional dependency that is not installed."""

    def __init__(self, package: str, extra: str, purpose: str) -> None:
        super().__init__(f"{purpose} needs the package {package}, which is not installed", install_command(extra))
