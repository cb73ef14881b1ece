"""``motes plan``: which directions to measure."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from motes.cli.options import Common, Whole
from motes.errors import MotesError


def plan(
    *,
    model: Annotated[str, Parameter(name=["--model", "-m"])] = "oren_nayar + torrance_sparrow",
    rig: str = "tvbrdf",
    count: Annotated[Whole, Parameter(name=["--count", "-n"])] = 12,
    minutes: float | None = None,
    prior: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    goal: str = "parameters",
    measured: str | None = None,
    noise: float | None = None,
    floor: float = 1e-4,
    rival: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    check: float = 0.15,
    repeats: Annotated[bool, Parameter(negative="")] = False,
    when: str | None = None,
    hours: str | None = None,
    scanned: str | None = None,
    output: Annotated[str, Parameter(name=["--output", "-o"])] = "plan.csv",
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Plan a measurement: which directions tell most of a material, and in what order to go through them.

    Writes a table for the lab book (NAME.csv), the same with all that is expected as JSON (NAME.json), and a picture of the hemisphere (NAME.svg).

    Parameters
    ----------
    model
        The model whose parameters are to be found; values in brackets are known, such as "oren_nayar(sigma_d=0.3)".
    rig
        What can be measured: tvbrdf, hemisphere, in_plane, a file rig.toml, or measured data, whose directions it is.
    count
        How many shots to measure: directions, or lamp positions of a rig whose cameras record together.
    minutes
        How long the measurement may take, readings and moves, in place of a count; of a rig.toml with its costs.
    prior
        What the material may be: typical (all that real materials span), catalogue (the presets), or a material; repeat for more.
    goal
        parameters, curve (the reflectance over the hemisphere), or the name of one parameter, such as tau.
    measured
        What is measured already: the plan goes on from its fit.
    noise
        Relative standard deviation of a reading; that of the measured data when not given, else 0.02.
    floor
        Standard deviation of a reading that does not go with its value, in f cos(theta_i).
    rival
        A model to be told from this one; repeat for more. A highlight or dust where the model has none when not given; none for none.
    check
        The share of shots that lie where a wrong model would be caught.
    repeats
        A direction may be measured more than once.
    when
        A material that changes, such as that of a fit to the scans so far: when to scan it, not where; COUNT is how many scans.
    hours
        FIRST,LAST: between which hours scans can be made; those of the trends when not given.
    scanned
        Hours of scans that are made already, such as 0,1,2.5.
    output
        The table to write, NAME.csv; NAME.json and NAME.svg lie beside it.
    """
    from motes.cli import console, paths
    from motes.cli.statuses import DONE
    from motes.planning import plan as planned
    from motes.planning import plan_times
    from motes.planning.planner import USUAL_NOISE

    table = Path(output)
    if table.suffix.lower() != ".csv":
        raise MotesError(f"{table} is no table by its name", "Write -o NAME.csv")
    if when is not None:
        schedule = plan_times(
            paths.material_of(when),
            count=count,
            hours=_pair(hours),
            rig=rig,
            scanned=_hours(scanned, "--scanned"),
            goal=goal,
            noise=USUAL_NOISE if noise is None else noise,
            floor=floor,
        )
        written = [
            schedule.table(table),
            schedule.save(table.with_suffix(".json")),
            schedule.picture(table.with_suffix(".svg")),
        ]
        if common.json:
            console.print_json({**schedule.to_dict(), "files": [str(file) for file in written]})
        elif not common.quiet:
            console.print_facts(
                [
                    *schedule.summary(),
                    *(("note", said) for said in schedule.findings),
                    *(("written", str(file)) for file in written),
                ]
            )
        return DONE
    for option, given in (("--hours", hours), ("--scanned", scanned)):
        if given is not None:
            raise MotesError(f"{option} {given} is for planning times", "Name what changes by --when material.json")
    design = planned(
        model,
        rig,
        count=count,
        prior=prior[0] if len(prior) == 1 else prior or "typical",
        goal=goal,
        measured=measured,
        noise=noise,
        floor=floor,
        rivals="auto" if not rival else rival[0] if len(rival) == 1 else rival,
        check=check,
        repeats=repeats,
        minutes=minutes,
    )
    written = [design.table(table), design.save(table.with_suffix(".json")), design.picture(table.with_suffix(".svg"))]
    if common.json:
        console.print_json({**design.to_dict(), "files": [str(file) for file in written]})
    elif not common.quiet:
        console.print_facts(design.summary())
        expected = console.Table(box=None)
        for header in ("parameter", "expected error", "to the even choice", "to all", "verdict"):
            expected.add_column(header)
        for row in design.expected_rows():
            expected.add_row(*row)
        console.print_table(expected)
        console.print_facts([*(("note", said) for said in design.findings), *(("written", str(f)) for f in written)])
    return DONE


def _hours(text: str | None, option: str) -> list[float]:
    """Hours between commas."""
    try:
        return [] if text is None else [float(hour) for hour in text.split(",")]
    except ValueError:
        raise MotesError(f"{option} {text} is no list of hours", f"Write {option} 0,1,2.5") from None


def _pair(text: str | None) -> tuple[float, float] | None:
    given = _hours(text, "--hours")
    if text is None:
        return None
    if len(given) != 2:
        raise MotesError(f"--hours {text} is no pair of hours", "Write --hours 0,48")
    return given[0], given[1]
