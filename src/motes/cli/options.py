"""Options that the commands share, and how their values are read."""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from cyclopts import Parameter

from motes.errors import DataError, MotesError


@Parameter(name="*")
@dataclass(frozen=True)
class Common:
    """How a command talks."""

    json: Annotated[bool, Parameter(negative="")] = False
    """Print one JSON object and nothing else to standard output."""

    quiet: Annotated[bool, Parameter(negative="")] = False
    """Print nothing but errors and warnings."""

    debug: Annotated[bool, Parameter(negative="")] = False
    """Show the traceback of an error (so does MOTES_DEBUG=1)."""


@Parameter(name="*")
@dataclass(frozen=True)
class Reading:
    """How data are read."""

    sample: Annotated[str | None, Parameter(name=["--sample", "-s"])] = None
    """Which sample of a container."""

    read: Annotated[tuple[str, ...], Parameter(negative="")] = ()
    """NAME=VALUE: an option of the reader; repeat for more. column:NAME=ROLE says what a column of a table is, such as
    column:lum=brdf or column:T=ignore; angles=deg, azimuth=mirror, sheet=NAME, theta_i_deg=45 (see docs/data.md); format=csv,
    times=0,0.5,1 (hours), irradiance=2 (TVBRDF folders), resolution=32 (RGL); relative_uncertainty=0.02,
    common_uncertainty=0.01."""

    def options(self) -> dict[str, Any]:
        """The keyword arguments of `motes.read`."""
        columns = [text.removeprefix("column:") for text in self.read if text.startswith("column:")]
        others = assignments([text for text in self.read if not text.startswith("column:")], "--read")
        for name, other in (("path", "the path stands before the options"), ("columns", "--read column:NAME=ROLE")):
            if name in others:
                raise MotesError(f"--read {name} is no option of a reader", f"Leave it out: {other}")
        for name, value in others.items():  # names, though they may look like numbers
            others[name] = str(value) if name in ("format", "sheet", "angles", "azimuth", "wavelength_unit") else value
        return {"sample": self.sample, **others, **({"columns": column_roles(columns)} if columns else {})}


def column_roles(texts: Sequence[str]) -> dict[str, str]:
    """``lum=brdf`` as column and role; a name may hold an equals sign, a role does not."""
    roles: dict[str, str] = {}
    for text in texts:
        name, equals, role = (part.strip() for part in text.rpartition("="))
        if not equals or not name or not role:
            raise MotesError(f"--read 'column:{text}' is not column:NAME=ROLE", "Write --read column:lum=brdf")
        if name in roles:
            raise MotesError(f"--read column:{name} is given twice", "Give it once")
        roles[name] = role
    return roles


def _whole(type_: Any, tokens: Sequence[Any]) -> int:
    try:
        return int(tokens[0].value)
    except ValueError:
        raise ValueError(f"{tokens[0].value!r} is not a whole number") from None


#: int() without rounding: 1.5 scans are an error.
Whole = Annotated[int, Parameter(converter=_whole)]


#: The same, where none may be given.
MaybeWhole = Annotated[int | None, Parameter(converter=_whole)]


def time_of(time: int | None, count: int, kinds: Mapping[str, str]) -> int | None:
    """What ``--time`` means of so many times, from 0; None for all of them.  `kinds` are those of ``--trend``, which needs several."""
    if time is not None and not -count <= time < count:
        raise DataError(f"--time {time} is not among the {count} time(s) of the data", f"Choose 0 to {count - 1}")
    if kinds and (time is not None or count == 1):
        raise DataError(
            f"--trend {next(iter(kinds))}={next(iter(kinds.values()))} was given, and one time has no trend",
            "Leave --time out" if count > 1 else "The data have one time; trends need several",
        )
    return None if time is None else time % count


def assignments(texts: Sequence[str], option: str) -> dict[str, Any]:
    """Several `assignment`; a name that is given twice is an error."""
    values: dict[str, Any] = {}
    for text in texts:
        name, value = assignment(text, option)
        if name in values:
            raise MotesError(f"{option} {name} is given twice", "Give it once")
        values[name] = value
    return values


def numbers(texts: Sequence[str], option: str) -> dict[str, Any]:
    """`assignments` of numbers, or lists of numbers."""
    values = assignments(texts, option)
    for name, value in values.items():
        if isinstance(value, str):
            raise MotesError(
                f"{option} {name}={value} is not a number or numbers",
                f"Write {option} {name}=0.3, or {option} {name}=0.7,0.6,0.5",
            )
    return values


def assignment(text: str, option: str) -> tuple[str, Any]:
    """``K_s=0.3``, ``K_d=0.7,0.6,0.5`` or ``format=csv`` as a name and a number, a list of numbers or a text."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not equals or not name or not value:
        raise MotesError(
            f"{option} {text!r} is not NAME=VALUE", f"Write {option} name=0.3, or {option} name=0.7,0.6,0.5"
        )
    try:
        number = ast.literal_eval(value)
        return name, [float(x) for x in number] if isinstance(number, (tuple, list)) else _number(number)
    except (ValueError, TypeError, SyntaxError, MemoryError, RecursionError):
        return name, value


def _number(value: Any) -> float | int:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise ValueError("not a number")
    return value
