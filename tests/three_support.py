"""Pages with three.js in a headless browser, on its software renderer; skipped, by name, without chromium or three."""

from __future__ import annotations

import base64
import html
import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest

from viewer_support import ROOT, chromium

# The browser prints a page once it is loaded, which it is when the document in its frame is closed: GPUs answer in their own time.
_PAGE = """<!doctype html><meta charset="utf-8"><title>test</title><pre id="result">nothing</pre><iframe id="open" hidden></iframe>
<script>
const open = document.getElementById('open').contentDocument, out = document.getElementById('result');
open.open();
onerror = (told) => { out.textContent = JSON.stringify({ error: told }); open.close(); };  // of what cannot be read at all
</script>
<script id="job" type="application/json">JOB</script>
<script type="importmap">{"imports": {"three": "./three/build/BUILD.js", "three/addons/": "./three/examples/jsm/"}}</script>
<script type="module">
import * as THREE from 'three';
IMPORTS
const job = JSON.parse(document.getElementById('job').textContent);
try { out.textContent = JSON.stringify(await (async () => { SCRIPT })()); }
catch (error) { out.textContent = JSON.stringify({ error: String(error.stack ?? error) }); }
open.close();
</script>"""

#: By renderer: the build of three.js that it is in, and the lines that make it, with what programs complain of.
RENDERERS = {
    "WebGLRenderer": (
        "three.module",
        """const renderer = new THREE.WebGLRenderer();
renderer.debug.onShaderError = (gl, program, vertex, fragment) => errors.push(gl.getShaderInfoLog(fragment) || gl.getShaderInfoLog(vertex));""",
    ),
    "WebGPURenderer": (
        "three.webgpu",
        """const renderer = new THREE.WebGPURenderer();
await renderer.init();
if (!renderer.backend.isWebGPUBackend) throw new Error('no WebGPU adapter');""",
    ),
    "WebGPURenderer on WebGL 2": (
        "three.webgpu",
        """const renderer = new THREE.WebGPURenderer({ forceWebGL: true });
await renderer.init();
if (!renderer.backend.isWebGLBackend) throw new Error('no WebGL 2');""",
    ),
}
# The pixel in the middle of a picture; rows of 16 float pixels are as long as WebGPU copies them.
_DRAWN = """
const errors = [];
for (const kind of ['error', 'warn']) console[kind] = (...told) => errors.push(told.join(' '));
MAKE
const target = new THREE[renderer.isWebGLRenderer ? 'WebGLRenderTarget' : 'RenderTarget'](16, 3, { type: THREE.FloatType });
const pixels = new Float32Array(4 * 16 * 3);
const drawn = async (scene, camera) => {
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  const found = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 16, 3, ...(renderer.isWebGLRenderer ? [pixels] : []));
  return [...found.slice(96, 99)];
};
"""

_LOADER = "import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';"
# A file under a sun from the side, seen by a camera; every step-th pixel of a square picture, and what the first mesh says.
_GLTF = """
const bytes = Uint8Array.from(atob(job.file), (c) => c.charCodeAt(0)).buffer;
const gltf = await new GLTFLoader().parseAsync(bytes, '');
if (job.at !== null) {
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations[0]).play();
  mixer.setTime(job.at);
}
const scene = new THREE.Scene(), sun = new THREE.DirectionalLight(0xffffff, 2);
sun.position.set(0.6, 0, 0.8);
scene.add(gltf.scene, sun);
const camera = new THREE[job.camera[0]](...job.camera[1]);
camera.position.set(0, 0, 5);
const renderer = new THREE.WebGLRenderer();
const { side, step } = job, target = new THREE.WebGLRenderTarget(side, side, { type: THREE.FloatType });
renderer.setRenderTarget(target);
renderer.render(scene, camera);
const all = new Float32Array(4 * side * side), first = Math.floor(step / 2), pixels = [];
renderer.readRenderTargetPixels(target, 0, 0, side, side, all);
for (let y = first; y < side; y += step) for (let x = first; x < side; x += step) pixels.push([...all.slice(4 * (side * y + x), 4 * (side * y + x) + 3)]);
const mesh = gltf.scene.getObjectByProperty('isMesh', true);
return { pixels, tau: mesh.geometry.attributes._tau?.array[0], specular: mesh.material.specularIntensity };
"""


def library() -> Path:
    """The folder of the package three: ``$MOTES_THREE``, or one that the viewer's build installed."""
    places = [os.environ.get("MOTES_THREE", "")]
    places += [str(p.parents[1]) for p in ROOT.glob("*/node_modules/three/build/three.module.js")]
    places += [str(p.parents[1]) for p in ROOT.glob("src/motes/viewer/**/node_modules/three/build/three.module.js")]
    for place in places:
        if place and (Path(place) / "build" / "three.module.js").exists():
            return Path(place)
    pytest.skip("the npm package three is not installed (set MOTES_THREE to its folder)")


def result(imports: str, script: str, folder: Path, job: dict[str, Any], renderer: str = "") -> dict[str, Any]:
    """What a script returns, the body of a function that knows ``THREE``, what it `imports` and the `job`; the page is in `folder`.

    With the name of one of `RENDERERS` it knows ``renderer``, ``drawn(scene, camera)`` and ``errors``, what was complained of, too.
    """
    (folder / "three").symlink_to(library())
    page = folder / "page.html"
    build, make = RENDERERS[renderer or "WebGLRenderer"]
    script = (_DRAWN.replace("MAKE", make) if renderer else "") + script
    text = _PAGE.replace("IMPORTS", imports).replace("SCRIPT", script).replace("JOB", json.dumps(job))
    text = text.replace("BUILD", build)
    page.write_text(text, encoding="utf-8")
    command = [
        chromium(),
        "--headless",
        "--no-sandbox",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        *(["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"] if renderer == "WebGPURenderer" else []),
        "--allow-file-access-from-files",
        f"--user-data-dir={folder / 'profile'}",
        "--timeout=100000",
        "--dump-dom",
        page.as_uri(),
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    match = re.search(r'<pre id="result">(.*?)</pre>', done.stdout, re.DOTALL)
    assert match, done.stderr[-2000:]
    found: dict[str, Any] = json.loads(html.unescape(match[1]))
    assert "error" not in found, found
    return found


def drawn_gltf(
    path: Path, folder: Path, camera: tuple[str, list[float]], side: int, step: int, at: float | None = None
) -> dict[str, Any]:
    """What is drawn of a glTF file, from the front: colours of every `step`-th pixel, the bottom row first; `at` a second of its animation."""
    file = base64.b64encode(path.read_bytes()).decode()
    return result(_LOADER, _GLTF, folder, {"file": file, "camera": camera, "side": side, "step": step, "at": at})
