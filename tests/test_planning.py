"""Plans of measurement: the information, the exchange, what is promised against what fits give, rigs, and bad input."""

from __future__ import annotations

import importlib
import itertools
import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import motes
from motes.cli.main import main
from motes.directions import from_spherical
from motes.errors import MotesError
from motes.measurements import Measurement
from motes.planning.believed import typical
from motes.planning.criteria import Criterion, Term
from motes.planning.design import CHECK, Design
from motes.planning.expectations import revealed
from motes.planning.information import Noise, Subject
from motes.planning.offers import Offer
from motes.planning.rigs import offered
from motes.planning.swapping import chosen, even, exposures
from motes.planning.travelling import length, ordered, turned

USUAL = "oren_nayar + torrance_sparrow"
TRUTH = motes.OrenNayar(K_d=0.45, sigma_d=0.5) + motes.TorranceSparrow(K_s=0.3, sigma_s=0.2)


def measured(wi: Any, wo: Any, seed: int, brdf: motes.BRDF = TRUTH, noise: float = 0.02) -> Measurement:
    """Readings with noise, which say so."""
    f = brdf.eval(wi, wo)
    readings = f * (1 + noise * np.random.default_rng(seed).standard_normal(f.shape))
    return Measurement.from_arrays(wi, wo, readings, uncertainties=noise * np.abs(readings), provenance={"name": "t"})


def angles(offer: Offer, shots: list[int]) -> tuple[Any, Any]:
    at = offer.directions_of(shots)
    return offer.wi[at], offer.wo[at]


# ---------------------------------------------------------------- information


def test_rows_are_derivatives_over_the_noise() -> None:
    """Against differences of `eval`, in the parameters' own units; sigma_d is moved in its square."""
    subject, offer, noise = Subject.of(USUAL), offered("in_plane"), Noise(0.03, 2e-4)
    values = np.array([[0.45, 0.5, 0.3, 0.2], [0.1, 1.0, 0.05, 0.4]])
    rows = subject.rows(values, offer.wi, offer.wo, noise)

    def f(row: Any) -> Any:
        brdf = motes.OrenNayar(row[0], row[1]) + motes.TorranceSparrow(row[2], row[3])
        return brdf.eval(offer.wi, offer.wo)[:, 0]

    for b, row in enumerate(values):
        deviation = np.sqrt((0.03 * f(row)) ** 2 + (2e-4 / offer.wi[:, 2]) ** 2)
        for k, name in enumerate(subject.names):
            step = np.zeros(4)
            step[k] = 1e-6
            slope = (f(row + step) - f(row - step)) / 2e-6
            low, high = subject.quantities[k].parameter.typical
            span = high - low
            if name == "sigma_d":
                slope, span = slope / (2 * row[k]), high**2 - low**2
            np.testing.assert_allclose(rows[b, :, k], slope * span / deviation, rtol=1e-5, atol=1e-4)


def some_terms(m: int) -> list[Term]:
    rng = np.random.default_rng(m)
    rows, start = rng.standard_normal((3, 9, m, 4)), np.broadcast_to(np.eye(4), (3, 4, 4))
    aim = rng.standard_normal((3, 4, 4))
    return [Term(rows, start, 0.7), Term(rows, start, 0.3, aim @ np.swapaxes(aim, 1, 2))]


@pytest.mark.parametrize("m", [1, 3])
@pytest.mark.parametrize("which", [0, 1])
def test_a_gain_is_what_the_value_gains(m: int, which: int) -> None:
    """The rank-m updates against determinants and traces computed anew."""
    criterion = Criterion([some_terms(m)[which]])
    criterion.take(4)
    gains, before = criterion.gains(), criterion.value()
    for shot in range(9):
        criterion.take(shot)
        assert criterion.value() - before == pytest.approx(gains[shot], rel=1e-9, abs=1e-12)
        criterion.give_back(shot)
    assert criterion.value() == pytest.approx(before, abs=1e-12)


def test_the_exchange_finds_what_trying_all_finds() -> None:
    offer = offered("in_plane")
    few = Offer.of("few", offer.wi[::13], offer.wo[::13])
    subject = Subject.of(USUAL)
    rows = subject.rows(typical(subject).values, few.wi, few.wo, Noise())[:, :, None]
    start = np.broadcast_to(np.eye(4), (len(rows), 4, 4))

    def value(shots: Any) -> float:
        taken = rows[:, list(shots), 0]
        return float(np.linalg.slogdet(start + np.swapaxes(taken, 1, 2) @ taken)[1].mean())

    best = max(value(shots) for shots in itertools.combinations(range(few.shots), 5))
    criterion = Criterion([Term(rows, start)])
    found = chosen(criterion, 5, None)
    assert len(set(found)) == 5
    assert value(found) == pytest.approx(criterion.value())
    assert best - 0.02 <= value(found) <= best + 1e-9


def test_exposures_meet_the_equivalence_theorem() -> None:
    """Kiefer, Wolfowitz 1960: at the best exposures of a D-optimal design the variance function is P where time is spent, and below it elsewhere."""
    offer, subject = offered("in_plane"), Subject.of(USUAL)
    rows = subject.rows(np.array([[0.45, 0.5, 0.3, 0.2]]), offer.wi, offer.wo, Noise())[:, :, None]
    criterion = Criterion([Term(rows, 1e-9 * np.eye(4)[None])])
    shots = list(range(0, offer.shots, 4))
    weights = exposures(criterion, shots, least=1e-9, steps=4000)
    taken = rows[0, shots, 0]
    matrix = (taken * weights[:, None]).T @ taken / weights.sum()
    variance = np.einsum("np,pq,nq->n", taken, np.linalg.inv(matrix), taken)
    assert variance.max() < 4.02
    np.testing.assert_allclose(variance[weights > 0.5], 4, rtol=0.01)


def test_what_is_promised_is_what_fits_give() -> None:
    """Errors of fits to 80 noisy copies against those expected."""
    offer, subject = offered("tvbrdf"), Subject.of(USUAL)
    wi, wo = angles(offer, even(offer, 40))
    values = np.array([[0.45, 0.5, 0.3, 0.2]])
    promised = revealed(subject, values, wi, wo, Noise(0.02, 1e-9)).stderr[0]
    found = []
    for seed in range(80):
        fit = motes.fit(measured(wi, wo, seed), USUAL)
        found.append([float(np.ravel(fit.parameters[name].value)[0]) for name in subject.names])
    np.testing.assert_allclose(np.std(found, axis=0), promised, rtol=0.3)


# ---------------------------------------------------------------- plans


def test_a_plan_beats_the_even_choice_on_materials_it_does_not_know() -> None:
    design = motes.plan(USUAL, "tvbrdf", count=12)
    assert design.shots == len(design.wi) == 12
    assert design.to_even < 0.7
    assert 1 < design.to_all < 3.5
    subject, rng = Subject.of(USUAL), np.random.default_rng(11)
    values = np.stack([rng.uniform(0.1, 0.9, 8), rng.uniform(0.1, 1.2, 8), rng.uniform(0.05, 0.9, 8), rng.uniform(0.05, 0.5, 8)], 1)  # fmt: skip
    noise = Noise()
    mine = revealed(subject, values, design.wi, design.wo, noise).stderr
    theirs = revealed(subject, values, design.even_wi, design.even_wo, noise).stderr
    assert np.median(np.log(mine / theirs).mean(axis=1)) < np.log(0.75)


def test_goals_are_reached() -> None:
    """Each goal is best in what it asks for."""
    plans = {goal: motes.plan(USUAL, "hemisphere", goal=goal, check=0, rivals="none") for goal in ("parameters", "curve", "sigma_s", "sigma_d")}  # fmt: skip
    error = {goal: {one.name: one.stderr for one in plan.expected} for goal, plan in plans.items()}
    for name in ("sigma_s", "sigma_d"):
        assert error[name][name] < error["parameters"][name]
    assert error["sigma_s"]["sigma_d"] > error["sigma_d"]["sigma_d"]
    subject, u = Subject.of(USUAL), np.random.default_rng(5).random((2, 2, 40_000))
    wi, wo = (from_spherical(np.arccos(a), 2 * np.pi * b) for a, b in u)  # even over the hemisphere
    values = typical(subject).values

    def blur(design: Design) -> float:
        rows = subject.rows(values, design.wi, design.wo, design.noise)
        inverse = np.linalg.inv(np.swapaxes(rows, 1, 2) @ rows + np.eye(4))
        f, slopes = subject.derivatives(values, wi, wo)
        variance = np.einsum("bnp,bpq,bnq->bn", slopes, inverse, slopes)
        seen = wi[:, 2] * wo[:, 2]
        share = (variance * seen).sum(1) / (np.square(f) * seen).sum(1)
        return float(np.log(share).mean())

    assert blur(plans["curve"]) < blur(plans["parameters"])


def test_rivals_are_told_apart_better_when_asked_for() -> None:
    """Noncentrality of dust left after the model has been fitted to it, by least squares of its own."""
    subject = Subject.of("lambert")
    offer, noise = offered("hemisphere"), Noise()
    blind = motes.plan("lambert", offer, check=0, rivals="none")
    seeing = motes.plan("lambert", offer, check=0, rivals="oren_nayar + torrance_sparrow")

    def left(design: Design) -> float:
        truth = motes.OrenNayar(0.5, 0.5) + motes.TorranceSparrow(0.2, 0.2)
        f = truth.eval(design.wi, design.wo)[:, 0]
        deviation = noise.deviation(f, design.wi[:, 2])
        column = (np.ones(len(f)) / deviation)[:, None]
        return float(np.linalg.lstsq(column, f / deviation, rcond=None)[1][0])

    assert subject.size == 1
    assert left(seeing) > 1.5 * left(blind)


def test_a_share_checks_the_model_far_from_the_rest() -> None:
    design = motes.plan(USUAL, "hemisphere", count=20, check=0.3)
    assert design.purpose.count(CHECK) == 6
    assert len({tuple(np.round(np.r_[a, b], 9)) for a, b in zip(design.wi, design.wo, strict=True)}) == 20


def test_the_next_one_goes_on_from_what_is_measured() -> None:
    first = motes.plan(USUAL, "tvbrdf", count=10)
    data = measured(first.wi, first.wo, 1)
    following = motes.plan(USUAL, "tvbrdf", measured=data, count=1)
    again = motes.plan(USUAL, "tvbrdf", measured=data, count=20, check=0)
    assert following.measured == 10
    assert "error bars" in following.prior
    assert following.noise.relative == pytest.approx(0.02, rel=0.01)
    assert following.offered == 260
    for wi, wo in zip(again.wi, again.wo, strict=True):
        assert not ((data.wi @ wi > 1 - 1e-9) & (data.wo @ wo > 1 - 1e-9)).any()
    assert again.to_all < first.to_all
    few = motes.plan(USUAL, "tvbrdf", measured=data.select([0, 1, 2]), count=1)
    assert "do not determine the model yet" in few.findings[0]


def test_what_stays_unseen_is_said() -> None:
    """At one angle of light and of view, turned about the normal, only one number shows."""
    wi = np.repeat(from_spherical([0.3], 0.0), 8, axis=0)
    wo = from_spherical(np.full(8, 0.3), np.linspace(0.1, 0.101, 8))
    design = motes.plan(USUAL, Offer.of("a fixed pair", wi, wo), count=5)
    assert any("unidentifiable" in said for said in design.findings)


def test_materials_are_the_prior(tmp_path: Path) -> None:
    one = motes.plan(USUAL, prior=TRUTH)
    assert "within 25 %" in one.prior
    motes.Material(TRUTH, "mine").save(tmp_path / "material.json")
    named = motes.plan(USUAL, prior=[str(tmp_path / "material.json"), "oren_nayar(K_d=0.3, sigma_d=0.2) + torrance_sparrow(K_s=0.1, sigma_s=0.1)"])  # fmt: skip
    assert named.materials == 18
    other = motes.plan("eon + ggx", prior=TRUTH)  # converted
    assert other.materials == 17


# ---------------------------------------------------------------- the way through them, and what is written


def test_the_order_is_the_shortest_of_few() -> None:
    offer = offered("in_plane")
    shots = [3, 150, 40, 88, 171, 120, 64]
    at = np.array(shots)
    distances = offer.travel(at[:, None], at[None, :])
    best = min(length(list(way), distances) for way in itertools.permutations(range(7)))
    order = ordered(offer, shots)
    assert sorted(order) == sorted(shots)
    assert float(offer.travel(order[:-1], order[1:]).sum()) <= 1.05 * best
    assert length(turned(list(range(7)), distances), distances) <= length(list(range(7)), distances)


def test_the_table_is_read_back_with_readings(tmp_path: Path) -> None:
    design = motes.plan(USUAL, "hemisphere", count=14)
    table = design.table(tmp_path / "book.csv")
    head, *rows = table.read_text().splitlines()
    readings = TRUTH.eval(design.wi, design.wo)[:, 0]
    filled = [row.replace(",,", f",{value!r},") for row, value in zip(rows, readings.tolist(), strict=True)]
    table.write_text("\n".join([head, *filled]))
    data = motes.read(table)
    np.testing.assert_allclose(data.values[0, :, 0], readings)
    np.testing.assert_allclose(data.wi, design.wi, atol=1e-5)
    np.testing.assert_allclose(data.wo, design.wo, atol=1e-5)
    assert motes.plan(USUAL, "hemisphere", measured=str(table), count=1).measured == 14


def test_the_picture_is_a_picture(tmp_path: Path) -> None:
    design = motes.plan(USUAL)
    root = ElementTree.fromstring(design.picture(tmp_path / "p.svg").read_text())
    said = "".join(root.itertext())
    assert root.tag.endswith("svg")
    assert "Lamp, from above" in said
    assert "to check the model" in said


def test_the_command_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table = tmp_path / "plan.csv"
    assert main(["plan", "--count", "9", "--rig", "in_plane", "-o", str(table), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["shots"] == 9
    assert [Path(file).exists() for file in found["files"]] == [True] * 3
    assert len(table.read_text().splitlines()) == 10
    assert main(["plan", "--count", "9", "-o", str(table)]) == 0
    assert "times those of an even choice" in capsys.readouterr().out
    assert main(["plan", "-o", "plan.txt"]) == 2
    assert "hint:" in capsys.readouterr().err


# ---------------------------------------------------------------- rigs

RIG = """
name = "ours"
[lights]
theta_deg = {from = 0, to = 60, step = 15}
[views]
theta_deg = [0, 20, 40, 60]
phi_deg = {from = 0, to = 180, step = 45}
[limits]
retro_deg = 10
apart_deg = 14
[[blocked]]
theta_r_deg = [55, 65]
dphi_deg = [0, 50]
[cost]
reading_s = 3
light_s_per_deg = 2
view_s_per_deg = 1
"""


def rig(tmp_path: Path, text: str) -> str:
    file = tmp_path / "rig.toml"
    file.write_text(text)
    return str(file)


def test_a_rig_file_says_what_is_free(tmp_path: Path) -> None:
    offer = offered(rig(tmp_path, RIG))
    # Pairs of every light and view, counted by hand: degrees, and the angle between them by the cosine rule.
    free = 0
    for light in range(0, 61, 15):
        for theta, phi in [(0, 0), *itertools.product((20, 40, 60), range(0, 181, 45))]:
            a, b, p = np.radians([light, theta, phi])
            apart = np.degrees(np.arccos(np.cos(a) * np.cos(b) + np.sin(a) * np.sin(b) * np.cos(p)))
            # The azimuth of a lamp at the normal is that of the arm that holds it: 0.
            free += apart >= 10 - 1e-9 and not (theta == 60 and phi <= 50)
    assert offer.shots == free
    design = motes.plan(USUAL, offer, count=8)
    for j, k in itertools.combinations(range(8), 2):
        apart = max(np.degrees(np.arccos(np.clip(w[j] @ w[k], -1, 1))) for w in (design.wi, design.wo))
        assert apart >= 14 - 1e-6

    def turn(w: Any) -> float:
        return float(np.degrees(np.arccos(np.clip(np.sum(w[1:] * w[:-1], axis=1), -1, 1))).sum())

    moved = 2 * turn(design.wi) + turn(design.wo)
    assert design.seconds == pytest.approx(moved + 8 * 3, abs=1e-3)


def test_cameras_that_record_together_are_one_shot(tmp_path: Path) -> None:
    text = "[lights]\ntheta_deg = {from = -70, to = 70, step = 5}\n[views]\npositions_deg = [[12, 180], [45, 180], [65, 150]]\ntogether = true\n"  # fmt: skip
    design = motes.plan(USUAL, rig(tmp_path, text), count=6)
    assert design.shots == 6
    assert len(design.wi) == 18
    assert design.offered == 29
    assert all(len({tuple(w) for w in design.wi[design.shot == k]}) == 1 for k in range(6))


BAD: dict[str, tuple[dict[str, Any], str]] = {
    "a model without free parameters": ({"model": "lambert(K_d=0.5)"}, "no free parameter"),
    "fewer than parameters": ({"count": 3}, "cannot determine the 4 parameters"),
    "none": ({"count": 0}, "at least one"),
    "more than there are": ({"count": 999}, "260 free ones"),
    "no such goal": ({"goal": "tau"}, "no parameter 'tau'"),
    "no such rig": ({"rig": "gonio"}, "no rig and no file"),
    "no such prior": ({"prior": "granite"}, "no preset"),
    "a wrong share": ({"check": 2.0}, "outside [0, 0.9]"),
    "no noise": ({"noise": 0.0}, "outside (0, 1]"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_answered_in_a_sentence(case: str) -> None:
    given, said = BAD[case]
    with pytest.raises(MotesError) as caught:
        motes.plan(**given)
    assert said in str(caught.value)
    assert caught.value.hint
    assert "\n" not in str(caught.value)


def test_a_rig_that_sees_nothing() -> None:
    with pytest.raises(MotesError, match="sees nothing"):
        Offer.of("a lamp below the table", [[0.0, 0.6, -0.8]], [[0.0, 0.0, 1.0]])


def test_no_direction_is_left() -> None:
    offer = Offer.of("two", from_spherical([0.1, 0.5], 0.0), from_spherical([0.4, 0.6], 1.0))
    data = measured(offer.wi, offer.wo, 1)
    with pytest.raises(MotesError, match="no free direction is left"):
        motes.plan("lambert", offer, measured=data, count=1)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("lights = 3", "no section"),
        ("[lights]\ntheta_deg = [0]\n[views]\ntheta_deg = [0]\n[limits]\nretro_deg = 6", "sees nothing"),
        ("[lights]\ntheta_deg = [0]", "[views]"),
        ("[lights]\ntheta_deg = ['a']\n[views]\ntheta_deg = [0]", "not a number"),
        ("[lights]\ntheta_deg = [0]\n[views]\ntheta_deg = [0]\n[limits]\nretro = 6", "'retro'"),
        ("[lights]\ntheta_deg = {from = 0, to = 80, step = 0.01}\n[views]\ntheta_deg = {from = 0, to = 80, step = 0.01}", "larger steps"),
        ("[lights", "not TOML"),
    ],
)  # fmt: skip
def test_bad_rigs_are_answered_in_a_sentence(text: str, said: str, tmp_path: Path) -> None:
    with pytest.raises(MotesError) as caught:
        offered(rig(tmp_path, text))
    assert said in str(caught.value)
    assert caught.value.hint


# ---------------------------------------------------------------- the study of docs/plan.md


def test_the_study_finds_the_grid_s_errors_in_a_quarter_of_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two of its materials and a few seeds: what the page says of eight and fifty."""
    root = Path(__file__).resolve().parents[1]
    monkeypatch.syspath_prepend(str(root / "tools"))
    study = importlib.import_module("plan_study")
    table = study.simulated(6, materials=2)
    row = next(line for line in table if line.startswith("| **median"))
    two, one, even_choice, random = (float(cell.strip(" *")) for cell in row.split("|")[2:6])
    assert max(two, one) < 1.4
    assert even_choice > 1.25 * two
    assert random > 1.25 * two
    page = (root / "docs" / "plan.md").read_text()
    assert study.placed(page, "simulated", ["new"]).count("new\n<!-- /simulated -->") == 1
