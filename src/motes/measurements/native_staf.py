"""STAF folders as their authors published them (Gu et al. 2006): maps at measured times, or their fitted course.

``tvBTFss-info.txt`` names the sample; ``tvBTFss-time.txt`` has a row ``d:h:m:s`` a time.
``TSparamNew/tvBTFss-TT-xx-TSparam-{Kd,Ks,Sigma}.exr``: a map a time.
``SIM/tvBTFss-staf-{Kd,Ks,Sigma}-{A,B,C,D}.exr`` with ``...-staf-Kd-phi.txt`` (lines ``pphi_r: pphi_g: pphi_b:``) and
``...-staf-Ks-phi.txt`` (``pphi_Ks: pphi_S:``): p(x, y, t) = A phi((t - C)/B) + D, phi a polynomial of degree 6.
Stored Sigma is 1/sigma^2.  By description: no such file was at hand.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError, MotesError
from motes.files import reading
from motes.images import exr
from motes.measurements.tabulated_maps import TabulatedMaps

NAME = "native-staf"
SOURCE = "in the layout of the STAF database (Gu, Tu, Ramamoorthi, Belhumeur, Matusik, Nayar, ACM TOG 25(3), 2006)"
PARTS = ("Kd", "Ks", "Sigma")
DEGREE = 6
MOST_TIMES = 10_000
_MAP = re.compile(r"(tvBTF\d+)-(\d{1,4})-(?:\w+-)?TSparam-(Kd|Ks|Sigma)\.exr", re.IGNORECASE)
_COURSE = re.compile(r"(tvBTF\d+)-staf-(Kd|Ks|Sigma)-([ABCD])\.exr", re.IGNORECASE)
_CLOCK = re.compile(r"(?<![\d:])(\d+):(\d+):(\d+):(\d+(?:\.\d*)?)(?![\d:])")
_PHI = re.compile(r"^\s*pphi_(r|g|b|Ks|S)\s*:(.*)$", re.IGNORECASE | re.MULTILINE)

Array = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if not path.is_dir():
        return False
    return bool(_files(path / "TSparamNew", _MAP) or _files(path / "SIM", _COURSE))


def read_native_staf(path: Path, *, which: str | None = None, bgr: bool = False) -> TabulatedMaps:
    """The maps of a sample.

    Parameters
    ----------
    path
        Its folder.
    which
        ``"measured"`` (TSparamNew) or ``"fitted"`` (SIM); the measured ones where both are there.
    bgr
        Whether to swap R and B, which some of the tools that wrote such files did.
    """
    if not path.is_dir():
        raise FormatError(f"{path} is one file of a set", f"Give the folder of the sample: {path.parent.parent}")
    if which not in (None, "measured", "fitted"):
        raise MotesError(f"which = {which!r}", "Give measured or fitted")
    measured, fitted = _files(path / "TSparamNew", _MAP), _files(path / "SIM", _COURSE)
    if not (measured if which == "measured" else fitted if which == "fitted" else measured or fitted):
        raise FormatError(
            f"{path} holds no {which or 'STAF'} maps", "They lie in TSparamNew (measured) and SIM (fitted)"
        )
    notes = [
        "read as f_r = K_d/pi + K_s rho_s, sigma_s = 1/sqrt(Sigma) in radians; whether the source divides Kd by pi is not "
        "confirmed",
        "by description only: the layout was not tried on a file of the authors'",
    ]
    if bgr:
        notes.append("R and B were swapped, as asked")
    hours = _hours(path)
    use_measured = bool(measured) and which != "fitted"
    if use_measured:
        count, load, shape = _measured(path, measured, bgr)
    else:
        count, load, shape = _fitted(path, fitted, 30 if hours is None else len(hours), bgr)
        notes.append(
            "t is taken to run from 0 to 1 over the experiment, coefficients of phi from the highest power down"
        )
    unit = "h"
    if hours is None or len(hours) != count:
        found = "no" if hours is None else str(len(hours))
        notes.append(f"tvBTF..-time.txt gives {found} times for {count} maps, so they are numbered")
        hours, unit = np.arange(float(count)), "scan"
    return TabulatedMaps(
        hours=hours,
        load=load,
        shape=shape,
        time_unit=unit,
        provenance={
            "format": NAME,
            "path": str(path),
            "name": _name(path) or path.resolve().name,
            "source": SOURCE,
            "which": "measured" if use_measured else "fitted",
            "notes": notes,
        },
    )


def _files(folder: Path, pattern: re.Pattern[str]) -> dict[tuple[str, str], Path]:
    """(time or part, part or letter) -> file; the groups of the pattern but the first."""
    found: dict[tuple[str, str], Path] = {}
    if folder.is_dir():
        for file in folder.iterdir():
            match = pattern.fullmatch(file.name)
            if match and file.is_file():
                found[match[2], match[3]] = file
    return found


def _text(path: Path, end: str) -> str:
    for file in sorted(path.glob(f"tvBTF*{end}")):
        if file.is_file():
            return reading.text(file)
    return ""


def _name(path: Path) -> str:
    match = re.search(r"Sample +([^\n:]+?) *: *([^\n]*)", _text(path, "-info.txt"))
    return " ".join(match.group(1, 2)).strip()[:200] if match else ""


def _hours(path: Path) -> Array | None:
    """Hours since the first time, or None where there are no times in order."""
    rows = [[float(x) for x in match.groups()] for match in _CLOCK.finditer(_text(path, "-time.txt"))][: MOST_TIMES + 1]
    if not rows:
        return None
    hours = np.array(rows) @ np.array([24, 1, 1 / 60, 1 / 3600])
    if not np.all(np.isfinite(hours)) or np.any(np.diff(hours) <= 0) or hours[-1] > 1e7:
        return None
    return np.asarray(hours - hours[0])


def _parameters(kd: Array, ks: Array, sigma: Array, bgr: bool) -> dict[str, Array]:
    """The parameters from stored maps (y, x, 3); nothing below 0, and no highlight where sigma has no value."""
    if bgr:
        kd, ks = kd[..., ::-1], ks[..., ::-1]
    inverse = sigma.mean(axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        width = np.where(inverse > 0, 1 / np.sqrt(inverse), 0.0)
    return {
        "K_d": np.maximum(kd, 0),
        "K_s": np.where(width[..., None] > 0, np.maximum(ks, 0), 0.0),
        "sigma_s": np.where(np.isfinite(width), width, 0.0),
    }


def _picture(file: Path, shape: tuple[int, int] | None) -> Array:
    picture = reading.doubles(exr.rgb(file, "reading STAF maps"))
    if shape is not None and picture.shape[:2] != shape:
        raise FormatError(f"{file} is {picture.shape[:2]} and the maps before it {shape}", "All have one size")
    reading.require(
        bool(np.all(np.isfinite(picture))), f"{file} holds values that are not finite", "Fetch the file again"
    )
    return picture


def _size(file: Path) -> tuple[int, int]:
    size = exr.size(file)
    if size is None:
        raise FormatError(f"{file} is not a complete OpenEXR picture of sane size", "Fetch the file again")
    return size


def _measured(
    path: Path, files: Mapping[tuple[str, str], Path], bgr: bool
) -> tuple[int, Callable[[int], Mapping[str, Array]], tuple[int, int]]:
    by_case = {(int(time), part.lower()): file for (time, part), file in files.items()}
    times = sorted({time for time, _ in by_case})
    for time in times:
        for part in PARTS:
            reading.require(
                (time, part.lower()) in by_case,
                f"{path / 'TSparamNew'} has no {part} of time {time:02d}",
                "Fetch it again",
            )
    shape = _size(by_case[times[0], "kd"])

    def load(k: int) -> dict[str, Array]:
        kd, ks, sigma = (_picture(by_case[times[k], part.lower()], shape) for part in PARTS)
        return _parameters(kd, ks, sigma, bgr)

    return len(times), load, shape


def _fitted(
    path: Path, files: Mapping[tuple[str, str], Path], count: int, bgr: bool
) -> tuple[int, Callable[[int], Mapping[str, Array]], tuple[int, int]]:
    by_case = {(part.lower(), letter.upper()): file for (part, letter), file in files.items()}
    for part in PARTS:
        for letter in "ABCD":
            reading.require(
                (part.lower(), letter) in by_case, f"{path / 'SIM'} has no {letter} of {part}", "Fetch it again"
            )
    phi = _phi(path / "SIM")
    shape = _size(by_case["kd", "A"])
    polynomials = {"kd": [phi["r"], phi["g"], phi["b"]], "ks": [phi["ks"]] * 3, "sigma": [phi["s"]] * 3}

    def course(part: str, t: float) -> Array:
        a, b, c, d = (_picture(by_case[part, letter], shape) for letter in "ABCD")
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            warped = np.where(b != 0, (t - c) / b, 0.0)
            course = np.stack([np.polyval(p, warped[..., k]) for k, p in enumerate(polynomials[part])], axis=-1)
            value: Array = a * course + d
        return np.where(np.isfinite(value), value, 0.0)

    def load(k: int) -> dict[str, Array]:
        t = k / max(count - 1, 1)
        return _parameters(course("kd", t), course("ks", t), course("sigma", t), bgr)

    return count, load, shape


def _phi(folder: Path) -> dict[str, Array]:
    """The polynomials by the names of their lines."""
    found: dict[str, Array] = {}
    for end in ("-staf-Kd-phi.txt", "-staf-Ks-phi.txt"):
        for name, numbers in _PHI.findall(_text(folder, end)):
            found[name.lower()] = reading.numbers(numbers.replace(",", " ").split()[:100], f"{folder}, pphi_{name}")
    for name in ("r", "g", "b", "ks", "s"):
        if name not in found or len(found[name]) != DEGREE + 1 or not np.all(np.isfinite(found[name])):
            n = len(found[name]) if name in found else 0
            raise FormatError(
                f"{folder}: the line pphi_{name} has {n} coefficients, not {DEGREE + 1}",
                "They stand in ...-staf-Kd-phi.txt and ...-staf-Ks-phi.txt",
            )
    return found
