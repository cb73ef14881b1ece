"""The values of a table with their uncertainties: wide tables, and long ones with a row for each channel."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from motes.errors import FormatError
from motes.measurements import _cells, _common_directions, _roles
from motes.measurements import _column_names as names
from motes.measurements._cell_numbers import Numbers
from motes.measurements._column_names import Column

Floats = NDArray[np.float64]
COSINES = {"brdf_cos_i": 2, "brdf_cos_r": 5}  # of wi and wo (N, 6)
SHORTEST = 100.0  # nm; what is called shorter is in other units: no goniometer measures X-rays


@dataclass(frozen=True)
class Samples:
    """A row a pair of directions and a time.

    Parameters
    ----------
    pairs, hours, rows
        wi and wo (N, 6); (N,); the row of the table that each comes from (N,).
    values, uncertainties
        f_r (N, C) [1/sr]; one standard deviation (N, C) [1/sr] or None.
    channels, wavelengths
        C names; (C,) [nm] or None.
    """

    pairs: Floats
    hours: Floats
    rows: NDArray[np.intp]
    values: Floats
    uncertainties: Floats | None
    channels: list[str]
    wavelengths: Floats | None


def samples(
    table: _cells.Cells,
    where: str,
    roles: _roles.Roles,
    numbers: Numbers,
    pairs: Floats,
    hours: Floats,
    wavelength_unit: str | None,
    missing: Floats,
    notes: list[str],
) -> Samples:
    """The samples of a table whose directions are known; values in `missing` (M,) stand for none."""
    values, factors = _values(table, where, roles, numbers, pairs, missing, notes)
    uncertainties = _uncertainties(table, where, roles, numbers, values, factors, notes)
    wide = Samples(pairs, hours, np.arange(len(values)), values, uncertainties, [], None)
    for role in ("wavelength", "channel"):
        if role in roles.single:
            return _long(table, where, roles, numbers, wide, role, wavelength_unit)
    columns = [_column(roles, at) for at in roles.values]
    channels, wavelengths = _channels(columns, where, wavelength_unit)
    roles.units.update(
        zip(roles.values, [c.unit_of_wavelength or wavelength_unit or "nm" for c in columns], strict=True)
    )
    return replace(wide, channels=channels, wavelengths=wavelengths)


def _column(roles: _roles.Roles, at: int) -> Column:
    column = roles.columns[at]
    assert column is not None
    return column


def _values(
    table: _cells.Cells,
    where: str,
    roles: _roles.Roles,
    numbers: Numbers,
    pairs: Floats,
    missing: Floats,
    notes: list[str],
) -> tuple[Floats, Floats]:
    """f_r (N, C) [1/sr], and what the numbers of the table were multiplied by."""
    values = _block(numbers, roles.values, table, where)
    if len(missing):
        stand_in = np.isin(values, missing)
        values = np.where(stand_in, np.nan, values)
        given = ", ".join(f"{x:g}" for x in missing)
        notes.append(f"{int(stand_in.sum())} values that are {given} stand for no reading, as given by the caller")
    factors = np.ones_like(values)
    for k, at in enumerate(roles.values):
        column = _column(roles, at)
        if column.name == "reflectance_factor":
            factors[:, k] = names.FACTORS[column.unit or "1"] / np.pi
        elif column.name in COSINES:
            cosine = pairs[:, COSINES[column.name]]
            with np.errstate(divide="ignore"):
                factors[:, k] = np.where(cosine > 0, 1 / cosine, np.nan)
    kinds = {_column(roles, at).name for at in roles.values}
    if kinds == {"brdf"}:
        notes.insert(0, "f_r in 1/sr, as the table says")
        return values, factors
    if "reflectance_factor" in kinds:
        notes.insert(0, "f_r = reflectance factor / pi")
    if "brdf_cos_r" in kinds:
        notes.insert(0, "f_r = cosine-corrected BRDF / cos(theta_r)")
    if "brdf_cos_i" in kinds:
        notes.insert(0, "f_r = BRDF times cos(theta_i) / cos(theta_i)")
    return values * factors, factors


def _block(numbers: Numbers, columns: list[int], table: _cells.Cells, where: str) -> Floats:
    """Columns (N, C) as numbers; neighbours at once."""
    parts, start = [], 0
    for k in range(1, len(columns) + 1):
        if k == len(columns) or columns[k] != columns[k - 1] + 1:
            part, unit = numbers.column(columns[start], columns[k - 1] + 1)
            if unit and unit != "1/sr" and names.unit_of(unit, "brdf") != "1/sr":
                raise FormatError(
                    f"{where}: the cells of {table.header[columns[start]]!r} are in {unit!r}, and a BRDF is in 1/sr",
                    "Write numbers without a unit, and the unit in the header",
                )
            parts.append(part)
            start = k
    return np.concatenate(parts, axis=1)


def _uncertainties(
    table: _cells.Cells,
    where: str,
    roles: _roles.Roles,
    numbers: Numbers,
    values: Floats,
    factors: Floats,
    notes: list[str],
) -> Floats | None:
    if not roles.uncertainties:
        return None
    result = np.full(values.shape, np.nan)
    for place, at in zip(roles.of, roles.uncertainties, strict=True):
        column = _column(roles, at)
        given, unit = numbers.column(at)
        relative = column.relative or unit == "%"
        share = 0.01 if "%" in (column.unit, unit) else 1.0
        roles.units[at] = "%" if share < 1 else column.unit
        given = given * share / (2 if column.expanded else 1)
        which = slice(None) if place < 0 else slice(place, place + 1)
        measured = np.isfinite(values[:, which]).any(axis=1)
        bad = measured & ~((given[:, 0] > 0) & np.isfinite(given[:, 0]))
        if bad.any():
            row = int(np.argmax(bad))
            shown = table.rows[row][at] or "missing"
            raise FormatError(
                f"{where}, line {table.lines[row]}: the uncertainty {table.header[at]} is {shown[:20]}; {int(bad.sum())} of {len(bad)} are not above 0",
                f"An uncertainty is one standard deviation; --read 'column:{table.header[at]}=ignore' leaves all of them out",
            )
        with np.errstate(invalid="ignore"):
            absolute = given * np.abs(values[:, which]) if relative else given * np.abs(factors[:, which])
        result[:, which] = np.where(absolute > 0, absolute, np.nan)  # a share of 0 is not known
        if relative and column.unit != "%" and np.nanmedian(given) > 0.5:
            raise FormatError(
                f"{where}: the relative uncertainty {table.header[at]} has the median {np.nanmedian(given):.3g}, more than half of the values",
                f"--read 'column:{table.header[at]}=relative_uncertainty_percent' says that it is in percent",
            )
    return result


def _channels(columns: list[Column], where: str, wavelength_unit: str | None) -> tuple[list[str], Floats | None]:
    if all(c.wavelength is not None for c in columns):
        stated = {c.unit_of_wavelength for c in columns}
        stated = {"nm"} if stated == {"", "nm"} and wavelength_unit in (None, "nm") else stated
        if len(stated) > 1:
            raise FormatError(
                f"{where}: the wavelengths are in {', '.join(sorted(u or 'no unit' for u in stated))}",
                "Write all in one unit",
            )
        nm = in_nm(np.array([c.wavelength for c in columns], float), stated.pop(), where, wavelength_unit)
        return _names_of(nm, where), nm
    names_of = [c.channel or ("grey" if len(columns) == 1 else c.name) for c in columns]
    return names_of, None


def _names_of(nm: Floats, where: str) -> list[str]:
    channels = [f"{w:.6g} nm" for w in nm]
    if len(set(channels)) < len(channels):
        channels = [f"{w!r} nm" for w in nm.tolist()]
    if len(set(channels)) < len(channels):
        raise FormatError(f"{where} has a wavelength twice", "Leave one out with --read column:NAME=ignore")
    return channels


def in_nm(values: Floats, unit: str, where: str, given: str | None) -> Floats:
    """Wavelengths in nm; those that name no unit and cannot be nm are refused."""
    if not unit and given is None and (np.nanmin(values) < SHORTEST):
        raise FormatError(
            f"{where}: the wavelengths, from {np.nanmin(values):g} to {np.nanmax(values):g}, name no unit and are no light in nm",
            "--read wavelength_unit=um says that they are in micrometres",
        )
    nm = values * names.FACTORS[unit or given or "nm"]
    rounded = np.round(nm, 6)  # 0.63 um is 630 nm, not 629.9999999999999
    return np.asarray(np.where(np.abs(rounded - nm) < 1e-9 * nm, rounded, nm), np.float64)


def _long(
    table: _cells.Cells,
    where: str,
    roles: _roles.Roles,
    numbers: Numbers,
    rows: Samples,
    role: str,
    wavelength_unit: str | None,
) -> Samples:
    """A row for each channel -> a row for each pair of directions."""
    at = roles.single[role]
    wavelengths: Floats | None = None
    if role == "wavelength":
        written, in_cells = numbers.column(at)
        bad = ~(np.isfinite(written[:, 0]) & (written[:, 0] > 0))
        if bad.any():
            raise FormatError(
                f"{where}, line {table.lines[int(np.argmax(bad))]}: {table.header[at]} is missing or not above 0",
                "Fill it in",
            )
        unit = _column(roles, at).unit or (names.unit_of(in_cells, "length") or "" if in_cells else "")
        roles.units[at] = unit or wavelength_unit or "nm"
        wavelengths, which = np.unique(in_nm(written[:, 0], unit, where, wavelength_unit), return_inverse=True)
        channels = _names_of(wavelengths, where)
    else:
        labels = [row[at] for row in table.rows]
        if "" in labels:
            raise FormatError(
                f"{where}, line {table.lines[labels.index('')]}: {table.header[at]} is missing", "Fill it in"
            )
        order = list(dict.fromkeys(labels))
        which = np.array([order.index(label) for label in labels])
        columns = [
            names.column(f"channel {label}" if label.isdigit() and float(label) < SHORTEST else label)
            for label in order
        ]
        if all(c is not None and c.role == "value" for c in columns):
            channels, wavelengths = _channels([c for c in columns if c is not None], where, wavelength_unit)
        else:
            channels = order
    which = which.reshape(-1)
    n = len(channels)
    if n > _roles.MOST_CHANNELS:
        raise FormatError(f"{where} has {n:,} channels, more than {_roles.MOST_CHANNELS:,}", "Split the table")
    kept, parts = [], []
    for hour in np.unique(rows.hours):
        now = np.flatnonzero(rows.hours == hour)
        groups = [now[which[now] == c] for c in range(n)]
        union, indices = _common_directions.union([rows.pairs[g] for g in groups])
        short = next((c for c in range(n) if len(indices[c]) < len(union)), None)
        if short is not None:
            raise FormatError(
                f"{where}: the channel {channels[short]} has {len(indices[short])} of {len(union)} directions"
                + (f" at {hour:g} h" if len(np.unique(rows.hours)) > 1 else ""),
                "Give each channel a row for each pair of directions, with an empty cell where nothing was measured",
            )
        grid = np.empty((len(union), n), np.intp)
        for c, (index, group) in enumerate(zip(indices, groups, strict=True)):
            grid[index, c] = group
        parts.append(grid)
        kept.append(grid[:, 0])
    grid, first = np.concatenate(parts), np.concatenate(kept)
    return Samples(
        rows.pairs[first],
        rows.hours[first],
        first,
        rows.values[grid, 0],
        None if rows.uncertainties is None else rows.uncertainties[grid, 0],
        channels,
        wavelengths,
    )
