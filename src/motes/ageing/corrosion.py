"""Iron rusts, as it was measured: the course of the mean over the STAF maps of `motes.ageing.rust`, carried over to any surface."""

from __future__ import annotations

import numpy as np

from motes import channels
from motes.ageing.carrying import carried, stretched
from motes.ageing.highlights import heights
from motes.ageing.phenomenon import Aged, Option, Phenomenon, Task
from motes.ageing.rust import MEAN_K_D, MEAN_R, MEAN_SPECULAR, MEAN_TIMES, highlight_strength
from motes.errors import ParameterError
from motes.material import Material
from motes.models import Lambert, TorranceSparrow
from motes.parameters import Role
from motes.trends import AnyTrend, Tabulated

#: What was measured, with how it is carried over.
SOURCES: dict[Role, np.ndarray] = {
    Role.HIGHLIGHT_WIDTH: MEAN_R,
    Role.HIGHLIGHT_STRENGTH: highlight_strength(MEAN_SPECULAR, MEAN_R),
    Role.DIFFUSE_COLOUR: MEAN_K_D,
}
RULES = {Role.DIFFUSE_COLOUR: "difference", Role.HIGHLIGHT_STRENGTH: "ratio", Role.HIGHLIGHT_WIDTH: "difference"}


def _rusting(task: Task) -> Aged:
    share, notes = task.options["extent"], []
    observed = (0.0, 1.0)
    reference = 0 if task.given == "start" else -1
    brdf = task.brdf
    if brdf.channels != 3 and any(np.ndim(s.value) for s in brdf.slots(Role.DIFFUSE_COLOUR)):
        notes.append("the colours of the rust were averaged: the surface does not have the channels R, G, B")
    trends: dict[str, AnyTrend] = {}
    for role, measured in SOURCES.items():
        values = measured[reference] + share * (measured - measured[reference])
        for slot in brdf.slots(role):
            course = values
            if values.ndim == 2 and (brdf.channels != 3 or (np.ndim(slot.value) and len(slot.value) != 3)):
                course = values.mean(-1)
            own = brdf.beside(slot, Role.HIGHLIGHT_WIDTH) if role is Role.HIGHLIGHT_STRENGTH else None
            if (
                own is not None
            ):  # the measured strength is a height: where that of the surface is not, its own width counts
                unit = [float(np.mean(heights(brdf, slot, w))) for w in trends[own.name](_moments(task))]
                course = course / np.array(unit)
            value = slot.value
            if course.ndim == 1 and np.ndim(value):
                course = np.repeat(course[:, None], len(value), axis=1)
            trend = stretched(Tabulated(MEAN_TIMES, course), task.interval, observed)
            trends[slot.name], rule = carried(trend, course[reference], value, RULES[role], slot.parameter.bounds)
            notes.append(f"{slot.name} by {rule}")
    missing = [role.value for role in SOURCES if not brdf.slots(role)]
    if missing:
        notes.append(f"the surface has no {', no '.join(missing)}: nothing moved there")
    if not trends:
        raise ParameterError(
            "rusting: the surface has neither a diffuse colour nor a highlight", "Give it a diffuse part or a highlight"
        )
    return Aged(brdf, trends, notes)


def _moments(task: Task) -> np.ndarray:
    """The measured moments in the time of the task [h]."""
    first, last = task.interval
    return first + (last - first) * MEAN_TIMES


_IRON = Material(
    Lambert(K_d=tuple(MEAN_K_D[0]))
    + TorranceSparrow(K_s=float(highlight_strength(MEAN_SPECULAR, MEAN_R)[0]), sigma_s=float(MEAN_R[0])),
    "cast iron",
    channels.RGB,
)


RUSTING = Phenomenon(
    "rusting",
    "Iron rusts.  Oxide grows in grains on the polished metal: facets tilt (sigma_s grows), less metal is left to mirror light (K_s falls), and the "
    "diffuse colour turns orange, then dark.  The courses are the means over the STAF maps of rusting cast iron (tvBTF45; Gu et al., 'Time-varying "
    "Surface Appearance', 2006) at six times; another surface gets their differences (K_d, sigma_s) and ratios (K_s).",
    {
        Role.HIGHLIGHT_WIDTH: "grows: tabulated, measured",
        Role.HIGHLIGHT_STRENGTH: "falls: tabulated, measured",
        Role.DIFFUSE_COLOUR: "brightens towards orange and darkens again: tabulated, measured",
    },
    {"extent": Option(1.0, (0, 1), "share of the measured change; 1 is all of it")},
    "start",
    RULES,
    _rusting,
    _IRON,
)
