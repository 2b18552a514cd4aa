"""Finds every attitude of a satellite with any tensor in a potential of degree 2 in n, r and t = n × r."""
from math import lcm

from sympy import Rational

from ...algebra.reals.exact import evaluate
from ...algebra.rotations.critical_rotations import critical_rotations
from ...algebra.rotations.quartic_forms import quartic
from ...algebra.solving.real_fields import FieldNumbers
from ...errors import ScopeError
from ...mechanics.scenes.system import System
from .amended_orbit import Exponents, amended_terms, energy
from .orbital_form import OrbitalForm

BITS, DIGITS = 128, 9                                  # of the order of the list
CURVES = ("the attitudes lie on curves, or it is not proved that they do not: a torque vanishes identically, "
          "as about the axis of a body of revolution; give an attitude, steady_motion(scene, n, r)")


def attitude_forms(scene: System) -> list[OrbitalForm]:
    """Return all equilibria of a satellite in orbit, those of least amended potential first.

    They are the critical points of V(n, r) = U − ½ ω0² n·In on the rotations; with the quaternion q of the
    attitude V (q·q)² is a quartic form. Derived in docs/explanation/derivations/satellite.md, section 10.

    Parameters
    ----------
    scene : System
        at given numbers

    Raises
    ------
    ScopeError
        the potential is of another degree, or its numbers are not rational; or the attitudes lie on curves
    """
    form = quartic(_whole(scene))
    if form is None:
        raise ScopeError("the potential is of degree above 2 in n, r and t = n × r, and all attitudes are "
                         "found up to degree 2: give an attitude, steady_motion(scene, n, r)")
    points = critical_rotations(form)
    if points is None:
        raise ScopeError(CURVES)
    heights = [float(energy(scene, point.balls(BITS), BITS).mid()) for point in points]
    size = max(map(abs, heights), default=1.0) or 1.0

    def order(n: int) -> tuple[float, ...]:
        *normal, r1, r2, r3 = (round(float(x.mid()), DIGITS) for x in points[n].balls(BITS))
        return round(heights[n] / size, DIGITS), -r3, -r2, -r1, *(-x for x in normal)

    return [_form(scene, points[n]) for n in sorted(range(len(points)), key=order)]


def _form(scene: System, point: FieldNumbers) -> OrbitalForm:
    return OrbitalForm(scene, point[:3], point[3:])


def _whole(scene: System) -> dict[Exponents, int]:
    """Return the terms of V over one of its coefficients as whole numbers."""
    terms = amended_terms(scene)
    unit = next(iter(terms.values()), Rational(1))
    ratios = {e: evaluate(c / unit, {}) for e, c in terms.items()}
    if not all(isinstance(x, Rational) for x in ratios.values()):
        raise ScopeError("the moments, l/omega0 and the torques over omega0² are not rational, and all "
                         "attitudes are found at rational ones: give them as decimals")
    bottom = lcm(*(x.q for x in ratios.values()))
    return {e: int(x * bottom) for e, x in ratios.items()}
