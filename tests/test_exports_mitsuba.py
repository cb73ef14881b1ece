"""Mitsuba files: loaded by Mitsuba, the plugin of Motes and the stock ones against the model."""

from __future__ import annotations

import importlib.util
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import Material
from motes.ageing import age
from motes.arrays import NUMPY
from motes.errors import DataError
from motes.exports import export, mitsuba
from motes.exports.subject import subject
from motes.models import BRDF, GGX, Beckmann, Conductor, Dielectric, Lambert, TorranceSparrow
from motes.models.microfacet import Microfacet
from shader_support import MODELS, SPECTRAL


@pytest.fixture(scope="module")
def mi() -> Any:
    if importlib.util.find_spec("mitsuba") is None:  # not imported here: Motes chooses an LLVM before
        pytest.skip("mitsuba is not installed")
    from motes.rendering import load_mitsuba

    return load_mitsuba()


def bsdfs(mi: Any, file: Path, folder: Path) -> dict[str, Any]:
    """The BSDFs of a file by id, taken in by another one as the documentation says."""
    names = [element.get("id") for element in ElementTree.parse(file).getroot().iter("bsdf") if element.get("id")]
    shapes = "".join(f'<shape type="rectangle"><ref id="{name}"/></shape>' for name in names)
    scene = folder / "scene.xml"
    scene.write_text(f'<scene version="3.0.0"><include filename="{file.name}"/>{shapes}</scene>', encoding="utf-8")
    loaded = mi.load_file(str(scene))
    return {shape.bsdf().id(): shape.bsdf() for shape in loaded.shapes()}


def evaluated(mi: Any, bsdf: Any, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """BSDF x cosine at directions (N, 3); Mitsuba's ``wi`` is the viewer."""
    si = mi.SurfaceInteraction3f()
    si.wi = mi.Vector3f(*np.float32(wo).T)
    si.t = 1.0
    values = bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(*np.float32(wi).T))
    return np.array(values).reshape(3, -1).T


def some(count: int = 200) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(3)
    w = rng.standard_normal((2, count, 3))
    w[..., 2] = np.abs(w[..., 2]) + 0.2
    w /= np.linalg.norm(w, axis=-1, keepdims=True)
    return w[0], w[1]


def test_plugin_is_the_model(mi: Any, tmp_path: Path) -> None:
    model = MODELS["dusty"]
    material = Material(model, name="Dusty & <dry>", channels=("R", "G", "B"))
    done = export(material, "mitsuba", tmp_path / "dusty.xml")
    assert [file.name for file in done.files] == ["dusty.xml", "dusty_material.json"]
    found = bsdfs(mi, done.files[0], tmp_path)
    assert sorted(found) == ["dusty_dry", "dusty_dry_stock"]
    wi, wo = some()
    wanted = model.eval(wi, wo) * wi[:, 2:]
    np.testing.assert_allclose(evaluated(mi, found["dusty_dry"], wi, wo), wanted, rtol=2e-4, atol=1e-6)


def test_time(mi: Any, tmp_path: Path) -> None:
    paint = age(Material(MODELS["plaster_and_coat"], name="paint", channels=("R", "G", "B")), "drying_paint", hours=6)
    done = export(paint, "mitsuba", tmp_path / "paint.xml", hours=2)
    assert any("set to 2 h" in note for note in done.notes)
    wi, wo = some()
    found = bsdfs(mi, done.files[0], tmp_path)[subject(paint, 2).identifier]
    wanted = paint.at(2.0).eval(wi, wo) * wi[:, 2:]
    np.testing.assert_allclose(evaluated(mi, found, wi, wo), wanted, rtol=2e-4, atol=1e-6)


@pytest.mark.parametrize("name", ["lambert", "grey", "torrance_sparrow", "dusty", "two_coats_under_dust", "conductor"])
def test_stock_reflects_as_much(mi: Any, name: str) -> None:
    """The albedo at 30 degrees; a mirror's by samples."""
    model = MODELS[name]
    bsdf = mi.load_dict(mitsuba.stock(subject(model)))
    rng = np.random.default_rng(5)
    n = 40_000
    wi = np.array([0.5, 0, np.sqrt(0.75)])
    si = mi.SurfaceInteraction3f()
    si.wi = mi.Vector3f(*(mi.Float(np.full(n, x, np.float32)) for x in wi))
    u = rng.random((3, n)).astype("f4")
    _, weight = bsdf.sample(mi.BSDFContext(), si, mi.Float(u[0]), mi.Point2f(u[1], u[2]))
    albedo = np.array(weight).reshape(3, -1).mean(axis=1)
    np.testing.assert_allclose(albedo, np.broadcast_to(model.directional_albedo(wi), 3), rtol=0.12)


@pytest.mark.parametrize(
    ("model", "tolerance"),
    [
        (GGX((1.0, 0.5, 0.2), 0.3), 2e-6),
        (GGX((1.0, 0.5, 0.2), 0.7, Dielectric((1.5, 1.33, 2.0))), 5e-6),
        (GGX(0.9, 0.3, Conductor((0.2, 0.9, 1.1), (3.9, 2.4, 2.3))), 5e-6),
        (Beckmann(0.9, 0.4), 0.007),  # Mitsuba has Walter's rational masking, right to 0.3 % each way
    ],
)
def test_facets_are_mitsubas_but_for_the_correlation(mi: Any, model: Microfacet, tolerance: float) -> None:
    """`roughconductor`, an independent implementation: the same D, F and Lambda; it multiplies the masking of both directions."""
    stock = mitsuba.stock(subject(model))
    assert stock["distribution"] == ("ggx" if isinstance(model, GGX) else "beckmann")
    wi, wo = some()
    Lambda = [model.masked(NUMPY, w[:, 2], np.sqrt(1 - w[:, 2] ** 2)) / w[:, 2] for w in (wi, wo)]
    separate = (1 + Lambda[0] + Lambda[1]) / ((1 + Lambda[0]) * (1 + Lambda[1]))
    wanted = np.broadcast_to(model.eval(wi, wo) * (wi[:, 2] * separate)[:, None], (len(wi), 3))
    np.testing.assert_allclose(evaluated(mi, mi.load_dict(stock), wi, wo), wanted, rtol=tolerance, atol=1e-6)
    assert separate.min() < 0.95  # and that is what differs


def test_an_index_takes_its_place_only_where_there_is_room() -> None:
    """Parts of a blend share out 1: a white base leaves none for all that a coat could reflect."""
    coat = GGX(1.0, 0.2, Dielectric(1.5))
    assert "eta" in mitsuba.stock(subject(coat))
    blend = mitsuba.stock(subject(Lambert(0.9) + coat))
    assert blend["second"]["material"] == "none"
    assert blend["weight"] == pytest.approx(0.04 / 0.94)


def test_a_blend_is_a_sum() -> None:
    """Weights and reflectances multiply back to the parts, whatever their number."""
    model = MODELS["two_coats_under_dust"]

    def parts(plugin: dict[str, Any], share: float = 1.0) -> list[np.ndarray]:
        if plugin["type"] == "blendbsdf":
            return parts(plugin["first"], share * (1 - plugin["weight"])) + parts(
                plugin["second"], share * plugin["weight"]
            )
        name = "reflectance" if plugin["type"] == "diffuse" else "specular_reflectance"
        assert max(plugin[name]["value"]) <= 1
        return [share * np.array(plugin[name]["value"])]

    from motes.exports.approximation import lobes

    whole = sum(lobe.normal for lobe in lobes(model))
    np.testing.assert_allclose(sum(parts(mitsuba.stock(subject(model)))), np.broadcast_to(whole, 3), rtol=1e-12)


@pytest.mark.parametrize("model", [Lambert((1.5, 1.0, 0.5)), Lambert(0.9) + TorranceSparrow(0.5, 0.1, "facets")])
def test_more_than_all_light_is_scaled_and_said(model: BRDF, tmp_path: Path) -> None:
    done = export(model, "mitsuba", tmp_path / "x.xml")
    assert any("stock plugins reflect 1 at most" in note for note in done.notes)


def test_spectra_have_no_stock(tmp_path: Path) -> None:
    done = export(SPECTRAL, "mitsuba", tmp_path / "x.xml")
    assert len(list(ElementTree.parse(done.files[0]).getroot().iter("bsdf"))) == 1
    assert any("no stock plugins" in note for note in done.notes)


def test_brightness_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DataError, match="is not reciprocal, so it is no BRDF"):
        export(MODELS["dust_brightness"], "mitsuba", tmp_path / "x.xml")
    assert not list(tmp_path.iterdir())
