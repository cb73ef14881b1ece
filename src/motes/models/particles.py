"""What the particles of dust may be, by how often light is scattered."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from motes.arrays import Array, is_foreign
from motes.errors import ParameterError
from motes.models.multiple_scattering import LEAST_G, MOST_G
from motes.parameters import Parameter, Role

SCATTERING = (SINGLE, MULTIPLE) = ("single", "multiple")


def physical(
    walked: Iterable[tuple[tuple[str, ...], Parameter, Array]], scattering: str
) -> Iterator[tuple[tuple[str, ...], Parameter, Array]]:
    """Parameters of dust, with the bounds of real particles where light is scattered more than once."""
    for path, declared, value in walked:
        if scattering == MULTIPLE and declared.role is Role.SINGLE_SCATTERING_ALBEDO:
            declared = replace(declared, bounds=(0, 1), fit_bounds=(0, 1))
        elif scattering == MULTIPLE and declared.role is Role.ASYMMETRY:
            declared = replace(declared, bounds=(LEAST_G, MOST_G), open=False, fit_bounds=(LEAST_G, MOST_G))
        yield path, declared, value


def check_physical(owner: str, w: Array, g: Array) -> None:
    """Raise `ParameterError` for dust that cannot be: that sends back more than it meets, or scatters in one line."""
    for value, (least, most), name, advice in (
        (
            w,
            (0, 1),
            "w",
            "w is the share of light that a particle scatters; fits of single scattering may hold more than 1",
        ),
        (g, (LEAST_G, MOST_G), "g", "multiple scattering was computed in that range only"),
    ):
        if not is_foreign(value) and not (np.all(np.asarray(value) >= least) and np.all(np.asarray(value) <= most)):
            worst = np.asarray(value).ravel()[int(np.argmax(np.abs(np.asarray(value) - 0.5 * (least + most))))]
            raise ParameterError(f"{owner}: {name} = {worst:g} is outside [{least:g}, {most:g}]", advice)
