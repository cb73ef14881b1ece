"""Materials for other programs: shaders, documents and tables, printed from the equations."""

from motes.exports.targets import SURFACES, TARGETS, TEXTURES, Exported, Target, export, target_named

__all__ = ["SURFACES", "TARGETS", "TEXTURES", "Exported", "Target", "export", "target_named"]
