"""Materials of Motes: the parameters of the Principled BSDF that `motes export --to blender` fitted, as a node group that a material shows."""

import json
from pathlib import Path

import bpy

#: What the sockets of the node are called by the names in the file, and the frames from one moment to the next; written by Motes.
NAMES = json.loads(Path(__file__).with_name("sockets.json").read_text(encoding="utf-8"))
SOCKETS, STEP = NAMES["sockets"], NAMES["step"]
LARGEST = 64 * 2**20


def read(path):
    """The name of a material and, for each of its moments, values by socket; raises ValueError with a sentence."""
    file = Path(path)
    hint = f"motes export MATERIAL --to blender -o {file.stem}.py writes {file.stem}_fit.json, which is read here."
    try:
        if file.stat().st_size > LARGEST:
            raise ValueError(f"{file.name} is larger than any material. {hint}")
        told = json.loads(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise ValueError(f"{file.name} cannot be read: {error.strerror}.") from None
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError):
        raise ValueError(f"{file.name} is no JSON. {hint}") from None
    moments = told.get("moments") if isinstance(told, dict) else None
    if not isinstance(moments, list) or not moments:
        raise ValueError(f"{file.name} has no parameters of Blender's. {hint}")
    return str(told.get("name", file.stem))[:60], [_values(file.name, each, hint) for each in moments]


def _values(name, moment, hint):
    parameters = moment.get("parameters") if isinstance(moment, dict) else None
    if not isinstance(parameters, dict) or not parameters or not set(parameters) <= set(SOCKETS):
        raise ValueError(f"{name} has the parameters of another program. {hint}")
    found = {}
    for parameter, value in parameters.items():
        numbers = value if isinstance(value, list) else [value]
        good = all(isinstance(x, (int, float)) and not isinstance(x, bool) and -1e6 < x < 1e6 for x in numbers)
        if not good or len(numbers) != (3 if isinstance(value, list) else 1):
            raise ValueError(f"{name}: {parameter} = {str(value)[:40]} is neither a number nor a colour of three.")
        found[SOCKETS[parameter]] = (*map(float, numbers), 1.0) if isinstance(value, list) else float(value)
    return found


def make(name, moments):
    """A material whose surface is a node group of that name; of several moments its sockets are keyed."""
    group = bpy.data.node_groups.new(f"Motes {name}", "ShaderNodeTree")
    group.interface.new_socket("BSDF", in_out="OUTPUT", socket_type="NodeSocketShader")
    node, end = group.nodes.new("ShaderNodeBsdfPrincipled"), group.nodes.new("NodeGroupOutput")
    node.location = (-300, 0)
    group.links.new(node.outputs["BSDF"], end.inputs["BSDF"])
    shared = {socket: value for values in moments for socket, value in values.items()}
    for k, values in enumerate(moments):
        for socket, value in {**shared, **values}.items():
            node.inputs[socket].default_value = value
            if len(moments) > 1:
                node.inputs[socket].keyframe_insert("default_value", frame=1 + STEP * k)
    material = bpy.data.materials.new(name)
    if bpy.app.version < (5, 0):  # later all materials have nodes
        material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    shown, output = nodes.new("ShaderNodeGroup"), nodes.new("ShaderNodeOutputMaterial")
    shown.node_tree, shown.location, shown.width = group, (-300, 0), 240
    links.new(shown.outputs["BSDF"], output.inputs["Surface"])
    return material
