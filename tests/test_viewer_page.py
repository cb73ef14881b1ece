"""The page of the viewer as a file: what it holds and forbids, what Python and TypeScript agree on, the command."""

from __future__ import annotations

import base64
import hashlib
import json
import re
import subprocess
import sys
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest

import motes
from motes.cli.main import main
from motes.directions import from_spherical
from motes.errors import DataError, MissingExtraError, ParameterError
from motes.material import Material
from motes.measurements import Measurement
from motes.meshes import shapes as originals
from motes.models import BRDF, Fresnel, Lambert, parse, registered
from motes.parameters import Parametrised
from motes.viewer import declarations, shader_library, shipped_shapes
from motes.viewer.page import page, policy, safe_json
from motes.viewer.payload import MOST_DIRECTIONS, payload
from motes.viewer.viewing import View, view
from viewer_support import DUSTY, ROCK, SOURCES, STATIC, drying, measured, node

EVIL = "</script><script>alert(1)</script><!-- \N{LINE SEPARATOR} & \udc80"


def data_of(text: str) -> dict:
    """The JSON in a page."""
    return json.loads(re.search(r'<script type="application/json" id="motes-data">(.*?)</script>', text, re.DOTALL)[1])


def test_the_page_holds_everything_and_forbids_the_rest(tmp_path: Path) -> None:
    file = motes.view(ROCK).save(tmp_path / "page.html")
    text = file.read_text(encoding="utf-8")
    assert file.stat().st_size <= 1.5e6
    script, style = ((STATIC / name).read_text(encoding="utf-8") for name in ("viewer.js", "viewer.css"))
    rules = re.search(r'Content-Security-Policy" content="([^"]*)"', text)[1].replace("&#x27;", "'")
    assert rules == policy(script, style)
    directives = dict(rule.split(" ", 1) for rule in rules.split("; "))
    assert directives["default-src"] == directives["connect-src"] == "'none'"
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert directives["script-src"] == f"'sha256-{digest}'"
    assert "unsafe" not in rules
    # Nothing refers to another file, and the script cannot be ended from inside.
    assert not re.findall(r'<(?:link|iframe|object|embed|base)\b|<(?:script|img)[^>]*src="(?!data:)', text)
    for end in ("</script", "<!--", "]]>"):
        assert end not in script.lower()
    assert text.count("<script") == 2 + script.count("<script")
    shown = data_of(text)
    assert shown["format"] == "motes view"
    assert shown["materials"][0]["json"]["model"] == "oren_nayar + torrance_sparrow"


def test_names_are_escaped_wherever_they_appear(tmp_path: Path) -> None:
    material = Material(ROCK, name=EVIL, channels=(EVIL, "G", "B"), about={"note": EVIL})
    points = Measurement.from_arrays(*[from_spherical([0.1, 0.2], 0.0)] * 2, np.ones((2, 3)), provenance={"name": EVIL})
    text = page(payload([material], points, notes=(EVIL,)), [material])
    assert "alert(1)</script>" not in text
    assert text.count("<script") == 2 + (STATIC / "viewer.js").read_text().count("<script")
    shown = data_of(text)
    inert = EVIL.replace("\u2028", "\ufffd").replace(
        "\udc80", "\ufffd"
    )  # a line end that nobody sees, half a surrogate pair
    assert shown["materials"][0]["json"]["name"] == inert
    assert shown["notes"] == [inert]
    with pytest.raises(ValueError, match="not JSON compliant"):
        safe_json({"x": float("nan")})


def test_the_types_have_not_drifted() -> None:
    """What TypeScript knows of models, parameters and the payload is what Python declares."""
    assert (SOURCES / "src" / "generated.ts").read_text(encoding="utf-8") == declarations.typescript(), (
        "run tools/viewer_build.py"
    )


@pytest.mark.slow
def test_the_bundle_is_what_the_sources_build(tmp_path: Path) -> None:
    run = node()
    for script, arguments in (("node_modules/typescript/bin/tsc", ["--noEmit"]), ("build.mjs", [str(tmp_path)])):
        done = subprocess.run([run, script, *arguments], cwd=SOURCES, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stdout + done.stderr
    for name in ("viewer.js", "viewer.css"):
        assert (tmp_path / name).read_text() == (STATIC / name).read_text(), f"{name} is old: run tools/viewer_build.py"


def test_the_lock_file_has_no_addresses() -> None:
    assert "omit-lockfile-registry-resolved=true" in (SOURCES / ".npmrc").read_text()
    assert '"resolved"' not in (SOURCES / "package-lock.json").read_text()
    assert "http" not in (SOURCES / "package.json").read_text()


def test_the_payload_says_what_the_shader_needs() -> None:
    shown = payload([drying(), Material(ROCK)])
    first = shown["materials"][0]
    assert [u["slot"] for u in first["shader"]["uniforms"]] == [slot.name for slot in DUSTY.slots()]
    assert [u["size"] for u in first["shader"]["uniforms"]] == [3, 1, 1, 1, 3, 1, 1]
    time = first["time"]
    assert time["interval"] == (0.0, 6.0)
    assert set(time["trends"]) == {"K_d", "K_s", "tau"}
    half = time["hours"].index(3.0)
    np.testing.assert_allclose(time["trends"]["K_d"]["values"][half], drying().at(3.0).parameters["K_d"])
    trend = drying().trends["K_s"]
    np.testing.assert_allclose(np.ravel(time["trends"]["K_s"]["stderr"]), np.ravel(trend.stderr(time["hours"])))
    assert time["trends"]["tau"]["stderr"] is None
    assert shown["materials"][1]["time"] is None
    json.dumps(shown, allow_nan=False)


def test_scans_come_from_the_fit_beside_a_material() -> None:
    """What each scan said, out of a fit.json; one that is damaged shows nothing of it, and is no error."""
    entry = {"scan_values": [[0.5], [0.3], [None]], "scan_stderr": [[0.01], [None], [None]]}
    fitted = {"hours": [0.0, 3.0, 6.0], "trends": {"K_s": entry}}
    shown = payload([drying()], fit=fitted)["materials"][0]["time"]["trends"]
    assert shown["K_s"]["scans"] == {"hours": fitted["hours"], "values": entry["scan_values"], "stderr": entry["scan_stderr"]}  # fmt: skip
    assert shown["tau"]["scans"] is None
    damages = ({"hours": "x"}, {"hours": [0.0]}, {"trends": []}, {"trends": {"K_s": 1}}, {"trends": {"K_s": {**entry, "scan_values": "no"}}})  # fmt: skip
    for damage in damages:
        shown = payload([drying()], fit={**fitted, **damage})["materials"][0]["time"]["trends"]
        assert shown["K_s"]["scans"] is None


def test_a_layer_over_a_base_is_a_layer_over_a_lambertian_of_its_value() -> None:
    """What lets the page put dust over any base: DustLayer(base) = DustLayer(Lambert(pi f_base))."""
    rng = np.random.default_rng(1)
    wi, wo = (from_spherical(np.arccos(rng.uniform(0.02, 1, 200)), rng.uniform(-3, 3, 200)) for _ in range(2))
    base = np.asarray(ROCK.eval(wi, wo))
    over = motes.DustLayer(Lambert(K_d=np.pi * base), DUSTY.dust, DUSTY.tau)
    np.testing.assert_allclose(over.eval(wi, wo), DUSTY.eval(wi, wo), rtol=1e-12)
    assert set(shader_library.library()) == set(shader_library.pieces())
    for name, piece in shader_library.library().items():
        assert f"vec3 {name}_eval_with(" in piece["source"]


def test_the_page_finds_a_piece_for_every_model() -> None:
    """Each model with each of its options and each Fresnel term has a printed piece, by the name that the page makes of it."""
    made = set()
    for name, cls in registered(BRDF).items():
        names = [[name]]
        options = {o.name: o.words for o in cls.declared_options()}
        for f in fields(cls):
            if f.name in options:
                names = [[*start, word] for start in names for word in options[f.name]]
            elif f.name == "fresnel":
                names = [[*start, *word] for start in names for word in ([], *([each] for each in registered(Fresnel)))]
        made |= {"_".join(each) for each in names}
    # Words that do not go together, a layer that is lit by its base, and exact Fresnel terms of facets that give back all light, which are long:
    # the page says that it holds no shader for that.
    exact = {f"{name}_{term}_multiple" for name in ("ggx", "beckmann") for term in ("dielectric", "conductor")}
    assert made - set(shader_library.pieces()) == {"dust_brightness_multiple", "dust_layer_multiple", *exact}
    assert set(shader_library.pieces()) <= made


def test_the_meshes_are_those_of_the_rendering_room() -> None:
    shown = {shape["name"]: shape for shape in shipped_shapes.shapes()["shapes"]}
    for mesh in (originals.sphere(48), originals.teapot(10), originals.bunny(1)):
        view_ = shown[mesh.name]
        low, high = (np.array(view_[key]) for key in ("low", "high"))
        positions = unpacked(view_["positions"], "<u2").reshape(-1, 3) / 65535 * (high - low) + low
        np.testing.assert_allclose(positions, mesh.positions, atol=3e-5)
        np.testing.assert_allclose(unpacked(view_["normals"], "<i2").reshape(-1, 3) / 32767, mesh.normals, atol=2e-5)
        # No cracks: what is one point in the mesh, but for the last bits, is one on the page.
        steps = unpacked(view_["positions"], "<u2").reshape(-1, 3)
        _, which = np.unique(np.round(mesh.positions, 9), axis=0, return_inverse=True)
        assert len(np.unique(np.column_stack([which.ravel(), steps]), axis=0)) == which.max() + 1
        np.testing.assert_array_equal(unpacked(view_["triangles"], "<u2").reshape(-1, 3), mesh.triangles)


@pytest.mark.slow
def test_the_dust_is_that_of_the_rendering_room() -> None:
    pytest.importorskip("mitsuba")
    now, stored = shipped_shapes.make(), shipped_shapes.shapes()
    np.testing.assert_allclose(now["dust_by_inclination"], stored["dust_by_inclination"], atol=2e-4)
    for a, b in zip(now["shapes"], stored["shapes"], strict=True):
        difference = np.abs(unpacked(a["dust"], "u1").astype(int) - unpacked(b["dust"], "u1"))
        # A ray that grazes an edge may fall on its other side on another machine.
        assert np.mean(difference > 2) < 0.01, a["name"]


def unpacked(text: str, dtype: str) -> np.ndarray:
    return np.frombuffer(base64.b64decode(text), dtype)


def test_many_points_are_thinned_and_it_is_said() -> None:
    rng = np.random.default_rng(0)
    n = 50_000
    wi = from_spherical(rng.uniform(0, 1.4, n), 0.0)
    dphi = np.where(rng.uniform(size=n) < 0.1, np.pi, rng.uniform(-3, 3, n))
    wo = from_spherical(rng.uniform(0, 1.4, n), dphi)
    data = Measurement.from_arrays(wi, wo, rng.uniform(0, 1, (n, 3)), provenance={"name": "many"})
    shown = payload([Material(ROCK)], data)
    points = shown["measurement"]
    assert points["count"] == MOST_DIRECTIONS
    assert "50,000 pairs of directions; the page holds 6,000 of them" in shown["notes"][0]
    kept = [unpacked(points[key], "<f4").reshape(-1, 3) for key in ("wi", "wo")]
    aside = np.abs(kept[0][:, 0] * kept[1][:, 1] - kept[0][:, 1] * kept[1][:, 0])
    assert (aside < 0.053).sum() >= MOST_DIRECTIONS // 2  # the plane of incidence comes first
    assert len(page(shown, [Material(ROCK)])) < 2e6
    assert payload([Material(ROCK)], measured(ROCK))["notes"] == []


def test_what_cannot_be_shown_is_refused() -> None:
    with pytest.raises(ParameterError, match="a dict is neither a material nor a fit nor a measurement"):
        view({})  # type: ignore[arg-type]
    with pytest.raises(ParameterError, match="K_d has shape"):
        view(Lambert(K_d=np.full((5, 3), 0.5)))
    nothing = Measurement.from_arrays([[0, 0, 1.0]], [[0, 0, 1.0]], [np.nan])
    with pytest.raises(DataError, match="has no usable sample"):
        view(ROCK, data=nothing)
    with pytest.raises(ParameterError, match="3 materials"):
        payload([Material(ROCK)] * 3)


def test_a_notebook_gets_a_widget() -> None:
    pytest.importorskip("anywidget")
    shown = motes.view(ROCK)
    assert isinstance(shown, View)
    bundle = shown._repr_mimebundle_()
    mime = bundle[0] if isinstance(bundle, tuple) else bundle
    assert "application/vnd.jupyter.widget-view+json" in mime
    assert shown.widget.payload["format"] == "motes view"
    assert shown.widget._esm == (STATIC / "viewer.js").read_text()
    shown.widget.state = {"exposure": 1}
    assert repr(shown) == "View('material')"


def test_without_anywidget_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    from motes.viewer import widget

    widget.widget_class.cache_clear()
    monkeypatch.setitem(sys.modules, "anywidget", None)
    with pytest.raises(MissingExtraError, match=r"pip install.*\[notebook\]"):
        view(ROCK).widget  # noqa: B018


# ------------------------------------------------------------ the command


def run(*arguments: object) -> int:
    return main([str(argument) for argument in arguments])


def test_motes_view_of_a_material(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Material(ROCK, name="rock", channels=("R", "G", "B")).save(tmp_path / "rock.json")
    drying().save(tmp_path / "plaster.json")
    out = tmp_path / "out.html"
    assert run("view", tmp_path / "rock.json", "--against", tmp_path / "plaster.json", "-o", out, "--json") == 0
    said = json.loads(capsys.readouterr().out)
    assert said["materials"] == ["rock", "plaster"]
    assert said["bytes"] == out.stat().st_size
    assert [m["json"]["name"] for m in data_of(out.read_text())["materials"]] == ["rock", "plaster"]


def test_motes_view_of_a_fit_finds_its_data(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    theta = np.arange(-70, 71, 5)
    rows = [f"{i},0,{abs(t)},{180 if t > 0 else 0},{0.3 + 0.1 * np.cos(t / 50):.4f}" for i in (20, 50) for t in theta]
    table = tmp_path / "table.csv"
    table.write_text("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg,grey\n" + "\n".join(rows) + "\n")
    assert run("fit", table, "-m", "lambert", "-o", tmp_path / "fit", "--quiet") in (0, 1)
    out = tmp_path / "out.html"
    assert run("view", tmp_path / "fit", "-o", out, "--json") == 0
    assert json.loads(capsys.readouterr().out)["points"] == len(rows)
    assert run("view", table, "-m", "lambert", "-o", out, "--json") == 0
    assert json.loads(capsys.readouterr().out)["points"] == len(rows)
    assert str(tmp_path) not in out.read_text()  # a page is handed on
    # A relative path is found again from another folder, and other bytes of the same name are not taken for it.
    elsewhere = tmp_path / "a" / "b"
    elsewhere.mkdir(parents=True)
    monkeypatch.chdir(tmp_path)
    assert run("fit", "table.csv", "-m", "lambert", "-o", "near", "--quiet") in (0, 1)
    (elsewhere / "table.csv").write_text(table.read_text().replace("0.3", "0.4"))
    monkeypatch.chdir(elsewhere)
    assert run("view", tmp_path / "near", "-o", out, "--json") == 0
    assert json.loads(capsys.readouterr().out)["points"] == len(rows)
    monkeypatch.chdir(tmp_path)
    table.unlink()
    assert run("view", tmp_path / "fit", "-o", out) == 0
    text = capsys.readouterr().out
    assert "--data shows them" in text
    assert "written" in text


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("{", "is not JSON"),
        ('{"format": "motes material", "version": 99}', "newer than 1"),
        (json.dumps(Material(ROCK).to_dict() | {"model": "velvet"}), "'velvet' is not a model"),
        ('{"format": "motes material", "version": 1, "model": "lambert", "parameters": {"K_d": {"value": NaN}}}', "K_d"),
    ],
)  # fmt: skip
def test_motes_view_refuses(tmp_path: Path, capsys: pytest.CaptureFixture[str], content: str, message: str) -> None:
    (tmp_path / "bad.json").write_text(content)
    assert run("view", tmp_path / "bad.json", "-o", tmp_path / "out.html") == 2
    error = capsys.readouterr().err
    assert message in error
    assert "Traceback" not in error
    assert not (tmp_path / "out.html").exists()


def test_models_as_text_are_read_alike() -> None:
    """The TypeScript reader of models against `parse`: accepted, refused, and the same parameters in the same order."""
    run_node = node()
    texts = [
        "lambert",
        "oren_nayar + torrance_sparrow + torrance_sparrow",
        "oren_nayar + (lambert + dust)",
        "dust_layer(oren_nayar + torrance_sparrow(fresnel=conductor), dust=dust)",
        "dust_layer(base=lambert, tau=0.5)",
        "torrance_sparrow(normalization=facets, fresnel=dielectric(n=1.4))",
        "torrance_sparrow(fresnel=schlick(f0=[0.1, 0.2, 0.3]))",
        "dust(form=brightness)",
        *("", "velvet", "lambert +", "dust_layer", "dust_layer(dust(form=brightness)", "torrance_sparrow(fresnel=lambert)"),
        *("dielectric", "lambert(K_d=x)", "lambert(K_d=1, K_d=2)", "lambert lambert", "__proto__", "lambert(form=brdf)"),
        "dust_layer(lambert, dust=dust(form=brightness))",
    ]  # fmt: skip
    wanted: list[list[str] | None] = []
    for text in texts:
        try:
            model: Parametrised = parse(text).model
            wanted.append([slot.name for slot in model.slots()])
        except ParameterError:
            wanted.append(None)
    script = (
        "import { build } from 'esbuild';"
        "const made = await build({ entryPoints: ['src/expression.ts'], bundle: true, format: 'esm', write: false });"
        "const { parse, slots } = await import('data:text/javascript,' + encodeURIComponent(made.outputFiles[0].text));"
        "const read = (text) => { try { return slots(parse(text)).map((s) => s.name); } catch { return null; } };"
        "process.stdout.write(JSON.stringify(JSON.parse(process.argv[1]).map(read)));"
    )
    done = subprocess.run(
        [run_node, "--input-type=module", "-e", script, json.dumps(texts)],
        cwd=SOURCES,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == wanted
