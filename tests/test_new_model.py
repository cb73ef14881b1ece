"""A new model, declared here as a newcomer would, goes through everything: no other file knows its name."""

from __future__ import annotations

import base64
import json
import math
import re
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, Self

import numpy as np
import pytest
from numpy.typing import NDArray

import motes
from catalogue import dense_albedo, upper_directions
from motes.ageing import age
from motes.arrays import Array
from motes.directions import HALF_PI, Geometry, Vector
from motes.exports import TARGETS, export
from motes.material import Material, load
from motes.measurements import Measurement
from motes.models import (
    BRDF,
    Component,
    CosineLobe,
    Lobe,
    Reflection,
    StandardLobe,
    describe,
    parse,
    register,
    unregister,
)
from motes.parameters import Role, parameter

# ---------------------------------------------------------------- the model: what a newcomer writes
# BEGIN


def D(alpha: Array, geometry: Geometry) -> Array:
    """The GGX distribution of facet normals [1/sr], Walter et al. 2007, equation (33)."""
    cosine, sine = geometry.cos_theta_h, geometry.sin_theta_h
    t = alpha * alpha * cosine * cosine + sine * sine
    return alpha * alpha / (math.pi * t * t)


@dataclass(frozen=True)
class NewcomerLobe(Lobe):
    """Mirror at a facet whose normal has the density D cos(theta_h)."""

    alpha: Array
    reflection: ClassVar[Reflection] = Reflection.GLOSSY

    def sample(self, xp: Array, wi: Array, u: Array) -> Array:
        cosine = 1 / xp.sqrt(1 + self.alpha * self.alpha * u[..., 0] / (1 - u[..., 0]))
        sine, phi = xp.sqrt(xp.maximum(1 - cosine * cosine, 0.0)), 2 * math.pi * u[..., 1]
        x, y, i = sine * xp.cos(phi), sine * xp.sin(phi), Vector.split(wi)
        twice = 2 * (i.x * x + i.y * y + i.z * cosine)
        return xp.stack([twice * x - i.x, twice * y - i.y, twice * cosine - i.z])

    def pdf(self, xp: Array, wi: Array, wo: Array) -> Array:
        g = Geometry(xp, Vector.split(wi), Vector.split(wo))
        return D(self.alpha, g) * g.cos_theta_h / (4 * g.cos_theta_d)


@dataclass(frozen=True, eq=False)
class Newcomer(BRDF):
    """A highlight with long tails, Walter et al. 2007, with the height-correlated shadowing of Heitz 2014."""

    words: ClassVar[str] = "Newcomer"
    approximation: ClassVar[str] = "Newcomer: GGX's lobe, with F = 1."
    K_s: Array = parameter(
        0.3, bounds=(0, float("inf")), typical=(0, 1), symbol="K_s", doc="share of light that facets reflect",
        per_channel=True, shared_in_fit=True, role=Role.HIGHLIGHT_STRENGTH,
    )  # fmt: skip
    alpha: Array = parameter(
        0.2, bounds=(0.001, 1), typical=(0.02, 0.8), starts=(0.03, 0.1, 0.3, 0.7), symbol="\\alpha",
        doc="roughness of Walter et al.", role=Role.HIGHLIGHT_WIDTH,
    )  # fmt: skip

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        i, r, a2 = geometry.cos_theta_i, geometry.cos_theta_r, self.alpha * self.alpha
        smith = r * xp.sqrt(a2 + (1 - a2) * i * i) + i * xp.sqrt(a2 + (1 - a2) * r * r)
        return self.K_s * D(self.alpha, geometry) * 0.5 / smith

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, NewcomerLobe(self.alpha), self.K_s)]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.GLOSSY, values.K_s, roughness=values.alpha)]


# END
# ---------------------------------------------------------------- what is checked

PAINT = "lambert + newcomer"
TRUTH = {"K_d": np.array([0.3, 0.2, 0.1]), "K_s": 0.12, "alpha": 0.18}
Floats = NDArray[np.float64]


@pytest.fixture(autouse=True)
def known() -> Iterator[None]:
    register("newcomer")(Newcomer)
    yield
    unregister("newcomer")


def paint() -> BRDF:
    return parse(PAINT).model.with_parameters(TRUTH)


def simulated(seed: int = 5) -> Measurement:
    """900 noisy values, a third of them near the mirror direction."""
    rng = np.random.default_rng(seed)
    wi, wo = upper_directions(900, seed), upper_directions(900, seed + 1)
    near = wi[:300] * [-1, -1, 1] + rng.normal(0, 0.12, (300, 3))
    near[:, 2] = np.maximum(near[:, 2], 0.05)
    wo[:300] = near / np.linalg.norm(near, axis=1, keepdims=True)
    values = paint().eval(wi, wo)
    return Measurement.from_arrays(wi, wo, values * (1 + 0.01 * rng.normal(size=values.shape)))


def test_it_is_short() -> None:
    text = Path(__file__).read_text(encoding="utf-8")
    model = text.split("# BEGIN\n")[1].split("# END\n")[0].strip("\n").split("\n")
    assert len(model) <= 60


def test_values_are_those_of_walter_and_heitz() -> None:
    """By angles, with Lambda as Heitz writes it, and no formula of the model above."""
    wi, wo = upper_directions(200, 1), upper_directions(200, 2)
    half = (wi + wo) / np.linalg.norm(wi + wo, axis=1, keepdims=True)
    theta_i, theta_o, theta_h = (np.arccos(w[:, 2]) for w in (wi, wo, half))
    alpha = 0.35
    d = alpha**2 / (np.pi * np.cos(theta_h) ** 4 * (alpha**2 + np.tan(theta_h) ** 2) ** 2)
    Lambda = [(np.sqrt(1 + (alpha * np.tan(t)) ** 2) - 1) / 2 for t in (theta_i, theta_o)]
    expected = 0.7 * d / (1 + sum(Lambda)) / (4 * np.cos(theta_i) * np.cos(theta_o))
    np.testing.assert_allclose(Newcomer(0.7, alpha).eval(wi, wo)[:, 0], expected, rtol=1e-9)


def test_it_samples_what_it_says() -> None:
    model, wi = Newcomer(0.8, 0.3), np.array([0.6, 0.0, 0.8])
    u = np.random.default_rng(0).random((200_000, 2))
    _, _, weight = model.sample(np.broadcast_to(wi, (len(u), 3)), u)
    assert weight.mean() == pytest.approx(float(dense_albedo(model, wi)[0]), rel=0.01)
    np.testing.assert_allclose(model.directional_albedo(wi), dense_albedo(model, wi), rtol=1e-3)


def test_text_and_file(tmp_path: Path) -> None:
    model = paint()
    assert describe(model) == PAINT
    assert parse(describe(model, values=True)).model == model
    assert load(Material(model, channels=("R", "G", "B")).save(tmp_path / "m.json")).brdf == model


def test_many_values_are_compiled_to_the_same() -> None:
    from motes.kernels import engine

    if not engine.available():
        pytest.skip("nothing can be compiled here")
    wi, wo = upper_directions(500, 3), upper_directions(500, 4)
    few = paint().eval(wi, wo)
    np.testing.assert_allclose(engine.evaluate(paint(), wi, wo), few, rtol=1e-12)


def test_fit_and_report(tmp_path: Path) -> None:
    fit = motes.fit(simulated(), model=PAINT)
    assert fit.status.ok
    for name, value in TRUTH.items():
        found = fit.parameters[name]
        assert np.all(np.abs(np.asarray(found.value) - value) < 5 * np.asarray(found.stderr)), name
    page = tmp_path / "report.html"
    fit.report(page)
    text = page.read_text(encoding="utf-8")
    assert "Lambert + Newcomer" in text
    assert "share of light that facets reflect" in text


def test_view(tmp_path: Path) -> None:
    view = motes.view(Material(paint(), name="new paint", channels=("R", "G", "B")))
    page = tmp_path / "viewer.html"
    view.save(page)
    text = page.read_text(encoding="utf-8")
    assert "uniform float motes_alpha" in text
    found = re.search(r'"library":"([^"]+)"', text)
    assert found
    # The library of pieces has it, for materials that are dropped.
    assert b"newcomer_eval_with(" in zlib.decompress(base64.b64decode(found[1]))


@pytest.mark.slow
def test_view_in_a_browser(tmp_path: Path) -> None:
    """The page knows the model, which its script does not; and puts a dropped material together with it."""
    from viewer_support import Viewed, browser, driver

    wi, wo = upper_directions(300, 7), upper_directions(300, 8)
    page = tmp_path / "viewer.html"
    motes.view(Material(paint(), name="new paint", channels=("R", "G", "B"))).save(page)
    dropped = parse("dust_layer(newcomer(K_s=0.2, alpha=0.4) + oren_nayar, tau=0.3)").model
    with driver() as playwright, browser(playwright) as running, Viewed(running, page) as viewed:
        viewed.settled()
        np.testing.assert_allclose(viewed.evaluate(0, wi, wo), paint().eval(wi, wo), rtol=1e-4, atol=1e-5)
        viewed.drop("material.json", json.dumps(Material(dropped, name="dropped").to_dict()))
        viewed.wait("app.material(0).name === 'dropped' && !app.plotsDue")
        found = viewed.evaluate(0, wi, wo)
        np.testing.assert_allclose(found, np.broadcast_to(dropped.eval(wi, wo), found.shape), rtol=1e-4, atol=1e-5)
        assert not viewed.errors


BY_LOBES = {"osl", "materialx", "mitsuba"}  # also; all others hold the formula itself, or its values


@pytest.mark.parametrize("to", TARGETS)
def test_exports(to: str, tmp_path: Path) -> None:
    material = Material(paint(), name="new paint", channels=("R", "G", "B"))
    if to == "openmaterial":  # tables of wavelengths
        material = Material(
            paint(), name="new paint", channels=("630 nm", "530 nm", "450 nm"), wavelengths=(630, 530, 450)
        )
    done = export(material, to, tmp_path / f"paint{TARGETS[to].suffix}")
    texts = [f.read_bytes().decode("utf-8", "replace") for f in done.files]
    if to not in BY_LOBES:
        assert not any("Newcomer" in note for note in done.notes)
    else:
        assert Newcomer.approximation in done.notes
        assert Newcomer.approximation in " ".join(" ".join(texts).replace("//", " ").split())
    if to == "mitsuba":
        assert '<float name="alpha" value="0.18" />' in texts[0]
        assert json.loads(texts[1])["model"] == PAINT
    if to == "materialx":
        assert "generalized_schlick_bsdf" in texts[0]
    if to == "osl":
        assert "generalized_schlick_bsdf(Normal, tangent, color(1.0), color(0.0), alpha, alpha, color(1.0)" in texts[0]


def test_mitsuba_plugin() -> None:
    from motes.rendering import load_mitsuba, load_scene
    from motes.rendering import register as register_plugins
    from plugin_support import needs_llvm  # noqa: F401  (skips without Mitsuba)

    mi = load_mitsuba()
    register_plugins()  # the variant may have been set before the model was known
    bsdf = load_scene({"type": "motes_newcomer", "K_s": 0.4, "alpha": 0.25})
    flags = mi.BSDFFlags
    assert bsdf.component_count() == 1
    assert bsdf.flags(0) & flags.GlossyReflection
    assert not bsdf.flags(0) & flags.DiffuseReflection
    si, wi, wo = mi.SurfaceInteraction3f(), [0.48, 0.0, math.sqrt(1 - 0.48**2)], [-0.36, 0.48, 0.8]
    si.wi = wi
    value = np.ravel(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(wo)))
    np.testing.assert_allclose(value, Newcomer(0.4, 0.25).eval(wi, wo)[0] * wo[2], rtol=2e-5)


@pytest.mark.parametrize("phenomenon", ["drying_paint", "drying_surface", "rusting"])
def test_ageing_uses_its_own_highlight(phenomenon: str) -> None:
    aged = age(paint(), phenomenon, hours=10)
    assert describe(aged.brdf) == PAINT
    start, end = aged.at(0).parameters, aged.at(10).parameters
    heights = [p["K_s"] / p["alpha"] ** 2 for p in (start, end)]
    assert heights[0] > 1.2 * heights[1]  # wet, or not yet rusty, it shines more
    if phenomenon == "drying_paint":
        assert set(aged.trends) == {"K_d", "K_s", "alpha"}
        assert end["alpha"] / start["alpha"] == pytest.approx(1.8, rel=0.05)
        assert heights[1] / heights[0] == pytest.approx(0.3, rel=0.15)  # K_s_left, of the height
    under = age(motes.DustLayer(motes.Lambert(0.4) + Newcomer()), "drying_surface", hours=10)
    assert describe(under.brdf) == "dust_layer(lambert + newcomer)"


def test_map_fit(tmp_path: Path) -> None:
    pytest.importorskip("zarr")
    from motes.maps import create_map, fit_map

    data = simulated()
    rng = np.random.default_rng(9)
    strengths = np.linspace(0.05, 0.25, 6).reshape(2, 3)
    values = np.stack([[paint().with_parameters({"K_s": k}).eval(data.wi, data.wo) for k in row] for row in strengths])
    values = values * (1 + 0.01 * rng.normal(size=values.shape))
    stack = create_map(tmp_path / "map.zarr", (2, 3), data.wi, data.wo, hours=[0.0], channels=("R", "G", "B"), chunk=4)
    stack.write(0, 0, values[:, :, None].astype(np.float32))
    fitted = fit_map(stack, PAINT, out=tmp_path / "fit.zarr")
    np.testing.assert_allclose(fitted.values("K_s")[..., 0], strengths, rtol=0.03)
    np.testing.assert_allclose(fitted.values("alpha")[..., 0], TRUTH["alpha"], rtol=0.03)


def test_without_any_fact_it_still_goes_everywhere(tmp_path: Path) -> None:
    """A model that declares a formula and components alone: exports say that they guess a diffuse lobe."""

    @register("plain_model")
    @dataclass(frozen=True, eq=False)
    class Plain(BRDF):
        k: Array = parameter(0.4, bounds=(0, 1), symbol="k", doc="a number")

        def formula(self, xp: Any, geometry: Geometry) -> Array:
            return self.k * geometry.cos_theta_d / HALF_PI

        def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
            return [Component(self.formula, CosineLobe(), self.k)]

    try:
        for to in ("glsl", *sorted(BY_LOBES), "csv"):
            done = export(Plain(), to, tmp_path / f"plain{TARGETS[to].suffix}")
            if to in BY_LOBES:
                assert BRDF.approximation in done.notes
        assert Plain().in_words() == "Plain"
        assert (
            age(Plain() + motes.Lambert(0.3), "drying_paint", hours=3).brdf.terms()[-1].in_words() == "Torrance-Sparrow"
        )
    finally:
        unregister("plain_model")
