"""Reflectance maps: a fit at every texel, chunk by chunk, on one machine or many."""

from motes.maps.fitted import FittedMap, open_fitted
from motes.maps.making import whole
from motes.maps.momentary import Moment, moment
from motes.maps.photographs import import_images
from motes.maps.run import fit_map
from motes.maps.simulated import simulate_map
from motes.maps.stack import MapStack, create_map, open_stack
from motes.maps.staf_layout import export_exr
from motes.maps.zarrs import is_store, kind_of

__all__ = [
    "FittedMap",
    "MapStack",
    "Moment",
    "create_map",
    "export_exr",
    "fit_map",
    "import_images",
    "is_store",
    "moment",
    "open_map",
    "simulate_map",
    "whole",
]


def open_map(path: object) -> MapStack | FittedMap:
    """A map at a path: a `MapStack` of measured reflectance, or the `FittedMap` that `fit_map` wrote.

    Raises
    ------
    FormatError
        When it is neither.
    """
    return open_fitted(path) if kind_of(path) == "fitted" else open_stack(path)
