"""What a text names that stands where a material is wanted: the one place that decides it.

In this order: what exists on the disk; a preset; a model with its values.  A file that is called like a preset goes before it.
"""

from __future__ import annotations

import difflib
import os
import re
from pathlib import Path

from motes.channels import default_names
from motes.errors import DataError, MotesError
from motes.files import reading, settle
from motes.files.finding import existing, exists, near
from motes.material import Material, load
from motes.measurements import bird
from motes.models import BRDF, parse, registered
from motes.presets.shelf import PRESETS

LONGEST_NAME = 80
_SUFFIX = re.compile(r".*\.[A-Za-z]\w*")


def material_at(path: Path) -> Path | None:
    """The file of the material at a path, where it holds one: a JSON file, or the folder that ``motes fit`` wrote.

    A JSON file of measured data (BiRD) is none.
    """
    settle(path if path.is_dir() else path.parent)  # what a fit that was killed had decided to write
    file = path / "material.json" if path.is_dir() else path
    if file.suffix.lower() != ".json" or not file.is_file():
        return None
    try:
        return None if bird.sniff(file, reading.head(file)) else file
    except OSError:  # whoever opens it says why not
        return file


def given(text: str) -> Material | Path:
    """The material that a text names; where it names what exists and is no material (data, a map), its path.

    Raises
    ------
    MotesError
        When it names nothing; the hint says what it was probably meant to be.
    """
    if exists(text):
        path = existing(text)
        file = material_at(path)
        return path if file is None else load(file)
    if text in PRESETS:
        return PRESETS[text].material()
    # No model's text has a slash, or ends like a file; one without brackets and plus is a name alone.
    if not text.strip() or os.sep in text or "/" in text or _SUFFIX.fullmatch(text):
        return existing(text)
    if not {"(", "+"} & set(text) and text not in registered(BRDF):
        raise _nothing(text)
    brdf = parse(text).model
    name = text if len(text) <= LONGEST_NAME else f"{text[: LONGEST_NAME - 3]}..."
    return Material(brdf, name, default_names(brdf.channels or 1), about={"source": "a model's text"})


def named(text: str) -> Material:
    """The material that a text names: a ``material.json``, a folder of ``motes fit``, a preset, or a model with its values.

    Raises
    ------
    MotesError
        When it names nothing, or something else; the hint says what to write.

    Examples
    --------
    >>> named("oren_nayar(K_d=0.8, sigma_d=0.4)").brdf.parameters
    {'K_d': 0.8, 'sigma_d': 0.4}
    >>> named("gold").channels
    ('R', 'G', 'B')
    """
    found = given(text)
    if isinstance(found, Material):
        return found
    if found.is_dir():
        raise DataError(f"{text} holds no material.json", f"motes fit {text} makes one from measured data")
    return load(found)


def _nothing(word: str) -> MotesError:
    """The error for a name that nothing has."""
    known = [*PRESETS, *registered(BRDF)]
    close = [
        *near(Path(word)),
        *difflib.get_close_matches(word.strip().lower().replace("-", "_").replace(" ", "_"), known, n=3, cutoff=0.6),
    ]
    hint = f"Did you mean {' or '.join(close[:4])}?" if close else "motes material --list lists presets and models"
    return MotesError(f"{word} is no file or folder, no preset and no model", hint)
