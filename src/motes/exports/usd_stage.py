"""USD by the package usd-core: a stage, its meshes, and materials of two networks, MaterialX nodes and UsdPreviewSurface beside them.

Lengths are metres (``metersPerUnit = 1``), y or z is up, colours are linear sRGB.  Programs that know MaterialX take ``outputs:mtlx:surface``, all others
``outputs:surface``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import MotesError
from motes.exports.materialx import VERSION
from motes.exports.usd_library import library
from motes.files.writing import replacing
from motes.meshes.mesh import Mesh

#: Frames a second; what a frame is the file says.
RATE = 24.0


@dataclass(frozen=True)
class Link:
    """An input that another node gives."""

    node: str


@dataclass(frozen=True)
class Node:
    """A node of a network.

    Attributes
    ----------
    name
        In its material.
    definition
        The name of its MaterialX nodedef, or of a shader of USD.
    output
        The type of its ``out``: ``float``, ``color3f``, ``token`` (a surface) ...
    inputs
        By name a type and a value, or where it comes from.
    port
        What its output is called.
    """

    name: str
    definition: str
    output: str
    inputs: Mapping[str, tuple[str, Any]]
    port: str = "out"


class Stage:
    """A stage in the making; `prim` is its default, under which all stands."""

    def __init__(self, name: str, lines: Sequence[str], up: str = "Y") -> None:
        self._usd = library()
        usd, geom = self._usd.Usd, self._usd.UsdGeom
        self.stage = usd.Stage.CreateInMemory()
        geom.SetStageUpAxis(self.stage, geom.Tokens.z if up == "Z" else geom.Tokens.y)
        geom.SetStageMetersPerUnit(self.stage, 1.0)
        self.root = f"/{name}"
        root = geom.Xform.Define(self.stage, self.root).GetPrim()
        usd.ModelAPI(root).SetKind("component")
        self.stage.SetDefaultPrim(root)
        self.stage.GetRootLayer().comment = "\n".join(lines)
        self.looks = f"{self.root}/Looks"
        geom.Scope.Define(self.stage, self.looks)

    def frames(self, frames: Sequence[float]) -> None:
        """Say the times of a stage that changes."""
        self.stage.SetTimeCodesPerSecond(RATE)
        self.stage.SetFramesPerSecond(RATE)
        self.stage.SetStartTimeCode(float(frames[0]))
        self.stage.SetEndTimeCode(float(frames[-1]))

    def mesh(self, name: str, mesh: Mesh, shift: Sequence[float] = (0.0, 0.0, 0.0)) -> Any:
        """A mesh without what its triangles do not use; returns the prim, and the indices of the vertices that it has."""
        sdf, geom, vt = self._usd.Sdf, self._usd.UsdGeom, self._usd.Vt
        if mesh.normals is None:
            raise MotesError(f"{mesh.name} has no normals", "motes.meshes.mesh.with_normals computes them")
        used = np.unique(mesh.triangles)
        index = np.zeros(len(mesh.positions), np.int32)
        index[used] = np.arange(len(used))
        made = geom.Mesh.Define(self.stage, f"{self.root}/{name}")
        points = mesh.positions[used].astype(np.float32)
        made.CreatePointsAttr(vt.Vec3fArray.FromNumpy(points))
        made.CreateFaceVertexCountsAttr(vt.IntArray.FromNumpy(np.full(len(mesh.triangles), 3, np.int32)))
        made.CreateFaceVertexIndicesAttr(vt.IntArray.FromNumpy(np.ascontiguousarray(index[mesh.triangles].ravel())))
        made.CreateNormalsAttr(vt.Vec3fArray.FromNumpy(mesh.normals[used].astype(np.float32)))
        made.SetNormalsInterpolation(geom.Tokens.vertex)
        made.CreateExtentAttr(vt.Vec3fArray.FromNumpy(np.stack([points.min(axis=0), points.max(axis=0)])))
        made.CreateSubdivisionSchemeAttr(geom.Tokens.none)
        made.CreateDoubleSidedAttr(True)
        if mesh.uv is not None:
            self.primvar(made, "st", sdf.ValueTypeNames.TexCoord2fArray).Set(
                vt.Vec2fArray.FromNumpy(mesh.uv[used].astype(np.float32))
            )
        if any(shift):
            geom.XformCommonAPI(made).SetTranslate(self._usd.Gf.Vec3d(*map(float, shift)))
        return made, used

    def primvar(self, mesh: Any, name: str, kind: Any) -> Any:
        """An attribute of the vertices, without a value yet."""
        return self._usd.UsdGeom.PrimvarsAPI(mesh).CreatePrimvar(name, kind, self._usd.UsdGeom.Tokens.vertex)

    def over_vertices(self, mesh: Any, name: str, moments: Sequence[tuple[float | None, NDArray[Any]]]) -> None:
        """Give the vertices numbers (V,) or colours (V, 3), one for all time or one a frame."""
        names, vt = self._usd.Sdf.ValueTypeNames, self._usd.Vt
        flat = moments[0][1].ndim == 1
        made = self.primvar(mesh, name, names.FloatArray if flat else names.Color3fArray)
        for frame, values in moments:
            array = np.ascontiguousarray(values, np.float32)
            given = vt.FloatArray.FromNumpy(array) if flat else vt.Vec3fArray.FromNumpy(array)
            made.Set(given) if frame is None else made.Set(given, frame)

    def material(self, name: str, networks: Mapping[str, Sequence[Node]]) -> Any:
        """A material whose surface is the last node of each network; these by render context: ``mtlx``, or the empty one for all programs."""
        shade = self._usd.UsdShade
        made = shade.Material.Define(self.stage, f"{self.looks}/{name}")
        for context, nodes in networks.items():
            folder = f"{self.looks}/{name}"
            shaders = {node.name: self._shader(folder, node) for node in nodes}
            for node in nodes:
                for key, (kind, value) in node.inputs.items():
                    self._input(shaders, shaders[node.name], key, kind, value, nodes)
            last = nodes[-1]
            end = made.CreateSurfaceOutput(context) if context else made.CreateSurfaceOutput()
            end.ConnectToSource(shaders[last.name].ConnectableAPI(), last.port)
        if "mtlx" in networks:  # without it documents are read as those of 1.38
            prim = made.GetPrim()
            prim.AddAppliedSchema("MaterialXConfigAPI")
            prim.CreateAttribute("config:mtlx:version", self._usd.Sdf.ValueTypeNames.String).Set(VERSION)
        return made

    def bind(self, mesh: Any, material: Any) -> None:
        """Give a mesh its material."""
        self._usd.UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)

    def _shader(self, folder: str, node: Node) -> Any:
        shader = self._usd.UsdShade.Shader.Define(self.stage, f"{folder}/{node.name}")
        shader.CreateIdAttr(node.definition)
        shader.CreateOutput(node.port, self._type(node.output))
        return shader

    def _input(
        self, shaders: Mapping[str, Any], shader: Any, key: str, kind: str, value: Any, nodes: Sequence[Node]
    ) -> None:
        made = shader.CreateInput(key, self._type(kind))
        if isinstance(value, Link):
            port = next(node.port for node in nodes if node.name == value.node)
            made.ConnectToSource(shaders[value.node].ConnectableAPI(), port)
        elif isinstance(value, dict):
            for frame, each in value.items():
                made.Set(self._value(kind, each), frame)
        else:
            made.Set(self._value(kind, value))

    def _value(self, kind: str, value: Any) -> Any:
        return self._usd.Gf.Vec3f(*map(float, value)) if kind == "color3f" else value

    def _type(self, kind: str) -> Any:
        names = self._usd.Sdf.ValueTypeNames
        return {
            "float": names.Float,
            "color3f": names.Color3f,
            "token": names.Token,
            "bool": names.Bool,
            "int": names.Int,
            "string": names.String,
        }[kind]

    def save(self, path: Path) -> Path:
        """Write the stage, whole or not at all; a ``.usdz`` holds it in binary form."""
        suffix = path.suffix.lower()
        with replacing(path) as staging, _sentences(path):
            # The library goes by names, and the staging file's ends otherwise.
            inner = staging.with_name(f"{staging.name}{'.usdc' if suffix == '.usdz' else suffix}")
            package = staging.with_name(f"{staging.name}.usdz")
            try:
                self.stage.GetRootLayer().Export(str(inner))
                if suffix == ".usdz":
                    self._packed(inner, f"{path.stem}.usdc", package)
                (package if suffix == ".usdz" else inner).replace(staging)
            finally:
                for left in (inner, package):
                    left.unlink(missing_ok=True)
        return path

    def _packed(self, inner: Path, name: str, package: Path) -> None:
        utils = self._usd.UsdUtils
        if not utils.CreateNewUsdzPackage(self._usd.Sdf.AssetPath(str(inner)), str(package), name):
            raise MotesError(f"{name} cannot be packed", "Write -o NAME.usdc, and pack it with usdzip")


@contextmanager
def _sentences(path: Path) -> Iterator[None]:
    """What the library raises, as a sentence."""
    import pxr.Tf

    try:
        yield
    except pxr.Tf.ErrorException as error:
        said = " ".join(str(error).split())[:200]
        raise MotesError(f"{path} cannot be written: {said}", "Choose a folder that exists and has room") from None
