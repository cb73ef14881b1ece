"""``motes export``: a material for another program."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from motes.cli.options import Common, Reading

if TYPE_CHECKING:
    from motes.material import Material
    from motes.measurements import Measurement

# The keys of motes.exports.TARGETS, SURFACES and TEXTURES, which --help must not load; a test compares.
To = Literal[
    "glsl",
    "wgsl",
    "hlsl",
    "osl",
    "c",
    "materialx",
    "mitsuba",
    "three",
    "merl",
    "csv",
    "bird",
    "openmaterial",
    "rgl",
    "klems",
    "tensortree",
    "zemax",
    "openpbr",
    "standard_surface",
    "gltf",
    "blender",
    "orm",
    "unity",
]


def export(
    material: str,
    /,
    *,
    to: To,
    output: Annotated[str | None, Parameter(name=["--output", "-o"])] = None,
    as_model: Annotated[str | None, Parameter(name="--as")] = None,
    hours: Annotated[str | None, Parameter()] = None,
    glsl_version: Literal["300 es", "450"] | None = None,
    scalar: Literal["double", "float"] | None = None,
    basis: Literal["full", "half", "quarter"] | None = None,
    bits: Literal[8, 16] | None = None,
    normal: str | None = None,
    flip_green: Annotated[bool, Parameter(negative="")] = False,
    reading: Reading = Reading(),  # noqa: B008 (an immutable value)
    common: Common = Common(),  # noqa: B008 (an immutable value)
) -> int:
    """Write a material for another program: a shader, a document, a table; or a fitted map as textures.

    What the program cannot express is said in the file and here.

    Parameters
    ----------
    material
        A material.json, a folder of motes fit, a preset or a model such as "oren_nayar(K_d=0.8)"; measured data, too, for bird and openmaterial, which
        write the samples as they are. Or a map that motes fit wrote, for openpbr, standard_surface, gltf, blender, mitsuba, orm and unity.
    to
        The program or language. Of openpbr, standard_surface, gltf and blender the program's own parameters are fitted
        to the material; the error is said, and a picture shows it. Of a map they are fitted at every texel, and written as textures: orm is base colour
        with occlusion, roughness and metallic in one picture (Unreal, Godot), unity a base map and a mask map.
    output
        The file to write; a name made of the material's when not given. Some targets write further files beside it. Of a map, the folder.
    as_model
        Another model to say the material with, such as "eon + ggx(fresnel=schlick)": its parameters are fitted over the hemisphere, and how far
        it is from the material's own is said.
    hours
        The moment of a material that follows time, its first one when not given; a csv and fitted parameters take several, such as 0,1,2.5.
    glsl_version
        Of GLSL: "300 es" (WebGL 2, the default) or 450.
    scalar
        Of C: double (the default) or float.
    basis
        Of klems: full (145 patches, the default), half (77) or quarter (41).
    bits
        Of the PNGs of a map: 8 (the default) or 16.
    normal
        A normal map (PNG) that goes along with the textures of a map as it is.
    flip_green
        Turn the green of the normal map round: from OpenGL's convention to DirectX's, or back.
    """
    from motes.cli import console, paths
    from motes.errors import MotesError
    from motes.exports import export as write
    from motes.exports import target_named
    from motes.measurements import Measurement

    if paths.is_map(material):
        others = {"--as": as_model, "--glsl-version": glsl_version, "--scalar": scalar, "--basis": basis}
        if unused := [name for name, value in others.items() if value is not None]:
            raise MotesError(f"{unused[0]} is for one material, and {material} is a map", "Leave it out")
        return _export_map(material, to, output, _hours(hours), bits or 8, normal, flip_green, common)
    if bits is not None or normal is not None or flip_green:
        raise MotesError("--bits, --normal and --flip-green are for the textures of a map", "Leave them out")
    given = (("version", glsl_version), ("scalar", scalar), ("basis", basis))
    options = {name: value for name, value in given if value is not None}
    source, moments = _source(material, to, reading), _hours(hours)
    if as_model is not None:
        source, moments = _converted(source, as_model, moments), None
    done = write(source, to, output, hours=moments, **options)
    if common.json:
        facts = {"to": to, "files": [str(file) for file in done.files], "notes": list(done.notes)}
        console.print_json({**facts, "fits": list(done.fits)} if done.fits else facts)
    elif not common.quiet:
        rows = [
            ("measurement" if isinstance(source, Measurement) else "material", source.name),
            ("target", target_named(to).title),
        ]
        rows += [("note", note) for note in done.notes]
        console.print_facts([*rows, *(("written", str(file)) for file in done.files)])
    return 0


def _export_map(
    store: str,
    to: str,
    output: str | None,
    hours: list[float] | None,
    bits: int,
    normal: str | None,
    flip_green: bool,
    common: Common,
) -> int:
    """A fitted map as textures."""
    from motes.cli import console, paths
    from motes.exports.texture_export import export_textures, title_of
    from motes.maps import FittedMap, open_map

    title, found = title_of(to), open_map(store)
    if title is None or not isinstance(found, FittedMap):
        raise paths.many(store, to)
    with console.texel_progress(common, "converting") as step:
        done = export_textures(
            found, to, output, hours=hours, bits=bits, normal=normal, flip_green=flip_green, progress=step
        )
    if common.json:
        facts = {"to": to, "files": [str(file) for file in done.files], "notes": list(done.notes)}
        console.print_json({**facts, "fits": list(done.fits)})
    elif not common.quiet:
        rows, columns = found.shape
        facts_ = [("map", f"{found.name}, {columns} x {rows} texels"), ("target", title)]
        facts_ += [("note", note) for note in done.notes]
        console.print_facts([*facts_, *(("written", str(file)) for file in done.files)])
    return 0


def _source(text: str, to: str, reading: Reading) -> Material | Measurement:
    """The material that a text names, or for targets that hold measured samples the data there."""
    from motes.cli import paths
    from motes.errors import DataError
    from motes.exports import target_named
    from motes.material import Material
    from motes.measurements import Measurement, read
    from motes.presets import given

    if not target_named(to).measured:
        return paths.material_of(text)
    if isinstance(named := given(text), Material):
        return named
    found = read(named, **reading.options())
    if not isinstance(found, Measurement):
        raise DataError(f"{text} holds maps of parameters, not measured samples", "They are no table of directions")
    return found


def _converted(source: Material | Measurement, model: str, hours: list[float] | None) -> Material:
    """The material at a moment, said with another model."""
    from dataclasses import replace

    from motes.errors import MotesError
    from motes.fitting.conversion import convert
    from motes.material import Material

    if not isinstance(source, Material):
        raise MotesError(
            "--as is for materials, and this is measured data", f"motes fit DATA --model {model!r} fits it"
        )
    if hours is not None and len(hours) > 1:
        raise MotesError("--as takes one moment", f"Write --hours {hours[0]:g}")
    interval = source.interval
    moment = hours[0] if hours else interval[0] if interval else 0.0
    found = convert(source.at(moment), model)
    return replace(source, brdf=found.brdf, trends={}, about={**source.about, "converted": found.said()})


def _hours(text: str | None) -> list[float] | None:
    """``2.5`` or ``0,1,2.5``."""
    from motes.errors import MotesError

    if text is None:
        return None
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise MotesError(
            f"--hours {text!r} is not a number or numbers", "Write --hours 2.5, or --hours 0,1,2.5"
        ) from None
