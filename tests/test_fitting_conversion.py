"""`motes.convert`: from one model to the nearest of another, with the distance stated."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import motes
from catalogue import upper_directions
from motes.errors import MotesError
from motes.fitting.conversion import Conversion, convert
from motes.models import BRDF, EON, GGX, Beckmann, Dust, Lambert, OrenNayar, Schlick, TorranceSparrow, describe


@pytest.mark.parametrize(
    ("model", "to"),
    [
        (Lambert((0.5, 0.3, 0.1)), "lambert"),
        (Lambert(0.4), "oren_nayar"),
        (Lambert(0.4), "eon"),
        (GGX(0.6, 0.2), "ggx"),
        (TorranceSparrow(0.3, 0.15), "torrance_sparrow(normalization=facets)"),
    ],
)
def test_what_can_be_said_exactly_is(model: BRDF, to: str) -> None:
    found = convert(model, to)
    assert found.relative_rms < 1e-4
    assert found.albedo < 1e-4
    wi, wo = upper_directions(300, 1), upper_directions(300, 2)
    np.testing.assert_allclose(found.brdf.eval(wi, wo), model.eval(wi, wo), rtol=2e-3, atol=2e-5)


@pytest.mark.parametrize(
    ("model", "to", "most"),
    [
        (OrenNayar((0.8, 0.5, 0.2), 0.5), "eon", 0.06),
        (EON((0.8, 0.5, 0.2), 0.6), "oren_nayar", 0.06),
        (Beckmann(0.5, 0.3), "torrance_sparrow(normalization=facets)", 0.1),
        (Beckmann(0.5, 0.1), "ggx", 0.35),
        (GGX(1.0, 0.15, Schlick(0.1)), "torrance_sparrow(normalization=facets, fresnel=schlick)", 0.5),
    ],
)
def test_the_distance_is_what_is_left(model: BRDF, to: str, most: float) -> None:
    """Stated, and that of a uniform rule over the hemisphere, which shares nothing with it."""
    found = convert(model, to)
    assert 1e-3 < found.relative_rms < most
    wi, wo = upper_directions(60_000, 3), upper_directions(60_000, 4)
    cosines = wi[:, 2:] * wo[:, 2:]
    wanted = model.eval(wi, wo) * cosines
    measured = np.sqrt(np.mean((found.brdf.eval(wi, wo) * cosines - wanted) ** 2) / np.mean(wanted**2))
    assert found.relative_rms == pytest.approx(measured, rel=0.2)


def test_it_is_nearer_than_the_formula() -> None:
    """alpha = sigma_s is what one would write down."""
    source = Beckmann(0.5, 0.5)
    found = convert(source, "torrance_sparrow(normalization=facets)")
    written = TorranceSparrow(0.5, 0.5, "facets")
    wi, wo = upper_directions(60_000, 5), upper_directions(60_000, 6)
    cosines = wi[:, 2:] * wo[:, 2:]
    off = [np.mean(((m.eval(wi, wo) - source.eval(wi, wo)) * cosines) ** 2) for m in (found.brdf, written)]
    assert off[0] < 0.6 * off[1]


def test_values_in_the_text_are_held() -> None:
    found = convert("ggx(K_s=0.5, alpha=0.2) + lambert(K_d=0.2)", "beckmann(alpha=0.3) + lambert")
    assert found.brdf.parameters["alpha"] == 0.3
    assert "beckmann" in found.said()
    assert describe(found.brdf) == "beckmann + lambert"
    assert isinstance(found, Conversion)
    assert motes.convert is convert


def test_what_cannot_be_converted_is_refused() -> None:
    with pytest.raises(MotesError, match="is not reciprocal"):
        convert(Dust(0.5, form="brightness"), "dust")
    with pytest.raises(MotesError, match="reflects nothing"):
        convert(Lambert(0.0), "eon")


def test_an_export_takes_another_model(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from motes.cli.main import main

    file = motes.Material(OrenNayar((0.6, 0.5, 0.4), 0.4), name="clay", channels=("R", "G", "B")).save(
        tmp_path / "clay.json"
    )
    out = tmp_path / "clay.mtlx"
    assert main(["export", str(file), "--to", "materialx", "--as", "eon", "-o", str(out)]) == 0
    assert "over the hemisphere" in capsys.readouterr().out
    text = out.read_text(encoding="utf-8")
    assert 'name="rho"' in text
    assert "over the hemisphere" in " ".join(text.split())
