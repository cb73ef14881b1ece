"""The study of mirrors that gather dust at real sites: readings, the dust on one mirror, and sites of many."""

from motes.soiling.mirrors import Reset, Soiling, fit_soiling, slant
from motes.soiling.readings import Series, read_soiling
from motes.soiling.sites import Growth, cleanings, growth

__all__ = ["Growth", "Reset", "Series", "Soiling", "cleanings", "fit_soiling", "growth", "read_soiling", "slant"]
