"""A fitted map as a page to look at: every parameter at up to six times, its standard error, the residual, how the fits ended."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import channels_to_srgb, data_uri, png, sequential, srgb_encode
from motes.drawing.markup import Html, table, tag
from motes.drawing.svg import number
from motes.files import replacing, together, write_text
from motes.maps.comparison import quartiles
from motes.maps.fitted import FittedMap
from motes.maps.layout import FLAGS, NOT_FITTED, VERDICT_FLAGS, worst
from motes.measurements.origin import not_measured
from motes.report.document import document
from motes.report.figures import color_bar, figure
from motes.report.findings import percent
from motes.version import __version__

Pixels = NDArray[np.uint8]

LARGEST = 320  # pixels along the longer side of a picture
SHOWN_TIMES = 6
BLANK = (128, 128, 128)  # where there is no fit
STATUS_COLORS = {
    "converged": (38, 130, 142),
    "max_iterations": (240, 180, 40),
    "no_data": (90, 90, 90),
    "failed": (200, 40, 40),
}
VERDICT_COLORS = {
    "identified": (38, 130, 142),
    "weak": (240, 180, 40),
    "unidentifiable": (200, 40, 40),
    "at_lower": (86, 108, 196),
    "at_upper": (150, 84, 168),
}


class Strip(NamedTuple):
    """A parameter's pictures over time, the words that go with them, and the ends of its colour scale (None for colours)."""

    name: str
    meaning: str
    titles: tuple[str, ...]
    pictures: tuple[Pixels, ...]
    scale: tuple[float, float] | None


def write_map_page(fitted: FittedMap, path: str | os.PathLike[str]) -> Path:
    """Write a fitted map as one self-contained HTML page, and its pictures side by side as a PNG beside it.

    Parameters
    ----------
    fitted
        From `motes.maps.fit_map`; it may be unfinished.
    path
        The HTML file; the PNG has the same name with ``.png``.

    Returns
    -------
    Path

    Raises
    ------
    MotesError
        When a file cannot be written.

    Notes
    -----
    Maps are thinned to every n-th texel, so that the page stays small however large they are.
    """
    target = Path(path)
    strips = parameter_strips(fitted)
    sheet, page = png(contact_sheet([s.pictures for s in strips])), _page(fitted, strips)
    with together(target.parent) as staging:
        with replacing(staging / target.with_suffix(".png").name) as temporary:
            temporary.write_bytes(sheet)
        write_text(staging / target.name, page)
    return target


def parameter_strips(fitted: FittedMap) -> list[Strip]:
    """The parameters over time, or with trends what they are made of as well; per-channel ones in their own colours."""
    where = _thinned(fitted)
    slots = {slot.name: slot.parameter for slot in fitted.brdf.slots()}
    shown, titles = _shown_times(fitted)
    strips = []
    for quantity in fitted.quantities:
        values = fitted.values(quantity, where)
        doc = slots[quantity].doc + (f" [{slots[quantity].unit}]" if slots[quantity].unit else "")
        strips.append(_strip(quantity, doc, values[:, :, shown], titles, fitted))
    if fitted.joint:
        for v in fitted.variables.values():
            if v.unit == "h":
                strips.append(_strip(v.name, f"{v.doc} [h]", fitted.read_map(v.name, where)[:, :, None], ("",), fitted))
    return strips


def _shown_times(fitted: FittedMap) -> tuple[list[int], tuple[str, ...]]:
    """The times that pictures are of, and their titles."""
    n = len(fitted.hours)
    shown = sorted({int(k) for k in np.linspace(0, n - 1, min(n, SHOWN_TIMES)).round()})
    return shown, tuple(f"{fitted.hours[k]:.4g} h" for k in shown) if n > 1 else ("",)


def contact_sheet(rows: list[tuple[Pixels, ...]], gap: int = 4) -> Pixels:
    """Rows of pictures of one size on white."""
    height, width = rows[0][0].shape[:2]
    columns = max(len(row) for row in rows)
    sheet = np.full((len(rows) * (height + gap) + gap, columns * (width + gap) + gap, 3), 255, np.uint8)
    for r, row in enumerate(rows):
        for c, picture in enumerate(row):
            y, x = gap + r * (height + gap), gap + c * (width + gap)
            sheet[y : y + height, x : x + width] = picture
    return sheet


def _thinned(fitted: FittedMap) -> tuple[slice, slice]:
    step = max(1, -(-max(fitted.shape) // LARGEST))
    return slice(None, None, step), slice(None, None, step)


def _strip(name: str, doc: str, values: Any, titles: tuple[str, ...], fitted: FittedMap) -> Strip:
    """Pictures of values (y, x, T[, C]); colours are scaled so that the brightest hundredth is just not clipped."""
    finite = values[np.isfinite(values)]
    if values.ndim == 4 and values.shape[-1] > 1:
        color = channels_to_srgb(fitted.channels)
        top = float(np.quantile(finite, 0.99)) if finite.size else 1.0
        linear = values / max(top, 1e-12) @ color.matrix
        pictures = [_blank(srgb_encode(linear[:, :, k]), values[:, :, k]) for k in range(values.shape[2])]
        return Strip(name, f"{doc}; {color.meaning}, {top:.3g} is full brightness", titles, tuple(pictures), None)
    values = values[..., 0] if values.ndim == 4 else values
    low, high = (float(q) for q in np.quantile(finite, (0.01, 0.99))) if finite.size else (0.0, 1.0)
    if high - low < 1e-9 + 1e-6 * abs(high):
        low, high = low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1)
    scaled = (values - low) / (high - low)
    pictures = [_blank(sequential(np.nan_to_num(scaled[:, :, k])), values[:, :, k]) for k in range(values.shape[2])]
    return Strip(name, doc, titles, tuple(pictures), (low, high))


def _blank(picture: Pixels, values: Any) -> Pixels:
    """Grey where there is no value."""
    missing = ~np.isfinite(values if values.ndim == 2 else values.sum(-1))
    picture = picture.copy()
    picture[missing] = BLANK
    return picture


def _image(picture: Pixels, title: str, alt: str) -> Html:
    return tag("div", tag("img", src=data_uri(png(picture)), alt=alt, style="image-rendering:pixelated"), title)


def _figure(strip: Strip) -> Html:
    panels = [_image(p, t, f"{strip.name} {t}".strip()) for p, t in zip(strip.pictures, strip.titles, strict=True)]
    bar = None
    if strip.scale is not None:
        ramp = sequential(np.linspace(0, 1, 10))
        bar = color_bar(
            number(float(f"{strip.scale[0]:.3g}")), number(float(f"{strip.scale[1]:.3g}")), ramp, strip.name
        )
    return figure(panels, strip.meaning, bar, kind="strip")


def _page(fitted: FittedMap, strips: list[Strip]) -> str:
    done, where = fitted.done(), _thinned(fitted)
    counts = fitted.counts()
    step = where[0].step or 1
    size = f"{fitted.shape[1]} x {fitted.shape[0]} texels"
    times = f"{len(fitted.hours)} times" if len(fitted.hours) > 1 else "one time"
    how = "fitted together as trends" if fitted.joint else "each fitted alone" if len(fitted.hours) > 1 else ""
    parts = [
        tag("h1", fitted.name),
        tag("p", tag("code", fitted.model), class_="model"),
        tag("p", ", ".join(w for w in (size, times, how) if w) + ".", class_="lead"),
    ]
    if said := not_measured({"source": fitted.origin}):
        parts.append(tag("p", said))
    if not done.all():
        text = f"Only {int(done.sum())} of {done.size} blocks are done; what is missing is grey."
        parts.append(tag("p", tag("strong", text)))
    if step > 1:
        parts.append(tag("p", f"Pictures show every {step}th texel of rows and columns.", class_="note"))
    parts += [tag("h2", "Parameters"), *(part for s in strips for part in (tag("h3", s.name), _figure(s)))]
    rows = [
        (tag("code", name), *(tag("td", f"{x:.4g}", class_="number") for x in numbers))
        for name, numbers in quartiles(fitted).items()
    ]
    heads = ("map", "lower quarter", "median", "upper quarter", "standard error (median)")
    parts += [tag("h2", "Numbers"), table(heads, rows)]
    parts += _tried(fitted)
    parts += [
        tag("h2", "How sure"),
        *_verdicts(fitted, where),
        *_errors(fitted, where),
        *_status(fitted, where, counts),
    ]
    parts.append(tag("footer", f"Motes {__version__}. Fitted from {fitted.plan.settings.source}."))
    return document(f"{fitted.name}: {fitted.model}", *parts)


def _tried(fitted: FittedMap) -> list[Html]:
    """The models that were compared."""
    tried = fitted.plan.tried
    if not tried:
        return []
    best = min(t.bic for t in tried)
    rows = [
        (
            tag("td", tag("code", t.model), tag("span", " ✓ chosen", class_="verdict good") if t.chosen else None),
            tag("td", str(t.n_parameters), class_="number"),
            tag("td", percent(t.relative_rms), class_="number"),
            tag("td", f"+{t.bic - best:,.1f}" if t.bic > best else "0", class_="number"),
        )
        for t in tried
    ]
    note = "BIC, summed over some texels from all over the map, weighs closeness against the number of parameters; the smallest is chosen."
    heads = ("model", "free parameters", "relative RMS", "BIC above the best")
    return [tag("h2", "Models tried"), table(heads, rows), tag("p", note, class_="note")]


def _errors(fitted: FittedMap, where: tuple[slice, slice]) -> list[Html]:
    """Relative residuals, and standard errors at the middle time."""
    rms = fitted.read_map("relative_rms", where)
    rms = rms if rms.ndim == 3 else rms[:, :, None]
    middle = rms.shape[2] // 2
    pictures = [_strip("relative residual", "", rms[:, :, middle, None], ("relative residual",), fitted)]
    for v in fitted.variables.values():
        errors = fitted.read_map(f"{v.name}_stderr", where)
        if v.per_channel:
            errors = errors.mean(axis=-1)
        errors = errors if errors.ndim == 3 else errors[:, :, None]
        middle = errors.shape[2] // 2
        pictures.append(_strip(v.name, "", errors[:, :, middle, None], (v.name,), fitted))
    panels = []
    for strip in pictures:
        assert strip.scale is not None
        title = f"{strip.titles[0]}: {strip.scale[0]:.2g} to {strip.scale[1]:.2g}"
        panels.append(_image(strip.pictures[0], title, strip.name))
    at = "" if fitted.joint or len(fitted.hours) == 1 else f" at {fitted.hours[len(fitted.hours) // 2]:.4g} h"
    ramp = color_bar("low", "high", sequential(np.linspace(0, 1, 10)), "")
    return [
        figure(panels, f"The residual over the data, and standard errors of the parameters{at}.", ramp, kind="strip")
    ]


def _verdicts(fitted: FittedMap, where: tuple[slice, slice]) -> list[Html]:
    """What the data determine: a sentence on the maps that they determine everywhere, pictures of the others."""
    counts = fitted.verdict_counts()
    if not counts:
        return []
    told = {name: {word: n for word, n in c.items() if n and word != "not_fitted"} for name, c in counts.items()}
    whole = [name for name, found in told.items() if set(found) == {"identified"}]
    parts = []
    if whole:
        parts.append(tag("p", f"The data determine every value of {', '.join(whole)}."))
    shown, titles = _shown_times(fitted)
    for name, found in told.items():
        if not found or name in whole:
            continue
        codes = fitted.verdicts(name, where)
        over_time = codes.reshape(*codes.shape[:2], 1 if fitted.joint else len(fitted.hours), -1)
        codes = worst(over_time)[:, :, [0] if fitted.joint else shown]
        pictures = [_colored(codes[:, :, k], VERDICT_COLORS, VERDICT_FLAGS) for k in range(codes.shape[2])]
        own = ("",) if fitted.joint else titles
        panels = [_image(p, t, f"verdict on {name} {t}".strip()) for p, t in zip(pictures, own, strict=True)]
        total = sum(found.values())
        shares = {word: percent(n / total) for word, n in found.items()}
        several = ", of its channels the worst" if over_time.shape[-1] > 1 else ""
        words = f"What the data say about {name}{several}; grey where there is no fit."
        parts.append(tag("h3", tag("code", name), f": determined in {shares.get('identified', '0 %')} of its values"))
        parts.append(figure(panels, words, _key(VERDICT_COLORS, shares), kind="strip"))
    return parts


def _colored(codes: Any, colors: dict[str, tuple[int, int, int]], flags: dict[str, int]) -> Pixels:
    """A picture of codes (y, x), grey for those without a colour."""
    picture = np.full((*codes.shape, 3), BLANK, np.uint8)
    for name, color in colors.items():
        picture[codes == flags[name]] = color
    return picture


def _key(colors: dict[str, tuple[int, int, int]], told: dict[str, str]) -> Html:
    """What colours mean, and what is told of each; those of which nothing is told are left out."""
    marks = (
        tag(
            "span",
            tag("i", class_="mark dot", style=f"background:rgb{colors[name]}"),
            f"{name.replace('_', ' ')}: {text}",
        )
        for name, text in told.items()
    )
    return tag("p", *marks, class_="key")


def _status(fitted: FittedMap, where: tuple[slice, slice], counts: dict[str, int]) -> list[Html]:
    status = fitted.read_map("status", where)
    ended = status if status.ndim == 2 else np.where(status == NOT_FITTED, 0, status).max(axis=2)
    picture = _colored(ended, STATUS_COLORS, FLAGS)
    if status.ndim == 3:
        picture[(status == NOT_FITTED).all(axis=2)] = BLANK
    keys = _key(STATUS_COLORS, {name: f"{counts[name]:,}" for name in STATUS_COLORS})
    words = "How fits ended; where times ended differently, the worst. Grey: not fitted yet."
    return [figure([_image(picture, "", "status")], words, keys, kind="strip")]
