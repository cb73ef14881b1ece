"""Motes: reflectance that changes with time, from measurement to picture."""

from motes.errors import MotesError
from motes.models import (
    BRDF,
    Conductor,
    Dielectric,
    Dust,
    DustLayer,
    Lambert,
    OrenNayar,
    Schlick,
    TorranceSparrow,
)

__version__ = "0.1.0"

__all__ = [
    "BRDF",
    "Conductor",
    "Dielectric",
    "Dust",
    "DustLayer",
    "Lambert",
    "MotesError",
    "OrenNayar",
    "Schlick",
    "TorranceSparrow",
]
