"""Reports on a pole in a field, and their verdicts by name."""
from sympy import Rational

import gyrostat as gs

k3, omega, l = gs.symbol("k3"), gs.symbol("omega"), gs.symbol("l")
I1, I3 = gs.symbol("I1"), gs.symbol("I3")
HALF = Rational(1, 2)


def name(report, values):
    """The verdict, by its name."""
    return report.verdict(values).verdict.name


def pole(potential, s=1, body=None):
    """The report on E1 or E2 in a potential."""
    scene = gs.assemble(body or gs.symmetric_gyrostat(), gs.axial_potential(potential))
    return gs.analyze((gs.upright if s == 1 else gs.hanging)(scene))
