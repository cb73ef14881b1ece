"""What the name of a column says: its role, its unit, the channel that it belongs to.

The names, units and factors are in ``columns.json``, which the browser viewer reads as well; ``docs/data.md`` is the page for
people.  Names are compared by their letters and digits alone, in lower case, so ``Theta_I``, ``theta-i`` and ``thetaI`` are
one.
"""

from __future__ import annotations

import difflib
import json
import re
import unicodedata
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from importlib import resources
from typing import Any

from motes.errors import FormatError

#: The tables of names, units and factors.
TABLES: dict[str, Any] = json.loads(
    (resources.files("motes.measurements") / "columns.json").read_text(encoding="utf-8")
)
FACTORS: dict[str, float] = TABLES["factors"]
WAVELENGTH = re.compile(
    r"(?:x|wl|w|wavelength|lambda|l)?[ _]*((?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d{1,2})?)[ _]*([a-zµμå]*)"
)
_NAMED = re.compile(r"(.*?)\s*\[\s*(.+?)\s*\]|(.*?):\s*(.+?)")
_GREEK = {"θ": "theta", "ϑ": "theta", "φ": "phi", "ϕ": "phi", "λ": "lambda", "σ": "sigma", "δ": "delta_"}
_DIMENSION = {"angle": "angle", "time": "time", "wavelength": "length", "value": "brdf", "uncertainty": "brdf"}


@dataclass(frozen=True)
class Column:
    """What a column is taken for.

    Parameters
    ----------
    role
        ``angle``, ``vector``, ``time``, ``scan``, ``weight``, ``wavelength``, ``channel``, ``value``, ``uncertainty``, ``index``,
        ``remark``, ``ignore``.
    name
        Which angle or component: ``theta_i``, ``wo_z``; of a value: ``brdf``, ``brdf_cos_r``, ``brdf_cos_i``, ``reflectance_factor``.
    unit
        A key of ``factors``, or "" where the name says none.
    channel
        The name of the channel of a value, and of the value that an uncertainty belongs to; "" where the name says none.
    wavelength
        That of the channel, in `unit_of_wavelength`.
    relative, expanded
        Of an uncertainty: a share of the value; two standard deviations.
    """

    role: str
    name: str = ""
    unit: str = ""
    channel: str = ""
    wavelength: float | None = None
    unit_of_wavelength: str = ""
    relative: bool = False
    expanded: bool = False


def normal(name: str) -> str:
    """A name in lower case, with Greek letters and plus-minus signs spelt out."""
    text = unicodedata.normalize("NFKC", name).replace("\u2212", "-").replace("\u00b5", "\u03bc").strip().lower()
    for letter, word in _GREEK.items():
        text = text.replace(letter, word)
    for sign in TABLES["uncertainty"]["signs"]:
        text = text.replace(sign, " uncertainty ")
    return text.strip()


def key(name: str) -> str:
    """The letters and digits of a name."""
    return re.sub(r"[^a-z0-9]", "", name)


@cache
def _keys() -> dict[str, tuple[str, str, str]]:
    """key -> role, name, unit."""
    found: dict[str, tuple[str, str, str]] = {}
    for group, role in (("angles", "angle"), ("vectors", "vector"), ("values", "value"), ("channels", "value")):
        for name, aliases in TABLES[group].items():
            found |= {key(alias): (role, name, "") for alias in aliases}
    for unit, aliases in TABLES["times"].items():
        found |= {key(alias): ("time", "", unit) for alias in aliases}
    for role, aliases in TABLES["others"].items():
        found |= {key(alias): (role, "", "") for alias in aliases}
    found |= {key(alias): ("index", "", "") for alias in TABLES["index"]}
    found |= {key(alias): ("remark", "", "") for alias in TABLES["remarks"]}
    return found


@cache
def _units() -> dict[str, list[tuple[str, str]]]:
    """What is written -> (dimension, unit)."""
    found: dict[str, list[tuple[str, str]]] = {}
    for dimension, units in TABLES["units"].items():
        for unit, texts in units.items():
            for text in texts:
                found.setdefault(text, []).append((dimension, unit))
    return found


def unit_of(text: str, dimension: str) -> str | None:
    """The unit that a text means for a dimension, or None; a ratio is a unit of values."""
    for found, unit in _units().get(normal(text), ()):
        if found == dimension or (dimension == "brdf" and found == "ratio"):
            return unit
    return None


def is_unit(text: str) -> bool:
    """Whether a text is a unit of anything."""
    return normal(text) in _units()


@lru_cache(maxsize=65536)
def column(name: str) -> Column | None:
    """What a name says, or None for one that is not known.

    Raises
    ------
    FormatError
        For a known name with the unit of something else, such as ``theta_i (nm)``.
    """
    text = normal(name)
    wrong: Column | None = None
    for stem, unit in _splits(text):
        found = _stem(stem, name)
        if found is None or found.role in ("index", "remark"):
            if unit == "" and found is not None:
                return found
            continue
        if unit == "":
            return None if found.unit == "with unit" else found
        dimension = _DIMENSION.get(found.role)
        known = unit_of(unit, dimension) if dimension else None
        if known is not None and found.unit in ("", "with unit"):
            if known == "%" and found.role == "uncertainty":
                return replace(found, unit="%", relative=True)
            return replace(found, unit=known)
        if known is None and len(unit) > 1:
            wrong = wrong or found
    if wrong is not None:
        raise FormatError(
            f"The column {name!r} is {wrong.role} {wrong.name} by its name, and its unit is that of something else",
            "Correct the name, or say what it is with --read column:NAME=ROLE",
        )
    return None


def _splits(text: str) -> list[tuple[str, str]]:
    """Ways to see a name as a stem and a unit, the most explicit first."""
    found: list[tuple[str, str]] = []
    for pattern in (r"(.+?)\s*\(([^()]*(?:\(-?1\))?)\)", r"(.+?)\s*\[([^\[\]]*)\]", r"(.+?)\s*\{([^{}]*)\}"):
        match = re.fullmatch(pattern, text)
        if match and match[2].strip() in _units():
            found.append((match[1], match[2].strip()))
    for pattern in (r"(.+?)\s+in\s+(.+)", r"(.+?)\s*/\s*(.+)", r"(.+)[\s_.,]+(\S+)", r"(.+?)(%|°)"):
        match = re.fullmatch(pattern, text)
        if (
            match and match[2].strip(" .") in _units() and match[2] not in ("1", "-")
        ):  # R.1 is the second column called R
            found.append((match[1], match[2].strip(" .")))
    return [*found, (text, "")]


def _stem(stem: str, original: str) -> Column | None:
    known = _keys().get(key(stem))
    if known is not None:
        role, name, unit = known
        if role == "value" and name not in TABLES["values"]:
            return Column("value", "brdf", channel=name)
        return Column(role, name, unit)
    return _uncertainty(stem, original) or _value(stem, original)


def _value(stem: str, original: str) -> Column | None:
    """A column of values: a wavelength, a named channel, or both with a word for the quantity."""
    channel = re.fullmatch(r"(?:channel|band|ch)[ _]*(\d+)", stem)
    if channel:
        return Column("value", "brdf", channel=f"channel {channel[1]}")
    match = WAVELENGTH.fullmatch(stem)
    if match:
        unit = unit_of(match[2], "length") if match[2] else ""
        if unit is not None:
            return Column("value", "brdf", channel=match[0], wavelength=float(match[1]), unit_of_wavelength=unit)
    named = _NAMED.fullmatch(stem)
    if named and key(named[1] or named[3] or "") in _value_words():
        inside = _original_case(named[2] or named[4], original)
        part = _value(normal(inside), inside)
        quantity = _value_words()[key(named[1] or named[3])]
        if part is not None and part.wavelength is not None:
            return replace(part, name=quantity)
        return Column("value", quantity, channel=inside)
    tokens = [t for t in re.split(r"[^a-z0-9.]+", stem) if t]
    for n in range(1, len(tokens)):
        for words, rest in ((tokens[:n], tokens[n:]), (tokens[-n:], tokens[:-n])):
            quantity = _value_words().get("".join(words), "")
            if quantity:
                part = _stem_of_channel(" ".join(rest))
                if part is not None:
                    return replace(part, name=quantity)
    return None


def _stem_of_channel(text: str) -> Column | None:
    known = _keys().get(key(text))
    if known is not None:
        return Column("value", "brdf", channel=known[1]) if known[1] in TABLES["channels"] else None
    match = WAVELENGTH.fullmatch(text)
    unit = (unit_of(match[2], "length") if match[2] else "") if match else None
    if match is None or unit is None:
        return None
    return Column("value", "brdf", channel=text, wavelength=float(match[1]), unit_of_wavelength=unit)


@cache
def _value_words() -> dict[str, str]:
    return {key(alias): name for name, aliases in TABLES["values"].items() for alias in aliases}


def _original_case(text: str, original: str) -> str:
    at = normal(original).find(text)
    return original.strip()[at : at + len(text)] if at >= 0 and len(normal(original)) == len(original.strip()) else text


def _uncertainty(stem: str, original: str) -> Column | None:
    """``sigma_R``, ``u(f_r)``, ``brdf_unc``, ``relative uncertainty``, ``R std``: of which value, and of what kind."""
    named = _NAMED.fullmatch(stem)
    words = TABLES["uncertainty"]
    if named and named[2] and key(named[1]) in {*words["words"], *words["first"]}:
        value = _value(f"brdf[{named[2]}]", f"brdf[{_original_case(named[2], original)}]")
        return None if value is None else replace(value, role="uncertainty", name="")
    joined = re.sub(r"\b(standard|std)[ _.]*(deviation|dev)\b", "stddev", stem)
    tokens = [t for t in re.split(r"[^a-z0-9.]+", joined) if t]
    relative = any(t in words["relative"] for t in tokens)
    expanded = any(t in words["expanded"] for t in tokens) or bool(re.search(r"k\s*=\s*2\b", stem))
    rest = [t for t in tokens if t not in words["relative"] and t not in words["expanded"]]
    if re.search(r"k\s*=\s*2\b", stem):
        rest = [t for t in rest if t not in ("k", "2")]
    marked = [k for k, t in enumerate(rest) if t in words["words"] or (k == 0 and t in words["first"])]
    if not marked and not (expanded and not rest):
        return None
    if rest and rest[0] == "u" and marked[:1] == [0] and original.strip()[:1] == "U" and not expanded:
        return None  # a capital U is an expanded uncertainty by the GUM, and a careless u elsewhere
    rest = [t for k, t in enumerate(rest) if k not in marked and t not in words["passed_over"]]
    found = Column("uncertainty", relative=relative, expanded=expanded)
    if not rest or "".join(rest) in _value_words():
        return found
    value = _stem_of_channel(" ".join(rest)) or _value(" ".join(rest), " ".join(rest))
    if value is None:
        return None
    return replace(
        found, channel=value.channel, wavelength=value.wavelength, unit_of_wavelength=value.unit_of_wavelength
    )


def nearest(name: str) -> list[str]:
    """The three known names that are most like a name."""
    known = {
        key(a): a
        for group in ("angles", "vectors", "times", "others", "values", "channels")
        for v in TABLES[group].values()
        for a in v
    }
    known |= {
        "uncertainty": "uncertainty",
        "brdfunc": "brdf_unc",
        "relunc": "rel_unc",
        "timeh": "time_h",
        "wavelengthnm": "wavelength_nm",
    }
    known = {k: alias for k, alias in known.items() if len(k) > 1}
    wanted = key(normal(name))
    return [known[k] for k in difflib.get_close_matches(wanted, known, n=3, cutoff=0.0)]
