"""Motes: reflectance that changes with time, from measurement to picture.

Names are imported when first used, so that ``import motes`` is light and ``motes --help`` answers at once.  As the one file that knows all
rooms, it also says which of them writes the pages that results are handed to (`motes.outlets`).  No other file imports it.
"""

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING

from motes import outlets
from motes.version import __version__

if TYPE_CHECKING:
    from motes.certification import certify
    from motes.errors import MotesError
    from motes.fitting import Fit, fit
    from motes.fitting.conversion import convert
    from motes.fitting.model_table import Comparison, compare
    from motes.material import Material, load
    from motes.measurements import Measurement, read
    from motes.models import (
        BRDF,
        EON,
        GGX,
        GTR,
        Beckmann,
        CoatedDiffuse,
        Conductor,
        Dielectric,
        Dust,
        DustLayer,
        Hapke,
        Lambert,
        OrenNayar,
        Retro,
        Schlick,
        Sheen,
        TorranceSparrow,
    )
    from motes.planning import Design, Schedule, plan, plan_times
    from motes.viewer.viewing import View, view

_HOMES = {
    "certify": "certification",
    "MotesError": "errors",
    "Fit": "fitting",
    "Comparison": "fitting.model_table",
    "compare": "fitting.model_table",
    "convert": "fitting.conversion",
    "fit": "fitting",
    "Material": "material",
    "load": "material",
    "Measurement": "measurements",
    "read": "measurements",
    "BRDF": "models",
    "EON": "models",
    "GGX": "models",
    "GTR": "models",
    "Beckmann": "models",
    "CoatedDiffuse": "models",
    "Conductor": "models",
    "Dielectric": "models",
    "Dust": "models",
    "DustLayer": "models",
    "Hapke": "models",
    "Lambert": "models",
    "OrenNayar": "models",
    "Retro": "models",
    "Schlick": "models",
    "Sheen": "models",
    "TorranceSparrow": "models",
    "Design": "planning",
    "plan": "planning",
    "plan_times": "planning",
    "Schedule": "planning",
    "View": "viewer",
    "view": "viewer",
}

outlets.offer("fit", "motes.report.fit_page", "write_report")
outlets.offer("fit over time", "motes.report.time_page", "write_time_report")
outlets.offer("certificate", "motes.report.certificate_page", "write_certificate")
outlets.offer("comparison", "motes.report.comparison_page", "write_comparison")
outlets.offer("fitted map", "motes.report.map_page", "write_map_page")
outlets.offer_paper("motes.report.paper", "print_page")


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        # The rooms, too: motes.directions, motes.rendering.
        if not name.startswith("_") and find_spec(f"motes.{name}") is not None:
            return import_module(f"motes.{name}")
        raise AttributeError(f"module 'motes' has no attribute {name!r}")
    value = getattr(import_module(f"motes.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})


__all__ = [
    "BRDF",
    "EON",
    "GGX",
    "GTR",
    "Beckmann",
    "CoatedDiffuse",
    "Comparison",
    "Conductor",
    "Design",
    "Dielectric",
    "Dust",
    "DustLayer",
    "Fit",
    "Hapke",
    "Lambert",
    "Material",
    "Measurement",
    "MotesError",
    "OrenNayar",
    "Retro",
    "Schedule",
    "Schlick",
    "Sheen",
    "TorranceSparrow",
    "View",
    "__version__",
    "certify",
    "compare",
    "convert",
    "fit",
    "load",
    "plan",
    "plan_times",
    "read",
    "view",
]
