"""Pictures through Mitsuba 3: materials as plugins, preview scenes, films, and dust that settles on meshes."""

from motes.rendering import llvm
from motes.rendering.loading import load_mitsuba, load_scene, register, slow_note

llvm.suggest()

__all__ = ["load_mitsuba", "load_scene", "register", "slow_note"]
