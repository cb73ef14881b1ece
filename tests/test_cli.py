"""The command line in one process: every command, what it prints and writes, and its exit status."""

from __future__ import annotations

import csv
import json
import re
import typing
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes import Lambert, OrenNayar, TorranceSparrow, load, read
from motes._cli import paths
from motes.ageing import Rig, simulate
from motes.cli import main, make_app
from motes.errors import MotesError

DOCS = Path(__file__).resolve().parents[1] / "docs" / "cli.md"
ROCK = OrenNayar(K_d=(0.6, 0.5, 0.4), sigma_d=0.3) + TorranceSparrow(K_s=0.3, sigma_s=0.15)

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def motes(capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """``motes("fit", path)``: exit status, standard output and standard error, in an empty folder."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("MOTES_DEBUG", raising=False)

    def run(*arguments: object) -> tuple[int, str, str]:
        status = main([str(a) for a in arguments])
        captured = capsys.readouterr()
        return status, captured.out, captured.err

    return run


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
    status, out, err = motes("fit", rock, "--model", "oren_nayar + torrance_sparrow", "-o", "out")
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
    options = ("--fix", "sigma_d=0.25", "--fix", "K_d=0.6,0.5,0.4", "--per-channel", "K_s", "--json", "--no-report")
    status, out, _ = motes("fit", rock, "-m", "oren_nayar + torrance_sparrow", *options)
    parameters = json.loads(out)["parameters"]
    assert status == 0
    assert parameters["sigma_d"]["value"] == 0.25
    assert parameters["K_d"]["value"] == [0.6, 0.5, 0.4]
    assert parameters["K_d"]["verdicts"] == ["fixed"] * 3
    assert len(parameters["K_s"]["value"]) == 3


@pytest.mark.parametrize("option", ["--loss", "--robust", "--weights"])
def test_choices_are_those_of_the_library(option: str) -> None:
    from motes._cli.fit import fit
    from motes.fitting.losses import LOSSES, ROBUST

    known = {"--loss": LOSSES, "--robust": ROBUST, "--weights": {"measurement": 0, "uniform": 0}}[option]
    hints = typing.get_type_hints(fit)
    assert set(typing.get_args(hints[option.strip("-")])) == set(known)


def test_losses_and_robust_functions_are_passed_on(motes: Run, rock: Path) -> None:
    def fitted(*options: str) -> dict[str, Any]:
        status, out, _ = motes("fit", rock, "-m", "oren_nayar", "--no-report", "--json", *options)
        assert status == 0
        result: dict[str, Any] = json.loads(out)
        return result

    plain, log, robust = fitted("--loss", "plain"), fitted("--loss", "log"), fitted("--robust", "cauchy")
    assert (plain["loss"], log["loss"], robust["robust"]) == ("plain", "log", "cauchy")
    assert (
        plain["parameters"]["K_d"]["value"] != log["parameters"]["K_d"]["value"] != robust["parameters"]["K_d"]["value"]
    )


def test_fit_says_when_it_did_not_converge(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from motes.fitting import static

    real = static.minimize
    monkeypatch.setattr(static, "minimize", lambda *a, **k: real(*a, **{**k, "max_iterations": 1}))
    status, out, err = motes("fit", rock, "-m", "oren_nayar + torrance_sparrow", "--no-report", "-o", "out")
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
    status, _, err = motes("fit", rock, "-m", "lambert", "-o", "out")
    assert status == 0
    assert err.startswith("warning: no report.html: ")
    assert "motes[report]" in err
    assert sorted(p.name for p in Path("out").iterdir()) == ["fit.json", "material.json", "parameters.csv"]


def test_a_failed_fit_leaves_an_older_result_alone(motes: Run, rock: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert motes("fit", rock, "-m", "lambert", "--no-report", "-o", "out", "--quiet")[0] == 0
    before = {p.name: p.read_bytes() for p in Path("out").iterdir()}
    from motes.fitting import Fit

    def report(self: Fit, path: Path) -> None:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr(Fit, "report", report)
    status, _, err = motes("fit", rock, "-m", "oren_nayar", "-o", "out")
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


# ---------------------------------------------------------------- info


def test_info_of_a_measurement(motes: Run, rock: Path) -> None:
    status, out, err = motes("info", rock)
    assert (status, err) == (0, "")
    size = "160 directions x 3 channels x 3 times"
    for words in ("tvbrdf", "2007", size, "0, 1, 2 h", "R, G, B", "2.0 to 78.0 degrees", "1440 of 1440 samples"):
        assert words in out
    status, out, _ = motes("info", rock, "--json")
    data = read(rock)
    assert (json.loads(out)["n_directions"], json.loads(out)["times"]) == (data.n_directions, [0, 1, 2])


def test_info_counts_what_is_masked_by_reason(motes: Run, tmp_path: Path) -> None:
    file = tmp_path / "m.csv"
    file.write_text(
        "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,grey\n10,0,20,0,0.3\n20,0,30,0,-1\n30,0,95,0,0.2\n40,0,5,0,nan\n"
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


def test_demo_finds_the_true_parameters(motes: Run) -> None:
    status, out, err = motes("demo", "-o", "out", "--json")
    result = json.loads(out)
    assert (status, err) == (0, "")
    for name, true in result["truth"].items():
        parameter = result["parameters"][name]
        assert np.all(np.abs(np.subtract(parameter["value"], true)) < 4 * np.array(parameter["stderr"])), name
    assert result["metrics"]["relative_rms"] == pytest.approx(0.02, abs=0.002)
    page = Path(result["files"]["report.html"]).read_text()
    assert "dusty plaster" in page
    # again, over itself
    status, out, _ = motes("demo", "-o", "out", "--time", "-1")
    assert status == 0
    assert "11 (at 6 h) of 12" in out
    assert "true" in out
    assert str(Path("out/report.html")) in out


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
        assert all(command in out for command in ("fit", "info", "simulate", "demo"))


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
    assert set(known) == set(re.findall(r"^## motes (\w+)$", page, re.MULTILINE)) == {"fit", "info", "simulate", "demo"}
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
    with paths.results(folder) as staging:
        (staging / "one").write_text("1")
        (staging / "two").write_text("2")
        assert [p.name for p in folder.iterdir()] == [staging.name]
    assert sorted(p.name for p in folder.iterdir()) == ["one", "two"]

    def fail(target: Path) -> None:
        with paths.results(target) as staging:
            (staging / "one").write_text("other")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail(folder)
    assert (folder / "one").read_text() == "1"
    assert sorted(p.name for p in folder.iterdir()) == ["one", "two"]
    with pytest.raises(ZeroDivisionError):
        fail(tmp_path / "c" / "d")
    assert not (tmp_path / "c").exists()


def test_a_folder_that_cannot_be_made_is_an_error_before_the_work(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(MotesError, match="cannot be written"), paths.results(tmp_path / "file" / "out"):
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
