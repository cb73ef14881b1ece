"""Transfer: the course of one material's parameters, carried over to another ("Time-Varying BRDFs": effects such as paint drying and dust accumulation
applied to arbitrary surfaces and novel materials).

==========  ==================================  ============================================================================================
parameter   rule                                why
==========  ==================================  ============================================================================================
``K_d``     ratio in each channel               drying scales how much light the pigment gives back, whatever its colour; the straight line
                                                between wet and dry colour stays a straight line
``K_s``     ratio; difference when the target   the film is what shines: its highlight scales with the one that is there, and adds to that
            is given at the end                 of a dry surface (a ratio to a highlight that has all but gone would mean nothing)
``sigma_s`` ratio                               a film that levels the facets narrows every distribution of them alike
``tau``     absolute                            dust lies on a surface, whatever is below
``w, g``    absolute                            they are the dust's own
rusting     K_d, sigma_s difference; K_s ratio  rust grows *on* the metal: it adds its own colour and tilt, and covers a share of what mirrors
==========  ==================================  ============================================================================================

The rule holds with respect to one moment, at which the target is what it is (``given``); there the result equals the target.  All else of the target
(``sigma_d``, the Fresnel term, further trends) stays.  Parameters are known by their roles: the names above stand for those of any model.
Covariances are not carried: they are those of the source's data, and say nothing of the target.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from motes.ageing.carrying import Interval, carried, grey, mapped, meaned, stretched
from motes.ageing.highlights import with_highlight
from motes.ageing.phenomena import phenomenon
from motes.ageing.phenomenon import Aged, Phenomenon, anchored, as_material, finished, interval_of
from motes.ageing.settling import OWN, dusted, scattered
from motes.errors import ParameterError
from motes.material import Material
from motes.models import BRDF, TorranceSparrow, layer_of
from motes.parameters import Role
from motes.trends import AnyTrend, Tabulated


def age(
    material: Material | BRDF,
    phenomenon_name: str | Phenomenon,
    *,
    hours: float | tuple[float, float] | None = None,
    source: Material | None = None,
    given: str | None = None,
    **overrides: Any,
) -> Material:
    """A material to which something happens.

    Parameters
    ----------
    material
        What it happens to.
    phenomenon_name
        A key of `motes.ageing.phenomena.PHENOMENA`.
    hours
        The first and the last time [h]; one number is the last, the first then 0.  None: those over which the source was observed.  Other times stretch the
        source's course: what took it from its first to its last scan takes the target so long.
    source
        A fitted time-varying material whose trends are carried over.  None: the phenomenon's defaults.
    given
        ``"start"`` when `material` is what it is before it happens, ``"end"`` when it is what comes out.  By default the phenomenon's own: the
        end for drying (materials are mostly measured dry), the start for dust and rust.
    overrides
        Options of the phenomenon.  With a source only those that do not compete with it: ``w`` and ``g`` of dust.

    Returns
    -------
    A material whose ``about["ageing"]`` says what was done.

    Raises
    ------
    ParameterError
        For what does not go together; the message says what.

    Examples
    --------
    >>> from motes import Lambert
    >>> dusty = age(Lambert(K_d=0.2), "dust", hours=48, tau_growth=0.3)
    >>> round(dusty.at(24).parameters["tau"], 3)
    0.15
    """
    what = phenomenon(phenomenon_name)
    if source is None:
        if hours is None:
            raise ParameterError(
                f"{what.name}: no time is given", "Give hours (--hours 24), or a source that has times of its own"
            )
        return what(material, hours=hours, given=given, **overrides)
    if not isinstance(source, Material):
        raise ParameterError(
            f"the source is a {type(source).__name__}, not a material",
            "Give a material that motes fit wrote from several scans",
        )
    allowed = tuple(OWN) if Role.DEPTH in what.moves else ()
    unknown = [name for name in overrides if name not in allowed]
    if unknown:
        raise ParameterError(
            f"{what.name} from {source.name}: {unknown[0]} comes from the source",
            f"With a source, {' and '.join(allowed) or 'nothing'} can be given",
        )
    observed = source.interval
    if observed is None:
        raise ParameterError(
            f"{source.name} does not change with time", "Fit several scans: motes fit FOLDER, all scans of a sample"
        )
    interval = observed if hours is None else interval_of(hours)
    given = what.moment(given)
    target, origin = as_material(material), as_material(source)
    brdf = anchored(target, interval, given, what.moves)
    moving = _moving(origin, what)
    values = {name: what.options[name].checked(what.name, name, v) for name, v in overrides.items() if v is not None}
    if Role.DEPTH in what.moves:
        aged = _dust(target, brdf, origin, observed, interval, values)
    else:
        aged = _surface(target, brdf, origin, what, moving, observed, interval, given)
    step = {"phenomenon": what.name, "given": given, "source": source.name, "source_hours": list(observed)}
    return finished(target, aged, interval, step)


def _moving(source: Material, what: Phenomenon) -> dict[Role, str]:
    """Role -> the source's slot that follows a trend: the first lobe, and the dust on top, that has one."""
    moving = {}
    for role in what.moves:
        slots = [slot.name for slot in source.brdf.slots(role) if slot.name in source.trends]
        if slots:
            moving[role] = slots[0]
    if not moving:
        raise ParameterError(
            f"nothing of {what.name} follows time in {source.name}: it would have to be the {_listed(what.moves)}",
            f"Its trends are {', '.join(source.trends)}",
        )
    return moving


def _listed(roles: Iterable[Role]) -> str:
    return ", the ".join(role.value for role in roles)


def _same_channels(target: Material, source: Material) -> bool:
    return target.brdf.channels == source.brdf.channels and (
        target.channels == source.channels or source.brdf.channels == 1
    )


def _surface(
    target: Material,
    brdf: BRDF,
    source: Material,
    what: Phenomenon,
    moving: Mapping[Role, str],
    observed: Interval,
    interval: Interval,
    given: str,
) -> Aged:
    moment = observed[0 if given == "start" else 1]
    then = {slot.name: slot.value for slot in source.at(moment).slots()}
    notes: list[str] = []
    added = False
    widths = source.brdf.slots(Role.HIGHLIGHT_WIDTH)
    if set(_HIGHLIGHT) & set(moving) and widths:
        brdf, added = with_highlight(brdf, TorranceSparrow(K_s=0.0, sigma_s=grey(then[widths[0].name])))
        if added:
            notes.append("the target has no highlight: it was given that of the source, as it is")
    trends: dict[str, AnyTrend] = {}
    averaged = False
    for role, origin in moving.items():
        for slot in brdf.slots(role):
            trend, reference, value = stretched(source.trends[origin], interval, observed), then[origin], slot.value
            if np.ndim(reference) and not _same_channels(target, source):
                # The mean over the channels stands for all: channels of different names are not the same light.
                trend, reference, averaged = meaned(trend), grey(reference), True
            rule = what.rules[role]
            if added and role in _HIGHLIGHT:
                rule = "absolute"
            elif role is Role.HIGHLIGHT_STRENGTH and given == "end" and rule == "ratio":
                rule = "difference"
            if np.ndim(value) and not np.ndim(reference):  # the target has channels and the source one value for all
                reference = np.broadcast_to(reference, np.shape(value))
            if isinstance(reference, np.ndarray) and reference.ndim and rule != "absolute":
                trend = _broadened(trend, len(reference))
            trends[slot.name], followed = carried(trend, reference, value, rule, slot.parameter.bounds)
            notes.append(f"{slot.name} by {followed}" + (" (the source's vanishes)" if followed != rule else ""))
    if averaged:
        listed = ", ".join(source.channels[:4]) + (", ..." if len(source.channels) > 4 else "")
        notes.append(f"the mean over the source's channels ({listed}) stands for those of the target")
    still = [role for role in what.moves if role not in moving]
    if still:
        notes.append(f"the {_listed(still)} does not follow time in the source, and stays")
    absent = [role.value for role in moving if not brdf.slots(role)]
    if absent:
        notes.append(f"the target has no {', no '.join(absent)}")
    if not trends:
        raise ParameterError(
            f"{target.name} has none of the parameters that move: the {_listed(moving)}",
            "Choose another target or source",
        )
    return Aged(brdf, trends, notes)


_HIGHLIGHT = (Role.HIGHLIGHT_STRENGTH, Role.HIGHLIGHT_WIDTH)


def _broadened(trend: AnyTrend, channels: int) -> AnyTrend:
    """The same trend with a value for each channel."""
    if isinstance(trend, Tabulated):
        values = trend.values if trend.values.ndim > 1 else np.repeat(trend.values[:, None], channels, axis=1)
        return Tabulated(trend.hours, values)
    return mapped(trend, lambda q: np.broadcast_to(q, (channels,)).copy(), trend.bounds)


def _dust(
    target: Material,
    brdf: BRDF,
    source: Material,
    observed: Interval,
    interval: Interval,
    given: Mapping[str, Any],
) -> Aged:
    above = layer_of(source.brdf)
    if above is None or above.depth.name not in source.trends:
        raise ParameterError(
            f"{source.name} has no layer of dust on top whose tau follows time", "Fit it as dust_layer(...)"
        )
    notes, dust = [], dict(given)
    first = source.at(observed[0]).parameters
    for name, role in OWN.items():
        slot = above.slot(role)
        if name in dust or slot is None:
            continue
        value = first[slot.name]
        if slot.name in source.trends:
            notes.append(f"{name} follows time in the source; its first value was taken")
        if np.ndim(value) and not _same_channels(target, source):
            value = grey(value)
            notes.append(f"{name} is the mean over the source's channels")
        dust[name] = value
    # w and g mean what they are only with the way of scattering that they were fitted with.
    layer, added = dusted(brdf, dust.get("w"), dust.get("g"), above.whole.options().get("scattering"))
    trend = stretched(source.trends[above.depth.name], interval, observed)
    moved, _ = carried(trend, 0.0, 0.0, "absolute", (0.0, np.inf))
    notes.append("a layer of dust was laid over the target" if added else "the target's own dust was replaced")
    notes += ["tau, w and g as in the source; the base does not change", *scattered(layer)]
    return Aged(layer.whole, {layer.depth.name: moved}, notes)
