"""Rounds the rotor of a satellite over ω0 to decimals, where no list is found with it as it is.

Wheels in rpm have π in their momentum, and ω0 of a height is a root, so that their ratio is transcendental.
"""
from dataclasses import replace

from sympy import Add, Rational

from ...algebra.reals.exact import evaluate
from ...mechanics.families.circular_orbit import NORMAL, orbital_rate
from ...mechanics.scenes.body import Gyrostat
from ...mechanics.scenes.coupled import CoupledPotential
from ...mechanics.scenes.kind import Kind
from ...mechanics.scenes.system import System, system_of
from ...notation import components

DIGITS = 12                                            # more than a data sheet has
NOTE = (f"the momentum of the wheels over omega0 is rounded to {DIGITS} digits here; the list is complete, "
        "and its verdicts are proved, for the rounded numbers")


def with_rounded_rotor(scene: System) -> System | None:
    """Return the scene of a satellite, in numbers, with l/ω0 in decimals; None if it is rational already."""
    if scene.kind is not Kind.ORBIT or not isinstance(scene.potential, CoupledPotential):
        return None
    rate, rotor = orbital_rate(scene), scene.body.gyrostatic_momentum
    ratios = [evaluate(x / rate, {}) for x in rotor]
    if all(isinstance(x, Rational) for x in ratios):
        return None
    rounded = [rate * Rational(str(x.evalf(DIGITS))) if x else x for x in ratios]
    # U has −ω0 n·l
    moved = rate * Add(*(n * (x - y) for n, x, y in zip(components(NORMAL), rotor, rounded)))
    field = replace(scene.potential, expression=(scene.potential.expression + moved).expand())
    return system_of(Gyrostat(scene.body.inertia, rounded), field)
