"""`motes.certify`: the mathematics it judges by, against other sources; the certificate, its page, its number; the command."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.special import gammaincc
from scipy.stats import chi2

import motes
import planted_faults as planted
from catalogue import ENTRIES, Entry, dense_albedo, direction
from motes.ageing import age
from motes.certification import Check, Finding, Outcome, certify
from motes.certification.chi_square import sidak, survival
from motes.certification.hemisphere import albedo
from motes.errors import DataError, FormatError, MotesError

Run = Callable[..., tuple[int, str, str]]

# ---------------------------------------------------------------- the mathematics


@pytest.mark.parametrize("freedom", [1, 2, 7, 30, 500, 1700])
def test_the_survival_function_is_scipys(freedom: int) -> None:
    for statistic in np.array([0.0, 1e-3, 0.1, 0.5, 0.9, 1.0, 1.1, 1.3, 2.0, 5.0]) * freedom:
        assert_allclose(survival(statistic, freedom), chi2.sf(statistic, freedom), rtol=1e-9, atol=1e-14)
    assert survival(1e9, freedom) == 0
    assert_allclose(survival(2 * 41.0, freedom), gammaincc(0.5 * freedom, 41.0), rtol=1e-9, atol=1e-14)


def test_sidak_shares_the_significance() -> None:
    assert_allclose(1 - (1 - sidak(0.01, 57)) ** 57, 0.01, rtol=1e-12)
    assert_allclose(sidak(1e-12, 3), 1e-12 / 3, rtol=1e-9)


@pytest.mark.parametrize("theta_i", [0.0, 1.0, 1.45])
@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_the_furnace_finds_the_albedo_of_every_model(entry: Entry, theta_i: float) -> None:
    """By a rule that knows nothing of the model, against Gauss-Legendre rules in pieces."""
    wi = direction(theta_i, 0.4)
    found, error = albedo(lambda a, b: np.asarray(entry.model.eval(a, b)), wi)
    expected = dense_albedo(entry.model, wi)
    assert np.all(np.abs(found - expected) <= 5 * error + 2e-3 * np.maximum(expected, 0.05))
    assert np.all(error < 0.015 * np.maximum(expected, 0.05))


# ---------------------------------------------------------------- materials


@pytest.mark.parametrize("entry", [e for e in ENTRIES if e.reciprocal], ids=str)
def test_no_model_raises_a_false_alarm(entry: Entry) -> None:
    """All checks are made of each, and none finds a fault; the one doubt is an energy of 1.013 that Oren-Nayar has at 88 degrees."""
    found = certify(entry.model, name=entry.name)
    names = [finding.name for finding in found.findings]
    assert names == (["energy"] if entry.name == "oren_nayar_nearly_smooth" else []), found.findings
    assert found.ok
    assert [check.name for check in found.checks if check.outcome is Outcome.NOT_JUDGED] == ["exports"]  # not asked for


def test_brightness_is_no_brdf_and_says_so() -> None:
    found = certify(motes.Dust(0.7, 0.4, "brightness"))
    (finding,) = found.check("reciprocity").findings
    assert finding.name in (
        "cosine-of-light-included",
        "cosine-of-viewer-divided",
    )  # which reciprocity alone cannot tell apart
    assert "look alike" in finding.probably
    assert "says of itself" in finding.probably
    assert not found.ok


def test_a_material_that_changes_is_certified_at_a_time(tmp_path: Path) -> None:
    rock = motes.Material(motes.Lambert(0.5) + motes.TorranceSparrow(0.2, 0.2))
    paint = age(rock, "drying_paint", hours=6)
    file = paint.save(tmp_path / "paint.json")
    early, late = (certify(file, hours=hours, date="") for hours in (0.0, 6.0))
    assert early.facts["K_d"] != late.facts["K_d"]
    assert early.digest != late.digest
    assert late.facts["moment"] == "6 h"


# ---------------------------------------------------------------- the certificate


def test_the_same_gives_the_same_and_another_another() -> None:
    one, two = (certify("lambert(K_d=0.5)", date="2026-01-31") for _ in range(2))
    other = certify("lambert(K_d=0.4)", date="2026-01-31")
    assert one.to_dict() == two.to_dict()
    assert one.number == certify("lambert(K_d=0.5)", date="2027-12-31").number
    assert one.number != other.number
    assert one.digest != other.digest


def test_the_date_may_be_the_builds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1000000000")
    assert certify("lambert(K_d=0.5)").date == "2001-09-09"


def test_the_worst_finding_is_the_outcome() -> None:
    doubt = Finding("a", "b", "c", Outcome.DOUBT)
    assert Check("x", "y", (doubt, Finding("a", "b", "c"))).outcome is Outcome.FAULT
    assert Check("x", "y", (doubt,)).outcome is Outcome.DOUBT
    assert Check("x", "y").outcome is Outcome.HOLDS
    assert Check("x", "y", judged=False).outcome is Outcome.NOT_JUDGED


def test_the_page_says_what_was_found_and_asks_the_network_for_nothing(tmp_path: Path) -> None:
    def bad(wi: planted.Floats, wo: planted.Floats) -> planted.Floats:
        return np.pi * planted.lambert(wi, wo)

    found = certify(bad, name="<script>alert(1)</script>", date="2026-01-31", **planted.WHITE)
    page = found.report(tmp_path / "a.html").read_text(encoding="utf-8")
    assert "<script" not in page
    assert "&lt;script&gt;" in page
    assert not re.search(r"(?:src|href)=\"(?!data:|#)", page)
    for words in ("factor-pi", "is it a reflectance factor", found.number, found.digest, "2026-01-31", "1 fault found"):
        assert words in page
    assert page.count("<svg class=") == 5
    assert page == found.report(tmp_path / "b.html").read_text(encoding="utf-8")
    saved = json.loads(found.save(tmp_path / "a.json").read_text())
    assert saved["number"] == found.number
    assert saved["checks"][1]["findings"][0]["name"] == "factor-pi"


def test_what_cannot_be_judged_is_said() -> None:
    found = certify(planted.lambert)
    judged = {check.name: check.outcome for check in found.checks}
    assert judged["sampling"] is judged["gradients"] is Outcome.NOT_JUDGED
    assert "physics alone" in found.check("conventions").says


# ---------------------------------------------------------------- functions


def test_a_function_of_one_pair_is_one_too() -> None:
    def scalar(wi: planted.Floats, wo: planted.Floats) -> float:
        assert wi.shape == (3,)
        return 0.5 / np.pi if wi[2] > 0 and wo[2] > 0 else 0.0

    assert certify(scalar).check("energy").numbers["spherical_albedo"] == pytest.approx([0.5], rel=2e-3)


@pytest.mark.parametrize(
    ("bad", "says"),
    [
        (lambda wi: wi, "cannot be called with two directions: TypeError"),
        (lambda wi, wo: "white", "is no array of numbers"),
        (lambda wi, wo: np.zeros((len(wi), 3, 3)), r"of shape \(\d+, 3, 3\)"),
    ],
)
def test_what_is_no_brdf_is_refused(bad: Callable[..., object], says: str) -> None:
    with pytest.raises(DataError, match=says):
        certify(bad)


def test_arguments_that_do_not_go_together_are_refused() -> None:
    with pytest.raises(MotesError, match="--as or --against"):
        certify("lambert", as_model="lambert", against="lambert")
    with pytest.raises(MotesError, match="is no function"):
        certify("lambert", pdf=planted.cosine_pdf)
    with pytest.raises(MotesError, match="nothing that can be certified"):
        certify(12)


# ---------------------------------------------------------------- the command


def test_the_command_writes_a_page_and_its_status_tells(motes: Run) -> None:
    status, out, err = motes("certify", "oren_nayar(K_d=0.5)", "-o", "good.html", "--date", "2026-01-31")
    assert (status, err) == (0, "")
    assert "holds" in out
    first = Path("good.html").read_bytes()
    motes("certify", "oren_nayar(K_d=0.5)", "-o", "good.html", "--date", "2026-01-31", "--quiet")
    assert Path("good.html").read_bytes() == first
    Path("mine.py").write_text(
        "import numpy as np\n"
        "def paper(wi, wo, rho):\n"
        "    return np.where((wi[:, 2] > 0) & (wo[:, 2] > 0), rho, 0.0)\n"
        "def paper_sample(wi, u, rho):\n"
        "    r, phi = np.sqrt(u[:, 0]), 2 * np.pi * u[:, 1]\n"
        "    return np.stack([r * np.cos(phi), r * np.sin(phi), np.sqrt(1 - u[:, 0])], 1)\n"
        "def paper_pdf(wi, wo, rho):\n"
        "    return np.maximum(wo[:, 2], 0) / np.pi\n"
    )
    status, out, err = motes("certify", "mine.py:paper", "--set", "rho=0.8", "--as", "lambert(K_d=0.8)", "--json")
    assert (status, err) == (1, "")
    found = json.loads(out)
    names = {check["name"]: [f["name"] for f in check["findings"]] for check in found["checks"]}
    assert names["energy"] == names["conventions"] == ["factor-pi"]
    assert names["sampling"] == []
    assert found["files"] == ["certificate-paper.html", "certificate-paper.json"]
    assert json.loads(Path("certificate-paper.json").read_text())["number"] == found["number"]


def test_errors_of_the_command_name_the_next_step(motes: Run) -> None:
    Path("mine.py").write_text("def other(wi, wo): return 1\n")
    for arguments, says in (
        (("mine.py:paper",), "It has other"),
        (("none.py:paper",), "Give the path of a source file"),
        (("lambert(K_d=0.5)", "-o", "page.txt"), "Write -o NAME.html"),
        (("lambert(K_d=0.5)", "--set", "a=1"), "Leave parameters out"),
    ):
        status, out, err = motes("certify", *arguments)
        assert (status, out) == (2, "")
        assert says in err


def test_a_file_that_others_may_write_is_not_run(tmp_path: Path) -> None:
    from motes.certification.opened import opened

    file = tmp_path / "mine.py"
    file.write_text("raise SystemExit('run')\n")
    file.chmod(0o666)
    tmp_path.chmod(0o777)
    with pytest.raises(MotesError, match="would be run, and others may write"):
        opened(f"{file}:f", {}, False)
    tmp_path.chmod(0o700)
    file.write_text("1 / 0\n")
    with pytest.raises(FormatError, match="fails when it is run: ZeroDivisionError"):
        opened(f"{file}:f", {}, False)
