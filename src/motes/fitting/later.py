"""Sentences that are found when somebody reads them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, final, overload


@final
class Later(Sequence[str]):
    """What a tuple of sentences is, found when it is first read; copies and pickles are the tuple."""

    def __init__(self, find: Callable[[], tuple[str, ...]]) -> None:
        self._find: Callable[[], tuple[str, ...]] | None = find
        self._found: tuple[str, ...] = ()

    def told(self) -> tuple[str, ...]:
        """The sentences."""
        find = self._find
        if find is not None:
            self._found = find()
            self._find = None  # with what it holds
        return self._found

    def __len__(self) -> int:
        return len(self.told())

    @overload
    def __getitem__(self, key: int) -> str: ...

    @overload
    def __getitem__(self, key: slice) -> tuple[str, ...]: ...

    def __getitem__(self, key: int | slice) -> str | tuple[str, ...]:
        return self.told()[key]

    def __add__(self, other: tuple[str, ...]) -> tuple[str, ...]:
        return self.told() + tuple(other)

    def __eq__(self, other: object) -> bool:
        return self.told() == (other.told() if isinstance(other, Later) else other)

    def __hash__(self) -> int:
        return hash(self.told())

    def __repr__(self) -> str:
        return repr(self.told())

    def __reduce__(self) -> tuple[Any, ...]:
        return tuple, (self.told(),)
