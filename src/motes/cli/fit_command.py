"""``motes fit``: from measured reflectance to a material, numbers with error bars and a report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter

from motes.cli.options import Common, MaybeWhole, Reading


def fit(
    data: str,
    /,
    *,
    model: Annotated[str, Parameter(name=["--model", "-m"])] = "auto",
    models: str | None = None,
    loss: Literal["linear", "plain", "log", "cube_root"] = "linear",
    robust: Literal["none", "soft_l1", "huber", "cauchy"] = "none",
    weights: Literal["measurement", "uniform"] = "measurement",
    errors: Literal["auto", "blocks", "independent", "bootstrap", "profile"] = "auto",
    fix: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    per_channel: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    time: MaybeWhole = None,
    trend: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    max_theta_deg: float | None = None,
    scale: str | None = None,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    report: Annotated[bool, Parameter(name="--report")] = True,
    workers: MaybeWhole = None,
    scheduler: str | None = None,
    block: MaybeWhole = None,
    exr: str | None = None,
    covariance: Annotated[bool, Parameter(negative="")] = False,
    restart: Annotated[bool, Parameter(negative="")] = False,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008
) -> int:
    """Fit a reflectance model to measured data.

    Data of several times give trends: each parameter as a function of time, fitted to all scans together.

    Writes material.json, fit.json, parameters.csv and report.html, all of them or none.

    A Zarr store of reflectance at every texel of a surface gives maps of parameters as another Zarr store, and a page of
    pictures beside it; every time is fitted alone unless --trend is given. The same command goes on after an interrupt.

    Exit status: 0 when the fit converged; 1 when it stopped before that, with the results written and marked so, or when
    a part of a map could not be read; 2 for bad input or usage; 3 for a defect of motes. A parameter that the data do not
    determine is named in the table and in fit.json, and does not change the status.

    Parameters
    ----------
    data
        A file or folder of measurements, or a map (Zarr); the format is found from its content.
    model
        Such as "oren_nayar + torrance_sparrow"; values in brackets are held: "oren_nayar(sigma_d=0.3)". "auto" compares
        several by how they predict directions left out.
    models
        Two or more, with commas between them: a table of them beside each other in place of one fit. Writes comparison.json
        and comparison.html.
    loss
        What is made small: "linear" is (f - r) cos(theta_i).
    robust
        How far-off samples count less.
    weights
        "measurement": as the format gives them (solid angles); "uniform": all alike.
    errors
        What error bars take as independent: "blocks" of directions, or "independent" samples; "auto": blocks, unless the
        data are simulated or state uncertainties, and the residuals of neighbours do not go together. "bootstrap": by
        fits to blocks that are drawn; "profile": intervals by the profile likelihood.
    fix
        NAME=VALUE: hold a parameter; repeat for more.
    per_channel
        NAME: fit a parameter for each channel that is shared otherwise (K_s of metals); repeat for more.
    time
        Fit one time of several alone, from 0; -1 is the last. All of them, with trends, when not given.
    trend
        NAME=KIND: settle the kind of a parameter's trend (constant, linear, exponential, logistic, quadratic, cubic,
        monotone_spline); repeat for more. The others are chosen by BIC.
    max_theta_deg
        Leave out samples with theta_i or theta_r beyond this [degrees].
    scale
        What the data are divided by, 1 where they are a BRDF in 1/sr; "fit" where nobody knows it: it becomes a parameter, and K_d stays at 1 or
        below. Not of maps.
    output
        The folder of the results; motes-NAME when not given.
    report
        Write report.html; of a map the page of pictures.
    workers
        Of a map: fit on so many processes of one thread each.
    scheduler
        Of a map: fit on the workers of a Dask scheduler, such as tcp://127.0.0.1:8786.
    block
        Of a map: texels along a side of what is fitted and saved at a time; whole chunks of the store when not given.
    exr
        Of a map: a folder for polynomials of time as OpenEXR pictures (STAF layout).
    covariance
        Of a map: keep the covariance matrices of the fits besides.
    restart
        Of a map: throw away what an earlier run left in the output.
    """
    import math

    from motes.cli.options import assignments, numbers
    from motes.cli.paths import is_map, slug
    from motes.errors import MotesError

    held = numbers(fix, "--fix")
    kinds = {name: str(kind) for name, kind in assignments(trend, "--trend").items()}
    if kinds:
        from motes.trends import KINDS

        for name, kind in kinds.items():
            if kind not in KINDS:
                raise MotesError(
                    f"--trend {name}={kind}: that is not a kind of trend", f"Choose one of {', '.join(KINDS)}"
                )
    if max_theta_deg is not None and not 0 < max_theta_deg <= 90:
        raise MotesError(
            f"--max-theta-deg {max_theta_deg:g} is outside (0, 90] degrees", "80 leaves out grazing angles"
        )
    if is_map(data):
        if models is not None:
            raise MotesError(
                "--models is for measurements, and this is a map", "--model auto compares models on some texels"
            )
        if scale is not None:
            raise MotesError(
                "--scale is for measurements, and this is a map",
                "Divide by it when the map is made: exposure of motes stack",
            )
        if errors not in ("auto", "independent"):
            raise MotesError(
                f"--errors {errors} is not for maps: their errors are over independent samples",
                "Leave it out, or fit one texel as a measurement",
            )
        from motes.cli.fitting_maps import fit_map

        return fit_map(
            data,
            reading=reading,
            output=output,
            report=report,
            exr=exr,
            common=common,
            model=model,
            loss=loss,
            robust=robust,
            time=time,
            covariance=covariance,
            weights=weights,
            fixed=held,
            per_channel=per_channel,
            trends=kinds or None,
            max_theta=None if max_theta_deg is None else math.radians(max_theta_deg),
            workers=workers,
            scheduler=scheduler,
            block=None if block is None else (block, block),
            restart=restart,
        )
    _only_for_maps(
        workers=workers,
        scheduler=scheduler,
        block=block,
        exr=exr,
        covariance=covariance or None,
        restart=restart or None,
    )
    from motes.cli.fitting_measurements import fit_and_write, load_measurement

    if models is not None:
        _one_time(model=model != "auto", trend=bool(kinds), scale=scale is not None, errors=errors != "auto")
    measurement = load_measurement(data, reading, common)
    folder = Path(output) if output is not None else Path(f"motes-{slug(measurement.name)}")
    options: dict[str, Any] = {
        "model": model,
        "loss": loss,
        "robust": robust,
        "weights": weights,
        "fixed": held,
        "per_channel": per_channel,
        "max_theta": None if max_theta_deg is None else math.radians(max_theta_deg),
        "scale": 1.0 if scale is None else _scale(scale),
        "errors": errors,
    }
    if models is not None:
        from motes.cli.comparing import compare_and_write, split_models

        own = {name: value for name, value in options.items() if name not in ("model", "scale", "errors")}
        return compare_and_write(measurement, split_models(models), time, folder, report, own, common)
    return fit_and_write(measurement, time, folder, report, options, common, kinds=kinds)


def _one_time(**given: bool) -> None:
    """Refuse options that a comparison of models does not take."""
    from motes.errors import MotesError

    for name, said in given.items():
        if said:
            raise MotesError(f"--{name} does not go with --models, which compares models at one time", "Leave it out")


def _only_for_maps(**options: Any) -> None:
    """Refuse options that only a map has."""
    from motes.errors import MotesError

    for name, value in options.items():
        if value is not None:
            raise MotesError(f"--{name} is for maps, and this is not a Zarr store", "Leave it out")


def _scale(text: str) -> float | str:
    """``fit``, or a number."""
    from motes.errors import MotesError

    if text == "fit":
        return text
    try:
        return float(text)
    except ValueError:
        raise MotesError(f"--scale {text!r} is not a number, or fit", "Write --scale 3.1416, or --scale fit") from None
