"""Which column of a table is what: names to roles, with everything that is not certain refused or said."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import groupby

import numpy as np

from motes.errors import FormatError
from motes.measurements import _cells
from motes.measurements import _column_names as names
from motes.measurements._column_names import Column

MOST_CHANNELS = 10_000
_HINT = "--read 'column:{name}=ROLE' says what it is, where ROLE is a name that docs/data.md knows, such as brdf, time_h, uncertainty or ignore"


@dataclass
class Roles:
    """Where everything is.

    Parameters
    ----------
    angles
        Angle or component of a direction -> column.
    values, uncertainties
        The columns of values, and of uncertainties, in their order.
    of
        For each column of uncertainties the place in `values` that it belongs to; -1 for all.
    single
        Role -> column, for time, scan, weight, wavelength and channel.
    columns
        What every column was taken for; None for those left out.
    notes
        Sentences on what was left out.
    units
        Column -> the unit in which its numbers were read, once they are: that of its name, of its cells, of an option, or the one without a name.
    """

    angles: dict[str, int] = field(default_factory=dict)
    values: list[int] = field(default_factory=list)
    uncertainties: list[int] = field(default_factory=list)
    of: list[int] = field(default_factory=list)
    single: dict[str, int] = field(default_factory=dict)
    columns: list[Column | None] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    units: dict[int, str] = field(default_factory=dict)


def assign(table: _cells.Cells, where: str, given: Mapping[str, str]) -> Roles:
    """The roles of the columns of a table.

    Parameters
    ----------
    table
        The cells.
    where
        The file, for messages.
    given
        Column -> role, as the user says; both as text, the column by its name, or its number from 1.

    Raises
    ------
    FormatError
        For columns that are not known, or two for one role.
    """
    header = table.header
    said = _said(header, where, given)
    roles = Roles()
    for at, name in enumerate(header):
        found = said[at] if at in said else _known(table, at, where)
        if found is None and _is_index(table, at, "" if at in said else name):
            roles.notes.append(f"The column {_called(header, at)} numbers or names the rows and is left out")
            roles.columns.append(None)
            continue
        if found is None:
            raise _unknown(table, at, where)
        if found.role == "index" and not _is_index(table, at, name):
            raise _unknown(table, at, where)
        if found.role in ("index", "remark", "ignore"):
            why = {"index": "numbers the rows", "remark": "holds remarks", "ignore": "is to be ignored"}[found.role]
            roles.notes.append(f"The column {_called(header, at)} {why} and is left out")
            roles.columns.append(None)
            continue
        found = _with_unit(found, table, at, where)
        roles.columns.append(found)
        if found.role in ("angle", "vector"):
            _once(roles.angles, found.name, at, header, where)
        elif found.role == "value":
            roles.values.append(at)
        elif found.role == "uncertainty":
            roles.uncertainties.append(at)
        else:
            _once(roles.single, found.role, at, header, where)
    _settle_theta_s(roles, header, where)
    _check_values(roles, header, where)
    return roles


def _said(header: list[str], where: str, given: Mapping[str, str]) -> dict[int, Column]:
    said: dict[int, Column] = {}
    for name, role in given.items():
        places = [at for at, h in enumerate(header) if h == name] or [
            at for at, h in enumerate(header) if names.normal(h) == names.normal(name)
        ]
        if not places and name.isascii() and name.isdigit() and 1 <= int(name) <= len(header):
            places = [int(name) - 1]
        if len(places) != 1:
            what = "has no column" if not places else f"has {len(places)} columns"
            raise FormatError(f"{where} {what} {name!r}", f"Its columns are: {_listed(header)}")
        if names.normal(role) in ("ignore", "index", "remark"):
            said[places[0]] = Column("ignore")
            continue
        column = names.column(role)
        if column is None:
            raise FormatError(
                f"column:{name}={role}: {role!r} is no role of a column",
                f"The nearest are {', '.join(names.nearest(role))}; docs/data.md lists all of them",
            )
        if column.role == "value" and column.channel == "" and column.name == "brdf":
            own = names.column(f"brdf[{name}]") if len(header) > 1 else None
            generic = names.column(name)
            if own is not None and (generic is None or generic.role != "value"):
                column = replace(column, channel=own.channel)
        said[places[0]] = column
    return said


def _known(table: _cells.Cells, at: int, where: str) -> Column | None:
    name = table.header[at]
    if name == "":
        return None
    try:
        return names.column(name)
    except FormatError as error:
        raise FormatError(f"{where}: {error.message[0].lower()}{error.message[1:]}", _HINT.format(name=name)) from None


def _is_index(table: _cells.Cells, at: int, name: str) -> bool:
    """Whether a column numbers the rows, or, where it has no name, names them: the index of a data frame."""
    plain = names.key(names.normal(name))
    nameless = name == "" or re.fullmatch(r"unnamed:? ?\d+(\.\d+)*", names.normal(name)) is not None
    if not nameless and plain not in {names.key(a) for a in names.TABLES["index"]}:
        return False
    cells = [row[at] for row in table.rows]
    if all(c == "" for c in cells):
        return True
    try:
        numbers = np.array(cells, np.float64)
    except ValueError:
        return nameless and len(set(cells)) == len(cells)  # R's names of rows
    return (
        len(numbers) < 2
        or bool(np.all(np.diff(numbers) == 1))
        or (not nameless and bool(np.all(numbers == np.round(numbers))))
    )


def _unknown(table: _cells.Cells, at: int, where: str) -> FormatError:
    header = table.header
    if header[at] == "":
        return FormatError(
            f"{where}: column {at + 1} has no name and does not number the rows", _HINT.format(name=at + 1)
        )
    return FormatError(
        f"{where}: the column {header[at][:60]!r} is not known; the nearest names are {', '.join(names.nearest(header[at]))}",
        _HINT.format(name=header[at]),
    )


def _with_unit(found: Column, table: _cells.Cells, at: int, where: str) -> Column:
    """With the unit of the row of units; one that contradicts the name is refused."""
    text = table.units[at] if table.units else ""
    if found.role == "value" and found.unit in ("%", "1"):
        text = text or found.unit
    if not text:
        return found
    dimension = {"angle": "angle", "time": "time", "wavelength": "length", "value": "brdf", "uncertainty": "brdf"}.get(
        found.role
    )
    unit = names.unit_of(text, dimension) if dimension else None
    implied = found.unit if found.unit != "with unit" else ""
    if unit is None and dimension is None:
        return found
    if unit is None or (implied and implied != unit):
        raise FormatError(
            f"{where}: the column {table.header[at]!r} has the unit {text!r}"
            + (f", and its name says {implied}" if implied else f", which is no unit of {found.name or found.role}"),
            "Correct one of them, or " + _HINT.format(name=table.header[at]),
        )
    if found.role == "value" and found.name != "reflectance_factor" and unit in ("%", "1"):
        raise FormatError(
            f"{where}: the column {table.header[at]!r} has the unit {text!r}, and a BRDF is in 1/sr",
            f"Where it is a reflectance factor (pi times the BRDF), give --read 'column:{table.header[at]}=reflectance_factor"
            + ("_percent'" if unit == "%" else "'"),
        )
    return replace(found, unit=unit, relative=found.relative or (found.role == "uncertainty" and unit == "%"))


def _once(places: dict[str, int], role: str, at: int, header: list[str], where: str) -> None:
    if role in places:
        raise FormatError(
            f"{where}: the columns {_called(header, places[role])} and {_called(header, at)} are both {role}",
            f"Leave one out with --read 'column:{header[at] or at + 1}=ignore'",
        )
    places[role] = at


def _settle_theta_s(roles: Roles, header: list[str], where: str) -> None:
    """theta_s is the scatter angle beside theta_i, and the sun's beside theta_v."""
    at = roles.angles.pop("theta_s", None)
    if at is None:
        return
    if ("theta_i" in roles.angles) == ("theta_r" in roles.angles):
        raise FormatError(
            f"{where}: the column {_called(header, at)} may be the angle of the scattered light or of the sun",
            f"--read 'column:{header[at]}=theta_r_deg' says that it is the viewer's",
        )
    name = "theta_r" if "theta_i" in roles.angles else "theta_i"
    roles.angles[name] = at
    column = roles.columns[at]
    assert column is not None
    roles.columns[at] = replace(column, name=name)
    roles.notes.append(f"The column {_called(header, at)} is taken for {name}, the other one being there")
    if (
        name == "theta_i"
        and "phi_r" in roles.angles
        and names.key(names.normal(header[roles.angles["phi_r"]])).startswith("phis")
    ):
        moved = roles.angles.pop("phi_r")
        roles.angles["phi_i"] = moved
        other = roles.columns[moved]
        assert other is not None
        roles.columns[moved] = replace(other, name="phi_i")


def _check_values(roles: Roles, header: list[str], where: str) -> None:
    long = [role for role in ("wavelength", "channel") if role in roles.single]
    if len(long) == 2:
        raise FormatError(
            f"{where}: the columns {_called(header, roles.single['wavelength'])} and {_called(header, roles.single['channel'])} both name the channel of a row",
            f"Leave one out with --read 'column:{header[roles.single['channel']]}=ignore'",
        )
    if "time" in roles.single and "scan" in roles.single:
        roles.notes.append(
            f"The column {_called(header, roles.single['scan'])} numbers the scans, whose times are known, and is left out"
        )
        roles.columns[roles.single.pop("scan")] = None
    if not roles.values:
        raise FormatError(
            f"{where} has no column of values; its columns are {_listed(header)}",
            "Name a column of the BRDF [1/sr] brdf, or R, G, B, or by its wavelength (630 nm)",
        )
    if long and len(roles.values) > 1:
        raise FormatError(
            f"{where} has a row for each {long[0]} and yet {len(roles.values)} columns of values: "
            + ", ".join(_called(header, at) for at in roles.values[:4]),
            f"Leave all but one out with --read 'column:{header[roles.values[1]]}=ignore'",
        )
    if len(roles.values) > MOST_CHANNELS:
        raise FormatError(f"{where} has {len(roles.values):,} channels, more than {MOST_CHANNELS:,}", "Split the table")
    seen: dict[object, int] = {}
    for at in roles.values:
        column = roles.columns[at]
        assert column is not None
        label: object = (
            (column.wavelength, column.unit_of_wavelength) if column.wavelength is not None else column.channel
        )
        if label in seen:
            raise FormatError(
                f"{where}: the columns {_called(header, seen[label])} and {_called(header, at)} hold values of the same channel",
                f"Leave one out with --read 'column:{header[at] or at + 1}=ignore', or name channels as in brdf[name]",
            )
        seen[label] = at
    for at in roles.uncertainties:
        _belongs(roles, at, header, where)


def _belongs(roles: Roles, at: int, header: list[str], where: str) -> None:
    """Which value an uncertainty belongs to."""
    column = roles.columns[at]
    assert column is not None
    if column.channel == "" and column.wavelength is None:
        if len(roles.values) > 1 and not column.relative:
            raise FormatError(
                f"{where}: the column {_called(header, at)} is an uncertainty [1/sr] of one of {len(roles.values)} channels, and does not say of which",
                f"--read 'column:{header[at]}=uncertainty[R]' says it, --read 'column:{header[at]}=relative_uncertainty' that it is a share of each value",
            )
        place = 0 if len(roles.values) == 1 else -1
    else:
        matches = [
            k
            for k, v in enumerate(roles.values)
            if (c := roles.columns[v]) is not None
            and (
                (c.wavelength == column.wavelength and column.unit_of_wavelength in ("", c.unit_of_wavelength))
                if column.wavelength is not None
                else names.key(names.normal(c.channel)) == names.key(names.normal(column.channel))
            )
        ]
        if len(matches) != 1:
            raise FormatError(
                f"{where}: the column {_called(header, at)} is the uncertainty of {column.channel}, and no column of values is called so",
                _HINT.format(name=header[at]),
            )
        place = matches[0]
    if place in roles.of or (roles.of and -1 in (place, *roles.of)):
        other = roles.uncertainties[roles.of.index(place) if place in roles.of else 0]
        raise FormatError(
            f"{where}: the columns {_called(header, other)} and {_called(header, at)} are both uncertainties of the same values",
            f"Leave one out with --read 'column:{header[at]}=ignore'",
        )
    roles.of.append(place)


def described(roles: Roles, header: list[str]) -> list[str]:
    """What each column was taken for, as sentences; many of one kind in one."""
    entries = [(header[at] or f"column {at + 1}", *_words(roles, at)) for at in range(len(header))]
    lines: list[str] = []
    for kind, run in groupby(entries, key=lambda entry: entry[1]):
        group = list(run)
        if len(group) > 4 and kind:
            lines.append(f"{group[0][0]} .. {group[-1][0]} ({len(group)} columns): {kind}")
        else:
            lines += [f"{name}: {kind}{detail}" for name, kind, detail in group]
    return lines


def _words(roles: Roles, at: int) -> tuple[str, str]:
    c = roles.columns[at]
    if c is None:
        return "left out", ""
    if c.role == "angle":
        return "", f"{c.name} [{roles.units[at]}]"
    if c.role == "time":
        return "", f"time [{roles.units[at]}]"
    if c.role == "wavelength":
        return "", f"wavelength of the row [{roles.units[at]}]"
    if c.role == "value":
        quantity = {
            "brdf": "f_r [1/sr]",
            "brdf_cos_r": "f_r cos(theta_r) [1/sr]",
            "brdf_cos_i": "f_r cos(theta_i) [1/sr]",
            "reflectance_factor": f"pi f_r{' in %' if c.unit == '%' else ''}",
        }[c.name]
        if c.wavelength is not None:
            return f"{quantity} at a wavelength [{roles.units.get(at, 'nm')}]", ""
        return quantity, f", channel {c.channel}" if c.channel else ""
    if c.role == "uncertainty":
        kind = ("two standard deviations" if c.expanded else "one standard deviation") + (
            ", in % of the value"
            if roles.units[at] == "%"
            else ", as a share of the value"
            if c.relative
            else " [1/sr]"
        )
        place = roles.of[roles.uncertainties.index(at)] if "wavelength" not in roles.single else 0
        of = roles.columns[roles.values[place]] if place >= 0 else None
        return f"uncertainty, {kind}", f" of channel {of.channel}" if of and of.channel and len(
            roles.values
        ) > 1 else ""
    return "", {
        "vector": c.name,
        "channel": "channel of the row",
        "scan": "number of the scan",
        "weight": "weight (solid angle)",
    }[c.role]


def _called(header: list[str], at: int) -> str:
    return repr(header[at][:60]) if header[at] else str(at + 1)


def _listed(header: list[str]) -> str:
    shown = ", ".join(repr(h[:40]) for h in header[:12])
    return shown + (f", ... ({len(header)} in all)" if len(header) > 12 else "")
