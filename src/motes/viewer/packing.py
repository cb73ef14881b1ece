"""Numbers in a page: base64 of little-endian ones."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np


def packed(values: Any, dtype: str) -> str:
    """An array as base64 of little-endian numbers."""
    return base64.b64encode(np.ascontiguousarray(values).astype(dtype).tobytes()).decode("ascii")
