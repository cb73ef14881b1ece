"""Materials for other programs: shaders, documents and tables, printed from the equations."""

from motes.exports.targets import TARGETS, Exported, Target, export

__all__ = ["TARGETS", "Exported", "Target", "export"]
