"""A text that looks like a table, and whose header names no directions: what its columns are called."""

from __future__ import annotations

import re

from motes.measurements._cells import NUMBER

SEPARATORS = (r"\t", r";", r",", r"\|", r"\s{2,}", r"\s+")
LINES = 50  # that are looked at


def strange_header(text: str) -> list[str]:
    """The names above the first rows of numbers in the beginning of a text; empty where it is no table.

    A header is a line of as many cells as each of the rows after it, three or more, none of them a number.
    """
    lines = [line.strip() for line in re.split(r"\r\n|\r|\n", text)[:-1] if line.strip()][:LINES]
    for separator in SEPARATORS:
        rows = [[cell.strip(' "') for cell in re.split(separator, line.lstrip("#%!/").strip())] for line in lines]
        for at, names in enumerate(rows[:-1]):
            below = rows[at + 1 : at + 6]
            if (
                len(names) >= 3
                and not any(NUMBER.fullmatch(name) for name in names)
                and all(len(row) == len(names) and any(NUMBER.fullmatch(cell) for cell in row) for row in below)
                and any(all(NUMBER.fullmatch(cell) for cell in row) for row in below)
            ):
                return names
    return []
