"""The three.js material in a browser: what it draws under lights against the BRDF; skipped, by name, without chromium or three."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from motes import Material
from motes.directions import from_spherical
from motes.errors import DataError
from motes.exports import export, three
from motes.exports.subject import subject
from motes.models import BRDF
from shader_support import MODELS, SPECTRAL
from three_support import result

ROOT = Path(__file__).resolve().parents[1]
VIEWS = [(0.0, 0.0), (0.5, 0.3), (1.0, 2.0), (1.4, -1.0)]
LIGHTS = [(0.2, 1.0), (0.8, 0.3 + np.pi), (1.3, 2.1), (1.0, 5.0)]
IMPORTS = "import { createMaterial, setParameter, parameters, albedo } from './material.js';"
SCRIPT = """
  const { views, lights, changes } = job;
  const renderer = new THREE.WebGLRenderer();
  const errors = [];
  renderer.debug.onShaderError = (gl, program, vertex, fragment) => errors.push(gl.getShaderInfoLog(fragment) || gl.getShaderInfoLog(vertex));
  const target = new THREE.WebGLRenderTarget(3, 3, { type: THREE.FloatType });
  const material = createMaterial(THREE, changes);
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material);
  const pixel = new Float32Array(4 * 9);
  const draw = (light, view) => {
    const scene = new THREE.Scene();
    scene.add(mesh, ...light);
    const camera = new THREE.PerspectiveCamera(0.01, 1, 0.1, 100);
    camera.position.set(...view).multiplyScalar(5);
    camera.up.set(0.3, 0.5, 0.81);
    camera.lookAt(0, 0, 0);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, 3, 3, pixel);
    return [...pixel.slice(16, 19)];
  };
  const far = [], near = [], spot = [];
  for (const view of views) for (const direction of lights) {
    const sun = new THREE.DirectionalLight(0xffffff, 2);
    sun.position.set(...direction);
    far.push(draw([sun], view));
    const lamp = new THREE.PointLight(0xffffff, 2, 0, 2);
    lamp.position.set(...direction).multiplyScalar(3);
    near.push(draw([lamp], view));
    const cone = new THREE.SpotLight(0xffffff, 2, 0, 0.2, 0, 2);
    cone.position.set(...direction).multiplyScalar(3);
    spot.push(draw([cone, cone.target], view));
  }
  const ambient = draw([new THREE.AmbientLight(0xffffff, 2)], views[0]);
  const refused = [];
  for (const attempt of [() => setParameter(material, 'K_x', 1), () => setParameter(material, parameters[0].name, -1), () => createMaterial(THREE, { K_x: 1 })])
    try { attempt(); refused.push('nothing'); } catch (error) { refused.push(error.message); }
  setParameter(material, parameters[0].name, 0.25);
  return { far, near, spot, ambient, albedo, refused, errors, first: material.uniforms[parameters[0].uniform].value };
"""


def drawn(text: str, folder: Path, changes: dict[str, object]) -> dict[str, list]:
    """What the page found."""
    (folder / "material.js").write_text(text, encoding="utf-8")
    job = {
        "views": [from_spherical(*view).tolist() for view in VIEWS],
        "lights": [from_spherical(*light).tolist() for light in LIGHTS],
        "changes": changes,
    }
    return result(IMPORTS, SCRIPT, folder, job)


def lit(model: BRDF) -> np.ndarray:
    """BRDF x cosine for the views and lights of the page."""
    wi = from_spherical(*np.transpose(LIGHTS))
    wo = from_spherical(*np.transpose(VIEWS))
    values = model.eval(wi[None], wo[:, None]) * wi[None, :, 2:]
    return np.broadcast_to(values, (len(VIEWS), len(LIGHTS), 3)).reshape(-1, 3)


MOVED = """
  const renderer = new THREE.WebGLRenderer();
  const errors = [];
  renderer.debug.onShaderError = (gl, program, vertex, fragment) => errors.push(gl.getShaderInfoLog(fragment) || gl.getShaderInfoLog(vertex));
  const target = new THREE.WebGLRenderTarget(3, 3, { type: THREE.FloatType });
  renderer.setRenderTarget(target);
  const camera = new THREE.PerspectiveCamera(0.01, 1, 0.1, 100);
  camera.position.set(0, 0, 5);
  const sun = new THREE.DirectionalLight(0xffffff, 2);
  sun.position.set(0.3, 0.5, 0.8);
  const draw = (mesh) => {
    const scene = new THREE.Scene(), pixel = new Float32Array(36);
    scene.add(mesh, sun);
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, 3, 3, pixel);
    return [...pixel.slice(16, 19)];
  };
  const turn = new THREE.Matrix4().makeRotationX(job.angle);
  const plane = () => new THREE.PlaneGeometry(2, 2);
  const material = (options) => createMaterial(THREE, {}, options);
  const turned = new THREE.Mesh(plane(), material());
  turned.applyMatrix4(turn);
  const instances = new THREE.InstancedMesh(plane(), material(), 1);
  instances.setMatrixAt(0, turn);
  const batch = new THREE.BatchedMesh(1, 4, 6, material());
  batch.setMatrixAt(batch.addInstance(batch.addGeometry(plane())), turn);
  const morph = plane();
  morph.morphAttributes.position = [morph.attributes.position.clone().applyMatrix4(turn)];
  morph.morphAttributes.normal = [morph.attributes.normal.clone().applyMatrix4(turn)];
  const morphed = new THREE.Mesh(morph, material());
  morphed.morphTargetInfluences[0] = 1;
  const skin = plane();
  skin.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Array(16).fill(0), 4));
  skin.setAttribute('skinWeight', new THREE.Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], 4));
  const skinned = new THREE.SkinnedMesh(skin, material()), bone = new THREE.Bone();
  skinned.add(bone);
  skinned.bind(new THREE.Skeleton([bone]));
  bone.rotation.x = job.angle;
  const inside = new THREE.Mesh(plane(), material({ side: THREE.BackSide }));
  inside.applyMatrix4(turn.clone().multiply(new THREE.Matrix4().makeRotationY(Math.PI)));
  const meshes = { turned, instances, batch, morphed, skinned, inside };
  const found = Object.fromEntries(Object.entries(meshes).map(([name, mesh]) => [name, draw(mesh)]));
  return { ...found, level: draw(new THREE.Mesh(plane(), material())), errors };
"""


@pytest.mark.slow
def test_what_moves_vertices_moves_their_normals(tmp_path: Path) -> None:
    """Instances, batches, morph targets, bones and the back of a plane, all turned alike, look alike, and as the BRDF says."""
    model = MODELS["dusty"]
    (tmp_path / "material.js").write_text(three.module(subject(model)), encoding="utf-8")
    angle = -0.6
    found = result(IMPORTS, MOVED, tmp_path, {"angle": angle})
    assert not found.pop("errors")
    level = found.pop("level")
    sun = np.array([0.3, 0.5, 0.8]) / np.linalg.norm([0.3, 0.5, 0.8])
    cosine, sine = np.cos(angle), np.sin(angle)
    to_surface = np.array([[1, 0, 0], [0, cosine, sine], [0, -sine, cosine]])  # turned back about x
    wi, wo = to_surface @ sun, to_surface @ np.array([0.0, 0.0, 1.0])
    wanted = 2 * np.ravel(model.eval(wi, wo)) * wi[2]
    assert set(found) == {"turned", "instances", "batch", "morphed", "skinned", "inside"}
    for name, pixel in found.items():
        np.testing.assert_allclose(pixel, wanted, rtol=5e-4, err_msg=name)
    assert np.abs(np.array(level) / wanted - 1).max() > 0.05


@pytest.mark.slow
@pytest.mark.parametrize("name", ["dusty", "grey"])
def test_lights_of_a_scene(name: str, tmp_path: Path) -> None:
    model = MODELS[name]
    changes = {"K_d": (0.9, 0.5, 0.2), "sigma_d": 0.7} if name == "dusty" else {"K_d": 0.3}
    found = drawn(three.module(subject(model)), tmp_path, changes)
    assert not found["errors"]
    wanted = lit(model.with_parameters(changes))
    np.testing.assert_allclose(found["far"], 2 * wanted, rtol=2e-4, atol=2e-5)
    np.testing.assert_allclose(found["near"], 2 / 9 * wanted, rtol=2e-4, atol=2e-5)  # three metres away
    np.testing.assert_allclose(found["spot"], 2 / 9 * wanted, rtol=2e-4, atol=2e-5)
    albedo = np.broadcast_to(model.spherical_albedo(), 3)
    np.testing.assert_allclose(found["ambient"], 2 * albedo / np.pi, rtol=1e-5)
    assert "no parameter K_x" in found["refused"][0]
    assert "K_d = -1 is outside 0 to Infinity" in found["refused"][1]
    assert "no parameter K_x" in found["refused"][2]
    assert found["first"] == ([0.25] * 3 if name == "dusty" else 0.25)


def test_a_name_cannot_leave_its_string(tmp_path: Path) -> None:
    name = "</script><script>alert(1)</script>`${alert(1)}\\` \N{LINE SEPARATOR}"
    text = three.module(subject(Material(MODELS["lambert"], name=name, channels=("R", "G", "B"))))
    assert "</script" not in text
    assert "\N{LINE SEPARATOR}" not in text
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    (tmp_path / "material.mjs").write_text(text, encoding="utf-8")
    (tmp_path / "run.mjs").write_text(
        "import { name, formula, parameters } from './material.mjs';\nprocess.stdout.write(JSON.stringify([name, formula, parameters]));\n"
    )
    done = subprocess.run([node, tmp_path / "run.mjs"], capture_output=True, text=True, timeout=60, check=True)
    said, formula, parameters = json.loads(done.stdout)
    assert said.startswith("< /script><script>alert(1)< /script>`${alert(1)}/`")
    assert "vec3 motes_eval(vec3 wi, vec3 wo)" in formula
    assert parameters[0]["value"] == [0.8, 0.5, 0.2]
    assert parameters[0]["meaning"] == "diffuse reflectance"


def test_channels_that_are_no_colour_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DataError, match=r"7 channels, and a three\.js material holds one or three"):
        export(SPECTRAL, "three", tmp_path / "x.js")
