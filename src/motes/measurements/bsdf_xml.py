"""BSDF files of WINDOW and Radiance (XML): Klems matrices and tensor trees, of reflection from one side.

Values are the BRDF [1/sr] without the cosine, each the mean over a patch of directions (weighted by the cosine); they
are read at the middle of their patches.  WINDOW's front is the outside of a window and Radiance's front is its inside:
``Reflection Back`` in the file is what Radiance calls the front.  See `motes.measurements._angle_basis` and
`motes.measurements._tree_cells` for the directions.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Literal
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MotesError
from motes.files import budget, reading
from motes.files.structured import number_list, xml_tree
from motes.measurements import _tree_cells
from motes.measurements._angle_basis import KLEMS, AngleBasis, towards_light
from motes.measurements.measurement import Measurement

NAME = "bsdf-xml"
SOURCE = "BSDF file of LBNL WINDOW or Radiance (Ward, Kurt, Bonneel 2012)"
SIDES = {"front": "reflection front", "back": "reflection back"}
MOST_RINGS, MOST_IN_RING = 200, 1000
# What a sample takes while it is read and in a Measurement [bytes]: two vectors, values, masks, weights, temporaries.
SAMPLE = 160
_UNITS = {"nm": 1.0, "nanometer": 1.0, "nanometers": 1.0, "um": 1e3, "micron": 1e3, "microns": 1e3, "micrometer": 1e3}

Array = NDArray[np.float64]
Side = Literal["front", "back"]


@dataclass(frozen=True)
class _Block:
    """The numbers of one quantity over directions."""

    wavelength: str
    unit: str
    direction: str
    element: Element


def sniff(path: Path, head: bytes) -> bool:
    return not path.is_dir() and head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<") and b"<WindowElement" in head


def read_bsdf_xml(path: Path, *, side: Side | None = None) -> Measurement:
    """The reflection of a Klems matrix or a tensor tree.

    Parameters
    ----------
    path
        The ``.xml`` file.
    side
        ``"front"`` or ``"back"``, as WINDOW names the sides.  Where it is not given, the one that the file holds; of two the
        back, which is Radiance's front.
    """
    if side is not None and side not in SIDES:
        raise MotesError(f"side = {side!r} is no side", "Give front or back, as WINDOW names them")
    root = xml_tree(path)
    if root.tag != "WindowElement":
        raise FormatError(f"{path} is a file of {root.tag[:40]!r}, not of a WindowElement", "This is not a BSDF file")
    layers = root.findall("Optical/Layer")
    reading.require(len(layers) >= 1, f"{path} has no optical layer", "It holds no BSDF")
    blocks = [block for block in _blocks(layers[0]) if block.direction.startswith("reflection")]
    notes = ["f_r in 1/sr, the mean over each patch of directions, read at its middle, weighted by solid angle"]
    if len(layers) > 1:
        notes.append(f"The first of {len(layers)} layers is read")
    chosen = _side(path, layers[0], blocks, side, notes)
    blocks = [block for block in blocks if block.direction == SIDES[chosen]]
    structure = _text(layers[0], "DataDefinition/IncidentDataStructure").lower()
    if structure.startswith("tensortree"):
        wi, wo, values, names, weights = _trees(path, blocks, structure)
    elif structure in ("rows", "columns"):
        wi, wo, values, names, weights = _matrices(path, layers[0], blocks, structure)
    else:
        raise FormatError(
            f"{path}: the IncidentDataStructure is {structure[:40]!r}",
            "Rows, Columns, TensorTree3 and TensorTree4 are read",
        )
    if chosen == "front":  # seen from behind: turned by pi about the y axis, so that z is the normal of this side
        wi, wo = wi * np.array([-1.0, 1.0, 1.0]), wo * np.array([-1.0, 1.0, 1.0])
    notes.append(f"The side is WINDOW's {chosen}, Radiance's {'back' if chosen == 'front' else 'front'}")
    channels, wavelengths = _channels(path, blocks, names)
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        channels=channels,
        wavelengths=wavelengths,
        weights=weights,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": _text(layers[0], "Material/Name") or path.stem,
            "source": SOURCE,
            "manufacturer": _text(layers[0], "Material/Manufacturer"),
            "side": chosen,
            "structure": structure,
            "notes": notes,
        },
    )


def _text(element: Element, path: str) -> str:
    return (element.findtext(path) or "").strip()[:200]


def _blocks(layer: Element) -> list[_Block]:
    found = []
    for data in layer.findall("WavelengthData"):
        wavelength = data.find("Wavelength")
        unit = "" if wavelength is None else wavelength.get("unit", "").strip()
        for block in data.findall("WavelengthDataBlock"):
            direction = " ".join(_text(block, "WavelengthDataDirection").lower().split())
            found.append(_Block(_text(data, "Wavelength"), unit, direction, block))
    return found


def _side(path: Path, layer: Element, blocks: list[_Block], side: Side | None, notes: list[str]) -> Side:
    """Which side to read."""
    held: list[Side] = [s for s in ("back", "front") if any(b.direction == SIDES[s] for b in blocks)]
    if not held:
        others = sorted({block.direction for block in _blocks(layer)})
        raise FormatError(
            f"{path} holds no reflection, only {', '.join(others)[:200] or 'no data at all'}", "Only reflection is read"
        )
    if side is not None and side not in held:
        raise FormatError(
            f"{path} holds no reflection of the {side}", f"It holds that of the {held[0]}: --read side={held[0]}"
        )
    if len(held) == 2 and side is None:
        notes.append("It holds both sides; the back is read, Radiance's front: side= chooses")
    if any(block.direction.startswith("transmission") for block in _blocks(layer)):
        notes.append("It holds a transmission too, which is not read")
    return side or held[0]


def _numbers(block: _Block, where: str) -> str:
    text = block.element.findtext("ScatteringData") or ""
    if not text.strip():
        raise FormatError(f"{where} has no ScatteringData", "The file is damaged")
    kind = _text(block.element, "ScatteringDataType").upper()
    if kind not in ("", "BRDF", "BTDF"):
        raise FormatError(f"{where} has a ScatteringDataType of {kind[:40]!r}", "BRDF is read")
    return text


def _matrices(
    path: Path, layer: Element, blocks: list[_Block], structure: str
) -> tuple[Array, Array, Array, list[str], Array]:
    bases = {**KLEMS, **_own_bases(path, layer)}
    tables: list[Array] = []
    names: list[str] = []
    grid: tuple[AngleBasis, AngleBasis] | None = None
    for block in blocks:
        where = f"{path}, {block.direction} at {block.wavelength!r}"
        pair = []
        for tag in ("ColumnAngleBasis", "RowAngleBasis"):
            name = _text(block.element, tag)
            if name.lower() not in bases:
                known = ", ".join(basis.name for basis in bases.values())
                raise FormatError(f"{where}: the {tag} {name!r} is not defined", f"These are: {known}")
            pair.append(bases[name.lower()])
        columns, rows = pair
        incident, outgoing = (columns, rows) if structure == "columns" else (rows, columns)
        if grid is not None and grid != (incident, outgoing):
            raise FormatError(f"{where} has other angle bases than the data before it", "All must have the same")
        grid = incident, outgoing
        text = _numbers(block, where)
        budget.check(path, SAMPLE * rows.size * columns.size, f"{rows.size} x {columns.size} patches")
        numbers = number_list(text, where)
        reading.require(
            len(numbers) == rows.size * columns.size,
            f"{where} has {len(numbers):,} values for {rows.size} rows of {columns.size}",
            "It is truncated, or its basis is another",
        )
        table = numbers.reshape(rows.size, columns.size)
        tables.append((table.T if structure == "columns" else table).reshape(-1))  # incident slowest
        names.append(block.wavelength)
    assert grid is not None
    incident, outgoing = grid
    n_in, n_out = incident.size, outgoing.size
    wi = np.repeat(towards_light(incident.centres()), n_out, axis=0)
    wo = np.tile(outgoing.centres(), (n_in, 1))
    weights = np.outer(incident.solid_angle, outgoing.solid_angle).reshape(-1)
    return wi, wo, np.stack(tables, axis=-1), names, weights


def _own_bases(path: Path, layer: Element) -> dict[str, AngleBasis]:
    """The bases that a file defines."""
    found: dict[str, AngleBasis] = {}
    for element in layer.findall("DataDefinition/AngleBasis"):
        name = _text(element, "AngleBasisName")
        edges, counts = [0.0], []
        blocks = element.findall("AngleBasisBlock")
        if not name or not blocks:
            continue
        reading.require(
            len(blocks) <= MOST_RINGS, f"{path}: the basis {name!r} has {len(blocks)} rings", f"At most {MOST_RINGS}"
        )
        for block in blocks:
            upper = reading.numbers([_text(block, "ThetaBounds/UpperTheta") or "nan"], f"{path}, basis {name!r}")[0]
            lower = reading.numbers([_text(block, "ThetaBounds/LowerTheta") or "nan"], f"{path}, basis {name!r}")[0]
            count = reading.integer(_text(block, "nPhis")) or 0
            if not (abs(lower - edges[-1]) < 1e-4 and edges[-1] < upper <= 90 + 1e-6 and 0 < count <= MOST_IN_RING):
                raise FormatError(
                    f"{path}: a ring of the basis {name!r} spans {lower:g} to {upper:g} degrees in {count} parts",
                    f"Rings follow each other from 0 to 90 degrees, with 1 to {MOST_IN_RING} parts",
                )
            edges.append(min(float(upper), 90.0))
            counts.append(count)
        found[name.lower()] = AngleBasis(name, tuple(edges), tuple(counts))
    return found


def _trees(path: Path, blocks: list[_Block], structure: str) -> tuple[Array, Array, Array, list[str], Array]:
    d = {"tensortree3": 3, "tensortree4": 4}.get(structure)
    if d is None:
        raise FormatError(f"{path} holds a {structure[:40]!r}", "TensorTree3 and TensorTree4 are read")
    trees: dict[str, _tree_cells.Leaves] = {}
    for block in blocks:
        where = f"{path}, {block.direction} at {block.wavelength!r}"
        basis = _text(block.element, "AngleBasis")
        if basis.lower() != "lbnl/shirley-chiu":
            raise FormatError(f"{where}: the angle basis is {basis!r}", "LBNL/Shirley-Chiu is read for tensor trees")
        text = _numbers(block, where)
        budget.check(path, SAMPLE * (len(text) // 8 + 1), "the cells of its tree")
        trees[block.wavelength.lower()] = _tree_cells.parse(text, d, where)
    first = trees.get("visible") or next(iter(trees.values()))
    corner, edge = first.corner, first.edge
    middle = corner + edge[:, None] / 2
    used = np.ones(len(middle), bool)
    if d == 3:  # only the lower half of the first coordinate means anything; a cell that covers it all is cut there
        used = corner[:, 0] < 0.5
        middle[:, 0] = np.minimum(middle[:, 0], 0.25) * (edge >= 1) + middle[:, 0] * (edge < 1)
    middle, edge = middle[used], edge[used]
    if d == 3:
        sin = 1 - 2 * middle[:, 0]
        wi = np.stack([-sin, np.zeros_like(sin), np.sqrt(np.maximum(1 - sin**2, 0))], axis=-1)
        measure = sin / wi[:, 2]  # d omega_i over the azimuth, sin d theta = (sin/cos) d sin
    else:
        wi = towards_light(_up(middle[:, :2]))
        measure = 1 / wi[:, 2]
    wo = _up(middle[:, -2:])
    weights = edge**d * measure / wo[:, 2]
    values = {name: tree.lookup(middle) if tree is not first else tree.value[used] for name, tree in trees.items()}
    if {"visible", "cie-u", "cie-v"} <= values.keys():
        y, u, v = (values.pop(name) for name in ("visible", "cie-u", "cie-v"))
        with np.errstate(divide="ignore", invalid="ignore"):  # X/Y and Z/Y from the chromaticity u', v' (CIE 1976)
            values |= {"cie-x": y * 9 * u / (4 * v), "visible": y, "cie-z": y * (12 - 3 * u - 20 * v) / (4 * v)}
    return wi, wo, np.stack(list(values.values()), axis=-1), list(values), weights


def _up(square: Array) -> Array:
    """Directions (n, 3) above the surface at coordinates of the square."""
    x, y = _tree_cells.to_disk(square)
    return np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], axis=-1)


def _channels(path: Path, blocks: list[_Block], names: list[str]) -> tuple[list[str], Array | None]:
    """Names, and wavelengths [nm] where all channels have one."""
    units = {block.wavelength: block.unit.lower() for block in blocks}
    nm = []
    for name in names:
        match = re.fullmatch(r"([0-9.]+(?:[eE][-+]?\d+)?)\s*([a-zA-Z]*)", name)
        factor = _UNITS.get((match[2] or units.get(name, "")).lower()) if match else None
        if match is None or factor is None:
            break
        nm.append(float(reading.numbers([match[1]], str(path))[0]) * factor)
    if len(nm) == len(names):
        return [f"{w:g} nm" for w in nm], np.array(nm)
    lower = [name.lower() for name in names]
    if len(lower) == 3 and set(lower) == {"visible", "cie-x", "cie-z"}:
        return [{"cie-x": "X", "visible": "Y", "cie-z": "Z"}[name] for name in lower], None
    labels = [name or f"channel {k}" for k, name in enumerate(lower, 1)]
    return labels if len(set(labels)) == len(labels) else [f"{name} {k}" for k, name in enumerate(labels, 1)], None
