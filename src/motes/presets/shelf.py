"""The presets: materials under a name, each with the word of where its numbers come from.

>>> PRESETS["grey_card"].material().brdf.parameters["K_d"]
0.18

A preset is a beginning, not a measurement of anybody's surface.  What nobody measured is called chosen.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import final

from motes.ageing.phenomena import PHENOMENA
from motes.ageing.plaster import drying_plaster, trends
from motes.channels import RGB, default_names
from motes.material import Material
from motes.models import parse

CHOSEN = "chosen, not measured"
#: Hours that the plaster is followed.
PLASTER_HOURS = 6.0
_HOFFMAN = (
    "f0 as it is commonly quoted after Hoffman, Background: Physics and Math of Shading, SIGGRAPH course 2013, linear RGB, not checked "
    "against measurements; the roughness is chosen"
)


@final
@dataclass(frozen=True)
class Preset:
    """A material under a name.

    Parameters
    ----------
    name, words
        As at the command line, and as in a list.
    source
        Where its numbers come from.
    make
        The material without these.
    """

    name: str
    words: str
    source: str
    make: Callable[[], Material]

    def material(self) -> Material:
        """The material, which says what preset it is and where its numbers come from."""
        made = self.make()
        return replace(made, name=self.words, about={**made.about, "preset": self.name, "source": self.source})


def _text(name: str, words: str, source: str, text: str) -> Preset:
    def make() -> Material:
        brdf = parse(text).model
        return Material(brdf, channels=default_names(brdf.channels or 1))

    return Preset(name, words, source, make)


def _metal(name: str, words: str, f0: tuple[float, float, float]) -> Preset:
    return _text(name, words, _HOFFMAN, f"ggx(K_s=1.0, alpha=0.2, fresnel=schlick(f0={f0}))")


def _base(name: str, phenomenon: str, source: str) -> Preset:
    """The surface that a phenomenon happens to where none is given."""
    base = PHENOMENA[phenomenon].base
    return Preset(name, base.name, f"the surface of motes age {phenomenon}: {source}", lambda: base)


def _plaster() -> Material:
    changing = {name: trend for name, trend in trends(PLASTER_HOURS).items() if trend.kind != "constant"}
    return Material(drying_plaster(0.0, "multiple"), channels=RGB, trends=changing)


_ALL = (
    _text("white", "white tile", "nominal reflectance of sintered PTFE standards, 99 %", "lambert(K_d=0.99)"),
    _text("grey_card", "grey card", "nominal reflectance of photographers' grey cards, 18 %", "lambert(K_d=0.18)"),
    Preset(
        "plaster",
        "drying plaster",
        f"the surface of motes simulate, which gathers dust, 0 to {PLASTER_HOURS:g} h: {CHOSEN}",
        _plaster,
    ),
    _base("red_paint", "drying_paint", CHOSEN),
    _base("clay", "drying_surface", CHOSEN),
    _base("varnish", "dust", CHOSEN),
    _base("cast_iron", "rusting", "means over the measured STAF maps of rusting cast iron (tvBTF45; Gu et al. 2006)"),
    _metal("gold", "gold", (1.0, 0.71, 0.29)),
    _metal("silver", "silver", (0.95, 0.93, 0.88)),
    _metal("copper", "copper", (0.95, 0.64, 0.54)),
    _metal("aluminium", "aluminium", (0.91, 0.92, 0.92)),
)

#: By name.
PRESETS: dict[str, Preset] = {preset.name: preset for preset in _ALL}
