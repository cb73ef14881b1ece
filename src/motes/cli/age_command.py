"""``motes age``: something happens to a material."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter

from motes.cli.options import Common


def age(
    material: str,
    /,
    *,
    phenomenon: Annotated[str, Parameter(name=["--phenomenon", "-p"])],
    from_: Annotated[str | None, Parameter(name="--from")] = None,
    hours: float | None = None,
    given: Literal["start", "end"] | None = None,
    dust: str | None = None,
    scattering: Literal["single", "multiple"] | None = None,
    set: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Let something happen to a material: paint dries, dust settles, iron rusts.

    Writes a material whose parameters follow time, which motes info, motes simulate and motes.load read. With --from
    the course is that of a fitted material, carried over; without, the default of the phenomenon.

    Parameters
    ----------
    material
        A material.json, a folder of motes fit, a preset or a model such as "oren_nayar(K_d=0.8)".
    phenomenon
        What happens: drying_paint, drying_surface, dust or rusting.
    from_
        A material that motes fit found over several scans, whose course is taken over.
    hours
        How long it takes; the time of the source when not given.
    given
        Whether the material is what it is before ("start") or what comes out ("end"). By default the end for drying,
        the start for dust and rust.
    dust
        What the dust is made of, for w and g by published optics: desert, desert_coarse, sahara, mountain, soil, soot, volcanic_ash, mars or
        snow.
    scattering
        How light goes in the dust: as often as it is scattered ("multiple"), or once as in the source ("single"). By default that of the layer
        that is there, else multiple.
    set
        NAME=VALUE: an option of the phenomenon, such as tau_growth=1; repeat for more.
    output
        The file to write; NAME-PHENOMENON.json when not given.
    """
    from motes.ageing import age as happen
    from motes.cli import console, paths
    from motes.cli.options import numbers
    from motes.cli.printed_tables import material_trends
    from motes.errors import MotesError
    from motes.models import describe
    from motes.models.dust_optics import dust_optics

    options = numbers(set, "--set")
    clash = [name for name in ("hours", "source", "given", "scattering") if name in options]
    if clash:
        raise MotesError(f"--set {clash[0]} is not an option of a phenomenon", f"Write --{clash[0]} instead")
    source = None if from_ is None else paths.material_of(from_)
    target, optics = paths.material_of(material), None
    if dust is not None:
        optics = dust_optics(dust)
        if phenomenon != "dust":
            raise MotesError(f"--dust {dust} does not go with --phenomenon {phenomenon}", "Write --phenomenon dust")
        other = "--from" if source else next((f"--set {name}" for name in ("w", "g") if name in options), None)
        if other:
            raise MotesError(f"both --dust and {other} say what the dust is", "Give one of them")
        options["w"], options["g"] = optics.values(target.channels, target.wavelengths)
    if scattering is not None:
        options["scattering"] = scattering
    aged = happen(target, phenomenon, hours=hours, source=source, given=given, **options)
    file = Path(output) if output is not None else Path(f"{paths.slug(aged.name)}.json")
    if file.is_dir():
        raise MotesError(f"{file} is a folder", f"Name a file, such as -o {file / 'aged.json'}")
    aged.save(file)
    step: dict[str, Any] = aged.about["ageing"][-1]
    if common.json:
        console.print_json({"path": str(file), "ageing": step, **aged.to_dict()})
    elif not common.quiet:
        first, last = step["hours"]
        course = f", as in {source.name}" if source else ""
        rows = [
            ("material", f"{aged.name}: {describe(aged.brdf)}"),
            (
                "what happens",
                f"{phenomenon.replace('_', ' ')}{course}, {first:g} to {last:g} h; at the {step['given']} it is as given",
            ),
        ]
        if optics is not None:
            rows.append(("dust", f"{optics.words}: {optics.source}"))
        console.print_facts(rows)
        print()
        console.print_table(material_trends(aged))
        print()
        console.print_facts([*(("note", note) for note in step["notes"]), ("written", str(file))])
    return 0
