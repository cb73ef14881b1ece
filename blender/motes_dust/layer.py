"""What dust looks like: a node group before the output of a material, of plain nodes or with an OSL shader."""

import hashlib
import json
import tempfile
from pathlib import Path

import bpy

from .settling import SHARE

#: By name: where the optics come from, the colour of light scattered once, and curves over tau / (1 + tau); written by Motes.
DUSTS = json.loads(Path(__file__).with_name("dusts.json").read_text(encoding="utf-8"))
DAYS, RATE = "motes_days", "motes_growth_per_day"
#: The mean of 1/cos over diffuse light, as in Motes.
DIFFUSIVITY = next(iter(DUSTS.values()))["diffusivity"]
MARK = "motes_layer"


def kind_for(scene):
    """OSL where Cycles runs it in a scene, else NODES."""
    cycles = getattr(scene, "cycles", None)
    runs = scene.render.engine == "CYCLES" and cycles is not None and cycles.device == "CPU" and cycles.shading_system
    return "OSL" if runs else "NODES"


def cover(thing, dust, kind):
    """Put the group before the output of each material of an object; returns how many outputs there are."""
    if not any(slot.material for slot in thing.material_slots):
        material = bpy.data.materials.new(f"{thing.name} under dust")
        if thing.material_slots:
            thing.material_slots[0].material = material
        else:
            thing.data.materials.append(material)
    group, count = group_of(dust, kind), 0
    for material in {slot.material for slot in thing.material_slots if slot.material}:
        if bpy.app.version < (5, 0):  # later all materials have nodes
            material.use_nodes = True
        tree = material.node_tree
        for end in [node for node in tree.nodes if node.type == "OUTPUT_MATERIAL"]:
            links = end.inputs["Surface"].links
            if not links:
                continue
            count += 1
            before = links[0].from_node
            if before.get(MARK):
                before.node_tree = group
                continue
            node = tree.nodes.new("ShaderNodeGroup")
            node.node_tree, node[MARK], node.label = group, True, "Motes Dust"
            node.location = (end.location.x, end.location.y)
            end.location.x += 220
            tree.links.new(links[0].from_socket, node.inputs["Base"])
            tree.links.new(node.outputs["BSDF"], end.inputs["Surface"])
            _take_albedo(tree, before, node.inputs["Albedo"])
    return count


def uncover(thing):
    """Take the groups off the materials of an object."""
    for material in {slot.material for slot in thing.material_slots if slot.material and slot.material.node_tree}:
        tree = material.node_tree
        for node in [n for n in tree.nodes if n.get(MARK)]:
            source = node.inputs["Base"].links
            for link in list(node.outputs["BSDF"].links):
                if source:
                    tree.links.new(source[0].from_socket, link.to_socket)
            tree.nodes.remove(node)


def _take_albedo(tree, base, albedo):
    """What lies below gives back the light of its colour, where it has one."""
    colour = next((base.inputs[name] for name in ("Base Color", "Color") if name in base.inputs), None)
    if colour is None:
        return
    if colour.links:
        tree.links.new(colour.links[0].from_socket, albedo)
    else:
        albedo.default_value = colour.default_value


def group_of(dust, kind):
    """The node group of a dust, made where there is none."""
    name = f"Motes Dust, {dust} ({kind})"
    if name in bpy.data.node_groups:
        return bpy.data.node_groups[name]
    group = bpy.data.node_groups.new(name, "ShaderNodeTree")
    group.interface.new_socket("Base", in_out="INPUT", socket_type="NodeSocketShader")
    albedo = group.interface.new_socket("Albedo", in_out="INPUT", socket_type="NodeSocketColor")
    albedo.default_value = (0.5, 0.5, 0.5, 1.0)
    group.interface.new_socket("BSDF", in_out="OUTPUT", socket_type="NodeSocketShader")
    (_with_osl if kind == "OSL" else _with_nodes)(group, dust)
    return group


class _Maker:
    """Nodes of a group in few words."""

    def __init__(self, group):
        self.nodes, self.links = group.nodes, group.links

    def node(self, kind, *inputs, **settings):
        """A node, whose inputs in order are numbers, colours or sockets (None: left alone); returns it."""
        made = self.nodes.new(kind)
        for name, value in settings.items():
            setattr(made, name, value)
        for socket, value in zip(made.inputs, inputs, strict=False):
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, socket)
            elif value is not None:
                socket.default_value = value
        return made

    def math(self, operation, *inputs):
        return self.node("ShaderNodeMath", *inputs, operation=operation).outputs[0]

    def colours(self, operation, *inputs):
        return self.node("ShaderNodeVectorMath", *inputs, operation=operation).outputs[0]

    def tau(self):
        """Optical thickness: days x growth per day x share."""
        days = self.node("ShaderNodeAttribute", attribute_type="OBJECT", attribute_name=DAYS).outputs["Fac"]
        rate = self.node("ShaderNodeAttribute", attribute_type="OBJECT", attribute_name=RATE).outputs["Fac"]
        share = self.node("ShaderNodeAttribute", attribute_type="GEOMETRY", attribute_name=SHARE).outputs["Fac"]
        return self.math("MULTIPLY", self.math("MULTIPLY", days, rate), share)


def _with_nodes(group, dust):
    """T base + diffuse, the standard lobes of Motes' layer; of the network's functions of tau, curves."""
    make, facts = _Maker(group), DUSTS[dust]
    given, end = make.node("NodeGroupInput"), make.node("NodeGroupOutput")
    tau = make.tau()
    geometry = make.node("ShaderNodeNewGeometry")
    facing = make.node(
        "ShaderNodeVectorMath", geometry.outputs["Normal"], geometry.outputs["Incoming"], operation="DOT_PRODUCT"
    )
    cosine = make.math("MAXIMUM", make.math("ABSOLUTE", facing.outputs["Value"]), 0.01)
    path = make.math("ADD", make.math("DIVIDE", 1.0, cosine), DIFFUSIVITY)
    through = make.math("EXPONENT", make.math("MULTIPLY", make.math("MULTIPLY", tau, path), -1.0))
    place = make.math("DIVIDE", tau, make.math("ADD", tau, 1.0))
    escaping, below, returned = (_curve(make, facts[name], place) for name in ("escaping", "below", "returned"))
    once = make.colours("SCALE", tuple(facts["once"]))
    make.links.new(make.math("SUBTRACT", 1.0, through), once.node.inputs["Scale"])
    albedo = given.outputs["Albedo"]
    again = make.colours("SUBTRACT", (1.0, 1.0, 1.0), make.colours("MULTIPLY", albedo, returned))
    exchanged = make.colours("DIVIDE", make.colours("MULTIPLY", albedo, below), again)
    colour = make.colours("ADD", make.colours("ADD", once, escaping), exchanged)
    own = make.node("ShaderNodeBsdfDiffuse", colour, 0.0)
    seen = make.node("ShaderNodeMixShader", through, None, given.outputs["Base"])
    total = make.node("ShaderNodeAddShader", seen.outputs[0], own.outputs[0])
    make.links.new(total.outputs[0], end.inputs["BSDF"])


def _curve(make, colours, place):
    """A colour over tau / (1 + tau), by straight lines between stops at equal distances."""
    node = make.node("ShaderNodeValToRGB", place)
    stops, last = node.color_ramp.elements, len(colours) - 1
    for k in range(1, last):
        stops.new(k / last)
    for k, colour in enumerate(colours):
        stops[k].position, stops[k].color = k / last, (*colour, 1.0)
    return node.outputs["Color"]


def _with_osl(group, dust):
    """The shader that Motes printed, compiled here and kept in the file."""
    make, facts = _Maker(group), DUSTS[dust]
    given, end = make.node("NodeGroupInput"), make.node("NodeGroupOutput")
    script = make.node("ShaderNodeScript")
    name = f"motes_dust_{dust}.osl"
    text = bpy.data.texts.get(name) or bpy.data.texts.new(name)
    text.from_string(Path(__file__).with_name("osl").joinpath(f"{dust}.osl").read_text(encoding="utf-8"))
    script.mode, script.script = "INTERNAL", text
    _compile(script, text.as_string())
    given_here = {
        "Base": ("NodeSocketShader", given.outputs["Base"]),
        "tau": ("NodeSocketFloat", make.tau()),
        "albedo": ("NodeSocketColor", given.outputs["Albedo"]),
        "w": ("NodeSocketColor", (*facts["w"], 1.0)),
    }
    for socket, (kind, value) in given_here.items():
        port = script.inputs.get(socket) or script.inputs.new(kind, socket)
        if isinstance(value, bpy.types.NodeSocket):
            make.links.new(value, port)
        else:
            port.default_value = value
    out = script.outputs.get("BSDF") or script.outputs.new("NodeSocketShader", "BSDF")
    make.links.new(out, end.inputs["BSDF"])


def _compile(script, source):
    """Give a script node its byte code, where Blender has not done it (its package for Python cannot)."""
    if script.bytecode:
        return
    import _cycles

    with tempfile.TemporaryDirectory() as folder:
        given, made = Path(folder) / "dust.osl", Path(folder) / "dust.oso"
        given.write_text(source, encoding="utf-8")
        if not _cycles.osl_compile(str(given), str(made)):
            raise ValueError("the OSL shader of the dust does not compile here; choose the shader Nodes")
        script.bytecode = made.read_text(encoding="utf-8")
    script.bytecode_hash = hashlib.md5(script.bytecode.encode(), usedforsecurity=False).hexdigest()
