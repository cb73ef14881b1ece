"""The plugins by name."""

from __future__ import annotations

from typing import Any

from motes.errors import ParameterError
from motes.models import DustLayer, OrenNayar, TorranceSparrow
from motes.models.expressions import FRESNEL


def constructors(mi: Any) -> dict[str, Any]:
    """Constructors for the variant that is set, by the plugins' names."""
    from motes.rendering.dusty_plugin import layer_class, nested_bsdfs
    from motes.rendering.surface_plugin import material_class, surface_class

    surface, layer = surface_class(mi), layer_class(mi)

    def torrance_sparrow(properties: Any) -> Any:
        """Options: ``normalization`` ("printed" or "facets") and ``fresnel`` ("dielectric", "conductor" or "schlick")."""
        name = properties.plugin_name()
        fresnel, normalization = _option(properties, name, "fresnel"), _option(properties, name, "normalization")
        if fresnel is not None and fresnel not in FRESNEL:
            raise ParameterError(f"{name}: fresnel = {fresnel!r} is not one of {', '.join(FRESNEL)}")
        options: dict[str, Any] = {} if normalization is None else {"normalization": normalization}
        if fresnel is not None:
            options["fresnel"] = FRESNEL[fresnel]()
        return surface(properties, TorranceSparrow(**options), (), ("fresnel", "normalization"))

    def dusty(properties: Any) -> Any:
        """Over the nested BSDF; where there is none, over the rough surface with a highlight of equations (1)-(11)."""
        if nested_bsdfs(mi, properties):
            return layer(properties)
        return surface(properties, DustLayer(OrenNayar() + TorranceSparrow()))

    return {
        "motes_oren_nayar": lambda properties: surface(properties, OrenNayar()),
        "motes_torrance_sparrow": torrance_sparrow,
        "motes_dusty": dusty,
        "motes_material": material_class(mi, surface),
    }


def _option(properties: Any, owner: str, name: str) -> str | None:
    if name not in properties:
        return None
    value = properties.get(name)
    if not isinstance(value, str):
        raise ParameterError(f"{owner}: {name} = {str(value)[:80]} is not a word", "Give its name as a string")
    return value
