"""Finds every attitude of a satellite with any tensor in a potential of degree 2 in n, r and t = n × r."""
from collections.abc import Sequence
from math import lcm

from sympy import Add, Expr, Rational, S, expand

from ...algebra.reals.exact import evaluate
from ...algebra.rotations.critical_rotations import critical_rotations
from ...algebra.rotations.quartic_forms import QuarticForm, is_admitted, quartic
from ...algebra.rotations.symmetries import symmetries
from ...algebra.solving.real_fields import balls
from ...errors import ScopeError
from ...mechanics.families.circular_orbit import orbital_rate
from ...mechanics.scenes.system import System
from .amended_orbit import Exponents, amended_terms, energy
from .circles_of_attitudes import circles_of
from .orbital_form import OrbitalForm

BITS, DIGITS = 128, 9                                  # of the order of the list
NOT_RATIONAL = ("all attitudes are found if the moments are rational, and l/omega0 and the torques over "
                "omega0² are, or are sums of square roots of such numbers and π times these, and if no two "
                "attitudes meet: give the numbers as decimals")
NOT_QUADRATIC = ("the potential is of degree above 2 in n, r and t = n × r, and all attitudes are found up "
                 "to degree 2: give an attitude, steady_motion(scene, n, r)")
CURVES = ("the attitudes lie on curves, or it is not proved that they do not: they are where n × ∂V/∂n + "
          "r × ∂V/∂r = 0, V = U − ω0² n·In/2; give one, steady_motion(scene, n, r)")


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
    form = _form(scene)
    if form is None:
        raise ScopeError(NOT_QUADRATIC)
    if turnings := symmetries(form):
        if (circles := circles_of(scene, form, turnings)) is None:
            raise ScopeError(NOT_RATIONAL)
        return by_energy(scene, circles)
    if (points := critical_rotations(form)) is None:
        raise ScopeError(NOT_RATIONAL if form.parts else CURVES)
    return by_energy(scene, [OrbitalForm(scene, point[:3], point[3:]) for point in points])


def by_energy(scene: System, forms: Sequence[OrbitalForm]) -> list[OrbitalForm]:
    """Return attitudes in the order of their amended potential, the least first, then of r and n."""
    places = [[*balls(form.n, BITS), *balls(form.r, BITS)] for form in forms]
    heights = [float(energy(scene, place, BITS).mid()) for place in places]
    size = max(map(abs, heights), default=1.0) or 1.0

    def order(n: int) -> tuple[float, ...]:
        *normal, r1, r2, r3 = (round(float(x.mid()), DIGITS) for x in places[n])
        return round(heights[n] / size, DIGITS), -r3, -r2, -r1, *(-x for x in normal)

    return [forms[n] for n in sorted(range(len(forms)), key=order)]


def _form(scene: System) -> QuarticForm | None:
    """Return V N² over ω0² and times a whole number; None if its degree is above 2."""
    square = orbital_rate(scene) ** 2
    factors: list[Expr] = [S.One]
    several: list[dict[Exponents, Rational]] = [{}]
    for e, c in amended_terms(scene).items():
        for x in Add.make_args(expand(evaluate(c / square, {}))):
            place = next((n for n, f in enumerate(factors) if isinstance(x / f, Rational)), len(factors))
            if place == len(factors):
                factors.append(x)
                several.append({})
            several[place][e] = several[place].get(e, S.Zero) + x / factors[place]
    if not all(map(is_admitted, factors)):
        raise ScopeError(NOT_RATIONAL)
    bottom = lcm(*(x.q for terms in several for x in terms.values()))
    forms = [quartic({e: int(x * bottom) for e, x in terms.items()}) for terms in several]
    known = [form for form in forms if form is not None]
    return QuarticForm(known[0], [*zip(factors[1:], known[1:])]) if len(known) == len(forms) else None
