"""What programs draw of exported files: a sphere each under one sun, beside what the material's formula says of the same pixels.

`tools/artefacts.py` makes a table of it.  The programs run as the tests run them, by the same scripts.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import motes
from motes.exports import export, three
from motes.exports.subject import subject
from motes.meshes.shapes import sphere
from motes.models import BRDF

ROOT = Path(__file__).resolve().parents[1]
TESTS = ROOT / "tests"
sys.path.insert(0, str(TESTS))

from blender_support import interpreters, there, version  # noqa: E402
from three_support import drawn_gltf, library, result  # noqa: E402
from viewer_support import chromium  # noqa: E402

Floats = NDArray[np.float64]
SIDE = 160
#: Where the sun stands; the script of Storm has it, too.
SUN = np.array([0.5, 0.0, 0.8]) / np.linalg.norm([0.5, 0.0, 0.8])
#: Of the sphere's radius, what is compared: not the outermost pixels, nor what the sun only grazes.
INNER, LEAST_COSINE = 0.92, 0.15
PAINT = motes.OrenNayar((0.6, 0.25, 0.1), 0.3) + motes.TorranceSparrow(0.3, 0.15)
DUSTY = motes.DustLayer(PAINT, motes.Dust((0.9, 0.8, 0.6), 0.3), tau=0.2)
MATERIAL = motes.Material(DUSTY, name="paint", channels=("R", "G", "B"))


@dataclass(frozen=True)
class Drawn:
    """A picture of a program, the bottom row first, and what the formula says of each pixel.

    Attributes
    ----------
    key
        The export's name, and which of its files or programs.
    program
        With its version.
    picture, exact
        Radiances (SIDE, SIDE, 3) under a sun of irradiance 1.
    compared
        Which pixels are (SIDE, SIDE).
    """

    key: str
    program: str
    picture: Floats
    exact: Floats
    compared: NDArray[np.bool_]

    def errors(self) -> tuple[float, float, float]:
        """Relative to the exact values: the median, what nine in ten are within, and the energy."""
        found, wanted = self.picture[self.compared], self.exact[self.compared]
        off = np.abs(found / wanted - 1)
        return float(np.median(off)), float(np.quantile(off, 0.9)), float(found.sum() / wanted.sum())


def from_above() -> tuple[Floats, Floats]:
    """Normals (SIDE, SIDE, 3) of the unit sphere and the way to the viewer, for a camera without perspective."""
    x, y = np.meshgrid(*2 * [(2 * np.arange(SIDE) + 1) / SIDE - 1])
    normal = np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], axis=-1)
    normal[x**2 + y**2 > 1] = 0
    return normal, np.broadcast_to([0.0, 0.0, 1.0], normal.shape)


def drawn(
    key: str,
    program: str,
    picture: Any,
    model: BRDF = DUSTY,
    sun: Floats = SUN,
    seen: tuple[Floats, Floats] | None = None,
) -> Drawn:
    """A picture beside the exact one."""
    normal, viewer = from_above() if seen is None else seen
    facing = np.sum(normal * viewer, axis=-1)
    there = facing > 0
    across = np.cross(normal[there], [0.3, 0.9, 0.1])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    frame = np.stack([across, np.cross(normal[there], across), normal[there]], axis=1)
    wi, wo = frame @ sun, np.einsum("nij,nj->ni", frame, viewer[there])
    exact = np.zeros((SIDE, SIDE, 3))
    exact[there] = model.eval(wi, wo) * np.maximum(wi[:, 2:], 0)
    compared = there & (facing > np.sqrt(1 - INNER**2)) & (normal @ sun > LEAST_COSINE)
    return Drawn(key, program, np.where(there[..., None], np.asarray(picture, np.float64), 0.0), exact, compared)


def ran(*command: object, **more: Any) -> str:
    """What a program printed; an error with its last words where it fails."""
    done = subprocess.run(
        [str(part) for part in command], capture_output=True, text=True, timeout=550, check=False, **more
    )
    if done.returncode:
        raise RuntimeError(f"{command[0]}: {done.stdout[-1500:]}{done.stderr[-1500:]}")
    return done.stdout


def blenders() -> list[tuple[str, str]]:
    """Interpreters with bpy, each with its version in words."""
    return [(python, ".".join(map(str, version(python)))) for python in interpreters() if there(python)]


# ---------------------------------------------------------------- browsers

_SPHERE = """
const large = new THREE[renderer.isWebGLRenderer ? 'WebGLRenderTarget' : 'RenderTarget'](job.side, job.side, { type: THREE.FloatType });
const sun = new THREE.DirectionalLight(0xffffff, 1), camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 100);
sun.position.set(...job.sun);
camera.position.set(0, 0, 5);
const scene = new THREE.Scene().add(sun, new THREE.Mesh(new THREE.SphereGeometry(1, 256, 128), createMaterial(THREE)));
renderer.setRenderTarget(large);
renderer.render(scene, camera);
const all = new Float32Array(4 * job.side * job.side);
const found = await renderer.readRenderTargetPixelsAsync(large, 0, 0, job.side, job.side, ...(renderer.isWebGLRenderer ? [all] : []));
return { errors, revision: THREE.REVISION, pixels: [...found].map((x) => +x.toPrecision(7)) };
"""


def browser() -> str:
    """Which browser draws."""
    said = ran(chromium(), "--version").split()
    return f"Chromium {next(word for word in said if word[0].isdigit()).split('.')[0]}"


def by_three(folder: Path) -> Iterator[Drawn]:
    """The module, by both renderers and what one falls back to."""
    for k, renderer in enumerate(("WebGLRenderer", "WebGPURenderer", "WebGPURenderer on WebGL 2")):
        place = folder / str(k)
        place.mkdir()
        (place / "paint.js").write_text(three.module(subject(MATERIAL)), encoding="utf-8")
        job = {"side": SIDE, "sun": SUN.tolist()}
        told = result("import { createMaterial } from './paint.js';", _SPHERE, place, job, renderer)
        picture = np.array(told["pixels"]).reshape(SIDE, SIDE, 4)[..., :3]
        words = {"WebGLRenderer": "WebGL 2", "WebGPURenderer": "WebGPU"}.get(renderer, "WebGPURenderer without WebGPU")
        yield drawn(f"three: {words}", f"three.js 0.{told['revision']} in {browser()}", picture)


def by_gltf(folder: Path) -> Iterator[Drawn]:
    """The fitted material of glTF, whose sphere three.js loads; its picture is made larger, since pixels' curvature adds roughness there."""
    file, step = export(MATERIAL, "gltf", folder / "paint.gltf").files[0], 5
    told = drawn_gltf(file, folder, ("OrthographicCamera", [-1, 1, 1, -1, 0.1, 100]), side=SIDE * step, step=step)
    picture = np.array(told["pixels"]).reshape(SIDE, SIDE, 3) / 2
    made = (library() / "package.json").read_text(encoding="utf-8").partition('"version": "')[2].partition('"')[0]
    yield drawn("gltf", f"three.js {made}'s GLTFLoader in {browser()}", picture, sun=np.array([0.6, 0.0, 0.8]))


# ---------------------------------------------------------------- MaterialX


def by_materialx(to: str, names: dict[str, str]) -> Callable[[Path], Iterator[Drawn]]:
    """A document, in MaterialX's renderer: its materials by name, each with what it is called here."""

    def draw(folder: Path) -> Iterator[Drawn]:
        import MaterialX

        file, ball = export(MATERIAL, to, folder / "paint.mtlx").files[0], folder / "ball.obj"
        mesh = sphere(128)
        assert mesh.normals is not None
        assert mesh.uv is not None
        lines = [f"{word} {a} {b} {c}" for word in ("v", "vn") for a, b, c in mesh.normals]  # about the origin
        lines += [f"vt {u} {v}" for u, v in mesh.uv]
        lines += ["f " + " ".join(f"{k + 1}/{k + 1}/{k + 1}" for k in corners) for corners in mesh.triangles]
        ball.write_text("\n".join(lines) + "\n")
        for name, words in names.items():
            told = ",".join(map(str, SUN))
            command = [
                "xvfb-run",
                "-a",
                sys.executable,
                TESTS / "materialx_render.py",
                file,
                name,
                folder / "r.npz",
                told,
            ]
            ran(*command, ball, SIDE)
            found = np.load(folder / "r.npz")
            x = 3 / found["scale"] * ((2 * np.arange(SIDE) + 1) / SIDE - 1)
            ray = np.stack([*np.meshgrid(x, x), np.full((SIDE, SIDE), 0.0)], axis=-1) - found["eye"]
            ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
            b, c = ray @ found["eye"], found["eye"] @ found["eye"] - 1
            normal = found["eye"] - (b + np.sqrt(np.maximum(b * b - c, 0)))[..., None] * ray
            normal[b * b < c] = 0
            yield drawn(
                f"{to}{words}",
                f"MaterialX {MaterialX.getVersionString()}'s renderer",
                found["colors"] / 2,
                seen=(normal, -ray),
            )

    return draw


# ---------------------------------------------------------------- Blender, USD


def by_cycles(to: str, name: str) -> Callable[[Path], Iterator[Drawn]]:
    """An OSL shader, or the script that makes a fitted material, in each Blender."""

    def draw(folder: Path) -> Iterator[Drawn]:
        file = export(MATERIAL, to, folder / name).files[0]
        for python, words in blenders():
            command = [python, ROOT / "tools" / "artefact_in_blender.py", file, "paint", folder / "r.npz", SIDE]
            ran(*command, ",".join(map(str, SUN)))
            yield drawn(f"{to}: Blender {words[:3]}", f"Blender {words}, Cycles", np.load(folder / "r.npz")["colors"])

    return draw


def by_extension(folder: Path) -> Iterator[Drawn]:
    """Blender's extension: Sahara dust over a diffuse paint, by plain nodes and by OSL."""
    from blender_build import build

    extension, base = build(folder), motes.Lambert((0.6, 0.3, 0.1))
    dust = motes.models.dust_optics.DUSTS["sahara"].dust()
    for python, words in blenders():
        user = {**os.environ, "BLENDER_USER_RESOURCES": str(folder / words)}
        ran(python, TESTS / "blender_dust.py", extension, folder / "r.npz", SIDE, env=user)
        found = np.load(folder / "r.npz")
        model = motes.DustLayer(base, dust, 0.5, scattering="multiple")
        yield drawn(f"extension: Blender {words[:3]}", f"Blender {words}, Cycles", found["diffuse_NODES"], model)


def by_usd(folder: Path) -> Iterator[Drawn]:
    """OpenPBR in a stage: Storm by MaterialX and by the preview, and what Blender imports."""
    import moderngl

    file = export(MATERIAL, "openpbr", folder / "paint.usda").files[0]
    environment = {**os.environ, "EGL_PLATFORM": "surfaceless"}
    for python, words in blenders():
        look = (
            "import bpy, pathlib, sys; home = pathlib.Path(bpy.utils.resource_path('LOCAL'));"
            "sys.path.append(str(next(home.glob('python/lib/python3*/site-packages'))));"
            "from pxr import Usd; print('USD', *Usd.GetVersion())"
        )
        usd = next(line.split() for line in ran(python, "-c", look).splitlines() if line.startswith("USD "))
        storm = f"Storm of USD {usd[2]}.{usd[3]}"
        packages = Path(moderngl.__file__).parents[1]
        paths = ("/paint_materials/Looks/paint", "/paint_materials/paint_sphere")
        ran(python, TESTS / "usd_in_programs.py", file, folder / "r.npz", SIDE, packages, *paths, env=environment)
        found = np.load(folder / "r.npz")
        yield drawn(f"openpbr as USD: {storm}", storm, found["storm_mtlx"][..., :3])
        yield drawn(f"openpbr as USD: preview, {storm}", storm, found["storm_preview"][..., :3])
        yield drawn(f"openpbr as USD: Blender {words[:3]}", f"Blender {words}, Cycles", found["cycles"][..., :3])


# ---------------------------------------------------------------- Mitsuba

_SCENE = """<scene version="3.0.0">
  <include filename="{file}"/>
  <integrator type="direct"/>
  <sensor type="orthographic"><transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
    <film type="hdrfilm"><integer name="width" value="{side}"/><integer name="height" value="{side}"/><rfilter type="box"/></film>
    <sampler type="stratified"><integer name="sample_count" value="64"/></sampler></sensor>
  <emitter type="directional"><vector name="direction" x="{x}" y="{y}" z="{z}"/><rgb name="irradiance" value="1"/></emitter>
  <shape type="sphere"><ref id="{name}"/></shape>
</scene>"""
_TABLE = (
    '<scene version="3.0.0"><bsdf type="measured" id="paint"><string name="filename" value="{file}"/></bsdf></scene>'
)


def by_mitsuba(folder: Path) -> Iterator[Drawn]:
    """The exact plugin, the stock ones, and a table that Mitsuba's `measured` reads."""
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    file = export(MATERIAL, "mitsuba", folder / "paint.xml").files[0]
    table = folder / "table.xml"
    table.write_text(_TABLE.format(file=export(MATERIAL, "rgl", folder / "paint.bsdf").files[0]))
    for key, source, name in (
        ("mitsuba", file, "paint"),
        ("mitsuba: stock", file, "paint_stock"),
        ("rgl", table, "paint"),
    ):
        x, y, z = -SUN
        (folder / "scene.xml").write_text(_SCENE.format(file=source.name, name=name, side=SIDE, x=x, y=y, z=z))
        scene = mi.load_file(str(folder / "scene.xml"))
        picture = np.array(mi.render(scene))[::-1, :, :3]
        yield drawn(key, f"Mitsuba {mi.__version__}, {mi.variant()}", picture)


PROGRAMS: dict[str, Callable[[Path], Iterator[Drawn]]] = {
    "three": by_three,
    "materialx": by_materialx("materialx", {"paint": "", "paint_lobes": ": lobes"}),
    "mitsuba": by_mitsuba,
    "osl": by_cycles("osl", "paint.osl"),
    "blender": by_cycles("blender", "paint.py"),
    "extension": by_extension,
    "openpbr": by_materialx("openpbr", {"paint": ""}),
    "standard_surface": by_materialx("standard_surface", {"paint": ""}),
    "usd": by_usd,
    "gltf": by_gltf,
}
