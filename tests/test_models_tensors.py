"""Tensors of PyTorch and JAX in, the same out, with derivatives that are those of finite differences."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from numpy.testing import assert_allclose
from numpy.typing import NDArray

from catalogue import (
    ENTRIES,
    SPECIAL,
    SPECIAL_WI,
    SPECIAL_WO,
    Entry,
    jax_in_float64,
    parts,
    reference,
    upper_directions,
)
from motes.arrays import NUMPY, namespace
from motes.directions import Geometry, Vector
from motes.graph import tracing
from motes.models import BRDF, OrenNayar

every_entry = pytest.mark.parametrize("entry", ENTRIES, ids=str)


@dataclass(frozen=True)
class Library:
    """A tensor library: how to make a tensor, to call a function of tensors (JAX compiles it whole, for time), the gradient of
    sum(function(values)), and the context in which it is float64.
    """

    name: str
    tensor: Callable[[Any], Any]
    run: Callable[..., Any]
    gradient: Callable[[Callable[[dict[str, Any]], Any], dict[str, Any]], dict[str, Any]]
    context: Callable[[], AbstractContextManager[Any]]


def with_torch() -> Library:
    torch = pytest.importorskip("torch")

    def gradient(function: Callable[[dict[str, Any]], Any], values: dict[str, Any]) -> dict[str, Any]:
        leaves = {
            name: torch.tensor(np.asarray(value, np.float64), requires_grad=True) for name, value in values.items()
        }
        function(leaves).sum().backward()
        return {name: np.zeros(leaf.shape) if leaf.grad is None else leaf.grad.numpy() for name, leaf in leaves.items()}

    return Library("torch", lambda x: torch.tensor(np.asarray(x)), lambda f, *x: f(*x), gradient, nullcontext)


def with_jax() -> Library:
    jax = pytest.importorskip("jax")
    import jax.numpy as jnp

    def gradient(function: Callable[[dict[str, Any]], Any], values: dict[str, Any]) -> dict[str, Any]:
        leaves = {name: jnp.asarray(value, jnp.float64) for name, value in values.items()}
        return {name: np.asarray(d) for name, d in jax.jit(jax.grad(lambda v: function(v).sum()))(leaves).items()}

    return Library("jax", jnp.asarray, lambda f, *x: jax.jit(f)(*x), gradient, jax_in_float64)


LIBRARIES = {"torch": with_torch, "jax": with_jax}
# JAX compiles every model for a second or more; these hold every class between them, and PyTorch takes all entries.
FOR_JAX = (
    "eon",
    "hapke",
    "coated_diffuse",
    "ggx",
    "gtr",
    "beckmann",
    "retro",
    "sheen",
    "dust_forward",
    "torrance_sparrow_conductor",
    "torrance_sparrow_schlick",
    "dust_on_plaster_and_varnish",
)
BOTH = [("torch", entry) for entry in ENTRIES] + [("jax", entry) for entry in ENTRIES if entry.name in FOR_JAX]
every_entry_of_both = pytest.mark.parametrize(
    ("library", "entry"), BOTH, ids=[f"{x}-{y}" for x, y in BOTH], indirect=["library"]
)


@pytest.fixture
def library(request: pytest.FixtureRequest) -> Iterator[Library]:
    made = LIBRARIES[request.param]()
    with made.context():
        yield made


def test_jax_is_given_every_class() -> None:
    def classes(entries: Iterable[Entry]) -> set[type]:
        return {type(part) for entry in entries for part in parts(entry.model)}

    assert classes(entry for _, entry in BOTH[len(ENTRIES) :]) == classes(ENTRIES)


def tensors(library: Library, model: BRDF) -> BRDF:
    """The model with every parameter a tensor."""
    return model.with_parameters(
        {slot.name: library.tensor(np.asarray(slot.value, np.float64)) for slot in model.slots()}
    )


@every_entry_of_both
def test_tensors_give_the_numbers_of_numpy(library: Library, entry: Entry) -> None:
    wi, wo = upper_directions(40, 1), upper_directions(40, 2)
    wi, wo = np.concatenate([wi, SPECIAL_WI]), np.concatenate([wo, SPECIAL_WO])
    expected = entry.model.eval(wi, wo)
    a, b = library.tensor(wi), library.tensor(wo)
    lifted = tensors(library, entry.model)
    for model, x, y in ((entry.model, a, b), (lifted, wi, wo), (lifted, a, wo)):
        value = library.run(model.eval, x, y)
        assert type(value) is type(a)
        assert value.dtype == a.dtype
        # XLA and PyTorch round sin, exp, asin by an ulp otherwise than NumPy; a difference of terms may hold a few of them.
        assert_allclose(np.asarray(value), expected, rtol=1e-12, atol=1e-300)


@every_entry_of_both
def test_sampling_and_integrals_of_tensors(library: Library, entry: Entry) -> None:
    wi, u = upper_directions(5, 3), np.random.default_rng(4).random((5, 2))
    expected = entry.model.sample(wi, u)
    sampled = library.run(entry.model.sample, library.tensor(wi), library.tensor(u))
    for got, want in zip(sampled, expected, strict=True):
        assert type(got) is type(library.tensor(wi))
        assert_allclose(np.asarray(got), want, rtol=1e-8, atol=1e-12)
    albedo = library.run(lambda w: entry.model.directional_albedo(w, nodes=(8, 8)), library.tensor(wi))
    assert_allclose(np.asarray(albedo), entry.model.directional_albedo(wi, nodes=(8, 8)), rtol=1e-10)


@every_entry_of_both
def test_float32_tensors_stay_float32(library: Library, entry: Entry) -> None:
    wi, wo = (library.tensor(upper_directions(3, seed).astype(np.float32)) for seed in (1, 2))
    value = library.run(tensors(library, entry.model).eval, wi, wo)
    assert value.dtype == wi.dtype
    assert library.run(entry.model.pdf, wi, wo).dtype == wi.dtype
    assert np.isfinite(np.asarray(value)).all()


@every_entry_of_both
def test_nan_stays_nan_in_tensors(library: Library, entry: Entry) -> None:
    wi = library.tensor(np.array([[0.0, 0.6, 0.8], [np.nan] * 3]))
    assert np.isnan(np.asarray(library.run(entry.model.eval, wi, wi))).all(axis=-1).tolist() == [False, True]


# ---------------------------------------------------------------- Derivatives


def central_difference(f: Callable[[BRDF], NDArray[np.float64]], model: BRDF, name: str, k: int) -> float:
    """Of sum(f) by entry k of a parameter: two central differences, extrapolated (error of the order step^4)."""
    value = np.asarray(model.parameters[name], np.float64)

    def moved(step: float) -> float:
        flat = value.ravel().copy()
        flat[k] += step
        return float(f(model.with_parameters({name: flat.reshape(value.shape)})).sum())

    step = 1e-3 * max(abs(value.ravel()[k]), 0.05)
    coarse, fine = ((moved(h) - moved(-h)) / (2 * h) for h in (step, step / 2))
    return (4 * fine - coarse) / 3


WEIGHT = np.random.default_rng(9).uniform(0.5, 1.5, (60, 1))
# Towards the highlight, where there is one, and anywhere.
WI = upper_directions(60, 5)
WO = WI * np.array([-1, -1, 1]) + np.where(np.arange(60)[:, None] % 2, 0.05, 2.0) * np.random.default_rng(6).normal(
    size=(60, 3)
)
WO = WO / np.linalg.norm(WO, axis=-1, keepdims=True)


@every_entry_of_both
def test_derivatives_by_every_parameter(library: Library, entry: Entry) -> None:
    """Against finite differences; directions below the horizon are among them, and contribute 0."""
    assert (WO[:, 2] < 0).any()
    wi, wo, weight = library.tensor(WI), library.tensor(WO), library.tensor(WEIGHT)
    derivatives = library.gradient(
        lambda values: entry.model.with_parameters(values).eval(wi, wo) * weight, entry.model.parameters
    )
    assert set(derivatives) == {slot.name for slot in entry.model.slots()}
    for name, derivative in derivatives.items():
        flat = derivative.ravel()
        for k in {0, flat.size // 2, flat.size - 1}:
            expected = central_difference(lambda m: reference(m, WI, WO) * WEIGHT, entry.model, name, k)
            assert_allclose(flat[k], expected, rtol=1e-7, atol=1e-9, err_msg=f"by {name}[{k}]")


@every_entry_of_both
def test_derivatives_are_finite_in_special_directions(library: Library, entry: Entry) -> None:
    wi, wo = library.tensor(SPECIAL_WI), library.tensor(SPECIAL_WO)
    n = len(SPECIAL)
    each = {}
    for slot in entry.model.slots():  # a parameter of its own for every pair of directions
        value = np.atleast_1d(slot.value) if slot.parameter.per_channel else np.asarray(slot.value)
        each[slot.name] = np.broadcast_to(value, (n, *value.shape)).copy()
    derivatives = library.gradient(lambda values: entry.model.with_parameters(values).eval(wi, wo), each)
    for name, derivative in derivatives.items():
        finite = np.isfinite(derivative).reshape(n, -1).all(axis=-1)
        assert dict(zip(SPECIAL, finite, strict=True)) == dict.fromkeys(SPECIAL, True), name


@every_entry_of_both
def test_derivatives_by_directions(library: Library, entry: Entry) -> None:
    """What moves a light or a normal: along the hemisphere, against finite differences; finite at normal incidence too."""
    rng = np.random.default_rng(8)
    keep = (WO[:, 2] > 0.1) & (WI[:, 2] > 0.1)
    wi, wo = WI[keep], WO[keep]
    tangent = np.cross(wi, rng.normal(size=wi.shape))
    tangent /= np.linalg.norm(tangent, axis=-1, keepdims=True)
    viewer = library.tensor(wo)
    slope = library.gradient(lambda v: entry.model.eval(v["wi"], viewer)[..., 0], {"wi": wi})["wi"]

    def along(t: float) -> NDArray[np.float64]:
        return reference(entry.model, np.cos(t) * wi + np.sin(t) * tangent, wo)[:, 0]

    coarse, fine = ((along(h) - along(-h)) / (2 * h) for h in (1e-4, 5e-5))
    assert_allclose(np.sum(slope * tangent, axis=-1), (4 * fine - coarse) / 3, rtol=1e-5, atol=1e-6)


@every_entry_of_both
def test_derivatives_by_directions_are_finite_at_normal_incidence(library: Library, entry: Entry) -> None:
    up = np.array([[0.0, 0.0, 1.0]] * 3)
    other = np.array([[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -0.6, 0.8]])
    slope = library.gradient(lambda v: entry.model.eval(v["wi"], v["wo"]), {"wi": up, "wo": other})
    assert np.isfinite(slope["wi"]).all()
    assert np.isfinite(slope["wo"]).all()


def test_jax_one_operation_at_a_time() -> None:
    """Without jax.jit, in the float32 that JAX has by default."""
    jnp = pytest.importorskip("jax.numpy")
    wi, wo = upper_directions(6, 1), upper_directions(6, 2)
    value = OrenNayar(jnp.array([0.8, 0.2]), 0.4).eval(jnp.asarray(wi), jnp.asarray(wo))
    assert value.dtype == jnp.float32
    assert_allclose(value, OrenNayar((0.8, 0.2), 0.4).eval(wi, wo), rtol=1e-5)


def test_a_model_of_tensors_can_be_compiled_and_mapped() -> None:
    jax = pytest.importorskip("jax")
    with jax_in_float64():
        wi, wo = upper_directions(4, 1), upper_directions(4, 2)
        compiled = jax.jit(lambda K_d, sigma_d: OrenNayar(K_d, sigma_d).eval(wi, wo))
        sigma_d = np.array([0.1, 0.5, 0.9])
        many = jax.vmap(compiled, in_axes=(None, 0))(np.array([0.8, 0.2]), sigma_d)
        for k, s in enumerate(sigma_d):
            assert_allclose(many[k], OrenNayar((0.8, 0.2), s).eval(wi, wo), rtol=1e-12)


# ---------------------------------------------------------------- Dr.Jit and the tracer


@every_entry
def test_dr_jit_gives_the_numbers_of_numpy(entry: Entry) -> None:
    """One channel at a time, by components, as a BSDF plugin of Mitsuba calls it."""
    Array4f64 = pytest.importorskip("drjit.scalar").Array4f64
    wi = np.concatenate([upper_directions(8, 1), SPECIAL_WI])
    wo = np.concatenate([upper_directions(8, 2), SPECIAL_WO])
    grey = entry.model.with_parameters({s.name: np.ravel(s.value)[0] for s in entry.model.slots()})
    xp = namespace(Array4f64(0))
    values = []
    for k in range(0, len(wi), 4):
        i, o = (Vector(*(Array4f64(w[k : k + 4, axis].tolist()) for axis in range(3))) for w in (wi, wo))
        values.append(np.array(grey.value(xp, Geometry(xp, i, o)) + Array4f64(0)))
    assert_allclose(np.concatenate(values), grey.eval(wi, wo)[:, 0], rtol=1e-12, atol=1e-300)


@every_entry
def test_a_recorded_model_gives_the_numbers_of_numpy(entry: Entry) -> None:
    wi = np.concatenate([upper_directions(50, 1), SPECIAL_WI])
    wo = np.concatenate([upper_directions(50, 2), SPECIAL_WO])
    channels = entry.model.channels
    trace = tracing.trace(entry.model, channels)
    leaves: dict[Any, Any] = {
        symbol: w[:, axis]
        for symbol, (w, axis) in zip(trace.directions, [(w, a) for w in (wi, wo) for a in range(3)], strict=True)
    }
    for p in trace.parameters:
        value = np.ravel(entry.model.parameters[p.slot])
        leaves[p.symbol] = float(value[p.channel if p.channel is not None else 0])
    with np.errstate(all="ignore"):
        values = tracing.evaluate(NUMPY, trace.outputs, leaves)
    recorded = np.stack([np.broadcast_to(v, len(wi)) for v in values], axis=-1)
    assert_allclose(recorded, entry.model.eval(wi, wo), rtol=1e-13, atol=1e-300)
