"""Functions out of files that a command line names, ``FILE.py:FUNCTION``, ``.c`` or ``.glsl``: they are run, so nobody else may be able to write them."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

from motes.certification.c_specimen import of_c
from motes.certification.function_specimen import of_function
from motes.certification.glsl_specimen import of_glsl
from motes.certification.specimen import Specimen
from motes.errors import FormatError, MotesError
from motes.files.trust import distrusted

LARGEST_SOURCE = 2**20
_NAMED = re.compile(r"(?P<file>.+\.(?P<kind>py|c|h|glsl|frag|fs)):(?P<function>[A-Za-z_]\w*)")


def opened(text: str, parameters: Mapping[str, Any], cosine: bool) -> Specimen | None:
    """The function that a text names; None where it names none.

    Beside ``FUNCTION`` a Python file may have ``FUNCTION_sample``, ``FUNCTION_pdf`` and ``FUNCTION_gradient``.

    Raises
    ------
    FormatError
        When the file cannot be read or run, or has no such function.
    MotesError
        When others could have written the file.
    """
    named = _NAMED.fullmatch(text)
    if named is None:
        return None
    path, function = Path(named["file"]), named["function"]
    source = source_of(path)
    if named["kind"] != "py":
        of_source = of_c if named["kind"] in ("c", "h") else of_glsl
        return of_source(path, source, function, parameters, cosine)
    module = _run(path)
    found = {part: getattr(module, f"{function}{part}", None) for part in ("", "_sample", "_pdf", "_gradient")}
    if not callable(found[""]):
        have = [name for name, value in vars(module).items() if callable(value) and not name.startswith("_")]
        raise FormatError(f"{path} has no function {function!r}", f"It has {', '.join(have) or 'none'}")
    return of_function(
        found[""],
        name=function,
        sample=found["_sample"],
        pdf=found["_pdf"],
        gradient=found["_gradient"],
        parameters=parameters,
        cosine=cosine,
        source=source,
    )


def source_of(path: Path) -> str:
    """The text of a source file that is going to be run.

    Raises
    ------
    FormatError
        When it cannot be read, is too large or no text.
    MotesError
        When others could have written it.
    """
    try:
        if path.stat().st_size > LARGEST_SOURCE:
            raise FormatError(
                f"{path} has more than {LARGEST_SOURCE} bytes, which no function needs",
                "Give the path of a source file",
            )
        reason = distrusted(path.parent, [path])
        text = path.read_text(encoding="utf-8")
    except OSError as error:
        raise FormatError(
            f"{path} cannot be read: {error.strerror or error}", "Give the path of a source file"
        ) from error
    except FormatError:
        raise
    except ValueError:
        raise FormatError(f"{path} is not text", "Give the path of a source file") from None
    if reason is not None:
        raise MotesError(f"{path} would be run, and {reason}", "Copy it to a folder that is yours alone")
    return text


def _run(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"_certified_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise FormatError(f"{path} is no Python file", "Its name ends in .py")
    module = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise FormatError(
            f"{path} fails when it is run: {type(error).__name__}: {str(error)[:200]}", "Run it alone first"
        ) from error
    return module
