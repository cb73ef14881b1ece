"""Phenomena: what drying, dust and rust do to the parameters of a surface.

A phenomenon names the parameters that move, says how and why, and turns any material into one that follows time::

    dusty = PHENOMENA["dust"](material, hours=(0, 240), tau_end=0.8)

Which parameters move, and along what kind of curve, is what "Time-Varying BRDFs" (TVCG 2007) found in its measurements of drying paint, of drying
surfaces such as wet plaster or wood, and of dust.  The *numbers* of the defaults are chosen, within what is physically plausible, and can all be replaced;
those of rusting are measured.  To carry a fitted course over to another material see `motes.ageing.transfer`.
"""

from __future__ import annotations

from motes.ageing.corrosion import RUSTING
from motes.ageing.drying import DRYING_PAINT, DRYING_SURFACE
from motes.ageing.phenomenon import Phenomenon
from motes.ageing.settling import DUST
from motes.errors import ParameterError

PHENOMENA: dict[str, Phenomenon] = {p.name: p for p in (DRYING_PAINT, DRYING_SURFACE, DUST, RUSTING)}


def phenomenon(name: str | Phenomenon) -> Phenomenon:
    """The phenomenon of a name; raises `ParameterError` with the names there are."""
    if isinstance(name, Phenomenon):
        return name
    if name not in PHENOMENA:
        raise ParameterError(f"{str(name)[:80]!r} is not a phenomenon", f"Choose one of {', '.join(PHENOMENA)}")
    return PHENOMENA[name]
