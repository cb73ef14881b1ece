"""The reflectance models, one a file, and what combines them."""

from motes.models.base import BRDF, Sampled
from motes.models.dust import Dust, DustLayer
from motes.models.expressions import describe, parse
from motes.models.fresnel import Conductor, Dielectric, Fresnel, Schlick
from motes.models.lambert import Lambert
from motes.models.oren_nayar import OrenNayar
from motes.models.sums import Sum
from motes.models.torrance_sparrow import TorranceSparrow

__all__ = [
    "BRDF",
    "Conductor",
    "Dielectric",
    "Dust",
    "DustLayer",
    "Fresnel",
    "Lambert",
    "OrenNayar",
    "Sampled",
    "Schlick",
    "Sum",
    "TorranceSparrow",
    "describe",
    "parse",
]
