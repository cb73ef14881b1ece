"""What is printed for graphics cards: run as C++ against NumPy and the engine, and compiled by NVIDIA's compiler; no card is asked for.

The first wants a C++ compiler, the second the package cuda-bindings, by name.
"""

from __future__ import annotations

import re

import numpy as np
import pytest

from catalogue import ENTRIES, Entry
from motes import directions
from motes.errors import MotesError
from motes.fitting.printed.translated import translated
from motes.fitting.texels import TexelSolver
from motes.graph import tracing
from motes.kernels import cards, cuda
from motes.models import BRDF, Dust, DustLayer, Lambert, OrenNayar, TorranceSparrow

COUNT = 24
RNG = np.random.default_rng(2)
WI, WO = (directions.from_spherical(RNG.uniform(0, 1.2, COUNT), RNG.uniform(0, 6.28, COUNT)) for _ in range(2))
SURFACE = OrenNayar((0.6, 0.4, 0.2), 0.3) + TorranceSparrow(0.3, 0.15)
SAND = Dust((0.9, 0.8, 0.7), 0.4)


@pytest.fixture(scope="module")
def device() -> cards.Device:
    try:
        return cards.device("c++")
    except MotesError as error:
        pytest.skip(str(error))


# ---------------------------------------------------------------- values


@pytest.mark.parametrize(
    "model",
    [
        SURFACE,
        DustLayer(SURFACE, SAND, 0.3, scattering="multiple"),
        DustLayer(SURFACE, SAND, np.linspace(0, 2, COUNT)),
    ],
    ids=["surface", "dust", "varying"],
)
def test_values_against_numpy(device: cards.Device, model: BRDF) -> None:
    wi, wo = WI.copy(), WO.copy()
    wo[3, 2] *= -1  # below the horizon
    exact = model.eval(wi, wo)
    np.testing.assert_allclose(cuda.evaluate(model, wi, wo, device=device), exact, rtol=1e-12)
    narrow = cuda.evaluate(model, wi.astype(np.float32), wo.astype(np.float32), device=device)
    assert narrow.dtype == np.float32
    assert np.all(np.abs(narrow - exact) < 2e-6 * np.maximum(exact, 0.1))
    assert not exact[3].any()


def test_values_are_of_the_shape_of_the_call(device: cards.Device) -> None:
    pairs = cuda.evaluate(SURFACE, WI[:4, None], WO[None, :5], device=device)
    np.testing.assert_allclose(pairs, SURFACE.eval(WI[:4, None], WO[None, :5]), rtol=1e-12)
    assert cuda.evaluate(SURFACE, WI[:0], WO[:0], device=device).shape == (0, 3)


# ---------------------------------------------------------------- fits


def both(device: cards.Device, model: str, data: np.ndarray, start: list[float], **options: object) -> None:
    """The same values, errors and verdicts from the engine and from the device; see `tests/test_one_fit.py` for what "the same" is."""
    fits = [
        TexelSolver(model, WI, WO, data.shape[-1], device=where, **options).fit(data, [start], covariance=True)  # type: ignore[arg-type]
        for where in (None, device)
    ]
    here, there = fits
    for name in ("status", "verdicts"):
        np.testing.assert_array_equal(getattr(here, name), getattr(there, name))
    for name in ("x", "stderr", "covariance"):
        np.testing.assert_array_equal(np.isnan(getattr(here, name)), np.isnan(getattr(there, name)))
    known = here.stderr > 0
    assert known.any()
    assert np.all(np.abs(here.x - there.x)[known] < 1e-3 * here.stderr[known])
    np.testing.assert_allclose(there.stderr[known], here.stderr[known], rtol=0.01)


def noisy(values: np.ndarray) -> np.ndarray:
    return (values * (1 + 0.02 * np.random.default_rng(7).standard_normal(values.shape))).astype(np.float32)


def test_fits_against_the_engine(device: cards.Device) -> None:
    """More texels than the room's blocks hold at once, some that miss samples or all, one black."""
    rng, count = np.random.default_rng(4), 100
    colour, rough = rng.uniform(0.1, 0.8, (count, 1, 3)), rng.uniform(0.05, 0.6, (count, 1))
    strength, width = rng.uniform(0.05, 0.5, (count, 1, 1)), rng.uniform(0.1, 0.4, (count, 1))
    model = OrenNayar(colour, rough) + TorranceSparrow(strength, width)
    data = noisy(model.eval(WI[None], WO[None]))
    data[5, 3], data[7, 4, 1], data[9], data[11] = np.nan, np.nan, np.nan, 0
    both(device, "oren_nayar + torrance_sparrow", data, [0.5, 0.5, 0.5, 0.3, 0.2, 0.2])


def test_robust_fits_against_the_engine(device: cards.Device) -> None:
    data = noisy(OrenNayar(np.linspace(0.1, 0.8, 20)[:, None, None], 0.4).eval(WI[None], WO[None]))
    data[::3, 2] *= 4
    both(device, "oren_nayar", data, [0.5, 0.3], robust="huber")


def test_trends_against_the_engine(device: cards.Device) -> None:
    hours = np.arange(6.0)
    fade = (0.2 + 0.5 * np.exp(-hours / 2)) * np.linspace(0.5, 1, 20)[:, None]
    data = noisy(Lambert(fade[:, :, None, None]).eval(WI[None, None], WO[None, None]))
    both(device, "lambert", data, [0.5, 0.2, 2.0], hours=hours, trends={"K_d": "exponential"})


def test_a_wrong_translation_is_seen(device: cards.Device, monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison fails when the text is wrong: a step that goes too far."""
    from motes.fitting import texel_cards

    def spoiled(module: str) -> str:
        return re.sub(
            r"\(\(double\*\)trial\)\[0 \+ lane\] = \(double\)(\w+);",
            r"((double*)trial)[0 + lane] = 1.01 * \1;",
            translated(module),
        )

    monkeypatch.setattr(texel_cards, "translated", spoiled)
    data = noisy(Lambert(np.linspace(0.1, 0.8, 20)[:, None, None]).eval(WI[None], WO[None]))
    with pytest.raises(AssertionError):
        both(device, "lambert", data, [0.5])


# ---------------------------------------------------------------- NVIDIA's compiler


def test_the_compiler_takes_what_is_printed() -> None:
    pytest.importorskip("cuda.bindings", reason="cuda-bindings is not installed")
    fit = TexelSolver("lambert", WI, WO, 1).kernel("direct").source  # type: ignore[union-attr]
    layer = DustLayer(SURFACE, SAND, 0.3, scattering="multiple")
    value = cuda.evaluation(tracing.trace(layer, 3), (), "float32").source
    for text in (translated(fit), value):
        assert cards.machine_code(text)[:4] == b"\x7fELF"
    with pytest.raises(MotesError, match="refuses"):
        cards.machine_code(value.replace("const real", "const unreal"))


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_every_model_is_printed(entry: Entry) -> None:
    model = entry.model
    text = cuda.evaluation(tracing.trace(model, model.channels), (), "float32").source
    assert text.count("out[") == model.channels


def test_devices_by_name() -> None:
    with pytest.raises(MotesError, match='not "cuda" or'):
        cards.device("tpu")


def test_without_a_card() -> None:
    """Where there is one, this is not its test."""
    try:
        cards.device("cuda")
    except MotesError as error:
        why = str(error)
    else:
        pytest.skip("there is a graphics card")
    assert "cupy" in why or "no graphics card" in why
