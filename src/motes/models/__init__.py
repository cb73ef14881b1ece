"""The reflectance models, one a file, and what combines them.

To add one, write its file and import it here: what it declares is all that anybody asks for.
"""

# Models in the order in which texts list them.
# isort: off
from motes.models.base import BRDF, Sampled, Sum
from motes.models.components import Component
from motes.models.lobes import CosineLobe, Lobe, Reflection
from motes.models.naming import register, registered, unregister
from motes.models.standard import StandardLobe
from motes.models.lambert import Lambert
from motes.models.oren_nayar import OrenNayar
from motes.models.eon import EON
from motes.models.torrance_sparrow import TorranceSparrow
from motes.models.ggx import GGX
from motes.models.beckmann import Beckmann
from motes.models.gtr import GTR
from motes.models.dust import Dust, DustLayer
from motes.models.coated_diffuse import CoatedDiffuse
from motes.models.hapke import Hapke
from motes.models.retro import Retro
from motes.models.sheen import Sheen
from motes.models.fresnel import Conductor, Dielectric, Fresnel, Schlick
from motes.models.surfaces.openpbr import OpenPBR
from motes.models.surfaces.standard_surface import StandardSurface
from motes.models.surfaces.gltf_surface import GltfSurface
from motes.models.surfaces.principled import Principled
from motes.models.surfaces.program import Surface
from motes.models.composition import Layer, layer_of, on_base
from motes.models.expressions import describe, parse
# isort: on

__all__ = [
    "BRDF",
    "EON",
    "GGX",
    "GTR",
    "Beckmann",
    "CoatedDiffuse",
    "Component",
    "Conductor",
    "CosineLobe",
    "Dielectric",
    "Dust",
    "DustLayer",
    "Fresnel",
    "GltfSurface",
    "Hapke",
    "Lambert",
    "Layer",
    "Lobe",
    "OpenPBR",
    "OrenNayar",
    "Principled",
    "Reflection",
    "Retro",
    "Sampled",
    "Schlick",
    "Sheen",
    "StandardLobe",
    "StandardSurface",
    "Sum",
    "Surface",
    "TorranceSparrow",
    "describe",
    "layer_of",
    "on_base",
    "parse",
    "register",
    "registered",
    "unregister",
]
