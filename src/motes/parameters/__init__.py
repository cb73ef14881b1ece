"""Parameters of models: how they are declared, and objects that have some."""

from motes.parameters.fields import Option, Parameter, PartField, Place, Role, option, parameter, part
from motes.parameters.parametrised import Parametrised, Slot

__all__ = ["Option", "Parameter", "Parametrised", "PartField", "Place", "Role", "Slot", "option", "parameter", "part"]
