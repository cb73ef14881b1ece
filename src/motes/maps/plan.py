"""What a run over a map does at every block: the settings, the model, and where fits start."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any, Self, final

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError
from motes.fitting.result import Trial
from motes.fitting.texels import TexelSolver
from motes.fitting.verdicts import Status
from motes.maps.choosing import choose
from motes.maps.settings import Settings, directions_used, sampled, solver_of, with_block
from motes.maps.stack import MapStack, open_stack
from motes.models import BRDF


@final
@dataclass(frozen=True)
class Plan:
    """Everything that fits a block: workers read it from the output, so that a task is no more than a path and two numbers.

    Parameters
    ----------
    settings
        What was asked for.
    model
        The model that is fitted: the one asked for, or the one chosen.
    starts
        Parameter vectors (K, P) that every texel may start from.
    tried
        Of ``model="auto"``: what was compared, summed over some texels from all over the map.
    """

    settings: Settings
    model: str
    starts: list[list[float]]
    tried: tuple[Trial, ...]

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON values."""
        tried = [asdict(trial) | {"status": str(trial.status)} for trial in self.tried]
        return {"settings": asdict(self.settings), "model": self.model, "starts": self.starts, "tried": tried}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Back from `to_dict`, of this or an earlier Motes."""
        tried = data["tried"]
        if isinstance(
            tried, Mapping
        ):  # an earlier Motes kept BIC less the best one's, by model, and 0 for the one that was given
            tried = [_only_bic(model, bic) for model, bic in tried.items()] if len(tried) > 1 else []
        trials = tuple(Trial(**{**trial, "status": Status(trial["status"])}) for trial in tried)
        return cls(Settings.from_dict(data["settings"]), data["model"], data["starts"], trials)

    @classmethod
    def make(cls, stack: MapStack, settings: Settings, extra: BRDF | None = None) -> Self:
        """Choose the model where it is not given, and find the starts, on texels from all over the map."""
        stack = stack.at(settings.time)
        rows = np.concatenate(list(sampled(stack).values()) or [np.empty((0, *stack.sizes), np.float32)])
        if not len(rows):
            raise DataError(f"none of the chunks tried of {stack.path} can be read", "Write the map again")
        rows = np.ascontiguousarray(rows[:, :, directions_used(stack, settings)])
        if settings.trends is None:
            # Each texel at one time, the times in turn.
            rows = rows[np.arange(len(rows)), np.arange(len(rows)) % rows.shape[1]]
        model, starts, tried = choose(stack, settings, rows)
        if extra is not None and settings.trends is None:
            starts = np.concatenate([starts, _vector(solver_of(stack, settings, model), extra)[None]])
        return cls(settings, model, np.asarray(starts, float).tolist(), tried)

    @cached_property
    def stack(self) -> MapStack:
        """The map that is fitted, at the time that is, in the plan's blocks."""
        stack = with_block(open_stack(self.settings.source), (self.settings.block[0], self.settings.block[1]))
        return stack.at(self.settings.time)

    @cached_property
    def solver(self) -> TexelSolver:
        """The solver of every block."""
        return solver_of(self.stack, self.fitting, self.model)

    @property
    def fitting(self) -> Settings:
        """The settings that the model has a use for."""
        return self.settings.for_model(self.model)

    @cached_property
    def used(self) -> NDArray[np.bool_]:
        """Directions (D,) that take part."""
        return directions_used(self.stack, self.settings)


def _only_bic(model: str, bic: float) -> dict[str, Any]:
    """A trial of which no more is known."""
    unknown = {"n_parameters": 0, "relative_rms": math.nan, "objective": math.nan, "n_samples": 0}
    return {"model": model, "bic": bic, "status": Status.CONVERGED, "chosen": bic == 0, **unknown}


def _vector(solver: TexelSolver, brdf: BRDF) -> NDArray[np.float64]:
    """The values of a BRDF as a parameter vector."""
    values = brdf.parameters
    vector = [
        np.broadcast_to(values[c.quantity], (solver.channels,))[c.channel or 0]
        if np.ndim(values[c.quantity])
        else values[c.quantity]
        for c in solver.columns
    ]
    return np.array(vector, float)
