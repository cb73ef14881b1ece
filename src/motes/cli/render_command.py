"""``motes render``: pictures and films of materials."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from motes.cli.options import Common, MaybeWhole, Reading, Whole

if TYPE_CHECKING:
    from motes.material import Material


def render(
    *material: str,
    output: Annotated[str, Parameter(name=["--output", "-o"])],
    scene: str | None = None,
    env: str | None = None,
    time: str | None = None,
    deposit: Annotated[bool, Parameter(negative="")] = False,
    set: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    up: str = "y",
    wind: str | None = None,
    lamp: str | None = None,
    repeat: MaybeWhole = None,
    filter: Literal["nearest", "bilinear"] | None = None,
    gaps: Literal["fill", "mark"] | None = None,
    strict: Annotated[bool, Parameter(negative="")] = False,
    scattering: Literal["single", "multiple"] | None = None,
    compare: str | None = None,
    model: Annotated[str, Parameter(name=["--model", "-m"])] = "oren_nayar + torrance_sparrow",
    size: str | None = None,
    samples: MaybeWhole = None,
    seed: Whole = 0,
    tone: Literal["neutral", "clip"] = "neutral",
    exposure: float = 0.0,
    fps: float = 12.0,
    labels: bool | None = None,
    keep_frames: Annotated[bool, Parameter(negative="")] = False,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008
) -> int:
    """Render materials: a picture, a film of how they change, a table that compares them.

    Several materials, or several times, stand side by side; both make a table. With --compare a measured material is
    shown beside its fit. A map that motes fit wrote is shown as the flat sample that was measured, every texel with its own parameters,
    or on a mesh by its texture coordinates. A film that was stopped goes on where it was when the same command is run again.

    Parameters
    ----------
    material
        A material.json, a folder of motes fit, a fitted map (.zarr), a preset or a model such as "oren_nayar(K_d=0.8)"; one or more.
    output
        NAME.png, NAME.exr (radiance), NAME.gif or NAME.mp4.
    scene
        sphere, bunny, teapot, grid (small spheres), flat (from above; of a map when not given), a mesh (.ply, .obj, .stl, .glb, .gltf), or a
        Mitsuba scene (.xml) with $material in it.
    env
        An environment map (EXR, HDR) in place of the studio's lights.
    time
        A time such as 12h, several as 0,6,24h, or FIRST:LAST:COUNT such as 0:30d:48; hours when no unit is given.
    deposit
        Let dust lie where it settles, rather than evenly.
    set
        NAME=VALUE: a number of the deposit, such as adhesion=0.5; repeat for more.
    up
        Of a mesh: x, y, z, -x, -y, -z or three numbers.
    wind
        The direction that wind comes from, for --deposit.
    lamp
        Over a flat sample: THETA,PHI in degrees, phi 0 on the right and 90 behind; 45,135 when not given.
    repeat
        Copies of a map along each side of a flat sample or a mesh's texture, around a sphere; every second is mirrored.
    filter
        Between texels of a map: nearest, each point as its own texel (when not given), or bilinear, their light mixed.
    gaps
        Texels of a map without a fit: fill, with the parameters of the nearest that has one (when not given), or mark, magenta.
    strict
        Count texels with a parameter that the data do not determine as texels without a fit.
    scattering
        How light goes in dust that is laid over a material without: "multiple" when not given, or "single", the source's.
    compare
        An RGL (.bsdf) or MERL (.binary) file, shown beside the materials, or beside its fit when none is given.
    model
        That is fitted for --compare.
    size
        Pixels along a side of a panel, or WIDTHxHEIGHT.
    samples
        Paths a pixel.
    seed
        Of the paths and of the noise in dust.
    tone
        neutral rolls highlights off (Khronos PBR Neutral), clip cuts at 1.
    exposure
        In stops.
    fps
        Frames a second of a film.
    labels
        Titles over the panels; on for films and where there are several.
    keep_frames
        Keep the frames of radiance when all is done.
    """
    from motes.cli import console, paths
    from motes.cli.dust_command import vector
    from motes.cli.options import numbers
    from motes.errors import MotesError
    from motes.files.finding import existing
    from motes.rendering import slow_note
    from motes.rendering.pictures import aspect_of, default_look, is_map
    from motes.rendering.pictures import render as make

    if compare is None and not material:
        raise MotesError(
            "no material was given", "motes render MATERIAL.json -o picture.png; motes fit makes materials"
        )
    options = numbers(set, "--set")
    if (options or wind is not None) and not deposit:
        raise MotesError(f"--{'wind' if wind is not None else 'set'} was given without --deposit", "Add --deposit")
    settling: dict[str, Any] | None = None
    if deposit:
        from motes.rendering.deposition import settled_options

        settling = {**settled_options(options), "seed": seed}
        if wind is not None:
            settling["wind"] = vector(wind, "--wind")
    hours = None if time is None else hours_of(time)
    film = Path(output).suffix.lower() in (".gif", ".mp4")
    if note := slow_note():
        console.warn(note)
    shown = [paths.material_or_map(path) for path in material]
    measured: Path | None = None
    if compare is not None:
        measured = existing(compare)
        shown = shown or [_fitted(measured, model, reading, common)]
    aspect = aspect_of(shown)
    scene = scene or ("sphere" if aspect is None else "flat")
    if Path(scene).suffix.lower() == ".xml" and size is not None:
        raise MotesError(f"--size was given for {scene}", "A Mitsuba scene says its own size, in its film")
    of_map = {"repeat": repeat, "filter": filter, "gaps": gaps, "strict": strict or None}
    _check_map_options(of_map, lamp, scene, any(map(is_map, shown)))
    several = film or scene == "grid" or len(shown) * len(hours or (0,)) + (measured is not None) > 1
    look = default_look(
        several=several,
        film=film,
        aspect=aspect,
        scene=scene,
        size=None if size is None else _size(size, aspect if scene == "flat" else None),
        samples=samples,
        seed=seed,
        env=None if env is None else existing(env),
        up=vector(up, "--up"),
        lamp_deg=None if lamp is None else _lamp(lamp),
        **of_map,
    )
    try:
        with console.progress(common, "rendering") as step:
            made = make(
                shown,
                output,
                look=look,
                hours=hours,
                settling=settling,
                scattering=scattering,
                measured=measured,
                tone=tone,
                exposure=exposure,
                fps=fps,
                labels=labels,
                keep_frames=keep_frames,
                progress=step,
            )
    except KeyboardInterrupt:
        if film:
            console.warn("finished frames are kept beside the film; the same command goes on from there")
        raise
    if made.not_finite:
        console.warn(f"{made.not_finite} values of radiance are no numbers and are shown black")
    if common.json:
        console.print_json(
            {
                "path": str(made.path),
                "materials": [m.name for m in shown],
                "scene": scene,
                "hours": list(made.hours),
                "size": list(made.look.size),
                "samples": made.look.samples,
                "rows": made.rows,
                "columns": made.columns,
                "frames_kept": made.kept,
                "tone": made.tone,
                "notes": list(made.notes),
            }
        )
    elif not common.quiet:
        first, last = min(made.hours), max(made.hours)
        what = f"{len(made.hours)} frames" if film else f"{made.rows} x {made.columns} panels"
        console.print_facts(
            [
                ("material", "; ".join(m.name for m in shown)),
                ("scene", f"{scene}, {what}, {made.look.samples} paths a pixel"),
                ("time", f"{first:g} h" if first == last else f"{first:g} to {last:g} h"),
                *([("kept", f"{made.kept} frames were there already")] if made.kept else []),
                *(("note", note) for note in made.notes),
                ("tone", made.tone if Path(output).suffix.lower() != ".exr" else "none: linear radiance"),
                ("written", str(made.path)),
            ]
        )
    return 0


def _fitted(path: Path, model: str, reading: Reading, common: Common) -> Material:
    """The fit of a measurement, named after its model."""
    from dataclasses import replace

    from motes.cli import console
    from motes.errors import DataError
    from motes.fitting import fit
    from motes.measurements import Measurement, read
    from motes.models import describe

    data = read(path, **reading.options())
    if not isinstance(data, Measurement):
        raise DataError(f"{path} holds maps of parameters, not a measured material", "Give an RGL or MERL file")
    with console.progress(common, f"fitting {path.name}") as step:
        found = fit(data, model=model, progress=step)
    material = found.material
    return replace(material, name=f"fit: {describe(material.brdf)}")


UNITS = {"s": 1 / 3600, "min": 1 / 60, "h": 1.0, "d": 24.0}


def hours_of(text: str) -> list[float]:
    """``12h``, ``0,6,24h`` or ``0:30d:48`` as hours; a unit at the end of the last time serves those without one."""
    from motes.errors import MotesError

    hint = "Write --time 12h, --time 0,6,24h or --time 0:30d:48 (units: s, min, h, d)"
    parts = text.replace(" ", "").split(":")
    if len(parts) not in (1, 3):
        raise MotesError(f"--time {text!r} is not FIRST:LAST:COUNT", hint)
    words = parts[0].split(",") if len(parts) == 1 else parts[:2]
    try:
        units = [next((u for u in ("min", "s", "h", "d") if word.endswith(u)), "") for word in words]
        times = [
            float(word.removesuffix(u)) * UNITS[u or units[-1] or "h"] for word, u in zip(words, units, strict=True)
        ]
        count = int(parts[2]) if len(parts) == 3 else len(times)
    except ValueError:
        raise MotesError(f"--time {text!r} is not a time, or several", hint) from None
    if not 1 <= count <= 100_000:
        raise MotesError(f"--time {text!r} asks for {count} frames", "Choose 1 to 100000")
    if len(parts) == 1:
        return times
    step = (times[1] - times[0]) / max(count - 1, 1)
    return [times[0] + k * step for k in range(count)]


def _check_map_options(given: dict[str, Any], lamp: str | None, scene: str, maps: bool) -> None:
    """Refuse what would do nothing."""
    from motes.errors import MotesError

    option = next((name for name, value in given.items() if value is not None), None)
    if lamp is not None and scene != "flat":
        raise MotesError(f"--lamp was given for the scene {scene}", "It lights a flat sample: --scene flat")
    if option is not None and not maps:
        raise MotesError(f"--{option} was given, and nothing that is shown is a map", "motes fit MAP.zarr makes one")
    if option is not None and Path(scene).suffix.lower() == ".xml":
        raise MotesError(f"--{option} was given for {scene}", "A Mitsuba scene says it itself, in its motes_map")


def _lamp(text: str) -> tuple[float, ...]:
    from motes.errors import MotesError

    try:
        return tuple(float(word) for word in text.split(","))
    except ValueError:
        raise MotesError(f"--lamp {text!r} is no direction", "Write THETA,PHI in degrees: --lamp 45,135") from None


def _size(text: str, aspect: float | None = None) -> tuple[int, int]:
    """Width and height; one number alone is the longer side of a flat sample."""
    from motes.errors import MotesError
    from motes.rendering.flat import size_of

    words = text.lower().split("x")
    if len(words) > 2 or not all(word.strip().isdigit() for word in words):
        raise MotesError(f"--size {text!r} is not a size", "Write --size 512 or --size 640x480")
    if len(words) == 1 and aspect is not None:
        return size_of(aspect, int(words[0]))
    return int(words[0]), int(words[-1])
