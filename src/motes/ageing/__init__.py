"""Reflectance that changes with time: phenomena, their transfer to other materials, and the rig that measures them."""

from motes.ageing.phenomena import PHENOMENA
from motes.ageing.phenomenon import Phenomenon
from motes.ageing.plaster import drying_plaster
from motes.ageing.rig import Rig, simulate
from motes.ageing.rust import rusting_material
from motes.ageing.transfer import age

__all__ = ["PHENOMENA", "Phenomenon", "Rig", "age", "drying_plaster", "rusting_material", "simulate"]
