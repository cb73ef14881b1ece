"""MaterialX 1.39: a document with nodes of our own, their implementations, and an approximation by standard nodes.

Three nodes are defined, whose inputs are the parameters of the model:

- ``motes_NAME_bsdf`` (BSDF): in ``genglsl`` (and what inherits from it) the exact BRDF under lights; the environment, and all other
  targets, see the standard lobes.
- ``motes_NAME_lobes`` (BSDF): the nearest `oren_nayar_diffuse_bsdf` and `generalized_schlick_bsdf` (GGX) nodes, in a node graph whose nodes
  convert the parameters (see `motes.exports.approximation`).
- ``motes_NAME_value`` (color3): the exact BRDF [1/sr] for the directions ``light`` and ``view``, in ``genglsl`` and ``genosl``.

Two materials use them: ``NAME`` and ``NAME_lobes``.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from motes.errors import MissingExtraError, MotesError
from motes.exports import materialx_shaders as shaders
from motes.exports.approximation import losses, recorded
from motes.exports.materialx_graph import Graph
from motes.exports.shaders import Prepared, heading, plain, prepare
from motes.exports.subject import Subject
from motes.files import write_text
from motes.parameters import Slot

VERSION = "1.39"
SUFFIX = ".mtlx"


def document(subject: Subject, stem: str | None = None) -> dict[str, str]:
    """The files of a MaterialX document.

    Parameters
    ----------
    subject
        What to export; one or three channels.
    stem
        What the files are called; the subject's identifier by default.

    Returns
    -------
    dict
        Texts by file name: ``stem.mtlx``, and the shaders that it refers to.
    """
    subject.colored("MaterialX")
    prepared, name, stem = prepare(subject.brdf), subject.identifier, stem or subject.identifier
    root = ElementTree.Element("materialx", version=VERSION, colorspace="lin_rec709")
    notes = (*subject.notes, *_said(subject, name))
    head = "\n".join(line.removeprefix("//") for line in heading(prepared, subject.name, f"MaterialX {VERSION}", notes))
    root.append(ElementTree.Comment(head.replace("--", "- -") + "\n"))
    for kind, type_ in (("bsdf", "BSDF"), ("lobes", "BSDF"), ("value", "color3")):
        root.append(_definition(prepared, f"motes_{name}_{kind}", kind, type_, subject))
    for kind, target in (("bsdf", "genglsl"), ("value", "genglsl"), ("value", "genosl")):
        node, file = f"motes_{name}_{kind}", f"{stem}_{kind}.{target[3:]}"
        attributes = {"name": f"IM_{node}_{target}", "nodedef": f"ND_{node}", "file": file}
        ElementTree.SubElement(root, "implementation", attributes | {"function": node, "target": target})
    root.append(_lobes_graph(prepared, name))
    root.append(_fallback_graph(prepared, name))
    for material, kind in ((name, "bsdf"), (f"{name}_lobes", "lobes")):
        _material(root, material, f"motes_{name}_{kind}", prepared)
    ElementTree.indent(root)
    text = '<?xml version="1.0" encoding="utf-8"?>\n' + ElementTree.tostring(root, encoding="unicode") + "\n"
    return {
        f"{stem}.mtlx": text,
        f"{stem}_formula.glsl": shaders.formula(prepared, subject, name),
        f"{stem}_bsdf.glsl": shaders.bsdf(prepared, subject, name, stem),
        f"{stem}_value.glsl": shaders.value(prepared, subject, name, stem),
        f"{stem}_value.osl": shaders.value_in_osl(prepared, subject, name),
    }


def write(subject: Subject, path: Path) -> list[Path]:
    """Write the document, and beside it the shaders that it refers to; the document last."""
    stem = re.sub(r"[^\w-]+", "-", path.stem, flags=re.ASCII).strip("-") or subject.identifier
    main, *others = document(subject, stem).items()
    files = [write_text(path.parent / file, text) for file, text in others]
    return [write_text(path, main[1]), *files]


def check(path: Path) -> str:
    """Read a document with the MaterialX library, validate it, and generate its GLSL, OSL and MDL shaders.

    Returns
    -------
    str
        The version of the library.

    Raises
    ------
    MissingExtraError
        Without the package MaterialX.
    MotesError
        When the library finds the document invalid.
    """
    try:
        import MaterialX as mx
        from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenMdl, PyMaterialXGenOsl, PyMaterialXGenShader
    except ImportError:
        raise MissingExtraError("MaterialX", "materialx", "checking a MaterialX document") from None
    text, search = loaded(mx, path)
    valid, message = text.validate()
    if not valid:
        raise MotesError(f"MaterialX {mx.__version__} finds {path} invalid: {message}", "Report it: this is a defect")
    for module, generator in (
        (PyMaterialXGenGlsl, "GlslShaderGenerator"),
        (PyMaterialXGenOsl, "OslShaderGenerator"),
        (PyMaterialXGenMdl, "MdlShaderGenerator"),
    ):
        writer = getattr(module, generator).create()
        context = PyMaterialXGenShader.GenContext(writer)
        context.registerSourceCodeSearchPath(search)
        for element in PyMaterialXGenShader.findRenderableElements(text):
            writer.generate(element.getName(), element, context)
    return str(mx.__version__)


def loaded(mx: Any, path: Path) -> tuple[Any, Any]:
    """A document read by the MaterialX library `mx`, with the library's own nodes; and where files that it names are looked for."""
    library, document = mx.createDocument(), mx.createDocument()
    search = mx.getDefaultDataSearchPath()
    search.append(mx.FilePath(str(path.parent)))
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, library)
    mx.readFromXmlFile(document, str(path))
    document.setDataLibrary(library)
    return document, search


def _said(subject: Subject, name: str) -> list[str]:
    """What the file says of itself."""
    return [
        f"motes_{name}_bsdf is exact under lights in GLSL; elsewhere it is motes_{name}_lobes, standard nodes that come near:",
        *losses(subject.brdf),
        f"motes_{name}_value is the BRDF itself for two directions, in GLSL and OSL.",
    ]


def _type(prepared: Prepared, slot: Slot) -> str:
    return "color3" if slot.name in prepared.split else "float"


def _text(value: float | tuple[float, ...]) -> str:
    return ", ".join(map(repr, value if isinstance(value, tuple) else (value,)))


def _definition(prepared: Prepared, node: str, kind: str, type_: str, subject: Subject) -> ElementTree.Element:
    """A nodedef."""
    what = {
        "bsdf": "the BRDF, exact in GLSL under lights",
        "lobes": "the nearest standard lobes",
        "value": "the BRDF [1/sr] for the directions light and view",
    }[kind]
    attributes = {"name": f"ND_{node}", "node": node, "nodegroup": "pbr", "doc": plain(f"{subject.name}: {what}")}
    if type_ == "BSDF":
        attributes["bsdf"] = "R"
    element = ElementTree.Element("nodedef", attributes)
    for slot in prepared.slots:
        parameter, many = slot.parameter, slot.name in prepared.split
        said = {"name": slot.name, "type": _type(prepared, slot), "value": _text(prepared.value(slot))}
        said["doc"] = plain(parameter.doc + (f" [{parameter.unit}]" if parameter.unit else ""))
        limits = zip(("uimin", "uimax", "uisoftmin", "uisoftmax"), (*parameter.bounds, *parameter.typical), strict=True)
        said |= {key: _text((x, x, x) if many else x) for key, x in limits if abs(x) < 1e6}
        ElementTree.SubElement(element, "input", said)
    for direction in ("light", "view") if kind == "value" else ():
        doc = f"unit vector to the {'light' if direction == 'light' else 'viewer'}, in world space"
        ElementTree.SubElement(element, "input", name=direction, type="vector3", value="0, 0, 1", doc=doc)
    ElementTree.SubElement(element, "input", name="normal", type="vector3", defaultgeomprop="Nworld")
    ElementTree.SubElement(element, "output", name="out", type=type_)
    return element


def _fallback_graph(prepared: Prepared, name: str) -> ElementTree.Element:
    """What the exact node is where it has no implementation: the lobes."""
    graph = Graph(f"NG_motes_{name}_bsdf", f"ND_motes_{name}_bsdf")
    inputs = {slot.name: graph.interface(slot.name, _type(prepared, slot)) for slot in prepared.slots}
    inputs["normal"] = graph.interface("normal", "vector3")
    graph.output(graph.node(f"motes_{name}_lobes", "BSDF", inputs))
    return graph.element


def _lobes_graph(prepared: Prepared, name: str) -> ElementTree.Element:
    """The standard lobes, with the conversion of the parameters as nodes."""
    graph = Graph(f"NG_motes_{name}_lobes", f"ND_motes_{name}_lobes")
    slots = {slot.name: graph.interface(slot.name, _type(prepared, slot)) for slot in prepared.slots}
    normal = graph.interface("normal", "vector3")
    graph.output(
        graph.total([graph.lobe(lobe, slots, normal) for lobe in recorded(prepared.model) if not lobe.regained])
    )
    return graph.element


def _material(root: ElementTree.Element, material: str, node: str, prepared: Prepared) -> None:
    """A node with the values of the model, a surface and a material."""
    own = ElementTree.SubElement(root, node, name=f"{material}_node", type="BSDF")
    for slot in prepared.slots:
        value = _text(prepared.value(slot))
        ElementTree.SubElement(own, "input", name=slot.name, type=_type(prepared, slot), value=value)
    surface = ElementTree.SubElement(root, "surface", name=f"{material}_surface", type="surfaceshader")
    ElementTree.SubElement(surface, "input", name="bsdf", type="BSDF", nodename=f"{material}_node")
    final = ElementTree.SubElement(root, "surfacematerial", name=material, type="material")
    ElementTree.SubElement(final, "input", name="surfaceshader", type="surfaceshader", nodename=f"{material}_surface")


def limits(subject: Subject) -> list[str]:
    """What the document cannot say."""
    return _said(subject, subject.identifier)
