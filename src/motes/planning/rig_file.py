"""A rig as a TOML file: where its lamp and its detectors can stand, what is blocked, and what moves cost.

::

    name = "our goniometer"
    [lights]
    theta_deg = {from = 0, to = 75, step = 15}   # or a list
    phi_deg = [0]
    [views]                                       # or positions_deg = [[12, 180], [45, 180]]
    theta_deg = {from = 0, to = 80, step = 5}
    phi_deg = {from = 0, to = 180, step = 30}
    together = false                              # true: all views record each light at once
    [limits]
    retro_deg = 6                                 # closer to the lamp the detector would stand in its light
    mirror_deg = 0                                # closer to the mirror direction it is blinded
    apart_deg = 5                                 # two shots differ by this
    [[blocked]]                                   # a zone: all that it says must hold
    theta_r_deg = [0, 10]
    [cost]
    reading_s = 2
    light_s_per_deg = 0.5
    view_s_per_deg = 0.2
    at_once = false                               # lamp and detector move one after the other
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.directions import from_spherical
from motes.errors import DataError, FormatError
from motes.planning.offers import MOST_DIRECTIONS, Cost, Offer

Floats = NDArray[np.float64]
LARGEST_FILE = 1 << 20
# Pairs that are looked at before limits take some of them away.
MOST_PAIRS = 20 * MOST_DIRECTIONS
_SECTIONS = {
    "lights": ("theta_deg", "phi_deg", "positions_deg"),
    "views": ("theta_deg", "phi_deg", "positions_deg", "together"),
    "limits": ("retro_deg", "mirror_deg", "apart_deg"),
    "cost": ("reading_s", "light_s_per_deg", "view_s_per_deg", "at_once"),
}
_ZONE = ("theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "dphi_deg")


def read_rig(path: Path) -> Offer:
    """The rig that a TOML file describes.

    Raises
    ------
    FormatError
        For what is no TOML, or holds what a rig has not.
    DataError
        Where it sees nothing, or far too many directions.
    """
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise FormatError(f"{path} has more than {LARGEST_FILE:,} bytes, and is no rig", "Give the file of a rig")
        found = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise FormatError(f"{path} cannot be read: {error.strerror or error}", "Give the file of a rig") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise FormatError(f"{path} is not TOML: {error}", "docs/plan.md shows the file of a rig") from None
    return rig_of(found, path.stem)


def rig_of(found: Mapping[str, Any], name: str) -> Offer:
    """The rig that a mapping describes, as read from its file; `name` is what it is called where it does not say."""
    _only(found, ("name", *_SECTIONS, "blocked"), "a rig")
    parts = {section: found.get(section, {}) for section in _SECTIONS}
    for section, known in _SECTIONS.items():
        if not isinstance(parts[section], Mapping):
            raise FormatError(f"[{section}] of the rig is no section", "docs/plan.md shows the file of a rig")
        _only(parts[section], known, f"[{section}] of a rig")
    lights, views = _positions(parts["lights"], "lights"), _positions(parts["views"], "views")
    if len(lights) * len(views) > MOST_PAIRS:
        raise DataError(
            f"the rig has {len(lights):,} lights and {len(views):,} views, which make more than {MOST_PAIRS:,} pairs",
            "Take larger steps",
        )
    wi, wo = np.repeat(lights, len(views), axis=0), np.tile(views, (len(lights), 1))
    free = directions.above(wi, wo)
    limits = parts["limits"]
    retro, mirror = _number(limits, "retro_deg", 0.0, 180.0), _number(limits, "mirror_deg", 0.0, 180.0)
    if retro > 0:
        free &= _angle(wi, wo) >= retro
    if mirror > 0:
        free &= _angle(wi * [-1, -1, 1], wo) >= mirror
    zones = found.get("blocked", [])
    if not isinstance(zones, list):
        raise FormatError("'blocked' of the rig is no list of zones", "Write [[blocked]] above each zone")
    for zone in zones:
        free &= ~_in_zone(zone, wi, wo)
    together = parts["views"].get("together", False)
    costs = parts["cost"]
    cost = Cost(
        _number(costs, "reading_s", 0.0, 1e6),
        _number(costs, "light_s_per_deg", 0.0, 1e6, 0.0 if costs else 1.0),
        _number(costs, "view_s_per_deg", 0.0, 1e6, 0.0 if costs else 1.0),
        costs.get("at_once", False) is True,
        bool(costs),
    )
    title = " ".join(str(found.get("name", name)).split())[:80]
    if not free.any():
        raise DataError(
            f"{title} sees nothing: all its {len(wi)} pairs of lights and views are at the horizon, below it or blocked",
            "Angles count from the normal, in degrees; make its blocked zones and limits smaller",
        )
    shot = np.repeat(np.arange(len(lights)), len(views))[free] if together is True else None
    return Offer.of(title, wi[free], wo[free], shot=shot, apart_deg=_number(limits, "apart_deg", 0.0, 90.0), cost=cost)


def _only(given: Mapping[str, Any], known: tuple[str, ...], what: str) -> None:
    for key in given:
        if key not in known:
            raise FormatError(f"{what} has no {str(key)[:40]!r}", f"It has {', '.join(known)}")


def _number(given: Mapping[str, Any], key: str, low: float, high: float, default: float = 0.0) -> float:
    value = given.get(key, default)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high:
        raise FormatError(
            f"{key} of the rig is {str(value)[:40]}, not a number in [{low:g}, {high:g}]", "Mend the file"
        )
    return float(value)


def _angles(given: Any, key: str) -> Floats:
    """A list of degrees, or from, to, step."""
    if isinstance(given, Mapping):
        _only(given, ("from", "to", "step"), key)
        first, last = _number(given, "from", -360, 360), _number(given, "to", -360, 360)
        step = _number(given, "step", 0.01, 360, 10.0)
        return np.asarray(first + np.sign(last - first) * step * np.arange(int(abs(last - first) / step + 1e-9) + 1))
    values = given if isinstance(given, list) else [given]
    return np.array([_number({key: value}, key, -360, 360) for value in values], float)


def _positions(given: Mapping[str, Any], what: str) -> Floats:
    listed = given.get("positions_deg")
    if listed is None:
        if "theta_deg" not in given:
            raise FormatError(f"[{what}] of the rig has no theta_deg and no positions_deg", "Say where they can stand")
        theta, phi = _angles(given["theta_deg"], "theta_deg"), _angles(given.get("phi_deg", [0.0]), "phi_deg")
        if theta.size * phi.size > MOST_PAIRS:
            raise DataError(f"[{what}] has {theta.size * phi.size:,} positions", "Take larger steps")
        theta, phi = (a.ravel() for a in np.meshgrid(theta, phi, indexing="ij"))
    else:
        if not isinstance(listed, list) or not listed or not all(isinstance(p, list) and len(p) == 2 for p in listed):
            raise FormatError(
                f"positions_deg of [{what}] is no list of pairs", "Write positions_deg = [[12, 180], [45, 180]]"
            )
        theta, phi = np.array([_angles(pair, "positions_deg") for pair in listed]).T
    if not theta.size:
        raise DataError(f"[{what}] of the rig names no position", "Give it angles in degrees")
    made = from_spherical(np.radians(theta), np.radians(phi))
    made[np.abs(made) < 1e-15] = 0.0
    # At the normal every azimuth is one direction.
    _, first = np.unique(np.round(made, 9), axis=0, return_index=True)
    return np.asarray(made[np.sort(first)])


def _angle(a: Floats, b: Floats) -> Floats:
    return np.asarray(np.degrees(np.arccos(np.clip(np.sum(a * b, axis=1), -1, 1))) + 1e-9)


def _in_zone(zone: Any, wi: Floats, wo: Floats) -> NDArray[np.bool_]:
    if not isinstance(zone, Mapping) or not zone:
        raise FormatError("a blocked zone of the rig says nothing", f"It has {', '.join(_ZONE)}: [least, most]")
    _only(zone, _ZONE, "a blocked zone")
    phi_i, phi_r = (np.degrees(directions.phi(w)) % 360 for w in (wi, wo))
    apart = (phi_r - phi_i) % 360
    at = {
        "theta_i_deg": np.degrees(directions.theta(wi)),
        "theta_r_deg": np.degrees(directions.theta(wo)),
        "phi_i_deg": phi_i,
        "phi_r_deg": phi_r,
        "dphi_deg": np.minimum(apart, 360 - apart),
    }
    inside = np.ones(len(wi), bool)
    for key, given in zone.items():
        if not isinstance(given, list) or len(given) != 2:
            raise FormatError(f"{key} of a blocked zone is no pair", f"Write {key} = [least, most]")
        low, high = _angles(given, key)
        if key.startswith("phi"):  # around the circle, from the first to the second
            inside &= (at[key] - low) % 360 <= (high - low if high - low >= 360 else (high - low) % 360) + 1e-9
        else:
            inside &= (at[key] >= low - 1e-9) & (at[key] <= high + 1e-9)
    return inside
