"""exp, expm1, log, log1p, asin, sin and cos as straight-line polynomials that LLVM vectorises; it calls libm, one number at a time, for the usual ones.

The coefficients are minimax, printed by ``tools/minimax.py``.  Errors over the whole domain, measured against wider arithmetic by
``tests/test_printing_elementary.py``, in units of the last place of the result:

=========  =======  ====================================================================================
function   at most  edges
=========  =======  ====================================================================================
exp        1.5      below 2^-125.5 (float64: 2^-1021.5) flushed to 0; overflows to inf where it should
expm1      2.5      -1 at the far left; the sign of zero is not kept
log        1.5      -inf at 0, NaN below; inf stays; of normal numbers only
log1p      1.5      -inf at -1, NaN below; inf stays
asin_near  1        on [-0.7072, 0.7072] only
asin       3        NaN outside [-1, 1]
sin, cos   1.5      on [-6.3, 6.3], a turn either way, only
=========  =======  ====================================================================================

NaN in, NaN out.  exp and expm1 share their reduction x = k ln(2) + r and polynomial, so a compiler does it once when it meets both:
with s = 2^(k-1) and p = exp(r) - 1, exp(x) = 2 (s p + s) and expm1(x) = 2 (s p + (s - 1/2)).  log1p splits 1 + x = 2^k m and takes the
polynomial of Sun's fdlibm (Ng, 1993) of m - 1, with what rounding lost of 1 + x put back; log does without the latter.  sin and cos share
their reduction x = k pi/2 + r.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass


@dataclass(frozen=True)
class Precision:
    """The numbers that differ between float32 and float64.

    Attributes
    ----------
    name
        Of the NumPy type.
    shift
        1.5 * 2^(bits of the fraction): adding it rounds to an integer, which then sits in the low bits.
    fraction, bias
        Bits of the fraction, and what to add to an exponent.
    lowest, highest
        exp(x) is 0 and infinite there.
    ln2
        ln(2) as two numbers, the first with enough trailing zeros that k times it is exact.
    one, half_root
        The bits of 1 and of sqrt(1/2), where the fraction that log1p takes begins.
    half_pi
        pi/2 as a sum of numbers, k times each of which but the last is exact for the k that there are.
    exp, exp2, asin, sin, cos, log
        Coefficients, lowest first; exp2 is that of programs of vectors alone; of log, of (log(1 + f) - f + f^2/2) by powers of (f/(2 + f))^2, from fdlibm.
    """

    name: str
    shift: float
    fraction: int
    bias: int
    lowest: float
    highest: float
    ln2: tuple[float, float]
    one: int
    half_root: int
    half_pi: tuple[float, ...]
    exp: tuple[float, ...]
    exp2: tuple[float, ...]
    asin: tuple[float, ...]
    sin: tuple[float, ...]
    cos: tuple[float, ...]
    log: tuple[float, ...]


FLOAT32 = Precision(
    name="float32",
    shift=12582912.0,
    fraction=23,
    bias=127,
    lowest=-87.5,
    highest=89.0,
    ln2=(0.69311523, 3.1946183e-05),
    one=0x3F800000,
    half_root=0x3F3504F3,
    half_pi=(1.5703125, 0.0004837513, 7.543713e-08, 6.0771006e-11),
    exp=(0.49999997, 0.16666543, 0.0416672, 0.008366514, 0.0013882522),
    exp2=(0.6931471, 0.24022351, 0.055505004, 0.009666245, 0.0013333539),
    asin=(0.16666906, 0.07488484, 0.046502333, 0.016388448, 0.07697573, -0.09262575, 0.11132111),
    sin=(-0.16666655, 0.00833216, -0.00019515282),
    cos=(0.041666646, -0.0013887316, 2.4433157e-05),
    log=(0.66666662693, 0.40000972152, 0.28498786688, 0.24279078841),
)
FLOAT64 = Precision(
    name="float64",
    shift=6755399441055744.0,
    fraction=52,
    bias=1023,
    lowest=-708.5,
    highest=710.0,
    ln2=(0.6931471803691238, 1.9082149292705877e-10),
    one=0x3FF0000000000000,
    half_root=0x3FE6A09E667F3BCD,
    half_pi=(1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21),
    exp=(
        0.5000000000000006,
        0.16666666666666588,
        0.041666666666576826,
        0.008333333333389509,
        0.0013888888931539432,
        0.00019841269719078869,
        2.4801505306416086e-05,
        2.7557407508317533e-06,
        2.7626024212806105e-07,
        2.5053774381819548e-08,
    ),
    exp2=(
        0.6931471805599453,
        0.24022650695910097,
        0.055504108664821236,
        0.009618129107607065,
        0.0013333558146531644,
        0.00015403530441481252,
        1.525273370119972e-05,
        1.32154427238934e-06,
        1.0178121306377697e-07,
        7.072561766172521e-09,
        4.4455360304847937e-10,
    ),
    asin=(
        0.1666666666666523,
        0.07500000000408744,
        0.04464285673369727,
        0.0303819653020441,
        0.022371521614163302,
        0.01736557005447978,
        0.013785740586215532,
        0.013363455201920007,
        -0.0038303994904661885,
        0.08524625846578622,
        -0.32300918605382234,
        1.087176118875537,
        -2.6698925796142263,
        4.941615831474354,
        -6.588154615125704,
        6.049000744889667,
        -3.4220721871174367,
        0.9215118736481213,
    ),
    sin=(
        -0.1666666666666663,
        0.008333333333322118,
        -0.00019841269829589536,
        2.7557313621384062e-06,
        -2.50507477625281e-08,
        1.589623013620773e-10,
    ),
    cos=(
        0.041666666666666595,
        -0.0013888888888873056,
        2.48015872888517e-05,
        -2.755731417929531e-07,
        2.0875700841799417e-09,
        -1.1358536512948367e-11,
    ),
    log=(
        6.666666666666735130e-01,
        3.999999999940941908e-01,
        2.857142874366239149e-01,
        2.222219843214978396e-01,
        1.818357216161805012e-01,
        1.531383769920937332e-01,
        1.479819860511658591e-01,
    ),
)
PRECISIONS = {"float32": FLOAT32, "float64": FLOAT64}

_TEMPLATE = '''
@inline
def exp_parts(x):
    """2^(k-1) and exp(r) - 1, where x = k ln(2) + r."""
    x = select(x < F({lowest!r}), F({lowest!r}), x)
    x = select(x > F({highest!r}), F({highest!r}), x)
    shifted = x * F(1.4426950408889634) + F({shift!r})
    k = shifted - F({shift!r})
    r = (x - k * F({ln2[0]!r})) - k * F({ln2[1]!r})
    s = float_of(I((bits_of(shifted) + I({exponent})) << I({fraction})))
    p = {exp}
    return s, p * (r * r) + r


@inline
def exp(x):
    s, p = exp_parts(x)
    return F(2.0) * (s * p + s)


@inline
def expm1(x):
    s, p = exp_parts(x)
    return F(2.0) * (s * p + (s - F(0.5)))


@inline
def log1p(x):
    u = F(1.0) + x
    shifted = I(bits_of(u) + I({above}))
    exponent = I(I(shifted >> I({fraction})) - I({bias}))
    m = float_of(I(I(shifted & I({mask})) + I({half_root})))
    k = F(exponent)
    near = exponent == I(0)
    lost = select(x > F(1.0), F(1.0) - (u - x), x - (u - F(1.0)))
    c = select(near, F(0.0), lost / u)
    f = select(near, x, m - F(1.0))
    s = f / (F(2.0) + f)
    z = s * s
    half = F(0.5) * (f * f)
    tail = s * (half + z * {log}) + c + k * F({ln2[1]!r})
    y = k * F({ln2[0]!r}) + (f - (half - tail))
    y = select(u > F(0.0), y, select(u == F(0.0), F(-inf), F(nan)))
    return select(x == F(inf), x, y)


@inline
def log(x):
    shifted = I(bits_of(x) + I({above}))
    exponent = I(I(shifted >> I({fraction})) - I({bias}))
    f = float_of(I(I(shifted & I({mask})) + I({half_root}))) - F(1.0)
    k = F(exponent)
    s = f / (F(2.0) + f)
    z = s * s
    half = F(0.5) * (f * f)
    tail = s * (half + z * {log}) + k * F({ln2[1]!r})
    y = k * F({ln2[0]!r}) + (f - (half - tail))
    y = select(x > F(0.0), y, select(x == F(0.0), F(-inf), F(nan)))
    return select(x == F(inf), x, y)


@inline
def turned(x, quarters):
    """The sine of x plus some right angles."""
    shifted = x * F(0.6366197723675814) + F({shift!r})
    k = shifted - F({shift!r})
    r = {rest}
    z = r * r
    sine = r + r * (z * {sin})
    half = F(0.5) * z
    most = F(1.0) - half
    cosine = most + (((F(1.0) - most) - half) + z * z * {cos})
    quadrant = I(bits_of(shifted) + I(quarters))
    y = select(I(quadrant & I(1)) != I(0), cosine, sine)
    return select(I(quadrant & I(2)) != I(0), -y, y)


@inline
def sin(x):
    return turned(x, 0)


@inline
def cos(x):
    return turned(x, 1)


@inline
def asin_near(x):
    """On [-0.7072, 0.7072]."""
    z = x * x
    p = {asin}
    return p * (z * x) + x


@inline
def asin(x):
    """By asin(x) = pi/2 - asin(sqrt(1 - x^2)) where x > sin(pi/4)."""
    a = select(x < F(0.0), -x, x)
    far = a > F(0.70715)
    y = asin_near(select(far, sqrt((F(1.0) - a) * (F(1.0) + a)), a))
    y = select(far, F(1.5707963267948966) - y, y)
    return select(x < F(0.0), -y, y)
'''


def horner(coefficients: tuple[float, ...], x: str) -> str:
    """A polynomial, nested."""
    text = f"F({coefficients[-1]!r})"
    for c in coefficients[-2::-1]:
        text = f"({text} * {x} + F({c!r}))"
    return text


def source(precision: Precision) -> str:
    """Source of the functions for `motes.kernels.lowering`; it needs the names F and I (kinds of numbers)."""
    return _TEMPLATE.format(
        lowest=precision.lowest,
        highest=precision.highest,
        shift=precision.shift,
        ln2=precision.ln2,
        rest=functools.reduce(lambda text, part: f"({text} - k * F({part!r}))", precision.half_pi, "x"),
        sin=horner(precision.sin, "z"),
        cos=horner(precision.cos, "z"),
        exponent=precision.bias - 1,
        fraction=precision.fraction,
        exp=horner(precision.exp, "r"),
        asin=horner(precision.asin, "z"),
        above=precision.one - precision.half_root,
        bias=precision.bias,
        mask=(1 << precision.fraction) - 1,
        half_root=precision.half_root,
        log=horner(precision.log, "z"),
    )
