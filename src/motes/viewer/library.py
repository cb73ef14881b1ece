"""Printed shaders of the single models, from which the page puts together the shader of a material that is dropped onto it.

Nothing is typed a second time: each piece is a model of three channels as `motes.exports.glsl` prints it.  A layer of dust over any base f is the printed
layer over a Lambertian base, whose value is K_d/pi: with K_d = pi f.
"""

from __future__ import annotations

from functools import cache

from motes.exports import glsl
from motes.exports.shaders import Shader
from motes.models import BRDF, Conductor, Dielectric, Dust, DustLayer, Lambert, OrenNayar, Schlick, TorranceSparrow
from motes.models.dust import FORMS
from motes.models.torrance_sparrow import NORMALIZATIONS
from motes.viewer.contract import ShaderView, UniformView

FRESNELS = {"": None, "dielectric": Dielectric(), "conductor": Conductor(), "schlick": Schlick()}
LAYER = "dust_layer"


def shader_view(shader: Shader) -> ShaderView:
    """A printed shader for the page."""
    uniforms = [
        UniformView(name=u.name, slot=u.slot, size=len(u.value) if isinstance(u.value, tuple) else 1)
        for u in shader.uniforms
    ]
    return {"source": shader.source, "name": shader.name, "uniforms": uniforms, "channels": shader.channels}


def pieces() -> dict[str, BRDF]:
    """The models by the names under which the page looks for them: the model's name, and its options where it has some."""
    models: dict[str, BRDF] = {"lambert": Lambert(), "oren_nayar": OrenNayar(), LAYER: DustLayer(Lambert())}
    models |= {f"dust_{form}": Dust(form=form) for form in FORMS}
    models |= {
        "_".join(filter(None, ("torrance_sparrow", normalization, name))): TorranceSparrow(
            normalization=normalization, fresnel=fresnel
        )
        for normalization in NORMALIZATIONS
        for name, fresnel in FRESNELS.items()
    }
    return models


@cache
def library() -> dict[str, ShaderView]:
    """Every piece, printed with three channels."""
    return {name: shader_view(glsl.shader(_colored(model), name=f"{name}_eval")) for name, model in pieces().items()}


def _colored(model: BRDF) -> BRDF:
    """The model with a value for each of three channels wherever a parameter may have one."""
    return model.with_parameters(
        {slot.name: (float(slot.value),) * 3 for slot in model.slots() if slot.parameter.per_channel}
    )
