"""Paths that users give: what is not there, and where results go."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from motes.errors import DataError
    from motes.maps import FittedMap
    from motes.material import Material

LONGEST_NAME = 60


def material_or_map(text: str) -> Material | FittedMap:
    """What `material_of` gives, or the fitted map that a user names."""
    from motes.errors import DataError
    from motes.maps import FittedMap, open_map
    from motes.presets import given, named

    if not (is_map(text) and isinstance(given(text), Path)):
        return named(text)
    found = open_map(text)
    if not isinstance(found, FittedMap):
        raise DataError(f"{text} holds measured reflectance at every texel", f"motes fit {text} fits every texel")
    return found


def material_of(text: str) -> Material:
    """The material that a user names: a file, a folder of motes fit, a preset or a model's text (see `motes.presets.named`)."""
    from motes.presets import given, named

    if is_map(text) and isinstance(given(text), Path):
        raise many(text)
    return named(text)


def many(store: str, target: str = "") -> DataError:
    """The error for a Zarr store where one material is asked for, such as by the target of an export."""
    from motes.errors import DataError
    from motes.maps import FittedMap, open_map

    if not isinstance(open_map(store), FittedMap):
        return DataError(f"{store} holds measured reflectance at every texel", f"motes fit {store} fits every texel")
    textures = f"--to openpbr, gltf, blender, orm and others write textures instead of {target}; " if target else ""
    return DataError(
        f"{store} holds a material for every texel, and one is asked for",
        f"{textures}motes render {store} -o NAME.png shows it, "
        f"motes view {store} what was fitted at each texel; docs/maps.md says how to take one texel's in Python",
    )


def slug(name: str) -> str:
    """A name as part of a file name: letters, digits, dot, dash and underscore."""
    return re.sub(r"[^\w.-]+", "-", name, flags=re.ASCII).strip("-.")[:LONGEST_NAME] or "material"


def is_map(data: str) -> bool:
    """Whether the argument of a command is a Zarr store; looks at names only."""
    folder = Path(data)
    try:
        return folder.suffix == ".zarr" or any((folder / n).is_file() for n in ("zarr.json", ".zgroup", ".zarray"))
    except (OSError, ValueError):  # no path at all; the command says so
        return False
