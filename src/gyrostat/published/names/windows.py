"""Derives what a formula may name about the normal form at an equilibrium."""
from collections.abc import Mapping
from typing import Any

from sympy import Expr, Symbol

from ...errors import PublishedError
from ...mechanics.equilibrium.equilibrium import Equilibrium
from ...stability.normal_forms.normal_form import NormalForm
from ...stability.report.analysis import analyze
from .kinematics import Later


def normal_form_names(eq: Equilibrium, at: Mapping[Symbol, Expr]) -> Mapping[str, Any]:
    """Return signed frequencies, coefficients of the actions, D4 and D6, at the numbers of `at`."""
    values = {s.name: value for s, value in at.items() if value.is_number}

    def form(degree: int = 4) -> NormalForm:
        if eq.system.potential is None or not eq.system.potential.given:
            raise PublishedError("a normal form needs derivatives of U up to its degree: give the scene a "
                                 "potential in k1, k2, k3 instead of an unspecified one")
        return analyze(eq).normal_form(values, degree)

    quartic = {f"birkhoff_{name}": Later(lambda n=n: form().coefficients[n][2])  # type: ignore[misc]
               for n, name in enumerate(("20", "11", "02"))}
    return {"frequency_1": Later(lambda: form().frequencies[0]),
            "frequency_2": Later(lambda: form().frequencies[1]),
            "D4": Later(lambda: form().twists[0]), "D6": Later(lambda: form(6).twists[1]), **quartic}
