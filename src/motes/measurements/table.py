"""Tables of the user's: text in any of the ways that programs write it, and spreadsheets.

A header names the columns; each row holds a pair of directions with its values (wide tables), or one value with its
wavelength or channel (long ones).  The grammar, with a worked example of each layout, is ``docs/data.md``; names, units and
factors are in ``columns.json``.  What is not certain is refused with the option that settles it, and what was taken for
what is in ``provenance["columns"]``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.errors import FormatError
from motes.files import spreadsheet
from motes.measurements import _cells, _common_directions, _roles, _table_values, policy
from motes.measurements import _column_names as names
from motes.measurements._cell_numbers import Numbers
from motes.measurements._strange_header import strange_header
from motes.measurements._table_times import hours_of
from motes.measurements.measurement import Measurement

NAME = "csv"
SOURCE = "a table of the user's"
LARGEST_ANGLE = 2 * np.pi + 1e-6
HEADER = _cells.HEADER_HINT
PHASE, ROUNDED = "phase", np.radians(0.06)  # angles rounded to a tenth of a degree
SPHERICAL, HALF = ("theta_i", "phi_i", "theta_r", "phi_r"), ("theta_h", "theta_d", "phi_d", "phi_h")
VECTORS = tuple(f"{w}_{axis}" for w in ("wi", "wo") for axis in "xyz")
Floats = NDArray[np.float64]


def sniff(path: Path, head: bytes) -> bool:
    if path.is_dir() or not head:
        return False
    if spreadsheet.is_spreadsheet(head):
        return path.suffix.lower() in (".xlsx", ".xlsm", ".xls") or b"[Content_Types].xml" in head
    try:
        text, _ = _cells.decoded(head, str(path))
    except FormatError:
        return False
    return _cells.has_header(text, _knows({}))


def is_headerless(head: bytes) -> bool:
    """Whether the beginning of a file is rows of numbers without names."""
    try:
        return _cells.is_numbers(_cells.decoded(head, "")[0])
    except FormatError:
        return False


def columns_without_directions(head: bytes) -> list[str]:
    """What the columns of a text are called that is a table by its looks, and none of which is a direction by its name."""
    try:
        return strange_header(_cells.decoded(head, "")[0])
    except FormatError:
        return []


def read_table(
    path: Path,
    *,
    columns: Mapping[str, str] | None = None,
    sheet: str | None = None,
    angles: str | None = None,
    azimuth: str | None = None,
    wavelength_unit: str | None = None,
    missing: float | Sequence[float] | None = None,
    theta_i_deg: float | None = None,
    phi_i_deg: float | None = None,
    theta_r_deg: float | None = None,
    phi_r_deg: float | None = None,
) -> Measurement:
    """The table as a measurement; rows of one time make a scan.

    Parameters
    ----------
    path
        Text or a spreadsheet.
    columns
        Column -> role, for names that are not known: ``{"lum": "brdf", "T": "ignore"}``.  At the command line
        ``--read column:lum=brdf``.
    sheet
        Of a spreadsheet.
    angles
        ``"deg"`` or ``"rad"``: the unit of columns that name none; radians otherwise.
    azimuth
        ``"lamp"``, where phi_r counts from the side of the lamp (0 is backscatter), as everywhere in Motes; or ``"mirror"``,
        where it counts from the side of the mirror direction, as in ASTM E2387.
    wavelength_unit
        ``"nm"``, ``"um"`` or ``"m"``: that of wavelengths whose names say none; nm otherwise.
    missing
        Numbers that stand for no reading where a value should be, as the table has them: ``9999``, ``(0, -1)``.
    theta_i_deg, phi_i_deg, theta_r_deg, phi_r_deg
        Angles that all rows share, in place of a column.

    Raises
    ------
    FormatError
        Where a column is not known, two are the same, units contradict each other, or a cell is not a number.
    """
    where = str(path)
    for name, value, allowed in (
        ("angles", angles, ("deg", "rad")),
        ("azimuth", azimuth, ("lamp", "mirror")),
        ("wavelength_unit", wavelength_unit, ("nm", "um", "m", "angstrom")),
    ):
        if value is not None and value not in allowed:
            raise FormatError(
                f"{name} = {value!s:.40} is none of {', '.join(allowed)}", f"Give --read {name}={allowed[0]}"
            )
    given = dict(columns or {})
    head = path.read_bytes()[:4] if path.stat().st_size else b""
    if spreadsheet.is_spreadsheet(head):
        table = _cells.of_sheet(spreadsheet.read_spreadsheet(path, sheet), where, _knows(given))
    else:
        if sheet is not None:
            raise FormatError(f"{path} is no spreadsheet, and has no sheet {sheet!s:.40}", "Leave sheet out")
        text, notes = _cells.text_of(path)
        table = _cells.of_text(text, where, _knows(given))
        del text
        table.notes[:0] = notes
    roles = _roles.assign(table, where, given)
    if not table.rows:
        raise FormatError(f"{path} has a header and no row below it", "It needs a row a sample")
    everything = [*roles.angles.values(), *roles.values, *roles.uncertainties]
    everything += [at for role, at in roles.single.items() if role in ("weight", "wavelength")]
    numbers = Numbers(table, where, everything)
    notes = [*table.notes, *roles.notes]
    if numbers.decimal_comma:
        notes.append("Its numbers have decimal commas")
    shared = {"theta_i": theta_i_deg, "phi_i": phi_i_deg, "theta_r": theta_r_deg, "phi_r": phi_r_deg}
    reader = _Angles(table, where, roles, numbers, angles, notes)
    pairs = reader.pairs({k: v for k, v in shared.items() if v is not None}, azimuth == "mirror")
    hours, time_unit = hours_of(table, where, roles)
    weights = numbers.column(roles.single["weight"])[0][:, 0] if "weight" in roles.single else np.ones(len(table.rows))
    bad = ~np.isfinite(weights) | (weights < 0)
    if bad.any():
        raise FormatError(
            f"{where}, line {table.lines[int(np.argmax(bad))]}: the weight is missing or below 0", "Fill it in"
        )
    samples = _table_values.samples(
        table, where, roles, numbers, pairs, hours, wavelength_unit, _fillers(missing), notes
    )
    described = _roles.described(roles, table.header)
    del table, numbers, reader, pairs, hours  # the text, which takes as much as what comes of it
    return _measured(path, described, samples, weights, time_unit, notes)


def _fillers(missing: float | Sequence[float] | None) -> Floats:
    """What stands for no reading."""
    try:
        return np.atleast_1d(np.asarray([] if missing is None else missing, np.float64))
    except (TypeError, ValueError):
        raise FormatError(
            f"missing = {missing!s:.40} is not a number or numbers", "Give --read missing=9999, or --read missing=0,-1"
        ) from None


def _measured(
    path: Path,
    described: list[str],
    samples: _table_values.Samples,
    weights: Floats,
    time_unit: str,
    notes: list[str],
) -> Measurement:
    """Scans brought onto one set of directions."""
    pairs, values = samples.pairs, samples.values
    times, scan = np.unique(samples.hours, return_inverse=True)
    scan = scan.reshape(-1)
    members = np.split(np.argsort(scan, kind="stable"), np.cumsum(np.bincount(scan))[:-1])
    union, indices = _common_directions.union([pairs[m] for m in members])
    n_channels = values.shape[1]
    spread, present = _common_directions.spread(
        len(union), indices, [values[m] for m in members], n_channels, str(path)
    )
    uncertainties = None
    if samples.uncertainties is not None:
        parts = [samples.uncertainties[m] for m in members]
        uncertainties, _ = _common_directions.spread(len(union), indices, parts, n_channels, str(path))
    weight = np.ones(len(union))
    for index, m in zip(indices, members, strict=True):
        weight[index] = weights[samples.rows[m]]
    wi, wo = union[:, :3], union[:, 3:]
    return Measurement.from_arrays(
        wi,
        wo,
        spread,
        times=times,
        time_unit=time_unit,
        channels=samples.channels,
        wavelengths=samples.wavelengths,
        weights=weight,
        uncertainties=uncertainties,
        reasons={policy.NOT_MEASURED: ~present[:, :, None], policy.CLIPPED: policy.clipped(wi, wo, spread)},
        provenance={
            "format": NAME,
            "path": str(path),
            "name": path.stem,
            "source": SOURCE,
            "columns": described,
            "notes": notes,
        },
    )


def _knows(given: Mapping[str, str]) -> Callable[[str], str]:
    """What a cell of a header names."""
    wanted = {names.normal(name): role for name, role in given.items()}

    def known(cell: str) -> str:
        try:
            found = names.column(wanted.get(names.normal(cell), cell))
        except FormatError:
            return "direction"  # a known name with a wrong unit is the name of a column all the same
        if found is None:
            return ""
        return "direction" if found.role in ("angle", "vector") else found.role

    return known


class _Angles:
    """The directions of the rows."""

    def __init__(
        self,
        table: _cells.Cells,
        where: str,
        roles: _roles.Roles,
        numbers: Numbers,
        unit: str | None,
        notes: list[str],
    ) -> None:
        self.table, self.where, self.roles, self.numbers, self.unit, self.notes = (
            table,
            where,
            roles,
            numbers,
            unit,
            notes,
        )
        self.in_degrees: list[str] = []  # for each column that says so itself, in its name or its cells
        self.without_unit: list[tuple[str, str]] = []  # label and angle

    def pairs(self, shared: Mapping[str, float], from_mirror: bool) -> Floats:
        """wi and wo (N, 6)."""
        found = set(self.roles.angles)
        groups = [g for g in (VECTORS, HALF, (*SPHERICAL, PHASE)) if found & set(g) or (PHASE in g and shared)]
        if len(groups) != 1 or {PHASE, "phi_r"} <= found | set(shared):
            raise FormatError(
                f"{self.where} gives directions in several ways: {', '.join(sorted(found) + list(shared))}",
                "Leave one way out with --read column:NAME=ignore",
            )
        if groups[0] is VECTORS:
            self._need(VECTORS)
            vectors = np.stack([self._column(name) for name in VECTORS], axis=1)
            return np.concatenate(
                [
                    policy.unit_directions(vectors[:, :3], f"{self.where}: wi"),
                    policy.unit_directions(vectors[:, 3:], f"{self.where}: wo"),
                ],
                axis=1,
            )
        if groups[0] is HALF:
            self._need(HALF[:3])
            parts = [self._angle(name) if name in found else 0.0 for name in HALF]
            return np.concatenate(directions.from_half_difference(*parts), axis=-1)
        return self._spherical(shared, from_mirror)

    def _spherical(self, shared: Mapping[str, float], from_mirror: bool) -> Floats:
        n = len(self.table.rows)
        found = self.roles.angles
        both = [name for name in shared if name in found]
        if both:
            raise FormatError(f"{self.where} has a column of {both[0]} already", f"Leave {both[0]}_deg out")
        by_phase = "phase" in found and "phi_r" not in found and "phi_r" not in shared
        self._need(("theta_i", "theta_r", *(() if by_phase else ("phi_r",))), shared)
        angle = {
            name: self._angle(name) if name in found else np.full(n, np.radians(shared.get(name, 0.0)))
            for name in SPHERICAL
        }
        if by_phase:
            angle["phi_r"] = angle["phi_i"] + self._azimuth_of_phase(angle["theta_i"], angle["theta_r"])
            self.notes.append("The azimuth between light and viewer follows from the phase angle")
        for name, degrees in shared.items():
            self.notes.append(f"{name} is {degrees:g} degrees for all rows, as given by the caller")
        if "phi_i" not in found and "phi_i" not in shared:
            self.notes.append("phi_i is missing and taken as 0")
        if (angle["theta_i"] < 0).any() or (angle["theta_r"] < 0).any():
            self.notes.append("Negative polar angles are taken for the opposite azimuth")
        if from_mirror:
            self.notes.append("Azimuths count from the side of the mirror direction, as given by the caller")
        pairs = np.empty((n, 6))
        turn = np.pi if from_mirror else 0.0
        for start in range(0, n, _cells.PART):  # by parts, for what sines and cosines take in between
            at = slice(start, start + _cells.PART)
            pairs[at, :3] = directions.from_spherical(angle["theta_i"][at], angle["phi_i"][at])
            pairs[at, 3:] = directions.from_spherical(angle["theta_r"][at], angle["phi_r"][at] + turn)
        return pairs

    def _azimuth_of_phase(self, theta_i: Floats, theta_r: Floats) -> Floats:
        """phi_r - phi_i >= 0 of the angle between light and viewer, as photometry of planets counts: which side is not known, and is all one to
        what is isotropic."""
        phase = self._angle("phase")
        sines = np.abs(np.sin(theta_i) * np.sin(theta_r))
        least, most = np.abs(theta_i - theta_r), theta_i + theta_r
        bad = (phase < least - ROUNDED) | (phase > most + ROUNDED) | (theta_i < 0) | (theta_r < 0)
        if bad.any():
            i = int(np.argmax(bad))
            between, given = np.degrees([least[i], most[i]]), np.degrees(phase[i])
            raise FormatError(
                f"{self.where}, line {self.table.lines[i]}: a phase angle of {given:g} degrees is outside {between[0]:g} to {between[1]:g}, "
                "which the two polar angles allow",
                "Check the row; polar angles beside a phase angle are not signed",
            )
        with np.errstate(divide="ignore", invalid="ignore"):
            cosine = (np.cos(phase) - np.cos(theta_i) * np.cos(theta_r)) / sines
        return np.where(sines > 1e-12, np.arccos(np.clip(cosine, -1.0, 1.0)), 0.0)

    def _need(self, needed: tuple[str, ...], shared: Mapping[str, float] = {}) -> None:
        missing = [name for name in needed if name not in self.roles.angles and name not in shared]
        if not missing:
            return
        header = ", ".join(repr(h[:40]) for h in self.table.header[:12])
        if missing == ["phi_r"]:
            hint = (
                "In a scan within the plane of incidence, --read phi_r_deg=180 says that positive theta_r is on the side of the "
                "mirror direction (ASTM E2387), --read phi_r_deg=0 that it is on the side of the lamp"
            )
        elif set(missing) <= set(SPHERICAL):
            hint = f"Add them, or say what all rows share with --read {' --read '.join(f'{name}_deg=0' for name in missing)}"
        else:
            hint = f"These columns come together: {', '.join(needed)}"
        raise FormatError(f"{self.where} has no column {', '.join(missing)}; it has {header}", hint)

    def _column(self, name: str) -> Floats:
        at = self.roles.angles[name]
        values, self.cell_unit = self.numbers.column(at)
        bad = ~np.isfinite(values[:, 0])
        if bad.any():
            line = self.table.lines[int(np.argmax(bad))]
            raise FormatError(
                f"{self.where}, line {line}: {self.table.header[at]} is missing or not finite", "Fill it in"
            )
        return values[:, 0]

    def _angle(self, name: str) -> Floats:
        """A column of angles [rad]."""
        at = self.roles.angles[name]
        values, label = self._column(name), self.table.header[at]
        column = self.roles.columns[at]
        assert column is not None
        in_cells = names.unit_of(self.cell_unit, "angle") if self.cell_unit else ""
        unit = column.unit or in_cells or self.unit or ""
        if in_cells is None or (in_cells and column.unit and in_cells != column.unit):
            raise FormatError(
                f"{self.where}: the cells of {label!r} are in {self.cell_unit!r}"
                + (f", its name says {column.unit}" if column.unit else ""),
                "Correct one of them",
            )
        others = {c.unit for c in self.roles.columns if c is not None and c.role == "angle"} | set(self.in_degrees)
        self.in_degrees += [unit] if unit == "deg" and not self.unit else []
        self.without_unit += [(label, name)] if not unit else []
        if self.without_unit and ("deg" in others or self.in_degrees):
            bare, its = self.without_unit[0]
            raise FormatError(
                f"{self.where}: {bare!r} names no unit, and other angles are in degrees",
                f"--read angles=deg says that it is in degrees too, --read 'column:{bare}={its}_rad' that it is in radians",
            )
        self.roles.units[at] = unit or "rad"
        radians = values * names.FACTORS[unit or "rad"]
        bad = np.abs(radians) > LARGEST_ANGLE
        if bad.any():
            i = int(np.argmax(bad))
            raise FormatError(
                f"{self.where}, line {self.table.lines[i]}: {label} = {values[i]:g} is outside +-2 pi rad (+-360 degrees)",
                "Check the row"
                if unit
                else f"Angles are in radians; --read angles=deg reads degrees, and so does the name {re.sub(r'[^A-Za-z0-9_]+', '_', label)}_deg",
            )
        return np.asarray(radians, np.float64)


#: Names of columns of times -> hours; for tables of other kinds.
TIMES: dict[str, float] = {"time": 1.0, **{f"time_{unit}": names.FACTORS[unit] for unit in ("h", "s", "min", "d")}}

__all__ = ["NAME", "SOURCE", "TIMES", "read_table", "sniff"]
