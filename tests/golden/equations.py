"""The functions of `motes.equations` with the columns they are given and the column they must give back."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from golden import Rows
from motes import equations


class Equation(NamedTuple):
    """A function, its arguments by column, the column of its value (None where the table has none), and whether it wants a namespace."""

    function: Callable[..., Any]
    arguments: tuple[str, ...]
    column: str | None
    over: bool = True

    def evaluate(self, xp: Any, rows: Rows, convert: Callable[[Any], Any] = lambda x: x) -> Any:
        """The value over the namespace `xp`, of columns that `convert` turns into its arrays."""
        namespace = (xp,) if self.over else ()  # plain arithmetic needs none
        return self.function(*namespace, *(convert(rows[name]) for name in self.arguments))


EQUATIONS = {
    equation.function.__name__: equation
    for equation in (
        Equation(
            equations.rho_d1,
            ("C1", "C2", "C3", "cos_dphi", "one_less_abs_cos_dphi", "tan_beta", "tan_half", "K_d"),
            "rho_d1",
        ),
        Equation(equations.alpha, ("theta_r", "theta_i"), "alpha"),
        Equation(equations.beta, ("theta_r", "theta_i"), "beta"),
        Equation(equations.C1, ("sigma_d",), "C1"),
        Equation(equations.C2, ("sin_alpha", "sin_alpha_less_cube", "cos_dphi", "sigma_d"), "C2"),
        Equation(equations.C3, ("alpha", "beta", "sigma_d"), "C3"),
        Equation(equations.rho_d2, ("beta", "cos_dphi", "sigma_d", "K_d"), "rho_d2"),
        Equation(equations.rho_d, ("rho_d1", "rho_d2"), "rho_d"),
        Equation(equations.rho_s, ("D", "G", "F", "cos_theta_i", "cos_theta_r"), "rho_s"),
        Equation(equations.D, ("theta_h", "sigma_s"), "D"),
        # wi . wh and wo . wh are both cos(theta_d).
        Equation(equations.G, ("cos_theta_i", "cos_theta_r", "cos_theta_h", "cos_theta_d", "cos_theta_d"), "G"),
        Equation(equations.rho_dust, ("Phi", "cos_theta_i", "cos_theta_r", "w"), "rho_dust"),
        Equation(equations.Phi, ("sin2_half_gamma", "cos2_half_gamma", "g"), "Phi"),
        # What the appendices leave to their readers; test_equations.py says what these must be.
        Equation(equations.fresnel_dielectric, ("cos_theta_d", "n"), None),
        Equation(equations.fresnel_conductor, ("cos_theta_d", "n", "sigma_s"), None),
        Equation(equations.fresnel_normal, ("cos_theta_d", "sigma_s"), None, over=False),
        Equation(equations.fresnel_schlick, ("cos_theta_d", "w"), None),
        Equation(equations.dust_brdf, ("Phi", "cos_theta_i", "cos_theta_r", "w"), None),
        Equation(equations.slant_depth, ("cos_theta_i", "cos_theta_r", "sigma_s"), None),
        Equation(equations.dust_layer, ("rho_d", "rho_dust", "sigma_s"), None),
        Equation(equations.facet_area, ("sigma_s",), None),
    )
}
