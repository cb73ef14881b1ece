"""OSL: a layer of dust over whatever lies below it, as a closure that takes a closure.

A renderer's shader of any kind goes in at ``Base``; out comes what is seen of it through the dust, and the dust's own light, by the standard
lobes that `motes.models.DustLayer` declares (see `motes.exports.approximation`).  Of the base a closure tells nothing: how much light it gives back
to the dust above it is the input ``albedo``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self, final

from motes.arrays import Array
from motes.directions import Geometry
from motes.equations import INV_PI
from motes.errors import ParameterError
from motes.exports.approximation import losses, written
from motes.exports.shaders import checked_name, plain
from motes.models import BRDF, Component, CosineLobe, Dust, DustLayer, Reflection, StandardLobe
from motes.parameters import parameter
from motes.printing.language import comment, indented
from motes.version import __version__

#: Inputs that are colours; the others are numbers.
COLOURS = ("albedo", "w")


@final
@dataclass(frozen=True, eq=False)
class Beneath(BRDF):
    """Whatever lies below the dust: of light it gives back the share ``albedo``, and that is all that is known of it."""

    approximation: ClassVar[str] = ""

    albedo: Array = parameter(0.5, bounds=(0, 1), symbol="a", doc="albedo of what lies below", per_channel=True)

    def formula(self, xp: Array, geometry: Geometry) -> Array:
        return self.albedo * INV_PI

    def components(self, xp: Array, cos_theta_i: Array) -> list[Component]:
        return [Component(self.formula, CosineLobe(), self.albedo)]

    def standard_lobes(self, xp: Array, values: Self, cos_view: Array) -> list[StandardLobe]:
        return [StandardLobe(Reflection.DIFFUSE, 1.0)]  # all of the closure itself


def layer_shader(dust: Dust, *, scattering: str = "multiple", shader_name: str = "motes_dust", title: str = "") -> str:
    """The OSL source of a layer of dust over a closure.

    Parameters
    ----------
    dust
        What it is made of; w is an input of the shader, g is fixed.
    scattering
        ``"multiple"`` or ``"single"``, as of `motes.models.DustLayer`.
    shader_name, title
        Of the shader, and for people.

    Returns
    -------
    str
        A shader with the inputs ``Base`` (a closure), ``tau``, ``albedo``, ``w`` and ``Normal``, and the output ``BSDF``.

    Raises
    ------
    ParameterError
        For dust of other than one or three channels, or a name that is none.
    """
    name = checked_name(shader_name)
    if dust.channels not in (1, 3):
        raise ParameterError(f"dust of {dust.channels} channels is no colour", "Give w one value or three")
    model = DustLayer(Beneath(), dust, 0.2, scattering=scattering)
    statements, (base, *lobes) = written(model, COLOURS, "color")
    red, green, blue = (float(x) for x in (dust.w if getattr(dust.w, "size", 1) == 3 else [dust.w] * 3))
    said = [
        f"{title or 'Dust'} over any closure: Open Shading Language, printed by Motes {__version__} from its equations.",
        f"Light in the dust: {scattering} scattering; g = {float(dust.g):g}.",
        *losses(model),
    ]
    head = [line for text in said for line in comment(plain(text))]
    body = [
        "vector view = dot(I, N) > 0 ? I : -I;",  # the specification's I points to the surface, that of Cycles to the viewer
        "vector wo = vector(0, 0, abs(dot(view, Normal)));",
        f"float g = {float(dust.g)!r};",
        *statements,
        f"BSDF = {base.grazing} * Base;",
        *(f"BSDF += oren_nayar_diffuse_bsdf(Normal, {lobe.grazing}, {lobe.roughness});" for lobe in lobes),
    ]
    parameters = [
        "closure color Base = 0,",
        'float tau = 0.2 [[ string help = "optical thickness of the layer", float min = 0.0, float UImax = 2.0 ]],',
        'color albedo = color(0.5) [[ string help = "albedo of what lies below" ]],',
        f'color w = color({red!r}, {green!r}, {blue!r}) [[ string help = "single-scattering albedo of the dust" ]],',
        'normal Normal = N [[ string help = "the surface\'s normal" ]],',
        "output closure color BSDF = 0",
    ]
    return "\n".join([*head, "", f"shader {name}(", *indented(parameters), ") {", *indented(body), "}"]) + "\n"
