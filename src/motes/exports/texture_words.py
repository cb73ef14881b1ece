"""What the files of a set of textures say: where the map is from, its errors, what each picture holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from motes.exports.texel_surface import TexelSurfaces
from motes.exports.texture_files import Source, filled, listed
from motes.exports.texture_moments import Then
from motes.exports.texture_sets import Layout, TextureSet
from motes.maps import FittedMap
from motes.measurements.origin import not_measured
from motes.version import __version__

#: Of pictures that hold numbers as they are.
REAL = "All pictures are OpenEXR of 32 bits, linear."


def notes(fitted: FittedMap, moments: Sequence[Then], sources: Sequence[Source], chosen: bool) -> list[str]:
    """What a file must say of the map: where it is from, the moment (`chosen` where nobody asked for one), what was filled."""
    said = [text for text in (not_measured({"source": fitted.origin}),) if text]
    interval = (float(fitted.hours[0]), float(fitted.hours[-1]))
    if moments[0].hours is not None:
        when = ", ".join(f"{each.hours:g}" for each in moments)
        said.append(f"The map follows time ({interval[0]:g} to {interval[1]:g} h); this is how it is at {when} h.")
        if chosen:
            said.append("No time was asked for, so the first was taken.")
        outside = [
            each.hours for each in moments if each.hours is not None and not interval[0] <= each.hours <= interval[1]
        ]
        if outside:
            said.append(f"{', '.join(f'{x:g}' for x in outside)} h is outside the times that were observed.")
    total = sum(each.known.size for each in moments)
    gaps = sum(int(filled(source, fitted.shape).sum()) for source in sources)
    if gaps:
        said.append(
            f"{gaps:,} of {total:,} texels have no fit and got the values of the nearest that has one; *_fitted.png is 0 there."
        )
    bridged = sum(int((each.bridged & each.known).sum()) for each in moments)
    if bridged:
        said.append(
            f"{bridged:,} of {total:,} texels have no fit at a scan next to the moment, and their own scans before and after it stand for it; "
            "*_fitted.png is 128 there."
        )
    doubtful = sum(int((each.doubtful & each.known).sum()) for each in moments)
    if doubtful:
        said.append(
            f"{doubtful:,} of {total:,} texels have a parameter that the data do not determine; *_fitted.png is 128 there."
        )
    return said


def errors(surfaces: TexelSurfaces, layout: Layout) -> list[str]:
    """How far the surfaces are from the materials, and what they leave out."""
    compared = surfaces.compared_in_words()
    said = [surfaces.said(layout.program), *([compared] if compared else [])]
    return [*said, surfaces.kind.left_out, *layout.notes]


def numbers(sets: Sequence[TextureSet], bits: int) -> list[str]:
    """How numbers became codes."""
    said = [
        f"PNGs have {bits} bits: colours follow the curve of sRGB (IEC 61966-2-1), all other numbers and alpha are linear."
    ]
    if high := sorted({texture.name for _, texture, _ in listed(sets) if texture.suffix == ".exr"}):
        said.append(f"{', '.join(high)}: OpenEXR, for values above 1; linear.")
    for each, texture, _ in listed(sets):
        if texture.factor != 1:
            said.append(f"{each.name}: the picture {texture.name} is multiplied by {texture.factor:.5g}.")
    return said


def about_normals(size: tuple[int, int], shape: tuple[int, int], normals: str, flipped: bool) -> str:
    green = {"OpenGL": "up", "DirectX": "down"}[normals]
    done = "its green turned round" if flipped else "as it is, byte for byte"
    other = "" if size == shape else f" It is {size[1]} x {size[0]} pixels, the map {shape[1]} x {shape[0]} texels."
    return (
        f"The normal map went along {done}; the target takes {normals}'s convention, green is {green}"
        f"{'' if flipped else ' (--flip-green turns the other one)'}.{other}"
    )


def record(
    fitted: FittedMap,
    to: str,
    layout: Layout,
    surfaces: TexelSurfaces,
    moments: Sequence[Then],
    sources: Sequence[Source],
    pictures: Sequence[dict[str, Any]],
    notes: Sequence[str],
) -> dict[str, Any]:
    size = moments[0].known.size
    return {
        "motes": __version__,
        "name": fitted.name,
        "model": fitted.model,
        "target": to,
        "surface": layout.program,
        "fitted_text": surfaces.text,
        "colour": "linear sRGB before the curve",
        "loss": "cube roots of f cos(theta_i), over lights from everywhere and over what an orthographic picture shows of the surface",
        "shape": list(fitted.shape),
        "hours": [each.hours for each in moments],
        "texels": {
            "all": size * len(moments),
            "filled": sum(int(filled(source, fitted.shape).sum()) for source in sources),
            "bridged": sum(int((each.bridged & each.known).sum()) for each in moments),
            "undetermined": sum(int((each.doubtful & each.known).sum()) for each in moments),
        },
        "error": surfaces.quantiles(),
        "fitted_singly": [
            {
                "moment": row // size,
                "texel": list(divmod(row % size, fitted.shape[1])),
                "single": single,
                "batched": batched,
            }
            for row, single, batched in surfaces.compared
        ],
        "textures": list(pictures),
        "notes": list(notes),
    }


def readme(head: Sequence[str], pictures: Sequence[dict[str, Any]], normal: str | None) -> str:
    lines = [*head, ""]
    for each in pictures:
        lines.append(f"{each['file']}: {', '.join(each['channels'])} ({each['format']}, {each['curve']})")
    if normal:
        lines.append(f"{normal}: normals")
    return (
        "\n".join(
            [
                *lines,
                "",
                "Row 0 of each picture is that of the map, at the top; x is to the right, y up, z out of the surface.",
            ]
        )
        + "\n"
    )
