"""What a page holds as base64: little-endian numbers, and what is seldom asked for, deflated."""

from __future__ import annotations

import base64
import json
import zlib
from typing import Any

import numpy as np


def packed(values: Any, dtype: str) -> str:
    """An array as base64 of little-endian numbers."""
    return base64.b64encode(np.ascontiguousarray(values).astype(dtype).tobytes()).decode("ascii")


def deflated(value: Any) -> str:
    """A JSON value as base64 of its UTF-8 text, deflated as zlib does."""
    text = json.dumps(value, allow_nan=False, separators=(",", ":"), ensure_ascii=False)
    return base64.b64encode(zlib.compress(text.encode("utf-8"), 9)).decode("ascii")
