"""The certificate as one HTML page: what holds, what does not and what it probably is, with the pictures it was judged by."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.certification.certificate import Certificate, Check, Outcome
from motes.certification.check_precision import ROUNDINGS, TOLERANCE
from motes.drawing.colour import diverging, sequential
from motes.drawing.markup import Html, join, table, tag
from motes.drawing.svg import Panel, Scale
from motes.files import write_text
from motes.report.document import Section, document, encoded, headline, last_words, sectioned
from motes.report.figures import PALETTE, RGB_COLORS, color_bar, figure, key
from motes.report.findings import count

TITLES = {
    "values": "Numbers that a BRDF can have",
    "energy": "Energy: the white furnace",
    "reciprocity": "Reciprocity",
    "sampling": "Samples and their density",
    "gradients": "Derivatives",
    "precision": "float32 against float64",
    "conventions": "Conventions",
    "exports": "Agreement of exports",
}
_MARKS = {
    Outcome.HOLDS: ("good", "✓ holds"),
    Outcome.DOUBT: ("warn", "≈ doubt"),
    Outcome.FAULT: ("bad", "✗ fault"),
    Outcome.NOT_JUDGED: ("plain", "– not judged"),
}
SIZE = 240


def write_certificate(certificate: Certificate, path: str | os.PathLike[str]) -> Path:
    """Write a certificate as one self-contained HTML page.

    Parameters
    ----------
    certificate
        From `motes.certify`.
    path
        The file to write; whole or not at all.

    Returns
    -------
    Path

    Notes
    -----
    The same certificate gives the same bytes.
    """
    return write_text(path, render(certificate))


def render(certificate: Certificate) -> str:
    """The page as text; see `write_certificate`."""
    parts = [_head(certificate), *sectioned(certificate, SECTIONS), last_words()]
    return document(f"{certificate.subject}: {certificate.outcome}", *parts)


# ---------------------------------------------------------------- the head


def _head(certificate: Certificate) -> Html:
    faults = [f for f in certificate.findings if f.outcome is Outcome.FAULT]
    doubts = [f for f in certificate.findings if f.outcome is Outcome.DOUBT]
    judged = [c for c in certificate.checks if c.outcome is not Outcome.NOT_JUDGED]
    if faults:
        lead = f"{count(len(faults), 'fault')} found. {faults[0].says}. {faults[0].probably}"
    elif doubts:
        lead = f"No fault was found in {count(len(judged), 'check')}, and {count(len(doubts), 'thing')} to look at: {doubts[0].says}."
    else:
        lead = f"All {count(len(judged), 'check')} that could be made hold."
    facts = [
        ("checks that hold", f"{sum(c.outcome is Outcome.HOLDS for c in judged)} of {len(judged)}"),
        ("faults", str(len(faults))),
        ("certificate", certificate.number),
    ]
    if certificate.date:
        facts.append(("date", certificate.date))
    return headline(_furnace(certificate), certificate.subject, certificate.kind, (lead,), facts)


def _furnace(certificate: Certificate) -> tuple[str, str]:
    """A sphere in a white furnace: grey where light is lost, white where all of it leaves, red where more than that does."""
    energy = certificate.check("energy").numbers
    y, x = np.meshgrid(*[(np.arange(SIZE) + 0.5) / SIZE * 2.04 - 1.02] * 2, indexing="ij")
    radius = np.hypot(x, y)
    coverage = np.clip((1 - radius) * SIZE / 2.04 + 0.5, 0, 1)
    if not energy:
        return encoded(np.full((SIZE, SIZE, 3), 0.2), coverage, 0), "A grey disc: no energy was judged"
    values = _floats(energy["directional_albedo"]).max(axis=1)
    seen = np.interp(np.degrees(np.arcsin(np.clip(radius, 0, 1))), energy["theta_i_deg"], values)
    over = np.clip((seen - 1.002) * 20, 0, 1)[..., None]
    grey = np.clip(seen, 0, 1)[..., None] * np.ones(3)
    colour = (1 - over) * grey + over * np.array([0.8, 0.02, 0.02])
    return (
        encoded(colour, coverage, 0),
        "A sphere in a white furnace: grey where light is lost, red where more leaves than arrives",
    )


# ---------------------------------------------------------------- sections


def _findings(certificate: Certificate) -> Html | None:
    rows = [
        [_chip(f.outcome), tag("td", tag("code", f.name)), TITLES[c.name], f"{f.says}.", f.probably]
        for c in certificate.checks
        for f in c.findings
    ]
    return table(("", "name", "check", "what was found", "what it probably is"), rows) if rows else None


def _checks(certificate: Certificate) -> Html:
    rows = [[_chip(c.outcome), TITLES[c.name], c.says] for c in certificate.checks]
    return table(("", "check", "result"), rows)


def _chip(outcome: Outcome) -> Html:
    kind, words = _MARKS[outcome]
    return tag("td", tag("span", words, class_=f"verdict {kind}"))


def _energy(certificate: Certificate) -> Html | None:
    numbers = certificate.check("energy").numbers
    if not numbers:
        return None
    angles, values = np.array(numbers["theta_i_deg"]), _floats(numbers["directional_albedo"])
    top = Scale.around(values, [1.0], zero=True)
    panel = Panel(
        Scale(0, 90, ticks=(0, 15, 30, 45, 60, 75, 90)), top, "Directional albedo", "θᵢ [°]", "share of light"
    )
    panel.line([0, 90], [1, 1], "--muted", "guide")
    colors = _colors(values.shape[1])
    for k, color in enumerate(colors):
        panel.line(angles, values[:, k], color)
        panel.dots(angles, values[:, k], color)
    caption = (
        "The share of light from each direction that leaves, by a rule that asks nothing of the subject's own sampling; what mirrors or goes through is "
        "added by its samples. More than 1 (dashed) is energy from nowhere; what lacks to 1 is absorbed, or lost by the model."
    )
    names = [("line", color, name) for color, name in zip(colors, numbers["channels"], strict=False)]
    more = (
        "" if values.shape[1] <= len(colors) else f" Of {values.shape[1]} channels the first {len(colors)} are drawn."
    )
    return figure([panel.svg("The directional albedo over the angle of incidence")], caption + more, key(names) if len(names) > 1 else None)  # fmt: skip


def _colors(channels: int) -> Sequence[str]:
    return RGB_COLORS if channels == 3 else PALETTE[:channels]


def _reciprocity(certificate: Certificate) -> Html | None:
    numbers = certificate.check("reciprocity").numbers
    if not numbers:
        return None
    theta, values = np.array(numbers["theta_deg"]), _floats(numbers["largest_relative_difference"])
    low, high = -7.0, 0.0
    with np.errstate(divide="ignore"):
        log = np.clip(np.log10(np.maximum(values, 1e-300)), low, high)
    pixels = sequential((log[::-1] - low) / (high - low))
    step = 0.5 * float(theta[1] - theta[0])
    ends = float(theta[0]) - step, float(theta[-1]) + step
    ticks = (0, 15, 30, 45, 60, 75, 90)
    panel = Panel(Scale(*ends, ticks=ticks), Scale(*ends, ticks=ticks), "Asymmetry", "θᵣ [°]", "θᵢ [°]")
    panel.picture(pixels, ends, ends)
    caption = (
        "The relative difference of f(wi, wo) and f(wo, wi), the largest of ten azimuths, on a logarithmic scale. "
        f"More than {numbers['tolerance']:g} at one pair in a hundred is a fault."
    )
    bar = color_bar("1e-7 or less", "1", sequential(np.linspace(0, 1, 10)), "relative difference")
    return figure([panel.svg("A map of how far light may not be turned around")], caption, bar)


def _sampling(certificate: Certificate) -> Html | None:
    check = certificate.check("sampling")
    if "picture" not in check.numbers:
        return None
    counts, expected = (np.nan_to_num(_floats(check.numbers["picture"][name])) for name in ("counts", "expected"))
    top = max(float(np.percentile(expected, 99.5)), float(np.percentile(counts, 99.5)), 1.0)
    expected = np.maximum(expected, 0)
    pull = (counts - expected) / np.sqrt(np.maximum(expected, 1.0))
    pictures = {
        "Expected of the density": sequential(np.sqrt(np.clip(expected / top, 0, 1))),
        "Where samples fell": sequential(np.sqrt(np.clip(counts / top, 0, 1))),
        "Difference, in standard deviations (±5)": diverging(np.clip(pull / 5, -1, 1)),
    }
    lowest = check.numbers["picture"]["lowest"]
    panels = [_grid(pixels, title, lowest) for title, pixels in pictures.items()]
    rows = [
        [f"{a:g}°", _number(s), str(n), _number(p), _number(i), _number(k)]
        for a, s, n, p, i, k in zip(
            *(
                check.numbers[name]
                for name in (
                    "theta_i_deg",
                    "chi_square",
                    "degrees_of_freedom",
                    "chance",
                    "integral_of_density",
                    "share_above_horizon",
                )
            ),
            strict=True,
        )
    ]
    head = ("θᵢ", "chi-square", "degrees of freedom", "chance", "integral of the density", "samples in the bins")
    caption = f"{check.says} Height is cos θᵣ, so that equal areas are equal solid angles; across is the azimuth. Peaks of Dirac are left out."
    return join(figure(panels, caption), table(head, rows))


def _grid(pixels: NDArray[np.uint8], title: str, lowest: float) -> Html:
    panel = Panel(Scale(-180, 180, ticks=(-180, -90, 0, 90, 180)), Scale(lowest, 1), title, "φᵣ [°]", "cos θᵣ")
    panel.picture(pixels[::-1], (-180, 180), (lowest, 1))
    return panel.svg(title)


def _precision(certificate: Certificate) -> Html | None:
    check = certificate.check("precision")
    if not check.numbers:
        return None
    rows = [
        [place, _number(row["largest_relative_error"]), f"{100 * row['share_beyond']:.2g} %"]
        for place, row in check.numbers.items()
    ]
    note = f"An error counts that is beyond {TOLERANCE:g} and beyond what one rounding of the directions changes in float64, {ROUNDINGS:.0f} times over."
    return join(
        table(("pairs of directions", "largest relative error", "share that counts"), rows),
        tag("p", note, class_="note"),
    )


def _rivals(certificate: Certificate) -> Html | None:
    check: Check = certificate.check("conventions")
    if "rivals" not in check.numbers:
        return tag("p", check.says)
    rows = [
        [" and ".join(r["changes"]) or "the reference as it is", f"{r['scale']:.5g}", f"{100 * r['difference']:.3g} %"]
        for r in check.numbers["rivals"]
    ]
    return join(
        tag("p", check.says),
        table(("rival hypothesis", "constant", "what it leaves"), rows),
        tag(
            "p",
            "The reference seen through other conventions, the best first. What is left is the mean of |a − b| / (|a| + |b|).",
            class_="note",
        ),
    )


def _exports(certificate: Certificate) -> Html | None:
    check = certificate.check("exports")
    if "targets" not in check.numbers:
        return None
    chips = {"agrees": ("good", "✓ agrees"), "differs": ("bad", "✗ differs"), "not run": ("plain", "– not run")}
    rows = []
    for row in check.numbers["targets"]:
        kind, words = chips[row["outcome"]]
        ran = row.get("at") is not None
        numbers = [_number(row["largest"]), row["at"], _number(row["median"])] if ran else ["", "", ""]
        asked = f"{row['tolerance']:.2g} ({row['judged_by']})" if ran else ""
        rows.append([tag("td", tag("span", words, class_=f"verdict {kind}")), tag("td", tag("code", row["target"])), row["how"], *numbers, asked])  # fmt: skip
    head = ("", "target", "how it was run, or why not", "largest difference", "where", "median", "at most")
    note = (
        "The material printed for each target of motes export, run here, and compared with NumPy in float64 at the same directions: differences are "
        "relative to the value, or to a twentieth of the median value where that is larger. Tables are compared at their own samples; those that "
        "average over patches, or between their nodes, by the median."
    )
    return join(table(head, rows), tag("p", note, class_="note"))


def _citing(certificate: Certificate) -> Html:
    pairs = {
        **certificate.facts,
        "SHA-256 of the subject": certificate.digest,
        **{f"version of {name}": version for name, version in certificate.versions.items()},
        "number": f"{certificate.number}: the head of the SHA-256 of everything here but the date",
    }
    rows = [part for name, value in pairs.items() for part in (tag("dt", name), tag("dd", value))]
    words = (
        "Cite the certificate by its number. The same subject, versions and options give the same number, and with "
        f"--date {certificate.date or 'DATE'} this page bit by bit."
    )
    return join(tag("dl", *rows, class_="pairs"), tag("p", words))


def _number(value: float | None) -> str:
    return "not finite" if value is None else f"{value:.5g}"


def _floats(rows: object) -> NDArray[np.float64]:
    """A table out of JSON; None is NaN."""
    return np.array(rows, dtype=np.float64)


SECTIONS: tuple[Section[Certificate], ...] = (
    Section("findings", "What was found", _findings),
    Section("checks", "All checks", _checks),
    Section("energy", TITLES["energy"], _energy),
    Section("reciprocity", TITLES["reciprocity"], _reciprocity),
    Section("sampling", TITLES["sampling"], _sampling),
    Section("precision", TITLES["precision"], _precision),
    Section("conventions", TITLES["conventions"], _rivals),
    Section("exports", TITLES["exports"], _exports),
    Section("cite", "To cite it and make it again", _citing),
)
