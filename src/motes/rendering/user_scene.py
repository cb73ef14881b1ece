"""A Mitsuba scene of the user's, in which ``$material`` and ``$time`` stand for the material's file and the hours."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MotesError
from motes.rendering.interrupts import interrupt_after
from motes.rendering.loading import native
from motes.rendering.passes import Look, traced

Floats = NDArray[np.floating[Any]]


def user_scene(look: Look, file: Path, plugin: str = "motes_material") -> Callable[[float], Floats]:
    """What draws the scene at a time [h].

    Parameters
    ----------
    look
        Its `scene` is the path of the XML file, which says its own size.
    file
        The material, or the map.
    plugin
        What takes it.

    Raises
    ------
    FormatError
        When the file cannot be read, or has no place for a material.
    """
    from motes.rendering import load_mitsuba

    mi = load_mitsuba()
    path = Path(look.scene)
    try:
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Give the path of a scene") from error
    except ValueError:
        raise FormatError(f"{path} is not text", "Give the path of a Mitsuba scene in XML") from None
    if "$material" not in text or plugin not in text:
        raise FormatError(
            f"{path} has no place for the {'material' if plugin == 'motes_material' else 'map'}",
            f'Write <bsdf type="{plugin}"><string name="filename" value="$material"/><float name="time" value="$time"/></bsdf>',
        )

    def draw(time: float) -> Floats:
        values = {"material": str(file), "time": repr(float(time))}
        try:
            with interrupt_after(mi):
                scene = mi.load_file(
                    native(path), optimize=False, **{k: v for k, v in values.items() if f"${k}" in text}
                )
        except (RuntimeError, TypeError, ValueError) as error:
            lines = [line.strip() for line in str(error).splitlines() if line.strip()]
            raise MotesError(
                f"Mitsuba cannot load {path}: {' '.join(lines[-3:])[:400]}", f"Try it alone first: mitsuba {path}"
            ) from error
        if not hasattr(scene, "sensors") or not scene.sensors():
            raise MotesError(f"{path} has no sensor", "A scene says where its camera is")
        return traced(mi, scene, look)

    return draw
