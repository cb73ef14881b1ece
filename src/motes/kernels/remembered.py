"""What is found once about a model, which is immutable, and goes with it.

By identity: models are equal by value, which takes long to find out.
"""

from __future__ import annotations

import weakref
from collections.abc import Callable
from functools import partial
from typing import Generic, TypeVar

from motes.parameters import Parametrised

T = TypeVar("T")


class Remembered(Generic[T]):
    """Something of each model, which `make` finds."""

    def __init__(self, make: Callable[[Parametrised], T]) -> None:
        self._make = make
        self._found: dict[int, tuple[weakref.ref[Parametrised], T]] = {}

    def __len__(self) -> int:
        return len(self._found)

    def of(self, model: Parametrised) -> T:
        """What was found of a model, or is found now."""
        number = id(model)
        known = self._found.get(number)
        if known is None or known[0]() is not model:
            known = self._found[number] = (weakref.ref(model, partial(self._forget, number)), self._make(model))
        return known[1]

    def _forget(self, number: int, _: object) -> None:
        self._found.pop(number, None)
