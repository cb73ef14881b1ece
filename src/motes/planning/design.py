"""`Design`: the directions to measure, in their order, with what they will reveal; saved as a table for the lab book, JSON and a picture."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from motes import directions
from motes.files import write_csv, write_json, write_text
from motes.fitting.formatting import finite
from motes.planning.expectations import Expectation
from motes.planning.information import Noise
from motes.planning.seen_from_above import drawn

Floats = NDArray[np.float64]
#: What a shot is for.
FIND, CHECK = "find", "check"


@final
@dataclass(frozen=True, eq=False)
class Design:
    """A plan of measurement: what `motes.plan` returns.

    Attributes
    ----------
    model, goal, rig, prior
        What it was planned for, in words.
    wi, wo
        The directions (K, 3), in the order to measure them.
    shot
        The number (K,) of the shot that records each, counted from 0 in this order; several directions where detectors record together.
    purpose
        For each direction ``"find"`` (the parameters) or ``"check"`` (whether the model holds).
    exposure
        Relative exposure (K,) of each, with mean 1 over shots.
    even_wi, even_wo
        The even choice of as many shots, that it is compared with.
    expected
        What it will reveal of each parameter.
    to_even, to_all
        How many times as large its errors are as those of the even choice, and of all shots: geometric mean over parameters, median over
        materials.
    travel, even_travel
        Through the shots in order, and through the even choice in its own: seconds where the costs of the instrument are known, else degrees.
    seconds
        In all, travel and readings; NaN where the costs are not known.
    offered
        How many shots there were to choose from.
    findings
        What stays unseen, and what else is to be known, in sentences.
    took
        Seconds that planning took.
    """

    model: str
    goal: str
    rig: str
    prior: str
    noise: Noise
    wi: Floats
    wo: Floats
    shot: NDArray[np.intp]
    purpose: tuple[str, ...]
    exposure: Floats
    even_wi: Floats
    even_wo: Floats
    expected: tuple[Expectation, ...]
    to_even: float
    to_all: float
    travel: float
    even_travel: float
    seconds: float
    offered: int
    materials: int
    measured: int
    findings: tuple[str, ...]
    took: float

    @property
    def shots(self) -> int:
        """How many shots there are to measure."""
        return int(self.shot.max()) + 1

    def records(self) -> list[dict[str, Any]]:
        """A row for each direction, angles in degrees."""
        angles = np.degrees([directions.theta(self.wi), directions.phi(self.wi), directions.theta(self.wo), directions.phi(self.wo)])  # fmt: skip
        # -180 and 180 degrees are one, and 0 has no sign.
        angles = np.round(angles, 4) + 0.0
        angles[angles == -180.0] = 180.0
        return [
            {
                "shot": int(self.shot[k]) + 1,
                "theta_i_deg": float(angles[0, k]),
                "phi_i_deg": float(angles[1, k]),
                "theta_r_deg": float(angles[2, k]),
                "phi_r_deg": float(angles[3, k]),
                "exposure": round(float(self.exposure[k]), 3),
                "purpose": self.purpose[k],
            }
            for k in range(len(self.wi))
        ]

    def to_dict(self) -> dict[str, Any]:
        """All of it as plain JSON values."""
        made: dict[str, Any] = {
            "format": "motes plan",
            "version": 1,
            "model": self.model,
            "goal": self.goal,
            "rig": self.rig,
            "prior": self.prior,
            "noise": {"relative": self.noise.relative, "floor": self.noise.floor},
            "offered": self.offered,
            "measured": self.measured,
            "shots": self.shots,
            "directions": self.records(),
            "expected": [
                {
                    "parameter": one.name,
                    "unit": one.unit,
                    "stderr": one.stderr,
                    "to_even": one.to_even,
                    "to_all": one.to_all,
                    "verdicts": {str(verdict): count for verdict, count in one.verdicts.items()},
                }
                for one in self.expected
            ],
            "errors_to_even": self.to_even,
            "errors_to_all": self.to_all,
            "travel": self.travel,
            "even_travel": self.even_travel,
            "seconds": self.seconds,
            "findings": list(self.findings),
            "planning_seconds": self.took,
        }
        plain: dict[str, Any] = finite(made)
        return plain

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write `to_dict` as a JSON file; returns its path."""
        return write_json(path, self.to_dict())

    def table(self, path: str | os.PathLike[str]) -> Path:
        """Write the table for the lab book as CSV, and return its path; with readings in its column ``brdf`` `motes.read` reads it."""
        head = ["no", "theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "brdf", "remarks"]
        rows = [
            [k + 1, *(row[name] for name in head[1:5]), "", f"shot {row['shot']}: {row['purpose']}, exposure {row['exposure']:.2g}"]
            for k, row in enumerate(self.records())
        ]  # fmt: skip
        return write_csv(path, [head, *rows])

    def picture(self, path: str | os.PathLike[str]) -> Path:
        """Write a picture of the hemisphere as SVG: where lamp and detector stand, planned and even; returns its path."""
        picture = drawn(
            (self.wi, self.wo),
            (self.even_wi, self.even_wo),
            np.array([purpose == CHECK for purpose in self.purpose]),
            self.shot,
        )
        return write_text(path, picture)

    def summary(self) -> list[tuple[str, str]]:
        """Facts for people: a label and a text each."""
        unit = "s" if math.isfinite(self.seconds) else "degrees"
        checks = sum(purpose == CHECK for purpose in self.purpose)
        facts = [
            ("plan", f"{self.shots} of {self.offered} shots of {self.rig}: {len(self.wi)} directions, {checks} of them to check the model"),
            ("for", f"{self.model}, {self.goal}; {self.prior}; noise {100 * self.noise.relative:.3g} %"),
        ]  # fmt: skip
        if self.measured:
            facts.append(("beside", f"{self.measured} directions that are measured"))
        if math.isfinite(self.to_even) and math.isfinite(self.to_all):
            facts.append(("errors", f"{self.to_even:.2g} times those of an even choice of as many, {self.to_all:.2g} times those of all"))  # fmt: skip
        seconds = f"; {self.seconds:.0f} s with the readings" if math.isfinite(self.seconds) else ""
        facts.append(("travel", f"{self.travel:.0f} {unit}, of the even choice {self.even_travel:.0f} {unit}{seconds}"))
        return facts

    def expected_rows(self) -> list[tuple[str, ...]]:
        """A row of texts for each parameter: its name, its error, that over the errors of the even choice and of all, its verdict."""
        return [
            (
                one.name,
                f"{one.stderr:.2g} {one.unit}".rstrip() if math.isfinite(one.stderr) else "none",
                _share(one.to_even),
                _share(one.to_all),
                str(one.verdict).partition(":")[0]
                + (f" ({one.verdicts[one.verdict]} of {self.materials})" if len(one.verdicts) > 1 else ""),
            )
            for one in self.expected
        ]


def _share(share: float) -> str:
    """A ratio of errors for people; nothing where neither has one."""
    return f"{share:.2g}" if math.isfinite(share) else "larger" if share > 0 else ""
