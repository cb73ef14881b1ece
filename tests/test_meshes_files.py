"""Meshes as other programs write them: OBJ and PLY with their habits, STL and glTF, faces that look inwards, and hostile files."""

from __future__ import annotations

import base64
import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motes.cli.main import main
from motes.errors import FormatError, MissingExtraError
from motes.files import budget
from motes.meshes import obj as _obj
from motes.meshes import ply as _ply
from motes.meshes.mesh import Mesh
from motes.meshes.meshfile import read_mesh
from motes.meshes.shapes import bunny, plane, sphere, teapot
from motes.meshes.subdivision import loop
from motes.meshes.winding import examined, turned_outwards, welded

BOX = [
    *("v -1 -1 -1", "v 1 -1 -1", "v 1 1 -1", "v -1 1 -1", "v -1 -1 1", "v 1 -1 1", "v 1 1 1", "v -1 1 1"),
    *("f 4 3 2 1", "f 5 6 7 8", "f 1 2 6 5", "f 3 4 8 7", "f 2 3 7 6", "f 1 5 8 4"),
]


def volume(mesh: Mesh) -> float:
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def area(mesh: Mesh) -> float:
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2)


def written(path: Path, lines: list[str], ending: str = "\n", encoding: str = "utf-8") -> Path:
    path.write_bytes((ending.join(lines) + ending).encode(encoding))
    return path


# ---------------------------------------------------------------- OBJ


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("spare", [[], ["v 9 9 9"]])
def test_marks_and_line_ends_change_nothing(tmp_path: Path, encoding: str, ending: str, spare: list[str]) -> None:
    box = [*BOX[:8], *spare, *BOX[8:]]
    mesh = read_mesh(written(tmp_path / "a.obj", box, ending, encoding))
    assert volume(mesh) == pytest.approx(8)
    assert area(mesh) == pytest.approx(24)


HABITS = {
    "comments": ["# Blender 4.2", "mtllib none.mtl", *BOX[:8], "usemtl red # not opened", "s off", "o box", "g a b", *BOX[8:], "l 1 2", "#f 1 2 3"],
    "comments behind": [f"{line} # said" for line in BOX],
    "vertex colours": [f"{line} 0.1 0.2 0.3" if line[0] == "v" else line for line in BOX],
    "w": [f"{line} 1.0" if line[0] == "v" else line for line in BOX],
    "tabs": [line.replace(" ", "\t") for line in BOX],
    "indented": [f"  {line}" for line in BOX],
    "doubled blanks": [line.replace(" ", "  ") for line in BOX],
    "negative": [*BOX[:8], *(f"f {' '.join(str(int(w) - 9) for w in line.split()[1:])}" for line in BOX[8:])],
    "negative, in two objects": ["v 9 9 9", *BOX[:8], "f -5 -6 -7 -8", "v 7 7 7",
        *(f"f {' '.join(str(int(w) - 10) for w in line.split()[1:])}" for line in BOX[9:])],
    "interleaved": [*BOX[:4], BOX[8], *BOX[4:8], *BOX[9:]],
    "continued": [*BOX[:8], "f 4 3 \\", "2 1", *BOX[9:]],
    "an n-gon": [*BOX[:8], "v 0 -1 -1", "f 4 3 2 9 1", *BOX[9:]],
    "triangles among quads": [*BOX[:8], "f 4 3 2", "f 4 2 1", *BOX[9:]],
    "exponents": [line.replace("v 1", "v 1.0E+00").replace("-1", "-1e0") if line[0] == "v" else line for line in BOX],
}  # fmt: skip


@pytest.mark.parametrize("lines", list(HABITS.values()), ids=list(HABITS))
def test_habits_of_programs(tmp_path: Path, lines: list[str]) -> None:
    mesh = read_mesh(written(tmp_path / "a.obj", lines))
    assert abs(volume(mesh)) == pytest.approx(8)
    assert area(mesh) == pytest.approx(24)


def test_both_ways_of_reading_say_the_same(tmp_path: Path) -> None:
    for shape in (teapot(3), bunny(0)):
        assert shape.normals is not None
        table = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in shape.positions]
        table += [f"vn {x:.9g} {y:.9g} {z:.9g}" for x, y, z in shape.normals]
        styles = [["{0}//{0}"]]
        if shape.uv is not None:
            table += [f"vt {u:.9g} {v:.9g}" for u, v in shape.uv]
            styles += [["{0}/{0}/{0}"], ["{0}/{0}"], ["{0}"]]
        for (style,) in styles:
            faces = ["f " + " ".join(style.format(k + 1) for k in face) for face in shape.triangles]
            at_once = _obj._at_once([*table, *faces])
            one_by_one = _obj._line_by_line(tmp_path, [*table, *faces])
            assert at_once is not None
            for found, expected in zip(at_once[1:], one_by_one[1:], strict=True):
                np.testing.assert_array_equal(found, expected)
            for kind in ("v", "vt", "vn"):
                np.testing.assert_array_equal(at_once[0][kind], one_by_one[0][kind])


# ---------------------------------------------------------------- digits


UTM = np.array([500_000.123456, 4_100_000.654321, 512.5])


def test_coordinates_far_away_keep_their_digits(tmp_path: Path) -> None:
    far = Mesh(sphere(16).positions + UTM, sphere(16).triangles, name="far")
    for name in ("a.obj", "a.ply"):
        if name == "a.obj":
            lines = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in far.positions]
            written(tmp_path / name, [*lines, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in far.triangles)])
        else:
            _ply.write_ply(tmp_path / name, far)
            assert b"property double x" in (tmp_path / name).read_bytes()[:400]
        mesh = read_mesh(tmp_path / name)
        assert volume(Mesh(mesh.positions - UTM, mesh.triangles)) == pytest.approx(volume(sphere(16)), rel=1e-6)
        assert not any("single precision" in note for note in mesh.notes)
    _ply.write_ply(tmp_path / "near.ply", sphere(16))
    assert b"property float x" in (tmp_path / "near.ply").read_bytes()[:400]
    binary = (
        b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        b"element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    )
    corners = UTM + np.array([[0, 0, 0], [1, 0, 0], [0, 0, 1]])
    (tmp_path / "lost.ply").write_bytes(binary + corners.astype("<f4").tobytes() + struct.pack("<B3i", 3, 0, 1, 2))
    assert "single precision, which tells places apart only from 0.25 on" in " ".join(
        read_mesh(tmp_path / "lost.ply").notes
    )


# ---------------------------------------------------------------- which way faces look


def turned(mesh: Mesh, which: np.ndarray) -> Mesh:
    triangles = mesh.triangles.copy()
    triangles[which] = triangles[which][:, ::-1]
    return Mesh(mesh.positions, triangles, name=mesh.name)


def as_obj(path: Path, mesh: Mesh) -> Path:
    vertices = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in mesh.positions]
    return written(path, [*vertices, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in mesh.triangles)])


def test_faces_that_look_inwards_are_said_and_turned(tmp_path: Path) -> None:
    ball = sphere(12)
    everything = np.ones(len(ball.triangles), bool)
    path = as_obj(tmp_path / "a.obj", turned(ball, everything))
    mesh = read_mesh(path)
    assert "the mesh is inside out: its faces point inwards (its volume is -4." in " ".join(mesh.notes)
    assert "motes dust --outwards" in " ".join(mesh.notes)
    mended = read_mesh(path, outwards=True)
    assert volume(mended) == pytest.approx(volume(ball), rel=1e-6)
    assert np.einsum("ij,ij->i", mended.normals, mended.positions - [0, 1, 0]).min() > 0.9
    assert f"{len(ball.triangles)} of {len(ball.triangles)} faces were turned" in " ".join(mended.notes)
    some = np.random.default_rng(1).random(len(ball.triangles)) < 0.3
    path = as_obj(tmp_path / "b.obj", turned(ball, some))
    assert "faces disagree on which side is out along" in " ".join(read_mesh(path).notes)
    assert volume(read_mesh(path, outwards=True)) == pytest.approx(volume(ball), rel=1e-6)
    for notes in (read_mesh(as_obj(tmp_path / "c.obj", ball), outwards=way).notes for way in (False, True)):
        assert notes == ("the file has no normals; they were computed",)


def test_normals_of_the_file_count_where_it_has_them(tmp_path: Path) -> None:
    ball = sphere(12)
    inwards = turned(ball, np.ones(len(ball.triangles), bool))
    out = _ply.write_ply(tmp_path / "a.ply", Mesh(ball.positions, inwards.triangles, ball.normals))
    assert not read_mesh(out).notes  # dust goes by the normals, and they look outwards
    inside = _ply.write_ply(tmp_path / "b.ply", Mesh(ball.positions, inwards.triangles, -ball.normals))
    assert "its normals point inwards" in " ".join(read_mesh(inside).notes)
    mended = read_mesh(inside, outwards=True)
    used = np.unique(mended.triangles)
    np.testing.assert_allclose(mended.normals[used], ball.normals[used], atol=1e-6)


def test_turning_agrees_with_trimesh(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    pytest.importorskip("networkx")
    rng = np.random.default_rng(2)
    two = [sphere(8), sphere(8).moved(shift=(5, 0, 0))]
    for shape in (*two[:1], bunny(0)):
        place = welded(shape.positions)
        points = np.zeros((place.max() + 1, 3))
        points[place] = shape.positions
        mixed = turned(Mesh(points, place[shape.triangles].astype(np.int32)), rng.random(len(shape.triangles)) < 0.4)
        own = turned_outwards(mixed)
        other = trimesh.Trimesh(mixed.positions, mixed.triangles, process=False)
        trimesh.repair.fix_normals(other, multibody=True)
        assert examined(own.positions, own.triangles).disagreeing == 0
        np.testing.assert_allclose(volume(own), abs(other.volume), rtol=1e-9)
    both = Mesh(
        np.concatenate([m.positions for m in two]),
        np.concatenate([two[0].triangles, two[1].triangles[:, ::-1] + len(two[0].positions)]).astype(np.int32),
    )
    assert volume(turned_outwards(both)) == pytest.approx(2 * volume(two[0]))
    floor = plane(4)
    most = turned(floor, np.arange(len(floor.triangles)) < 5)  # an open piece: as most of it looked before
    np.testing.assert_array_equal(turned_outwards(most).triangles[5:], floor.triangles[5:])
    assert examined(floor.positions, turned_outwards(most).triangles).disagreeing == 0
    assert not examined(floor.positions, floor.triangles).closed


def test_loop_subdivision_agrees_with_trimesh() -> None:
    """Where every vertex has 3 or 6 neighbours; elsewhere trimesh has Loop's own weights, and Motes has Warren's."""
    trimesh = pytest.importorskip("trimesh")
    points = np.array([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    own = Mesh(points, np.array([[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]], np.int32))
    for _ in range(3):
        expected, _faces = trimesh.remesh.subdivide_loop(own.positions, own.triangles, iterations=1)
        own = loop(own)
        order = [np.lexsort(np.round(p, 9).T) for p in (own.positions, expected)]
        np.testing.assert_allclose(own.positions[order[0]], expected[order[1]], atol=1e-9)


# ---------------------------------------------------------------- STL and glTF


def test_stl_of_both_kinds(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    read_mesh(written(tmp_path / "box.obj", BOX))
    box = trimesh.creation.box((2, 2, 2))
    (tmp_path / "a.stl").write_bytes(box.export(file_type="stl"))
    (tmp_path / "b.stl").write_text(box.export(file_type="stl_ascii"))
    for name in ("a.stl", "b.stl"):
        mesh = read_mesh(tmp_path / name)
        assert (volume(mesh), area(mesh)) == (pytest.approx(8), pytest.approx(24))
        assert len(mesh.positions) == 24  # welded, then split at its edges
    (tmp_path / "a.stl").write_bytes((tmp_path / "a.stl").read_bytes()[:-7])
    with pytest.raises(FormatError, match="is not an STL file, or is cut short"):
        read_mesh(tmp_path / "a.stl")


def scene() -> Any:
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((2, 2, 2))
    made = trimesh.Scene()
    made.add_geometry(box, node_name="near", geom_name="box")
    made.add_geometry(
        box,
        node_name="far",
        geom_name="box",
        transform=trimesh.transformations.compose_matrix(scale=[2, 1, 1], translate=[10, 0, 0]),
    )
    return made


def test_gltf_of_both_kinds(tmp_path: Path) -> None:
    (tmp_path / "a.glb").write_bytes(scene().export(file_type="glb"))
    for name, data in scene().export(file_type="gltf").items():
        (tmp_path / name.replace("model.", "b.")).write_bytes(data)
    for name in ("a.glb", "b.gltf"):
        mesh = read_mesh(tmp_path / name)
        assert volume(mesh) == pytest.approx(8 + 16)
        assert mesh.bounds[1][0] == pytest.approx(12)
    document = json.loads((tmp_path / "b.gltf").read_text())
    held = (tmp_path / document["buffers"][0]["uri"]).read_bytes()
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(held).decode()
    (tmp_path / "c.gltf").write_text(json.dumps(document))
    if len(document["buffers"]) == 1:
        assert volume(read_mesh(tmp_path / "c.gltf")) == pytest.approx(24)


def test_files_outside_the_folder_are_not_opened(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "secret.bin").write_bytes(bytes(1000))
    outside = ("../secret.bin", str(tmp_path / "secret.bin"), "https://example.org/a.bin")
    for uri, words in (*((uri, "outside its folder") for uri in outside), ("none.bin", "is not there")):
        document = {"asset": {"version": "2.0"}, "buffers": [{"uri": uri, "byteLength": 100}]}
        (tmp_path / "in" / "a.gltf").write_text(json.dumps(document))
        with pytest.raises(FormatError, match=words):
            read_mesh(tmp_path / "in" / "a.gltf")


TRIANGLE = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]]).tobytes()
PLAIN: dict[str, Any] = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36}],
}


def glb(path: Path, binary: bytes = TRIANGLE, **changes: Any) -> Path:
    text = json.dumps(PLAIN | changes).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    path.write_bytes(b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body)
    return path


HOSTILE: dict[str, tuple[dict[str, Any], str]] = {
    "a cycle": ({"nodes": [{"mesh": 0, "children": [1]}, {"children": [0]}]}, "own ancestors"),
    "a node that is its own child": ({"nodes": [{"mesh": 0, "children": [0]}]}, "own ancestors"),
    "two parents": ({"nodes": [{"children": [2]}, {"children": [2]}, {"mesh": 0}]}, "nodes that lead nowhere"),
    "a deep chain": ({"nodes": [*({"children": [k + 1]} for k in range(99)), {"mesh": 0}]}, "64 deep"),
    "a negative stride": ({"bufferViews": [{"buffer": 0, "byteLength": 36, "byteStride": -12}]}, "byteStride = -12 is no size"),
    "a negative offset": ({"bufferViews": [{"buffer": 0, "byteLength": 36, "byteOffset": -4}]}, "is no size"),
    "an absurd count": ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": 2**39, "type": "VEC3"}]}, "beyond the file"),
    "numbers that are not there": ({"accessors": [{"componentType": 5126, "count": 2**33, "type": "VEC3"}]}, "would take"),
    "a long buffer": ({"buffers": [{"byteLength": 2**39}], "bufferViews": [{"buffer": 0, "byteLength": 2**39}]}, "claims"),
    "many of one": ({"nodes": [{"mesh": 0}] * 200_000, "scenes": [{"nodes": list(range(200_000))}]}, "would take"),
    "text for a number": ({"accessors": [{"bufferView": "x", "componentType": 5126, "count": 3, "type": "VEC3"}]}, "is no size"),
    "an infinite number": ({"accessors": [{"bufferView": 0, "componentType": 5126, "count": 1e300, "type": "VEC3"}]}, "is no size"),
    "a list of lists": ({"nodes": [[]]}, "nodes that lead nowhere"),
    "no list": ({"nodes": 5}, "nodes that lead nowhere"),
    "compressed": ({"extensionsRequired": ["KHR_draco_mesh_compression"]}, "KHR_draco"),
    "sparse": ({"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {}}]}, "sparse"),
    "nothing shown": ({"nodes": [{}]}, "shows no triangles"),
}  # fmt: skip


@pytest.mark.parametrize("kind", list(HOSTILE))
def test_hostile_gltf_is_refused_before_it_is_read(tmp_path: Path, kind: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("trimesh")
    changes, words = HOSTILE[kind]
    with pytest.raises(FormatError, match=words):
        read_mesh(glb(tmp_path / "a.glb", **changes))


def test_the_plain_one_of_them_is_read(tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    mesh = read_mesh(glb(tmp_path / "a.glb"))
    assert area(mesh) == pytest.approx(0.5)


def test_gltf_keeps_its_normals_and_mirrors_faces(tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    slanted = np.float32([[0.6, 0, 0.8]] * 3).tobytes()
    changes = {
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}],
        "accessors": [PLAIN["accessors"][0] | {"bufferView": k} for k in range(2)],
        "bufferViews": [{"buffer": 0, "byteOffset": 36 * k, "byteLength": 36} for k in range(2)],
        "buffers": [{"byteLength": 72}],
    }
    plain = read_mesh(glb(tmp_path / "a.glb", TRIANGLE + slanted, **changes))
    np.testing.assert_allclose(plain.normals, [[0.6, 0, 0.8]] * 3, atol=1e-7)
    assert plain.notes == ()
    mirror = {"nodes": [{"mesh": 0, "scale": [-2, 1, 1], "translation": [5, 0, 0]}]}
    mirrored = read_mesh(glb(tmp_path / "a.glb", TRIANGLE + slanted, **changes, **mirror))
    np.testing.assert_allclose(mirrored.normals, [np.array([-0.3, 0, 0.8]) / np.hypot(0.3, 0.8)] * 3, atol=1e-7)
    a, b, c = mirrored.positions[mirrored.triangles[0]]
    np.testing.assert_allclose(np.cross(b - a, c - a), [0, 0, 2])  # looks to the same side as before


@pytest.mark.parametrize("row", ["3 0.2 1.7 2", "3.0 0 1 2", "3 0 1e0 2", "4 0 1.5 2 1"])
def test_fractions_are_no_vertices(tmp_path: Path, row: str) -> None:
    """NumPy 1.26 reads 0.2 and 1.7 as the vertices 0 and 1 where it is asked for whole numbers."""
    head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    path = tmp_path / "a.ply"
    path.write_text(f"{head}property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n{row}\n")
    with pytest.raises(FormatError, match="faces"):
        read_mesh(path)
    path = tmp_path / "a.obj"
    path.write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\nf {row}\n")
    with pytest.raises(FormatError, match="line 4"):
        read_mesh(path)


def test_without_the_package_the_command_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
    for name in ("a.stl", "a.glb"):
        with pytest.raises(MissingExtraError, match=r"trimesh.*pip install.*\[meshes\]"):
            read_mesh(glb(tmp_path / name))
    assert len(read_mesh(written(tmp_path / "a.obj", BOX)).triangles) == 12


# ---------------------------------------------------------------- damage


def files(folder: Path) -> dict[str, bytes]:
    trimesh = pytest.importorskip("trimesh")
    ball = sphere(4)
    _ply.write_ply(folder / "b.ply", ball.with_attribute("tau", ball.positions[:, 0]))
    other = trimesh.Trimesh(ball.positions, ball.triangles, process=False)
    (folder / "a.ply").write_text(other.export(file_type="ply", encoding="ascii").decode())
    as_obj(folder / "a.obj", ball)
    written(folder / "q.obj", HABITS["negative, in two objects"])
    (folder / "b.stl").write_bytes(other.export(file_type="stl"))
    (folder / "a.stl").write_text(other.export(file_type="stl_ascii"))
    glb(folder / "s.glb", nodes=[{"children": [1]}, {"mesh": 0, "translation": [1, 2, 3], "rotation": [0, 0, 0, 1]}])
    return {path.name: path.read_bytes() for path in folder.iterdir()}


TEXTS = [
    b"nan",
    b"1e999",
    b"-1",
    b"10" * 300,
    b"",
    b" ",
    b"list",
    b"float",
    b"property",
    b"0x1",
    b"1_0",
    b"\xff",
    b"[",
    b"{}",
    b"null",
    b"-0.5",
]


def mutated(good: bytes, rng: np.random.Generator) -> bytes:
    data = bytearray(good)
    for _ in range(rng.integers(1, 4)):
        at = int(rng.integers(0, min(len(data), 500) if rng.random() < 0.5 else len(data)))
        if rng.random() < 0.5:
            data[at] = rng.integers(0, 256)
        else:
            data[at : at + int(rng.integers(0, 6))] = TEXTS[rng.integers(0, len(TEXTS))]
    return bytes(data if rng.random() < 0.8 else data[: rng.integers(0, len(data))])


def test_mutated_meshes_give_a_mesh_or_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "good").mkdir()
    rng = np.random.default_rng(4)
    answers: dict[str, int] = {}
    for name, good in files(tmp_path / "good").items():
        for _ in range(300):
            (tmp_path / name).write_bytes(mutated(good, rng))
            try:
                mesh = read_mesh(tmp_path / name, outwards=bool(rng.integers(0, 2)))
            except FormatError:
                continue
            assert np.isfinite(mesh.positions).all()
            assert mesh.triangles.max() < len(mesh.positions)
            answers[name] = answers.get(name, 0) + 1
    assert min(answers.get(name, 0) for name in ("b.ply", "a.ply", "a.obj", "b.stl", "s.glb")) > 3


def test_claims_are_checked_before_anything_is_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("trimesh")
    monkeypatch.setattr(budget, "LEAST", 2**16)
    many: Callable[[int], bytes] = lambda n: b"\0" * 80 + struct.pack("<I", n) + bytes(50 * n)  # noqa: E731
    (tmp_path / "a.stl").write_bytes(many(2000))
    with pytest.raises(FormatError, match=r"no triangle|no faces|have no area|would take"):
        read_mesh(tmp_path / "a.stl")


@pytest.mark.parametrize("suffix", [".ply", ".glb", ".usda"])
def test_numbers_beyond_single_precision_are_left_out_and_said(tmp_path: Path, suffix: str) -> None:
    """Meshes are written in single precision: what it cannot hold must not end as an infinity, or as a defect of Motes."""
    if suffix == ".usda":
        pytest.importorskip("pxr")
    head = ["ply", "format ascii 1.0", "element vertex 3"]
    head += [f"property double {name}" for name in ("x", "y", "z", "nx", "ny", "nz", "u", "v", "heat")]
    head += ["element face 1", "property list uchar int vertex_indices", "end_header"]
    body = ["0 0 0 0 0 1 1e308 0 1e300", "1 0 0 0 0 1 1 0 nan", "0 1 0 0 0 1 0 1 2", "3 0 1 2"]
    path = tmp_path / "a.ply"
    path.write_text("\n".join([*head, *body]) + "\n")
    mesh = read_mesh(path)
    assert mesh.uv is None
    assert not mesh.attributes
    said = " ".join(mesh.notes)
    assert "texture coordinates" in said
    assert "heat" in said
    assert main(["dust", str(path), "--days", "5", "-o", str(tmp_path / f"b{suffix}")]) == 0
    path.write_text("\n".join([*head, "0 0 0 0 0 1e308 0 0 0", *body[1:]]) + "\n")
    assert any("normals have no direction" in note for note in read_mesh(path).notes)
    path.write_text("\n".join([*head, "1e38 0 0 0 0 1 0 0 0", *body[1:]]) + "\n")
    with pytest.raises(FormatError, match="beyond 1e\\+30"):
        read_mesh(path)
