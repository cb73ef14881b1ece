"""The interpreters that have Blender as the package bpy: `MOTES_BPY` names one or, separated as in PATH, several."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path

#: What to install where none is named.
NEEDED = "MOTES_BPY does not name a Python with the package bpy (pip install 'bpy==5.0.*' 'numpy<2')"


def interpreters() -> list[str]:
    """As they are named; one that is empty where none is."""
    return [path for path in os.environ.get("MOTES_BPY", "").split(os.pathsep) if path] or [""]


def there(python: str) -> bool:
    """Whether it can be run."""
    return bool(python and shutil.which(python))


def version(python: str) -> tuple[int, ...]:
    """Blender's version, by the package beside the interpreter; () where it is not found there."""
    folders = (
        Path(shutil.which(python) or "/nowhere/bin/python")
        .parents[1]
        .glob("lib/python3*/site-packages/bpy-*.dist-info")
    )
    found = [re.match(r"bpy-(\d+)\.(\d+)\.(\d+)", folder.name) for folder in folders]
    return next((tuple(map(int, match.groups())) for match in found if match), ())


def named(python: str) -> str:
    """For a test: Blender 5.0.1."""
    return f"Blender {'.'.join(map(str, version(python)))}" if version(python) else "Blender"
