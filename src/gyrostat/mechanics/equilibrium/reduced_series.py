"""Expands g(k3) in the motion of k3, I1² k̇3² = g, in powers of the deviation from an equilibrium."""
from sympy import Add, Expr, Integer, Rational, S, Symbol, factorial

from ...algebra.rings.polynomials import Ring, by_degree
from ...arguments import checked
from ...errors import ScopeError, brief
from ...notation import jet_name, symbol
from .equilibrium import Equilibrium
from .reduction import ENERGY, K3, P, V, reduce

MOST_TERMS = 100
DEVIATION = Symbol("deviation")                        # a symbol that is none of a user's, which are real


@checked
def expansion(eq: Equilibrium, order: int) -> list[Expr]:
    """Return the coefficients of x⁰ … x^order in g on the levels of an equilibrium.

    At a pole k3 = ±(1 − x), else k3 grows by x. U is expanded in its derivatives dU, d2U, … at the
    equilibrium, and a relation on them is inserted. The first two coefficients vanish.

    Parameters
    ----------
    eq : Equilibrium
        of a body of revolution in U(k3)
    order : int

    Returns
    -------
    list of Expr
        order + 1 of them

    Raises
    ------
    ScopeError
        the body is not of revolution, U is not U(k3), or the powers are fractions

    Examples
    --------
    >>> import gyrostat as gs
    >>> top = gs.assemble(gs.symmetric_gyrostat(), gs.axial_potential())
    >>> gs.mechanics.expansion(gs.upright(top), 3)[2:]
    [4*I1*dU - l**2 - 2*l*pi3_0 - pi3_0**2, -2*I1*d2U - 2*I1*dU]
    """
    if eq.near_pole is not None and not eq.near_pole.smooth:
        raise ScopeError(f"{eq.label} has U in fractional powers of x there, and so has g: Report.boundary "
                         "has their coefficients")
    found = powers_of_distance(eq, order)
    return [found[Integer(n)] for n in range(order + 1)]


def inward(eq: Equilibrium) -> Expr:
    """Return the change of k3 with x, which at a pole leads away from it."""
    return -eq.at if eq.at**2 == 1 else S.One


def field_coefficient(eq: Equilibrium, n: int) -> Expr:
    """Return the coefficient of xⁿ in U − U(k3), n > 0.

    At a pole where U has roots, it is the coefficient of x^(n/q), where q is the order of the series.
    """
    if eq.near_pole is not None:
        return eq.near_pole.coefficient(n)
    return symbol(jet_name(n)) * inward(eq) ** n / factorial(n)


def powers_of_distance(eq: Equilibrium, order: int) -> dict[Rational, Expr]:
    """Return the coefficients of the powers of x up to an order in g on the levels of an equilibrium.

    At a pole where U(k3) has roots the powers are fractions (near_pole), and U is its series; else they are
    whole, and U is expanded in its derivatives dU, d2U, ….
    """
    if not 0 <= order <= MOST_TERMS:
        raise ScopeError(f"order = {brief(order)} is out of range: give a number from 0 to {MOST_TERMS}")
    motion, scene, near = reduce(eq.system), eq.system, eq.near_pole
    pi3, root = scene.space.coordinates[2], 1 if near is None else near.order
    field = Add(*(field_coefficient(eq, n) * DEVIATION**n for n in range(1, order * root + 1)))
    levels = {V: scene.space.casimirs[0], P: pi3 + scene.body.gyrostatic_momentum[2],
              ENERGY: scene.body.kinetic_energy(scene.space.coordinates[:3])}
    levels = {level: value.xreplace(dict(zip(scene.space.coordinates, eq.point)))
              for level, value in levels.items()}
    g = motion.square(field).xreplace({K3: K3 + inward(eq) * DEVIATION**root}).xreplace(levels | {K3: eq.at})
    for name, value in eq.relations:
        if name == symbol("dU"):
            g = g.xreplace({name: value})
    ring = Ring([g, DEVIATION])
    top, bottom = ring.fraction(g)
    place = ring.generators.index(DEVIATION)
    parts = by_degree(ring.reduce(top), place, max(top.degrees()[place], order * root))
    return {Rational(n, root): ring.quotient(part, bottom) for n, part in enumerate(parts[:order * root + 1])}
