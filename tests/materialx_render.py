"""Draw a square with a material of a MaterialX document, by MaterialX's own renderer; run under xvfb-run, not imported by the tests.

    python materialx_render.py DOCUMENT.mtlx MATERIAL RESULT.npz [X,Y,Z [MESH.obj SIDE]]

The square [-1, 1]^2, or a mesh, faces the camera at (0, 0, 3); the sun stands towards (0.3, 0.2, 1), or where it is told, with intensity 2.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import MaterialX as mx
import numpy as np
from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader, PyMaterialXRender, PyMaterialXRenderGlsl

from motes.exports.materialx import loaded

SIDE = 64
SQUARE = """v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
vn 0 0 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
f 1/1/1 2/2/1 3/3/1
f 1/1/1 3/3/1 4/4/1
"""


def main(
    path: Path,
    material: str,
    result: Path,
    towards: tuple[float, ...] = (0.3, 0.2, 1.0),
    mesh: str = "",
    side: int = SIDE,
) -> None:
    document, search = loaded(mx, path)
    sun = document.addNode("directional_light", "sun", "lightshader")
    sun.setInputValue("direction", mx.Vector3(*(-x for x in towards)).getNormalized())
    sun.setInputValue("color", mx.Color3(1, 1, 1))
    sun.setInputValue("intensity", 2.0)

    generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    context.getOptions().hwMaxActiveLightSources = 1
    renderer = PyMaterialXRenderGlsl.GlslRenderer.create(side, side, PyMaterialXRender.BaseType.FLOAT)
    renderer.initialize()
    geometry = PyMaterialXRender.GeometryHandler.create()
    geometry.addLoader(PyMaterialXRender.TinyObjLoader.create())
    with tempfile.TemporaryDirectory() as folder:
        square = Path(folder) / "square.obj"
        square.write_text(SQUARE)
        geometry.loadGeometry(mx.FilePath(mesh or str(square)), False)
    renderer.setGeometryHandler(geometry)
    renderer.setImageHandler(PyMaterialXRender.ImageHandler.create(PyMaterialXRender.StbImageLoader.create()))
    lights = PyMaterialXRender.LightHandler.create()
    lights.setLightSources([sun])
    lights.registerLights(document, [sun], context)
    renderer.setLightHandler(lights)
    renderer.createProgram(generator.generate(material, document.getNode(material), context))
    renderer.validateInputs()
    renderer.setSize(side, side)
    renderer.render()
    image = renderer.captureImage(None)
    colors = [[list(image.getTexelColor(x, y))[:3] for x in range(side)] for y in range(side)]
    scale = renderer.getCamera().getProjectionMatrix()[0, 0]
    np.savez(result, colors=colors, scale=scale, eye=list(renderer.getCamera().getViewPosition()))


if __name__ == "__main__":
    main(
        Path(sys.argv[1]),
        sys.argv[2],
        Path(sys.argv[3]),
        *(tuple(map(float, text.split(","))) for text in sys.argv[4:5]),
        *sys.argv[5:6],
        *map(int, sys.argv[6:]),
    )
