"""What models declare of themselves: roles, places, kinds of reflection, words, names; and how a composed one is asked for them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from catalogue import ENTRIES, Entry, parts
from motes.arrays import NUMPY, Array
from motes.directions import Geometry
from motes.errors import ParameterError
from motes.models import (
    BRDF,
    Component,
    Conductor,
    CosineLobe,
    Dielectric,
    Dust,
    DustLayer,
    Fresnel,
    Lambert,
    OrenNayar,
    Reflection,
    Retro,
    Schlick,
    TorranceSparrow,
    describe,
    layer_of,
    on_base,
    parse,
    register,
    registered,
    unregister,
)
from motes.models.standard import MEAN_COSINE
from motes.parameters import Parametrised, Place, Role, option, parameter, part

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)
ROCK = OrenNayar(0.5) + TorranceSparrow(0.3, 0.1)


@every_entry
def test_every_parameter_of_motes_has_a_role(entry: Entry) -> None:
    assert all(slot.parameter.role is not None for slot in entry.model.slots())


@every_entry
def test_a_component_is_what_its_lobe_is_made_for(entry: Entry) -> None:
    """Glossy where there is a highlight or what is sent back, and as many as there are of them."""
    glossy = [c for c in entry.model.components(NUMPY, 1.0) if c.reflection is Reflection.GLOSSY]
    back = [part for part in parts(entry.model) if isinstance(part, Retro)]
    assert len(glossy) == len(entry.model.slots(Role.HIGHLIGHT_STRENGTH)) + len(back)
    assert Component(entry.model.formula, CosineLobe(), 1.0, Reflection.GLOSSY).reflection is Reflection.GLOSSY


@every_entry
def test_standard_lobes_are_those_of_the_components(entry: Entry) -> None:
    lobes = entry.model.standard_lobes(NUMPY, entry.model, MEAN_COSINE)
    kinds = [c.reflection for c in entry.model.components(NUMPY, 1.0)]
    if isinstance(entry.model, Retro):  # which no program has
        kinds = [Reflection.DIFFUSE]
    assert [lobe.reflection for lobe in lobes] == kinds
    for cls in {type(p) for p in parts(entry.model) if isinstance(p, BRDF)}:
        assert cls.words or "in_words" in vars(cls)


@pytest.mark.parametrize("term", [Dielectric(1.5), Dielectric(1.0), Conductor((0.2, 1.1), (3.9, 2.4)), Schlick(0.07)])
def test_the_reflectance_at_normal_incidence_is_the_curves_own(term: Fresnel) -> None:
    np.testing.assert_allclose(term.at_normal(), term.reflectance(NUMPY, 1.0), rtol=1e-12, atol=1e-16)


@pytest.mark.parametrize(
    ("model", "words"),
    [
        ("lambert", "Lambert"),
        ("oren_nayar + torrance_sparrow(fresnel=dielectric)", "Oren-Nayar + Torrance-Sparrow with Dielectric Fresnel"),
        ("dust_layer(oren_nayar + torrance_sparrow)", "(Oren-Nayar + Torrance-Sparrow) under dust"),
        ("dust_layer(lambert) + dust", "Lambert under dust + dust"),
    ],
)
def test_words(model: str, words: str) -> None:
    assert parse(model).model.in_words() == words


# ---------------------------------------------------------------- composition


def test_terms_and_what_stands_beside_a_parameter() -> None:
    two = Lambert(0.1) + (TorranceSparrow(0.2, 0.1) + TorranceSparrow(0.3, 0.4))
    assert [describe(t) for t in two.terms()] == ["lambert", "torrance_sparrow", "torrance_sparrow"]
    assert DustLayer(two).terms() == (DustLayer(two),)
    first, second = two.slots(Role.HIGHLIGHT_STRENGTH)
    assert (first.name, second.name) == ("K_s", "K_s_2")
    width = two.beside(second, Role.HIGHLIGHT_WIDTH)
    assert width is not None
    assert (width.name, width.value) == ("sigma_s_2", 0.4)
    assert two.beside(second, Role.DIFFUSE_COLOUR) is None
    assert [s.name for s in two.slots(Role.HIGHLIGHT_WIDTH, Role.DIFFUSE_COLOUR)] == ["K_d", "sigma_s", "sigma_s_2"]


def test_a_layer_is_asked_for_its_own() -> None:
    model = DustLayer(DustLayer(Lambert(0.3), tau=0.1), Dust(0.9, 0.2), 0.5)
    layer = layer_of(model)
    assert layer is not None
    assert (layer.depth.name, layer.depth.value) == ("tau_2", 0.5)
    assert [s.name for s in layer.own] == ["w_2", "g_2", "tau_2"]
    assert [s.name for s in layer.below] == ["K_d", "w", "g", "tau"]
    changed = layer.with_values({Role.ASYMMETRY: -0.1, Role.DEPTH: 0.7})
    assert changed == DustLayer(model.base, Dust(0.9, -0.1), 0.7)
    assert layer.over(ROCK) == DustLayer(ROCK, Dust(0.9, 0.2), 0.5)
    assert layer_of(ROCK) is None
    assert layer_of(model + ROCK) is None  # a sum has no layer on top
    with pytest.raises(ParameterError, match="the layer has no diffuse colour"):
        layer.with_values({Role.DIFFUSE_COLOUR: 0.1})


def test_what_lies_below_all_layers_is_changed() -> None:
    model = DustLayer(DustLayer(Lambert(0.3), tau=0.1), tau=0.5)
    assert (
        describe(on_base(model, lambda base: base + TorranceSparrow()))
        == "dust_layer(dust_layer(lambert + torrance_sparrow))"
    )
    assert on_base(Lambert(), lambda base: ROCK) == ROCK


# ---------------------------------------------------------------- names in texts


def flat(**declared: Any) -> type[BRDF]:
    """A model with these fields."""
    fields = {name: value for name, (_, value) in declared.items()}

    def formula(self: BRDF, xp: Array, geometry: Geometry) -> Array:
        return 0.1

    def components(self: BRDF, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), 0.1)]

    annotations = {name: kind for name, (kind, _) in declared.items()}
    body = {"__annotations__": annotations, "formula": formula, "components": components, **fields}
    return dataclass(frozen=True, eq=False)(type("Flat", (BRDF,), body))


def test_a_registered_model_has_its_options_and_parts_in_texts() -> None:
    cls = flat(
        k=(Array, parameter(0.4, bounds=(0, 1), symbol="k", doc="a number")),
        mode=(str, option("slow", words=("slow", "fast"))),
        below=(BRDF, part(BRDF, place=Place.BASE, default=None)),
    )
    register("flat")(cls)
    try:
        assert registered(BRDF)["flat"] is cls
        model = parse("flat(lambert(K_d=0.2), k=0.3, mode=fast) + lambert").model
        assert model.terms()[0] == cls(k=0.3, mode="fast", below=Lambert(0.2))  # type: ignore[call-arg]
        assert describe(model) == "flat(mode=fast, below=lambert) + lambert"
        assert parse(describe(model, values=True)).model == model
        with pytest.raises(ParameterError, match="Flat: mode = 'quick' is not one of slow, fast"):
            parse("flat(mode=quick)")
        with pytest.raises(ParameterError, match=r"Flat: below = 'lambert' is not a BRDF"):
            cls(below="lambert")  # type: ignore[call-arg]
    finally:
        unregister("flat")
    with pytest.raises(ParameterError, match="'flat' is not a model"):
        parse("flat")
    with pytest.raises(ParameterError, match=r"Flat has no name in texts\. Put @register"):
        describe(cls())


@pytest.mark.parametrize("name", ["", "GGX", "two words", "1st", "if", "a-b"])
def test_a_name_is_lower_case_words(name: str) -> None:
    with pytest.raises(ParameterError, match="is no name for a model"):
        register(name)


def test_what_cannot_be_registered_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"the name lambert is taken by motes.models.lambert.Lambert"):
        register("lambert")(OrenNayar)
    with pytest.raises(ParameterError, match="Flat: the field mode is not declared"):
        register("flat")(flat(mode=(str, "slow")))

    class Bare(BRDF):
        def formula(self, xp: Array, geometry: Geometry) -> Array:
            return 0.1

        def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
            return []

    with pytest.raises(ParameterError, match="Bare is not a frozen dataclass"):
        register("bare")(Bare)
    assert "flat" not in registered(Parametrised)


def test_a_class_that_is_declared_again_takes_its_own_name() -> None:
    """As a cell of a notebook does that is run twice."""
    first, second = flat(), flat()
    try:
        register("flat")(first)
        register("flat")(second)
        assert registered(BRDF)["flat"] is second
    finally:
        unregister("flat")
        unregister("flat")
