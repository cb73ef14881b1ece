"""The three.js material in a browser: what it draws under lights against the BRDF; skipped, by name, without chromium or three."""

from __future__ import annotations

import json
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

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
#: The renderer and the material of each page: both renderers, and what one of them falls back to, see colours and grey between them.
PAGES = [
    ("WebGLRenderer", "dusty"),
    ("WebGLRenderer", "grey"),
    ("WebGPURenderer", "dusty"),
    ("WebGPURenderer on WebGL 2", "grey"),
]
CHANGES = {"dusty": {"K_d": (0.9, 0.5, 0.2), "sigma_d": 0.7}, "grey": {"K_d": 0.3}}
ANGLE = -0.6  # of what is turned about x, under a sun
SUN = np.array([0.3, 0.5, 0.8]) / np.linalg.norm([0.3, 0.5, 0.8])
SCRIPT = """
  const { views, lights, changes, angle } = job;
  const plane = () => new THREE.PlaneGeometry(2, 2);
  const camera = new THREE.PerspectiveCamera(0.01, 1, 0.1, 100);
  camera.up.set(0.3, 0.5, 0.81);
  const from = (view) => {
    camera.position.set(...view).multiplyScalar(5);
    camera.lookAt(0, 0, 0);
    return camera;
  };
  const scenes = new Map();  // new ones would have their programs made anew
  const lit = async (mesh, light, view) => {
    const scene = scenes.get(light) ?? new THREE.Scene().add(light, ...(light.target ? [light.target] : []));
    scenes.set(light, scene.add(mesh));
    const found = await drawn(scene, from(view));
    scene.remove(mesh);
    return found;
  };
  const material = createMaterial(THREE, changes);
  const flat = new THREE.Mesh(plane(), material);
  const white = (kind, ...more) => new THREE[kind](0xffffff, 2, ...more);
  const sun = white('DirectionalLight'), lamp = white('PointLight', 0, 2), cone = white('SpotLight', 0, 0.2, 0, 2);
  const far = [], near = [], spot = [];
  for (const view of views) for (const direction of lights) {
    sun.position.set(...direction);
    far.push(await lit(flat, sun, view));
    lamp.position.set(...direction).multiplyScalar(3);
    near.push(await lit(flat, lamp, view));
    cone.position.set(...direction).multiplyScalar(3);
    spot.push(await lit(flat, cone, view));
  }
  const ambient = await lit(flat, new THREE.AmbientLight(0xffffff, 2), views[0]);
  const above = new THREE.HemisphereLight(0xffffff, 0, 2);
  above.position.set(0, 0, 1);
  const sky = await lit(flat, above, views[0]);
  const refused = [];
  for (const attempt of [() => setParameter(material, 'K_x', 1), () => setParameter(material, parameters[0].name, -1), () => createMaterial(THREE, { K_x: 1 })])
    try { attempt(); refused.push('nothing'); } catch (error) { refused.push(error.message); }
  // A clone goes its own way, and what is changed later is seen.
  const other = material.clone();
  setParameter(material, parameters[0].name, 0);
  setParameter(other, parameters[0].name, 0.25);
  sun.position.set(...lights[0]);
  const changed = await lit(flat, sun, views[0]);
  const cloned = await lit(new THREE.Mesh(plane(), other), sun, views[0]);

  sun.position.set(...job.sun);
  const facing = [0, 0, 1], turn = new THREE.Matrix4().makeRotationX(angle);
  const asExported = (options) => createMaterial(THREE, {}, options);
  const turned = new THREE.Mesh(plane(), asExported());
  turned.applyMatrix4(turn);
  const instances = new THREE.InstancedMesh(plane(), asExported(), 1);
  instances.setMatrixAt(0, turn);
  const batch = new THREE.BatchedMesh(1, 4, 6, asExported());
  batch.setMatrixAt(batch.addInstance(batch.addGeometry(plane())), turn);
  const morph = plane();
  morph.morphAttributes.position = [morph.attributes.position.clone().applyMatrix4(turn)];
  morph.morphAttributes.normal = [morph.attributes.normal.clone().applyMatrix4(turn)];
  const morphed = new THREE.Mesh(morph, asExported());
  morphed.morphTargetInfluences[0] = 1;
  const skin = plane();
  skin.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Array(16).fill(0), 4));
  skin.setAttribute('skinWeight', new THREE.Float32BufferAttribute([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], 4));
  const skinned = new THREE.SkinnedMesh(skin, asExported()), bone = new THREE.Bone();
  skinned.add(bone);
  skinned.bind(new THREE.Skeleton([bone]));
  bone.rotation.x = angle;
  const inside = new THREE.Mesh(plane(), asExported({ side: THREE.BackSide }));
  inside.applyMatrix4(turn.clone().multiply(new THREE.Matrix4().makeRotationY(Math.PI)));
  const meshes = { turned, instances, batch, morphed, skinned, inside }, moved = {};
  for (const [key, mesh] of Object.entries(meshes)) moved[key] = await lit(mesh, sun, facing);
  const level = await lit(new THREE.Mesh(plane(), asExported()), sun, facing);
  const found = { far, near, spot, ambient, sky, refused, changed, cloned, moved, level };
  if (renderer.isWebGLRenderer) return { ...found, errors };

  // Of node materials alone: an environment, shadows, and a parameter that the mesh knows.
  const scene = new THREE.Scene().add(new THREE.Mesh(plane(), asExported()));
  scene.environmentNode = THREE.TSL.vec3(1, 1, 1);  // a picture would be filtered for 15 seconds without a GPU
  const environment = await drawn(scene, from(views[1]));
  const varied = plane();
  varied.setAttribute('known', new THREE.Float32BufferAttribute([0.7, 0.7, 0.7, 0.7], 1));
  const knowing = new THREE.Mesh(varied, asExported());
  await lit(knowing, sun, facing);
  setParameter(knowing.material, 'sigma_d', THREE.TSL.attribute('known', 'float'));
  const attribute = await lit(knowing, sun, facing);
  renderer.shadowMap.enabled = true;
  const ground = new THREE.Mesh(plane(), asExported()), lid = new THREE.Mesh(plane(), asExported({ side: THREE.DoubleSide }));
  ground.receiveShadow = lid.castShadow = true;
  lid.position.set(...job.sun);
  lid.scale.setScalar(0.1);
  sun.castShadow = true;
  sun.position.multiplyScalar(3);
  const shaded = await lit(new THREE.Group().add(ground, lid), sun, facing);
  return { ...found, environment, attribute, shaded, errors };
"""


@dataclass(frozen=True)
class Page:
    """A material and what a renderer drew of it."""

    renderer: str
    model: BRDF
    changes: dict[str, object]
    found: dict[str, Any]


@pytest.fixture(scope="module", params=PAGES, ids=[" ".join(page) for page in PAGES])
def page(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Page:
    """What a page draws of a material, all in one visit of the browser."""
    renderer, name = request.param
    model, changes, folder = MODELS[name], CHANGES[name], tmp_path_factory.mktemp("page")
    (folder / "material.js").write_text(three.module(subject(model)), encoding="utf-8")
    job = {
        "views": [from_spherical(*view).tolist() for view in VIEWS],
        "lights": [from_spherical(*light).tolist() for light in LIGHTS],
        "changes": changes,
        "angle": ANGLE,
        "sun": SUN.tolist(),
    }
    found = result(IMPORTS, SCRIPT, folder, job, renderer)
    assert not found["errors"], found["errors"]
    return Page(renderer, model, changes, found)


def lit(model: BRDF) -> np.ndarray:
    """BRDF x cosine for the views and lights of the page."""
    wi = from_spherical(*np.transpose(LIGHTS))
    wo = from_spherical(*np.transpose(VIEWS))
    values = model.eval(wi[None], wo[:, None]) * wi[None, :, 2:]
    return np.broadcast_to(values, (len(VIEWS), len(LIGHTS), 3)).reshape(-1, 3)


def at_sun(model: BRDF, angle: float) -> np.ndarray:
    """What the viewer on the axis z sees of a plane that is turned about x, under the sun."""
    cosine, sine = np.cos(angle), np.sin(angle)
    to_surface = np.array([[1, 0, 0], [0, cosine, sine], [0, -sine, cosine]])  # turned back about x
    wi, wo = to_surface @ SUN, to_surface @ np.array([0.0, 0.0, 1.0])
    return np.broadcast_to(2 * np.ravel(model.eval(wi, wo)) * wi[2], 3)


@pytest.mark.slow
def test_lights_of_a_scene(page: Page) -> None:
    found, wanted = page.found, lit(page.model.with_parameters(page.changes))
    np.testing.assert_allclose(found["far"], 2 * wanted, rtol=2e-4, atol=2e-5)
    np.testing.assert_allclose(found["near"], 2 / 9 * wanted, rtol=2e-4, atol=2e-5)  # three metres away
    np.testing.assert_allclose(found["spot"], 2 / 9 * wanted, rtol=2e-4, atol=2e-5)
    albedo = np.broadcast_to(page.model.spherical_albedo(), 3)
    np.testing.assert_allclose(found["ambient"], 2 * albedo / np.pi, rtol=1e-5)
    np.testing.assert_allclose(found["sky"], 2 * albedo / np.pi, rtol=1e-5)


@pytest.mark.slow
def test_parameters_change(page: Page) -> None:
    """Also after the first picture, and a clone's apart from its original's; what is out of range, or unknown, is refused."""
    for what, K_d in (("changed", 0.0), ("cloned", 0.25)):
        model = page.model.with_parameters({**page.changes, "K_d": (K_d,) * 3 if page.model.channels == 3 else K_d})
        np.testing.assert_allclose(page.found[what], 2 * lit(model)[0], rtol=2e-4, atol=2e-5, err_msg=what)
    refused = page.found["refused"]
    assert "no parameter K_x" in refused[0]
    assert "K_d = -1 is outside 0 to Infinity" in refused[1]
    assert "no parameter K_x" in refused[2]


@pytest.mark.slow
def test_what_moves_vertices_moves_their_normals(page: Page) -> None:
    """Instances, batches, morph targets, bones and the back of a plane, all turned alike, look alike, and as the BRDF says."""
    moved, wanted = page.found["moved"], at_sun(page.model, ANGLE)
    assert set(moved) == {"turned", "instances", "batch", "morphed", "skinned", "inside"}
    for name, pixel in moved.items():
        np.testing.assert_allclose(pixel, wanted, rtol=5e-4, err_msg=name)
    assert np.abs(np.array(page.found["level"]) / wanted - 1).max() > 0.05


@pytest.mark.slow
def test_what_node_materials_have_besides(page: Page) -> None:
    """The light of an environment, shadows, and parameters that are nodes."""
    found, model = page.found, page.model
    if page.renderer == "WebGLRenderer":
        assert not {"environment", "attribute", "shaded"} & set(found)
        return
    np.testing.assert_allclose(found["environment"], np.broadcast_to(model.spherical_albedo(), 3), rtol=1e-5)
    np.testing.assert_allclose(found["attribute"], at_sun(model.with_parameters({"sigma_d": 0.7}), 0.0), rtol=5e-4)
    assert found["shaded"] == [0, 0, 0]
    assert min(found["level"]) > 0.1


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
