"""A BSDF of Mitsuba as a specimen: a plugin's name, a dictionary, an XML file, or the object itself.

Mitsuba's ``si.wi`` is here the direction that is given, wi, and its ``wo`` the one that is sampled; its ``eval`` is f |cos(theta_o)|, which is divided
by the cosine.  All of it is computed in float32, by the variant ``llvm_ad_rgb``.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.certification.specimen import Drawn, Floats, Slopes, Specimen, digest_of
from motes.errors import DataError
from motes.rendering import load_mitsuba, load_scene

VARIANT = "llvm_ad_rgb"
PREFIX = "mitsuba:"
STEP = 1e-2
MOST_PARAMETERS = 8


def of_mitsuba(subject: Any, name: str = "") -> Specimen:
    """See `motes.certify`; `subject` is a dictionary, the path of an XML or JSON file, or a BSDF.

    Raises
    ------
    MotesError
        When Mitsuba is not installed, cannot run here or cannot load it.
    DataError
        When it is no BSDF.
    """
    mi = load_mitsuba(VARIANT)
    texts: list[str | bytes] = []
    if isinstance(subject, Path):
        texts.append(subject.read_bytes())
        name = name or subject.stem
        subject = json.loads(texts[0]) if subject.suffix.lower() == ".json" else subject
    if isinstance(subject, Mapping):
        texts += [json.dumps(subject, sort_keys=True, default=str), *_files(subject)]
        name = name or str(subject.get("type", "dictionary"))
    if isinstance(subject, (Mapping, Path)):
        bsdf = bsdf_of(mi, load_scene(subject))
    else:
        bsdf = subject
        texts.append(str(bsdf))
    if not isinstance(bsdf, mi.BSDF):
        raise DataError(f"{name or type(bsdf).__name__} is no BSDF of Mitsuba", "Give one, or a scene with one")
    flags = bsdf.flags()
    through = mi.has_flag(flags, mi.BSDFFlags.Transmission) or mi.has_flag(flags, mi.BSDFFlags.Null)
    return Specimen(
        name=name or type(bsdf).__name__,
        kind="BSDF of Mitsuba",
        eval=lambda wi, wo: evaluated(mi, bsdf, wi, wo),
        digest=digest_of(*texts),
        sample=lambda wi, u: _sampled(mi, bsdf, wi, u),
        pdf=lambda wi, wo: _numbers(bsdf.pdf(mi.BSDFContext(), _surface(mi, wi), _vector(mi, wo)), len(wi))[:, 0],
        slopes=lambda wi, wo: _slopes(mi, bsdf, wi, wo),
        transmits=through,
        both_sides=mi.has_flag(flags, mi.BSDFFlags.BackSide),
        single=True,
        facts={"Mitsuba's words": " ".join(str(bsdf).split())[:600], "variant": VARIANT},
        versions={"mitsuba": mi.__version__},
    )


def bsdf_of(mi: Any, loaded: Any) -> Any:
    """The BSDF itself, or that of a scene's only material."""
    if not isinstance(loaded, mi.Scene):
        return loaded
    found = list({id(s.bsdf()): s.bsdf() for s in loaded.shapes() if s.bsdf() is not None}.values())
    if len(found) != 1:
        raise DataError(f"the scene has {len(found)} BSDFs, not one", "Give the <bsdf> alone, as a file of its own")
    return found[0]


def _files(subject: Mapping[str, Any]) -> list[bytes]:
    """The contents of files that a dictionary names, which are what is certified as much as it is."""
    found = []
    for _, value in sorted(subject.items(), key=lambda item: item[0]):
        if isinstance(value, Mapping):
            found += _files(value)
        elif isinstance(value, str) and len(value) < 4096 and Path(value).is_file():
            found.append(Path(value).read_bytes())
    return found


# ---------------------------------------------------------------- asking it


def _vector(mi: Any, w: Floats) -> Any:
    return mi.Vector3f(*(mi.Float(np.ascontiguousarray(w[:, k], np.float32)) for k in range(3)))


def _surface(mi: Any, wi: Floats) -> Any:
    """A point of a surface in the plane of x and y, with coordinates of textures in their middle."""
    import drjit as dr

    si = dr.zeros(mi.SurfaceInteraction3f, len(wi))
    si.wi = _vector(mi, wi)
    si.t = 1.0
    si.n = mi.Normal3f(0, 0, 1)
    si.sh_frame = mi.Frame3f(mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0), mi.Vector3f(0, 0, 1))
    si.dp_du, si.dp_dv = mi.Vector3f(1, 0, 0), mi.Vector3f(0, 1, 0)
    si.uv = mi.Point2f(0.5, 0.5)
    return si


def _numbers(value: Any, count: int) -> Floats:
    """A Float or a color of Dr.Jit as (N, C)."""
    array = np.atleast_2d(np.array(value, np.float64))
    array = array.T if array.shape[0] in (1, 3) else array
    return np.broadcast_to(array, (count, array.shape[1]))


def evaluated(mi: Any, bsdf: Any, wi: Floats, wo: Floats) -> Floats:
    """The BSDF [1/sr] without the cosine (N, C)."""
    values = _numbers(bsdf.eval(mi.BSDFContext(), _surface(mi, wi), _vector(mi, wo)), len(wi))
    cosine = np.abs(np.float32(wo[:, 2:])).astype(np.float64)
    return np.where(cosine > 0, values / np.where(cosine > 0, cosine, 1), values)


def _sampled(mi: Any, bsdf: Any, wi: Floats, u: Floats) -> Drawn:
    """Mitsuba takes a third number; it comes of the first two."""
    third = np.random.default_rng(int(u[0, 0] * 2**53)).random(len(u))
    a, b, c = (mi.Float(np.minimum(x.astype(np.float32), np.float32(1 - 2**-24))) for x in (third, u[:, 0], u[:, 1]))
    light = np.broadcast_to(wi, (len(u), 3))
    sample, weight = bsdf.sample(mi.BSDFContext(), _surface(mi, light), a, mi.Point2f(b, c))
    wo = np.array(sample.wo, np.float64).T
    kind = np.broadcast_to(np.array(sample.sampled_type, np.uint32), (len(u),))
    pdf = np.broadcast_to(np.array(sample.pdf, np.float64), (len(u),))
    peaks: NDArray[np.bool_] = (kind & int(mi.BSDFFlags.Delta)) != 0
    # A sample without a density is none: it counts as lost.
    lost = ~peaks & ~(pdf > 0)
    return Drawn(np.where(lost[:, None], np.nan, wo), pdf, _numbers(weight, len(u)), peaks)


def _slopes(mi: Any, bsdf: Any, wi: Floats, wo: Floats) -> Mapping[str, Slopes]:
    """Derivatives by forward mode, of all components of a parameter together, against central differences of a hundredth."""
    import drjit as dr

    parameters = mi.traverse(bsdf)
    found: dict[str, Slopes] = {}

    def value() -> Any:
        return bsdf.eval(mi.BSDFContext(), _surface(mi, wi), _vector(mi, wo))

    def moved_to(key: str, to: Any) -> None:
        parameters[key] = to
        parameters.update()

    for key in list(parameters.keys())[:MOST_PARAMETERS]:
        try:
            start = parameters[key]
        except TypeError:  # what is not there in a plugin (of hair) cannot be read
            continue
        if not (dr.is_diff_v(type(start)) and dr.is_float_v(type(start))) or dr.depth_v(type(start)) > 2:
            continue
        plain = type(start)(dr.detach(start))
        size = float(np.max(np.abs(np.array(plain))))
        # A picture is no one number; 0 is the end of a range, where a lobe is turned off.
        if dr.width(plain) > 1 or size == 0:
            continue
        moved = type(start)(plain)
        dr.enable_grad(moved)
        dr.set_grad(moved, 1.0)
        moved_to(key, moved)
        result = value()
        said = np.zeros((len(wi), 1))
        if dr.grad_enabled(result):
            dr.forward_to(result)
            said = _numbers(dr.grad(result), len(wi))
        h, ends = STEP * size, []
        for step in (h, -h):
            moved_to(key, plain + step)
            ends.append(_numbers(value(), len(wi)))
        moved_to(key, plain)
        if said.any() or not np.array_equal(ends[0], ends[1]):  # else the values do not depend on it
            noise = 4 * 2.0**-24 * float(np.max(np.abs(ends[0]))) / h
            found[key] = Slopes(said, (ends[0] - ends[1]) / (2 * h), noise)
    return found
