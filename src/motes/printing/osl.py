"""OSL (Open Shading Language): how it writes a recorded model."""

from __future__ import annotations

from motes.printing.language import POWER_WITHOUT_BITS, Language

_WORDS = """closure color displacement emit illuminance illuminate light matrix normal output point private public shader string surface texture
transform uniform unlit varying vector volume and or not global I N P Ng Ci u v dPdu dPdv Ps time dtime dPdtime M_PI M_1_PI M_PI_2 abs acos area
asin atan atan2 backfacing bump calculatenormal ceil clamp cos cosh cross degrees deg2rad diffuse distance dot emission erf error exit exp
exp2 expm1 fabs floor fmod format hash hypot isfinite isinf isnan length linearstep log log10 log2 logb max microfacet min mix mod noise
normalize oren_nayar phong pow printf radians raytype reflect reflection refract round sign sin smoothstep sqrt step strlen tan trace trunc
ward"""

LANGUAGE = Language(
    title="Open Shading Language",
    number="float",
    color="color",
    direction="vector",
    truth="int",
    constant="float {name} = {value};",
    splat="color({0})",
    components=("{0}[0]", "{0}[1]", "{0}[2]"),
    power=POWER_WITHOUT_BITS,
    array_header="void {name}({arguments}, output float f[{count}])",
    reserved=frozenset(_WORDS.split()),
)
