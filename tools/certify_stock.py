"""Certify the BSDFs that come with Mitsuba, and write the table of which of them fail what into docs/certify.md.

usage: python tools/certify_stock.py [-o docs/certify.md]

The table stands between two comments of the page; nothing else of it is touched.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from motes.certification import Certificate, Outcome, certify
from motes.files import write_text

BEGIN, END = "<!-- stock: written by tools/certify_stock.py -->", "<!-- end of stock -->"


def rgb(*value: float) -> dict[str, Any]:
    return {"type": "rgb", "value": list(value)}


GREEN = {"type": "diffuse", "reflectance": rgb(0.2, 0.6, 0.3)}
GOLD = {"type": "roughconductor", "material": "Au", "alpha": 0.2}
#: By name: what is certified.  ``bumpmap`` and ``normalmap`` need a picture, ``measured`` a file, ``hair`` is no surface.
STOCK: dict[str, dict[str, Any]] = {
    "diffuse": GREEN,
    "plastic": {"type": "plastic", "diffuse_reflectance": rgb(0.2, 0.6, 0.3)},
    "roughplastic, GGX": {"type": "roughplastic", "distribution": "ggx", "alpha": 0.2},
    "roughplastic, Beckmann": {"type": "roughplastic", "alpha": 0.2},
    "conductor": {"type": "conductor", "material": "Au"},
    "roughconductor, GGX": {**GOLD, "distribution": "ggx"},
    "roughconductor, Beckmann": GOLD,
    "roughconductor, anisotropic": {
        "type": "roughconductor",
        "material": "Al",
        "alpha_u": 0.1,
        "alpha_v": 0.4,
        "distribution": "ggx",
    },
    "dielectric": {"type": "dielectric"},
    "thindielectric": {"type": "thindielectric"},
    "roughdielectric, GGX": {"type": "roughdielectric", "alpha": 0.2, "distribution": "ggx"},
    "roughdielectric, Beckmann": {"type": "roughdielectric", "alpha": 0.2},
    "principled": {"type": "principled", "base_color": rgb(0.2, 0.6, 0.3), "roughness": 0.4},
    "principled, metal with clearcoat": {
        "type": "principled",
        "base_color": rgb(0.9, 0.6, 0.3),
        "metallic": 0.8,
        "roughness": 0.3,
        "clearcoat": 0.7,
        "clearcoat_gloss": 0.5,
    },
    "principled, cloth": {
        "type": "principled",
        "base_color": rgb(0.6, 0.2, 0.2),
        "roughness": 0.8,
        "sheen": 0.8,
        "sheen_tint": 0.5,
    },
    "principledthin": {"type": "principledthin", "base_color": rgb(0.2, 0.6, 0.3), "roughness": 0.4},
    "pplastic": {"type": "pplastic", "alpha": 0.2},
    "blendbsdf": {"type": "blendbsdf", "weight": 0.3, "first": GREEN, "second": GOLD},
    "mask": {"type": "mask", "opacity": 0.4, "inner": GREEN},
    "twosided": {"type": "twosided", "inner": GREEN},
    "null": {"type": "null"},
}
MARKS = {Outcome.HOLDS: "✓", Outcome.DOUBT: "≈", Outcome.FAULT: "**✗**", Outcome.NOT_JUDGED: "–"}
SHOWN = ("values", "energy", "reciprocity", "sampling", "gradients")


def certified(name: str) -> Certificate:
    """The certificate of one of them."""
    return certify(STOCK[name], name=name, date="")


def row(found: Certificate) -> str:
    """Its line of the table."""
    marks = [MARKS[found.check(name).outcome] for name in SHOWN]
    curve = [max(values) for values in found.check("energy").numbers["directional_albedo"]]
    said = ", ".join(dict.fromkeys(f"`{f.name}`" for f in found.findings))
    return f"| {found.subject} | {' | '.join(marks)} | {max(curve):.3f} | {said} |"


def section(rows: list[str], versions: str) -> str:
    """The table with its head, between the comments."""
    head = f"| BSDF | {' | '.join(SHOWN)} | largest albedo | findings |"
    lines = [f"Mitsuba {versions}, `llvm_ad_rgb`; ✓ holds, ≈ doubt, ✗ fault, – not judged.", "", head]
    return "\n".join([BEGIN, "", *lines, "|" + "---|" * (len(SHOWN) + 3), *rows, "", END])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else "")
    parser.add_argument(
        "-o", "--output", type=Path, default=Path(__file__).resolve().parents[1] / "docs" / "certify.md"
    )
    page: Path = parser.parse_args().output
    rows, versions = [], ""
    for name in STOCK:
        found = certified(name)
        versions = found.versions["mitsuba"]
        rows.append(row(found))
        print(rows[-1], flush=True)
    text = page.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    after = rest.partition(END)[2]
    write_text(page, f"{before}{section(rows, versions)}{after}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
