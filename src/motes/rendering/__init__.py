"""Pictures through Mitsuba 3: materials as plugins, preview scenes, films, and dust that settles on meshes."""

from motes.rendering import _llvm
from motes.rendering.mitsuba_ import load_mitsuba, load_scene, register, slow_note

_llvm.suggest()

__all__ = ["load_mitsuba", "load_scene", "register", "slow_note"]
