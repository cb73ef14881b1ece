"""Which pictures programs want of a map, what each channel of them holds, and how numbers become codes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.drawing.colour import srgb_curve
from motes.exports.texel_surface import TexelSurfaces
from motes.models import GltfSurface, Surface

Floats = NDArray[np.float64]
Constants = dict[str, float | tuple[float, ...]]
#: Values over texels: (y, x), or (y, x, C) for colours.
Grids = Mapping[str, Floats]

#: What is taken for the same at all texels: less than half a code of 16 bits.
SAME = 5e-6
#: What the picture of occlusion says where nobody measured it: open everywhere.
OPEN = "occlusion: 1, it was not measured"


@dataclass(frozen=True)
class Texture:
    """A picture.

    Attributes
    ----------
    name
        What stands in the file's name behind that of the material.
    values
        (y, x, C) before any curve.
    holds
        What each channel is; one entry for a colour.
    srgb
        Whether the first three channels follow sRGB's curve in a PNG; alpha never does.
    factor
        What a program multiplies the picture by.
    real
        Whether it is an OpenEXR picture whatever its values are; those with values above 1 always are.
    """

    name: str
    values: Floats
    holds: tuple[str, ...]
    srgb: bool = False
    factor: float = 1.0
    real: bool = False

    @property
    def suffix(self) -> str:
        """``.png``, or ``.exr`` for what a PNG cannot hold."""
        return ".exr" if self.real or float(self.values.max()) > 1 + SAME else ".png"

    def codes(self, bits: int) -> NDArray[Any]:
        """The numbers of a PNG of 8 or 16 bits."""
        shown = np.clip(self.values, 0.0, 1.0)
        if self.srgb:
            shown[..., :3] = srgb_curve(shown[..., :3])
        codes: NDArray[Any] = np.round((2**bits - 1) * shown).astype(np.uint8 if bits == 8 else np.uint16)
        return codes

    def record(self, file: str, bits: int) -> dict[str, Any]:
        """What JSON says of it."""
        png = self.suffix == ".png"
        curve = "sRGB (IEC 61966-2-1)" if self.srgb and png else "linear"
        return {
            "file": file,
            "channels": list(self.holds),
            "curve": curve,
            "format": f"PNG, {bits} bits" if png else "OpenEXR, float32",
            "factor": self.factor,
        }


@dataclass(frozen=True)
class TextureSet:
    """The pictures of a map at a moment.

    Attributes
    ----------
    name
        Of the material.
    hours
        The moment, None for a map of one.
    textures
        The pictures, by what a document refers to them by.
    constants
        The parameters that are the same at all texels.
    """

    name: str
    hours: float | None
    textures: Mapping[str, Texture]
    constants: Constants

    def file(self, key: str) -> str:
        """The name of a picture's file."""
        texture = self.textures[key]
        return f"{self.name}_{texture.name}{texture.suffix}"


Made = tuple[dict[str, Texture], Constants]


def by_parameter(kind: type[Surface], grids: Grids) -> Made:
    """A picture for every parameter that differs among texels, named as in the program."""
    textures: dict[str, Texture] = {}
    same: dict[str, Floats] = {}
    for name, values in grids.items():
        rows = values.reshape(values.shape[0] * values.shape[1], -1)
        if np.ptp(rows, axis=0).max() <= SAME:
            same[name] = rows[0]
            continue
        colour = values.ndim == 3
        wide = np.repeat(values, 3, axis=2) if colour and values.shape[2] == 1 else values
        textures[name] = Texture(name, wide if colour else values[..., None], (name,), colour)
    first = kind().with_parameters(
        {name: v.reshape(-1, v.shape[-1])[0] if v.ndim == 3 else v.flat[0] for name, v in grids.items()}
    )
    constants = {name: value for name, value in first.written().items() if name not in textures}
    return textures, constants


def orm(kind: type[Surface], grids: Grids) -> Made:
    """Base colour, and occlusion, roughness and metallic in the channels of one picture."""
    one = np.ones_like(grids["roughness"])
    packed = np.stack([one, grids["roughness"], grids["metallic"]], axis=-1)
    return {
        "base_color": _base(grids, "BaseColor"),
        "packed": Texture("OcclusionRoughnessMetallic", packed, (OPEN, "roughness", "metallic")),
    }, {}


def unity(kind: type[Surface], grids: Grids) -> Made:
    """Base map and mask map: metallic, occlusion, the mask of details, smoothness = 1 - roughness."""
    one = np.ones_like(grids["roughness"])
    packed = np.stack([grids["metallic"], one, 0 * one, 1 - grids["roughness"]], axis=-1)
    words = ("metallic", OPEN, "detail mask: 0", "smoothness, 1 - roughness")
    return {"base_color": _base(grids, "BaseMap"), "packed": Texture("MaskMap", packed, words)}, {}


def gltf(kind: type[Surface], grids: Grids) -> Made:
    """The pictures that glTF's core and its extensions of the highlight and of sheen refer to."""
    one = np.ones_like(grids["roughness"])
    packed = np.stack([one, grids["roughness"], grids["metallic"]], axis=-1)
    textures = {
        "base_color": _base(grids, "baseColor"),
        "packed": Texture("metallicRoughness", packed, ("1", "roughness", "metallic")),
    }
    colour, weight = grids["specular_color"], grids["specular"]
    if float(np.abs(colour - 1).max()) > SAME or float(np.abs(weight - 1).max()) > SAME:
        factor = max(1.0, float(colour.max()))
        values = np.concatenate([np.broadcast_to(colour / factor, (*one.shape, 3)), weight[..., None]], axis=2)
        textures["specular"] = Texture("specular", values, ("specularColor", "A: specular"), True, factor)
    if float(grids["sheen_weight"].max()) > SAME:
        shade = np.broadcast_to(grids["sheen_weight"][..., None] * grids["sheen_tint"], (*one.shape, 3))
        values = np.concatenate([shade, grids["sheen_roughness"][..., None]], axis=2)
        textures["sheen"] = Texture("sheen", values, ("sheenColor", "A: sheenRoughness"), True)
    return textures, {}


def _base(grids: Grids, name: str) -> Texture:
    colour = grids["base_color"]
    return Texture(name, np.broadcast_to(colour, (*colour.shape[:2], 3)), (name,), True)


#: glTF's core alone: what is meant by roughness and metallic wherever they are packed.
CORE = (
    "gltf(metallic=0, specular=1, specular_color=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
    "gltf(specular=1, specular_color=1, sheen_weight=0, sheen_tint=1, sheen_roughness=0.5)",
)


@dataclass(frozen=True)
class Layout:
    """How a target has its pictures.

    Attributes
    ----------
    kind
        The surface whose parameters are fitted.
    textures
        Makes the pictures.
    texts
        What of the surface is fitted; its own candidates where there are none.
    normals
        Which way green points in normal maps: ``"OpenGL"`` (up) or ``"DirectX"`` (down).
    notes
        What its files must say.
    words, program
        What the surface is called, and whose it is.
    """

    kind: type[Surface]
    textures: Callable[[type[Surface], Grids], Made]
    texts: tuple[str, ...] = ()
    normals: str = "OpenGL"
    notes: tuple[str, ...] = ()
    words: str = ""
    program: str = ""

    @classmethod
    def of(cls, to: str, kind: type[Surface]) -> Layout:
        """Of a target, whose surface is of this kind."""
        if to == "orm":
            notes = (PACKED, "Normal maps are as Unreal wants them; Godot wants OpenGL's.")
            return cls(GltfSurface, orm, CORE, "DirectX", notes, CORE_WORDS, CORE_PROGRAM)
        if to == "unity":
            notes = (PACKED, "The mask map serves URP's metallic map, too, which takes its red and alpha.")
            return cls(GltfSurface, unity, CORE, "OpenGL", notes, CORE_WORDS, CORE_PROGRAM)
        return cls(kind, gltf if to == "gltf" else by_parameter, words=kind.words, program=kind.program)


CORE_WORDS, CORE_PROGRAM = "roughness and metallic", "glTF 2.0's core (base colour, roughness, metallic)"
PACKED = (
    "Roughness and metallic are those of glTF's core, a dielectric of index 1.5 or a metal: engines' own formulas are near it, "
    "and what they differ by is not in the error."
)


def grids_of(surfaces: TexelSurfaces, rows: slice, source: Any, shape: tuple[int, int]) -> dict[str, Floats]:
    """The values of a moment, whose texels are these rows of the fits, over the texels of the map, each with those of the texel `source`."""
    found = {}
    for name, values in surfaces.values.items():
        grid = values[rows].reshape(*shape, *values.shape[1:])
        found[name] = grid if source is None else grid[source]
    return found
