"""``motes export``: a material for another program."""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from motes.cli.options import Common

# The keys of motes.exports.TARGETS, which --help must not load; a test compares.
To = Literal["glsl", "wgsl", "hlsl", "osl", "c", "materialx", "mitsuba", "three", "merl", "csv"]


def export(
    material: str,
    /,
    *,
    to: To,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    hours: Annotated[str | None, Parameter()] = None,
    glsl_version: Literal["300 es", "450"] | None = None,
    scalar: Literal["double", "float"] | None = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Write a material for another program: a shader, a document, a table.

    What the program cannot express is said in the file and here.

    Parameters
    ----------
    material
        A material.json, or the folder that motes fit wrote.
    to
        The program or language.
    output
        The file to write; a name made of the material's when not given. Some targets write further files beside it.
    hours
        The moment of a material that follows time, its first one when not given; a csv takes several, such as 0,1,2.5.
    glsl_version
        Of GLSL: "300 es" (WebGL 2, the default) or 450.
    scalar
        Of C: double (the default) or float.
    """
    from motes.cli import console, paths
    from motes.exports import TARGETS
    from motes.exports import export as write

    options = {name: value for name, value in (("version", glsl_version), ("scalar", scalar)) if value is not None}
    source = paths.material_of(material)
    done = write(source, to, output, hours=_hours(hours), **options)
    if common.json:
        console.print_json({"to": to, "files": [str(file) for file in done.files], "notes": list(done.notes)})
    elif not common.quiet:
        rows = [("material", source.name), ("target", TARGETS[to].title)]
        rows += [("note", note) for note in done.notes]
        console.print_facts([*rows, *(("written", str(file)) for file in done.files)])
    return 0


def _hours(text: str | None) -> list[float] | None:
    """``2.5`` or ``0,1,2.5``."""
    from motes.errors import MotesError

    if text is None:
        return None
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise MotesError(
            f"--hours {text!r} is not a number or numbers", "Write --hours 2.5, or --hours 0,1,2.5"
        ) from None
