"""Ways to damage a file: its bytes, and what its format makes of them."""

from __future__ import annotations

import base64
import io
import json
import re
import struct
import zipfile
import zlib
from copy import deepcopy
from typing import Any

import numpy as np

NASTY = [b"\xff" * 8, b"\0" * 8, b"nan ", b"inf", b"1e308 ", b"-1", b"-", b"\n", b"9" * 12, b"{" * 40, b"[" * 80]
NASTY += [b"<a>" * 70, b"<!DOCTYPE x [<!ENTITY a 'b'>]>", b"&a;", b"null", b'"', b"\xef\xbb\xbf", b"\xfe\xff", b"#"]
NASTY += [b",,", b"2147483647 ", b"\x7f" * 4]
WORDS = b"nan inf -inf 1e400 1e308 -1e308 1e-320 -1 0 -0.0 1,5 x 2147483648 18446744073709551616 0x10 1_0 =1+1 true %s".split()
WORDS += [b"", b"9" * 400, b"a" * 5000, b"\xd9\xa1", b"\xff"]
VALUES: list[Any] = [None, True, -1, 0, 1e308, 10**400, 2**63, 1.5, -0.0, float("nan"), float("inf")]
VALUES += ["", "nan", "x" * 3000, "\x1b[31m", "\ud800", "=1+1", "__proto__", "constructor"]
VALUES += [[], {}, [[[[]]]], [1, [2]], ["a"], {"value": None}]
NUMBERS = [struct.pack("<I", n) for n in (0, 1, 255, 65535, 2**31 - 1, 2**31, 2**32 - 1)]
NUMBERS += [struct.pack("<f", x) for x in (np.nan, np.inf, 3e38, -1)]
NUMBERS += [struct.pack("<d", x) for x in (np.nan, 1e308, -1)]
WORD = re.compile(rb"[^\s,;:=<>\"\[\](){}]+")
LINK = b"#motes="
END_OF_PLY = b"end_header\n"


def damaged(data: bytes, rng: np.random.Generator) -> bytes:
    """The bytes of a file with one change or a few; by structure, where it has one, half of the times."""
    if rng.random() < 0.5:
        return _bytes(data, rng)
    if data[:1] in (b"{", b"["):
        return _json(data, rng)
    if data.startswith(b"\x89PNG"):
        return _png(_bytes(data, rng))
    if data.startswith(b"PK"):
        return _archive(data, rng)
    if data.startswith(b"glTF"):
        return _glb(data, rng)
    if data.startswith(b"ply") and END_OF_PLY in data:
        head, end, body = data.partition(END_OF_PLY)
        return _words(head, rng) + end + body if rng.random() < 0.5 else head + end + _fields(body, rng)
    if data.startswith(LINK):
        state = base64.urlsafe_b64decode(data[len(LINK) :] + b"==")
        return LINK + base64.urlsafe_b64encode(_json(state, rng)).rstrip(b"=")
    return _words(data, rng) if b"\0" not in data else _fields(data, rng)


def _bytes(data: bytes, rng: np.random.Generator) -> bytes:
    for _ in range(int(rng.geometric(0.6))):
        at = int(rng.integers(0, len(data) + 1))
        kind = int(rng.integers(0, 8))
        piece = NASTY[int(rng.integers(len(NASTY)))] if rng.random() < 0.5 else rng.bytes(int(rng.integers(1, 17)))
        if kind == 0:
            data = data[:at]
        elif kind == 1:
            data = data[:at] + piece + data[at:]
        elif kind == 2:
            data = data[:at] + data[at + int(rng.integers(1, 200)) :]
        elif kind == 3:
            end = at + int(rng.integers(1, 400))
            data = data[:end] + data[at:end] + data[end:]
        elif kind == 4 and data[at : at + 1].isdigit():
            data = data[:at] + b"%d" % rng.integers(0, 10**9) + data[at + 1 :]
        elif kind == 5 and at < len(data):
            data = data[:at] + bytes([data[at] ^ (1 << int(rng.integers(8)))]) + data[at + 1 :]
        else:
            data = data[:at] + piece + data[at + len(piece) :]
    return data


def _words(data: bytes, rng: np.random.Generator) -> bytes:
    """A word or two replaced by others."""
    for _ in range(int(rng.geometric(0.6))):
        at = int(rng.integers(0, len(data) + 1))
        found = WORD.search(data, at)
        if found:
            data = data[: found.start()] + WORDS[int(rng.integers(len(WORDS)))] + data[found.end() :]
    return data


def _fields(data: bytes, rng: np.random.Generator) -> bytes:
    """Numbers at multiples of four bytes, more often near the beginning, where counts stand."""
    for _ in range(int(rng.geometric(0.6))):
        reach = len(data) if rng.random() < 0.5 else min(len(data), 400)
        at = 4 * int(rng.integers(0, reach // 4 + 1))
        number = NUMBERS[int(rng.integers(len(NUMBERS)))]
        data = data[:at] + number + data[at + len(number) :]
    return data


def _json(data: bytes, rng: np.random.Generator) -> bytes:
    """Members replaced, removed, added, or nested."""
    try:
        root: Any = [json.loads(data)]
    except ValueError:
        return _bytes(data, rng)
    for _ in range(int(rng.geometric(0.6))):
        parent, key = root, 0
        while rng.random() < 0.85:  # a walk downwards
            value = parent[key]
            if not isinstance(value, dict | list) or not value:
                break
            parent = value
            keys = list(parent) if isinstance(parent, dict) else list(range(len(parent)))
            key = keys[int(rng.integers(len(keys)))]
        kind = int(rng.integers(5))
        if kind == 0 and parent is not root:
            del parent[key]
        elif kind == 1 and isinstance(parent, list):
            parent.insert(int(rng.integers(len(parent) + 1)), deepcopy(parent[key]))
        elif kind == 2:
            parent[key] = [parent[key]]
        else:
            parent[key] = deepcopy(VALUES[int(rng.integers(len(VALUES)))])
        if not root:
            break
    return json.dumps(root[0] if root else None).encode()


def _png(data: bytes) -> bytes:
    """With the checksums that its chunks should have."""
    at, made = 8, data[:8]
    while at + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, at)
        body = data[at + 4 : at + 8 + length]
        made += data[at : at + 4] + body + struct.pack(">I", zlib.crc32(body))
        at += 12 + length
    return made + data[at:]


def _glb(data: bytes, rng: np.random.Generator) -> bytes:
    """A glTF whose JSON, or whose numbers, are damaged, its lengths set right."""
    made, at = b"", 12
    victim = int(rng.integers(2))
    while at + 8 <= len(data):
        length, kind = struct.unpack_from("<I4s", data, at)
        body = data[at + 8 : at + 8 + length]
        if (kind == b"JSON") == (victim == 0):
            body = _json(body, rng) if kind == b"JSON" else _fields(body, rng)
        body += (b" " if kind == b"JSON" else b"\0") * (-len(body) % 4)
        made += struct.pack("<I4s", len(body), kind) + body
        at += 8 + length
    return data[:8] + struct.pack("<I", 12 + len(made)) + made


def _archive(data: bytes, rng: np.random.Generator) -> bytes:
    """A member of a ZIP damaged, packed again as is due."""
    made = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as new:
        names = old.namelist()
        victim = names[int(rng.integers(len(names)))]
        for name in names:
            content = old.read(name)
            if name == victim:
                content = _words(content, rng) if rng.random() < 0.5 else _bytes(content, rng)
            new.writestr(name, content)
    return made.getvalue()
