"""Measured reflectance: `Measurement`, `ParameterMaps`, `TabulatedMaps`, and one reader a format."""

from motes.measurements.measurement import Measurement
from motes.measurements.parameter_maps import ParameterMaps
from motes.measurements.registry import READERS, Reader, list_samples, read
from motes.measurements.tabulated_maps import TabulatedMaps

__all__ = ["READERS", "Measurement", "ParameterMaps", "Reader", "TabulatedMaps", "list_samples", "read"]
