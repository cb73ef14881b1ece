"""``motes simulate``: a material measured by the simulated rig."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from motes.cli.options import Common, MaybeWhole, Whole

if TYPE_CHECKING:
    from motes.ageing.rig import Surface


def simulate(
    folder: str,
    /,
    *,
    material: str | None = None,
    model: Annotated[str | None, Parameter(name=["--model", "-m"])] = None,
    phenomenon: str | None = None,
    set: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    scattering: Literal["single", "multiple"] | None = None,
    scans: Whole = 12,
    hours: float = 6.0,
    noise: float = 0.02,
    seed: Whole = 0,
    step_deg: float = 0.5,
    irradiance: float = 1.0,
    size: MaybeWhole = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Measure a material with a simulated rig of four cameras and a lamp on an arm.

    Writes the folder format of the TVBRDF database (radiance at three exposures merged into one, blue first). With
    --phenomenon something happens to the surface between the first scan and the last. Without --material, --model and
    --phenomenon the surface is a dusty plaster that dries.

    A folder whose name ends in .zarr is a reflectance map instead: a painted surface that dries, other parameters at every
    texel, with the truth beside the values.

    Parameters
    ----------
    folder
        To write; motes fit reads it.
    material
        A material.json, a folder of motes fit, a preset or a model with values.
    model
        A model with values, such as "oren_nayar(K_d=(0.7,0.6,0.5), sigma_d=0.4) + torrance_sparrow(K_s=0.3)"; what is
        not given has its default.
    phenomenon
        What happens meanwhile: drying_paint, drying_surface, dust or rusting; to a surface of its own where none is
        given.
    set
        NAME=VALUE: an option of the phenomenon, such as tau_growth=1; repeat for more.
    scattering
        How light goes in the dust of the phenomenon, or on the plaster: "multiple" when not given, or once as in the source, "single".
    scans
        How many scans.
    hours
        The time of the last scan; the first is at 0.
    noise
        Relative standard deviation of each radiance; 0 also turns off the camera's read noise.
    seed
        Of the noise.
    step_deg
        Between two positions of the lamp, in degrees.
    irradiance
        Of the lamp.
    size
        Of a map: rows and columns of texels, 64 when not given.
    """
    from motes.ageing import Rig
    from motes.ageing import simulate as measure
    from motes.cli import console
    from motes.cli.options import numbers
    from motes.errors import MotesError

    if folder.rstrip("/").endswith(".zarr"):
        given = {
            "--material": material,
            "--model": model,
            "--phenomenon": phenomenon,
            "--set": set or None,
            "--scattering": scattering,
        }
        return _simulate_map(folder, size, scans, hours, noise, seed, [o for o, v in given.items() if v], common)
    if size is not None:
        raise MotesError("--size is for maps", "Give a folder whose name ends in .zarr")
    surface, name, process = _surface(material, model, phenomenon, numbers(set, "--set"), scattering, hours)
    rig, dust = Rig(step_deg=step_deg, irradiance=irradiance), _scattering(surface)
    with console.progress(common, "simulating") as step:
        measure(
            folder,
            surface,
            scans=scans,
            hours=hours,
            noise=noise,
            seed=seed,
            rig=rig,
            name=name,
            process=process,
            progress=step,
        )
    records = scans * len(rig.wi) * len(rig.wo)
    if common.json:
        facts: dict[str, Any] = {
            "folder": folder,
            "name": name,
            "process": process,
            "scattering": dust,
            "scans": scans,
            "cameras": len(rig.wo),
            "records": records,
            "noise": noise,
            "seed": seed,
        }
        console.print_json(facts)
    elif not common.quiet:
        rows = [
            ("surface", name if dust is None else f"{name}; light in its dust: {dust} scattering"),
            ("written", f"{folder}/: {scans} scan(s) over {hours:g} h, {len(rig.wo)} cameras, {records} records"),
            ("next", f"motes fit {folder}"),
        ]
        console.print_facts(rows)
    return 0


def _surface(
    material: str | None,
    model: str | None,
    phenomenon: str | None,
    options: dict[str, Any],
    scattering: str | None,
    hours: float,
) -> tuple[Surface, str, str]:
    """What is measured, its name, and the process it goes through."""
    from motes.cli.paths import material_of
    from motes.errors import MotesError

    if material is not None and model is not None:
        raise MotesError("both --material and --model were given", "Give one of them")
    if options and phenomenon is None:
        raise MotesError(
            f"--set {next(iter(options))} was given without --phenomenon", "It is an option of a phenomenon"
        )
    given: Surface | None = None
    name = ""
    if material is not None:
        given = material_of(material)
        name = given.name
    elif model is not None:
        from motes.models import parse

        given, name = parse(model).model, model
    if phenomenon is not None:
        from motes.ageing.phenomena import phenomenon as named
        from motes.material import Material
        from motes.models import BRDF

        what = named(phenomenon)
        surface = given if isinstance(given, (Material, BRDF)) else what.base
        if scattering is not None:
            options = {**options, "scattering": scattering}
        return what(surface, hours=hours, **options), name or what.base.name, what.name.replace("_", " ")
    if given is not None:
        if scattering is not None:
            raise MotesError(
                f"--scattering {scattering} was given without dust that settles",
                "Add --phenomenon dust, or say it of the dust_layer in the model",
            )
        return given, name, "unchanged"
    from motes.ageing import drying_plaster

    return partial(drying_plaster, scattering=scattering or "multiple"), "dusty plaster", "drying"


def _scattering(surface: Surface) -> str | None:
    """How light goes in the dust on top of a surface; None where there is none."""
    from motes.material import Material
    from motes.models import BRDF, layer_of

    brdf = surface.brdf if isinstance(surface, Material) else surface if isinstance(surface, BRDF) else surface(0.0)
    layer = layer_of(brdf)
    return None if layer is None else layer.whole.options().get("scattering")


def _simulate_map(
    folder: str, size: int | None, scans: int, hours: float, noise: float, seed: int, refused: list[str], common: Common
) -> int:
    """Write a simulated map."""
    from motes.cli import console
    from motes.cli.printed_maps import stack_rows
    from motes.errors import MotesError
    from motes.maps import simulate_map

    if refused:
        raise MotesError(f"{refused[0]} is not offered for maps", "The map is of a painted surface that dries")
    n = 64 if size is None else size
    with console.texel_progress(common, "texels") as step:
        stack = simulate_map(folder, (n, n), times=scans, hours=hours, noise=noise, seed=seed, progress=step)
    if common.json:
        console.print_json(stack.summary())
    elif not common.quiet:
        rows = [row for row in stack_rows(stack.summary()) if row[0] in ("size", "times")]
        console.print_facts([("written", folder), *rows, ("next", f"motes fit {folder}")])
    return 0
