"""The plugins by name: ``motes_NAME`` for every registered model that stands alone, ``motes_dusty``, ``motes_material`` and ``motes_map``."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from motes.errors import ParameterError
from motes.models import BRDF, DustLayer, OrenNayar, TorranceSparrow, registered
from motes.models.particles import SINGLE


def names() -> list[str]:
    """The names of all plugins there are now."""
    return [*(f"motes_{name}" for name in _alone()), "motes_dusty", "motes_material", "motes_map"]


def constructors(mi: Any) -> dict[str, Callable[[Any], Any]]:
    """Constructors for the variant that is set, by the plugins' names."""
    from motes.rendering.dusty_plugin import layer_class, nested_bsdfs
    from motes.rendering.map_plugin import map_class
    from motes.rendering.surface_plugin import material_class, surface_class

    surface, layer = surface_class(mi), layer_class(mi)

    def dusty(properties: Any) -> Any:
        """Over the nested BSDF; where there is none, over the rough surface with a highlight of equations (1)-(11)."""
        scattering = _word(properties, properties.plugin_name(), "scattering") or SINGLE
        if nested_bsdfs(mi, properties):
            return layer(properties, scattering)
        return surface(
            properties, DustLayer(OrenNayar() + TorranceSparrow(), scattering=scattering), (), ("scattering",)
        )

    models = {f"motes_{name}": _model_plugin(surface, name) for name in _alone()}
    return models | {
        "motes_dusty": dusty,
        "motes_material": material_class(mi, surface),
        "motes_map": map_class(mi, surface),
    }


def _alone() -> list[str]:
    """The models that need no other one: what lies over a base has a plugin of its own."""
    return [name for name, cls in registered(BRDF).items() if not any(p.required for p in cls.declared_parts())]


def _model_plugin(surface: type, model: str) -> Callable[[Any], Any]:
    """The constructor of a model's plugin: its parameters are textures, its options and parts words (``fresnel="dielectric"``)."""

    def construct(properties: Any) -> Any:
        cls, owner = registered(BRDF)[model], properties.plugin_name()
        given: dict[str, Any] = {}
        for option in cls.declared_options():
            word = _word(properties, owner, option.name)
            given |= {} if word is None else {option.name: word}
        for place in cls.declared_parts():
            word, classes = _word(properties, owner, place.name), registered(place.accepts)
            if word is not None and word not in classes:
                raise ParameterError(
                    f"{owner}: {place.name} = {word!r} is not one of {', '.join(classes)}", "Name one of them"
                )
            given |= {} if word is None else {place.name: classes[word]()}
        template = cls(**given)
        if not template.reciprocal:
            usual = {option.name: option.default for option in cls.declared_options()}
            options = ", ".join(f"{k} = {word!r}" for k, word in template.options().items() if word != usual.get(k))
            raise ParameterError(f"{owner} with {options} is not reciprocal, so it is no BRDF", "Leave the option out")
        others = [*(o.name for o in cls.declared_options()), *(p.name for p in cls.declared_parts())]
        return surface(properties, template, (), tuple(others))

    return construct


def _word(properties: Any, owner: str, name: str) -> str | None:
    if name not in properties:
        return None
    value = properties.get(name)
    if not isinstance(value, str):
        raise ParameterError(f"{owner}: {name} = {str(value)[:80]} is not a word", "Give its name as a string")
    return value
