"""The figures of a report: each takes a fit and its samples, and gives HTML (panels, key, caption)."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes import directions, equations
from motes.arrays import NUMPY
from motes.fitting.result import Fit
from motes.models import BRDF, TorranceSparrow, describe
from motes.models.sums import Sum
from motes.report.color import Floats, diverging, hex_color, sequential
from motes.report.markup import Html, join, tag
from motes.report.slices import MOST_DOTS, NearMirror, Samples, Slice, Slices, binned, grows, incidence_groups
from motes.report.sphere import evaluate
from motes.report.svg import Panel, Scale, number

# Enough samples for every cell of the maps over the hemisphere.
MOST_CELLS = 200_000
# The Okabe-Ito colours that are dark enough for lines, as custom properties of the page.
PALETTE = ("--blue", "--vermilion", "--green", "--purple")
RGB_COLORS = {"r": "--vermilion", "g": "--green", "b": "--blue"}
DEGREES = tuple(range(-90, 91, 30))


class Shown(NamedTuple):
    """A channel that is drawn: its index, its name (out of the file), its colour."""

    index: int
    name: str
    color: str


def shown_channels(fit: Fit) -> list[Shown]:
    """All channels up to four; of spectra those nearest to 450, 550 and 650 nm; else the first, the middle and the last.  Channels without data are left out."""
    data = fit.measurement
    usable = [c for c in range(data.n_channels) if data.mask[0, :, c].any()]
    names = data.channels
    if len(usable) <= 4:
        colors = [RGB_COLORS.get(names[c][:1].lower()) if data.n_channels == 3 else None for c in usable]
        if None in colors or len(set(colors)) < len(colors):
            colors = list(PALETTE[: len(usable)])
        return [Shown(c, names[c], str(color)) for c, color in zip(usable, colors, strict=True)]
    picks = [usable[0], usable[len(usable) // 2], usable[-1]]
    if data.wavelengths is not None:
        nearest = [usable[int(np.argmin(np.abs(data.wavelengths[usable] - nm)))] for nm in (450, 550, 650)]
        picks = nearest if len(set(nearest)) == 3 else picks
    return [Shown(c, names[c], color) for c, color in zip(picks, ("--blue", "--green", "--vermilion"), strict=True)]


# ---------------------------------------------------------------- HTML around the panels


def figure(panels: Iterable[Html], caption: object, key: object = None, *, kind: str = "panels") -> Html:
    """Panels side by side as the page is wide, a key above, a caption below."""
    grid = tag("div", *panels, class_=kind)
    return tag("figure", key, grid, tag("figcaption", caption))


def key(entries: Sequence[tuple[str, str, str]]) -> Html:
    """Legend entries (mark, colour, words): marks are line, dashed, dotted, dot, bar."""
    return tag("p", *(tag("span", tag("i", class_=f"mark {mark}", style=f"--c:var({color})"), words) for mark, color, words in entries), class_="key")


def color_bar(low: str, high: str, ramp: NDArray[np.uint8], words: str) -> Html:
    """A colour scale with its ends named."""
    stops = ",".join(hex_color(c) for c in ramp)
    return tag(
        "p",
        tag("span", words),
        tag("span", low),
        tag("i", class_="ramp", style=f"background:linear-gradient(90deg,{stops})"),
        tag("span", high),
        class_="key",
    )


def _channel_key(channels: Sequence[Shown], more: Sequence[tuple[str, str, str]] = ()) -> Html:
    if len(channels) == 1:
        color = channels[0].color
        return key([("dot", color, "measured"), ("line", color, "fitted"), *more])
    names = [("line", c.color, c.name) for c in channels]
    return key([*names, ("dot", "--muted", "measured"), ("line", "--muted", "fitted"), *more])


# ---------------------------------------------------------------- curves of the fitted BRDF


def plane_curve(brdf: BRDF, theta_i: float, theta_r: Floats, n_channels: int, *, across: bool = False) -> Floats:
    """The BRDF (n, C) along a plane through the normal; theta_r signed, positive on the side of the mirror direction."""
    wi = directions.from_spherical(theta_i, 0.0)
    wo = directions.from_spherical(np.abs(theta_r), np.where(np.asarray(theta_r) >= 0, np.pi, 0.0) + (np.pi / 2 if across else 0.0))
    value = evaluate(brdf, np.broadcast_to(wi, wo.shape), wo)
    return np.broadcast_to(value, (len(value), n_channels))


def parts(brdf: BRDF) -> list[BRDF]:
    """The terms of a sum."""
    return [*parts(brdf.a), *parts(brdf.b)] if isinstance(brdf, Sum) else [brdf]


# ---------------------------------------------------------------- figures


def slices_figure(fit: Fit, slices: Slices, channels: Sequence[Shown], value_scale: Scale) -> Html:
    """Measured dots and fitted curves along a plane at several angles of incidence, all on one scale."""
    across = slices.panels[0].across
    panels = [_slice_panel(fit, s, channels, value_scale) for s in slices.panels]
    where = "at right angles to the plane of incidence" if across else "in the plane of incidence"
    exact = np.degrees([slices.off_plane, slices.off_angle])
    caption = (
        f"BRDF {where}, one angle of incidence a panel, all on the same {'logarithmic ' if value_scale.log else ''}scale. "
        + ("" if across else "Negative θᵣ is the side of the light, positive the side of the mirror direction (dotted line). ")
        + f"Dots are samples within {exact[0]:.2g}° of the plane and {exact[1]:.2g}° of θᵢ; curves are the fit exactly in the plane; "
        "the stroke at a dot ends at the fit for that very sample."
    )
    return figure(panels, caption, _channel_key(channels))


def slice_scale(fit: Fit, all_slices: Sequence[Slices], channels: Sequence[Shown]) -> Scale:
    """One scale for all slices: from zero, or logarithmic where the values span more than a factor of 30."""
    index = [c.index for c in channels]
    values = np.concatenate([s.samples.measured[:, index].ravel() for group in all_slices for s in group.panels] or [np.ones(1)])
    positive = values[np.isfinite(values) & (values > 0)]
    if not positive.size:
        return Scale(0.0, 1.0)
    low, high = np.percentile(positive, 2), positive.max()
    if high / low > 30:
        return Scale.around([low * 0.7, high], log=True)
    curves = [np.nanmax(s.samples.fitted[:, index]) for group in all_slices for s in group.panels]
    return Scale.around([high, min(max(curves), 1.5 * high)], zero=True)


def _slice_panel(fit: Fit, part: Slice, channels: Sequence[Shown], value_scale: Scale) -> Html:
    x = Scale(0 if part.across else -90, 90, ticks=DEGREES)
    panel = Panel(x, value_scale, part.title, "θᵣ [°]", "f [1/sr]")
    mirror = np.degrees(part.theta_i)
    if not part.across and mirror > 1:
        panel.line([mirror, mirror], [value_scale.low, value_scale.high], "--muted", "guide")
    theta_r = np.deg2rad(np.linspace(0 if part.across else -89, 89, 90 if part.across else 268))
    if not part.across and mirror > 0.5:  # a narrow highlight needs closer steps
        theta_r = np.sort(np.concatenate([theta_r, part.theta_i + np.deg2rad(np.linspace(-4, 4, 81))]))
        theta_r = theta_r[theta_r < np.deg2rad(89.5)]
    curve = plane_curve(fit.brdf, part.theta_i, theta_r, fit.measurement.n_channels, across=part.across)
    at = np.degrees(part.theta_r)
    for c in channels:
        panel.line(np.degrees(theta_r), curve[:, c.index], c.color)
    for c in channels:
        panel.whiskers(at, part.samples.measured[:, c.index], part.samples.fitted[:, c.index], c.color)
        panel.dots(at, part.samples.measured[:, c.index], c.color, 5 if len(at) < 60 else 3.5)
    count = int(np.isfinite(part.samples.measured[:, [c.index for c in channels]]).sum())
    return panel.svg(f"BRDF against angle of reflection at {part.title}: {count} measured samples and the fitted curve")


def mirror_figure(fit: Fit, near: NearMirror, channels: Sequence[Shown]) -> Html:
    """How high the highlight is, measured and fitted, as the light grazes; and their ratio, where a missing Fresnel term shows."""
    degrees = np.degrees(near.theta_i)
    index = [c.index for c in channels]
    x = Scale(0, 90, ticks=DEGREES)
    both = np.concatenate([near.measured[:, index], near.fitted[:, index]])
    positive = both[both > 0]
    spans = positive.size > 0 and positive.max() > 10 * positive.min()
    peak = Panel(x, Scale.around(both, log=spans, zero=not spans), "Height of the highlight", "θᵢ [°]", "f near mirror [1/sr]")
    for c in channels:
        peak.line(degrees, near.fitted[:, c.index], c.color)
        peak.dots(degrees, near.measured[:, c.index], c.color, 6)
    good = (near.measured > 0) & (near.fitted > 0)
    ratio = np.where(good, near.measured, np.nan) / np.where(good, near.fitted, 1)
    shown = ratio[:, index]
    finite = shown[np.isfinite(shown)]
    lowest, highest = (float(finite.min()), float(finite.max())) if finite.size else (1.0, 1.0)
    rise = Panel(x, Scale.ratios(lowest, highest), "Measured over fitted", "θᵢ [°]", "ratio")
    rise.line([0, 90], [1, 1], "--ink", "guide")
    entries: list[tuple[str, str, str]] = []
    if grows(near) and _without_fresnel(fit.brdf):
        theta = np.linspace(0, np.deg2rad(89.5), 90)
        F = np.asarray(equations.fresnel_dielectric(NUMPY, np.cos(theta), 1.5))
        at = np.asarray(equations.fresnel_dielectric(NUMPY, np.cos(near.theta_i), 1.5))
        offset = np.nanmean(np.log(shown / at[:, None]))
        rise.line(np.degrees(theta), F * np.exp(offset), "--muted", "dashed")
        entries.append(("dashed", "--muted", "shape of the Fresnel term of a dielectric, n = 1.5, moved up or down to the dots"))
    if np.isfinite(near.elsewhere).any():
        rise.line(degrees, near.elsewhere, "--muted", "dotted")
        entries.append(("dotted", "--muted", "median ratio more than 45° from the mirror direction"))
    for c in channels:
        rise.line(degrees, ratio[:, c.index], c.color, "thin")
        rise.dots(degrees, ratio[:, c.index], c.color, 6)
    furthest = max(0.1, float(np.degrees(near.from_mirror.max())))
    caption = (
        f"For each angle of incidence the sample nearest to the mirror direction, at most {furthest:.2g}° from it. "
        "A fit that follows the highlight stays at ratio 1; a ratio that rises with θᵢ is reflectance that grows towards grazing faster than the model"
        + (", as the Fresnel term does: fresnel=dielectric adds it." if entries and entries[0][0] == "dashed" else ".")
    )
    return figure(
        [
            peak.svg("Measured and fitted BRDF near the mirror direction against angle of incidence"),
            rise.svg(f"Ratio of measured to fitted BRDF near the mirror direction, from {lowest:.2g} to {highest:.2g}, against angle of incidence"),
        ],
        caption,
        _channel_key(channels, entries),
    )


def _without_fresnel(brdf: BRDF) -> bool:
    lobes = [part for part in _tree(brdf) if isinstance(part, TorranceSparrow)]
    return bool(lobes) and all(lobe.fresnel is None for lobe in lobes)


def _tree(part: object) -> list[object]:
    children = part.children().values() if hasattr(part, "children") else ()
    return [part, *(x for child in children for x in _tree(child))]


def agreement_figure(samples: Samples, channels: Sequence[Shown]) -> Html:
    """Measured against fitted on logarithmic axes; their ratio against both polar angles."""
    some = samples.thinned()
    index = [c.index for c in channels]
    scale = Scale.around(*_cut(some.measured[:, index], some.fitted[:, index]), log=True)
    scatter = Panel(scale, scale, "Measured against fitted", "fitted f [1/sr]", "measured f [1/sr]")
    dense = len(some) * len(index) > MOST_DOTS
    if dense:
        scatter.picture(_density(some, index, scale), (scale.low, scale.high), (scale.low, scale.high))
    scatter.line([scale.low, scale.high], [scale.low, scale.high], "--ink", "guide")
    if not dense:
        for c in channels:
            scatter.dots(some.fitted[:, c.index], some.measured[:, c.index], c.color, 3.5 if len(some) < 500 else 2.4)
    ratio = some.ratio[:, index]
    finite = ratio[np.isfinite(ratio)]
    low, high = np.percentile(finite, (3, 97)) if finite.size else (0.5, 2.0)
    ratio_scale = Scale.ratios(max(float(low), 0.04), min(float(high), 25))
    panels = [scatter.svg("Measured against fitted BRDF, logarithmic axes, with the line of equality")]
    for theta, label, words in ((some.theta_i, "θᵢ [°]", "incidence"), (some.theta_r, "θᵣ [°]", "reflection")):
        panel = Panel(Scale(0, 90, ticks=DEGREES), ratio_scale, f"Ratio against angle of {words}", label, "measured / fitted")
        panel.line([0, 90], [1, 1], "--ink", "guide")
        for k, c in enumerate(channels):
            middle, quantiles = binned(np.degrees(theta), ratio[:, k], np.linspace(0, 90, 13))
            filled = np.isfinite(quantiles[1])
            panel.band(middle[filled], quantiles[0, filled], quantiles[2, filled], c.color)
            panel.line(middle[filled], quantiles[1, filled], c.color)
            panel.dots(middle[filled], quantiles[1, filled], c.color, 4.5)
        panels.append(panel.svg(f"Median ratio of measured to fitted BRDF against angle of {words}, with the middle 68 %"))
    thinned = f" Drawn from {len(some):,} of {len(samples):,} directions, chosen evenly at random (seed 0)." if len(some) < len(samples) else ""
    gaps = int(np.isfinite(some.measured[:, index]).sum() - finite.size)
    missing = f" {gaps:,} values that are 0 or less, measured or fitted, have no place on a logarithmic axis." if gaps else ""
    caption = (
        "Left: every sample; on the line the fit is exact. "
        + ("Brighter cells hold more samples. " if dense else "")
        + "Middle and right: median and middle 68 % of the ratio in steps of 7.5°; above 1 the surface is brighter than the fit." + thinned + missing
    )
    entries = [("line", c.color, c.name if len(channels) > 1 else "median") for c in channels]
    return figure(panels, caption, key([*entries, ("bar", channels[0].color if len(channels) == 1 else "--muted", "middle 68 %")]))


def _cut(*arrays: Floats) -> list[Floats]:
    """Values without the far lower tail, which would take most of a logarithmic axis."""
    everything = np.concatenate([a.ravel() for a in arrays])
    positive = everything[np.isfinite(everything) & (everything > 0)]
    if not positive.size:
        return [everything]
    low, high = np.percentile(positive, 1), positive.max()
    return [np.array([max(low, high * 1e-6), high])]


def _density(samples: Samples, index: Sequence[int], scale: Scale) -> NDArray[np.uint8]:
    """Counts of (fitted, measured) on a grid, coloured by their logarithm; empty cells are transparent."""
    n = 110
    x, y = scale(samples.fitted[:, index]).ravel(), scale(samples.measured[:, index]).ravel()
    inside = (x >= 0) & (x < 1) & (y >= 0) & (y < 1)
    cells = (n - 1 - (y[inside] * n).astype(int)) * n + (x[inside] * n).astype(int)
    counts = np.bincount(cells, minlength=n * n).reshape(n, n)
    shade = np.log1p(counts) / max(np.log1p(counts.max()), 1e-9)
    return np.concatenate([sequential(shade), np.where(counts > 0, 255, 0).astype(np.uint8)[..., None]], -1)


def residual_figure(samples: Samples) -> Html:
    """Where over the hemisphere the fit is too bright (red) or too dark (blue), one disc for each angle of incidence.

    Differences as a share of RMS(measured); where the measurement spans decades, in which case the highlight takes that scale for itself, ratios too.
    """
    samples = samples.thinned(MOST_CELLS)
    usable = np.isfinite(samples.measured)
    rms = float(np.sqrt(np.mean(samples.measured[usable] ** 2))) or 1.0
    mean = np.nansum(np.where(usable, samples.fitted - samples.measured, 0), axis=1) / np.maximum(usable.sum(1), 1)
    positive = samples.measured[usable & (samples.measured > 0)]
    maps = [_discs(samples, mean / rms, "difference")]
    if positive.size and np.percentile(positive, 99) > 30 * np.median(positive):
        low, high = np.percentile(positive, 0.5), positive.max()
        sums = [np.nansum(np.clip(a, low, high), 1) for a in (samples.fitted, samples.measured)]  # a floor, so that noise at 0 makes no infinities
        maps.append(_discs(samples, np.log2(sums[0] / np.maximum(sums[1], low)), "ratio"))
    one_sided = _one_sided(samples)
    caption = (
        "The hemisphere of viewing directions seen from above; the distance from the middle is θᵣ (circles at 30°, 60°, 90°), the light comes from the left "
        "(triangle), the mirror direction is the cross. Blue: the fit is too dark; red: too bright. "
        + ("Channels are averaged. " if samples.measured.shape[1] > 1 else "")
        + ("The data hold one side of the plane of incidence, mirrored here. " if one_sided else "")
        + " ".join(words for _, _, words in maps)
    )
    return tag("figure", *(join(bar, panels) for bar, panels, _ in maps), tag("figcaption", caption))


def _discs(samples: Samples, value: Floats, kind: str) -> tuple[Html, Html, str]:
    """The colour scale, the discs, and what the caption has to add."""
    limit = float(f"{np.percentile(np.abs(value), 98) or 1.0:.1g}")
    if kind == "difference":
        ends, words = (f"−{100 * limit:g} %", f"+{100 * limit:g} %"), "fitted − measured, as a share of RMS(measured); white is 0:"
    else:
        limit = min(max(limit, 0.5), 5.0)
        ends, words = (f"1/{2**limit:.2g}", f"{2**limit:.2g}"), "fitted / measured, logarithmic; white is 1:"
    groups = incidence_groups(samples.theta_i)
    if kind == "ratio" and len(groups) > 4:
        groups = [groups[k] for k in np.linspace(0, len(groups) - 1, 4).round().astype(int)]
    panels = [_disc(theta_i, samples.take(which), value[which] / limit, _one_sided(samples)) for theta_i, which in groups]
    beyond = float(np.mean(np.abs(value) > limit))
    name = "difference" if kind == "difference" else "ratio"
    more = f"{100 * beyond:.1f} % of the samples lie beyond the scale of the {name}." if beyond >= 5e-4 else ""
    return color_bar(*ends, diverging(np.linspace(-1, 1, 11)), words), tag("div", *panels, class_="panels discs"), more


def _one_sided(samples: Samples) -> bool:
    side = np.sin(samples.dphi)
    return len(samples) > 1 and bool(np.all(side >= -1e-6) or np.all(side <= 1e-6))


def _disc(theta_i: float, samples: Samples, value: Floats, one_sided: bool) -> Html:
    edge = 97.0
    scale = Scale(-edge, edge)
    size = 260
    panel = Panel(scale, Scale(-edge, edge + 14), f"θᵢ = {np.degrees(theta_i):.3g}°", width=size, height=round(size * (2 * edge + 14) / (2 * edge)), axes=False)
    circle = np.linspace(0, 2 * np.pi, 91)
    r = np.degrees(samples.theta_r)
    x, y = -r * np.cos(samples.dphi), r * np.sin(samples.dphi)  # the light (dphi = 0) on the left
    if one_sided:
        x, y, value = np.r_[x, x], np.r_[y, -y], np.r_[value, value]
    panel.line(90 * np.cos(circle), 90 * np.sin(circle), "--disc", "fill")
    for radius in (30, 60, 90):
        panel.line(radius * np.cos(circle), radius * np.sin(circle), "--muted", "guide")
    if len(value) > 1500:
        panel.picture(_averaged(x, y, value), (-90, 90), (-90, 90))
    else:
        step = np.clip(np.round(value * 8), -8, 8).astype(int)
        diameter = float(np.clip(150 / np.sqrt(max(len(value), 1)), 5, 13))
        for s in np.unique(step):
            which = step == s
            panel.dots(x[which], y[which], hex_color(diverging(s / 8)), diameter)
    mirror = np.degrees(theta_i)
    panel.line([mirror - 4, mirror + 4], [-4, 4], "--ink", "ring")
    panel.line([mirror - 4, mirror + 4], [4, -4], "--ink", "ring")
    panel.line([-mirror - 4, -mirror + 3, -mirror - 4, -mirror - 4], [-4, 0, 4, -4], "--ink", "ring")
    return panel.svg(f"Residuals over the hemisphere at an angle of incidence of {np.degrees(theta_i):.3g} degrees")


def _averaged(x: Floats, y: Floats, value: Floats) -> NDArray[np.uint8]:
    n = 72
    column, row = ((x + 90) / 180 * n).astype(int).clip(0, n - 1), ((90 - y) / 180 * n).astype(int).clip(0, n - 1)
    cell = row * n + column
    counts = np.bincount(cell, minlength=n * n).reshape(n, n)
    mean = np.bincount(cell, value, minlength=n * n).reshape(n, n) / np.maximum(counts, 1)
    return np.concatenate([diverging(mean), np.where(counts > 0, 255, 0).astype(np.uint8)[..., None]], -1)


def lobes_figure(fit: Fit, channels: Sequence[Shown]) -> Html:
    """f cos(theta_r) in the plane of incidence as a polar plot, for three angles of incidence on one radial scale."""
    theta_r = np.deg2rad(np.linspace(-89.9, 89.9, 360))
    incidences = np.deg2rad((15, 45, 75))
    n = fit.measurement.n_channels
    terms = parts(fit.brdf) if len(channels) == 1 else []
    grids = [np.sort(np.r_[theta_r, t + np.deg2rad(np.linspace(-4, 4, 81))]) for t in incidences]
    curves = [plane_curve(fit.brdf, t, g, n) * np.cos(g)[:, None] for t, g in zip(incidences, grids, strict=True)]
    index = [c.index for c in channels]
    shown = np.concatenate([c[:, index] for c in curves])
    top, typical = float(shown.max()), float(np.median(shown))
    if not (np.isfinite(top) and top > 0):
        return tag("p", "The fitted BRDF is 0 or not a number in the plane of incidence: there is no lobe to draw.", class_="note")
    power = 1.0 if top <= 8 * max(typical, 1e-12) else 1 / 3
    panels = [_lobe(t, g, c, channels, terms, top, power) for t, g, c in zip(incidences, grids, curves, strict=True)]
    entries = [("line", c.color, c.name if len(channels) > 1 else "f cos θᵣ") for c in channels]
    if len(terms) > 1:
        entries += [(kind, "--muted", describe(term)) for kind, term in zip(("dashed", "dotted"), terms, strict=False)]
    caption = (
        "f cos θᵣ [1/sr] in the plane of incidence as distance from the point of incidence, the light coming along the arrow; a Lambertian surface gives a circle. "
        f"All panels share the rings{', which are spaced as the cube root so that the diffuse part stays visible beside the highlight' if power < 1 else ''}."
    )
    return figure(panels, caption, key(entries))


def _rings(reach: float, power: float) -> list[float]:
    """Values of the rings: evenly spaced, or decades where lengths are cube roots; none so near another that labels touch."""
    if power == 1:
        return Scale(0, reach).marks(4)[1:]
    decade = np.floor(np.log10(reach))
    rings = [float(10 ** (decade - k)) for k in (2, 1, 0)] + ([5 * 10.0**decade] if reach > 5 * 10**decade else [])
    return [r for k, r in enumerate(rings) if r**power > 0.2 * reach**power or k == len(rings) - 1]


def _lobe(
    theta_i: float,
    theta_r: Floats,
    curve: Floats,
    channels: Sequence[Shown],
    terms: Sequence[BRDF],
    reach: float,
    power: float,
) -> Html:
    """One half disc; `reach` is the largest value of all panels, `power` what values are raised to before they become lengths."""
    outer = reach**power
    width, height = 340, 215
    edge = outer * 1.12
    panel = Panel(Scale(-edge, edge), Scale(-0.12 * edge, 2 * edge * height / width - 0.12 * edge), f"θᵢ = {np.degrees(theta_i):.0f}°", width=width, height=height, axes=False)
    half = np.linspace(-np.pi / 2, np.pi / 2, 61)
    panel.line([-edge, edge], [0, 0], "--ink", "axis")
    for value in _rings(reach, power):
        r = value**power
        panel.line(r * np.sin(half), r * np.cos(half), "--grid", "ring")
        panel.text(r, 0, number(value), kind="tick", shift=(0, 14))
    towards = np.array([-np.sin(theta_i), np.cos(theta_i)])
    side = np.array([towards[1], -towards[0]])
    tip, back = 0.03 * outer * towards, 0.11 * outer * towards
    head = np.array([back + 0.03 * outer * side, tip, back - 0.03 * outer * side])
    panel.line([1.06 * outer * towards[0], tip[0]], [1.06 * outer * towards[1], tip[1]], "--muted", "arrow")
    panel.line(head[:, 0], head[:, 1], "--muted", "arrow")
    for kind, term in zip(("dashed", "dotted"), terms if len(terms) > 1 else (), strict=False):
        r = (plane_curve(term, theta_i, theta_r, 1)[:, 0] * np.cos(theta_r)) ** power
        panel.line(r * np.sin(theta_r), r * np.cos(theta_r), "--muted", kind)
    for c in channels:
        r = curve[:, c.index] ** power
        panel.line(r * np.sin(theta_r), r * np.cos(theta_r), c.color)
    return panel.svg(f"Polar plot of the fitted lobe at an angle of incidence of {np.degrees(theta_i):.0f} degrees")


def spectral_figure(fit: Fit) -> Html | None:
    """Parameters that were fitted for each wavelength, with error bands; and the relative residual of each."""
    data = fit.measurement
    if data.wavelengths is None or data.n_channels < 5:
        return None
    nm = data.wavelengths
    x = Scale(float(nm.min()), float(nm.max()))
    panels = []
    for p in fit.parameters.values():
        value, error = np.atleast_1d(p.value), np.nan_to_num(np.atleast_1d(p.stderr))
        if len(value) != len(nm):
            continue
        panel = Panel(x, Scale.around(value + error, value - error, zero=True), f"{p.name}: {p.doc}", "wavelength [nm]", f"{p.name} [{p.unit}]" if p.unit else p.name)
        panel.band(nm, value - error, value + error, "--blue")
        panel.line(nm, value, "--blue")
        panel.dots(nm, value, "--blue", 4)
        panels.append(panel.svg(f"{p.name} against wavelength, from {value.min():.3g} to {value.max():.3g}"))
    residual, values = fit.residuals, np.where(data.mask[0], data.values[0], np.nan)
    with np.errstate(invalid="ignore", divide="ignore"):
        counts = np.maximum(np.isfinite(residual).sum(0), 1)
        relative = np.sqrt(np.nansum(residual**2, 0) / counts) / np.sqrt(np.nansum(values**2, 0) / counts)
    panel = Panel(x, Scale.around(100 * relative, zero=True), "Relative RMS at each wavelength", "wavelength [nm]", "relative RMS [%]")
    panel.line(nm, 100 * relative, "--ink")
    panel.dots(nm, 100 * relative, "--ink", 4)
    panels.append(panel.svg("Relative root-mean-square residual against wavelength"))
    caption = "Values at each wavelength with one standard error as a band (often thinner than the line), and RMS(f − r) / RMS(r) at each wavelength."
    return figure(panels, caption)


__all__ = ["MOST_DOTS", "Shown", "agreement_figure", "figure", "join", "key", "lobes_figure", "mirror_figure", "residual_figure", "shown_channels", "slice_scale", "slices_figure", "spectral_figure"]
