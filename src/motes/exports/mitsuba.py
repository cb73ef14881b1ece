"""Mitsuba 3: BSDFs in XML, the exact plugin of Motes and stock ones that come near.

The file is a scene without shapes; another one takes it in by ``<include filename="plaster.xml"/>`` and uses ``<ref id="plaster"/>``, or
``plaster_stock``.  The exact one is the plugin ``motes_material``, which Motes registers (`motes.rendering.register`); it reads the material
from a JSON file beside the XML, with its course over time.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError
from motes.exports.approximation import Numbers, lobes, losses
from motes.exports.shaders import heading, plain, prepare
from motes.exports.subject import Subject
from motes.files import write_text
from motes.models import Reflection, describe

Floats = NDArray[np.float64]

SUFFIX = ".xml"
VERSION = "3.0.0"


def limits(subject: Subject) -> list[str]:
    """What the file cannot say."""
    name = subject.identifier
    said = [f"{name} is exact and needs Motes in Mitsuba's Python (motes.rendering.register)."]
    if subject.hours is not None:
        said.append(f"Its time is set to {subject.hours:g} h and can be changed; {name}_stock stays as it is.")
    if subject.brdf.channels not in (1, 3):
        return [*said, "There are no stock plugins: theirs are colours of three channels here."]
    said.append(
        f"{name}_stock blends stock plugins: smooth diffuse ones in the place of rough diffuse lobes, and mirrors with Smith's shadowing, GGX where "
        "the model says GGX, else Beckmann of the same alpha; F is that of its refractive index where that leaves room for all parts, else F "
        "at normal incidence."
    )
    said += losses(subject.brdf)
    total = _total(_with_indices(lobes(subject.brdf)))
    if total > 1:
        said.append(
            f"Together they would reflect {total:.3g} of the light; stock plugins reflect 1 at most, so they are scaled to it."
        )
    return said


def stock(subject: Subject) -> dict[str, Any]:
    """The nearest stock plugins as a dictionary for ``mitsuba.load_dict``.

    Mitsuba has no sum of BSDFs.  A blend ``(1 - weight) a + weight b`` is one where each part reflects the sum's brightest channel and the weights are its
    share in that.
    """
    parts = _with_indices(lobes(subject.brdf))
    scale = 1 / max(1.0, _total(parts))
    diffuse = np.broadcast_to(_diffuse(parts), 3) * scale
    plugins: list[tuple[Any, dict[str, Any], str]] = []
    if diffuse.any() or not _mirrors(parts):
        plugins.append((diffuse, {"type": "diffuse"}, "reflectance"))
    for lobe in _mirrors(parts):
        mirror = {
            "type": "roughconductor",
            "distribution": lobe.distribution or "beckmann",
            "alpha": lobe.roughness,
        }
        if lobe.index is None:
            mirror["material"] = "none"
        else:
            mirror |= {
                key: {"type": "rgb", "value": np.broadcast_to(x, 3).tolist()}
                for key, x in zip(("eta", "k"), lobe.index, strict=True)
            }
        plugins.append((np.broadcast_to(lobe.normal, 3) * scale, mirror, "specular_reflectance"))
    return _blended(plugins)


def document(subject: Subject, material_file: str) -> str:
    """The text of the XML file, which refers to the material in `material_file`."""
    _check(subject)
    root = ElementTree.Element("scene", version=VERSION)
    said = heading(prepare(subject.brdf), subject.name, "Mitsuba 3", (*subject.notes, *limits(subject)))
    text = "\n".join(line.removeprefix("//").replace("--", "- -") for line in said)
    root.append(ElementTree.Comment(text + "\n"))
    exact: dict[str, Any] = {"type": "motes_material", "filename": material_file}
    exact |= {} if subject.hours is None else {"time": subject.hours}
    root.append(_element(exact, subject.identifier))
    if subject.brdf.channels in (1, 3):
        root.append(_element(stock(subject), f"{subject.identifier}_stock"))
    ElementTree.indent(root)
    return '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the XML file, and the material beside it.

    Raises
    ------
    DataError
        When the material holds dust in the form of brightness, which is no BRDF.
    """
    material_file = path.with_name(f"{path.stem}_material.json")
    text = document(subject, material_file.name)
    subject.material.save(material_file)
    return [write_text(path, text), material_file]


def _check(subject: Subject) -> None:
    if not subject.brdf.reciprocal:
        raise DataError(
            f"{subject.name} is not reciprocal, so it is no BRDF: {describe(subject.brdf)}", "Give dust form='brdf'"
        )


def _with_indices(parts: list[Numbers]) -> list[Numbers]:
    """The lobes as Mitsuba is to have them: `normal` is what multiplies the plugin's own F, that of an index or 1.

    The parts of a blend share out 1 among them, and what multiplies an F is more than what it reflects: where that leaves no room for the
    others, F at normal incidence takes its place.  Before that, light goes that facets pass on to each other: it would dim their highlight.
    """
    exact = [lobe if lobe.index is None else replace(lobe, normal=lobe.grazing) for lobe in parts]
    if _total(exact) > 1 and any(lobe.regained for lobe in parts):
        return _with_indices([lobe for lobe in parts if not lobe.regained])
    return exact if _total(exact) <= 1 else [replace(lobe, index=None) for lobe in parts]


def _mirrors(parts: list[Numbers]) -> list[Numbers]:
    return [lobe for lobe in parts if lobe.reflection is Reflection.GLOSSY and lobe.normal.any()]


def _diffuse(parts: list[Numbers]) -> Floats:
    """The reflectance of all diffuse lobes together, per channel."""
    return sum((lobe.normal for lobe in parts if lobe.reflection is Reflection.DIFFUSE), np.zeros(1))


def _total(parts: list[Numbers]) -> float:
    """What the lobes reflect together where each is brightest."""
    return float(np.max(_diffuse(parts))) + sum(float(np.max(lobe.normal)) for lobe in _mirrors(parts))


def _blended(plugins: list[tuple[Any, dict[str, Any], str]]) -> dict[str, Any]:
    """A blend that equals the sum of plugins with the given reflectances."""
    brightest = [float(color.max()) for color, _, _ in plugins]
    total = sum(brightest)
    made = []
    for (color, plugin, name), most in zip(plugins, brightest, strict=True):
        share = most / total if total else 1.0
        made.append((share, plugin | {name: {"type": "rgb", "value": (color / (share or 1.0)).tolist()}}))
    share, result = made[0]
    for other, plugin in made[1:]:
        share += other
        result = {"type": "blendbsdf", "weight": other / share, "first": result, "second": plugin}
    return result


def _element(description: dict[str, Any], name: str = "") -> ElementTree.Element:
    """A dictionary as Mitsuba's XML."""
    if description["type"] == "rgb":
        return ElementTree.Element("rgb", name=name, value=", ".join(f"{x:.9g}" for x in description["value"]))
    element = ElementTree.Element("bsdf", type=description["type"])
    if name and name not in ("first", "second"):
        element.set("id", name)
    for key, value in description.items():
        if key == "type":
            continue
        if isinstance(value, dict):
            child = _element(value, key)
            element.append(child)
        elif isinstance(value, str):
            ElementTree.SubElement(element, "string", name=key, value=plain(value))
        else:
            ElementTree.SubElement(element, "float", name=key, value=f"{value:.9g}")
    return element
