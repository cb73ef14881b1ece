"""How far the fitted surfaces of other programs are from materials, by light: ``python tools/surface_errors.py clay`` writes the table of
docs/exports.md, between its marks, and prints it.  Materials are presets or models as texts; a quarter of a minute for each surface on an idle machine."""

from __future__ import annotations

import sys
from pathlib import Path

from motes import models
from motes.exports import SURFACES
from motes.exports.subject import subject
from motes.exports.surface_fit import LIGHTINGS, fit_surface
from motes.presets import given

DOCUMENT = Path(__file__).resolve().parents[1] / "docs" / "exports.md"
BEGIN, END = "<!-- surface errors: tools/surface_errors.py -->", "<!-- /surface errors -->"


def percent(share: float) -> str:
    """Two digits; 0 for what is rounding alone."""
    return f"{100 * share:.2g} %" if share > 5e-5 else "0 %"


def rows(materials: list[str]) -> list[str]:
    """The lines of the table."""
    head = ["material", "target", "hemisphere", *LIGHTINGS]
    lines = [f"| {' | '.join(head)} |", "|---" * len(head) + "|"]
    for text in materials:
        named = given(text)
        if isinstance(named, str):
            named = models.parse(named).model
        what = subject(named)
        for to, (_, kind) in SURFACES.items():
            fit = fit_surface(what, getattr(models, kind))
            lights = [f"{percent(light.difference)} ({light.energy:.2f})" for light in fit.lights]
            lines.append(f"| {text} | `{to}` | {percent(fit.conversion.relative_rms)} | {' | '.join(lights)} |")
            print(lines[-1], flush=True)
    return lines


def main() -> None:
    table = "\n".join(rows(sys.argv[1:] or ["clay"]))
    text = DOCUMENT.read_text(encoding="utf-8")  # now: it may have changed in the meantime
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    DOCUMENT.write_text(f"{before}{BEGIN}\n{table}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
