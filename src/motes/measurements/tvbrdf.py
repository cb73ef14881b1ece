"""The TVBRDF database (Sun, Sunkavalli, Ramamoorthi, Belhumeur, Nayar 2006/2007): surfaces that dry, dust over and
decay, scan by scan.

``sampleNN/tvBrdf-info.txt`` (name and process, exposures, number of scans, time stamps) and
``sampleNN/tvBrdf-data/scanTT_brdf_cameraV_allexposures.txt``, TT from 01, V from 1 to 4: a line ``Exposure 0.2 4.0
32.0``, then triples of lines ``F b g r`` (radiance, blue first), ``L x y z`` (to the light), ``V x y z`` (to the
viewer).

Scale.  F is a radiance L_r, and f_r = L_r / (E cos(theta_i)) where E is the irradiance of a surface that faces the
light.  E is not published; with ``irradiance = 1`` the BRDF, and every K_d, K_s and w fitted to it, carries the unknown
scale of the source.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import directions
from motes.errors import DataError, FormatError
from motes.files import reading
from motes.measurements import _common_directions, _timestamps, policy
from motes.measurements.measurement import Measurement
from motes.measurements.origin import is_simulated

NAME = "tvbrdf"
SOURCE = "in the layout of the TVBRDF database (Sun, Sunkavalli, Ramamoorthi, Belhumeur, Nayar, IEEE TVCG 13(3), 2007)"
INFO, DATA = "tvBrdf-info.txt", "tvBrdf-data"
SCAN = re.compile(r"scan(\d{1,6})_brdf_camera(\d{1,3})_allexposures\.txt", re.IGNORECASE)
SAMPLE = re.compile(r"sample[-_]?(\w{1,40})", re.IGNORECASE)
N_CAMERAS = 4
# More absent scans than this many times the present ones: the numbers in the names are not scans.
MOST_ABSENT = 9


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir():
        return bool(_scan_files(path)) or bool(_sample_folders(path)) or (path / INFO).is_file()
    lines = head.decode("utf-8", errors="replace").split("\n")
    words = [line.split()[:1] for line in lines if line.strip()][:4]
    return words in ([["Exposure"], ["F"], ["L"], ["V"]], [["F"], ["L"], ["V"], ["F"]], [["F"], ["L"], ["V"]])


def samples(path: Path) -> list[str]:
    """The sample folders of a database folder; none for a sample folder."""
    return list(_sample_folders(path)) if path.is_dir() and not _scan_files(path) else []


def read_tvbrdf(
    path: Path, *, sample: int | str | None = None, times: ArrayLike | None = None, irradiance: float | None = None
) -> Measurement:
    """A sample: all its scans and cameras on one set of directions.

    Parameters
    ----------
    path
        A sample folder (or one scan file), or the database folder with `sample`.
    sample
        Name or number of a sample folder, where `path` holds several.
    times
        Hours of the scans, instead of the time stamps.
    irradiance
        E, at normal incidence, in the unit of F times sr.  The default is what the info file says, as `write_tvbrdf`
        does, or else 1.

    Notes
    -----
    Scans and cameras that are missing are masked as "not measured in this scan".  Where the time stamps cannot be read
    the times are the indices of the scans, with the unit "scan"; see ``provenance["notes"]``.
    """
    folder = _choose(path, sample)
    files = _scan_files(folder) if folder.is_dir() else {(1, 1): folder}
    info = _Info.of(folder)
    notes = []
    n_found = len({scan for scan, _ in files})
    reading.require(
        n_found > 0, f"{folder} holds no scan file", f"Expected {DATA}/scan01_brdf_camera1_allexposures.txt and so on"
    )
    n_scans = max(scan for scan, _ in files)
    reading.require(
        n_scans <= n_found * (1 + MOST_ABSENT),
        f"{folder} holds files of {n_found} scans, numbered up to {n_scans}",
        "Number the scans from 01 without large gaps",
    )
    if info.n_scans and n_scans < info.n_scans <= n_found * (1 + MOST_ABSENT):
        n_scans = info.n_scans
    elif info.n_scans and info.n_scans != n_scans:
        notes.append(f"The info file says {info.n_scans} scans; the files are numbered up to {n_scans}")

    cameras = sorted({camera for _, camera in files})
    directions_of, values_of = [], []
    for camera in cameras:
        blocks = [
            _triples(files[t, camera]) if (t, camera) in files else np.empty((0, 9)) for t in range(1, n_scans + 1)
        ]
        union, indices = _common_directions.union([block[:, 3:] for block in blocks])
        spread, present = _common_directions.spread(
            len(union), indices, [block[:, 2::-1] for block in blocks], 3, str(folder)
        )
        directions_of.append(union)
        values_of.append((spread, present))
    pairs = np.concatenate(directions_of)
    wi, wo = policy.unit_directions(pairs[:, :3], f"{folder}: L"), policy.unit_directions(pairs[:, 3:], f"{folder}: V")
    radiance = np.concatenate([v for v, _ in values_of], axis=1)
    present = np.concatenate([p for _, p in values_of], axis=1)

    stated = irradiance if irradiance is not None else info.irradiance
    try:
        scale = 1.0 if stated is None else float(stated)
    except (TypeError, ValueError, OverflowError):
        scale = np.nan
    if not 0 < scale < np.inf:
        raise DataError(f"irradiance = {stated!r:.40} is not positive", "It is that of a surface facing the light")
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        values = radiance / (scale * wi[:, 2:])
    values[:, ~directions.above(wi)] = np.nan
    if stated is None:
        meaning = "f_r = F / cos(theta_i): the irradiance is unknown, so K_d, K_s and w carry the scale of the source"
    else:
        origin = "as given" if irradiance is not None else f"from {INFO}"
        meaning = f"f_r = F / (E cos(theta_i)) in 1/sr with E = {scale:g}, {origin}"
    notes = [meaning, *notes]
    notes += _absences(files, n_scans)
    hours, unit = _times(times, info.text, n_scans, notes)
    return Measurement.from_arrays(
        wi,
        wo,
        values,
        times=hours,
        time_unit=unit,
        channels=("R", "G", "B"),
        reasons={policy.NOT_MEASURED: ~present[:, :, None], policy.CLIPPED: policy.clipped(wi, wo, radiance)},
        provenance={
            "format": NAME,
            "path": str(path),
            "sample": folder.name,
            "name": info.name or folder.name,
            "source": info.source or SOURCE,
            **({"simulated": True} if is_simulated(info.source) else {}),
            "exposures": info.exposures,
            "irradiance": scale,
            "notes": notes,
        },
    )


@dataclass(frozen=True)
class _Info:
    """What could be made out of ``tvBrdf-info.txt``, whose exact text is not published."""

    text: str = ""
    name: str = ""
    exposures: tuple[float, ...] = ()
    n_scans: int = 0
    irradiance: float | None = None
    source: str = ""

    @classmethod
    def of(cls, folder: Path) -> _Info:
        file = (
            next((f for f in sorted(folder.iterdir()) if f.name.lower() == INFO.lower()), None)
            if folder.is_dir()
            else None
        )
        if file is None or not file.is_file():
            return cls()
        text = reading.text(file)
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        name, n_scans = "", 0
        exposures: tuple[float, ...] = ()
        irradiance: float | None = None
        source = ""
        for line in lines:
            label, _, value = (
                part.strip() for part in (line if ":" in line else line.replace("=", ":", 1)).partition(":")
            )
            low = label.lower()
            numbers = [
                float(x) for x in re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?:[eE][-+]?\d{1,2})?(?![\w.])", value or label)
            ]
            if low == "source":
                source = value[:200]
            elif "exposure" in low and not exposures:
                exposures = tuple(numbers[:32])
            elif "irradiance" in low and numbers:
                irradiance = numbers[0]
            elif (
                "scan" in low
                and re.search(r"num|#|count|total|scans", low)
                and len(numbers) == 1
                and not n_scans
                and numbers[0] < 1e6
            ):
                n_scans = int(numbers[0])
            elif ("name" in low or "sample" in low) and value and not name:
                name = value
        # "Sample Name (Process)" may well stand there without a label
        if (
            not name
            and lines
            and ":" not in lines[0]
            and not re.search(r"exposure|scans?\b|\d:\d", lines[0], re.IGNORECASE)
        ):
            name = lines[0]
        return cls(text, name[:200], exposures, n_scans, irradiance, source)


def _choose(path: Path, sample: int | str | None) -> Path:
    folders = _sample_folders(path) if path.is_dir() and not _scan_files(path) else {}
    if not folders:
        if sample is not None and path.is_dir() and _matches(path.resolve().name, sample):
            return path
        if sample is not None:
            raise FormatError(f"{path} is one sample, not sample {sample!s:.40}", "Leave sample out")
        return path
    chosen = [f for name, f in folders.items() if sample is not None and _matches(name, sample)]
    if sample is None and len(folders) == 1:
        chosen = list(folders.values())
    if len(chosen) != 1:
        what = f"holds {len(folders)} samples" if sample is None else f"has no sample {sample!s:.40}"
        raise FormatError(f"{path} {what}", f"Choose one with --sample: {', '.join(folders)}")
    return chosen[0]


def _matches(name: str, sample: int | str) -> bool:
    """Whether a folder called sample07 is meant by "sample07", "07" or 7."""
    number = SAMPLE.fullmatch(name)
    ours, theirs = number[1] if number else name, str(sample).strip()
    if name == theirs or ours == theirs:
        return True
    a, b = reading.integer(ours), reading.integer(theirs)
    return a is not None and a == b


def _sample_folders(path: Path) -> dict[str, Path]:
    return {f.name: f for f in sorted(path.iterdir()) if f.is_dir() and ((f / INFO).is_file() or (f / DATA).is_dir())}


def _scan_files(folder: Path) -> dict[tuple[int, int], Path]:
    """(scan, camera) -> file, from the sample's data folder or the folder itself."""
    data = folder / DATA if (folder / DATA).is_dir() else folder
    found: dict[tuple[int, int], Path] = {}
    for file in sorted(data.iterdir()):
        match = SCAN.fullmatch(file.name)
        if match and int(match[1]) >= 1 and file.is_file():
            found[int(match[1]), int(match[2])] = file
    return found


def _triples(file: Path) -> NDArray[np.float64]:
    """Rows (M, 9) of F, L and V as written: b g r, x y z, x y z."""
    text = reading.text(file)
    tokens = text.split()
    if tokens and tokens[0].lower().startswith("exposure"):
        tokens = text.partition("\n")[2].split()
    labels = (tokens[0::12], tokens[4::12], tokens[8::12])
    n, rest = divmod(len(tokens), 12)
    for which, letter in enumerate("FLV"):
        wrong = next((i for i, label in enumerate(labels[which][:n]) if label != letter), None)
        if wrong is not None:
            raise FormatError(
                f"{file}, record {wrong + 1}: {labels[which][wrong][:40]!r} stands where {letter} is expected",
                "Records are: F b g r, L x y z, V x y z",
            )
    reading.require(rest == 0, f"{file} is truncated within record {n + 1}", "Fetch the file again")
    reading.require(n > 0, f"{file} holds no record", "Records are: F b g r, L x y z, V x y z")
    rows = np.array(tokens, object).reshape(n, 3, 4)[:, :, 1:].reshape(n, 9)
    try:
        values = rows.astype(np.float64)
    except ValueError:
        for record, row in enumerate(rows.tolist(), 1):  # find the record, for the message
            reading.numbers(row, f"{file}, record {record}")
        raise
    for start, letter in ((3, "L"), (6, "V")):
        policy.unit_directions(values[:, start : start + 3], f"{file}: {letter}")
    return values


def _absences(files: dict[tuple[int, int], Path], n_scans: int) -> list[str]:
    """Sentences on which scans and cameras are missing."""
    cameras = sorted({camera for _, camera in files})
    notes = []
    if len(files) > 1 and len(cameras) < N_CAMERAS:
        notes.append(
            f"Only camera{'s' if len(cameras) > 1 else ''} {', '.join(map(str, cameras))} of {N_CAMERAS} are there"
        )
    empty = [t for t in range(1, n_scans + 1) if not any((t, c) in files for c in cameras)]
    if empty:
        notes.append(f"Missing scans, masked: {_list(empty)}")
    partial = [
        f"{t} (camera {c})" for t in range(1, n_scans + 1) if t not in empty for c in cameras if (t, c) not in files
    ]
    if partial:
        notes.append(f"Missing cameras, masked: scan {_list(partial)}")
    return notes


def _list(items: Sequence[Any]) -> str:
    shown = ", ".join(str(i) for i in items[:10])
    return shown if len(items) <= 10 else f"{shown} and {len(items) - 10} more"


def _times(times: ArrayLike | None, text: str, n_scans: int, notes: list[str]) -> tuple[ArrayLike, str]:
    if times is not None:
        try:
            given = np.asarray(times, np.float64).reshape(-1)
        except (TypeError, ValueError, OverflowError):
            raise DataError(f"times = {times!r:.60} are not numbers", "Give the hours of all scans") from None
        if len(given) != n_scans:
            raise DataError(
                f"times has {len(given)} entries for {n_scans} scans",
                "Give the hours of all scans, missing ones included",
            )
        notes.append("Times as given by the caller, in hours")
        return given, "h"
    if n_scans == 1:
        return [0.0], "h"
    hours = _timestamps.hours(text, n_scans)
    if hours is None:
        notes.append(
            f"The time stamps could not be read from {INFO}: times are the indices of the scans. Give times in hours"
        )
        return np.arange(float(n_scans)), "scan"
    return hours, "h"
