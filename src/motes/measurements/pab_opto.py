"""pab-opto goniophotometer text (pg2, program Mountain), as Radiance's ``pabopto2bsdf`` reads it: a file an incident direction.

Header lines ``#sample_name "..."``, ``#format: theta phi BSDF`` (or BRDF; DSF is f cos(theta)), ``#intheta``, ``#inphi`` (or
``#incident_angle theta phi``), ``#upphi``, ``#colorimetry: CIE-Y | CIE-XYZ``; then rows ``theta phi value``, degrees, both
directions in one spherical system, counter-clockwise seen from the front.  Polar angles above 90 degrees are behind.
A folder of such files is one measurement.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError
from motes.files import budget, reading
from motes.files.structured import number_list
from motes.measurements.measurement import Measurement

NAME = "pab-opto"
SOURCE = "pab advanced technologies, goniophotometer pg2"
SAMPLE = 160  # bytes of memory a row
MOST_FILES = 10_000
TRANSMITTED = "on the other side of the surface than the light"
_INCIDENT = re.compile(rb"^#\s*(?:incident_angle|intheta)\b", re.MULTILINE)
_FORMAT = re.compile(rb"^#\s*format:\s*theta\s+phi\b", re.MULTILINE)

Array = NDArray[np.float64]


@dataclass(frozen=True)
class _Scan:
    """One file."""

    name: str
    theta_i: float
    phi_i: float
    up: float
    divided: bool
    channels: tuple[str, ...]
    rows: Array


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return any(True for _ in _files(path))
    return bool(_INCIDENT.search(head) and _FORMAT.search(head))


def read_pab_opto(path: Path) -> Measurement:
    """The scans of a file or of all files in a folder, each at its incident direction."""
    files = sorted(_files(path)) if path.is_dir() else [path]
    reading.require(bool(files), f"{path} holds no pab-opto file", "They start with lines such as #intheta")
    reading.require(
        len(files) <= MOST_FILES, f"{path} holds {len(files):,} files", f"At most {MOST_FILES:,} are read at once"
    )
    scans = [_scan(file) for file in files]
    for file, scan in zip(files, scans, strict=True):
        reading.require(
            scan.channels == scans[0].channels,
            f"{file} has the channels {', '.join(scan.channels)}, and {files[0]} {', '.join(scans[0].channels)}",
            "Read them apart",
        )
    wi, wo, values, through = (np.concatenate(part) for part in zip(*map(_samples, scans), strict=True))
    reading.require(not through.all(), f"{path} holds transmission only", "Only reflection is read")
    behind = sorted({scan.theta_i > 90 for scan in scans})
    reading.require(len(behind) == 1, f"{path} has light from both sides", "Read the files of each side apart")
    notes = ["f_r in 1/sr, read from DSF divided by cos(theta)" if scans[0].divided else "f_r in 1/sr"]
    notes.append("Azimuths are turned so that the sample's up (#upphi) is 90 degrees, as in Radiance")
    if behind[0]:
        notes.append("The light comes from behind: seen from there, turned by 180 degrees about the y axis")
    names = {scan.name for scan in scans if scan.name}
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        channels=scans[0].channels,
        reasons={TRANSMITTED: through[None, :, None]},
        provenance={
            "format": NAME,
            "path": str(path),
            "name": ", ".join(sorted(names))[:200] or path.stem,
            "source": SOURCE,
            "files": len(files),
            "notes": notes,
        },
    )


def _files(folder: Path) -> list[Path]:
    found = []
    for file in folder.iterdir():
        if file.suffix.lower() in (".txt", ".dat", ".pab", ".bsdf") and file.is_file():
            head = reading.head(file)
            if b"\0" not in head and sniff(file, head):
                found.append(file)
    return found


def _scan(path: Path) -> _Scan:
    text = reading.text(path)
    header: dict[str, str] = {}
    end = 0
    for match in re.finditer(r"^[ \t]*#[ \t]*([^\s:]+):?[ \t]*(.*)$\n?|^[ \t]*$\n", text, re.MULTILINE):
        if match.start() != end:
            break
        end = match.end()
        if match[1]:
            header[match[1].lower()] = match[2].strip()
        if end == len(text):
            break
    kind = header.get("format", "").split()
    if [k.lower() for k in kind[:2]] != ["theta", "phi"] or len(kind) < 3:
        raise FormatError(f"{path} has the format {' '.join(kind)[:60]!r}", "theta phi BSDF, BRDF or DSF are read")
    quantity = kind[2].upper()
    if quantity not in ("BSDF", "BRDF", "DSF"):
        raise FormatError(f"{path} holds {quantity[:40]!r}", "BSDF, BRDF and DSF are read")
    angles = header.get("incident_angle", f"{header.get('intheta', 'nan')} {header.get('inphi', 'nan')}").split()
    theta_i, phi_i = reading.numbers([*angles, "nan", "nan"][:2], f"{path}, the incident angle")
    up = float(reading.numbers([(header.get("upphi", "") or "0").split()[0]], f"{path}, #upphi")[0])
    if not (0 <= theta_i <= 180 and abs(phi_i) <= 720 and abs(up) <= 720):
        raise FormatError(
            f"{path}: the incident angle is ({theta_i:g}, {phi_i:g}), up {up:g} degrees", "theta lies in 0 to 180"
        )
    colours = header.get("colorimetry", "CIE-Y").upper()
    if colours not in ("CIE-Y", "CIE-XYZ"):
        raise FormatError(f"{path} has the colorimetry {colours[:40]!r}", "CIE-Y and CIE-XYZ are read")
    channels = ("X", "Y", "Z") if colours == "CIE-XYZ" else ("Y",)
    budget.check(path, SAMPLE * ((len(text) - end) // 6 + 1), "its rows")
    numbers = number_list(text[end:], str(path))
    columns = 2 + len(channels)
    reading.require(
        len(numbers) > 0 and len(numbers) % columns == 0,
        f"{path}: {len(numbers):,} numbers are no rows of theta, phi and {len(channels)} values",
        "It is truncated or damaged",
    )
    name = header.get("sample_name", "").strip('"')[:200]
    return _Scan(name, float(theta_i), float(phi_i), up, quantity == "DSF", channels, numbers.reshape(-1, columns))


def _samples(scan: _Scan) -> tuple[Array, Array, Array, NDArray[np.bool_]]:
    """wi, wo (n, 3) with the light above, values (n, C), and which are transmitted."""
    turn = np.deg2rad(90 - scan.up)
    with np.errstate(invalid="ignore"):
        wo = directions.from_spherical(np.deg2rad(scan.rows[:, 0]), np.deg2rad(scan.rows[:, 1]) + turn)
    if not np.all(np.isfinite(scan.rows[:, :2])):
        raise FormatError("a row of pab-opto data has an angle that is no number", "Check the rows of the file")
    wi = np.broadcast_to(directions.from_spherical(np.deg2rad(scan.theta_i), np.deg2rad(scan.phi_i) + turn), wo.shape)
    values = scan.rows[:, 2:]
    if scan.divided:
        with np.errstate(divide="ignore", invalid="ignore"):
            values = values / np.abs(wo[:, 2:])
    if scan.theta_i > 90:
        around = np.array([-1.0, 1.0, -1.0])
        wi, wo = wi * around, wo * around
    return wi, wo, values, wo[:, 2] < 0
