"""``motes info``: what a file is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from motes._cli.options import Common, Reading

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
    """Say what a file holds: measurements, parameter maps or a material.

    Format and source, sizes, angles, channels, times, what is masked and why; the samples of a container; the model and
    parameters of a material.

    Parameters
    ----------
    data
        A file or folder: measurements, a material.json, or the folder that motes fit wrote.
    """
    from motes._cli import console
    from motes._cli.paths import existing, material_at
    from motes.measurements import list_samples, read

    path = existing(data)
    if file := material_at(path):
        from motes.material import load

        material = load(file)
        if common.json:
            console.print_json({"kind": "material", "path": str(file), **material.to_dict()})
        elif not common.quiet:
            _show_material(material)
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
        summary = read(path, **options).summary()
        rows = _maps(summary) if "mean" in summary else _measurement(summary)
    if common.json:
        console.print_json(summary)
    elif not common.quiet:
        console.print_facts(rows)
    return 0


def _show_material(material: Material) -> None:
    from motes._cli import console
    from motes._cli.tables import model_table
    from motes.models import describe

    rows = [("kind", "material"), ("name", material.name), ("model", describe(material.brdf))]
    if len(material.channels) > 1:
        rows.append(("channels", _list(list(material.channels))))
    console.print_facts(rows)
    print()
    console.print_table(model_table(material.brdf))
    rows = [(key, _text(value)) for key, value in material.about.items() if isinstance(value, (str, int, float))]
    if rows:
        print()
        console.print_facts(rows)


def _measurement(summary: dict[str, Any]) -> list[Row]:
    """The summary of a measurement."""
    s = summary
    channels = f"{s['n_channels']} channel{'s' if s['n_channels'] > 1 else ''}"
    times = f"{s['n_times']} time{'s' if s['n_times'] > 1 else ''}"
    rows = _heads(s)
    rows += [("size", f"{s['n_directions']} directions x {channels} x {times}"), ("channels", _list(s["channels"]))]
    if s["n_times"] > 1:
        rows.append(("times", f"{_list([f'{t:.4g}' for t in s['times']])} {s['time_unit']}"))
    for key, label in (("theta_i_deg", "theta_i"), ("theta_r_deg", "theta_r")):
        rows.append((label, f"{s[key][0]:.1f} to {s[key][1]:.1f} degrees"))
    if s["f_r"]:
        rows.append(("f_r", f"{s['f_r'][0]:.4g} to {s['f_r'][1]:.4g} 1/sr, median {s['f_r_median']:.4g}"))
    masked = "".join(f"\n{count} masked: {reason}" for reason, count in s["masked"].items())
    rows.append(("usable", f"{s['n_usable']} of {s['n_samples']} samples{masked}"))
    rows.append(("weights", "solid angles" if s["weighted"] else "all alike"))
    return rows + _rest(s)


def _maps(summary: dict[str, Any]) -> list[Row]:
    """The summary of maps of parameters that change with time."""
    s = summary
    rows = _heads(s)
    rows.append(("size", f"{s['shape'][1]} x {s['shape'][0]} texels"))
    for name, form in s["maps"].items():
        rows.append((f"map {name}", f"polynomial of time of degree {form['degree']}, {form['channels']} channel(s)"))
    rows.append(("times", "  ".join(f"{t:7.4g}" for t in s["times"])))
    for name, means in s["mean"].items():
        rows.append((f"mean {name}", "  ".join(f"{mean:7.4f}" for mean in means)))
    return rows + _rest(s)


def _heads(summary: dict[str, Any]) -> list[Row]:
    return [(key, str(summary[key])) for key in ("kind", "name", "format", "source") if summary.get(key)]


#: What the rows above say already.
_SAID = frozenset(
    "kind name format source n_times n_directions n_channels channels wavelengths_nm times time_unit theta_i_deg theta_r_deg f_r f_r_median "
    "n_samples n_usable masked weighted shape maps mean notes".split()
)


def _rest(summary: dict[str, Any]) -> list[Row]:
    """What else a reader tells of its format, and its notes."""
    rows = [(key.replace("_", " "), _text(v)) for key, v in summary.items() if key not in _SAID and v not in (None, "", [], {})]
    notes = summary.get("notes") or ()
    return rows + ([("notes", "\n".join(str(note) for note in notes))] if notes else [])


def _list(items: list[str], most: int = 8) -> str:
    return ", ".join(items) if len(items) <= most else f"{', '.join(items[: most - 1])}, .. {items[-1]} ({len(items)} in all)"


def _text(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list):
        return _list([_text(v) for v in value], 12)
    if isinstance(value, dict):
        return ", ".join(f"{key} {_text(v)}" for key, v in value.items())
    return str(value)
