"""The files of a set of textures: pictures, and what refers to them."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.exports import texture_documents, texture_gltf
from motes.exports.targets import SURFACES
from motes.exports.texture_moments import Then
from motes.exports.texture_sets import Texture, TextureSet
from motes.files import replacing, write_text
from motes.images import exr, library, png_writing
from motes.models import Surface

Bools = NDArray[np.bool_]
Source = tuple[NDArray[np.int32], NDArray[np.int32]] | None
#: Of the picture of what was fitted: texels with the parameters of another, those with one that the data do not determine
#: or that another scan stands for, and all others.
FILLED, DOUBTFUL, FITTED = 0.0, 0.5, 1.0
SUFFIXES = {"openpbr": ".mtlx", "standard_surface": ".mtlx", "gltf": ".gltf", "blender": ".py"}
PURPOSE = "Writing pictures with values above 1"


def listed(sets: Sequence[TextureSet]) -> list[tuple[TextureSet, Texture, str]]:
    """Every picture with its set and the name of its file."""
    return [(each, texture, each.file(key)) for each in sets for key, texture in each.textures.items()]


def pictures(sets: Sequence[TextureSet], folder: Path, bits: int) -> list[Path]:
    """Write all pictures; raises `MissingExtraError` without OpenImageIO where one is OpenEXR."""
    every = listed(sets)
    if any(texture.suffix == ".exr" for _, texture, _ in every):
        library.oiio(PURPOSE)
    made = []
    for _, texture, file in every:
        if texture.suffix == ".exr":
            made.append(exr.write(folder / file, texture.values, PURPOSE))
        else:
            made.append(write_bytes(folder / file, png_writing.encoded(texture.codes(bits), srgb=texture.srgb)))
    return made


def marks(moments: Sequence[Then], sources: Sequence[Source], folder: Path) -> list[Path]:
    """A picture of what was fitted, where something was not."""
    made = []
    for each, source in zip(moments, sources, strict=True):
        codes = np.where(each.doubtful | each.bridged, DOUBTFUL, FITTED)
        codes[filled(source, codes.shape)] = FILLED
        if (codes != FITTED).any():
            stored = Texture("fitted", codes[..., None], ("fitted",)).codes(8)
            made.append(write_bytes(folder / f"{each.name}_fitted.png", png_writing.encoded(stored)))
    return made


def filled(source: Source, shape: tuple[int, ...]) -> Bools:
    """Which texels have the values of another."""
    if source is None:
        return np.zeros(shape, bool)
    rows, columns = np.indices(shape)
    return np.asarray((source[0] != rows) | (source[1] != columns))


def write_bytes(path: Path, data: bytes) -> Path:
    """Write a file, whole or not at all."""
    with replacing(path) as temporary:
        temporary.write_bytes(data)
    return path


def document(
    to: str,
    sets: Sequence[TextureSet],
    kind: type[Surface],
    head: Sequence[str],
    error: dict[str, Any],
    normal: str | None,
    path: Path,
) -> list[Path]:
    """The file that refers to the pictures, where the target has one."""
    if to not in SURFACES:
        return []
    if to == "gltf":
        text = json.dumps(texture_gltf.document(sets, head, error, normal), indent=1, ensure_ascii=False) + "\n"
    elif to == "blender":
        text = texture_documents.blender(sets, head, normal)
    else:
        text = texture_documents.materialx(sets, kind, head, normal)
    return [write_text(path.with_name(path.name + SUFFIXES[to]), text)]
