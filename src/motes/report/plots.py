"""The figures of the fitted BRDF beside its data: slices, the highlight, lobes, spectra."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from motes import directions, equations
from motes.arrays import NUMPY
from motes.drawing.colour import Floats
from motes.drawing.markup import Html, tag
from motes.drawing.sphere import evaluate
from motes.drawing.svg import Panel, Scale, number
from motes.fitting.grazing import without_fresnel
from motes.fitting.result import Fit
from motes.models import BRDF, describe
from motes.report.figures import DEGREES, Shown, channel_key, figure, key
from motes.report.slices import NearMirror, Slice, Slices, grows

# ---------------------------------------------------------------- curves of the fitted BRDF


def plane_curve(brdf: BRDF, theta_i: float, theta_r: Floats, n_channels: int, *, across: bool = False) -> Floats:
    """The BRDF (n, C) along a plane through the normal; theta_r signed, positive on the side of the mirror direction."""
    wi = directions.from_spherical(theta_i, 0.0)
    wo = directions.from_spherical(
        np.abs(theta_r), np.where(np.asarray(theta_r) >= 0, np.pi, 0.0) + (np.pi / 2 if across else 0.0)
    )
    value = evaluate(brdf, np.broadcast_to(wi, wo.shape), wo)
    return np.broadcast_to(value, (len(value), n_channels))


# ---------------------------------------------------------------- figures


def slices_figure(fit: Fit, slices: Slices, channels: Sequence[Shown], value_scale: Scale) -> Html:
    """Measured dots and fitted curves along a plane at several angles of incidence, all on one scale."""
    across = slices.panels[0].across
    panels = [slice_panel(fit, s, channels, value_scale) for s in slices.panels]
    where = "at right angles to the plane of incidence" if across else "in the plane of incidence"
    exact = np.degrees([slices.off_plane, slices.off_angle])
    caption = (
        f"BRDF {where}, one angle of incidence a panel, all on the same {'logarithmic ' if value_scale.log else ''}scale. "
        + (
            ""
            if across
            else "Negative θᵣ is the side of the light, positive the side of the mirror direction (dotted line). "
        )
        + f"Dots are samples within {exact[0]:.2g}° of the plane and {exact[1]:.2g}° of θᵢ; curves are the fit exactly in the plane; "
        "the stroke at a dot ends at the fit for that very sample."
    )
    return figure(panels, caption, channel_key(channels))


def slice_scale(fit: Fit, all_slices: Sequence[Slices], channels: Sequence[Shown]) -> Scale:
    """One scale for all slices: from zero, or logarithmic where the values span more than a factor of 30."""
    index = [c.channel for c in channels]
    values = np.concatenate(
        [s.samples.measured[:, index].ravel() for group in all_slices for s in group.panels] or [np.ones(1)]
    )
    positive = values[np.isfinite(values) & (values > 0)]
    if not positive.size:
        return Scale(0.0, 1.0)
    low, high = np.percentile(positive, 2), positive.max()
    if high / low > 30:
        return Scale.around([low * 0.7, high], log=True)
    fitted = np.concatenate([s.samples.fitted[:, index].ravel() for group in all_slices for s in group.panels])
    top = float(np.max(fitted, where=np.isfinite(fitted), initial=0.0))
    return Scale.around([high, min(top, 1.5 * high)], zero=True)


def slice_panel(fit: Fit, part: Slice, channels: Sequence[Shown], value_scale: Scale) -> Html:
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
        panel.line(np.degrees(theta_r), curve[:, c.channel], c.color)
    for c in channels:
        panel.whiskers(at, part.samples.measured[:, c.channel], part.samples.fitted[:, c.channel], c.color)
        panel.dots(at, part.samples.measured[:, c.channel], c.color, 5 if len(at) < 60 else 3.5)
    count = int(np.isfinite(part.samples.measured[:, [c.channel for c in channels]]).sum())
    return panel.svg(f"BRDF against angle of reflection at {part.title}: {count} measured samples and the fitted curve")


def mirror_figure(fit: Fit, near: NearMirror, channels: Sequence[Shown]) -> Html:
    """How high the highlight is, measured and fitted, as the light grazes; and their ratio, where a missing Fresnel term shows."""
    degrees = np.degrees(near.theta_i)
    index = [c.channel for c in channels]
    x = Scale(0, 90, ticks=DEGREES)
    both = np.concatenate([near.measured[:, index], near.fitted[:, index]])
    positive = both[both > 0]
    spans = positive.size > 0 and positive.max() > 10 * positive.min()
    peak = Panel(
        x, Scale.around(both, log=spans, zero=not spans), "Height of the highlight", "θᵢ [°]", "f near mirror [1/sr]"
    )
    for c in channels:
        peak.line(degrees, near.fitted[:, c.channel], c.color)
        peak.dots(degrees, near.measured[:, c.channel], c.color, 6)
    good = (near.measured > 0) & (near.fitted > 0)
    ratio = np.where(good, near.measured, np.nan) / np.where(good, near.fitted, 1)
    shown = ratio[:, index]
    finite = shown[np.isfinite(shown)]
    lowest, highest = (float(finite.min()), float(finite.max())) if finite.size else (1.0, 1.0)
    rise = Panel(x, Scale.ratios(lowest, highest), "Measured over fitted", "θᵢ [°]", "ratio")
    rise.line([0, 90], [1, 1], "--ink", "guide")
    entries: list[tuple[str, str, str]] = []
    if grows(near) and without_fresnel(fit.brdf):
        theta = np.linspace(0, np.deg2rad(89.5), 90)
        F = np.asarray(equations.fresnel_dielectric(NUMPY, np.cos(theta), 1.5))
        at = np.asarray(equations.fresnel_dielectric(NUMPY, np.cos(near.theta_i), 1.5))
        offset = np.nanmean(np.log(shown / at[:, None]))
        rise.line(np.degrees(theta), F * np.exp(offset), "--muted", "dashed")
        entries.append(
            ("dashed", "--muted", "shape of the Fresnel term of a dielectric, n = 1.5, moved up or down to the dots")
        )
    if np.isfinite(near.elsewhere).any():
        rise.line(degrees, near.elsewhere, "--muted", "dotted")
        entries.append(("dotted", "--muted", "median ratio more than 45° from the mirror direction"))
    for c in channels:
        rise.line(degrees, ratio[:, c.channel], c.color, "thin")
        rise.dots(degrees, ratio[:, c.channel], c.color, 6)
    furthest = max(0.1, float(np.degrees(near.from_mirror.max())))
    caption = (
        f"For each angle of incidence the sample nearest to the mirror direction, at most {furthest:.2g}° from it. "
        "A fit that follows the highlight stays at ratio 1; a ratio that rises with θᵢ is reflectance that grows towards grazing faster than the model"
        + (", as the Fresnel term does: fresnel=dielectric adds it." if entries and entries[0][0] == "dashed" else ".")
    )
    return figure(
        [
            peak.svg("Measured and fitted BRDF near the mirror direction against angle of incidence"),
            rise.svg(
                f"Ratio of measured to fitted BRDF near the mirror direction, from {lowest:.2g} to {highest:.2g}, against angle of incidence"
            ),
        ],
        caption,
        channel_key(channels, entries),
    )


def lobes_figure(fit: Fit, channels: Sequence[Shown]) -> Html:
    """f cos(theta_r) in the plane of incidence as a polar plot, for three angles of incidence on one radial scale."""
    theta_r = np.deg2rad(np.linspace(-89.9, 89.9, 360))
    incidences = np.deg2rad((15, 45, 75))
    n = fit.measurement.n_channels
    terms = fit.brdf.terms() if len(channels) == 1 else ()
    grids = [np.sort(np.r_[theta_r, t + np.deg2rad(np.linspace(-4, 4, 81))]) for t in incidences]
    curves = [plane_curve(fit.brdf, t, g, n) * np.cos(g)[:, None] for t, g in zip(incidences, grids, strict=True)]
    index = [c.channel for c in channels]
    shown = np.concatenate([c[:, index] for c in curves])
    top, typical = float(shown.max()), float(np.median(shown))
    if not (np.isfinite(top) and top > 0):
        return tag(
            "p",
            "The fitted BRDF is 0 or not a number in the plane of incidence: there is no lobe to draw.",
            class_="note",
        )
    power = 1.0 if top <= 8 * max(typical, 1e-12) else 1 / 3
    panels = [_lobe(t, g, c, channels, terms, top, power) for t, g, c in zip(incidences, grids, curves, strict=True)]
    entries = [("line", c.color, c.name if len(channels) > 1 else "f cos θᵣ") for c in channels]
    if len(terms) > 1:
        entries += [(kind, "--muted", describe(term)) for kind, term in zip(("dashed", "dotted"), terms, strict=False)]
    caption = (
        "f cos θᵣ [1/sr] in the plane of incidence as distance from the point of incidence, the light coming along the arrow; "
        "a Lambertian surface gives a circle. "
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
    panel = Panel(
        Scale(-edge, edge),
        Scale(-0.12 * edge, 2 * edge * height / width - 0.12 * edge),
        f"θᵢ = {np.degrees(theta_i):.0f}°",
        width=width,
        height=height,
        axes=False,
    )
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
        r = curve[:, c.channel] ** power
        panel.line(r * np.sin(theta_r), r * np.cos(theta_r), c.color)
    return panel.svg(f"Polar plot of the fitted lobe at an angle of incidence of {np.degrees(theta_i):.0f} degrees")


def spectral_figure(fit: Fit) -> Html | None:
    """Parameters that were fitted for each wavelength, with error bands; and the relative residual of each."""
    data = fit.measurement
    if data.wavelengths is None or data.n_channels < 5:
        return None
    order = np.argsort(data.wavelengths)
    nm = data.wavelengths[order]
    x = Scale(float(nm[0]), float(nm[-1]))
    panels = []
    for p in fit.parameters.values():
        value, error = np.atleast_1d(p.value), np.nan_to_num(np.atleast_1d(p.stderr))
        if len(value) != len(nm):
            continue
        value, error = value[order], error[order]
        panel = Panel(
            x,
            Scale.around(value + error, value - error, zero=True),
            f"{p.name}: {p.doc}",
            "wavelength [nm]",
            f"{p.name} [{p.unit}]" if p.unit else p.name,
        )
        panel.band(nm, value - error, value + error, "--blue")
        panel.line(nm, value, "--blue")
        panel.dots(nm, value, "--blue", 4)
        panels.append(panel.svg(f"{p.name} against wavelength, from {value.min():.3g} to {value.max():.3g}"))
    residual, values = fit.residuals, np.where(data.mask[0], data.values[0], np.nan)
    with np.errstate(invalid="ignore", divide="ignore"):
        counts = np.maximum(np.isfinite(residual).sum(0), 1)
        relative = np.sqrt(np.nansum(residual**2, 0) / counts) / np.sqrt(np.nansum(values**2, 0) / counts)
    relative = relative[order]
    panel = Panel(
        x,
        Scale.around(100 * relative, zero=True),
        "Relative RMS at each wavelength",
        "wavelength [nm]",
        "relative RMS [%]",
    )
    panel.line(nm, 100 * relative, "--ink")
    panel.dots(nm, 100 * relative, "--ink", 4)
    panels.append(panel.svg("Relative root-mean-square residual against wavelength"))
    caption = "Values at each wavelength with one standard error as a band (often thinner than the line), and RMS(f − r) / RMS(r) at each wavelength."
    return figure(panels, caption)
