"""What is needed to make a fit again: when, by which Motes, with which options, from which data."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field
from datetime import UTC, datetime
from functools import lru_cache
from pathlib import Path
from typing import Any, final
from weakref import WeakKeyDictionary

import numpy as np

from motes.measurements import Measurement
from motes.models import BRDF, describe
from motes.version import __version__


@final
@dataclass(frozen=True)
class Origin:
    """How a fit was made.

    Attributes
    ----------
    date
        When, in UTC (ISO 8601).
    motes
        The version.
    options
        The arguments of `motes.fit`, as plain values; an array is told by its shape.
    sha256_of_arrays
        Of the measurement as it was given: see `digest`.  Found when it is asked for.
    sha256_of_file
        Of the file that it was read from; None where it is no single file any more.
    command
        The command line; None where Python called.
    """

    date: str
    motes: str
    options: dict[str, Any]
    _given: Measurement | str = field(repr=False)  # or its digest
    sha256_of_file: str | None
    command: str | None = None

    @property
    def sha256_of_arrays(self) -> str:
        if isinstance(self._given, str):
            return self._given
        return _digests.get(self._given) or _digests.setdefault(self._given, digest(self._given))

    def to_dict(self) -> dict[str, Any]:
        """As plain JSON values."""
        names = ("date", "motes", "options", "sha256_of_arrays", "sha256_of_file", "command")
        return deepcopy({name: getattr(self, name) for name in names})

    def __getstate__(self) -> dict[str, Any]:
        """What is written down of it: a digest, and no measurement."""
        return self.__dict__ | {"_given": self.sha256_of_arrays}


# Of measurements, which do not change, and of files as they were last changed: one is fitted by many models.
_digests: WeakKeyDictionary[Measurement, str] = WeakKeyDictionary()


def origin_of(data: Measurement, options: Mapping[str, Any]) -> Origin:
    """The origin of a fit to `data` that begins now."""
    now = datetime.now(UTC).isoformat(timespec="seconds")
    plain = {name: _plain(value) for name, value in options.items()}
    return Origin(now, __version__, plain, data, _file_digest(data.provenance.get("path")))


def digest(data: Measurement) -> str:
    """The SHA-256 of a measurement's numbers: wi, wo, times, values (NaN where masked), weights and uncertainties, as little-endian float64 in C order."""
    total = hashlib.sha256()
    values = data.values if data.mask.all() else np.where(data.mask, data.values, np.nan)
    for array in (data.wi, data.wo, data.times, values, data.weights, data.uncertainties):
        if array is not None:
            total.update(np.ascontiguousarray(array, "<f8").data)
    return total.hexdigest()


def _file_digest(path: Any) -> str | None:
    try:
        if not path:
            return None
        found = os.stat(str(path))
        return _digest_of(str(path), found.st_ino, found.st_size, found.st_mtime_ns)
    except (OSError, ValueError):
        return None


@lru_cache(maxsize=16)
def _digest_of(path: str, *state: int) -> str:
    """Of a file in a state: its number, its size, and when it last changed."""
    with Path(path).open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _plain(value: Any) -> Any:
    if isinstance(value, BRDF):
        return {"model": describe(value), "starts": {slot.name: _plain(slot.value) for slot in value.slots()}}
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, Mapping):
        return {str(k): _plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple, set, frozenset)) and len(value) <= 100:
        return [_plain(v) for v in value]
    array = np.asarray(value)
    return array.tolist() if array.dtype.kind in "bif" and array.size <= 100 else f"an array of shape {array.shape}"
