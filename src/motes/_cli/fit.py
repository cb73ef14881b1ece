"""``motes fit``: from measured reflectance to a material, numbers with error bars and a report."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from motes._cli.options import Common, Reading, Whole

if TYPE_CHECKING:
    from motes.fitting import Fit
    from motes.measurements import Measurement

NOT_CONVERGED = 1


def fit(
    data: str,
    /,
    *,
    model: Annotated[str, Parameter(name=["--model", "-m"])] = "auto",
    loss: Literal["linear", "plain", "log", "cube_root"] = "linear",
    robust: Literal["none", "soft_l1", "huber", "cauchy"] = "none",
    weights: Literal["measurement", "uniform"] = "measurement",
    fix: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    per_channel: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    time: Whole = 0,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    report: Annotated[bool, Parameter(name="--report")] = True,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008
) -> int:
    """Fit a reflectance model to measured data.

    Writes material.json, fit.json, parameters.csv and report.html, all of them or none.

    Exit status: 0 when the fit converged; 1 when it stopped before that, with the results written and marked so; 2 for
    bad input or usage; 3 for a defect of motes. A parameter that the data do not determine is named in the table and in
    fit.json, and does not change the status.

    Parameters
    ----------
    data
        A file or folder of measurements; the format is found from its content.
    model
        Such as "oren_nayar + torrance_sparrow"; values in brackets are held: "oren_nayar(sigma_d=0.3)". "auto" compares
        several by BIC.
    loss
        What is made small: "linear" is (f - r) cos(theta_i).
    robust
        How far-off samples count less.
    weights
        "measurement": as the format gives them (solid angles); "uniform": all alike.
    fix
        NAME=VALUE: hold a parameter; repeat for more.
    per_channel
        NAME: fit a parameter for each channel that is shared otherwise (K_s of metals); repeat for more.
    time
        Which time of a measurement with several, from 0; -1 is the last.
    output
        The folder of the results; motes-NAME when not given.
    report
        Write report.html.
    """
    from motes._cli.options import assignment
    from motes._cli.paths import slug
    from motes.errors import MotesError

    held = dict(assignment(text, "--fix") for text in fix)
    for name, value in held.items():
        if isinstance(value, str):
            raise MotesError(
                f"--fix {name}={value} is not a number or numbers",
                f"Write --fix {name}=0.3, or --fix {name}=0.7,0.6,0.5",
            )
    measurement = load_measurement(data, reading, common)
    folder = Path(output) if output is not None else Path(f"motes-{slug(measurement.name)}")
    options = {
        "model": model,
        "loss": loss,
        "robust": robust,
        "weights": weights,
        "fixed": held,
        "per_channel": per_channel,
    }
    return fit_and_write(measurement, time, folder, report, options, common)


def load_measurement(data: str, reading: Reading, common: Common) -> Measurement:
    """The measurement at a path; other things that Motes reads are an error that names the right command."""
    from motes._cli.console import progress
    from motes._cli.paths import existing, material_at
    from motes.errors import DataError
    from motes.measurements import Measurement, read

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
    time: int,
    folder: Path,
    report: bool,
    options: dict[str, Any],
    common: Common,
    truth: dict[str, Any] | None = None,
) -> int:
    """Fit one time, write the results, print them; returns the exit status.

    `truth` holds the true parameters of simulated data.
    """
    from motes._cli import console, paths
    from motes.errors import DataError, MissingExtraError
    from motes.fitting import fit

    n = measurement.n_times
    if not -n <= time < n:
        raise DataError(f"--time {time} is not among the {n} time(s) of the data", f"Choose 0 to {n - 1}")
    index = time % n
    with paths.results(folder) as staging:
        with console.progress(common, "fitting") as step:
            result = fit(measurement, time=index, progress=step, **options)
        result.save(staging)
        if report:
            try:
                with console.progress(common, "writing the report"):
                    result.report(staging / "report.html")
            except MissingExtraError as error:
                console.warn(f"no report.html: {error}")
        names = sorted(file.name for file in staging.iterdir())
    if common.json:
        files = {name: str(folder / name) for name in names}
        times = {"index": index, "of": n, "at": float(measurement.times[index]), "unit": measurement.time_unit}
        console.print_json({**result.to_dict(), "time": times, "truth": truth, "folder": str(folder), "files": files})
    elif not common.quiet:
        _show(result, measurement, index, folder, names, truth)
    if not result.status.ok:
        console.warn(f"the fit did not converge ({result.status}); its numbers are not to be trusted")
        return NOT_CONVERGED
    return 0


def _show(
    result: Fit, measurement: Measurement, index: int, folder: Path, names: list[str], truth: dict[str, Any] | None
) -> None:
    from motes._cli import console
    from motes._cli.tables import parameter_table, verdict_notes

    one, n = result.measurement, measurement.n_times
    channels = f"{one.n_channels} channel{'s' if one.n_channels > 1 else ''}"
    rows = [("data", f"{measurement.name}: {one.n_directions} directions, {channels}")]
    if n > 1:
        at = "" if measurement.time_unit == "scan" else f" (at {measurement.times[index]:.4g} {measurement.time_unit})"
        rows.append(("time", f"{index}{at} of {n}, 0 to {n - 1}; each is fitted alone, choose with --time"))
    compared = f"  (the best of {len(result.tried)} by BIC)" if len(result.tried) > 1 else ""
    rows.append(("model", result.model_text + compared))
    console.print_facts(rows)
    print()
    console.print_table(parameter_table(result, truth))
    print()
    masked = sum(one.masked.values())
    reasons = "; ".join(f"{count} {reason}" for reason, count in one.masked.items())
    loss = result.loss + ("" if result.robust == "none" else f", {result.robust}")
    effort = f"{result.n_starts} start{'s' if result.n_starts > 1 else ''}, {result.seconds:.2f} s"
    rows = verdict_notes(result)
    rows += [
        ("relative RMS", f"{100 * result.metrics['relative_rms']:.2f} %, unweighted (the loss was {loss})"),
        ("masked", f"{masked} of {one.mask.size} samples: {reasons}" if masked else f"none of {one.mask.size} samples"),
        ("status", f"{result.status} ({effort})"),
        ("written", f"{folder}/: {', '.join(names)}"),
    ]
    if "report.html" in names:
        rows.append(("look at", str(folder / "report.html")))
    console.print_facts(rows)
