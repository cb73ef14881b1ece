"""The targets of an export by name, and `export`, which writes one."""

from __future__ import annotations

import importlib
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from motes.errors import ParameterError
from motes.exports.subject import Subject, identifier, subject
from motes.exports.usd_library import SUFFIXES as USD_SUFFIXES
from motes.files import together, write_text
from motes.measurements.measurement import Measurement

#: Moments of a table of a material that follows time, where none are asked for.
MOMENTS = 11
MOST_MOMENTS = 1000


@dataclass(frozen=True)
class Target:
    """Something to export to.

    Attributes
    ----------
    title
        For people.
    suffix
        Of the file, where no name is given.
    module
        Under `motes.exports`.
    options
        What `export` accepts besides.
    over_time
        Whether one file holds a material at several moments.
    measured
        Whether it holds a `Measurement` as it is, too.
    others
        Further suffixes that a file of it may have.
    """

    title: str
    suffix: str
    module: str
    options: tuple[str, ...] = ()
    over_time: bool = False
    measured: bool = False
    others: tuple[str, ...] = ()

    @property
    def suffixes(self) -> tuple[str, ...]:
        """All suffixes that a file of it may have."""
        return (self.suffix, *self.others)


TARGETS: dict[str, Target] = {
    "glsl": Target(
        "GLSL ES 3.00 or 4.5: functions and uniforms", ".glsl", "glsl", ("version",), others=(".frag", ".vert")
    ),
    "wgsl": Target("WGSL: functions and a buffer of parameters", ".wgsl", "wgsl"),
    "hlsl": Target("HLSL: functions and a constant buffer", ".hlsl", "hlsl", others=(".hlsli", ".fxh")),
    "osl": Target("OSL: a shader with the value and the nearest closures", ".osl", "osl"),
    "c": Target("C99, C++ and CUDA: a header", ".h", "c", ("scalar",), others=(".hpp", ".hh", ".cuh", ".c")),
    "materialx": Target("MaterialX 1.39: a document with nodes of its own and standard ones", ".mtlx", "materialx"),
    "mitsuba": Target("Mitsuba 3: a scene's BSDFs in XML", ".xml", "mitsuba"),
    "three": Target(
        "three.js: a module with a material for WebGLRenderer and WebGPURenderer", ".js", "three", others=(".mjs",)
    ),
    "merl": Target("MERL: a table of half and difference angles", ".binary", "merl_table"),
    "csv": Target("CSV: a table of angles, times and channels", ".csv", "csv_table", over_time=True, others=(".txt",)),
    "bird": Target(
        "BiRD JSON: values with uncertainties and provenance", ".json", "bird_json", over_time=True, measured=True
    ),
    "openmaterial": Target(
        "ASAM OpenMATERIAL: a table of wavelengths and angles", ".xompt", "openmaterial_table", measured=True
    ),
    "rgl": Target("RGL tensor file: a measured material for Mitsuba and others", ".bsdf", "rgl_tensors"),
    "klems": Target("WINDOW and Radiance: a Klems matrix in XML", ".xml", "klems", ("basis",)),
    "tensortree": Target("Radiance: a tensor tree in XML", ".xml", "tensor_tree"),
    "zemax": Target("Zemax: a tabular BSDF about the mirror direction", ".bsdf", "zemax_table"),
}
#: Programs with a surface of their own, whose parameters are fitted: the kind of surface (of `motes.models`) besides.  Each holds several moments.
SURFACES: dict[str, tuple[Target, str]] = {
    "openpbr": (
        Target(
            "OpenPBR in MaterialX or USD: its parameters, fitted",
            ".mtlx",
            "surface_nodes",
            over_time=True,
            others=USD_SUFFIXES,
        ),
        "OpenPBR",
    ),
    "standard_surface": (
        Target(
            "Standard Surface in MaterialX or USD: its parameters, fitted",
            ".mtlx",
            "surface_nodes",
            over_time=True,
            others=USD_SUFFIXES,
        ),
        "StandardSurface",
    ),
    "gltf": (
        Target(
            "glTF 2.0: the parameters of its material, fitted, on a sphere", ".gltf", "surface_gltf", over_time=True
        ),
        "GltfSurface",
    ),
    "blender": (
        Target("Blender: a script that makes a Principled BSDF, fitted", ".py", "surface_blender", over_time=True),
        "Principled",
    ),
}
#: What a map is written for besides `SURFACES`: sets of pictures that several programs share (`motes.exports.texture_export`).
TEXTURES: dict[str, Target] = {
    "orm": Target(
        "Unreal, Godot and others: base colour, and occlusion, roughness, metallic in one picture", "", "texture_export"
    ),
    "unity": Target("Unity: base map, and mask map with smoothness", "", "texture_export"),
}
SHADERS = ("glsl", "wgsl", "hlsl", "osl", "c")


class Exported(NamedTuple):
    """What `export` wrote.

    Attributes
    ----------
    files
        The first is the one that was asked for; the others lie beside it.
    notes
        What the target cannot express, and what was chosen: sentences that the files say, too.
    fits
        Of `SURFACES` the parameters and errors of each moment, as the JSON beside the file has them.
    """

    files: tuple[Path, ...]
    notes: tuple[str, ...]
    fits: tuple[dict[str, Any], ...] = ()


def export(
    material: Any,
    to: str,
    path: str | os.PathLike[str] | None = None,
    *,
    hours: float | Sequence[float] | None = None,
    **options: str,
) -> Exported:
    """Write a material for another program.

    Parameters
    ----------
    material
        A `Material` or a BRDF; for ``"bird"`` and ``"openmaterial"`` also a `Measurement`, whose samples are written as they are.
    to
        A key of `TARGETS`: ``"glsl"``, ``"materialx"``, ``"merl"`` ...; or of `SURFACES`: ``"openpbr"`` ..., whose parameters are fitted.
    path
        The file to write; a name made of the material's, in the current folder, when not given.
    hours
        The moment [h] of a material that follows time, its first one by default.  A table (``"csv"``) takes several; by default it has
        eleven over the time that was observed.  A fitted surface takes several, too.
    **options
        ``version`` of GLSL (``"300 es"``, ``"450"``), ``scalar`` of C (``"double"``, ``"float"``), ``basis`` of klems (``"full"``,
        ``"half"``, ``"quarter"``).

    Raises
    ------
    ParameterError
        When there is no such target, option or moment, or the model cannot be expressed.
    DataError
        When the target does not hold as many channels.
    MotesError
        When the file cannot be written.

    Examples
    --------
    >>> import motes, tempfile
    >>> folder = tempfile.mkdtemp()
    >>> done = export(motes.Lambert(K_d=(0.8, 0.5, 0.2)), "glsl", f"{folder}/clay.glsl")
    >>> "vec3 motes_eval(vec3 wi, vec3 wo)" in done.files[0].read_text()
    True
    """
    target = target_named(to)
    unknown = [name for name in options if name not in target.options]
    if unknown:
        raise ParameterError(
            f"{to} has no option {unknown[0]!r}",
            f"It has {', '.join(target.options)}" if target.options else "It has none",
        )
    if isinstance(material, Measurement):
        return _export_measurement(material, to, path, hours)
    moments = _moments(material, target, hours, several=to not in SURFACES)
    first = moments[0][1]
    file = _named(path, first.identifier, to, target)
    module = importlib.import_module(f"motes.exports.{target.module}")
    if to in SURFACES:
        return _fitted(module, SURFACES[to][1], [what for _, what in moments], file)
    said = list(first.notes if len(moments) == 1 else first.origin)
    said += shader_limits(to, first) if to in SHADERS else module.limits(first)
    with together(file.parent) as staging:
        new = staging / file.name
        if to in SHADERS:
            made = [_write_shader(module, to, first, new, options)]
        elif target.over_time:
            made = module.write(moments, new)
        else:
            made = module.write(first, new, **options)
    return Exported(tuple(file.parent / part.name for part in made), tuple(said))


def target_named(to: str) -> Target:
    """The target of that name; raises `ParameterError` when there is none."""
    if to in TARGETS:
        return TARGETS[to]
    if to in SURFACES:
        return SURFACES[to][0]
    if to in TEXTURES:
        raise ParameterError(
            f"{to} is a set of textures, for a map that motes fit wrote",
            f"One material goes to {either(list(SURFACES))}",
        )
    raise ParameterError(
        f"{to!r} is nothing that Motes exports to", f"It exports to {', '.join([*TARGETS, *SURFACES])}"
    )


def either(words: Sequence[str]) -> str:
    """Words as ``a, b or c``."""
    return " or ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _named(path: str | os.PathLike[str] | None, name: str, to: str, target: Target) -> Path:
    """The file to write: one that is asked for, whose suffix must be of the target, or one by the material's name."""
    if path is None:
        return Path(f"{name}{target.suffix}")
    file = Path(path)
    if file.is_dir():
        raise ParameterError(f"{file} is a folder", f"Name a file, such as {file / (name + target.suffix)}")
    if file.suffix and file.suffix.lower() not in target.suffixes:
        raise ParameterError(
            f"{file.name} is no name for {to}, whose files end in {either(target.suffixes)}",
            f"Write -o {file.stem}{target.suffix}, or choose another target with --to",
        )
    return file


def _fitted(module: Any, kind: str, moments: Sequence[Subject], file: Path) -> Exported:
    """Fit the surface of a program to each moment; beside its file lie the numbers with their errors, and a picture."""
    from motes import models
    from motes.exports import surface_files, surface_picture
    from motes.exports.surface_fit import fit_surface
    from motes.exports.usd_library import library as usd_library

    if file.suffix.lower() in USD_SUFFIXES:
        usd_library()  # what is missing is said before the work
    fits = [fit_surface(what, getattr(models, kind)) for what in moments]
    beside = {
        f"{file.stem}_fit.json": surface_files.record(fits),
        f"{file.stem}_fit.svg": surface_picture.picture(fits),
    }
    with together(file.parent) as staging:
        made = [module.write(fits, staging / file.name)]
        made += [write_text(staging / name, text) for name, text in beside.items()]
    return Exported(
        tuple(file.parent / part.name for part in made),
        tuple(surface_files.notes(fits)),
        tuple(fit.record() for fit in fits),
    )


def _export_measurement(
    data: Measurement, to: str, path: str | os.PathLike[str] | None, hours: float | Sequence[float] | None
) -> Exported:
    """Write measured samples as they are."""
    target = target_named(to)
    if not target.measured:
        able = ", ".join(name for name, other in TARGETS.items() if other.measured)
        raise ParameterError(
            f"{to} takes a material, and {data.name} is measured data", f"Fit it first; {able} take data"
        )
    if hours is not None:
        raise ParameterError("hours choose the moment of a material, and these are measured data", "Leave hours out")
    file = _named(path, identifier(data.name), to, target)
    module = importlib.import_module(f"motes.exports.{target.module}")
    return Exported((file,), tuple(module.write_measurement(data, file)))


def _moments(
    material: Any, target: Target, hours: float | Sequence[float] | None, *, several: bool
) -> list[tuple[float | None, Subject]]:
    """The moments to export, with the material then; `several` unless others are asked for, where the target holds them."""
    asked = None if hours is None else [float(x) for x in np.atleast_1d(np.asarray(hours, float))]
    interval = getattr(material, "interval", None)
    if several and target.over_time and interval is not None and asked is None:
        asked = np.linspace(interval[0], interval[1], MOMENTS).tolist()
    if asked is None:
        return [(None, subject(material))]
    if not 1 <= len(asked) <= (MOST_MOMENTS if target.over_time else 1):
        at_most = f"1 to {MOST_MOMENTS}" if target.over_time else "one"
        raise ParameterError(
            f"{len(asked)} moments, and {target.title.partition(':')[0]} holds {at_most}", "Give others"
        )
    if sorted(set(asked)) != asked:
        raise ParameterError(f"the moments {', '.join(f'{x:g}' for x in asked)} h do not increase", "Give each once")
    return [(moment, subject(material, moment)) for moment in asked]


def _write_shader(module: Any, to: str, what: Subject, file: Path, options: dict[str, str]) -> Path:
    more: dict[str, Any] = dict(options)
    if to == "osl":
        more["shader_name"] = f"motes_{what.identifier}"
    make: Callable[..., Any] = module.shader
    return write_text(file, make(what.brdf, title=what.name, notes=what.notes, **more).source)


def shader_limits(to: str, what: Subject) -> list[str]:
    """What a shading language cannot say."""
    from motes.exports.approximation import losses

    if to != "osl":
        return []
    if what.brdf.channels not in (1, 3):
        return ["Without one or three channels there is no closure, only the value."]
    return [
        "Reflectance is the BRDF for a given light; BSDF, for rendering, is the nearest sum of closures:",
        *losses(what.brdf),
    ]
