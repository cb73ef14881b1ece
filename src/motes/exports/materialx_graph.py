"""Node graphs of MaterialX: expressions of nodes, and the standard lobes."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from dataclasses import dataclass

from motes.exports.approximation import supported
from motes.graph.dependence import live
from motes.graph.symbols import Symbol
from motes.models import Reflection, StandardLobe

_ARITHMETIC = {
    "add": "add",
    "sub": "subtract",
    "mul": "multiply",
    "div": "divide",
    "maximum": "max",
    "minimum": "min",
}


@dataclass(frozen=True)
class Value:
    """Something that can be an input: a node, an input of the graph, or a number."""

    attribute: str
    text: str
    type: str


def number(value: float) -> Value:
    """A constant."""
    return Value("value", repr(float(value)), "float")


class Graph:
    """A ``<nodegraph>`` in the making; `element` is its XML."""

    def __init__(self, name: str, nodedef: str) -> None:
        self.element = ElementTree.Element("nodegraph", name=name, nodedef=nodedef)
        self._known: dict[tuple[object, ...], Value] = {}

    def interface(self, name: str, type_: str) -> Value:
        """An input of the graph."""
        return Value("interfacename", name, type_)

    def node(self, category: str, type_: str, inputs: Mapping[str, Value | str], label: str = "") -> Value:
        """A node; the same one where there is an equal one already.  Texts are string inputs."""
        key = (category, type_, *inputs.items())
        if key not in self._known:
            name = f"{label or category}_{len(self._known) + 1}"
            element = ElementTree.SubElement(self.element, category, name=name, type=type_)
            for port, value in inputs.items():
                given = Value("value", value, "string") if isinstance(value, str) else value
                ElementTree.SubElement(
                    element, "input", {"name": port, "type": given.type, given.attribute: given.text}
                )
            self._known[key] = Value("nodename", name, type_)
        return self._known[key]

    def output(self, value: Value) -> None:
        """The result of the graph."""
        ElementTree.SubElement(self.element, "output", {"name": "out", "type": value.type, value.attribute: value.text})

    # ------------------------------------------------------------ arithmetic

    def calculate(self, op: str, a: Value, b: Value) -> Value:
        """``add``, ``subtract``, ``multiply``, ``divide``, ``max`` or ``min``, of numbers and colours."""
        if "color3" in (a.type, b.type) and a.type != "color3":
            a = self.color(a)
        return self.node(op, a.type, {"in1": a, "in2": b})

    def color(self, value: Value) -> Value:
        """A number as a colour."""
        if value.type == "color3":
            return value
        if value.attribute == "value":
            return Value("value", ", ".join([value.text] * 3), "color3")
        return self.node("convert", "color3", {"in": value})

    # ------------------------------------------------------------ lobes

    def computed(self, symbol: Symbol, slots: Mapping[str, Value]) -> Value:
        """Recorded arithmetic as nodes."""
        known: dict[Symbol, Value] = {}
        for part in live([symbol]):
            known[part] = self._computed(part, [known[a] for a in part.args], slots)
        return known[symbol]

    def _computed(self, symbol: Symbol, args: list[Value], slots: Mapping[str, Value]) -> Value:
        """One step of it."""
        if symbol.op == "leaf":
            return slots[str(symbol.value)]
        if symbol.op == "constant":
            return number(symbol.value)
        op = supported(symbol)
        if op in _ARITHMETIC:
            return self.calculate(_ARITHMETIC[op], *args)
        if op == "lt":  # 1 or 0; value1 > value2
            return self._choose(args[1], args[0], number(1), number(0))
        if op == "where":
            return self._choose(args[0], number(0.5), args[1], args[2])
        if op == "neg":
            return self.calculate("multiply", args[0], number(-1))
        if op == "expm1":
            return self.calculate("subtract", self._function("exp", args[0]), number(1))
        return self._function(op, args[0])

    def _choose(self, more: Value, less: Value, then: Value, otherwise: Value) -> Value:
        """One of two values, by whether a number is more than another."""
        if "color3" in (then.type, otherwise.type):
            then, otherwise = self.color(then), self.color(otherwise)
        inputs = {"value1": more, "value2": less, "in1": then, "in2": otherwise}
        return self.node("ifgreater", then.type, inputs)

    def _function(self, name: str, value: Value) -> Value:
        """``exp`` or ``sqrt``, which nodes do for numbers and vectors but not for colours."""
        if value.type != "color3":
            return self.node(name, value.type, {"in": value})
        vector = self.node("convert", "vector3", {"in": value})
        return self.node("convert", "color3", {"in": self.node(name, "vector3", {"in": vector})})

    def lobe(self, lobe: StandardLobe, slots: Mapping[str, Value], normal: Value) -> Value:
        """A recorded standard lobe, with what converts the parameters."""
        color = self.color(self.computed(lobe.reflectance, slots))
        if lobe.tint:
            tint = lobe.tint * 3 if len(lobe.tint) == 1 else lobe.tint
            color = self.calculate("multiply", color, Value("value", ", ".join(map(repr, tint)), "color3"))
        roughness = self.computed(lobe.roughness, slots)
        if lobe.reflection is Reflection.DIFFUSE:
            inputs = {"color": color, "roughness": roughness, "normal": normal}
            if lobe.preserving:  # EON itself
                inputs["energy_compensation"] = Value("value", "true", "boolean")
            return self.node("oren_nayar_diffuse_bsdf", "BSDF", inputs, "diffuse")
        share = self.computed(lobe.normal, slots)
        inputs = {
            "color0": color if lobe.normal.is_constant(1) else self.calculate("multiply", color, share),
            "color90": color,
            "roughness": self.node("combine2", "vector2", {"in1": roughness, "in2": roughness}, "alpha"),
            "normal": normal,
        }
        return self.node("generalized_schlick_bsdf", "BSDF", inputs | {"scatter_mode": "R"}, "highlight")

    def total(self, parts: list[Value]) -> Value:
        """The sum of BSDFs."""
        result, *others = parts
        for other in others:
            result = self.node("add", "BSDF", {"in1": result, "in2": other}, "sum")
        return result
