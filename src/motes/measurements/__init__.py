"""Measured reflectance: `Measurement`, `ParameterMaps`, and one reader a format."""

from motes.measurements.measurement import Measurement
from motes.measurements.parameter_maps import ParameterMaps
from motes.measurements.registry import READERS, Reader, list_samples, read

__all__ = ["READERS", "Measurement", "ParameterMaps", "Reader", "list_samples", "read"]
