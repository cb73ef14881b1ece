"""From whatever is given to a `Specimen`."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from motes.certification.function_specimen import of_function
from motes.certification.mitsuba_specimen import PREFIX, of_mitsuba
from motes.certification.model_specimen import of_model
from motes.certification.specimen import Specimen
from motes.errors import MotesError
from motes.material import LARGEST_FILE, Material, load
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
    if isinstance(subject, BRDF):
        return of_model(Material(subject, name=describe(subject)))
    if isinstance(subject, (str, os.PathLike)):
        text = os.fspath(subject)
        path = Path(text)
        if path.is_dir() and (path / "material.json").is_file():
            path = path / "material.json"
        if path.is_file() and path.suffix.lower() == ".xml":
            return of_mitsuba(path)
        if path.is_file() and path.suffix.lower() == ".json":
            return of_mitsuba(path) if _describes_a_bsdf(path) else of_model(load(path), hours)
        if text.startswith(PREFIX):
            return of_mitsuba({"type": text.removeprefix(PREFIX)})
        if isinstance(subject, str):
            return of_model(Material(parse(subject).model, name=subject))
    raise MotesError(
        f"{type(subject).__name__} is nothing that can be certified",
        "Give a material, a model, the path of a file, or a function f(wi, wo)",
    )


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
    parsed = parse(as_model)
    return of_model(Material(parsed.model, name=as_model))
