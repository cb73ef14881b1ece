"""LightTools BSDF (``.bsdf`` text): scatter about the normal, a table each side, wavelength and angle of incidence.

Keywords ``Symmetry, SpectralContent, ScatterAzimuth, ScatterRadial`` with their angles [deg], then blocks of ``AOI, POI, Side,
Wavelength, ScatterType, TIS`` (and ``TristimulusValue``) with a row of BSDF values [1/sr] an azimuth, a column a radial angle.

By second hand: no specification was at hand but what the reader of the public program BSDF Processor (K. Ryo) does.  There
the light lies at the azimuth 90 + POI; POI counts the rotation of the sample.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError
from motes.files import budget, reading
from motes.measurements._keyword_text import Keywords, choice, told_apart
from motes.measurements.measurement import Measurement

NAME = "lighttools"
SOURCE = "LightTools BSDF file"
SAMPLE = 220  # bytes of memory a sample
LIGHT = 90.0  # azimuth of the light [deg] at POI = 0
_SIDES = {"front": "Front", "back": "Back"}
_TRISTIMULUS = {"trisx": "X", "trisy": "Y", "trisz": "Z"}

Array = NDArray[np.float64]


@dataclass(frozen=True)
class _Block:
    """One table: where the light is [deg], what it is of, and its values (azimuths x radials)."""

    incidence: float
    rotation: float
    channel: str
    values: Array


def sniff(path: Path, head: bytes) -> bool:
    words = head.decode("latin-1").lower()
    if path.is_dir() or b"\0" in head or "scatterazimuth" not in words:
        return False
    return "angleofincidence" not in words and "scatterradial" in words


def read_lighttools(path: Path, *, side: str = "front") -> Measurement:
    """The BRDF of one side; wavelengths, or X, Y and Z, as channels.

    Parameters
    ----------
    path
        The file.
    side
        ``"front"`` or ``"back"``.
    """
    choice(side, _SIDES, str(path), "side")
    text = Keywords(path)
    grids: dict[str, Array] = {}
    blocks: list[_Block] = []
    others = 0
    state: dict[str, str] = {}
    while text.more():
        where, word = text.where(), text.word()
        if word in ("scatterazimuth", "scatterradial"):
            grids[word] = text.angles()
        elif word == "tis":
            text.value()
            reading.require(len(grids) == 2, f"{where}: a table before its angles", "The file is damaged")
            inner = len(grids["scatterazimuth"]) * len(grids["scatterradial"])
            budget.check(path, SAMPLE * inner * (len(blocks) + 1), f"{len(blocks) + 1} tables of {inner} directions")
            values = text.numbers(inner, "a table")
            if state.get("side", "front").lower() == side and state.get("scattertype", "brdf").upper() == "BRDF":
                blocks.append(_block(state, values, where))
            else:
                others += 1
        else:
            state[word] = text.value()
    reading.require(
        bool(blocks),
        f"{path} holds no BRDF of the {side}, only {others} other tables",
        "It is truncated, or another side",
    )
    incidences = sorted({(b.incidence, b.rotation) for b in blocks})
    channels = list(dict.fromkeys(b.channel for b in blocks))
    n_out = len(blocks[0].values)
    budget.check(path, SAMPLE * n_out * len(incidences) * len(channels), "its tables")
    values = np.full((len(incidences), n_out, len(channels)), np.nan)
    for block in blocks:
        values[incidences.index((block.incidence, block.rotation)), :, channels.index(block.channel)] = block.values
    theta_i, rotation = np.deg2rad(np.array(incidences)).T
    azimuth, radial = (
        a.reshape(-1)
        for a in np.meshgrid(*(np.deg2rad(grids[k]) for k in ("scatterazimuth", "scatterradial")), indexing="ij")
    )
    wi = np.repeat(directions.from_spherical(theta_i, np.deg2rad(LIGHT) + rotation), n_out, axis=0)
    wo = np.tile(directions.from_spherical(radial, azimuth), (len(incidences), 1))
    flat = values.reshape(-1, len(channels))
    kept = told_apart(flat, len(grids["scatterazimuth"]), grids["scatterradial"])
    wi, wo, flat = wi[kept], wo[kept], flat[kept]
    nm = [float(c.removesuffix(" nm")) for c in channels] if all(c.endswith(" nm") for c in channels) else None
    notes = [
        "f_r in 1/sr; the light is taken to lie at the azimuth 90 degrees + POI: by second hand, see docs/formats.md"
    ]
    if others:
        notes.append(f"{others} tables of the other side or of transmission are not read")
    return Measurement.from_arrays(
        wi,
        wo,
        flat,
        channels=channels,
        wavelengths=nm,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.stem,
            "source": SOURCE,
            "comments": text.comments,
            "symmetry": state.get("symmetry", ""),
            "side": side,
            "notes": notes,
        },
    )


def _block(state: dict[str, str], values: Array, where: str) -> _Block:
    incidence, rotation = reading.numbers([state.get("aoi", "nan"), state.get("poi", "0")], where)
    if not (0 <= incidence < 90 and abs(rotation) <= 360):
        raise FormatError(f"{where}: AOI {incidence:g}, POI {rotation:g} degrees", "AOI lies from 0 to 90 degrees")
    channel = _TRISTIMULUS.get(state.get("tristimulusvalue", "").lower(), "")
    if not channel and "wavelength" in state:
        nm = float(reading.numbers([state["wavelength"].split()[0] if state["wavelength"] else "nan"], where)[0])
        reading.require(100 <= nm <= 1e5, f"{where}: the wavelength {nm:g} is none in nm", "LightTools writes nm")
        channel = f"{nm:g} nm"
    return _Block(float(incidence), float(rotation), channel or "grey", values)
