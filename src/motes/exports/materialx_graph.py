"""Node graphs of MaterialX: expressions of nodes, and the standard lobes."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping
from dataclasses import dataclass

from motes.exports.approximation import DIFFUSIVITY, Lobe


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
        """``add``, ``subtract``, ``multiply`` or ``divide``, of numbers and colours."""
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

    def product(self, *values: Value) -> Value:
        result, *others = sorted(values, key=lambda value: value.type != "color3")
        for other in others:
            result = self.calculate("multiply", result, other)
        return result

    def square(self, value: Value) -> Value:
        return self.calculate("multiply", value, value)

    # ------------------------------------------------------------ lobes

    def lobe(self, lobe: Lobe, slots: Mapping[str, Value], normal: Value) -> Value:
        """A standard lobe, with what converts the parameters."""
        factors = [slots[lobe.color]]
        factors += [number(lobe.scale)] if lobe.scale != 1 else []
        width = slots[lobe.width] if lobe.width else number(0)
        factors += [number(math.pi), self.square(width)] if lobe.area else []
        for tau, dust in lobe.layers:
            depth = self.calculate("multiply", slots[tau], number(-2 * DIFFUSIVITY))
            through = self.node("exp", "float", {"in": depth}, "through")
            factors.append(self.calculate("subtract", number(1), through) if dust else through)
        color = self.color(self.product(*factors))
        if not lobe.specular:
            inputs = {"color": color, "roughness": width, "normal": normal}
            return self.node("oren_nayar_diffuse_bsdf", "BSDF", inputs, "diffuse")
        color0 = self.color(self.product(color, *self._fresnel(lobe, slots)))
        inputs = {
            "color0": color0,
            "color90": color,
            "roughness": self.node("combine2", "vector2", {"in1": width, "in2": width}, "alpha"),
            "normal": normal,
        }
        return self.node("generalized_schlick_bsdf", "BSDF", inputs | {"scatter_mode": "R"}, "highlight")

    def _fresnel(self, lobe: Lobe, slots: Mapping[str, Value]) -> list[Value]:
        """The factor of the reflectance at normal incidence."""
        kind, *own = lobe.fresnel
        if not kind:
            return []
        if kind == "schlick":
            return [slots[own[0]]]
        n = slots[own[0]]
        less, more = (self.square(self.calculate(op, n, number(1))) for op in ("subtract", "add"))
        if kind == "conductor":
            k2 = self.square(slots[own[1]])
            less, more = self.calculate("add", less, k2), self.calculate("add", more, k2)
        return [self.calculate("divide", less, more)]

    def total(self, parts: list[Value]) -> Value:
        """The sum of BSDFs."""
        result, *others = parts
        for other in others:
            result = self.node("add", "BSDF", {"in1": result, "in2": other}, "sum")
        return result
