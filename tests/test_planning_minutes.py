"""Plans within a time: never longer, not far from the best of all, better than a count that takes as long, and within the limits of the rig."""

from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import motes
from motes.cli.main import main
from motes.errors import MotesError
from motes.planning.believed import believed
from motes.planning.criteria import Criterion, Term
from motes.planning.information import Noise, Subject, information
from motes.planning.offers import Cost, Offer
from motes.planning.rigs import offered
from motes.planning.swapping import chosen
from motes.planning.timed import time_of, within
from motes.planning.travelling import ordered

SLOW = Cost(reading=1.0, light=0.5, view=0.0, known=True)
SUBJECT = Subject.of("oren_nayar + torrance_sparrow")
VALUES = believed(SUBJECT, "typical").values
RIG = """
name = "a slow arm"
[lights]
theta_deg = {from = 0, to = 75, step = 15}
[views]
theta_deg = {from = 0, to = 75, step = 15}
phi_deg = [0, 90, 180]
[limits]
retro_deg = 20
apart_deg = 14
[cost]
reading_s = 2
light_s_per_deg = 0.5
view_s_per_deg = 0.2
"""


def criterion(offer: Offer, seed: int = 1) -> Criterion:
    """Of two parameters, for three materials, with rows drawn at random."""
    rows = np.random.default_rng(seed).normal(0, 3, (3, offer.shots, 1, 2))
    return Criterion([Term(rows, np.broadcast_to(np.eye(2), (3, 2, 2)))])


@pytest.mark.parametrize("seed", range(5))
def test_it_comes_near_the_best_of_all(seed: int) -> None:
    """Against every subset of up to six of nine shots, each gone through in the shortest of all orders."""
    whole = offered("tvbrdf")
    some = np.random.default_rng(seed).choice(whole.shots, 9, replace=False)
    offer = Offer.of("nine", whole.wi[some], whole.wo[some], cost=SLOW)
    seconds = 20.0

    def shortest(shots: tuple[int, ...]) -> float:
        return min(time_of(offer, list(way)) for way in itertools.permutations(shots))

    best = 0.0
    for size in range(1, 7):
        for shots in itertools.combinations(range(9), size):
            trial = criterion(offer, seed)
            for shot in shots:
                trial.take(shot)
            if trial.value() > best and shortest(shots) <= seconds:
                best = trial.value()
    way = within(lambda: criterion(offer, seed), offer, seconds, None)
    assert time_of(offer, way) <= seconds
    again = criterion(offer, seed)
    for shot in way:
        again.take(shot)
    assert len(way) <= 6
    assert 0.7 * best <= again.value() <= best + 1e-9, (again.value() / best, len(way))


def test_a_minute_tells_more_than_by_count() -> None:
    """On the rig of the paper with an arm that takes half a second a degree: as much time, more readings, more information."""
    offer = replace(offered("tvbrdf"), cost=SLOW)
    timed = motes.plan(rig=offer, minutes=2, check=0)
    assert timed.seconds <= 120
    assert timed.seconds == pytest.approx(timed.travel + timed.shots)
    for count in range(timed.shots, 4, -1):
        other = motes.plan(rig=offer, count=count, check=0)
        if other.seconds <= 120:
            break
    assert other.shots < timed.shots
    logs = [
        np.linalg.slogdet(information(SUBJECT.rows(VALUES, d.wi, d.wo, Noise(0.02, 1e-4))))[1] for d in (timed, other)
    ]
    assert np.exp(np.mean(logs[0] - logs[1]) / SUBJECT.size) > 1.05
    minute = motes.plan(rig=offer, minutes=1, check=0)
    least = motes.plan(rig=offer, count=4, check=0)
    assert minute.seconds <= 60 < least.seconds  # by count, four readings alone take longer


def test_limits_of_the_rig_hold(tmp_path: Path) -> None:
    """Blocked retro-reflection and least steps, by count and by time; some pairs of the rig are nearer."""
    file = tmp_path / "rig.toml"
    file.write_text(RIG, encoding="utf-8")
    free = tmp_path / "free.toml"
    free.write_text(RIG.replace("retro_deg = 20", "retro_deg = 0"), encoding="utf-8")
    assert offered(str(file)).shots < offered(str(free)).shots
    for design in (motes.plan(rig=file, minutes=3), motes.plan(rig=file, count=15)):
        apart = np.degrees(np.arccos(np.clip(np.sum(design.wi * design.wo, axis=1), -1, 1)))
        assert apart.min() >= 20 - 1e-6
        for k, j in itertools.combinations(range(design.shots), 2):
            steps = [np.degrees(np.arccos(np.clip(w[k] @ w[j], -1, 1))) for w in (design.wi, design.wo)]
            assert max(steps) >= 14 - 1e-6
    assert motes.plan(rig=file, minutes=3).seconds <= 180
    checked = motes.plan(rig=file, minutes=3, check=0.4)
    assert "check" in checked.purpose
    assert checked.seconds <= 180


def test_it_is_no_worse_than_by_count() -> None:
    offer = replace(offered("tvbrdf"), cost=SLOW)
    way = within(lambda: criterion(offer), offer, 60.0, None)
    assert sorted(way) == sorted(set(way))
    assert time_of(offer, way) <= 60
    mine = criterion(offer)
    for shot in way:
        mine.take(shot)
    for count in (2, 4, 8, 16):
        other = criterion(offer)
        if time_of(offer, ordered(offer, chosen(other, count, None))) <= 60:
            assert other.value() <= mine.value() + 1e-9


@pytest.mark.parametrize(
    ("cost", "minutes", "words"),
    [
        (Cost(), 1.0, "is not known"),
        (SLOW, 0.0, "are no time"),
        (SLOW, np.inf, "are no time"),
        (SLOW, 0.01, "more than the 0.6 s"),
        (replace(SLOW, reading=0.0), 1.0, "takes no time"),
        (SLOW, 0.03, "cannot determine"),
    ],
)
def test_bad_times_are_answered_in_a_sentence(cost: Cost, minutes: float, words: str) -> None:
    with pytest.raises(MotesError, match=words):
        motes.plan(rig=replace(offered("tvbrdf"), cost=cost), minutes=minutes)


def test_the_command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("rig.toml").write_text(RIG, encoding="utf-8")
    assert main(["plan", "--rig", "rig.toml", "--minutes", "3"]) == 0
    said = capsys.readouterr().out
    assert " s with the readings" in said
    assert main(["plan", "--minutes", "3"]) == 2
    assert "is not known" in capsys.readouterr().err
