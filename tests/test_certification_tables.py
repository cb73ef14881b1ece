"""Measurements and tables as subjects: noise is a doubt, a wrong scale a fault; a MERL table answers for the function that made it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

import planted_faults as planted
from motes import OrenNayar
from motes.certification import Outcome, certify
from motes.certification.table_specimen import of_file
from motes.directions import from_half_difference
from motes.errors import DataError, MotesError
from motes.measurements import Measurement
from skips import SHARED

RGL = SHARED / "data" / "rgl"
NAMES = ("aurora_white", "cc_ibiza_sunset", "chm_orange", "ilm_solo_m_68", "irid_flake_paint1", "vch_silk_blue")
shared = pytest.mark.skipif(not RGL.exists(), reason="../shared/data/rgl is missing")


def merl_file(path: Path, f: Callable[..., planted.Floats], scale: bool = True) -> Path:
    """A table of a function at the middles of its bins, by the definition of its axes; negative where there is no value."""
    h, d, p = np.meshgrid(
        ((np.arange(90) + 0.5) / 90) ** 2 * np.pi / 2,
        (np.arange(90) + 0.5) / 90 * np.pi / 2,
        (np.arange(180) + 0.5) / 180 * np.pi,
        indexing="ij",
    )
    wi, wo = (w.reshape(-1, 3) for w in from_half_difference(h, d, p))
    values = f(wi, wo)
    values = np.where((wi[:, 2:] > 0) & (wo[:, 2:] > 0), values, -1.0)
    stored = values / (np.array([1.0, 1.15, 1.66]) / 1500) if scale else values
    path.write_bytes(np.array([90, 90, 180], "<i4").tobytes() + stored.T.astype("<f8").tobytes())
    return path


def test_a_merl_table_answers_for_its_function(tmp_path: Path) -> None:
    def rough(wi: planted.Floats, wo: planted.Floats) -> planted.Floats:
        return np.asarray(OrenNayar((0.7, 0.5, 0.3), 0.4).eval(wi, wo))

    file = merl_file(tmp_path / "rough.binary", rough)
    specimen = of_file(file)
    rng = np.random.default_rng(4)
    w = rng.normal(size=(2, 400, 3))
    w[..., 2] = np.abs(w[..., 2]) + 0.3
    wi, wo = w / np.linalg.norm(w, axis=-1, keepdims=True)
    assert_allclose(specimen.eval(wi, wo), rough(wi, wo), rtol=0.03)
    found = certify(specimen, as_model="oren_nayar(K_d=(0.7, 0.5, 0.3), sigma_d=0.4)")
    assert found.ok, found.findings
    assert found.kind == "MERL table"
    assert_allclose(found.check("energy").numbers["spherical_albedo"], OrenNayar((0.7, 0.5, 0.3), 0.4).spherical_albedo(), rtol=0.02)  # fmt: skip


def test_a_merl_table_without_its_scale_is_too_bright(tmp_path: Path) -> None:
    file = merl_file(tmp_path / "raw.binary", lambda wi, wo: 1500 * planted.lambert(wi, wo))
    (finding,) = certify(file).check("energy").findings
    assert (finding.name, finding.outcome) == ("merl-scale", Outcome.FAULT)


@shared
@pytest.mark.parametrize("name", NAMES)
def test_rgl_files_raise_no_alarm(name: str) -> None:
    found = certify(RGL / f"{name}_rgb.bsdf")
    assert found.ok, found.findings
    assert {f.name for f in found.findings} <= {"negative", "measured-asymmetry"}
    assert found.check("energy").outcome is Outcome.HOLDS


@shared
def test_a_wrong_scale_of_a_measurement_is_a_fault() -> None:
    right = of_file(RGL / "aurora_white_rgb.bsdf")
    for factor, check, name in (
        (lambda wo: np.pi, "energy", "factor-pi"),
        (lambda wo: wo[:, 2:], "reciprocity", "cosine-included"),
    ):
        wrong = replace(right, eval=lambda wi, wo, k=factor: right.eval(wi, wo) * k(wo))  # type: ignore[misc]
        found = certify(wrong)
        assert name in [f.name for f in found.check(check).findings]
        assert not found.ok
    (finding,) = certify(
        replace(right, eval=lambda wi, wo: np.pi * right.eval(wi, wo)[:, ::-1]), against=right
    ).check("conventions").findings[:1]  # fmt: skip
    assert finding.name == "channels-reversed"


def scattered(factor: float = 1.0, noise: float = 0.0) -> Measurement:
    rng = np.random.default_rng(8)
    w = rng.normal(size=(2, 300, 3))
    w[..., 2] = np.abs(w[..., 2]) + 0.2
    wi, wo = w / np.linalg.norm(w, axis=-1, keepdims=True)
    values = factor * OrenNayar((0.6, 0.4, 0.2), 0.4).eval(wi, wo)
    return Measurement.from_arrays(wi, wo, values * (1 + noise * rng.normal(size=values.shape)))


def test_samples_are_judged_at_their_own_directions() -> None:
    found = certify(scattered(noise=0.02), as_model="oren_nayar(K_d=(0.6, 0.4, 0.2), sigma_d=0.4)")
    assert found.ok
    assert not found.findings
    assert found.check("energy").outcome is Outcome.NOT_JUDGED
    (finding,) = certify(scattered(np.pi, 0.02), as_model="oren_nayar(K_d=(0.6, 0.4, 0.2), sigma_d=0.4)").findings
    assert finding.name == "factor-pi"


def test_what_a_model_lacks_is_fitted_and_said() -> None:
    found = certify(lambda wi, wo: planted.ggx(wi, wo, 0.2) * wo[:, 2:], as_model="ggx")
    assert [f.name for f in found.check("conventions").findings] == ["cosine-included"]
    assert float(found.facts["alpha of that"].split()[0]) == pytest.approx(0.2, rel=1e-3)
    assert certify(scattered(noise=0.02), as_model="oren_nayar").ok
    doubt = certify(lambda wi, wo: planted.ggx(wi, wo, 0.2), as_model="lambert").check("conventions")
    assert [f.name for f in doubt.findings] == ["differs"]
    with pytest.raises(DataError, match="no values above 0"):
        certify(lambda wi, wo: np.zeros(len(wi)), as_model="ggx")


def test_what_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(MotesError, match="does not exist"):
        certify("folder/none.binary")
    with pytest.raises(MotesError):
        certify("no_such_model")
    (tmp_path / "broken.binary").write_bytes(b"\0" * 40)
    with pytest.raises(MotesError):
        certify(tmp_path / "broken.binary")
