"""What a text names that stands where a material is wanted, in the library and in every command that takes one."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import motes
from catalogue import upper_directions
from motes import Material, OrenNayar, load
from motes.ageing.plaster import TRENDS
from motes.certification.recognising import specimen_of
from motes.errors import MotesError
from motes.measurements.bird_writing import write_bird
from motes.models import BRDF, registered
from motes.presets import PRESETS, given, named

Run = Callable[..., tuple[int, str, str]]
TEXT = "oren_nayar(K_d=(0.8,0.7,0.6), sigma_d=0.4)"
ROCK = OrenNayar(K_d=(0.8, 0.7, 0.6), sigma_d=0.4)
WI, WO = upper_directions(50, 1), upper_directions(50, 2)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def same(found: Material, expected: BRDF) -> None:
    np.testing.assert_array_equal(found.at(0).eval(WI, WO), expected.eval(WI, WO))


def test_a_text_names_a_file_a_folder_a_preset_or_a_model(here: Path) -> None:
    Material(ROCK, "rock", motes.channels.RGB).save(here / "rock.json")
    Path("fitted").mkdir()
    load("rock.json").save(here / "fitted" / "material.json")
    for text in ("rock.json", str(here / "rock.json"), "fitted", "./fitted", TEXT):
        same(named(text), ROCK)
        assert named(text).channels == motes.channels.RGB
    assert named(TEXT).name == TEXT
    assert named("lambert").brdf.parameters == {"K_d": 0.5}
    assert named("gold").about["preset"] == "gold"


def test_what_is_on_the_disk_goes_before_a_preset_of_its_name(here: Path) -> None:
    Path("gold").mkdir()
    Material(ROCK).save(here / "gold" / "material.json")
    same(named("gold"), ROCK)
    Path("lambert").mkdir()
    with pytest.raises(MotesError, match=r"lambert holds no material\.json"):
        named("lambert")


def test_measured_data_are_given_back_as_their_path(here: Path) -> None:
    data = motes.Measurement.from_arrays(WI, WO, ROCK.eval(WI, WO))
    write_bird(data, here / "data.json")
    assert given("data.json") == Path("data.json")
    with pytest.raises(MotesError, match="not a Motes material"):
        named("data.json")


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("glod", "no file or folder, no preset and no model", "Did you mean gold?"),
        ("Oren-Nayar", "no file or folder", "oren_nayar"),
        ("rok.json", "does not exist", "Did you mean rock.json?"),
        ("rok", "no file or folder", "rock.json"),
        ("here/rock", "does not exist", "The folder . exists"),
        ("oren_nyar(K_d=0.5)", "is not a model", "Did you mean oren_nayar?"),
        ("lambert + orennayar", "is not a model", "Did you mean oren_nayar?"),
        ("ggx(fresnel=shlick)", "shlick", "Schlick(f0)"),
        ("oren_nayar(sigma_d=20)", "sigma_d = 20 is outside", ""),
        ("qqq", "no file or folder", "motes material --list"),
        ("", "holds no material.json", ""),
        ("x\0y", "no file or folder", ""),
        ("lambert + " * 200 + "lambert", "more than 64 parts", ""),
        ("link", "link to what does not exist", ""),
    ],
)
def test_what_names_nothing_gets_a_hint(here: Path, text: str, message: str, hint: str) -> None:
    Material(ROCK).save(here / "rock.json")
    Path("link").symlink_to("nowhere")
    with pytest.raises(MotesError) as caught:
        named(text)
    assert message in caught.value.message
    assert hint in (caught.value.hint or "")


@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_says_where_its_numbers_come_from_and_survives_its_file(name: str, here: Path) -> None:
    preset = PRESETS[name]
    assert preset.name == name
    assert name not in registered(BRDF)
    assert name.isidentifier()
    made = preset.material()
    assert len(made.about["source"]) > 20
    back = load(made.save(here / "made.json"))
    assert back.to_dict() == made.to_dict()
    albedo = made.brdf.directional_albedo((0, 0, 1))
    assert np.all((albedo > 0) & (albedo <= 1)), albedo


def test_the_plaster_is_that_of_the_demonstration() -> None:
    plaster = named("plaster")
    for hours in (0.0, 1.7, 6.0):
        for name, value in plaster.at(hours).parameters.items():
            np.testing.assert_allclose(value, TRENDS[name](hours), rtol=1e-12, err_msg=name)


def test_a_certificate_takes_the_same_texts(here: Path) -> None:
    assert specimen_of("grey_card").name == "grey card"
    assert specimen_of(TEXT).name == TEXT
    with pytest.raises(MotesError, match="glod is no file"):
        specimen_of("glod")


# ---------------------------------------------------------------- every command that takes a material


def test_material_lists_shows_and_writes(motes: Run) -> None:
    status, out, err = motes("material")
    assert (status, err) == (0, "")
    assert motes("material", "--list")[1] == out
    for name in (*PRESETS, *registered(BRDF)):
        assert name in out
    listed = json.loads(motes("material", "--list", "--json")[1])
    assert [p["name"] for p in listed["presets"]] == list(PRESETS)
    assert listed["models"]["oren_nayar"] == ["K_d=0.5", "sigma_d=0.3"]
    status, out, err = motes("material", TEXT, "--name", "rock", "-o", "rock.json")
    assert (status, err) == (0, "")
    assert "sigma_d" in out
    same(load("rock.json"), ROCK)
    assert load("rock.json").name == "rock"
    assert "a model's text" in motes("material", TEXT)[1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("gold", "--list"), "a list was asked for"),
        (("-o", "x.json"), "a list was asked for"),
        (("gold", "--name", "x"), "nothing is written"),
        (("gold", "-o", "x.txt"), "no material by its name"),
    ],
)
def test_material_refuses(motes: Run, arguments: tuple[str, ...], message: str) -> None:
    status, _, err = motes("material", *arguments)
    assert status == 2
    assert message in err
    assert len(err.splitlines()) == 2


def test_every_command_that_takes_a_material_takes_a_text(motes: Run) -> None:
    assert motes("age", TEXT, "-p", "dust", "--hours", 10, "-o", "aged.json", "--quiet") == (0, "", "")
    same(load("aged.json"), load("aged.json").at(0))
    assert load("aged.json").at(0).parameters["K_d"].tolist() == [0.8, 0.7, 0.6]
    assert motes("age", "red_paint", "-p", "dust", "--from", "plaster", "-o", "b.json", "--quiet") == (0, "", "")
    assert motes("export", TEXT, "--to", "c", "-o", "rock.c", "--quiet") == (0, "", "")
    assert motes("export", TEXT, "--to", "merl", "-o", "rock.binary", "--quiet") == (0, "", "")
    assert motes("view", TEXT, "--against", "gold", "-o", "rock.html", "--quiet") == (0, "", "")
    assert "oren_nayar" in Path("rock.html").read_text("utf-8")
    assert motes("simulate", "scans", "--material", "clay", "--scans", 1, "--step-deg", 30, "--quiet") == (0, "", "")
    said = json.loads(motes("info", TEXT, "--json")[1])
    assert (said["kind"], said["model"]) == ("material", "oren_nayar")


def test_dust_takes_a_preset(motes: Run) -> None:
    pytest.importorskip("mitsuba")
    status, out, _ = motes("dust", "plane", "--days", 0.25, "--material", "plaster", "--rays", 16, "--json")
    assert status == 0
    assert json.loads(out)["open_tau"] == pytest.approx(0.05 + 0.06 * 6)


def test_render_takes_presets_and_texts(motes: Run) -> None:
    pytest.importorskip("mitsuba")
    status, out, _ = motes("render", TEXT, "gold", "--size", 24, "--samples", 1, "-o", "two.png", "--json")
    assert status == 0
    assert json.loads(out)["materials"] == [TEXT, "gold"]


def test_a_name_that_is_nearly_right_gets_a_hint(motes: Run) -> None:
    for command in (("render", "-o", "x.png"), ("export", "--to", "c"), ("view",), ("info",), ("age", "-p", "dust")):
        status, _, err = motes(command[0], "glod", *command[1:])
        assert (status, err.splitlines()[-1]) == (2, "hint: Did you mean gold?"), command
