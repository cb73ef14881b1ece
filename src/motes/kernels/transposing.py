"""Numbers that lie together for an item, and in rows over items: from one to the other in shuffles of vectors, as LLVM's instructions."""

from __future__ import annotations

from collections.abc import Sequence

from motes.kernels.assembly import FLOAT, INT, WORD, Builder, Value, number, vector

PIECE = 8  # numbers of an item that are read or written at once


def transposed(
    builder: Builder, lanes: int, address: Value, stride: Value, last: Value, start: Value, room: Value
) -> None:
    """Write what brings `PIECE` numbers of each of 16 lanes into rows of lanes.

    Arguments: the address of the first lane's numbers (float32), the bytes from a lane's to the next lane's, the last lane that there is (those beyond
    repeat it), the position of the first number, and the address of the rows, of which those at `start` and beyond are written.
    """
    begin = builder.binary("add", address, builder.binary("mul", start, number(WORD, 4)))
    vectors = []
    for k in range(lanes):
        lane = number(WORD, k)
        lane = builder.select(builder.compared("slt", lane, last), lane, last)
        place = builder.pointer(builder.binary("add", begin, builder.binary("mul", lane, stride)))
        vectors.append(builder.load(vector(PIECE, FLOAT), place, 4))
    for k, value in enumerate(_columns(builder, vectors)):
        row = builder.binary("mul", builder.binary("add", start, number(WORD, k)), number(WORD, 4 * lanes))
        builder.store(value, builder.pointer(builder.binary("add", room, row)), 4)


def boxed(builder: Builder, pieces: int, *arguments: Value) -> None:
    """Write what brings numbers (float32) from rows into the places of items, `pieces` times `PIECE` of them together: the reverse of `turned`.

    Arguments: `count`, of whole 16, `at`, the address of the places (int32), that of the items, and for each row that there is its address.
    """
    lanes, whole = 2 * PIECE, pieces * PIECE
    count, at, items, *rows = arguments
    kind = vector(lanes, FLOAT)
    with builder.loop(number(WORD, 0), count, lanes) as n:
        here = builder.binary("mul", n, number(WORD, 4))
        found = [builder.load(kind, builder.pointer(builder.binary("add", row, here)), 4) for row in rows]
        found += [number(kind, 0.0)] * (whole - len(found))
        parts = [_items(builder, found[PIECE * piece : PIECE * (piece + 1)]) for piece in range(pieces)]
        places = builder.binary("add", at, here)
        for k in range(lanes):
            place = builder.load(INT, builder.pointer(builder.binary("add", places, number(WORD, 4 * k))))
            first = builder.binary("mul", builder.turned("zext", place, WORD), number(WORD, 4 * whole))
            item = builder.binary("add", items, first)
            for piece, part in enumerate(parts):
                target = builder.pointer(builder.binary("add", item, number(WORD, 4 * PIECE * piece)))
                builder.store(part[k], target, 4)


def turned(builder: Builder, pieces: int, *arguments: Value) -> None:
    """Write what brings `pieces` times `PIECE` numbers (float32) of each of some items, one after the other in memory, into rows.

    Arguments: the address of the items, their number, the address of the rows, and how many numbers they are apart.  What lies behind the last
    item in a row, up to a multiple of 16, repeats it.
    """
    lanes = 2 * PIECE
    address, count, room, pitch = arguments
    last = builder.binary("sub", count, number(WORD, 1))
    whole = builder.binary("and", count, number(WORD, -lanes))
    for start, stop in ((number(WORD, 0), whole), (whole, count)):
        with builder.loop(start, stop, lanes) as n:
            items = [builder.binary("add", n, number(WORD, k)) for k in range(lanes)]
            if stop is count:
                items = [builder.select(builder.compared("slt", item, last), item, last) for item in items]
            _into_rows(
                builder,
                pieces,
                [builder.binary("mul", item, number(WORD, 4 * PIECE * pieces)) for item in items],
                address,
                n,
                room,
                pitch,
            )


def _into_rows(
    builder: Builder, pieces: int, items: Sequence[Value], address: Value, n: Value, room: Value, pitch: Value
) -> None:
    for piece in range(pieces):
        begin = builder.binary("add", address, number(WORD, 4 * PIECE * piece))
        places = [builder.pointer(builder.binary("add", begin, item)) for item in items]
        for k, value in enumerate(
            _columns(builder, [builder.load(vector(PIECE, FLOAT), place, 4) for place in places])
        ):
            row = builder.binary("mul", pitch, number(WORD, PIECE * piece + k))
            at = builder.binary("mul", builder.binary("add", row, n), number(WORD, 4))
            builder.store(value, builder.pointer(builder.binary("add", room, at)), 4)


def _items(builder: Builder, rows: Sequence[Value]) -> list[Value]:
    """The 16 columns of `PIECE` rows: first within quarters of four numbers, then of these."""
    lanes = 2 * PIECE
    quarters = [4 * q for q in range(lanes // 4)]

    def within(a: Value, b: Value, *places: int) -> Value:
        return builder.shuffled(a, b, [q + (n if n < 4 else n - 4 + lanes) for q in quarters for n in places])

    fours = []  # of rows 0-3 and 4-7: in each quarter the four numbers of one column
    for k in (0, 4):
        pairs = [
            (within(a, b, 0, 4, 1, 5), within(a, b, 2, 6, 3, 7)) for a, b in (rows[k : k + 2], rows[k + 2 : k + 4])
        ]
        fours.append(
            [within(pairs[0][j], pairs[1][j], *places) for j in (0, 1) for places in ((0, 1, 4, 5), (2, 3, 6, 7))]
        )
    return [
        builder.shuffled(
            fours[0][k % 4],
            fours[1][k % 4],
            [k // 4 * 4 + n for n in (0, 1, 2, 3)] + [lanes + k // 4 * 4 + n for n in (0, 1, 2, 3)],
        )
        for k in range(lanes)
    ]


def _columns(builder: Builder, rows: list[Value]) -> list[Value]:
    """The columns of twice `PIECE` rows of `PIECE` numbers, in shuffles that processors have: first within quarters of four numbers, then of these."""
    size, quarters = 2 * PIECE, PIECE // 2

    def within(a: Value, b: Value, *places: int) -> Value:
        return builder.shuffled(a, b, [4 * q + (n if n < 4 else n - 4 + size) for q in range(quarters) for n in places])

    # Rows k and k + 8 are one vector: numbers 0-3 and 4-7 of the one, and of the other.
    both = [builder.shuffled(a, b, list(range(size))) for a, b in zip(rows[:PIECE], rows[PIECE:], strict=True)]
    fours = []
    for k in (0, 4):  # four rows by four numbers, in each quarter
        low = [within(both[k + n], both[k + n + 1], 0, 4, 1, 5) for n in (0, 2)]
        high = [within(both[k + n], both[k + n + 1], 2, 6, 3, 7) for n in (0, 2)]
        fours.append(
            [within(pair[0], pair[1], *places) for pair in (low, high) for places in ((0, 1, 4, 5), (2, 3, 6, 7))]
        )
    found = []
    for first in (0, 4):
        order = [quarter + n for quarter in (first, size + first, 8 + first, size + 8 + first) for n in range(4)]
        found += [builder.shuffled(a, b, order) for a, b in zip(*fours, strict=True)]
    return found
