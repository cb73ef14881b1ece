"""Writing BiRD JSON: a measurement with its uncertainties, times and provenance, valid by the schema of EURAMET 16NRM08."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from uuid import NAMESPACE_URL, uuid5

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import DataError
from motes.files import write_text
from motes.measurements.measurement import Measurement

SCHEMA = "https://raw.githubusercontent.com/BiRD-project/BiRD_view/master/BRDF_JSON_schema/brdf_json_schema_v1.0.json"
UNKNOWN = "not stated"
NO_TIME = "1970-01-01T00:00:00+00:00"  # the schema asks for one
DIGITS = 9
LARGEST_THETA = 90.0  # the schema wants less than that
STATES = ("s", "p", "u")


def write_bird(
    measurement: Measurement,
    path: str | Path,
    *,
    metadata: Mapping[str, Any] | None = None,
    method: str = "measurement",
) -> list[str]:
    """Write a measurement.

    Parameters
    ----------
    measurement
        What to write; masked samples are left out.
    path
        The file.
    metadata
        Parts of the format's ``metadata`` that replace what is made here, merged object by object: the schema asks for an
        organisation, a contact, an instrument and a sample, which a measurement knows only where it was read with them.
    method
        ``"measurement"`` or ``"simulation"``.

    Returns
    -------
    list of str
        What the format does not hold, as sentences.

    Raises
    ------
    DataError
        When no sample can be written.
    """
    m = measurement
    theta_i, theta_r = np.degrees(m.theta_i), np.degrees(m.theta_r)
    phi_i, phi_r = (np.degrees(directions.phi(w)) % 360 for w in (m.wi, m.wo))
    usable = m.mask & (theta_i < LARGEST_THETA)[None, :, None] & (theta_r < LARGEST_THETA)[None, :, None]
    negative = usable & (m.values < 0)
    kept = usable & ~negative
    if not kept.any():
        raise DataError(f"{m.name} has no sample that a BiRD file can hold", "They need values >= 0 below 90 degrees")
    said = []
    if negative.any():
        said.append(f"{int(negative.sum()):,} negative values are left out: the schema has no place for them.")
    if (m.mask & ~usable).any() or (~m.mask).any():
        said.append(f"{int((~usable).sum()):,} masked samples are left out.")
    time, direction, channel = np.nonzero(kept)

    def column(unit: str, values: NDArray[np.float64]) -> dict[str, Any]:
        return {"unit": unit, "values": [round(x, DIGITS) + 0.0 for x in values.tolist()]}

    data: dict[str, Any] = {
        "theta_i": column("deg", theta_i[direction]),
        "phi_i": column("deg", _below_360(phi_i[direction])),
        "theta_r": column("deg", theta_r[direction]),
        "phi_r": column("deg", _below_360(phi_r[direction])),
        "BRDF": {"unit": "sr^-1", "values": _significant(m.values[kept])},
    }
    data |= _uncertainty(m, kept, said)
    if m.wavelengths is not None:
        data["wavelength_i"] = column("nm", m.wavelengths[channel])
    states = _states(m)
    if states is not None:
        data["polarization_i"] = {"notation": "sp", "values": [states[c] for c in channel.tolist()]}
    own: dict[str, Any] = {}
    if m.wavelengths is None and m.n_channels > 1:
        names = [m.channels[c] for c in channel.tolist()]
        own["channel"] = {"description": "Name of the channel.", "unit": "", "type": "string", "values": names}
    if m.n_times > 1:
        unit = m.time_unit if m.time_unit in ("s", "min", "h", "d") else "scan"
        values = [round(x, DIGITS) for x in m.times[time].tolist()]
        own["time"] = {"description": "Time of the scan.", "unit": unit, "type": "number", "values": values}
    if own:
        data["adhoc_variables"] = own
    document = {"metadata": _merged(_metadata(m, method), metadata or {}), "data": data}
    write_text(path, json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False) + "\n")
    return said


def _below_360(degrees: NDArray[np.float64]) -> NDArray[np.float64]:
    rounded = np.round(degrees, DIGITS)
    return np.where(rounded >= 360, 0.0, rounded)


def _significant(values: NDArray[np.float64]) -> list[float]:
    return [float(f"{x:.10g}") for x in values.tolist()]


def _uncertainty(m: Measurement, kept: NDArray[np.bool_], said: list[str]) -> dict[str, Any]:
    if m.common_uncertainty is not None:
        said.append(
            f"The uncertainty of the scale that all samples share, {m.common_uncertainty:.2%}, stands in the comments only."
        )
    if m.uncertainties is None:
        return {}
    u = m.uncertainties[kept]
    if not np.all(np.isfinite(u)):
        unknown = int(np.count_nonzero(~np.isfinite(u)))
        said.append(
            f"Uncertainties are left out: {unknown:,} of {u.size:,} are not known, and the format has a number for each."
        )
        return {}
    comments = "Standard uncertainties (k = 1)."
    return {"uBRDF": {"unit": "sr^-1", "values": _significant(u), "comments": comments}}


def _states(m: Measurement) -> list[str] | None:
    """The polarisation of each channel, where the names of channels say it: ``550 nm s``."""
    last = [name.rpartition(" ")[2] if " " in name or name in STATES else "" for name in m.channels]
    if not any(word in ("s", "p") for word in last):
        return None
    return [word if word in STATES else "u" for word in last]


def _metadata(m: Measurement, method: str) -> dict[str, Any]:
    from motes.version import __version__

    p = m.provenance
    source = str(p.get("source") or UNKNOWN)
    comments = [f"Written by Motes {__version__}.", f"Source: {source}.", *(f"{note}." for note in p.get("notes", ()))]
    if m.common_uncertainty is not None:
        comments.append(f"All values share a relative standard uncertainty of scale of {m.common_uncertainty:.4g}.")
    if not p.get("timestamp"):
        comments.append("The time is not known, and the timestamp stands for that.")
    made: dict[str, Any] = {
        "schema": SCHEMA,
        "id": f"urn:uuid:{uuid5(NAMESPACE_URL, f'motes:{m.name}:{source}')}",
        "type": "BRDF",
        "timestamp": str(p.get("timestamp") or NO_TIME),
        "provenance": {
            "organization": str(p.get("organization") or UNKNOWN),
            "location": dict.fromkeys(("country", "city", "street", "building_nr", "postal_code"), UNKNOWN),
            "email": UNKNOWN,
            "contact_person": str(p.get("contact") or UNKNOWN),
        },
        "description": str(p.get("description") or m.name),
        "method": method,
        "instrumentation": "NA",
        "software": {"name": "Motes", "version": __version__},
        "sample": {
            "name": m.name,
            "type": str(p.get("sample_type") or UNKNOWN),
            "dimensions": {},
            "shape": UNKNOWN,
            "zero_azimuth_location": str(p.get("zero_azimuth") or UNKNOWN),
        },
        "environment": "NA",
        "comments": " ".join(comments),
    }
    return made


def _merged(base: dict[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    result = dict(base)
    for name, value in changes.items():
        old = result.get(name)
        result[name] = _merged(old, value) if isinstance(old, dict) and isinstance(value, Mapping) else value
    return result
