"""The viewer's readers of meshes, run under Node: what programs write, hostile files, and thousands of damaged ones."""

from __future__ import annotations

import base64
import json
import struct
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from test_meshes_files import BOX, HABITS, PLAIN, TRIANGLE, mutated
from viewer_support import SOURCES, node

SCRIPT = """
import { readFileSync } from 'node:fs';
import { build } from 'esbuild';
globalThis.fetch = () => { throw new Error('the network was asked'); };
globalThis.self ??= globalThis;
const made = await build({ entryPoints: ['src/meshfiles.ts'], bundle: true, format: 'esm', write: false, platform: 'node' });
const { readMesh } = await import('data:text/javascript;base64,' + Buffer.from(made.outputFiles[0].text).toString('base64'));
const told = [];
let slowest = 0;
console.log = console.error = console.warn = () => {};
for (const [name, content, short] of JSON.parse(readFileSync(process.argv[1], 'utf8'))) {
  const data = Uint8Array.from(Buffer.from(content, 'base64')).buffer;
  const start = performance.now();
  try {
    const mesh = await readMesh(name, data);
    const whole = () => [mesh.positions, mesh.indices, mesh.normals ?? []].map((each) => Array.from(each));
    told.push(short ? [mesh.positions.length, mesh.indices.length] : whole());
  } catch (error) {
    told.push(error.name === 'Problem' ? error.message : 'UNEXPECTED ' + error.stack);
  }
  slowest = Math.max(slowest, performance.now() - start);
}
process.stdout.write(JSON.stringify({ told, slowest }));
"""

Reader = Callable[..., list[Any]]


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> Reader:
    """Name and content of files -> (positions, indices, normals), or the sentence."""
    run_node = node()

    def read(files: list[tuple[str, bytes]], short: bool = False) -> list[Any]:
        manifest = tmp_path_factory.mktemp("meshes") / "files.json"
        manifest.write_text(json.dumps([(name, base64.b64encode(data).decode(), short) for name, data in files]))
        done = subprocess.run(
            [run_node, "--max-old-space-size=1024", "--input-type=module", "-e", SCRIPT, str(manifest)],
            cwd=SOURCES,
            capture_output=True,
            text=True,
            timeout=300,
        )
        assert done.returncode == 0, done.stderr[-2000:]
        answer = json.loads(done.stdout)
        assert answer["slowest"] < 5000
        return list(answer["told"])

    return read


def volume(told: Any) -> float:
    positions, indices = np.reshape(told[0], (-1, 3)), np.reshape(told[1], (-1, 3)).astype(int)
    a, b, c = (positions[indices[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def test_habits_of_programs_that_write_obj(read: Reader) -> None:
    texts = {f"{name}{ending!r}": ending.join(lines) for name, lines in HABITS.items() for ending in ("\n", "\r\n")}
    marked = [("\ufeff" + "\n".join(BOX)).encode(), ("\ufeff" + "\r\n".join(["v 9 9 9", *BOX])).encode()]
    told = read([*(("a.obj", text.encode()) for text in texts.values()), ("a.obj", marked[0])])
    for name, answer in zip([*texts, "mark"], told, strict=True):
        assert not isinstance(answer, str), (name, answer)
        assert abs(volume(answer)) == pytest.approx(8), name


def glb(binary: bytes = TRIANGLE, **changes: Any) -> bytes:
    text = json.dumps(PLAIN | changes).encode()
    text += b" " * (-len(text) % 4)
    body = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def test_scenes_are_put_together(read: Reader) -> None:
    nodes = [{"children": [1, 2]}, {"mesh": 0, "translation": [5, 0, 0]}, {"mesh": 0, "scale": [-2, 1, 1]}]
    short = np.int16([[0, 0, 0, 9], [32767, 0, 0, 9], [0, 32767, 0, 9]]).tobytes()
    quantized = {
        "extensionsUsed": ["KHR_mesh_quantization"],
        "extensionsRequired": ["KHR_mesh_quantization"],
        "accessors": [{"bufferView": 0, "componentType": 5122, "normalized": True, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 24, "byteStride": 8}],
        "buffers": [{"byteLength": 24}],
    }
    looked_up = {
        "images": [{"uri": "https://example.org/a.png"}],
        "textures": [{"source": 0}],
        "skins": [{"joints": [7]}],
    }
    painted = [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 9}, "material": 3, "targets": [{}]}]}]
    moved, small, plain = read(
        [("a.glb", glb(nodes=nodes)), ("b.glb", glb(short, **quantized)), ("c.glb", glb(meshes=painted, **looked_up))]
    )
    assert not isinstance(moved, str), moved
    np.testing.assert_allclose(
        np.reshape(moved[0], (-1, 3)), [[5, 0, 0], [6, 0, 0], [5, 1, 0], [0, 0, 0], [-2, 0, 0], [0, 1, 0]]
    )
    assert moved[1] == [0, 1, 2, 3, 5, 4]  # what is mirrored looks to the same side
    np.testing.assert_allclose(np.reshape(small[0], (-1, 3)), [[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    assert plain[:2] == [[0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]]


def changed(key: str, **values: Any) -> dict[str, Any]:
    return {key: [PLAIN[key][0] | values]}


HOSTILE: list[tuple[dict[str, Any], str]] = [
    ({"nodes": [{"mesh": 0, "children": [0]}]}, "own ancestors"),
    ({"nodes": [{"mesh": 0, "children": [1]}, {"children": [0]}]}, "own ancestors"),
    ({"nodes": [{"children": [2]}, {"children": [2]}, {"mesh": 0}]}, "nodes that lead nowhere"),
    ({"nodes": [{"children": [9]}]}, "nodes that lead nowhere"),
    (changed("bufferViews", byteStride=-12), "byteStride = -12 is no size"),
    (changed("bufferViews", byteStride=4), "accessors that lead nowhere"),
    (changed("bufferViews", byteLength=2**40), "bufferViews that lead nowhere"),
    (changed("accessors", count=2**40), "accessors that lead nowhere"),
    (changed("accessors", count=1e300), "is no size"),
    (changed("accessors", byteOffset=-4), "is no size"),
    (changed("accessors", sparse={"count": 1}), "in a way that is not supported"),
    (changed("buffers", byteLength=2**40), "claims"),
    (changed("buffers", uri="https://example.org/a.bin"), "in other files"),
    ({"meshes": [{"primitives": [{"attributes": {"POSITION": 7}}]}]}, "meshes that lead nowhere"),
    ({"nodes": [{"mesh": 0}] * 3, "scenes": [{"nodes": [5]}]}, "scenes that lead nowhere"),
    ({"nodes": 5}, "nodes that lead nowhere"),
    ({"extensionsRequired": ["KHR_draco_mesh_compression"]}, "is compressed, or needs KHR_draco"),
]


def test_hostile_files_end_in_a_sentence(read: Reader) -> None:
    wide = "ply\nformat ascii 1.0\nelement vertex 1000000000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n"
    lists = wide.replace("1000000000000", "1").replace(
        "end_header", "element face 1e9\nproperty list uchar int vertex_indices\nend_header"
    )
    files = [("a.glb", glb(**changes)) for changes, _ in HOSTILE]
    told = read([*files, ("a.ply", wide.encode()), ("a.ply", lists.encode()), ("a.glb", glb()[:60])])
    words = [
        *(sentence for _, sentence in HOSTILE),
        "claims 1000000000000 of vertex",
        "claims 1e9 of face",
        "cut short",
    ]
    for answer, expected in zip(told, words, strict=True):
        assert isinstance(answer, str), (answer, expected)
        assert expected in answer


PLY_TEXT = (
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face {faces}\n"
    "property uchar red\nproperty list uchar {type} vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{rows}\n"
)


def test_faces_of_ply_name_whole_vertices(read: Reader) -> None:
    """three's loader cuts fractions off: 0.2 and 1.7 would be the vertices 0 and 1."""
    rows = ["9 3 0.2 1.7 2", "9 3.0 0 1 2", "9 3 0 1e0 2", "9 3 0 x 2", "9 4 0 1 2.5 3", "9 3 0 1"]
    files = [("a.ply", PLY_TEXT.format(faces=2, type="int", rows=f"9 3 0 1 2\n{row}").encode()) for row in rows]
    files += [("a.ply", PLY_TEXT.format(faces=1, type=kind, rows="9 3 0 1 2").encode()) for kind in ("float", "double")]
    good = PLY_TEXT.format(faces=2, type="int", rows="9 3 0 1 2\n\n9  4 +0 1 2 3").encode()
    *refused, read_well = read([*files, ("a.ply", good)])
    for answer in refused[:5]:
        assert "whose vertices are not whole numbers" in answer
    assert "breaks off within the face" in refused[5]
    for answer in refused[6:]:
        assert "has faces whose vertices are fractions" in answer
    assert read_well[1] == [0, 1, 2, 0, 1, 2, 0, 2, 3]


def test_thousands_of_damaged_files_give_triangles_or_a_sentence(read: Reader) -> None:
    rng = np.random.default_rng(9)
    ply = (
        b"ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        b"property list uchar int vertex_indices\nend_header\n" + np.float32(np.eye(4, 3)).tobytes() + struct.pack("<B4i", 4, 0, 1, 2, 3)
    )  # fmt: skip
    text = b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    text += b"property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    good = [("a.obj", "\n".join(HABITS["negative"]).encode()), ("a.ply", ply), ("b.ply", text)]
    good += [("a.glb", glb()), ("b.glb", glb(nodes=[{"children": [1]}, {"mesh": 0, "scale": [1, 2, 3]}]))]
    files = [(name, mutated(data, rng)) for name, data in good for _ in range(800)]
    told = read(files, short=True)
    strange = [
        (files[k][1][:400], answer)
        for k, answer in enumerate(told)
        if isinstance(answer, str) and "UNEXPECTED" in answer
    ]
    assert not strange, strange[:3]
    for name, _ in good:
        assert sum(isinstance(t, list) for t, f in zip(told, files, strict=True) if f[0] == name) > 20
        assert sum(isinstance(t, str) for t, f in zip(told, files, strict=True) if f[0] == name) > 20


def test_the_pages_scripts_stay_small(tmp_path: Path) -> None:
    static = Path(__file__).parents[1] / "src" / "motes" / "viewer" / "static"
    assert sum(file.stat().st_size for file in static.iterdir()) < 1.5e6
