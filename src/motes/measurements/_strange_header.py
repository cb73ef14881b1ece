"""A text that looks like a table, and whose header names no directions: what its columns are called."""

from __future__ import annotations

import re

SEPARATORS = (r"\t", r";", r",", r"\|", r"\s{2,}", r"\s+")
LINES = 50  # that are looked at
COMMENTS = re.compile(r"\s*(?:#|%|//|!)+")
_NUMBER = re.compile(r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][-+]?\d+)?")


def strange_header(text: str) -> list[str]:
    """The names above the first rows of numbers in the beginning of a text; empty where it is no table.

    A header is a line of as many cells as each of the rows after it, three or more, none of them a number.
    """
    lines = [line.strip() for line in re.split(r"\r\n|\r|\n", text)[:-1] if line.strip()][:LINES]
    for separator in SEPARATORS:
        rows = [[cell.strip(' "') for cell in re.split(separator, COMMENTS.sub("", line))] for line in lines]
        for at, names in enumerate(rows[:-1]):
            below = rows[at + 1 : at + 6]
            if (
                len(names) >= 3
                and not any(_NUMBER.fullmatch(name) for name in names)
                and all(len(row) == len(names) and any(_NUMBER.fullmatch(cell) for cell in row) for row in below)
                and any(all(_NUMBER.fullmatch(cell) for cell in row) for row in below)
            ):
                return names
    return []
