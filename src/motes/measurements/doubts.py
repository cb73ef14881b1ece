"""Whether a measurement can be what it says: sentences for people, before anything is fitted.

Nothing here changes a number.  Each finding says what was seen and, where there is one, the option that would mend it.
"""

from __future__ import annotations

from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.arrays import any_last, dot, median
from motes.measurements.fillers import fillers
from motes.measurements.measurement import Measurement

Floats = NDArray[np.float64]

ENERGY = 1.05  # pi f_r of the typical sample; a perfect white diffuser has 1
BLACKEST = 3e-4  # pi f_r of arrays of carbon nanotubes, as their makers state it
AWAY = 0.35  # rad from the half vector to the normal: beyond most highlights
LIGHT = (100.0, 100_000.0)  # nm
FEWEST = 20  # samples that a statement needs
MOST_ROWS = 2000  # directions that the sides of the highlight are compared with
MOST_REPEATED = 100_000  # directions among which repeated ones are looked for
WIDTHS = (0.05, 0.1, 0.2, 0.35, 0.5)  # of highlights [rad]
RIDGE = 1e-10  # of squares that are 1
BETTER = 0.25  # the turned azimuths must leave so much of the squared residuals, or less


# Of measurements, which do not change: each fit of one says so again.
_known: WeakKeyDictionary[Measurement, tuple[str, ...]] = WeakKeyDictionary()


def implausible(data: Measurement) -> tuple[str, ...]:
    """What is odd about a measurement, the most important first; empty when nothing is."""
    if data not in _known:
        _known[data] = tuple(_looked_for(data))
    return _known[data]


def _looked_for(data: Measurement) -> list[str]:
    found: list[str] = []
    for check in (fillers, _energy, _angles, _side, _wavelengths, _channels, _rows, _scans, _dark, _uncertainties):
        found += check(data)
    return found


def _reflected(data: Measurement) -> Floats:
    """pi f_r of the typical light (T, C), to be compared with 1: the spherical albedo where samples have solid angles, else the median away from
    the mirror direction; NaN where there are few samples."""
    result = np.full((data.n_times, data.n_channels), np.nan)
    cosines = data.wi[:, 2] * data.wo[:, 2]
    weighted = bool(np.ptp(data.weights) > 0)
    away = ~directions.half_vectors_within(AWAY, data.wi, data.wo)
    for t in range(data.n_times):
        for c in range(data.n_channels):
            use = data.mask[t, :, c] if weighted else data.mask[t, :, c] & away
            if np.count_nonzero(use) < FEWEST:
                continue
            v = data.values[t, :, c].compress(use)
            share = (data.weights * cosines)[use] if weighted else None
            middle = dot(v, share) / float(share.sum()) if share is not None else median(v)
            result[t, c] = np.pi * middle
    return result


def _energy(data: Measurement) -> list[str]:
    """More light out than in."""
    reflected = _reflected(data)
    if not np.any(np.isfinite(reflected)):
        return []
    t, c = (int(k) for k in np.unravel_index(np.nanargmax(reflected), reflected.shape))
    factor = float(reflected[t, c])
    if 0 < factor < BLACKEST:
        return [
            f"Hardly any light out: the brightest of the data has pi f_r = {factor:.2g}, and the blackest surfaces have {BLACKEST:g}. The values may be in "
            "another unit than 1/sr, or lack a scale; roughness goes with it, for light between facets goes with the square of the colour."
        ]
    if factor <= ENERGY:
        return []
    where = f"channel {data.channels[c]}" if data.n_channels > 1 else "the typical sample"
    said = f"More light out than in: {where} has pi f_r = {factor:.3g}, and a white diffuser has 1"
    if data.provenance.get("format") == "tvbrdf" and "irradiance" in data.provenance:
        return [
            f"{said}. The scale of these data is that of their irradiance; --read irradiance={_nice(factor)} or more would bring it below 1."
        ]
    table = data.provenance.get("format") == "csv"
    values = data.values[data.mask]
    if (values == np.round(values)).all():
        return [
            f"{said}; all values are whole numbers up to {values.max():.7g}, as the pixels of a picture or the counts of a detector: "
            "take off the picture's transfer function and the dark signal, and divide by what a white standard gives."
        ]
    if factor <= np.pi * ENERGY:
        mend = "reflectance factors (pi times the BRDF)", "reflectance_factor"
    elif factor <= 100 * np.pi * ENERGY:
        mend = "reflectance factors in percent", "reflectance_factor_percent"
    else:
        return [f"{said}: the values are not in 1/sr, or their scale is off."]
    how = f" --read 'column:NAME={mend[1]}' reads them as such." if table else ""
    return [f"{said}: these may be {mend[0]} and not the BRDF [1/sr].{how}"]


def _nice(x: float) -> str:
    return f"{x:.2g}"


def _angles(data: Measurement) -> list[str]:
    """Degrees that were read as radians, and the other way round."""
    below = ~directions.above(data.wi, data.wo)
    table = data.provenance.get("format") == "csv"
    found = []
    if len(below) >= FEWEST and below.mean() > 0.4:
        how = " --read angles=deg reads degrees where the columns name no unit." if table else ""
        found.append(
            f"{below.mean():.0%} of the directions are at or below the horizon: the angles may be in another unit.{how}"
        )
    highest = max(float(directions.theta(w[np.argmin(w[:, 2])])) for w in (data.wi, data.wo))
    if len(below) >= FEWEST and 0 < highest < 0.03:
        how = " --read 'column:NAME=theta_i_rad', and so on, reads them as such." if table else ""
        found.append(
            f"All directions lie within {np.degrees(highest):.2g} degrees of the normal: the angles may be in radians and not in degrees.{how}"
        )
    return found


def _side(data: Measurement) -> list[str]:
    """A highlight on the side of the lamp: azimuths that count from the mirror direction."""
    f, wi, wo = _grey(data)
    if len(f) < FEWEST:
        return []
    given, _ = _explained(wi, wo, f)
    if given < 1e-4:
        return []
    turned, share = _explained(wi, wo * np.array([-1.0, -1.0, 1.0]), f)
    if turned > BETTER * given or share < 0.03:
        return []
    how = (
        "--read azimuth=mirror reads them so."
        if data.provenance.get("format") == "csv"
        else "Check the convention of the source."
    )
    return [
        "The highlight sits on the side of the lamp: azimuths may count from the side of the mirror direction (as in ASTM E2387), or signed "
        f"theta_r be positive there. With the azimuths turned by 180 degrees simple lobes leave {np.sqrt(turned):.1%} of the values unexplained, "
        f"as they are {np.sqrt(given):.1%}. {how}"
    ]


def _grey(data: Measurement) -> tuple[Floats, Floats, Floats]:
    """The mean over the channels of the first usable time at some directions that are well away from the horizon."""
    t = int(np.argmax(data.mask.any(axis=(1, 2))))
    usable = data.mask[t].all(axis=1) & (data.wi[:, 2] > 0.15) & (data.wo[:, 2] > 0.15)
    rows = np.flatnonzero(usable)
    rows = rows[:: max(1, len(rows) // MOST_ROWS)]
    return data.values[t, rows].mean(axis=1), data.wi[rows], data.wo[rows]


def _explained(wi: Floats, wo: Floats, f: Floats) -> tuple[float, float]:
    """Of f cos(theta_i): the squared residuals of the best sum of simple lobes with weights >= 0, as a share of the squares, and the share of
    the highlights in what is explained."""
    cos_i, cos_r = np.ascontiguousarray(wi[:, 2]), np.ascontiguousarray(wo[:, 2])
    cross = wi[:, 0] * wo[:, 0] + wi[:, 1] * wo[:, 1]  # sin sin cos(dphi)
    lobes = np.empty((3 + len(WIDTHS), len(f)))
    lobes[0] = 1.0
    lobes[1] = np.maximum(cross, 0) / np.maximum(cos_i, cos_r)
    lobes[2] = (1 - cos_i**2) * (1 - cos_r**2)
    lobes[3:] = np.exp(-((directions.theta(wi + wo) / np.array(WIDTHS)[:, None]) ** 2)) / (4 * cos_i * cos_r)
    lobes *= cos_i
    lobes /= np.maximum(np.sqrt(np.einsum("kn,kn->k", lobes, lobes)), 1e-300)[:, None]
    matrix, target = lobes.T, f * cos_i
    # Lobes may be alike; the ridge takes the smallest weights then.
    gram, onto = matrix.T @ matrix + RIDGE * np.eye(matrix.shape[1]), matrix.T @ target
    used = np.ones(matrix.shape[1], bool)
    weights = np.zeros(matrix.shape[1])
    while (
        used.any()
    ):  # leave out what would be negative: an approximation of non-negative least squares that is good enough here
        weights[:] = 0
        rows = np.flatnonzero(used)
        weights[rows] = np.linalg.solve(gram[rows[:, None], rows], onto[rows])
        if weights.min() >= 0:
            break
        used[int(np.argmin(weights))] = False
    total = float(target @ target)
    if total == 0:
        return 0.0, 0.0
    residual = target - matrix @ weights
    highlight = matrix[:, -len(WIDTHS) :] @ weights[-len(WIDTHS) :]
    return float(residual @ residual) / total, float(highlight @ highlight) / total


def _wavelengths(data: Measurement) -> list[str]:
    w = data.wavelengths
    if w is None or (w.min() >= LIGHT[0] and w.max() <= LIGHT[1]):
        return []
    unit = "micrometres" if w.max() < LIGHT[0] else "another unit"
    how = (
        " --read wavelength_unit=um reads micrometres where the columns name no unit."
        if data.provenance.get("format") == "csv"
        else ""
    )
    return [f"Wavelengths from {w.min():g} to {w.max():g} nm are no light: they may be in {unit}.{how}"]


def _channels(data: Measurement) -> list[str]:
    """Channels that hold one number, or the same numbers."""
    found = []
    usable = ~any_last(~data.mask) if data.n_channels <= 3 else any_last(data.mask)
    if np.count_nonzero(usable) < FEWEST:
        return []
    values = data.values.reshape(-1, data.n_channels) if usable.all() else data.values[usable]
    few = values[:FEWEST]  # which tell as a rule, so that the rest need not be looked at
    constant = [k for k in range(data.n_channels) if _one_number(few[:, k]) and _one_number(values[:, k])]
    if constant:
        names = ", ".join(data.channels[k] for k in constant[:5])
        found.append(
            f"The same number stands at all directions in {names}: a perfect diffuser without noise, or a column that holds no reflectance."
        )
    firsts: dict[bytes, int] = {}
    for k in range(data.n_channels):
        first = firsts.setdefault(few[:, k].tobytes(), k)
        if first != k:
            first = firsts.setdefault(values[:, first].tobytes(), first)
            first = firsts.setdefault(values[:, k].tobytes(), k)
        if first != k and k not in constant:
            found.append(f"The channels {data.channels[first]} and {data.channels[k]} hold the same numbers.")
    return found[:3]


def _one_number(values: Floats) -> bool:
    """Whether there is no other; NaN is none."""
    numbers = values[~np.isnan(values)]
    return not len(numbers) or bool(numbers.min() == numbers.max())


def _rows(data: Measurement) -> list[str]:
    """Rows that stand there twice, values and all."""
    t = int(np.argmax(data.mask.any(axis=(1, 2))))
    usable = any_last(data.mask[t])
    if not FEWEST <= np.count_nonzero(usable) <= MOST_REPEATED:
        return []
    rows = np.concatenate([data.wi, data.wo, data.values[t]], axis=1)[usable]
    # Equal rows have equal sums; of others hardly any have, and only what shares its sum is looked at number by number.
    sums = np.zeros(len(rows))
    with np.errstate(all="ignore"):
        for k, column in enumerate(rows.T):
            sums += column * np.sqrt(k + 2.0)
    sums = np.nan_to_num(sums)  # what is no number counts as equal
    order = np.argsort(sums)
    same = np.diff(sums[order]) == 0
    shared = rows[order[np.append(same, False) | np.append(False, same)]]
    repeated = len(shared) - len({row.tobytes() for row in shared + 0.0})
    if repeated < 2:
        return []
    return [f"{repeated} of {len(rows)} samples repeat others, directions and values alike: they count twice in a fit."]


def _scans(data: Measurement) -> list[str]:
    """Times of samples that were taken for times of scans."""
    if data.n_times < 4:
        return []
    measured = data.mask.any(axis=2).sum(axis=1)
    typical = float(np.median(measured))
    if typical >= 3 or data.n_directions < 3:
        return []
    how = (
        " --read 'column:NAME=ignore' takes all samples as one scan." if data.provenance.get("format") == "csv" else ""
    )
    return [
        f"{data.n_times} times have {typical:g} sample{'s' if typical != 1 else ''} each: the times may be those of the samples and not of scans.{how}"
    ]


def _dark(data: Measurement) -> list[str]:
    """More negative samples than noise about 0 has."""
    found = []
    usable = data.mask
    below = (data.values < 0) & usable
    if not below.any():
        return []
    n, negative = usable.sum(axis=(0, 1)), below.sum(axis=(0, 1))
    for c in np.flatnonzero((n >= FEWEST) & (negative > 0.5 * n + 2 * np.sqrt(n))):
        found.append(
            f"{negative[c] / n[c]:.0%} of the samples of {data.channels[c]} are below 0, and noise about 0 has half: "
            "too much of a dark reading may have been taken off."
        )
    return found[:3]


def _uncertainties(data: Measurement) -> list[str]:
    if data.uncertainties is None:
        return []
    known = data.mask & np.isfinite(data.uncertainties)
    if known.sum() < FEWEST:
        return (
            [f"{int(known.sum())} of {int(data.mask.sum())} usable samples have an uncertainty."]
            if data.mask.any()
            else []
        )
    v, u = np.abs(data.values[known]), data.uncertainties[known]
    found = []
    share = float(np.median(u[v > 0] / v[v > 0])) if (v > 0).any() else 0.0
    if share > 1:
        found.append(
            f"The typical uncertainty is {share:.3g} times its value: it may be in percent "
            "(--read 'column:NAME=relative_uncertainty_percent'), or of another quantity."
        )
    unknown = int(data.mask.sum() - known.sum())
    if unknown:
        found.append(f"{unknown} of {int(data.mask.sum())} usable samples have no uncertainty.")
    return found
