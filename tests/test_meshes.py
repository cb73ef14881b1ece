"""Meshes: reading, mending, refining, and the shapes that Motes brings along."""

from __future__ import annotations

import struct
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from motes.errors import FormatError, MotesError
from motes.meshes import ply as _ply
from motes.meshes.mesh import Mesh, face_normals, turn_to_y, with_normals
from motes.meshes.meshfile import read_mesh
from motes.meshes.shapes import SHAPES, bunny, plane, sphere, teapot
from motes.meshes.subdivision import loop, refine

BOX = """# a unit cube, eight vertices, no normals
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f 2 3 7 6
f 1 5 8 4
"""


def box(folder: Path) -> Mesh:
    file = folder / "box.obj"
    file.write_text(BOX)
    return read_mesh(file)


def volume(mesh: Mesh) -> float:
    """By the divergence theorem: positive when the triangles face out."""
    a, b, c = (mesh.positions[mesh.triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def euler(mesh: Mesh) -> int:
    """Vertices - edges + faces, of the welded surface: 2 for a sphere."""
    places, index = np.unique(mesh.positions.round(9), axis=0, return_inverse=True)
    triangles = index.reshape(-1)[mesh.triangles]
    sides = np.sort(np.stack([triangles, np.roll(triangles, -1, 1)], -1).reshape(-1, 2), axis=1)
    return len(places) - len(np.unique(sides, axis=0)) + len(triangles)


# ---------------------------------------------------------------- mending


def test_a_box_without_normals_keeps_its_sides_flat(tmp_path: Path) -> None:
    mesh = box(tmp_path)
    assert len(mesh.triangles) == 12
    assert len(mesh.positions) == 24  # each corner once for each of its three sides
    np.testing.assert_allclose(mesh.normals[mesh.triangles], face_normals(mesh)[:, None, :].repeat(3, 1), atol=1e-15)
    assert "no normals" in " ".join(mesh.notes)
    assert volume(mesh) == pytest.approx(1)


def test_normals_do_not_depend_on_how_sides_are_cut(tmp_path: Path) -> None:
    # At some corners of the box a side has two triangles, at others one; weighted by angles that makes no difference.
    rounded = with_normals(box(tmp_path), crease_deg=180)
    places, index = np.unique(rounded.positions, axis=0, return_inverse=True)
    welded = with_normals(Mesh(places, index.reshape(-1)[rounded.triangles].astype(np.int32)), crease_deg=180)
    np.testing.assert_allclose(welded.normals, (2 * places - 1) / np.sqrt(3), atol=1e-12)


def test_smooth_surfaces_are_not_split() -> None:
    for shape in (sphere(48), bunny(0)):
        bare = Mesh(shape.positions, shape.triangles)
        smooth = with_normals(bare, crease_deg=180)
        np.testing.assert_array_equal(smooth.positions, shape.positions[np.unique(shape.triangles)])
    round_ = with_normals(Mesh(sphere(48).positions, sphere(48).triangles))
    expected = round_.positions - [0, 1, 0]
    # Splitting never happens; normals come from the welded surface only where the file shares vertices (not at the seam).
    inner = np.abs(expected[:, 1]) < 0.9
    assert np.einsum("ij,ij->i", round_.normals, expected)[inner].min() > 0.998


def test_a_crease_follows_the_angle(tmp_path: Path) -> None:
    (tmp_path / "roof.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nv 0 1 2\nv 1 1 2\nf 1 3 4 2\nf 3 5 6 4\n"
    )  # 45 deg
    mesh = read_mesh(tmp_path / "roof.obj")
    assert len(mesh.positions) == 6
    assert len(with_normals(mesh, crease_deg=44).positions) == 8


def test_degenerate_triangles_are_left_out_and_said(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 2\n")
    mesh = read_mesh(tmp_path / "a.obj")
    assert len(mesh.triangles) == 1
    assert "2 of 3 triangles have no area" in mesh.notes[0]
    (tmp_path / "b.obj").write_text("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
    with pytest.raises(FormatError, match="no triangle with an area"):
        read_mesh(tmp_path / "b.obj")


def test_normals_that_are_no_numbers_are_computed(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 0\nvn 0 0 0\nf 1//1 2//1 3//2\n")
    mesh = read_mesh(tmp_path / "a.obj")
    np.testing.assert_array_equal(mesh.normals, [[0, 0, 1]] * 3)
    assert "3 normals have no direction" in mesh.notes[0]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "1 of 3 vertices whose position is not finite"),
        ("v 0 0 0\nv 1e200 0 0\nv 0 1e200 0\nf 1 2 3\n", "a coordinate of 1e\\+200"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4"),
        ("v 0 0 0\nv 1 0\n", "line 2"),
        ("v 0 0 0\nf 1 x 2\n", "line 2"),
        ("hello\n", "no faces"),
        ("", "no faces"),
    ],
)
def test_damaged_obj_files_are_explained(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "a.obj").write_text(text)
    with pytest.raises(FormatError, match=words):
        read_mesh(tmp_path / "a.obj")


def test_obj_indices_of_every_kind(tmp_path: Path) -> None:
    (tmp_path / "a.obj").write_text(
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf -4/1 -3/2 -2/3 -1/4\n"
    )
    mesh = read_mesh(tmp_path / "a.obj")
    np.testing.assert_array_equal(mesh.uv, [[0, 0], [1, 0], [1, 1], [0, 1]])
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [0, 2, 3]])


# ---------------------------------------------------------------- PLY


def test_ply_comes_back_as_it_was_written(tmp_path: Path) -> None:
    mesh = sphere(8).with_attribute("tau", np.linspace(0, 1, len(sphere(8).positions)))
    back = read_mesh(_ply.write_ply(tmp_path / "a.ply", mesh, ("a remark",)))
    for name in ("positions", "normals", "uv"):
        np.testing.assert_allclose(getattr(back, name), getattr(mesh, name), atol=1e-7)
    np.testing.assert_array_equal(back.triangles, mesh.triangles)
    np.testing.assert_allclose(back.attributes["tau"], mesh.attributes["tau"], atol=1e-7)
    assert b"\ncomment a remark\n" in (tmp_path / "a.ply").read_bytes()[:200]


def header(kind: str, vertices: int = 4, faces: int = 1) -> bytes:
    return (
        f"ply\nformat {kind} 1.0\ncomment x\nelement vertex {vertices}\nproperty float x\nproperty float y\nproperty float z\n"
        f"property uchar red\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    ).encode()


SQUARE = [(0, 0, 0, 7), (1, 0, 0, 8), (1, 1, 0, 9), (0, 1, 0, 10)]


@pytest.mark.parametrize("kind", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_every_kind_of_ply_is_read(tmp_path: Path, kind: str) -> None:
    order = ">" if "big" in kind else "<"
    if kind == "ascii":
        body = "".join(f"{x} {y} {z} {red}\n" for x, y, z, red in SQUARE).encode() + b"4 0 1 2 3\n"
    else:
        body = b"".join(struct.pack(order + "3fB", *row) for row in SQUARE) + struct.pack(order + "B4i", 4, 0, 1, 2, 3)
    (tmp_path / "a.ply").write_bytes(header(kind) + body)
    mesh = read_mesh(tmp_path / "a.ply")
    np.testing.assert_array_equal(mesh.positions, np.array(SQUARE)[:, :3])
    np.testing.assert_array_equal(mesh.triangles, [[0, 1, 2], [0, 2, 3]])
    np.testing.assert_array_equal(mesh.attributes["red"], [7, 8, 9, 10])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "not a PLY"),
        (b"ply\nformat ascii 1.0\n", "not a PLY"),
        (b"ply\nformat morse 1.0\nend_header\n", "morse"),
        (b"ply\nformat ascii 1.0\nelement vertex x\nend_header\n", "element vertex x"),
        (b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", "holds vertex"),
        (header("binary_little_endian", vertices=2**40) + bytes(100), "claims 1099511627776"),
        (header("binary_little_endian", faces=2**30) + bytes(200), "claims"),
        (header("binary_little_endian") + bytes(4 * 13), "claims|breaks off"),
        (header("binary_little_endian") + bytes(4 * 13) + struct.pack("<B2i", 200, 0, 1), "breaks off"),
        (header("ascii") + b"0 0 0 1\n1 0 0 1\n1 1 0 1\n", "claims 4 of vertex"),
        (header("ascii") + b"0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 z 1\n4 0 1 2 3\n", "breaks off"),
        (header("ascii") + b"0 0 0 1\n1 0 0 1\n1 1 0 1\n0 1 0 1\n3 0 1 9\n", "vertex 9 of 4"),
    ],
)
def test_damaged_ply_files_are_explained(tmp_path: Path, content: bytes, words: str) -> None:
    (tmp_path / "a.ply").write_bytes(content)
    with pytest.raises(FormatError, match=words):
        read_mesh(tmp_path / "a.ply")


@given(data=st.data())
def test_no_ply_ends_in_anything_but_an_explanation(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject
) -> None:
    whole = (
        header("binary_little_endian")
        + b"".join(struct.pack("<3fB", *r) for r in SQUARE)
        + struct.pack("<B4i", 4, 0, 1, 2, 3)
    )
    damaged = bytearray(whole[: data.draw(st.integers(0, len(whole)))])
    for at, byte in data.draw(
        st.lists(st.tuples(st.integers(0, max(len(damaged) - 1, 0)), st.integers(0, 255)), max_size=4)
    ):
        if damaged:
            damaged[at] = byte
    file = tmp_path_factory.getbasetemp() / "fuzz.ply"
    file.write_bytes(bytes(damaged))
    try:
        mesh = read_mesh(file)
    except FormatError:
        return
    assert np.isfinite(mesh.positions).all()
    assert mesh.triangles.max() < len(mesh.positions)


@pytest.mark.parametrize(
    ("name", "words"),
    [("a.fbx", "not a mesh by its name"), ("a.stl", "cannot be read"), ("none.ply", "cannot be read")],
)
def test_what_is_not_there_is_explained(tmp_path: Path, name: str, words: str) -> None:
    with pytest.raises(FormatError, match=words):
        read_mesh(tmp_path / name)


def test_real_meshes_are_read(shared: Callable[[str], Path]) -> None:
    mesh = read_mesh(shared("data/assets/bunny.obj"))
    np.testing.assert_array_equal(np.unique(mesh.positions, axis=0).shape, (1839, 3))
    assert len(mesh.triangles) == 3674


# ---------------------------------------------------------------- shapes and refining


@pytest.mark.parametrize("name", SHAPES)
def test_shapes_stand_on_the_floor_and_face_out(name: str) -> None:
    mesh = SHAPES[name]()
    low, high = mesh.bounds
    assert low[1] == pytest.approx(0, abs=1e-12)
    assert 1.9 < (high - low).max() < 4.1
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1, atol=1e-12)
    agreement = np.einsum("ij,ij->i", face_normals(mesh), mesh.normals[mesh.triangles].mean(1))
    assert agreement.min() > 0.7
    if name != "plane":
        assert volume(mesh) > 0.5


def test_the_sphere_is_one() -> None:
    mesh = sphere()
    np.testing.assert_allclose(np.linalg.norm(mesh.positions - [0, 1, 0], axis=1), 1, atol=1e-12)
    assert volume(mesh) == pytest.approx(4 * np.pi / 3, rel=2e-3)
    assert euler(mesh) == 2


def test_the_teapot_has_the_measures_of_the_original() -> None:
    # Newell's teapot in Blinn's height: 6.525 long from handle to spout, 3.15 high, 4 across the body, in its own units.
    low, high = teapot().bounds
    length, height, depth = high - low
    assert height / length == pytest.approx(3.15 / 6.43, rel=0.01)
    assert depth / length == pytest.approx(4.0 / 6.43, rel=0.01)
    uv = teapot().uv
    assert uv.min() > 0
    assert uv.max() < 1


def test_each_texel_of_the_teapot_belongs_to_one_patch() -> None:
    cells = np.floor(teapot(4).uv * 6).astype(int)
    patch = np.repeat(np.arange(32), 25)
    assert all(len(np.unique(cells[patch == k], axis=0)) == 1 for k in range(32))


def test_refining_keeps_the_shape() -> None:
    mesh = refine(plane(4).with_attribute("height", plane(4).positions[:, 0] * 2), 2)
    assert len(mesh.triangles) == 32 * 16
    np.testing.assert_allclose(mesh.attributes["height"], mesh.positions[:, 0] * 2, atol=1e-15)
    np.testing.assert_allclose(mesh.positions[:, 1], 0)
    np.testing.assert_allclose(mesh.uv[:, 0] * 4 - 2, mesh.positions[:, 0], atol=1e-12)
    with pytest.raises(MotesError, match="would have"):
        refine(plane(64), 8)


def test_loop_subdivision_has_its_limits() -> None:
    # An octahedron: valence 4 throughout, so beta = 3/(8 4); a vertex moves to (1 - 4 beta) v, its four neighbours cancel.
    corners = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    once = loop(Mesh(corners, np.array(faces, np.int32)))
    np.testing.assert_allclose(once.positions[:6], corners * (1 - 4 * 3 / 32), atol=1e-15)
    # The middle of an edge: 3/8 of both ends, 1/8 of the two opposite corners, which cancel here.
    np.testing.assert_allclose(np.sort(np.abs(once.positions[6:]), axis=1), [[0, 0.375, 0.375]] * 12, atol=1e-15)
    assert euler(once) == 2
    flat = loop(plane(4))
    np.testing.assert_allclose(flat.positions[:, 1], 0)
    assert np.abs(flat.positions[:, [0, 2]]).max() == pytest.approx(2, abs=0.1)


def test_turning_up_is_a_rotation() -> None:
    rng = np.random.default_rng(3)
    for up in (*rng.normal(size=(20, 3)), [0, 1, 0], [0, -1, 0], [0, -1, 1e-9], [0, 0, 1]):
        turn = turn_to_y(up)
        np.testing.assert_allclose(turn @ np.asarray(up) / np.linalg.norm(up), [0, 1, 0], atol=2e-8)
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(turn) == pytest.approx(1)
    with pytest.raises(MotesError, match="not a direction"):
        turn_to_y([0, 0, 0])


WAYS = ("{0}", "{0}/{0}", "{0}/{0}/{0}", "{0}//{0}", "-{0}")


@pytest.mark.parametrize("first", WAYS)
@pytest.mark.parametrize("second", WAYS)
def test_faces_of_obj_may_be_written_in_several_ways(tmp_path: Path, first: str, second: str) -> None:
    """Counted together, corners of three numbers and of one looked like corners of two, and the mesh was another."""
    places = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1], [2, 1, 0]])
    lines = ["v {} {} {}".format(*row) for row in places] + ["vt 0.5 0.5"] * 6 + ["vn 0 0 1"] * 6
    faces = [(1, 2, 3), (4, 5, 6), (2, 3, 4)]
    ways = (first, second, first)
    lines += ["f " + " ".join(way.format(k) for k in face) for way, face in zip(ways, faces, strict=True)]
    (tmp_path / "a.obj").write_text("\n".join(lines))
    found = read_mesh(tmp_path / "a.obj")
    backwards = [np.array(face) if way[0] != "-" else 7 - np.array(face) for way, face in zip(ways, faces, strict=True)]
    np.testing.assert_array_equal(found.positions[found.triangles], places[np.array(backwards) - 1])


def test_an_obj_of_nothing_but_faces_is_counted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Seven bytes a triangle, of three vertices."""
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n" * 20_000
    (tmp_path / "a.obj").write_text(text)
    monkeypatch.setattr("motes.files.budget.LEAST", 2**20)
    with pytest.raises(FormatError, match=r"its 20,004 lines and 60,000 corners would take 6 MiB of memory"):
        read_mesh(tmp_path / "a.obj")
    monkeypatch.setenv("MOTES_LARGEST_MIB", "60")
    assert len(read_mesh(tmp_path / "a.obj").triangles) == 20_000
