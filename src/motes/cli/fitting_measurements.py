"""What ``motes fit`` and ``motes demo`` do with measurements: fit, write, print."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from motes.cli.options import Common, Reading, time_of
from motes.cli.statuses import DONE, NOT_CONVERGED

if TYPE_CHECKING:
    from motes.fitting import Fit
    from motes.fitting.time_result import TimeFit
    from motes.measurements import Measurement

Row = tuple[str, str]


def load_measurement(data: str, reading: Reading, common: Common) -> Measurement:
    """The measurement at a path; other things that Motes reads are an error that names the right command."""
    from motes.cli.console import progress
    from motes.errors import DataError
    from motes.files.finding import existing
    from motes.measurements import Measurement, read
    from motes.presets import material_at

    path = existing(data)
    with progress(common, f"reading {path.name}"):
        measured = None if material_at(path) else read(path, **reading.options())
    if not isinstance(measured, Measurement):
        raise DataError(
            f"{data} holds fitted parameters already, not measured reflectance", f"motes info {data} shows them"
        )
    return measured


def fit_and_write(
    measurement: Measurement,
    time: int | None,
    folder: Path,
    report: bool,
    options: dict[str, Any],
    common: Common,
    truth: dict[str, Any] | None = None,
    kinds: dict[str, str] | None = None,
) -> int:
    """Fit one time, or the trends over all of them, write the results, print them; returns the exit status.

    `truth` holds what is true of simulated data, `kinds` the kinds of trend that are settled.
    """
    from motes.cli import console, invocation
    from motes.errors import MissingExtraError
    from motes.files import together
    from motes.fitting import fit
    from motes.fitting.time_result import TimeFit

    index, why = _which(measurement, time, kinds or {})
    if index is None:
        options = {**options, "trends": kinds or "auto"}
    before = _held_before(folder)
    with together(folder) as staging:
        with console.progress(common, "fitting") as step:
            result = fit(measurement, time=index, progress=step, **options)
        result = result.made_by(invocation.command())
        result.save(staging)
        if report:
            try:
                with console.progress(common, "writing the report"):
                    result.report(staging / "report.html")
            except MissingExtraError as error:
                console.warn(f"no report.html: {error}")
        names = sorted(file.name for file in staging.iterdir())
    for note in _about_times(measurement) if index is None else ():
        console.warn(note)
    if before is not None and (earlier := _other_fit(before, result)):
        console.warn(f"{folder}/ held the fit of {earlier}, which this one has replaced; -o OTHER keeps both")
    if common.json:
        about: dict[str, Any] = {
            "truth": truth,
            "folder": str(folder),
            "files": {name: str(folder / name) for name in names},
        }
        if index is not None:
            at = float(measurement.times[index])
            about["time"] = {"index": index, "of": measurement.n_times, "at": at, "unit": measurement.time_unit}
        console.print_json({**result.to_dict(), **about})
    elif not common.quiet:
        rows = [("written", f"{folder}/: {', '.join(names)}")]
        if "report.html" in names:
            rows.append(("look at", str(folder / "report.html")))
        if isinstance(result, TimeFit):
            _show_trends(result, truth, rows)
        else:
            _show(result, measurement, index or 0, why, truth, rows)
    if not result.status.ok:
        console.warn(f"the fit did not converge ({result.status}); its numbers are not to be trusted")
        return NOT_CONVERGED
    return DONE


def _which(measurement: Measurement, time: int | None, kinds: dict[str, str]) -> tuple[int | None, str]:
    """The one time that is fitted alone and why, or None for trends over all of them."""
    import numpy as np

    from motes.errors import DataError

    n = measurement.n_times
    index = time_of(time, n, kinds)
    if index is not None:
        return index, "fitted alone; without --time all are fitted, with trends" if n > 1 else ""
    usable = np.flatnonzero(measurement.mask.any(axis=(1, 2)))
    if n > 1 and len(usable) == 1:
        return int(usable[0]), "the only scan with usable samples: fitted alone, since a trend needs two"
    if n == 1:
        series = measurement.provenance.get("format") == "tvbrdf"
        return 0, "one scan only: fitted alone, since a trend needs several" if series else ""
    if not len(usable):
        reasons = ", ".join(f"{count} {reason}" for reason, count in measurement.masked.items())
        raise DataError(
            f"none of the {measurement.mask.size} samples in {n} scans is usable: {reasons}", "motes info says more"
        )
    return None, ""


def _held_before(folder: Path) -> dict[str, Any] | None:
    """What the fit.json of a folder says; None where there is none to be read."""
    import json

    try:
        found = json.loads((folder / "fit.json").read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) and isinstance(found.get("measurement"), dict) else None


def _other_fit(before: dict[str, Any], result: Fit | TimeFit) -> str:
    """What an earlier fit was of, where it was another than this one: of other data or times, by another model or loss; else empty."""
    after = result.to_dict()
    then, now = before["measurement"], after["measurement"]
    if Path(str(then.get("path"))).resolve() != Path(str(now.get("path"))).resolve() or then.get("sample") != now.get(
        "sample"
    ):
        sample = then.get("sample")
        return str(then.get("path")) if sample is None else f"{then.get('path')}, sample {sample}"
    if then.get("times") != now.get("times"):
        return "other times"
    for name, words in (("model", "by {}"), ("loss", "with the loss {}"), ("robust", "with the robust function {}")):
        if before.get(name) != after[name]:
            return f"the same data {words.format(before.get(name))}"
    return ""


def _about_times(measurement: Measurement) -> list[str]:
    """Warnings on times that are not known."""
    if measurement.time_unit != "scan":
        return []
    notes = [str(note) for note in measurement.provenance.get("notes") or () if "time" in str(note).lower()]
    return [f"{note} with --read times=0,0.5,1" for note in notes] or ["the times of the scans are not known"]


def _show(
    result: Fit, measurement: Measurement, index: int, why: str, truth: dict[str, Any] | None, written: list[Row]
) -> None:
    from motes.cli import console
    from motes.cli.printed_tables import parameter_table, verdict_notes

    one, n = result.measurement, measurement.n_times
    rows = [("data", f"{measurement.name}: {_size(one)}"), *_taken_for(one)]
    if n > 1:
        at = "" if measurement.time_unit == "scan" else f" (at {measurement.times[index]:.4g} {measurement.time_unit})"
        rows.append(("time", f"{index}{at} of {n}, 0 to {n - 1}; {why}"))
    elif why:
        rows.append(("time", why))
    rows.append(("model", _model(result)))
    console.print_facts(rows)
    print()
    console.print_table(parameter_table(result, truth))
    print()
    effort = f"{result.n_starts} start{'s' if result.n_starts > 1 else ''}, {result.seconds:.2f} s"
    found = [("finding", text) for text in result.findings]
    console.print_facts([*verdict_notes(result), *found, *_ending(result, effort), *written])


def _show_trends(result: TimeFit, truth: dict[str, Any] | None, written: list[Row]) -> None:
    from motes.cli import console
    from motes.cli.printed_tables import coefficient_table, trend_notes, trend_table

    data = result.measurement
    first, last = (f"{result.hours[k]:.4g}" for k in (0, -1))
    span = f"scan {first} to {last}" if data.time_unit == "scan" else f"{first} to {last} {data.time_unit}"
    rows = [
        ("data", f"{data.name}: {data.n_times} scans, {span}; {_size(data)}"),
        *_taken_for(data),
        ("model", _model(result)),
    ]
    console.print_facts(rows)
    print()
    console.print_table(trend_table(result, truth))
    if truth:
        print()
        console.print_table(coefficient_table(result, truth))
    print()
    coefficients = f"{int(result.metrics['n_coefficients'])} coefficients, {result.seconds:.2f} s"
    console.print_facts([*trend_notes(result), *_ending(result, coefficients), *written])


def _taken_for(data: Measurement) -> list[Row]:
    """What the columns of a table were taken for, what the data were divided by, and that simulated data are simulated."""
    from motes.measurements.origin import not_measured, over_scale

    columns = data.provenance.get("columns")
    said, scale = not_measured(data.provenance), over_scale(data.provenance)
    rows = [("columns", "; ".join(map(str, columns)))] if columns else []
    if scale:
        rows.append(("scale", f"the data, {scale}"))
    return [*rows, *([("source", said)] if said else [])]


def _size(data: Measurement) -> str:
    return f"{data.n_directions} directions, {data.n_channels} channel{'s' if data.n_channels > 1 else ''}"


def _model(result: Fit | TimeFit) -> str:
    own = next((trial.per_channel for trial in result.tried if trial.chosen), ())
    each = f", {', '.join(own)} for each channel" if own else ""
    return result.model_text + each + (f"  (chosen of {len(result.tried)})" if len(result.tried) > 1 else "")


def _ending(result: Fit | TimeFit, effort: str) -> list[Row]:
    data = result.measurement
    masked = sum(data.masked.values())
    reasons = "; ".join(f"{count} {reason}" for reason, count in data.masked.items())
    loss = result.loss + ("" if result.robust == "none" else f", {result.robust}")
    of = f"{data.mask.size} samples"
    chi = result.metrics.get("reduced_chi_square")
    return [
        ("relative RMS", f"{100 * result.metrics['relative_rms']:.2f} %, unweighted (the loss was {loss})"),
        *(
            [("chi-square", f"{chi:.3g} for each degree of freedom, by the data's uncertainties")]
            if chi is not None
            else []
        ),
        ("errors", str(result.errors)),
        ("masked", f"{masked} of {of}: {reasons}" if masked else f"none of {of}"),
        ("status", f"{result.status} ({effort})"),
    ]
