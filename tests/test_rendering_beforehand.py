"""What is uniform over a surface is computed once, and nobody can tell but by the time it takes."""

from __future__ import annotations

import gc
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from motes import Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow
from motes.models import BRDF
from motes.rendering import load_mitsuba, load_scene
from plugin_support import needs_llvm, rgb, sphere_scene

pytestmark = needs_llvm

Floats = NDArray[np.float64]
RED, WHITE, TEAL = (0.8, 0.5, 0.3), (0.95, 0.9, 0.8), (0.4, 0.7, 0.9)
NESTED = {"type": "motes_dusty", "base": {"type": "diffuse", "reflectance": rgb(*RED)}, "scattering": "multiple"}
GLOSSY = {"type": "motes_dusty", "K_d": rgb(*RED), "sigma_s": 0.2, "scattering": "multiple"}
OVER: dict[str, tuple[dict[str, Any], BRDF]] = {
    "nested": (NESTED, Lambert(RED)),
    "glossy": (GLOSSY, OrenNayar(RED) + TorranceSparrow(sigma_s=0.2)),
}
both = pytest.mark.parametrize("name", OVER)


def pairs(count: int, seed: int = 4) -> tuple[Floats, Floats]:
    rng = np.random.default_rng(seed)
    w = rng.normal(size=(2, count, 3))
    w[..., 2] = np.abs(w[..., 2]) + 0.02
    w /= np.linalg.norm(w, axis=-1, keepdims=True)
    return w[0], w[1]


def interaction(mi: Any, viewer: Floats, uv: tuple[float, float] | None = None) -> Any:
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, len(viewer))
    si.wi = mi.Vector3f(viewer.T)
    if uv is not None:
        si.uv = mi.Point2f(*uv)
    return si


def error_of(bsdf: Any, model: BRDF, uv: tuple[float, float] | None = None) -> float:
    """The largest error of the plugin, of the value or of 0.01/sr where that is more."""
    mi = load_mitsuba()
    viewer, light = pairs(300)
    value = bsdf.eval(mi.BSDFContext(), interaction(mi, viewer, uv), mi.Vector3f(light.T))
    expected = model.eval(light, viewer) * light[:, 2:]
    return float(np.max(np.abs(np.array(value, np.float64).T - expected) / np.maximum(expected, 0.01)))


def texture(mi: Any, left: Any, right: Any) -> dict[str, Any]:
    """Two texels, looked up by u = 0.25 and 0.75."""
    texels = np.stack([np.atleast_1d(left), np.atleast_1d(right)])[None].astype(np.float32)
    return {"type": "bitmap", "data": mi.TensorXf(texels), "raw": True, "filter_type": "nearest"}


@both
def test_a_change_of_a_uniform_parameter_is_seen(name: str) -> None:
    """By whom the numbers of the layer were computed before: of each parameter alone, and of all together."""
    mi = load_mitsuba("llvm_ad_rgb")
    description, base = OVER[name]
    bsdf = load_scene(description | {"w": rgb(*WHITE), "g": 0.6, "tau": 0.5})
    parameters = mi.traverse(bsdf)
    values: dict[str, Any] = {"w": WHITE, "g": 0.6, "tau": 0.5}
    for changes in (
        {},
        {"tau": 1.5},
        {"w": TEAL},
        {"g": -0.3},
        {"tau": 0.1, "w": (0.7, 0.7, 0.7), "g": 0.2},
        {"tau": 0.0},
    ):
        for key, value in changes.items():
            parameters[f"{key}.value"] = mi.Color3f(value) if key == "w" else value
        parameters.update()
        values |= changes
        model = DustLayer(base, Dust(values["w"], values["g"]), values["tau"], "multiple")
        assert error_of(bsdf, model) < 1e-5, changes


@both
def test_a_change_of_the_base_is_seen(name: str) -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    description, base = OVER[name]
    bsdf = load_scene(description | {"w": 0.9, "tau": 0.5})
    layer = DustLayer(base, Dust(0.9), 0.5, "multiple")
    assert error_of(bsdf, layer) < 1e-5
    parameters = mi.traverse(bsdf)
    parameters["base.reflectance.value" if name == "nested" else "K_d.value"] = mi.Color3f(TEAL)
    parameters.update()
    slot = next(s.name for s in layer.slots() if s.name.startswith("K_d"))
    assert error_of(bsdf, layer.with_parameters({slot: TEAL})) < 1e-5


@both
@pytest.mark.parametrize("key", ["tau", "w", "g"])
def test_what_varies_is_computed_where_it_is(name: str, key: str) -> None:
    mi = load_mitsuba("llvm_ad_rgb")
    description, base = OVER[name]
    values: dict[str, Any] = {"w": np.array(WHITE), "g": 0.6, "tau": 0.5}
    ends = {"w": (np.array(WHITE), np.array(TEAL)), "g": (-0.3, 0.6), "tau": (0.2, 1.5)}[key]
    given = {"w": rgb(*WHITE), "g": 0.6, "tau": 0.5, key: texture(mi, *ends)}
    bsdf = load_scene(description | given)
    for u, value in zip((0.25, 0.75), ends, strict=True):
        here = values | {key: value}
        model = DustLayer(base, Dust(here["w"], here["g"]), here["tau"], "multiple")
        assert error_of(bsdf, model, (u, 0.5)) < 1e-5, u


@pytest.mark.parametrize(("name", "keys"), [("nested", ("w",)), ("nested", ("tau", "g")), ("glossy", ("tau",))])
def test_gradients_by_some_while_others_are_known(name: str, keys: tuple[str, ...]) -> None:
    """Dr.Jit's, twice, against central differences of Motes in float64; what has no gradient says the same beside them."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    description, base = OVER[name]
    model = DustLayer(base, Dust(0.9, 0.5), 0.7, "multiple")
    bsdf = load_scene(description | {"w": 0.9, "g": 0.5, "tau": 0.7})
    parameters = mi.traverse(bsdf)
    viewer, light = pairs(200)
    for _ in range(2):
        for key in keys:
            parameters[f"{key}.value"] = dr.detach(parameters[f"{key}.value"])
            dr.enable_grad(parameters[f"{key}.value"])
        parameters.update()
        value, pdf = bsdf.eval_pdf(mi.BSDFContext(), interaction(mi, viewer), mi.Vector3f(light.T))
        assert not dr.grad_enabled(pdf)
        dr.backward(dr.sum(dr.sum(value)))
        for key in keys:
            slot = next(s for s in model.slots() if s.name == key)
            step, at = 1e-6, float(np.ravel(slot.value)[0])
            up, down = (model.with_parameters({key: at + d}).eval(light, viewer) * light[:, 2:] for d in (step, -step))
            found = float(np.array(dr.grad(parameters[f"{key}.value"])).sum())
            assert_allclose(found, np.sum(up - down) / (2 * step), rtol=2e-3, err_msg=key)
    assert error_of(bsdf, model) < 1e-5


def test_gradients_through_a_picture() -> None:
    """Of a rendering by Mitsuba's differentiable integrator, after another one that needed no gradient."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    base = NESTED | {"tau": 0.4, "w": 0.8, "g": 0.5}
    scene = sphere_scene(base, {"type": "prb", "max_depth": 3}, {"type": "constant"}, size=12)
    parameters = mi.traverse(scene)
    key = "sphere.bsdf.tau.value"
    mi.render(scene, spp=4).numpy()
    dr.enable_grad(parameters[key])
    parameters.update()
    dr.backward(dr.sum(mi.render(scene, parameters, spp=256, seed=1), axis=None))
    gradient = float(np.array(dr.grad(parameters[key])).ravel()[0])
    totals = []
    for tau in (0.44, 0.36):
        parameters[key] = tau
        parameters.update()
        totals.append(float(np.array(mi.render(scene, spp=1024, seed=2)).sum()))
    assert_allclose(gradient, (totals[0] - totals[1]) / 0.08, rtol=0.05)


def operations(bsdf: Any) -> int:
    """Of the largest kernel that evaluates it."""
    import drjit as dr

    mi = load_mitsuba()
    viewer, light = pairs(50)
    with dr.scoped_set_flag(dr.JitFlag.KernelHistory, True):
        dr.kernel_history_clear()
        dr.eval(bsdf.eval(mi.BSDFContext(), interaction(mi, viewer, (0.25, 0.5)), mi.Vector3f(light.T)))
        return max(kernel.get("operation_count", 0) for kernel in dr.kernel_history())


@both
def test_a_hit_costs_little_more_than_with_one_scattering(name: str) -> None:
    """Counted in operations of the kernel: the numbers of a layer, some three thousand for each channel, are not among them."""
    mi = load_mitsuba("llvm_ad_rgb")
    dust = {"w": rgb(*WHITE), "g": 0.6, "tau": 0.5}
    single = operations(load_scene(OVER[name][0] | dust | {"scattering": "single"}))
    multiple = operations(load_scene(OVER[name][0] | dust))
    varying = operations(load_scene(OVER[name][0] | dust | {"tau": texture(mi, 0.2, 1.5)}))
    assert multiple < 6 * single
    assert varying > 6 * multiple


def test_a_frozen_function_follows_the_parameters() -> None:
    """It finds the variables of textures, and would not find what was computed of them beforehand."""
    import drjit as dr

    mi = load_mitsuba("llvm_ad_rgb")
    if not hasattr(dr, "freeze"):
        pytest.skip("this Dr.Jit freezes no functions")
    scene = sphere_scene(NESTED | {"w": 0.9}, {"type": "path", "max_depth": 3}, {"type": "constant"}, size=8)
    parameters = mi.traverse(scene)
    frozen = dr.freeze(lambda scene, seed: mi.render(scene, spp=16, seed=seed))
    gc.collect()
    gc.disable()  # see docs/rendering.md: while it records, Dr.Jit does not bear that garbage of earlier tests is collected
    try:
        for tau in (0.2, 0.2, 0.2, 1.0, 3.0):
            parameters["sphere.bsdf.tau.value"] = tau
            parameters.update()
            plain = np.array(mi.render(scene, spp=16, seed=1))
            assert_allclose(np.array(frozen(scene, mi.UInt32(1))), plain, rtol=2e-5, atol=1e-5)
    finally:
        gc.enable()


def test_numbers_are_those_of_numpy() -> None:
    """What is known stays a number of this process until it meets what differs."""
    from motes.rendering.beforehand import Number, Numbers

    mi = load_mitsuba("llvm_ad_rgb")
    xp = Numbers(mi)
    a, b, c = xp.known(0.3), xp.known((0.1, 0.2, 0.5)), xp.differing(mi.Float([0.25, 0.75]))
    known = xp.where(a < b, xp.sqrt(b), -xp.expm1(2 - a / b)) * xp.maximum(a, 0.5) - 1
    assert isinstance(known, Number)
    assert known.known
    expected = np.where(b.value > 0.3, np.sqrt(b.value), -np.expm1(2 - 0.3 / b.value)) * 0.5 - 1
    assert_allclose(known.value, expected, rtol=1e-14)
    mixed = 1 / (known + c)
    assert not mixed.known
    assert_allclose(np.array(xp.found(mixed)), 1 / (expected[:, None] + [[0.25, 0.75]]), rtol=1e-6)
    assert xp.found(xp.known(0.3)) is xp.found(a)
    with pytest.raises(AttributeError, match=r"formulas over Dr\.Jit have no tanh"):
        xp.tanh(a)
