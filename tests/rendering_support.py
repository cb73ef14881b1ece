"""What the tests of pictures share: the command line's errors."""

from __future__ import annotations

from collections.abc import Callable

Run = Callable[..., tuple[int, str, str]]


def message(err: str) -> tuple[str, str]:
    """The sentence and the hint of an error, which must be all there is."""
    lines = err.splitlines()
    assert len(lines) == 2, err
    assert lines[0].startswith("error: ")
    assert lines[1].startswith("hint: ")
    return lines[0], lines[1]
