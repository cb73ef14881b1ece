"""``motes stack``: pictures under known lights to a reflectance map."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from motes.cli.options import Common, Whole


def stack(
    folder: str,
    /,
    *,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    table: str | None = None,
    linear: Annotated[bool, Parameter(negative="")] = False,
    transfer: str | None = None,
    layer: str | None = None,
    chunk: Whole = 64,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Turn a folder of pictures under known lights into a reflectance map (Zarr), which motes fit fits.

    A CSV table in the folder has a row a picture: file, the direction to the light (theta_i_deg, phi_i_deg, or wi_x, wi_y,
    wi_z), the direction to the viewer where it is not straight above (theta_r_deg, phi_r_deg, or wo_x, wo_y, wo_z), time,
    exposure, irradiance. The BRDF is pixel / (exposure x irradiance x cos(theta_i)).

    Parameters
    ----------
    folder
        The pictures, OpenEXR, PNG, TIFF or JPEG, and the table.
    output
        The Zarr store to write; NAME.zarr when not given.
    table
        The CSV, where the folder holds several.
    linear
        The pictures hold linear values, whatever they say of themselves.
    transfer
        linear, srgb or an exponent such as 2.2: what the numbers are, where a picture does not say it or says it wrongly.
    layer
        The layer of OpenEXR pictures that have several, such as ViewLayer.Combined, or one of their channels.
    chunk
        Texels along a side of a chunk.
    """
    from motes.cli import console, paths
    from motes.cli.printed_maps import stack_rows
    from motes.errors import MotesError
    from motes.files.finding import existing
    from motes.maps import import_images

    source = existing(folder)
    if chunk < 1:
        raise MotesError(f"--chunk {chunk} is below 1", "64 is a good size")
    out = Path(output) if output is not None else Path(f"{paths.slug(source.resolve().name)}.zarr")
    with console.progress(common, "pictures") as step:
        made = import_images(
            source, out, table=table, linear=linear, transfer=transfer, layer=layer, chunk=chunk, progress=step
        )
    if common.json:
        console.print_json(made.summary())
    elif not common.quiet:
        console.print_facts([*stack_rows(made.summary()), ("written", str(out)), ("next", f"motes fit {out}")])
    return 0
