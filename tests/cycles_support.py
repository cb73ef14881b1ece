"""How the scripts that Blender's Python executes draw: by Cycles, light that comes straight from lamps, each pixel its own middle."""

from __future__ import annotations

from typing import Any


def drawn_by_cycles(scene: Any, side: int) -> None:
    """A picture of `side` pixels as OpenEXR; the same wherever it is drawn."""
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", 4
    scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
    scene.cycles.max_bounces = 0
    scene.cycles.pixel_filter_type, scene.cycles.filter_width = "BOX", 0.01
    scene.render.resolution_x = scene.render.resolution_y = side
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
