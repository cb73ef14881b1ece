"""The text of a module's functions that are the same for every model, in the language of `motes.kernels.lowering`; see `motes.fitting.printed.driver`."""

from __future__ import annotations

CLEAR = """
def clear(rows, count):
    for n in range(count * LANES):
        store(D, rows, n, D(0.0), "clear", 0, 1)
"""

LOAD = """
@apart
def load_block(source, stride, last, given, samples, times, columns, row, data, raw):
    numbers = given * CHANNELS
    for t in range(times):
        at, block = source + 4 * numbers * t, data + 4 * LANES * WIDTH * samples * t
        for first in range(0, numbers - PIECE + 1, PIECE):
            transposed(at, stride, last, first, <RAW>)
        if numbers >= PIECE:
            transposed(at, stride, last, numbers - PIECE, <RAW>)
        else:
            for k in range(numbers):
                for n in range(LANES):
                    store(F, <RAW>, k * LANES + n, load(F, at + min(n, last) * stride, k, "other", 1), "plain", 0, 1)
        <STORED>
        for n in range(given * WIDTH * LANES, samples * WIDTH * LANES):
            store(F, block, n, BLANK, "plain", 0, 1)
"""

AHEAD = """
def ahead(address, end):
    last = min(address + 64 * LINES, end)
    while address < last:
        prefetch(address)
        address += 64
    return address
"""

PASS = """
@apart
def {name}(x, room, own, columns, row, basis, times, every, samples, data{total}, coming, end):
    parameters, slopes, constants, wide = room + AT_PARAMETERS, room + AT_SLOPES, room + AT_CONSTANTS, room + AT_WIDE
    summed, normal, shared = room + AT_SUMMED, room + AT_NORMAL, basis + 8 * BASIS * times
    {before}
    for t in range(0, times, every):
        coming = ahead(coming, end)
        {body}
    return coming
"""

CLOSING = """
def any_of(rows):
    total = D(0.0)
    for n in range(LANES):
        total += load(D, rows, n, "other", 1)
    return total > D(0.0)


@apart
def column_of(matrix, k, column):
    for i in range(SIZE):
        at = i * (i + 1) // 2 + k if k <= i else k * (k + 1) // 2 + i
        for n in range(LANES):
            store(D, column, i * LANES + n, load(D, matrix, at * LANES + n, "other", 1), "plain", 0, 1)


def inverse_of(curvature, among, blurred, inverse, now_blurred):
    inverse_at(curvature, among, blurred, inverse, now_blurred)


@apart
def closing(x, room, own, box, columns, row, basis, times, samples, data, roughly, whole, coming, end):
    parameters, slopes, constants, wide = room + AT_PARAMETERS, room + AT_SLOPES, room + AT_CONSTANTS, room + AT_WIDE
    normal, curved, leverage, middle = room + AT_NORMAL, room + AT_CURVED, room + AT_LEVERAGE, room + AT_MIDDLE
    stand, among, blurred, now_blurred = room + AT_STAND, room + AT_AMONG, room + AT_BLURRED, room + AT_NOW_BLURRED
    loose, unit, column, noise = room + AT_LOOSE, room + AT_UNIT, room + AT_COLUMN, room + AT_NOISE
    inverse, wider, relaxed = room + AT_INVERSE, room + AT_WIDER, room + AT_RELAXED
    covariance, found = room + AT_COVARIANCE, room + AT_FOUND
    matrix, point = x + 8 * LANES * (SIZE + 2 + SIZE), room + AT_POINT
    gradient, spread = middle + 16 * LANES, middle + 8 * LANES * (2 + SIZE)
    free = stand + 8 * LANES * 3 * SIZE
    objective, ending, bright = x + 8 * LANES * SIZE, x + 8 * LANES * (SIZE + ROWS + ENDING), x + 8 * LANES * (SIZE + ROWS + BRIGHTNESS)
    {curving}
    if roughly:
        for k in range(SIZE):
            for n in range(LANES):
                store(D, found, k * LANES + n, load(D, curvature, (k * (k + 1) // 2 + k) * LANES + n, "other", 1), "plain", 0, 1)
        return
    standing_at(x, curvature, bright, box, stand)
    clear(loose, SIZE)
    clear(blurred, SIZE + 1)
    for again in range(2):  # what is only seen in sums is left out the second time
        among_at(free, blurred, loose, among)
        inverse_of(curvature, among, blurred, inverse, now_blurred)
        blurred, now_blurred = now_blurred, blurred
        if not any_of(blurred + 8 * LANES * SIZE):
            break
    among_at(free, blurred, loose, among)
    clear(middle, ROWS + 1)
    for t in range(times):
        coming = ahead(coming, end)
        {middle}
    polished(x, objective, ending, bright, middle, gradient, inverse, among, box, point)
    for k in range(SIZE):
        column_of(inverse, k, column)
        if whole:
            row_at(column, inverse, spread, unit)
            for n in range(k * LANES):
                store(D, covariance, k * (k + 1) // 2 * LANES + n, load(D, unit, n, "other", 1), "plain", 0, 1)
        variance_at(column, spread, covariance + 8 * LANES * (k * (k + 1) // 2 + k))
    noise_at(curvature, spread, among, noise)
    wider_blurred, some = blurred, False
    clear(relaxed, SIZE)
    for k in range(SIZE):
        if not (any_of(stand + 8 * LANES * k) or any_of(stand + 8 * LANES * (SIZE + k))):
            continue
        column_of(curvature, k, column)
        for i in range(SIZE):
            for n in range(LANES):
                store(D, unit, i * LANES + n, D(1.0) if i == k else D(0.0), "plain", 0, 1)
        push_at(unit, gradient, column, inverse, spread, among, loose + 8 * LANES * SIZE)
        for n in range(LANES):
            bounded = load(D, stand, k * LANES + n, "other", 1) + load(D, stand, (SIZE + k) * LANES + n, "other", 1)
            here = bounded * (D(1.0) - load(D, loose, SIZE * LANES + n, "other", 1))
            store(D, loose, k * LANES + n, here, "plain", 0, 1)
            some = some or here > D(0.0)
    if some or any_of(blurred + 8 * LANES * SIZE):
        among_at(free, blurred, loose, among)
        clear(now_blurred, SIZE)
        inverse_of(curvature, among, now_blurred, wider, room + AT_WIDER_BLURRED)
        wider_blurred = room + AT_WIDER_BLURRED
        for k in range(SIZE):
            column_of(wider, k, column)
            variance_at(column, spread, relaxed + 8 * LANES * k)
    errors_at(point, stand, covariance, relaxed, loose, blurred, wider_blurred, box, found)
"""

STEP = """
@apart
def proposed(state, box, own, room, trial):
    stops, next_stops = room + AT_STOPS, room + AT_NEXT_STOPS
    held(state, box, own, stops)
    for again in range(ROUNDS):
        bounded_step(state, box, stops, next_stops)
        stops, next_stops = next_stops, stops
        leaving = D(0.0)
        for n in range(LANES):
            leaving += load(D, stops, 2 * SIZE * LANES + n, "other", 1)
        if not leaving > D(0.0):
            break
    proposal(state, box, stops, trial)
"""

# Some steps by a few of the times, to where those have their minimum, about; from there the fit goes on by all of them.
FEW_TIMES = """if every > 1:
            coming = normal_equations(state, room, own, columns, row, basis, times, every, samples, data, state + 8 * LANES * SIZE, coming, end)
            for iteration in range(FIRST):
                proposed(state, box, own, room, trial)
                coming = normal_equations(trial, room, own, columns, row, basis, times, every, samples, data, fresh, coming, end)
                judged(state, box, trial, fresh, next_state)
                state, next_state = next_state, state
            for n in range(LANES):
                if load(D, state, (after + ENDING) * LANES + n, "other", 1) > D(0.0):
                    store(D, state, (after + RUNNING) * LANES + n, D(1.0), "plain", 0, 1)
                    store(D, state, (after + ENDING) * LANES + n, D(0.0), "plain", 0, 1)"""

# Whether a texel has a sample with some of its channels only, which sums over whole samples leave out.
PARTIAL = """if running > D(0.0) and used < whole:
                for s in range(times * given):
                    there = 0
                    for c in range(CHANNELS):
                        v = load(F, values + 4 * (texel * times * given + s) * CHANNELS, c, "other", 1)
                        there += v - v == F(0.0)
                    if there > 0 and there < CHANNELS:
                        running = D(0.0)
                if running == D(0.0) and n < count:
                    store(D, states, texel * STATE + 11, D(1.0), "plain", 0, 1)"""

# A texel that misses a sample: the form does not serve it.
WHOLE = """if not brightness - brightness == D(0.0):
                brightness, used = D(0.0), D(0.0)
                for k in range(OPENING * times):
                    store(D, room + AT_OPENED, k * LANES + n, D(0.0), "plain", 0, 1)
                for k in range(times * samples * WIDTH):
                    store(F, data, k * LANES + n, F(0.0), "plain", 0, 1)
                if n < count:
                    store(D, states, texel * STATE + 11, D(1.0), "plain", 0, 1)"""

# Until a lane is near its end steps are shorter than those by the curvature of the objective, which may have no minimum there.
STARTING = """store(D, own, (SIZE + 1) * LANES + n, D(1.0), "plain", 0, 1)"""

BENDING = """for n in range(LANES):
                near = load(D, trial, SIZE * LANES + n, "other", 1) < NEAR * load(D, state, SIZE * LANES + n, "other", 1)
                store(D, own, (SIZE + 1) * LANES + n, LEAST if near else D(1.0), "plain", 0, 1)"""

# Where the curvature is not positive errors are those of the weights themselves.
FLAT = """flat = False
for k in range(SIZE):
    for n in range(LANES):
        flat = flat or not load(D, bent, (k * (k + 1) // 2 + k) * LANES + n, "other", 1) > D(0.0)
if flat:
    for n in range(LANES):
        store(D, own, (SIZE + 1) * LANES + n, D(1.0), "plain", 0, 1)
    coming = normal_equations(x, room, own, columns, row, basis, times, 1, samples, data, room + AT_FRESH, coming, end)
    matrix = room + AT_FRESH + 8 * LANES * (2 + SIZE)""".splitlines()

RESIDUALS = """if out != 0:
            block = out + 4 * LANES * CHANNELS * given * times * (first // LANES)
            coming = residuals(state, room, own, columns, row, basis, times, 1, samples, data, given, block, coming, end)"""

# Addresses are integers.  `values` are float32 (texel, time, sample, channel); `columns` rows of `row` items; `points` and `held` (texel,
# coefficient), `noise` (texel,) and `states` (texel, STATE) float64, of which `held` and `noise` may be the same for all (a step of 0); `box`
# as `motes.fitting.printed.judging.BOX`.  What comes out, when `close` is 1: `found` and `errors` (texel, coefficient) float32, `codes` likewise uint8,
# for a texel without a fit NaN and NONE; and covariances (texel, TRIANGLE) float32 where that is an address.  When it is 2: the diagonal
# of the curvature in `points`.
FIT = """
@kernel
@flushing
def fit(
    values, times, given, samples, columns, row, basis, box, texels, points, states, held_at, held_step, noise, noise_step,
    limit, leave, every, close, found, errors, codes, covariances, out, room,
):
    data = room + AT_OPENED + 8 * LANES * OPENING * times
    raw = data + 4 * LANES * WIDTH * samples * times
    own, fresh, trial = room + AT_OWN, room + AT_FRESH, room + AT_TRIAL
    whole = load(D, box, 3 * SIZE + 2, "other", 1)
    after = SIZE + ROWS
    for first in range(0, texels, LANES):
        state, next_state = room + AT_STATE, room + AT_NEXT_STATE
        count = min(LANES, texels - first)
        stride = 4 * times * given * CHANNELS
        load_block(values + first * stride, stride, count - 1, given, samples, times, columns, row, data, raw)
        clear(room + AT_OPENED, OPENING * times)
        for t in range(times):
            opened = room + AT_OPENED + 8 * LANES * OPENING * t
            opening_sums(columns, row, room + AT_CONSTANTS, data + 4 * LANES * WIDTH * samples * t, samples, opened)
        # The next block's memory, a little at a time between the steps: more at once would have to be waited for.
        coming, end = values + (first + LANES) * stride, values + min(texels, first + 2 * LANES) * stride
        # What the next block's texels bring.
        ahead(points + 8 * (first + LANES) * SIZE, points + 8 * min(texels, first + 2 * LANES) * SIZE)
        ahead(states + 8 * (first + LANES) * STATE, states + 8 * min(texels, first + 2 * LANES) * STATE)
        # ---- where the lanes start
        going, begun = 0, False
        for n in range(LANES):
            texel = first + min(n, count - 1)
            for k in range(SIZE):
                store(D, state, k * LANES + n, load(D, points, texel * SIZE + k, "other", 1), "plain", 0, 1)
                store(D, own, k * LANES + n, load(D, held_at, texel * held_step + k, "other", 1), "plain", 0, 1)
            store(D, own, SIZE * LANES + n, load(D, noise, texel * noise_step, "other", 1), "plain", 0, 1)
            <STARTING>
            for k in range(BRIGHTNESS):
                store(D, state, (after + k) * LANES + n, load(D, states, texel * STATE + k, "other", 1), "plain", 0, 1)
            brightness, used = D(0.0), D(0.0)
            for t in range(times):
                opened = room + AT_OPENED + 8 * LANES * OPENING * t
                brightness += load(D, opened, n, "other", 1)
                used += load(D, opened, LANES + n, "other", 1)
            <WHOLE>
            store(D, state, (after + BRIGHTNESS) * LANES + n, brightness, "plain", 0, 1)
            running = load(D, state, (after + RUNNING) * LANES + n, "other", 1)
            <PARTIAL>
            if n >= count or brightness == D(0.0) or used <= SIZE:
                running = D(0.0)
            store(D, state, (after + RUNNING) * LANES + n, running, "plain", 0, 1)
            going += running > D(0.0)
            begun = begun or load(D, state, (after + ITERATIONS) * LANES + n, "other", 1) > D(0.0)
            if n < count:
                store(D, states, texel * STATE + 6, used, "plain", 0, 1)
                store(D, states, texel * STATE + 7, brightness, "plain", 0, 1)
        coming = ahead(coming, end)
        <FEW_TIMES>
        coming = normal_equations(state, room, own, columns, row, basis, times, 1, samples, data, state + 8 * LANES * SIZE, coming, end)
        for iteration in range(limit):
            if begun:  # in another block: a lane waits that has come as far as is asked for
                going = 0
                for n in range(LANES):
                    on = load(D, state, (after + RUNNING) * LANES + n, "other", 1) > D(0.0)
                    if on and load(D, state, (after + ITERATIONS) * LANES + n, "other", 1) >= limit:
                        store(D, state, (after + RUNNING) * LANES + n, D(0.0), "plain", 0, 1)
                        store(D, state, (after + ENDING) * LANES + n, D(-1.0), "plain", 0, 1)
                        on = False
                    going += on
            few = min(leave, count // 2) if iteration >= LONG else 0
            if going <= few:
                break
            coming = ahead(coming, end)
            proposed(state, box, own, room, trial)
            going = 0
            for n in range(LANES):
                on = load(D, state, (after + RUNNING) * LANES + n, "other", 1) > D(0.0)
                going += on and load(D, trial, (SIZE + 1) * LANES + n, "other", 1) == D(0.0)
            if going <= few:  # the others' next block looks at the data for them
                ended(state, trial, next_state)
                state, next_state = next_state, state
                break
            <BENDING>
            coming = normal_equations(trial, room, own, columns, row, basis, times, 1, samples, data, fresh, coming, end)
            coming = ahead(coming, end)
            judged(state, box, trial, fresh, next_state)
            state, next_state = next_state, state
        for n in range(count):
            texel = first + n
            if load(D, state, (after + ENDING) * LANES + n, "other", 1) < D(0.0):
                store(D, state, (after + RUNNING) * LANES + n, D(1.0), "plain", 0, 1)
                store(D, state, (after + ENDING) * LANES + n, D(0.0), "plain", 0, 1)
            for k in range(SIZE):
                store(D, points, texel * SIZE + k, load(D, state, k * LANES + n, "other", 1), "plain", 0, 1)
            for k in range(BRIGHTNESS):
                store(D, states, texel * STATE + k, load(D, state, (after + k) * LANES + n, "other", 1), "plain", 0, 1)
            store(D, states, texel * STATE + 10, load(D, state, SIZE * LANES + n, "other", 1), "plain", 0, 1)
        <RESIDUALS>
        if close == 0:
            continue
        if close == 1:  # what the data do not see goes to its default
            rest_at(state, state + 8 * LANES * (SIZE + 2 + SIZE), state + 8 * LANES * (after + BRIGHTNESS), box, trial)
            if any_of(trial + 8 * LANES * SIZE):
                coming = normal_equations(trial, room, own, columns, row, basis, times, 1, samples, data, fresh, coming, end)
                rested(state, trial, fresh, next_state)
                state, next_state = next_state, state
        closing(state, room, own, box, columns, row, basis, times, samples, data, close == 2, covariances != 0, coming, end)
        middle, results, noise_here = room + AT_MIDDLE, room + AT_FOUND, room + AT_NOISE
        for n in range(count):
            texel = first + n
            if close == 2:
                for k in range(SIZE):
                    store(D, points, texel * SIZE + k, load(D, results, k * LANES + n, "other", 1), "plain", 0, 1)
                continue
            squares = load(D, middle, n, "other", 1)
            used, brightness = load(D, states, texel * STATE + 6, "other", 1), load(D, states, texel * STATE + 7, "other", 1)
            store(D, states, texel * STATE + 8, squares, "plain", 0, 1)
            store(D, states, texel * STATE + 15, load(D, middle, LANES + n, "other", 1), "plain", 0, 1)
            store(D, states, texel * STATE + 9, load(D, middle, ROWS * LANES + n, "other", 1), "plain", 0, 1)
            store(D, states, texel * STATE + 14, load(D, room + AT_POINT, SIZE * LANES + n, "other", 1), "plain", 0, 1)
            store(D, states, texel * STATE + 12, load(D, noise_here, n, "other", 1), "plain", 0, 1)
            there = squares - squares == D(0.0) and brightness > D(0.0) and used > SIZE
            for k in range(SIZE):
                value = load(D, results, k * LANES + n, "other", 1)
                there = there and value - value == D(0.0)
            store(D, states, texel * STATE + 13, load(D, results, 3 * SIZE * LANES + n, "other", 1) if there else D(0.0), "plain", 0, 1)
            for k in range(SIZE):
                store(D, points, texel * SIZE + k, load(D, room + AT_POINT, k * LANES + n, "other", 1), "plain", 0, 1)
                value = load(D, results, k * LANES + n, "other", 1) if there else D(nan)
                error = load(D, results, (SIZE + k) * LANES + n, "other", 1) if there else D(nan)
                code = load(D, results, (2 * SIZE + k) * LANES + n, "other", 1) if there else D(NONE)
                store(F, found, texel * SIZE + k, F(value), "plain", 0, 1)
                store(F, errors, texel * SIZE + k, F(error), "plain", 0, 1)
                store(B, codes, texel * SIZE + k, B(code), "plain", 0, 1)
            if covariances != 0:
                for k in range(TRIANGLE):
                    value = load(D, room + AT_COVARIANCE, k * LANES + n, "other", 1)
                    store(F, covariances, texel * TRIANGLE + k, F(value), "plain", 0, 1)
"""
