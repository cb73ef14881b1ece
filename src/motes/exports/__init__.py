"""Materials for other programs: shaders, documents and tables, printed from the equations."""

from motes.exports.targets import SURFACES, TARGETS, Exported, Target, export, target_named

__all__ = ["SURFACES", "TARGETS", "Exported", "Target", "export", "target_named"]
