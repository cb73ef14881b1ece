"""The function that fits blocks of texels, and where everything is in a thread's room: the part of a module that is the same for every model."""

from __future__ import annotations

from dataclasses import dataclass

from motes.fitting.levenberg import ROUNDS
from motes.fitting.printed import driver_text
from motes.fitting.printed.rows import LANES
from motes.fitting.printed.steps import SCALARS

#: What a texel brings and takes away, in the order of its row: see `motes.fitting.texel_kernel`.
STATE = (
    "damping",
    "growth",
    "idle",
    "running",
    "iterations",
    "ending",
    "samples",
    "brightness",
    "squares",
    "clamped",
    "objective",
    "partial",
    "noise",
    "asks",
    "adrift",
    "fourth",
)


#: The verdict of a texel without a fit.
NO_VERDICT = 255
# After so many iterations a block in which few texels still run leaves them to a block of such texels.
LONG_RUN = 6
# Steps that a fit of many times makes by a few of them.
FIRST_STEPS = 2
# Under a robust function a step that promises less than this share of the objective is near the end; from there on steps take the curvature of the objective
# for what it is, but of each residual no less than this share of its weight.
NEAR, LEAST_BENDING = 0.01, 0.02
# Lines of the next block's memory that are asked for at a time, at one time and at several: all of it by the end of a block, but no more at once than a
# processor keeps requests for.
LINES_AHEAD = 20, 64


@dataclass(frozen=True)
class Layout:
    """Sizes of everything in a thread's room.

    Attributes
    ----------
    size, local
        The numbers of coefficients, and of parameters at a time.
    channels, width
        Of a sample: its channels, and the rows that are kept of it.
    narrow, wide, opening, sums
        Rows of what depends on parameters alone, in float32 and in float64; of sums over samples that are made once, and at every point.
    basis
        What trends need of a time.
    static, robust, by_sample, whole
        One time, no trends; a robust function; a sample counts only with all its channels; no sample may be missing, and sums are series.
    """

    size: int
    local: int
    channels: int
    width: int
    blank: str
    narrow: int
    wide: int
    opening: int
    sums: int
    basis: int
    static: bool
    robust: bool
    by_sample: bool
    whole: bool

    @property
    def triangle(self) -> int:
        return self.size * (self.size + 1) // 2

    @property
    def local_triangle(self) -> int:
        return self.local * (self.local + 1) // 2

    @property
    def rows(self) -> int:
        """Of the normal equations."""
        return 2 + self.size + self.triangle

    def places(self) -> dict[str, int]:
        """Rows of each buffer in float64, in their order."""
        state = self.size + self.rows + len(SCALARS)
        return {
            "parameters": self.local,
            "slopes": 0 if self.static else self.local * self.size,
            "constants": (self.narrow + 1) // 2 + 1,
            "wide": self.wide,
            "summed": self.sums,
            "normal": 0 if self.static else 3 + self.local + self.local_triangle,
            "fresh": self.rows,
            "state": state,
            "next_state": state,
            "stops": 2 * self.size + 1,
            "next_stops": 2 * self.size + 1,
            "trial": self.size + 2,
            "own": self.size + 1 + self.robust,
            "curved": self.local_triangle if self.robust and not self.static else 0,
            "bent": self.triangle if self.robust else 0,
            "curvature": self.triangle if self.robust else 0,
            "leverage": 0 if self.static else self.local_triangle,
            "middle": self.rows + 1,
            "stand": 4 * self.size,
            "among": self.size,
            "blurred": self.size + 1,
            "now_blurred": self.size + 1,
            "loose": self.size + 1,
            "unit": self.size,
            "column": self.size,
            "inverse": self.triangle,
            "wider": self.triangle,
            "wider_blurred": self.size + 1,
            "relaxed": self.size,
            "covariance": self.triangle,
            "noise": 1,
            "point": self.size + 1,
            "found": 3 * self.size + 1,
        }

    def room(self, times: int, given: int, samples: int) -> int:
        """Items of float64 that a thread needs."""
        floats = times * samples * self.width + given * self.channels
        return LANES * (sum(self.places().values()) + times * self.opening + -(-floats // 2))

    def constants(self) -> str:
        """The sizes, and the places of the buffers in a room, as constants of the module."""
        lines = [
            f"LANES, SIZE, LOCAL, CHANNELS, WIDTH, BLANK = {LANES}, {self.size}, {self.local}, {self.channels}, {self.width}, F({self.blank})",
            f"NARROW, OPENING, SUMS, BASIS, ROWS, STATE = {self.narrow}, {self.opening}, {self.sums}, {self.basis}, {self.rows}, {len(STATE)}",
            f"TRIANGLE, LOCAL_TRIANGLE = {self.triangle}, {self.local_triangle}",
            *(f"{name.upper()} = {SCALARS.index(name)}" for name in ("running", "iterations", "ending", "brightness")),
            f"NONE, ROUNDS, LONG, FIRST, LINES = {NO_VERDICT}, {ROUNDS}, {LONG_RUN}, {FIRST_STEPS}, {LINES_AHEAD[not self.static]}",
            *([f"NEAR, LEAST = D({NEAR}), D({LEAST_BENDING})"] if self.robust else []),
        ]
        start = 0
        for name, rows in (*self.places().items(), ("opened", 0)):
            lines.append(f"AT_{name.upper()} = {8 * LANES * start}")
            start += rows
        return "\n".join(lines)

    def text(self) -> str:
        """The functions of the driver."""
        loops = self._normal(), self._closing(), self._residuals() if self.robust else ""
        # What misses nothing is kept as it was measured.
        stored = "" if self.whole else "stored(columns, row, raw, given, block)"
        load = driver_text.LOAD.replace("<RAW>", "block" if self.whole else "raw").replace("<STORED>", stored)
        parts = (driver_text.CLEAR, load, driver_text.AHEAD, driver_text.STEP, *loops, self._fit())
        return "\n\n".join(part.strip("\n") for part in parts if part)

    def _normal(self) -> str:
        """``normal_equations``: at a point, added up over the times."""
        if self.static:
            body, target = ["parameters = x"], "total"
        else:
            body, target = ["trends_at(x, basis + 8 * BASIS * t, parameters, slopes)"], "normal"
        opened = "room + AT_OPENED + 8 * LANES * OPENING * t"
        body += [
            "constants_at(parameters, own, constants, wide)",
            *(
                [f"series_at(parameters, {opened}, shared, summed)"]
                if self.whole
                else [
                    "clear(summed, SUMS)",
                    "sums_at(columns, row, constants, data + 4 * LANES * WIDTH * samples * t, samples, summed)",
                ]
            ),
            f"normal_at(wide, own, {opened}, summed, shared, {target})",
        ]
        if not self.static:
            body.append("chain_rule(normal, slopes, total)")
        return driver_text.PASS.format(
            name="normal_equations",
            total=", total",
            before="" if self.static else "clear(total, ROWS)",
            body=_joined(body, 8),
        )

    def _closing(self) -> str:
        """``closing``: residuals, errors and verdicts at the solution."""
        parameters = ["parameters = x"] if self.static else ["trends_at(x, basis + 8 * BASIS * t, parameters, slopes)"]
        block = "data + 4 * LANES * WIDTH * samples * t"
        curving = ["curvature = matrix"]
        if self.robust:
            into = "bent" if self.static else "curved"
            curving = [
                "curvature, bent = room + AT_CURVATURE, room + AT_BENT",
                "clear(bent, TRIANGLE)",
                "for t in range(times):",
                *("    " + line for line in parameters),
                "    constants_at(parameters, own, constants, wide)",
                *([] if self.static else ["    clear(curved, LOCAL_TRIANGLE)"]),
                f"    curving_sums(columns, row, constants, {block}, samples, {into})",
                *([] if self.static else ["    carry(curved, slopes, bent)"]),
                *driver_text.FLAT,
                "curvature_at(bent, matrix, curvature)",
            ]
        middle = [*parameters]
        if self.static:
            middle += [
                "closing_at(parameters, own, inverse, constants)",
                f"closing_sums(columns, row, constants, {block}, samples, middle)",
            ]
        else:
            middle += [
                "leverage_at(inverse, slopes, leverage)",
                "closing_at(parameters, own, leverage, constants)",
                "clear(normal, 3 + LOCAL + LOCAL_TRIANGLE)",
                f"closing_sums(columns, row, constants, {block}, samples, normal)",
                "chain_rule(normal, slopes, middle)",
                "for n in range(LANES):",
                '    here = load(D, normal, (2 + LOCAL + LOCAL_TRIANGLE) * LANES + n, "clamped", 1)',
                '    store(D, middle, ROWS * LANES + n, load(D, middle, ROWS * LANES + n, "other", 1) + here, "clamped", 0, 1)',
            ]
        return driver_text.CLOSING.format(curving=_joined(curving, 4), middle=_joined(middle, 8))

    def _residuals(self) -> str:
        """``residuals``: those of all given samples, NaN where there is no value."""
        body = [
            "parameters = x" if self.static else "trends_at(x, basis + 8 * BASIS * t, parameters, slopes)",
            "constants_at(parameters, own, constants, wide)",
            "residuals_at(columns, row, constants, data + 4 * LANES * WIDTH * samples * t, given, out + 4 * LANES * CHANNELS * given * t)",
        ]
        return driver_text.PASS.format(name="residuals", total=", given, out", before="", body=_joined(body, 8))

    def _fit(self) -> str:
        text = driver_text.FIT
        for key, value in {
            "FEW_TIMES": "" if self.static else driver_text.FEW_TIMES,
            "WHOLE": driver_text.WHOLE if self.whole else "",
            "PARTIAL": driver_text.PARTIAL if self.by_sample and self.channels > 1 else "",
            "STARTING": driver_text.STARTING if self.robust else "",
            "BENDING": driver_text.BENDING if self.robust else "",
            "RESIDUALS": driver_text.RESIDUALS if self.robust else "",
        }.items():
            text = text.replace(f"<{key}>", value)
        return text


def _joined(lines: list[str], indent: int) -> str:
    return ("\n" + " " * indent).join(lines)
