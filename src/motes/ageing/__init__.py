"""Reflectance that changes with time: a plaster that dries under dust, and the rig that measures it."""

from motes.ageing.plaster import drying_plaster
from motes.ageing.rig import Rig, simulate

__all__ = ["Rig", "drying_plaster", "simulate"]
