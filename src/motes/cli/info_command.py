"""``motes info``: what a file is."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from motes.cli.options import Common, Reading

if TYPE_CHECKING:
    from motes.material import Material

Row = tuple[str, str]


def info(
    data: str,
    /,
    *,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008
) -> int:
    """Say what a file holds: measurements, a reflectance map, parameter maps or a material.

    Format and source, sizes, angles, channels, times, what is masked and why; the samples of a container; the model and
    parameters of a material.

    Parameters
    ----------
    data
        A file or folder: measurements, a material.json, the folder that motes fit wrote, a preset or a model
        with its values, or a map (Zarr).
    """
    from motes.cli import console
    from motes.cli.paths import is_map
    from motes.files.finding import exists
    from motes.material import Material
    from motes.measurements import Measurement, list_samples, read
    from motes.measurements.doubts import implausible
    from motes.presets import given, material_at

    path = given(data)
    if is_map(data):
        return _map(data, common)
    if isinstance(path, Material):
        if common.json:
            file = {"path": str(material_at(Path(data)))} if exists(data) else {}
            console.print_json({"kind": "material", **file, **path.to_dict()})
        elif not common.quiet:
            show_material(path)
        return 0
    options = reading.options()
    samples = list_samples(path, format=options.get("format"))
    if len(samples) > 1 and reading.sample is None:
        summary = {"kind": "container", "path": str(path), "n_samples": len(samples), "samples": samples}
        rows = [
            ("kind", f"container of {len(samples)} samples"),
            ("samples", ", ".join(samples)),
            ("next", f"motes info {data} --sample {samples[0]}"),
        ]
    else:
        with console.progress(common, f"reading {path.name}"):
            found = read(path, **options)
        summary = found.summary()
        if isinstance(found, Measurement):
            summary["findings"] = list(implausible(found))
        rows = _measurement(summary) if isinstance(found, Measurement) else _maps(summary)
    if common.json:
        console.print_json(summary)
    elif not common.quiet:
        console.print_facts(rows)
    return 0


def show_material(material: Material) -> None:
    """Print what a material is: its model, its parameters, their course, and where they come from."""
    from motes.cli import console
    from motes.cli.printed_tables import material_trends, model_table
    from motes.models import describe

    rows = [("kind", "material"), ("name", material.name), ("model", describe(material.brdf))]
    if len(material.channels) > 1:
        rows.append(("channels", _list(list(material.channels))))
    if material.interval:
        first, last = material.interval
        rows.append(("times", f"{first:.4g} to {last:.4g} h; beyond them trends extrapolate"))
    console.print_facts(rows)
    still = [slot.name for slot in material.brdf.slots() if slot.name not in material.trends]
    if material.trends:
        print()
        console.print_table(material_trends(material))
    if still:
        print()
        console.print_table(model_table(material.brdf, material.trends))
    rows = [(key, _text(value)) for key, value in material.about.items() if isinstance(value, (str, int, float))]
    for step in material.about.get("ageing") or ():
        if isinstance(step, dict):
            source = f" from {step['source']}" if step.get("source") else ""
            rows.append(("aged", f"{step.get('phenomenon')}{source}, {_text(step.get('hours'))} h"))
    if rows:
        print()
        console.print_facts(rows)


def _measurement(summary: dict[str, Any]) -> list[Row]:
    """The summary of a measurement."""
    s = dict(summary)  # what is said is taken out; the rest is listed after it
    rows = _heads(s)
    n_times, n_channels, times, unit = s.pop("n_times"), s.pop("n_channels"), s.pop("times"), s.pop("time_unit")
    size = f"{s.pop('n_directions')} directions x {_count(n_channels, 'channel')} x {_count(n_times, 'time')}"
    rows += [("size", size), ("channels", _list(s.pop("channels")))]
    s.pop("wavelengths_nm")  # the names of the channels say them
    if n_times > 1:
        rows.append(("times", f"{_list([f'{t:.4g}' for t in times])} {unit}"))
    for label in ("theta_i", "theta_r"):
        low, high = s.pop(f"{label}_deg")
        rows.append((label, f"{low:.1f} to {high:.1f} degrees"))
    f_r, median = s.pop("f_r"), s.pop("f_r_median")
    if f_r:
        rows.append(("f_r", f"{f_r[0]:.4g} to {f_r[1]:.4g} 1/sr, median {median:.4g}"))
    masked = "".join(f"\n{count} masked: {reason}" for reason, count in s.pop("masked").items())
    rows.append(("usable", f"{s.pop('n_usable')} of {s.pop('n_samples')} samples{masked}"))
    rows.append(("weights", "solid angles" if s.pop("weighted") else "all alike"))
    rows += _uncertainties(s.pop("uncertainties"), s.pop("common_uncertainty"))
    findings = [("finding", text) for text in s.pop("findings")]
    columns = s.pop("columns", None)
    if columns:
        rows.append(("columns", "\n".join(columns)))
    return rows + _rest(s) + findings


def _uncertainties(facts: dict[str, Any] | None, common: float | None) -> list[Row]:
    """Those of the samples, and that of their scale."""
    parts = []
    if facts and facts["n_samples"]:
        low, high = facts["range"]
        relative = facts["relative_median"]
        share = "" if relative is None else f", typically {relative:.1%} of the value"
        parts.append(f"{low:.3g} to {high:.3g} 1/sr (one standard deviation){share}")
    if common is not None:
        parts.append(f"{common:.1%} of the scale, common to all samples")
    return [("uncertainty", "\n".join(parts))] if parts else []


def _maps(summary: dict[str, Any]) -> list[Row]:
    """The summary of maps of parameters that change with time."""
    s = dict(summary)
    rows = _heads(s)
    height, width = s.pop("shape")
    rows.append(("size", f"{width} x {height} texels"))
    for name, form in s.pop("maps").items():
        channels = _count(form["channels"], "channel")
        rows.append((f"map {name}", f"polynomial of time of degree {form['degree']}, {channels}"))
    rows.append(("times", "  ".join(f"{t:7.4g}" for t in s.pop("times"))))
    for name, means in s.pop("mean").items():
        rows.append((f"mean {name}", "  ".join(f"{mean:7.4f}" for mean in means)))
    return rows + _rest(s)


def _heads(s: dict[str, Any]) -> list[Row]:
    return [(key, str(s.pop(key))) for key in ("kind", "name", "format", "source") if s.get(key)]


def _rest(s: dict[str, Any]) -> list[Row]:
    """What else a reader tells of its format, and its notes."""
    notes = "\n".join(str(note) for note in s.pop("notes", None) or ())
    rows = [(key.replace("_", " "), _text(v)) for key, v in s.items() if v not in (None, "", [], {})]
    return [*rows, ("notes", notes)] if notes else rows


def _count(n: int, what: str) -> str:
    return f"{n} {what}{'' if n == 1 else 's'}"


def _list(items: list[str], most: int = 8) -> str:
    if len(items) <= most:
        return ", ".join(items)
    return f"{', '.join(items[: most - 1])}, .. {items[-1]} ({len(items)} in all)"


def _text(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list):
        return _list([_text(v) for v in value], 12)
    if isinstance(value, dict):
        return ", ".join(f"{key} {_text(v)}" for key, v in value.items())
    return str(value)


def _map(data: str, common: Common) -> int:
    """What a map holds."""
    from motes.cli import console
    from motes.cli.printed_maps import show_fitted, stack_rows
    from motes.maps import FittedMap, open_map

    found = open_map(data)
    summary = found.summary()
    if common.json:
        console.print_json(summary)
    elif not common.quiet:
        if isinstance(found, FittedMap):
            show_fitted(found, summary, {}, [])
        else:
            console.print_facts(stack_rows(summary))
    return 0
