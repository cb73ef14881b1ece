"""A small chart in SVG: scales with ticks, lines, dots, bands, pictures.

Why not a plotting library: a report has some twenty small panels, which cost Matplotlib 0.7 s to import and 0.07 s each, more than the fit they show;
and a panel made of CSS classes follows the page's light or dark scheme, keeps its text selectable, and takes a few kilobytes.  No text out of a file
comes here: legends are HTML.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes.drawing.colour import data_uri, png
from motes.drawing.markup import Html, tag

LEFT, RIGHT, TOP, BOTTOM = 50, 12, 30, 42
#: The mean width of a letter of a title, and what is left free beside it, in pixels.
LETTER, MARGIN = 7.2, 4
_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def number(x: float) -> str:
    """A tick label: plain where that is short, a power of ten otherwise."""
    if x == 0:
        return "0"
    if 1e-3 <= abs(x) < 1e5:
        return f"{x:.6g}".replace("-", "−")
    mantissa, exponent = f"{x:.2e}".split("e")
    mantissa = f"{float(mantissa):g}"
    power = "10" + str(int(exponent)).translate(_SUPERSCRIPT)
    return power if mantissa == "1" else f"{mantissa}·{power}".replace("-", "−")


@dataclass(frozen=True)
class Scale:
    """Values along an axis: ``low`` to ``high``, linear or logarithmic; ``ticks`` override the ones that suit."""

    low: float
    high: float
    log: bool = False
    ticks: tuple[float, ...] | None = None

    @classmethod
    def ratios(cls, low: float, high: float) -> Scale:
        """A logarithmic scale for ratios that holds 1, with ticks that are one another's inverse where that reads well."""
        low, high = min(low, 0.96) / 1.05, max(high, 1.04) * 1.05
        reach = max(high, 1 / low)
        ticks: tuple[float, ...]
        sets: tuple[tuple[float, tuple[float, ...]], ...] = (
            (1.1, (0.92, 0.96, 1.04, 1.08)),
            (1.2, (0.85, 0.9, 0.95, 1.05, 1.1, 1.15)),
            (1.5, (0.7, 0.8, 0.9, 1.1, 1.25, 1.4)),
            (2.6, (0.5, 0.7, 1.4, 2)),
        )
        ticks = next((t for most, t in sets if reach <= most), (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 2, 5, 10, 20, 50, 100))
        if reach > 30:
            ticks = tuple(10.0**k for k in range(-8, 9) if k and (reach < 1e4 or k % 2 == 0))
        return cls(low, high, True, tuple(sorted((*ticks, 1.0))))

    @classmethod
    def around(cls, *values: ArrayLike, log: bool = False, zero: bool = False, margin: float = 0.04) -> Scale:
        """A scale that holds all finite values (all positive ones when logarithmic), from zero when asked."""
        flat = np.concatenate([np.ravel(np.asarray(v, np.float64)) for v in values] or [np.zeros(0)])
        flat = flat[np.isfinite(flat) & ((flat > 0) if log else True)]
        if not flat.size:
            return cls(0.1, 1.0, True) if log else cls(0.0, 1.0)
        low, high = float(flat.min()), float(flat.max())
        if log:
            pad = max((high / low) ** margin, 1.08)
            return cls(low / pad, high * pad, True)
        if zero:
            low, high = min(low, 0.0), max(high, 0.0)
        if low == high == 0:
            return cls(0.0, 1.0)
        pad = (high - low) * margin or abs(high) * 0.1
        return cls(low - (0 if zero and low == 0 else pad), high + (0 if zero and high == 0 else pad))

    def __call__(self, values: ArrayLike) -> NDArray[np.float64]:
        """Fractions of the axis, 0 at ``low``; NaN where a logarithmic axis has no place."""
        values = np.asarray(values, np.float64)
        if not self.log:
            return (values - self.low) / (self.high - self.low)
        safe = np.where(values > 0, values, np.nan)
        return np.log(safe / self.low) / math.log(self.high / self.low)

    def marks(self, most: int = 6) -> list[float]:
        """Where the ticks are."""
        if self.ticks is not None:
            return [t for t in self.ticks if self.low <= t <= self.high]
        if not self.log or self.high < 2.2 * self.low:
            rough = (self.high - self.low) / most
            power = 10.0 ** math.floor(math.log10(rough))
            step = next(s * power for s in (1, 2, 2.5, 5, 10) if s * power >= rough * (1 - 1e-9))
            return [k * step for k in range(math.ceil(self.low / step - 1e-9), math.floor(self.high / step + 1e-9) + 1)]
        decades = math.log10(self.high / self.low)
        first, last = math.floor(math.log10(self.low)), math.ceil(math.log10(self.high))
        if decades > 2.2:
            every = math.ceil(decades / most)
            return [10.0**k for k in range(first, last + 1) if k % every == 0 and self.low <= 10.0**k <= self.high]
        factors = (1, 2, 5) if decades > 0.75 else (1, 1.5, 2, 3, 4, 5, 7)
        return [f * 10.0**k for k in range(first, last + 1) for f in factors if self.low <= f * 10.0**k <= self.high]


def _points(x: NDArray[np.float64], y: NDArray[np.float64]) -> list[str]:
    return [f"{a:.1f} {b:.1f}" for a, b in zip(x.tolist(), y.tolist(), strict=True)]


@dataclass
class Panel:
    """One chart; draw on it, then take ``svg(alt)``.

    Colours are CSS custom properties of the page: ``color="--red"``, or ``#rrggbb``.
    """

    x: Scale
    y: Scale
    title: str = ""
    x_label: str = ""
    y_label: str = ""
    width: int = 340
    height: int = 250
    axes: bool = True
    _inside: list[str] = field(default_factory=list)

    @property
    def _box(self) -> tuple[float, float, float, float]:
        if not self.axes:
            return 0, 0, self.width, self.height
        return LEFT, TOP, self.width - LEFT - RIGHT, self.height - TOP - BOTTOM

    def place(self, x: ArrayLike, y: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Pixels inside the plot area, y downward."""
        _, _, width, height = self._box
        px, py = np.broadcast_arrays(np.atleast_1d(self.x(x)) * width, (1 - np.atleast_1d(self.y(y))) * height)
        # Far outside is as good as just outside, and keeps the numbers short.
        return np.clip(px, -2 * width, 3 * width), np.clip(py, -2 * height, 3 * height)

    def line(self, x: ArrayLike, y: ArrayLike, color: str = "--ink", kind: str = "line") -> None:
        """A polyline, broken where a value is missing; ``kind`` is a CSS class: line, thin, dashed, dotted, guide."""
        px, py = self.place(x, y)
        good = np.isfinite(px) & np.isfinite(py)
        pieces = np.split(np.arange(len(px)), np.flatnonzero(~good))
        path = ""
        for piece in pieces:
            piece = piece[good[piece]]
            if len(piece) > 1:
                path += "M" + "L".join(_points(px[piece], py[piece]))
        self._path(path, kind, color)

    def dots(self, x: ArrayLike, y: ArrayLike, color: str = "--ink", size: float = 4.5, kind: str = "dots") -> None:
        """Round dots of a diameter in pixels: one path of points with round caps, a dozen bytes each."""
        px, py = self.place(x, y)
        good = np.isfinite(px) & np.isfinite(py)
        path = "".join(f"M{point}h0" for point in _points(px[good], py[good]))
        self._path(path, kind, color, f"stroke-width:{size:g}")

    def whiskers(
        self, x: ArrayLike, low: ArrayLike, high: ArrayLike, color: str = "--ink", kind: str = "whiskers"
    ) -> None:
        """Vertical strokes from low to high."""
        px, a = self.place(x, low)
        _, b = self.place(x, high)
        good = np.isfinite(px) & np.isfinite(a) & np.isfinite(b)
        path = "".join(f"M{p:.1f} {q:.1f}V{r:.1f}" for p, q, r in zip(px[good], a[good], b[good], strict=True))
        self._path(path, kind, color)

    def band(self, x: ArrayLike, low: ArrayLike, high: ArrayLike, color: str = "--ink") -> None:
        """The area between two curves; missing values are left out."""
        px, a = self.place(x, low)
        _, b = self.place(x, high)
        good = np.isfinite(px) & np.isfinite(a) & np.isfinite(b)
        if good.sum() > 1:
            path = "M" + "L".join(_points(px[good], a[good]) + _points(px[good][::-1], b[good][::-1])) + "Z"
            self._path(path, "band", color)

    def picture(self, pixels: NDArray[np.uint8], x: tuple[float, float], y: tuple[float, float]) -> None:
        """An image (first row on top) between two values along each axis."""
        px, py = self.place(x, y)
        self._inside.append(
            tag(
                "image",
                href=data_uri(png(pixels)),
                x=f"{px[0]:.1f}",
                y=f"{py[1]:.1f}",
                width=f"{px[1] - px[0]:.1f}",
                height=f"{py[0] - py[1]:.1f}",
                preserveAspectRatio="none",
                class_="pixels",
            )
        )

    def text(
        self,
        x: float,
        y: float,
        words: str,
        anchor: str = "middle",
        kind: str = "note",
        shift: tuple[float, float] = (0, 0),
    ) -> None:
        """Words at a point of the plot area, moved by pixels."""
        px, py = self.place(x, y)
        if np.isfinite(px[0]) and np.isfinite(py[0]):
            self._inside.append(_text(px[0] + shift[0], py[0] + shift[1], words, anchor, kind))

    def _path(self, path: str, kind: str, color: str, more: str = "") -> None:
        if path:
            stroke = f"var({color})" if color.startswith("--") else color
            self._inside.append(f'<path class="{kind}" style="--c:{stroke};{more}" d="{path}"/>')

    def svg(self, alt: str) -> Html:
        """The chart as an element; `alt` says in words what is to be seen."""
        left, top, width, height = self._box
        parts = []
        if self.axes:
            parts += self._frame()
        # A nested svg clips its content without an id that would have to be unique on the page.
        inside = "".join(self._inside)
        parts.append(f'<svg x="{left}" y="{top}" width="{width}" height="{height}">{inside}</svg>')
        if self.title:
            parts.append(self._titled(left if self.axes else 4))
        return Html(
            f'<svg class="panel" viewBox="0 0 {self.width} {self.height}" role="img" aria-label="{_attribute(alt)}">'
            + "".join(parts)
            + "</svg>"
        )

    def _titled(self, left: float) -> str:
        """The title above the plot area; one that is too long for that begins at the edge, and is set closer."""
        width = LETTER * len(self.title)
        if width > self.width - left - MARGIN:
            left = MARGIN
        room = self.width - left - MARGIN
        words = _text(left, 17, self.title, "start", "title")
        if width > room:
            words = words.replace("<text ", f'<text textLength="{room:.0f}" lengthAdjust="spacingAndGlyphs" ', 1)
        return words

    def _frame(self) -> list[str]:
        left, top, width, height = self._box
        bottom = top + height
        parts = []
        grid = ""
        for t in self.x.marks():
            p = left + float(self.x(t)) * width
            grid += f"M{p:.1f} {top}V{bottom}"
            parts.append(_text(p, bottom + 15, number(t), "middle", "tick"))
        for t in self.y.marks(5):
            p = bottom - float(self.y(t)) * height
            grid += f"M{left} {p:.1f}H{left + width}"
            parts.append(_text(left - 6, p + 4, number(t), "end", "tick"))
        frame = f'<path class="grid" d="{grid}"/><path class="axis" d="M{left} {top}V{bottom}H{left + width}"/>'
        if self.x_label:
            parts.append(_text(left + width / 2, bottom + 34, self.x_label, "middle", "label"))
        if self.y_label:
            middle = top + height / 2
            parts.append(
                f'<text class="label" text-anchor="middle" transform="translate(12 {middle:.1f}) rotate(-90)">{_attribute(self.y_label)}</text>'
            )
        return [frame, *parts]


def _attribute(words: str) -> str:
    return words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def _text(x: float, y: float, words: str, anchor: str, kind: str) -> str:
    return f'<text class="{kind}" x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{_attribute(words)}</text>'
