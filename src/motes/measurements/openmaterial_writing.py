"""Writing ASAM OpenMATERIAL 3D ``.xompt``: a measurement of one time with wavelengths."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any
from uuid import NAMESPACE_URL, uuid5

import numpy as np

from motes.errors import DataError
from motes.files import write_text
from motes.measurements.measurement import Measurement
from motes.measurements.origin import not_measured

SCHEMA = "https://raw.githubusercontent.com/asam-ev/OpenMATERIAL-3D/refs/tags/v1.0.0/schemas/material_brdf_schema.json"
VERSION = "1.0.0"
UNKNOWN = "not stated"
METRE = 1e-9  # of a nanometre
LARGEST_POLAR, LARGEST_AZIMUTH = 1.570796, 6.283185  # of the schema


def write_openmaterial(
    measurement: Measurement,
    path: str | Path,
    *,
    metadata: Mapping[str, Any] | None = None,
    sources: str | None = None,
) -> list[str]:
    """Write a measurement; azimuths relative to that of the light, 0 on its side.

    Parameters
    ----------
    measurement
        What to write: one time, channels with wavelengths; masked samples become null.
    path
        The file.
    metadata
        Entries of the format's ``metadata`` that replace what is made here: authors, copyrights, licence.
    sources
        ``"measurement"`` or ``"simulation"``; what the provenance says when not given.

    Returns
    -------
    list of str
        What the format does not hold, as sentences.

    Raises
    ------
    DataError
        Without wavelengths, or with several times.
    """
    m = measurement
    if m.wavelengths is None:
        raise DataError(
            f"{m.name} has the channels {', '.join(m.channels)[:100]} and no wavelengths, which an OpenMATERIAL table needs",
            "Give wavelengths to from_arrays; csv and bird take any channels",
        )
    if m.n_times > 1:
        raise DataError(f"{m.name} has {m.n_times} times, and an OpenMATERIAL table one", "Take one: measurement.at(0)")
    usable = m.mask[0] & (m.values[0] >= 0)
    said = []
    if not usable.all():
        said.append(f"{int((~usable).sum()):,} masked or negative values became null.")
    if m.uncertainties is not None or m.common_uncertainty is not None:
        said.append("Uncertainties are left out: the format has no place for them.")
    azimuth = np.round(np.minimum(m.dphi % (2 * np.pi), LARGEST_AZIMUTH), 6)
    angles = np.round(np.stack([m.theta_i, m.theta_r], axis=-1), 6)
    angles = np.minimum(angles, LARGEST_POLAR)
    order = np.lexsort((azimuth, angles[:, 1], angles[:, 0]))
    rows: list[list[float | None]] = []
    for c in np.argsort(m.wavelengths).tolist():
        nm = float(f"{m.wavelengths[c] * METRE:.9g}")
        for n in order.tolist():
            value = float(f"{m.values[0, n, c]:.9g}") if usable[n, c] else None
            rows.append([nm, *(float(x) + 0.0 for x in angles[n]), float(azimuth[n]) + 0.0, value])
    p = m.provenance
    made = {
        "name": m.name,
        "description": str(p.get("description") or p.get("source") or UNKNOWN),
        "uuid": str(uuid5(NAMESPACE_URL, f"motes:{m.name}:{p.get('source')}")),
        "materialVersion": VERSION,
        "openMaterial3dVersion": VERSION,
        "copyrights": [UNKNOWN],
        "license": str(p.get("license") or UNKNOWN),
        "authors": [UNKNOWN],
        "sources": sources or ("simulation" if not_measured(p) else "measurement"),
        **(metadata or {}),
    }
    brdf = {"wavelengths": sorted({row[0] for row in rows if row[0] is not None}), "lookupTable": rows}
    document = {"$schema": SCHEMA, "metadata": made, "brdf": brdf}
    write_text(path, _text(document))
    return said


def _text(document: dict[str, Any]) -> str:
    """JSON with one row of the table a line."""
    rows = document["brdf"].pop("lookupTable")
    head = json.dumps(document, indent=1, ensure_ascii=False, allow_nan=False)
    table = ",\n   ".join(json.dumps(row, allow_nan=False) for row in rows)
    closing = head.rindex("}", 0, head.rindex("}"))
    return head[:closing].rstrip() + f',\n  "lookupTable": [\n   {table}\n  ]\n }}\n}}\n'
