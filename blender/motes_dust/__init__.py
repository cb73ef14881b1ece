"""Motes Dust: dust settles on the active object, over any material.

Object > Motes Dust, or the tab Motes of the sidebar.  How much lies where is a share at each vertex (the attribute `motes_share`); what it looks
like, a node group before the output of each material; how long it has been settling, the property `motes_days` of the object, which animates.
File > Import > Motes Material, or a file dropped into the view: what `motes export --to blender` fitted, as a node group.
"""

import bpy
from bpy_extras.io_utils import ImportHelper

from . import importing, layer, settling
from .layer import DAYS, DUSTS, RATE

# Of a level, open surface; the enumeration needs its texts kept alive.
_ITEMS = [(name, name.replace("_", " ").capitalize(), dust["source"]) for name, dust in DUSTS.items()]


class MOTES_OT_dust(bpy.types.Operator):
    """Let dust settle on the active object; again, it settles anew"""

    bl_idname = "object.motes_dust"
    bl_label = "Motes Dust"
    bl_options = {"REGISTER", "UNDO"}

    days: bpy.props.FloatProperty(name="Days", default=120, min=0, soft_max=1000, description="Since it was clean")
    growth_per_day: bpy.props.FloatProperty(
        name="Growth per day",
        default=settling.GROWTH_PER_DAY,
        min=0,
        precision=4,
        description="Optical thickness a day",
    )
    tau: bpy.props.FloatProperty(
        name="tau", default=0, min=0, description="Optical thickness after these days; 0: by the growth per day"
    )
    dust: bpy.props.EnumProperty(name="Dust", items=_ITEMS)
    up: bpy.props.FloatVectorProperty(name="Up", default=(0, 0, 1), subtype="DIRECTION")
    shelter: bpy.props.BoolProperty(
        name="Sheltered by the scene", default=True, description="Other meshes keep dust off"
    )
    adhesion: bpy.props.FloatProperty(name="Adhesion", default=settling.ADHESION, min=0, max=1)
    slipperiness: bpy.props.FloatProperty(name="Slipperiness", default=settling.SLIPPERINESS, min=0, max=1)
    spread_deg: bpy.props.FloatProperty(
        name="Spread", default=settling.SPREAD_DEG, min=1, max=60, description="In degrees"
    )
    rays: bpy.props.IntProperty(name="Rays", default=64, min=1, max=4096, description="Directions that dust falls from")
    shader: bpy.props.EnumProperty(
        name="Shader",
        items=[
            ("AUTO", "Automatic", "OSL where Cycles runs it in this scene, else nodes"),
            ("NODES", "Nodes", "For EEVEE, and Cycles on any device"),
            ("OSL", "OSL", "For Cycles on the CPU with Open Shading Language"),
        ],
    )

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        thing = context.object
        try:
            share = settling.settle(
                context,
                thing,
                up=tuple(self.up),
                shelter=self.shelter,
                rays=self.rays,
                adhesion=self.adhesion,
                slipperiness=self.slipperiness,
                spread_deg=self.spread_deg,
            )
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        thing[DAYS] = float(self.days)
        thing.id_properties_ui(DAYS).update(min=0.0, soft_max=1000.0, description="Days of dust; it animates")
        thing[RATE] = float(self.tau / max(self.days, 1e-9) if self.tau > 0 else self.growth_per_day)
        thing.update_tag()
        kind = layer.kind_for(context.scene) if self.shader == "AUTO" else self.shader
        count = layer.cover(thing, self.dust, kind)
        self.report(
            {"INFO"},
            f"{len(share)} vertices, mean share {share.mean():.2f}; {count} outputs of materials under dust ({kind})",
        )
        return {"FINISHED"}


class MOTES_OT_clean(bpy.types.Operator):
    """Take the dust and its nodes off the active object"""

    bl_idname = "object.motes_clean"
    bl_label = "Remove Motes Dust"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and DAYS in context.object

    def execute(self, context):
        layer.uncover(context.object)
        settling.forget(context.object)
        for name in (DAYS, RATE):
            context.object.pop(name, None)
        return {"FINISHED"}


class MOTES_OT_animate(bpy.types.Operator):
    """Keyframes from clean at the first frame of the scene to the days of now at the last"""

    bl_idname = "object.motes_animate"
    bl_label = "Animate Days"
    bl_options = {"REGISTER", "UNDO"}

    poll = MOTES_OT_clean.poll

    def execute(self, context):
        thing, scene = context.object, context.scene
        last = thing[DAYS]
        for frame, days in ((scene.frame_start, 0.0), (scene.frame_end, last)):
            thing[DAYS] = days
            thing.keyframe_insert(f'["{DAYS}"]', frame=frame)
        return {"FINISHED"}


class MOTES_OT_import(bpy.types.Operator, ImportHelper):
    """Make a material of the parameters that Motes fitted, and give it to the active object"""

    bl_idname = "import_scene.motes_material"
    bl_label = "Import Motes Material"
    bl_options = {"REGISTER", "UNDO"}

    filename_ext = ".json"
    filter_glob: bpy.props.StringProperty(default="*.json", options={"HIDDEN"})
    filepath: bpy.props.StringProperty(subtype="FILE_PATH", options={"SKIP_SAVE"})

    def invoke(self, context, event):
        return self.execute(context) if self.filepath else ImportHelper.invoke(self, context, event)

    def execute(self, context):
        try:
            name, moments = importing.read(self.filepath)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        material = importing.make(name, moments)
        thing = context.object
        if thing is not None and thing.type == "MESH":
            thing.active_material = material
        self.report({"INFO"}, f"{material.name}: {len(moments)} moment{'s' * (len(moments) > 1)}")
        return {"FINISHED"}


class MOTES_FH_material(bpy.types.FileHandler):
    bl_idname = "MOTES_FH_material"
    bl_label = "Motes Material"
    bl_import_operator = MOTES_OT_import.bl_idname
    bl_file_extensions = ".json"

    @classmethod
    def poll_drop(cls, context):
        return context.area is not None and context.area.type == "VIEW_3D"


class MOTES_PT_dust(bpy.types.Panel):
    bl_label = "Motes Dust"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Motes"

    def draw(self, context):
        self.layout.operator(MOTES_OT_dust.bl_idname)
        if context.object is not None and DAYS in context.object:
            self.layout.prop(context.object, f'["{DAYS}"]', text="Days")
            self.layout.prop(context.object, f'["{RATE}"]', text="Growth per day")
            self.layout.operator(MOTES_OT_animate.bl_idname)
            self.layout.operator(MOTES_OT_clean.bl_idname)


CLASSES = (MOTES_OT_dust, MOTES_OT_clean, MOTES_OT_animate, MOTES_OT_import, MOTES_FH_material, MOTES_PT_dust)


def _in_menu(self, context):
    self.layout.operator(MOTES_OT_dust.bl_idname)


def _in_import(self, context):
    self.layout.operator(MOTES_OT_import.bl_idname, text="Motes Material (_fit.json)")


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_object.append(_in_menu)
    bpy.types.TOPBAR_MT_file_import.append(_in_import)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(_in_import)
    bpy.types.VIEW3D_MT_object.remove(_in_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
