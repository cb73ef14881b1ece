"""From a measurement and the user's wishes to a least-squares problem."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from motes.arrays import any_last
from motes.errors import DataError, MotesError
from motes.fitting.choice import parsed
from motes.fitting.columns import unit_of
from motes.fitting.even_weights import everywhere, one_number
from motes.fitting.losses import LOSSES, ROBUST, Floats, Loss
from motes.fitting.problem import Problem
from motes.fitting.quantities import Quantity, layout
from motes.fitting.scaled import Scaled, physical
from motes.measurements import Measurement
from motes.measurements.policy import LARGEST
from motes.models import BRDF, describe
from motes.models.expressions import Parsed


@dataclass(frozen=True)
class Wishes:
    """How a measurement is to be fitted: arguments of `motes.fit`, checked there."""

    loss: str
    robust: str
    weights: str | ArrayLike
    fixed: Collection[str] | Mapping[str, Any]
    per_channel: Collection[str]
    free_scale: bool = False
    errors: str = "auto"

    def about(self, data: Measurement) -> dict[str, Any]:
        """What a material says of the fit that made it."""
        told = {name: value for name, value in data.provenance.items() if isinstance(value, (str, int, float, bool))}
        return {"data": told, "loss": self.loss, "robust": self.robust}


class Fitted(NamedTuple):
    """A model, what is fitted of it, and what is held."""

    brdf: BRDF
    quantities: tuple[Quantity, ...]
    held: frozenset[str]


class Setup(NamedTuple):
    """A model without its data's values, a BRDF to start from if one was given, the problem, and the factor of weights that
    are inverse variances (`Weights`)."""

    brdf: BRDF
    start: BRDF | None
    problem: Problem
    factor: float | None


def fitted_of(
    model: str | BRDF | Parsed,
    channels: int,
    fixed: Collection[str] | Mapping[str, Any],
    per_channel: Collection[str],
    lenient: bool = False,
) -> Fitted:
    """What is fitted of a model; `lenient` lets names pass that it does not have (candidates of "auto")."""
    if not isinstance(model, (str, BRDF, Parsed)):
        raise DataError(
            f"a model of type {type(model).__name__} cannot be fitted", "Give text such as 'oren_nayar', or a BRDF"
        )
    brdf, held = (
        (model, frozenset[str]()) if isinstance(model, BRDF) else parsed(model) if isinstance(model, str) else model
    )
    names = [slot.name for slot in brdf.slots()]
    for name in (*fixed, *per_channel):
        if name not in names and not lenient:
            raise MotesError(f"{describe(brdf)} has no parameter {name!r}", f"It has {', '.join(names)}")
    if isinstance(fixed, Mapping):
        brdf = brdf.with_parameters({name: value for name, value in fixed.items() if name in names})
    held = held | (frozenset(fixed) & frozenset(names))
    quantities = layout(brdf, channels, held, frozenset(per_channel))
    if not quantities:
        raise MotesError(
            f"every parameter of {describe(brdf)} is held, so there is nothing to fit", "Hold fewer parameters"
        )
    return Fitted(brdf, quantities, held)


def check_enough(samples: int, parameters: int, model: BRDF, where: str = "") -> None:
    """That so many samples, `where` they are, can determine so many parameters of a model.

    Raises
    ------
    DataError
        When they are too few.
    """
    if samples <= parameters:
        raise DataError(
            f"{where}{samples} usable sample(s) cannot determine the {parameters} parameters of {describe(model)}",
            "Measure more directions, or fit a smaller model",
        )


def prepare(data: Measurement, model: str | BRDF | Parsed, wishes: Wishes, lenient: bool = False) -> Setup:
    """The problem of fitting `model` to `data`: with values (N, C) for one time, (T, N, C) for several."""
    brdf, quantities, held = fitted_of(model, data.n_channels, wishes.fixed, wishes.per_channel, lenient)
    shape = brdf
    if wishes.free_scale:
        shape = Scaled(brdf)
        quantities = tuple(map(physical, layout(shape, data.n_channels, held, frozenset(wishes.per_channel))))
    unit = unit_of(data.values, data.mask)
    loss = LOSSES[wishes.loss].of_unit(unit)
    full, factor = sample_weights(data, wishes.weights, loss)
    alike = one_number(full)  # as where nothing is masked
    used: Any = None if alike else any_last(full).any(axis=0)
    every = alike or bool(used.all())
    used = slice(None) if every else used  # no copies of large data
    wi, wo = (data.wi, data.wo) if every else (data.wi[used], data.wo[used])
    wi.setflags(write=False), wo.setflags(write=False)  # so that what is found out about them is kept
    values = (data.values if alike or full.all() else np.where(full > 0, data.values, 0.0))[:, used]
    full = full[:, used]
    if not values.any():
        raise DataError(
            f"all {int(np.count_nonzero(full))} usable samples are 0, so there is nothing to fit",
            "Check the exposure and the units of the data",
        )
    lost = 0
    if not loss.is_linear:  # which is finite wherever the value is
        with np.errstate(all="ignore"):
            lost = int(np.count_nonzero((full > 0) & ~np.isfinite(loss.transform(values, wi[:, 2:3]))))
    if lost:
        raise DataError(
            f"the loss {loss.name} has no value at {lost} sample(s): {loss.meaning.partition(' - ')[0]} of their negative f_r",
            "Choose another loss, or mask them",
        )
    single = data.n_times == 1
    problem = Problem(
        model=shape,
        quantities=quantities,
        fixed={
            slot.name: _held_value(slot.value, slot.parameter.per_channel, data.n_channels)
            for slot in brdf.slots()
            if slot.name in held
        },
        wi=wi,
        wo=wo,
        values=values[0] if single else values,
        weights=full[0] if single else full,
        loss=loss,
        robust=ROBUST["none"],
        common=0.0 if wishes.free_scale else data.common_uncertainty or 0.0,
        unit=unit,
    )
    return Setup(brdf, model if isinstance(model, BRDF) else None, problem, factor)


def _held_value(value: Any, per_channel: bool, channels: int) -> Any:
    if not (np.abs(value) <= LARGEST).all():
        raise DataError(
            f"a parameter is held at {np.abs(value).max():g}, outside [-{LARGEST:g}, {LARGEST:g}]",
            "Hold it at a value that a surface has",
        )
    if np.ndim(value) == 0:
        return value
    if per_channel and np.shape(value) in ((channels,), (1,)):
        return np.asarray(value)[None, None, :]
    raise DataError(
        f"a held value of shape {np.shape(value)} does not fit {channels} channels",
        "Give one value, or one for each channel",
    )


class Weights(NamedTuple):
    """Weights (T, N, C), 0 where masked, with mean 1 over the rest; and what they were multiplied with for that, where they are
    inverse variances of the residuals: chi-square is twice the objective over it.  None where nothing is known of the noise."""

    values: Floats
    factor: float | None


def uncertainties_of(data: Measurement, weights: str | ArrayLike) -> Floats | None:
    """The uncertainties (T, N, C) that samples are weighted by: where they have any, unless asked otherwise."""
    return data.uncertainties if isinstance(weights, str) and weights == "measurement" else None


def sample_weights(data: Measurement, weights: str | ArrayLike, loss: Loss) -> Weights:
    """The weights of a fit.

    An uncertainty u of a value r makes the residual of a loss uncertain by u T'(r): the weight is the inverse square of that,
    so that chi-square does not depend on the loss.
    """
    uncertainties = uncertainties_of(data, weights)
    if uncertainties is not None:
        slope = loss.slope(data.values, data.wi[None, :, 2:3])
        with np.errstate(all="ignore"):
            inverse = 1.0 / np.square(uncertainties * slope)
        return _scaled(data, np.where(data.mask & np.isfinite(inverse), inverse, 0.0), True)
    if isinstance(weights, str):
        if weights not in ("measurement", "uniform"):
            raise MotesError(
                f"weights {weights!r} is not 'measurement', 'uniform' or an array",
                "Give one of these words, or a weight for each direction",
            )
        given = data.weights if weights == "measurement" else np.ones(data.n_directions)
    else:
        try:
            given = np.asarray(weights, float)
        except (TypeError, ValueError, OverflowError):
            raise DataError("weights are not numbers", "Give one number >= 0 a direction") from None
    given = given[:, None] if given.ndim == 1 else given
    if given.shape not in ((data.n_directions, 1), (data.n_directions, data.n_channels)):
        expected = f"({data.n_directions},) or ({data.n_directions}, {data.n_channels})"
        raise DataError(
            f"weights of shape {np.shape(weights)} do not fit the data", f"Give an array of shape {expected}"
        )
    if not (np.isfinite(given).all() and (given >= 0).all()):
        raise DataError("weights hold a negative or non-finite value", "Weights are 0 or positive")
    if (given == given.flat[0]).all() and given.flat[0] > 0 and data.mask.all():
        return Weights(everywhere(1.0, data.mask.shape), None)
    return _scaled(data, np.where(data.mask, given, 0.0), False)


def _scaled(data: Measurement, full: Floats, inverse_variances: bool) -> Weights:
    used = int(np.count_nonzero(full))
    if used == 0:
        reasons = ", ".join(f"{count} {reason}" for reason, count in data.masked.items()) or "all weights are 0"
        raise DataError(
            f"no sample of {data.mask.size} is left to fit: {reasons}", "motes info DATA shows what was masked and why"
        )
    factor = used / float(full.sum())
    return Weights(full * factor, factor if inverse_variances else None)
