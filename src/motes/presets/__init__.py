"""Materials that have a name, and what a text that somebody gives names: a file, a folder, a preset or a model with its values."""

from motes.presets.named import given, material_at, named
from motes.presets.shelf import PRESETS, Preset

__all__ = ["PRESETS", "Preset", "given", "material_at", "named"]
