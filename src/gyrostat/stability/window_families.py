"""What decides where gyroscopic forces hold a maximum, along a family: D4 as a rational function."""
from collections.abc import Mapping
from dataclasses import dataclass
from math import prod

from flint import fmpq_mpoly
from sympy import Expr, Mul, Pow, S, Symbol

from ..algebra.exact import evaluate
from ..algebra.margins import Signs
from ..algebra.polynomials import Ring, cancel, lcm
from ..algebra.rational_functions import RationalFunction
from ..errors import ScopeError
from ..mechanics.equilibria import Equilibrium
from ..notation import Stored
from ..shown import Shown
from .averages import Averages, averages
from .local_motion import LocalMotion, motion_along
from .values import refuse_any_direction
from .windows import resonance_margin

DEGREE, MOST = 4, 3                                        # of U; names where h3 is not 0


@dataclass(frozen=True, repr=False)
class Window(Shown, Stored):
    """Arnold's condition where p, q and p² − 4q are positive and the second variation is not definite.

    Stable where no resonance holds and D4 is not 0; of the other points a verdict decides each.

    Parameters
    ----------
    p, q : Expr
        of λ⁴ + p λ² + q [1/T², 1/T⁴]
    resonances : tuple of (int, int, Expr)
        m, n and a polynomial that is 0 where the frequencies are as m to n
    D4 : Expr
        factored
    margin : Expr
        the primitive integer polynomial that has the sign of D4 in the window
    zeros : tuple of Expr
        factors of D4 that do not change its sign, and where it is 0
    at : Expr
        the k3 at which derivatives of U are taken

    Examples
    --------
    >>> import gyrostat as gs
    >>> scene = gs.assemble(gs.Gyrostat((5, 4, 3), (0, 0, 0)), gs.general_potential(lambda k1, k2, k3: k3))
    >>> found = gs.analyze(gs.upright(scene)).window()
    >>> found.q
    (pi3_0**2 + 9)*(2*pi3_0**2 + 9)/1620
    >>> found.resonances[0], found.margin
    ((1, 2, 26*pi3_0**4 - 771*pi3_0**2 - 396), 1)
    """

    p: Expr
    q: Expr
    resonances: tuple[tuple[int, int, Expr], ...]
    D4: Expr
    margin: Expr
    zeros: tuple[Expr, ...]
    at: Expr


def window_of(eq: Equilibrium, numbers: Mapping[Symbol, Expr]) -> Window:
    """As Report.window."""
    potential = eq.system.potential
    if potential is None:
        raise ScopeError(f"{eq.label} is of a free body, which has one degree of freedom: its verdict needs "
                         "no D4")
    refuse_any_direction(eq)
    motion = motion_along(eq, numbers, DEGREE)
    if not potential.given and any(x.free_symbols for x in motion.k):
        raise ScopeError(f"{eq.label}: U is unspecified, and k is not a point: give U for D4")
    domain = [evaluate(e, numbers) for e in eq.existence()]
    ring = Ring([*motion.entries, motion.potential, *domain])
    if not all(isinstance(g, Symbol) for g in ring.generators):
        raise ScopeError(f"{eq.label}: D4 is a rational function where numbers are rational and U and the "
                         "point are fractions of polynomials; give other numbers, or all for a verdict")
    found, scale = _scaled(eq, motion, ring)
    p, q, discriminant = found.p, found.q, found.p**2 - 4 * found.q
    for value, what in ((q, "q"), (discriminant, "p² − 4q"), (found.bottom, "4p² − 25q")):
        if not value:
            raise ScopeError(f"{eq.label}: {what} of λ⁴ + p λ² + q is 0 whatever the names are, and there is "
                             "no D4")
    # of degree 1 in the energy at given actions, which are frequencies
    top, bottom = cancel(found.top, found.bottom * scale**3)
    signs = Signs(ring, [*domain, *map(ring.expression, (p, q, discriminant))])
    margin, even = signs.split(top, bottom)
    resonances = []
    for m, n in ((1, 2), (1, 3)):
        odd, squares = signs.split(resonance_margin(p, q, m, n), ring.one)
        resonances.append((m, n, ring.expression(prod(squares, start=odd))))
    return Window(_factored(ring, *cancel(p, scale**2)), _factored(ring, *cancel(q, scale**4)),
                  tuple(resonances), _factored(ring, top, bottom), ring.expression(margin),
                  tuple(map(ring.expression, even)), eq.at)


def _scaled(eq: Equilibrium, motion: LocalMotion, ring: Ring) -> tuple[Averages, fmpq_mpoly]:
    """Averages of a multiple of the energy that is polynomial, and the multiple."""
    def number(x: Expr) -> RationalFunction:
        return RationalFunction(*ring.fraction(x))

    parts = motion.energy(DEGREE, number)
    if parts[3] and len(motion.names) > MOST:
        raise ScopeError(f"{eq.label}: D4 in {', '.join(sorted(s.name for s in motion.names))} is too long: "
                         f"give numbers for all but {MOST} of them")
    scale = ring.one
    for part in parts[2:]:
        for x in part.values():
            scale = lcm(scale, x.bottom)
    whole = [{code: x.top * (scale / x.bottom) for code, x in part.items()} for part in parts]
    return averages(whole), scale


def _factored(ring: Ring, top: fmpq_mpoly, bottom: fmpq_mpoly) -> Expr:
    """A fraction in lowest terms as a quotient of products."""
    if not top:
        return S.Zero
    (above, tops), (below, bottoms) = top.factor(), bottom.factor()
    powers = [(f, int(n)) for f, n in tops] + [(f, -int(n)) for f, n in bottoms]
    return Mul(ring.constant(above / below), *(Pow(ring.expression(f), n) for f, n in powers))
