"""Mitsuba 3: the model's own parameters as bitmaps of ``motes_material``, nothing fitted anew; an XML file without shapes, as of one material."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from motes.exports.mitsuba import VERSION
from motes.exports.texture_files import Source
from motes.exports.texture_moments import Then, model_of
from motes.exports.texture_sets import Texture, TextureSet
from motes.files import write_text
from motes.maps import FittedMap
from motes.material import Material
from motes.rendering.map_textures import channel_order, nearest

NOTE = "The BSDF needs Motes in Mitsuba's Python (motes.rendering.register); row 0 of a picture is at v = 0 of Mitsuba's texture coordinates."


def sets_of(then: Sequence[Then]) -> tuple[list[TextureSet], list[Source]]:
    """The parameters of each moment as pictures, and from where each texel has its values."""
    sets, sources = [], []
    for each in then:
        source = nearest(each.known)
        textures = {}
        for name, values in each.values.items():
            grid = values.reshape(*each.known.shape, -1)
            textures[name] = Texture(name, grid if source is None else grid[source], (name,), real=True)
        sets.append(TextureSet(each.name, each.hours, textures, {}))
        sources.append(source)
    return sets, sources


def write(
    fitted: FittedMap,
    then: Sequence[Then],
    sets: Sequence[TextureSet],
    head: Sequence[str],
    normal: str | None,
    path: Path,
) -> list[Path]:
    """The XML file, and beside it the material that has what all texels share; returns their paths."""
    material = path.with_name(f"{path.name}_material.json")
    model, row = model_of(fitted), int(np.flatnonzero(then[0].known.ravel())[0])
    values = {name: value[row] for name, value in then[0].values.items()}
    channels = tuple(fitted.channels[k] for k in channel_order(fitted))
    about = {"map": fitted.name, **({"data": {"source": fitted.origin}} if fitted.origin else {})}
    Material(model.with_parameters(values), fitted.name, channels, about=about).save(material)
    colours = {slot.name for slot in model.slots() if slot.parameter.per_channel}
    root = ElementTree.Element("scene", version=VERSION)
    root.append(ElementTree.Comment("\n" + "\n".join(head).replace("--", "- -") + "\n"))
    for each in sets:
        place = root
        if normal is not None:
            place = ElementTree.SubElement(root, "bsdf", type="normalmap", id=each.name)
            _bitmap(place, "normalmap", normal, raw=True)
        bsdf = ElementTree.SubElement(place, "bsdf", type="motes_material")
        if normal is None:
            bsdf.set("id", each.name)
        ElementTree.SubElement(bsdf, "string", name="filename", value=material.name)
        for name in each.textures:
            _bitmap(bsdf, name, each.file(name), raw=name not in colours)
    ElementTree.indent(root)
    text = '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"
    return [write_text(path.with_name(f"{path.name}.xml"), text), material]


def _bitmap(parent: ElementTree.Element, name: str, file: str, *, raw: bool) -> None:
    texture = ElementTree.SubElement(parent, "texture", type="bitmap", name=name)
    ElementTree.SubElement(texture, "string", name="filename", value=file)
    ElementTree.SubElement(texture, "boolean", name="raw", value="true" if raw else "false")
