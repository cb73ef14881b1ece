"""Look at a USD file in Storm and in Cycles; executed by a Python that has the package bpy, which brings USD with MaterialX and imaging.

    python usd_in_programs.py FILE.usda RESULT.npz SIDE PACKAGES MATERIAL MESH

An orthographic camera above looks down the axis z at a square of side 2 about the mesh's middle, under a distant light along SUN.  PACKAGES is a folder that
has moderngl, whose context Storm draws in.  RESULT has what Storm draws by MaterialX and by the preview, what Cycles draws of what Blender imports, and what
all of USD's validators say, each with its error's name.
"""

from __future__ import annotations

import sys
from pathlib import Path

import bpy
import numpy as np

from cycles_support import drawn_by_cycles

BLENDERS = next(Path(bpy.utils.resource_path("LOCAL")).glob("python/lib/python3*/site-packages"))
sys.path += [str(BLENDERS), sys.argv[4]]
FILE, RESULT, SIDE, MATERIAL, MESH = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3]), sys.argv[5], sys.argv[6]
SUN = np.array([0.5, 0.0, 0.8]) / np.linalg.norm([0.5, 0.0, 0.8])
FAR = 1000.0


def validated() -> list[str]:
    from pxr import Usd, UsdValidation

    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    return [error.GetErrorAsString() for error in context.Validate(Usd.Stage.Open(str(FILE)))]


def middle(stage: object) -> np.ndarray:
    from pxr import UsdGeom

    points = np.array(UsdGeom.Mesh(stage.GetPrimAtPath(MESH)).GetPointsAttr().Get(0))
    return (points.min(axis=0) + points.max(axis=0)) / 2


def by_storm(context: str) -> np.ndarray:
    from pxr import Gf, Tf, Usd, UsdAppUtils, UsdGeom, UsdLux, UsdShade

    stage = Usd.Stage.Open(Usd.Stage.Open(str(FILE)).Flatten())
    centre = middle(stage)
    material = UsdShade.Material(stage.GetPrimAtPath(MATERIAL))
    other = "mtlx" if context == "preview" else ""
    stage.GetPrimAtPath(MATERIAL).RemoveProperty(material.GetSurfaceOutput(other).GetFullName())
    light = UsdLux.DistantLight.Define(stage, "/sun")
    light.CreateAngleAttr(0.5)
    light.CreateIntensityAttr(1 / (2 * np.pi * (1 - np.cos(np.radians(0.25)))))  # a radiance: of 1 in all
    turn = np.degrees(np.arctan2(SUN[0], SUN[2]))
    UsdGeom.XformCommonAPI(light).SetRotate(Gf.Vec3f(0, float(turn), 0))
    camera = UsdGeom.Camera.Define(stage, "/camera")
    camera.CreateProjectionAttr("orthographic")
    camera.CreateHorizontalApertureAttr(20.0)  # tenths of a unit
    camera.CreateVerticalApertureAttr(20.0)
    # Far away, for MaterialX's nodes in Storm see each place from where the camera stands, as if it were none without perspective.
    camera.CreateClippingRangeAttr(Gf.Vec2f(FAR - 5, FAR + 5))
    UsdGeom.XformCommonAPI(camera).SetTranslate(Gf.Vec3d(float(centre[0]), float(centre[1]), float(centre[2]) + FAR))
    recorder = UsdAppUtils.FrameRecorder()
    recorder.SetImageWidth(SIDE)
    recorder.SetCameraLightEnabled(False)
    recorder.SetColorCorrectionMode("disabled")
    picture = RESULT.with_name(f"storm_{context}.exr")
    try:
        recorder.Record(stage, camera, Usd.TimeCode(stage.GetEndTimeCode()), str(picture))
    except Tf.ErrorException as error:  # of the window that there is none of
        others = [line for line in str(error).splitlines() if line.strip() and "GL error" not in line]
        assert not others, others
    return pixels(picture)


def pixels(picture: Path) -> np.ndarray:
    loaded = bpy.data.images.load(str(picture))
    loaded.colorspace_settings.name = "Non-Color"
    values = np.empty(4 * SIDE * SIDE, np.float32)
    loaded.pixels.foreach_get(values)
    return values.reshape(SIDE, SIDE, 4)


def by_cycles() -> np.ndarray:
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.wm.usd_import(filepath=str(FILE), import_usd_preview=True)
    scene = bpy.context.scene
    drawn_by_cycles(scene, SIDE)
    scene.frame_set(int(scene.frame_end))
    scene.world = bpy.data.worlds.new("dark")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.0
    thing = next(each for each in bpy.data.objects if each.type == "MESH")
    corners = np.array([thing.matrix_world @ vertex.co for vertex in thing.data.vertices])
    centre = (corners.min(axis=0) + corners.max(axis=0)) / 2
    # Blender turns what has y up by a quarter about x: the camera, the light and the axes of the picture turn along.
    frame = bpy.data.objects.new("frame", None)
    frame.location, frame.rotation_euler = centre, (np.pi / 2, 0, 0)
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 1.0, 0.0
    sun.rotation_euler = (0, np.arctan2(SUN[0], SUN[2]), 0)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type, camera.data.ortho_scale, camera.location = "ORTHO", 2.0, (0, 0, 5)
    for each in (frame, sun, camera):
        scene.collection.objects.link(each)
    sun.parent = camera.parent = frame
    scene.camera = camera
    picture = RESULT.with_name("cycles.exr")
    scene.render.filepath = str(picture)
    bpy.ops.render.render(write_still=True)
    return pixels(picture)


found = {"validators": np.array(validated())}
import moderngl  # noqa: E402

window = moderngl.create_standalone_context(backend="egl", require=450)
found |= {f"storm_{context}": by_storm(context) for context in ("mtlx", "preview")}
found["renderer"] = np.array(window.info["GL_RENDERER"])
found["cycles"] = by_cycles()
np.savez(RESULT, sun=SUN, **found)
