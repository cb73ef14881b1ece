"""The text of what generated modules hold besides formulas: their beginning, and the functions that are called; see `motes.kernels.loops`."""

HEADER = '''"""{title}"""

F, I = {scalar}, {integer}
ITEM, WHOLE, TILE = {item}, {whole}, {tile}

'''

COLUMNS = '''
def gather(lanes, source, step, stride, scratch, count):
    """`lanes` rows one after the other in memory, from any layout: item k of entry n is source[n * step + k * stride]."""
    if lanes == 3 and step == 3 and stride == 1:
        for n in range(count):
            store(F, scratch, n, load(F, source, 3 * n, "gather", 3), "gather", 0, 3)
            store(F, scratch, TILE + n, load(F, source, 3 * n + 1, "gather", 3), "gather", 1, 3)
            store(F, scratch, 2 * TILE + n, load(F, source, 3 * n + 2, "gather", 3), "gather", 2, 3)
    else:
        for k in range(lanes):
            for n in range(count):
                store(F, scratch, k * TILE + n, load(F, source, n * step + k * stride, "gather", 3), "gather", 0, 3)


def columns(lanes, source, step, stride, room, count, copied):
    """Where rows one after the other in memory begin, and how far apart they are: `source` itself or a copy in `room`."""
    if step == 1 and not copied:
        return source, stride
    gather(lanes, source, step, stride, room, count)
    return room, TILE


def scatter(lanes, scratch, target, step, stride, count):
    """The reverse of `gather`."""
    if lanes == 3 and step == 3 and stride == 1:
        for n in range(count):
            store(F, target, 3 * n, load(F, scratch, n, "scatter", 3), "scatter", 0, 3)
            store(F, target, 3 * n + 1, load(F, scratch, TILE + n, "scatter", 3), "scatter", 1, 3)
            store(F, target, 3 * n + 2, load(F, scratch, 2 * TILE + n, "scatter", 3), "scatter", 2, 3)
    else:
        for k in range(lanes):
            for n in range(count):
                store(F, target, n * step + k * stride, load(F, scratch, k * TILE + n, "scatter", 3), "scatter", 0, 3)

'''

# Addresses are integers.  Directions are an address, the step from one to the next and the stride between components, in items; rows of
# `varying` and `slopes` are `row` items apart; `room` has space for a tile of all components and channels.  Directions that do not make a whole
# vector come last: they are copied, and what lies beside them there, and behind rows of `varying`, is computed with them and left.
EVALUATE = """
@kernel
@flushing
def evaluate(wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, out, out_step, out_stride, room, first, last):
    start = first
    while start < last:
        count = min(TILE, last - start)
        part = count < WHOLE
        if not part:
            count -= count % WHOLE
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count, part)
        o, o_row = columns(3, wo + ITEM * start * wo_step, wo_step, wo_stride, room + 3 * ITEM * TILE, count, part)
        f, f_row = out + ITEM * start * out_step, out_stride
        apart = part or out_step != 1
        if apart:
            f, f_row = room + 6 * ITEM * TILE, TILE
        span(i, i_row, o, o_row, constants, varying + ITEM * start, row, f, f_row, WHOLE if part else count)
        if apart:
            scatter({channels}, f, out + ITEM * start * out_step, out_step, out_stride, count)
        start += count
"""
TABLE = """
@kernel
def evaluate(wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, out, out_step, out_stride, room, first, last):
    span(wi + ITEM * first, wi_stride, wo + ITEM * first, wo_stride, constants, varying + ITEM * first, row, out + ITEM * first, out_stride, last - first)
"""

# Rows of `length` directions, each with values of its own for what is uniform over it: `width` constants, and where its directions begin.
APART = """
@kernel
def apart(wi_at, wi_step, wi_stride, wo_at, wo_step, wo_stride, constants, width, out, out_step, out_stride, length, room, first, last):
    for k in range(first, last):
        evaluate(
            load(int64, wi_at, k - first, "apart", 1), wi_step, wi_stride, load(int64, wo_at, k - first, "apart", 1), wo_step, wo_stride,
            constants + ITEM * width * (k - first), 0, 0, out + ITEM * k * length * out_step, out_step, out_stride, room, 0, length,
        )
"""

# Sums are rows of lanes: of a tile, and in float64 of all that is called for, which are added up at the end.  Directions that do not make a whole
# vector are copied, and the last of them is repeated, with seeds of 0.
GRADIENT = """
def repeated(rows, source, row, target, count):
    for k in range(rows):
        for n in range(WHOLE):
            store(F, target, k * TILE + n, load(F, source, k * row + min(n, count - 1), "other", 1), "repeated", 0, 1)


def put_back(rows, source, target, row, count):
    for k in range(rows):
        for n in range(count):
            store(F, target, k * row + n, load(F, source, k * TILE + n, "other", 1), "back", 0, 1)


@kernel
@flushing
def gradient(
    wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, seed, seed_step, seed_stride, slopes, totals,
    room, first, last,
):
    sums = room + ({channels} + 6) * ITEM * TILE
    wide = sums + ITEM * {lanes} * {totals}
    own = wide + 8 * {lanes} * {totals}
    for k in range({lanes} * {totals}):
        store(F, sums, k, F(0.0), "cleared", 0, 1)
    for k in range({lanes} * {totals}):
        store(float64, wide, k, 0.0, "cleared", 0, 1)
    start = first
    while start < last:
        count = min(TILE, last - start)
        part = count < WHOLE
        if not part:
            count -= count % WHOLE
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count, part)
        o, o_row = columns(3, wo + ITEM * start * wo_step, wo_step, wo_stride, room + 3 * ITEM * TILE, count, part)
        f, f_row = columns({channels}, seed + ITEM * start * seed_step, seed_step, seed_stride, room + 6 * ITEM * TILE, count, part)
        v, v_row, s, s_row = varying + ITEM * start, row, slopes + ITEM * start, row
        if part:
            repeated(6, room, TILE, room, count)
            repeated({rows}, v, row, own, count)
            v, v_row, s, s_row = own, TILE, own + {rows} * ITEM * TILE, TILE
            for k in range({channels}):
                for n in range(count, WHOLE):
                    store(F, f, k * TILE + n, F(0.0), "other", 0, 1)
        span(i, i_row, o, o_row, constants, v, v_row, f, f_row, s, s_row, sums, WHOLE if part else count)
        if part:
            put_back({rows}, s, slopes + ITEM * start, row, count)
        for k in range({lanes} * {totals}):
            store(float64, wide, k, load(float64, wide, k, "widened", 2) + load(F, sums, k, "widened", 2), "widened", 0, 2)
            store(F, sums, k, F(0.0), "widened", 1, 2)
        start += count
    for k in range({totals}):
        total = load(float64, totals, k, "other", 1)
        for n in range({lanes}):
            total += load(float64, wide, {lanes} * k + n, "other", 1)
        store(float64, totals, k, total, "added", 0, 1)
"""

# `u` are two random numbers; what is sampled is brought from rows into three arrays.
SAMPLE = """
@wide
@kernel
@flushing
def sample(
    wi, wi_step, wi_stride, u, u_step, u_stride, constants, varying, row, wo, wo_step, wo_stride, density, weight, weight_step, weight_stride,
    room, first, last,
):
    f = room + 5 * ITEM * TILE
    for start in range(first, last, TILE):
        count = min(TILE, last - start)
        i, i_row = columns(3, wi + ITEM * start * wi_step, wi_step, wi_stride, room, count, False)
        o, o_row = columns(2, u + ITEM * start * u_step, u_step, u_stride, room + 3 * ITEM * TILE, count, False)
        span(i, i_row, o, o_row, constants, varying + ITEM * start, row, f, TILE, count)
        scatter(3, f, wo + ITEM * start * wo_step, wo_step, wo_stride, count)
        scatter(1, f + 3 * ITEM * TILE, density + ITEM * start, 1, 1, count)
        scatter({channels}, f + 4 * ITEM * TILE, weight + ITEM * start * weight_step, weight_step, weight_stride, count)
"""
