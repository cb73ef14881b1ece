"""Models as text: what is written comes back, and no text does anything but name a model or be refused."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from catalogue import ENTRIES, Entry
from motes.errors import ParameterError
from motes.models import (
    BRDF,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Fresnel,
    Lambert,
    OrenNayar,
    Schlick,
    TorranceSparrow,
    describe,
    parse,
    registered,
)
from motes.parameters import Parametrised

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)


@every_entry
def test_a_model_with_its_values_comes_back(entry: Entry) -> None:
    parsed = parse(describe(entry.model, values=True))
    assert parsed.model == entry.model
    assert parsed.fixed == {slot.name for slot in entry.model.slots()}


@every_entry
def test_the_form_of_a_model_comes_back(entry: Entry) -> None:
    form = parse(describe(entry.model))
    assert form.fixed == frozenset()
    assert describe(form.model) == describe(entry.model)
    assert form.model.with_parameters(entry.model.parameters) == entry.model


def test_the_text_is_what_a_person_would_write() -> None:
    assert describe(OrenNayar() + TorranceSparrow(fresnel=Dielectric())) == (
        "oren_nayar + torrance_sparrow(fresnel=dielectric)"
    )
    assert describe(DustLayer(Lambert() + TorranceSparrow())) == "dust_layer(lambert + torrance_sparrow)"
    assert describe(Dust((0.5, 0.25), 0.1), values=True) == "dust(w=[0.5, 0.25], g=0.1)"
    assert describe(Lambert() + (OrenNayar() + Dust())) == "lambert + (oren_nayar + dust)"


@pytest.mark.parametrize(
    ("text", "model", "fixed"),
    [
        ("lambert", Lambert(), set()),
        ("  oren_nayar \n", OrenNayar(), set()),
        ("(lambert)", Lambert(), set()),
        ("lambert()", Lambert(), set()),
        ("oren_nayar + torrance_sparrow", OrenNayar() + TorranceSparrow(), set()),
        ("oren_nayar(sigma_d=0.3) + lambert(K_d=0.1)", OrenNayar(sigma_d=0.3) + Lambert(0.1), {"sigma_d", "K_d_2"}),
        ("lambert(K_d=[0.1, 0.2])", Lambert((0.1, 0.2)), {"K_d"}),
        ("lambert(K_d=(1,))", Lambert((1.0,)), {"K_d"}),
        ("dust(form=brightness, g=-0.5)", Dust(g=-0.5, form="brightness"), {"g"}),
        ("dust(form='brightness')", Dust(form="brightness"), set()),
        ("torrance_sparrow(fresnel=dielectric(n=1.5))", TorranceSparrow(fresnel=Dielectric(1.5)), {"n"}),
        (
            "torrance_sparrow(normalization=facets, fresnel=conductor)",
            TorranceSparrow(normalization="facets", fresnel=Conductor()),
            set(),
        ),
        ("torrance_sparrow(fresnel=schlick(f0=0.04))", TorranceSparrow(fresnel=Schlick(0.04)), {"f0"}),
        ("dust_layer(oren_nayar)", DustLayer(OrenNayar()), set()),
        ("dust_layer(oren_nayar, dust(w=0.9), tau=1)", DustLayer(OrenNayar(), Dust(0.9), 1.0), {"w", "tau"}),
        ("dust_layer(dust=dust(g=0.1), base=lambert)", DustLayer(Lambert(), Dust(g=0.1)), {"g"}),
        ("lambert + (oren_nayar + dust)", Lambert() + (OrenNayar() + Dust()), set()),
    ],
)
def test_texts(text: str, model: BRDF, fixed: set[str]) -> None:
    parsed = parse(text)
    assert parsed.model == model
    assert parsed.fixed == fixed


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is not a sum of models"),
        ("phong", "'phong' is not a model. Write for example"),
        ("oren_nayar +", "is not a sum of models"),
        ("oren_nayar - lambert", "is not a model"),
        ("2 * lambert", "is not a model"),
        ("lambert(0.5)", r"has a value without a name. Write lambert\(K_d=...\)"),
        ("lambert(sigma=1)", "lambert has no parameter 'sigma'"),
        ("lambert(K_d=0.1, **{'K_d': 1})", "has no parameter"),
        ("lambert(K_d=red)", "K_d = 'red' is not a number"),
        ("lambert(K_d=-1)", r"Lambert: K_d = -1 is outside \[0, inf\)"),
        ("lambert(K_d=1e999)", "Lambert: K_d = inf is outside"),
        ("lambert(K_d='0.5')", "is not a number"),
        ("oren_nayar(sigma_d=20)", "20 degrees is 0.349"),
        ("dielectric", "is a Fresnel term, not a BRDF"),
        ("lambert + dielectric", r"Sum: b = Dielectric\(n=1.5\) is not a BRDF"),
        ("dust_layer", "dust_layer has no base"),
        ("dust_layer(tau=1)", "dust_layer has no base"),
        ("dust_layer(lambert, lambert)", "dust = .* is not a Dust"),
        ("dust_layer(dielectric)", "base = .* is not a BRDF"),
        ("dust_layer(lambert, base=lambert)", "given twice"),
        ("torrance_sparrow(fresnel=lambert)", "is not a Fresnel term"),
        ("torrance_sparrow(normalization=round)", "is not one of printed, facets"),
        ("torrance_sparrow(normalization=dust)", "is not one of printed, facets"),
        ("+".join(["lambert"] * 65), "has more than 64 parts"),
    ],
)
def test_errors_name_the_culprit(text: str, message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        parse(text)


MALICIOUS = [
    "__import__('os').system('echo')",
    "lambert(K_d=__import__('os').getpid())",
    "lambert.__class__",
    "lambert.__init__.__globals__",
    "[lambert for _ in ()]",
    "(lambda: lambert)()",
    "lambert if 1 else lambert",
    "lambert(K_d=[0]*10**10)",
    "lambert(K_d=9**9**9)",
    "lambert(K_d=0x" + "f" * 20_000 + ")",
    "lambert(K_d=" + "9" * 20_000 + ")",
    "lambert(K_d=" + "[" * 90 + "1" + "]" * 90 + ")",
    "lambert(K_d=" + "-" * 5_000 + "1)",
    "lambert(K_d={**{}})",
    "lambert(K_d=f'{1}')",
    "lambert(K_d='\\d')",
    "lambert(K_d=0x1for x in y)",
    "1 is 1",
    "lambert; lambert",
    "lambert\nlambert",
    "lambert\x00",
    "lambert\ud800",
    "(" * 400 + "lambert" + ")" * 400,
    "dust_layer(" * 400 + "lambert" + ")" * 400,
    "dust_layer(" * 60 + "lambert" + ")" * 60 + "(",
    "+".join(["lambert"] * 3_000),
    "lambert" * 100_000,
    "lambert(" + ",".join(["K_d=1"] * 500) + ")",
    "yield lambert",
    "await lambert",
    "lambert := lambert",
    "dust(form=[])",
    "dust(form=dust(form=brightness))",
]


@pytest.mark.parametrize("text", MALICIOUS, ids=range(len(MALICIOUS)))
def test_what_is_no_model_is_refused_with_a_sentence(text: str) -> None:
    with pytest.raises(ParameterError) as caught:
        parse(text)
    assert len(str(caught.value)) < 1500


WORDS = [
    *registered(Parametrised),
    "K_d",
    "sigma_d",
    "K_s",
    "g",
    "tau",
    "n",
    "fresnel",
    "normalization",
    "facets",
    "form",
    "base",
    "dust",
]
pieces = st.sampled_from(
    [*WORDS, "+", "(", ")", "=", ",", "[", "]", " ", "0.3", "-1", "1e9", "'", '"', "{", "}", "*", ":", "lambda", "\\"]
)


@settings(max_examples=400)
@given(
    text=st.text(max_size=40) | st.lists(pieces, max_size=12).map("".join) | st.lists(pieces, max_size=12).map(" ".join)
)
@example(text="dust_layer(dust_layer(lambert), tau=0.3)")
def test_any_text_is_a_model_or_a_parameter_error(text: str) -> None:
    try:
        parsed = parse(text)
    except ParameterError:
        return
    assert isinstance(parsed.model, BRDF)
    assert parsed.fixed <= set(parsed.model.parameters)
    assert parse(describe(parsed.model, values=True)).model == parsed.model
    assert np.isfinite(parsed.model.eval([0.0, 0.6, 0.8], [0.0, 0.0, 1.0])).all()


@given(data=st.data())
@every_entry
def test_any_values_come_back(entry: Entry, data: st.DataObject) -> None:
    """All digits of them."""
    values = {}
    for slot in entry.model.slots():
        low, high = (float(np.clip(b, -1e300, 1e300)) for b in slot.parameter.bounds)
        number = st.floats(low, high, exclude_min=slot.parameter.open, exclude_max=slot.parameter.open)
        values[slot.name] = data.draw(
            number | st.lists(number, min_size=2, max_size=2) if slot.parameter.per_channel else number
        )
    model = entry.model.with_parameters(values)
    assert parse(describe(model, values=True)).model == model


def test_every_name_is_a_class_of_its_own() -> None:
    models, terms = registered(BRDF), registered(Fresnel)
    both = registered(Parametrised)
    assert both == models | terms
    assert len(both) == len(models) + len(terms) == len(set(both.values()))
