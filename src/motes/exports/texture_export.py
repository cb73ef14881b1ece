"""`export_textures`: a fitted map as the set of pictures that another program takes, with its own parameters fitted at every texel."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from motes import models
from motes.channels import names_or_default
from motes.drawing.colour import channels_to_srgb
from motes.errors import DataError, ParameterError
from motes.exports import texture_files as files
from motes.exports import texture_mitsuba, texture_picture
from motes.exports import texture_words as words
from motes.exports.shaders import plain
from motes.exports.subject import identifier
from motes.exports.targets import SURFACES, TEXTURES, Exported, either
from motes.exports.texel_surface import Progress, TexelSurfaces, fit_texels, for_directions
from motes.exports.texture_files import Source
from motes.exports.texture_moments import Then, model_of, moments_of
from motes.exports.texture_normals import normal_map
from motes.exports.texture_sets import Layout, TextureSet, grids_of
from motes.files import together, write_text
from motes.maps import FittedMap
from motes.rendering.map_textures import channel_order, nearest
from motes.version import __version__

BITS = (8, 16)
#: The target that takes the model's own parameters.
OWN = "mitsuba"


def title_of(to: str) -> str | None:
    """What a target is, for people; None where it takes no map."""
    if to == OWN:
        return "Mitsuba 3: the model's own parameters as bitmaps"
    return TEXTURES[to].title if to in TEXTURES else SURFACES[to][0].title if to in SURFACES else None


def export_textures(
    fitted: FittedMap,
    to: str,
    folder: str | os.PathLike[str] | None = None,
    *,
    hours: float | Sequence[float] | None = None,
    bits: int = 8,
    normal: str | os.PathLike[str] | None = None,
    flip_green: bool = False,
    progress: Progress | None = None,
) -> Exported:
    """Write a fitted map as textures.

    Parameters
    ----------
    fitted
        The map.
    to
        A key of `SURFACES` or `TEXTURES`: ``"openpbr"``, ``"standard_surface"``, ``"gltf"``, ``"blender"``, ``"orm"`` or ``"unity"``; or
        ``"mitsuba"``, for the model's own parameters.
    folder
        Where the files go; one named after the map and the target, in the current folder, when not given.
    hours
        The moment [h], the map's first one by default; of several, each has its own pictures.
    bits
        Of PNG: 8 or 16.
    normal
        A normal map that goes along as it is.
    flip_green
        Whether its green is turned round: from OpenGL's convention to DirectX's, or back.
    progress
        Told the number of texels done, how many there are, and a word.

    Returns
    -------
    Exported
        Its `fits` holds one record: what the JSON says.

    Raises
    ------
    ParameterError
        For a target that is for one material, bits or moments that cannot be.
    DataError
        When no texel has a fit, or the channels are no colours.
    FormatError
        When a part of the store or the normal map cannot be read.
    MissingExtraError
        Without OpenImageIO, where values go above 1.
    MotesError
        When the files cannot be written.
    """
    if title_of(to) is None:
        raise ParameterError(
            f"{to} takes one material, and {fitted.path} holds one at every texel",
            f"Textures go to {either([*SURFACES, OWN, *TEXTURES])}",
        )
    if bits not in BITS:
        raise ParameterError(f"pictures of {bits} bits", f"They have {BITS[0]} or {BITS[1]}")
    if flip_green and normal is None:
        raise ParameterError("there is no normal map whose green could be turned", "Name it with --normal FILE")
    name = identifier(fitted.name)
    place = Path(f"{name}_{to}") if folder is None else Path(folder)
    if place.suffix and not place.is_dir():
        raise ParameterError(
            f"{place} is the name of a file, and textures are many",
            f"Name a folder, such as -o {place.with_suffix('')}",
        )
    turned = None if normal is None else normal_map(Path(normal), flip_green)
    then = moments_of(fitted, name, hours)
    if to == OWN:
        return _own(fitted, then, name, place, hours is None, turned, flip_green)
    layout = Layout.of(to, getattr(models, SURFACES[to][1]) if to in SURFACES else models.GltfSurface)
    with together(place) as staging:
        surfaces = _fitted(fitted, then, layout, progress)
        sets, sources = _sets(then, surfaces, layout)
        drawn = [*files.pictures(sets, staging, bits), *files.marks(then, sources, staging)]
        listed = [each.record(file, bits) for _, each, file in files.listed(sets)]
        notes = words.notes(fitted, then, sources, hours is None)
        notes += [*words.errors(surfaces, layout), *words.numbers(sets, bits)]
        beside = None
        if turned is not None:
            beside = f"{name}_normal.png"
            notes.append(words.about_normals(turned[1], fitted.shape, layout.normals, flip_green))
            drawn.append(files.write_bytes(staging / beside, turned[0]))
        record = words.record(fitted, to, layout, surfaces, then, sources, listed, notes)
        head = [
            plain(f"{fitted.name}: {fitted.model}"),
            f"as {layout.program}, by Motes {__version__}.",
            *map(plain, notes),
        ]
        made = files.document(to, sets, layout.kind, head, record["error"], beside, staging / name)
        made.append(write_text(staging / f"{name}_fit.json", json.dumps(record, indent=2, ensure_ascii=False) + "\n"))
        made.append(write_text(staging / f"{name}_fit.svg", _drawn(fitted, then, surfaces, sources, layout)))
        made.append(write_text(staging / "README.txt", words.readme(head, listed, beside)))
    return Exported(tuple(place / file.name for file in [*made, *drawn]), tuple(notes), (record,))


def _own(
    fitted: FittedMap,
    then: Sequence[Then],
    name: str,
    place: Path,
    chosen: bool,
    turned: tuple[bytes, tuple[int, int]] | None,
    flip_green: bool,
) -> Exported:
    """The model's own parameters for Mitsuba."""
    with together(place) as staging:
        sets, sources = texture_mitsuba.sets_of(then)
        drawn = [*files.pictures(sets, staging, 8), *files.marks(then, sources, staging)]
        notes = [*words.notes(fitted, then, sources, chosen), texture_mitsuba.NOTE, words.REAL]
        beside = None
        if turned is not None:
            beside = f"{name}_normal.png"
            notes.append(words.about_normals(turned[1], fitted.shape, "OpenGL", flip_green))
            drawn.append(files.write_bytes(staging / beside, turned[0]))
        head = [plain(f"{fitted.name}: {fitted.model}"), f"for Mitsuba 3, by Motes {__version__}.", *map(plain, notes)]
        made = texture_mitsuba.write(fitted, then, sets, head, beside, staging / name)
        listed = [each.record(file, 8) for _, each, file in files.listed(sets)]
        made.append(write_text(staging / "README.txt", words.readme(head, listed, beside)))
    return Exported(tuple(place / file.name for file in [*made, *drawn]), tuple(notes))


def _fitted(fitted: FittedMap, moments: Sequence[Then], layout: Layout, progress: Progress | None) -> TexelSurfaces:
    """The surfaces of all texels that have a fit, at all moments; as many rows as there are texels, those without one NaN."""
    if len(fitted.channels) not in (1, 3):
        raise DataError(
            f"{fitted.path} has {len(fitted.channels)} channels, and textures hold one or three",
            "Name the channels R, G and B where they are, in the measured map",
        )
    known = np.concatenate([each.known.ravel() for each in moments])
    values = {q: np.concatenate([each.values[q] for each in moments])[known] for q in moments[0].values}
    found = fit_texels(model_of(fitted), values, layout.kind, layout.texts, progress)
    return found.spread(known)


def _sets(moments: Sequence[Then], surfaces: TexelSurfaces, layout: Layout) -> tuple[list[TextureSet], list[Source]]:
    """The pictures of each moment, and from where each texel has its values."""
    sets, sources = [], []
    for k, each in enumerate(moments):
        rows = slice(k * each.known.size, (k + 1) * each.known.size)
        whole = surfaces.found[rows].reshape(each.known.shape)
        source = nearest(whole)
        grids = grids_of(surfaces, rows, source, each.known.shape)
        textures, constants = layout.textures(layout.kind, grids)
        sets.append(TextureSet(each.name, each.hours, textures, constants))
        sources.append(source)
    return sets, sources


def _drawn(
    fitted: FittedMap, moments: Sequence[Then], surfaces: TexelSurfaces, sources: Sequence[Source], layout: Layout
) -> str:
    """The picture of the first moment and of the last."""
    model, every = model_of(fitted), texture_picture.step(fitted.shape)
    size = fitted.shape[0] * fitted.shape[1]
    patches = []
    for k in sorted({0, len(moments) - 1}):
        grid = np.arange(size).reshape(fitted.shape)
        source = sources[k]
        shown = (grid if source is None else grid[source])[::every, ::every]
        rows = shown.ravel()
        exact = model.with_parameters(for_directions(model, moments[k].values, rows))
        when = "" if moments[k].hours is None else f"{moments[k].hours:g} h"
        patches.append(texture_picture.Patch(when, exact, surfaces.model(rows + k * size), shown.shape))
    order = channel_order(fitted)
    names = names_or_default([fitted.channels[c] for c in order], len(order))
    matrix = np.asarray(channels_to_srgb(names).matrix, np.float64)
    return texture_picture.picture(patches, f"{fitted.name} as {layout.program}", layout.words, matrix)
