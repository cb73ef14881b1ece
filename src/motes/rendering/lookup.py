"""How a map is looked up: the words for it, which the look of a picture and the plugin share."""

from __future__ import annotations

from motes.errors import ParameterError

#: What a point of a map shows: its own texel, or the light of the four around it.
FILTERS = ("nearest", "bilinear")
#: What stands where nothing was fitted.
GAPS = ("fill", "mark")
MOST_REPEATS = 1000


def one_of(owner: str, name: str, word: object, options: tuple[str, ...]) -> str:
    """`word` where it is one of the options; raises `ParameterError` where not."""
    if word not in options:
        raise ParameterError(f"{owner}: {name} = {str(word)[:80]!r} is not one of {', '.join(options)}", "Name one")
    return str(word)
