"""Triangle meshes: files, shapes, subdivision."""
