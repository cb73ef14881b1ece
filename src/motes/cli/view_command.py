"""``motes view``: a page to look at a material, a fit or measured data."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from motes.cli.options import Common, Reading

if TYPE_CHECKING:
    from motes.measurements import Measurement

LARGEST_FIT = 64 * 2**20


def view(
    subject: str,
    /,
    *,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    against: str | None = None,
    data: str | None = None,
    model: Annotated[str, Parameter(name=["--model", "-m"])] = "auto",
    open_: Annotated[bool | None, Parameter(name="--open")] = None,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008
) -> int:
    """Write a page to look at a material, a fit, a fitted map or measured data, and open it.

    One self-contained HTML file that asks the network for nothing: the material on a sphere, teapot, bunny or mesh of one's own,
    its lobe, sliders for its parameters, its course in time, measured points over it. Measured data are fitted first.

    Parameters
    ----------
    subject
        A material.json, a folder of motes fit, a preset, a model such as "oren_nayar(K_d=0.8)", measured data, or a map that motes fit wrote.
    output
        The file to write; NAME-view.html when not given.
    against
        A second material to compare, of any of these but data.
    data
        Measured data to show over the material; of a fit its own where they are still there.
    model
        What measured data are fitted with, as of motes fit.
    open_
        Open the page in the browser; by default on a terminal.
    """
    import sys

    from motes.cli import console, paths
    from motes.files.finding import exists
    from motes.material import Material
    from motes.presets import given
    from motes.viewer import view as look

    if paths.is_map(subject):
        return _view_map(subject, output, against or data, open_, common)
    notes: list[str] = []
    fitted: dict[str, Any] | None = None
    points = _read(data, reading, common) if data is not None else None
    found, beside = given(subject), Path(subject) / "fit.json"
    fit_is_there = exists(subject) and beside.is_file()
    what: Any
    if isinstance(found, Material) or fit_is_there:
        what = paths.material_of(subject) if isinstance(found, Path) else found
        if fit_is_there:
            fitted = _fit_json(beside)
            if points is None:
                points = _own_data(fitted, Path(subject), notes)
    else:
        what = _fit(_read(subject, reading, common), model, common)
    second = None if against is None else paths.material_of(against)
    shown = look(what, second, data=points, notes=tuple(notes), fitted=fitted)
    name = shown.materials[0].name
    target = Path(output or f"{paths.slug(name)}-view.html")
    opened = open_ if open_ is not None else console.on_terminal(sys.stdout) and not common.json
    written = shown.open(target) if opened else shown.save(target)
    size = written.stat().st_size
    held = shown.payload["measurement"]
    if common.json:
        console.print_json(
            {
                "materials": [material.name for material in shown.materials],
                "points": held["count"] if held else 0,
                "notes": shown.payload["notes"],
                "file": str(written),
                "bytes": size,
            }
        )
    elif not common.quiet:
        rows = [("material", material.name) for material in shown.materials]
        if held:
            rows.append(("points", f"{held['count']:,} pairs of directions, {len(held['hours'])} scans"))
        rows += [("note", note) for note in shown.payload["notes"]]
        console.print_facts([*rows, ("written", f"{written} ({size / 1e6:.2f} MB)")])
    return 0


def _view_map(subject: str, output: str | None, other: str | None, open_: bool | None, common: Common) -> int:
    """The page of a fitted map."""
    import sys

    from motes.cli import console, paths
    from motes.errors import DataError, MotesError
    from motes.maps import FittedMap, open_map
    from motes.viewer import view as look

    if other is not None:
        raise MotesError(f"a map is shown alone, without {other}", "Leave out --against and --data")
    found = open_map(subject)
    if not isinstance(found, FittedMap):
        raise DataError(
            f"{subject} holds measured reflectance, not fitted parameters", f"motes fit {subject} fits every texel"
        )
    with console.progress(common, "reading the map"):
        shown = look(found)
    target = Path(output or f"{paths.slug(found.name)}-view.html")
    opened = open_ if open_ is not None else console.on_terminal(sys.stdout) and not common.json
    written = shown.open(target) if opened else shown.save(target)
    rows, columns = shown.payload["shape"]
    size = written.stat().st_size
    if common.json:
        facts = {"map": found.name, "shape": [rows, columns], "step": shown.payload["step"]}
        console.print_json({**facts, "notes": shown.payload["notes"], "file": str(written), "bytes": size})
    elif not common.quiet:
        notes = [("note", note) for note in shown.payload["notes"]]
        texels = ("texels", f"{columns} x {rows}, {len(found.hours)} times, {len(shown.payload['layers'])} maps")
        console.print_facts([("map", found.name), texels, *notes, ("written", f"{written} ({size / 1e6:.2f} MB)")])
    return 0


def _read(path: str, reading: Reading, common: Common) -> Measurement:
    from motes.cli import console
    from motes.errors import DataError
    from motes.files.finding import existing
    from motes.measurements import Measurement, read

    with console.progress(common, f"reading {Path(path).name}"):
        found = read(existing(path), **reading.options())
    if not isinstance(found, Measurement):
        raise DataError(
            f"{path} holds maps of parameters: a material for every texel",
            "motes info says what they hold",
        )
    return found


def _fit(data: Measurement, model: str, common: Common) -> Any:
    from motes.cli import console
    from motes.fitting import fit

    with console.progress(common, f"fitting {data.name}") as progress:
        return fit(data, model=model, progress=progress)


def _fit_json(path: Path) -> dict[str, Any] | None:
    """What motes fit wrote beside the material; None when it cannot be read, for the material can be shown without."""
    import json

    try:
        if path.stat().st_size > LARGEST_FIT:
            return None
        found = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) else None


def _where(path: str, digest: object, folder: Path) -> str:
    """Where the data of a fit are.

    A relative path is of the folder that `motes fit` ran in, which is most often that of the results or one above; a file there is taken only
    when its bytes are those that were fitted.
    """
    import hashlib

    if Path(path).is_absolute():
        return path
    for base in (Path(), *folder.resolve().parents):
        candidate = base / path
        try:
            if candidate.is_file() and isinstance(digest, str):
                with candidate.open("rb") as file:
                    if hashlib.file_digest(file, "sha256").hexdigest() == digest:
                        return str(candidate)
            elif candidate.exists() and (base == Path() or not isinstance(digest, str)):
                return str(candidate)
        except OSError:
            continue
    return path


def _own_data(fitted: dict[str, Any] | None, folder: Path, notes: list[str]) -> Measurement | None:
    """The data that a fit was made of, read again where they still are."""
    from motes.errors import MotesError
    from motes.measurements import Measurement, read

    about = (fitted or {}).get("measurement")
    if not isinstance(about, dict) or not isinstance(about.get("path"), str):
        return None
    options: dict[str, Any] = {key: str(about[key]) for key in ("sample", "format") if about.get(key)}
    if isinstance(about.get("options"), dict):  # of the reader, as they were given then
        options = {**about["options"], **options}
    try:
        found = read(_where(about["path"], (fitted or {}).get("sha256_of_file"), folder), **options)
    except (MotesError, OSError, TypeError, ValueError):
        notes.append("The measured data of this fit are not where they were; --data shows them over the material.")
        return None
    if not isinstance(found, Measurement):
        return None
    if isinstance(scale := about.get("scale"), float) and 0 < scale < math.inf:
        found = found.rescaled(scale)
    times = about.get("times")
    if isinstance(times, list) and len(times) < found.n_times:  # one scan of several was fitted
        index = [k for k, t in enumerate(found.times) if t in times]
        found = found.at(index[0]) if len(index) == 1 else found
    return found
