"""``motes dust``: dust settles on a mesh."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from motes.cli.options import Common, Whole

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from motes.meshes.mesh import Mesh
    from motes.rendering.wiping import Stroke


def dust(
    mesh: str,
    /,
    *,
    days: str,
    growth_per_day: float | None = None,
    material: str | None = None,
    up: str = "y",
    source: str | None = None,
    wind: str | None = None,
    stroke: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    mask: str | None = None,
    rubbed_by: str | None = None,
    shelter: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    set: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    outwards: Annotated[bool, Parameter(negative="")] = False,
    refine: Whole = 0,
    texture_size: Whole = 1024,
    rays: Whole = 256,
    seed: Whole = 0,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Let dust settle on a mesh: more on what lies level and open, none under a table.

    Writes the optical thickness tau at the vertices (a PLY file with the property tau) or as a texture (EXR or PFM), or the
    mesh as it looks, in glTF (GLB) or USD.
    The amount on a level, open surface is days x growth-per-day, or that of a material's own dust.

    Parameters
    ----------
    mesh
        A PLY, OBJ, STL or glTF file, or sphere, plane, bunny or teapot.
    days
        Since the surface was clean; several, such as 0,30,90, for USD, where each is a frame, and for GLB, which has an animation through them.
    growth_per_day
        tau a day on a level, open surface; 0.005 when not given, about what mirrors of solar plants gather.
    material
        A material with dust on top (a file, preset or model), whose tau after so many days is used instead.
    up
        Against gravity: x, y, z, -x, -y, -z or three numbers such as 0,0.6,0.8.
    source
        The direction that dust comes from; from above when not given.
    wind
        The direction that wind comes from; it carries dust off but in the lee.
    stroke
        X,Y,Z,X,Y,Z,...,RADIUS: a stroke of a brush through points, which wipes dust off; repeat for more.
    mask
        A picture over the texture coordinates: white is wiped clean.
    rubbed_by
        A mesh that rubs dust off where it touches.
    shelter
        A mesh that stands on this one or over it, in the same coordinates; repeat for more.
    set
        NAME=VALUE: adhesion, slipperiness, spread_deg, scour, noise or noise_scale; repeat for more.
    outwards
        Turn faces of the mesh so that neighbours agree and closed surfaces look outwards.
    refine
        Cut each triangle into four so many times first: the pattern cannot be finer than the vertices.
    texture_size
        Texels along a side of a texture.
    rays
        Directions that dust falls from.
    seed
        Of the noise.
    output
        NAME.ply for tau at the vertices, NAME.glb for glTF with the dust as colours, NAME.usda, .usdc or .usdz for USD, NAME.exr or NAME.pfm for a
        texture; MESH-dusty.ply when not given.
    """
    from motes.cli import console, paths
    from motes.cli.options import numbers
    from motes.errors import MotesError
    from motes.exports import usd_library as usd
    from motes.files.finding import existing
    from motes.meshes.ply import write_ply
    from motes.meshes.subdivision import refine as refined
    from motes.rendering.baking import SUFFIXES, bake, write_texture
    from motes.rendering.deposition import GROWTH_PER_DAY, deposit, dusted, open_tau, settled_options
    from motes.rendering.wiping import read_mask

    file = Path(output) if output is not None else Path(f"{paths.slug(Path(mesh).stem)}-dusty.ply")
    suffix = file.suffix.lower()
    if suffix not in (".ply", ".glb", *usd.SUFFIXES, *SUFFIXES):
        raise MotesError(
            f"{file} is neither a mesh nor a texture by its name",
            "Write -o NAME.ply, NAME.glb, NAME.usda, NAME.usdz, NAME.exr or NAME.pfm",
        )
    if suffix in usd.SUFFIXES:
        usd.library()  # what is missing is said before the work
    moments = _days(days, several=suffix in (".glb", *usd.SUFFIXES))
    last = moments[-1]
    if material is not None and growth_per_day is not None:
        raise MotesError("both --material and --growth-per-day were given", "Give one of them")
    options = settled_options(numbers(set, "--set"))
    covered = None if material is None else paths.material_of(material)
    rate = GROWTH_PER_DAY if growth_per_day is None else growth_per_day
    levels = [open_tau(day, growth_per_day=rate, material=covered) for day in moments]
    level = levels[-1]
    notes: tuple[str, ...] = ()
    if not 0 <= refine <= 8:
        raise MotesError(f"--refine {refine} is outside [0, 8]", "Each step makes four times the triangles")
    shape = refined(mesh_of(mesh, outwards), refine)
    arguments: dict[str, Any] = {
        "up": vector(up, "--up"),
        "source": None if source is None else vector(source, "--source"),
        "wind": None if wind is None else vector(wind, "--wind"),
        "strokes": [_stroke(text) for text in stroke],
        "mask": None if mask is None else read_mask(existing(mask)),
        "rubbed_by": None if rubbed_by is None else mesh_of(rubbed_by),
        "others": [mesh_of(path) for path in shelter],
        "rays": rays,
        "seed": seed,
        **options,
    }
    with console.progress(common, f"dust on {shape.name}") as step:
        if suffix not in SUFFIXES:
            settled = deposit(shape, progress=step, **arguments)
            tau: NDArray[np.floating[Any]] = settled.tau(level)
            told = f"tau of dust after {last:g} days, {level:.6g} where level and open; made by motes dust"
            if suffix == ".ply":
                # Mitsuba's own reader takes numbers whose names end so; it calls the attribute vertex_tau.
                write_ply(file, shape.with_attribute("tau", tau).with_attribute("tau_0", tau), (told,))
            else:
                from motes.exports.gltf_dust import write_gltf
                from motes.exports.usd_dust import write_usd

                then = [(day, settled.tau(each)) for day, each in zip(moments, levels, strict=True)]
                model = dusted(last, growth_per_day=rate, material=covered)
                if suffix == ".glb":
                    notes = write_gltf(file, shape, model, then, told)
                else:
                    notes = write_usd(file, shape, model, then, told, up=arguments["up"], progress=step)
        else:
            baked = bake(shape, texture_size, progress=step, **arguments)
            picture = baked.texture(level)
            tau = picture[baked.covered]
            write_texture(file, picture)
    _report(file, shape, tau, last, level, notes, common, dict(zip(moments, levels, strict=True)))
    if level > 0 and float(tau.max()) == 0:
        console.warn(_nowhere(shape))
    return 0


def _nowhere(shape: Mesh) -> str:
    """Why no dust landed, as far as it can be told."""
    inwards = next((note for note in shape.notes if "--outwards" in note), "")
    return f"no dust landed anywhere: {inwards or 'no open face looks to where it comes from, or it was carried off; --up says where up is (y when not given)'}"


def _report(
    file: Path,
    shape: Mesh,
    tau: NDArray[np.floating[Any]],
    days: float,
    level: float,
    said: tuple[str, ...],
    common: Common,
    moments: dict[float, float],
) -> None:
    from motes.cli import console
    from motes.rendering.baking import SUFFIXES

    suffix = file.suffix.lower()
    is_mesh = suffix not in SUFFIXES
    places = "vertices" if is_mesh else "texels"
    facts = {"min": float(tau.min()), "mean": float(tau.mean()), "max": float(tau.max())}
    if common.json:
        console.print_json(
            {
                "path": str(file),
                "mesh": shape.name,
                places: len(tau),
                "triangles": len(shape.triangles),
                "days": days,
                "open_tau": level,
                "moments": [{"days": day, "open_tau": each} for day, each in moments.items()],
                "tau": facts,
                "notes": [*shape.notes, *said],
            }
        )
    elif not common.quiet:
        console.print_facts(
            [
                ("mesh", f"{shape.name}: {len(shape.positions)} vertices, {len(shape.triangles)} triangles"),
                *(("note", note) for note in (*shape.notes, *said)),
                *(
                    ("dust", f"tau = {each:.4g} where it is level and open, after {day:g} days")
                    for day, each in moments.items()
                ),
                ("tau", f"{facts['min']:.3g} to {facts['max']:.3g}, mean {facts['mean']:.3g} over {len(tau)} {places}"),
                ("written", str(file)),
                *([("next", f"motes render MATERIAL --scene {file} -o picture.png")] if suffix == ".ply" else []),
            ]
        )


def mesh_of(name: str, outwards: bool = False) -> Mesh:
    """A mesh from a file, its faces turned outwards or left, or one of the shapes by its name."""
    from motes.files.finding import existing
    from motes.meshes.meshfile import read_mesh
    from motes.meshes.shapes import SHAPES

    if name in SHAPES and not Path(name).exists():
        return SHAPES[name]()
    return read_mesh(existing(name), outwards=outwards)


def _days(text: str, several: bool) -> list[float]:
    """``30``, or where several are taken ``0,30,90``."""
    from motes.errors import MotesError

    days = _numbers(text, "--days", "Write --days 30, or for GLB and USD --days 0,30,90")
    if not days or sorted(set(days)) != days:
        raise MotesError(f"--days {text!r} do not increase", "Give each once, such as 0,30,90")
    if len(days) > 1 and not several:
        raise MotesError(
            f"--days {text!r} are {len(days)} moments", "GLB and USD hold several: -o NAME.glb or -o NAME.usda"
        )
    return days


AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


def vector(text: str, option: str) -> tuple[float, ...]:
    """``y``, ``-z`` or ``0,0.6,0.8``."""
    from motes.errors import MotesError

    word = text.strip().lower()
    if word.lstrip("+-") in AXES:
        sign = -1.0 if word.startswith("-") else 1.0
        return tuple(sign * c for c in AXES[word.lstrip("+-")])
    values = _numbers(text, option)
    if len(values) != 3:
        raise MotesError(
            f"{option} {text!r} is not a direction", f"Write {option} y, {option}=-x or {option} 0,0.6,0.8"
        )
    return tuple(values)


def _numbers(text: str, option: str, hint: str = "") -> list[float]:
    from motes.errors import MotesError

    try:
        return [float(word) for word in text.replace(",", " ").split()]
    except ValueError:
        raise MotesError(f"{option} {text!r} is not numbers", hint or f"Write {option} 0,0.6,0.8") from None


def _stroke(text: str) -> Stroke:
    from motes.errors import MotesError
    from motes.rendering.wiping import Stroke

    values = _numbers(text, "--stroke")
    if len(values) < 4 or len(values) % 3 != 1:
        raise MotesError(
            f"--stroke {text!r} has {len(values)} numbers", "Write the points X,Y,Z,X,Y,Z and then the radius"
        )
    points: Any = [values[k : k + 3] for k in range(0, len(values) - 1, 3)]
    return Stroke(points, values[-1])
