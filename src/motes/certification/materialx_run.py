"""The value that a MaterialX document has for two directions: its shaders as MaterialX's generator writes them, run by OpenGL, a point a pair."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.certification.specimen import Numbers
from motes.errors import MissingExtraError
from motes.exports.materialx import loaded

NEEDED = {"u_worldMatrix": np.eye(4), "u_viewProjectionMatrix": np.eye(4), "u_worldInverseTransposeMatrix": np.eye(4)}


def shaders_of(path: Path, node: str) -> tuple[str, str, str]:
    """The vertex and the pixel shader of a node of a document, whose inputs ``light`` and ``view`` come with the vertices; and MaterialX's version.

    Raises
    ------
    MissingExtraError
        Without the package MaterialX.
    """
    try:
        import MaterialX as mx
        from MaterialX import PyMaterialXGenGlsl, PyMaterialXGenShader
    except ImportError:
        raise MissingExtraError("MaterialX", "materialx", "running a MaterialX document") from None
    document, search = loaded(mx, path)
    value = document.addNode(node, "motes_certified", "color3")
    for name in ("light", "view"):
        given = document.addNode("geompropvalue", f"motes_certified_{name}", "vector3")
        given.setInputValue("geomprop", f"motes_{name}")
        value.addInput(name, "vector3").setNodeName(given.getName())
    generator = PyMaterialXGenGlsl.GlslShaderGenerator.create()
    context = PyMaterialXGenShader.GenContext(generator)
    context.registerSourceCodeSearchPath(search)
    made = generator.generate("motes_certified", value, context)
    return made.getSourceCode("vertex"), made.getSourceCode("pixel"), mx.__version__


def run_materialx(context: Any, vertex: str, pixel: str, wi: Numbers, wo: Numbers) -> NDArray[np.float32]:
    """The values (N, 3) of the shaders of `shaders_of`."""
    side = int(np.ceil(np.sqrt(len(wi))))
    k = np.arange(len(wi))
    place = np.stack([(2 * (k % side) + 1) / side - 1, (2 * (k // side) + 1) / side - 1, np.zeros(len(k))], axis=1)
    columns = {
        "i_position": place,
        "i_geomprop_motes_light": wi,
        "i_geomprop_motes_view": wo,
        "i_normal": np.broadcast_to([0.0, 0.0, 1.0], place.shape),
    }
    with context:  # current, whatever else draws in this process
        program = context.program(vertex_shader=vertex, fragment_shader=pixel)
        for name, matrix in NEEDED.items():
            if name in program:
                program[name].write(matrix.astype("f4").tobytes())
        buffers = [
            (context.buffer(np.ascontiguousarray(values, "f4")), "3f", name)
            for name, values in columns.items()
            if name in program
        ]
        array = context.vertex_array(program, buffers)
        canvas = context.texture((side, side), 4, dtype="f4")
        target = context.framebuffer([canvas])
        target.use()
        target.clear(np.nan, np.nan, np.nan, np.nan)
        context.point_size = 1.0
        array.render(context.POINTS)
        picture = np.frombuffer(target.read(components=4, dtype="f4"), "f4").reshape(-1, 4)[: len(wi), :3].copy()
        for resource in (program, *(b[0] for b in buffers), array, target, canvas):
            resource.release()
    return picture
