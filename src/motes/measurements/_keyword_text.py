"""The text that Zemax's and LightTools' BSDF files share: keywords with numbers after them, one table a geometry."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import reading
from motes.files.structured import number_list

MOST_ANGLES = 100_000


class Keywords:
    """The lines of a file, without comments, read from the first to the last.

    Parameters
    ----------
    path
        The file; lines that start with ``#`` are comments.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        lines = reading.text(path).splitlines()
        self.comments = [line.lstrip("# \t").strip()[:200] for line in lines if line.lstrip().startswith("#")][:100]
        kept = ((number, line.strip()) for number, line in enumerate(lines, 1))
        self.lines = [(number, line) for number, line in kept if line and not line.startswith("#")]
        self.at = 0

    def more(self) -> bool:
        return self.at < len(self.lines)

    def where(self) -> str:
        number = self.lines[min(self.at, len(self.lines) - 1)][0] if self.lines else 1
        return f"{self.path}, line {number}"

    def word(self) -> str:
        """The keyword of this line, lower-case."""
        return re.split(r"[\s:=]", self.lines[self.at][1], maxsplit=1)[0].lower()

    def value(self) -> str:
        """What follows the keyword on this line, which is then done."""
        parts = re.split(r"[\s:=]+", self.lines[self.at][1], maxsplit=1)
        self.at += 1
        return parts[1].strip() if len(parts) > 1 else ""

    def numbers(self, count: int, what: str) -> NDArray[np.float64]:
        """The next `count` numbers, on as many lines as they take."""
        where, parts, found = self.where(), [], 0
        while found < count and self.more():
            row = number_list(self.lines[self.at][1], self.where())
            parts.append(row)
            found += len(row)
            self.at += 1
        if found != count:
            raise FormatError(
                f"{where}: {what} needs {count} numbers, and {found} stand there", "The file is truncated or damaged"
            )
        return np.concatenate(parts) if parts else np.empty(0)

    def angles(self) -> NDArray[np.float64]:
        """A keyword with a count, and on the following lines that many angles [deg], increasing."""
        where, name = self.where(), self.word()
        count = reading.integer(self.value())
        if count is None or not 1 <= count <= MOST_ANGLES:
            raise FormatError(f"{where}: {name} has no count from 1 to {MOST_ANGLES}", "It stands after the keyword")
        angles = self.numbers(count, name)
        if not np.all(np.isfinite(angles) & (np.abs(angles) <= 360)) or np.any(np.diff(angles) <= 0):
            raise FormatError(
                f"{where}: the angles of {name} do not increase within 360 degrees: {angles[:5].tolist()}, ...",
                "The file is damaged",
            )
        return angles


def told_apart(values: NDArray[np.float64], azimuths: int, radials: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Which of the samples (N, C), radial angles fastest, azimuths next, are not the pole again: at the radial angle 0 all azimuths
    are one direction, and tables repeat its value there."""
    table = values.reshape(-1, azimuths, len(radials), values.shape[-1])
    again = np.zeros(table.shape[:3], bool)
    again[:, 1:, radials == 0] = np.all(table[:, 1:, radials == 0] == table[:, :1, radials == 0], axis=-1)
    return ~again.reshape(-1)


def choice(text: str, known: dict[str, str], where: str, what: str) -> str:
    """One of some words, whatever their case."""
    if text.lower() not in known:
        raise FormatError(f"{where}: {what} is {text[:40]!r}", f"{', '.join(known.values())} are read")
    return text.lower()
