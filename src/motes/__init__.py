"""Motes: reflectance that changes with time, from measurement to picture."""

from typing import TYPE_CHECKING

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

if TYPE_CHECKING:
    from motes.fitting import Fit, fit
    from motes.material import Material, load
    from motes.measurements import Measurement, read

__version__ = "0.1.0"

# What reads and fits is imported when first used, so that `import motes` stays light.
_LAZY = {
    "Fit": "motes.fitting",
    "Material": "motes.material",
    "Measurement": "motes.measurements",
    "fit": "motes.fitting",
    "load": "motes.material",
    "read": "motes.measurements",
}


def __getattr__(name: str) -> object:
    if name in _LAZY:
        import importlib

        return getattr(importlib.import_module(_LAZY[name]), name)
    raise AttributeError(f"module 'motes' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_LAZY})


__all__ = [
    "BRDF",
    "Conductor",
    "Dielectric",
    "Dust",
    "DustLayer",
    "Fit",
    "Lambert",
    "Material",
    "Measurement",
    "MotesError",
    "OrenNayar",
    "Schlick",
    "TorranceSparrow",
    "fit",
    "load",
    "read",
]
