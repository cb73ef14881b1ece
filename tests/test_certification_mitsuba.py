"""BSDFs of Mitsuba as subjects: the right ones raise no alarm, planted plugins are found out, the table of the docs is what a run says."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from motes import Lambert, OrenNayar
from motes.certification import Outcome, certify
from motes.errors import DataError, MotesError
from motes.rendering import load_mitsuba
from plugin_support import needs_llvm, rgb

pytestmark = needs_llvm
ROOT = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def stock() -> ModuleType:
    """tools/certify_stock.py"""
    spec = importlib.util.spec_from_file_location("certify_stock", ROOT / "tools" / "certify_stock.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


RIGHT = ("diffuse", "plastic", "roughconductor, GGX", "roughconductor, anisotropic", "principled", "principled, cloth", "mask", "twosided")  # fmt: skip


@pytest.mark.parametrize("name", RIGHT)
def test_right_ones_raise_no_alarm(name: str, stock: ModuleType) -> None:
    found = stock.certified(name)
    assert not found.findings
    for check in ("values", "energy", "reciprocity", "sampling", "gradients"):
        assert found.check(check).outcome is Outcome.HOLDS, found.check(check).says


def test_the_table_of_the_docs_is_what_a_run_says(stock: ModuleType) -> None:
    """Two of its rows; the tool writes all of them."""
    page = (ROOT / "docs" / "certify.md").read_text("utf-8")
    for name in stock.STOCK:
        assert f"| {name} |" in page
    if f"Mitsuba {stock.certified('null').versions['mitsuba']}," in page:
        for name in ("diffuse", "roughdielectric, Beckmann"):
            marks = stock.row(stock.certified(name)).split(" | ")[:6]
            assert " | ".join(marks) in page


def test_rough_glass_sends_samples_where_its_density_is_0(stock: ModuleType) -> None:
    names = [f.name for f in stock.certified("roughdielectric, Beckmann").check("sampling").findings]
    assert "samples-without-density" in names


def test_the_plugin_of_a_model_is_that_model() -> None:
    """Mitsuba's diffuse against Lambert, and with its channels reversed; a plugin of Motes against its model."""
    same = certify({"type": "diffuse", "reflectance": rgb(0.6, 0.4, 0.2)}, as_model="lambert(K_d=(0.6,0.4,0.2))")
    assert same.ok
    (finding,) = certify(
        {"type": "diffuse", "reflectance": rgb(0.2, 0.4, 0.6)}, against=Lambert((0.6, 0.4, 0.2))
    ).findings
    assert finding.name == "channels-reversed"
    plugin = {"type": "motes_oren_nayar", "K_d": rgb(0.6, 0.4, 0.2), "sigma_d": 0.4}
    assert certify(plugin, against=OrenNayar((0.6, 0.4, 0.2), 0.4)).ok


def test_alpha_of_roughconductor_is_no_roughness() -> None:
    """A slider squared: what the docs of many programs get wrong."""
    squared = {"type": "roughconductor", "material": "none", "alpha": 0.16, "distribution": "ggx"}
    found = certify(squared, against={**squared, "alpha": 0.4})
    assert "differs" in [f.name for f in found.findings]  # two of Mitsuba have no parameters to vary
    beckmann = {"type": "roughconductor", "material": "none", "alpha": 0.16}
    named = certify(beckmann, as_model="beckmann(K_s=1, alpha=0.4)").check("conventions").findings
    # The masking of both directions is multiplied there and correlated here: nothing explains all of it, the square is nearest.
    assert "squared" in named[0].probably


def planted() -> Any:
    """A plugin whose eval leaves the cosine out, and whose density is twice what it should be."""
    mi = load_mitsuba("llvm_ad_rgb")
    import drjit as dr

    class Wrong(mi.BSDF):  # type: ignore[misc, name-defined]
        def __init__(self, properties: Any) -> None:
            mi.BSDF.__init__(self, properties)
            self.m_components = [mi.BSDFFlags.DiffuseReflection | mi.BSDFFlags.FrontSide]
            self.m_flags = self.m_components[0]

        def sample(self, context: Any, si: Any, sample1: Any, sample2: Any, active: Any = True) -> tuple[Any, Any]:
            bs = dr.zeros(mi.BSDFSample3f, dr.width(si.wi))
            bs.wo = mi.warp.square_to_cosine_hemisphere(sample2)
            bs.pdf = self.pdf(context, si, bs.wo)
            bs.eta, bs.sampled_type = 1.0, +mi.BSDFFlags.DiffuseReflection
            return bs, self.eval(context, si, bs.wo) / bs.pdf

        def eval(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return mi.Color3f(dr.select((si.wi.z > 0) & (wo.z > 0), 0.2 / dr.pi, 0.0))

        def pdf(self, context: Any, si: Any, wo: Any, active: Any = True) -> Any:
            return 2 * dr.select((si.wi.z > 0) & (wo.z > 0), wo.z / dr.pi, 0.0)

        def to_string(self) -> str:
            return "Wrong[]"

    mi.register_bsdf("wrong_for_the_tests", Wrong)
    return {"type": "wrong_for_the_tests"}


def test_a_wrong_plugin_is_found_out() -> None:
    found = certify(planted())
    assert [f.name for f in found.check("reciprocity").findings] == ["cosine-of-viewer-divided"]
    assert [f.name for f in found.check("sampling").findings] == ["scale-of-pdf"]


def test_files_and_names(tmp_path: Path) -> None:
    bsdf = {"type": "diffuse", "reflectance": rgb(0.3, 0.3, 0.3)}
    (tmp_path / "grey.json").write_text(json.dumps(bsdf))
    (tmp_path / "grey.xml").write_text(
        '<bsdf version="3.0.0" type="diffuse"><rgb name="reflectance" value="0.3 0.3 0.3"/></bsdf>'
    )
    for subject in (tmp_path / "grey.json", str(tmp_path / "grey.xml"), bsdf):
        albedo = certify(subject).check("energy").numbers["spherical_albedo"]
        np.testing.assert_allclose(albedo, 0.3, rtol=2e-3)
    assert certify("mitsuba:diffuse").kind == "BSDF of Mitsuba"
    with pytest.raises(MotesError, match="Mitsuba cannot load this"):
        certify("mitsuba:no_such_plugin")
    with pytest.raises(DataError, match="is no BSDF"):
        certify({"type": "sphere"})
    with pytest.raises(DataError, match="has 0 BSDFs"):
        certify({"type": "scene"})
