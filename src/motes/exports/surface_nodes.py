"""MaterialX 1.39 with the surface shaders that it brings (OpenPBR, Standard Surface): a material of fitted parameters for each moment."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path

from motes.exports import usd_library, usd_surfaces
from motes.exports.materialx import VERSION
from motes.exports.surface_files import NODES, comment, names, rounded
from motes.exports.surface_fit import SurfaceFit
from motes.files import write_text


def document(fits: Sequence[SurfaceFit]) -> str:
    """The text of the document."""
    root = ElementTree.Element("materialx", version=VERSION, colorspace="lin_rec709")
    root.append(
        ElementTree.Comment("\n" + "\n".join(f"  {line}" for line in comment(fits)).replace("--", "- -") + "\n")
    )
    for fit, name in zip(fits, names(fits), strict=True):
        node = NODES[type(fit.surface).__name__]
        shader = ElementTree.SubElement(root, node, name=f"{name}_surface", type="surfaceshader")
        for parameter, value in fit.surface.written().items():
            many = isinstance(value, tuple)
            text = ", ".join(map(repr, rounded(value))) if isinstance(value, tuple) else repr(rounded((value,))[0])
            ElementTree.SubElement(shader, "input", name=parameter, type="color3" if many else "float", value=text)
        material = ElementTree.SubElement(root, "surfacematerial", name=name, type="material")
        ElementTree.SubElement(
            material, "input", name="surfaceshader", type="surfaceshader", nodename=f"{name}_surface"
        )
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def write(fits: Sequence[SurfaceFit], path: Path) -> Path:
    """Write the document; as USD where the file is called so."""
    if path.suffix.lower() in usd_library.SUFFIXES:
        return usd_surfaces.write_fits(fits, path)
    return write_text(path, document(fits))
