"""XML and JSON that nobody vouches for: no entities, no document types, no deep nesting, nothing that grows in memory."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.files import budget, reading

DEEPEST = 64  # levels of nesting; the formats that are read have ten at most
LONGEST_TOKEN = 64  # characters of a number
CHUNK = 2**20  # characters of numbers that are split at a time
# What Python makes of one element or container in memory [bytes]; a file of nothing but "[]," or "<a/>" is made of them.
ELEMENT, CONTAINER = 600, 160

_ESCAPED = re.compile(rb"\\.", re.DOTALL)
_SPACES = re.compile(r"[\s,]+")


def xml_tree(path: Path) -> Element:
    """The tree of an XML file, names without their namespaces.

    Document types are refused, and with them entities, external ones or such that multiply; so is nesting deeper than
    `DEEPEST`.

    Raises
    ------
    FormatError
        With the line, for what is not well formed or not wanted.
    """
    data = _bytes(path)
    budget.check(path, ELEMENT * data.count(b"<") + 3 * len(data), "its elements", len(data))
    builder, depth = TreeBuilder(), 0
    parser = expat.ParserCreate(namespace_separator="}")
    parser.buffer_text = True

    def start(name: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > DEEPEST:
            raise FormatError(
                f"{path}, line {parser.CurrentLineNumber}: elements are nested more than {DEEPEST} deep",
                "Check the file",
            )
        builder.start(name.rpartition("}")[2], {key.rpartition("}")[2]: value for key, value in attributes.items()})

    def end(name: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(name.rpartition("}")[2])

    def refuse(*_: object) -> None:
        raise FormatError(
            f"{path}, line {parser.CurrentLineNumber}: it declares a document type or entities, which are never read",
            "Remove the line <!DOCTYPE ...>; no measurement needs it",
        )

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.CharacterDataHandler = builder.data
    parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = refuse
    try:
        parser.Parse(data, True)
        return builder.close()
    except expat.ExpatError as error:
        raise FormatError(
            f"{path} is not well-formed XML: {error}", "It is damaged or truncated; fetch it again"
        ) from None
    except (ValueError, AssertionError, LookupError) as error:  # an encoding that Python lacks
        if isinstance(error, FormatError):
            raise
        raise FormatError(f"{path} cannot be read as XML: {error}", "Save it as UTF-8") from None


def json_object(path: Path) -> dict[str, Any]:
    """The object that a JSON file holds.

    Raises
    ------
    FormatError
        Where it is no JSON, no object, or nested more than `DEEPEST` deep.
    """
    data = _bytes(path)
    containers = data.count(b"[") + data.count(b"{")
    budget.check(path, CONTAINER * containers + 12 * len(data), f"its {containers:,} lists and objects", len(data))
    depth = _depth(data)
    if depth > DEEPEST:
        raise FormatError(f"{path} is nested {depth} deep, more than {DEEPEST}", "Check the file")
    try:
        found = json.loads(data)
    except json.JSONDecodeError as error:
        raise FormatError(f"{path} is not JSON: {error}", "It is damaged or truncated; fetch it again") from None
    except (UnicodeDecodeError, ValueError, RecursionError) as error:  # an integer of ten thousand digits
        raise FormatError(f"{path} cannot be read as JSON: {str(error)[:200]}", "Save it as UTF-8") from None
    if not isinstance(found, dict):
        raise FormatError(f"{path} holds a {type(found).__name__} instead of an object", "It starts with {")
    return found


def number_list(text: str, where: str) -> NDArray[np.float64]:
    """Numbers separated by blanks or commas, in little more memory than they take as float64.

    Raises
    ------
    FormatError
        Naming the first that is none.
    """
    parts = [reading.numbers(tokens, where) for tokens in _tokens(text, where)]
    return np.concatenate(parts) if parts else np.empty(0)


def _tokens(text: str, where: str) -> Iterator[list[str]]:
    at = 0
    while at < len(text):
        end = min(at + CHUNK, len(text))
        if end < len(text):  # up to the next blank
            gap = _SPACES.search(text, end, end + LONGEST_TOKEN)
            if gap is None:
                raise FormatError(
                    f"{where}: {text[end : end + 40]!r} goes on for more than {LONGEST_TOKEN} characters",
                    "Separate the numbers by blanks",
                )
            end = gap.end()
        tokens = _SPACES.split(text[at:end].strip(" \t\r\n,"))
        if tokens != [""]:
            yield tokens
        at = end


def _bytes(path: Path) -> bytes:
    size = path.stat().st_size
    if size > reading.LARGEST_TEXT:
        raise FormatError(
            f"{path} is {size:,} bytes of text, more than the {reading.LARGEST_TEXT:,} that are read", "Split it"
        )
    return path.read_bytes()


def _depth(data: bytes) -> int:
    """How deep lists and objects are nested, brackets in strings aside."""
    plain = np.frombuffer(_ESCAPED.sub(b"", data), np.uint8)
    inside = (np.cumsum(plain == ord('"'), dtype=np.int64) % 2).astype(bool)
    step = np.zeros(plain.size, np.int8)
    for bracket, change in (("[", 1), ("{", 1), ("]", -1), ("}", -1)):
        step[(plain == ord(bracket)) & ~inside] = change
    return int(np.cumsum(step, dtype=np.int64).max(initial=0))
