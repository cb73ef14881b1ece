"""Triangle meshes: files, shapes, subdivision."""

from motes.meshes.mesh import Mesh
from motes.meshes.meshfile import read_mesh
from motes.meshes.ply import write_ply

__all__ = ["Mesh", "read_mesh", "write_ply"]
