r"""Trends: parameters as functions of time.

=================== ============================================================================== =========================
``constant``        :math:`q = a`                                                                  does not change
``linear``          :math:`q = a + (b - a) u,\ u = (t - t_0)/(t_1 - t_0)`                          steady growth
``exponential``     :math:`q = b + (a - b) e^{-(t - t_0)/T}`                                       evaporation, relaxation
``logistic``        :math:`q = a + (b - a) / (1 + e^{-(t - m)/s})`                                 wet to dry, a front passing
``quadratic``       :math:`q = \sum_{k=0}^2 c_k B_k(u)`, Bernstein                                 smooth, no law known
``cubic``           the same with four control values                                              smooth, no law known
``monotone_spline`` :math:`q = a + (b - a) \sum_k s_k I_k(u)`, I-splines                           one-way, no law known
``tabulated``       piecewise linear through measured points                                       measured, not fitted
=================== ============================================================================== =========================

All but time constants are *values of the parameter* (at the start, at the end, control values), so the bounds of the parameter are the bounds of the
trend, and inside the observed interval a trend never leaves them.  Time is in hours.
"""

from motes.trends.kinds import KINDS, Coefficient, Floats, Kind, evaluate
from motes.trends.tabulated import AnyTrend, Tabulated, trend_from_dict
from motes.trends.trend import Trend, flat, flat_jacobian

__all__ = [
    "KINDS",
    "AnyTrend",
    "Coefficient",
    "Floats",
    "Kind",
    "Tabulated",
    "Trend",
    "evaluate",
    "flat",
    "flat_jacobian",
    "trend_from_dict",
]
