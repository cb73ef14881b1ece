"""Reading files that nobody vouches for: sizes before allocation, text that is text, numbers that are numbers."""

from __future__ import annotations

import csv
import math
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError

LARGEST_TEXT = 2**30  # bytes; the largest text measurement known is far below


def head(path: Path, n: int = 4096) -> bytes:
    """The first bytes of a file."""
    with path.open("rb") as file:
        return file.read(n)


def text(path: Path) -> str:
    """A whole text file; refuses binary and absurdly large ones."""
    size = path.stat().st_size
    if size > LARGEST_TEXT:
        raise FormatError(f"{path} is {size:,} bytes of text, more than the {LARGEST_TEXT:,} that are read", "Split it")
    data = path.read_bytes()
    if b"\0" in data:
        raise FormatError(
            f"{path} is a binary file (byte {data.index(0)} is 0), not the text expected", "Check the file"
        )
    return data.decode("utf-8", errors="replace").removeprefix("\ufeff")


def numbers(tokens: Sequence[str], where: str) -> NDArray[np.float64]:
    """Tokens as float64; the error names the first that is not a number."""
    try:
        return np.array(tokens, dtype=np.float64) if len(tokens) else np.empty(0)
    except ValueError:
        pass
    for position, token in enumerate(tokens):
        try:
            float(token)
        except ValueError:
            raise FormatError(
                f"{where}: entry {position + 1} is {token[:40]!r}, not a number", "Check the file near there"
            ) from None
    raise FormatError(f"{where}: not numbers", "Check the file")


def delimited(lines: Iterable[str], separator: str, where: str, blanks: bool = False) -> Iterator[list[str]]:
    """The cells of lines of a table, without blanks around them; quotes may hold separators, and where `blanks`, stand behind some."""
    try:
        for row in csv.reader(lines, delimiter=separator, skipinitialspace=blanks):
            yield [cell.strip() for cell in row]
    except csv.Error as error:  # a cell of more than 131,072 characters
        raise FormatError(
            f"{where}: {error}", "A quote that is never closed makes such cells; check the file"
        ) from None


def integer(token: str) -> int | None:
    """A token as a non-negative integer of sane length, or None."""
    return int(token) if token.isascii() and token.isdigit() and len(token) < 10 else None


def binary(path: Path, dtype: str, count: int, offset: int, what: str) -> NDArray[Any]:
    """`count` numbers at a byte offset, once the file is known to hold them."""
    needed, size = offset + count * np.dtype(dtype).itemsize, path.stat().st_size
    if size < needed:
        raise FormatError(
            f"{path} is truncated: {what} ends at byte {needed:,} and the file at {size:,}",
            "Fetch or copy the file again",
        )
    found = np.fromfile(path, dtype, count, offset=offset)
    if found.size < count:
        raise FormatError(f"{path} became shorter while it was read", "Wait until it is written, then read it again")
    return found


def doubles(array: NDArray[Any]) -> NDArray[np.float64]:
    """As float64; a signalling NaN in a damaged file is a NaN, not a warning."""
    with np.errstate(invalid="ignore"):
        return array.astype(np.float64)


def product(shape: Sequence[int]) -> int:
    """The number of elements, in Python's integers: absurd shapes do not wrap around."""
    return math.prod(int(n) for n in shape)


def require(condition: bool, message: str, hint: str) -> None:
    if not condition:
        raise FormatError(message, hint)
