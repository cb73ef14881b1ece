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
from motes.certification.opened import opened
from motes.certification.specimen import Specimen
from motes.certification.table_specimen import of_file, of_measurement
from motes.errors import MotesError
from motes.files import reading
from motes.files.finding import exists
from motes.material import LARGEST_FILE, Material
from motes.measurements import Measurement
from motes.models import BRDF, describe
from motes.presets import given


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
    if isinstance(subject, str) and (function := opened(subject, parameters or {}, cosine)) is not None:
        return replace(function, name=name) if name else function
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
    passed = (("sample", sample), ("pdf", pdf), ("gradient", gradient), ("parameters", parameters), ("cosine", cosine))
    for word, value in passed:
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
        if exists(text) and _is_bsdf_file(Path(text)):
            return of_mitsuba(Path(text))
        if not exists(text) and text.startswith(PREFIX):
            return of_mitsuba({"type": text.removeprefix(PREFIX)})
        found = given(text)
        return of_model(found, hours) if isinstance(found, Material) else of_file(found)
    raise MotesError(
        f"{type(subject).__name__} is nothing that can be certified",
        "Give a material, a model, the path of a file, or a function f(wi, wo)",
    )


def _is_bsdf_file(path: Path) -> bool:
    """Whether a file holds a BSDF of Mitsuba, as XML or JSON."""
    suffix = path.suffix.lower() if path.is_file() else ""
    if suffix == ".xml":
        return re.search(rb"<(bsdf|scene)\b", reading.head(path, 65536)) is not None
    return suffix == ".json" and _describes_a_bsdf(path)


def _describes_a_bsdf(path: Path) -> bool:
    """Whether a JSON file is a dictionary for Mitsuba; whoever reads it as a material says what is wrong with any other."""
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
