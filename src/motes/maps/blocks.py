"""How the texels of a map are divided into blocks: what is read, fitted and written at a time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import final

# Bytes of a block's values as float32.  Small chunks are put together up to the first, where one block costs a hundredth of
# a second beside its fits; a block is cut to the second where a chunk of the store holds many texels but not all their values.
SMALL, LARGE = 16 * 2**20, 128 * 2**20
ITEM = 4


@final
@dataclass(frozen=True)
class Blocks:
    """A map of `shape` (y, x) in blocks of `block` (y, x); those at the far edges may be smaller."""

    shape: tuple[int, int]
    block: tuple[int, int]

    @property
    def counts(self) -> tuple[int, int]:
        """Rows and columns of blocks."""
        return -(-self.shape[0] // self.block[0]), -(-self.shape[1] // self.block[1])

    def slices(self, block: tuple[int, int]) -> tuple[slice, slice]:
        """The texels of a block."""
        starts = [k * n for k, n in zip(block, self.block, strict=True)]
        stops = [min(s + n, end) for s, n, end in zip(starts, self.block, self.shape, strict=True)]
        return slice(starts[0], stops[0]), slice(starts[1], stops[1])

    def texels(self, block: tuple[int, int]) -> int:
        """The number of texels in a block."""
        y, x = self.slices(block)
        return int((y.stop - y.start) * (x.stop - x.start))

    def __iter__(self) -> Iterator[tuple[int, int]]:
        rows, columns = self.counts
        return ((y, x) for y in range(rows) for x in range(columns))

    def spread(self, most: int) -> list[tuple[int, int]]:
        """Up to so many blocks from all over the map."""
        total = math.prod(self.counts)
        # A golden-section sequence over rows and columns alike: even cover without falling into step with the columns.
        rows, columns = self.counts
        if total <= most:
            return list(self)
        chosen = dict.fromkeys(
            (int((k + 0.5) / most * rows), int((k * 0.6180339887 + 0.5) % 1 * columns)) for k in range(most)
        )
        return list(chosen)


def block_shape(shape: Sequence[int], chunks: Sequence[int]) -> tuple[int, int]:
    """Texels of a block for an array (y, x, time, direction, channel) in chunks: whole chunks, many where they are small."""
    texel = math.prod(shape[2:]) * ITEM
    height, width = min(chunks[0], shape[0]), min(chunks[1], shape[1])
    whole = all(c >= n for c, n in zip(chunks[2:], shape[2:], strict=True))
    while height * width * texel < SMALL and (height < shape[0] or width < shape[1]):
        if (height <= width and height < shape[0]) or width >= shape[1]:
            height = min(2 * height, shape[0])
        else:
            width = min(2 * width, shape[1])
    while not whole and height * width * texel > LARGE and height * width > 1:
        if height >= width:
            height = -(-height // 2)
        else:
            width = -(-width // 2)
    return height, width
