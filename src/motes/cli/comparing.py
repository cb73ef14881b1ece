"""``motes fit --models a,b,c``: models beside each other in one table."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from motes.cli.options import Common, time_of
from motes.cli.statuses import DONE, NOT_CONVERGED

if TYPE_CHECKING:
    from motes.cli.console import Table
    from motes.fitting.model_table import Comparison
    from motes.measurements import Measurement


def split_models(text: str) -> list[str]:
    """The models of a list with commas; those inside brackets belong to a model."""
    found, depth = [""], 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            found.append("")
        else:
            found[-1] += letter
    return [model.strip() for model in found if model.strip()]


def compare_and_write(
    measurement: Measurement,
    models: list[str],
    time: int | None,
    folder: Path,
    report: bool,
    options: dict[str, Any],
    common: Common,
) -> int:
    """Compare, write comparison.json and comparison.html, print the table; returns the exit status."""
    from motes.cli import console
    from motes.files import together
    from motes.fitting.model_table import compare

    index = time_of(time, measurement.n_times, {})
    with together(folder) as staging:
        with console.progress(common, "comparing") as step:
            found = compare(measurement, models, time=index, progress=step, **options)
        found.save(staging / "comparison.json")
        if report:
            found.report(staging / "comparison.html")
        names = sorted(file.name for file in staging.iterdir())
    if common.json:
        console.print_json({**found.to_dict(), "folder": str(folder)})
    elif not common.quiet:
        console.print_facts([("data", measurement.name), ("dust", DUST[found.dusty])])
        print()
        console.print_table(_table(found))
        print()
        facts = [
            ("relative RMS", "of all samples, unweighted"),
            ("left out", "of blocks of directions that a fit to the others predicts, weighted as the loss weighs"),
            ("sphere", "mean colour difference to the measurement under a lamp at 45 degrees; about 1 is just visible"),
            ("written", f"{folder}/: {', '.join(names)}"),
        ]
        console.print_facts(facts)
    bad = [row.fit.model_text for row in found.rows if not row.fit.status.ok]
    if bad:
        console.warn(f"the fit of {', '.join(bad)} did not converge; its numbers are not to be trusted")
    return NOT_CONVERGED if bad else DONE


DUST = {
    True: "yes: a layer of it predicts directions left out far better than any model without",
    None: "these models do not tell",
    False: "no: no layer predicts directions left out better than the models without",
}


def _table(found: Comparison) -> Table:
    from rich import box

    from motes.cli.console import Table, clean

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("model")
    for heading in ("relative RMS", "left out", "BIC", "sphere dE ITP"):
        table.add_column(heading, justify="right", no_wrap=True)
    for row in found.rows:
        table.add_row(
            clean(row.fit.model_text) + (" *" if row.chosen else ""),
            f"{100 * row.fit.metrics['relative_rms']:.3g} %",
            f"{100 * row.left_out:.3g} %",
            f"+{row.delta_bic:,.0f}" if row.delta_bic else "0",
            f"{row.delta_e:.3g}",
        )
    return table
