"""`Specimen`: anything that reflects, as functions of directions; what every check asks, whatever program it comes from."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError
from motes.material import Material
from motes.models import BRDF

Floats = NDArray[np.float64]
Numbers = NDArray[np.floating[Any]]
Evaluation = Callable[[Floats, Floats], Floats]


class Drawn(NamedTuple):
    """Samples (N, 3), their density (N,) [1/sr], their weight (N, C) or None, and which of them are peaks of Dirac (N,)."""

    wo: Floats
    pdf: Floats
    weight: Floats | None
    peaks: NDArray[np.bool_] | None = None


class Slopes(NamedTuple):
    """Derivatives (N, C) of the values by a parameter: what the subject says, central differences of its values, and how far rounding may
    move those."""

    said: Floats
    differences: Floats
    noise: float = 0.0


@dataclass(frozen=True)
class Specimen:
    """What is certified.

    Attributes
    ----------
    name, kind
        For people.
    eval
        The BRDF [1/sr] without the cosine, (N, C), of directions (N, 3), (N, 3); float64.
    digest
        SHA-256 of what it is.
    sample
        Directions for one `wi` (3,) and numbers (N, 2), or None.
    pdf
        The density (N,) [1/sr] of `sample` for directions (N, 3), (N, 3), or None.
    narrow
        `eval` computed in float32, or None.
    slopes
        Derivatives by its parameters, by name, for directions (N, 3), (N, 3), or None.
    model
        The BRDF that it is, where it is one of Motes'.
    material, moment
        The material that it is, with the moment [h] where it changes; None where it is none of Motes'.
    reciprocal
        Whether it says of itself that light may be turned around; None where it says nothing.
    measured
        Whether its values come from an instrument, whose noise is no fault.
    transmits
        Whether light goes through: then what lies below the horizon is not looked at, and energy is that of both sides.
    both_sides
        Whether it reflects on the other side of the surface as well.
    single
        Whether it computes in float32 alone.
    strict
        Whether it must answer 0 below the horizon; a bare formula need not.
    pairs
        Directions (N, 3), (N, 3) at which alone it has values, or None where it can be asked everywhere.
    facts, versions
        For the page.
    """

    name: str
    kind: str
    eval: Evaluation
    digest: str
    sample: Callable[[Floats, Floats], Drawn] | None = None
    pdf: Evaluation | None = None
    narrow: Callable[[Numbers, Numbers], Numbers] | None = None
    slopes: Callable[[Floats, Floats], Mapping[str, Slopes]] | None = None
    model: BRDF | None = None
    material: Material | None = None
    moment: float | None = None
    reciprocal: bool | None = None
    measured: bool = False
    transmits: bool = False
    both_sides: bool = False
    single: bool = False
    strict: bool = True
    pairs: tuple[Floats, Floats] | None = None
    facts: Mapping[str, str] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)


def digest_of(*parts: str | bytes) -> str:
    """SHA-256 of texts and files, each with its length, so that no two lists of parts have one digest."""
    total = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        total.update(len(data).to_bytes(8, "big") + data)
    return total.hexdigest()


def shaped(values: Any, count: int, owner: str) -> Floats:
    """What a function answered as (N, C) in float64.

    Raises
    ------
    DataError
        When it is no array of numbers with a row for each pair of directions.
    """
    if np.iscomplexobj(values):
        raise DataError(f"{owner} answers complex numbers", "Return their real part, or their square")
    try:
        array = np.asarray(values, np.float64)
    except (TypeError, ValueError):
        raise DataError(
            f"{owner} answers {type(values).__name__}, which is no array of numbers", "Return an array (N,) or (N, C)"
        ) from None
    if array.shape[:1] != (count,) or array.ndim > 2 or (array.ndim == 2 and not array.shape[1]):
        raise DataError(
            f"{owner} answers an array of shape {array.shape} for {count} pairs of directions",
            "Return an array (N,) or (N, C)",
        )
    return array[:, None] if array.ndim == 1 else array
