"""Whether numbers come from a measurement, in one sentence for every page and file that shows them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

#: How the source of simulated data begins, in the files that `motes.ageing.rig` and `motes.maps.simulate_map` write.
SIMULATED = "simulated"


def is_simulated(source: str) -> bool:
    """Whether a file's statement of its source says that nothing was measured."""
    return source.strip().lower().startswith(SIMULATED)


def not_measured(about: Mapping[str, Any] | None) -> str:
    """The sentence that simulated data get wherever they, or what was fitted to them, are shown; empty for others.

    Parameters
    ----------
    about
        The provenance of a measurement, the entry ``data`` in a material's ``about``, or the attributes of a map.

    Examples
    --------
    >>> not_measured({"source": "simulated by Motes 0.1.0, noise 0.02, seed 1"})
    'The data are not measured: simulated by Motes 0.1.0, noise 0.02, seed 1.'
    >>> not_measured({"source": "CUReT"})
    ''
    """
    if not isinstance(about, Mapping):
        return ""
    source = str(about.get("source") or "")
    if not (about.get("simulated") or is_simulated(source)):
        return ""
    return f"The data are not measured: {source.strip().rstrip('.') or SIMULATED}."


def over_scale(about: Mapping[str, Any] | None) -> str:
    """What the values of a file were divided by, in words; empty where they are as they were.

    Parameters
    ----------
    about
        The provenance of a measurement; see `Measurement.rescaled`.

    Examples
    --------
    >>> over_scale({"scale": 3.0})
    'divided by 3'
    >>> over_scale({"scale": 2.996, "scale_stderr": 0.08})
    'divided by 2.996 ± 0.08, which was fitted'
    """
    scale, error = ((about or {}).get(name) for name in ("scale", "scale_stderr"))
    if not isinstance(scale, (int, float)):
        return ""
    fitted = f" ± {error:.2g}, which was fitted" if isinstance(error, (int, float)) else ""
    return f"divided by {scale:.4g}{fitted}"
