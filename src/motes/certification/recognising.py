"""From whatever is given to a `Specimen`."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from motes.certification.fitted_reference import reference_by_model
from motes.certification.function_specimen import of_function
from motes.certification.mitsuba_specimen import PREFIX, of_mitsuba
from motes.certification.model_specimen import of_model
from motes.certification.specimen import Specimen
from motes.certification.table_specimen import of_file, of_measurement
from motes.errors import FormatError, MotesError
from motes.files import reading
from motes.material import LARGEST_FILE, Material, load
from motes.measurements import Measurement, bird
from motes.models import BRDF, describe, parse


def specimen_of(
    subject: Any,
    *,
    sample: Callable[..., Any] | None = None,
    pdf: Callable[..., Any] | None = None,
    gradient: Callable[..., Any] | None = None,
    parameters: Mapping[str, Any] | None = None,
    cosine: bool = False,
    name: str = "",
    hours: float | None = None,
) -> Specimen:
    """See `motes.certify`, whose arguments these are."""
    if isinstance(subject, Specimen):
        found = subject
    elif (
        isinstance(subject, Mapping)
        or type(subject).__module__.split(".")[0] == "mitsuba"
        or hasattr(subject, "eval_pdf")
    ):
        found = of_mitsuba(subject)
    elif callable(subject) and not isinstance(subject, (BRDF, str, os.PathLike)):
        return of_function(
            subject, name=name, sample=sample, pdf=pdf, gradient=gradient, parameters=parameters, cosine=cosine
        )
    else:
        found = _of_value(subject, hours)
    given = (("sample", sample), ("pdf", pdf), ("gradient", gradient), ("parameters", parameters), ("cosine", cosine))
    for word, value in given:
        if value:
            raise MotesError(f"{word} was given, and {found.name} is no function", f"Leave {word} out")
    return replace(found, name=name) if name else found


def _of_value(subject: Any, hours: float | None) -> Specimen:
    if isinstance(subject, Material):
        return of_model(subject, hours)
    if isinstance(subject, Measurement):
        return of_measurement(subject)
    if isinstance(subject, BRDF):
        return of_model(Material(subject, name=describe(subject)))
    if isinstance(subject, (str, os.PathLike)):
        text = os.fspath(subject)
        path = Path(text)
        if path.is_dir() and (path / "material.json").is_file():
            path = path / "material.json"
        if _there(path):
            return _of_path(path, hours)
        if text.startswith(PREFIX):
            return of_mitsuba({"type": text.removeprefix(PREFIX)})
        return _of_text(text)
    raise MotesError(
        f"{type(subject).__name__} is nothing that can be certified",
        "Give a material, a model, the path of a file, or a function f(wi, wo)",
    )


def _there(path: Path) -> bool:
    try:
        return path.exists()
    except (OSError, ValueError):  # a name too long for a file, which a model may be
        return False


def _of_path(path: Path, hours: float | None) -> Specimen:
    suffix = path.suffix.lower() if path.is_file() else ""
    if suffix == ".xml" and re.search(rb"<(bsdf|scene)\b", reading.head(path, 65536)):
        return of_mitsuba(path)
    if suffix == ".json" and not bird.sniff(path, reading.head(path, 4096)):
        return of_mitsuba(path) if _describes_a_bsdf(path) else of_model(load(path), hours)
    return of_file(path)


def _of_text(text: str) -> Specimen:
    try:
        return of_model(Material(parse(text).model, name=text))
    except MotesError as error:
        if re.search(r"[/\\]|\.\w{1,12}$", text) and "(" not in text:
            raise FormatError(
                f"{text[:200]} does not exist", "Give the path of a file, a model or FILE.py:FUNCTION"
            ) from error
        raise


def _describes_a_bsdf(path: Path) -> bool:
    """Whether a JSON file is a dictionary for Mitsuba; `load` says what is wrong with any other."""
    try:
        data = json.loads(path.read_text(encoding="utf-8")) if path.stat().st_size <= LARGEST_FILE else None
    except (OSError, ValueError, RecursionError):
        return False
    return isinstance(data, dict) and "type" in data and "format" not in data


def reference_of(specimen: Specimen, as_model: str | None, against: Any) -> Specimen | None:
    """What the specimen should be."""
    if against is not None:
        return specimen_of(against)
    if as_model is None:
        return None
    return reference_by_model(specimen, as_model)
