"""Why a fit stopped, and what the data say about a parameter: the words, once."""

from __future__ import annotations

from enum import StrEnum


class Status(StrEnum):
    """Why a fit stopped."""

    CONVERGED = "converged: no step makes the residuals smaller"
    SMALL_STEP = "converged: the parameters no longer move"
    IDLE = "converged: the residuals hardly shrink any more"
    PERFECT = "converged: the residuals are zero to rounding"
    NO_PROGRESS = "stopped: the damping grew without finding a better point"
    MAX_ITERATIONS = "stopped: the iterations ran out before it converged"

    @property
    def ok(self) -> bool:
        """True when it converged."""
        return self.value.startswith("converged")


class Verdict(StrEnum):
    """What the data say about a parameter."""

    IDENTIFIED = "identified"
    WEAK = "weakly identified: its error is large, or values far away fit as well"
    UNIDENTIFIABLE = "unidentifiable: the data do not determine it"
    AT_LOWER = "at its lower bound"
    AT_UPPER = "at its upper bound"
    FIXED = "fixed"
