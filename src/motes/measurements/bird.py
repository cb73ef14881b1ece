"""BiRD JSON, the universal BRDF format of EURAMET 16NRM08: columns ``theta_i, phi_i, theta_r, phi_r, BRDF`` with their units,
and optionally ``uBRDF, wavelength_i, polarization_i, ...``, all of one length; metadata of sample and instrument.

Uncertainties are read from ``uBRDF`` (a value a sample) or ``BRDF.uncertainty`` (one for all), in 1/sr or percent.  The schema
has no coverage factor: they are taken as standard uncertainties unless ``coverage`` says otherwise.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import DataError, FormatError, MotesError
from motes.files import budget, reading
from motes.files.structured import json_object
from motes.measurements._long_table import pivot
from motes.measurements.measurement import Measurement

NAME = "bird"
SOURCE = "BiRD universal BRDF data format (EURAMET 16NRM08)"
SAMPLE = 300  # bytes of memory a row
SNIFFED = 65536  # bytes that are looked at
ANGLES = ("theta_i", "phi_i", "theta_r", "phi_r")
ANGLE_UNITS = {"deg": np.pi / 180, "°": np.pi / 180, "rad": 1.0}
LENGTHS = {"nm": 1.0, "μm": 1e3, "µm": 1e3, "um": 1e3}
HOURS = {"s": 1 / 3600, "min": 1 / 60, "h": 1.0, "d": 24.0, "scan": 1.0}
PER_STERADIAN = ("1/sr", "sr^-1")
NOT_MEASURED = "not measured at this wavelength, polarisation or time"
STATES = {"s": "s", "p": "p", "u": ""}  # how they are named in channels

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or not head.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"{"):
        return False
    known = (b"brdf_json_schema", b'"theta_r"', b'"uBRDF"', b'"BRDF"')
    more = reading.head(path, SNIFFED) if path.is_file() else head  # the metadata come first, and may be long
    return any(word in more for word in known)


def read_bird(path: Path, *, coverage: float = 1.0, polarization: str | None = None) -> Measurement:
    """The data of a file; wavelengths and polarisations as channels, a variable ``time`` as times.

    Parameters
    ----------
    path
        The JSON file.
    coverage
        The coverage factor k of its uncertainties: 2 where they are expanded ones.
    polarization
        ``"s"``, ``"p"`` or ``"u"`` to read one state of the light; ``"mean"`` for the mean of s and p, which is
        unpolarised light.  Every state is a channel where it is not given.
    """
    if not 0 < coverage <= 10:
        raise MotesError(
            f"coverage = {coverage!r} is no coverage factor", "Give 1 for standard uncertainties, 2 for k = 2"
        )
    if polarization not in (None, "s", "p", "u", "mean"):
        raise MotesError(f"polarization = {polarization!r}", "Give s, p, u or mean")
    document = json_object(path)
    data = document.get("data")
    if not isinstance(data, dict):
        raise FormatError(
            f"{path} has no object 'data', only {', '.join(map(str, document))[:100]}", "The schema asks for it"
        )
    metadata = document.get("metadata")
    notes = ["f_r in 1/sr"]
    f = _column(path, data, "BRDF")
    budget.check(path, SAMPLE * len(f), f"{len(f):,} rows")
    _unit(path, data["BRDF"], "BRDF", dict.fromkeys(PER_STERADIAN, 1.0))
    angles = np.stack([_angle(path, data, name, len(f)) for name in ANGLES], axis=-1)
    nm = _wavelengths(path, data, len(f), notes)
    state = _polarizations(path, data, len(f), polarization, notes)
    hours, unit = _times(path, data, len(f))
    own, own_names = _own_channels(path, data, len(f))
    u = _uncertainties(path, data, f, coverage, notes)
    wanted = {"mean": ["s", "p"], None: sorted(set(state))}.get(polarization, [str(polarization)])
    kept: NDArray[np.bool_] = np.asarray(np.isin(state, wanted))
    if not kept.any():
        raise DataError(
            f"{path} holds no light of polarisation {polarization}", f"It holds {', '.join(sorted(set(state)))}"
        )
    angles, (times, lengths, codes, states), (values, spread), present = pivot(
        angles[kept], [hours[kept], nm[kept], own[kept], state[kept]], [f[kept], u[kept]], path
    )
    if polarization == "mean":
        if len(states) < 2:
            raise DataError(
                f"{path} holds no s and p to take the mean of, only {', '.join(map(str, states))}", "Leave it out"
            )
        values, spread = values.mean(axis=-1, keepdims=True), np.sqrt(np.sum(spread**2, axis=-1, keepdims=True)) / 2
        present, states = np.asarray(present.all(axis=-1, keepdims=True)), np.array(["u"])
        notes.append("Each value is the mean of s and p polarised light")
    wi = directions.from_spherical(angles[:, 0], angles[:, 1])
    wo = directions.from_spherical(angles[:, 2], angles[:, 3])
    values, spread = (np.moveaxis(a, 1, 0).reshape(len(times), len(wi), -1) for a in (values, spread))
    present = np.moveaxis(present, 1, 0).reshape(values.shape)
    spectral = bool(np.all(lengths > 0))
    names = [_name(w, own_names[int(c)], str(s), spectral, len(states)) for w in lengths for c in codes for s in states]
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        times=times if len(times) > 1 else None,
        time_unit=unit,
        channels=names,
        wavelengths=np.repeat(lengths, len(codes) * len(states)) if spectral else None,
        reasons={NOT_MEASURED: ~present},
        uncertainties=spread if np.isfinite(spread).any() else None,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": _say(metadata, "sample", "name") or path.stem,
            "source": SOURCE,
            **_provenance(metadata),
            "notes": notes,
        },
    )


def _provenance(metadata: Any) -> dict[str, str]:
    """What the metadata say of where the numbers come from, as words."""
    places = {
        "organization": ("provenance", "organization"),
        "contact": ("provenance", "contact_person"),
        "method": ("method",),
        "timestamp": ("timestamp",),
        "description": ("description",),
        "instrument": ("instrumentation", "name"),
        "software": ("software", "name"),
        "license": ("license", "type"),
        "sample_type": ("sample", "type"),
        "zero_azimuth": ("sample", "zero_azimuth_location"),
        "id": ("id",),
    }
    said = {name: _say(metadata, *place) for name, place in places.items()}
    return {name: text for name, text in said.items() if text}


def _say(element: Any, *place: str) -> str:
    for name in place:
        element = element.get(name) if isinstance(element, dict) else None
    return element[:500] if isinstance(element, str) else ""


def _name(nm: float, own: str, state: str, spectral: bool, n_states: int) -> str:
    words = [f"{nm:g} nm"] if spectral else []
    words.append(own)
    if n_states > 1 or state not in ("u", ""):
        words.append(STATES.get(state, state))
    return " ".join(word for word in words if word) or "grey"


def _object(path: Path, data: dict[str, Any], name: str) -> dict[str, Any]:
    found = data.get(name)
    if not isinstance(found, dict) or not isinstance(found.get("values"), list):
        raise FormatError(f"{path}: data.{name} has no list of values", "The schema asks for unit and values")
    return found


def _column(path: Path, data: dict[str, Any], name: str, n: int | None = None) -> Array:
    values = _object(path, data, name)["values"]
    reading.require(bool(values), f"{path}: data.{name} is empty", "It needs at least one value")
    for k, x in enumerate(values):
        if type(x) not in (int, float):
            raise FormatError(
                f"{path}: value {k + 1} of data.{name} is {str(x)[:40]!r}, not a number", "Check the file"
            )
    if n is not None and len(values) != n:
        raise FormatError(f"{path}: data.{name} has {len(values)} values, and BRDF {n}", "All columns have one length")
    try:
        return np.array(values, np.float64)
    except OverflowError:
        raise FormatError(f"{path}: a value of data.{name} is too large", "Check the file") from None


def _unit(path: Path, column: dict[str, Any], name: str, known: dict[str, float]) -> float:
    unit = column.get("unit")
    if not isinstance(unit, str) or unit not in known:
        raise FormatError(f"{path}: the unit of {name} is {str(unit)[:40]!r}", f"The schema has {', '.join(known)}")
    return known[unit]


def _angle(path: Path, data: dict[str, Any], name: str, n: int) -> Array:
    column = _column(path, data, name, n)
    scale = _unit(path, data[name], name, ANGLE_UNITS)
    angles = column * scale
    largest = np.pi / 2 if name.startswith("theta") else 2 * np.pi
    bad = ~(np.abs(angles) <= largest + 1e-4)
    if bad.any():
        k = int(np.argmax(bad))
        raise FormatError(
            f"{path}: value {k + 1} of data.{name} is {column[k]:g} {data[name]['unit']}",
            f"It is at most {np.degrees(largest):g} degrees; check the unit",
        )
    return angles


def _wavelengths(path: Path, data: dict[str, Any], n: int, notes: list[str]) -> Array:
    """[nm] a row; 0 where the file has none."""
    names = [name for name in ("wavelength_i", "wavelength_r") if name in data]
    columns = [_column(path, data, name, n) * _unit(path, data[name], name, LENGTHS) for name in names]
    for name, column in zip(names, columns, strict=True):
        reading.require(
            bool(np.all(np.isfinite(column) & (column > 0))),
            f"{path}: data.{name} has a value not above 0",
            "Check the file",
        )
    if len(columns) == 2 and not np.allclose(columns[0], columns[1], rtol=1e-6):
        raise FormatError(
            f"{path}: wavelength_i and wavelength_r differ: the sample fluoresces", "Such data are not read"
        )
    if not columns:
        notes.append("No wavelength is given")
        return np.zeros(n)
    return np.asarray(np.round(columns[0], 6))


def _polarizations(path: Path, data: dict[str, Any], n: int, wanted: str | None, notes: list[str]) -> NDArray[np.str_]:
    """A word a row: s, p, u of the light, with ``>s`` where the receiver has one."""
    words = []
    for name in ("polarization_i", "polarization_r"):
        if name not in data:
            words.append(["u"] * n)
            continue
        column = _object(path, data, name)["values"]
        reading.require(
            len(column) == n, f"{path}: data.{name} has {len(column)} values, and BRDF {n}", "All have one length"
        )
        words.append([_state(path, name, x) for x in column])
    if any(w != "u" for w in words[1]):
        notes.append("The receiver is polarised: its state follows > in the names of channels")
    if wanted is None and len(set(words[0])) > 1:
        notes.append("Each polarisation of the light is a channel; polarization=mean gives unpolarised light")
    return np.array([i if r == "u" else f"{i}>{r}" for i, r in zip(*words, strict=True)])


def _state(path: Path, name: str, value: Any) -> str:
    if isinstance(value, str) and value in STATES:
        return value
    if isinstance(value, list) and len(value) == 4 and all(type(x) in (int, float) for x in value):
        known = {(1, 0, 0): "s", (-1, 0, 0): "p", (0, 0, 0): "u"}
        return known.get(tuple(value[1:]), "[" + " ".join(f"{x:g}" for x in value) + "]")
    raise FormatError(f"{path}: {str(value)[:40]} in data.{name}", "It is s, p, u, or a Stokes vector of 4 numbers")


def _times(path: Path, data: dict[str, Any], n: int) -> tuple[Array, str]:
    """[h] a row, from a variable of the user's own called time."""
    own = data.get("adhoc_variables")
    time = own.get("time") if isinstance(own, dict) else None
    if time is None:
        return np.zeros(n), "h"
    assert isinstance(own, dict)
    column = _column(path, own, "time", n)
    reading.require(bool(np.all(np.isfinite(column))), f"{path}: a time is no number", "Check the file")
    scale = _unit(path, own["time"], "time", HOURS)
    return column * scale, "scan" if own["time"]["unit"] == "scan" else "h"


def _own_channels(path: Path, data: dict[str, Any], n: int) -> tuple[NDArray[np.intp], list[str]]:
    """A number a row, and the names by number, from a variable of the user's own called channel."""
    own = data.get("adhoc_variables")
    if not isinstance(own, dict) or "channel" not in own:
        return np.zeros(n, np.intp), [""]
    values = _object(path, own, "channel")["values"]
    if len(values) != n or not all(isinstance(x, str) and 0 < len(x) <= 100 for x in values):
        raise FormatError(f"{path}: the variable channel does not hold {n} names", "One word a value")
    names = list(dict.fromkeys(values))
    code = {name: k for k, name in enumerate(names)}
    return np.array([code[x] for x in values], np.intp), names


def _uncertainties(path: Path, data: dict[str, Any], f: Array, coverage: float, notes: list[str]) -> Array:
    """One standard deviation [1/sr] a row, NaN where there is none."""
    if "uBRDF" in data:
        u, unit = _column(path, data, "uBRDF", len(f)), data["uBRDF"].get("unit")
    else:
        one = data["BRDF"].get("uncertainty")
        if not isinstance(one, dict):
            return np.full(len(f), np.nan)
        if type(one.get("value")) not in (int, float):
            raise FormatError(f"{path}: the uncertainty of BRDF is {str(one.get('value'))[:40]!r}", "It is a number")
        u, unit = np.full(len(f), float(one["value"])), one.get("unit")
    if unit == "%":
        u = u / 100 * np.abs(f)
    elif unit not in PER_STERADIAN:
        raise FormatError(
            f"{path}: the unit of the uncertainty is {str(unit)[:40]!r}", "The schema has 1/sr, sr^-1 and %"
        )
    bad = ~np.isfinite(u) | (u <= 0)
    if bad.any():
        k = int(np.argmax(bad))
        raise FormatError(
            f"{path}: uncertainty {k + 1} is {u[k]:g}; {int(bad.sum())} of {len(u)} are not above 0",
            "Leave uBRDF out where the uncertainty is not known",
        )
    notes.append(
        "Uncertainties are taken as standard ones (k = 1); the schema has no coverage factor, coverage=2 halves them"
        if coverage == 1
        else f"Uncertainties were divided by the coverage factor {coverage:g}"
    )
    return u / coverage
