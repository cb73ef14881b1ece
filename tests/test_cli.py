"""The command line in one process: every command, what it prints and writes, and its exit status."""

from __future__ import annotations

import csv
import json
import os
import re
import typing
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import Dust, DustLayer, Lambert, Material, OrenNayar, TorranceSparrow, load, read
from motes.ageing import PHENOMENA, Rig, age, simulate
from motes.ageing.plaster import TRENDS
from motes.cli import paths
from motes.cli.demo_command import true_trends
from motes.cli.main import main, make_app
from motes.errors import MotesError
from motes.files import check_writable, leftovers, settle, together, write_text, writing
from motes.trends import Trend

DOCS = Path(__file__).resolve().parents[1] / "docs" / "cli.md"
ROCK = OrenNayar(K_d=(0.6, 0.5, 0.4), sigma_d=0.3) + TorranceSparrow(K_s=0.3, sigma_s=0.15)

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture(scope="session")
def rock(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three scans of a rock that does not change."""
    return simulate(tmp_path_factory.mktemp("rock") / "rock", ROCK, scans=3, hours=2, seed=5, rig=Rig(step_deg=4))


def message(err: str) -> tuple[str, str]:
    """The sentence and the hint of an error, which must be all there is."""
    lines = err.splitlines()
    assert len(lines) == 2, err
    assert lines[0].startswith("error: ")
    assert lines[1].startswith("hint: ")
    return lines[0], lines[1]


# ---------------------------------------------------------------- fit


def test_fit_writes_results_that_agree(motes: Run, rock: Path) -> None:
    status, out, err = motes("fit", rock, "--time", 0, "--model", "oren_nayar + torrance_sparrow", "-o", "out")
    assert (status, err) == (0, "")
    assert sorted(p.name for p in Path("out").iterdir()) == [
        "fit.json",
        "material.json",
        "parameters.csv",
        "report.html",
    ]
    fitted = json.loads(Path("out/fit.json").read_text())
    material = load("out/material.json")
    with open("out/parameters.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    for name, true in ROCK.parameters.items():
        parameter = fitted["parameters"][name]
        np.testing.assert_allclose(parameter["value"], material.brdf.parameters[name])
        np.testing.assert_allclose(
            np.ravel(parameter["value"]), [float(r["value"]) for r in rows if r["parameter"] == name]
        )
        assert np.all(np.abs(np.subtract(parameter["value"], true)) < 5 * np.array(parameter["stderr"]))
        assert name in out
    assert f"{100 * fitted['metrics']['relative_rms']:.2f} %" in out
    for words in ("identified", "status", "none of", "0 (at 0 h) of 3", "out/report.html"):
        assert words in out


def test_fit_names_its_folder_after_the_material(motes: Run, rock: Path) -> None:
    assert motes("fit", rock, "-m", "lambert", "--no-report", "--quiet") == (0, "", "")
    assert (Path("motes-rock-simulated") / "material.json").is_file()


def test_fit_json_is_one_object_and_nothing_else(motes: Run, rock: Path) -> None:
    status, out, err = motes("fit", rock, "--model", "oren_nayar", "--json", "--no-report", "--time", "-1", "-o", "out")
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert result["time"] == {"index": 2, "of": 3, "at": pytest.approx(2.0), "unit": "h"}
    assert {name: Path(path).is_file() for name, path in result["files"].items()} == {
        "fit.json": True,
        "material.json": True,
        "parameters.csv": True,
    }
    assert result["converged"] is True
    assert set(result["parameters"]) == {"K_d", "sigma_d"}


def test_fit_holds_and_splits_parameters(motes: Run, rock: Path) -> None:
    options = (
        "--time",
        0,
        "--fix",
        "sigma_d=0.25",
        "--fix",
        "K_d=0.6,0.5,0.4",
        "--per-channel",
        "K_s",
        "--json",
        "--no-report",
    )
    status, out, _ = motes("fit", rock, "-m", "oren_nayar + torrance_sparrow", *options)
    parameters = json.loads(out)["parameters"]
    assert status == 0
    assert parameters["sigma_d"]["value"] == 0.25
    assert parameters["K_d"]["value"] == [0.6, 0.5, 0.4]
    assert parameters["K_d"]["verdicts"] == ["fixed"] * 3
    assert len(parameters["K_s"]["value"]) == 3


@pytest.mark.parametrize("option", ["--loss", "--robust", "--weights", "--errors"])
def test_choices_are_those_of_the_library(option: str) -> None:
    from motes.cli.fit_command import fit
    from motes.fitting.error_bars import ERRORS
    from motes.fitting.losses import LOSSES, ROBUST

    weights = ("measurement", "uniform")
    known = {"--loss": LOSSES, "--robust": ROBUST, "--weights": weights, "--errors": ERRORS}[option]
    hints = typing.get_type_hints(fit)
    assert set(typing.get_args(hints[option.strip("-")])) == set(known)


def test_losses_and_robust_functions_are_passed_on(motes: Run, rock: Path) -> None:
    def fitted(*options: str) -> dict[str, Any]:
        status, out, _ = motes("fit", rock, "--time", 0, "-m", "oren_nayar", "--no-report", "--json", *options)
        assert status == 0
        result: dict[str, Any] = json.loads(out)
        return result

    plain, log, robust = fitted("--loss", "plain"), fitted("--loss", "log"), fitted("--robust", "cauchy")
    assert (plain["loss"], log["loss"], robust["robust"]) == ("plain", "log", "cauchy")
    assert (
        plain["parameters"]["K_d"]["value"] != log["parameters"]["K_d"]["value"] != robust["parameters"]["K_d"]["value"]
    )


def test_fit_says_when_it_did_not_converge(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from motes.fitting import objective

    real = objective.minimize
    monkeypatch.setattr(objective, "minimize", lambda *a, **k: real(*a, **{**k, "max_iterations": 1}))
    status, out, err = motes(
        "fit", rock, "--time", 1, "-m", "oren_nayar + torrance_sparrow", "--no-report", "-o", "out"
    )
    assert status == 1
    assert err.startswith("warning: the fit did not converge")
    assert json.loads(Path("out/fit.json").read_text())["converged"] is False
    assert "stopped" in out


def test_fit_without_matplotlib_writes_the_rest(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from motes.errors import MissingExtraError
    from motes.fitting import Fit

    def report(self: Fit, path: Path) -> None:
        raise MissingExtraError("matplotlib", "report", "The report")

    monkeypatch.setattr(Fit, "report", report)
    status, _, err = motes("fit", rock, "--time", 0, "-m", "lambert", "-o", "out")
    assert status == 0
    assert err.startswith("warning: no report.html: ")
    assert "[report]" in err
    assert sorted(p.name for p in Path("out").iterdir()) == ["fit.json", "material.json", "parameters.csv"]


def test_a_failed_fit_leaves_an_older_result_alone(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert motes("fit", rock, "-m", "lambert", "--no-report", "-o", "out", "--quiet")[0] == 0
    before = {p.name: p.read_bytes() for p in Path("out").iterdir()}
    from motes.fitting import Fit

    def report(self: Fit, path: Path) -> None:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(Fit, "report", report)
    status, _, err = motes("fit", rock, "--time", 0, "-m", "oren_nayar", "-o", "out")
    assert status == 2
    assert "No space left" in message(err)[0]
    assert {p.name: p.read_bytes() for p in Path("out").iterdir()} == before


def test_names_from_files_cannot_drive_the_terminal(motes: Run, tmp_path: Path) -> None:
    folder = simulate(tmp_path / "s", Lambert(0.5), scans=1, rig=Rig(step_deg=20), name="evil \x1b[2J\x07 [red]")
    for command in (("info", folder), ("fit", folder, "-m", "lambert", "--no-report")):
        status, out, err = motes(*command)
        assert status == 0
        assert "[red]" in out
        assert not set("\x1b\x07") & set(out + err)


# ---------------------------------------------------------------- fit over time


@pytest.fixture(scope="session")
def greying(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Five scans of a surface whose colours meet at a steady rate."""
    K_d = Trend("linear", {"start": (0.2, 0.4, 0.8), "end": (0.5, 0.5, 0.5)}, (0, 4))
    material = Material(Lambert(K_d=(0.2, 0.4, 0.8)), "paint", ("R", "G", "B"), trends={"K_d": K_d})
    folder = tmp_path_factory.mktemp("greying") / "greying"
    return simulate(folder, material, scans=5, hours=4, seed=3, rig=Rig(step_deg=6), name="paint")


def edited(source: Path, folder: Path, change: Callable[[str, str], str | None]) -> Path:
    """A copy of a sample; `change` gets the name and the text of each file, and gives a text, or None to leave it out."""
    for file in source.rglob("*.txt"):
        text = change(file.name, file.read_text())
        if text is not None:
            target = folder / file.relative_to(source)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text)
    return folder


def test_all_scans_give_trends(motes: Run, greying: Path) -> None:
    status, out, err = motes("fit", greying, "-m", "lambert", "-o", "out")
    assert (status, err) == (0, "")
    assert {p.name for p in Path("out").iterdir()} == {"fit.json", "material.json", "parameters.csv", "report.html"}
    fitted = json.loads(Path("out/fit.json").read_text())
    trend = fitted["trends"]["K_d"]
    assert (fitted["format"], trend["kind"]) == ("motes time fit", "linear")
    off = np.subtract(trend["values"], np.linspace((0.2, 0.4, 0.8), (0.5, 0.5, 0.5), 5))
    assert np.all(np.abs(off) < 4.5 * np.array(trend["stderr"]))
    material = load("out/material.json")
    np.testing.assert_allclose(material.at(2.0).parameters["K_d"], trend["values"][2])
    with open("out/parameters.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(r["channel"], float(r["hours"])) for r in rows] == [(c, float(h)) for c in "RGB" for h in range(5)]
    assert "Trends" in Path("out/report.html").read_text()
    for words in ("5 scans, 0 to 4 h", "linear", "identified", "out/report.html", "relative RMS", "6 coefficients"):
        assert words in out


def test_trends_as_json(motes: Run, greying: Path) -> None:
    options = ("-m", "lambert", "--trend", "K_d=cubic", "--no-report", "--json", "-o", "out")
    status, out, err = motes("fit", greying, *options)
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert result["trends"]["K_d"]["kind"] == "cubic"
    assert result["hours"] == pytest.approx([0, 1, 2, 3, 4])
    assert set(result["files"]) == {"fit.json", "material.json", "parameters.csv"}
    assert result["folder"] == "out"
    assert "time" not in result


def test_grazing_angles_can_be_left_out(motes: Run, greying: Path) -> None:
    options = ("-m", "lambert", "--max-theta-deg", 50, "--no-report", "--json")
    over_time, alone = (json.loads(motes("fit", greying, *options, *more)[1]) for more in ((), ("--time", 2)))
    for result, scans in ((over_time, 5), (alone, 1)):
        data = read(greying)
        beyond = np.maximum(data.theta_i, data.theta_r) > np.radians(50)
        assert result["masked"] == {"theta beyond 50 degrees": scans * 3 * int(beyond.sum())}


def test_info_shows_trends(motes: Run, greying: Path) -> None:
    motes("fit", greying, "-m", "oren_nayar", "--no-report", "-o", "out", "--quiet")
    status, out, err = motes("info", "out")
    assert (status, err) == (0, "")
    for words in ("0 to 4 h", "linear", "sigma_d", "extrapolate"):
        assert words in out
    assert json.loads(motes("info", "out", "--json")[1])["trends"]["K_d"]["kind"] == "linear"


def test_many_channels_are_summarised(motes: Run) -> None:
    rng = np.random.default_rng(4)
    rows = ["theta_i,theta_r,phi_r,time," + ",".join(f"{nm} nm" for nm in range(400, 701, 50))]
    for hours in range(3):
        for theta_i in range(5, 80, 15):
            for theta_r in range(5, 80, 15):
                f = (0.1 + 0.05 * hours) * (1 + 0.01 * rng.standard_normal(7))
                rows.append(f"{theta_i},{theta_r},180,{hours}," + ",".join(f"{x:.6f}" for x in f))
    Path("m.csv").write_text("\n".join(rows).replace("theta_i,theta_r,phi_r", "theta_i_deg,theta_r_deg,phi_r_deg"))
    status, out, err = motes("fit", "m.csv", "-m", "lambert", "-o", "out")
    assert (status, err) == (0, "")
    assert "all 7" in out
    assert re.search(r"0\.\d+ \.\. 0\.\d+", out)
    assert "With 3 scans" in out


def test_one_scan_alone_is_said(motes: Run, greying: Path) -> None:
    single = simulate(Path("single"), Lambert(0.5), scans=1, rig=Rig(step_deg=10))
    status, out, err = motes("fit", single, "-m", "lambert", "--no-report")
    assert (status, err) == (0, "")
    assert "one scan only: fitted alone" in out
    rest = edited(greying, Path("rest"), lambda name, text: None if re.match("scan0[1245]", name) else text)
    status, out, err = motes("fit", rest, "-m", "lambert", "--no-report", "-o", "out")
    assert (status, err) == (0, "")
    assert "2 (at 2 h) of 5" in out
    assert "the only scan with usable samples" in out
    assert json.loads(Path("out/fit.json").read_text())["format"] == "motes fit"


@pytest.mark.parametrize("stamp", ["3600 s", "10 s"], ids=["repeated", "backwards"])
def test_time_stamps_that_do_not_increase_are_not_used(motes: Run, greying: Path, stamp: str) -> None:
    bad = edited(greying, Path("bad"), lambda _, text: re.sub("scan 03: .*", f"scan 03: {stamp}", text))
    status, out, err = motes("fit", bad, "-m", "lambert", "-o", "out")
    assert status == 0
    assert err.startswith("warning: The time stamps")
    assert "--read times=0,0.5,1" in err
    assert "scan 0 to 4" in out
    assert motes("fit", bad, "-m", "lambert", "--read", "times=0,1,2,3,4", "--no-report")[::2] == (0, "")


def test_scans_with_other_channels_are_an_error(motes: Run, greying: Path) -> None:
    def one_channel(name: str, text: str) -> str:
        return re.sub(r"^F (\S+) .*", r"F \1", text, flags=re.MULTILINE) if name.startswith("scan03") else text

    status, _, err = motes("fit", edited(greying, Path("bad"), one_channel), "-o", "out")
    assert status == 2
    assert "scan03_brdf_camera1" in message(err)[0]
    assert "F b g r" in message(err)[1]
    assert not Path("out").exists()


def test_a_channel_that_one_scan_lacks_is_filled_by_the_trend(motes: Run, greying: Path) -> None:
    def without_red(name: str, text: str) -> str:
        return re.sub(r"^(F \S+ \S+) .*", r"\1 -1", text, flags=re.MULTILINE) if name.startswith("scan03") else text

    dark = edited(greying, Path("dark"), without_red)
    result = json.loads(motes("fit", dark, "-m", "lambert", "--no-report", "--json")[1])
    trend = result["trends"]["K_d"]
    assert trend["scan_stderr"][2][0] is None
    assert trend["values"][2][0] == pytest.approx(0.35, abs=0.01)
    assert sum(result["masked"].values()) == read(dark).n_directions


def test_what_scans_do_not_show_is_said(motes: Run) -> None:
    rig = Rig(step_deg=6)
    matte = simulate(Path("matte"), OrenNayar(K_d=(0.3, 0.2, 0.1), sigma_d=0.3), scans=4, seed=1, rig=rig)
    status, out, _ = motes("fit", matte, "-m", "oren_nayar + torrance_sparrow", "--no-report")
    assert status in (0, 1)
    assert "No highlight is seen" in out
    buried = age(DustLayer(OrenNayar(K_d=(0.3, 0.2, 0.1)), Dust((0.7, 0.6, 0.5)), tau=6.0), "dust", hours=6)
    status, out, _ = motes("fit", simulate(Path("s"), buried, scans=4, seed=1, rig=rig), "-m", "dust_layer(lambert)")
    assert status in (0, 1)
    assert "hides the surface" in out
    assert "unidentifiable" in out


def test_scans_without_a_usable_sample_are_an_error(motes: Run, greying: Path) -> None:
    dark = edited(greying, Path("dark"), lambda _, text: re.sub(r"^F .*", "F -1 -1 -1", text, flags=re.MULTILINE))
    status, _, err = motes("fit", dark, "-o", "out")
    assert status == 2
    assert "usable" in message(err)[0]
    assert not Path("out").exists()


def test_trends_that_did_not_converge_are_marked(motes: Run, greying: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from motes.fitting import objective

    real = objective.minimize
    monkeypatch.setattr(objective, "minimize", lambda *a, **k: real(*a, **{**k, "max_iterations": 0}))
    status, _, err = motes("fit", greying, "-m", "oren_nayar", "-o", "out")
    assert status == 1
    assert err.startswith("warning: the fit did not converge")
    assert "did not converge" in Path("out/report.html").read_text()


# ---------------------------------------------------------------- age


@pytest.fixture
def slate(motes: Run) -> Path:
    """A material in a file."""
    material = Material(ROCK, "slate", ("R", "G", "B"))
    return material.save("slate.json")


def test_dust_settles_on_a_material(motes: Run, slate: Path) -> None:
    status, out, err = motes("age", slate, "-p", "dust", "--hours", 48, "--set", "tau_growth=0.8", "-o", "aged.json")
    assert (status, err) == (0, "")
    aged = load("aged.json")
    assert aged.interval == (0, 48)
    assert aged.at(24).parameters["tau"] == pytest.approx(0.4)
    np.testing.assert_allclose(aged.at(24).parameters["K_d"], ROCK.parameters["K_d"])
    for words in ("slate, dust", "0 to 48 h", "tau", "linear", "a layer of dust was laid", "aged.json"):
        assert words in out
    result = json.loads(motes("age", slate, "-p", "dust", "--hours", 48, "--json")[1])
    assert result["path"] == "slate-dust.json"
    assert result["ageing"]["phenomenon"] == "dust"
    assert load("slate-dust.json").to_dict()["trends"] == result["trends"]
    assert motes("info", "aged.json")[1].count("tau")
    assert motes("simulate", "s", "--material", "aged.json", "--hours", 48, "--scans", 2, "--step-deg", 20)[0] == 0


def test_a_fitted_course_is_carried_over(motes: Run, slate: Path, greying: Path) -> None:
    motes("fit", greying, "-m", "lambert", "--no-report", "-o", "source", "--quiet")
    status, out, err = motes("age", slate, "-p", "drying_surface", "--from", "source", "--hours", 10, "-o", "aged.json")
    assert (status, err) == (0, "")
    assert "as in paint" in out
    source, aged = load("source/material.json"), load("aged.json")
    # drying ends at what the material is, and scales as the source does
    np.testing.assert_allclose(aged.at(10).parameters["K_d"], ROCK.parameters["K_d"])
    ratio = source.at(0).parameters["K_d"] / source.at(4).parameters["K_d"]
    np.testing.assert_allclose(aged.at(0).parameters["K_d"], ratio * ROCK.parameters["K_d"])
    start = ("age", slate, "-p", "drying_surface", "--from", "source", "--given", "start", "-o", "b.json", "--quiet")
    assert motes(*start) == (0, "", "")
    np.testing.assert_allclose(load("b.json").at(0).parameters["K_d"], ROCK.parameters["K_d"])


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("-p", "rain", "--hours", "3"), "drying_paint"),
        (("-p", "dust"), "no time is given"),
        (("-p", "dust", "--hours", "-3"), "forward"),
        (("-p", "dust", "--hours", "3", "--set", "tau=1"), "tau_growth"),
        (("-p", "dust", "--hours", "3", "--set", "tau_growth=much"), "much"),
        (("-p", "dust", "--hours", "3", "--set", "tau_growth=-1"), "outside"),
        (("-p", "dust", "--hours", "3", "--set", "hours=4"), "--hours"),
        (("-p", "dust", "--hours", "3", "--from", "slate.json"), "does not change with time"),
        (("-p", "dust", "--hours", "3", "--given", "middle"), "start"),
        (("-p", "dust", "--hours", "3", "-o", "."), "folder"),
        (("-p", "dust", "--hours", "3", "-o", "slate.json/aged.json"), "cannot be written"),
    ],
)
def test_wrong_ageing_is_explained(motes: Run, slate: Path, arguments: tuple[str, ...], words: str) -> None:
    before = slate.read_bytes()
    status, out, err = motes("age", slate, *arguments)
    assert (status, out) == (2, "")
    assert words in " ".join(message(err))
    assert [p.name for p in Path().iterdir()] == ["slate.json"]
    assert slate.read_bytes() == before


# ---------------------------------------------------------------- info


def test_info_of_a_measurement(motes: Run, rock: Path) -> None:
    status, out, err = motes("info", rock)
    assert (status, err) == (0, "")
    size = "160 directions x 3 channels x 3 times"
    for words in (
        "tvbrdf",
        "simulated by Motes",
        size,
        "0, 1, 2 h",
        "R, G, B",
        "2.0 to 78.0 degrees",
        "1440 of 1440 samples",
    ):
        assert words in out
    status, out, _ = motes("info", rock, "--json")
    data = read(rock)
    assert (json.loads(out)["n_directions"], json.loads(out)["times"]) == (data.n_directions, [0, 1, 2])


def test_info_counts_what_is_masked_by_reason(motes: Run, tmp_path: Path) -> None:
    file = tmp_path / "m.csv"
    file.write_text(
        "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,grey\n10,0,20,0,0.3\n20,0,30,0,-999\n30,0,95,0,0.2\n40,0,5,0,nan\n"
    )
    out = json.loads(motes("info", file, "--json")[1])
    assert (out["n_samples"], out["n_usable"], len(out["masked"])) == (4, 1, 3)
    text = motes("info", file)[1]
    assert "1 of 4 samples" in text
    for reason in out["masked"]:
        assert f"1 masked: {reason}" in text


def test_info_of_a_material_and_of_a_fitted_folder(motes: Run, rock: Path) -> None:
    motes("fit", rock, "-m", "oren_nayar", "--no-report", "-o", "out", "--quiet")
    for path in ("out", "out/material.json"):
        status, out, err = motes("info", path)
        assert (status, err) == (0, "")
        assert "oren_nayar" in out
        assert "sigma_d" in out
        assert "rad" in out
    assert json.loads(motes("info", "out", "--json")[1])["kind"] == "material"


def test_info_lists_the_samples_of_a_container(motes: Run, tmp_path: Path) -> None:
    for name in ("sample01", "sample07"):
        simulate(tmp_path / "db" / name, Lambert(0.5), scans=1, rig=Rig(step_deg=20))
    summary = json.loads(motes("info", "db", "--json")[1])
    assert (summary["kind"], summary["samples"]) == ("container", ["sample01", "sample07"])
    assert "--sample sample01" in motes("info", "db")[1]
    assert motes("info", "db", "--sample", "7")[0] == 0
    status, _, err = motes("fit", "db")
    assert status == 2
    assert "sample07" in " ".join(message(err))


def test_reader_options_are_passed_on(motes: Run, rock: Path) -> None:
    out = json.loads(
        motes("info", rock, "--json", "--read", "times=0,3,9", "--read", "irradiance=2", "--read", "format=tvbrdf")[1]
    )
    assert out["times"] == [0, 3, 9]
    assert out["f_r"][1] == pytest.approx(json.loads(motes("info", rock, "--json")[1])["f_r"][1] / 2)
    assert "no option" in message(motes("info", rock, "--read", "colour=2")[2])[0]
    assert "csv" in message(motes("info", rock, "--read", "format=xml")[2])[1]


# ---------------------------------------------------------------- simulate and demo


def test_simulate_writes_what_fit_reads(motes: Run) -> None:
    status, out, err = motes(
        "simulate", "s", "--scans", 2, "--step-deg", 6, "--hours", 1.5, "--noise", 0, "--irradiance", 2
    )
    assert (status, err) == (0, "")
    assert "next" in out
    data = read("s")
    assert (data.n_times, data.times[-1]) == (2, pytest.approx(1.5))


def test_simulate_takes_a_model_or_a_material(motes: Run) -> None:
    model = "oren_nayar(K_d=(0.7,0.6,0.5), sigma_d=0.4)"
    small = ("--scans", 1, "--step-deg", 10)
    facts = json.loads(motes("simulate", "a", "--model", model, *small, "--json")[1])
    assert facts["records"] == 4 * 16
    fitted = json.loads(motes("fit", "a", "-m", "oren_nayar", "--no-report", "-o", "out", "--json")[1])
    assert fitted["parameters"]["sigma_d"]["value"] == pytest.approx(0.4, abs=0.1)
    assert motes("simulate", "b", "--material", "out/material.json", *small, "--noise", 0)[0] == 0
    brdf = load("out/material.json").brdf
    data = read("b")
    np.testing.assert_allclose(data.values[0], brdf.eval(data.wi, data.wo), rtol=1e-5)


def test_simulate_overwrites_nothing(motes: Run) -> None:
    Path("s").mkdir()
    Path("s/precious").write_text("mine")
    status, _, err = motes("simulate", "s", "--scans", 1, "--step-deg", 20)
    assert status == 2
    assert "not an empty folder" in message(err)[0]
    assert [p.name for p in Path().rglob("*")] == ["s", "precious"]


def test_simulate_lets_something_happen(motes: Run) -> None:
    small = ("--scans", 3, "--step-deg", 10, "--hours", 8, "--noise", 0)
    dusty = ("--phenomenon", "dust", "--set", "tau_growth=2")
    facts = json.loads(motes("simulate", "a", "--model", "lambert(K_d=0.1)", *dusty, *small, "--json")[1])
    assert (facts["name"], facts["process"]) == ("lambert(K_d=0.1)", "dust")
    data, truth = read("a"), age(Lambert(0.1), "dust", hours=8, tau_growth=2)
    for k, hours in enumerate(data.times):
        expected = np.broadcast_to(truth.at(float(hours)).eval(data.wi, data.wo), data.values[k].shape)
        np.testing.assert_allclose(data.values[k], expected, rtol=1e-5)
    assert np.all(data.values[2] != data.values[0])
    for name in PHENOMENA:  # each has a surface of its own
        assert motes("simulate", name, "--phenomenon", name, *small)[0] == 0
        assert read(name).n_times == 3


def test_demo_finds_the_truth(motes: Run) -> None:
    status, out, err = motes("demo", "-o", "out", "--json")
    result = json.loads(out)
    assert (status, err) == (0, "")
    for name, true in result["truth"].items():
        trend = result["trends"][name]
        assert trend["kind"] == true["kind"], name
        for index, end in ((0, "first"), (-1, "last")):
            off = np.subtract(trend["values"][index], true[end])
            assert np.all(np.abs(off) < 4.5 * np.array(trend["stderr"][index])), (name, end)
    times = {("K_d", "middle"), ("K_d", "width"), ("K_s", "time_constant")}
    for name, coefficient in times:
        true = result["truth"][name]["coefficients"][coefficient]
        assert result["trends"][name]["coefficients"][coefficient] == pytest.approx(true, rel=0.02)
    assert result["metrics"]["relative_rms"] == pytest.approx(0.02, abs=0.001)
    page = Path(result["files"]["report.html"]).read_text()
    assert "dusty plaster" in page
    assert 'id="trends"' in page
    # again, over itself, one scan alone
    status, out, _ = motes("demo", "-o", "out", "--time", "-1")
    assert status == 0
    assert "11 (at 6 h) of 12" in out
    assert "true" in out
    assert str(Path("out/report.html")) in out


def test_the_truth_of_the_demo_is_that_of_the_plaster() -> None:
    truth = true_trends(6.0)
    assert set(truth) == set(TRENDS)
    for name, true in truth.items():
        trend = Trend(true["kind"], true["coefficients"], (0.0, 6.0))
        for hours in np.linspace(0, 6, 13):
            np.testing.assert_allclose(trend(hours), TRENDS[name](float(hours)), rtol=1e-12, err_msg=name)


def test_demo_spares_what_it_did_not_write(motes: Run) -> None:
    Path("out/plaster").mkdir(parents=True)
    Path("out/plaster/notes.txt").write_text("mine")
    status, _, err = motes("demo", "-o", "out")
    assert status == 2
    assert "notes.txt" in message(err)[0]
    assert Path("out/plaster/notes.txt").read_text() == "mine"


# ---------------------------------------------------------------- usage


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("fot",), "fit"),
        (("fit",), "DATA"),
        (("fit", "x", "--losss", "3"), "--loss"),
        (("fit", "x", "--loss", "cubic"), "cube_root"),
        (("fit", "{rock}", "--time", "1.5"), "whole number"),
        (("fit", "{rock}", "--time", "3"), "3 time"),
        (("fit", "{rock}", "--time", "-4"), "3 time"),
        (("fit", "{rock}", "--fix", "sigma_d"), "NAME=VALUE"),
        (("fit", "{rock}", "--fix", "sigma_d=rough"), "rough"),
        (("fit", "{rock}", "-m", "lambert", "--fix", "sigma_d=1"), "sigma_d"),
        (("fit", "{rock}", "--trend", "K_d"), "NAME=VALUE"),
        (("fit", "{rock}", "--trend", "K_d=cubical"), "monotone_spline"),
        (("fit", "{rock}", "--trend", "K_d=cubic", "--trend", "K_d=linear"), "twice"),
        (("fit", "{rock}", "-m", "lambert", "--trend", "K_s=linear"), "K_s"),
        (("fit", "{rock}", "--time", "0", "--trend", "K_d=linear"), "one time has no trend"),
        (("fit", "{rock}", "--max-theta-deg", "91"), "degrees"),
        (("fit", "{rock}", "--max-theta-deg", "1"), "usable"),
        (("fit", "{rock}", "--read", "times=0,1,1"), "does not increase"),
        (("fit", "{rock}", "--read", "times=0,2,1"), "does not increase"),
        (("fit", "{rock}", "--read", "times=0,2"), "3 scans"),
        (("fit", "{rock}", "--model", "phong"), "phong"),
        (("fit", "{rock}", "--model", "oren_nayar(sigma_d=20)"), "degrees"),
        (("fit", "{rock}", "--sample", "3"), "sample"),
        (("info",), "DATA"),
        (("info", "{rock}", "more"), "more"),
        (("simulate", "s", "--scans", "0"), "scans"),
        (("simulate", "s", "--scans", "many"), "many"),
        (("simulate", "s", "--noise", "2"), "noise"),
        (("simulate", "s", "--step-deg", "0"), "step"),
        (("simulate", "s", "--model", "lambert", "--material", "m.json"), "--material"),
        (("simulate", "s", "--model", "lambert(K_d=-1)"), "K_d"),
        (("simulate", "s", "--material", "{rock}/tvBrdf-info.txt"), "JSON"),
        (("simulate", "s", "--phenomenon", "rain"), "drying_paint"),
        (("simulate", "s", "--set", "tau_growth=1"), "--phenomenon"),
        (("simulate", "s", "--phenomenon", "dust", "--set", "tau=1"), "tau_growth"),
        (("age", "{rock}", "-p", "dust", "--hours", "3"), "motes fit"),
        (("age", "nowhere.json", "-p", "dust"), "does not exist"),
        (("age", "{rock}/tvBrdf-info.txt", "-p", "dust"), "JSON"),
        (("age", "m.json"), "--phenomenon"),
        (("demo", "--time", "12"), "12 time"),
    ],
)
def test_wrong_usage_is_a_sentence_and_a_hint(motes: Run, rock: Path, arguments: tuple[str, ...], words: str) -> None:
    status, out, err = motes(*(a.replace("{rock}", str(rock)) for a in arguments))
    assert status == 2
    assert words in " ".join(message(err))
    assert "Traceback" not in out + err


def test_a_mistyped_path_suggests_close_names(motes: Run) -> None:
    Path("plaster.csv").write_text("x")
    assert "Did you mean plaster.csv" in message(motes("fit", "plastr.csv")[2])[1]
    assert "Did you mean plaster.csv" in message(motes("info", "plaster.cvs")[2])[1]
    assert "does not exist" in message(motes("info", "nothing/like/it")[2])[0]
    assert motes("info", "x" * 5000)[0] == 2
    assert motes("info", "nul\0l")[0] == 2


def test_fitted_parameters_are_not_data(motes: Run, rock: Path) -> None:
    motes("fit", rock, "-m", "lambert", "--no-report", "-o", "out", "--quiet")
    for path in ("out", "out/material.json"):
        assert "motes info" in message(motes("fit", path)[2])[1]


def test_an_unexpected_failure_asks_for_a_report(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from motes import measurements

    def broken(*_: object, **__: object) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr(measurements, "read", broken)
    status, _, err = motes("info", rock)
    assert status == 3
    assert "ZeroDivisionError" in message(err)[0]
    assert "--debug" in message(err)[1]
    assert "Traceback" in motes("info", rock, "--debug")[2]
    monkeypatch.setenv("MOTES_DEBUG", "1")
    assert "Traceback" in motes("info", rock)[2]


# ---------------------------------------------------------------- help and the page that documents it


def test_help_lists_the_commands(motes: Run) -> None:
    for arguments in ((), ("--help",), ("-h",)):
        status, out, err = motes(*arguments)
        assert (status, err) == (0, "")
        assert all(command in out for command in ("fit", "info", "age", "simulate", "demo"))


def test_version_is_that_of_the_package(motes: Run) -> None:
    import motes as package

    assert motes("--version") == (0, f"motes {package.__version__}\n", "")


def commands() -> dict[str, set[str]]:
    """Every command of the app with its options."""
    app = make_app()
    names = [name for name in app if not name.startswith("-")]
    return {
        name: {
            option
            for argument in app[name].assemble_argument_collection()
            for option in argument.names
            if option[0] == "-"
        }
        for name in names
    }


def test_every_command_and_option_is_documented() -> None:
    page = DOCS.read_text()
    known = commands()
    assert (
        set(known)
        == set(re.findall(r"^## motes (\w+)$", page, re.MULTILINE))
        == {
            "age",
            "certify",
            "demo",
            "dust",
            "export",
            "fit",
            "info",
            "material",
            "plan",
            "render",
            "report",
            "simulate",
            "stack",
            "view",
        }
    )
    for name, options in known.items():
        section = page.partition(f"## motes {name}\n")[2].partition("\n## ")[0]
        documented = {
            o
            for row in re.findall(r"^\| (`-.*?) \|", section, re.MULTILINE)
            for o in re.findall(r"(?<![\w-])--?[\w-]+", row)
        }
        assert documented == options, name


def test_every_option_has_a_help_text() -> None:
    app = make_app()
    for name in commands():
        for argument in app[name].assemble_argument_collection(parse_docstring=True):
            if argument.name != "*":  # a group of shared options, whose members are listed too
                assert argument.parameter.help, (name, argument.name)


# ---------------------------------------------------------------- results


def test_results_appear_together_or_not_at_all(tmp_path: Path) -> None:
    folder = tmp_path / "a" / "b"
    with together(folder) as staging:
        (staging / "one").write_text("1")
        (staging / "two").write_text("2")
        assert [p.name for p in folder.iterdir()] == [staging.name]
    assert sorted(p.name for p in folder.iterdir()) == ["one", "two"]

    def fail(target: Path) -> None:
        with together(target) as staging:
            (staging / "one").write_text("other")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail(folder)
    assert (folder / "one").read_text() == "1"
    assert sorted(p.name for p in folder.iterdir()) == ["one", "two"]
    with pytest.raises(ZeroDivisionError):
        fail(tmp_path / "c" / "d")
    assert not (tmp_path / "c").exists()


def test_a_folder_in_the_way_of_a_file_moves_nothing(motes: Run, rock: Path) -> None:
    options = ("fit", rock, "-m", "lambert", "--time", 0, "-o", "out")
    assert motes(*options)[0] == 0
    before = Path("out/fit.json").read_bytes()
    Path("out/report.html").unlink()
    Path("out/report.html").mkdir()
    status, _, err = motes(*options, "--loss", "log")
    assert status == 2
    assert "report.html is a folder" in message(err)[0]
    assert Path("out/fit.json").read_bytes() == before
    assert sorted(p.name for p in Path("out").iterdir()) == [
        "fit.json",
        "material.json",
        "parameters.csv",
        "report.html",
    ]


def test_another_fit_in_the_same_folder_is_said(motes: Run, rock: Path) -> None:
    common = ("fit", rock, "--time", 0, "--no-report", "-o", "out")
    assert motes(*common, "-m", "lambert")[2] == ""
    assert motes(*common, "-m", "lambert")[2] == ""  # the same again
    assert "held the fit of the same data by lambert" in motes(*common, "-m", "oren_nayar")[2]
    assert "with the loss linear" in motes(*common, "-m", "oren_nayar", "--loss", "log")[2]
    assert "held the fit of other times" in motes("fit", rock, "-m", "oren_nayar", "--no-report", "-o", "out")[2]


def test_what_was_decided_is_finished_by_whoever_comes_next(motes: Run, rock: Path, tmp_path: Path) -> None:
    """A process that was killed between the moves of its files: readers and writers see all of the new ones."""
    decided = tmp_path / "out" / ".motes-0123456789abcdef.decided"
    decided.mkdir(parents=True)
    for name in ("one", "two"):
        (tmp_path / "out" / name).write_text("old")
    (tmp_path / "out" / "one").write_text("new")  # was moved already
    (decided / "two").write_text("new")
    with leftovers.held(decided):  # its process is still at work
        settle(tmp_path / "out")
        assert (decided / "two").exists()
    settle(tmp_path / "out")
    assert {p.name: p.read_text() for p in (tmp_path / "out").iterdir()} == {"one": "new", "two": "new"}


def test_files_of_killed_writers_are_removed_and_those_at_work_are_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    left, worked_on = (tmp_path / f".report.html.0123456{k}.partial" for k in (7, 8))
    theirs, young = tmp_path / ".theirs.partial", tmp_path / ".report.html.01234569.partial"
    for file in (left, worked_on, theirs, young):
        file.write_text("half")
    for file in (left, worked_on, theirs):
        os.utime(file, (1, 1))
    with leftovers.held(worked_on):
        write_text(tmp_path / "report.html", "whole")
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(
        [worked_on.name, theirs.name, young.name, "report.html"]
    )
    monkeypatch.setattr(writing, "_cleaned", set())
    write_text(tmp_path / "report.html", "whole")
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted([theirs.name, young.name, "report.html"])


def test_trying_a_place_leaves_it_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("kept")
    check_writable(tmp_path / "a")
    check_writable(tmp_path / "b")
    assert {p.name: p.read_text() for p in tmp_path.iterdir()} == {"a": "kept"}
    with pytest.raises(MotesError, match="cannot be written"):
        check_writable(tmp_path / "a" / "b")


def test_a_folder_that_cannot_be_made_is_an_error_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(MotesError, match="cannot be written"), together(tmp_path / "file" / "out"):
        pytest.fail("the work began")


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("CUReT sample 10", "CUReT-sample-10"),
        ("../../etc", "etc"),
        ("", "material"),
        ("ätzend/x", "tzend-x"),
        ("a" * 99, "a" * 60),
    ],
)
def test_slugs_are_safe_names(name: str, expected: str) -> None:
    assert paths.slug(name) == expected


def test_nothing_is_written_over_what_a_command_reads(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A certificate brings a JSON file beside its page, which had the name of the material that it judged."""
    material = tmp_path / "x.json"
    assert main(["material", "gold", "-o", str(material)]) == 0
    before = material.read_bytes()
    assert main(["certify", str(material), "-o", str(tmp_path / "x.html")]) == 2
    assert "x.json is read here, and would be written over" in capsys.readouterr().err
    assert material.read_bytes() == before
    assert not (tmp_path / "x.html").exists()
    folder = tmp_path / "out"
    folder.mkdir()
    material.rename(folder / "material.json")
    assert main(["certify", str(folder), "-o", str(folder / "material.html")]) == 2
    assert (folder / "material.json").read_bytes() == before
    # What is named as the output is meant.
    again = str(folder / "material.json")
    assert main(["material", again, "-o", again]) == 0
